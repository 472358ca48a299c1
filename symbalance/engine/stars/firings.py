"""The firing orders a crank allows, and the intervals between firings.

A cylinder fires at one of its top dead centres. Counted from cylinder 1's, the first of them comes at

    t_j = (throw_1 - bank_1) - (throw_j - bank_j)  modulo 360 degrees;

a two-stroke fires there, a four-stroke there or 360 degrees later. Cylinders whose t_j agree share
these moments, and unless they may fire together each takes one: the choices of one such group do not
touch the next group's, so all firing orders are a product over the groups. Where an offset or a link
rod shifts the dead centre (`symbalance.engine.dead_centres`), t_j is where it then is, to a millionth of
a degree.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from itertools import permutations, product
from math import gcd, prod
from typing import TYPE_CHECKING, Any, ClassVar

from symbalance.document.result import SequenceResult
from symbalance.engine.dead_centres import (
    dead_centre_angles,
    firing_dead_centres,
    has_shifted_dead_centres,
)
from symbalance.engine.engine import Engine
from symbalance.errors import SymbalanceError, brief
from symbalance.exact.angles import Angle
from symbalance.text.numbers import exact

if TYPE_CHECKING:
    from symbalance.document.nodes import Document

MOST_ORDERS = 2**16
"""More firing orders are not listed: 17 cylinders, if they need not fire evenly."""

FARTHEST = 20
"""Degrees from an even moment beyond which no dead centre counts as lying there."""

Moments = dict[int, Fraction]
"""Cylinder number -> degrees after cylinder 1's firing."""


@dataclass(frozen=True, order=True)
class Firing:
    """A firing order: the cylinders' numbers, and the degrees after each firing (the last leads back).

    Refused: intervals that are negative, all 0, or not one for each cylinder.

    >>> four = Firing((1, 3, 4, 2), (Fraction(180),) * 4)
    >>> four.as_text(), four.is_even, four.overlap()
    ('1-3-4-2', True, Fraction(0, 1))
    """

    order: tuple[int, ...]
    intervals: tuple[Fraction, ...]

    def __post_init__(self) -> None:
        gaps = self.intervals
        if len(gaps) != len(self.order) or not any(gaps) or min(gaps) < 0:
            raise SymbalanceError(
                f"intervals = {brief(list(map(str, gaps)))}",
                f"must be {len(self.order)} degrees of 0 or more, not all 0",
                "one after each firing",
            )

    @property
    def is_even(self) -> bool:
        """Whether equally many cylinders fire at equally spaced moments; one each, as a rule."""
        gaps = [gap for gap in self.intervals if gap]
        together = len(self.order) // len(gaps)
        spaced = all(gap == gaps[0] for gap in gaps)
        return spaced and self.intervals == ((Fraction(0),) * (together - 1) + (gaps[0],)) * len(gaps)

    def as_text(self) -> str:
        """Return the order as it is written: 1-3-4-2."""
        return "-".join(map(str, self.order))

    def overlap(self, push: int | Fraction = 180) -> Fraction:
        """Return by how many degrees successive power strokes of `push` degrees overlap at the least.

        Negative: so long no cylinder pushes, and only the flywheel keeps the engine turning.
        """
        return push - max(self.intervals)


