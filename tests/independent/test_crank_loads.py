"""The loads on the crank pins against Newton and Euler, the library's torque and its free forces."""

from __future__ import annotations

import re
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from mpmath import mp

import symbalance as sb
from symbalance.crankshaft.assembly import assemble
from symbalance.crankshaft.files import read_running_engine
from symbalance.crankshaft.loads import big_end_masses, pin_loads
from symbalance.crankshaft.running import configure_run
from tests.cranks import WORKED, engine, sheet

OMEGA = 2200 * np.pi / 30
VEE = (
    "[layout]\nbanks = [-30, 30]\ncylinders = [[1, 3, 5], [2, 4, 6]]\nfiring_order = [1, 2, 3, 4, 5, 6]\n"
)
FLYING = "young = 206\nflying_web = 12"
ROD = "rod_mass = 1.6\nrod_centre = 60\nrod_inertia = 11000"


def newton_euler(p: float, force: float, sizes: dict[str, float]) -> complex:
    """Return the rigid rod's whole force on the crank pin, height + i lateral, from positions alone.

    Accelerations are finite differences of the positions in mpmath; the rod is one rigid body. Unknown
    are the forces at its two pins and the wall's.
    """
    r, length, offset = sizes["r"], sizes["l"], sizes["e"]

    def pin(t):
        return mp.mpc(r * mp.cos(t), r * mp.sin(t))

    def piston(t):
        return mp.mpc(pin(t).real + mp.sqrt(length**2 - (pin(t).imag - offset) ** 2), offset)

    def second(place, t):
        h = mp.mpf(10) ** -10
        return (place(t + h) - 2 * place(t) + place(t - h)) / h**2 * OMEGA**2

    def centre(t):
        return pin(t) + (piston(t) - pin(t)) * sizes["a"] / length

    def angle(t):
        rod = piston(t) - pin(t)
        return mp.atan2(rod.imag, rod.real)

    top = sizes["piston"] * second(piston, p).real - force  # the rod's push on the piston, along the axis
    rod = sizes["rod"] * second(centre, p)
    low_up = rod.real + top  # the crank's push on the rod, along the axis
    rotated = sizes["J"] * second(lambda t: mp.mpc(angle(t)), p).real
    low, high = pin(p) - centre(p), piston(p) - centre(p)
    # rod: F_low + F_high = rod, low x F_low + high x F_high = turned; F_high = -(top + i side)
    # low.real y - low.imag low_up + high.real (rod.imag - y) + high.imag top = turned
    y = (rotated + low.imag * low_up - high.real * rod.imag - high.imag * top) / (low.real - high.real)
    return -complex(low_up, y)


def test_the_pin_force_is_newtons_and_eulers(tmp_path):
    """With offset, rod inertia and gas: the rods' forces and the big end's mass make the whole."""
    text = sheet(big_end_mass=ROD).replace("rod = 192", "rod = 192\noffset = 7")
    made = engine(tmp_path, text)
    rod = sb.kinematics.RodSplit(Fraction("1.6"), Fraction(192), Fraction(60), Fraction(11000))
    sizes = {
        "r": 0.06,
        "l": 0.192,
        "e": 0.007,
        "a": 0.06,
        "rod": 1.6,
        "J": 0.011,
        "piston": 1.5 - float(rod.reciprocating),
    }
    loads = pin_loads(made, OMEGA)
    rotating = big_end_masses(made)[0] * 0.06 * OMEGA**2
    run = made.operation
    top = np.degrees(np.arcsin(0.007 / (0.192 + 0.06)))  # rod and crank in one line
    with mp.workdps(50):
        for degrees in (-350, -90, 3, 40, 100, 200, 333):
            p = mp.mpf(degrees) * mp.pi / 180
            gas = -(run.trace.at(degrees - top) - run.ambient) * 1e5 * run.area
            whole = newton_euler(p, gas, sizes)
            theta = np.array([float(p)])
            ours = loads.rods.own(1, theta)[0] + rotating * np.exp(1j * float(p))
            assert abs(ours - whole) < 1e-9 * abs(whole) + 1e-6


GAS = "compression = 16\nheat = 20\n"


