"""Forces in N and couples in N m against pistons and weights whose places are differentiated.

Nothing here knows a harmonic coefficient: pins go round, rods reach the cylinders' axes (`tests.placed`),
link pins swing with their masters (`tests.link_pins`), weights turn. Their places over a turn, in m, are
transformed; minus mass times the second derivative by time is the force, and with the stations, in m from
their mean, the couple.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from fractions import Fraction
from math import atan2, cos, pi, sin
from typing import Any

import numpy as np
import pytest

import symbalance as sb
from symbalance.document.formula import Decimal
from symbalance.document.nodes import Document, Table
from symbalance.engine.cylinders import unchecked_copy
from symbalance.forces.turn_maximum import turn_maximum
from tests import TESTS, placed

POINTS = 512
PLANAR = ("vertical", "lateral")
HIGHEST = 120
"""Orders above are below a rounding of the first; the noise of doubles grows with n squared."""
GRID = 1 << 16
THETA = 2 * pi * np.arange(POINTS) / POINTS
RPM = 5400
OMEGA = RPM * pi / 30
ORDERS = 8


@dataclass(frozen=True)
class Turning:
    """A weight: turns at `speed` times the crank, `unbalance` kg mm, at an angle, at a station."""

    speed: int
    unbalance: float
    angle: float
    station: float


@dataclass(frozen=True)
class Case:
    """An engine, the sizes it lacks, and what turns in it, in the test's own words."""

    engine: Callable[[], sb.Engine]
    sizes: dict[str, Any] = field(default_factory=dict)
    turning: tuple[Turning, ...] = ()


def _file(name: str) -> Callable[[], sb.Engine]:
    return lambda: sb.load(TESTS / "record" / "engines" / f"{name}.toml")


def _second_order(stroke: float, rod: float) -> float:
    """Return one piston's A_2 from its places over a turn."""
    radius = stroke / 2
    height = radius * np.cos(THETA) + np.sqrt(rod**2 - (radius * np.sin(THETA)) ** 2)
    return float(2 * 4 * np.fft.fft(height)[2].real / POINTS / radius)


def _boxer() -> sb.Engine:
    four = sb.boxer("1-3-2-4", stagger=["1/4", "-1/4"])
    return four.with_sizes(stroke=79, rod=131, reciprocating_mass="0.52", pitch=113)


def _lanchester() -> tuple[Turning, ...]:
    size = 2 * _second_order(86, 143) * 0.5 * 43 / 4  # a share is of A_n m r/n^2
    return (Turning(2, size, 180, 0), Turning(-2, size, 180, 0))


def _on_three_throws() -> tuple[Turning, ...]:
    pins = tuple(Turning(1, 0.5 * 40, throw, station) for throw, station in ((0, 1), (240, 0), (120, -1)))
    share = 0.4 * 40
    return (
        *pins,
        Turning(1, 12.5, 150, 1),
        Turning(1, share / 3, -30, -1),
        Turning(1, share / 4, 240 + 180, 0.25),  # web 3 is the second pin's first, a quarter pitch ahead
    )


def _unlike_shaft() -> sb.Engine:
    """Unlike cylinders, a shaft at 30 times the speed: above every order summed at first."""
    shaft = sb.BalanceShaft(-30, [sb.engine.Weight(1, 40, unbalance="0.05")], phase=20)
    return _file("unlike-strokes-four")().balanced_by(shaft)


