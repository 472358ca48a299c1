"""Numbers for the catalogue's quantities by other routes: statics, roots, eigenvectors, work."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise

from mpmath import mp, mpf

from tests.independent.crank_torque_cases import CRANK_TORQUE
from tests.independent.resonance_cases import RESONANCE
from tests.independent.shaft_cases import SHAFTS

F = Fraction


def exact(number) -> Fraction:
    return F(mp.nstr(mpf(number), 30))


def floats(numbers):
    return {name: mpf(n.numerator) / n.denominator for name, n in numbers.items()}


# Sections and beams

OUTER, INNER, WIDTH, HEIGHT = F(5, 100), F(3, 100), F(2, 100), F(7, 100)
FORCE, LENGTH, LINE_LOAD, YOUNG, SHEAR = F(900), F(6, 5), F(350), F(21 * 10**10), F(79 * 10**9)


def ring(weight):
    """Integrate over the hollow section."""
    low, high = float(INNER) / 2, float(OUTER) / 2
    return mp.quad(
        lambda r: mp.quad(
            lambda a: weight(r * mp.cos(a), r * mp.sin(a)) * r, [0, 2 * mp.pi], maxdegree=4
        ),
        [low, high],
    )


POLAR, AXIAL = ring(lambda x, y: x * x + y * y), ring(lambda x, y: y * y)
HOLLOW = {
    "outer": OUTER, "inner": INNER, "outer_radius": OUTER / 2, "inner_radius": INNER / 2,
    "shear": SHEAR, "length": LENGTH,
}  # fmt: skip
RECTANGLE = mp.quad(lambda y: float(WIDTH) * y * y, [-float(HEIGHT) / 2, float(HEIGHT) / 2])
FLAT = {"width": WIDTH, "height": HEIGHT, "bending": F(80)}
BEAM = {
    "force": FORCE, "length": LENGTH, "line_load": LINE_LOAD, "young": YOUNG, "section": exact(RECTANGLE),
}  # fmt: skip
LOAD, SPAN, EI = float(FORCE), float(LENGTH), float(YOUNG) * RECTANGLE


def half_span(x):
    """Return the moment of a unit load in the middle of two supports."""
    return min(x, SPAN - x) / 2


def by_unit_loads(moment, unit):
    return mp.quad(lambda x: moment(x) * unit(x) / EI, [0, SPAN / 2, SPAN])


FIXED_END = mp.quad(half_span, [0, SPAN / 2, SPAN]) * LOAD / SPAN  # no slope at a fixed end
UNIFORM = float(LINE_LOAD)
CANTILEVER_UNIFORM = mp.quad(lambda x: UNIFORM * x, [0, SPAN])
SUPPORTED_UNIFORM = UNIFORM * SPAN / 2 * SPAN / 2 - mp.quad(lambda x: UNIFORM * x, [0, SPAN / 2])
STRESSES = {"stress": F(40), "shearing": F(27), "bending": F(80), "torque": F(130)}


def largest_shear(stress, shear):
    values = mp.eigsy(mp.matrix([[stress, shear], [shear, 0]]), eigvals_only=True)
    return (max(values) - min(values)) / 2


def largest_principal(stress, shear):
    return max(mp.eigsy(mp.matrix([[stress, shear], [shear, 0]]), eigvals_only=True))


BAR = {
    "force": FORCE, "diameter": WIDTH, "radius": WIDTH / 2, "width": HEIGHT, "length": HEIGHT,
    "pressure": F(10**6), "wall": F(1, 1000),
}  # fmt: skip
PIN = mp.quad(
    lambda x: mp.sqrt((float(WIDTH) / 2) ** 2 - x * x) * 2, [-float(WIDTH) / 2, float(WIDTH) / 2]
)
PROJECTED = float(WIDTH) * float(HEIGHT)
HOOP = mp.quad(lambda a: 10**6 * float(WIDTH) / 2 * mp.sin(a), [0, mp.pi]) / (2 * 0.001)
RATES = {"first_rate": F(300), "second_rate": F(700)}
SERIES = 1 / (mpf(1) / 300 + mpf(1) / 700)  # one force, two deflections
THICK, THIN = F(6, 100), F(4, 100)
STEPPED = {
    "length": LENGTH, "own_length": LENGTH, "diameter": THICK, "first_diameter": THICK,
    "own_diameter": THIN, "first_length": F(1, 2),
    "section": F(THICK**4), "second_section": F(THIN**4),
}  # fmt: skip
TWIST = (mpf(6) / 4) ** 4 * SPAN  # the same angle by the same torque

STRENGTH = {
    "polar second moment of area of a hollow round section": [(HOLLOW, POLAR)],
    "second moment of area of a hollow round section": [(HOLLOW, AXIAL)],
    "polar section modulus of a hollow round section": [(HOLLOW, POLAR / (float(OUTER) / 2))],
    "section modulus of a hollow round section in bending": [(HOLLOW, AXIAL / (float(OUTER) / 2))],
    "second moment of area of a rectangle": [(FLAT, RECTANGLE)],
    "section modulus of a rectangle": [(FLAT, RECTANGLE / (float(HEIGHT) / 2))],
    "bending stress of a rectangular bar": [(FLAT, 80 * float(HEIGHT) / 2 / RECTANGLE)],
    "equivalent stress by Tresca": [(STRESSES, 2 * largest_shear(40, 27))],
    # of a round bar σ = M/W and τ = T/(2 W); the torque or moment alone with the same greatest stress
    "equivalent twisting moment": [(STRESSES, 2 * largest_shear(80, 65))],
    "equivalent bending moment": [(STRESSES, largest_principal(80, 65))],
    "direct stress in a round bar": [({**BAR, "area": exact(PIN)}, LOAD / PIN)],
    "hoop stress of a thin cylinder": [(BAR, HOOP)],
    "bending moment of a cantilever with a load at its end": [(BEAM, LOAD * SPAN)],
    "bending moment of a cantilever with a uniform load": [
        (BEAM, CANTILEVER_UNIFORM),
        ({**BEAM, "force": LINE_LOAD * LENGTH}, CANTILEVER_UNIFORM),
    ],
    "bending moment of a simply supported beam loaded in the middle": [
        (BEAM, LOAD * half_span(SPAN / 2))
    ],
    "bending moment of a simply supported beam with a uniform load": [
        (BEAM, SUPPORTED_UNIFORM),
        ({**BEAM, "force": LINE_LOAD * LENGTH}, SUPPORTED_UNIFORM),
    ],
    "bending moment of a beam fixed at both ends and loaded in the middle": [(BEAM, FIXED_END)],
    "deflection of a cantilever with a load at its end": [
        (BEAM, by_unit_loads(lambda x: LOAD * x, lambda x: x))
    ],
    "deflection of a simply supported beam loaded in the middle": [
        (BEAM, by_unit_loads(lambda x: LOAD * half_span(x), half_span))
    ],
    "bending stiffness of a simply supported shaft in its middle": [
        (BEAM, 1 / by_unit_loads(half_span, half_span))
    ],
    "bending stiffness of a cantilever at its end": [(BEAM, 1 / by_unit_loads(lambda x: x, lambda x: x))],
    "bearing pressure": [(BAR, LOAD / PROJECTED)],
    "torsional stiffness of a hollow shaft": [(HOLLOW, float(SHEAR) * POLAR / SPAN)],
    "stiffness of springs in series": [(RATES, SERIES)],
    "stiffness of springs in parallel": [(RATES, mpf(1000))],
    "equivalent length of a shaft": [(STEPPED, TWIST), (STEPPED, TWIST + 0.5)],
}

# Vibrations

MASS, RATE, DASHPOT, J1, J2 = F(7, 2), F(4000), F(46), F(3, 100), F(7, 100)
ROOT = mp.polyroots([3.5, 46, 4000])[0]
FREE = mp.sqrt(mpf(4000) / mpf(3.5))
DECAY = -ROOT.real
TURNS = abs(ROOT.imag)
LEHR = exact(DECAY / abs(ROOT))
DECREMENT = mp.log(abs(mp.exp(ROOT * 0)) / abs(mp.exp(ROOT * 2 * mp.pi / TURNS)))
DAMPED = {
    "mass": MASS, "stiffness": RATE, "damping": DASHPOT, "omega": exact(abs(ROOT)), "decay": exact(DECAY),
    "damping_ratio": LEHR, "decrement": exact(DECREMENT), "period": exact(2 * mp.pi / TURNS),
}  # fmt: skip
TURNING = {**DAMPED, "inertia": MASS}
TUNING = F(3, 4)
FORCED = {"tuning": TUNING, "damping_ratio": LEHR}


def forced(tuning, dashpot=46):
    speed = tuning * FREE
    return abs(4000 / (4000 - 3.5 * speed**2 + 1j * dashpot * speed))


THREE = mp.eig(mp.matrix([[1, -1, 0], [-1, 2, -1], [0, -1, 1]]) * 4000 / 0.03)[0]
CHAIN = sorted(mp.sqrt(abs(each)) for each in THREE)
SAG = F(981, 100) * MASS / RATE
SHAPE = [1 / mpf(0.03), -1 / mpf(0.07)]  # no sum of angular momenta
NODE = SPAN * SHAPE[0] / (SHAPE[0] - SHAPE[1])
SPEEDS = {
    "omega": F(420), "order": F(6), "frequency": exact(420 / (2 * mp.pi)),
    "rotation": exact(420 / (2 * mp.pi) * 60),
}  # fmt: skip
SWING_ARM = F(2, 5)
PENDULUM = {
    "mass": MASS, "gravity": F(981, 100), "arm": SWING_ARM, "central": F(1, 5),
    "gyration": exact(mp.sqrt(0.2 / 3.5)),
    "inertia": F(1, 5) + MASS * SWING_ARM**2,
}  # fmt: skip
ABOUT_PIVOT = mp.quad(lambda x: 3.5 * 2 * x, [0, 0.4]) + 0.2
SWINGS = mp.sqrt(mp.mpf("3.5") * 9.81 * 0.4 / ABOUT_PIVOT)
REDUCED = exact(ABOUT_PIVOT / (3.5 * 0.4))

VIBRATION = {
    "natural angular frequency of three equal discs": [
        ({"stiffness": RATE, "inertia": J1}, CHAIN[1]),
        ({"stiffness": RATE, "inertia": J1}, CHAIN[2]),
    ],
    "natural angular frequency by the static deflection": [
        ({"gravity": F(981, 100), "static_deflection": SAG}, FREE)
    ],
    "damped natural angular frequency": [(DAMPED, TURNS)],
    "damping ratio": [(DAMPED, DECAY / abs(ROOT)), (TURNING, DECAY / abs(ROOT))],
    "critical damping": [
        (TURNING, mp.findroot(lambda c: c * c - 4 * mpf(3.5) * 4000, 200)),
    ],
    "logarithmic decrement": [(DAMPED, DECREMENT)],
    "magnification of a forced vibration": [(FORCED, forced(0.75)), (FORCED, forced(0.75, 0))],
    "magnification at resonance": [(FORCED, forced(1))],
    "magnification factor at resonance": [(FORCED, forced(1))],
    "critical speed of an order": [
        (SPEEDS, mpf(70)), (SPEEDS, 70 / (2 * mp.pi)), (SPEEDS, 70 / (2 * mp.pi) * 60)
    ],
    "distance of the node of two discs": [
        ({"length": LENGTH, "own_inertia": J1, "other_inertia": J2}, NODE)
    ],
    "period of a simple pendulum": [
        ({"length": REDUCED, "gravity": F(981, 100)}, 2 * mp.pi / SWINGS)
    ],
    "period of a compound pendulum": [({**PENDULUM, "length": REDUCED}, 2 * mp.pi / SWINGS)],
    "moment of inertia from a pendulum's period": [
        ({**PENDULUM, "period": exact(2 * mp.pi / SWINGS)}, ABOUT_PIVOT)
    ],
    "moment of inertia about its pivot by a pendulum's period": [
        ({**PENDULUM, "period": exact(2 * mp.pi / SWINGS)}, ABOUT_PIVOT)
    ],
}  # fmt: skip

# Masses

CYLINDER = {**HOLLOW, "mass": MASS}
AREA = ring(lambda x, y: 1)
ROD = {
    "mass": MASS, "near": F(2, 5), "far": F(4, 5), "rod": F(6, 5), "gyration": F(1, 2),
    "central": MASS * F(1, 4),
}  # fmt: skip
TWO_MASSES = mpf(3.5) * 2 / 3 * mpf(0.4) ** 2 + mpf(3.5) / 3 * mpf(0.8) ** 2
DISC = {"density": F(7850), "diameter": OUTER, "radius": OUTER / 2, "width": WIDTH, "height": WIDTH}

INERTIA = {
    "moment of inertia of a hollow cylinder about its axis": [(CYLINDER, 3.5 * POLAR / AREA)],
    "moment of inertia by the radius of gyration": [({"mass": MASS, "gyration": F(1, 2)}, mpf(0.875))],
    "radius of gyration of a ring between two radii": [(CYLINDER, mp.sqrt(POLAR / AREA))],
    "mass by its radius of gyration": [({"inertia": F(7, 8), "gyration": F(1, 2)}, mpf(3.5))],
    "radius of gyration": [({"mass": MASS, "inertia": F(7, 8)}, mpf(0.5))],
    "mass of a round disc": [
        (DISC, 7850 * float(WIDTH) * mp.quad(lambda r: 2 * mp.pi * r, [0, float(OUTER) / 2]))
    ],
    "centre part of a rod in three masses": [
        (ROD, 3.5 * 0.25 - TWO_MASSES),
        (ROD, TWO_MASSES - 3.5 * 0.25),
    ],
    "part of a rod's mass at one end": [(ROD, mpf(3.5) / 3), (ROD, mpf(3.5) * 2 / 3)],
}

# One cylinder

CRANK, RODS, SPEED, ANGLE, GAS = F(3, 100), F(1, 10), F(150), F(7, 10), F(5000)
R, L, W, T, P = (mpf(n.numerator) / n.denominator for n in (CRANK, RODS, SPEED, ANGLE, GAS))
TILT = mp.asin(R / L * mp.sin(T))


def place(angle):
    return R * mp.cos(angle) + mp.sqrt(L**2 - (R * mp.sin(angle)) ** 2)


ALONG = mp.matrix([R * mp.cos(T) - place(T), R * mp.sin(T)]) / L  # from the piston to the crank pin
PUSH = P / abs(ALONG[0])
TANGENT, OUTWARD = (-mp.sin(T), mp.cos(T)), (mp.cos(T), mp.sin(T))
TURNING_FORCE = PUSH * abs(ALONG[0] * TANGENT[0] + ALONG[1] * TANGENT[1])
INWARD = PUSH * (ALONG[0] * OUTWARD[0] + ALONG[1] * OUTWARD[1])
VIRTUAL = -P * mp.diff(place, T)
FASTEST = max(abs(W * mp.diff(place, mpf(k) / 400)) for k in range(630))
DRIVE = {
    "piston_force": GAS, "any_force": GAS, "rod_force": exact(PUSH), "rod_angle": exact(TILT),
    "crank_angle": ANGLE, "ratio": CRANK / RODS, "slenderness": RODS / CRANK, "pin": CRANK, "rod": RODS,
    "omega": SPEED, "torque": exact(VIRTUAL), "power": exact(VIRTUAL * W),
    "rotation": exact(W / (2 * mp.pi)),
}  # fmt: skip
TOP, BOTTOM = (W**2 * mp.diff(place, angle, 2) for angle in (0, mp.pi))
SWAY, SWAYS = (
    W * mp.diff(lambda a: mp.asin(R / L * mp.sin(a)), T),
    W**2 * mp.diff(lambda a: mp.asin(R / L * mp.sin(a)), T, 2),
)
SPACES = {"swept": F(9), "clearance": F(1), "compression": F(10)}
FACE_AREA = mp.quad(lambda r: 2 * mp.pi * r, [0, mpf(1) / 25])
FACE = {
    "diameter": F(2, 25), "area": exact(FACE_AREA), "pressure": F(5 * 10**5), "back_pressure": F(10**5),
}  # fmt: skip
PUSHED = mp.quad(lambda r: (5 * 10**5 - 10**5) * 2 * mp.pi * r, [0, mpf(1) / 25])
CLEARANCE = FACE_AREA * (place(0) - place(mp.pi)) / 9
ABOVE = CLEARANCE + mp.quad(lambda a: -FACE_AREA * mp.diff(place, a), [0, T])
LONG = {
    **DRIVE, "ratio": F(1, 100), "slenderness": F(100), "rod": F(3), "mass": F(7, 2), **FACE,
    "piston_force": exact(5 * 10**5 * FACE_AREA), "any_force": exact(5 * 10**5 * FACE_AREA),
}  # fmt: skip


def long_place(angle):
    return R * mp.cos(angle) + mp.sqrt(9 - (R * mp.sin(angle)) ** 2)


CRANK_DRIVE = {
    "side force on the cylinder wall": [(DRIVE, PUSH * ALONG[1])],
    "force in the connecting rod": [(DRIVE, PUSH), (DRIVE, P / abs(mp.cos(mp.asin(R / L))))],
    "tangential force at the crank pin": [(DRIVE, TURNING_FORCE)],
    "radial force at the crank pin": [(DRIVE, INWARD), (DRIVE, -INWARD)],
    "radial force at the crank pin, positive inwards": [(DRIVE, -INWARD)],
    "torque of a crank": [(DRIVE, VIRTUAL)],
    "ratio of the crank to the rod": [
        ({**DRIVE, "stroke": exact(place(0) - place(mp.pi))}, mp.sin(mp.asin(R / L)))
    ],
    "stroke of a crank": [(DRIVE, place(0) - place(mp.pi))],
    "compression ratio": [(SPACES, mpf(10))],
    "clearance volume": [(SPACES, mpf(1))],
    "largest piston speed": [(DRIVE, FASTEST)],
    "largest piston acceleration": [(DRIVE, TOP), (DRIVE, -TOP)],
    "piston acceleration at the bottom dead centre": [(DRIVE, BOTTOM), (DRIVE, -BOTTOM)],
    "angular velocity of the rod": [(DRIVE, SWAY), (DRIVE, -SWAY)],
    "angular acceleration of the rod": [(DRIVE, SWAYS), (DRIVE, -SWAYS)],
    "gas force against the pressure below the piston": [(FACE, PUSHED)],
    "force of gas and mass on the piston": [
        (LONG, 5 * 10**5 * mpf(FACE_AREA) + mpf(3.5) * W**2 * mp.diff(long_place, T, 2))
    ],
    "volume of a cylinder at a crank angle": [
        ({**DRIVE, **FACE, "clearance": exact(CLEARANCE), "compression": F(10)}, ABOVE)
    ],
    "couple of the side force on the frame": [(DRIVE, PUSH * ALONG[1] * place(T))],
}

# Work

CYLINDERS, ETA, MEAN, VOLUME = F(4), F(4, 5), F(8 * 10**5), F(5, 10**4)


def engine(turns, count, eta):
    """Return an engine's roles where each cylinder does p V in a number of turns."""
    work = 8 * 10**5 * mpf(5) / 10**4 * count * eta
    power = work * 50 / turns
    numbers = {
        "pressure": MEAN, "volume": VOLUME, "rotation": F(50), "omega": exact(100 * mp.pi),
        "power": exact(power), "torque": exact(power / (100 * mp.pi)), "area": F(1, 200),
        "stroke": F(1, 10), "velocity": F(10), "cylinders": CYLINDERS, "efficiency": ETA,
        "swing": exact(work), "cycle_work": exact(work if count == 1 else work / count),
    }  # fmt: skip
    return numbers, power


