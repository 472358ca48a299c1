"""The crank as beams, bodies and web elements: against textbooks, published rotors and a meshed solid."""

import importlib.util
import json
import sys
from dataclasses import replace
from math import pi
from unittest.mock import MagicMock

import numpy as np
import pytest

import symbalance as sb
from symbalance.crankshaft.assembly import WEBS, assemble
from symbalance.crankshaft.crank import Crank, Disc, Journal, Material, Pin, Web, WebCounterweight
from symbalance.crankshaft.geometry_checks import check_geometry
from symbalance.crankshaft.rotor.beams import Beam, circular, element, flexibility, rectangular, transfer
from symbalance.crankshaft.rotor.campbell_diagram import campbell
from symbalance.crankshaft.rotor.modes import assurance, dominant_motions, motion_shares, natural_modes
from symbalance.crankshaft.rotor.shafts import Tube, bearing_springs, shaft
from symbalance.crankshaft.rotor.torsion import crank_torsional_chain, torsional_chain
from symbalance.crankshaft.solid import store as store_module
from symbalance.crankshaft.solid.reference import SIZES, reference, reference_four
from symbalance.crankshaft.solid.store import WebStore, open_store, solid_web, solve_missing
from symbalance.crankshaft.webs.arm import arms
from symbalance.crankshaft.webs.beam_webs import ker_wilson_torsion, nominal_flexibility
from symbalance.crankshaft.webs.fitted import fitted_flexibility, fitted_parameters
from symbalance.crankshaft.webs.sector import sector_counterweight
from symbalance.errors import MissingPartError, SymbalanceError
from tests import ROOT

SOLID = ROOT / "derivations" / "crankshaft" / "solid_four.json"
STEEL = Material(211e9, 211 / 162.4 - 1, 7810)  # Friswell's: E = 211, G = 81.2 GPa
MESHER = importlib.util.find_spec("gmsh") and importlib.util.find_spec("skfem")


def lateral(rotor, count):
    """The frequencies, in rad/s, of a rotor's bending in the U-W plane."""
    modes = natural_modes(rotor, count)
    flat = motion_shares(rotor, modes)
    return 2 * pi * modes.frequencies[flat[:, 0] > 0.5], modes


def simple_crank(throws=1, angles=None, **pin):
    web = Web(0.022, 0.09, 0.04, 0.042)
    journal = Journal(0.06, 0.03, fillet=0.003)
    angles = angles or [2 * pi * k / 3 for k in range(throws)]
    parts = [journal]
    for number, angle in enumerate(angles, 1):
        sizes = {"diameter": 0.05, "length": 0.03, "radius": 0.045, **pin}
        parts += [web, Pin(**sizes, angle=angle, cylinders=(number,)), web, journal]
    return Crank(tuple(parts))


# Beams


def test_slender_free_beam_has_the_textbook_wave_numbers():
    diameter, length = 0.002, 1.0
    rotor = shaft([Tube(length, diameter, elements=24)], material=STEEL)
    modes = natural_modes(rotor, 6)
    area, bend = pi * diameter**2 / 4, pi * diameter**4 / 64
    slow = np.sqrt(STEEL.young * bend / (STEEL.density * area))
    waves = np.sqrt(2 * pi * modes.frequencies / slow) * length
    assert waves == pytest.approx(np.repeat([4.730041, 7.853205, 10.995608], 2), rel=3e-5)


@pytest.mark.slow
@pytest.mark.parametrize(("diameter", "rate"), [(0.1, 2.0), (0.001, 4.0)])
def test_free_beams_converge_to_timoshenkos_equation(diameter, rate):
    """Against the exact beam's frequency determinant: fourth order where slender, second where stocky.

    An element's shear force is constant along it: that is what decides where shear matters.
    """
    exact = timoshenko_free(circular(diameter, 0.0, STEEL.poisson), STEEL, 0.5)
    errors = []
    for elements in (4, 8, 16):
        modes = natural_modes(shaft([Tube(0.5, diameter, elements=elements)], material=STEEL), 2)
        errors.append(2 * pi * modes.frequencies[0] / exact - 1)
    assert np.log2(np.array(errors[:-1]) / errors[1:]) == pytest.approx([rate, rate], abs=0.3)
    assert abs(errors[-1]) < 1e-3


def timoshenko_free(section, material, length):
    """The lowest angular frequency at which the end loads' matrix of the exact beam is singular."""
    from scipy.linalg import expm
    from scipy.optimize import brentq

    ei, gas = material.young * section.bend_y, material.shear * section.shear_y
    mass, turn = material.density * section.area, material.density * section.bend_y
    slender = 22.373285 * np.sqrt(ei / mass) / length**2

    def determinant(omega):
        # w' = phi + V/GAs, phi' = M/EI, V' = -m omega^2 w, M' = -V - rho I omega^2 phi
        system = np.zeros((4, 4))
        system[0, 1], system[0, 2], system[1, 3] = 1, 1 / gas, 1 / ei
        system[2, 0], system[3, 1], system[3, 2] = -mass * omega**2, -turn * omega**2, -1
        scale = np.diag([1, 1, length**2 / ei, length**2 / ei])
        matrix = expm(scale @ system @ np.linalg.inv(scale) * length)
        return np.linalg.det(matrix[2:, :2])

    return brentq(determinant, 0.5 * slender, 1.1 * slender, xtol=1e-9 * slender, rtol=1e-12)


