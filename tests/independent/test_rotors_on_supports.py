"""Round rotors on any supports, against the exact shaft: transfer matrices in stationary axes.

`exact_root` integrates Timoshenko's equations for both planes along the shaft (a matrix exponential a
piece), steps over discs and supports, and asks for free ends: no elements, no turning axes, nothing of
the package. Published figures: M. I. Friswell, J. E. T. Penny, S. D. Garvey, A. W. Lees, Dynamics of
Rotating Machines (2010), examples 5.9.2, 5.9.4 and 5.9.5, as the open software ROSS quotes them.
"""

from __future__ import annotations

import numpy as np
import pytest

pytest.importorskip("scipy")

from scipy.linalg import expm

import symbalance as sb
from symbalance.crankshaft.frames import rotation

STEEL = sb.crankshaft.Material(211e9, 211 / (2 * 81.2) - 1, 7810)
FAST = 4000 * np.pi / 30


def friswell_disc(diameter):
    mass = 7810 * np.pi / 4 * (diameter**2 - 0.05**2) * 0.07
    polar = mass * (diameter**2 + 0.05**2) / 8
    return sb.crankshaft.Disc(mass, polar, polar / 2 + mass * 0.07**2 / 12)


def two_discs(elements=6):
    discs = {0.5: friswell_disc(0.28), 1.0: friswell_disc(0.35)}
    return sb.crankshaft.rotor.shaft(
        [sb.crankshaft.rotor.Tube(1.5, 0.05, elements=elements)], discs, (0.0, 1.5), STEEL
    )


# --- the exact shaft ----------------------------------------------------------------------------------


def piece(length, tube, s, omega):
    """Return the (8, 8) transfer of w, w's slope by bending, moment and shear force, both planes."""
    bore, outer = tube.bore, tube.diameter
    area, bend = np.pi / 4 * (outer**2 - bore**2), np.pi / 64 * (outer**4 - bore**4)
    nu, whole, ratio = STEEL.poisson, (1 + (bore / outer) ** 2) ** 2, (bore / outer) ** 2
    cowper = 6 * (1 + nu) * whole / ((7 + 6 * nu) * whole + (20 + 12 * nu) * ratio)
    rho, stiff = STEEL.density, STEEL.young * bend
    A = np.zeros((8, 8), dtype=complex)
    for o, sign in ((0, 1), (4, -1)):
        A[o, o + 1], A[o, o + 3] = 1, 1 / (cowper * STEEL.young / (2 * (1 + nu)) * area)
        A[o + 1, o + 2] = 1 / stiff
        A[o + 2, o + 3], A[o + 2, o + 1] = -1, rho * bend * s**2
        A[o + 2, 5 - o] = sign * 2 * rho * bend * omega * s
        A[o + 3, o] = rho * area * s**2
    scale = np.array([1, 1 / length, stiff / length**2, stiff / length**3] * 2)
    return scale[:, None] * expm(A * length * scale / scale[:, None]) / scale


def determinant(s, omega, tubes, discs, supports):
    """Return what vanishes at a root: moment and shear force at the rear of a shaft free at its front."""
    ends = np.cumsum([0.0] + [tube.length for tube in tubes])
    places = sorted({*np.round([*ends, *discs, *supports], 9)})
    unit, turn = np.array([1, 1, 1e6, 1e6] * 2), 1.0 + 0j
    state = np.eye(8, dtype=complex)[:, [0, 1, 4, 5]]
    for k, place in enumerate(places):
        step = np.eye(8, dtype=complex)
        if place in discs:
            disc = discs[place]
            for o, sign in ((0, 1), (4, -1)):
                step[o + 3, o] += disc.mass * s**2
                step[o + 2, o + 1] += disc.diametral * s**2
                step[o + 2, 5 - o] += sign * disc.polar * omega * s
        if place in supports:
            spring, damper = supports[place].matrices
            step[np.ix_([3, 7], [0, 4])] += spring + s * damper
        state = step @ state
        if k + 1 < len(places):
            length = places[k + 1] - place
            tube = tubes[int(np.searchsorted(ends, place + length / 2)) - 1]
            parts = int(np.ceil(length / tube.diameter / 2))
            for _ in range(parts):
                state = piece(length / parts, tube, s, omega) @ state
            held, sizes = np.linalg.qr(state / unit[:, None])
            state, turn = held * unit[:, None], turn * np.prod(np.diag(sizes) / np.abs(np.diag(sizes)))
    return np.linalg.det((state / unit[:, None])[[2, 3, 6, 7]]) * turn