def cases(turns, result):
    every = [engine(turns, count, eta) for count in (1, 4) for eta in (1, mpf(0.8))]
    return [(numbers, result(power)) for numbers, power in every]


HARMONIC = {
    "torque": F(300), "order": F(3), "inertia": F(2), "omega": F(100), "kinetic": F(10**4),
    "swing": F(200),
}  # fmt: skip
POSITIVE = mp.quad(lambda a: 300 * mp.sin(3 * a), [0, mp.pi / 3])
SWINGS_OF_SPEED = (mp.sqrt(10000 + 100) - mp.sqrt(10000 - 100)) / 100  # E ± ΔE/2 of J = 2, to first order

WORK = {
    "mean torque of a four-stroke engine": cases(2, lambda p: p / (100 * mp.pi)),
    "mean torque of a two-stroke engine": cases(1, lambda p: p / (100 * mp.pi)),
    "mean effective pressure of a four-stroke engine": cases(2, lambda p: mpf(8 * 10**5)),
    "mean effective pressure of a two-stroke engine": cases(1, lambda p: mpf(8 * 10**5)),
    "mean effective pressure by the work of a cycle": cases(1, lambda p: mpf(8 * 10**5)),
    "power of a four-stroke engine": cases(2, lambda p: p),
    "power of a two-stroke engine": cases(1, lambda p: p),
    "fluctuation of energy of one harmonic": [(HARMONIC, POSITIVE)],
    "coefficient of fluctuation by the energy": [
        (HARMONIC, POSITIVE / (2 * 100**2)),
        (HARMONIC, mpf(round(SWINGS_OF_SPEED, 4))),
    ],
    "work of a turn": [({"torque": F(300)}, mp.quad(lambda a: 300, [0, 2 * mp.pi]))],
}

