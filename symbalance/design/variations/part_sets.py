"""Weighed pistons and rods, as a CSV file lists them: read strictly, refused with file and line."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path

from symbalance.engine.engine import Engine
from symbalance.errors import SymbalanceError, brief
from symbalance.text.csv_rows import CsvRow, rows_of
from symbalance.text.files import file_name, read_text
from symbalance.text.numbers import as_list, exact

COLUMNS = ("name", "piston", "rod_reciprocating", "rod_rotating")
HEAVIEST = 50_000
"""Kilogrammes that a part of any engine may weigh: the largest pistons with crossheads have 15 t."""
UNSIZED = 50
"""Kilogrammes where the engine gives neither stroke nor mass: more than the pistons of a locomotive.

A car's piston weighs some 400 g. Its number of grammes, taken for kilogrammes, is beyond this.
"""
DENSEST = 20_000
"""Kilogrammes a cubic metre, of the cube of the stroke, that a part may weigh.

What goes up and down weighs 300 (slow two-strokes) to 4,000 (short strokes of racing engines) of these:
five times what is built, and a fifteenth of the least that grammes taken for kilogrammes come to.
"""
MULTIPLE = 20
"""Times the engine's own mass, reciprocating or rotating, that a part may weigh where one is given."""
MOST_PARTS = 1000
"""Rows that a file may hold, far above any engine's cylinders."""


@dataclass(frozen=True, init=False)
class Part:
    """A weighed part: its name, its reciprocating and its rotating mass in kg."""

    name: str
    reciprocating: Fraction
    rotating: Fraction
    place: str = field(default="", repr=False, compare=False)
    """The file and the line it is listed on, where it comes from a file."""

    def __init__(
        self, name: object, reciprocating: object = 0, rotating: object = 0, place: str = ""
    ) -> None:
        object.__setattr__(self, "name", str(name))
        object.__setattr__(self, "place", place)
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


def checked_sets(parts: object, engine: Engine) -> tuple[PartSet, ...]:
    """Return the sets of parts, one part for each of an engine's cylinders, or refuse.

    A list of numbers is one set of pistons, kg. Refused are parts that share a name, since the result
    could not say which goes where, and one too heavy for the engine: see `heaviest_part`.

    >>> from symbalance.engine.builders import inline
    >>> [p.name for p in checked_sets([0.45, 0.46], inline("1-2", ratio=4))[0].parts]
    ['piston 1', 'piston 2']
    """
    count = len(engine.cylinders)
    values = as_list(parts, "parts", "[0.452, 0.450, 0.455, 0.449]")
    if not all(isinstance(v, PartSet) for v in values):
        pistons = tuple(Part(f"piston {i}", v) for i, v in enumerate(values, 1))
        values = [PartSet("piston", pistons)]
    for one in values:
        if len(one.parts) != count:
            what, rule = f"{len(one.parts)} {one.kind}s", f"the engine has {count} cylinders"
            raise SymbalanceError(what, rule, "list one part for each cylinder")
        _check_names(one)
        _check_weights(one, engine)
    return tuple(values)


def _check_names(parts: PartSet) -> None:
    """Refuse two parts of one name, though its letters be composed in two ways."""
    lines: dict[str, Part] = {}
    for number, part in enumerate(parts.parts, 1):
        name = unicodedata.normalize("NFC", part.name)
        first = lines.setdefault(name, part)
        if first is not part:
            other = f"at {first.place} too" if first.place else f"before, and of part {number}"
            rule = f"is the name of a {parts.kind} {other}"
            remedy = "name each part once, or leave the column name out"
            raise SymbalanceError(f"name = {brief(part.name)!r}", rule, remedy, part.place)


def _check_weights(parts: PartSet, engine: Engine) -> None:
    most, why = heaviest_part(engine)
    for part in parts.parts:
        for key in ("reciprocating", "rotating"):
            mass = getattr(part, key)
            if mass > most:
                what = f"{part.name}: {key} mass = {_short(mass)} kg"
                rule = f"must be at most {_short(most)} kg, {why}"
                raise SymbalanceError(what, rule, "write kg, not g; " + STATED, part.place)


STATED = "for a larger engine give its stroke in [crank_train]"


def heaviest_part(engine: Engine) -> tuple[Fraction, str]:
    """Return what a part of an engine may weigh, in kg, and why: as much as its sizes leave possible.

    A number of grammes taken for kilogrammes shows only beside an engine's size: 500 kg are no car's
    piston, and a tenth of a large ship's with its crosshead. So the bound goes with the cube of the
    stroke, or with the mass that the engine gives, whichever is more.

    >>> from symbalance.engine.crank_train import CrankTrain
    >>> from symbalance.engine.builders import inline
    >>> sizes = [CrankTrain(stroke=stroke, rod=4 * stroke) for stroke in (80, 500)]
    >>> [float(heaviest_part(inline("1-2", crank_train=size))[0]) for size in sizes]
    [10.24, 2500.0]
    """
    strokes = [c.stroke for c in engine.cylinders if c.stroke is not None]
    masses = [m for c in engine.cylinders for m in (c.reciprocating_mass, c.rotating_mass) if m]
    bounds = [
        (DENSEST * (stroke / 1000) ** 3, f"for a stroke of {_short(stroke)} mm") for stroke in strokes
    ]
    bounds += [(Fraction(MULTIPLE * mass), f"{MULTIPLE} times the engine's own") for mass in masses]
    return max(bounds, default=(Fraction(UNSIZED), "as the engine gives no stroke"))


def _short(number: Fraction) -> str:
    return f"{float(number):.6g}"


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
    masses = [_masses(header, row) for row in rows]
    return _sets(header, names, masses, [row.place for row in rows], paired)


def _check_header(where: str, header: Sequence[str]) -> None:
    unknown = [name for name in header if name not in COLUMNS]
    if len(unknown) == len(header):  # no list of parts: what stands there is nobody's business
        rule = "names no column that is known"
        raise SymbalanceError("header", rule, f"it may name {', '.join(COLUMNS)} (kg)", where)
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
    header: Sequence[str],
    names: Sequence[str],
    rows: Sequence[dict[str, Fraction]],
    places: Sequence[str],
    paired: bool,
) -> tuple[PartSet, ...]:
    def parts(kind: str, columns: Sequence[str]) -> PartSet:
        return PartSet(kind, tuple(_parts(kind, names, rows, places, columns)))

    has_rods = any(name.startswith("rod") for name in header)
    if "piston" not in header or not has_rods or paired:
        kind = "set" if "piston" in header and has_rods else "piston" if "piston" in header else "rod"
        return (parts(kind, COLUMNS[1:]),)
    return parts("piston", ("piston",)), parts("rod", COLUMNS[2:])


def _parts(
    kind: str,
    names: Sequence[str],
    rows: Sequence[dict[str, Fraction]],
    places: Sequence[str],
    columns: Sequence[str],
) -> Iterator[Part]:
    for i, (name, row, place) in enumerate(zip(names, rows, places, strict=True), 1):
        masses = {key: row[key] for key in columns if key in row}
        turning = masses.pop("rod_rotating", Fraction(0))
        yield Part(name or f"{kind} {i}", sum(masses.values(), Fraction(0)), turning, place)
