"""Numbers for quantities of balance by other routes: sums over cylinders, areas by integrals, moments."""

from __future__ import annotations

from fractions import Fraction

from mpmath import mp, mpf

from tests.independent.catalogue_cases import CRANK, RODS, SPEED, exact

F = Fraction
MASS, SHARE, PITCH, LEVER = F(7, 2), F(3, 5), F(3, 2), F(1, 20)
R, RODL, W, M = (mpf(n.numerator) / n.denominator for n in (CRANK, RODS, SPEED, MASS))
LAMBDA, ANGLE = R / RODL, F(7, 10)
T = mpf(7) / 10
SIZES = {
    "mass": MASS, "pin": CRANK, "omega": SPEED, "share": SHARE, "crank_angle": ANGLE,
    "ratio": CRANK / RODS,
    "slender": RODS / CRANK, "rod": RODS, "pitch": PITCH, "base_force": exact(M * R * W**2),
    "cylinders": F(5), "arm_of_weight": LEVER, "rotating": F(2), "reciprocating": F(3),
}  # fmt: skip


def first(crank, axis):
    """Return the first order of a piston that moves along an axis, as a vector."""
    return M * R * W**2 * mp.cos(crank - axis) * mp.expj(axis)


def second(crank, axis):
    """Return its second order, with the first power of r/l."""
    return M * R * W**2 * LAMBDA * mp.cos(2 * (crank - axis)) * mp.expj(axis)


def vee(order, angle, crank=T):
    """Return what two pistons on one pin give together, the line between the banks being real."""
    return order(crank, angle / 2) + order(crank, -angle / 2)


OF_ONE_ROD = {"rotating": F(2), "reciprocating": MASS, "cylinders": F(2), "share": F(1, 2)}
OF_BOTH_RODS = {**OF_ONE_ROD, "reciprocating": 2 * MASS}
ON_ONE_PIN = 2 + abs(vee(first, mp.pi / 2)) / (R * W**2)
"""What turns on the pin of a vee of 90°, and the first order of its two pistons, which turns with it."""


def without_first_order(gamma):
    """Return the angle between two pins at which what turns against the crank vanishes, by a search."""

    def backward(delta):
        total = 0
        for k in range(12):  # the mean of the force times e^(it) over a turn
            t = 2 * mp.pi * k / 12
            force = first(t - delta / 2, gamma / 2) + first(t + delta / 2, -gamma / 2)
            total += force * mp.expj(t) / 12
        return (total / (M * R * W**2)).real

    return mp.findroot(backward, mpf(1) / 2)


def largest(values):
    return max(abs(each) for each in values)


TURN = [2 * mp.pi * k / 3600 for k in range(3600)]
GAMMA = mpf(11) / 10


def sizes_of_bank(gamma):
    return {**SIZES, "bank": exact(gamma), "half_bank": exact(gamma / 2)}


def along(gamma):
    """Return the cases of the force along the line between the banks, and of its size."""
    numbers = sizes_of_bank(gamma)
    size = largest(vee(first, gamma, t).real for t in TURN)
    values = [vee(order, gamma).real for order in (first, second)] + [size]
    return [(numbers, each) for each in values if abs(each) > mpf(10) ** -9]


def across(gamma):
    numbers = sizes_of_bank(gamma)
    size = largest(vee(first, gamma, t).imag for t in TURN)
    return [(numbers, vee(order, gamma).imag) for order in (first, second)] + [(numbers, size)]


def turning(order, gamma, direction):
    """Return the part of what two banks give that turns with the crank, or against it."""
    parts = [vee(order, gamma, t) * mp.expj(-direction * t) for t in TURN[::36]]
    return abs(sum(parts) / len(parts))


def of_crank(order, times):
    """Return the half of a piston's order that turns one way."""
    parts = [order(t, 0) * mp.expj(-times * t) for t in TURN[::36]]
    return abs(sum(parts) / len(parts))


# Locomotives: two cylinders with cranks at right angles, a share of each piston balanced

LEFT = [
    M * (1 - mpf(3) / 5) * R * W**2 * mp.cos(angle) for angle in (T, T + mp.pi / 2)
]  # the forces left along the line of stroke
ARM = mpf(3) / 4