# Balance

SHARE, LEVER = F(3, 5), F(1, 20)
WHEEL = {
    "mass": MASS, "pin": CRANK, "omega": SPEED, "share": SHARE, "crank_angle": ANGLE, "cylinders": F(5),
    "arm_of_weight": LEVER, "rotating": F(2), "reciprocating": F(3), "ratio": CRANK / RODS, "rod": RODS,
    "unbalance": F(3, 100), "unbalanced": F(3, 10), "eccentricity": F(1, 10),
}  # fmt: skip
TURNED = -mpf(0.6) * mpf(3.5) * R * W**2 * mp.expj(T)  # a counterweight opposite to the crank
BALANCED = {**WHEEL, "balance_mass": MASS * SHARE * CRANK / LEVER}
LEFT = mpf(3.5) * R * W**2 * mp.cos(T) + TURNED
NEEDED = (2 + mpf(0.6) * 3) * R
SECOND = mpf(3.5) * R**2 / L * W**2  # the second order's amplitude, to the first power of λ


def star(cylinders, step, angle):
    """Return the sum of first orders along axes a step apart, all rods on one pin."""
    axes = [step * k for k in range(cylinders)]
    return abs(sum(3.5 * R * W**2 * mp.cos(angle - a) * mp.expj(a) for a in axes))


