"""Numbers for resonance curves and for shafts in detail by other routes: roots, work, waves."""

from __future__ import annotations

from fractions import Fraction

from mpmath import mp, mpf

from tests.independent.shaft_cases import BEST

F = Fraction


def exact(number) -> Fraction:
    return F(mp.nstr(mpf(number), 30))


MASS, RATE, DASHPOT, SPEED = mpf("3.5"), mpf(4000), mpf(46), mpf(25)
FREE = mp.sqrt(RATE / MASS)
LEHR = DASHPOT / (2 * mp.sqrt(MASS * RATE))
DRIVEN = {
    "tuning": exact(SPEED / FREE), "damping_ratio": exact(LEHR), "omega": F(25),
    "stiffness": F(4000), "mass": F(7, 2), "inertia": F(7, 2), "excitation": F(60),
}  # fmt: skip


def passed(speed):
    return abs(RATE / (RATE - MASS * speed**2))


TOP = mp.findroot(lambda r: mp.diff(lambda x: (1 - x**2) ** 2 + (2 * LEHR * x) ** 2, r), 0.9)
HEIGHT = 1 / mp.sqrt((1 - TOP**2) ** 2 + (2 * LEHR * TOP) ** 2)
NARROW = mpf("0.0000001")


def half_power(start):
    """Return a speed at which a mass of little damping swings with 1/√2 of what it does at resonance."""
    return mp.findroot(
        lambda r: ((1 - r**2) ** 2 + (2 * NARROW * r) ** 2) / NARROW**2 - 8, mpf(start), tol=1e-12
    )


LOWER, UPPER = half_power("0.9999999"), half_power("1.0000001")
POINTS = {"upper_point": exact(UPPER * 50), "lower_point": exact(LOWER * 50), "resonant": F(50)}
BY_UNBALANCE = mp.findroot(
    lambda x: RATE * x - MASS * SPEED**2 * x - mpf("0.1") * mpf("0.02") * SPEED**2, 0.001
)
BY_FORCE = mp.findroot(lambda x: RATE * x - MASS * SPEED**2 * x - 60, 0.01)
BELOW = {"driving": F(25), "natural": exact(FREE)}
ABOVE = {"driving": F(80), "natural": exact(FREE)}
DECAYING = mp.polyroots([MASS, DASHPOT, RATE])[0]
BENDING = mpf(21) * 10**10 * 3 / 10**8
BAR = {
    "young": F(21 * 10**10), "section": F(3, 10**8), "length": F(6, 5), "force": F(900),
    "line_load": F(350),
    "mass_per_length": F(7),
}  # fmt: skip
SPAN = mpf("1.2")
WAVES = mp.pi / SPAN  # a sine between the bearings: its fourth derivative against the mass's acceleration
WHIRL = mp.sqrt(BENDING * abs(mp.diff(lambda x: mp.sin(WAVES * x), 0.6, 4)) / 7)
HALF_WAVE = mp.findroot(lambda load: mp.sin(mp.sqrt(load / BENDING) * SPAN), 43000)


def half(x):
    """Return the moment of a unit load in the middle of two supports."""
    return min(x, SPAN - x) / 2


BOTH_FIXED = mp.quad(lambda x: (900 * half(x) - 900 * SPAN / 8) * half(x) / BENDING, [0, 0.6, 1.2])
UNIFORM_SAG = mp.quad(lambda x: 350 * x * (SPAN - x) / 2 * half(x) / BENDING, [0, 0.6, 1.2])
TILT_OF_END = mp.quad(lambda x: 900 * x / BENDING, [0, 1.2])
OUT, IN = mpf("0.05"), mpf("0.03")
RING_POLAR = mp.quad(lambda r: 2 * mp.pi * r**3, [IN / 2, OUT / 2])
RINGED = {"outer": F(5, 100), "inner": F(3, 100), "torque": F(130), "bending": F(80)}
ROUND = {
    "diameter": F(5, 100), "radius": F(5, 200), "torque": F(130), "omega": F(120),
    "rotation": exact(120 / (2 * mp.pi)),
}  # fmt: skip
ROUND_AXIAL = mp.quad(lambda r: mp.pi * r**3, [0, OUT / 2])
STRESS = 130 * (OUT / 2) / (2 * ROUND_AXIAL)
THREE = {"first_rate": F(300), "second_rate": F(700), "third_rate": F(900)}
ONE_FORCE = 1 / sum(mpf(1) / rate for rate in (300, 700, 900))
FATIGUE = {"mean_stress": F(70), "endurance": F(300), "static_strength": F(700)}