def test_cantilever_under_all_six_loads():
    section = rectangular(0.03, 0.05, 0.3)
    material, length = Material(200e9, 0.3, 7800), 0.7
    own = flexibility(section, material, length, np.eye(3))
    e, g = material.young, material.shear
    assert own[0, 0] == pytest.approx(length / (e * 0.03 * 0.05))
    assert own[1, 1] == pytest.approx(
        length**3 / (3 * e * 0.05 * 0.03**3 / 12) + length / (g * section.shear_y)
    )
    assert own[2, 2] == pytest.approx(
        length**3 / (3 * e * 0.03 * 0.05**3 / 12) + length / (g * section.shear_z)
    )
    assert own[1, 5] > 0 > own[2, 4]


def test_an_element_in_any_direction_is_the_turned_one():
    rng = np.random.default_rng(3)
    axes = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    axes *= np.linalg.det(axes)
    section = circular(0.05, 0.02, 0.3)
    straight = Beam(section, STEEL, 0.2, np.eye(3)).stiffness
    turn = np.kron(np.eye(4), axes)
    assert Beam(section, STEEL, 0.2, axes).stiffness == pytest.approx(
        turn.T @ straight @ turn, rel=1e-9, abs=1
    )


def test_an_element_gives_no_force_under_rigid_motion_and_its_flexibility_back():
    lever = np.array([0.03, -0.02, 0.05])
    rng = np.random.default_rng(5)
    root = rng.normal(size=(6, 6))
    flexible = root @ root.T + np.eye(6)
    stiffness = element(flexible, lever)
    rigid = np.vstack([np.eye(6), transfer(lever)])
    assert np.abs(stiffness @ rigid).max() < 1e-12
    assert np.linalg.inv(stiffness[6:, 6:]) == pytest.approx(flexible)


# Published rotors


def friswell_disc(diameter):
    mass = 7810 * pi / 4 * (diameter**2 - 0.05**2) * 0.07
    polar = mass * (diameter**2 + 0.05**2) / 8
    return Disc(mass, polar, polar / 2 + mass * 0.07**2 / 12)


TWO_DISCS = ({0.5: friswell_disc(0.28), 1.0: friswell_disc(0.35)}, (0.0, 1.5), 1e6)
OVERHUNG = ({1.5: friswell_disc(0.35)}, (0.0, 1.0), 1e7)


@pytest.mark.spread(2)
@pytest.mark.parametrize(
    ("rotor", "rpm", "expected"),
    [
        (TWO_DISCS, 0, [86.66, 86.66, 274.31, 274.31, 716.78, 716.78]),
        (TWO_DISCS, 4000, [85.39, 87.80, 251.78, 294.71, 600.18, 827.08]),
        (OVERHUNG, 0, [90.14, 90.14, 630.73, 630.73, 830.43, 830.43]),
        (OVERHUNG, 4000, [76.19, 103.91, 565.99, 634.23, 647.75, 1174.2]),
    ],
)
def test_whirl_speeds_of_friswells_rotors(rotor, rpm, expected):
    """Friswell, Penny, Garvey, Lees, Dynamics of Rotating Machines, examples 5.9.1 and 5.9.9, rad/s."""
    discs, bearings, stiffness = rotor
    model = shaft([Tube(1.5, 0.05, elements=6)], discs, bearings, STEEL)
    support = bearing_springs(model, stiffness, axial=1e12)
    lines = campbell(model, [0.0, rpm * pi / 60, rpm * pi / 30] if rpm else [0.0], support, count=10)
    found = np.abs(lines.stationary[-1][lines.lateral[-1]])
    assert np.sort(found)[:6] == pytest.approx(expected, rel=1e-4)
    assert np.abs(lines.growth).max() < 1e-3


def test_a_rigid_free_rotor_stands_still_in_space():
    """In turning axes its shift and tilt turn backward with the speed, and do not grow."""
    rotor = shaft([Tube(0.3, 0.1, elements=2)], material=STEEL)
    lines = campbell(rotor, [0.0, 50.0, 100.0], count=4)
    assert np.abs(lines.growth).max() < 1e-2


def test_torsional_chain_of_friswell():
    chain = torsional_chain([3.5e-3, 3.5e-3, 3.5e-3, 0.15, 0.05], [12e3, 12e3, 14e3, 10e3])
    assert chain.frequencies() == pytest.approx([81.21, 141.21, 378.95, 536.36], abs=0.006)


def test_torsional_chain_of_the_cbr600rr():
    inertias = [1.99e-5, 1.6958e-3, 2.1595e-3, 1.8157e-3, 1.2602e-3, 1.54e-5]
    springs = np.array([3014, 2562, 2430, 2636, 2562]) * 180 / pi  # N m per degree
    found = torsional_chain(inertias, [*springs]).frequencies()
    assert found[:2] == pytest.approx([1168.9076, 2084.5654], abs=6e-4)


def test_torsional_modes_are_orthogonal_and_carry_no_momentum():
    chain = torsional_chain([1.0, 2.0, 3.0], [5.0, 7.0])
    shapes = chain.modes()[1]
    assert shapes.T @ np.diag(chain.inertias) @ shapes == pytest.approx(np.eye(2), abs=1e-12)
    assert chain.inertias @ shapes == pytest.approx(np.zeros(2), abs=1e-12)


def test_a_straight_shaft_with_two_discs_twists_as_the_formula_says():
    discs = {0.0: Disc(5.0, 0.05, 0.03), 0.4: Disc(8.0, 0.10, 0.06)}
    light = Material(206e9, 0.29, 1e-3)
    rotor = shaft([Tube(0.4, 0.03, elements=2)], discs, (0.0, 0.4), light)
    spring = light.shear * pi * 0.03**4 / 32 / 0.4
    exact = np.sqrt(spring * (1 / 0.05 + 1 / 0.10)) / (2 * pi)
    chain = crank_torsional_chain(rotor)
    assert chain.frequencies()[0] == pytest.approx(exact, rel=1e-6)
    modes = natural_modes(rotor, 8)
    assert exact == pytest.approx(
        modes.frequencies[dominant_motions(rotor, modes).index("torsion")], rel=1e-4
    )