def exact_root(near, *shaft):
    """Return the zero of `determinant` beside a value, by Muller's method."""
    x = [near * f for f in (1 - 1e-4, 1 + 1e-4j, 1)]
    f = [determinant(value, *shaft) for value in x]
    for _ in range(40):
        first, second = (f[1] - f[0]) / (x[1] - x[0]), (f[2] - f[1]) / (x[2] - x[1])
        a = (second - first) / (x[2] - x[0])
        b = a * (x[2] - x[1]) + second
        root = np.sqrt(b * b - 4 * a * f[2])
        x = [*x[1:], x[2] - 2 * f[2] / (b + root if abs(b + root) > abs(b - root) else b - root)]
        f = [*f[1:], determinant(x[-1], *shaft)]
        if abs(x[2] - x[1]) < 1e-11 * abs(near):
            break
    return x[-1]


CROSS = [[1e7, 3e6], [-4e6, 6e6]], [[2e3, 500], [-300, 4e3]]
FOUR = [
    sb.crankshaft.rotor.Tube(0.3, 0.04, 0.0, 18),
    sb.crankshaft.rotor.Tube(0.5, 0.06, 0.02, 20),
    sb.crankshaft.rotor.Tube(0.2, 0.05, 0.0, 12),
]


@pytest.mark.slow
@pytest.mark.parametrize("omega", [0.0, 300.0, 1500.0])
@pytest.mark.parametrize(
    ("tubes", "discs", "supports", "within"),
    [
        (FOUR, {0.3: (12, 0.2, 0.11), 0.8: (20, 0.3, 0.2)}, {0.0: (1e7,), 1.0: (5e6, 2e3)}, 1e-5),
        (FOUR, {0.3: (12, 0.2, 0.11), 1.0: (20, 0.3, 0.2)}, {0.1: CROSS, 0.9: ((2e7, 1e7), 3e3)}, 1e-5),
        (
            [sb.crankshaft.rotor.Tube(0.6, 0.1, 0.07, 24)],
            {0.3: (50, 1.0, 0.6)},
            {0.0: ((1e9, 4e7), 1e5), 0.6: (2e8,)},
            5e-4,
        ),
    ],
    ids=["even", "cross terms", "hollow"],
)
def test_roots_are_those_of_the_exact_shaft(tubes, discs, supports, within, omega):
    """The thicker the shaft, the more shear: an element's is constant, so that errors fall with h^2."""
    weights = {place: sb.crankshaft.Disc(*map(float, disc)) for place, disc in discs.items()}
    below = {place: sb.crankshaft.rotor.Support(*given) for place, given in supports.items()}
    found = sb.crankshaft.rotor.whirl(
        sb.crankshaft.rotor.shaft(tubes, weights, [*below], STEEL), [*below.values()], omega
    )
    for root in found.roots[:6]:
        assert abs(exact_root(root, omega, tubes, weights, below) / root - 1) < within


def test_published_roots():
    uneven = sb.crankshaft.rotor.whirl(two_discs(), [sb.crankshaft.rotor.Support((1e6, 8e5))] * 2, FAST)
    assert uneven.natural[:6] == pytest.approx([82.33, 86.86, 239.64, 287.25, 583.49, 806.89], rel=1e-4)
    crossed = sb.crankshaft.rotor.whirl(
        two_discs(), [sb.crankshaft.rotor.Support([[1e6, 5e5], [0, 1e6]])] * 2, FAST
    )
    expected = [84.198, 89.033, 246.441, 301.086, 594.82, 834.04]
    assert crossed.natural[:6] == pytest.approx(expected, rel=1e-5)
    assert not crossed.is_stable
    damped = sb.crankshaft.rotor.whirl(two_discs(), [sb.crankshaft.rotor.Support(1e6, 3e3)] * 2, FAST)
    natural = [13.70, 14.09, 43.61, 52.18, 122.37, 149.81]
    assert damped.natural[:6] / (2 * np.pi) == pytest.approx(natural, abs=6e-3)
    frequencies = [13.68, 14.07, 41.98, 50.65, 104.25, 105.66]
    assert damped.roots.imag[:6] / (2 * np.pi) == pytest.approx(frequencies, abs=6e-3)
    assert damped.is_stable


