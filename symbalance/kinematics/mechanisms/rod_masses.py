"""A connecting rod as two masses at its ends and one inertia couple, together exactly the real rod.

A rod of mass M and length L, its centre of gravity c from the big end and its moment of inertia J
about that centre, has for every motion the momentum and the kinetic energy of m_1 at the piston's pin,
m_2 at the crank's pin, and a massless body of moment of inertia J_x that turns with the rod: mass, centre
of gravity and moment of inertia agree.

Formulas:
    m_1 + m_2 = M
    m_1 L = M c
    m_1 (L - c)^2 + m_2 c^2 + J_x = J
    with m_1 = M c/L; m_2 = M (1 - c/L); J_x = J - M c (L - c); M, c, L, J positive

J_x is negative where the rod's mass lies further in than at its ends, which is usual. The first mass
only goes along the cylinder, the second only round with the crank (a link rod's goes with its link pin,
and belongs to the master rod): they count as reciprocating and as rotating mass. What is left is the
inertia couple of J_x. The rod points from its pin along -phi, so that, positive in the sense of rotation,
the couple is J_x omega^2 phi'' about the crank's axis, the same wherever the cylinder stands: it rolls
the engine and does nothing else. Without offset:

Formulas:
    k_1 = -rho - rho^3/8 - ...
    k_3 = 3 rho^3/8 + ...
    d^2phi/dtheta^2 = -rho (1 - rho^2) sin theta/cos^3 phi
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from symbalance.errors import SymbalanceError, brief
from symbalance.kinematics.mechanisms.fourier import rod_angle_harmonics
from symbalance.kinematics.mechanisms.mechanism_types import Mechanism
from symbalance.kinematics.mechanisms.motion import rod_motion
from symbalance.kinematics.slider_crank import Series, rod_angle_series
from symbalance.text.numbers import exact
from symbalance.text.reals import Complex, Exact, Real, cos, tan


@dataclass(frozen=True)
class RodSplit:
    """A rod's mass, length, centre of gravity (from the big end), and moment of inertia J about it.

    Any units that agree: kg, m, m, kg m^2 or kg, mm, mm, kg mm^2. All are held exactly, as fractions.

    Formulas:
        m_1 (L - c)^2 + m_2 c^2 = M c (L - c)
        with m_1 = M c/L; m_2 = M (1 - c/L); M, c, L positive

    >>> rod = RodSplit(mass="0.6", length=150, centre=45, inertia=2500)
    >>> rod.reciprocating, rod.rotating, rod.excess
    (Fraction(9, 50), Fraction(21, 50), Fraction(-335, 1))
    """

    mass: Fraction
    length: Fraction
    centre: Fraction
    inertia: Fraction

    def __post_init__(self) -> None:
        for name in ("mass", "length", "centre", "inertia"):
            value = exact(getattr(self, name), name)
            object.__setattr__(self, name, value)
            if value < 0 or (value == 0 and name == "length"):
                what = f"{name} = {brief(value)}"
                raise SymbalanceError(what, "must not be negative, nor the length 0", "check the sign")
        if self.centre > self.length:
            rule = f"must lie between the rod's ends, within 0 and {brief(self.length)}"
            raise SymbalanceError(f"centre = {brief(self.centre)}", rule, "count from the big end")

    @property
    def reciprocating(self) -> Fraction:
        """The mass at the piston's end, m_rod a/l."""
        return self.mass * self.centre / self.length

    @property
    def rotating(self) -> Fraction:
        """The mass at the crank's end, m_rod (1 - a/l)."""
        return self.mass - self.reciprocating

    @property
    def excess(self) -> Fraction:
        """The moment of inertia J_x that the two masses lack; negative where they have too much."""
        return self.inertia - self.mass * self.centre * (self.length - self.centre)

    def couple_harmonics(self, mechanism: Mechanism, order: int, digits: int = 20) -> dict[int, Complex]:
        """Return n -> k_n, n = 1..order: the couple J_x phi'' = sum of k_n e^(inp), k_-n = conj(k_n).

        Units: those of J_x, times omega^2; positive in the sense of rotation. k_n = -n^2 J_x d_n with
        d_n of `rod_angle_harmonics`, with its errors times that.

        >>> from symbalance.kinematics.mechanisms import SliderCrank
        >>> rod = RodSplit(1, 1, "1/2", "1/4")
        >>> rod.excess, rod.couple_harmonics(SliderCrank(4), 4)
        (Fraction(0, 1), {})
        """
        excess = self.excess
        if not excess:
            return {}
        angles = rod_angle_harmonics(mechanism, order, digits)
        return {n: d * (-n * n * excess) for n, d in angles.items() if n}


def rocking_series(order: int, through: int) -> Series:
    """Return the coefficient of sin(order p) in -phi'', centred, kept through (1/lambda)^through.

    It is n^2 R_n, or -k_n:

    Formulas:
        -k_3 = 9 R_3
        -k_5 = 25 R_5

    >>> [rocking_series(n, through=5).in_powers_of_rho() for n in (1, 3, 5)]
    [3*rho**5/64 + rho**3/8 + rho, -27*rho**5/128 - 3*rho**3/8, 15*rho**5/128]
    """
    return rod_angle_series(order, through).scaled(order * order)


def side_thrust(
    mechanism: Mechanism, p: Exact | Real, axial: Exact | Real, excess: Exact | Real = 0
) -> Real:
    """Return the side force on the cylinder's wall, positive towards + lateral.

        N = F tan phi + J_x phi''/(lam cos phi)

    `axial` is F, all that pushes the piston along the axis away from the crank: gas (negative when it
    drives) and inertia -y'' of the reciprocating mass, the rod's share included; `excess` is J_x. Units
    m r omega^2 and m r^2 with one m of your choice, so omega = r = 1.

    Without offset the thrust of a force along the axis is

    Formulas:
        tan phi = rho sin theta/cos phi

    From d'Alembert: along the axis the rod holds the piston against F; across it the wall gives what the
    moments about the rod's lower pin need, and pushes the piston with -N. The crank's bearings push the
    frame with -N too, lower down: no lateral force is left, only a couple about the crank's axis. That is
    true of link rods too; of a master rod it leaves out what the link rods on it bear on it.

    >>> from symbalance.kinematics.mechanisms import SliderCrank
    >>> from symbalance.text.reals import nstr, pi
    >>> nstr(side_thrust(SliderCrank(4), pi() / 2, axial=-1), 10)  # gas drives: away from the pin
    '-0.2581988897'
    """
    rod = rod_motion(mechanism, p)
    return axial * tan(rod.value) + excess * rod.second / (mechanism.length * cos(rod.value))