@pytest.mark.parametrize("gas", ["", GAS])
def test_an_offset_engine_burns_at_its_pistons_tops(gas, tmp_path):
    """The pins of offset axes pass them before their pistons are at the top: torque counts from there."""
    text = sheet().replace("rod = 192", "rod = 192\noffset = 25")
    if gas:
        text = re.sub(r"pressure = .*\n", gas, text)
    made = engine(tmp_path, text)
    theta = np.linspace(0, 4 * np.pi, 97)
    trace = made.operation.ideal or made.operation.trace
    torque = sb.running_torque(made.engine, trace, bore=92, rpm=OMEGA * 30 / np.pi)
    expected = np.array([torque.gas(t) for t in theta])
    rods = replace(pin_loads(made, OMEGA).rods, parts=("gas",))
    assert np.abs(rods.torque(theta) - expected).max() < 1e-9 * np.abs(expected).max()


@pytest.mark.parametrize("name", ["inline-4.toml", "inline-6.toml"])
def test_the_torque_of_the_pin_forces_is_the_librarys(name):
    made = read_running_engine(WORKED / name)
    loads, theta = pin_loads(made, OMEGA), np.linspace(0, 4 * np.pi, 97)
    torque = sb.running_torque(made.engine, made.operation.trace, bore=92, rpm=2200)
    expected = np.array([torque.at(t) for t in theta])
    assert np.abs(loads.rods.torque(theta) - expected).max() < 1e-9 * np.abs(expected).max()
    assert loads.mean_torque == pytest.approx(torque.mean, rel=2e-4)


def test_the_torque_of_a_vee_with_offset_and_rods_is_virtual_work(tmp_path):
    """T omega = sum of F y' r omega less what the rods' own couples take: J_x phi'' phi' omega^3."""
    made = engine(
        tmp_path, sheet(VEE, big_end_mass=ROD, young=FLYING).replace("rod = 192", "rod = 192\noffset = 7")
    )
    check_virtual_work(made)


def test_link_rods_bear_on_the_crank_pin_through_the_master(tmp_path):
    """A master rod and two links: the crank's torque is the virtual work of all pistons."""
    text = sheet("", big_end_mass="big_end_mass = 0") + "".join(
        f"[[cylinder]]\nnumber = {n}\nthrow = 0\nbank = {bank}\nfires = {fires}\n{link}"
        for n, bank, fires, link in (
            (1, 0, 0, ""),
            (2, 60, 420, "master = 1\nlink_angle = 58\nlink_radius = 50\nrod = 140\n"),
            (3, -75, 285, "master = 1\nlink_angle = -75\nlink_radius = 48\nrod = 144\n"),
        )
    )
    made = engine(tmp_path, text)
    assert [pin.cylinders for pin in made.crank.pins] == [(1, 2, 3)]
    check_virtual_work(made)
    check_virtual_work(replace(made, operation=replace(made.operation, excess=-0.0015)))


def check_virtual_work(made):
    loads, theta = pin_loads(made, OMEGA), np.linspace(0, 4 * np.pi, 181)
    radius = made.crank.pins[0].radius
    total = np.zeros_like(theta)
    for cylinder in made.engine.cylinders:
        moved = loads.rods._motion(cylinder.number, theta)
        total += loads.rods.axial(cylinder.number, theta) * moved.speed * radius
        total -= made.operation.excess * OMEGA**2 * moved.angle_acceleration * moved.angle_rate
    assert np.abs(loads.rods.torque(theta) - total).max() < 1e-11 * np.abs(total).max()


def test_bearings_walls_and_heads_together_get_the_free_force(tmp_path):
    """What the frame gets from rods, walls and gas is `balance`'s free force, order by order."""
    made = engine(tmp_path, sheet(VEE, young=FLYING))
    loads, theta = pin_loads(made, OMEGA), np.linspace(0, 4 * np.pi, 61)
    frame = np.zeros(len(theta), complex)
    for cylinder in made.engine.cylinders:
        number, bank = cylinder.number, 2 * np.pi * float(cylinder.bank.turns)
        gas = -pin_loads(made, OMEGA, "gas").rods.axial(number, theta)
        own = loads.rods.own(number, theta) + 1j * loads.rods.side_thrust(number, theta) + gas
        frame += own * np.exp(1j * bank)
    free = sb.to_function(sb.balance(made.engine, 40), outputs=("force.vertical", "force.lateral"))
    expected = free(theta, mass=1.5, radius=0.06, omega=OMEGA)
    whole = expected["force.vertical"] + 1j * expected["force.lateral"]
    unit = 1.5 * 0.06 * OMEGA**2
    assert np.abs(frame - whole).max() < 1e-9 * unit