@dataclass(frozen=True, repr=False, eq=False)
class FiringOrders(SequenceResult[Firing]):
    """The firing orders that the crank of `engine` allows, and how they were asked for."""

    engine: Engine
    items: tuple[Firing, ...]
    even_only: bool
    simultaneous: bool
    within: Fraction
    kind: ClassVar[str] = "firing-orders"

    def summary(self) -> str:
        """Return how many orders there are, in one line."""
        which = "Even firing orders" if self.even_only else "Firing orders"
        return f"{which} of {self.engine.name}: {len(self)}"

    def document(self) -> Document:
        """Return a table of the orders and their intervals."""
        from symbalance.engine.stars.stars_document import firing_orders_document

        return firing_orders_document(self)

    def data(self) -> dict[str, Any]:
        """Return every order with its intervals, in degrees."""
        return {
            "engine": self.engine.name,
            "strokes": self.engine.strokes,
            "even_only": self.even_only,
            "simultaneous": self.simultaneous,
            "within": str(self.within),
            "firing_orders": [
                {"order": list(firing.order), "intervals": [str(gap) for gap in firing.intervals]}
                for firing in self
            ],
        }

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each order."""
        return [
            {
                "firing_order": firing.as_text(),
                "intervals_degrees": " ".join(map(str, firing.intervals)),
                "even": firing.is_even,
                "least_overlap_degrees": float(firing.overlap()),
            }
            for firing in self
        ]


def firing_orders(
    engine: Engine, *, even_only: bool = True, simultaneous: bool = False, within: object = 0
) -> FiringOrders:
    """Return all firing orders a crank allows, from its lowest-numbered cylinder; ignores `fires`.

    `even_only`: equal intervals; otherwise every order, 2^(N-1) in a four-stroke whose cylinders all
    reach top dead centre apart. `simultaneous`: cylinders may fire together (interval 0, written by
    number); such an order counts as even if equally many fire at equally spaced moments.
    `within`: dead centres that lie as near to a multiple of the even interval as so many degrees count
    as lying there, as pins rounded by their maker do.
    Refused: more than `MOST_ORDERS` orders, and a symbolic angle between cylinders.

    >>> from symbalance.engine.builders import inline, vee
    >>> [f.as_text() for f in firing_orders(inline(throws=[0, 180, 180, 0]))]
    ['1-2-4-3', '1-3-4-2']
    >>> len(firing_orders(vee(90, pins=[0, 120, 240])))  # a 90-degree V6 on shared pins: never even
    0
    >>> from symbalance.engine.catalogue import load
    >>> [f.as_text() for f in firing_orders(load("vw-vr6"), within="1/2")]
    ['1-2-3-6-5-4', '1-2-4-6-5-3', '1-5-3-6-2-4', '1-5-4-6-2-3']
    """
    _checked(engine)
    near = _checked_within(within)
    items = tuple(_all_firings(engine, even_only, simultaneous, near))
    return FiringOrders(engine, items, even_only, simultaneous, near)


def _all_firings(engine: Engine, even_only: bool, simultaneous: bool, within: Fraction) -> list[Firing]:
    cycle, count = 180 * engine.strokes, len(engine.cylinders)
    groups = _groups(engine, within)
    if not even_only:
        choices = [_choices(group, start, cycle, simultaneous) for start, group in groups.items()]
        return _listed(choices, cycle)
    firings: set[Firing] = set()
    for together in range(1, count + 1 if simultaneous else 2):
        if count % together == 0:
            moments = {Fraction(cycle * together * k, count) for k in range(count // together)}
            choices = [_evenly(group, start, cycle, moments, together) for start, group in groups.items()]
            firings |= set(_listed(choices, cycle))
    return sorted(firings)


def evenest(engine: Engine) -> list[Firing]:
    """Return the firing orders with the least sum of squared intervals: the even ones, if there are any.

    Intervals alone are compared, not whether the banks fire by turns.

    >>> from symbalance.engine.builders import vee
    >>> for firing in evenest(vee(90, pins=[0, 120, 240])):
    ...     print(firing.as_text(), [int(gap) for gap in firing.intervals])
    1-2-6-4-5-3 [90, 120, 120, 150, 120, 120]
    1-5-3-4-2-6 [120, 120, 90, 120, 120, 150]
    1-5-6-4-2-3 [120, 90, 120, 120, 150, 120]
    """
    orders = firing_orders(engine) or firing_orders(engine, even_only=False)
    squares = [sum(gap * gap for gap in firing.intervals) for firing in orders]
    least = min(squares, default=Fraction(0))
    return [firing for firing, size in zip(orders, squares, strict=True) if size == least]


def known_firing(engine: Engine) -> Firing:
    """Return the firing order an engine's `fires` say, its lowest-numbered cylinder first.

    Intervals are those between top dead centres.

    >>> from symbalance.engine.catalogue import load
    >>> known_firing(load("v8-90")).as_text()
    '1-8-4-3-6-5-7-2'
    """
    cycle = 180 * _checked(engine).strokes
    fires: Moments = {c.number: c.fires for c in engine.cylinders if c.fires is not None}
    if len(fires) < len(engine.cylinders):
        missing = next(c.number for c in engine.cylinders if c.fires is None)
        raise SymbalanceError(
            f"cylinder {missing} of {engine.name}",
            "has no firing angle",
            "give fires, or ask firing_orders(engine) for those its crank allows",
        )
    if has_shifted_dead_centres(engine):
        return _firing(firing_dead_centres(engine), cycle)
    start = fires[min(fires)]
    return _firing({number: (angle - start) % cycle for number, angle in fires.items()}, cycle)


def intervals(engine: Engine) -> tuple[Fraction, ...]:
    """Return the degrees after each firing of an engine whose `fires` are known: between dead centres.

    >>> from symbalance.engine.catalogue import load
    >>> [int(gap) for gap in intervals(load("v6-90"))]
    [150, 90, 150, 90, 150, 90]
    """
    return known_firing(engine).intervals


def is_even(engine: Engine) -> bool:
    """Tell whether an engine whose `fires` are known fires evenly."""
    return known_firing(engine).is_even


def _checked(engine: object) -> Engine:
    if not isinstance(engine, Engine):
        rule = "must be an Engine"
        raise SymbalanceError(f"engine = {brief(engine)}", rule, "build one, as inline(throws=[0, 180])")
    return engine


def _checked_within(within: object) -> Fraction:
    degrees = exact(within, "within")
    if not 0 <= degrees <= FARTHEST:
        raise SymbalanceError(f"within = {brief(within)}", f"must lie in [0, {FARTHEST}]", "degrees")
    return degrees


def _groups(engine: Engine, within: Fraction) -> dict[Fraction, list[int]]:
    """Return the cylinders by the degrees at which they first reach top dead centre, cylinder 1 at 0."""
    cylinders = sorted(engine.cylinders, key=lambda c: c.number)
    shifted_angles = dead_centre_angles(engine) if has_shifted_dead_centres(engine) else {}
    count, turns = len(cylinders), engine.strokes // 2
    step = Fraction(360 * gcd(count, turns), count)  # even moments, modulo a turn
    groups: dict[Fraction, list[int]] = {}
    for cylinder in cylinders:
        ahead = _numeric(cylinders[0].delay - cylinder.delay, cylinder.number).turns * 360
        ahead = shifted_angles.get(cylinder.number, ahead)
        place = round(ahead / step) * step
        if abs(ahead - place) <= within:
            ahead = place
        groups.setdefault(ahead % 360, []).append(cylinder.number)
    return groups


def _numeric(angle: Angle, number: int) -> Angle:
    if angle.symbols:
        raise SymbalanceError(
            f"cylinder {number} at {angle.as_text()}",
            "fires at a symbolic angle from the first cylinder",
            "give the bank angle or the throw as a number",
        )
    return angle


def _choices(group: list[int], start: Fraction, cycle: int, simultaneous: bool) -> list[Moments]:
    """Return every way a group's cylinders may share their top dead centres."""
    slots = [start + turn for turn in range(0, cycle, 360)]
    if simultaneous:
        _check_count(len(slots) ** len(group))
        assignments: Iterable[tuple[Fraction, ...]] = product(slots, repeat=len(group))
    else:
        assignments = permutations(slots, len(group))
    return [dict(zip(group, assignment, strict=True)) for assignment in assignments]


