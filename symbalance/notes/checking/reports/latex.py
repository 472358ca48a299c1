"""The report as LaTeX: every equation with its verdict, corrected lines beside the wrong ones."""

from __future__ import annotations

import re
from pathlib import Path

from symbalance.document.formula import Formula
from symbalance.document.latex_characters import escaped
from symbalance.document.latex_writer import LatexWriter
from symbalance.document.line_breaking import Line, broken_sum
from symbalance.notes.checking.reports.text import summary, verdict_words, witness_text
from symbalance.notes.checking.verdicts import REFUTED, Checked, Verdict

_HEAD = r"""\documentclass[a4paper,10pt]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\usepackage{lmodern}
\usepackage{amsmath}
\usepackage{booktabs}
\usepackage{longtable}
\usepackage[margin=18mm]{geometry}
\setlength{\parindent}{0pt}
\begin{document}
"""


def report_latex(checked: Checked) -> str:
    """Return a document that compiles with pdflatex: amsmath, booktabs and longtable only."""
    parts = [_HEAD, rf"\section*{{{escaped(Path(checked.document.name).name)}}}", "\n"]
    parts += [_entry(verdict) for verdict in checked.verdicts]
    parts += [r"\medskip\hrule\medskip", "\n", escaped(summary(checked)), "\n", r"\end{document}", "\n"]
    return "".join(parts)


def _entry(verdict: Verdict) -> str:
    place = f"{verdict.line}" if verdict.link == 1 else f"{verdict.line}.{verdict.link}"
    parts = [rf"\textbf{{{place}}}\quad {_words(verdict)}\\" + "\n", _source(verdict)]
    parts += [_note(f"claims to be: {verdict.bind}")] if verdict.bind else []
    parts += [_note(verdict.reason)] if verdict.reason else []
    if verdict.verdict == REFUTED:
        parts += [_note(f"witness: {witness_text(verdict)}")] if verdict.witness else []
        parts += [_note(f"found: {verdict.fix.kind}")] if verdict.fix else []
        parts.append(_beside(verdict))
    return r"\begin{samepage}" + "".join(parts) + r"\end{samepage}\medskip" + "\n\n"


def _words(verdict: Verdict) -> str:
    words = escaped(verdict_words(verdict))
    return rf"\fbox{{\textsc{{{words.lower()}}}}}" if verdict.is_bad else rf"\textit{{{words}}}"


def _beside(verdict: Verdict) -> str:
    """Return the line as it stands and as it should be, one above the other, typeset alike."""
    rows = [("stands", verdict.node)] if verdict.node is not None else []
    rows += [("right", verdict.fix.node)] if verdict.fix else []
    if not rows:
        return ""
    broken = [(title, _lines(node)) for title, node in rows]
    size = _size(max(line.width for _, lines in broken for line in lines))
    printed = [(title, _aligned(lines)) for title, lines in broken]
    lines = rf"\\[1.2ex]{chr(10)}".join(
        rf"\textit{{{title}}} & \displaystyle {formula}" for title, formula in printed
    )
    return rf"{{{size}\[\begin{{array}}{{@{{}}l@{{\quad}}l@{{}}}}{lines}\end{{array}}\]}}" + "\n"


def _lines(node: Formula) -> list[Line]:
    """Return a formula in lines that fit at the usual size of letters."""
    return broken_sum(node, LatexWriter(), WIDEST, WIDEST, INDENT)


def _aligned(lines: list[Line]) -> str:
    if len(lines) == 1:
        return lines[0].printed
    joined = f"\\\\{chr(10)}&".join(r"\quad " * line.depth + line.printed for line in lines)
    return rf"\begin{{aligned}}[t]&{joined}\end{{aligned}}"


WIDEST = 82
"""How many digits wide a line may be: 174 mm less the words before it hold 90 of them at 10 pt."""
INDENT = 2
"""What the indent of a continued line takes of that."""
_SIZES = ((WIDEST, ""), (93, r"\small"), (105, r"\footnotesize"), (120, r"\scriptsize"))


def _size(width: float) -> str:
    """Return the size of letters at which a line fits that could not be broken."""
    return next((size for limit, size in _SIZES if width <= limit), r"\tiny")


def _source(verdict: Verdict) -> str:
    joined = " ".join(verdict.source.replace(r"\displaystyle", " ").split())
    shown = escaped(joined if len(joined) <= 600 else joined[:599] + "...")
    shown = re.sub(r"(?=\\textbackslash)|(?<=[,=+}])", r"\\allowbreak ", shown)
    return rf"{{\small\ttfamily\raggedright {shown}\par}}" + "\n"


def _note(text: str) -> str:
    return rf"{{\small {escaped(text)}\par}}" + "\n"