def test_the_bearings_carry_the_pins_and_the_centrifugal_forces_together():
    made = configure_run(read_running_engine(WORKED / "inline-4.toml"), webs="nominal")
    theta = np.linspace(0, 4 * np.pi, 25)
    carried = made.bearing_loads(2200, theta).sum(axis=1)
    force = made.rotor_loads(2200).at(theta)
    sums = np.stack([force[:, 0::6].sum(axis=1), force[:, 1::6].sum(axis=1)], axis=-1)
    turn = np.exp(1j * theta)
    given = (sums[:, 0] + 1j * sums[:, 1]) * turn
    assert np.abs(carried[:, 0] + 1j * carried[:, 1] - given).max() < 1e-7 * np.abs(given).max()


def test_the_big_ends_are_counted_once(tmp_path):
    """Their mass is the rotor's, with F_M = m r along the throw; the pin loads know nothing of it."""
    light, heavy = (engine(tmp_path, sheet(big_end_mass=f"big_end_mass = {m}")) for m in (0, 2.5))
    theta = np.linspace(0, 4 * np.pi, 9)
    assert np.array_equal(pin_loads(light, OMEGA).at(theta), pin_loads(heavy, OMEGA).at(theta))
    rotors = [assemble(e.crank, pin_masses=big_end_masses(e)) for e in (light, heavy)]
    more = (rotors[1].centrifugal_force - rotors[0].centrifugal_force).reshape(-1, 6)
    pin = rotors[1].pins[0]
    assert more[pin, :3] == pytest.approx([2.5 * 0.06, 0, 0], abs=1e-12)
    assert np.abs(np.delete(more, pin, axis=0)).max() == 0
    assert (rotors[1].mass - rotors[0].mass)[6 * pin, 6 * pin] == pytest.approx(2.5)


def test_inertia_harmonics_are_the_mechanisms_exact_ones(tmp_path):
    """Of a pin load's spectrum: the axial force's orders are those of `force_harmonics`."""
    made = engine(tmp_path, sheet())
    rods = pin_loads(made, OMEGA, "inertia").rods
    theta = 4 * np.pi * np.arange(2048) / 2048
    spectrum = np.fft.rfft(rods.axial(1, theta)) / len(theta)
    unit = 1.5 * 0.06 * OMEGA**2
    for order, (cosine, sine) in sb.kinematics.force_harmonics(
        sb.kinematics.SliderCrank(Fraction("3.2")), 8
    ).items():
        assert spectrum[2 * order] * 2 / unit == pytest.approx(complex(cosine, -sine), abs=1e-12)


def test_the_harmonics_rebuild_the_loads(tmp_path):
    loads = pin_loads(engine(tmp_path, sheet()), OMEGA)
    theta = np.linspace(0.1, 12, 7)
    found = loads.harmonics(400)
    orders = np.arange(len(found)) / 2
    waves = np.exp(1j * orders * theta[:, None]) * np.where(orders > 0, 2, 1)
    rebuilt = np.einsum("sk,kpd->spd", waves, found).real
    assert np.abs(rebuilt - loads.at(theta)).max() < 2e-4 * np.abs(loads.at(theta)).max()


def test_rods_side_by_side_turn_their_pin(tmp_path):
    """Half a rod's width beside the middle: the moment of each force about the pin's middle."""
    layout = "[layout]\nbanks = [-30, 30]\ncylinders = [[1], [2]]\nfiring_order = [1, 2]\n"
    layout += 'firing_intervals = [420, 300]\nstagger = ["1/10", "-1/10"]\n'
    made = engine(tmp_path, sheet(layout).replace("rod = 192", "rod = 192\npitch = 110"))
    loads, theta = pin_loads(made, OMEGA), np.array([0.3])
    assert [pin.cylinders for pin in made.crank.pins] == [(1, 2)]
    assert loads.shifts == pytest.approx({1: -0.011, 2: 0.011})
    forces = [loads.rods.at(n, theta)[0] for n in (1, 2)]
    moment = 0.011 * (forces[1] - forces[0])
    assert loads.at(theta)[0, 0, 3:5] == pytest.approx([-moment.imag, moment.real])


def test_a_rod_given_to_the_crank_train_is_the_same_rod(tmp_path):
    here = engine(tmp_path, sheet(big_end_mass=ROD)).operation
    there = sheet(big_end_mass="").replace("rod = 192", "rod = 192\n" + ROD)
    assert engine(tmp_path, there).operation == here
    assert here.excess != 0
