"""Numbers for quantities of shafts, mounts, dampers and fatigue by other routes: roots and work."""

from __future__ import annotations

from fractions import Fraction

from mpmath import mp, mpf

F = Fraction


def exact(number) -> Fraction:
    return F(mp.nstr(mpf(number), 30))


# Fatigue

HIGH, LOW = F(180), F(-40)
CYCLE = {"upper_stress": HIGH, "lower_stress": LOW}
MIDDLE = mp.quad(lambda t: 110 * mp.sin(t) + 70, [0, mp.pi, 2 * mp.pi]) / (2 * mp.pi)
SWING = {
    "stress_amplitude": F(110), "mean_stress": F(70), "endurance": F(300), "static_strength": F(700),
}  # fmt: skip
ALONG = mp.findroot(lambda n: n * mpf(110) / 300 + n * mpf(70) / 700 - 1, 2)
SAFETIES = {"bending_safety": F(3), "torsion_safety": F(4)}
ON_ELLIPSE = mp.findroot(lambda n: (n / 3) ** 2 + (n / 4) ** 2 - 1, 2)
NOTCH = {"sensitivity": F(3, 4), "form_factor": F(11, 5)}
BETWEEN = mpf(1) * mpf("0.25") + mpf("2.2") * mpf("0.75")  # from 1 without to K_t with full sensitivity

# Forced vibrations

MASS, RATE, DASHPOT, SPEED = mpf("3.5"), mpf(4000), mpf(46), mpf(25)
FREE = mp.sqrt(RATE / MASS)
LEHR = DASHPOT / (2 * mp.sqrt(MASS * RATE))
DRIVEN = {
    "tuning": exact(SPEED / FREE), "damping_ratio": exact(LEHR), "damping": F(46), "omega": F(25),
    "stiffness": F(4000), "mass": F(7, 2),
}  # fmt: skip
ABOVE = {"tuning": F(2)}


def passed(speed, dashpot):
    foot = RATE + 1j * dashpot * speed
    return abs(foot / (RATE - MASS * speed**2 + 1j * dashpot * speed))


LAG = mp.arg(RATE - MASS * SPEED**2 + 1j * DASHPOT * SPEED)
SHIFT = mpf("0.002")
BOW = mp.findroot(lambda y: RATE * y - MASS * SPEED**2 * (y + SHIFT), 0.001)
SIZE = mpf("0.03")
PER_CYCLE = mp.quad(
    lambda t: DASHPOT * (SIZE * SPEED * mp.cos(SPEED * t)) ** 2, mp.linspace(0, 2 * mp.pi / SPEED, 5)
)

# Dampers: the response of a mass with a smaller one on a spring and a dashpot

MU = mpf("0.2")


def response(speed, tuning, damping, ratio=MU):
    """Return the square of the main mass's amplitude over its static deflection."""
    loss = (2 * damping * speed) ** 2
    above = loss + (speed**2 - tuning**2) ** 2
    spring = ratio * tuning**2 * speed**2 - (speed**2 - 1) * (speed**2 - tuning**2)
    return above / (loss * (speed**2 - 1 + ratio * speed**2) ** 2 + spring**2)


def fixed_points(tuning):
    """Return the speeds at which the response is the same with and without damping."""
    half = (1 + tuning**2 * (1 + MU)) / (2 + MU)
    rest = mp.sqrt(half**2 - 2 * tuning**2 / (2 + MU))
    return mp.sqrt(half - rest), mp.sqrt(half + rest)


def unequal(tuning):
    low, high = fixed_points(tuning)
    return response(low, tuning, 0) - response(high, tuning, 0)


BEST = mp.findroot(unequal, (mpf("0.8"), mpf("0.85")))


def flat(speed, tuning, start):
    """Return the damping with which the response is largest at a speed."""
    return mp.findroot(lambda z: mp.diff(lambda g: response(g, tuning, z), speed), start)


