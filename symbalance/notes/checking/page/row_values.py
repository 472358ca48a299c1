"""A letter's number in a row of a table, beside the value of its formula at the row's angle or speed.

Where a factor of the formula has no number, the rows are compared with one of them: whatever the mass is,
a force that goes with the square of the speed is nine times as large at three times the speed.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from math import inf, nan
from typing import NamedTuple

from symbalance.document.formula import PI, Call, Constant, Formula, Number, Product, names, walk
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.algebra.letters_behind import letters_behind, names_behind
from symbalance.notes.algebra.tree_values import NO_VALUE, TreeValues
from symbalance.notes.algebra.values import random_point
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.relations import decide, written_out
from symbalance.notes.checking.deciding.substitution import replace_part, substitute
from symbalance.notes.reading.equations import Chain

_OMEGAS = ("omega", "Omega", "w", "w_0", "omega_0")
BY_ROW = ", by its row"
_POINTS, _NEAR = 3, 1e-9
"""Values of the open letters at which a ratio has to be the same, up to the rounding of floats."""
MOST_COMPARED_WITH = 20
"""Rows, the first ones, with which all are compared: a table of thousands takes time in proportion."""


class Place(NamedTuple):
    """What a row of a table is at: an angle or a speed, and the letter of its column's head."""

    kind: str
    letter: str
    number: Number
    text: str
    others: tuple[tuple[str, Number], ...] = ()
    """What other letters are in the row, by the heads of their columns."""

    @property
    def value(self) -> Formula:
        """The angle, the angular speed or the number of the letter."""
        if self.kind == "letter":
            return self.number
        return Product((Number(self.number.value / (180 if self.kind == "angle" else 30)), PI))

    @property
    def is_at_dead_centre(self) -> bool:
        """Whether it is a multiple of a half turn."""
        return self.kind == "angle" and self.number.value % 180 == 0


class Row(NamedTuple):
    """A letter in a row of a table: its number (nan: a formula), half a unit of its last place."""

    chain: Chain
    number: float
    half: float
    place: Place


class Judged(NamedTuple):
    """A row, whether its number is its formula's value there, and how far they are apart."""

    row: Row
    decision: Decision
    gap: float
    ratio: float = 0.0
    """The row's number over the formula's; 0 where that is not known."""


def by_formula(rows: list[Row], formula: Formula, name: str, knowledge: Knowledge) -> Iterator[Judged]:
    """Yield the rows with the decisions on their numbers by a formula whose letters all have numbers."""
    for row in rows:
        there = _at_place(row.place, formula, name, knowledge)
        if there is None or letters_behind(there[0], _values(there[1])):
            continue
        value = _number_at(there, 0)
        gap = inf if value is None else abs(value - row.number)
        yield Judged(row, _decided(row, there), gap, row.number / value if value else 0.0)


def in_letters(rows: list[Row], formula: Formula, name: str, knowledge: Knowledge) -> Iterator[Judged]:
    """Yield the rows with the decisions on their formulas by the letter's formula at the row's place."""
    for row in rows:
        if (there := _at_place(row.place, formula, name, knowledge)) is not None:
            yield Judged(row, _decided(row, there), inf)


def _decided(row: Row, there: tuple[Formula, Knowledge]) -> Decision:
    left, right = row.chain.sides
    return decide(replace(left, readings=(there[0],)), right, row.chain.relations[0].sign, there[1])


def _at_place(
    place: Place, formula: Formula, name: str, knowledge: Knowledge
) -> tuple[Formula, Knowledge] | None:
    """Return a formula at a row's place and what is known there; None where it does not depend on it."""
    known = _with_formulas(name, place, knowledge)
    given = {letter: Definition(number, 0, numeric=True) for letter, number in place.others}
    known = replace(known, definitions={**known.definitions, **given})
    if place.kind == "speed":
        speeds = _speeds(formula, place, known)
        return (formula, replace(known, definitions={**known.definitions, **speeds})) if speeds else None
    letter = place.letter if place.letter in _behind(formula, known) else ""
    letter = letter or (_turning(formula, known) if place.kind == "angle" else "")
    if not letter:
        return None
    try:
        formula = substitute(written_out(formula, known, letter), letter, place.value)
    except (NoFormError, TooLargeError):
        return None
    rest = {n: d for n, d in known.definitions.items() if n != letter}
    return formula, replace(known, definitions=rest)


def by_ratios(
    rows: list[Row], formula: Formula, name: str, knowledge: Knowledge
) -> Iterator[list[Judged]]:
    """Yield the decisions on the rows by each in turn, where a factor of the formula is not known.

    F goes with the square of the speed, whatever the mass is: 0.87 kN at 1500 rpm is 7.8 kN at 4500 rpm.
    """
    places = [_at_place(row.place, formula, name, knowledge) for row in rows]
    points = [[_number_at(there, seed) for there in places] for seed in range(_POINTS)]
    for k, first in enumerate(rows[:MOST_COMPARED_WITH]):
        ratios = [_same_ratio([(point[n], point[k]) for point in points]) for n in range(len(rows))]
        judged = [
            _beside(row, first, ratio)
            for row, ratio in zip(rows, ratios, strict=True)
            if ratio is not None
        ]
        others = [each for each in judged if each.row is not first and each.row.number]
        if first.number and any(each.decision.is_proved for each in others):  # not by itself, nor by zero
            yield judged


