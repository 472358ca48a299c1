"""Formulas in the docstrings of symbalance, each judged by symbalance's own checker of derivations.

A docstring marks its formulas by a heading; below it, indented, one formula a line:

    Formulas:
        q = (rho/(1 + k'))^2 = (1 - k')/(1 + k')
        with k' = sqrt(1 - rho^2)

A line that begins with a relation or a sign goes on with the one before. Words after four spaces are a
remark. What stands after "with" says what the letters of the block are, items parted by semicolons:

    k' = sqrt(1 - rho^2)                a definition
    p the crank angle                   a role that the checker knows
    x, y numbers; n a whole number      free letters; also: positive, lengths, angles
    S the force of order 2 of inline-4  of a preset, in F_n: the formula S = ... is held against it

The letters in `ROLES` have their role without being told; those in `QUANTITIES`, such as A_2, are what
the library computes for them, through (r/l)^POWER: a formula for them holds only if the code agrees.

    proved       every relation of the line holds, or holds through the powers that are written (...)
    definition   it only gives a letter its value: nothing to prove, nothing proved
    refuted      a relation is wrong, and the checker has a witness
    undecided    the checker cannot tell
    unread       the reader does not know the notation, or the equation is not marked as a formula

`survey()` gives all of them; `python -m tests.docstring_formulas` prints how many there are of each kind
and those that are not proved.
"""

from __future__ import annotations

import ast
import re
import sys
import unicodedata
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from textwrap import dedent
from typing import Any

import symbalance
from symbalance.checking import check
from symbalance.document.formula import Equation
from symbalance.document.latex_writer import formula_latex
from symbalance.document.text_writer import formula_text
from symbalance.kinematics.piston_torque import torque_series
from symbalance.kinematics.rod_torque import rocking_couple_series, rod_torque_series
from symbalance.kinematics.series_printing import series_formula
from symbalance.kinematics.slider_crank import Series, acceleration_series, harmonics, rod_angle_series
from symbalance.notes.checking.verdicts import (
    CONDITIONAL,
    DEFINITION,
    HOLDS,
    HOLDS_TO_ORDER,
    REFUTED,
    UNREADABLE,
    Checked,
    Verdict,
)

PACKAGE = Path(symbalance.__file__).parent
PROVED, UNDECIDED, UNREAD = "proved", "undecided", "unread"
STATUSES = (PROVED, DEFINITION, REFUTED, UNDECIDED, UNREAD)
NOT_MARKED = "not marked as a formula"
POWER = 15
"""Through which power of r/l the library's series are put in; more terms only cost time."""

ROLES = {
    "theta": "crank angle",
    "phi": "rod angle",
    "r": "crank radius",
    "l": "rod length",
    "lambda": "rod ratio l/r",
    "rho": "crank ratio r/l",
    "omega": "angular speed",
    "m": "reciprocating mass",
    "x": "displacement from top dead centre",
    "v": "piston velocity",
    "a": "piston acceleration",
    "F": "inertia force",
}
"""Letters whose meaning is the same throughout; a formula that means another by one says so."""


def _rest_position(order: int) -> Series:
    return harmonics("displacement", 1, POWER).constant


def _displacement(order: int) -> Series:
    """B_n = A_n/n^2, which the displacement holds with its sign reversed; B_0 is its mean."""
    if order == 0:
        return _rest_position(order)
    return harmonics("displacement", max(order, 1), POWER).terms[order].scaled(-1)


QUANTITIES: dict[str, Callable[[int], Series]] = {
    "A": lambda n: acceleration_series(n, POWER),
    "B": _displacement,
    "R": lambda n: rod_angle_series(n, POWER),
    "D": lambda n: rod_angle_series(n, POWER).scaled(n),
    "t": lambda n: torque_series(n, POWER),
    "u": lambda n: rod_torque_series(n, POWER + 2),
    "k": lambda n: rocking_couple_series(n, POWER),
}
"""The coefficients of one slider-crank, from the functions that compute them: A_2, t_3, ...."""

