"""Roll moment of balance shafts that run beside or above the crank.

A force (vertical v, lateral l) at a point x to the right of the crank's axis and y above it has the
moment y l - x v about it, positive in the sense of rotation. With p = y + i x that is
Im(conj(p) u e^(i n theta)) for a vector u at n times the crank's speed: exact harmonics of order |n|. Two
shafts at +-2 that take 2 F_2 each of an in-line four, the one that turns with the crank h above the
other, have the moment -2 (h/r) A_2 sin 2 theta in m r^2 omega^2; the pistons leave -4 t_2 sin 2 theta.
With t_2 = -1/2 and A_2 = r/l to leading order, h = l, one rod length, ends force and roll moment at once;
Gas torque asks for another height, so one that is built is a compromise: derivations/balancing.md.

Formulas:
    (P - Q)/(2 i) = y l - x v
    with P = (y - i x) (v + i l); Q = (y + i x) (v - i l); x, y, v, l numbers
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from symbalance.engine.engine import Engine
from symbalance.engine.rotating_masses import unit_of_share
from symbalance.errors import SymbalanceError
from symbalance.exact.amplitude import Amplitude
from symbalance.exact.phasor import ZERO
from symbalance.exact.spectrum import Component
from symbalance.text.reals import DIGITS, Real


def shaft_moment(engine: Engine) -> dict[int, Component]:
    """Return the roll moment of an engine's balance shafts by order, C + iS each, in units F_n r.

    F_n = A_n m r omega^2 (m r omega^2 where that is the unit of the balance); positive in the sense of
    rotation, on the frame. Refused without a stroke, as x and y are in mm. A vector W e^(i n theta) at
    height h and one W e^(-i n theta) at -h have the moment

    Formulas:
        h W (e^(i n theta) - e^(-i n theta))/(2 i) + (-h) W (e^(-i n theta) - e^(i n theta))/(2 i)
        = 2 h W sin n theta
        with h, W numbers; n a whole number

    >>> from symbalance.engine.balance_masses import BalanceShaft, Weight
    >>> from symbalance.engine.builders import inline
    >>> from symbalance.engine.crank_train import CrankTrain
    >>> four = inline("1-3-4-2", crank_train=CrankTrain(stroke=Fraction(80), rod=Fraction(140)))
    >>> pair = [BalanceShaft(s, [Weight(share=2, phase=180)], y=y) for s, y in ((2, 70), (-2, -70))]
    >>> shaft_moment(four.balanced_by(*pair))[2].sin  # -2 * 140/40
    -7
    """
    total: dict[int, Amplitude] = {}
    for rotor in engine.rotating_masses if has_shafts_aside(engine) else ():
        if not (rotor.x or rotor.y):
            continue
        radius = engine.first.radius
        if radius is None:
            rule, remedy = "needs the stroke to be a moment", "give stroke = ... in [crank_train], mm"
            raise SymbalanceError("x, y of a shaft", rule, remedy)
        above, right = rotor.y / radius, rotor.x / radius
        moment, n = rotor.vector.scaled(above), abs(rotor.speed)
        quarter = Fraction(1, 4)
        if right:
            moment += rotor.vector.rotated(-quarter).scaled(right)
        part = moment.conjugate().rotated(quarter) if rotor.speed > 0 else moment.rotated(-quarter)
        total[n] = total.get(n, ZERO) + part
    return {n: Component(c) for n, c in sorted(total.items()) if not c.is_zero()}


def has_shafts_aside(engine: Engine) -> bool:
    """Tell whether some balance shaft's axis is not the crank's own."""
    return any(shaft.x or shaft.y for shaft in engine.balancers.shafts)


def shaft_terms(engine: Engine, order: int) -> Iterator[tuple[int, Real, Real]]:
    """Yield (n, C, S) of the shafts' roll moment up to an order, in m r^2 omega^2 of cylinder 1."""
    for n, part in shaft_moment(engine).items():
        if n <= order:
            cos, sin = part.decimal(DIGITS)
            unit = unit_of_share(engine, n) if engine.counts_in_orders else 1
            yield n, cos * unit, sin * unit