def pull(t):
    return sum(M * mpf(2) / 5 * R * W**2 * mp.cos(a) for a in (t, t + mp.pi / 2))


def sway(t):
    forces = [M * mpf(2) / 5 * R * W**2 * mp.cos(a) for a in (t, t + mp.pi / 2)]
    return ARM * (forces[0] - forces[1])


LIFTING = mp.findroot(lambda w: mpf(9) * mpf(1) / 20 * w**2 - 4000, 90)


def piston_place(angle):
    return R * mp.cos(angle) + mp.sqrt(RODL**2 - (R * mp.sin(angle)) ** 2)


def piston_force(angle):
    return -M * W**2 * mp.diff(piston_place, angle, 2)


def beside_weight(angle, with_rod=LAMBDA):
    """Return what a piston leaves along its axis, counted from the crank, beside a counterweight."""
    size = M * R * W**2
    return size * (mp.cos(angle) + with_rod * mp.cos(2 * angle)) - mpf(3) / 5 * size * mp.cos(angle)


ASIDE = mpf(3) / 5 * M * R * W**2
WHEEL = {"wheel_load": F(4000), "balance_mass": F(9), "arm_of_weight": LEVER}
ROLLING = {"velocity": F(20), "radius": F(9, 10), "diameter": F(9, 5)}
AT_RIGHT_ANGLE = piston_force(mp.pi / 2)

LOCOMOTIVES = {
    "variation of the tractive force of two cranks at right angles": [
        (SIZES, sum(LEFT)), (SIZES, largest(map(pull, TURN))),
    ],
    "swaying couple of two cranks at right angles": [
        (SIZES, sway(T - mp.pi / 2 + mp.pi / 2)), (SIZES, largest(map(sway, TURN))),
    ],
    "angular velocity at which a wheel leaves the rail": [(WHEEL, LIFTING)],
    "angular velocity of a rolling wheel": [(ROLLING, 2 * mp.pi * 20 / (2 * mp.pi * mpf(9) / 10))],
    "inertia force at the top dead centre beside a counterweight": [
        (SIZES, beside_weight(0)), (SIZES, -beside_weight(0)),
    ],
    "inertia force at the bottom dead centre beside a counterweight": [
        (SIZES, beside_weight(mp.pi)), (SIZES, -beside_weight(mp.pi)),
    ],
    "force across the cylinder at 90° beside a counterweight": [(SIZES, ASIDE), (SIZES, -ASIDE)],
    "resultant that the balance of a share leaves": [
        (SIZES, abs(M * R * W**2 * (mp.cos(T) - mpf(3) / 5 * mp.expj(T)))),
        (SIZES, abs(M * R * W**2 * (mp.cos(T) - mpf(1) / 2 * mp.expj(T)))),
    ],
    "resultant that the balance of a share leaves, by the angle from the line of stroke": [
        (SIZES, abs(M * R * W**2 * (mp.cos(T) - mpf(3) / 5 * mp.expj(T))))
    ],
    "amplitude of the force that a counterweight leaves across the cylinder": [
        (SIZES, largest((-ASIDE * mp.expj(2 * mp.pi * k / 360)).imag for k in range(360)))
    ],
    "balance factor that makes two forces equal": [
        (SIZES, mp.findroot(lambda b: abs(1 + LAMBDA - b) - b, 0.5)),
    ],
    "horizontal force of an upright cylinder beside a counterweight": [
        (SIZES, (-ASIDE * mp.expj(T)).imag), (SIZES, (ASIDE * mp.expj(T)).imag),
    ],
    "inertia force at a right angle of the crank": [(SIZES, AT_RIGHT_ANGLE), (SIZES, -AT_RIGHT_ANGLE)],
}  # fmt: skip

# Two cylinders on one pin, and what stands for one

DEGREES = {number: mp.pi * number / 180 for number in (45, 60, 90, 120)}
BANKS = sizes_of_bank(GAMMA)
STAR = abs(sum(second(T, 2 * mp.pi * k / 3) for k in range(3)))
SMALLEST = 2 * LAMBDA * R / 8
V_WEIGHT = turning(first, DEGREES[90], 1) / W**2
BOTH = {**SIZES, "mass": F(3)}

