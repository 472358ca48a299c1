"""The figures, rows and files of a run against the curves they are taken from, invented here."""

from __future__ import annotations

import csv
import io
import json

import numpy as np
import pytest

from symbalance.crankshaft.reports.curves import curves_csv, loads_csv
from symbalance.crankshaft.reports.summary import Summary, summarise_run
from symbalance.crankshaft.running import RunConfiguration, configure_run
from symbalance.crankshaft.running.outcome import SpeedOutcome
from tests.cranks import engine, sheet
from tests.independent.test_fatigue import miner

SPEEDS = (1200.0, 1800.0, 2200.0)
STEPS = 48


@pytest.fixture(scope="module")
def run(tmp_path_factory) -> RunConfiguration:
    path = tmp_path_factory.mktemp("run")
    strength = "[running.strength]\ntensile = 800\nendurance = 300\nslope = 6\ncycles = 2e6\n"
    return configure_run(engine(path, sheet("[layout]\nfiring_order = [1]\n", strength)), webs="nominal")


def outcome(run: RunConfiguration, rpm: float, reason: str = "", **changed) -> SpeedOutcome:
    draw = np.random.default_rng(int(rpm))
    names = tuple(c.name for c in run.channels)
    units = tuple(c.unit for c in run.channels)
    theta = 4 * np.pi * np.arange(STEPS) / STEPS
    sizes = np.where([u == "Pa" for u in units], 60e6, 0.2)
    values = draw.normal(size=(STEPS, len(names))) * sizes + draw.normal(size=len(names)) * sizes
    values = {
        "rpm": rpm, "theta": theta, "names": names, "units": units, "values": values,
        "orbits": draw.normal(size=(STEPS, 2, 2)) * 5e-6,
        "bearings": draw.normal(size=(STEPS, 2, 2)) * 9e3,
        "clearance": np.array([3.5e-5, 3.5e-5]), "largest": 0.6, "error": 2e-3, "seconds": 0.25,
        "departure": 0.02, "reason": reason,
    }  # fmt: skip
    return SpeedOutcome(**{**values, **changed})


def summary(run: RunConfiguration, *outcomes: SpeedOutcome) -> Summary:
    return summarise_run(run, outcomes or [outcome(run, rpm) for rpm in SPEEDS])


def test_the_extremes_are_those_of_all_reliable_speeds(run):
    lost = outcome(run, 2600.0, "its films do not settle")
    result = summary(run, *(outcome(run, rpm) for rpm in SPEEDS), lost)
    assert [o.rpm for o in result.reliable] == list(SPEEDS)
    assert len(result.extremes) == len(run.channels)
    for k, extreme in enumerate(result.extremes):
        scale = 1e-6 if run.channels[k].unit == "Pa" else 1.0
        curves = np.array([o.values[:, k] * scale for o in result.reliable])
        assert (extreme.least, extreme.largest) == pytest.approx((curves.min(), curves.max()), rel=1e-12)
        at = int(np.abs(curves).max(axis=1).argmax())
        assert (extreme.name, extreme.rpm) == (run.channels[k].name, SPEEDS[at])
        assert extreme.unit == ("MPa" if scale != 1 else "degrees")
        wave = np.fft.rfft(curves[at]) / STEPS * 2
        wave[-1] /= 2
        strongest = sorted(range(1, len(wave)), key=lambda i: -abs(wave[i]))[:4]
        by_hand = [(i / 2, pytest.approx(abs(wave[i]))) for i in strongest]
        assert list(extreme.orders) == by_hand


