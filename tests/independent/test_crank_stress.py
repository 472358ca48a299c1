"""Stresses against hand calculations and other routes; fatigue, orders, the whole linear chain."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from symbalance.crankshaft.assembly import assemble
from symbalance.crankshaft.crank import Crank, Journal, Pin, Web
from symbalance.crankshaft.files import read_running_engine
from symbalance.crankshaft.files.operation import Overlay, Strength
from symbalance.crankshaft.frames import rotation, turned_stiffness
from symbalance.crankshaft.running import configure_run
from symbalance.crankshaft.running.measured import compare_with_measured
from symbalance.crankshaft.running.outcome import SpeedOutcome
from symbalance.crankshaft.running.speed_sweep import run_speed
from symbalance.crankshaft.steady import steady_state
from symbalance.crankshaft.stress import channels, durability, fillet_factors, stress_matrix
from symbalance.crankshaft.stress.fatigue import damage
from symbalance.crankshaft.system import Film
from tests.cranks import WORKED, engine, sheet

ANGLE = 0.7
WEB = Web(0.02, 0.08, 0.04, 0.04)
JOURNAL, PIN = Journal(0.06, 0.03, fillet=0.003), Pin(0.05, 0.03, 0.04, ANGLE, (1,), fillet=0.003)
THROW = Crank((JOURNAL, WEB, PIN, WEB, JOURNAL))
OUT = np.array([np.cos(ANGLE), np.sin(ANGLE)])


def stressed(crank: Crank, loads: dict[int, float], held: list[int] | None = None) -> dict[str, float]:
    """Return the channels of a throw on two bearings, the front's w and turn held, under loads."""
    rotor = assemble(crank)
    front, rear = rotor.journals[0], rotor.journals[-1]
    fixed = [6 * front, 6 * front + 1, 6 * rear, 6 * rear + 1, 6 * front + 2, 6 * front + 5]
    free = [i for i in range(rotor.size) if i not in fixed]
    force, moved = np.zeros(rotor.size), np.zeros(rotor.size)
    for unknown, value in loads.items():
        force[unknown] = value
    moved[free] = np.linalg.solve(rotor.stiffness[np.ix_(free, free)], force[free])
    found = channels(crank, rotor)
    return dict(zip([c.name for c in found], stress_matrix(found) @ moved, strict=True))


def test_a_throw_on_two_bearings_under_a_load_on_its_pin_is_a_beam():
    """F L/4 at the pin, F/2 times the arm at the webs; opening is positive."""
    load, pin = 10e3, 6 * assemble(THROW).pins[0]
    found = stressed(THROW, {pin: -load * OUT[0], pin + 1: -load * OUT[1]})
    length, modulus = 0.03 + 2 * 0.02 + 0.03, np.pi * 0.05**3 / 32
    assert found["pin 1 bending"] == pytest.approx(load * length / 4 / modulus, rel=1e-9)
    assert found["pin 1 sideways"] == pytest.approx(0, abs=1)
    assert found["pin 1 torsion"] == pytest.approx(0, abs=1)
    factors = fillet_factors(JOURNAL, WEB, PIN)
    bent, pressed = load / 2 * (0.015 + 0.01) * 6 / (0.08 * 0.02**2), -load / 2 / (0.08 * 0.02)
    expected = -factors.journal_bending * bent + factors.journal_pressure * pressed
    for web in (1, 2):
        assert found[f"web {web} pin fillet bending"] == pytest.approx(
            factors.pin_bending * bent, rel=1e-9
        )
        assert found[f"web {web} journal fillet bending"] == pytest.approx(expected, rel=1e-9)


def test_a_load_across_the_throw_bends_the_leading_line_and_twists_the_pin():
    """A tangential load: the held front bears its torque."""
    load, pin = 8e3, 6 * assemble(THROW).pins[0]
    found = stressed(THROW, {pin: -load * -OUT[1], pin + 1: -load * OUT[0]})
    modulus = np.pi * 0.05**3 / 32
    assert found["pin 1 bending"] == pytest.approx(0, abs=1)
    assert found["pin 1 sideways"] == pytest.approx(-load * 0.1 / 4 / modulus, rel=1e-9)
    # load * radius passes the front web; at the pin's axis the bearing's reaction takes half off
    torque = load * 0.04 - load / 2 * 0.04
    assert found["pin 1 torsion"] == pytest.approx(torque / (2 * modulus), rel=1e-9)