TWO_CYLINDERS = {
    "force of two cylinders on one pin along the line between the banks": along(GAMMA),
    "force of two cylinders on one pin across the line between the banks": across(GAMMA),
    **{
        f"force of a V-twin at {number}° along the line between its banks": along(gamma)
        for number, gamma in DEGREES.items()
    },
    **{
        f"force of a V-twin at {number}° across the line between its banks": across(gamma)
        for number, gamma in DEGREES.items()
    },
    "force of one of the two cranks that stand for a piston": [
        (SIZES, of_crank(first, 1)), (SIZES, of_crank(second, 2)),
    ],
    "radius of the cranks that stand for a piston's second order": [
        (SIZES, of_crank(second, 2) / (M / 2 * (2 * W) ** 2))
    ],
    "vector of two cylinders on one pin that turns with the crank": [(BANKS, turning(first, GAMMA, 1))],
    "vector of two cylinders on one pin that turns against the crank": [
        (BANKS, turning(first, GAMMA, -1))
    ],
    "mass of one of the two cranks that stand for a piston": [(SIZES, of_crank(first, 1) / (R * W**2))],
    "second-order force of a star of three cylinders": [(SIZES, STAR)],
    "resultant second-order force of a V-twin at 90°": [
        (SIZES, vee(second, DEGREES[90]).imag), (SIZES, largest(vee(second, DEGREES[90],
        t) for t in TURN)),
    ],
    "angle between the crank pins of a V-twin without first order": [
        ({"bank": F(6, 5)}, without_first_order(1.2)), ({"bank": F(6, 5)}, -without_first_order(1.2)),
    ],
    "moment of the counterweight of a V-twin at 90°": [
        (SIZES, V_WEIGHT), ({**SIZES, "reciprocating": MASS}, 2 * R + V_WEIGHT), (SIZES,
        2 * R + V_WEIGHT),
    ],
}  # fmt: skip

# Counterweights and shafts

RADIUS, NEAR, HALF, THICK, DENSITY = mpf(3) / 10, mpf(1) / 10, mpf(4) / 5, mpf(1) / 50, mpf(7800)
SECTORS = {
    "radius": F(3, 10), "diameter": F(3, 5), "outer_radius": F(3, 10), "inner_radius": F(1, 10),
    "half_sector": F(4, 5), "sector": F(8, 5), "wall_of_weight": F(1, 50), "density": F(7800),
    "height": F(1, 5),
}  # fmt: skip


def over_sector(weight, low, half):
    """Integrate over a sector about the real axis, from a radius to the outer one."""
    return mp.quad(lambda r: mp.quad(lambda a: weight(r * mp.cos(a)) * r, [-half, half]), [low, RADIUS])


def moment(low, half):
    return over_sector(lambda x: x, low, half)


def centre(low, half):
    return moment(low, half) / over_sector(lambda x: 1, low, half)


STEEL = THICK * DENSITY
SECTOR, HALF_DISC = STEEL * moment(0, HALF), STEEL * moment(0, mp.pi / 2)
RING_SECTOR, HALF_RING = STEEL * moment(NEAR, HALF), STEEL * moment(NEAR, mp.pi / 2)
SECTOR_MASS = STEEL * over_sector(lambda x: 1, 0, HALF)
FOUR = abs(sum(second(T + mp.pi * k, 0) for k in (0, 1, 1, 0))) / abs(mp.cos(2 * T))
PAIR = [mpf(3) / 100 * (2 * W) ** 2 * mp.expj(s * 2 * T) for s in (1, -1)]
FAST = {**SIZES, "mass": F(3, 10), "arm_of_weight": F(1, 10), "unbalance": F(3, 100)}
NEEDED = (2 + 3 * mpf(3) / 5) * R
STAR_WEIGHT = abs(sum(first(T, 2 * mp.pi * k / 5) for k in range(5))) / W**2
PERIODS = [t for t in TURN if abs(second(t, 0)) > abs(second(0, 0)) * (1 - mpf(10) ** -9)]
FAST_SPEED = mpf(120) * len(PERIODS) / 2  # two extremes a turn of the shaft
UNBALANCE = {"mass": F(7, 2), "eccentricity": F(1, 100), "omega": F(50), "pitch": PITCH,
             "unbalance": F(35, 1000), "grade": F(1, 2), "rotation": exact(mpf(50) / (2 * mp.pi)),
             "turn_rate": exact(mpf(50) / (2 * mp.pi))}  # fmt: skip

