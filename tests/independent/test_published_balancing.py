"""Presets with published masses against what the same sources say of their forces.

Sources stand in the presets and in `docs/sources.md`. The formulas here are the sources' own, written
out; they share nothing with the program.
"""

from __future__ import annotations

from cmath import exp
from math import cos, pi, radians, sin, sqrt

import pytest

import symbalance as sb
from symbalance.engine.catalogue import preset_text
from symbalance.engine.engine_file import parse_engine

RPM = 3000
OMEGA = RPM * pi / 30


def test_the_v4_of_135_degrees_shakes_with_the_published_force() -> None:
    """About 1.15 kN at 3000 rpm, upright, nothing across: order 2 with r/l for its coefficient."""
    balance = sb.balance(sb.load("v4-135"), 6)
    mass, radius, rod = 0.688, 0.035, 0.111
    first = mass * radius * OMEGA**2
    upright = float(balance[2].force.vertical.amplitude)
    assert upright == pytest.approx(4 * cos(radians(67.5)))
    assert upright * first * radius / rod == pytest.approx(1150, abs=5)
    assert all(order.force.lateral.amplitude == 0 for order in balance.orders)
    assert 1 not in [order.order for order in balance.orders if order.force.vertical.amplitude != 0]


def test_two_masses_at_twice_the_speed_leave_the_published_residue_of_the_v4() -> None:
    """80 g at 17.5 mm, twice, at 110 degrees: some 65 N of 1150 are left, however the phase is meant."""
    balance = sb.balance(sb.load("v4-135"), 6)
    upright = float(balance[2].force.vertical.amplitude) * 0.688 * 0.035 * OMEGA**2 * 0.035 / 0.111
    two = 2 * 0.08 * 0.0175 * (2 * OMEGA) ** 2
    assert upright - two == pytest.approx(42, abs=2)
    assert upright - two < 65


@pytest.mark.parametrize(("counterweight", "at"), [(844, 37.36), (764, 41.4)])
def test_half_of_the_piston_is_balanced_in_the_single(counterweight: float, at: float) -> None:
    """The project's two counterweights, of steel and with tungsten, are to balance k = 0.5 of the piston.

    The second has 80 g less than the first. What it takes from the upright first order it adds across.
    """
    weighed = (
        f"{preset_text('szechenyi-single')}\n[[counterweight]]\nthrow = 1\nstation = 0\n"
        f"unbalance = {counterweight * at / 1000}\n"
    )
    balance = sb.balance(parse_engine(weighed, "single.toml"), 1)
    upright = float(balance[1].force.vertical.amplitude)
    across = float(balance[1].force.lateral.amplitude)
    assert across == pytest.approx(0.5, abs=0.01)
    assert upright + across == pytest.approx(1, rel=1e-9)


def test_the_masses_are_the_sums_that_the_sources_state() -> None:
    """Piston, and the rod's share by its centre of mass: in grams."""
    stated = {
        "twin-108": (952 + 1202.4 * (180 - 116.69) / 180, 1202.4 * 116.69 / 180),
        "two-stroke-92": (139.414 + 85.275 * 31.159 / 71.4, 85.275 * (1 - 31.159 / 71.4)),
        "two-stroke-37": (112 + 58.7 / 2, 58.7 / 2),
        "szechenyi-single": (380 + 330 * 33 / 106.7, 330 * (1 - 33 / 106.7) + 1310 * 12.86 / 31.5),
        "diesel-30": (1460 + 0.38 * 1400, 850 + 0.62 * 1400),
        "modelica-v6": (6000 + 1000 / 2, 1000 / 2),
        "lancia-fulvia-16": ((728.5 + 747 + 728 + 746) / 4, (490.5 + 494.5 + 495.5 + 489.5) / 4),
        "v4-135": (688, 396),
    }
    for name, (reciprocating, rotating) in stated.items():
        sizes = sb.load(name).first.sizes
        assert float(sizes.reciprocating_mass or 0) * 1000 == pytest.approx(reciprocating, rel=1e-4), name
        assert float(sizes.rotating_mass or 0) * 1000 == pytest.approx(rotating, rel=1e-4), name


@pytest.mark.parametrize("order", range(1, 8))
def test_pistons_of_the_modelica_v6_shake_as_its_geometry_says(order: int) -> None:
    """Heights of six pistons, over those of one, by circles and lines, transformed."""
    radius, rod, count = 0.05, 0.175, 72
    axes, throws = (-30, 30) * 3, (-30, 90, 210, 210, 90, -30)
    stations = (2.5, 1.5, 0.5, -0.5, -1.5, -2.5)
    steps = [2 * pi * step / count for step in range(count)]

    def harmonic(lead: float) -> complex:
        """Return the harmonic of one piston's height whose crank leads its axis by so many degrees."""
        turned = [angle + radians(lead) for angle in steps]
        heights = [radius * cos(t) + sqrt(rod**2 - (radius * sin(t)) ** 2) for t in turned]
        return sum(h * exp(-1j * order * angle) for h, angle in zip(heights, steps, strict=True)) / count

    one = harmonic(0)
    each = [harmonic(throw - axis) for throw, axis in zip(throws, axes, strict=True)]
    balance = sb.balance(sb.load("modelica-v6"), 7)
    if order in (3, 5, 7):
        assert abs(one) < 1e-15
        assert order not in [each_order.order for each_order in balance.orders]
        return
    for kind, arms in (("force", (1.0,) * 6), ("couple", stations)):
        for component, along in (("vertical", cos), ("lateral", sin)):
            parts = [
                h * arm * along(radians(axis)) for h, arm, axis in zip(each, arms, axes, strict=True)
            ]
            exact = getattr(getattr(balance[order], kind), component).amplitude
            assert abs(sum(parts)) / abs(one) == pytest.approx(float(exact), rel=1e-8, abs=1e-8)