def _evenly(
    group: list[int], start: Fraction, cycle: int, moments: set[Fraction], together: int
) -> list[Moments]:
    """Return the choices that put so many together at each of the moments, and none elsewhere."""
    per_moment = {start + turn: together for turn in range(0, cycle, 360) if start + turn in moments}
    if len(group) != together * len(per_moment):
        return []
    assignments = _choices(group, start, cycle, together > 1)
    return [assignment for assignment in assignments if Counter(assignment.values()) == per_moment]


def _listed(choices: list[list[Moments]], cycle: int) -> list[Firing]:
    """Return a firing order for every combination of the groups' choices, cylinder 1 at 0."""
    first, *rest = choices
    first = [assignment for assignment in first if assignment[min(assignment)] == 0]
    _check_count(len(first) * prod(map(len, rest)))
    merged = (
        {number: at for assignment in assignments for number, at in assignment.items()}
        for assignments in product(first, *rest)
    )
    return sorted(_firing(moments, cycle) for moments in merged)


def _firing(moments: Moments, cycle: int) -> Firing:
    fired = sorted((at, number) for number, at in moments.items())
    ends = [at for at, _ in fired[1:]] + [Fraction(cycle)]
    gaps = tuple(end - at for (at, _), end in zip(fired, ends, strict=True))
    return Firing(tuple(number for _, number in fired), gaps)


def _check_count(count: int) -> None:
    if count > MOST_ORDERS:
        raise SymbalanceError(
            f"{brief(count)} firing orders",
            f"are too many to list (at most {MOST_ORDERS})",
            "ask for even_only=True, or for fewer cylinders",
        )
