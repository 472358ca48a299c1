"""Rotors whose behaviour is known in closed form, built from the node's matrices, in both frames."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import quad, solve_ivp
from scipy.linalg import expm
from scipy.optimize import brentq

from symbalance.crankshaft.frames import QUARTER_TURN, gravity, rotation, turned_damping, turned_stiffness
from symbalance.crankshaft.rotor.rigid_bodies import node_force, node_matrices
from symbalance.crankshaft.rotor.rigid_body_mode import deflated, spin_motion, without_unknown

NOWHERE = np.zeros(3)
SHIFTS, TILTS = slice(0, 2), slice(3, 5)


def state_matrix(M, D, S):
    n = len(M)
    inverse = np.linalg.inv(M)
    return np.block([[np.zeros((n, n)), np.eye(n)], [-inverse @ S, -inverse @ D]])


def roots(M, D, S):
    return np.linalg.eigvals(state_matrix(M, D, S))


def growth(M, D, S):
    return roots(M, D, S).real.max()


def frequencies(M, D, S):
    """Return the whirl frequencies of an undamped system, the conjugates left out."""
    found = roots(M, D, S)
    assert np.abs(found.real).max() < 1e-6 * np.abs(found).max()
    return np.sort(found.imag[found.imag > 0])


# --- a free body: Euler's top -----------------------------------------------------------------------


@pytest.mark.parametrize("moments", [(1.0, 3.0, 2.0), (3.0, 1.0, 2.0), (1.0, 2.0, 3.0), (2.0, 3.0, 1.0)])
def test_rotation_about_a_principal_axis(moments):
    """s^2 = -omega^2 (I_w - I_u)(I_w - I_v)/(I_u I_v): unstable about the middle axis only (Euler)."""
    omega, (I_u, I_v, I_w) = 7.0, moments
    M, G, dK = (matrix[TILTS, TILTS] for matrix in node_matrices(1.0, NOWHERE, np.diag(moments)))
    found = roots(M, omega * G, omega**2 * dK)
    square = -(omega**2) * (I_w - I_u) * (I_w - I_v) / (I_u * I_v)
    # the frame's own spin is the other pair, +-i omega: a top tilted at rest in space
    for expected in (np.sqrt(complex(square)), 1j * omega):
        for sign in (1, -1):
            assert np.abs(found - sign * expected).min() < 1e-6
    assert (growth(M, omega * G, omega**2 * dK) > 0.1) == (sorted(moments)[1] == I_w)


def test_a_free_mass_stays_where_it_is_in_space():
    """Seen from the turning frame a point at rest circles backward at omega, and drifts if it moves."""
    omega = 3.0
    M, G, dK = (m[SHIFTS, SHIFTS] for m in node_matrices(2.0, NOWHERE, np.eye(3)))
    A = state_matrix(M, omega * G, omega**2 * dK)
    start, speed = np.array([0.3, -0.2]), np.array([0.5, 0.1])
    turning_speed = speed - omega * QUARTER_TURN @ start
    for t in (0.4, 1.9):
        there = (expm(A * t) @ [*start, *turning_speed])[:2]
        np.testing.assert_allclose(rotation(omega * t) @ there, start + speed * t, atol=1e-12)


# --- the shaft of unequal stiffness -----------------------------------------------------------------


def uneven(omega):
    M, G, dK = (m[SHIFTS, SHIFTS] for m in node_matrices(1.0, NOWHERE, np.eye(3)))
    return M, omega * G, np.diag([0.81, 1.21]) + omega**2 * dK


def test_an_uneven_shaft_is_unstable_between_its_two_critical_speeds():
    """Exactly for 0.9 < omega < 1.1 = sqrt(k_u), sqrt(k_v); growth 0.099504 at omega = 1."""
    assert growth(*uneven(1.0)) == pytest.approx(0.099504, abs=5e-7)
    unstable = [omega for omega in np.arange(0.8, 1.2, 0.001) if growth(*uneven(omega)) > 1e-4]
    assert min(unstable) == pytest.approx(0.901)
    assert max(unstable) == pytest.approx(1.099)
    for edge in (0.9, 1.1):
        within = np.sign(1 - edge)
        assert growth(*uneven(edge + within * 1e-5)) > 1e-4
        assert growth(*uneven(edge - within * 1e-5)) < 1e-7


def test_an_uneven_shaft_by_floquet_in_the_stationary_frame():
    """x'' + R K R^T x = 0 has the period pi/omega: no turning frame, no gyroscopic matrix."""

    def slope(t, state):
        x, v = state.reshape(2, 2, 4)
        turn = rotation(t)
        return np.concatenate([v, -(turn @ np.diag([0.81, 1.21]) @ turn.T) @ x]).ravel()

    half_turn = solve_ivp(slope, (0, np.pi), np.eye(4).ravel(), rtol=1e-11, atol=1e-13).y[:, -1]
    multipliers = np.linalg.eigvals(half_turn.reshape(4, 4))
    assert np.log(np.abs(multipliers).max()) / np.pi == pytest.approx(growth(*uneven(1.0)), abs=1e-9)


# --- damping that turns, damping that stands --------------------------------------------------------


@pytest.mark.parametrize(("inner", "outer"), [(0.02, 0.03), (0.1, 0.05), (0.01, 0.0)])
def test_internal_damping_sets_in_at_its_speed(inner, outer):
    """A Jeffcott rotor is stable below omega_n (1 + c_e/c_i) and no further (Smith 1933)."""
    M, G, dK = (m[SHIFTS, SHIFTS] for m in node_matrices(2.0, NOWHERE, np.eye(3)))
    k = 2.0 * 5.0**2

    def rate(omega):
        C = inner * np.eye(2) + turned_damping(outer * np.eye(2), 0.0)
        S = k * np.eye(2) + turned_stiffness(np.zeros((2, 2)), outer * np.eye(2), 0.0, omega)
        return growth(M, C + omega * G, S + omega**2 * dK)

    onset = 5.0 * (1 + outer / inner)
    assert brentq(rate, 0.6 * onset, 1.5 * onset, xtol=1e-10) == pytest.approx(onset, rel=1e-7)


def test_stationary_damping_without_its_circulatory_part_would_not_stabilise():
    """Left out, as the paper leaves it, stationary damping acts as if it turned: onset at omega_n."""
    M, G, dK = (m[SHIFTS, SHIFTS] for m in node_matrices(2.0, NOWHERE, np.eye(3)))
    C, K, omega = 0.3 * np.eye(2), 50.0 * np.eye(2), 6.0  # omega_n = 5
    whole = turned_stiffness(K, C, 0.0, omega)
    assert growth(M, C + omega * G, whole + omega**2 * dK) == pytest.approx(-0.3 / 4, rel=1e-3)
    assert growth(M, C + omega * G, K + omega**2 * dK) > 1e-3


# --- discs with gyroscopic moments ------------------------------------------------------------------


@pytest.mark.parametrize("polar", [0.5, 1.0, 1.9])
def test_a_tilting_disc_whirls_as_the_textbook_has_it(polar):
    """nu = I_p omega/(2 I_d) +- sqrt((I_p omega/(2 I_d))^2 + k/I_d) (Stodola), shifted."""
    diametral, k, omega = 1.0, 40.0, 11.0
    M, G, dK = (
        m[TILTS, TILTS] for m in node_matrices(1.0, NOWHERE, np.diag([diametral, diametral, polar]))
    )
    half = polar * omega / (2 * diametral)
    whirl = half + np.array([1, -1]) * np.sqrt(half**2 + k / diametral)
    found = frequencies(M, omega * G, k * np.eye(2) + omega**2 * dK)
    np.testing.assert_allclose(found, np.sort(np.abs(whirl - omega)), rtol=1e-9)


def overhung(length=0.4, EI=1e4):
    """Return stiffness at the end of a cantilever for (u, theta_v) and so for (v, -theta_u)."""
    coupling = -6 / length**2
    return EI * np.array([[12 / length**3, coupling], [coupling, 4 / length]])


def overhung_matrices(omega, mass=5.0, diametral=0.04, polar=0.075):
    M, G, dK = node_matrices(mass, NOWHERE, np.diag([diametral, diametral, polar]))
    K = np.zeros((6, 6))
    K[np.ix_([0, 4], [0, 4])] = overhung()
    K[np.ix_([1, 3], [1, 3])] = overhung() * [[1, -1], [-1, 1]]
    rows = np.ix_([0, 1, 3, 4], [0, 1, 3, 4])
    return M[rows], omega * G[rows], (K + omega**2 * dK)[rows]


@pytest.mark.parametrize("omega", [0.0, 120.0, 300.0, 900.0])
def test_an_overhung_disc_whirls_at_the_roots_of_the_published_quartic(omega):
    """One complex line u + i v of the stationary frame, force and moment of the disc on the shaft's end:

    det [[k11 - m nu^2, k12], [k12, k22 - I_d nu^2 + I_p omega nu]] = 0, four real roots nu.
    """
    mass, diametral, polar = 5.0, 0.04, 0.075
    (k11, k12), (_, k22) = overhung()
    quartic = np.polysub(np.polymul([-mass, 0, k11], [-diametral, polar * omega, k22]), [k12**2])
    whirl = np.roots(quartic)
    assert np.abs(whirl.imag).max() == 0
    found = roots(*overhung_matrices(omega)).imag
    expected = np.concatenate([whirl.real - omega, omega - whirl.real])
    np.testing.assert_allclose(np.sort(found), np.sort(expected), rtol=1e-6, atol=1e-4)


def test_a_thin_overhung_disc_has_no_second_forward_critical_speed():
    """With I_p > I_d the second forward whirl outruns the shaft: k22 + (I_p - I_d) nu^2 > 0.

    A forward critical speed is a zero of the stiffness in the turning frame, in both planes at once.
    """

    def passed(polar, speed):
        stiffness = overhung_matrices(speed, polar=polar)[2]
        return int((np.linalg.eigvalsh(stiffness) < 0).sum()) // 2

    assert [passed(0.076, speed) for speed in (10.0, 1e3, 1e4, 1e5)] == [0, 1, 1, 1]
    assert [passed(0.02, speed) for speed in (10.0, 1e3, 1e4, 1e5)] == [0, 1, 2, 2]


def flexible(seed=0):
    """Return a symmetric shaft on symmetric bearings, as three general round discs on random springs."""
    rng = np.random.default_rng(seed)
    M, G, dK, K = (np.zeros((18, 18)) for _ in range(4))
    moments = [(0.02, 0.02, 0.035), (0.03, 0.03, 0.03), (0.05, 0.05, 0.08)]
    for i, tensor in enumerate(moments):
        here = slice(6 * i, 6 * i + 6)
        M[here, here], G[here, here], dK[here, here] = node_matrices(
            rng.uniform(1, 3), (0, 0, 0.02 * i), np.diag(tensor), (0, 0, 0.1 * i)
        )
    one = rng.normal(size=(6, 6))
    plane = 1e4 * (one @ one.T + np.eye(6))
    bending = [0, 4, 6, 10, 12, 16], [1, 3, 7, 9, 13, 15]
    signs = np.array([1, -1] * 3)
    K[np.ix_(bending[0], bending[0])] = plane
    K[np.ix_(bending[1], bending[1])] = plane * np.outer(signs, signs)
    chain = 1e4 * np.array([[2, -1, 0], [-1, 2, -1], [0, -1, 2.0]])
    for axis in (2, 5):
        K[axis::6, axis::6] = chain
    return M, G, dK, K


def test_a_symmetric_rotor_is_the_same_in_both_frames():
    """Every whirl frequency shifts by omega; what turns about W, or moves along it, does not."""
    omega = 90.0
    M, G, dK, K = flexible()
    turning = roots(M, omega * G, K + omega**2 * dK).imag
    # in the stationary frame: no Coriolis, no centrifugal terms, the polar moments alone
    standing = np.zeros_like(G)
    for i, polar in enumerate((0.035, 0.03, 0.08)):
        standing[6 * i + 3, 6 * i + 4], standing[6 * i + 4, 6 * i + 3] = polar, -polar
    free = roots(M, omega * standing, K).imag
    axial = [i for i in range(18) if i % 6 in (2, 5)]
    along = roots(*(m[np.ix_(axial, axial)] for m in (M, 0 * M, K))).imag
    across = [i for i in range(18) if i not in axial]
    vectors = np.linalg.eig(state_matrix(M, omega * standing, K))
    lines = [value.imag for value, x in zip(*vectors_of(vectors), strict=True) if forward(x[:18], across)]
    expected = np.concatenate([np.array(lines) - omega, omega - np.array(lines), along])
    assert len(lines) == 12
    assert len(free) == len(expected)
    np.testing.assert_allclose(np.sort(turning), np.sort(expected), rtol=1e-6, atol=1e-5)


def vectors_of(pair):
    values, columns = pair
    return values, columns.T


def forward(shape, across):
    """Whether x = a exp(i nu t) is a motion u + i v ~ exp(i nu t): then v = -i u."""
    u, v = shape[0::6], shape[1::6]
    weight = np.abs(shape[across]).max()
    return weight > 1e-8 * np.abs(shape).max() and np.abs(v + 1j * u).max() < 1e-6 * weight


# --- energy and loads -------------------------------------------------------------------------------


def uneven_rotor():
    """Return two general bodies joined by an uneven spring and tied softly to the frame's axis."""
    rng = np.random.default_rng(3)
    M, G, dK, F = np.zeros((12, 12)), np.zeros((12, 12)), np.zeros((12, 12)), np.zeros(12)
    for i in range(2):
        here, point = slice(6 * i, 6 * i + 6), rng.uniform(-0.1, 0.1, 3)
        mass, offset = rng.uniform(1, 2), rng.uniform(-0.02, 0.02, 3)
        tensor = np.diag(rng.uniform(0.01, 0.02, 3)) + 0.002 * (1 - np.eye(3))
        M[here, here], G[here, here], dK[here, here] = node_matrices(mass, offset, tensor, point)
        F[here] = node_force(mass, point, offset, tensor)
    one = rng.normal(size=(12, 12))
    return M, G, dK, F, 200 * (one @ one.T) + 50 * np.eye(12)