PLANE = mp.eigsy(mp.matrix([[40, 27], [27, 0]]), eigvals_only=True)
BY_BOTH = {"stress": F(40), "shearing": F(27)}
WORK_IN = mp.quad(  # a torque a quarter of a turn ahead of the motion
    lambda t: 60 * mp.cos(t) * mpf("0.03") * mp.cos(t), mp.linspace(0, 2 * mp.pi, 5)
)

RESONANCE = {
    "largest principal stress of bending and torsion": [(BY_BOTH, max(PLANE))],
    "largest shear stress of bending and torsion": [(BY_BOTH, (max(PLANE) - min(PLANE)) / 2)],
    "work of an excitation per cycle at resonance": [({**DRIVEN, "amplitude": F(3, 100)}, WORK_IN)],
    "natural frequency of an absorber with optimum tuning": [
        ({"resonant": exact(FREE), "mass_ratio": F(1, 5)}, BEST * FREE)
    ],
    "allowable amplitude by a straight line of the fatigue diagram": [
        (FATIGUE, mp.findroot(lambda a: a / 300 + mpf(70) / 700 - 1, 200))
    ],
    "isolation of a mount": [({"tuning": F(2)}, 1 - passed(2 * FREE))],
    "transmissibility by the two frequencies": [(BELOW, passed(25)), (ABOVE, passed(80))],
    "magnification by the two frequencies": [(BELOW, passed(25))],
    "amplitude by an unbalance": [
        ({**DRIVEN, "unbalanced": F(1, 10), "eccentricity": F(1, 50)}, BY_UNBALANCE)
    ],
    "amplitude of a forced vibration": [(DRIVEN, BY_FORCE)],
    "frequency ratio at the top of a resonance curve": [(DRIVEN, TOP)],
    "frequency of the top of a resonance curve": [({**DRIVEN, "resonant": exact(FREE)}, TOP * FREE)],
    "height of a resonance curve": [(DRIVEN, HEIGHT)],
    "damping ratio by the half-power points": [(POINTS, NARROW)],
    "quality factor by the half-power points": [(POINTS, 1 / (2 * NARROW))],
    "stiffness by a natural frequency": [
        ({**DRIVEN, "omega": exact(FREE), "frequency": exact(FREE / (2 * mp.pi))}, RATE)
    ],
    "period of a damped oscillation": [
        ({"omega": exact(FREE), "damping_ratio": exact(LEHR)}, 2 * mp.pi / abs(DECAYING.imag))
    ],
    "whirling speed of a uniform shaft on two bearings": [(BAR, WHIRL)],
    "torsional stress of a hollow shaft": [(RINGED, 130 * OUT / 2 / RING_POLAR)],
    "bending stress of a hollow shaft": [(RINGED, 80 * OUT / RING_POLAR)],
    "section modulus of a round section by which bending is reckoned": [(ROUND, ROUND_AXIAL / (OUT / 2))],
    "stiffness of three springs in series": [(THREE, ONE_FORCE)],
    "stiffness of three springs in parallel": [(THREE, mpf(1900))],
    "force at the surface of a shaft": [(ROUND, 130 / (OUT / 2))],
    "buckling load of a strut with pinned ends": [(BAR, HALF_WAVE)],
    "sliding speed of a journal": [(ROUND, 120 * OUT / 2)],
    "diameter of a shaft for a torque": [({"torque": F(130), "shear_stress_allowed": exact(STRESS)},
    OUT)],
    "diameter of a shaft for an equivalent torque": [
        ({"torque": F(130), "shear_stress_allowed": exact(STRESS)}, OUT)
    ],
    "deflection of a beam fixed at both ends and loaded in the middle": [(BAR, BOTH_FIXED)],
    "deflection of a simply supported beam with a uniform load": [(BAR, UNIFORM_SAG)],
    "slope at the end of a cantilever": [(BAR, TILT_OF_END)],
}  # fmt: skip