BALANCE = {
    "hammer blow": [
        (BALANCED, abs(TURNED)), (BALANCED, abs(TURNED.imag)), (WHEEL, abs(TURNED.imag)), (WHEEL,
        abs(TURNED)), ({**WHEEL, "mass": MASS * SHARE}, abs(TURNED)),
        ({**WHEEL, "mass": MASS * SHARE}, abs(TURNED.imag)),
    ],
    "residual force along the line of stroke": [(WHEEL, LEFT.real)],
    "residual force across the line of stroke": [(WHEEL, LEFT.imag), (WHEEL, -LEFT.imag)],
    "force that a counterweight leaves across the cylinder": [(WHEEL, LEFT.imag), (WHEEL, -LEFT.imag)],
    "counterweight": [
        (WHEEL, NEEDED / 0.05), ({**WHEEL, "mass": F(19, 5)}, NEEDED / 0.05),
        ({**WHEEL, "mass": F(19, 3)}, NEEDED / 0.05), ({**WHEEL, "reciprocating": F(18, 5)},
        NEEDED / 0.05),
    ],
    "mass of each of two counter-rotating weights at twice the crank's speed": [
        (WHEEL, SECOND / (2 * 0.05 * (2 * W) ** 2))
    ],
    "mass of each of two counter-rotating weights at the crank's speed": [
        (WHEEL, 3.5 * R * W**2 / (2 * 0.05 * W**2))
    ],
    "unbalance": [(WHEEL, mpf(0.03))],
    "centrifugal force of an unbalance": [(WHEEL, 0.03 * W**2)],
    "whole centrifugal force of a rotor on its bearings": [(WHEEL, 0.03 * W**2)],
    "resultant first-order force of a radial engine": [(WHEEL, star(5, 2 * mp.pi / 5, 0.4))],
    "resultant first-order force of a V-twin at 90°": [(WHEEL, star(2, mp.pi / 2, 0.4))],
}  # fmt: skip


