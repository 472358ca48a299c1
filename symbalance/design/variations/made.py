"""What turns in an engine within tolerances: counterweights, shafts, rotating masses, as they are made.

They have no errors here: a counterweight that was made for a nominal mass stays as it is when a piston is
heavier, and stands where it stands when a pin is out of place. In every order they add the same to c_n
and c_-n, whatever the cylinders' errors are.
"""

from __future__ import annotations

import cmath
from dataclasses import dataclass

from symbalance.design.variations.sectors import Sector
from symbalance.engine.engine import Engine
from symbalance.engine.rotating_masses import unit_of_share
from symbalance.exact.phasor import ZERO
from symbalance.exact.spectrum import Spectrum
from symbalance.forces.force_sums import turning_vectors


@dataclass(frozen=True)
class Made:
    """c_n and c_-n of what turns, in m r omega^2 of cylinder 1 (times a)."""

    ahead: complex = 0j
    against: complex = 0j

    def __bool__(self) -> bool:
        return bool(self.ahead or self.against)

    def seen_from(self, direction: float) -> list[Sector]:
        """Return what it adds to the component in a direction, as C + iS would turn: one point."""
        turned = self.ahead * cmath.rect(1, -direction)
        return _point(turned + self.against.conjugate() * cmath.rect(1, direction))

    def turning(self, sign: int) -> list[Sector]:
        """Return what it adds to c_n (sign 1) or c_-n (sign -1)."""
        return _point(self.ahead if sign > 0 else self.against)


def _point(number: complex) -> list[Sector]:
    return [Sector(abs(number), abs(number), cmath.phase(number))] if number else []


def made_parts(layout: Engine, order: int, reference: object = None) -> dict[int, dict[str, Made]]:
    """Return n -> what turns adds to the "force" and to the "couple", for the orders it has.

    >>> from symbalance.engine.balance_masses import Counterweight
    >>> from symbalance.engine.builders import inline
    >>> single = inline("1", ratio=4).balanced_by(Counterweight(throw=1, overbalance="1/2"))
    >>> made_parts(single, 4)[1]["force"].ahead
    (-0.5+0j)
    """
    force, couple = turning_vectors(layout, order, layout.plane(reference))
    orders = sorted({*force.orders(), *couple.orders()})
    return {n: {"force": _part(layout, force, n), "couple": _part(layout, couple, n)} for n in orders}


def _part(layout: Engine, spectrum: Spectrum, n: int) -> Made:
    factor = float(unit_of_share(layout, n)) if layout.counts_in_orders else 1.0
    ahead, against = (complex(spectrum.terms.get(s, ZERO).evaluated()) for s in (n, -n))
    return Made(ahead * factor, against * factor)


NOTHING = {"force": Made(), "couple": Made()}
"""What turns where nothing does."""
