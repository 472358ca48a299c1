"""Weighed pistons and rods, as a CSV file lists them: read strictly, refused with file and line."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

from symbalance.errors import SymbalanceError, brief
from symbalance.text.csv_rows import CsvRow, rows_of
from symbalance.text.files import file_name, read_text
from symbalance.text.numbers import as_list, exact

COLUMNS = ("name", "piston", "rod_reciprocating", "rod_rotating")
HEAVIEST = 10_000
"""Kilogrammes that a part may weigh."""
MOST_PARTS = 1000
"""Rows that a file may hold, far above any engine's cylinders."""


@dataclass(frozen=True, init=False)
class Part:
    """A weighed part: its name, its reciprocating and its rotating mass in kg."""

    name: str
    reciprocating: Fraction
    rotating: Fraction

    def __init__(self, name: object, reciprocating: object = 0, rotating: object = 0) -> None:
        object.__setattr__(self, "name", str(name))
        for key, value in (("reciprocating", reciprocating), ("rotating", rotating)):
            number = exact(value, key)
            if not 0 <= number <= HEAVIEST:
                raise SymbalanceError(f"{key} = {brief(value)}", f"must lie in [0, {HEAVIEST}]", "kg")
            object.__setattr__(self, key, number)


@dataclass(frozen=True)
class PartSet:
    """Parts of one kind, one for each cylinder, in the order they are listed in."""

    kind: str
    parts: tuple[Part, ...]


def checked_sets(parts: object, count: int) -> tuple[PartSet, ...]:
    """Return the sets of parts, one part for each of `count` cylinders, or refuse.

    A list of numbers is one set of pistons, kg.

    >>> [p.name for p in checked_sets([0.45, 0.46], 2)[0].parts]
    ['piston 1', 'piston 2']
    """
    values = as_list(parts, "parts", "[0.452, 0.450, 0.455, 0.449]")
    if not all(isinstance(v, PartSet) for v in values):
        pistons = tuple(Part(f"piston {i}", v) for i, v in enumerate(values, 1))
        values = [PartSet("piston", pistons)]
    for one in values:
        if len(one.parts) != count:
            what, rule = f"{len(one.parts)} {one.kind}s", f"the engine has {count} cylinders"
            raise SymbalanceError(what, rule, "list one part for each cylinder")
    return tuple(values)


def read_parts(path: str | Path, *, paired: bool = False) -> tuple[PartSet, ...]:
    """Return the sets of parts in a CSV file.

    Its header names the columns: `piston`, `rod_reciprocating`, `rod_rotating` (kg) and `name`, of which
    one mass at least is there. A row holds one part of each kind; `paired` keeps a row's piston and rod
    together, else they are placed each for itself. Columns are parted by commas, semicolons or tabs;
    empty lines and lines that begin with # are passed over.
    """
    return parse_parts(read_text(path, what="a CSV file of parts"), file_name(path), paired=paired)


def parse_parts(text: str, place: str, *, paired: bool = False) -> tuple[PartSet, ...]:
    """Return the sets of parts in a CSV text; error messages call the text `place`.

    >>> text = "piston,rod_reciprocating,rod_rotating\\n.4,.1,.3\\n.41,.1,.31"
    >>> pistons, rods = parse_parts(text, "p.csv")
    >>> rods.parts[1]
    Part(name='rod 2', reciprocating=Fraction(1, 10), rotating=Fraction(31, 100))
    """
    rows = rows_of(text, place)
    if not rows:
        raise SymbalanceError(place, "holds no parts", f"begin with a header: {','.join(COLUMNS)}")
    first = rows.pop(0)
    header = first.cells
    _check_header(first.place, header)
    if not rows:
        raise SymbalanceError(place, "holds no parts", "write one row a cylinder below the header")
    if len(rows) > MOST_PARTS:
        raise SymbalanceError(place, f"holds more than {MOST_PARTS} parts", "list one engine's")
    names = [_row_name(header, row) for row in rows]
    return _sets(header, names, [_masses(header, row) for row in rows], paired)


def _check_header(where: str, header: Sequence[str]) -> None:
    unknown = [name for name in header if name not in COLUMNS]
    if unknown or len(set(header)) != len(header):
        what = f"column {brief(unknown[0])!r}" if unknown else f"header {brief(','.join(header))}"
        rule = "is not known" if unknown else "names a column twice"
        raise SymbalanceError(what, rule, f"the header may name {', '.join(COLUMNS)} (kg)", where)
    if not set(header) & set(COLUMNS[1:]):
        raise SymbalanceError("header", "names no mass", "add a column piston, in kg", where)


def _row_name(header: Sequence[str], row: CsvRow) -> str:
    """Return a row's name, "" where it has none; refuses a row of another width than the header."""
    row.check_width(len(header), "write one cell for each column of the header, decimals with a point")
    return re.sub(r"\s+", " ", row.cells[header.index("name")]) if "name" in header else ""


def _masses(header: Sequence[str], row: CsvRow) -> dict[str, Fraction]:
    """Return the masses of a row's parts in kg, by column."""
    masses = {key: row.exact(column, key) for column, key in enumerate(header) if key != "name"}
    for key, mass in masses.items():
        if not 0 <= mass <= HEAVIEST:
            what, rule = f"{key} = {brief(mass)}", f"must lie in [0, {HEAVIEST}]"
            raise SymbalanceError(what, rule, "give kg", row.place)
    return masses


def _sets(
    header: Sequence[str], names: Sequence[str], rows: Sequence[dict[str, Fraction]], paired: bool
) -> tuple[PartSet, ...]:
    has_rods = any(name.startswith("rod") for name in header)
    if "piston" not in header or not has_rods or paired:
        kind = "set" if "piston" in header and has_rods else "piston" if "piston" in header else "rod"
        return (PartSet(kind, tuple(_parts(kind, names, rows, COLUMNS[1:]))),)
    return (
        PartSet("piston", tuple(_parts("piston", names, rows, ("piston",)))),
        PartSet("rod", tuple(_parts("rod", names, rows, COLUMNS[2:]))),
    )


def _parts(
    kind: str, names: Sequence[str], rows: Sequence[dict[str, Fraction]], columns: Sequence[str]
) -> Iterator[Part]:
    for i, (name, row) in enumerate(zip(names, rows, strict=True), 1):
        masses = {key: row[key] for key in columns if key in row}
        turning = masses.pop("rod_rotating", Fraction(0))
        yield Part(name or f"{kind} {i}", sum(masses.values(), Fraction(0)), turning)
