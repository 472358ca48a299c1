"""What turns with a crank, summed by hand; sections, bases and outcomes by their definitions."""

from __future__ import annotations

from dataclasses import fields, replace

import numpy as np
import pytest
from scipy.linalg import eigh

import symbalance as sb
from symbalance.crankshaft.assembly import assemble
from symbalance.crankshaft.crank import Crank, Disc, Journal, Pin, Web, WebCounterweight
from symbalance.crankshaft.reduction import lowest_modes, projected, reduce_system
from symbalance.crankshaft.rotor.beams import circular, rectangular
from symbalance.crankshaft.rotor.parts import Material
from symbalance.crankshaft.running.outcome import (
    SpeedOutcome,
    decode_outcome,
    encode_outcome,
    harmonic_content,
)
from symbalance.crankshaft.webs.sector import sector_counterweight
from tests.cranks import engine, sheet

TWO = "[layout]\nfiring_order = [1, 2]\nfiring_intervals = [180, 540]\n"
WEIGHTS = """
[[crankshaft.counterweight]]
webs = [1, 4]
mass = 1.2
radius = 55
inertia = 900
angle = 20
[[crankshaft.counterweight]]
webs = [2]
mass = 0.7
radius = 48
"""


def rigid_sums(crank: Crank) -> tuple[np.ndarray, np.ndarray]:
    """Return the rigid-body mass matrix (6, 6) about the origin, and the centrifugal force and couple."""
    rotor = assemble(crank)
    rigid = rotor.rigid_motions()
    return rigid.T @ rotor.mass @ rigid, rigid.T @ rotor.centrifugal_force


def body_sums(mass, place, about) -> tuple[np.ndarray, np.ndarray]:
    """Return the same of a body with the inertia tensor `about` its centre, by definition."""
    u, v, w = place
    moments = mass * np.array([[0, w, -v], [-w, 0, u], [v, -u, 0]])
    tensor = mass * (np.dot(place, place) * np.eye(3) - np.outer(place, place)) + about
    pull = mass * np.array([u, v, 0])
    # of each of its points: w x (x x w) at its own height, whose couple holds the products of inertia
    couple = np.array([-w * pull[1] + about[1, 2], w * pull[0] - about[0, 2], 0])
    return np.block([[mass * np.eye(3), moments], [moments.T, tensor]]), np.concatenate([pull, couple])


def test_counterweights_of_a_file_pull_away_from_their_pins(tmp_path):
    """By web and angle: m r at the pin's angle + 180 degrees + their own, at the web's middle."""
    bare, heavy = (engine(tmp_path, sheet(TWO, *more)).crank for more in ((), (WEIGHTS,)))
    angles = [pin.angle for pin in bare.pins]
    assert np.cos(angles[1] - angles[0]) == pytest.approx(-1)
    stations = [(start + stop) / 2 for part, start, stop in bare.stations() if isinstance(part, Web)]
    before, after = rigid_sums(bare), rigid_sums(heavy)
    expected = [np.zeros((6, 6)), np.zeros(6)]
    rows = ((1, 0, 1.2, 0.055, 900e-6, 20), (4, 1, 1.2, 0.055, 900e-6, 20), (2, 0, 0.7, 0.048, 0, 0))
    for web, pin, mass, radius, inertia, angle in rows:
        turn = angles[pin] + np.pi + np.radians(angle)
        place = np.array([radius * np.cos(turn), radius * np.sin(turn), stations[web - 1]])
        flat = mass * 0.024**2 / 12
        about = np.diag([inertia / 2 + flat, inertia / 2 + flat, inertia])
        expected = [a + b for a, b in zip(expected, body_sums(mass, place, about), strict=True)]
    for old, new, added in zip(before, after, expected, strict=True):
        assert new - old == pytest.approx(added, rel=1e-9, abs=1e-9)


