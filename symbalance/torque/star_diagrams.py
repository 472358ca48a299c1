"""Star diagrams: the exact sum of one unit vector for each cylinder, at every order, halves included.

A cylinder that does the same as cylinder 1, but at theta_j, has its order n at the angle n theta_j: drawn
from one point these vectors are the star of that order, and their sum is all that the engine does to it.
In a four-stroke the cycle is 720 degrees, so that n = 1/2, 1, 3/2, .... Whether a star closes (sum zero)
is decided exactly.

The half order and the first one of a four that fires every half turn, and the first of a three:

Formulas:
    1 + z + z^2 + z^3 = 0
    1 + y + y^2 + y^3 = 0
    1 + w + w^2 = 0
    with z = e^(i pi/2); y = e^(i pi); w = e^(4 i pi/3)
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import lcm
from typing import TYPE_CHECKING, Any, ClassVar

from symbalance.document.result import SequenceResult
from symbalance.engine.cylinders import Cylinder
from symbalance.engine.engine import Engine, checked_engine
from symbalance.errors import SymbalanceError
from symbalance.exact.amplitude import Amplitude
from symbalance.exact.angles import Angle
from symbalance.exact.phasor import Phasor, checked_modulus
from symbalance.exact.spectrum import Component
from symbalance.exact.symbolic_phasor import SymbolicPhasor
from symbalance.forces.free_forces import listed_orders
from symbalance.kinematics.slider_crank import checked_order

if TYPE_CHECKING:
    from symbalance.document.nodes import Document


@dataclass(frozen=True)
class Star:
    """The star of one order: each cylinder's number with its vector's angle in turns, and their sum.

    `resultant` is C + iS = sum of e^(i order theta_j): what cos(order theta) of one cylinder becomes.
    """

    order: Fraction
    vectors: tuple[tuple[int, Fraction], ...]
    resultant: Component

    def is_closed(self) -> bool:
        """Tell whether the vectors cancel: a proof either way."""
        return self.resultant.is_zero()


@dataclass(frozen=True, repr=False, eq=False)
class FiringStars(SequenceResult[Star]):
    """The stars of all orders of an engine's gas torque, up to `highest`: a sequence of `Star`."""

    engine: Engine
    highest: int
    items: tuple[Star, ...]

    kind: ClassVar[str] = "firing-stars"

    @property
    def open(self) -> tuple[Star, ...]:
        """The stars whose vectors do not cancel: the orders that the gas torque has."""
        return tuple(star for star in self.items if not star.is_closed())

    def summary(self) -> str:
        """Return which orders are left, in one line."""
        orders = [star.order for star in self.open]
        words = f"open in order {listed_orders(orders)}" if orders else "all closed"
        return f"Firing stars of {self.engine.name} to order {self.highest}: {words}"

    def document(self) -> Document:
        """Return the sums of the stars that are open, then every star's vectors."""
        from symbalance.torque.gas_document import stars_document

        return stars_document(self)

    def data(self) -> dict[str, Any]:
        """Return every star: its vectors' angles in turns and their sum, exact numbers as strings."""
        from symbalance.torque.torque_data import stars_data

        return stars_data(self)

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each vector; keys: order, cylinder, degrees, and closed, of its star."""
        return [
            {
                "order": float(star.order),
                "cylinder": number,
                "degrees": float(360 * turns),
                "closed": star.is_closed(),
            }
            for star in self.items
            for number, turns in star.vectors
        ]


def firing_pin_passings(engine: Engine) -> dict[int, Fraction]:
    """Return the crank angle of a cycle, degrees, at which each pin lies on its cylinder's axis to fire.

    Cylinder 1 of an engine built from its firing order fires at 0; where no cylinder stands at its firing
    at theta = 0, the one with fires = 0 does within the first turn. In a two-stroke every top dead
    centre fires; in a four-stroke the cylinders' `fires` say which. A cylinder whose dead centre an
    offset or a link rod moves stands there later, by what its dead centre is shifted.

    >>> from symbalance.engine.builders import inline
    >>> {n: str(top) for n, top in firing_pin_passings(inline("1-3-4-2")).items()}
    {1: '0', 2: '540', 3: '180', 4: '360'}
    """
    cycle = 180 * checked_engine(engine).strokes
    first = next((c for c in engine.cylinders if c.fires is not None), None)
    start = Fraction(0) if first is None else _top(first) - (first.fires or 0)
    start %= 360
    firing_angles = {}
    for cylinder in engine.cylinders:
        if engine.strokes == 2:
            firing_angles[cylinder.number] = _top(cylinder) % cycle
        elif cylinder.fires is None:
            rule = "has no firing angle, and every other top dead centre of a four-stroke fires"
            remedy = "build it from a firing order, or give each cylinder fires"
            raise SymbalanceError(f"cylinder {cylinder.number} of {engine.name}", rule, remedy)
        else:
            top = _top(cylinder)
            turns = round((start + cylinder.fires - top) / 360)
            firing_angles[cylinder.number] = (top + 360 * turns) % cycle
    return firing_angles


def _top(cylinder: Cylinder) -> Fraction:
    """Return a crank angle at which the cylinder stands at top dead centre, in degrees."""
    return -_checked_delay(cylinder).delay.in_degrees()


def _checked_delay(cylinder: Cylinder) -> Cylinder:
    if cylinder.delay.symbols:
        rule = "its top dead centre depends on a symbol"
        raise SymbalanceError(f"cylinder {cylinder.number}", rule, "gas torque needs numbers")
    return cylinder


def firing_stars(engine: Engine, order: int = 6) -> FiringStars:
    """Return the stars of all orders of the gas torque to `order`: halves in a four-stroke.

    Vectors stand where the pins pass the cylinders' axes: like cylinders are moved from there alike.

    >>> from symbalance.engine.builders import inline
    >>> [str(s.order) for s in firing_stars(inline("1-5-3-6-2-4"), 9) if not s.is_closed()]
    ['3', '6', '9']
    """
    stars = stars_of(firing_pin_passings(engine), engine.strokes, order)
    return FiringStars(engine, order, stars)


def stars_of(firing_angles: Mapping[int, Fraction], strokes: int, order: int) -> tuple[Star, ...]:
    """Return the stars of some cylinders' firing top dead centres, in degrees."""
    checked_order(order)
    cycle = 180 * strokes
    parts = {number: top / cycle for number, top in firing_angles.items()}
    modulus = checked_modulus(lcm(*(part.denominator for part in parts.values())))
    sums: dict[int, Component] = {}
    stars = []
    for k in range(1, order * strokes // 2 + 1):
        vectors = tuple((number, part * k % 1) for number, part in parts.items())
        if k % modulus not in sums:
            sums[k % modulus] = Component(unit_vector_sum([Angle(turns) for _, turns in vectors]))
        stars.append(Star(Fraction(2 * k, strokes), vectors, sums[k % modulus]))
    return tuple(stars)


def unit_vector_sum(angles: Sequence[Angle]) -> Amplitude:
    """Return the sum of e^(i angle), exactly."""
    if any(a.symbols for a in angles):
        total = SymbolicPhasor({})
        for a in angles:
            total = total + SymbolicPhasor.of({a.symbols: Phasor.root(a.turns)})
        return total
    modulus = checked_modulus(lcm(*(a.turns.denominator for a in angles)))
    terms: dict[int, int] = {}
    for a in angles:
        place = a.turns.numerator * (modulus // a.turns.denominator) % modulus
        terms[place] = terms.get(place, 0) + 1
    return Phasor.of(modulus, terms)