_HEADING = re.compile(r"^( *)Formulas:\s*$")
_DOCTEST = re.compile(r"^\s*(>>>|\.\.\.) ")
_RELATION = re.compile(r"(?<![<>=!:])=(?!=)|≈|<=|>=|≤|≥")
_EQUATION = re.compile(r"\S ?(?<![<>=!:\w(])= ?\S|\w+\)? = \S|≈")
_GOES_ON = re.compile(r"^([=≈+]|- )")
_LETTER = re.compile(r"[^\W\d_]+'*(?:_(?:\d+|[^\W\d_]\b))?'*")
_INDEXED = re.compile(r"^([A-Za-z])_(\d+)$")
_OF_AN_ENGINE = re.compile(r"^(?P<role>[a-z.]+) of order (?P<order>\d+) of (?P<engine>[\w-]+)$")
_KINDS = (
    (re.compile(r"^(?P<letters>.+?) the (?P<role>.+)$"), ""),
    (re.compile(r"^(?P<letters>.+?) (?:an? )?whole numbers?$"), "integer"),
    (re.compile(r"^(?P<letters>.+?) (?:an? )?positive(?: numbers?)?$"), "positive"),
    (re.compile(r"^(?P<letters>.+?) (?:an? )?(?:numbers?|angles?|lengths?)$"), "variable"),
)


@dataclass(frozen=True)
class Entry:
    """One equation of a docstring, and what the checker says of it."""

    name: str
    """The module, class or function whose docstring it stands in, by its qualified name."""
    text: str
    """The equation as it stands there, on one line."""
    latex: str
    """The same as LaTeX for math mode; empty where it was not read."""
    status: str
    """One of `STATUSES`."""
    reason: str = ""
    """Why it is not proved, or through which power it holds."""


@dataclass(frozen=True)
class Block:
    """The formulas below one heading, with what is said of their letters."""

    formulas: tuple[str, ...]
    definitions: tuple[str, ...]
    symbols: tuple[tuple[str, str], ...]


@dataclass(frozen=True)
class Docstring:
    """A docstring, with the qualified name of what it describes."""

    name: str
    text: str


def docstrings(root: Path = PACKAGE) -> Iterator[Docstring]:
    """Yield the docstring of every module, class and function of a package."""
    for path in sorted(root.rglob("*.py")):
        parts = path.relative_to(root.parent).with_suffix("").parts
        module = ".".join(parts[:-1] if parts[-1] == "__init__" else parts)
        yield from _docstrings(ast.parse(path.read_text(encoding="utf-8")), module)


def _docstrings(node: ast.AST, name: str) -> Iterator[Docstring]:
    if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef):
        text = ast.get_docstring(node)
        if text:
            yield Docstring(name, text)
    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef):
            yield from _docstrings(child, f"{name}.{child.name}")


def blocks(text: str) -> tuple[list[Block], list[str]]:
    """Return the blocks of formulas of a docstring, and its equations outside of them.

    >>> text = "Return y.\\n\\nFormulas:\\n    y = 2 x    for short\\n    with x a number"
    >>> (block,), rest = blocks(text)
    >>> block.formulas, block.symbols, rest
    (('y = 2 x',), (('x', 'variable'),), [])
    """
    marked: list[Block] = []
    others: list[str] = []
    lines = text.split("\n")
    i = 0
    while i < len(lines):
        heading = _HEADING.match(lines[i])
        i += 1
        if heading is None:
            line = lines[i - 1]
            if _EQUATION.search(line) and not _DOCTEST.match(line):
                others.append(" ".join(line.split()))
            continue
        depth, inside = len(heading[1]), []
        while i < len(lines) and (not lines[i].strip() or _indent(lines[i]) > depth):
            inside.append(lines[i])
            i += 1
        marked.append(_block(dedent("\n".join(inside)).split("\n")))
    return marked, others


