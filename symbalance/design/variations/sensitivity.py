"""One derivative of one order: exact geometry, one number of kinematics, the worth of a step."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from math import pi

from symbalance.exact.amplitude import Amplitude
from symbalance.exact.spectrum import Spectrum
from symbalance.forces.resultants import Resultant
from symbalance.text.reals import Real

STEPS = {
    "mass": (Fraction(1, 100), "1 % of m"),
    "rotating": (Fraction(1, 100), "1 % of m"),
    "throw": (None, "1 degree"),
    "bank": (None, "1 degree"),
    "station": (Fraction(1, 100), "1 % of a"),
    "stroke": (Fraction(1, 100), "1 % of the stroke"),
    "rod": (Fraction(1, 100), "1 % of r"),
    "offset": (Fraction(1, 100), "1 % of r"),
}
"""The step that tables compare parameters by; None is a degree."""


@dataclass(frozen=True)
class Sensitivity:
    """The derivative of one order of the force and couple by one size of one cylinder.

    `geometry` is exact (but for link rods), `factor` the kinematics that it is multiplied by: real, in m
    r omega^2 of cylinder 1 (times a for the couple) a unit of change, as in `sensitivities`.
    The couple is `arm` times the force, for a station the force's own direction, or `couples`.
    """

    parameter: str
    cylinder: int
    order: int
    geometry: tuple[Amplitude, Amplitude]
    factor: Real
    arm: Fraction
    couples: tuple[Amplitude, Amplitude] | None = None
    """The couple's own geometry, of sizes that move several cylinders, each at its station."""

    @cached_property
    def force(self) -> Resultant:
        """The change of the force, its geometry alone; zero for a station."""
        return self._resultant(Fraction(self.parameter != "station"))

    @cached_property
    def couple(self) -> Resultant:
        """The change of the couple, its geometry alone."""
        if self.couples is not None:
            return self._resultant(Fraction(1), self.couples)
        return self._resultant(Fraction(1) if self.parameter == "station" else self.arm)

    def _resultant(self, weight: Fraction, pair: tuple[Amplitude, Amplitude] | None = None) -> Resultant:
        ahead, against = (part.scaled(weight) for part in pair or self.geometry)
        return Resultant(Spectrum.of({self.order: ahead, -self.order: against}), self.order)

    @cached_property
    def largest(self) -> tuple[float, float]:
        """The largest moduli of the force's and the couple's change over a turn, for one unit."""
        size = sum(part.most for part in self.geometry) * abs(float(self.factor))
        if self.couples is not None:
            return size, sum(part.most for part in self.couples) * abs(float(self.factor))
        if self.parameter == "station":
            return 0.0, size
        return size, size * abs(float(self.arm))

    @cached_property
    def values(self) -> tuple[complex, complex]:
        """The change of c_n and c_-n for one unit, kinematics in it; of the couple where a station's."""
        return self._valued(self.geometry)

    def pair(self, quantity: str) -> tuple[complex, complex]:
        """Return the change of c_n and c_-n of the "force" or the "couple" for one unit."""
        if self.couples is not None and quantity == "couple":
            return self._valued(self.couples)
        weight = self.weight(quantity)
        return self.values[0] * weight, self.values[1] * weight

    def _valued(self, pair: tuple[Amplitude, Amplitude]) -> tuple[complex, complex]:
        ahead, against = (complex(part.evaluated()) * float(self.factor) for part in pair)
        return ahead, against

    def weight(self, quantity: str) -> float:
        """Return what `values` count in the "force" or, but for `couples`, in the "couple"."""
        if self.parameter == "station":
            return float(quantity == "couple")
        return float(self.arm) if quantity == "couple" else 1.0

    def step(self) -> tuple[float, float]:
        """Return `largest` for the step of `STEPS` in place of one unit."""
        step = STEPS[self.parameter][0]
        by = pi / 180 if step is None else float(step)
        return self.largest[0] * by, self.largest[1] * by
