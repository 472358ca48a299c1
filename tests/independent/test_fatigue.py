"""Durability against another count of cycles, measured curves against differences known beforehand."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import symbalance as sb
from symbalance.crankshaft.files.operation import Overlay, Strength
from symbalance.crankshaft.running.measured import compare_with_measured, read_curve
from symbalance.crankshaft.running.outcome import SpeedOutcome
from symbalance.crankshaft.stress import durability
from symbalance.crankshaft.stress.fatigue import damage

STRENGTH = Strength(tensile=850e6, endurance=310e6, slope=5.5, cycles=3e6)
POINTS = 240


def reversals(wave: np.ndarray) -> list[float]:
    """Return the turning points of a closed history, from its largest value on."""
    closed = np.roll(wave, -int(np.argmax(wave)))
    after, before = np.roll(closed, -1), np.roll(closed, 1)
    return list(closed[(closed - before) * (after - closed) < 0])


def cycles(wave: np.ndarray) -> list[tuple[float, float]]:
    """Return (amplitude, mean) of every cycle of a closed history, the smallest range taken out first."""
    points, counted = reversals(wave), []
    while len(points) > 2:
        ranges = [abs(points[i] - points[i - 1]) for i in range(len(points))]
        i = int(np.argmin(ranges))
        counted.append((ranges[i] / 2, (points[i] + points[i - 1]) / 2))
        points = [p for k, p in enumerate(points) if k not in (i, (i - 1) % len(points))]
    if len(points) == 2:
        counted.append((abs(points[1] - points[0]) / 2, (points[1] + points[0]) / 2))
    return counted


def miner(wave: np.ndarray, strength: Strength) -> float:
    """Return the share of life of a closed history, each cycle on Goodman's line to zero mean."""
    shares = []
    for amplitude, mean in cycles(wave):
        alone = amplitude / (1 - mean / strength.tensile) if mean > 0 else amplitude
        shares.append((alone / strength.endurance) ** strength.slope / strength.cycles)
    return sum(shares)


def random_wave(draw: np.random.Generator, size: float, mean: float) -> np.ndarray:
    theta = 2 * np.pi * np.arange(POINTS) / POINTS
    parts = [draw.normal() / n**0.7 * np.cos(n * theta + draw.uniform(0, 7)) for n in range(1, 14)]
    wave = np.sum(parts, axis=0)
    return mean + size * wave / np.abs(wave).max()


@pytest.mark.parametrize("seed", range(6))
def test_damage_is_that_of_another_count_of_the_cycles(seed):
    draw = np.random.default_rng(seed)
    wave = random_wave(draw, 180e6, draw.uniform(-150e6, 250e6))
    assert len(cycles(wave)) > 3
    assert damage(wave, STRENGTH) == pytest.approx(miner(wave, STRENGTH), rel=1e-9)
    # where the cycle begins is the choice of who writes it down
    assert damage(np.roll(wave, 77), STRENGTH) == pytest.approx(damage(wave, STRENGTH), rel=1e-9)


def test_each_figure_of_the_strength_counts_as_woehlers_line_has_it():
    wave = random_wave(np.random.default_rng(3), 200e6, 90e6)
    once = damage(wave, STRENGTH)

    def changed(**sizes):
        return damage(wave, Strength(**{**vars(STRENGTH), **sizes})) / once

    assert changed(cycles=6e6) == pytest.approx(1 / 2)
    assert changed(endurance=2 * 310e6) == pytest.approx(2**-5.5)
    steeper, shares = changed(slope=7.5), [a / (1 - max(m, 0) / 850e6) / 310e6 for a, m in cycles(wave)]
    by_hand = sum(x**7.5 for x in shares) / sum(x**5.5 for x in shares)
    assert steeper == pytest.approx(by_hand)
    assert damage(2 * wave, Strength(2 * 850e6, 2 * 310e6, 5.5, 3e6)) == pytest.approx(once)


def test_a_mean_at_the_tensile_strength_breaks_at_once():
    small = 1e6 * np.cos(2 * np.pi * np.arange(POINTS) / POINTS)
    assert damage(STRENGTH.tensile + small, STRENGTH) == np.inf
    assert np.isfinite(damage(0.99 * STRENGTH.tensile + small, STRENGTH))
    pressed = damage(small - 2 * STRENGTH.tensile, STRENGTH)  # compression is no mean: it neither harms
    assert pressed == pytest.approx(damage(small, STRENGTH), rel=1e-9)  # nor helps


@pytest.mark.parametrize("seed", range(4))
def test_the_worst_direction_of_bending_and_torsion_is_nearly_the_worst_of_all(seed):
    draw = np.random.default_rng(seed + 20)
    normal = random_wave(draw, draw.uniform(20e6, 150e6), draw.uniform(-50e6, 90e6))
    shear = random_wave(draw, draw.uniform(20e6, 90e6), draw.uniform(-30e6, 30e6))
    root = np.sqrt(normal**2 + 3 * shear**2) * np.where(normal < 0, -1, 1)
    angles = np.radians(np.arange(-90, 90.1, 0.5))
    waves = [normal * np.cos(a) + 3**0.5 * shear * np.sin(a) for a in angles]
    everywhere = max(miner(wave, STRENGTH) for wave in [root, *waves])
    worst = durability(normal, shear, STRENGTH).damage
    assert 0.985 * everywhere < worst <= everywhere * (1 + 1e-9)