def firings(turns_each, per_cylinder=1):
    """Count the firings of six cylinders in a second at 3000 turns a minute, each in so many turns."""
    turns = 3000 // 60
    return sum(1 for turn in range(turns * per_cylinder) for _ in range(6) if turn % turns_each == 0)


def zero_crossings(order):
    """Count the periods of an order in a second at 3000 turns a minute, by the signs of cos nωt."""
    signs = [mp.cos(order * 2 * mp.pi * 50 * (k + mpf(1) / 3) / 2000) > 0 for k in range(2001)]
    return sum(1 for one, two in pairwise(signs) if two and not one)


SIX = {"turn_rate": F(50), "cylinders": F(6), "omega": exact(100 * mp.pi)}
A_MINUTE = {"turn_rate": F(3000), "cylinders": F(6)}
ROTATING = [{name: number} for name in ("turn_rate", "rotation") for number in (F(50), F(3000))]
TURNING_RATE = 1000 * abs(mp.arg(mp.expj(2 * mp.pi * 50 / 1000)))  # the angle of each thousandth
ENGINE_RATES = {
    "firing frequency of a four-stroke engine": [(SIX, mpf(firings(2))), (A_MINUTE, mpf(firings(2)))],
    "firing frequency of a two-stroke engine": [(SIX, mpf(firings(1))), (A_MINUTE, mpf(firings(1)))],
    "firings per turn of a four-stroke engine": [(SIX, mpf(firings(2)) / 50)],
    "firings per turn of a two-stroke engine": [(SIX, mpf(firings(1)) / 50)],
    "frequency of a force of the second order": [
        (SIX, mpf(zero_crossings(2))), (A_MINUTE, mpf(zero_crossings(2))),
    ],
    "frequency of that force of the second order": [
        (SIX, mpf(zero_crossings(2))), (A_MINUTE, mpf(zero_crossings(2))),
    ],
    "speed of the camshaft of a four-stroke engine": [
        *(({name: F(50)}, mpf(len(range(0, 50, 2)))) for name in ("turn_rate", "rotation")),
        ({"omega": exact(100 * mp.pi)}, 2 * mp.pi * len(range(0, 50, 2))),  # every second turn again
    ],
    "speed of the balance shafts of four cylinders in line": [
        (SIX, mpf(zero_crossings(2))), ({"omega": F(300)}, mpf(600)),
    ],
    "angular speed by the speed of rotation": [(each, TURNING_RATE) for each in ROTATING],
    "speed of rotation by the angular speed": [
        ({"omega": exact(TURNING_RATE)}, mpf(number)) for number in (50, 3000)
    ],
    "period by the angular frequency": [({"omega": exact(TURNING_RATE)}, mp.mpf(1) / 50)],
    "angular frequency by the period": [({"period": F(1, 50)}, TURNING_RATE)],
    "time of a turn of the crank": [
        ({**each, angle: F(90)}, mp.mpf(1) / 4 / 50)
        for each in ROTATING
        for angle in ("turned_angle", "crank_angle")
    ] + [
        ({"omega": exact(TURNING_RATE), angle: exact(mp.pi / 2)}, mp.mpf(1) / 4 / 50)
        for angle in ("turned_angle", "crank_angle")
    ],
    "crank radius by the stroke": [
        ({"stroke": F(86)}, (mpf(0.1 * 430) * (1 - mp.cos(mp.pi))) / 2),
    ],
}  # fmt: skip


def turns_of_bearing(exponent):
    """Return the turns that a bearing bears at 2 kN, by a straight line of log life over log load.

    At its rated 14 kN it bears a million.
    """
    loads = [mpf(14000), mpf(2000)]
    return mp.exp(mp.log(mpf(10) ** 6) + exponent * (mp.log(loads[0]) - mp.log(loads[1])))


def lives(exponent):
    """Return the life in millions of turns, and in hours at 1500 turns a minute."""
    turns, loads = turns_of_bearing(exponent), {"load_rating": F(14000), "bearing_load": F(2000)}
    return [(loads, turns / 10**6), ({**loads, "turn_rate": F(1500)}, turns / 1500 / 60)]


BEARINGS = {
    "rating life of a ball bearing": lives(3),
    "rating life of a roller bearing": lives(mpf(10) / 3),
}

CASES = {
    **BEARINGS,
    **SHAFTS,
    **RESONANCE,
    **STRENGTH,
    **VIBRATION,
    **INERTIA,
    **CRANK_DRIVE,
    **WORK,
    **CRANK_TORQUE,
    **BALANCE,
    **ENGINE_RATES,
}
