"""One cylinder: where it stands, which way it points, where its crank pin is, what is its own.

Angles are positive in the sense of rotation, from straight up, the engine seen from the front turning
clockwise. A cylinder's own crank angle is theta + throw - bank: top dead centre where that is 0.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

from symbalance.engine.trains import OWN, CrankTrain, Link, own_train
from symbalance.errors import SymbalanceError, shown
from symbalance.exact.angles import Angle, angle, degrees
from symbalance.text.numbers import checked_whole, exact

MOST_CYLINDERS = 1000
LONGEST_STATION = 10_000


@dataclass(frozen=True, init=False)
class Cylinder:
    """One cylinder.

    `throw` is its crank pin's angle at theta = 0 and `bank` its axis' angle, degrees if numbers or
    text, the angle itself if a SymPy expression. `station` is its place along the crank, in cylinder
    pitches, positive towards the front. `fires` is its firing angle in degrees after cylinder 1's
    firing top dead centre, or None if that is not known. Sizes of its own (stroke, rod,
    reciprocating_mass, rotating_mass, offset; mm and kg) override the engine's; `link` hangs its rod
    on another cylinder's, `rod` then being the link rod's own length.

    >>> Cylinder(1, throw="360/7", station="5/2")
    Cylinder(1, throw='360/7', bank='0', station='5/2')
    """

    number: int
    throw: Angle
    bank: Angle
    station: Fraction
    fires: Fraction | None
    own: CrankTrain
    link: Link | None

    def __init__(
        self,
        number: int,
        throw: object = 0,
        bank: object = 0,
        station: object = 0,
        fires: object = None,
        *,
        link: Link | None = None,
        **own: object,
    ) -> None:
        set_field = object.__setattr__
        set_field(
            self, "number", checked_whole(number, "number", 1, MOST_CYLINDERS, "count from the front")
        )
        set_field(self, "throw", angle(throw, "throw").normalized())
        set_field(self, "bank", checked_bank(bank))
        set_field(self, "station", _checked_station(station))
        set_field(self, "fires", None if fires is None else _checked_fires(fires))
        unknown = [key for key in own if key not in OWN]
        if unknown:
            raise TypeError(f"Cylinder has no {unknown[0]!r}; its own sizes are {', '.join(OWN)}")
        set_field(self, "own", own_train(own))
        set_field(self, "link", link)

    def __repr__(self) -> str:
        parts = f"throw={self.throw.as_text()!r}, bank={self.bank.as_text()!r}"
        fires = "" if self.fires is None else f", fires='{self.fires}'"
        return f"Cylinder({self.number}, {parts}, station='{self.station}'{fires})"

    @cached_property
    def delay(self) -> Angle:
        """How far its pin leads its axis at theta = 0: throw - bank."""
        return (self.throw - self.bank).normalized()


def _checked_fires(fires: object) -> Fraction:
    value = degrees(fires, "fires").in_degrees()
    if not 0 <= value < 720:
        what = f"fires = {shown(fires)}"
        raise SymbalanceError(what, "must lie in [0, 720)", "degrees after cylinder 1's firing")
    return value


def checked_bank(bank: object, name: str = "bank") -> Angle:
    """Return a bank's angle from vertical; a number is taken modulo 360, to (-180, 180].

    >>> checked_bank(270) == checked_bank(-90)
    True
    """
    result = angle(bank, name)
    return result if result.symbols else result.normalized()


def _checked_station(station: object) -> Fraction:
    value = exact(station, "station")
    if abs(value) > LONGEST_STATION:
        raise SymbalanceError(
            f"station = {shown(station)}",
            f"must lie within {-LONGEST_STATION} and {LONGEST_STATION}",
            "give cylinder pitches, not millimetres",
        )
    return value
