"""Published rotors: whirl frequencies at standstill and at 4000 rpm, from the equations in turning axes.

Source: M. I. Friswell, J. E. T. Penny, S. D. Garvey, A. W. Lees, Dynamics of Rotating Machines (2010),
examples 5.9.1, 5.9.2, 5.9.5 and 5.9.9; the figures as the tests of the open rotor-dynamics software ROSS
(Petrobras) quote them, rad/s to a thousandth, the damped ones in Hz to a hundredth. E = 211 GPa, G = 81.2
GPa, 7810 kg/m^3; a shaft 1.5 m long, 50 mm thick, with discs 70 mm thick.
"""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import eigh

from symbalance.crankshaft.frames import turned_damping, turned_stiffness
from symbalance.crankshaft.rotor.rigid_bodies import node_matrices

E, SHEAR, DENSITY, DIAMETER, LENGTH = 211e9, 81.2e9, 7810.0, 0.05, 1.5
NODES = 61
USED = [0, 1, 3, 4]  # u, v, theta_u, theta_v of a node
FAST = 4000 * np.pi / 30
TWO = ((1 / 3, 0.28), (2 / 3, 0.35))
"""Discs: their place along the shaft and their diameter."""


def cylinder(diameter: float, length: float, bore: float = 0.0) -> tuple[float, np.ndarray]:
    mass = DENSITY * np.pi / 4 * (diameter**2 - bore**2) * length
    square = (diameter**2 + bore**2) / 4
    diametral = mass * (square / 4 + length**2 / 12)
    return mass, np.diag([diametral, diametral, mass * square / 2])


def bending(length: float) -> np.ndarray:
    """Return a Timoshenko beam's stiffness for u, theta_v at both ends (u' = theta_v)."""
    EI, area, nu = E * np.pi * DIAMETER**4 / 64, np.pi * DIAMETER**2 / 4, E / (2 * SHEAR) - 1
    corrected = 6 * (1 + nu) / (7 + 6 * nu)  # Cowper 1966
    phi = 12 * EI / (corrected * SHEAR * area * length**2)
    a, b, c, d = 12, 6 * length, (4 + phi) * length**2, (2 - phi) * length**2
    rows = [[a, b, -a, b], [b, c, -b, d], [-a, -b, a, -b], [b, d, -b, c]]
    return EI / (length**3 * (1 + phi)) * np.array(rows)


