r"""Unbalance of rotating parts, its force and couple, and the counterweights that balance both.

A part of mass m at radius r and angle a has the unbalance m r e^(i a); a crank is in static balance where
their sum is 0, in dynamic balance where the sum of station * m r e^(i a) is 0 too. For one throw that is
the second equation of a founding document, sum of m_i r_i = m_4 r_4. For a crank two planes always do:
w_1 + w_2 = force and z_1 w_1 + z_2 w_2 = couple have one solution; `symbalance.design.balancing.planes`
shares the weights out over more.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import hypot
from typing import TYPE_CHECKING, Any, ClassVar

from symbalance.design.balancing.planes import in_planes
from symbalance.document.result import Result
from symbalance.engine.balance_masses import Counterweight, Weight
from symbalance.engine.engine import Engine
from symbalance.errors import SymbalanceError, brief
from symbalance.exact.amplitude import Amplitude
from symbalance.exact.angles import Angle
from symbalance.exact.arithmetic import total
from symbalance.exact.spectrum import Component
from symbalance.forces.balance_data import component_values
from symbalance.text.numbers import as_list, exact
from symbalance.text.reals import atan2, pi

if TYPE_CHECKING:
    from symbalance.document.nodes import Document


@dataclass(frozen=True, repr=False)
class RotatingBalance(Result):
    """Counterweights in given planes that balance rotating `weights`; a sequence of them.

    `stations` are the planes, `spread` how the counterweights share them. Couples are about station 0,
    in the weights' unit times pitches; where no force is left, they are the same about any station.

    >>> balanced_weights([Weight(1, 0, unbalance=6), Weight(0, 90, unbalance=3)], [3, -3])
    2 counterweights against 2 turning weights: no force and no couple left
    >>> balanced_weights([Weight(1, 0, unbalance=6), Weight(0, 90, unbalance=3)], [0])
    1 counterweight against 2 turning weights: no force and a couple left
    """

    weights: tuple[Weight, ...]
    stations: tuple[Fraction, ...]
    spread: str
    counterweights: tuple[Counterweight, ...]

    kind: ClassVar[str] = "rotating-balance"

    def __iter__(self) -> Iterator[Counterweight]:
        return iter(self.counterweights)

    def __len__(self) -> int:
        return len(self.counterweights)

    def __getitem__(self, index: int) -> Counterweight:
        return self.counterweights[index]

    @property
    def in_kg_mm(self) -> bool:
        """Whether weights are in kg mm, else shares of the first cylinder's m r."""
        return any(weight.in_kg_mm for weight in self.weights)

    @property
    def vectors(self) -> list[tuple[Fraction, Amplitude]]:
        """The counterweights' stations and vectors, straight up + i to the right at theta = 0."""
        return [
            (c.station, c.weight.vector)
            for c in self.counterweights
            if c.station is not None and c.weight is not None
        ]

    @property
    def before(self) -> tuple[Amplitude, Amplitude]:
        """The force and the couple of the weights alone."""
        return rotating_unbalance(self.weights)

    @property
    def remains(self) -> tuple[Amplitude, Amplitude]:
        """The force and the couple of weights and counterweights, added up anew."""
        every = [*((w.station, w.vector) for w in self.weights), *self.vectors]
        return total(vector for _, vector in every), total(v.scaled(z) for z, v in every)

    def summary(self) -> str:
        """Return how many counterweights there are, and what is left, in one line."""
        force, couple = self.remains
        residual = (
            f"{'no' if force.is_zero() else 'a'} force and {'no' if couple.is_zero() else 'a'} couple"
        )
        count, others = len(self.counterweights), len(self.weights)
        return (
            f"{count} counterweight{'' if count == 1 else 's'} against "
            f"{others} turning weight{'' if others == 1 else 's'}: {residual} left"
        )

    def document(self) -> Document:
        """Return the counterweights, what they leave, the weights they are against."""
        from symbalance.design.balancing.rotating_document import rotating_document

        return rotating_document(self)

    def data(self) -> dict[str, Any]:
        """Return weights, counterweights and what is left, exact numbers as strings.

        A vector's `cos` and `sin` are its parts straight up and to the right at theta = 0, in `unit`;
        couples are in it times pitches, about station 0.
        """
        pairs = zip(("force", "couple"), self.before, self.remains, strict=True)
        return {
            "unit": self._unit,
            "stations": [str(z) for z in self.stations],
            "spread": self.spread,
            "counterweights": _rows(self.vectors),
            "weights": _rows((w.station, w.vector) for w in self.weights),
            **{
                name: {"before": vector_data(before), "left": vector_data(after)}
                for name, before, after in pairs
            },
            "complete": all(part.is_zero() for part in self.remains),
        }

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each counterweight, then for each weight.

        Keys: is_counterweight, station (pitches), size and direction_deg (floats, None with symbols in
        them), exact_up and exact_right (its parts), unit of the size (kg mm or m r).
        """
        every = [(True, z, number) for z, number in self.vectors]
        every += [(False, weight.station, weight.vector) for weight in self.weights]
        rows = []
        for is_counterweight, station, number in every:
            size, degrees = polar(number)
            rows.append(
                {
                    "is_counterweight": is_counterweight,
                    "station": float(station),
                    "size": size,
                    "direction_deg": degrees,
                    "exact_up": str(Component(number).cos),
                    "exact_right": str(Component(number).sin),
                    "unit": self._unit,
                }
            )
        return rows

    @property
    def _unit(self) -> str:
        return "kg mm" if self.in_kg_mm else "m r"


def vector_data(number: Amplitude) -> dict[str, Any]:
    """Return a vector's exact parts and decimals."""
    return dict(component_values(Component(number)))