@pytest.mark.slow
def test_critical_speeds_are_where_the_whirl_meets_the_speed():
    rotor, even = two_discs(), [sb.crankshaft.rotor.Support(1e6)] * 2
    found = sb.crankshaft.rotor.critical_speeds(rotor, even)
    assert (found.forward[:6].round(9) == [0, 1, 0, 1, 0, 1]).all()
    for speed in found.speeds[:6]:
        assert (
            np.abs(np.abs(sb.crankshaft.rotor.whirl(rotor, even, speed).frequencies) / speed - 1).min()
            < 1e-9
        )
    little = sb.crankshaft.rotor.critical_speeds(
        rotor, [sb.crankshaft.rotor.Support(1e6, 1.0)] * 2, most=600.0
    )
    assert little.speeds == pytest.approx(found.speeds[: len(little.speeds)], rel=1e-6)
    assert len(little.speeds) == np.sum(found.speeds < 600)
    function = sb.crankshaft.rotor.critical_speeds(rotor, lambda omega: even, most=600.0)
    assert function.speeds == pytest.approx(little.speeds, rel=1e-6)


def test_a_published_rotor_of_eighteen_pieces():
    """Sizes and speeds (rpm) assumed to be Nelson and McVaugh's (J. Eng. Ind., 1976), not seen."""
    places = [0, 1.27, 5.08, 7.62, 8.89, 10.16, 10.67, 11.43, 12.70, 13.46, 16.51, 19.05, 22.86]
    places = np.array([*places, 26.67, 28.70, 30.48, 31.50, 34.54, 35.50]) / 100
    radii = [0.51, 1.02, 0.76, 2.03, 2.03, 3.3, 3.3, 2.54, 2.54, 1.27, 1.27, 1.52, 1.52, 1.27, 1.27]
    bores = [0] * 6 + [1.52, 1.78] + [0] * 9 + [1.52]
    tubes = [
        sb.crankshaft.rotor.Tube(float(length), radius / 50, bore / 50, 1)
        for length, radius, bore in zip(np.diff(places), [*radii, 3.81, 2.03, 2.03], bores, strict=True)
    ]
    disc = {float(places[4]): sb.crankshaft.Disc(1.401, 0.002, 0.00136)}
    bearings = (float(places[10]), float(places[14]))
    rotor = sb.crankshaft.rotor.shaft(
        tubes, disc, bearings, sb.crankshaft.Material(207.8e9, 0.3, 7806), shear=False
    )
    found = sb.crankshaft.rotor.critical_speeds(rotor, [sb.crankshaft.rotor.Support(4.378e7)] * 2)
    expected = [15470, 17159, 46612, 49983, 64752, 96457]
    assert found.speeds[:6] * 30 / np.pi == pytest.approx(expected, rel=8e-3)


@pytest.mark.parametrize("stiffness", [1e11, 1e13, 1e15])
def test_stiff_supports_cost_no_digits(stiffness):
    """Far stiffer than the shaft they are pins: the root moves with 1/stiffness."""
    soft, stiff = (
        sb.crankshaft.rotor.whirl(two_discs(), [sb.crankshaft.rotor.Support(k)] * 2, FAST).roots[:4]
        for k in (stiffness, stiffness * 100)
    )
    assert np.abs(soft / stiff - 1).max() < 3e6 / stiffness + 1e-11
    assert np.abs(stiff.real).max() < 1e-9 * np.abs(stiff).max()


def test_a_cantilever_by_its_tilt_stiffness():
    """An overhung disc on a light shaft held fast: Stodola's quartic (see test_rotors)."""
    length, light = 0.4, sb.crankshaft.Material(211e9, 0.3, 1e-3)
    rotor = sb.crankshaft.rotor.shaft(
        [sb.crankshaft.rotor.Tube(length, 0.03, elements=4)],
        {length: sb.crankshaft.Disc(5.0, 0.075, 0.04)},
        (0.0,),
        light,
        shear=False,
    )
    found = sb.crankshaft.rotor.whirl(
        rotor, [sb.crankshaft.rotor.Support(1e14, tilt=1e12)], 300.0
    ).frequencies[:4]
    EI = 211e9 * np.pi / 64 * 0.03**4
    k11, k12, k22 = EI * np.array([12 / length**3, -6 / length**2, 4 / length])
    quartic = np.polysub(np.polymul([-5.0, 0, k11], [-0.04, 0.075 * 300, k22]), [k12**2])
    assert np.sort(found) == pytest.approx(np.sort(np.roots(quartic).real), rel=1e-5)