# The assembled crank


@pytest.mark.slow
def test_the_crank_floats_and_weighs_what_it_should():
    crank = replace(
        reference_four(weighted=True),
        flywheel=Disc(32.0, 0.56, 0.285, 0.02),
        pulley=Disc(3.2, 0.014, 0.008),
    )
    rotor = assemble(crank, webs="nominal", pin_masses=[1.1] * 4, damping_ratio=0.02, damping_time=1e-6)
    rigid = rotor.rigid_motions()
    for matrix in (rotor.stiffness, rotor.damping):
        assert np.abs(matrix @ rigid).max() < 1e-6 * np.abs(matrix).max()
    bare = assemble(reference_four(weighted=True), webs="nominal")
    shaft_mass = 7850 * pi / 4 * 0.065**2 * 0.02
    extra = 32.0 + 3.2 + 4.4 + shaft_mass
    weights = [r.rigid_motions()[:, 0] @ r.mass @ r.rigid_motions()[:, 0] for r in (bare, rotor)]
    assert weights[1] - weights[0] == pytest.approx(extra)
    assert np.linalg.eigvalsh(rotor.mass)[0] > 0
    assert np.abs(rotor.gyroscopic + rotor.gyroscopic.T).max() < 1e-15
    assert np.abs(rotor.centrifugal - rotor.centrifugal.T).max() < 1e-12


@pytest.mark.slow
def test_mass_centre_and_inertia_against_a_fine_cloud_of_points():
    """The rigid-body inertia of a bare throw by Monte-Carlo-free midpoint sums over its solids."""
    crank = simple_crank(angles=[0.7])
    rotor = assemble(crank, webs="nominal")
    rigid = rotor.rigid_motions()
    found = rigid.T @ rotor.mass @ rigid
    mass, moment, ww = cloud(crank)
    assert found[0, 0] == pytest.approx(mass, rel=2e-3)
    assert [found[1, 5], -found[0, 5]] == pytest.approx(moment, rel=5e-3)
    assert found[5, 5] == pytest.approx(ww, rel=3e-3)
    assert [rotor.centrifugal_force @ rigid[:, k] for k in (0, 1)] == pytest.approx(moment, rel=5e-3)


def cloud(crank):
    """Mass, first moments (U, V) and the moment of inertia about W, by sums over a grid of points."""
    step = 2.5e-4
    u, v = np.meshgrid(np.arange(-0.06, 0.12, step), np.arange(-0.06, 0.12, step), indexing="ij")
    total = np.zeros(4)
    for part, start, stop in crank.stations():
        if isinstance(part, Journal):
            inside = u**2 + v**2 < (part.diameter / 2) ** 2
        elif isinstance(part, Pin):
            pu, pv = part.radius * np.cos(part.angle), part.radius * np.sin(part.angle)
            inside = (u - pu) ** 2 + (v - pv) ** 2 < (part.diameter / 2) ** 2
        else:
            pin = crank.pins[0]
            along = u * np.cos(pin.angle) + v * np.sin(pin.angle)
            across = -u * np.sin(pin.angle) + v * np.cos(pin.angle)
            inside = np.abs(across) < part.width / 2
            for end, sign in ((pin.radius + part.tip, 1), (part.heel, -1)):
                margin = part.tip if sign > 0 else part.heel
                corner = min(part.width / 2, margin)
                a = np.maximum(sign * along - (end - corner), 0)
                b = np.maximum(np.abs(across) - (part.width / 2 - corner), 0)
                inside &= np.where(a > 0, a**2 + b**2 < corner**2, True)
        weight = 7850 * step**2 * (stop - start) * inside
        total += [weight.sum(), (weight * u).sum(), (weight * v).sum(), (weight * (u**2 + v**2)).sum()]
    return total[0], total[1:3], total[3]


@pytest.mark.slow
def test_a_turned_crank_has_the_same_frequencies_and_turned_shapes():
    one, other = (assemble(simple_crank(angles=[a, a + pi]), webs="nominal") for a in (0.0, 1.1))
    assert natural_modes(one, 12).frequencies == pytest.approx(
        natural_modes(other, 12).frequencies, rel=1e-7
    )


@pytest.mark.slow
def test_a_crank_seen_from_behind_has_the_same_frequencies():
    crank = simple_crank(angles=[0.3, 1.9, 4.0])
    back = Crank(crank.parts[::-1])
    one, other = (natural_modes(assemble(c, webs="formula"), 14).frequencies for c in (crank, back))
    assert one == pytest.approx(other, rel=1e-7)


@pytest.mark.slow
def test_modes_are_orthonormal_and_matched_with_themselves():
    rotor = assemble(simple_crank(3), webs="nominal")
    modes = natural_modes(rotor, 10)
    assert modes.shapes.T @ rotor.mass @ modes.shapes == pytest.approx(np.eye(10), abs=1e-8)
    squares = (2 * pi * modes.frequencies) ** 2
    assert modes.shapes.T @ rotor.stiffness @ modes.shapes == pytest.approx(
        np.diag(squares), rel=1e-6, abs=10
    )
    assert np.argmax(assurance(modes.shapes, modes.shapes), axis=1).tolist() == list(range(10))


def test_modal_damping_is_what_was_asked_for():
    rotor = assemble(simple_crank(1), webs="nominal", damping_ratio=0.03)
    modes = natural_modes(rotor, 8)
    got = np.diag(modes.shapes.T @ rotor.damping @ modes.shapes) / (4 * pi * modes.frequencies)
    assert got == pytest.approx(np.full(8, 0.03), rel=1e-6)


