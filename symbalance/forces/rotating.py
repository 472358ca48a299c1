"""What turns, as a spectrum: what counterweights, shafts and rotating masses add to force and couple."""

from __future__ import annotations

from fractions import Fraction

from symbalance.engine.engine import Engine
from symbalance.engine.rotors import counts_in_orders, rotors
from symbalance.exact.arithmetic import added, decimal
from symbalance.exact.decimal_phasor import DecimalPhasor
from symbalance.exact.spectrum import Number, Spectrum
from symbalance.forces.cylinder_sums import link_pin_spectrum


def rotor_spectrum(layout: Engine, highest: int, plane: Fraction | None) -> Spectrum:
    """Return what the rotors add to the force, or to the couple about `plane`, up to an order.

    >>> from symbalance.engine.balancers import Counterweight
    >>> from symbalance.engine.builders import inline
    >>> single = inline("1").balanced_by(Counterweight(throw=1, overbalance="1/2"))
    >>> rotor_spectrum(single, 12, None).component(1, "vertical").cos
    -1/2
    """
    total: dict[int, Number] = {}
    for rotor in rotors(layout):
        if abs(rotor.speed) <= highest:
            arm = Fraction(1) if plane is None else rotor.station - plane
            part = rotor.vector.scaled(arm)
            total[rotor.speed] = added(total[rotor.speed], part) if rotor.speed in total else part
    return Spectrum.of(total)


def turning_spectrum(layout: Engine, highest: int, plane: Fraction | None) -> Spectrum:
    """Return what rotors and masses on link pins add to the force, or to the couple about `plane`."""
    weights = [Fraction(1)] * len(layout.cylinders) if plane is None else layout.arms(plane)
    return with_rotors(layout, link_pin_spectrum(layout, highest, weights), highest, plane)


def with_rotors(layout: Engine, vector: Spectrum, highest: int, plane: Fraction | None) -> Spectrum:
    """Return a force, or a couple about `plane`, with that of the rotors added to it."""
    if not layout.balancers:
        return vector
    total = dict(vector.terms)
    for n, number in rotor_spectrum(layout, highest, plane).terms.items():
        total[n] = added(total[n], number) if n in total else number
    if not counts_in_orders(layout):
        total = {n: _decimal(number) for n, number in total.items()}
    return Spectrum.of(total)


def _decimal(number: Number) -> DecimalPhasor:
    return number if isinstance(number, DecimalPhasor) else DecimalPhasor(decimal(number))