def test_turning_damping_destabilises_beyond_its_onset():
    """Jeffcott: omega_n (1 + c_e/c_i) (Smith 1933); damping that turns as 2 zeta/omega_n times K."""
    from dataclasses import replace

    light = sb.crankshaft.Material(density=1e-3)
    rotor = sb.crankshaft.rotor.shaft(
        [sb.crankshaft.rotor.Tube(1.0, 0.05)],
        {0.5: sb.crankshaft.Disc(20.0, 0.05, 0.05)},
        (0.0, 1.0),
        light,
    )
    pinned = [sb.crankshaft.rotor.Support(1e12)] * 2
    own = sb.crankshaft.rotor.whirl(rotor, pinned, 0.0).natural[0]
    inner = replace(rotor, damping=1e-4 * rotor.stiffness)
    assert sb.crankshaft.rotor.whirl(inner, pinned, 0.99 * own).is_stable
    beyond = sb.crankshaft.rotor.whirl(inner, pinned, 1.01 * own)
    assert not beyond.is_stable
    assert beyond.frequencies[np.argmax(beyond.roots.real)] > 0  # forward, with the shaft


def test_unbalance_is_the_steady_state_and_the_multipliers_are_the_roots():
    """The same rotor as a periodic system in turning axes, uneven damped supports, two unbalances."""
    rotor, amounts = two_discs(), {0.5: 1e-3, 1.0: 2e-3 * np.exp(0.7j)}
    supports = [sb.crankshaft.rotor.Support((1e6, 8e5), [[300.0, 50.0], [-20.0, 500.0]])] * 2
    steady = sb.crankshaft.steady_state(
        sb.crankshaft.rotor.system_on_supports(rotor, supports, FAST, unbalances=amounts), steps=180
    )
    found = sb.crankshaft.rotor.unbalance_response(rotor, supports, amounts, [FAST])
    wave = np.exp(1j * steady.theta)
    for node in range(len(rotor.points)):
        rotated = steady.position[:, 6 * node : 6 * node + 2]
        place = (rotation(steady.theta) @ rotated[..., None])[..., 0]
        given = [(a[0, node] * wave).real for a in (found.vertical, found.lateral)]
        assert np.abs(place - np.transpose(given)).max() < 1e-7 * found.largest.max()
    for j in range(2):
        carried = [(force * wave).real for force in found.forces[0, j]]
        assert np.abs(steady.bearing[:, j] + np.transpose(carried)).max() < 1e-7 * np.abs(carried).max()
    assert steady.multipliers is not None
    for root in sb.crankshaft.rotor.whirl(rotor, supports, FAST).roots[:6]:
        assert np.abs(steady.multipliers - np.exp(root * 2 * np.pi / FAST)).min() < 1e-6


def test_a_flattened_shaft_is_unstable_between_its_critical_speeds():
    """Growth of the uneven Jeffcott rotor (see test_rotors), in turning axes and by the multipliers.

    s^2 = -(w^2 + (a + b)/2) + sqrt(((a - b)/2)^2 + 2 (a + b) w^2), a and b the squared frequencies.
    """
    tube = sb.crankshaft.rotor.Tube(1.0, 0.05, bending=(0.9, 1.1))
    weight = sb.crankshaft.Disc(20.0, 1e-6, 1e-6)
    rotor = sb.crankshaft.rotor.shaft(
        [tube], {0.5: weight}, (0.0, 1.0), sb.crankshaft.Material(density=1e-4), shear=False
    )
    stiff = 48 * 206e9 * np.pi / 64 * 0.05**4 / 20
    a, b = 0.9 * stiff, 1.1 * stiff
    for share in (0.93, 0.97, 1.0, 1.03, 1.07):
        w = share * np.sqrt(stiff)
        square = -(w**2) - (a + b) / 2 + np.sqrt(((a - b) / 2) ** 2 + 2 * (a + b) * w**2)
        growth = np.sqrt(max(square, 0.0))
        lines = sb.crankshaft.rotor.campbell(
            rotor, [w], sb.crankshaft.rotor.bearing_springs(rotor, 1e12, axial=1e12), count=4
        )
        assert lines.growth.max() == pytest.approx(growth, rel=2e-4, abs=0.02)
        made = sb.crankshaft.rotor.system_on_supports(
            rotor, [sb.crankshaft.rotor.Support(1e12, 1e-3)] * 2, w
        )
        found = sb.crankshaft.steady_state(made, steps=180, method="radau-iia-9").multipliers
        assert found is not None
        assert np.log(np.abs(found).max()) * w / (2 * np.pi) == pytest.approx(growth, rel=1e-3, abs=0.05)