def test_each_place_is_judged_at_its_worst_speed(run):
    result = summary(run)
    strength = run.engine.operation.strength
    assert (strength.tensile, strength.endurance) == (800e6, 300e6)
    names = [c.name for c in run.channels]
    assert [p.name for p in result.places] == [
        "pin 1",
        *(f"web {k} {end} fillet" for k in (1, 2) for end in ("pin", "journal")),
    ]
    for place in result.places:
        figures = []
        for one in result.outcomes:
            normal, shear = (
                one.values[:, names.index(f"{place.name} {x}")] for x in ("bending", "torsion")
            )
            swing, middle = (
                [(w.max() + sign * w.min()) / 2 for w in (normal, shear)] for sign in (-1, 1)
            )
            alternating, mean = (float(np.hypot(s, 3**0.5 * t)) for s, t in (swing, middle))
            mean = mean if middle[0] > 0 else 0.0
            figures.append((1 / (alternating / 300e6 + mean / 800e6), alternating, mean, one))
        safety, alternating, mean, one = min(figures, key=lambda row: row[0])
        assert place.rpm == one.rpm
        fatigue = place.durability
        assert (fatigue.safety, fatigue.amplitude, fatigue.mean) == pytest.approx(
            (safety, alternating, mean)
        )
        assert place.hours == pytest.approx(120 / one.rpm / fatigue.damage / 3600)
        normal, shear = (one.values[:, names.index(f"{place.name} {x}")] for x in ("bending", "torsion"))
        root = np.where(normal < 0, -1, 1) * np.hypot(normal, 3**0.5 * shear)
        angles = np.radians(np.arange(-90, 91, 7.5))
        waves = [root, *(normal * np.cos(a) + 3**0.5 * shear * np.sin(a) for a in angles)]
        assert fatigue.damage == pytest.approx(max(miner(w, strength) for w in waves), rel=1e-9)
    assert result.worst.durability.safety == min(p.durability.safety for p in result.places)
    assert f"{result.worst.durability.safety:.2f}, of {result.worst.name}" in result.summary()
    assert "at 1200, 1800, 2200 rpm" in result.summary()


def test_the_figures_of_each_speed(run):
    result = summary(run, outcome(run, 1200.0), outcome(run, 2600.0, "its films do not settle"))
    sound, lost = result.speeds
    one = result.outcomes[0]
    assert sound.bearing == pytest.approx(np.hypot(one.bearings[..., 0], one.bearings[..., 1]).max())
    farthest = np.hypot(one.orbits[..., 0], one.orbits[..., 1]).max() / 3.5e-5
    assert sound.eccentricity == pytest.approx(farthest)
    assert (sound.rpm, sound.departure, sound.largest, sound.error) == (1200.0, 0.02, 0.6, 2e-3)
    assert (sound.seconds, sound.steps, sound.reason) == (0.25, STEPS, None)
    assert (lost.rpm, lost.reason, lost.steps) == (2600.0, "its films do not settle", STEPS)
    assert np.isnan([lost.bearing, lost.largest]).all()
    frequencies = [f for f, _ in result.frequencies]
    assert frequencies == sorted(frequencies)
    assert frequencies[0] > 10


@pytest.mark.parametrize(
    ("changed", "valid", "said"),
    [
        ({}, True, ""),
        ({"largest": 1.0}, True, ""),
        ({"largest": 1.001}, False, "unstable, largest Floquet multiplier 1.001"),
        ({"error": 0.05}, True, ""),
        ({"error": 0.0501}, False, "halved steps change a stress by 5 % of the largest"),
        ({"error": float("nan")}, False, "by an unknown share of the largest"),
        ({"orbits": np.full((STEPS, 2, 2), 3e-5)}, False, "an orbit reaches 1.21 of its clearance"),
        ({"reason": "its films do not settle"}, False, ""),
    ],
    ids=str,
)
def test_what_makes_a_run_one_to_rely_on(run, changed, valid, said):
    calm = {"values": 0.2 * outcome(run, 1500.0).values}
    result = summary(run, outcome(run, 1500.0, **calm), outcome(run, 2000.0, **{**calm, **changed}))
    assert result.worst.durability.safety > 1
    assert result.valid == valid
    notes = "\n".join(note for note in result.notes if "2000 rpm" in note)
    assert said in notes
    assert not any(note.startswith("1500 rpm: unstable") for note in result.notes)
    assert bool(said) == ("unstable" in notes or "halved" in notes or "clearance" in notes)
    strained = {"values": 9 * outcome(run, 1500.0).values}
    assert not summary(run, outcome(run, 1500.0, **strained)).valid


