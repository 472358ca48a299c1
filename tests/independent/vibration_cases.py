"""Numbers for trains, rotors and free swings by other routes: eigenvalues, balances, paths in time."""

from __future__ import annotations

from fractions import Fraction

from mpmath import mp, mpf

F = Fraction


def exact(number) -> Fraction:
    return F(mp.nstr(mpf(number), 30))


def frequencies(masses, rates):
    """Return the angular frequencies of a row of discs with shafts between them."""
    size = len(masses)
    matrix = mp.matrix(size)
    for k, rate in enumerate(rates):
        for i, j, sign in ((k, k, 1), (k, k + 1, -1), (k + 1, k + 1, 1), (k + 1, k, -1)):
            matrix[i, j] += mpf(sign * rate) / mpf(masses[i])
    return sorted(mp.sqrt(abs(value.real)) for value in mp.eig(matrix)[0])


# Trains

ENDS, MIDDLE, RATE = F(3, 10), F(7, 10), F(5000)
THREE = {"stiffness": RATE, "outer_inertia": ENDS, "middle_inertia": MIDDLE}
TWO_NODES = frequencies(["0.3", "0.7", "0.3"], [5000, 5000])[-1]
OWN = {"stiffness": RATE, "inertia": F(2), "mass": F(2), "shaft_inertia": F(3, 10)}
LINEAR_TWIST = mp.sqrt(5000 / (2 + mp.quad(lambda x: mpf("0.3") * x**2, [0, 1])))
GEARED = {
    "own_inertia": F(2), "other_inertia": F(3), "own_speed": F(50), "other_speed": F(20),
    "own_teeth": F(20),
    "other_teeth": F(50),
}  # fmt: skip
BY_ENERGY = 2 * (mpf(2) * 50**2 / 2) / 20**2
PAIR = {"first_rate": F(500), "second_rate": F(700), "gear_ratio": F(3)}

FAST = 1 / (mpf(1) / 500 + (mpf(1) / 3 / 700) / 3)  # the second carries a third of the torque
SLOW = 1 / (mpf(1) / 500 + (mpf(3) / 700) * 3)
JUNCTION = {
    "first_torque": F(40), "second_torque": F(70), "inertia": F(2), "omega": F(30),
    "amplitude_before": F(1, 50),
}  # fmt: skip
REACHED = 40 + 70 - 2 * mp.diff(lambda t: mp.sin(30 * t) / 50, mp.pi / 60, 2)

# Rotors

DISC = {
    "density": F(7850),
    "omega": F(300),
    "radius": F(3, 10),
    "diameter": F(6, 10),
    "poisson": F(3, 10),
}
_E, _NU, _PULL = mpf(21) * 10**10, mpf("0.3"), mpf(7850) * 300**2
_CUBIC = -_PULL * (1 - _NU**2) / _E / 8  # of u = a r + b r³ in r² u'' + r u' - u = -ρ ω² (1 - ν²) r³/E
_LINEAR = -_CUBIC * mpf("0.09") * (3 + _NU) / (1 + _NU)  # no stress at the edge
AT_CENTRE = _E / (1 - _NU**2) * (1 + _NU) * _LINEAR
BEAM = {
    "young": F(21 * 10**10), "section": F(3, 10**7), "mass": F(40), "length": F(12, 10), "near": F(5, 10),
    "far": F(7, 10), "force": F(900),
}  # fmt: skip
_EI = mpf(21) * 10**10 * 3 / 10**7


def sag(place):
    """Return the deflection under a force of 1 by the moments that it makes."""
    span = mpf("1.2")

    def moment(x):
        return x * (span - place) / span if x < place else place * (span - x) / span

    return mp.quad(lambda x: moment(x) ** 2 / _EI, [0, place, span])


SPUN = {
    "driving": F(90), "natural": F(120), "tuning": F(3, 4), "eccentricity": F(2, 1000),
    "damping_ratio": F(1, 10),
    "eccentric_mass": F(3), "machine_mass": F(200),
}  # fmt: skip
BOWED = mp.findroot(lambda y: 120**2 * y - 90**2 * (y + mpf("0.002")), mpf("0.003"))
SHAKEN = {
    damping: abs(3 * mpf("0.002") * 90**2 / (200 * (120**2 - 90**2 + 2j * damping * 120 * 90)))
    for damping in (mpf("0.1"), mpf(0))
}
GRADED = {"grade": F(63, 10), "mass": F(25), "rotation": F(3000)}
ALLOWED = 25 * 1000 * mpf("6.3") / (2 * mp.pi * 3000 / 60)
COUPLE = {
    "unbalanced": F(1, 5), "crank": F(1, 10), "omega": F(90), "couple_arm": F(2, 10), "span": F(8, 10),
}  # fmt: skip
_PULL_OF_ONE = mpf("0.02") * 90**2
AT_BEARING = (_PULL_OF_ONE * mpf("0.5") - _PULL_OF_ONE * mpf("0.3")) / mpf(
    "0.8"
)  # moments about the other
FASTER = {"driving": F(200), "natural": F(120), "tuning": F(5, 3)}
SWUNG = abs(1 / (1 - (mpf(200) / 120) ** 2))
MET = {"frequency": F(75), "order": F(9, 2), "omega": exact(150 * mp.pi)}

# Free swings

