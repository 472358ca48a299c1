"""How soon the outputs repeat on a grid of evenly spaced angles."""

from __future__ import annotations

from symbalance.codegen.plans import Plan


def repeating(planned: Plan, divide: str = "/", gcd: str = "gcd") -> tuple[str, bool]:
    """Return the formula of how many of `points` to a turn make a period, and whether it calls gcd.

    With the outputs repeating s = a/b times in a turn, the grid repeats after b points/gcd(b points, a).
    """
    times, under = planned.step.numerator, planned.step.denominator
    whole = "points" if under == 1 else f"{under}*points"
    return (whole, False) if times == 1 else (f"{whole}{divide}{gcd}({whole}, {times})", True)
