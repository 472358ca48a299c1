"""Grids of evenly spaced angles: how soon the outputs repeat, and how their size is read."""

from __future__ import annotations

from symbalance.codegen.plans import Plan


def repeating(planned: Plan, divide: str = "/", gcd: str = "gcd") -> tuple[str, bool]:
    """Return the formula of how many of `points` to a turn make a period, and whether it calls gcd.

    With the outputs repeating s = a/b times in a turn, the grid repeats after b points/gcd(b points, a).
    """
    times, under = planned.step.numerator, planned.step.denominator
    whole = "points" if under == 1 else f"{under}*points"
    return (whole, False) if times == 1 else (f"{whole}{divide}{gcd}({whole}, {times})", True)


WHOLE = '''

def _whole(name, value):
    """Return a whole number, at least 1, or refuse what is none: True too, nan and None."""
    try:
        number = int(value)
        fits = bool(number == value >= 1) and "bool" not in type(value).__name__
    except (TypeError, ValueError, OverflowError):
        fits = False
    if not fits:
        raise ValueError(f"{{name}} = {{value!r}}: must be a whole number, at least 1")
    return number
'''
"""How numbers of points and turns are read in Python; part of a template, so braces are doubled."""