def _beside(row: Row, first: Row, ratio: float) -> Judged:
    """Return the decision on a row by another one, of which the formula has `ratio` times the value."""
    expected = first.number * ratio
    gap = abs(row.number - expected)
    text = f"it goes with the row {first.place.text.removesuffix(BY_ROW)}"
    if gap <= (row.half + first.half * abs(ratio)) * (1 + _NEAR):
        return Judged(row, Decision(PROVED, assumptions=(text,)), gap)
    witness = {"left": f"{expected:.4g}", "right": f"{row.number:.4g}"}
    factor = row.number / expected if expected else 0.0
    return Judged(row, Decision(REFUTED, text, witness=witness), gap, factor)


def _same_ratio(pairs: list[tuple[float | None, float | None]]) -> float | None:
    """Return the ratio of two values, None where it depends on the open letters."""
    ratios = [one / other for one, other in pairs if one is not None and other]
    is_same = len(ratios) == len(pairs) and all(abs(r - ratios[0]) <= _NEAR * abs(r) for r in ratios)
    return ratios[0] if is_same else None


def _number_at(there: tuple[Formula, Knowledge] | None, seed: int) -> float | None:
    """Return the value of a formula where its open letters have some positive numbers."""
    if there is None:
        return None
    formula, known = there
    values = {**known.meaning.values, **_values(known)}
    meaning = replace(known.meaning, values=values)
    free = sorted(letters_behind(formula, values))
    point = random_point(free, meaning.domain(), seed)
    try:
        return float(TreeValues(meaning, point).value(formula).real)
    except NO_VALUE:
        return None


def number_of(node: Formula) -> float:
    """Return the value of a number as printed, nan for what has letters or no value."""
    try:
        return nan if names(node) else float(TreeValues(SymbolValue(), {}).value(node).real)
    except NO_VALUE:
        return nan


def _values(known: Knowledge) -> dict[str, Formula]:
    return {n: d.node for n, d in known.definitions.items()}


def _with_formulas(name: str, place: Place, knowledge: Knowledge) -> Knowledge:
    """Return what is known without a letter's own number; at another speed, of what turns by formulas."""
    definitions = {n: d for n, d in knowledge.definitions.items() if n != name}
    for other, own in definitions.items() if place.kind == "speed" else ():
        if own.numeric and own.formula is not None and names(own.formula) & {*_OMEGAS, "n", "N"}:
            definitions[other] = replace(own, node=own.formula, numeric=False)
    return replace(knowledge, definitions=definitions, solved={}, solved_from=())


def _behind(formula: Formula, known: Knowledge) -> set[str]:
    return {*names_behind(formula, {n: d.node for n, d in known.definitions.items()})}


def _turning(formula: Formula, known: Knowledge) -> str:
    """Return the only letter that turns behind a formula, "" where there are several or none."""
    values = {n: d.node for n, d in known.definitions.items()}
    nodes = [formula, *(values[n] for n in _behind(formula, known) if n in values)]
    waves = [
        p for node in nodes for p in walk(node) if isinstance(p, Call) and p.function in ("sin", "cos")
    ]
    turning = {n for wave in waves for n in names(wave.argument)}
    return next(iter(turning)) if len(turning) == 1 else ""


def _speeds(formula: Formula, place: Place, known: Knowledge) -> dict[str, Definition]:
    """Return what a row's speed makes of the letters of speeds behind a formula."""
    speeds: dict[str, Definition] = {}
    for name in _behind(formula, known):
        own = known.definitions.get(name)
        if name in _OMEGAS:
            speeds[name] = Definition(place.value, own.line if own else 0, numeric=True)
        elif own is None and name == place.letter and _counts_minutes(formula):
            speeds[name] = Definition(Number(place.number.value), 0, numeric=True)
        elif own is not None and name[:1] in "nN" and not names(own.node):
            numbers = [p for p in walk(own.node) if isinstance(p, Number)]
            largest = max(numbers, key=lambda number: number.value, default=None)
            if largest is not None:
                node = replace_part(own.node, largest, Number(place.number.value))
                speeds[name] = replace(own, node=node, rounded=None)
    return speeds


def _counts_minutes(formula: Formula) -> bool:
    """Tell whether a formula makes radians per second of a number of revolutions per minute: 2π n/60."""
    numbers = {part.value for part in walk(formula) if isinstance(part, Number)}
    return Constant("pi") in set(walk(formula)) and not numbers.isdisjoint((30, 60))
