"""The crank angles at which pistons stand at top dead centre, where an offset or a link rod shifts them.

A centred cylinder is at top dead centre at p = theta + throw - bank = 0. An offset axis or a link rod
shifts that to the p at which the piston stands highest (`dead_centre_shift`): sin p = eps/(lambda + 1)
of an offset slider-crank (`symbalance.kinematics.mechanisms.dead_centres`). A maker who wants even firing
turns the pin on by as much, rounded to what he can machine; the intervals here show what rounding leaves.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import lru_cache

from symbalance.engine.cylinders import Cylinder
from symbalance.engine.engine import Engine
from symbalance.errors import SymbalanceError, brief
from symbalance.kinematics.mechanisms import Mechanism, SliderCrank, dead_centres
from symbalance.text.numbers import exact
from symbalance.text.reals import pi

FINEST = Fraction(1, 1_000_000)
"""Moved dead centres are irrational: they are given to a millionth of a degree."""
COARSEST, FINEST_STEP = 10, 10**12


# A document, a drawing and a page ask for the same link rods' roots, some milliseconds each.
@lru_cache(maxsize=256)
def dead_centre_shift(mechanism: Mechanism) -> Fraction:
    """Return p at the piston's top dead centre, degrees in (-180, 180], to a millionth of a degree.

    >>> float(dead_centre_shift(SliderCrank(4, "1/2")))
    5.73917
    >>> dead_centre_shift(SliderCrank(4))
    Fraction(0, 1)
    """
    if isinstance(mechanism, SliderCrank) and not mechanism.offset:
        return Fraction(0)
    degrees = dead_centres(mechanism, 30).top * 180 / pi(30)
    return round(degrees / FINEST) * FINEST


def has_shifted_dead_centres(engine: Engine) -> bool:
    """Tell whether some top dead centre is not where the pin passes the cylinder's axis."""
    return any(c.link or c.offset for c in engine.cylinders)


def dead_centre_shift_of(cylinder: Cylinder) -> Fraction:
    """Return a cylinder's `dead_centre_shift`; 0 for a centred one, whose sizes need not be known."""
    return dead_centre_shift(cylinder.mechanism) if cylinder.mechanism else Fraction(0)


def dead_centre_angles(engine: Engine) -> dict[int, Fraction]:
    """Return the degrees of theta at a top dead centre of each cylinder, less the first-numbered one's.

    >>> from symbalance.engine.builders import radial
    >>> [str(top) for top in dead_centre_angles(radial(3)).values()]
    ['0', '120', '-120']
    """
    tops = {}
    for mechanism, cylinders in engine.grouped(lambda c: c.mechanism).items():
        ahead = dead_centre_shift(mechanism) if mechanism else Fraction(0)
        tops |= {c.number: ahead - c.delay.in_degrees() for c in cylinders}
    return {c.number: tops[c.number] - tops[min(tops)] for c in engine.cylinders}


def firing_dead_centres(engine: Engine) -> dict[int, Fraction]:
    """Return how far after cylinder 1's each cylinder's firing dead centre stands, degrees of theta.

    `fires` of every cylinder says which of its top dead centres that is; the angle itself follows
    from throw, bank and mechanism. Refused where a cylinder has no `fires`.

    >>> from symbalance.engine.builders import vr
    >>> six = vr(15, "1-5-3-6-2-4", stroke=90, rod=164, offset=12.5, pin_step="1/2")
    >>> [float(round(top, 3)) for top in firing_dead_centres(six).values()]
    [0.0, 240.0, 120.0, 479.858, 599.858, 359.858]
    """
    tops, cycle = dead_centre_angles(engine), 180 * engine.strokes
    fires = {c.number: c.fires for c in engine.cylinders if c.fires is not None}
    if len(fires) < len(tops):
        what = f"cylinder {next(n for n in tops if n not in fires)} of {engine.name}"
        raise SymbalanceError(what, "has no firing angle", "give fires")
    firing_angles = {number: fires[number] - fires[min(tops)] for number in tops}
    return {n: (top + 360 * round((firing_angles[n] - top) / 360)) % cycle for n, top in tops.items()}


def bank_shifts(engine: Engine, banks: Sequence[Sequence[int]], step: object) -> list[Fraction]:
    """Return each bank's dead centre shift, the same for all its cylinders, rounded to `step` degrees."""
    size = checked_step(step)
    by_number = {c.number: c for c in engine.cylinders}
    return [round(dead_centre_shift_of(by_number[bank[0]]) / size) * size for bank in banks]


def checked_step(step: object) -> Fraction:
    """Return the fraction of a degree that pins are rounded to, or refuse."""
    number = exact(step, "pin_step", FINEST_STEP)
    if not 0 < number <= COARSEST:
        remedy = 'write it like "1/2" or 0.01'
        raise SymbalanceError(f"pin_step = {brief(step)}", f"must lie in (0, {COARSEST}] degrees", remedy)
    return number
