"""Numbers for gas cycles, damping numbers and wheels by other routes: integrals, responses, balances."""

from __future__ import annotations

from fractions import Fraction

from mpmath import mp, mpc, mpf

F = Fraction


def exact(number) -> Fraction:
    return F(mp.nstr(mpf(number), 30))


# A gas that is compressed step by step: dT/T = -(γ - 1) dV/V

EXPONENT, COMPRESSION, START, PUSHED = mpf("1.4"), mpf(9), mpf(300), mpf("1.1")
GROWTH = mp.exp(mp.quad(lambda v: (EXPONENT - 1) / v, [1, COMPRESSION]))
HOT = START * GROWTH
BURNT = HOT + 900
EXHAUST = BURNT / GROWTH
END_PRESSURE = PUSHED * HOT / START * COMPRESSION
GAS = {
    "compression": F(9), "adiabatic": F(7, 5), "first_temperature": F(300), "first_pressure": F(11, 10),
    "second_pressure": exact(END_PRESSURE), "first_volume": F(18), "second_volume": F(2),
}  # fmt: skip

# A vibration that is hardly damped

MASS, RATE, DASHPOT = mpf("3.5"), mpf(4000), mpf("0.00001")
FREE = mp.sqrt(RATE / MASS)
RESPONSE = RATE / abs(mpc(RATE - MASS * FREE**2, DASHPOT * FREE))
DECAY, TURNING = DASHPOT / (2 * MASS), mp.sqrt(FREE**2 - (DASHPOT / (2 * MASS)) ** 2)
DECREMENT = mp.log(1 / mp.exp(-DECAY * 2 * mp.pi / TURNING))
DAMPED = {
    "damping_ratio": exact(DASHPOT / (2 * mp.sqrt(RATE * MASS))), "mass": exact(MASS),
    "inertia": exact(MASS), "stiffness": exact(RATE), "damping": exact(DASHPOT), "omega": exact(FREE),
    "decrement": exact(DECREMENT), "decay": exact(DECAY), "gain": exact(RESPONSE),
}  # fmt: skip
MODES, _ = mp.eigsy(mp.matrix([[1, -1, 0], [-1, 2, -1], [0, -1, 1]]))

# Wheels

RADIUS, WIDTH, DENSITY, WHEEL = mpf("0.3"), mpf("0.05"), mpf(7800), mpf("3.5")
STRESS = mpf(40) * 10**6
RIM = {"mass": exact(WHEEL), "radius": exact(RADIUS), "diameter": exact(2 * RADIUS)}
DISC = {**RIM, "density": exact(DENSITY), "wall_of_weight": exact(WIDTH), "length": exact(WIDTH)}


def pull_of_half_ring(speed):
    """Return what the halves of a ring of unit section pull with, over both of its cuts."""
    return mp.quad(lambda t: DENSITY * RADIUS * speed**2 / RADIUS * mp.sin(t), [0, mp.pi])


WHEELS_AND_CYCLES = {
    "thermal efficiency of the Otto cycle": [(GAS, 1 - (EXHAUST - START) / (BURNT - HOT))],
    "temperature at the end of an adiabatic compression": [(GAS, HOT)],
    "pressure at the end of an adiabatic compression": [(GAS, END_PRESSURE)],
    "quality factor": [(DAMPED, RESPONSE)],
    "damping ratio by the quality factor": [(DAMPED, DASHPOT / (2 * mp.sqrt(RATE * MASS)))],
    "logarithmic decrement of a light damping": [(DAMPED, DECREMENT)],
    "natural angular frequency of the second mode of three equal discs": [
        ({"stiffness": F(4000), "inertia": exact(MASS)}, mp.sqrt(RATE / MASS * max(MODES)))
    ],
    "moment of inertia of a rim that is thin": [
        (RIM, WHEEL / (2 * mp.pi) * mp.quad(lambda t: RADIUS**2, [0, 2 * mp.pi]))
    ],
    "moment of inertia about its axle of a disc by its density": [
        (DISC, mp.quad(lambda r: 2 * mp.pi * r * DENSITY * WIDTH * r**2, [0, RADIUS]))
    ],
    "speed that a thin rim stands": [
        (
            {"stress": exact(STRESS), "density": exact(DENSITY)},
            mp.findroot(lambda v: pull_of_half_ring(v) / (2 * STRESS) - 1, 70),
        )
    ],
    "circumferential speed in metres per second": [
        ({**RIM, "rotation": F(50)}, 50 * mp.quad(lambda t: RADIUS, [0, 2 * mp.pi]))
    ],
    "energy that a flywheel gives off between two speeds": [
        (
            {"inertia": F(7, 2), "first_omega": F(33), "second_omega": F(29)},
            mp.quad(lambda w: mpf("3.5") * w, [29, 33]),
        )
    ],
    "coefficient of fluctuation by the revolutions": [
        ({"highest_rate": F(51), "lowest_rate": F(49), "rotation": F(50)}, mpf(2) / 50)
    ],
    "compression ratio by the swept and the clearance volume": [
        ({"swept": F(8), "clearance": F(1)}, mpf(8 + 1))
    ],
    "factor of safety against yielding": [
        (
            {"static_strength": F(355), "stress": F(142)},
            mp.findroot(lambda n: 142 * n - 355, 2),
        )
    ],
}
