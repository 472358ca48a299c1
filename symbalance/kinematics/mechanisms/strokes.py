"""Where the piston turns round: the dead centres and the stroke of a mechanism.

At its dead centres an offset slider-crank's crank and rod lie in one line, stretched or folded:

    top     sin p =  eps/(lam + 1),            y = sqrt((lam + 1)^2 - eps^2),
    bottom  sin p = -eps/(lam - 1), cos p < 0, y = sqrt((lam - 1)^2 - eps^2).

With eps > 0 the way down takes more than half a turn, and the stroke exceeds 2 r. A link rod's dead
centres are roots of y', bracketed and found to the working precision.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

from mpmath import mp

from symbalance.kinematics.mechanisms.linkages import Mechanism, SliderCrank, plain
from symbalance.kinematics.mechanisms.motion import height, height_motion
from symbalance.text.numbers import Real

LOOKS = 96
"""At how many crank angles a link rod's piston is looked at to find where it turns round."""
FIRST_LOOK = -2
"""Any angle in rad; this one is far from the dead centres of common engines."""


@dataclass(frozen=True)
class DeadCentres:
    """The crank angles `top` and `bottom` in rad and the piston's heights there over r.

    `top` lies in (-pi, pi) and `bottom` follows it by less than a turn; numbers are SymPy's of
    `exact_dead_centres` and mpmath's of `dead_centres`.
    """

    top: Real
    bottom: Real
    highest: Real
    lowest: Real

    @property
    def stroke(self) -> Real:
        """The piston's way between the dead centres, over r; 2 without offset."""
        return self.highest - self.lowest

    @property
    def down(self) -> Real:
        """The crank angle in rad that the way down takes; pi without offset."""
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
    return _lined_up(lam, eps, sympy)


def dead_centres(mechanism: Mechanism) -> DeadCentres:
    """Return the dead centres as mpmath numbers at the working precision.

    Of several turning points of a link rod's piston the highest and the lowest count.

    >>> mp.nstr(dead_centres(SliderCrank(4, 1)).stroke, 12)
    '2.07055236082'
    """
    mechanism = plain(mechanism)
    if isinstance(mechanism, SliderCrank):
        lam, eps = (mp.mpf(x.numerator) / x.denominator for x in (mechanism.ratio, mechanism.offset))
        return _lined_up(lam, eps, mp)
    turns = _turning_points(mechanism)
    top = max(turns, key=lambda p: height(mechanism, p))
    bottom = min(turns, key=lambda p: height(mechanism, p))
    start = top - 2 * mp.pi * mp.nint(top / (2 * mp.pi))
    return DeadCentres(
        start,
        start + (bottom - top) % (2 * mp.pi),
        height(mechanism, top),
        height(mechanism, bottom),
    )


def _lined_up(lam: Real, eps: Real, library: Real) -> DeadCentres:
    sqrt, asin = library.sqrt, library.asin
    return DeadCentres(
        asin(eps / (lam + 1)),
        library.pi + asin(eps / (lam - 1)),
        sqrt((lam + 1) ** 2 - eps**2),
        sqrt((lam - 1) ** 2 - eps**2),
    )


def _turning_points(mechanism: Mechanism) -> list[Real]:
    """Return the roots of y' in one turn, between crank angles where its sign differs."""

    def slope(p: Real) -> Real:
        return height_motion(mechanism, p).first

    angles = [FIRST_LOOK + 2 * mp.pi * i / LOOKS for i in range(LOOKS + 1)]
    slopes = [slope(p) for p in angles[:-1]]
    found = []
    for (start, before), (end, after) in pairwise(zip(angles, [*slopes, slopes[0]], strict=True)):
        if before == 0:
            found.append(start)
        elif before * after < 0:
            found.append(mp.findroot(slope, (start, end), solver="anderson"))
    return found
