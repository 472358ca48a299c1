"""The list of preset engines: what each is, its sizes, and which of them were looked up or estimated.

All of it is read from the presets' tables alone, without building an engine, so that the list is quick.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from math import nan
from typing import TYPE_CHECKING, Any, ClassVar

from symbalance.document.result import SequenceResult
from symbalance.errors import SymbalanceError, brief
from symbalance.text.numbers import checked_whole, exact

if TYPE_CHECKING:
    from symbalance.document.formula import Formula
    from symbalance.document.nodes import Document

KINDS = ("in-line", "vee", "boxer", "W", "radial")
LENGTHS = ("bore", "stroke", "rod", "pitch")
"""The lengths a preset should have, in mm."""
MASSES = ("reciprocating_mass", "rotating_mass")
UNITS = {**dict.fromkeys(LENGTHS, "mm"), **dict.fromkeys(MASSES, "kg")}
CONTENTS = ("sizes", "masses", "estimates")
"""What a preset may be asked to have: all lengths, a reciprocating mass, or something estimated."""


@dataclass(frozen=True)
class Preset:
    """A preset: its name, what it is, where its figures come from, its sizes and its estimates.

    `arrangement` says in a word or two how many cylinders stand how, and whether it has two strokes:
    "V8 90°". `lengths` are in mm, `masses` in kg of each cylinder, each as far as it is given.
    `estimates` says of what nobody looked up why it is what it is.
    """

    name: str
    description: str
    source: str
    kind: str
    arrangement: str
    cylinders: int
    strokes: int
    lengths: Mapping[str, Fraction]
    masses: Mapping[str, Fraction]
    estimates: Mapping[str, str]

    @property
    def sizes(self) -> str:
        """How well bore, stroke, rod and pitch are known: looked up, estimated, in part or none.

        One estimate among them makes them estimated; one that is not given, looked up in part. A single
        cylinder has no pitch to look up.
        """
        if not self.lengths:
            return "none"
        if any(key in self.estimates for key in self.lengths):
            return "estimated"
        return "looked up" if self._has_all_lengths else "in part"

    @property
    def _has_all_lengths(self) -> bool:
        return all(key in self.lengths or (key == "pitch" and self.cylinders == 1) for key in LENGTHS)

    @property
    def weights(self) -> str:
        """How well the reciprocating mass is known: looked up, estimated or none."""
        if "reciprocating_mass" not in self.masses:
            return "none"
        return "estimated" if "reciprocating_mass" in self.estimates else "looked up"

    def holds(self, contents: str) -> bool:
        """Tell whether the preset has all lengths, a reciprocating mass, or something estimated."""
        known = {
            "sizes": self._has_all_lengths,
            "masses": "reciprocating_mass" in self.masses,
            "estimates": bool(self.estimates),
        }
        return known[contents]


def preset_from(name: str, table: Mapping[str, Any]) -> Preset:
    """Return what the list says of a preset, from the tables of its file."""
    train, rows = table.get("crank_train", {}), table.get("cylinder", [])
    layout = table.get("layout", {})
    banks = [row.get("bank", 0) for row in rows] or layout.get("banks", [0])
    axes = [exact(bank, "bank") for bank in banks]
    cylinders = len(rows) or _layout_cylinders(layout)
    strokes = int(layout.get("strokes", table.get("strokes", 4)))
    return Preset(
        name,
        table["description"],
        table["source"],
        kind_of(axes),
        arrangement_of(axes, cylinders, strokes),
        cylinders,
        strokes,
        _present(train, LENGTHS),
        _present(train, MASSES),
        dict(table.get("estimates", {})),
    )


def _layout_cylinders(layout: Mapping[str, Any]) -> int:
    """Return how many cylinders a [layout] has, by the first of its lists that says it."""
    if "firing_order" in layout:
        return len(layout["firing_order"])
    return sum(map(len, layout["cylinders"])) if "cylinders" in layout else len(layout["pins"])


def _present(train: Mapping[str, Any], keys: Iterable[str]) -> dict[str, Fraction]:
    return {key: exact(train[key], key) for key in keys if key in train}


def kind_of(banks: Iterable[Fraction]) -> str:
    """Return in one word how cylinders stand whose axes have these angles, in degrees.

    Two banks half a turn apart are a boxer, whatever their pins. More than two are radial where they
    leave less than half a turn free, else a W.

    >>> kind_of([Fraction(-45), Fraction(45)]), kind_of([Fraction(0), Fraction(120), Fraction(240)])
    ('vee', 'radial')
    """
    gaps = _gaps(banks)
    if len(gaps) <= 1:
        return "in-line"
    if len(gaps) == 2:
        return "boxer" if gaps[0] == gaps[1] else "vee"
    return "radial" if max(gaps) < 180 else "W"


def arrangement_of(banks: Iterable[Fraction], cylinders: int, strokes: int) -> str:
    """Return how many cylinders stand how, of the angles of their axes in degrees, and two strokes.

    >>> arrangement_of([Fraction(-45), Fraction(45)], 8, 4), arrangement_of([Fraction(0)], 6, 2)
    ('V8 90°', '2-stroke in-line 6')
    """
    axes = tuple(banks)
    words = {
        "in-line": f"in-line {cylinders}" if cylinders > 1 else "single",
        "vee": f"V{cylinders} {float(min(_gaps(axes), default=0)):.4g}°",
        "boxer": f"boxer {cylinders}",
        "W": f"W{cylinders}",
        "radial": f"radial {cylinders}",
    }
    return ("2-stroke " if strokes == 2 else "") + words[kind_of(axes)]


def _gaps(banks: Iterable[Fraction]) -> list[Fraction]:
    """Return the angles from each axis to the next, all round."""
    axes = sorted({bank % 360 for bank in banks})
    return [(b - a) % 360 for a, b in zip(axes, [*axes[1:], *axes[:1]], strict=True)]


SORTS: dict[str, Callable[[Preset], Any]] = {
    "cylinders": lambda preset: preset.cylinders,
    **{key: lambda preset, key=key: preset.lengths.get(key) for key in LENGTHS},
    **{key: lambda preset, key=key: preset.masses.get(key) for key in MASSES},
}
"""What presets may be sorted by beside their names; those that lack it come last."""


@dataclass(frozen=True, repr=False, eq=False)
class Presets(SequenceResult[Preset]):
    """Preset engines, all of them or a selection; `in_full`, its document tells their sources too."""

    items: tuple[Preset, ...]
    in_full: bool = False
    kind: ClassVar[str] = "presets"

    def selected(
        self,
        *,
        cylinders: object = None,
        strokes: object = None,
        kind: str | None = None,
        having: Iterable[str] = (),
        sort: str | None = None,
        in_full: bool = False,
    ) -> Presets:
        """Return the presets of so many cylinders and strokes, of a kind, that have what is named.

        `kind` is one of `KINDS`, `having` some of `CONTENTS`, `sort` one of `SORTS` or "name".
        `in_full` adds descriptions, sources and estimates to the document.
        """
        tests: list[Callable[[Preset], bool]] = []
        if cylinders is not None:
            count = checked_whole(cylinders, "cylinders", 1, 1000, "count an engine's cylinders")
            tests.append(lambda preset: preset.cylinders == count)
        if strokes is not None:
            cycle = _one_of(str(strokes), ("2", "4"), "strokes")
            tests.append(lambda preset: str(preset.strokes) == cycle)
        if kind is not None:
            word = _one_of(kind, KINDS, "kind")
            tests.append(lambda preset: preset.kind == word)
        for contents in having:
            known = _one_of(contents, CONTENTS, "with")
            tests.append(lambda preset, known=known: preset.holds(known))
        chosen = [preset for preset in self if all(test(preset) for test in tests)]
        if _one_of(sort or "name", ("name", *SORTS), "sort") != "name":
            key = SORTS[str(sort)]
            chosen.sort(key=lambda preset: (key(preset) is None, key(preset) or 0))
        return replace(self, items=tuple(chosen), in_full=in_full)

    def summary(self) -> str:
        """Return how many there are, in one line."""
        return f"Preset engines: {len(self)}"

    def document(self) -> Document:
        """Return a table, a line an engine; `in_full`, also descriptions, sources and estimates."""
        from symbalance.document.nodes import UNKNOWN, Code, Column, Details, Document, Facts, Table

        if not self.items:
            return Document("Preset engines", (), "None is of this selection.")
        columns = tuple(map(Column, ("name", "engine", *LENGTHS, "mass", "sizes")))
        rows = tuple((Code(p.name), p.arrangement, *_numbers(p), p.sizes) for p in self)
        looked_up = sum(preset.sizes == "looked up" for preset in self)
        weighed = sum(preset.weights == "looked up" for preset in self)
        lead = (
            f"{len(self)} engine{'s' if len(self) > 1 else ''}; sizes looked up of {looked_up}, "
            f"masses of {weighed}. Bore, stroke, rod and pitch in mm, reciprocating mass of a cylinder "
            f"in kg, rounded; {UNKNOWN}: not given. Sizes are estimated where one of the four is. "
        )
        if not self.in_full:
            more = (
                lead,
                Code("--full"),
                " adds descriptions, sources and estimates, ",
                Code("--show NAME"),
            )
            return Document(
                "Preset engines", (Table("", columns, rows),), (*more, " prints an engine's file.")
            )
        facts = Facts(tuple((Code(p.name), _words(p)) for p in self))
        details = Details("What they are, and where their figures come from", (facts,))
        return Document("Preset engines", (Table("", columns, rows), details), lead.rstrip())

    def data(self) -> dict[str, Any]:
        """Return of every preset what it is, its sizes, its sources and its estimates."""
        return {"presets": [_record(preset) for preset in self]}

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each preset; a size that is not given is None, estimates are one text."""
        return [
            {
                **record,
                "estimates": "; ".join(f"{key}: {why}" for key, why in record["estimates"].items()),
            }
            for record in map(_record, self)
        ]