SHARED = {"stroke": 84, "mass": "0.46"}
CASES = {
    "vee": Case(lambda: sb.load("vq30de")),
    "vee of 12, no couple": Case(lambda: sb.load("v12-60"), {**SHARED, "pitch": 98}),
    "in line": Case(lambda: sb.load("inline-5"), {**SHARED, "pitch": 98, "rod": 150}),
    "one cylinder, no pitch": Case(lambda: sb.load("inline-1"), SHARED),
    "in line, nearly no rod": Case(lambda: sb.load("inline-4").with_ratio("1.05"), SHARED),
    "boxer": Case(_boxer),
    "boxer, by a file": Case(_file("opposed-boxer")),
    "offset": Case(lambda: sb.load("vw-vr6"), {"mass": "0.46"}),
    "link rods": Case(lambda: sb.load("r-985"), {"mass": "2.3"}),
    "link rods, by a file": Case(_file("link-rod-five"), {"mass": "1.2"}),
    "unlike": Case(_file("unlike-strokes-four")),
    "unlike masses": Case(_file("unlike-masses-three")),
    "shafts": Case(_file("lanchester-four"), {}, _lanchester()),
    "counterweights": Case(_file("placed-counterweights-three"), {}, _on_three_throws()),
    "a fast shaft": Case(_unlike_shaft, {}, (Turning(-30, 0.05, 60, 1),)),
}
every_case = pytest.mark.parametrize("name", CASES)


def _at(name: str) -> sb.forces.Balance:
    case = CASES[name]
    return sb.balance(case.engine(), ORDERS).at(rpm=RPM, **case.sizes)


def _harmonics(name: str, of: str) -> np.ndarray:
    """Return c_n of vertical + i lateral in N or N m, n of both signs, from places alone."""
    case, engine = CASES[name], _at(name).engine
    mean = float(sum(c.station for c in engine.cylinders)) / len(engine.cylinders)
    pitch = 0.0 if engine.pitch is None else float(engine.pitch) / 1000

    def lever(station: float) -> float:
        return 1.0 if of == "force" else (station - mean) * pitch

    moments = np.zeros(POINTS, complex)  # mass times place, kg m
    for cylinder in engine.cylinders:
        assert cylinder.reciprocating_mass is not None
        height = _heights(engine, cylinder) / 1000
        axis = placed.direction(cylinder.bank)
        moments += float(cylinder.reciprocating_mass) * height * axis * lever(float(cylinder.station))
    for weight in case.turning:
        place = np.exp(1j * (weight.speed * THETA + weight.angle * pi / 180))
        moments += weight.unbalance / 1000 * place * lever(weight.station)
    n = np.fft.fftfreq(POINTS, 1 / POINTS)
    return np.where(abs(n) <= HIGHEST, OMEGA**2 * n**2 * np.fft.fft(moments) / POINTS, 0)


def _heights(engine: sb.Engine, cylinder: sb.Cylinder) -> np.ndarray:
    """Return places over a turn, mm; of an engine with a ratio alone the rod is that times the radius."""
    if cylinder.sizes.rod is None:
        assert cylinder.stroke is not None
        assert cylinder.ratio is not None
        radius = float(cylinder.stroke) / 2
        own = THETA + 2 * pi * float((cylinder.throw - cylinder.bank).turns)
        reach = np.sqrt((float(cylinder.ratio) * radius) ** 2 - (radius * np.sin(own)) ** 2)
        return radius * np.cos(own) + reach
    return placed.heights(engine, cylinder, THETA)


def _outputs(name: str) -> list[str]:
    return ["force"] if _at(name).engine.pitch is None else ["force", "couple"]


TURNED = ("vee", "in line", "boxer", "offset", "link rods", "unlike", "unlike masses")
"""Engines whose weights, if they have any, turn steadily: torque is the pistons'."""


@pytest.mark.slow
@pytest.mark.parametrize("name", TURNED)
def test_the_inertia_torque_in_newton_metres(name: str) -> None:
    """By energy: the crank gets what the pistons' kinetic energy loses a radian."""
    engine = _at(name).engine
    energy = np.zeros(POINTS)
    n = np.fft.fftfreq(POINTS, 1 / POINTS)
    for cylinder in engine.cylinders:
        assert cylinder.reciprocating_mass is not None
        speed = np.fft.ifft(1j * n * np.fft.fft(_heights(engine, cylinder) / 1000)).real * OMEGA
        energy += float(cylinder.reciprocating_mass) * speed**2 / 2
    series = -1j * n * np.fft.fft(energy) / POINTS
    torque = sb.inertia_torque(engine, ORDERS).at(rpm=RPM)
    for order in range(1, ORDERS + 1):
        expected = 2 * series[order].real, -2 * series[order].imag
        values = [float(x) for x in torque.in_newton_metres(order)]
        assert np.allclose(values, expected, rtol=1e-8, atol=1e-9 * abs(series).max()), order


