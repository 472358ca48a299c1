"""Counterweights, balance shafts and rotating masses, which tolerances of cylinders leave as built.

They have no errors here: a counterweight that was built for a nominal mass stays the same when a piston
is heavier, and stands where it stands when a pin is out of place. In every order they add the same to
c_n and c_-n, whatever the cylinders' errors are.
"""

from __future__ import annotations

import cmath
from dataclasses import dataclass

from symbalance.design.variations.annular_sectors import AnnularSector
from symbalance.engine.engine import Engine
from symbalance.engine.rotating_masses import unit_of_share
from symbalance.exact.phasor import ZERO
from symbalance.exact.spectrum import Spectrum
from symbalance.forces.force_sums import turning_vectors


@dataclass(frozen=True)
class AsBuilt:
    """c_n and c_-n of what turns, in m r omega^2 of cylinder 1 (times a)."""

    forward: complex = 0j
    backward: complex = 0j

    def __bool__(self) -> bool:
        return bool(self.forward or self.backward)

    def component_sectors(self, direction: float) -> list[AnnularSector]:
        """Return what it adds to the component in a direction, as C + iS would turn: one point."""
        forward = self.forward * cmath.rect(1, -direction)
        return _point(forward + self.backward.conjugate() * cmath.rect(1, direction))

    def rotating_sectors(self, sign: int) -> list[AnnularSector]:
        """Return what it adds to c_n (sign 1) or c_-n (sign -1)."""
        return _point(self.forward if sign > 0 else self.backward)


def _point(number: complex) -> list[AnnularSector]:
    return [AnnularSector(abs(number), abs(number), cmath.phase(number))] if number else []


def as_built_parts(engine: Engine, order: int, reference: object = None) -> dict[int, dict[str, AsBuilt]]:
    """Return n -> what turns adds to the "force" and to the "couple", for the orders it has.

    >>> from symbalance.engine.balance_masses import Counterweight
    >>> from symbalance.engine.builders import inline
    >>> single = inline("1", ratio=4).balanced_by(Counterweight(throw=1, overbalance="1/2"))
    >>> as_built_parts(single, 4)[1]["force"].forward
    (-0.5+0j)
    """
    force, couple = turning_vectors(engine, order, engine.plane(reference))
    orders = sorted({*force.orders(), *couple.orders()})
    return {n: {"force": _part(engine, force, n), "couple": _part(engine, couple, n)} for n in orders}


def _part(engine: Engine, spectrum: Spectrum, n: int) -> AsBuilt:
    factor = float(unit_of_share(engine, n)) if engine.counts_in_orders else 1.0
    forward, backward = (complex(spectrum.terms.get(s, ZERO).evaluated()) for s in (n, -n))
    return AsBuilt(forward * factor, backward * factor)


NOTHING = {"force": AsBuilt(), "couple": AsBuilt()}
"""What turns where nothing does."""