def test_jacobi_integral_is_conserved_without_damping():
    """x'.M x'/2 + x.(K + omega^2 dK) x/2 - omega^2 F_M.x is constant: G does no work."""
    omega = 9.0
    M, G, dK, F, K = uneven_rotor()
    S = K + omega**2 * dK
    rest = np.linalg.solve(S, omega**2 * F)
    A = state_matrix(M, omega * G, S)
    rng = np.random.default_rng(4)
    start = rng.normal(size=24) * 1e-3

    def integral(t):
        x, v = (expm(A * t) @ (start - [*rest, *np.zeros(12)])).reshape(2, 12)
        x = x + rest
        return v @ M @ v / 2 + x @ S @ x / 2 - omega**2 * F @ x

    values = [integral(t) for t in (0.0, 0.31, 1.7)]
    assert np.ptp(values) < 1e-10 * abs(values[0])
    assert abs(start[12:] @ G @ start[12:]) < 1e-18


def test_gravity_makes_a_shaft_sag_in_space():
    """In the turning frame the load turns backward; the answer is a constant sag -m g/k in X."""
    mass, k, omega = 3.0, 2e4, 40.0
    M, G, dK = (m[SHIFTS, SHIFTS] for m in node_matrices(mass, NOWHERE, np.eye(3)))
    S = k * np.eye(2) + omega**2 * dK
    weight = mass * 9.80665 * np.array([-1, -1j])
    harmonic = np.linalg.solve(S - omega**2 * M + 1j * omega * (omega * G), weight)
    for theta in (0.0, 0.7, 3.0):
        load = mass * gravity(theta)[:2]
        np.testing.assert_allclose(load, (weight * np.exp(1j * theta)).real)
        sag = rotation(theta) @ (harmonic * np.exp(1j * theta)).real
        np.testing.assert_allclose(sag, [-mass * 9.80665 / k, 0], atol=1e-12)


