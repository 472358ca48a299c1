"""Evidence: engines whose stations and pins are listed, against pistons moved by hand where they stand.

What is listed is typed here a second time, as places in pitches and throws in degrees, and goes through
`kinematics`, which knows no harmonic: forces, couples and torque by quadrature.
"""

from __future__ import annotations

from fractions import Fraction

import pytest
from mpmath import mp

import symbalance as sb
from symbalance.engine.engine_file import parse_engine
from symbalance.torque import inertia_torque
from tests import kinematics
from tests.independent.test_against_quadrature import assert_agrees
from tests.kinematics import Place

SIX = """\
[crank_train]
stroke = 86
rod = 172
reciprocating_mass = 0.5
[layout]
firing_order = [1, 5, 3, 6, 2, 4]
pitch = [91, 91, 91, 104.5, 91]
station_unit = "mm"
"""
EIGHT = """\
[crank_train]
ratio = 4
pitch = 100
[layout]
pins = [0, 180, 90, 270, 270, 90, 180, 0]
stations = [0, -100, -200, -300, -437.5, -537.5, -637.5, -750]
station_unit = "mm"
"""
SPLIT = """\
[crank_train]
ratio = 4
[layout]
banks = [45, -45]
cylinders = [[1, 3, 5], [2, 4, 6]]
pins = [[45, -75, 165], [78.5, -41.5, 198.5]]
stations = [[0, -1, "-9/4"], ["-1/5", "-6/5", "-49/20"]]
firing_order = [1, 6, 5, 4, 3, 2]
"""


def placed(*rows: tuple[object, object, object]) -> list[Place]:
    return [Place(*map(Fraction, row)) for row in rows]  # type: ignore[arg-type]


PLACES = {
    SIX: placed(
        *zip(
            (0, -120, 120, 120, -120, 0),
            [0] * 6,
            [-Fraction(x) / 91 for x in ("0", "91", "182", "273", "377.5", "468.5")],
            strict=True,
        )
    ),
    EIGHT: placed(
        *zip(
            (0, 180, 90, 270, 270, 90, 180, 0),
            [0] * 8,
            ("0", "-1", "-2", "-3", "-4.375", "-5.375", "-6.375", "-7.5"),
            strict=True,
        )
    ),
    SPLIT: placed(
        (45, 45, 0),
        (-75, 45, -1),
        (165, 45, "-2.25"),
        ("78.5", -45, "-0.2"),
        ("-41.5", -45, "-1.2"),
        ("198.5", -45, "-2.45"),
    ),
}
each_engine = pytest.mark.parametrize("text", PLACES, ids=["in-line six", "straight eight", "split pins"])


@pytest.mark.slow
@each_engine
def test_forces_and_couples_of_listed_places(text: str) -> None:
    engine = parse_engine(text, "listed.toml")
    assert_agrees(engine, places=PLACES[text], order=6)
    assert any(not order.couple.is_zero() for order in sb.balance(engine, 6).orders)


@each_engine
def test_torque_of_listed_pins(text: str) -> None:
    """Minus velocity times acceleration of each piston, at two angles."""
    engine = parse_engine(text, "listed.toml")
    terms = inertia_torque(engine, 40).terms(4)
    with mp.workdps(30):
        for theta in (mp.mpf("0.7"), mp.mpf("2.9")):
            own = [theta + kinematics.radians(p.throw - p.bank) for p in PLACES[text]]
            expected = -mp.fsum(kinematics.velocity(p, 4) * kinematics.acceleration(p, 4) for p in own)
            waves = (c * mp.cos(n * theta) + s * mp.sin(n * theta) for n, c, s in terms)
            assert abs(mp.fsum(waves) - expected) < mp.mpf(10) ** -20


def test_newton_metres_are_those_of_the_millimetres_whatever_the_pitch_a() -> None:
    """About the mean of the stations in metres, by a sum over the pistons in doubles."""
    rpm, theta = 6000, 0.4
    omega = 2 * mp.pi * rpm / 60
    from_front = [0, 91, 182, 273, 377.5, 468.5]
    middle = sum(from_front) / 6
    throws = (0, -120, 120, 120, -120, 0)
    expected = mp.fsum(
        0.5 * 0.043 * omega**2 * (middle - x) / 1000 * kinematics.acceleration(theta + mp.radians(t), 4)
        for x, t in zip(from_front, throws, strict=True)
    )
    for other in ("", "pitch = 50\n"):
        text = SIX.replace("rod = 172\n", f"rod = 172\n{other}")
        operated = sb.balance(parse_engine(text, "six.toml"), 30).at(rpm=rpm)
        pitch, unit = (50 if other else 91) / 1000, 0.5 * 0.043 * omega**2
        waves = mp.fsum(
            operated.values[int(order.order)]
            * unit
            * pitch
            * mp.fsum(
                part * wave
                for part, wave in zip(
                    order.couple.vertical.decimal(20),
                    (mp.cos(int(order.order) * theta), mp.sin(int(order.order) * theta)),
                    strict=True,
                )
            )
            for order in operated.orders
        )
        assert abs(waves - expected) < 1e-9 * abs(expected)


FIRED = {
    "even": ("pins = [45, -75, 165]\nsplay = [0, 30]", [0, 120, 240, 360, 480, 600]),
    "common pins": ("pins = [45, -75, 165]", [0, 150, 240, 390, 480, 630]),
    "split by 33.5": ("pins = [45, -75, 165]\nsplay = [0, 33.5]", [0, 116.5, 240, 356.5, 480, 596.5]),
}


@pytest.mark.parametrize("name", FIRED)
def test_firings_follow_from_the_pins(name: str) -> None:
    """Bank angle less throw, by hand: the other bank is 90 degrees ahead, its pin so much further on."""
    pins, fires = FIRED[name]
    banks = "banks = [45, -45]\ncylinders = [[1, 3, 5], [2, 4, 6]]\nfiring_order = [1, 6, 5, 4, 3, 2]\n"
    engine = parse_engine(f"[layout]\n{banks}{pins}\n", "v6.toml")
    order = engine.firing_order()
    assert order == [1, 6, 5, 4, 3, 2]
    fired = {c.number: c.fires for c in engine.cylinders}
    assert [fired[n] for n in order] == fires


@pytest.mark.parametrize(("pins", "fires"), [([30, 30], [0, 360]), ([70], [0]), ([20, 200], None)])
def test_firings_are_even_where_the_pins_allow_it(pins: list[int], fires: list[int] | None) -> None:
    """Wherever on the crank the first pin is; pins half a turn apart fire 180-540 or 540-180."""
    order = list(range(1, len(pins) + 1))
    if fires is None:
        with pytest.raises(sb.SymbalanceError, match="add firing_intervals"):
            sb.inline(order, throws=pins)
    else:
        assert [c.fires for c in sb.inline(order, throws=pins).cylinders] == fires
