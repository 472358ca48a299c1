"""A sensitivity: the derivative of one order by one size of one cylinder; and the list of them all."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from math import pi
from typing import TYPE_CHECKING, Any, ClassVar, overload

from symbalance.design.variations.legend import as_decimal
from symbalance.design.variations.speeds import speed_scale
from symbalance.document.result import Result
from symbalance.engine.engine import Engine
from symbalance.exact.amplitude import Amplitude
from symbalance.exact.spectrum import COMPONENTS, Spectrum
from symbalance.forces.free_forces import Resultant
from symbalance.forces.rows import plane_key
from symbalance.text.numbers import decimal_text
from symbalance.text.reals import Real

if TYPE_CHECKING:
    from symbalance.document.nodes import Document

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
UNITS = {
    "mass": "m of cylinder {first}",
    "rotating": "m of cylinder {first}",
    "throw": "radian",
    "bank": "radian",
    "station": "pitch",
    "stroke": "r of cylinder {first}, of the crank radius",
    "rod": "r of cylinder {first}",
    "offset": "r of cylinder {first}",
}
"""What derivatives are per."""
DIGITS = 20
"""Of the kinematics, in JSON."""


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
        forward, backward = (part.scaled(weight) for part in pair or self.geometry)
        return Resultant(Spectrum.of({self.order: forward, -self.order: backward}), self.order)

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
        return self._with_factor(self.geometry)

    def pair(self, quantity: str) -> tuple[complex, complex]:
        """Return the change of c_n and c_-n of the "force" or the "couple" for one unit."""
        if self.couples is not None and quantity == "couple":
            return self._with_factor(self.couples)
        weight = self.weight(quantity)
        return self.values[0] * weight, self.values[1] * weight

    def _with_factor(self, pair: tuple[Amplitude, Amplitude]) -> tuple[complex, complex]:
        forward, backward = (complex(part.evaluated()) * float(self.factor) for part in pair)
        return forward, backward

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


@dataclass(frozen=True, repr=False)
class Sensitivities(Result, Sequence[Sensitivity]):
    """All derivatives of orders by each cylinder's sizes, largest effect of a step first: a sequence.

    An effect is the force, or where it is larger the couple over one pitch: the pair of forces, a pitch
    apart, that makes it. So it is the same sequence at every speed. Forces are in m r omega^2 of cylinder
    1, couples in m r omega^2 a about `reference`, None for the mean of all stations. `parameters` are the
    sizes they are by.
    """

    engine: Engine
    order: int
    parameters: tuple[str, ...]
    reference: Fraction | None
    changes: tuple[Sensitivity, ...]
    rpm: Fraction | None = None
    """The speed at which steps are given in N and N m too; None where none is asked for."""

    kind: ClassVar[str] = "sensitivities"

    @overload
    def __getitem__(self, index: int) -> Sensitivity: ...
    @overload
    def __getitem__(self, index: slice) -> tuple[Sensitivity, ...]: ...
    def __getitem__(self, index: int | slice) -> Sensitivity | tuple[Sensitivity, ...]:
        return self.changes[index]

    def __len__(self) -> int:
        return len(self.changes)

    def __iter__(self) -> Iterator[Sensitivity]:
        return iter(self.changes)

    def summary(self) -> str:
        """Return how many there are and the worst step, in one line."""
        head = f"Sensitivities of {self.engine.name} to order {self.order}: {len(self)} derivatives"
        if not self:
            return head
        worst = self[0]
        step = f"{STEPS[worst.parameter][1]}, {worst.parameter} of cylinder {worst.cylinder}"
        return f"{head}, the worst step {step}, in order {worst.order}"

    def at_speed(self, change: Sensitivity) -> tuple[float, float]:
        """Return the largest force and couple of a change's step, N and N m at the speed."""
        scale = speed_scale(self.engine, self.rpm)
        force, couple = change.step()
        return force * scale.force, couple * scale.couple

    def document(self) -> Document:
        """Return what one step in each size adds, worst first, then how it is meant."""
        from symbalance.design.variations.sensitivities_document import sensitivities_document

        return sensitivities_document(self)

    def data(self) -> dict[str, Any]:
        """Return every derivative: its geometry exact, its factor to 20 digits, and per what."""
        return {
            "engine": self.engine.name,
            "ratio": None if self.engine.ratio is None else str(self.engine.ratio),
            "highest": str(self.order),
            "reference_plane": plane_key(self.reference),
            "parameters": list(self.parameters),
            "units": {"force": "m r omega^2", "couple": "m r omega^2 a"},
            **({} if self.rpm is None else {"rpm": as_decimal(self.rpm)}),
            "sensitivities": [self._one(change) for change in self],
        }

    def _one(self, change: Sensitivity) -> dict[str, Any]:
        force, couple = change.largest
        return {
            "order": str(change.order),
            "parameter": change.parameter,
            "per": self.unit(change),
            "cylinder": change.cylinder,
            "factor": decimal_text(change.factor, DIGITS),
            "force": _components(change.force),
            "couple": _components(change.couple),
            "largest": {"force": force, "couple": couple},
            **({} if self.rpm is None else {"step": self._step(change)}),
        }

    def _step(self, change: Sensitivity) -> dict[str, Any]:
        force, couple = self.at_speed(change)
        units = speed_scale(self.engine, self.rpm).units
        words = STEPS[change.parameter][1]
        return {"of": words, "force": force, "couple": couple, "units": list(units)}

    def unit(self, change: Sensitivity) -> str:
        """Return what one of the derivatives is per."""
        return UNITS[change.parameter].format(first=self.engine.first.number)

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each derivative: the largest moduli for one unit and for the step of tables.

        Forces are in m r omega^2, couples in m r omega^2 a; those of a step at the speed, where one was
        asked for, in N and N m.
        """
        return [
            {
                "order": change.order,
                "parameter": change.parameter,
                "cylinder": change.cylinder,
                "per": self.unit(change),
                "force": change.largest[0],
                "couple": change.largest[1],
                "step": STEPS[change.parameter][1],
                "force_of_step": self.at_speed(change)[0],
                "couple_of_step": self.at_speed(change)[1],
            }
            for change in self
        ]


def _components(resultant: Resultant) -> dict[str, dict[str, str]]:
    parts = ((name, resultant.component(name)) for name in COMPONENTS)
    return {name: {"cos": str(part.cos), "sin": str(part.sin)} for name, part in parts}