MEAN_OF_TWO = mp.sqrt(sum(flat(speed, BEST, mpf("0.2")) ** 2 for speed in fixed_points(BEST)) / 2)
COMMON = mp.findroot(
    lambda g: response(g, 0, mpf("0.3")) - response(g, 0, mpf("0.9")),
    (0.93, 0.97),
    solver="anderson",
    tol=1e-12,
)
RING = flat(COMMON, 0, mpf("0.4"))
HANG, BOB, TURNING = mpf("0.09"), mpf("0.01"), mpf(150)
PUSHED_BACK = (
    mp.diff(lambda a: -(TURNING**2) / 2 * abs(HANG + BOB * mp.expj(a)) ** 2, 0, 2) / BOB**2
)  # by the centrifugal potential
PENDULUM = {"hang": F(9, 100), "bob": F(1, 100), "omega": F(150)}

# Discs on shafts

J1, J2 = mpf("0.03"), mpf("0.07")
PAIR = {"stiffness": F(4000), "first_inertia": F(3, 100), "second_inertia": F(7, 100)}
MODES = mp.eig(mp.matrix([[RATE / J1, -RATE / J1], [-RATE / J2, RATE / J2]]))[0]
TWO_DISCS = mp.sqrt(max(mode.real for mode in MODES))
ON_SPRINGS = {"stiffness": F(4000), "mass": F(7, 2), "gravity": F(981, 100)}
SAG = MASS * mpf("9.81") / RATE
SAGGED = {**ON_SPRINGS, "static_deflection": exact(SAG)}
SPEEDS = {"first_speed": F(90), "second_speed": F(130), "third_speed": F(210)}


def by_softness(*speeds):
    """Return the speed at which the deflections by each mass alone add up."""
    return mp.sqrt(1 / sum(mpf(1) / speed**2 for speed in speeds))


RATIO = mpf(3)
GEARED = {"gear_ratio": F(3), "inertia": F(3, 100), "stiffness": F(4000)}


def doubled_energy(size, ratio):
    return 2 * (size / 2 * (ratio * 7) ** 2) / 7**2


TURNED, TORQUE = mpf(1), J1 * mpf(120) ** 2
NEXT = mp.findroot(lambda a: J1 * -(mpf(120) ** 2) * TURNED - RATE * (a - TURNED), 1)
HOLZER = {
    "amplitude_before": F(1), "torque": exact(TORQUE), "stiffness": F(4000), "inertia": F(3, 100),
    "omega": F(120),
}  # fmt: skip
WIRE, COIL, WINDINGS, SHEAR = mpf("0.004"), mpf("0.03"), 7, mpf(79) * 10**9
COILED = {
    "wire": F(4, 1000), "coil": F(3, 100), "windings": F(7), "shear": F(79 * 10**9), "force": F(50),
}  # fmt: skip
WIRE_POLAR = mp.quad(lambda r: 2 * mp.pi * r**3, [0, WIRE / 2])
UNIT_TWIST = (COIL / 2) ** 2 / (SHEAR * WIRE_POLAR)  # the work of a unit force along the wire
SOFTNESS = UNIT_TWIST * WINDINGS * mp.pi * COIL
THROW = {"central": F(1, 50), "rotating": F(2), "reciprocating": F(3), "crank": F(1, 20)}
MEAN_THROW = mp.quad(lambda a: mpf("0.05") ** 2 * (2 + 3 * mp.sin(a) ** 2), [0, mp.pi, 2 * mp.pi]) / (
    2 * mp.pi
)
PIN = mpf("0.05")
MOMENT = mp.quad(lambda y: y * 2 * mp.sqrt(PIN**2 / 4 - y**2), [0, PIN / 2])
SECOND = mp.quad(lambda y: y**2 * 2 * mp.sqrt(PIN**2 / 4 - y**2), [-PIN / 2, 0, PIN / 2])
MIDDLE_SHEAR = 900 * MOMENT / (SECOND * PIN)
PIN_AREA = mp.quad(lambda r: 2 * mp.pi * r, [0, PIN / 2])
SHEARED = {
    "shear_force": F(900), "diameter": F(5, 100), "area": exact(PIN_AREA), "shearing": exact(900
    / PIN_AREA),
}  # fmt: skip


