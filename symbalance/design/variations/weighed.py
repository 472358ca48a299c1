"""Weighed parts as a CSV file lists them: pistons and rods, read strictly, refused with file and line."""

from __future__ import annotations

import csv
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

from symbalance.errors import SymbalanceError, shown
from symbalance.text.files import read_text
from symbalance.text.numbers import exact, listed

COLUMNS = ("name", "piston", "rod_reciprocating", "rod_rotating")
SETS = ("piston", "rod")
HEAVIEST = 10_000
MOST_PARTS = 1000


@dataclass(frozen=True, init=False)
class Part:
    """One weighed part: its name, the mass that moves with the piston and that which turns, kg."""

    name: str
    reciprocating: Fraction
    rotating: Fraction

    def __init__(self, name: object, reciprocating: object = 0, rotating: object = 0) -> None:
        object.__setattr__(self, "name", str(name))
        for key, value in (("reciprocating", reciprocating), ("rotating", rotating)):
            number = exact(value, key)
            if not 0 <= number <= HEAVIEST:
                raise SymbalanceError(f"{key} = {shown(value)}", f"must lie in [0, {HEAVIEST}]", "kg")
            object.__setattr__(self, key, number)


@dataclass(frozen=True)
class PartSet:
    """Parts of one kind, one for each cylinder, in the order they are listed in."""

    kind: str
    parts: tuple[Part, ...]

    @property
    def is_level(self) -> bool:
        """Whether all its parts weigh the same."""
        return len({(p.reciprocating, p.rotating) for p in self.parts}) <= 1


def checked_sets(given: object, count: int) -> tuple[PartSet, ...]:
    """Return the sets of parts, one part for each of `count` cylinders, or refuse.

    A list of numbers is one set of pistons, kg.

    >>> [p.name for p in checked_sets([0.45, 0.46], 2)[0].parts]
    ['piston 1', 'piston 2']
    """
    values = listed(given, "parts", "[0.452, 0.450, 0.455, 0.449]")
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
    return parse_parts(read_text(path, what="a CSV file of parts"), str(path), paired=paired)


def parse_parts(text: str, place: str, *, paired: bool = False) -> tuple[PartSet, ...]:
    """Return the sets of parts in a CSV text; `place` is what errors call it.

    >>> text = "piston,rod_reciprocating,rod_rotating\\n.4,.1,.3\\n.41,.1,.31"
    >>> pistons, rods = parse_parts(text, "p.csv")
    >>> rods.parts[1]
    Part(name='rod 2', reciprocating=Fraction(1, 10), rotating=Fraction(31, 100))
    """
    lines = [(f"{place}:{i}", line.strip()) for i, line in enumerate(text.splitlines(), 1)]
    told = [(where, _cells(line)) for where, line in lines if line and not line.startswith("#")]
    if not told:
        raise SymbalanceError(place, "holds no parts", f"begin with a header: {','.join(COLUMNS)}")
    (where, header), *rows = told
    _check_header(where, header)
    if not rows:
        raise SymbalanceError(place, "holds no parts", "write one row a cylinder below the header")
    if len(rows) > MOST_PARTS:
        raise SymbalanceError(place, f"holds more than {MOST_PARTS} parts", "list one engine's")
    tables = [_row(place, header, row) for place, row in rows]
    return _sets(header, tables, paired)


def _cells(line: str) -> list[str]:
    separator = next((s for s in (";", "\t") if s in line), ",")
    return [cell.strip() for cell in next(csv.reader([line], delimiter=separator))]


def _check_header(where: str, header: Sequence[str]) -> None:
    unknown = [name for name in header if name not in COLUMNS]
    if unknown or len(set(header)) != len(header):
        what = f"column {shown(unknown[0])!r}" if unknown else f"header {shown(','.join(header))}"
        rule = "is not known" if unknown else "names a column twice"
        raise SymbalanceError(what, rule, f"the header may name {', '.join(COLUMNS)} (kg)", where)
    if not set(header) & set(COLUMNS[1:]):
        raise SymbalanceError("header", "names no mass", "add a column piston, in kg", where)


def _row(where: str, header: Sequence[str], row: Sequence[str]) -> dict[str, str]:
    if len(row) != len(header):
        what, rule = f"row of {len(row)} cells", f"the header has {len(header)}"
        raise SymbalanceError(what, rule, "write decimals with a point", where)
    found = dict(zip(header, row, strict=True))
    try:
        for key in COLUMNS[1:]:
            if key in found:
                Part("", exact(found[key], key))
    except SymbalanceError as problem:
        raise problem.within(where) from None
    return found


def _sets(header: Sequence[str], rows: Sequence[dict[str, str]], paired: bool) -> tuple[PartSet, ...]:
    has_rods = any(name.startswith("rod") for name in header)
    if "piston" not in header or not has_rods or paired:
        kind = "set" if "piston" in header and has_rods else "piston" if "piston" in header else "rod"
        return (PartSet(kind, tuple(_parts(kind, rows, COLUMNS[1:]))),)
    return (
        PartSet("piston", tuple(_parts("piston", rows, ("piston",)))),
        PartSet("rod", tuple(_parts("rod", rows, COLUMNS[2:]))),
    )


def _parts(kind: str, rows: Sequence[dict[str, str]], columns: Iterable[str]) -> Iterable[Part]:
    kept = tuple(columns)
    for i, row in enumerate(rows, 1):
        masses = {key: exact(row[key], key) for key in kept if key in row}
        turning = masses.pop("rod_rotating", Fraction(0))
        name = re.sub(r"\s+", " ", row.get("name", "")) or f"{kind} {i}"
        yield Part(name, sum(masses.values(), Fraction(0)), turning)
