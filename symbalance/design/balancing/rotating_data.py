"""Balanced turning weights as plain values for JSON and data frames: exact numbers as strings."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from math import hypot
from typing import Any

from symbalance.design.balancing.rotating import RotatingBalance
from symbalance.exact.amplitude import Amplitude
from symbalance.exact.spectrum import Component
from symbalance.forces.balance_data import component_values
from symbalance.text.reals import atan2, pi


def rotating_data(balance: RotatingBalance) -> dict[str, Any]:
    """Return what `to_json` writes, as plain Python values.

    A vector's `cos` and `sin` are its parts straight up and to the right at theta = 0, in `unit`; couples
    are in it times pitches, about station 0.
    """
    pairs = zip(("force", "couple"), balance.before, balance.remains, strict=True)
    return {
        "unit": _unit(balance),
        "stations": [str(z) for z in balance.stations],
        "spread": balance.spread,
        "counterweights": _placed(balance.placed),
        "weights": _placed((w.station, w.vector) for w in balance.weights),
        **{name: {"before": vector(one), "left": vector(other)} for name, one, other in pairs},
        "complete": all(part.is_zero() for part in balance.remains),
    }


def vector(number: Amplitude) -> dict[str, Any]:
    """Return a vector's exact parts and decimals."""
    return dict(component_values(Component(number)))


def polar(number: Amplitude) -> tuple[float | None, float | None]:
    """Return a vector's size, and its direction in degrees from straight up; None with symbols in it."""
    if number.has_symbols:
        return None, None
    near = number.evaluated()
    return hypot(float(near.real), float(near.imag)), float(atan2(near.imag, near.real) * 180 / pi())


def _unit(balance: RotatingBalance) -> str:
    return "kg mm" if balance.in_kg_mm else "m r"


def _placed(placed: Iterable[tuple[Fraction, Amplitude]]) -> list[dict[str, Any]]:
    return [{"station": str(z), "vector": vector(number)} for z, number in placed]


def rotating_records(balance: RotatingBalance) -> list[dict[str, Any]]:
    """Return a row for each counterweight, then for each weight.

    Keys: is_counterweight, station (pitches), size and direction_deg (floats, None with symbols in them),
    exact_up and exact_right (its parts), unit of the size (kg mm or m r).
    """
    every = [(True, z, number) for z, number in balance.placed]
    every += [(False, weight.station, weight.vector) for weight in balance.weights]
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
                "unit": _unit(balance),
            }
        )
    return rows