def test_an_unbalanced_rotor_bows_out_as_jeffcott_says():
    """r = e omega^2/(omega_n^2 - omega^2): in the turning frame a static load (Jeffcott 1919)."""
    mass, k, e = 2.0, 2.0 * 50.0**2, 1e-4
    M, _, dK = node_matrices(mass, (e, 0, 0), np.eye(3))
    force = node_force(mass, NOWHERE, (e, 0, 0), np.eye(3))
    for omega in (20.0, 45.0, 80.0):
        bow = np.linalg.solve((k * np.eye(6) + omega**2 * dK)[:2, :2], omega**2 * force[:2])
        assert bow[0] == pytest.approx(e * omega**2 / (50.0**2 - omega**2), rel=1e-12)
    assert M[1, 5] == mass * e


def test_a_rotor_that_speeds_up_follows_newton():
    """A mass on a turning spring through omega(t) = a t: Euler's force and Coriolis'."""
    k, alpha, e = 30.0, 1.5, 0.2

    def stationary(t, state):
        x, v = state.reshape(2, 2)
        turn = rotation(alpha * t**2 / 2)
        return np.concatenate([v, -k * (x - turn @ [e, 0])])

    M, G, dK = (m[SHIFTS, SHIFTS] for m in node_matrices(1.0, NOWHERE, np.eye(3)))
    point = np.array([e, 0.0])

    def turning(t, state):
        z, dz = state.reshape(2, 2)
        omega = alpha * t
        euler = alpha * QUARTER_TURN
        force = -omega * G @ dz - (omega**2 * dK + euler + k * np.eye(2)) @ z
        force = force + (omega**2 * np.eye(2) - euler) @ point
        return np.concatenate([dz, np.linalg.solve(M, force)])

    options = {"rtol": 1e-11, "atol": 1e-13}
    fixed = solve_ivp(stationary, (0, 3), [e, 0, 0, 0], **options).y[:2, -1]
    moved = solve_ivp(turning, (0, 3), [0, 0, 0, 0], **options).y[:2, -1]
    np.testing.assert_allclose(rotation(alpha * 9 / 2) @ (point + moved), fixed, atol=1e-9)