def test_a_torque_through_the_crank_is_the_same_in_every_pin_and_journal():
    rotor = assemble(THROW)
    found = stressed(THROW, {6 * (len(rotor.points) - 1) + 5: -100.0})
    factors = fillet_factors(JOURNAL, WEB, PIN)
    at_pin, at_journal = (100 * 16 / (np.pi * d**3) for d in (0.05, 0.06))
    assert found["pin 1 torsion"] == pytest.approx(at_pin, rel=1e-9)
    for web in (1, 2):
        assert found[f"web {web} pin fillet torsion"] == pytest.approx(
            at_pin * factors.pin_torsion, rel=1e-9
        )
        torsion = at_journal * factors.journal_torsion
        assert found[f"web {web} journal fillet torsion"] == pytest.approx(torsion, rel=1e-6)


def test_bending_does_not_depend_on_the_webs_stiffness():
    """The throw is statically determinate: how the webs are modelled moves no nominal stress."""
    pin = 6 * assemble(THROW).pins[0]
    stiff = replace(THROW, material=replace(THROW.material, young=9e11))
    soft, hard = (stressed(crank, {pin: -1e4, pin + 1: 3e3}) for crank in (THROW, stiff))
    assert soft.keys() == hard.keys()
    for name in soft:
        if not name.startswith("twist"):
            assert soft[name] == pytest.approx(hard[name], rel=1e-6, abs=1e2)


def test_modes_times_amplitudes_are_the_stress():
    """Psi a: the stress modes of any basis give the stress of the displacements it stands for."""
    made = configure_run(read_running_engine(WORKED / "inline-4.toml"), webs="nominal")
    draw = np.random.default_rng(7)
    basis, amounts = draw.normal(size=(made.rotor.size, 5)), draw.normal(size=5)
    whole = made.stress @ (basis @ amounts)
    assert (made.stress @ basis) @ amounts == pytest.approx(
        whole, rel=1e-9, abs=1e-3 * np.abs(whole).max()
    )


def test_fillet_factors_fall_with_the_radius_and_say_when_they_are_extrapolated():
    values = [fillet_factors(JOURNAL, WEB, replace(PIN, fillet=r)) for r in (0.002, 0.003, 0.005)]
    assert [v.outside for v in values] == [(), (), ()]
    assert values[0].pin_bending > values[1].pin_bending > values[2].pin_bending > 1
    assert values[0].pin_torsion > values[2].pin_torsion > 1
    sharp = fillet_factors(JOURNAL, WEB, replace(PIN, fillet=0.0005))
    assert sharp.outside == ("r = 0.01",)
    assert sharp.pin_bending == fillet_factors(JOURNAL, WEB, replace(PIN, fillet=0.0015)).pin_bending


def test_the_journal_fillet_counts_over_the_journal_diameter_in_torsion():
    """Annex 5-3: beta_T = alpha_T with r = R_G/D_G, so a thicker journal's fillet is the sharper one."""
    alike = fillet_factors(replace(JOURNAL, diameter=PIN.diameter, fillet=PIN.fillet), WEB, PIN)
    assert alike.journal_torsion == alike.pin_torsion
    thick = replace(JOURNAL, diameter=1.2 * PIN.diameter, fillet=1.2 * PIN.fillet)
    scaled = fillet_factors(thick, WEB, PIN)
    assert scaled.journal_torsion == scaled.pin_torsion
    sharper = fillet_factors(replace(thick, fillet=PIN.fillet), WEB, PIN)
    overlap = (PIN.diameter + thick.diameter) / 2 - PIN.radius
    exponent = -0.322 + 0.1015 * (1 - overlap / PIN.diameter)
    assert sharper.journal_torsion == pytest.approx(scaled.pin_torsion * 1.2**-exponent, rel=1e-12)


