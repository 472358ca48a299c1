"""Each standard formula gives what another route computes: integrals, eigenvalues, paths, tensors."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise

import pytest
from mpmath import mp, mpf

from symbalance.document.formula import Formula, names
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.algebra.tree_values import TreeValues
from symbalance.notes.checking.meant.catalogue import QUANTITIES, Quantity
from tests.independent.balance_cases import BALANCE_CASES
from tests.independent.catalogue_cases import CASES as OTHER_CASES
from tests.independent.round_body_cases import ROUND_BODIES
from tests.independent.section_and_firing_cases import SECTIONS_AND_FIRING
from tests.independent.vibration_cases import VIBRATIONS
from tests.independent.wheel_and_cycle_cases import WHEELS_AND_CYCLES

F = Fraction
R, INNER = F(2, 100), F(1, 100)
MASS, RADIUS, LENGTH, RATE = F(7, 2), F(3, 10), F(6, 5), F(4000)
TORQUE, MOMENT, RIGIDITY = F(150), F(90), F(79 * 10**9)
OMEGA, PER_SECOND, CYLINDERS, FLUCTUATION = F(120), F(50), F(6), F(1, 40)
J1, J2 = F(3, 100), F(7, 100)


def over_section(function, inner=0):
    """Integrate a function of x and y over a circle, or over a ring."""
    return mp.quad(
        lambda r: mp.quad(
            lambda a: function(r * mp.cos(a), r * mp.sin(a)) * r, [0, 2 * mp.pi], maxdegree=4
        ),
        [mpf(inner.numerator) / inner.denominator if inner else 0, float(R)],
        maxdegree=4,
    )


def axial(inner=0):
    return over_section(lambda x, y: y * y, inner)


def polar(inner=0):
    return over_section(lambda x, y: x * x + y * y, inner)


def free_speed(masses, stiffness):
    """Return the largest eigenfrequency of J φ'' + K φ = 0."""
    size = len(masses)
    matrix = mp.matrix(size)
    for i in range(size):
        for k in range(size):
            matrix[i, k] = mpf(stiffness[i][k]) / mpf(float(masses[i]))
    return mp.sqrt(max(value.real for value in mp.eig(matrix)[0]))


def mises(stress, shear):
    """Return √(3/2 s:s) of the deviator of a plane state of stress."""
    tensor = mp.matrix([[stress, shear, 0], [shear, 0, 0], [0, 0, 0]])
    mean = sum(tensor[k, k] for k in range(3)) / 3
    return mp.sqrt(
        mp.mpf(3)
        / 2
        * sum((tensor[i, k] - (mean if i == k else 0)) ** 2 for i in range(3) for k in range(3))
    )


def disc_inertia():
    density = float(MASS) / (mp.pi * float(RADIUS) ** 2)
    return mp.quad(lambda r: density * 2 * mp.pi * r * r * r, [0, float(RADIUS)])


def along_rod(shift):
    return mp.quad(lambda x: float(MASS / LENGTH) * (x - shift) ** 2, [0, float(LENGTH)])


def circle_motion(order):
    """Return the size of the first or second derivative of a point on a circle, by small steps."""
    step, at = (
        mp.mpf(10) ** -6,
        [mp.expj(float(OMEGA) * k * mp.mpf(10) ** -6) * float(RADIUS) for k in (-1, 0, 1)],
    )
    return abs(at[2] - at[0]) / (2 * step) if order == 1 else abs(at[2] - 2 * at[1] + at[0]) / step**2


def piston_path():
    """Return what a piston travels in a turn: its steps one by one."""
    crank, rod, steps = mpf(float(RADIUS)), mpf(1), 4000
    places = [
        crank * mp.cos(t) + mp.sqrt(rod**2 - (crank * mp.sin(t)) ** 2)
        for t in (2 * mp.pi * k / steps for k in range(steps + 1))
    ]
    return sum(abs(b - a) for a, b in pairwise(places))


def known_values(inner=0):
    """Return numbers of all roles that belong together."""
    section = F(str(axial(inner)))
    return {
        "diameter": 2 * R,
        "radius": R,
        "outer": 2 * R,
        "inner": 2 * INNER,
        "section": section,
        "bending": MOMENT,
        "torque": TORQUE,
        "shear": RIGIDITY,
        "length": LENGTH,
    }


SPEED = F(str(float(OMEGA * RADIUS)))
TURN = F(str(OMEGA * F(str(1 / (2 * mp.pi)))))
SWING = F(1, 2) * J1 * ((OMEGA * (1 + FLUCTUATION / 2)) ** 2 - (OMEGA * (1 - FLUCTUATION / 2)) ** 2)
WHEEL = {
    "inertia": J1,
    "omega": OMEGA,
    "fluctuation": FLUCTUATION,
    "swing": SWING,
    "mass": J1 / RADIUS**2,
    "radius": RADIUS,
    "rotation": TURN,
    "velocity": SPEED,
}
POLAR, RING = F(str(polar())), F(str(polar(INNER)))
SOLID = known_values()
SHAFT = {**SOLID, "section": POLAR, "modulus": POLAR / R, "stiffness": RIGIDITY * POLAR / LENGTH}
MOVING = {
    "mass": MASS,
    "radius": RADIUS,
    "velocity": SPEED,
    "omega": OMEGA,
    "diameter": 2 * RADIUS,
    "rotation": TURN,
    "inertia": J1,
    "length": LENGTH,
    "weight": MASS * F(981, 100),
    "gravity": F(981, 100),
}
SPRING = {"stiffness": RATE, "mass": J1, "inertia": J1}
TWO = {"stiffness": RATE, "first_inertia": J1, "second_inertia": J2}
ONE_SPEED = free_speed([J1], [[4000]])
TWO_SPEED = free_speed([J1, J2], [[4000, -4000], [-4000, 4000]])
ENGINE = {
    "stroke": 2 * RADIUS,
    "crank": RADIUS,
    "rotation": PER_SECOND,
    "omega": F(str(2 * mp.pi * 50)),
    "diameter": 2 * R,
    "radius": R,
    "area": F(str(over_section(lambda x, y: 1))),
    "cylinders": CYLINDERS,
    "pressure": F(5 * 10**6),
}
AREA = over_section(lambda x, y: 1)

CASES = {
    "torsional stress of a round shaft": [
        (SHAFT, float(TORQUE * R) / polar()),
        ({**SHAFT, "section": RING}, float(TORQUE * R) / polar(INNER)),
    ],
    "bending stress of a round bar": [
        ({**SOLID, "modulus": SOLID["section"] / R}, float(MOMENT * R) / axial()),
        (SOLID, float(MOMENT * R) / axial(INNER)),
    ],
    "equivalent stress by von Mises": [({"stress": F(40), "shearing": F(27)}, mises(40, 27))],
    "equivalent stress by von Mises's hypothesis": [
        ({"stress": F(40), "shearing": F(27)}, mises(40, 27))
    ],
    "polar second moment of area of a round section": [(SHAFT, polar()), (SHAFT, polar(INNER))],
    "axial second moment of area of a round section": [(SOLID, axial()), (SOLID, axial(INNER))],
    "second moment of area of a round section": [(SOLID, axial()), (SOLID, axial(INNER))],
    "polar section modulus of a round section": [
        (SHAFT, polar() / float(R)),
        (SHAFT, polar(INNER) / float(R)),
    ],
    "section modulus of a round section in bending": [
        (SOLID, axial() / float(R)),
        (SOLID, axial(INNER) / float(R)),
    ],
    "section modulus of a round section": [(SOLID, axial() / float(R)), (SOLID, axial(INNER) / float(R))],
    "torsional stiffness of a round shaft": [
        (SHAFT, 1 / mp.quad(lambda x: 1 / (float(RIGIDITY) * polar()), [0, float(LENGTH)]))
    ],
    "angle of twist of a round shaft": [
        (SHAFT, mp.quad(lambda x: float(TORQUE) / (float(RIGIDITY) * polar()), [0, float(LENGTH)]))
    ],
    "natural angular frequency": [
        (SPRING, ONE_SPEED),
        (TWO, TWO_SPEED),
        ({"frequency": TURN}, float(OMEGA)),
    ],
    "natural frequency in cycles": [
        (SPRING, ONE_SPEED / (2 * mp.pi)),
        (TWO, TWO_SPEED / (2 * mp.pi)),
        ({"omega": OMEGA}, float(TURN)),
    ],
    "period of the free oscillation": [
        (SPRING, 2 * mp.pi / ONE_SPEED),
        ({"omega": OMEGA, "frequency": TURN}, 1 / float(TURN)),
    ],
    "moment of inertia of a disc about its axis": [(MOVING, disc_inertia())],
    "moment of inertia of a solid disc": [(MOVING, disc_inertia())],
    "moment of inertia of a disc about its axle": [(MOVING, disc_inertia())],
    "moment of inertia of a thin ring about its axis": [
        (MOVING, sum(float(MASS) / 100 * abs(float(RADIUS) * mp.expj(k)) ** 2 for k in range(100)))
    ],
    "moment of inertia of a thin rod about its centre": [(MOVING, along_rod(float(LENGTH) / 2))],
    "moment of inertia of a thin rod about its end": [(MOVING, along_rod(0))],
    "moment of inertia about a parallel axis": [
        (
            {"central": F(str(along_rod(float(LENGTH) / 2))), "mass": MASS, "shift": F(1, 5)},
            along_rod(float(LENGTH) / 2 - 0.2),
        )
    ],
    "mean piston speed": [(ENGINE, piston_path() * 50)],
    "swept volume": [(ENGINE, AREA * 2 * float(RADIUS)), (ENGINE, AREA * 2 * float(RADIUS) * 6)],
    "piston area": [(ENGINE, AREA)],
    "gas force": [(ENGINE, AREA * 5 * 10**6)],
    "power": [
        (
            {
                "torque": TORQUE,
                "omega": OMEGA,
                "rotation": TURN,
                "force": TORQUE / RADIUS,
                "velocity": SPEED,
                "swing": F(str(float(TORQUE) * 2 * mp.pi)),
            },
            float(TORQUE * OMEGA),
        )
    ],
    "kinetic energy": [
        ({**MOVING, "inertia": MASS * RADIUS**2}, mp.quad(lambda s: float(MASS) * s, [0, float(SPEED)]))
    ],
    "fluctuation of energy": [(WHEEL, float(SWING))],
    "moment of inertia of the flywheel": [(WHEEL, float(J1))],
    "degree of irregularity": [
        (
            {
                **WHEEL,
                "omega_high": OMEGA * (1 + FLUCTUATION / 2),
                "omega_low": OMEGA * (1 - FLUCTUATION / 2),
            },
            float(FLUCTUATION),
        )
    ],
    "centrifugal force": [(MOVING, float(MASS) * circle_motion(2))],
    "centrifugal force of a weight": [
        ({**MOVING, "weight": 9 * MASS, "gravity": Fraction(9)}, float(MASS) * circle_motion(2))
    ],
    "circumferential speed": [(MOVING, circle_motion(1))],
    "firing interval of a four-stroke engine": [(ENGINE, 2 * 2 * mp.pi / 6)],
    "firing interval of a two-stroke engine": [(ENGINE, 2 * mp.pi / 6)],
    "stress of a force on an area": [
        ({"force": F(str(over_section(lambda x, y: 5))), "area": F(str(AREA))}, 5)
    ],
    "pressure of a force on an area": [
        ({"force": F(str(over_section(lambda x, y: 5))), "area": F(str(AREA))}, 5)
    ],
    "torque of a power": [
        (
            {"power": TORQUE * OMEGA, "omega": OMEGA, "force": TORQUE / RADIUS, "radius": RADIUS},
            float(TORQUE),
        )
    ],
    "stiffness by a force and its deflection": [
        ({"force": 3 * RATE, "static_deflection": F(3)}, float(RATE))
    ],
    "density": [({"mass": F(14), "volume": F(2)}, 7)],
    "duration of a turn or an oscillation": [({"omega": OMEGA}, 1 / float(TURN))],
    "angular speed of a point on a circle": [(MOVING, float(OMEGA))],
    **OTHER_CASES,
    **BALANCE_CASES,
    **ROUND_BODIES,
    **VIBRATIONS,
    **SECTIONS_AND_FIRING,
    **WHEELS_AND_CYCLES,
}


def value(node: Formula, numbers):
    return TreeValues(SymbolValue(), numbers).value(node).real


@pytest.mark.parametrize("quantity", QUANTITIES, ids=lambda q: q.name)
def test_every_standard_formula_agrees_with_another_route(quantity: Quantity):
    for node in quantity.formulas:
        results = []
        for numbers, expected in CASES[quantity.name]:
            per_minute = {**numbers, "rotation": numbers.get("rotation", F(1)) * 60}
            if names(node) <= set(numbers):
                results += [abs(value(node, each) / expected - 1) for each in (numbers, per_minute)]
        assert results, f"nothing to compare {node} with"
        assert min(results) < 1e-6, node


def test_a_formula_that_may_be_meant_is_another_one():
    numbers = {
        **SHAFT,
        **MOVING,
        "stress": F(40),
        "shearing": F(27),
        "omega_high": F(121),
        "omega_low": F(118),
    }
    for quantity in QUANTITIES:
        for other in (*quantity.others, *quantity.mistakes):
            known = {
                name: numbers.get(name, F(3 + sum(map(ord, name)) % 97, 131)) for name in names(other)
            }
            same = [n for n in quantity.formulas if n != other and names(n) == names(other)]
            taken = value(other, known)  # nothing real below a root
            assert all(not taken or abs(value(node, known) / taken - 1) > 1e-9 for node in same), other


def test_a_rough_formula_is_near_where_the_rod_is_long():
    rough = [(quantity, node) for quantity in QUANTITIES for node in quantity.approximate]
    assert len(rough) >= 8
    for quantity, node in rough:
        (numbers, expected), *_ = CASES[quantity.name]
        assert abs(abs(value(node, numbers) / expected) - 1) < 0.1, node
