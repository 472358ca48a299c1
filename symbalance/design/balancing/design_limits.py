"""Limits of a design: shafts, stations and sizes it may use, and how its residual is weighted."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from symbalance.design.balancing.planes import SPREADS
from symbalance.errors import SymbalanceError, brief
from symbalance.kinematics.slider_crank import HIGHEST_ORDER
from symbalance.text.numbers import as_list, checked_whole, exact

MOST_SHAFTS = 1000
"""The largest number of shafts that may be given, far above what any engine has."""


@dataclass(frozen=True)
class Weighting:
    """Weights of a residual: its vertical and lateral parts, and a length (pitches) for couples."""

    vertical: Fraction = Fraction(1)
    lateral: Fraction = Fraction(1)
    length: Fraction = Fraction(1)

    @property
    def tilt(self) -> Fraction:
        """(v - l)/(v + l): 0 where both directions weigh the same."""
        return (self.vertical - self.lateral) / (self.vertical + self.lateral)


@dataclass(frozen=True)
class Limits:
    """Limits of a design: shafts, stations and sizes it may use, and how its residual is weighted."""

    shafts: int | None
    counter_rotation: bool
    counterweights: bool
    stations: tuple[Fraction, ...] | None
    spread: str
    weighting: Weighting
    most: Fraction | None
    per_throw: bool


def checked_limits(
    *,
    shafts: object,
    counter_rotation: bool,
    counterweights: bool,
    stations: object,
    spread: str,
    vertical: object,
    lateral: object,
    length: object,
    most: object,
    per_throw: bool,
) -> Limits:
    """Return limits from what a user gives, or refuse what cannot be one."""
    if spread not in SPREADS:
        rule = f"must be one of {', '.join(SPREADS)}"
        raise SymbalanceError(f"spread = {brief(spread)}", rule, "ends takes the fewest weights")
    if per_throw and not counterweights:
        rule, remedy = "puts counterweights on every throw", "leave out one of the two"
        raise SymbalanceError("per_throw without counterweights", rule, remedy)
    return Limits(
        None if shafts is None else checked_whole(shafts, "shafts", 0, MOST_SHAFTS, "0 is none"),
        bool(counter_rotation),
        bool(counterweights),
        None if stations is None else tuple(exact(s, "stations") for s in _places(stations)),
        spread,
        checked_weighting(vertical, lateral, length),
        None if most is None else _positive(most, "most"),
        bool(per_throw),
    )


def checked_orders(remove: Any) -> tuple[int, ...]:
    """Return orders to remove, each once and in order, or refuse what is none.

    >>> checked_orders([2, 1, 2])
    (1, 2)
    """
    remedy, orders = "name orders like [1, 2]", as_list(remove, "remove", "[1, 2]")
    if not orders:
        raise SymbalanceError("remove = []", "names no order", remedy)
    return tuple(sorted({checked_whole(n, "remove", 1, HIGHEST_ORDER, remedy) for n in orders}))


def checked_weighting(vertical: object, lateral: object, length: object = 1) -> Weighting:
    """Return weights of the two directions and a length for couples, or refuse them."""
    up, side = exact(vertical, "vertical"), exact(lateral, "lateral")
    if min(up, side) < 0 or up + side == 0:
        what, rule = f"vertical = {brief(vertical)}, lateral = {brief(lateral)}", "must be weights"
        raise SymbalanceError(what, f"{rule}, not negative, one of them above 0", "1 and 1 are even")
    return Weighting(up, side, _positive(length, "length"))


def _places(stations: Any) -> list[object]:
    places = as_list(stations, "stations", "[2, -2]")
    if not places:
        raise SymbalanceError("stations = []", "leave no place for a weight", "give one or two")
    return places


def _positive(value: object, name: str) -> Fraction:
    number = exact(value, name)
    if number <= 0:
        raise SymbalanceError(f"{name} = {brief(value)}", "must be above 0", "give a size")
    return number