def test_a_drawn_sector_balances_its_own_throw_and_lies_opposite_the_pin():
    """A sector that takes all of a throw's unbalance leaves none; turned half round it doubles it."""
    material, angle = Material(), 0.9
    web = Web(0.02, 0.07, 0.035, 0.035)
    pin = Pin(0.05, 0.03, 0.04, angle, (1,))
    weight = sector_counterweight(web, angle, 0.04, 0.09, 1.1, material)
    throw = (Journal(0.06, 0.03), web, pin, web, Journal(0.06, 0.03))
    bare = rigid_sums(Crank(throw))[1]
    out = np.array([np.cos(angle), np.sin(angle)])
    assert bare[:2] @ out > 0
    share = bare[:2] @ out / 2 / (weight.mass * weight.radius)
    fitted = replace(weight, mass=weight.mass * share, inertia=weight.inertia * share)
    held = replace(web, counterweight=fitted)
    balanced = rigid_sums(Crank((throw[0], held, pin, held, throw[4])))[1]
    assert np.abs(balanced).max() < 1e-9 * np.abs(bare).max()
    wrong = replace(web, counterweight=replace(fitted, angle=fitted.angle + np.pi))
    doubled = rigid_sums(Crank((throw[0], wrong, pin, wrong, throw[4])))[1]
    assert doubled[:2] == pytest.approx(2 * bare[:2], rel=1e-9)


def test_a_sector_is_what_lies_outside_the_web():
    """Points over both: mass, centre and inertia of those in the sector and not in the web."""
    web, reach, outer, half = Web(0.02, 0.07, 0.035, 0.03), 0.04, 0.085, 1.2
    weight = sector_counterweight(web, 0.3, reach, outer, half, Material(density=7000.0))
    step = 2.5e-4
    u, v = np.meshgrid(np.arange(-0.09, 0.09, step) + step / 2, np.arange(-0.09, 0.09, step) + step / 2)
    inside = (np.hypot(u, v) < outer) & (np.abs(np.arctan2(v, -u)) < half)
    corner = min(web.width / 2, web.heel)
    a, b = np.maximum(-u - (web.heel - corner), 0), np.maximum(np.abs(v) - (web.width / 2 - corner), 0)
    within = (np.abs(v) < web.width / 2) & (u > -web.heel) & ((a == 0) | (np.hypot(a, b) < corner))
    spots = inside & ~within
    area, centre = spots.sum() * step**2, u[spots].mean()
    assert weight.mass == pytest.approx(7000 * 0.02 * area, rel=2e-3)
    assert weight.radius == pytest.approx(-centre, rel=2e-3)
    around = ((u[spots] - centre) ** 2 + v[spots] ** 2).sum() * step**2
    assert weight.inertia == pytest.approx(7000 * 0.02 * around, rel=4e-3)
    assert np.exp(1j * weight.angle) == pytest.approx(-np.exp(0.3j))
    assert (weight.outer, weight.half_angle) == (outer, half)
    # its inertia is divided along and across its own middle as its points are
    held = replace(web, counterweight=weight)
    pin, journal = Pin(0.04, 0.03, reach, 0.3, (1,)), Journal(0.05, 0.03)
    crank = Crank((journal, held, pin, web, journal), Material(density=7000.0))
    bare = Crank((journal, web, pin, web, journal), Material(density=7000.0))
    added = (rigid_sums(crank)[0] - rigid_sums(bare)[0])[3:, 3:]
    turn = np.array([[np.cos(0.3), -np.sin(0.3), 0], [np.sin(0.3), np.cos(0.3), 0], [0, 0, 1]])
    own = turn.T @ added @ turn
    density, middle = 7000 * 0.02, 0.03 + 0.01
    along, across = ((x[spots] ** 2).sum() * step**2 * density for x in (u, v))
    through = weight.mass * (0.02**2 / 12 + middle**2)
    assert own[0, 0] == pytest.approx(across + through, rel=3e-3)
    assert own[1, 1] == pytest.approx(along + through, rel=3e-3)
    assert own[2, 2] == pytest.approx(along + across, rel=3e-3)
    assert own[0, 2] == pytest.approx(-weight.mass * -weight.radius * middle, rel=3e-3)