@pytest.mark.slow
@pytest.mark.parametrize("webs", ["nominal", "formula"])
@pytest.mark.parametrize(
    "crank",
    [
        simple_crank(1),
        simple_crank(12),
        simple_crank(1, bore=0.03),
        simple_crank(1, radius=0.02),  # journal and pin overlap
        replace(simple_crank(1), parts=tuple(
            replace(p, thickness=0.004) if isinstance(p, Web) else p for p in simple_crank(1).parts)),
    ],
    ids=["one throw", "twelve", "hollow pin", "short stroke", "thin web"],
)  # fmt: skip
def test_extreme_cranks_are_positive(crank, webs):
    rotor = assemble(crank, webs=webs)
    modes = natural_modes(rotor, 6)
    assert modes.frequencies[0] > 10
    assert np.linalg.eigvalsh(rotor.mass)[0] > 0


def test_split_pins_with_a_thin_web_and_without():
    journal, web, flying = (
        Journal(0.06, 0.03),
        Web(0.02, 0.09, 0.04, 0.042),
        Web(0.006, 0.08, 0.035, 0.035),
    )
    front, rear = (Pin(0.05, 0.025, 0.045, a, (n,)) for a, n in ((0.0, 1), (pi / 6, 2)))
    for middle in ((front, flying, rear), (front, rear)):
        crank = Crank((journal, web, *middle, web, journal))
        check_geometry(crank)
        rotor = assemble(crank, webs="nominal")
        assert len(rotor.pins) == 2
        assert natural_modes(rotor, 3).frequencies[0] > 100


# Webs


def test_nominal_web_is_the_sum_of_its_beams_under_torque():
    crank = simple_crank(1)
    arm = next(arms(crank))[1]
    twist = nominal_flexibility(arm)[5, 5]
    g, e = crank.material.shear, crank.material.young
    stubs = sum(0.011 / (g * pi * d**4 / 32) for d in (0.06, 0.05))
    assert twist == pytest.approx(stubs + 0.045 / (e * 0.022 * 0.09**3 / 12))


def test_formula_webs_add_up_to_ker_wilsons_throw():
    """A throw with its two half journals, twisted at the ends with both pins free to shift."""
    crank = simple_crank(1)
    rotor = assemble(crank, webs="formula")
    torque = np.zeros(rotor.size)
    torque[6 * rotor.journals[0] + 5], torque[6 * rotor.journals[1] + 5] = -1, 1
    twist = torque @ np.linalg.lstsq(rotor.stiffness, torque, rcond=1e-13)[0]
    journal, web, pin = crank.parts[0], crank.parts[1], crank.pins[0]
    formula = ker_wilson_torsion(journal, pin, web.thickness, web.width, crank.material.shear)
    assert twist == pytest.approx(formula, rel=1e-9)


def test_six_parameters_give_a_six_parameter_web_back():
    arm = next(arms(simple_crank(1)))[1]
    target = nominal_flexibility(arm)
    assert fitted_flexibility(arm, target, stubs=True) == pytest.approx(target, rel=1e-6, abs=1e-16)
    assert np.all(fitted_parameters(arm, 0.2 * target) >= 0)


def test_a_sector_counterweight_against_its_formulas():
    web = Web(0.02, 1e-6, 1e-6, 1e-6)
    half, outer, material = 1.0, 0.08, Material()
    got = sector_counterweight(web, 0.4, 1e-6, outer, half, material)
    mass = material.density * 0.02 * half * outer**2
    radius = 2 * outer * np.sin(half) / (3 * half)
    assert got.mass == pytest.approx(mass, rel=1e-4)
    assert got.radius == pytest.approx(radius, rel=1e-4)
    assert got.inertia == pytest.approx(mass * (outer**2 / 2 - radius**2), rel=1e-4)
    assert got.angle == pytest.approx(0.4 + pi)


# The solid


@pytest.mark.spread(2)
@pytest.mark.parametrize(
    ("weighted", "webs", "low", "high"),
    [
        (False, "solid", -3.0, 3.0),
        (True, "solid", -3.0, 3.0),
        (False, "fitted", -10.0, 6.0),
        (True, "fitted", -6.0, 17.0),
        (False, "formula", -22.0, 0.0),
        (False, "nominal", -40.0, -15.0),
    ],
)
def test_free_modes_against_the_meshed_crank(weighted, webs, low, high):
    solid = json.loads(SOLID.read_text(encoding="utf-8"))
    name = "weighted 16" if weighted else "bare 16"
    rotor = assemble(reference_four(weighted=weighted), webs=webs)
    errors = 100 * (natural_modes(rotor, 20).frequencies / solid[name]["frequencies"] - 1)
    assert low < errors.min() <= errors.max() < high


@pytest.mark.slow
@pytest.mark.parametrize("webs", ["solid", "formula"])
def test_what_passes_a_web_is_what_pulls_before_it(webs):
    """Free-body: the loads that hold any bent shape, summed over the nodes in front of a web's middle."""
    crank = reference("short")
    rotor = assemble(crank, webs=webs)
    shape = np.random.default_rng(7).normal(size=rotor.size)
    loads = (rotor.stiffness @ shape).reshape(-1, 6)
    arm = dict(arms(crank))
    for member in (m for m in rotor.members if m.kind == "web"):
        front = rotor.points[member.front]
        before = rotor.points[:, 2] < front[2] + 1e-9
        for other in (m for m in rotor.members if m.body):
            behind = other.rear <= member.front or (other is member and not arm[member.index].mirrored)
            before[other.body.node] = behind
        levers = rotor.points - front
        force = loads[before, :3].sum(0)
        moment = (loads[before, 3:] + np.cross(levers[before], loads[before, :3])).sum(0)
        assert rotor.passing(member) @ shape == pytest.approx([*force, *moment], rel=1e-6, abs=1e-3)