def on_springs(number):
    """Return the cases of a mass on some equal springs."""
    together = mp.fsum(RATE for _ in range(number))
    speed = mp.sqrt(together / MASS)
    return {
        f"natural angular frequency on {number} equal springs": [(ON_SPRINGS, speed)],
        f"natural frequency in cycles on {number} equal springs": [(ON_SPRINGS, speed / (2 * mp.pi))],
        f"static deflection on {number} equal springs": [(ON_SPRINGS, MASS * mpf("9.81") / together)],
    }


SHAFTS = {
    "amplitude of a stress that swings": [(CYCLE, 180 - MIDDLE)],
    "mean of a stress that swings": [(CYCLE, MIDDLE)],
    "fatigue notch factor": [(NOTCH, BETWEEN)],
    "safety factor in bending and torsion together": [(SAFETIES, ON_ELLIPSE)],
    "safety factor by a straight line of the fatigue diagram": [(SWING, ALONG)],
    "transmissibility of a mount": [
        (DRIVEN, passed(SPEED, DASHPOT)), (DRIVEN, passed(SPEED, 0)), (ABOVE, passed(2 * FREE, 0)),
    ],
    "phase angle of a forced vibration": [(DRIVEN, LAG)],
    "lag of a forced vibration behind its force": [(DRIVEN, LAG)],
    "bow of a shaft that whirls": [({**DRIVEN, "eccentricity": F(2, 1000)}, BOW)],
    "energy lost per cycle in a viscous damper": [({**DRIVEN, "amplitude": F(3, 100)}, PER_CYCLE)],
    "optimum tuning of an absorber": [({"mass_ratio": F(1, 5)}, BEST)],
    "optimum damping of a tuned absorber": [({"mass_ratio": F(1, 5)}, MEAN_OF_TWO)],
    "optimum damping of a viscous ring": [({"mass_ratio": F(1, 5)}, RING)],
    "greatest magnification with the best viscous ring": [
        ({"mass_ratio": F(1, 5)}, mp.sqrt(response(COMMON, 0, RING)))
    ],
    "order to which a pendulum is tuned": [(PENDULUM, mp.sqrt(PUSHED_BACK) / TURNING)],
    "natural angular frequency of a pendulum on a turning crank": [(PENDULUM, mp.sqrt(PUSHED_BACK))],
    "natural angular frequency of two discs on a shaft": [(PAIR, TWO_DISCS)],
    "natural frequency in cycles of two discs on a shaft": [(PAIR, TWO_DISCS / (2 * mp.pi))],
    **{name: cases for number in (2, 3, 4, 6) for name, cases in on_springs(number).items()},
    "natural frequency in cycles by the static deflection": [(SAGGED, FREE / (2 * mp.pi))],
    "critical speed of bending of a shaft": [(SAGGED, FREE)],
    "critical speed of bending of a shaft in turns": [
        (SAGGED, FREE / (2 * mp.pi)), (SAGGED, FREE / (2 * mp.pi) * 60)
    ],
    "critical speed of bending of a shaft in turns per minute": [(SAGGED, FREE / (2 * mp.pi) * 60)],
    "critical speed of bending of a shaft in turns per second": [(SAGGED, FREE / (2 * mp.pi))],
    "critical speed of two discs by Dunkerley": [(SPEEDS, by_softness(90, 130))],
    "critical speed of three discs by Dunkerley": [(SPEEDS, by_softness(90, 130, 210))],
    "moment of inertia reduced over a gear": [
        (GEARED, doubled_energy(J1, RATIO)), (GEARED, doubled_energy(J1, 1 / RATIO))
    ],
    "torsional stiffness reduced over a gear": [
        (GEARED, doubled_energy(RATE, RATIO)), (GEARED, doubled_energy(RATE, 1 / RATIO))
    ],
    "next amplitude of a Holzer table": [(HOLZER, NEXT)],
    "stiffness of a helical spring": [(COILED, 1 / SOFTNESS)],
    "stress in the wire of a helical spring": [(COILED, 50 * COIL / 2 * WIRE / 2 / WIRE_POLAR)],
    "mean inertia of a crank with its running gear": [
        (THROW, mpf("0.02") + MEAN_THROW), (THROW, MEAN_THROW)
    ],
    "greatest shear stress of a shear force in a round section": [(SHEARED, MIDDLE_SHEAR)],
}  # fmt: skip