SHM = {
    "omega": F(30), "amplitude": F(5, 100), "displacement": F(3, 100), "whole_swing": F(1, 10),
    "frequency": exact(30 / (2 * mp.pi)),
}  # fmt: skip
_AT = mp.asin(mpf("0.6")) / 30
PASSING = mp.diff(lambda t: mp.sin(30 * t) / 20, _AT)
FASTEST = mp.diff(lambda t: mp.sin(30 * t) / 20, 0)
HARDEST = abs(mp.diff(lambda t: mp.sin(30 * t) / 20, mp.pi / 60, 2))
LEHR = mpf("0.05")
ROOTS = mp.polyroots([1, 2 * LEHR * 40, 1600])
TURNS = abs(ROOTS[0].imag)
PEAKS = {
    "first_peak": F(3), "later_peak": exact(3 * mp.exp(ROOTS[0].real * 4 * 2 * mp.pi / TURNS)),
    "cycles": F(4),
}  # fmt: skip
NEXT_PEAK = {"first_peak": F(3), "later_peak": exact(3 * mp.exp(ROOTS[0].real * 2 * mp.pi / TURNS))}
DECREMENT = 2 * mp.pi / TURNS * 40 * LEHR
FREE = {"omega": F(40), "damping_ratio": F(1, 20), "decay": F(2)}
G = F(981, 100)
INERTIA = mpf("0.02")
SWINGS = 2 * mp.pi / mp.sqrt(mp.diff(lambda a: -2 * mpf("9.81") * mpf("0.15") * mp.cos(a), 0, 2)
                             / (INERTIA + 2 * mpf("0.15") ** 2))  # fmt: skip
ROD = {"mass": F(2), "gravity": G, "arm": F(15, 100), "period": exact(SWINGS)}


def lifted(radius, length):
    """Return how a body on strings is lifted by a turn: the curvature of its height."""
    return mp.diff(lambda a: -mp.sqrt(length**2 - 2 * radius**2 * (1 - mp.cos(a))), 0, 2)


_ON_TWO = 2 * mp.pi * mp.sqrt(INERTIA / (2 * mpf("9.81") * lifted(mpf("0.1"), mpf("1.5"))))
HUNG = {
    "mass": F(2), "gravity": G, "string_gap": F(2, 10), "string_circle": F(1, 10), "strings": F(3, 2),
    "inertia": F(2, 100), "period": exact(_ON_TWO),
}  # fmt: skip
ISOLATED = mp.findroot(lambda r: 1 / (r**2 - 1) - mpf("0.2"), 2)
ABSORBER = {"stiffness": F(800), "mass": F(2), "inertia": F(2)}
STOPPED = mp.findroot(lambda w: 800 - 2 * w**2, 21)  # the absorber's own spring holds the force

VIBRATIONS = {
    "natural angular frequency of the two-node mode of three discs alike at the ends": [(THREE,
    TWO_NODES)],
    "natural angular frequency with the inertia of the shaft itself": [(OWN, LINEAR_TWIST)],
    "moment of inertia reduced over a gear by the speeds": [(GEARED, BY_ENERGY), (GEARED, 3 + BY_ENERGY)],
    "stiffness of two shafts over a gear": [(PAIR, FAST), (PAIR, SLOW)],
    "stiffness of a shaft and a faster one over a gear": [(PAIR, FAST)],
    "torque behind a junction of two branches": [(JUNCTION, REACHED)],
    "largest stress of a turning full disc": [
        ({**DISC, "velocity": DISC["omega"] * DISC["radius"]}, AT_CENTRE)
    ],
    "critical speed of a disc in the middle of a shaft on two bearings": [
        (BEAM, 1 / mp.sqrt(40 * sag(mpf("0.6"))))
    ],
    "deflection under a load between two bearings": [(BEAM, 900 * sag(mpf("0.5")))],
    "bow of a whirling shaft by its critical speed": [(SPUN, BOWED)],
    "amplitude of a machine by a rotating unbalance": [(SPUN, each) for each in SHAKEN.values()],
    "permissible unbalance by the turns per minute": [(GRADED, ALLOWED)],
    "force of a couple of unbalances on each of two bearings": [(COUPLE, AT_BEARING)],
    "magnification above the natural frequency": [(FASTER, SWUNG)],
    "engine speed of resonance with an order": [(MET, mpf(75) / mpf("4.5") * 60)],
    "velocity in a harmonic oscillation at a displacement": [(SHM, PASSING)],
    "largest velocity of a harmonic vibration": [(SHM, FASTEST)],
    "largest acceleration of a harmonic vibration": [(SHM, HARDEST)],
    "logarithmic decrement by two peaks": [(PEAKS, DECREMENT), (NEXT_PEAK, DECREMENT)],
    "angular frequency of a damped free oscillation": [(FREE, TURNS)],
    "moment of inertia about the centre of gravity by a pendulum's period": [(ROD, INERTIA)],
    "moment of inertia by a bifilar suspension": [(HUNG, INERTIA)],
    "period of a bifilar suspension": [(HUNG, _ON_TWO)],
    "moment of inertia by a trifilar suspension": [(HUNG, INERTIA)],
    "period of a trifilar suspension": [(HUNG, _ON_TWO)],
    "frequency ratio for a transmissibility": [({"transmission": F(1, 5)}, ISOLATED)],
    "angular frequency at which an undamped absorber stops a mass": [(ABSORBER, STOPPED)],
    "stiffness of an undamped absorber": [({"mass": F(2), "inertia": F(2), "omega": F(20)}, mpf(800))],
}  # fmt: skip