def test_discs_and_big_ends_stand_where_they_are_named():
    throw = (Journal(0.06, 0.03), Web(0.02, 0.08, 0.04, 0.04), Pin(0.05, 0.03, 0.04, 0.7, (1,)))
    crank = Crank((*throw, throw[1], throw[0]))
    bare = rigid_sums(crank)
    pulley, flywheel = Disc(3.0, 0.02, 0.013, 0.05, 0.03), Disc(20.0, 0.4, 0.22)
    with_discs = rigid_sums(replace(crank, pulley=pulley, flywheel=flywheel))
    shaft = Material().density * np.pi / 4 * 0.03**2 * 0.05
    bodies = [
        (3.0, (0, 0, -0.05), np.diag([0.013, 0.013, 0.02])),
        (20.0, (0, 0, crank.length), np.diag([0.22, 0.22, 0.4])),
        (shaft, (0, 0, -0.025), shaft * np.diag([0.05**2 / 12 + 0.015**2 / 4] * 2 + [0.015**2 / 2])),
    ]
    sums = [body_sums(m, np.array(p, float), about) for m, p, about in bodies]
    assert with_discs[0] - bare[0] == pytest.approx(sum(s[0] for s in sums), rel=1e-9, abs=1e-10)
    assert with_discs[1] == pytest.approx(bare[1], abs=1e-12)


# Sections, by integrals over them


@pytest.mark.parametrize("bore", [0.0, 0.02, 0.04])
def test_a_round_section_by_its_integrals(bore):
    section, nu = circular(0.06, bore, 0.29), 0.29
    radii = np.linspace(bore / 2, 0.03, 20001)
    area, square = (np.trapezoid(2 * np.pi * radii * radii**k, radii) for k in (0, 2))
    assert (section.area, section.torsion) == pytest.approx((area, square), rel=1e-7)
    assert (section.bend_y, section.bend_z) == pytest.approx((square / 2, square / 2), rel=1e-7)
    # Cowper's two ends: the full circle and the thin tube
    assert circular(1, 0, nu).shear_y / circular(1, 0, nu).area == pytest.approx(6 * 1.29 / (7 + 6 * nu))
    thin = circular(1, 1 - 1e-9, nu)
    assert thin.shear_z / thin.area == pytest.approx(2 * 1.29 / (4 + 3 * nu), rel=1e-6)
    assert circular(0.06, bore, nu).shear_y == circular(0.06, bore, nu).shear_z


@pytest.mark.parametrize(("height", "depth"), [(0.08, 0.02), (0.02, 0.08), (0.03, 0.03), (0.05, 0.03)])
def test_a_rectangle_by_its_integrals_and_saint_venants_series(height, depth):
    section = rectangular(height, depth, 0.29)
    assert section.area == pytest.approx(height * depth)
    y, z = np.linspace(-height / 2, height / 2, 2001), np.linspace(-depth / 2, depth / 2, 2001)
    assert section.bend_z == pytest.approx(np.trapezoid(y**2, y) * depth, rel=1e-5)
    assert section.bend_y == pytest.approx(np.trapezoid(z**2, z) * height, rel=1e-5)
    a, b = max(height, depth), min(height, depth)
    odd = np.arange(1, 60, 2)
    series = (np.tanh(odd * np.pi * a / (2 * b)) / odd**5).sum()
    exact = a * b**3 / 3 * (1 - 192 / np.pi**5 * b / a * series)
    assert section.torsion == pytest.approx(exact, rel=3e-3)
    assert section.shear_y == section.shear_z == pytest.approx(12.9 / (12 + 11 * 0.29) * height * depth)


# Bases


def random_matrices(size: int, seed: int) -> tuple[np.ndarray, np.ndarray]:
    draw = np.random.default_rng(seed).normal(size=(2, size, size))
    mass, stiffness = draw[0] @ draw[0].T + np.eye(size), draw[1] @ draw[1].T
    return mass, stiffness


def test_the_lowest_modes_are_the_eigenvectors():
    mass, stiffness = random_matrices(9, 1)
    shapes, (values, vectors) = lowest_modes(stiffness, mass, 4), eigh(stiffness, mass)
    assert shapes.T @ mass @ shapes == pytest.approx(np.eye(4), abs=1e-12)
    assert np.diag(shapes.T @ stiffness @ shapes) == pytest.approx(values[:4])
    assert np.abs(shapes.T @ mass @ vectors[:, :4]) == pytest.approx(np.eye(4), abs=1e-9)
    assert (shapes[np.abs(shapes).argmax(axis=0), np.arange(4)] > 0).all()


