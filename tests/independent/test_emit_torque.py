"""Evidence: torque as functions and as source in every language, against energy and straight evaluation.

Truth is the kinetic energy's derivative (`kinematics`), the running engine's closed forms, and its orders
summed term by term; every written source also tests itself, in a process of its own.
"""

from __future__ import annotations

import math
import pickle
from pathlib import Path

import numpy as np
import pytest
from mpmath import mp

import symbalance as sb
from symbalance.cli import run
from symbalance.errors import SymbalanceError
from symbalance.torque import (
    RunningTorque,
    ideal_cycle,
    inertia_torque,
    rod_torque,
    roll_moment,
    running_torque,
)
from tests import kinematics
from tests.independent.test_targets import self_test
from tests.independent.test_torque_unlike import fired, offset_twin
from tests.independent.test_unlike import hung_radial, narrow_six
from tests.targets import ENDINGS, execute

THETA = np.array([0.0, 0.3, -2.5, 7.0, 1e3, -1e5])
U = 2.0**-53
OTTO = ideal_cycle(10, heat=18)


def running(name: str = "v6-90") -> RunningTorque:
    return running_torque(sb.load(name), OTTO, bore=80, stroke=80, reciprocating_mass=0.5, rpm=3000)


def terms_at(terms, theta: float) -> float:
    """Return a sum of harmonics in 30 digits."""
    with mp.workdps(30):
        angles = ((mp.mpf(n.numerator) / n.denominator * mp.mpf(theta), c, s) for n, c, s in terms)
        return float(mp.fsum(c * mp.cos(a) + s * mp.sin(a) for a, c, s in angles))


@pytest.mark.slow
@pytest.mark.parametrize("name", ["inline-1", "inline-4", "v6-90", "radial-9", "inline-5"])
@pytest.mark.parametrize("target", ["numpy", "numba"])
def test_all_orders_are_the_kinetic_energys(name: str, target: str) -> None:
    layout = sb.load(name)
    made = sb.to_function(inertia_torque(layout, 1, ratio=4), tolerance=0, target=target)
    found = pickle.loads(pickle.dumps(made))(THETA)
    bound = U * made.rounding["torque.inertia"] * made.amplitude["torque.inertia"]
    bound += made.left_out["torque.inertia"] or 0.0
    with mp.workdps(40):
        for theta, value in zip(THETA.tolist(), found.tolist(), strict=True):
            own = [mp.mpf(theta) + kinematics.radians(c.delay.in_degrees()) for c in layout.cylinders]
            lam = mp.mpf(4)
            pairs = ((kinematics.velocity(p, lam), kinematics.acceleration(p, lam)) for p in own)
            assert abs(value + mp.fsum(v * a for v, a in pairs)) <= bound
    assert made.rounding["torque.inertia"] < 15


@pytest.mark.parametrize("tolerance", [1e-2, 1e-5, 1e-9])
def test_a_tolerance_is_met_with_the_fewest_orders(tolerance: float) -> None:
    result = inertia_torque(sb.load("inline-3"), 1)
    made, every = (sb.to_function(result, tolerance=t) for t in (tolerance, 0))
    theta = np.linspace(0, 2 * np.pi, 2000)
    gap = np.abs(made(theta) - every(theta)).max()
    left = made.left_out["torque.inertia"]
    assert left is not None
    assert 0.05 * left < gap <= left <= tolerance
    fewer = sb.to_function(
        inertia_torque(sb.load("inline-3"), int(made.orders["torque.inertia"][-1]) - 1)
    )
    assert np.abs(fewer(theta) - every(theta)).max() > tolerance / 3


@pytest.mark.slow
@pytest.mark.parametrize("engine", [narrow_six, hung_radial, offset_twin])
def test_unlike_cylinders_and_rods(engine) -> None:
    layout = engine()
    names = ("torque.inertia", "torque.frame", "torque.rod", "force.vertical")
    made = sb.to_function(inertia_torque(layout, 20), outputs=names)
    values = made(THETA)
    wanted = {
        "torque.inertia": (inertia_torque(layout, 20), 1.0),
        "torque.frame": (roll_moment(layout, 20), 1.0),
        "torque.rod": (rod_torque(layout, 20), _excess(layout)),
    }
    for name, (balance, scale) in wanted.items():
        for theta, value in zip(THETA.tolist(), values[name].tolist(), strict=True):
            expected = scale * terms_at(balance.terms(), theta)
            bound = U * made.rounding[name] * made.amplitude[name]
            assert abs(value - expected) <= bound + 1e-17 * abs(expected)
    force = sb.to_function(sb.balance(layout, 20))(THETA)
    assert (force == values["force.vertical"]).all()


def _excess(layout: sb.Engine) -> float:
    rod = layout.cylinders[0].rod_split
    return float(rod.excess) * 1e-6 if rod else 0.0


@pytest.mark.slow
@pytest.mark.parametrize("target", ["numpy", "numba", "array-api"])
def test_gas_and_inertia_add_up_to_the_whole(target: str) -> None:
    made = running()
    names = ("torque.gas", "torque.total", "torque.inertia")
    function = sb.to_function(made, outputs=names, order=30, target=target)
    theta = np.array([0.0, 0.4, 5.0, 11.0])
    values = function(theta, mass=0.5, radius=0.04, omega=made.omega)
    assert values["torque.gas"] + values["torque.inertia"] == pytest.approx(
        values["torque.total"], rel=1e-11
    )
    for t, value in zip(theta.tolist(), values["torque.total"].tolist(), strict=True):
        assert value == pytest.approx(made.mean + terms_at(made.terms(30), t), rel=1e-11)
    twice = function(theta, mass=1.0, radius=0.08, omega=2 * made.omega)
    assert twice["torque.gas"] == pytest.approx(2 * values["torque.gas"], rel=1e-14)
    assert twice["torque.inertia"] == pytest.approx(32 * values["torque.inertia"], rel=1e-14)
    assert twice["torque.total"] == pytest.approx(values["torque.total"], rel=1e-14)
    assert function.orders["torque.gas"][:2] == ("3/2", "3")