COUNTERWEIGHTS = {
    "moment of a counterweight": [
        (SIZES, NEEDED), (SIZES, mpf(3) / 5 * M * R), (SIZES, STAR_WEIGHT),
        ({**SIZES, "reciprocating": MASS}, 2 * R + STAR_WEIGHT),
    ],
    "moment of a counterweight that takes up half of the reciprocating mass": [
        (SIZES, (2 + mpf(3) / 2) * R)
    ],
    "moment of each of two shafts against the second order of four cylinders in line": [
        (SIZES, FOUR / (2 * (2 * W) ** 2))
    ],
    "moment of each of two shafts against the second order of a single cylinder": [
        (SIZES, FOUR / 4 / (2 * (2 * W) ** 2))
    ],
    "moment of each of two shafts against the first order of a single cylinder": [
        (SIZES, abs(first(0, 0)) / (2 * W**2))
    ],
    "moment of each of two shafts beside a crank balanced for its rotating mass only": [
        (SIZES, abs(first(0, 0)) / (2 * W**2))
    ],
    "force of two counter-rotating shafts at twice the crank's speed": [
        (FAST, sum(PAIR).real), (FAST, 2 * abs(PAIR[0])),
    ],
    "centrifugal force of one shaft at twice the crank's speed": [(FAST, abs(PAIR[0]))],
    "centrifugal force of a shaft at the crank's speed": [(FAST, abs(PAIR[0]) / 4)],
    "distance of a half disc's centre of gravity from its straight edge": [
        (SECTORS, centre(0, mp.pi / 2))
    ],
    "distance of a sector's centre of gravity from its tip": [(SECTORS, centre(0, HALF))],
    "distance of a ring sector's centre of gravity from its centre": [(SECTORS, centre(NEAR, HALF))],
    "radius of a block's centre of gravity": [
        (SECTORS, mp.quad(lambda x: x, [0.1, 0.3]) / mpf("0.2")),
        (SECTORS, mp.quad(lambda x: x, [0.3, 0.5]) / mpf("0.2")),
    ],
    "static moment of a sector": [(SECTORS, SECTOR), (SECTORS, RING_SECTOR)],
    "static moment of two sectors": [(SECTORS, 2 * SECTOR), (SECTORS, 2 * RING_SECTOR)],
    "static moment of a half disc": [(SECTORS, HALF_DISC), (SECTORS, HALF_RING)],
    "static moment of two half discs": [(SECTORS, 2 * HALF_DISC), (SECTORS, 2 * HALF_RING)],
    "bob weight of a pin with two rods": [(OF_ONE_ROD, ON_ONE_PIN), (OF_BOTH_RODS, ON_ONE_PIN)],
    "bob weight": [(SIZES, NEEDED / R), (SIZES, (2 * R + 5 * (NEEDED - 2 * R)) / R)],
    "mass of a sector": [(SECTORS, SECTOR_MASS), (SECTORS, 2 * SECTOR_MASS)],
    "permissible eccentricity by the balance quality": [(UNBALANCE, mpf(1) / 2 / 50)],
    "permissible unbalance": [
        (UNBALANCE, mpf(7) / 2 / 100), (UNBALANCE, mpf(7) / 2 * (mpf(1) / 2 / 50)),
    ],
    "couple of two unbalances opposite to each other": [
        (UNBALANCE, abs(sum(s * 0.035 * 50**2 * z for s, z in ((1, 0.75), (-1, -0.75))))),
    ],
}  # fmt: skip

BALANCE_CASES = {**LOCOMOTIVES, **TWO_CYLINDERS, **COUNTERWEIGHTS}
