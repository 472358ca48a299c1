"""Dead centres of a mechanism: the crank angles where its piston reverses, and its stroke.

At its dead centres an offset slider-crank's crank and rod lie in one line, stretched or folded:

    top     sin p =  eps/(lam + 1),            y = sqrt((lam + 1)^2 - eps^2),
    bottom  sin p = -eps/(lam - 1), cos p < 0, y = sqrt((lam - 1)^2 - eps^2).

At the top sin phi = (sin p - eps)/lam = -sin p, so that crank and rod add up to y = (lam + 1) cos p:

Formulas:
    (s - e)/L = -s
    ((L + 1) c)^2 = (L + 1)^2 - e^2
    with c = sqrt(1 - s^2); s = e/(L + 1); L, e positive

With eps > 0 the downward stroke takes more than half a turn, and the stroke exceeds 2 r. A link rod's
dead centres are roots of y', bracketed and computed to all digits.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from typing import Any

from symbalance.kinematics.mechanisms.mechanism_types import (
    Mechanism,
    SliderCrank,
    checked_mechanism,
    simplified,
)
from symbalance.kinematics.mechanisms.motion import height, height_motion
from symbalance.text.reals import DIGITS, Real, asin, nint, pi, sqrt

SAMPLES = 96
"""At how many crank angles a link rod's velocity is computed to bracket its changes of sign."""
GUARD = 10
"""Digits beyond those wanted, in which a root is sought."""
FIRST_SAMPLE = -2
"""Any angle in rad; this one is far from the dead centres of common engines."""


@dataclass(frozen=True)
class DeadCentres:
    """The crank angles `top` and `bottom` in rad and the piston's heights there over r.

    `top` lies in (-pi, pi) and `bottom` follows it by less than a turn; numbers are SymPy's of
    `exact_dead_centres` and decimals of `dead_centres`.
    """

    top: Any
    bottom: Any
    highest: Any
    lowest: Any

    @property
    def stroke(self) -> Any:
        """The distance between the dead centres, over r; 2 without offset."""
        return self.highest - self.lowest

    @property
    def down(self) -> Any:
        """The crank angle in rad that the downward stroke takes; pi without offset."""
        return self.bottom - self.top


def exact_dead_centres(mechanism: SliderCrank) -> DeadCentres:
    """Return the dead centres of a slider-crank as exact SymPy numbers.

    >>> exact_dead_centres(SliderCrank(4, 1)).stroke
    -2*sqrt(2) + 2*sqrt(6)
    >>> exact_dead_centres(SliderCrank(4, 1)).down
    -asin(1/5) + asin(1/3) + pi
    """
    import sympy

    lam, eps = (sympy.Rational(x.numerator, x.denominator) for x in (mechanism.ratio, mechanism.offset))
    return _lined_up(lam, eps, sympy.sqrt, sympy.asin, sympy.pi)


def dead_centres(mechanism: Mechanism, digits: int = DIGITS) -> DeadCentres:
    """Return the dead centres to `digits` significant digits.

    Of several turning points of a link rod's piston the highest and the lowest count.

    Of a slider-crank, where the piston's velocity is 0, as crank and rod are in line:

    Formulas:
        -s - c (s - e)/(L c) = 0
        with c = sqrt(1 - s^2); s = e/(L + 1); L, e positive

    >>> from symbalance.text.reals import nstr
    >>> nstr(dead_centres(SliderCrank(4, 1)).stroke, 12)
    '2.07055236082'
    """
    mechanism = simplified(checked_mechanism(mechanism))
    if isinstance(mechanism, SliderCrank):
        lam, eps = (Real(x, digits) for x in (mechanism.ratio, mechanism.offset))
        return _lined_up(lam, eps, sqrt, asin, pi(digits))
    turns, turn = _turning_points(mechanism, digits), 2 * pi(digits)
    top = max(turns, key=lambda p: height(mechanism, p))
    bottom = min(turns, key=lambda p: height(mechanism, p))
    start = top - turn * nint(top / turn)
    return DeadCentres(
        start,
        start + (bottom - top) % turn,
        height(mechanism, top),
        height(mechanism, bottom),
    )


def _lined_up(
    lam: Any, eps: Any, root: Callable[[Any], Any], arcsine: Callable[[Any], Any], half_turn: Any
) -> DeadCentres:
    return DeadCentres(
        arcsine(eps / (lam + 1)),
        half_turn + arcsine(eps / (lam - 1)),
        root((lam + 1) ** 2 - eps**2),
        root((lam - 1) ** 2 - eps**2),
    )


def _turning_points(mechanism: Mechanism, digits: int) -> list[Real]:
    """Return the roots of y' in one turn, between crank angles where its sign differs."""

    def slope(p: Real) -> Real:
        return height_motion(mechanism, p).first

    angles = [FIRST_SAMPLE + 2 * pi(digits + GUARD) * i / SAMPLES for i in range(SAMPLES + 1)]
    slopes = [slope(p) for p in angles[:-1]]
    roots = []
    for (start, before), (end, after) in pairwise(zip(angles, [*slopes, slopes[0]], strict=True)):
        if before == 0:
            roots.append(start)
        elif before * after < 0:
            roots.append(_root(slope, start, end, before, after).rounded(digits))
    return roots


def _root(slope: Callable[[Real], Real], start: Real, end: Real, before: Real, after: Real) -> Real:
    """Return the root between two angles with slopes of different sign, to all digits but `GUARD`.

    Secants, kept on both sides of the root by scaling down the slope that stays (Anderson and Bjorck,
    A new high order method of regula falsi type, BIT 13, 1973).
    """
    least = Fraction(1, 10 ** (end.digits - GUARD + 2))
    while True:
        place = end - after * (end - start) / (after - before)
        value = slope(place)
        if value == 0 or abs(place - end) < least:
            return place
        if value * after < 0:
            start, before = end, after
        else:
            share = 1 - value / after
            before *= share if share > 0 else Fraction(1, 2)
        end, after = place, value