def test_the_centrifugal_couple_of_a_tilted_rod():
    """A thin rod tilted to the axis: (I_diametral) sin cos = the moments of its pieces, integrated."""
    mass, length, tilt = 2.0, 0.3, 0.4
    along = np.array([np.sin(tilt), 0.0, np.cos(tilt)])
    tensor = mass * length**2 / 12 * (np.eye(3) - np.outer(along, along))
    couple = node_force(mass, NOWHERE, NOWHERE, tensor)[3:]
    piece = quad(lambda s: mass / length * s**2 * along[2] * along[0], -length / 2, length / 2)[0]
    np.testing.assert_allclose(couple, [0, piece, 0], atol=1e-12)


# --- the free spin of a flexible rotor --------------------------------------------------------------


def test_the_free_spin_of_a_flexible_rotor_is_false_and_taken_out():
    """Two off-axis discs on a spring that lets the rotor turn as a whole, in a bearing each."""
    omega = 230.0
    points = np.array([[0.05, 0.0, 0.0], [-0.05, 0.0, 0.1]])
    M, G, dK = (np.zeros((12, 12)) for _ in range(3))
    for i, point in enumerate(points):
        here = slice(6 * i, 6 * i + 6)
        M[here, here], G[here, here], dK[here, here] = node_matrices(
            3.0, NOWHERE, np.diag([4e-3, 4e-3, 8e-3]), point
        )
    spin = spin_motion(points)
    rng = np.random.default_rng(5)
    any_springs = rng.normal(size=(12, 12))
    rest = np.eye(12) - np.outer(spin, spin) / (spin @ spin)
    K = 1e7 * rest @ (any_springs @ any_springs.T + np.eye(12)) @ rest
    rate = growth(M, omega * G, K + omega**2 * dK)
    stated = omega * np.sqrt(-(spin @ dK @ spin) / (spin @ M @ spin))
    assert rate == pytest.approx(stated, rel=0.05)
    assert rate > 100
    flat = deflated(dK, M, spin)
    assert growth(M, omega * G, K + omega**2 * flat) < 0.01 * rate
    kept = [without_unknown(m, 11) for m in (M, omega * G, K + omega**2 * dK)]
    assert growth(*kept) < 0.01 * rate
