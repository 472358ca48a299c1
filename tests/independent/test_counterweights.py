"""Counterweights on unlike throws at the crank's own speed: against vectors added by hand, pin by pin."""

from __future__ import annotations

from math import cos, radians, sin

import pytest

import symbalance as sb
from symbalance.engine.engine_file import parse_engine

ROWS = [
    # throw, bank, station, stroke, rod, reciprocating, rotating; its counterweight's overbalance, angle
    (0, -45, 1, 80, 150, 0.5, 0.4, "1/2", 0),
    (120, -45, 0, 84, 150, 0.45, 0.3, "1/3", 10),
    (200, 30, "-1/2", 76, 140, 0.6, 0.5, "-1/4", -25),
]


def text(overbalanced: bool) -> str:
    lines = ['name = "unlike"']
    for number, (throw, bank, station, stroke, rod, mass, rotating, _, _) in enumerate(ROWS, 1):
        lines += ["[[cylinder]]", f"number = {number}", f"throw = {throw}", f"bank = {bank}"]
        lines += [f'station = "{station}"', f"stroke = {stroke}", f"rod = {rod}"]
        lines += [f"reciprocating_mass = {mass}", f"rotating_mass = {rotating}"]
    for number, row in enumerate(ROWS if overbalanced else (), 1):
        lines += [
            "[[counterweight]]",
            f"throw = {number}",
            f'overbalance = "{row[7]}"',
            f"angle = {row[8]}",
        ]
    return "\n".join(lines)


def up_and_right(theta: float, overbalanced: bool) -> tuple[float, float, float, float]:
    """Return the force up and right and their moments by station, at the crank's speed, over m r omega^2.

    A piston's inertia of order one is m r cos(theta + pin - bank) along its axis, whatever its rod.
    """
    up = right = up_moment = right_moment = 0.0
    stations = [float(as_number(row[2])) for row in ROWS]
    middle = sum(stations) / len(stations)
    unit = 0.5 * 40
    for (throw, bank, _, stroke, _, mass, rotating, share, angle), station in zip(
        ROWS, stations, strict=True
    ):
        pin, axis, radius = theta + radians(throw), radians(bank), stroke / 2
        along = mass * radius * cos(pin - axis)
        y, x = along * cos(axis), along * sin(axis)
        if overbalanced:
            y += rotating * radius * cos(pin)
            x += rotating * radius * sin(pin)
            weight = (rotating + as_number(share) * mass) * radius
            y -= weight * cos(pin + radians(angle))
            x -= weight * sin(pin + radians(angle))
        up, right = up + y / unit, right + x / unit
        up_moment += (station - middle) * y / unit
        right_moment += (station - middle) * x / unit
    return up, right, up_moment, right_moment


def as_number(value: object) -> float:
    above, _, below = str(value).partition("/")
    return float(above) / float(below or 1)


@pytest.mark.parametrize("overbalanced", [False, True])
def test_the_first_order_is_the_sum_of_vectors(overbalanced: bool) -> None:
    engine = parse_engine(text(overbalanced), "unlike.toml")
    rows = sb.balance(engine, 1).records()
    values = {
        (row["of"], row["component"]): (row["cos"], row["sin"]) for row in rows if row["order"] == 1
    }
    names = [(of, side) for of in ("force", "couple") for side in ("vertical", "lateral")]
    for degrees in (0, 50, 90, 200, 311):
        theta = radians(degrees)
        computed = []
        for name in names:
            c, s = values.get(name, (0.0, 0.0))
            computed.append(c * cos(theta) + s * sin(theta))  # type: ignore[operator]
        assert computed == pytest.approx(up_and_right(theta, overbalanced), abs=1e-9)