def rotor(discs) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return M, G, dK, K of the free shaft, every slice of it a rigid body at its node."""
    step, n = LENGTH / (NODES - 1), 4 * NODES
    M, G, dK, K = (np.zeros((n, n)) for _ in range(4))

    def add(node, mass, tensor):
        here = slice(4 * node, 4 * node + 4)
        for whole, part in zip((M, G, dK), node_matrices(mass, np.zeros(3), tensor), strict=True):
            whole[here, here] += part[np.ix_(USED, USED)]

    for node in range(NODES):
        add(node, *cylinder(DIAMETER, step / (1 + (node in (0, NODES - 1)))))
    for place, diameter in discs:
        add(round(place * (NODES - 1)), *cylinder(diameter, 0.07, DIAMETER))
    beam, sign = bending(step), np.array([1, -1, 1, -1])
    for node in range(NODES - 1):
        u, v = (4 * node + np.array(which) for which in ([0, 3, 4, 7], [1, 2, 5, 6]))
        K[np.ix_(u, u)] += beam
        K[np.ix_(v, v)] += beam * np.outer(sign, sign)
    return M, G, dK, K


def at_bearings(places, blocks) -> np.ndarray:
    whole = np.zeros((4 * NODES, 4 * NODES))
    for place, block in zip(places, blocks, strict=True):
        here = slice(4 * round(place * (NODES - 1)), 4 * round(place * (NODES - 1)) + 2)
        whole[here, here] += block
    return whole


def whirls(discs, places, stiffness, damping, omega) -> np.ndarray:
    """Return the stationary roots of an isotropic rotor, forward ones with a positive imaginary part.

    z = u + i v moves alone: v = -i u, theta_u = i theta_v. Turning roots are stationary ones - i omega.
    """
    M, G, dK, K = rotor(discs)
    bearing = stiffness * np.eye(2), damping * np.eye(2)
    D = omega * G + at_bearings(places, [turned_damping(bearing[1], 0.0)] * 2)
    S = K + omega**2 * dK + at_bearings(places, [turned_stiffness(*bearing, 0.0, omega)] * 2)
    n = 2 * NODES
    line = np.zeros((2 * n, n), dtype=complex)
    for node in range(NODES):
        line[4 * node : 4 * node + 2, 2 * node] = 1, -1j
        line[4 * node + 2 : 4 * node + 4, 2 * node + 1] = 1j, 1
    M, D, S = (line.conj().T @ matrix @ line / 2 for matrix in (M, D, S))
    rest = np.linalg.inv(M)
    found = np.linalg.eigvals(np.block([[np.zeros((n, n)), np.eye(n)], [-rest @ S, -rest @ D]]))
    return found + 1j * omega


def lowest(roots: np.ndarray, count: int = 6) -> np.ndarray:
    return roots[np.argsort(np.abs(roots))][:count]


@pytest.mark.parametrize(
    ("discs", "places", "stiffness", "omega", "published"),
    [
        (TWO, (0, 1), 1e6, 0.0, [86.66, 86.66, 274.31, 274.31, 716.78, 716.78]),
        (TWO, (0, 1), 1e6, FAST, [85.39, 87.80, 251.78, 294.71, 600.18, 827.08]),
        (((1, 0.35),), (0, 2 / 3), 1e7, 0.0, [90.14, 90.14, 630.73, 630.73, 830.43, 830.43]),
        (((1, 0.35),), (0, 2 / 3), 1e7, FAST, [76.19, 103.91, 565.99, 634.23, 647.75, 1174.2]),
    ],
    ids=["two discs at rest", "two discs", "overhung at rest", "overhung"],
)
def test_whirl_frequencies(discs, places, stiffness, omega, published):
    found = whirls(discs, places, stiffness, 0.0, omega)
    assert np.abs(found.real).max() < 1e-6 * np.abs(found).max()
    np.testing.assert_allclose(np.abs(lowest(found)), published, rtol=2e-3)


def test_whirl_in_damped_bearings():
    """3 kN s/m each: the circulatory part of the damping is what keeps these roots where they are."""
    for omega, natural, damped in (
        (0.0, [13.91, 13.91, 48.18, 48.18, 137.06, 137.06], [13.89, 13.89, 46.54, 46.54, 103.22, 103.22]),
        (
            FAST,
            [13.70, 14.09, 43.61, 52.18, 122.37, 149.81],
            [13.68, 14.07, 41.98, 50.65, 104.25, 105.66],
        ),
    ):
        found = lowest(whirls(TWO, (0, 1), 1e6, 3e3, omega)) / (2 * np.pi)
        np.testing.assert_allclose(np.abs(found), natural, rtol=1e-2)
        np.testing.assert_allclose(np.abs(found.imag), damped, rtol=1e-2)
        assert found.real.max() < 0


@pytest.mark.slow
def test_uneven_bearings_by_floquet():
    """Bearings of 1 and 0.8 MN/m turn against the shaft: multipliers of a turn are exp(i nu T)."""
    published = np.array([82.33, 86.86, 239.64, 287.25, 583.49, 806.89])
    M, G, dK, K = rotor(TWO)
    block = np.diag([1e6, 8e5])
    modes = eigh(K + at_bearings((0, 1), [0.9e6 * np.eye(2)] * 2), M)[1][:, :32]
    D, fixed = (modes.T @ matrix @ modes for matrix in (FAST * G, K + FAST**2 * dK))
    ends = [modes[4 * node : 4 * node + 2] for node in (0, NODES - 1)]
    n = len(D)

    def slope(t, state):
        x, v = state.reshape(2, n, 2 * n)
        turned = turned_stiffness(block, np.zeros((2, 2)), FAST * t, FAST)
        S = fixed + sum(end.T @ turned @ end for end in ends)
        return np.concatenate([v, -S @ x - D @ v]).ravel()

    period = 2 * np.pi / FAST
    options = {"method": "DOP853", "rtol": 1e-7, "atol": 1e-9}
    end = solve_ivp(slope, (0, period), np.eye(2 * n).ravel(), **options).y[:, -1]
    multipliers = np.linalg.eigvals(end.reshape(2 * n, 2 * n))
    assert np.abs(np.abs(multipliers) - 1).max() < 1e-3

    def distance(nu):
        return np.abs(multipliers - np.exp(1j * nu * period)).min() / (nu * period)

    assert max(distance(nu) for nu in published) < 1e-3
    assert distance(85.39) > 5e-3  # with even bearings the first would be there