@pytest.mark.slow
def test_many_orders_come_near_the_torque_itself() -> None:
    made = running("inline-5")
    function = sb.to_function(made, order=200)
    for theta in (0.5, 3.0, 9.0):
        assert float(function(theta)) == pytest.approx(made.at(theta), abs=0.02 * made.mean)


def test_a_mean_alone_is_an_array_and_loses_what_is_not_finite() -> None:
    made = running("v12-60")
    function = sb.to_function(made, order=5)
    function.self_test()
    values = function(np.array([[1.0, np.inf], [2.0, np.nan]]))
    assert values[:, 0] == pytest.approx(made.mean)
    assert np.isnan(values[:, 1]).all()


# --- the command ---

FILE = """
name = "odd twin"
[crank_train]
stroke = 90
rod = 164
reciprocating_mass = 0.55
rod_mass = 0.6
rod_centre = 45
rod_inertia = 2900
offset = 9
[layout]
firing_order = [1, 2]
banks = [-22.5, 22.5]
cylinders = [[1], [2]]
firing_intervals = [405, 315]
"""
RUN = ("--compression", "10", "--bore", "81", "--rpm", "3000")
OUTPUTS = "torque.gas,torque.total,torque.inertia,torque.rod,torque.frame,force.vertical"


@pytest.mark.slow
@pytest.mark.parametrize("target", ["numpy", "numba", "array-api", "c", "javascript", "octave"])
def test_every_language_writes_a_source_that_tests_itself(target: str, tmp_path: Path) -> None:
    """Half orders, six outputs of five units, over a grid of two turns."""
    engine = tmp_path / "twin.toml"
    engine.write_text(FILE, encoding="utf-8")
    path = tmp_path / f"made{ENDINGS.get(target, '.py')}"
    options = ["--target", target, "--outputs", OUTPUTS, "--order", "8", "--uniform-grid", *RUN]
    assert run(["emit", str(engine), *options, "-o", str(path)]) == 0
    for line in self_test(target, path):
        execute(line, tmp_path)
    header = path.with_suffix(".h") if target == "c" else path
    text = " ".join(header.read_text(encoding="utf-8").split())
    assert "orders 1/2, 1, 3/2" in text
    assert "Mean " in text


@pytest.mark.slow
def test_a_grid_of_half_orders_repeats_after_two_turns() -> None:
    made = fired(offset_twin())
    function = sb.to_function(running_torque(made, OTTO, bore=80, rpm=3000), order=6)
    grid = function.on_grid(8, 4)
    assert grid == pytest.approx(function(2 * np.pi * np.arange(32) / 8), rel=1e-12)
    assert (grid[:16] == grid[16:]).all()
    assert abs(grid[:8] - grid[8:16]).max() > 1


def test_gas_needs_neither_mass_nor_speed(capsys) -> None:
    options = ("--compression", "10", "--bore", "80", "--outputs", "torque.gas", "--order", "4")
    assert run(["emit", "inline-4", "--target", "numpy", *options]) == 0
    namespace: dict = {"__name__": "made"}
    exec(capsys.readouterr().out, namespace)
    made = running("inline-4")
    expected = made.gas_terms(4)
    mean = math.fsum(made.gas(made.cycle * i / 2000) for i in range(2000)) / 2000
    value = namespace["evaluate"](0.7, radius=0.04)
    assert value == pytest.approx(mean + terms_at(expected, 0.7), rel=1e-5)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("--outputs", "torque.gas"), "is that of a running engine"),
        (("--outputs", "torque.gas", "--compression", "10"), "--bore: is missing"),
        (("--outputs", "torque.gas", "--compression", "10", "--bore", "8"), "give the highest order"),
        (("--outputs", "torque.total", "--compression", "10", "--bore", "8"), "--rpm: is missing"),
        (("--outputs", "torque.up"), "output 'torque.up': is unknown"),
        (("--outputs", "torque.frame", "--tolerance", "1e-3"), "no proven bound for torque.frame"),
    ],
)
def test_refusals(arguments: tuple[str, ...], words: str, capsys) -> None:
    assert run(["emit", "inline-4", "--target", "numpy", *arguments]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert words in err
    assert err.count("\n") == 1


def test_a_running_engine_has_its_own_ratio() -> None:
    with pytest.raises(SymbalanceError, match="is the running engine's own already"):
        sb.to_function(running(), ratio=3)


def test_what_lies_beyond_the_orders_looked_at_is_in_the_bound() -> None:
    """Near rho = 1 the orders above the first 48 show: without them the bound would be too small."""
    result = inertia_torque(sb.load("inline-1"), 1, ratio="1.04")
    made = sb.to_function(result, tolerance=7e-5)
    theta = np.linspace(0, np.pi, 4001)
    sine, cosine, lam = np.sin(theta), np.cos(theta), 1.04
    root = np.sqrt(lam**2 - sine**2)
    speed = sine * (1 + cosine / root)
    change = cosine + (cosine**2 - sine**2) / root + (sine * cosine) ** 2 / root**3
    gap = np.abs(made(theta) + speed * change).max()
    left = made.left_out["torque.inertia"]
    assert left is not None
    assert 0.5 * left < gap <= left <= 7e-5