def _indent(line: str) -> int:
    return len(line) - len(line.lstrip())


def _block(lines: list[str]) -> Block:
    """Return what the lines below a heading say, their remarks left out."""
    rows: list[str] = []
    for line in (raw.strip() for raw in lines if raw.strip()):
        bare = re.split(r" {4,}", line)[0]
        if rows and (_GOES_ON.match(bare) or (rows[-1].startswith("with ") and rows[-1].endswith(";"))):
            rows[-1] += " " + bare
        else:
            rows.append(bare)
    items = [
        item.strip() for row in rows if row.startswith("with ") for item in row[5:].rstrip(".").split(";")
    ]
    definitions = tuple(item for item in items if _RELATION.search(item))
    symbols = [pair for item in items if not _RELATION.search(item) for pair in _declared(item)]
    return Block(tuple(r for r in rows if not r.startswith("with ")), definitions, tuple(symbols))


def _declared(item: str) -> Iterator[tuple[str, str]]:
    """Yield the letters an item declares, each with its meaning."""
    for pattern, meaning in _KINDS:
        match = pattern.match(item)
        if match:
            for letter in re.split(r", | and ", match["letters"]):
                yield letter, meaning or match["role"]
            return
    raise ValueError(f"not understood after 'with': {item}")


def judge(block: Block) -> list[Entry]:
    """Return an entry, with no name yet, for each formula of a block, and for each letter it defines."""
    texts = (*block.definitions, *block.formulas)
    symbols: dict[str, Any] = dict(block.symbols)
    defined = {_RELATION.split(text)[0].strip() for text in block.definitions}
    letters = {letter for text in texts for letter in _letters(text)}
    first: list[str] = []
    for letter in sorted(letters - defined - set(symbols)):
        indexed = _INDEXED.match(letter)
        if letter in ROLES:
            symbols[letter] = ROLES[letter]
        elif indexed and indexed[1] in QUANTITIES:
            first.append(f"{letter} = {_series_text(indexed[1], int(indexed[2]))}")
            symbols.setdefault("rho", ROLES["rho"])
    symbols |= dict.fromkeys(defined, "variable")
    engines = {letter: match for letter, text in symbols.items() if (match := _OF_AN_ENGINE.match(text))}
    # What one definition uses is defined after it in prose, and before it in a derivation.
    before = (*first, *reversed(block.definitions))
    binds = [
        {
            "line": 2 * k + 1,
            "quantity": engines[letter]["role"],
            "order": int(engines[letter]["order"]),
            "engine": engines[letter]["engine"],
            "unit": "F_n",
        }
        for k, text in enumerate(block.formulas, len(before))
        if (letter := _RELATION.split(text)[0].strip()) in engines
    ]
    if binds:
        symbols = {"symbols": symbols | dict.fromkeys(engines, "variable"), "bind": binds}
    checked = check(_document((*before, *block.formulas)), symbols)
    entries = [_entry(text, checked, 2 * k + 1) for k, text in enumerate((*before, *block.formulas))]
    at_odds = (REFUTED, UNDECIDED)
    if first and any(entry.status in at_odds for entry in entries):
        # The library's series end at POWER, a closed form does not: it is compared through that power.
        nearly = tuple(text.replace("=", "≈") for text in block.formulas)
        checked = check(_document((*before, *nearly)), symbols)
        closed = [_entry(text, checked, 2 * k + 1) for k, text in enumerate((*before, *block.formulas))]
        entries = [
            new if old.status in at_odds and _is_through_all(new.reason) else old
            for old, new in zip(entries, closed, strict=True)
        ]
    return entries[len(first) :]


def _is_through_all(reason: str) -> bool:
    """Tell whether two sides agree through every power that the library's series were put in with."""
    power = unicodedata.normalize("NFKC", reason.split(",", maxsplit=1)[0]).removeprefix("through ρ")
    return reason.startswith("through all powers") or (power.isdigit() and int(power) >= POWER - 1)