def test_a_webs_two_ends_are_the_whole_with_nothing_pulling_between():
    member = next(m for m in assemble(reference("short"), webs="solid").members if m.body)
    ends, middle = slice(0, 12), slice(12, 18)
    whole = member.whole
    kept = whole[ends, middle] @ np.linalg.solve(whole[middle, middle], whole[middle, ends])
    assert whole[ends, ends] - kept == pytest.approx(member.stiffness, rel=1e-6, abs=1e-6 * whole[0, 0])


def found(store, arm):
    web = store.lookup(arm)
    assert web is not None
    return web


def test_stored_webs_are_read_back_and_scale_with_youngs_modulus(tmp_path):
    store, arm = open_store(), next(arms(reference_four(weighted=False)))[1]
    web = found(store, arm)
    soft = replace(arm, material=replace(arm.material, young=arm.material.young / 2))
    assert web.body is not None
    assert found(store, soft).flexibility == pytest.approx(2 * web.flexibility)
    assert store.lookup(replace(arm, material=replace(arm.material, poisson=0.3))) is None
    own = WebStore(path=tmp_path / "webs.json")
    own.keep(arm, web)
    again = found(open_store(tmp_path / "webs.json"), arm)
    assert again.flexibility == pytest.approx(web.flexibility)
    assert again.body == pytest.approx(web.body)
    assert not [p for p in tmp_path.iterdir() if p.suffix == ".part"]


@pytest.mark.parametrize(
    "text",
    [
        "",
        "[]",
        '{"webs": {"a": {"flexibility": [], "body": [0, 0, 0]}}}',
        '{"webs": {"a": {"flexibility": [1]}}}',
        '{"webs": {"a": 1}}',
    ],
)
def test_a_broken_store_is_said_and_not_believed(tmp_path, text):
    (tmp_path / "webs.json").write_text(text)
    lines = []
    assert open_store(tmp_path / "webs.json", lines.append).new_webs == {}
    assert len(lines) == 1
    assert "webs.json" in lines[0]


def two_webs():
    """Two solved webs of the package's store and their arms."""
    crank = [arm for _, arm in arms(reference_four(weighted=True))]
    arm, other = crank[0], next(arm for _, arm in arms(reference_four(weighted=False)))
    return (arm, found(open_store(), arm)), (other, found(open_store(), other))


def test_webs_of_another_mesher_are_said_and_not_believed(tmp_path, monkeypatch):
    path, heard = tmp_path / "webs.json", []
    (arm, web), _ = two_webs()
    strange = replace(arm, web=replace(arm.web, thickness=arm.web.thickness * 1.01))
    WebStore(path=path).keep(strange, web)
    assert found(open_store(path, heard.append), strange)
    assert heard == []
    monkeypatch.setattr(store_module, "mesher_digest", lambda: "of another version")
    assert open_store(path, heard.append).lookup(strange) is None
    assert len(heard) == 1
    assert "webs.json: holds webs that another version solved" in heard[0]


def test_the_packages_own_webs_are_not_overridden_by_a_files(tmp_path):
    path = tmp_path / "webs.json"
    (arm, web), _ = two_webs()
    WebStore(path=path).keep(arm, replace(web, flexibility=2 * web.flexibility))
    assert found(open_store(path), arm).flexibility == pytest.approx(web.flexibility)


def test_two_writers_keep_each_others_webs(tmp_path):
    path = tmp_path / "webs.json"
    (arm, web), (other, its) = two_webs()
    one, two = open_store(path), open_store(path)
    one.keep(arm, web)
    two.keep(other, its)
    assert len(json.loads(path.read_text(encoding="utf-8"))["webs"]) == 2
    assert [p.name for p in tmp_path.iterdir()] == ["webs.json"]


def test_elements_of_another_size_are_another_web(tmp_path, monkeypatch):
    (arm, web), _ = two_webs()
    coarse = replace(web, flexibility=0.9 * web.flexibility)
    monkeypatch.setattr("symbalance.crankshaft.solid.half_throw.solve_web", lambda arm, size: coarse)
    store = WebStore(path=tmp_path / "webs.json")
    solve_missing(reference_four(weighted=True), store, 0.03)
    assert store.lookup(arm) is None
    assert found_at(store, arm, 0.03).flexibility == pytest.approx(coarse.flexibility)


def found_at(store, arm, size):
    web = store.lookup(arm, size)
    assert web is not None
    return web


def test_a_web_solved_now_is_the_one_read_back(tmp_path, monkeypatch):
    """To the last digit: what is saved of a speed hangs on it."""
    (arm, web), _ = two_webs()
    third = replace(web, flexibility=web.flexibility / 3)
    monkeypatch.setattr("symbalance.crankshaft.solid.half_throw.solve_web", lambda arm: third)
    store = WebStore(path=tmp_path / "webs.json")
    first, again = solid_web(arm, store), solid_web(arm, store)
    assert (first.flexibility == again.flexibility).all()


def test_a_store_that_cannot_be_read_or_written_is_one_line(tmp_path):
    (arm, web), _ = two_webs()
    (tmp_path / "folder.json").mkdir()
    with pytest.raises(SymbalanceError, match=r"folder\.json: is a directory"):
        open_store(tmp_path / "folder.json")
    with pytest.raises(SymbalanceError, match=r"webs\.json: cannot be written"):
        WebStore(path=tmp_path / "nowhere" / "webs.json").keep(arm, web)