def _one_of(word: str, words: Iterable[str], name: str) -> str:
    known = {each.lower(): each for each in words}
    if word.lower() not in known:
        raise SymbalanceError(
            f"{name} = {brief(word)}", "is not known", f"one of {', '.join(known.values())}"
        )
    return known[word.lower()]


def _numbers(preset: Preset) -> list[Formula | str]:
    """Return lengths and the reciprocating mass as cells; a dash where one is not given."""
    from symbalance.document.decimals import fixed_cell

    values, places = {**preset.lengths, **preset.masses}, {"mm": 1, "kg": 2}
    keys = (*LENGTHS, "reciprocating_mass")
    return [fixed_cell(float(values.get(key, nan)), places[UNITS[key]]) for key in keys]


def _words(preset: Preset) -> str:
    """Return a preset's description, its masses, its source and its estimates."""
    masses = [f"{key.replace('_', ' ')} {float(value):.10g} kg" for key, value in preset.masses.items()]
    after = f"; {', '.join(masses)}" if masses else ""
    reasons = [f"{key.replace('_', ' ')}: {reason}" for key, reason in preset.estimates.items()]
    estimates = f" [estimates: {'; '.join(reasons)}]" if reasons else ""
    return f"{preset.description}{after} [{preset.source}]{estimates}"


def _record(preset: Preset) -> dict[str, Any]:
    values = {**preset.lengths, **preset.masses}
    numbers = {
        f"{key}_{unit}": float(values[key]) if key in values else None for key, unit in UNITS.items()
    }
    return {
        "name": preset.name,
        "description": preset.description,
        "source": preset.source,
        "kind": preset.kind,
        "arrangement": preset.arrangement,
        "cylinders": preset.cylinders,
        "strokes": preset.strokes,
        "sizes": preset.sizes,
        "masses": preset.weights,
        **numbers,
        "estimates": dict(preset.estimates),
    }