@pytest.mark.parametrize("stiffness", [1e9, 1e12, 1e15])
@pytest.mark.parametrize("density", [7850.0, 1e-3])
def test_stiff_springs_hide_no_slow_mode_from_the_campbell_diagram(density, stiffness):
    """In turning and in stationary axes alike: a heavy disc on a light shaft, roots far apart."""
    weight = sb.crankshaft.Disc(20.0, 0.2, 0.1)
    rotor = sb.crankshaft.rotor.shaft(
        [sb.crankshaft.rotor.Tube(1.0, 0.05)],
        {0.5: weight},
        (0.0, 1.0),
        sb.crankshaft.Material(density=density),
    )
    lines = sb.crankshaft.rotor.campbell(
        rotor, [0.0, 50.0, 100.0], sb.crankshaft.rotor.bearing_springs(rotor, stiffness, axial=stiffness)
    )
    expected = sb.crankshaft.rotor.whirl(
        rotor, [sb.crankshaft.rotor.Support(stiffness)] * 2, 100.0
    ).frequencies[:4]
    found = lines.stationary[-1][lines.lateral[-1]][:4]
    assert np.sort(found) == pytest.approx(np.sort(expected), rel=1e-6)


def test_weight_is_carried_by_the_supports():
    rotor = two_discs()
    steady = sb.crankshaft.steady_state(
        sb.crankshaft.rotor.system_on_supports(
            rotor, [sb.crankshaft.rotor.Support(1e6, 3e3)] * 2, FAST, weight=True
        ),
        steps=90,
    )
    weight = rotor.mass[0::6, 0::6].sum() * 9.80665
    assert steady.bearing.sum(axis=1)[:, 0] == pytest.approx(weight, rel=1e-6)
    assert np.abs(steady.bearing.sum(axis=1)[:, 1]).max() < 1e-6 * weight


def test_refusals():
    rotor, plain = two_discs(), [sb.crankshaft.rotor.Tube(1.0, 0.05)]
    two = [sb.crankshaft.rotor.Support(1e6)] * 2
    for call, words in (
        (
            lambda: sb.crankshaft.rotor.whirl(rotor, [sb.crankshaft.rotor.Support(1e6)], 0.0),
            "1 supports: must be one a bearing, 2",
        ),
        (
            lambda: sb.crankshaft.rotor.whirl(rotor, [sb.crankshaft.rotor.Support(1e6)] * 2, np.nan),
            "speed = nan rad/s: must be finite",
        ),
        (lambda: sb.crankshaft.rotor.Support([1.0, 2.0, 3.0]), "support stiffness of shape"),
        (
            lambda: sb.crankshaft.rotor.Support(1e6, tilt=-1.0),
            "support tilt = -1.0: must be finite, not negative",
        ),
        (
            lambda: sb.crankshaft.rotor.critical_speeds(rotor, [sb.crankshaft.rotor.Support(0.0)] * 2),
            "must hold the rotor",
        ),
        (
            lambda: sb.crankshaft.rotor.critical_speeds(
                rotor, [sb.crankshaft.rotor.Support(1e6, 1.0)] * 2
            ),
            "most: must be given",
        ),
        (
            lambda: sb.crankshaft.rotor.unbalance_response(rotor, two, {0.33: 1.0}, [1.0]),
            "place = 0.33 m",
        ),
        (
            lambda: sb.crankshaft.rotor.shaft(plain, {0.5: sb.crankshaft.Disc(-1.0, 1.0, 1.0)}),
            "mass = -1.0: must be finite",
        ),
        (
            lambda: sb.crankshaft.rotor.shaft(plain, {0.5: sb.crankshaft.Disc(1.0, 3.0, 1.0)}),
            "polar = 3.0: must be at most",
        ),
        (
            lambda: sb.crankshaft.rotor.shaft([sb.crankshaft.rotor.Tube(1.0, 0.05, elements=2.5)]),
            "whole number of elements",
        ),  # pyright: ignore
        (
            lambda: sb.crankshaft.rotor.shaft(plain, material=sb.crankshaft.Material(young=-1.0)),
            "young = -1.0",
        ),
        (lambda: sb.crankshaft.rotor.campbell(rotor, [np.nan]), "speed = nan"),
        (lambda: sb.crankshaft.rotor.natural_modes(rotor, 3, np.eye(3)), "support of shape"),
        (lambda: sb.crankshaft.rotor.torsional_chain(["a", 1.0], [1.0]), "must be two lists of numbers"),  # pyright: ignore
        (
            lambda: sb.crankshaft.equilibrium(
                sb.crankshaft.Bearing(0.1, 0.03, 1e-4, 0.1), [1.0, 0.0], 0.0
            ),
            "journal that turns",
        ),
    ):
        with pytest.raises(sb.SymbalanceError, match=words):
            call()


