"""Balance shafts aside of the crank roll the frame: against rotating forces at their places, by angle."""

from __future__ import annotations

from math import cos, pi, radians, sin

import pytest

import symbalance as sb
from symbalance.engine.crank_train import CrankTrain

STROKE, ROD, MASS = 80, 140, 0.5
SHAFTS = [
    # speed, station, x, y in mm, unbalance in kg mm, direction at theta = 0 in degrees
    [(2, 0, 0, 70, 3, 180), (-2, 0, 0, -70, 3, 180)],
    [(1, 1, 55, 20, 4, 30), (-1, -1, -40, 15, 5, 200), (2, 0, 35, -60, 2, 75)],
    [(-2, 0, -90, 10, 6, 140)],
]


def moment_at(theta: float, shafts: list[tuple[int, ...]]) -> float:
    """Return y F_right - x F_up over m r^2 omega^2: + in the crank's sense, clockwise from the front."""
    radius, total = STROKE / 2, 0.0
    for speed, _, x, y, unbalance, direction in shafts:
        angle = speed * theta + radians(direction)
        force = unbalance * speed**2 / (MASS * radius)
        total += force * (y * sin(angle) - x * cos(angle)) / radius
    return total


def rolls(engine: sb.Engine, order: int) -> list[tuple[float, float, float]]:
    rows = sb.torque.torque_report(engine, order).records()
    return [
        (row["order"], row["cos"], row["sin"])  # type: ignore[misc]
        for row in rows
        if str(row["of"]).startswith("roll moment")
    ]


def opposite_torque(engine: sb.Engine, order: int) -> list[tuple[float, float, float]]:
    rows = sb.inertia_torque(engine, order).records()
    return [(r["order"], -r["cos"] * r["coefficient"], -r["sin"] * r["coefficient"]) for r in rows]  # type: ignore[operator,misc]


@pytest.mark.slow
@pytest.mark.parametrize("offset", [None, 6])
@pytest.mark.parametrize("shafts", SHAFTS, ids=["lanchester", "three", "one"])
def test_the_roll_of_shafts_is_their_forces_at_their_places(
    shafts: list[tuple[int, ...]], offset: int | None
) -> None:
    sizes = {"stroke": STROKE, "rod": ROD, "reciprocating_mass": "0.5", "offset": offset}
    train = CrankTrain(**{key: value for key, value in sizes.items() if value is not None})
    bare = sb.inline("1-3-4-2", crank_train=train)
    weights = [
        sb.BalanceShaft(speed, [sb.engine.Weight(station, direction, unbalance=unbalance)], x=x, y=y)
        for speed, station, x, y, unbalance, direction in shafts
    ]
    order = 4
    with_shafts = rolls(bare.balanced_by(*weights), order)
    # Centred, with nothing aside, the frame gets the opposite of the crank's torque, and no row says so.
    without = rolls(bare, order) if offset else opposite_torque(bare, order)
    assert with_shafts
    assert without
    for degrees in range(0, 360, 17):
        theta = degrees * pi / 180
        value = sum(c * cos(n * theta) + s * sin(n * theta) for n, c, s in with_shafts)
        value -= sum(c * cos(n * theta) + s * sin(n * theta) for n, c, s in without)
        assert value == pytest.approx(moment_at(theta, shafts), abs=1e-9)