def test_only_pressure_sees_an_overlap_below_the_least():
    """Annex 5-3 replaces s < -0.5 in f(s, w) and f(r, s) alone; f_Q(s) is a parabola in 1 - s."""
    lengths = [PIN.diameter / 2 + JOURNAL.diameter / 2 + x * PIN.diameter for x in (0.5, 0.7)]
    at, below = (fillet_factors(JOURNAL, WEB, replace(PIN, radius=radius)) for radius in lengths)
    assert below.outside == ("s = -0.7",)
    for name in ("pin_bending", "pin_torsion", "journal_bending", "journal_torsion"):
        assert getattr(below, name) == pytest.approx(getattr(at, name), rel=1e-12)
    parabola = [0.4368 + 2.1630 * x - 1.5212 * x * x for x in (1.5, 1.7)]
    assert below.journal_pressure / at.journal_pressure == pytest.approx(
        parabola[1] / parabola[0], rel=1e-9
    )


def test_goodman_and_rainflow_by_hand():
    strength = Strength(tensile=900e6, endurance=300e6, slope=6, cycles=1e6)
    theta = np.arange(720) * np.pi / 180
    wave = 90e6 + 120e6 * np.cos(theta)
    found = durability(wave, np.zeros(720), strength)
    assert (found.amplitude, found.mean) == pytest.approx((120e6, 90e6))
    assert found.safety == pytest.approx(1 / (120 / 300 + 90 / 900))
    # two turns a cycle: two equal cycles of amplitude 120 about 90
    assert found.damage == pytest.approx(2 * (120 / (1 - 0.1) / 300) ** 6 / 1e6, rel=1e-9)
    shear = durability(np.zeros(720), 40e6 * np.cos(theta), strength)
    assert shear.safety == pytest.approx(300 / (40 * np.sqrt(3)))
    assert found.hours(0.05) == pytest.approx(0.05 / found.damage / 3600)
    # a small wave upon a large one: one cycle of the whole range, one small inner one
    blocks = np.array([0, 200e6, 120e6, 160e6, -200e6, 0])
    inner = 20e6 / (1 - 140 / 900)
    by_hand = (200 / 300) ** 6 + (inner / 300e6) ** 6
    assert damage(blocks, strength) == pytest.approx(by_hand / 1e6, rel=1e-9)
    assert damage(np.array([0.0, 2000e6]), strength) == np.inf


def test_torsion_counts_with_its_whole_swing():
    strength = Strength(900e6, 400e6, 8.0, 2e6)
    wave = np.cos(np.arange(720) * np.pi / 360)
    pure = (np.sqrt(3) * 100 / 400) ** 8 / 2e6
    for bending in (0.0, 1e3, -1e3):  # a bending of no account must not fold the torsion
        assert durability(bending + 0 * wave, 100e6 * wave, strength).damage == pytest.approx(
            pure, rel=1e-3
        )
    both = durability(90e6 * wave, 70e6 * wave, strength)  # proportional: von Mises
    by_hand = (np.sqrt(90**2 + 3 * 70**2) / 400) ** 8 / 2e6
    assert both.damage == pytest.approx(by_hand, rel=0.02)
    assert both.damage <= by_hand * (1 + 1e-12)


def test_a_pair_of_torsion_and_bending_is_von_mises():
    theta = np.arange(360) * np.pi / 180
    found = durability(100e6 * np.cos(theta), 50e6 * np.cos(theta), Strength())
    assert found.amplitude == pytest.approx(np.sqrt(100**2 + 3 * 50**2) * 1e6, rel=1e-6)


def constant_film(count: int, stiffness: float, damping: float) -> Film:
    springs, dampers = (np.tile(x * np.eye(2), (count, 1, 1)) for x in (stiffness, damping))

    def spread(matrices: np.ndarray, theta: np.ndarray) -> np.ndarray:
        return np.broadcast_to(matrices, (len(theta), *matrices.shape))

    return Film(lambda theta: spread(springs, theta), lambda theta: spread(dampers, theta))


