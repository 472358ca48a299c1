"""Cranks of every shape from file to stress, and the whole of a run against laws of its own."""

from __future__ import annotations

import json
import re
from dataclasses import replace

import numpy as np
import pytest

import symbalance as sb
from symbalance.cli import run
from symbalance.crankshaft.loads import pin_loads
from symbalance.crankshaft.reduction import reduce_system
from symbalance.crankshaft.running import configure_run
from symbalance.crankshaft.running.about_orbit import system_about_orbit
from symbalance.crankshaft.steady import steady_state
from symbalance.engine.catalogue import preset_text
from tests.cranks import BEARINGS, CRANKSHAFT, RUNNING, TRAIN, engine, sheet, written
from tests.independent.test_crank_stress import constant_film

QUICK = ("--webs", "nominal", "--steps", "120", "--about", "centre", "--modes", "20", "--format", "json")
FLYING = CRANKSHAFT.replace("young = 206", "young = 206\nflying_web = 12")
STIFF = CRANKSHAFT.replace("young = 206", "young = 2e6")


def running_preset(name: str, crankshaft: str = FLYING) -> str:
    """Return a preset with sizes: its layout is its own, all else the tests'."""
    layout = re.sub(r"(?ms)^\[crank_train\].*?(?=^\[)", "", preset_text(name))
    return layout + TRAIN + crankshaft + BEARINGS + RUNNING


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "pins", "journals"),
    [
        ("v6-60", [(1,), (2,), (3,), (4,), (5,), (6,)], 4),  # split pins: flying webs
        ("boxer-4", [(1,), (2,), (3,), (4,)], 5),
        ("v8-90", [(1, 2), (3, 4), (5, 6), (7, 8)], 5),  # cross-plane, two rods a pin
        ("radial-5", [(1, 2, 3, 4, 5)], 2),
    ],
)
def test_cranks_of_every_shape_run_from_file_to_stress(name, pins, journals, tmp_path, capsys):
    path = written(tmp_path, running_preset(name))
    made = engine(tmp_path, path.read_text(encoding="utf-8"))
    assert [pin.cylinders for pin in made.crank.pins] == pins
    assert len(made.bearings.clearance) == journals
    out = tmp_path / "out"
    assert run(["crankshaft", str(path), *QUICK, "--no-plots", "-o", str(out)]) in (0, 1)
    found = json.loads(capsys.readouterr().out)
    bending = [c for c in found["channels"] if re.fullmatch(r"pin \d+ bending", c["name"])]
    assert len(bending) == len(pins)
    assert all(1 < c["largest"] - c["least"] < 1000 for c in bending)
    assert found["speeds"][0]["largest"] < 1


@pytest.mark.slow
def test_a_preset_has_no_sizes_and_says_so(capsys):
    assert run(["crankshaft", "inline-4"]) == 2
    err = capsys.readouterr().err
    assert len(err.splitlines()) == 1
    assert "inline-4: is a preset" in err
    assert "[crankshaft], [bearings] and [running]" in err


def test_slow_and_stiff_is_statics(tmp_path):
    """One throw at 100 rpm on stiff springs, with a heavy wheel: a simply supported beam, by hand.

    The rod's force from the trace and plain trigonometry, stress from F L/4; weight is below a percent.
    """
    wheel = "[crankshaft.flywheel]\nmass = 1\npolar = 1e9\n"
    made = configure_run(engine(tmp_path, sheet().replace(CRANKSHAFT, STIFF + wheel)), webs="nominal")
    found = steady_state(made.system(100, constant_film(2, 1e12, 1e6)), steps=360, multipliers=False)
    values = dict(zip([c.name for c in made.channels], (found.position @ made.stress.T).T, strict=True))
    trace = made.engine.operation.trace
    after = (np.degrees(found.theta) + 360) % 720 - 360
    gas = np.array([(trace.at(x) - 1.01325) * 1e5 for x in after]) * np.pi * 0.092**2 / 4
    rod = np.arcsin(np.sin(found.theta) * 60 / 192)
    radial, across = -gas * np.cos(found.theta + rod) / np.cos(rod), gas * np.sin(found.theta + rod)
    across = across / np.cos(rod)
    length, modulus = 0.030 + 2 * 0.024 + 0.032, np.pi * 0.055**3 / 32
    bending = -radial * length / 4 / modulus
    sideways = across * length / 4 / modulus
    peak = np.abs(bending).max()
    assert np.abs(values["pin 1 bending"] - bending).max() < 0.01 * peak
    assert np.abs(values["pin 1 sideways"] - sideways).max() < 0.01 * peak