def _wave(harmonics: np.ndarray) -> np.ndarray:
    """Return vertical + i lateral at GRID angles."""
    padded = np.zeros(GRID, complex)
    padded[: POINTS // 2], padded[-POINTS // 2 :] = harmonics[: POINTS // 2], harmonics[POINTS // 2 :]
    return np.fft.ifft(padded) * GRID


def _largest(wave: np.ndarray) -> dict[str, float]:
    parts = {".vertical": np.real(wave), ".lateral": np.imag(wave), "": wave}
    return {name: float(abs(part).max()) for name, part in parts.items()}


@pytest.mark.slow
@every_case
def test_every_order_in_newtons(name: str) -> None:
    balance = _at(name)
    for of in _outputs(name):
        series = _harmonics(name, of)
        atol = 1e-9 * abs(series).max() + 1e-9
        for n in range(1, ORDERS + 1):
            for part in ("vertical", "lateral"):
                expected = placed.component(series, n, part)
                values = [float(x) for x in balance.in_newtons(n, f"{of}.{part}")]
                assert np.allclose(values, expected, rtol=1e-9, atol=atol), (of, n, part)


def _column(document: Document, topic: str, head: str) -> list[float]:
    """Return a column of a document's table as numbers."""
    (table,) = [b for b in document.blocks if isinstance(b, Table) and b.topic == topic]
    place = [column.head for column in table.columns].index(head)
    return [float(cell.text) for row in table.rows if isinstance(cell := row[place], Decimal)]


@pytest.mark.slow
@pytest.mark.parametrize("name", ["vee", "in line", "unlike"])
def test_a_printed_value_times_the_cosine_at_its_phase_is_the_force(name: str) -> None:
    """A_4 and A_8 are below zero: an amplitude at the phase printed would be half a turn out."""
    balance = _at(name)
    for of in _outputs(name):
        rows = [
            row
            for row in balance.records()
            if row["of"] == of and row["component"] in PLANAR and row["bound"] is None
        ]
        column = _column(balance.document(), of, {"force": "N", "couple": "N m"}[of])
        for value, row in zip(column, rows, strict=False):  # the smallest are said in a line
            phase = atan2(row["sin"], row["cos"])
            expected = placed.component(_harmonics(name, of), row["order"], row["component"])
            assert np.allclose([value * cos(phase), value * sin(phase)], expected, rtol=1e-4, atol=1e-3)
            of_row = row["value_cos"], row["value_sin"]
            assert np.allclose(of_row, expected, rtol=1e-8, atol=1e-6)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["in line", "vee", "unlike"])
def test_a_printed_torque_times_the_cosine_at_its_phase_is_the_torque(name: str) -> None:
    torque = sb.inertia_torque(_at(name).engine, ORDERS).at(rpm=RPM)
    column = _column(torque.document(), "inertia", "N m")
    for value, row in zip(column, torque.records(), strict=True):
        phase = atan2(row["sin"], row["cos"])
        expected = [float(x) for x in torque.in_newton_metres(int(row["order"]))]
        assert [row["value_cos"], row["value_sin"]] == expected
        assert np.allclose([value * cos(phase), value * sin(phase)], expected, rtol=1e-4)


