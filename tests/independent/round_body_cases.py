"""Numbers for round bodies and single harmonics by other routes: integrals over rings, sums over time."""

from __future__ import annotations

from fractions import Fraction

from mpmath import mp, mpf

F = Fraction
INSIDE, OUTSIDE, THICK, HEAVY, TURNS = F(3, 100), F(5, 100), F(2, 100), F(7850), F(40)
FULL = {
    "radius": OUTSIDE, "diameter": 2 * OUTSIDE, "wall_of_weight": THICK, "length": THICK,
    "density": HEAVY,
}  # fmt: skip
BORED = {
    "outer_radius": OUTSIDE, "inner_radius": INSIDE, "outer": 2 * OUTSIDE, "inner": 2 * INSIDE,
    "wall_of_weight": THICK, "length": THICK, "density": HEAVY,
}  # fmt: skip


def over_ring(weight, inside=INSIDE, turn=2 * mp.pi):
    """Integrate a function of the radius over a ring, or a sector of one."""
    return mp.quad(
        lambda r: weight(r) * turn * r, [mpf(inside.numerator) / inside.denominator, mpf("0.05")]
    )


LAYER = mpf(7850) * mpf("0.02")
SPEED = mpf(40) * mpf("0.05")
# half a ring of section 1 is held at its two ends against the forces ρ r ω² of its arc
PULLED = mp.quad(lambda a: 7850 * mpf("0.05") * mpf(40) ** 2 * mp.sin(a) * mpf("0.05"), [0, mp.pi]) / 2
RIM = {"density": HEAVY, "velocity": TURNS * OUTSIDE, "radius": OUTSIDE, "omega": TURNS}
DASHPOT = {"damping": F(46), "omega": F(25), "amplitude": F(3, 100)}
HEATED = mp.quad(
    lambda t: 46 * (mpf("0.03") * 25 * mp.cos(25 * t)) ** 2, mp.linspace(0, 2 * mp.pi / 25, 5)
)
DRIVEN = {"excitation": F(300), "inertia": F(7, 10), "order": F(3), "omega": F(20)}
SPED_UP = mp.quad(lambda t: 300 / mpf("0.7") * mp.sin(60 * t), [0, mp.pi / 60]) / 2  # half the swing
TURNED = mp.quad(lambda t: SPED_UP * mp.cos(60 * t), [-mp.pi / 120, mp.pi / 120]) / 2

ROUND_BODIES = {
    "hoop stress of a turning rim": [(RIM, PULLED)],
    "area of a half disc": [(FULL, over_ring(lambda r: 1, F(0), mp.pi))],
    "area of a ring": [(BORED, over_ring(lambda r: 1))],
    "moment of inertia of a disc by its density": [(FULL, LAYER * over_ring(lambda r: r * r, F(0)))],
    "moment of inertia of a hollow disc by its density": [(BORED, LAYER * over_ring(lambda r: r * r))],
    "mass of a hollow disc": [(BORED, LAYER * over_ring(lambda r: 1))],
    "power lost in a viscous damper": [(DASHPOT, HEATED / (2 * mp.pi / 25))],
    "amplitude of the speed by one harmonic of the torque": [(DRIVEN, SPED_UP)],
    "amplitude of the angle by one harmonic of the torque": [(DRIVEN, TURNED)],
    "unbalance by its force": [
        ({"force": F(48), "centrifugal": F(48), "omega": F(40)}, mpf("0.6") * mpf("0.05"))
    ],  # 0.6 kg at 0.05 m pull with m r ω² = 48 N
}