@pytest.mark.slow
def test_bearings_with_walls_and_heads_pass_on_the_librarys_free_force(tmp_path):
    """A stiff in-line four at 2200 rpm: what its run leaves on the frame is `balance`, order by order."""
    text = sheet("[layout]\nfiring_order = [1, 3, 4, 2]\n").replace(CRANKSHAFT, STIFF)
    made = configure_run(engine(tmp_path, text), webs="nominal")
    found = steady_state(made.system(2200, constant_film(5, 1e12, 1e7)), steps=720, multipliers=False)
    theta, omega = found.theta, 2200 * np.pi / 30
    rods = pin_loads(made.engine, omega).rods
    gas = pin_loads(made.engine, omega, "gas").rods
    frame = -found.bearing.sum(axis=1) @ [1, 1j]
    for number in (1, 2, 3, 4):
        frame = frame - gas.axial(number, theta) + 1j * rods.side_thrust(number, theta)
    free = sb.to_function(sb.balance(made.engine.engine, 20), outputs=("force.vertical",))
    expected = free(theta, mass=1.5, radius=0.06, omega=omega)
    weight = 9.80665 * made.rotor.mass[0::6, 0::6].sum()
    unit = 1.5 * 0.06 * omega**2
    assert np.abs(expected).max() > unit
    assert np.abs(frame + weight - expected).max() < 0.01 * unit


@pytest.mark.slow
def test_what_the_pins_take_up_the_films_and_the_driveline_give_away(tmp_path):
    """Energy over a cycle: the gas's p dV is the mean torque's work, and a run creates none."""
    made = configure_run(engine(tmp_path, sheet()), webs="nominal")
    system = made.system(1500, constant_film(2, 3e8, 5e4))
    found = steady_state(system, steps=1440, multipliers=False)
    step = system.cycle / 1440 / system.omega
    rotated = np.einsum("sij,sbi->sbj", _rotation(found.theta), found.bearing)
    borne = np.einsum("bin,sbi->sn", system.points, rotated)
    put_in = ((system.force(found.theta) + borne) * found.velocity).sum() * step
    symmetric = (system.damping + system.damping.T) / 2
    lost = np.einsum("sn,nm,sm->", found.velocity, symmetric, found.velocity) * step
    scale = np.abs(system.force(found.theta) * found.velocity).sum() * step
    assert lost > 1e-3 * scale
    assert put_in == pytest.approx(lost, abs=1e-4 * scale)


def test_the_mean_torque_is_the_gass_work_over_a_cycle(tmp_path):
    made = engine(tmp_path, sheet())
    degrees = np.linspace(-360, 360, 72_001)
    theta = np.radians(degrees)
    height = 0.06 * np.cos(theta) + np.sqrt(0.192**2 - (0.06 * np.sin(theta)) ** 2)
    pressure = np.array([made.operation.trace.at(x) for x in degrees]) * 1e5
    volume = -height * np.pi * 0.092**2 / 4
    work = ((pressure[1:] + pressure[:-1]) / 2 * np.diff(volume)).sum()
    for omega in (10.0, 300.0):
        assert pin_loads(made, omega).mean_torque * 4 * np.pi == pytest.approx(work, rel=2e-4)


def test_solved_webs_with_their_bodies_leave_the_throws_statics_alone(tmp_path):
    """A slow run, the web's heel and weight on a node of their own: section loads stay the pin's."""
    from symbalance.crankshaft.assembly import assemble
    from symbalance.crankshaft.solid.reference import reference_four
    from symbalance.crankshaft.stress import channels, stress_matrix

    crank = replace(reference_four(weighted=True), flywheel=None, pulley=None)
    found = []
    for webs in ("nominal", "solid"):
        rotor = assemble(crank, webs=webs)
        held = [6 * rotor.journals[0] + i for i in (0, 1, 2, 5)]
        held += [6 * rotor.journals[-1] + i for i in (0, 1)]
        free = np.setdiff1d(np.arange(rotor.size), held)
        force, moved = np.zeros(rotor.size), np.zeros(rotor.size)
        force[6 * rotor.pins[1]] = -1e4
        moved[free] = np.linalg.solve(rotor.stiffness[np.ix_(free, free)], force[free])
        made = channels(crank, rotor)
        values = stress_matrix(made) @ moved
        found.append({c.name: v for c, v in zip(made, values, strict=True) if c.unit == "Pa"})
    plain, solid = found
    most = max(abs(v) for v in plain.values())
    assert len(rotor.points) > len(assemble(crank, webs="nominal").points)
    for name, value in plain.items():
        assert solid[name] == pytest.approx(value, abs=1e-6 * most)


def _rotation(theta):
    from symbalance.crankshaft.frames import rotation

    return rotation(theta)


@pytest.mark.slow
def test_a_long_cranks_modes_are_a_reduction(tmp_path):
    """Loads about the orbits of six bearings have more shapes than a short crank's."""
    made = configure_run(
        engine(tmp_path, sheet("[layout]\nfiring_order = [1, 2, 4, 5, 3]\n")), webs="nominal"
    )
    orbits = made.orbits(2200)
    full = made.system(2200, orbits.film)
    small, basis = reduce_system(system_about_orbit(full, made.rotor, orbits).system, 15)
    assert basis.shape[1] < 0.5 * basis.shape[0]
    assert np.allclose(small.mass, np.eye(len(small.mass)), atol=1e-9)
    theta = np.linspace(0, full.cycle, 7)
    asked = np.linalg.solve(full.stiffness + 1e8 * _springs(full), full.force(theta).T)
    there = basis @ (basis.T @ full.mass @ asked)
    assert np.abs(there - asked).max() < 0.02 * np.abs(asked).max()


def _springs(full):
    flat = full.points.reshape(-1, full.size)
    return flat.T @ flat
