r"""Weights in given planes that have a given force and couple: balancing in one, two or more planes.

Weights w_i at arms z_i (station minus reference plane) on one shaft have the force sum of w_i and the
couple sum of z_i w_i, all of them vectors that turn with it. So

    one plane     does if couple = z force with z real, and only then;
    two planes    always do:  w_1 = (couple - z_2 force)/(z_1 - z_2),  w_2 = force - w_1;
    more planes   leave a choice: w_i = p + q z_i has the least sum of squares, with p and q from
                  N p + (sum of z) q = force,  (sum of z) p + (sum of z^2) q = couple.

The least total unbalance, sum of |w_i|, is always had with the two outermost planes. For it is the
maximum over vectors p, q of Re(conj(force) p + conj(couple) q) with |p + q z_i| <= 1 for all i; the
square of |p + q z| is convex in z, so where q is not 0 the bound is met at the ends alone, and a weight
stands only where it is met. (Where q = 0 all weights point one way, and the ends do as well as any.)
Fractions times vectors of the exact fields stay in the fields: nothing is rounded.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from symbalance.errors import SymbalanceError
from symbalance.exact.amplitude import Amplitude
from symbalance.exact.arithmetic import station_of

PlacedVector = tuple[Fraction, Amplitude]
"""A lever arm, and the vector that turns there."""
SPREADS = ("ends", "even")


def in_planes(
    force: Amplitude,
    couple: Amplitude,
    arms: Sequence[Fraction],
    *,
    spread: str = "ends",
    length: Fraction,
) -> list[PlacedVector]:
    """Return weight vectors at some of `arms` that have a given force and couple, in their unit.

    `spread` "ends" takes as few planes as do, with the least total; "even" all planes, with the least sum
    of squares. With one plane only, both cannot be had unless it stands right: then what is missed is
    least in the sense of |force|^2 + |couple|^2/length^2.

    >>> from symbalance.exact.phasor import ONE, ZERO
    >>> pair = in_planes(ZERO, ONE, [Fraction(1), Fraction(-1)], length=Fraction(1))
    >>> [(str(z), w.rational()) for z, w in pair]
    [('1', Fraction(1, 2)), ('-1', Fraction(-1, 2))]
    """
    if spread not in SPREADS:
        rule = f"must be one of {', '.join(SPREADS)}"
        raise SymbalanceError(
            f"spread = {spread}", rule, "ends: few weights; even: a weight in every plane"
        )
    places = sorted(set(arms), reverse=True)
    if not places:
        raise SymbalanceError("stations = []", "leave no place for a weight", "give one or two")
    one = station_of(force, couple)
    if spread == "ends" and one is not None and one in places:
        return [(one, force)]
    if len(places) == 1:
        return [_nearest(force, couple, places[0], length)]
    return _ends(force, couple, places) if spread == "ends" else _even(force, couple, places)


def _ends(force: Amplitude, couple: Amplitude, places: Sequence[Fraction]) -> list[PlacedVector]:
    front, rear = places[0], places[-1]
    over = 1 / (front - rear)
    first = (couple - force.scaled(rear)).scaled(over)
    second = (force.scaled(front) - couple).scaled(over)
    return [(z, w) for z, w in ((front, first), (rear, second)) if not w.is_zero()]


def _even(force: Amplitude, couple: Amplitude, places: Sequence[Fraction]) -> list[PlacedVector]:
    count, total, squares = len(places), sum(places), sum(z * z for z in places)
    over = 1 / Fraction(count * squares - total * total)
    level = (force.scaled(squares) - couple.scaled(total)).scaled(over)
    slope = (couple.scaled(count) - force.scaled(total)).scaled(over)
    vectors = [(z, level + slope.scaled(z)) for z in places]
    return [(z, w) for z, w in vectors if not w.is_zero()]


def _nearest(force: Amplitude, couple: Amplitude, arm: Fraction, length: Fraction) -> PlacedVector:
    """Return the vector at one arm that misses force and couple least, in the sense of a length."""
    square = length * length
    return arm, (force + couple.scaled(arm / square)).scaled(1 / (1 + arm * arm / square))