def test_json_and_rows_hold_the_same_figures(run):
    result = summary(run)
    data = json.loads(json.dumps(result.data()))
    assert [s["rpm"] for s in data["speeds"]] == list(SPEEDS)
    assert data["webs"] == "nominal"
    assert [c["name"] for c in data["channels"]] == [c.name for c in run.channels]
    for row, extreme in zip(data["channels"], result.extremes, strict=True):
        assert (row["least"], row["largest"], row["rpm"]) == (extreme.least, extreme.largest, extreme.rpm)
        assert row["orders"] == [list(pair) for pair in extreme.orders]
    for row, place in zip(data["places"], result.places, strict=True):
        fatigue = place.durability
        assert (row["amplitude"], row["mean"]) == pytest.approx(
            (fatigue.amplitude / 1e6, fatigue.mean / 1e6)
        )
        assert (row["safety"], row["damage"]) == (fatigue.safety, fatigue.damage)
        assert row["hours"] == pytest.approx(place.hours)
    hertz = [f["hertz"] for f in data["natural_frequencies"]]
    assert hertz == [f for f, _ in result.frequencies]
    rows = result.records()
    assert len(rows) == len(SPEEDS) * len(run.channels)
    for row, (one, k) in zip(
        rows, ((o, k) for o in result.outcomes for k in range(len(run.channels))), strict=True
    ):
        scale = 1e-6 if run.channels[k].unit == "Pa" else 1.0
        assert (row["rpm"], row["channel"]) == (one.rpm, run.channels[k].name)
        ends = one.values[:, k].min() * scale, one.values[:, k].max() * scale
        assert (row["least"], row["largest"]) == pytest.approx(ends, rel=1e-12)
        assert row["unit"] == ("MPa" if scale != 1 else "degrees")


def test_curves_are_written_in_the_units_of_their_heads(run):
    one = outcome(run, 1800.0)
    head, *rows = csv.reader(io.StringIO(curves_csv(one)))
    table = np.array(rows, dtype=float)
    assert head[0] == "crank angle [degrees]"
    assert table[:, 0] == pytest.approx(np.arange(STEPS) * 15.0)
    columns = dict(zip(head, table.T, strict=True))
    for k, channel in enumerate(run.channels):
        unit, scale = ("MPa", 1e-6) if channel.unit == "Pa" else ("degrees", 1.0)
        assert columns[f"{channel.name} [{unit}]"] == pytest.approx(one.values[:, k] * scale, rel=1e-6)
    for j in range(2):
        for axis, word in enumerate(("vertical", "lateral")):
            force, place = columns[f"bearing {j + 1} {word} [N]"], columns[f"journal {j + 1} {word} [mm]"]
            assert force == pytest.approx(one.bearings[:, j, axis], rel=1e-6)
            assert place == pytest.approx(one.orbits[:, j, axis] * 1e3, rel=1e-6)
    lost = curves_csv(outcome(run, 1800.0, "its films do not settle")).splitlines()
    assert lost == ["# 1800 rpm: its films do not settle", ",".join(head)]


def test_the_rods_forces_are_written_by_pin(run):
    one = outcome(run, 1800.0)
    head, *rows = csv.reader(io.StringIO(loads_csv(one, run)))
    assert head == ["crank angle [degrees]", "pin 1 U [N]", "pin 1 V [N]"]
    table = np.array(rows, dtype=float)
    # at top dead centre of the exhaust stroke, 360 degrees: inertia upwards along the crank, little gas
    omega, radius, length = 1800 * np.pi / 30, 0.06, 0.192
    inertia = 1.5 * radius * omega**2 * (1 + radius / length)
    gas = -(3 - 1.01325) * 1e5 * np.pi / 4 * 0.092**2
    at = dict(zip(table[:, 0], table[:, 1:], strict=True))
    assert at[0.0][0] == pytest.approx(inertia + gas - 60e5 * np.pi / 4 * 0.092**2, rel=2e-3)
    assert at[0.0][1] == pytest.approx(0, abs=1e-6 * inertia)
    turned = run.rotor_loads(1800.0).pins.at(one.theta)[:, 0, :2]
    assert table[:, 1:] == pytest.approx(turned, rel=1e-6, abs=1e-2)


def test_the_default_strength_and_other_balance_masses_are_said(tmp_path):
    weights = "[[counterweight]]\nthrow = 1\noverbalance = 0.5\n"
    usual = configure_run(
        engine(tmp_path, sheet("[layout]\nfiring_order = [1]\n", weights)), webs="formula"
    )
    notes = summary(usual, outcome(usual, 1500.0)).notes
    assert any("take no part here" in note for note in notes)
    assert any(note.startswith("strength: default values") for note in notes)
    assert len(summary(usual, outcome(usual, 1500.0)).assumptions) == 2
    many = summary(usual, *(outcome(usual, 1000.0 + 100 * k) for k in range(5)))
    assert ", … (5 speeds) rpm" in many.summary()
    assert "…" not in summary(usual, *(outcome(usual, 1000.0 + 100 * k) for k in range(4))).summary()
    lost = summary(usual, outcome(usual, 1500.0, "its films do not settle"))
    assert (lost.extremes, lost.places, lost.valid) == ((), (), False)
    assert "no speed is to be relied on" in lost.summary()
