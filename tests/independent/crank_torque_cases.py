"""Numbers for the catalogue's torques, cycles and flywheels by other routes: levers, work, counting."""

from __future__ import annotations

from fractions import Fraction

from mpmath import mp, mpf

F = Fraction


def exact(number) -> Fraction:
    return F(mp.nstr(mpf(number), 30))


# Levers: a rod of 7/2 kg whose centre of gravity is 2/5 m from the big end and 4/5 m from the small end

ENDS = {
    "mass": F(7, 2), "to_big": F(2, 5), "to_small": F(4, 5), "rod": F(6, 5), "near": F(2, 5),
    "far": F(4, 5), "gyration": F(1, 2), "central": F(7, 8), "rod_acceleration": F(9),
}  # fmt: skip
SMALL_END, BIG_END = mp.lu_solve(mp.matrix([[1, 1], [0.8, -0.4]]), mp.matrix([3.5, 0]))
MASSES = SMALL_END * mpf(0.8) ** 2 + BIG_END * mpf(0.4) ** 2
DEFECT = mpf(3.5) / 4 - MASSES
THIRDS = {"piston_mass": F(1, 2), "rod_mass": F(3, 5), "crank_mass": F(2, 5)}
UPPER = mp.lu_solve(mp.matrix([[1, 1], [2, -1]]), mp.matrix([0.6, 0]))  # balanced at a third

# A crank of 3 cm

R, T, W = mpf(3) / 100, mpf(7) / 10, mpf(150)
DRIVE = {"pin": F(3, 100), "rod": F(1, 10), "crank_angle": F(7, 10), "ratio": F(3, 10),
         "rod_angle": exact(mp.asin(mpf(0.3) * mp.sin(T)))}  # fmt: skip
LONG = {"pin": F(3, 100), "rod": F(3), "ratio": F(1, 100), "crank_angle": F(7, 10), "mass": F(7, 2),
        "omega": F(150)}  # fmt: skip
PUSHED = {"tangential": F(30), "radial_part": F(50), "centrifugal": F(10), "mass": F(1),
          "pin": F(1, 10), "omega": F(10)}  # fmt: skip


def height(angle, rod=None):
    rod = mpf(1) / 10 if rod is None else rod
    return R * mp.cos(angle) + mp.sqrt(rod**2 - (R * mp.sin(angle)) ** 2)


def pull(radius):
    """Return the acceleration of a point on a circle that turns once in 2π seconds."""
    return abs(mp.diff(lambda a: radius * mp.expj(a), mpf(0), 2))


def inertia_torque():
    """Return what the piston's momentum takes from the shaft: the power of -m a at the speed v."""
    speed, rate = (mp.diff(lambda a: height(a, mpf(3)), T, n) * W**n for n in (1, 2))
    return -mpf(3.5) * rate * speed / W


def rough_height(ratio):
    return lambda a: R * (mp.cos(a) + ratio / 4 * mp.cos(2 * a))


SHARE = {"inertia": F(2), "mass": F(7, 2), "pin": F(3, 100), "crank_angle": F(7, 10), "ratio": F(3, 10)}


def reduced(rest, ratio):
    """Return twice the kinetic energy at one radian a second."""
    return rest + mpf(3.5) * mp.diff(rough_height(ratio), T) ** 2


# Cycles

PRESSURES = {
    "indicated_pressure": F(10), "effective_pressure": F(8), "lost_pressure": F(2), "efficiency": F(4, 5),
    "indicated_power": F(40), "effective_power": F(32), "lost_power": F(8),
}  # fmt: skip
GAINED, LOST = mp.quad(lambda v: 10, [0, 3]), mp.quad(lambda v: 2, [0, 3])
CYCLE = {"torque": F(300), "pressure": exact(300 * 4 * mp.pi), "volume": F(1)}
WHEEL = {"inertia": F(2), "mass": F(3), "velocity": F(5), "omega": F(100), "fluctuation": F(1, 25),
         "omega_high": F(102), "omega_low": F(98), "rotation": F(20), "radius": F(1, 4),
         "diameter": F(1, 2), "pin": F(3, 100)}  # fmt: skip
FASTEST, SLOWEST = mp.lu_solve(mp.matrix([[0.5, 0.5], [1, -1]]), mp.matrix([100, 4]))
RIM = sum(mpf(3) / 90 * abs(mp.expj(k) / 4) ** 2 for k in range(90))


def ignitions(cylinders, turns):
    """Count what fires in 40 turns of a second, each cylinder once in some turns."""
    return mpf(sum(1 for _ in range(cylinders) for turn in range(40) if turn % turns == 0))


def lowest_in_phase(cylinders, turns):
    """Return the lowest order in which all evenly fired cylinders act at once."""
    phases = [F(turns * k, cylinders) for k in range(cylinders)]
    orders = (F(n, turns) for n in range(1, 40))
    return next(k for k in orders if all((k * phase).denominator == 1 for phase in phases))


def mean_tangential(turns):
    """Return the mean force at the pin over the piston area: the work of a stroke over the pin's way."""
    return mp.quad(lambda s: 8, [0, 2 * R]) / (turns * 2 * mp.pi * R)