def test_a_crank_is_not_round():
    web = sb.crankshaft.Web(0.02, 0.08, 0.04, 0.04)
    journal, pin = sb.crankshaft.Journal(0.06, 0.03), sb.crankshaft.Pin(0.05, 0.03, 0.04, 0.0, (1,))
    crank = sb.crankshaft.assemble(sb.crankshaft.Crank((journal, web, pin, web, journal)))
    with pytest.raises(sb.SymbalanceError, match="must look alike from all sides"):
        sb.crankshaft.rotor.whirl(crank, [sb.crankshaft.rotor.Support(1e8)] * 2, 100.0)
    made = sb.crankshaft.rotor.system_on_supports(
        crank, [sb.crankshaft.rotor.Support((1e8, 5e7), 1e4)] * 2, 100.0
    )
    found = sb.crankshaft.steady_state(made, steps=180).multipliers
    assert found is not None
    assert np.abs(found).max() < 1


def oscillator(**changed):
    from dataclasses import replace

    none = sb.crankshaft.Film(*[lambda theta: np.zeros((len(theta), 0, 2, 2))] * 2)
    push = lambda theta: np.cos(theta)[:, None] * np.ones(2)  # noqa: E731
    matrices = np.eye(2), 0.1 * np.eye(2), 4 * np.eye(2), np.zeros((0, 2, 2))
    return replace(sb.crankshaft.PeriodicSystem(*matrices, none, None, push, 1.0, 2 * np.pi), **changed)


def test_a_system_without_bearings_swings_as_the_formula_says():
    for method in ("radau-iia", "radau-iia-9", "newmark"):
        found = sb.crankshaft.steady_state(oscillator(), method=method, steps=360)
        expected = (np.exp(1j * found.theta) / (3 + 0.1j)).real
        assert np.abs(found.position[:, 0] - expected).max() < (1e-4 if method == "newmark" else 1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("steps", [64, 720])
def test_a_resonance_without_damping_is_refused_and_with_a_little_it_is_not(steps):
    at_rest = {"stiffness": np.eye(2), "omega": 1.0}
    with pytest.raises(sb.SymbalanceError, match="a resonance that nothing damps"):
        sb.crankshaft.steady_state(oscillator(damping=np.zeros((2, 2)), **at_rest), steps=steps)
    little = sb.crankshaft.steady_state(oscillator(damping=1e-4 * np.eye(2), **at_rest), steps=720)
    assert np.abs(little.position).max() == pytest.approx(1e4, rel=1e-3)


@pytest.mark.parametrize(
    ("changed", "words"),
    [
        ({"mass": np.zeros((2, 2))}, "the mass matrix: must be positive definite"),
        ({"mass": np.diag([1.0, 0.0])}, "the mass matrix: must be positive definite"),
        ({"damping": np.eye(3)}, "damping of shape .3, 3.: must be .2, 2."),
        ({"points": np.zeros((1, 2, 2))}, "film stiffness at one angle of shape"),
        ({"force": np.cos}, "force at one angle of shape"),
        ({"cycle": 0.0}, "cycle = 0.0 rad: must be positive"),
    ],
)
def test_systems_that_none_are(changed, words):
    with pytest.raises(sb.SymbalanceError, match=words):
        sb.crankshaft.steady_state(oscillator(**changed), steps=36)