def test_a_basis_is_orthonormal_in_the_mass_and_spans_what_it_was_given(tmp_path):
    from symbalance.crankshaft.running import configure_run
    from tests.independent.test_crank_stress import constant_film

    run = configure_run(engine(tmp_path, sheet()), webs="nominal")
    system = run.system(2000, constant_film(2, 3e8, 4e4))
    draw = np.random.default_rng(3)
    first = draw.normal(size=(system.size, 3))
    second = np.column_stack([first @ [1, 2, -1], draw.normal(size=(system.size, 2)), first[:, 0]])
    second[:, 0] += 1e-4 * draw.normal(size=system.size)  # nearly dependent, and new all the same
    small, basis = projected(system, [first, second])
    assert basis.shape[1] == 6  # three, two, the nearly dependent one; not the repeated one
    assert basis.T @ system.mass @ basis == pytest.approx(np.eye(6), abs=1e-11)
    for column in (*first.T, *second.T):
        rest = column - basis @ (basis.T @ system.mass @ column)
        assert np.abs(rest).max() < 1e-9 * np.abs(column).max()
    assert small.mass == pytest.approx(np.eye(6), abs=1e-11)
    for name in ("stiffness", "damping"):
        matrix = getattr(system, name)
        assert getattr(small, name) == pytest.approx(basis.T @ matrix @ basis, rel=1e-9)
    theta = np.linspace(0, 4, 5)
    assert small.force(theta) == pytest.approx(system.force(theta) @ basis, rel=1e-9)
    assert small.points == pytest.approx(system.points @ basis)
    whole, basis = reduce_system(system, system.size)
    assert basis.shape == (system.size, system.size)
    with_loads, basis = reduce_system(system, 4)
    modes = lowest_modes((system.stiffness + system.stiffness.T) / 2, system.mass, 4)
    assert np.abs(modes - basis @ (basis.T @ system.mass @ modes)).max() < 1e-9 * np.abs(modes).max()
    bare = reduce_system(system, 4, attachments=False)[1]
    assert (bare.shape[1], whole.size > with_loads.size > 4) == (4, True)


# Outcomes


def outcome(reason: str = "") -> SpeedOutcome:
    theta = 4 * np.pi * np.arange(48) / 48
    draw = np.random.default_rng(9)
    return SpeedOutcome(
        1800.5, theta, ("pin 1 bending", "twist 1"), ("Pa", "degrees"), draw.normal(size=(48, 2)),
        draw.normal(size=(48, 3, 2)) * 1e-5, draw.normal(size=(48, 3, 2)), np.array([3e-5, 4e-5, 5e-5]),
        0.25, 1e-3, 0.5, 0.01, reason,
    )  # fmt: skip


@pytest.mark.parametrize("reason", ["", "the films do not settle"])
def test_a_saved_speed_comes_back_as_it_was(reason):
    saved = decode_outcome(encode_outcome(outcome(reason)))
    for field in fields(SpeedOutcome):
        old, new = getattr(outcome(reason), field.name), getattr(saved, field.name)
        assert type(old) is type(new), field.name
        assert np.array_equal(old, new), field.name


def test_the_figures_of_an_outcome_are_its_curves():
    one = outcome()
    assert (one.steps, one.cycle) == (48, pytest.approx(4 * np.pi))
    assert one.cycle_time == pytest.approx(2 * 60 / 1800.5)
    assert one.degrees == pytest.approx(np.arange(48) * 15)
    farthest = [max(np.hypot(*x) for x in one.orbits[:, j]) / c for j, c in enumerate(one.clearance)]
    assert one.eccentricity == pytest.approx(farthest)
    assert one.within_clearance == (max(farthest) < 1)
    assert not replace(one, orbits=one.orbits / one.eccentricity.max()).within_clearance
    orders, sizes = one.orders("twist 1")
    assert orders == pytest.approx(np.arange(25) / 2)
    for order, size in zip(orders, sizes, strict=True):
        wave = np.exp(-1j * order * one.theta)
        twice = 1 if order in (0, 12) else 2
        assert size == pytest.approx(twice * abs((one.channel("twist 1") * wave).mean()), abs=1e-12)
    odd = harmonic_content(np.cos(2 * np.pi * np.arange(7) * 3 / 7), 2 * np.pi)[1]
    assert odd == pytest.approx([0, 0, 0, 1], abs=1e-12)


