"""Values of numbered letters that a page gives in one row or one table: z_1, z_2, δ_1, δ_2 and so on.

z = (1, i, −i, −1)                       a row of values: z_k is the k-th of them

| k | z_k | δ_k |                        a table with the index in its first column,
| 1 |  1  |  0° |

| cylinder | 1 | 2  |                    or in its first row
| δ_k      | 0 | 90° |
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Protocol

from symbalance.document.formula import (
    Call,
    Formula,
    Matrix,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Span,
    Sum,
    Summation,
    children,
    names,
    walk,
    with_children,
)
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.algebra.sums import at_index
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.reading import ReadingError, read_expression
from symbalance.notes.reading.equations import Chain, ReadNotes, Relation, Side
from symbalance.notes.reading.letters.macro_letters import formulas_of, letter_in
from symbalance.notes.reading.units import scale_of
from symbalance.text import lazy_patterns as re

_INDEX = re.compile(r"(?P<stem>.+_)(?P<index>[ijkn]|nu|[0-9]{1,2})")
_DEGREES = re.compile(
    r"\s*(?:\[°\]|\(°\)|/\s*°|in\s+(?:°|degrees?|Grad)|\[(?:deg|Grad)\]|\((?:deg|Grad)\))$"
)
"""The one unit that a head may have: a formula may put in lengths in mm as bare numbers."""
_HEADS = re.compile(
    r"(?:cyl(?:inder)?s?|throws?|cranks?|(?:crank\s?)?pins?|zyl(?:inder)?|kröpfung|(?:hub|kurbel)?zapfen|kurbel|nr|no"
    r"|number|nummer|piston|kolben|cylindre|manetons?|manivelle|coude|cilindro|manovella|perno|muñequilla|codo"
    r"|シリンダ|気筒|番号|クランク(?:ピン)?)?[.:#]?"
    r"(?:\s*(?:[ijkn]|number|no\.?|nr\.?|番号))?|#",
    re.IGNORECASE,
)
_MARKS = re.compile(r"\*\*|\$|\\[()]|`|</?(?:b|i|em|strong|var|math)\b[^>]*>")
_LONGEST_CELL = 60
_NUMBER = re.compile(
    r"(?P<sign>[+\-−]?)\s?(?P<digits>[0-9]+(?:(?:[.,]|\{,\})[0-9]{1,2})?)(?=$|\s?\\?[A-Za-z])"
)
"""A short number of a cell, the place of a cylinder in distances of two: −1,5 and +0.5."""
_OVER_A_LETTER = re.compile(
    r"(?P<above>[^/\s]{1,20})\s?/\s?(?P<below>\\?[A-Za-z]{1,12}(?:_\{?\w{1,6}\}?)?)"
    r"|\\[dt]?frac\s?\{(?P<over>[^{}]{1,20}(?:\{\w{1,6}\})?)\}\s?\{(?P<under>[^{}]{1,12})\}"
)
"""The head z_k/a of a column of places."""


class Cell(Protocol):
    """A cell of a table: its text and its place in the page."""

    @property
    def text(self) -> str:
        """What stands in it."""
        ...

    @property
    def span(self) -> Span:
        """Where it stands."""
        ...


def rows_of_values(page: ReadNotes, used: Collection[str]) -> Iterator[Chain]:
    """Yield the values of z_1, z_2, … for each row z = (…) of a page that uses z_1 or z_k."""
    rows = {
        c.sides[0].node.name
        for c in page.chains
        if isinstance(c.sides[0].node, Name) and isinstance(c.sides[-1].node, Matrix)
    }
    for chain in page.chains:
        head, value = chain.sides[0].node, chain.sides[-1].node
        is_row = isinstance(value, Matrix) and (len(value.rows) == 1 or len(value.rows[0]) == 1)
        if not isinstance(head, Name) or not isinstance(value, Matrix) or not is_row:
            continue
        entries = [entry for row in value.rows for entry in row]
        stem = f"{head.name}_"
        numbers = {int(n[len(stem) :]) for n in used if n.startswith(stem) and n[len(stem) :].isdecimal()}
        if any(f"{stem}{number}" in rows for number in numbers):
            continue  # F = (2, 6) beside F_1 = (3, 4) is their sum, and F_1 no entry of it
        is_indexed = any((m := _INDEX.fullmatch(name)) and m["stem"] == stem for name in used)
        if not is_indexed and not numbers:
            continue
        first = 0 if 0 in numbers and len(entries) not in numbers else 1
        for number, entry in enumerate(entries, first):
            yield _given(f"{stem}{number}", entry, chain.sides[-1].span, chain.lines[0])


def instances_of_rules(page: ReadNotes, used: Collection[str]) -> Iterator[Chain]:
    """Yield θ_1 = θ, θ_2 = θ + 2π/3 for a rule θ_k = θ + 2π(k − 1)/3 of a page that uses θ_1 and θ_2.

    Only where k is an index by what the page says: one of a sum, or one that runs through whole numbers.
    """
    heads = {c.sides[0].node.name for c in page.chains if isinstance(c.sides[0].node, Name)}
    for chain in page.chains:
        head = chain.sides[0].node
        match = _INDEX.fullmatch(head.name) if isinstance(head, Name) else None
        if match is None or match["index"].isdecimal() or len(chain.sides) < 2:
            continue
        stem, index, value = match["stem"], match["index"], chain.sides[1].node
        if chain.relations[0].sign != "=" or not _holds_index(value, index):
            continue
        is_numbered = _is_numbered(value, index, heads)
        is_numbered = is_numbered or is_sum_of_order(value, index)
        if not (is_numbered or _runs(page, index)):
            continue
        for name in sorted(used):
            number = name[len(stem) :]
            if name.startswith(stem) and number.isdecimal() and (is_numbered or name not in heads):
                at_number = at_index(value, index, int(number))
                try:
                    node = substitute(at_number, index, Number(Fraction(int(number))))
                except NoFormError:  # a derivative by the index
                    break
                yield _given(name, _at(node, chain.sides[1].span), chain.sides[1].span, chain.lines[0])


def _holds_index(value: Formula, index: str) -> bool:
    return any(name == index or name.endswith(f"_{index}") for name in names(value))


def _is_numbered(value: Formula, index: str, heads: set[str]) -> bool:
    """Tell whether a page gives every letter with an index its values by number: φ_1, φ_2 for φ_k."""
    stems = [name[: -len(index)] for name in names(value) if name.endswith(f"_{index}")]
    return bool(stems) and all(f"{stem}1" in heads and f"{stem}2" in heads for stem in stems)


def is_sum_of_order(value: Formula, index: str) -> bool:
    """Tell whether a value is a sum of waves of an order: S_8 is what S_n = Σ e^{-inφ_k} is for n = 8.

    Written out it has several phases: A cos nθ + B sin nθ is a harmonic with coefficients of its own.
    """
    is_open = False
    bodies: tuple[Formula, ...] = ()
    if isinstance(value, Sum):
        bodies = value.terms
    elif isinstance(value, Summation) and value.index is not None and value.index.name != index:
        is_open, bodies = True, (value.body,)
    if not bodies:
        return False
    waves = [_arguments_with(body, index) for body in bodies]
    ends = (value.lower, value.upper) if isinstance(value, Summation) else ()
    if not all(waves) or any(index in names(end) for end in ends if end is not None):
        return False
    phases = {node for arguments in waves for node in arguments}
    return (is_open or len(phases) > 1) and all(_is_factor(node, index) for node in phases)


def _arguments_with(body: Formula, index: str) -> list[Formula]:
    """Return the arguments of waves in a formula that hold an index."""
    arguments = [
        part.exponent if isinstance(part, Power) else part.argument
        for part in walk(body)
        if isinstance(part, Power) or (isinstance(part, Call) and part.function in ("cos", "sin", "exp"))
    ]
    return [node for node in arguments if index in names(node)]


def _is_factor(node: Formula, index: str) -> bool:
    """Tell whether a letter multiplies the whole of an argument: n in 2πnk/5 and in n(θ + φ_k)."""
    if isinstance(node, Negative):
        return _is_factor(node.operand, index)
    if isinstance(node, Quotient):
        return index not in names(node.denominator) and _is_factor(node.numerator, index)
    if isinstance(node, Product):
        return Name(index) in node.factors and sum(index in names(part) for part in node.factors) == 1
    return node == Name(index)


def _runs(page: ReadNotes, index: str) -> bool:
    """Tell whether a letter counts: as the index of a sum, k = 1, 2, 3, or 1 ≤ k ≤ N."""
    sums = (part for c in page.chains for side in c.sides for part in walk(side.node))
    if any(isinstance(s, Summation) and s.index is not None and s.index.name == index for s in sums):
        return True
    run = (
        rf"(?<![\w\\]){index}\s*(?:=\s*[0-9]\s*(?:,|\\l?dots|…|\.\.)|\\in(?![a-z])|∈"
        r"|(?:\\leq?|≤)\s*[0-9A-Z])"
    )
    return re.search(run, page.text) is not None


def tables_of_values(
    page: ReadNotes, tables: Sequence[Sequence[Sequence[Cell]]], used: Collection[str]
) -> Iterator[Chain]:
    """Yield the values of numbered letters in tables with a row, or a column, for each number."""
    reader = _Tables(page, used)
    for table in tables:
        if len(table) < 2 or len({len(row) for row in table}) > 1:
            continue
        yield from reader.of(table)
        yield from reader.of([list(column) for column in zip(*table, strict=True)])


class _Tables:
    def __init__(self, page: ReadNotes, used: Collection[str]) -> None:
        self.page, self.used = page, used
        self.expanded = formulas_of(page.text)
        self.stems = {
            (match["stem"], match["index"]) for name in used if (match := _INDEX.fullmatch(name))
        }

    def of(self, table: Sequence[Sequence[Cell]]) -> Iterator[Chain]:
        """Yield the values of a table whose first row names letters and first column counts."""
        numbers = [_bare(row[0].text) for row in table[1:]]
        if not _HEADS.fullmatch(_bare(table[0][0].text)) or len(numbers) < 2:
            return
        if not all(number.isdecimal() for number in numbers):
            return
        counted = list(map(int, numbers))
        if counted != list(range(counted[0], counted[0] + len(counted))) or counted[0] > 1:
            return
        for column, head in enumerate(table[0][1:], 1):
            text = _bare(head.text)
            name = _DEGREES.sub("", text)
            stem, unit = self._stem(name), "°" if name != text else ""
            pitch = None if stem else self._pitch(text)
            if pitch is not None:
                stem = pitch[0]
            values = [self._value(row[column], unit) for row in table[1:]] if stem else []
            if not stem or any(value is None for value in values):
                continue
            for number, value, row in zip(counted, values, table[1:], strict=True):
                if value is not None:
                    span = row[column].span
                    of_pitch = value if pitch is None else _times(value, pitch[1], span)
                    yield _given(f"{stem}{number}", of_pitch, span, self.page.line_of(span[0]))

    def _stem(self, text: str) -> str:
        """Return δ_ for a head δ_k, δ_i or δ, where the page uses δ_k."""
        name = letter_in(self.page.text, text) or letter_in(self.page.text, text.rpartition(" ")[2])
        if name is None:
            return ""
        match = _INDEX.fullmatch(name)
        stem = match["stem"] if match else f"{name}_"
        return stem if any(own == stem for own, _ in self.stems) else ""

    def _pitch(self, text: str) -> tuple[str, str] | None:
        """Return z_ and a for a head z_k/a, where the page uses z_k and a: its numbers are so many a."""
        match = _OVER_A_LETTER.fullmatch(text)
        if match is None:
            return None
        above, below = match["above"] or match["over"], match["below"] or match["under"]
        stem, letter = self._stem(above), letter_in(self.page.text, below)
        is_letter = letter in self.used and scale_of(below) is None
        return (stem, letter) if stem and letter is not None and is_letter else None

    def _value(self, cell: Cell, unit: str) -> Formula | None:
        text = _plain_number(_bare(self.expanded(cell.text)))
        text += unit if text.lstrip("-−").isdecimal() else ""
        if not text or len(text) > _LONGEST_CELL:
            return None
        try:
            (node, *_) = read_expression(text.replace("−", "-"), self.used)
        except ReadingError:
            return None
        return _at(node, cell.span)


def _at(node: Formula, span: Span) -> Formula:
    parts = children(node)
    moved = with_children(node, tuple(_at(part, span) for part in parts)) if parts else node
    return replace(moved, span=span)


def _times(value: Formula, letter: str, span: Span) -> Formula:
    return Product((value, Name(letter, span=span)), span=span)


def _plain_number(text: str) -> str:
    """Return a short cell with its sign and its comma as a formula has them: +0,5 a is 0.5 a."""
    match = _NUMBER.match(text)
    if match is None:
        return text
    digits = match["digits"].replace("{,}", ".").replace(",", ".")
    return match["sign"].strip("+") + digits + text[match.end() :]


def _bare(text: str) -> str:
    return " ".join(_MARKS.sub(" ", text).split())


def _given(name: str, value: Formula, span: Span, line: int) -> Chain:
    sides = Side((Name(name, span=span),), span), Side((value,), span)
    return Chain(sides, (Relation("=", line),), (line,))