def test_a_web_under_another_webs_key_is_not_believed(tmp_path):
    path, lines = tmp_path / "webs.json", []
    (arm, web), _ = two_webs()
    WebStore(path=path).keep(arm, web)
    document = json.loads(path.read_text(encoding="utf-8").replace("web 24.0", "web 25.0"))
    document["checksum"] = store_module._checksum(document["webs"])
    path.write_text(json.dumps(document), encoding="utf-8")
    assert open_store(path, lines.append).new_webs == {}
    assert "is not the web it describes" in lines[0]


@pytest.mark.spread(2)
@pytest.mark.parametrize(
    "missing", ["skfem", pytest.param("gmsh", marks=pytest.mark.skipif(not MESHER, reason="optional"))]
)
@pytest.mark.parametrize("webs", ["solid", "fitted"])
def test_without_the_mesher_an_unsolved_web_says_what_to_install(monkeypatch, missing, webs):
    monkeypatch.setitem(__import__("sys").modules, missing, None)
    with pytest.raises(MissingPartError, match=r"pip install 'symbalance\[crankshaft\]'") as caught:
        assemble(simple_crank(1), webs=webs)
    assert "\n" not in str(caught.value)


@pytest.mark.skipif(not MESHER, reason="gmsh and scikit-fem are optional")
def test_what_gmsh_cannot_draw_is_an_error_in_words():
    from symbalance.crankshaft.solid.meshing import mesh_solid

    with pytest.raises(SymbalanceError, match="the crank's solid: cannot be meshed"):
        mesh_solid(lambda occ: occ.addCylinder(0, 0, 0, 0, 0, 0, 10), 0.01)


def test_a_very_thin_web_is_meshed_within_reach():
    from symbalance.crankshaft.solid.half_throw import element_size

    parts = (replace(p, thickness=0.002) if isinstance(p, Web) else p for p in simple_crank(1).parts)
    arm = next(arms(Crank(tuple(parts))))[1]
    assert element_size(arm) >= arm.web.width / 15


@pytest.mark.slow
@pytest.mark.skipif(not MESHER, reason="gmsh and scikit-fem are optional")
def test_a_meshed_web_is_symmetric_positive_and_converges():
    from symbalance.crankshaft.solid.half_throw import solve_web

    arm = next(arms(simple_crank(1, length=0.04)))[1]
    coarse, finer = (solve_web(arm, size).flexibility for size in (0.020, 0.014))
    for web in (coarse, finer):
        assert np.linalg.eigvalsh(web)[0] > 0
    scale = np.sqrt(np.outer(np.diag(finer), np.diag(finer)))
    assert np.abs((coarse - finer) / scale).max() < 0.06


@pytest.mark.slow
@pytest.mark.skipif(not MESHER, reason="gmsh and scikit-fem are optional")
def test_a_meshed_round_bar_is_the_beam():
    """A half throw without a throw: pin on the journal's axis, a web that is a slice of the same bar."""
    from symbalance.crankshaft.solid.half_throw import half_throw_flexibility

    bar = (Journal(0.05, 0.2), Web(0.05, 0.05, 0.025, 0.025), Pin(0.05, 0.2, 1e-9, 0.0, (1,)))
    arm = next(arms(Crank((*bar, bar[1], bar[0]))))[1]
    found, body = half_throw_flexibility(arm, 0.016)
    section = circular(0.05, 0.0, arm.material.poisson)
    exact = flexibility(section, arm.material, 0.25)
    assert np.diag(found)[:6] == pytest.approx(np.diag(exact), rel=0.02)
    # The near half of the middle slice hangs on the bar some 125 mm from its held end, loaded there.
    assert body == pytest.approx([-2 * 0.05 / (3 * pi), 0, 0.025], abs=1e-3)
    assert found[11, 11] == pytest.approx(flexibility(section, arm.material, 0.125)[5, 5], rel=0.05)


# Bad input


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"pin": {"bore": 0.05}}, "bore = 50 mm: must be less than the diameter"),
        ({"pin": {"fillet": 0.02}}, "fillet = 20 mm: must be less than half the length"),
        ({"web": {"width": 0.05}}, "width = 50 mm: must cover the journal"),
        ({"web": {"tip": 0.02}}, "tip = 20 mm: must cover the pin"),
        ({"web": {"heel": 0.02}}, "heel = 20 mm: must cover the journal"),
        ({"web": {"thickness": 0.002}}, "thickness = 2 mm: must be more than the journal's fillet, 3 mm"),
        (
            {"web": {"counterweight": WebCounterweight(1.0, 0.09, pi, 0, 0.08, 1.0)}},
            "must be less than its outer",
        ),
        (
            {"web": {"counterweight": WebCounterweight(1.0, 0.05, pi, 0, 0.08, 4.0)}},
            "half_angle = 229.183",
        ),
        ({"flywheel": Disc(30.0, 0.5, 0.1)}, "polar = 0.5: must be at most twice the diametral"),
        ({"flywheel": Disc(0.0, 0.5, 0.3)}, "mass = 0.0: must be positive"),
    ],
)
def test_sizes_that_cannot_be(change, words):
    crank = simple_crank(1)
    kinds_ = {"pin": Pin, "web": Web}
    for name, sizes in change.items():
        if name in kinds_:
            parts = tuple(replace(p, **sizes) if isinstance(p, kinds_[name]) else p for p in crank.parts)
            crank = replace(crank, parts=parts)
        else:
            crank = replace(crank, **{name: sizes})
    with pytest.raises(SymbalanceError) as caught:
        check_geometry(crank)
    assert words in str(caught.value)