def test_an_unbalance_draws_the_ellipse_its_parts_say():
    """On unlike springs: the largest radius along the orbit, its circles' sizes and phases."""
    from symbalance.crankshaft.rotor.shafts import Tube, shaft
    from symbalance.crankshaft.rotor.stationary import Support
    from symbalance.crankshaft.rotor.unbalance import unbalance_response

    rotor = shaft([Tube(0.8, 0.04)], {0.3: Disc(9.0, 0.05, 0.03)}, (0.0, 0.8), Material(density=1e-6))
    supports = [Support((4e6, 2e6), damping=300.0), Support((5e6, 1.5e6), damping=500.0)]
    amount = 2e-4 * np.exp(0.6j)
    response = unbalance_response(rotor, supports, {0.3: amount}, [180.0, 420.0])
    assert (np.abs(response.backward) > 1e-9).any()
    turn = np.exp(1j * np.linspace(0, 2 * np.pi, 2000))
    for s, speed in enumerate((180.0, 420.0)):
        for n in range(len(rotor.points)):
            x, y = ((z[s, n] * turn).real for z in (response.vertical, response.lateral))
            assert np.hypot(x, y).max() == pytest.approx(response.largest[s, n], rel=1e-4)
            whole = response.forward[s, n] * turn + (response.backward[s, n] * turn).conj()
            assert whole.real == pytest.approx(x, abs=1e-12)
            row = response.records()[s * len(rotor.points) + n]
            assert row["rpm"] == pytest.approx(speed * 30 / np.pi)
            assert row["place"] == rotor.points[n, 2]
            assert row["largest"] == response.largest[s, n]
            for part in ("forward", "backward"):
                circle = row[part] * np.exp(1j * np.radians(row[f"{part}_phase"]))
                assert circle == pytest.approx(getattr(response, part)[s, n], abs=1e-15)
        # Newton: the shaft weighs nothing, so the supports bear what disc and unbalance pull
        disc = int(np.argmin(np.abs(rotor.points[:, 2] - 0.3)))
        for axis, moved, put in ((0, response.vertical, amount), (1, response.lateral, -1j * amount)):
            pull = speed**2 * (put + 9.0 * moved[s, disc])
            assert response.forces[s, :, axis].sum() == pytest.approx(pull, rel=1e-5)
    size, (at, node) = (
        response.largest.max(),
        np.unravel_index(response.largest.argmax(), response.largest.shape),
    )
    assert f"largest orbit {size * 1e6:.4g} µm at {rotor.points[node, 2]:.4g} m" in response.summary()
    assert f"{(180.0, 420.0)[at] * 30 / np.pi:.6g} rpm" in response.summary()


def test_a_web_between_pins_takes_no_side():
    """A flying web with a weight straight out balances nothing of the wrong throw."""
    journal, web = Journal(0.06, 0.03), Web(0.02, 0.08, 0.04, 0.04)
    pins = [Pin(0.05, 0.03, 0.03, angle, (k,)) for k, angle in ((1, 0.2), (2, 2.2))]
    weight = WebCounterweight(0.8, 0.05, 1.2, 4e-4)
    held = replace(web, counterweight=weight)
    chains = [Crank((journal, web, pins[0], mid, pins[1], web, journal)) for mid in (web, held)]
    before, after = map(rigid_sums, chains)
    height = 0.03 + 0.02 + 0.03 + 0.01
    place = np.array([0.05 * np.cos(1.2), 0.05 * np.sin(1.2), height])
    flat = 0.8 * 0.02**2 / 12
    about = np.diag([2e-4 + flat, 2e-4 + flat, 4e-4])
    for old, new, added in zip(before, after, body_sums(0.8, place, about), strict=True):
        assert new - old == pytest.approx(added, rel=1e-9, abs=1e-10)


def test_a_bare_material_has_the_shear_modulus_of_its_two_others():
    assert Material(210e9, 0.25).shear == pytest.approx(84e9)
    assert sb.crankshaft.Material is Material