@pytest.mark.parametrize("seed", range(4))
def test_goodmans_line_of_the_equivalent_stress(seed):
    draw = np.random.default_rng(seed + 40)
    normal = random_wave(draw, 120e6, (-1) ** seed * 70e6)
    shear = random_wave(draw, 50e6, 45e6)
    swing = [(w.max() - w.min()) / 2 for w in (normal, shear)]
    middle = [(w.max() + w.min()) / 2 for w in (normal, shear)]
    amplitude, mean = (float(np.hypot(s, 3**0.5 * t)) for s, t in (swing, middle))
    mean = mean if middle[0] > 0 else 0.0
    fatigue = durability(normal, shear, STRENGTH)
    assert (fatigue.amplitude, fatigue.mean) == pytest.approx((amplitude, mean), rel=1e-12)
    assert amplitude / 310e6 + mean / 850e6 == pytest.approx(1 / fatigue.safety, rel=1e-12)
    assert (mean == 0) == (seed % 2 == 1)
    assert fatigue.hours(0.04) == pytest.approx(0.04 / fatigue.damage / 3600)


def test_nothing_at_all_lasts_for_ever():
    still = durability(np.zeros(POINTS), np.zeros(POINTS), STRENGTH)
    assert (still.amplitude, still.mean, still.damage) == (0, 0, 0)
    assert still.safety == still.hours(0.04) == np.inf


# A measured curve that is the computed one, scaled, shifted and raised, has a known error


def outcome(wave: np.ndarray, turns: int, rpm: float = 1500.0) -> SpeedOutcome:
    count = len(wave)
    theta, blank = 2 * np.pi * turns * np.arange(count) / count, np.zeros((count, 1, 2))
    columns = np.stack([np.full(count, 7e6), wave], axis=1)
    names, units = ("pin 1 torsion", "pin 1 bending"), ("Pa", "Pa")
    return SpeedOutcome(rpm, theta, names, units, columns, blank, blank, np.ones(1), 0.5, 0.0, 0.0)


def written(path: Path, degrees: np.ndarray, values: np.ndarray) -> Path:
    rows = [f"{a},{v!r}" for a, v in zip(degrees.tolist(), values.tolist(), strict=True)]
    path.write_text("\n".join(rows) + "\n", encoding="utf-8")
    return path


@pytest.mark.parametrize("turns", [1, 2])
@pytest.mark.parametrize(
    ("scale", "shift", "rise"),
    [(1, 0, 0), (1.3, 0, 0), (1, 25, 0), (1, 0, -9), (0.8, -40, 6), (-1, 0, 0)],
)
def test_a_curve_scaled_shifted_and_raised_shows_just_that(turns, scale, shift, rise, tmp_path):
    size, mean, order = 60.0, 11.0, 2
    computed = outcome(
        1e6 * (mean + size * np.cos(order * 2 * np.pi * turns * np.arange(1440) / 1440)), turns
    )
    degrees = np.arange(-360 * turns + 2, 360 * turns, 2.0)[: 360 * turns // 2]  # one cycle, from before
    values = mean + rise + scale * size * np.cos(order * np.radians(degrees - shift))
    overlay = Overlay(written(tmp_path / "curve.csv", degrees, values), "pin 1 bending", 1500.0)
    errors = compare_with_measured(overlay, computed)
    assert errors is not None
    between = 1 + scale**2 - 2 * scale * np.cos(order * np.radians(shift))
    assert errors.rms == pytest.approx(np.sqrt(size**2 / 2 * between + rise**2), rel=1e-4, abs=1e-3)
    top = mean + size - (mean + rise + abs(scale) * size)
    assert errors.peak == pytest.approx(top, abs=2e-3 * size)
    assert errors.span == pytest.approx(2 * abs(scale) * size, rel=2e-3)
    assert np.array_equal(errors.degrees, degrees)
    assert np.array_equal(errors.values, values)
    assert (errors.rpm, errors.channel) == (1500.0, "pin 1 bending")


def test_a_curve_belongs_to_its_own_speed_or_to_all(tmp_path):
    path = written(tmp_path / "curve.csv", np.arange(0, 720, 30.0), np.zeros(24))
    computed = outcome(1e6 * np.ones(720), 2)
    for rpm, belongs in ((None, True), (1500.0, True), (1500.1, False), (1499.9, False)):
        assert (compare_with_measured(Overlay(path, "pin 1 bending", rpm), computed) is None) != belongs


def test_eight_points_are_a_curve_and_seven_are_none(tmp_path):
    degrees = np.arange(8) * 90.0
    angles, values = read_curve(written(tmp_path / "eight.csv", degrees, degrees / 7))
    assert np.array_equal(angles, degrees)
    assert np.array_equal(values, degrees / 7)
    with pytest.raises(sb.SymbalanceError, match="holds 7 points"):
        read_curve(written(tmp_path / "seven.csv", degrees[:7], degrees[:7]))


@pytest.mark.parametrize(("cycle", "last"), [(720, 720.0), (360, 360.0)])
def test_angles_lie_within_a_cycle_of_zero(cycle, last, tmp_path):
    degrees = np.append(np.arange(7) * 45.0, last)
    for sign in (1, -1):
        assert (
            read_curve(written(tmp_path / "a.csv", sign * degrees, degrees), cycle)[0][-1] == sign * last
        )
        beyond = np.append(np.arange(7) * 45.0, last + 1)
        with pytest.raises(sb.SymbalanceError, match=f"-{cycle}, {cycle}"):
            read_curve(written(tmp_path / "b.csv", sign * beyond, degrees), cycle)