def test_on_equal_constant_springs_the_motion_is_a_sum_of_harmonics(tmp_path):
    """The whole chain against another solver: isotropic bearings make the turning equations constant."""
    made = configure_run(engine(tmp_path, sheet()), webs="nominal")
    springs, dampers = 4e8, 6e4
    system = made.system(2200, constant_film(2, springs, dampers))
    found = steady_state(system, steps=720, multipliers=False)
    points, theta = system.points, found.theta
    turning = turned_stiffness(springs * np.eye(2), dampers * np.eye(2), 0.0, system.omega)
    stiffness = system.stiffness + np.einsum("bin,ij,bjm->nm", points, turning, points)
    damping = system.damping + dampers * np.einsum("bin,bim->nm", points, points)
    spectrum = np.fft.rfft(system.force(theta), axis=0)
    rates = 1j * system.omega / 2 * np.arange(len(spectrum))
    waves = [
        np.linalg.solve(s * s * system.mass + s * damping + stiffness, f)
        for s, f in zip(rates, spectrum, strict=True)
    ]
    other = np.fft.irfft(np.array(waves), n=len(theta), axis=0)
    ours, theirs = found.position @ made.stress.T, other @ made.stress.T
    assert np.abs(ours - theirs).max(axis=0) == pytest.approx(0, abs=2e-3 * np.abs(theirs).max())
    # a third route to the bearing forces: what is left of Newton's law of the whole crank, U and V
    turn = rotation(theta)
    carried = np.einsum("sij,sbi->sj", turn, found.bearing)
    motions = made.rotor.rigid_motions()[:, :2]
    speeds, bent = np.fft.irfft(rates[:, None] * np.array(waves), n=720, axis=0), other
    faster = np.fft.irfft(rates[:, None] ** 2 * np.array(waves), n=720, axis=0)
    inertia = faster @ system.mass.T + speeds @ system.damping.T + bent @ system.stiffness.T
    missing = (inertia - system.force(theta)) @ motions
    assert carried == pytest.approx(missing, abs=5e-3 * np.abs(missing).max())


@pytest.mark.slow
def test_films_about_the_orbit_carry_the_nonlinear_films_own_force(tmp_path):
    """After some passes the journals go where the short bearing itself carries what they bear."""
    from symbalance.crankshaft.bearings.short_film import film_states
    from symbalance.crankshaft.running.oil_films import periodic_spline, plain_bearings

    made = configure_run(engine(tmp_path, sheet()), webs="nominal", steps=360)
    once, found = run_speed(replace(made, iterations=1), 1500), run_speed(made, 1500)
    assert found.departure < 0.05 < once.departure
    assert found.within_clearance
    bearings, omega = plain_bearings(made.engine), 1500 * np.pi / 30
    velocity = omega * periodic_spline(found.theta, found.orbits, found.cycle)(found.theta, 1)
    strength = np.array([b.strength for b in bearings])
    film = film_states(strength, found.clearance, found.orbits, velocity, omega)
    off = np.abs(film.force - found.bearings).max(axis=(0, 2)) / np.abs(found.bearings).max(axis=(0, 2))
    assert off.max() < 0.05


@pytest.mark.slow
def test_the_mean_torque_leaves_through_the_flywheel():
    """The mean torsion of the last journal is the engine's mean torque, of the first none."""
    made = configure_run(
        read_running_engine(WORKED / "inline-4.toml"), webs="nominal", steps=240, iterations=1
    )
    found = run_speed(made, 2200)
    torque = made.rotor_loads(2200).pins.mean_torque
    journal, web, pin = made.engine.crank.parts[:3]
    assert isinstance(journal, Journal)
    assert isinstance(web, Web)
    assert isinstance(pin, Pin)
    factors = fillet_factors(journal, web, pin)
    section = np.pi * 0.065**3 / 16
    last = found.channel("web 8 journal fillet torsion").mean() / factors.journal_torsion * section
    first = found.channel("web 1 journal fillet torsion").mean() / factors.journal_torsion * section
    assert last == pytest.approx(torque, rel=0.01)
    assert abs(first) < 0.01 * torque


def test_the_error_of_a_measured_curve(tmp_path):
    theta = 4 * np.pi * np.arange(720) / 720
    wave = 50e6 * np.cos(theta)
    blank = np.zeros((720, 1, 2))
    found = SpeedOutcome(
        1000.0, theta, ("pin 1 bending",), ("Pa",), wave[:, None], blank, blank, np.ones(1), 0.5, 0.0, 0.0
    )
    path = tmp_path / "measured.csv"
    rows = [f"{a};{50 * np.cos(np.radians(a)) - 2:.6f}" for a in range(-360, 360, 10)]
    path.write_text("angle;MPa\n" + "\n".join(rows), encoding="utf-8")
    shown = compare_with_measured(Overlay(path, "pin 1 bending", None), found)
    assert shown is not None
    assert (shown.rms, shown.peak, shown.span) == pytest.approx((2.0, 2.0, 100.0), rel=1e-5)
    assert compare_with_measured(Overlay(path, "pin 1 bending", 1200.0), found) is None