def _document(formulas: tuple[str, ...]) -> str:
    """Return a derivation of one formula every second line."""
    return "\n\n".join(f"$${formula}$$" for formula in formulas)


def _letters(text: str) -> Iterator[str]:
    """Yield the letters of a formula; of the derivative dphi/dtheta those that it holds."""
    for letter in _LETTER.findall(text):
        yield letter
        yield letter.removeprefix("d")


@cache
def _series_text(letter: str, order: int) -> str:
    return formula_text(series_formula(QUANTITIES[letter](order), "r/l"), plain=True)


def _entry(formula: str, checked: Checked, line: int) -> Entry:
    verdicts = checked.at(line)
    status, reason = _status(verdicts)
    return Entry("", formula, _latex(checked, line), status, reason)


def _status(verdicts: tuple[Verdict, ...]) -> tuple[str, str]:
    """Return the status of a line of one or several relations: the worst of them."""
    if not verdicts:
        return UNREAD, "no equation"
    for verdict in verdicts:
        if verdict.verdict == REFUTED:
            return REFUTED, f"should be {verdict.fix.text}" if verdict.fix else verdict.reason
    for verdict in verdicts:
        if verdict.verdict == UNREADABLE:
            return UNREAD, verdict.reason
    for verdict in verdicts:
        if verdict.verdict not in (HOLDS, HOLDS_TO_ORDER, DEFINITION):
            why = f"needs {verdict.assumption}" if verdict.verdict == CONDITIONAL else verdict.reason
            return UNDECIDED, why
    proofs = [verdict for verdict in verdicts if verdict.verdict != DEFINITION]
    if not proofs:
        return DEFINITION, ""
    return PROVED, next((f"through {v.order}" for v in proofs if v.order), "")


def _latex(checked: Checked, line: int) -> str:
    for chain in checked.derivation.chains:
        if chain.lines[0] == line and chain.relations:
            left, *rest = (side.node for side in chain.sides)
            signs = [relation.sign for relation in chain.relations]
            return formula_latex(Equation(left, tuple(zip(signs, rest, strict=True))))
    return ""


@cache
def survey(root: Path = PACKAGE) -> tuple[Entry, ...]:
    """Return every equation of every docstring, marked formulas first, with what is known of it."""
    marked: list[Entry] = []
    others: list[Entry] = []
    for docstring in docstrings(root):
        of_this, rest = blocks(docstring.text)
        for block in of_this:
            marked += [Entry(docstring.name, e.text, e.latex, e.status, e.reason) for e in judge(block)]
        others += [Entry(docstring.name, line, "", UNREAD, NOT_MARKED) for line in rest]
    return (*marked, *others)


def marked_formulas(root: Path = PACKAGE) -> list[Entry]:
    """Return the formulas that their docstrings mark as such."""
    return [entry for entry in survey(root) if entry.reason != NOT_MARKED]


def counts(entries: list[Entry]) -> str:
    """Return how many entries there are of each status, in one line."""
    number = Counter(entry.status for entry in entries)
    return ", ".join(f"{number[status]} {status}" for status in STATUSES)


def main() -> None:
    """Print the counts, then what is marked and not proved; with --all every formula."""
    entries, marked = list(survey()), marked_formulas()
    out = sys.stdout
    out.write(f"marked as formulas: {counts(marked)}\n")
    plain = [e for e in entries if e.reason == NOT_MARKED]
    out.write(f"equations in docstrings that are not marked: {len(plain)}\n")
    for entry in marked if "--all" in sys.argv else [e for e in marked if e.status != PROVED]:
        out.write(f"{entry.status:10} {entry.name}: {entry.text}  {entry.reason}\n")
    if "--all" in sys.argv:
        for entry in plain:
            out.write(f"{'not marked':10} {entry.name}: {entry.text}\n")


if __name__ == "__main__":
    main()
