"""Numbers for sections, rods, walls and firing intervals by other routes: integrals, eigenvalues."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise

from mpmath import mp, mpf

F = Fraction
BORE, OUTSIDE, PRESSURE = mpf("0.04"), mpf("0.07"), mpf(9)
WIDTH, WALL, MOMENT, TORQUE, DIAMETER = mpf("0.05"), mpf("0.02"), mpf(80), mpf(130), mpf("0.03")
DENSITY, AREA, OMEGA, PIN, LENGTH = mpf(7800), mpf("0.0006"), mpf(300), mpf("0.05"), mpf("0.2")
MASS, HEIGHT, RADIUS, BANK = mpf("3.5"), mpf("0.3"), mpf("0.12"), mpf("1.1")


def exact(number) -> Fraction:
    return F(mp.nstr(mpf(number), 30))


def wall_stress():
    """Return the hoop stress at the bore: A + B/r², with A - B/r² the pressure inside and 0 outside."""
    rows = mp.matrix([[1, -1 / BORE**2], [1, -1 / OUTSIDE**2]])
    a, b = mp.lu_solve(rows, mp.matrix([-PRESSURE, 0]))
    return a + b / BORE**2


def largest_shear(diameter):
    """Return half the difference of the principal stresses at the surface of a round bar."""
    axial = 2 * mp.quad(lambda y: 2 * y**2 * mp.sqrt(diameter**2 / 4 - y**2), [0, diameter / 2])
    polar = 2 * mp.pi * mp.quad(lambda r: r**3, [0, diameter / 2])
    normal, shear = MOMENT * diameter / 2 / axial, TORQUE * diameter / 2 / polar
    roots = mp.eigsy(mp.matrix([[normal, shear], [shear, 0]]), eigvals_only=True)
    return (max(roots) - min(roots)) / 2


def whip():
    """Return the largest moment of a load that rises linearly along a beam on two supports."""
    top = DENSITY * AREA * OMEGA**2 * PIN
    left = mp.quad(lambda x: top * x / LENGTH * (LENGTH - x), [0, LENGTH]) / LENGTH
    place = mp.findroot(lambda x: left - mp.quad(lambda s: top * s / LENGTH, [0, x]), LENGTH / 2)
    return left * place - mp.quad(lambda s: top * s / LENGTH * (place - s), [0, place])


def ring(weight, low, high):
    """Integrate over the section between two radii."""
    return mp.quad(
        lambda r: mp.quad(
            lambda a: weight(r * mp.cos(a), r * mp.sin(a)) * r, [0, 2 * mp.pi], maxdegree=4
        ),
        [low, high],
    )


def across(radius, height):
    """Return the inertia of a solid cylinder about a line across its middle, over its mass."""
    area = mp.pi * radius**2
    own = ring(lambda x, y: y * y, 0, radius) / area
    return own + mp.quad(lambda z: z * z, [-height / 2, height / 2]) / height


def half_left():
    """Return the size of what a weight of half the mass leaves of a piston's first order."""
    turn = mpf("0.7")
    return abs(MASS * PIN * OMEGA**2 * (mp.cos(turn) - mp.expj(turn) / 2))


def half_left_along(turn):
    """Return what a weight of half the mass, opposite to the crank, leaves in the line of the stroke."""
    return (MASS * PIN * OMEGA**2 * (mp.cos(turn) - mp.expj(turn) / 2)).real


def firing():
    """Return the intervals of two cylinders on one pin, each firing where the pin is on its own axis."""
    places = [-BANK / 2, BANK / 2 + 2 * mp.pi, -BANK / 2 + 4 * mp.pi]
    return sorted(b - a for a, b in pairwise(places))


SPLIT = mp.findroot(lambda apart: (BANK + apart) - 4 * mp.pi / 6, 1)
"""By how much two pins have to stand apart for their cylinders to fire a sixth of the cycle apart."""
TUBE = {
    "outer_radius": exact(OUTSIDE), "inner_radius": exact(BORE), "outer": exact(2 * OUTSIDE),
    "inner": exact(2 * BORE), "pressure": exact(PRESSURE), "mass": exact(MASS),
}  # fmt: skip
ROUND = {"bending": exact(MOMENT), "torque": exact(TORQUE), "diameter": exact(DIAMETER)}
ROD = {
    "density": exact(DENSITY), "area": exact(AREA), "omega": exact(OMEGA), "pin": exact(PIN),
    "length": exact(LENGTH), "mass": exact(DENSITY * AREA * LENGTH),
}  # fmt: skip
SECTIONS_AND_FIRING = {
    "hoop stress at the bore of a thick cylinder": [(TUBE, wall_stress())],
    "bending stress of a plate bent across its thickness": [
        (
            {"bending": exact(MOMENT), "width": exact(WIDTH), "wall": exact(WALL)},
            MOMENT * WALL / 2 / (WIDTH * mp.quad(lambda y: y * y, [-WALL / 2, WALL / 2])),
        )
    ],
    "axial second moment of area of a hollow round section": [
        (TUBE, ring(lambda x, y: y * y, BORE, OUTSIDE))
    ],
    "diameter of a shaft in bending and torsion by the largest shear stress": [
        ({**ROUND, "shear_stress_allowed": exact(largest_shear(DIAMETER))}, DIAMETER)
    ],
    "largest shear stress of a shaft in bending and torsion": [(ROUND, largest_shear(DIAMETER))],
    "largest bending moment of a rod by its own inertia": [(ROD, whip())],
    "moment of inertia of a ring about the axis that it turns about": [
        (
            TUBE,
            MASS * ring(lambda x, y: x * x + y * y, BORE, OUTSIDE) / ring(lambda x, y: 1, BORE, OUTSIDE),
        )
    ],
    "moment of inertia of a solid cylinder about a line across it": [
        (
            {name: exact(size) for name, size in
             (("mass", MASS), ("radius", RADIUS), ("height", HEIGHT), ("length", HEIGHT))},
            MASS * across(RADIUS, HEIGHT),
        )
    ],
    "force that half a balance leaves": [
        ({"mass": exact(MASS), "pin": exact(PIN), "omega": exact(OMEGA)}, half_left())
    ],
    "force that half a balance leaves along the cylinder": [
        ({"mass": exact(MASS), "pin": exact(PIN), "omega": exact(OMEGA), "crank_angle": F(7, 10)},
         half_left_along(mpf("0.7"))),
        ({"mass": exact(MASS), "pin": exact(PIN), "omega": exact(OMEGA)}, half_left_along(mpf(0))),
    ],
    "shorter firing interval of two cylinders on one pin": [({"bank": exact(BANK)}, firing()[0])],
    "longer firing interval of two cylinders on one pin": [({"bank": exact(BANK)}, firing()[1])],
    "angle between the split pins of a V6 that fires evenly": [({"bank": exact(BANK)}, SPLIT)],
}  # fmt: skip
"""Quantity -> the numbers of its roles and what it has to be."""