SLAB, END, ROD = Web(0.02, 0.08, 0.04, 0.04), Journal(0.06, 0.03), Pin(0.05, 0.03, 0.04, 0.0, (1,))
PARTS = (END, SLAB, ROD, SLAB, END)
TURNING = shaft([Tube(1.0, 0.05)], bearings=(0.0, 1.0))
PLAIN = sb.crankshaft.Bearing(0.1, 0.03, 1e-4, 0.1)
MADE_WRONG = [
    (
        lambda: replace(SLAB, counterweight=sb.Counterweight(throw=1, overbalance=1)),
        "sb.crankshaft.WebCounterweight",
    ),
    (lambda: replace(SLAB, counterweight=1.5), "web counterweight of type float"),
    (lambda: replace(SLAB, thickness="0.02"), "web thickness = '0.02': must be a number"),
    (lambda: replace(SLAB, width=float("inf")), "web width = inf: must be finite"),
    (lambda: replace(SLAB, heel=-0.01), "web heel = -0.01: must be finite, not negative"),
    (lambda: replace(END, diameter=None), "journal diameter = None: must be a number"),
    (lambda: replace(END, length=True), "journal length = True: must be a number"),
    (lambda: replace(END, bearing="no"), "journal bearing of type str"),
    (lambda: replace(ROD, radius=-0.04), "pin radius = -0.04: must be finite, not negative"),
    (lambda: replace(ROD, angle=float("nan")), "pin angle = nan: must be finite"),
    (lambda: replace(ROD, angle=sb.exact.degrees(90)), "pin angle = Angle"),
    (lambda: replace(ROD, cylinders=1), "pin cylinders = 1: must be a list"),
    (lambda: replace(ROD, cylinders=("1",)), "must be whole numbers"),
    (lambda: WebCounterweight(-1.0, 0.05, pi), "counterweight mass = -1.0"),
    (lambda: WebCounterweight(1.0, 0.05, "180"), "counterweight angle = '180'"),
    (lambda: Disc(float("nan"), 1.0, 1.0), "disc mass = nan: must be finite"),
    (lambda: Disc(1.0, 1.0, 1.0, distance=-0.1), "disc distance = -0.1"),
    (lambda: Material("steel"), "young = 'steel': must be a number"),
    (lambda: Material(poisson=0.5), "poisson = 0.5: must lie in"),
    (lambda: Material(young=-1.0), "young = -1.0: must be positive"),
    (lambda: Material(density=0), "density = 0: must be positive"),
    (lambda: Crank(END), "must be a list"),
    (lambda: Crank((END, SLAB, 5, SLAB, END)), "crank part 3 of type int"),
    (lambda: Crank(PARTS, material={"young": 1}), "crank material of type dict"),
    (lambda: Crank(PARTS, flywheel=Tube(1.0, 0.05)), "flywheel of type Tube"),
    (lambda: Crank(PARTS, pulley=3.0), "pulley of type float"),
    (lambda: Tube("1", 0.05), "tube length = '1': must be a number"),
    (lambda: Tube(-1.0, 0.05), "tube length = -1.0"),
    (lambda: Tube(1.0, 0.05, bore=0.05), "a bore within its diameter"),
    (lambda: Tube(1.0, 0.05, bending=1.0), "tube bending = 1.0: must be a list"),
    (lambda: sb.crankshaft.rotor.Support("1e6"), "support stiffness = '1e6'"),
    (lambda: sb.crankshaft.rotor.Support(None), "support stiffness = None"),
    (lambda: sb.crankshaft.rotor.Support((1e6, "a")), "must be a finite number, a pair"),
    (lambda: sb.crankshaft.rotor.Support(1e6, tilt="a"), "support tilt = 'a': must be a number"),
    (lambda: sb.crankshaft.Bearing("0.1", 0.03, 1e-4, 0.1), "bearing diameter = '0.1'"),
    (lambda: sb.crankshaft.Bearing(0.1, 0.03, 1e-4, float("nan")), "bearing viscosity = nan"),
    (lambda: sb.crankshaft.Film(1e8, 1e5), "film stiffness of type float: must be a function"),
    (lambda: sb.crankshaft.Housing(np.eye(2), np.eye(2)), "housing stiffness of shape"),
    (lambda: assemble(SLAB), "crank of type Web: must be of type Crank"),
    (lambda: shaft(Tube(1.0, 0.05)), "tubes = .* must be a list"),
    (lambda: shaft([Disc(1.0, 1.0, 1.0)]), "tube 1 of type Disc"),
    (lambda: shaft([Tube(1.0, 0.05)], [Disc(1.0, 1.0, 1.0)]), "discs of type list"),
    (lambda: shaft([Tube(1.0, 0.05)], {0.5: 3.0}), "disc at 0.5 m of type float"),
    (lambda: shaft([Tube(1.0, 0.05)], bearings=0.5), "bearings = 0.5: must be a list"),
    (lambda: shaft([Tube(1.0, 0.05)], bearings=("0",)), "place = '0': must be a number"),
    (lambda: shaft([Tube(1.0, 0.05)], material="steel"), "material of type str"),
    (lambda: sb.crankshaft.rotor.whirl(TURNING, [1e6, 1e6], 100.0), "support 1 of type float"),
    (
        lambda: sb.crankshaft.rotor.whirl(TURNING, sb.crankshaft.rotor.Support(1e6), 100.0),
        "supports = .* must be a list",
    ),
    *(
        (call, "rotor of type Crank: must be of type Rotor")
        for call in (
            lambda: sb.crankshaft.rotor.whirl(
                Crank(PARTS), [sb.crankshaft.rotor.Support(1e6)] * 2, 100.0
            ),
            lambda: sb.crankshaft.rotor.critical_speeds(
                Crank(PARTS), [sb.crankshaft.rotor.Support(1e6)] * 2
            ),
            lambda: sb.crankshaft.rotor.unbalance_response(
                Crank(PARTS), [sb.crankshaft.rotor.Support(1e6)] * 2, {}, [1.0]
            ),
            lambda: sb.crankshaft.rotor.system_on_supports(
                Crank(PARTS), [sb.crankshaft.rotor.Support(1e6)] * 2, 100.0
            ),
            lambda: natural_modes(Crank(PARTS), 5),
            lambda: crank_torsional_chain(Crank(PARTS)),
            lambda: campbell(Crank(PARTS), [1.0]),
            lambda: bearing_springs(Crank(PARTS), 1.0),
        )
    ),
    *(
        (lambda call=call: call(TURNING), "system of type Rotor: must be of type PeriodicSystem")
        for call in (sb.crankshaft.steady_state, sb.crankshaft.integrate, sb.crankshaft.reduce_system)
    ),
    (lambda: sb.crankshaft.film_state(None, [0.0, 0.0], [0.0, 0.0], 1.0), "bearing of type NoneType"),
    (lambda: sb.crankshaft.equilibrium("b", [1.0, 0.0], 1.0), "bearing of type str"),
    (lambda: sb.crankshaft.equilibrium(PLAIN, [1e30, 0.0], 157.0), "is more than the film bears"),
    (
        lambda: sb.crankshaft.journal_orbit(PLAIN, np.ones((8, 1, 2)), 1.0, 6.28),
        "bearings = .* must be a list",
    ),
    (
        lambda: sb.crankshaft.journal_orbit([3.0], np.ones((8, 1, 2)), 1.0, 6.28),
        "bearing 1 of type float",
    ),
    (
        lambda: sb.crankshaft.film_from_tables(np.arange(4.0), np.eye(2), np.eye(2), 6.28),
        "stiffness of shape .* must be",
    ),
]


