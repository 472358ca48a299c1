"""Search for real values of the letters at which two sides are equal, or one is larger.

Nothing is proved here: a relation for which no values turn up is refuted by a point at which it fails,
which is exact, and said to have none as far as tried. Values are drawn over fourteen decades, near 1, and
at the multiples of 30 degrees: numbers are put in for letters of any unit, conditions stand on angles.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from typing import Any

from symbalance.document.formula import Formula
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.algebra.letters_behind import letters_behind
from symbalance.notes.algebra.tree_values import DerivativeForms, TreeValues
from symbalance.notes.algebra.values import Point, context

TRIES = 90
_FEW = 3
"""Letters of which every mixture of -1, 0 and 1 is tried as well."""
STEPS = 70
"""Of a bisection: 2^-70 of a bracket is below what 20 digits show."""
FARTHEST = Fraction(20)
"""Of the search for a root without a change of sign: at 10^3, e^-x would count as 0."""
MOST_STEPS = 40
"""From a point to one at which an inequality fails: with half steps between, to 10^-6."""
VANISHES = 1e-12
"""Beside the values around it."""
_PI = Fraction(355, 113)


@dataclass(frozen=True)
class Survey:
    """The signs of left - right at the points tried: each with one such point, and how many there are.

    `generic` counts those at which no letter was chosen for being special.
    """

    examples: dict[int, tuple[Point, Any, Any]]
    counts: dict[int, int]
    generic: dict[int, int]
    has_root: bool

    @property
    def tried(self) -> int:
        """At how many points both sides were real."""
        return sum(self.counts.values())

    @property
    def is_equal_in_places(self) -> bool:
        """Tell whether the sides are equal at random points, as only a relation true on a branch is."""
        return 0 in self.generic and len(self.generic) > 1


def survey(
    left: Formula,
    right: Formula,
    meaning: SymbolValue,
    *,
    roots: bool = True,
    where: Callable[[Point], bool] | None = None,
    also: Sequence[Formula] = (),
) -> Survey:
    """Return where left - right is negative, zero and positive; with `roots`, whether it vanishes.

    `where` chooses points, at which the letters of `also` have values too.
    """
    difference = _Difference(left, right, meaning, also)
    examples: dict[int, tuple[Point, Any, Any]] = {}
    counts: dict[int, int] = {}
    generic: dict[int, int] = {}
    values: list[tuple[Point, Any]] = []
    for point, is_generic in _points(difference.letters, meaning):
        pair = difference.pair(point)
        if pair is None or (where is not None and not where(point)):
            continue
        gap, sign = pair[0] - pair[1], _sign(*pair)
        examples.setdefault(sign, (point, *pair))
        counts[sign] = counts.get(sign, 0) + 1
        if is_generic:
            generic[sign] = generic.get(sign, 0) + 1
        values.append((point, gap))
    has_root = 0 in counts or (roots and _has_root(difference, values))
    return Survey(examples, counts, generic, has_root)


def failing_point(
    left: Formula,
    right: Formula,
    meaning: SymbolValue,
    satisfied_by: Sequence[int],
    where: Callable[[Point], bool],
) -> tuple[Point, Any, Any] | None:
    """Return a point at which left - right has none of some signs, with both values; None where none is.

    `where` chooses points. Such points are looked for beyond those tried: from the nearest of them by
    steps that are halved.
    """
    difference = _Difference(left, right, meaning)
    values: list[tuple[Point, Any]] = []
    simple = _simple_points(difference.letters, meaning)
    for point in (*(point for point, _ in _points(difference.letters, meaning)), *simple):
        pair = difference.pair(point)
        if pair is None or not where(point):
            continue
        if _sign(*pair) not in satisfied_by:
            return (point, *pair)
        values.append((point, pair[0] - pair[1]))
    outward = -1 if 1 in satisfied_by else 1
    for start, gap in sorted(values, key=_size)[:3]:
        point = _climbed(difference, start, gap, outward, where)
        pair = difference.pair(point)
        if pair is not None and _sign(*pair) not in satisfied_by:
            return (point, *pair)
    return None


def _sign(left: Any, right: Any) -> int:
    """Return the sign of left - right, 0 where they agree to 25 digits."""
    gap, scale = left - right, max(abs(left), abs(right))
    return 0 if abs(gap) <= scale * context().mpf(10) ** -25 else (1 if gap > 0 else -1)


def _climbed(
    difference: _Difference, start: Point, gap: Any, outward: int, where: Callable[[Point], bool]
) -> Point:
    """Return a point near another at which (left - right) times `outward` is largest around there."""
    point, best, step = dict(start), gap * outward, Fraction(1)
    for _ in range(MOST_STEPS):
        better: Point | None = None
        for name in [n for n in point if n not in difference.meaning.integer]:
            for change in (step, -step):
                there = {**point, name: point[name] + change}
                value = difference.gap(there) if abs(there[name]) <= FARTHEST and where(there) else None
                if value is not None and value * outward > best:
                    better, best = there, value * outward
        if better is None:
            step /= 2
        point = better or point
    return point


class _Difference:
    """left - right at points, None where a side is not real."""

    def __init__(
        self, left: Formula, right: Formula, meaning: SymbolValue, also: Sequence[Formula] = ()
    ) -> None:
        self.left, self.right, self.meaning = left, right, meaning
        names = {name for node in (left, right, *also) for name in letters_behind(node, meaning.values)}
        self.letters = sorted(names)
        self.derivatives: DerivativeForms = {}

    def pair(self, point: Point) -> tuple[Any, Any] | None:
        at, mp = TreeValues(self.meaning, point, self.derivatives), context()
        try:
            row = [at.value(node) for node in (self.left, self.right)]
        except (NoFormError, TooLargeError, ArithmeticError, ValueError, KeyError, TypeError):
            return None  # outside the range of a function: no point of the relation
        if any(abs(v.imag) > abs(v) * mp.mpf(10) ** -20 or not mp.isfinite(v) for v in row):
            return None
        return row[0].real, row[1].real

    def gap(self, point: Point) -> Any:
        pair = self.pair(point)
        return None if pair is None else pair[0] - pair[1]


def sign_at(left: Formula, right: Formula, meaning: SymbolValue, point: Point) -> int | None:
    """Return the sign of left - right at a point, None where a side is not real."""
    gap = _Difference(left, right, meaning).gap(point)
    return None if gap is None else (gap > 0) - (gap < 0)


def _points(letters: list[str], meaning: SymbolValue) -> Iterator[tuple[Point, bool]]:
    if not letters:
        yield {}, False
        return
    chance = random.Random(f"{letters}")
    for k in range(TRIES):
        yield {name: _draw(name, meaning, chance, k % 3) for name in letters}, k % 3 < 2


def _simple_points(letters: list[str], meaning: SymbolValue) -> Iterator[Point]:
    """Yield points of ones and zeros, at which letters are equal: a² + b² > 2ab fails where a = b."""
    choices = [(1,) if name in meaning.positive else (1, 0, -1) for name in letters]
    if 0 < len(letters) <= _FEW:
        for values in product(*choices):
            yield dict(zip(letters, map(Fraction, values), strict=True))


def _draw(name: str, meaning: SymbolValue, chance: random.Random, kind: int) -> Fraction:
    if name in meaning.integer:
        return Fraction(chance.randint(0, 9))
    if name in meaning.ranges and kind:
        low, high = meaning.ranges[name]
        return Fraction(chance.randint(low * 9973, high * 9973), 997300)  # no number that a page may use
    if kind == 2 and name not in meaning.positive:
        return chance.randint(-12, 12) * _PI / 6
    size = chance.uniform(-7, 7) if kind == 0 else chance.uniform(-0.7, 0.7)
    value = Fraction(round(10 ** (size + 12)), 10**12)
    return value if name in meaning.positive or chance.random() < 0.5 else -value


def _has_root(difference: _Difference, values: list[tuple[Point, Any]]) -> bool:
    below = [item for item in values if item[1] < 0]
    above = [item for item in values if item[1] > 0]
    pairs = zip(sorted(below, key=_size)[:6], sorted(above, key=_size)[:6], strict=False)
    if any(_changes_sign_between(difference, *pair) for pair in pairs):
        return True
    nearest = sorted(values, key=_size)[:3]
    return any(_touches_zero(difference, *item) for item in nearest)


def _size(item: tuple[Point, Any]) -> Any:
    return abs(item[1])


def _changes_sign_between(
    difference: _Difference, low: tuple[Point, Any], high: tuple[Point, Any]
) -> bool:
    """Tell whether left - right passes through zero on the way from one point to another: no pole."""
    (a, gap_a), (b, gap_b) = low, high
    if any(name in difference.meaning.integer for name in a):
        return False
    bound = max(abs(gap_a), abs(gap_b)) * VANISHES
    for _ in range(STEPS):
        middle = {name: (a[name] + b[name]) / 2 for name in a}
        gap = difference.gap(middle)
        if gap is None:
            return False
        if abs(gap) <= bound:
            return True
        a, b = (middle, b) if gap < 0 else (a, middle)
    return False


def _touches_zero(difference: _Difference, start: Point, gap: Any) -> bool:
    """Tell whether |left - right| comes down to zero around a point, by steps that are halved."""
    point = {name: min(max(value, -FARTHEST), FARTHEST) for name, value in start.items()}
    best = difference.gap(point)
    if best is None:
        return False
    bound, step = max(abs(gap), 1) * VANISHES, Fraction(1)
    for _ in range(4 * STEPS):
        moved = False
        for name in [n for n in point if n not in difference.meaning.integer]:
            for change in (step, -step):
                value = point[name] + change
                if abs(value) > FARTHEST or (name in difference.meaning.positive and value <= 0):
                    continue
                there = difference.gap({**point, name: value})
                if there is not None and abs(there) < abs(best):
                    point, best, moved = {**point, name: value}, there, True
        if abs(best) <= bound:
            return True
        if not moved:
            step /= 2
        if step < Fraction(1, 2**60):
            return False
    return False
