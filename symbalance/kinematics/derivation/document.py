r"""A derivation in print: Unicode text within 80 columns, or a LaTeX document for A4 (amsmath only)."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator
from itertools import groupby

from symbalance.document.formula import Equation, Formula
from symbalance.document.formula_printing import FormulaWriter
from symbalance.document.latex_writer import InlineLatexWriter, LatexWriter
from symbalance.document.line_breaking import Medium, broken_equation
from symbalance.document.text_writer import TextWriter
from symbalance.kinematics.derivation.result import Derivation
from symbalance.kinematics.derivation.setting import LETTERS, LONGEST_IN_FULL, Prose, Step, prose

COLUMNS = 80
_MARGIN = 2
_LATEX_ROOM = 78.0
"""How many digits wide a line may be: 16 cm hold 90 of them at 10 pt."""
_LATEX_INDENT = 2.0
_HARD_SPACE = "\u00a0"
_SUBJECTS = {
    "displacement": "Piston displacement",
    "velocity": "Piston velocity",
    "acceleration": "Piston acceleration",
    "force": "Inertia force",
    "rod-angle": "Rod angle",
}
_PREAMBLE = r"""\documentclass[a4paper]{article}
\usepackage{amsmath}
\setlength{\textwidth}{16cm}
\setlength{\oddsidemargin}{0cm}
\setlength{\textheight}{24cm}
\setlength{\topmargin}{-1.5cm}
\setlength{\parindent}{0pt}
\setlength{\parskip}{4pt}
\setlength{\emergencystretch}{3em}
\setlength{\jot}{6pt}
\allowdisplaybreaks
\begin{document}
"""

Row = tuple[str, int, str]
"""What stands left of the relation, how deep the line is indented, and the line."""


def title(derivation: Derivation) -> str:
    """Return what a derivation is called.

    >>> from symbalance.kinematics.derivation import derive
    >>> title(derive("velocity", 4))
    'Piston velocity of one slider-crank, harmonics to order 4'
    """
    subject = _SUBJECTS[derivation.quantity]
    return f"{subject} of one slider-crank, harmonics to order {derivation.order}"


def _opening(derivation: Derivation) -> Prose:
    """Return the paragraph that states the convention, and that a derivation is shortened."""
    letters = LETTERS[derivation.convention]
    words = f", {letters.meaning}."
    if _is_long(derivation):
        words += (
            f" Beyond order {LONGEST_IN_FULL} the derivation is shortened: of long lines only the first"
            " terms are written out, of every coefficient two."
        )
    return prose("Convention: ", letters.ratio, words)


def _is_long(derivation: Derivation) -> bool:
    return max(derivation.order, derivation.power + 1) > LONGEST_IN_FULL


# Both forms -------------------------------------------------------------------------------------


def _groups(step: Step) -> Iterator[Prose | list[Equation]]:
    """Yield a step's paragraphs and, one list each, the equations that follow one another."""
    for displayed, parts in groupby(step.parts, lambda part: isinstance(part, Equation)):
        if displayed:
            yield [part for part in parts if isinstance(part, Equation)]
        else:
            yield from (part for part in parts if isinstance(part, Prose))


def _rows(equations: list[Equation], medium: Medium, room: float, indent: float) -> Iterator[Row]:
    """Yield the lines of equations that share one left column."""
    names = [medium.write(each.left) for each in equations]
    left = max(map(medium.width, names)) + medium.width(" ")
    for name, each in zip(names, equations, strict=True):
        for line in broken_equation(each, medium, room - left, indent):
            yield name, line.depth, line.printed
            name = ""  # noqa: PLW2901 - a name stands at its equation's first line alone


def _inline(piece: str | Formula | Equation, writer: FormulaWriter) -> str:
    """Return a formula or an equation as it stands within a sentence."""
    if isinstance(piece, Equation):
        return writer.equation(piece)
    return piece if isinstance(piece, str) else writer.write(piece)


# Text -------------------------------------------------------------------------------------------


def derivation_text(derivation: Derivation) -> str:
    """Return a derivation as Unicode text, no line over 80 columns.

    >>> from symbalance.kinematics.derivation import derive
    >>> print(derivation_text(derive("force", 2)).splitlines()[0])
    Inertia force of one slider-crank, harmonics to order 2
    """
    writer = TextWriter()
    head = title(derivation)
    blocks = [f"{head}\n{'=' * len(head)}", _text_prose(_opening(derivation), writer)]
    for number, step in enumerate(derivation.steps, 1):
        blocks.append(f"{number}. {step.title}\n{'-' * len(f'{number}. {step.title}')}")
        blocks += [_text_group(group, writer) for group in _groups(step)]
    return "\n\n".join(blocks) + "\n"


def _text_group(group: Prose | list[Equation], writer: TextWriter) -> str:
    if isinstance(group, Prose):
        return _text_prose(group, writer)
    rows = list(_rows(group, writer, COLUMNS - _MARGIN, 2))
    left = max(len(name) for name, _, _ in rows)
    return "\n".join(f"{' ' * _MARGIN}{name:>{left}} {'  ' * depth}{line}" for name, depth, line in rows)


def _text_prose(paragraph: Prose, writer: TextWriter) -> str:
    """Return a paragraph, wrapped between words but not inside formulas."""
    words = "".join(
        piece if isinstance(piece, str) else _inline(piece, writer).replace(" ", _HARD_SPACE)
        for piece in paragraph.pieces
    )
    wrapped = textwrap.fill(words, COLUMNS, break_long_words=False, break_on_hyphens=False)
    return wrapped.replace(_HARD_SPACE, " ")


# LaTeX ------------------------------------------------------------------------------------------


def derivation_latex(derivation: Derivation, standalone: bool = True) -> str:
    r"""Return a derivation as a LaTeX document, or its body alone, which needs amsmath.

    >>> from symbalance.kinematics.derivation import derive
    >>> print(derivation_latex(derive("force", 2), standalone=False).splitlines()[0])
    \section*{Inertia force of one slider-crank, harmonics to order 2}
    """
    writer = LatexWriter()
    blocks = [rf"\section*{{{title(derivation)}}}", _latex_prose(_opening(derivation))]
    for number, step in enumerate(derivation.steps, 1):
        blocks.append(rf"\subsection*{{{number}. {step.title}}}")
        blocks += [_latex_group(group, writer) for group in _groups(step)]
    body = "\n".join(blocks) + "\n"
    return f"{_PREAMBLE}{body}\\end{{document}}\n" if standalone else body


def _latex_group(group: Prose | list[Equation], writer: LatexWriter) -> str:
    if isinstance(group, Prose):
        return _latex_prose(group)
    rows, indent = _rows(group, writer, _LATEX_ROOM, _LATEX_INDENT), r"\quad "
    printed = [f"{name} &{indent * depth}{line}".strip() for name, depth, line in rows]
    return "\\begin{align*}\n" + " \\\\\n".join(printed) + "\n\\end{align*}"


def _latex_prose(paragraph: Prose) -> str:
    inline = InlineLatexWriter()
    return "".join(
        piece if isinstance(piece, str) else f"${_inline(piece, inline)}$" for piece in paragraph.pieces
    )