@pytest.mark.parametrize(("make", "words"), MADE_WRONG, ids=[words for _, words in MADE_WRONG])
def test_what_is_made_wrong_is_refused_where_it_is_made(make, words):
    with pytest.raises(SymbalanceError, match=words) as caught:
        make()
    assert "\n" not in str(caught.value)


def test_the_two_counterweights_have_names_of_their_own():
    """A layout's goes to `balanced_by`, a web's to `Web`; both do what they are for."""
    assert sb.Counterweight is not sb.crankshaft.WebCounterweight
    assert (sb.Counterweight.__name__, sb.crankshaft.WebCounterweight.__name__) == (
        "Counterweight",
        "WebCounterweight",
    )
    slab = sb.crankshaft.Web(
        0.02, 0.08, 0.04, 0.04, counterweight=sb.crankshaft.WebCounterweight(1.0, 0.05, pi)
    )
    heavier = assemble(Crank((END, slab, ROD, SLAB, END)))
    total = heavier.mass[::6, ::6].sum() - assemble(Crank(PARTS)).mass[::6, ::6].sum()
    assert total == pytest.approx(1.0)


def test_a_fault_of_the_drawing_is_no_matter_of_sizes(monkeypatch):
    """gmsh raises bare Exceptions; an AttributeError is ours, and must not blame the crank's sizes."""
    from symbalance.crankshaft.solid.meshing import mesh_solid

    for name in ("gmsh", "skfem"):
        monkeypatch.setitem(sys.modules, name, MagicMock())

    def draw(fault):
        raise fault

    with pytest.raises(AttributeError):
        mesh_solid(lambda occ: draw(AttributeError("addCylindre")), 0.01)
    with pytest.raises(SymbalanceError, match="cannot be meshed"):
        mesh_solid(lambda occ: draw(Exception("no elements")), 0.01)


def test_pins_that_do_not_meet():
    journal, web = Journal(0.06, 0.03), Web(0.02, 0.09, 0.04, 0.042)
    front, rear = (Pin(0.03, 0.025, 0.045, a, (n,)) for a, n in ((0.0, 1), (pi, 2)))
    with pytest.raises(SymbalanceError, match="distance between their axes = 90 mm"):
        check_geometry(Crank((journal, web, front, rear, web, journal)))


def test_wrong_requests_are_refused():
    crank = simple_crank(1)
    with pytest.raises(SymbalanceError, match="webs = wood: must be one of " + ", ".join(WEBS)):
        assemble(crank, webs="wood")
    with pytest.raises(SymbalanceError, match="2 pin masses: must be one per pin, 1"):
        assemble(crank, pin_masses=[1.0, 2.0])
    with pytest.raises(SymbalanceError, match="modes = 0"):
        natural_modes(assemble(crank), 0)
    with pytest.raises(SymbalanceError, match=r"stiffness = -1\.0: must be positive"):
        torsional_chain([1.0, 1.0], [-1.0])
    with pytest.raises(SymbalanceError, match="must lie on the shaft"):
        shaft([Tube(1.0, 0.05)], bearings=(1.2,))


@pytest.mark.slow
@pytest.mark.parametrize(("name", "high"), [("short", 5.0), ("slender", 3.0)])
def test_short_and_slender_cranks_below_their_webs_own_modes(name, high):
    """The first ten; above, a web's own plate modes come, which no beam has: `crankshaft-model.md`."""
    solid = json.loads(SOLID.read_text(encoding="utf-8"))[f"{name} 14"]["frequencies"][:10]
    errors = 100 * (natural_modes(assemble(reference(name), webs="solid"), 10).frequencies / solid - 1)
    assert -1.0 < errors.min() <= errors.max() < high


@pytest.mark.parametrize("name", SIZES)
def test_nothing_is_left_to_solve_for_the_stored_cranks(name):
    assert solve_missing(reference(name), open_store()) == 0
