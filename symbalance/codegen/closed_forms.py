r"""A piston's motion in closed form, every order at once, in formulas that lose no digits.

With c = cos theta, g = cos 2 theta, k'^2 = (1 - rho)(1 + rho), every order of a piston's acceleration
above the first is

    E = rho (c^4 - k'^2 s^4)/(k'^2 + rho^2 c^2)^(3/2)                     where rho^2 > 1/2,
      = rho (g (1 + k'^2)/2 + rho^2 (1 + g^2)/4)/(1 - rho^2 (1 - g)/2)^(3/2)  elsewhere.

The first keeps its digits where rho nears 1 (k'^2 + rho^2 c^2 does not cancel as 1 - rho^2 s^2 does),
the second keeps the digits of g. Displacement from top dead centre, with h = theta/2 reduced so that
sin h keeps its own digits near every dead centre:

    x = 2 sin^2 h (1 + 2 rho cos^2 h/(1 + sqrt(k'^2 + rho^2 cos^2 theta))).
"""

from __future__ import annotations

from fractions import Fraction

from symbalance.codegen.cosines import LIMIT, Cosine, per_point, sine_lines, sine_tail, split_on_grids
from symbalance.codegen.expression_ir import Kernel
from symbalance.codegen.harmonic_sum import ClosedForm
from symbalance.text.reals import Real, cos, pi, sin, sqrt

COMPRESSED = Fraction(1, 2)
"""Above this rho^2 the form in cos theta is used, below it the one in cos 2 theta."""


def squares(ratio: Fraction) -> tuple[Real, Real]:
    """Return k'^2 = 1 - rho^2 and rho^2."""
    square = 1 / (ratio * ratio)
    return Real(1 - square), Real(square)


def uses_double_angle(ratio: Fraction) -> bool:
    """Tell which of the two forms of E is used."""
    return 1 / (ratio * ratio) <= COMPRESSED


def secondary_cosine(ratio: Fraction, turns: Fraction) -> Cosine:
    """Return the cosine E(theta + 2 pi turns) is computed from."""
    step = 2 if uses_double_angle(ratio) else 1
    phase = -step * turns
    return Cosine(Fraction(step), Real(_nearest(phase)))


def _nearest(turns: Fraction) -> Fraction:
    """Return the turns within (-1/2, 1/2]."""
    return turns - round(turns)


def secondary_lines(kernel: Kernel, ratio: Fraction, cosine: str, mark: str) -> str:
    """Add the lines of E, from the cosine's name; return the name of the result."""
    rest, square = squares(ratio)
    rho = kernel.constant("RHO", sqrt(square), "r/l")
    if uses_double_angle(ratio):
        half = kernel.constant("MEAN_SQUARE", (1 + rest) / 2, "1 - rho^2/2")
        swing = kernel.constant("HALF_SQUARE", square / 2, "rho^2/2")
        even = kernel.constant("EVEN", square / 4, "rho^2/4")
        d = kernel.line(f"d{mark}", f"{half} + {swing}*{cosine}", "1 - rho^2 sin^2 theta")
        top = f"{half}*{cosine} + {even}*(1.0 + {cosine}*{cosine})"
    else:
        gap = kernel.constant("GAP", rest, "1 - rho^2")
        full = kernel.constant("RHO_SQUARE", square, "rho^2")
        z = kernel.line(f"z{mark}", f"{cosine}*{cosine}")
        d = kernel.line(f"d{mark}", f"{gap} + {full}*{z}", "1 - rho^2 sin^2 theta")
        top = f"{z}*{z} - {gap}*((1.0 - {z})*(1.0 - {z}))"
    return kernel.line(f"e{mark}", f"{rho}*({top})/({d}*sqrt({d}))", "every order above the first")


def velocity_formula(kernel: Kernel, closed_form: ClosedForm, cosine: str, sine: str) -> str:
    """Add the lines of a piston's velocity over r omega, from cos and sin of its crank angle."""
    rest, square = squares(closed_form.ratio)
    rho = kernel.constant("RHO", sqrt(square), "r/l")
    gap = kernel.constant("GAP", rest, "1 - rho^2")
    full = kernel.constant("RHO_SQUARE", square, "rho^2")
    d = kernel.line("d", f"{gap} + {full}*{cosine}*{cosine}", "1 - rho^2 sin^2 theta")
    return f"{sine}*(1.0 + {rho}*{cosine}/sqrt({d}))"


