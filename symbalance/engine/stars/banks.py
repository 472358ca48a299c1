"""Bank angles at which a vee on shared pins fires evenly, and the pin offsets other angles need.

N cylinders fire evenly h = 180 strokes/N degrees apart. On one pin, the right cylinder's pin turned on
by the offset s, right and left axes beta apart, the right one reaches top dead centre (beta - s) after
the left one: so beta - s must be a multiple of h (modulo 360), and one that the crank allows.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from fractions import Fraction
from math import gcd
from typing import Any

from symbalance.engine.cylinders import MOST_CYLINDERS
from symbalance.engine.engine import checked_strokes
from symbalance.errors import SymbalanceError, brief
from symbalance.exact.angles import degrees
from symbalance.text.numbers import as_list, checked_whole, exact

Crank = int | Sequence[object]
"""A number of cylinders (any crank), or the throws of the pins two cylinders share, in degrees."""


def even_interval(count: int, strokes: int = 4) -> Fraction:
    """Return the degrees between the firings of `count` evenly firing cylinders: 180 strokes/count.

    >>> [str(even_interval(n)) for n in (2, 3, 4, 5, 6, 7, 8, 10, 12)]
    ['360', '240', '180', '144', '120', '720/7', '90', '72', '60']
    """
    return Fraction(180 * checked_strokes(strokes), _counted(count))


def fewest_cylinders(push: object = 180, strokes: int = 4) -> int:
    """Return how few evenly firing cylinders have one pushing at any time, each for `push` degrees.

    The power strokes must overlap, push > 180 strokes/N: where one ends as the next begins, at a dead
    centre, neither turns the crank. A push lasts at most 180 degrees.

    >>> fewest_cylinders(), fewest_cylinders(120)
    (5, 7)
    """
    lasts = exact(push, "push")
    if not 0 < lasts <= 180:
        raise SymbalanceError(
            f"push = {brief(push)}", "must lie in (0, 180]", "degrees of one power stroke"
        )
    cycle = 180 * checked_strokes(strokes)
    fewest = cycle // lasts + 1
    return checked_whole(int(fewest), "cylinders for so short a push", 1, MOST_CYLINDERS, "lengthen it")


def natural_bank_angles(crank: Crank, strokes: int = 4) -> tuple[Fraction, ...]:
    """Return the bank angles in (0, 180] at which a vee on shared pins fires evenly, smallest first.

    `crank` is the number of cylinders (even; every angle that some crank allows), or the throws of the
    pins, for that crank alone.

    >>> [[int(b) for b in natural_bank_angles(n)] for n in (4, 6, 8, 10, 12)]
    [[180], [120], [90, 180], [72, 144], [60, 120, 180]]
    >>> [int(b) for b in natural_bank_angles([0, 180, 180, 0])]  # the flat crank of a V8
    [90]
    """
    return tuple(lag for lag in _lags(crank, strokes) if 0 < lag <= 180)


def pin_offsets(crank: Crank, bank_angle: object, strokes: int = 4) -> tuple[Fraction, ...]:
    """Return the offsets of right cylinders' pins from left ones' with which a vee fires evenly.

    Degrees in (-180, 180], positive in the sense of rotation (the `splay` of `vee`), smallest first;
    (0, ...) where the bank angle is natural. `crank` as for `natural_bank_angles`.

    >>> [[str(s) for s in pin_offsets(6, b)] for b in (60, 90, 120)]
    [['-60', '60', '180'], ['-30', '90', '-150'], ['0', '-120', '120']]
    """
    beta = degrees(bank_angle, "bank_angle").in_degrees()
    if not 0 <= beta <= 180:
        raise SymbalanceError(f"bank_angle = {brief(bank_angle)}", "must lie in [0, 180] degrees")
    offsets = (180 - (180 - beta + lag) % 360 for lag in _lags(crank, strokes))
    return tuple(sorted(offsets, key=lambda s: (abs(s), s)))


def _lags(crank: Crank, strokes: int) -> list[Fraction]:
    """Return in [0, 360) how far after the left cylinder the right one may reach top dead centre."""
    if isinstance(crank, Sequence) and not isinstance(crank, str):
        return _lags_of_pins(_pins(crank), strokes)
    count = _counted(crank, "crank")
    if count % 2:
        remedy = "two on each pin; for an odd number build the vee from its firing order"
        raise SymbalanceError(f"crank = {count}", "must be an even number of cylinders", remedy)
    step, whole_turn = even_interval(count, strokes), 2 * count // strokes
    return [k * step for k in range(whole_turn) if _tiles(k, count, strokes)]


def _tiles(k: int, count: int, strokes: int) -> bool:
    """Tell whether pairs k places apart can fill all places: always where each place is filled twice.

    In a two-stroke every one of the N places is filled once. Steps of k run through cycles of
    N/gcd(N, k) places, which pairs of neighbours fill only if that is even.
    """
    return strokes == 4 or count // gcd(count, k) % 2 == 0


def _lags_of_pins(pins: list[Fraction], strokes: int) -> list[Fraction]:
    step = even_interval(2 * len(pins), strokes)
    places = {(k * step - pins[0]) % 360 for k in range(int(360 / step))}
    even_moments = Counter(dict.fromkeys(places, strokes // 2))
    lags = [k * step for k in range(len(places))]
    return [lag for lag in lags if _top_dead_centres(pins, lag) == even_moments]


def _top_dead_centres(pins: list[Fraction], lag: Fraction) -> Counter[Fraction]:
    """Return how many cylinders reach top dead centre at each angle, the right ones `lag` later."""
    return Counter([-pin % 360 for pin in pins] + [(lag - pin) % 360 for pin in pins])


def _pins(crank: Sequence[object]) -> list[Fraction]:
    pins = [degrees(pin, f"crank[{i}]").in_degrees() for i, pin in enumerate(as_list(crank, "crank"), 1)]
    if not 1 <= len(pins) <= MOST_CYLINDERS // 2:
        rule = f"must have 1 to {MOST_CYLINDERS // 2} pins"
        raise SymbalanceError(f"crank of {len(pins)} pins", rule, "give the throw of each")
    return pins


def _counted(count: Any, name: str = "count") -> int:
    return checked_whole(count, name, 1, MOST_CYLINDERS, "cylinders of one engine")