def polar(number: Amplitude) -> tuple[float | None, float | None]:
    """Return a vector's size, and its direction in degrees from straight up; None with symbols in it."""
    if number.has_symbols:
        return None, None
    near = number.evaluated()
    return hypot(float(near.real), float(near.imag)), float(atan2(near.imag, near.real) * 180 / pi())


def _rows(vectors: Iterable[tuple[Fraction, Amplitude]]) -> list[dict[str, Any]]:
    return [{"station": str(z), "vector": vector_data(number)} for z, number in vectors]


def throw_unbalance(parts: Iterable[tuple[object, object]]) -> Fraction:
    """Return the unbalance of one throw, the sum of m_i r_i over its parts: kg times mm give kg mm.

    Radii count from the crank's axis towards the pin; negative ones lie opposite, as a web's own
    counterweight does. The counterweight to it has the same mass times radius on the other side.

    >>> throw_unbalance([("0.35", 40), ("0.42", 40), ("0.9", 12)])  # pin, rod end, two cheeks
    Fraction(208, 5)
    """
    rows = [
        tuple(as_list(part, "part", "(0.35, 40)")) for part in as_list(parts, "parts", "[(0.35, 40)]")
    ]
    if any(len(row) != 2 for row in rows):
        raise SymbalanceError("parts", "hold a mass and a radius each", "write them like [(0.35, 40)]")
    return sum((_mass(m) * exact(r, "radius") for m, r in rows), Fraction(0))


def _mass(value: object) -> Fraction:
    mass = exact(value, "mass")
    if mass < 0:
        raise SymbalanceError(f"mass = {brief(value)}", "must not be negative", "give a negative radius")
    return mass


def rotating_weights(engine: Engine) -> list[Weight]:
    """Return an engine's rotating masses as weights: in kg mm if sizes are known, else relative.

    >>> from symbalance.engine.builders import inline
    >>> from symbalance.engine.crank_train import CrankTrain
    >>> train = CrankTrain(reciprocating_mass=Fraction(1, 2), rotating_mass=Fraction(3, 4))
    >>> [w.vector.rational() for w in rotating_weights(inline("1-2", crank_train=train))]
    [Fraction(3, 2), Fraction(3, 2)]
    """
    unit = engine.unit_unbalance
    weights = []
    for cylinder, share in zip(engine.cylinders, engine.rotating_sizes, strict=True):
        size = {"share": share} if unit is None else {"unbalance": share * unit}
        weights += [Weight(cylinder.station, cylinder.throw, **size)] if share else []
    return weights


def rotating_unbalance(weights: Iterable[Weight], plane: object = 0) -> tuple[Amplitude, Amplitude]:
    """Return the force, and the couple about a station, of rotating weights, in their unit.

    >>> force, couple = rotating_unbalance([Weight(1, 0, unbalance=5), Weight(-1, 180, unbalance=5)])
    >>> force.is_zero(), couple.rational()
    (True, Fraction(10, 1))
    """
    rows, station = _checked_weights(weights), exact(plane, "plane")
    return total(w.vector for w in rows), total(w.vector.scaled(w.station - station) for w in rows)


def balanced_weights(
    weights: Iterable[Weight], stations: Sequence[object], *, spread: str = "ends"
) -> RotatingBalance:
    """Return counterweights at given stations that balance rotating weights in force and couple.

    With two stations or more the balance is exact; `spread` "ends" takes the fewest planes and the least
    total, "even" all of them with the least sum of squares. With one station it is static, if it can be
    no more.

    >>> balance = balanced_weights([Weight(1, 0, unbalance=6), Weight(0, 90, unbalance=3)], [3, -3])
    >>> [str(c.station) for c in balance], all(c.weight is not None for c in balance)
    (['3', '-3'], True)
    """
    rows = _checked_weights(weights)
    in_kg_mm = any(w.in_kg_mm for w in rows)
    places = [exact(s, "stations") for s in as_list(stations, "stations", "[2, -2]")]
    force, couple = rotating_unbalance(rows)
    if len(set(places)) == 1:  # static: the couple about the one plane is not to be had
        force, couple = -force, -force.scaled(places[0])
    else:
        force, couple = -force, -couple
    vectors = []
    if not (force.is_zero() and couple.is_zero()):
        vectors = in_planes(force, couple, places, spread=spread, length=Fraction(1))
    counterweights = tuple(_counterweight(vector, station, in_kg_mm) for station, vector in vectors)
    return RotatingBalance(tuple(rows), tuple(places), spread, counterweights)


def _counterweight(vector: Amplitude, station: Fraction, in_kg_mm: bool) -> Counterweight:
    if not in_kg_mm:
        return Counterweight(Angle(Fraction(0)), station, share=vector)
    return Counterweight(Angle(Fraction(0)), station, unbalance=vector)


def _checked_weights(weights: Iterable[Weight]) -> list[Weight]:
    rows = as_list(weights, "weights", "[Weight(1, 0, unbalance=5)]")
    if not all(isinstance(w, Weight) for w in rows):
        raise SymbalanceError("weights", "must be Weight values", "make each with Weight(...)")
    if len({w.in_kg_mm for w in rows}) > 1:
        raise SymbalanceError("weights", "are partly in kg mm and partly shares", "give them in one unit")
    return rows