def add_reduced_range_square(kernel: Kernel, closed_form: ClosedForm, name: str) -> None:
    """Add the lines of name = sin^2 h, h half the piston's crank angle, with its own digits everywhere.

    The angle is reduced in three parts, so that what is left of it keeps its digits near a dead centre;
    what the last subtraction and the sine's last sum round off is carried along.
    """
    turn = 2 * pi(90)
    bits = 53 - (int(LIMIT / turn) + 3).bit_length()
    shift = -turn * _nearest(closed_form.places[0][1])
    period, at = ([*split_on_grids(value, bits - 3, bits, 2)] for value in (turn, shift))
    p1, p2, p3 = (kernel.constant(f"TURN_{i}", part) for i, part in enumerate(period, 1))
    s1, s2, s3 = (kernel.constant(f"TOP_{i}", part) for i, part in enumerate(at, 1))
    turns = kernel.constant("PER_RADIAN_P", 1 / turn, "turns in a radian")
    top = kernel.constant("TOP_TURNS", at[0] / turn, "where the piston is at the top")
    kernel.line("pn", f"rint(theta*{turns} - {top})", "whole turns")
    kernel.line("pa", f"theta - ({s1} + pn*{p1})", "exact")
    kernel.line("pb", f"{s2} + pn*{p2}", "exact")
    kernel.line("pd", "pa - pb")
    kernel.line("rest", f"((pa - pd) - pb) - (pn*{p3} + {s3})")
    kernel.line("pr", "pd + rest", "the crank angle from the nearest top dead centre")
    kernel.line("lost", "(pd - pr) + rest", "what rounding took from it")
    kernel.line("pside", "side(pr)")
    kernel.line("ph", "0.5*abs(pr)", "half of it, and beside it what is left to a quarter turn")
    kernel.line("pl", "0.5*(pside*lost)")
    high, low = kernel.constant("HALF_PI_1", pi() / 2), pi() / 2 - float(pi() / 2)
    kernel.line("pc", f"({high} - ph) + ({kernel.constant('HALF_PI_2', low)} - pl)")
    kernel.line("upper", "0.5 + 0.5*side(pc - ph)", "1 in the upper half of the stroke, 0 in the lower")
    kernel.line("py", "upper*ph + (1.0 - upper)*pc", "the smaller of the two")
    kernel.line("pu", "py*py")
    kernel.line("pv", f"py*pu*({sine_tail(kernel, 'pu')})")
    kernel.line("ps", "py + pv", "its sine")
    kernel.line("pq", "((py - ps) + pv) + upper*pl", "and what rounding took from that")
    kernel.line(name, "(1.0 - upper) + (2.0*upper - 1.0)*(ps*ps + 2.0*(ps*pq))")


def add_on_grid_square(kernel: Kernel, closed_form: ClosedForm, name: str) -> None:
    """Add the same at theta = 2 pi index/points."""
    turns = _nearest(closed_form.places[0][1])
    shift = f" + points*{kernel.constant('TOP_TURNS_BEFORE', turns)}" if turns else ""
    whole = f" + {kernel.constant('TOP_TURNS_BEFORE', turns)}" if turns else ""
    kernel.line("pn", f"rint(index*{per_point(kernel)}{whole})", "whole turns")
    kernel.line("pm", f"(index - pn*points){shift}")
    kernel.line("half_step", f"{kernel.constant('PI', pi())}/points", "half the angle of a point")
    kernel.line("ph", "pm*half_step", "half the crank angle")
    sine_lines(kernel, "ps", "ph", "p")
    kernel.line(name, "ps*ps")


def add_full_range_square(kernel: Kernel, closed_form: ClosedForm, name: str) -> None:
    """Add the same for any other angle, from the library's own cosine and sine."""
    half = pi() * _nearest(closed_form.places[0][1])
    c, s = kernel.constant("COS_TOP", cos(half)), kernel.constant("SIN_TOP", sin(half))
    kernel.line("ps", f"sin(0.5*theta)*{c} + cos(0.5*theta)*{s}")
    kernel.line(name, "ps*ps")


def displacement_formula(kernel: Kernel, closed_form: ClosedForm, square: str) -> str:
    """Return the displacement over r from sin^2(theta/2), adding what it needs."""
    rest, rho_square = squares(closed_form.ratio)
    rho = kernel.constant("RHO", sqrt(rho_square), "r/l")
    gap = kernel.constant("GAP", rest, "1 - rho^2")
    full = kernel.constant("RHO_SQUARE", rho_square, "rho^2")
    c = kernel.line("pc", f"1.0 - 2.0*{square}", "cos(theta)")
    root = kernel.line("root", f"sqrt({gap} + {full}*({c}*{c}))")
    return f"2.0*{square}*(1.0 + 2.0*{rho}*(1.0 - {square})/(1.0 + {root}))"