ENGINE = {"cylinders": F(6), "rotation": F(40), "pressure": F(8)}
EXCESS = mp.quad(lambda a: 300 * mp.sin(a), [0, mp.pi])


CRANK_TORQUE = {
    "load on the crank pin": [
        (PUSHED, abs(mp.mpc(30, 50 - 10))),
        ({name: n for name, n in PUSHED.items() if name != "centrifugal"}, abs(mp.mpc(30, 50))),
    ],
    "mechanical efficiency": [(PRESSURES, (GAINED - LOST) / GAINED)],
    "effective pressure by the losses": [(PRESSURES, (GAINED - LOST) / 3)],
    "friction mean effective pressure": [(PRESSURES, LOST / 3)],
    "work of a cycle of a four-stroke engine": [
        (CYCLE, mp.quad(lambda a: 300, [0, 2 * mp.pi, 4 * mp.pi]))
    ],
    "inertia torque of one cylinder": [(LONG, inertia_torque())],
    "distance of the piston pin from the crank's axis": [(DRIVE, height(T))],
    "distance of the piston from its top dead centre at a right angle of the crank": [
        (DRIVE, height(0) - height(mp.pi / 2))
    ],
    "moment of inertia of the two masses that replace a rod": [(ENDS, MASSES)],
    "reciprocating mass of a piston and the share of its rod": [
        ({**ENDS, "rod_mass": ENDS["mass"], "piston_mass": F(1, 2)}, SMALL_END + mpf(1) / 2)
    ],
    "rotating mass of a crank and the share of its rod": [
        ({**ENDS, "rod_mass": ENDS["mass"], "crank_mass": F(1, 2)}, BIG_END + mpf(1) / 2)
    ],
    "mass of a rod at its small end": [(ENDS, SMALL_END)],
    "mass of a rod at its big end": [(ENDS, BIG_END)],
    "reciprocating mass with a third of the rod": [(THIRDS, mpf(0.5) + UPPER[0])],
    "rotating mass with two thirds of the rod": [(THIRDS, mpf(0.4) + UPPER[1])],
    "couple that corrects a rod of two masses": [(ENDS, DEFECT * 9), (ENDS, -DEFECT * 9)],
    "correction of the moment of inertia of a rod of two masses": [(ENDS, DEFECT), (ENDS, -DEFECT)],
    "excess of inertia of a rod of two masses": [(ENDS, -DEFECT)],
    "rotating mass of a throw and its rod": [
        (
            {**ENDS, "balance_mass": F(2), "arm_of_weight": F(1, 20), "pin": F(3, 100)},
            BIG_END + 2 * pull(mpf(1) / 20) / pull(mpf(3) / 100),
        )
    ],
    "kinetic energy of a crank and its piston": [
        (WHEEL, mp.quad(lambda w: 2 * w, [0, 100]) + mp.quad(lambda v: 3 * v, [0, 5]))
    ],
    "energy between two speeds of a flywheel": [(WHEEL, mp.quad(lambda w: 2 * w, [98, 102]))],
    "moment of inertia with the piston's mean share": [
        (
            SHARE,
            mp.quad(lambda a: 2 + mpf(3.5) * (R * mp.sin(a)) ** 2, [0, mp.pi, 2 * mp.pi]) / (2 * mp.pi),
        )
    ],
    "moment of inertia of the drive reduced to the crank": [
        (SHARE, reduced(rest, ratio)) for rest in (2, 0) for ratio in (mpf(0), mpf(3) / 10)
    ],
    "moment of inertia about the centre of gravity": [
        (
            {"inertia": F(12), "central": F(12), "mass": F(4), "shift": F(3, 2)},
            mp.quad(lambda x: mpf(4) / 3 * (x - mpf(3) / 2) ** 2, [0, 3]),
        )
    ],
    "largest speed of rotation": [(WHEEL, FASTEST), (WHEEL, FASTEST / 5)],
    "smallest speed of rotation": [(WHEEL, SLOWEST), (WHEEL, SLOWEST / 5)],
    "coefficient of fluctuation of energy": [
        (
            {"excess": exact(EXCESS), "cycle_work": exact(600 * mp.pi)},
            EXCESS / mp.quad(lambda a: 300 * (1 + mp.sin(a)), [0, mp.pi, 2 * mp.pi]),
        )
    ],
    "moment of inertia of a rim": [(WHEEL, RIM)],
    "mass of a rim": [({**WHEEL, "inertia": exact(RIM)}, mpf(3))],
    "mean tangential pressure of a four-stroke engine": [(ENGINE, mean_tangential(2))],
    "mean tangential pressure of a two-stroke engine": [(ENGINE, mean_tangential(1))],
    "order of the lowest main harmonic of a four-stroke engine": [
        (ENGINE, mpf(int(lowest_in_phase(6, 2))))
    ],
    "order of the lowest main harmonic of a two-stroke engine": [
        (ENGINE, mpf(int(lowest_in_phase(6, 1))))
    ],
}