@pytest.mark.slow
@every_case
def test_the_largest_over_a_turn(name: str) -> None:
    balance = _at(name)
    outputs = _outputs(name)
    assert {key.split(".")[0] for key in balance.turn_maxima} == set(outputs)
    size = float(balance.operating_point.force)  # type: ignore[union-attr]
    for of in outputs:
        wave = _wave(_harmonics(name, of))
        for part, expected in _largest(wave).items():
            top = balance.turn_maxima[of + part]
            noise = 1e-10 * size
            assert top.value <= top.bound
            assert expected <= top.bound + noise
            assert expected == pytest.approx(top.value, rel=1e-6, abs=noise)
            if top.value:
                assert top.bound / top.value - 1 <= 1e-6
                at_angle = wave[round(top.angle / 360 * GRID) % GRID]
                there = {".vertical": at_angle.real, ".lateral": at_angle.imag, "": at_angle}[part]
                assert abs(there) == pytest.approx(top.value, rel=1e-3)
            else:
                assert top.bound < 1e-7 * size  # of a plane that nothing leaves, not known as such


def _heavier(engine: sb.Engine, factor: Fraction) -> sb.Engine:
    return _resized(engine, "reciprocating_mass", factor, only=1)


def _resized(engine: sb.Engine, key: str, factor: Fraction, only: int | None = None) -> sb.Engine:
    changed = [
        unchecked_copy(c, sizes=replace(c.sizes, **{key: value * factor}))
        if (value := getattr(c.sizes, key)) is not None and only in (None, c.number)
        else c
        for c in engine.cylinders
    ]
    return sb.Engine(
        changed, strokes=engine.strokes, name=engine.name, pitch=engine.pitch, balancers=engine.balancers
    )


def _longer_link(engine: sb.Engine) -> sb.Engine:
    rod = engine.cylinders[1].sizes.rod
    assert rod is not None
    return _resized(engine, "rod", 1 + Fraction(1, 100) / rod, only=engine.cylinders[1].number)


FAULTS: dict[str, tuple[str, Callable[[Any], Any]]] = {
    "a piston's mass is off by a part in a million": (
        "vee",
        lambda e: _heavier(e, Fraction(1000001, 10**6)),
    ),
    "an offset has the other sign": ("offset", lambda e: _resized(e, "offset", Fraction(-1))),
    "a link rod is longer by 0.01 mm": ("link rods", _longer_link),
}


@pytest.mark.slow
@pytest.mark.parametrize("fault", FAULTS)
def test_a_fault_is_seen(fault: str) -> None:
    """What the library would say of a slightly different engine differs by more than the tolerance."""
    name, change = FAULTS[fault]
    balance = sb.balance(change(_at(name).engine), ORDERS).at(rpm=RPM)
    series = _harmonics(name, "force")
    away = [
        abs(float(value) - expected)
        for n in range(1, ORDERS + 1)
        for part in ("vertical", "lateral")
        for value, expected in zip(
            balance.in_newtons(n, f"force.{part}"), placed.component(series, n, part), strict=True
        )
    ]
    assert max(away) > 10 * (1e-9 * abs(series).max() + 1e-9)


def test_a_vector_that_turns_without_changing_its_size() -> None:
    top = turn_maximum({-3: 2.0 - 1.5j})
    assert top.value == pytest.approx(2.5, rel=1e-12)
    assert top.value <= top.bound <= 2.5 * (1 + 1e-6)
    assert turn_maximum({}, 0.25) == (0.0, 0.25, 0.0)


@pytest.mark.slow
def test_a_bound_that_leaves_out_what_is_there_would_show() -> None:
    """A wave of 40 harmonics between whose 160 first angles the largest lies."""
    harmonics = {n: 0.5 * np.exp(1j * n * 0.0123) / n**2 for n in range(1, 41)}
    both = harmonics | {-n: c.conjugate() for n, c in harmonics.items()}
    top = turn_maximum(both)
    turn = 2j * pi * np.arange(GRID) / GRID
    wave = np.sum([c * np.exp(n * turn) for n, c in both.items()], axis=0)
    assert float(np.abs(wave).max()) <= top.bound <= top.value * (1 + 1e-6)
    assert top.angle == pytest.approx(360 - np.degrees(0.0123), abs=0.05)
