"""Errors of closed sums at and next to their removable poles: sin(Nx)/sin(x), and the couple of a row."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import numpy as np

from symbalance.bench.bounded_cases import ULP, BoundedCase, Part, attempt, worst_point
from symbalance.bench.timing import progress
from symbalance.bench.true_values import Number, mp
from symbalance.document.symbols import symbol
from symbalance.forces.inline_sums import dirichlet_quotient, inline_couple, inline_sum

BOUND = 1.0
"""ulp: SymPy evaluates to as many digits as a double holds."""
COUNTS, ORDERS = (2, 5, 6, 12, 100), (1, 2, 3)
AWAY = tuple(Fraction(sign, 10**e) for e in (16, 14, 12, 9, 6, 3) for sign in (-1, 1))
INTRODUCTION = """\
Cylinders N, order n, spacing h: sin(N n h/2)/sin(n h/2) at n h/2π whole (the pole) and off it by 1e-16
to 1e-3 of h, as float(...) of what `symbalance.forces.inline_sums` returns; true is the sum of the N
cosines. naive: the quotient in doubles, inf where it gives no number. Only the quotient can come near a
pole: sums and couples take whole N and n."""


def closed_sum_part(quick: bool) -> Part:
    """Return the cases of the sums."""
    counts = COUNTS[:3] if quick else COUNTS
    progress("closed sums")
    return Part("Closed sums at their removable poles", INTRODUCTION, [*quotients(counts), *rows(counts)])


def quotients(counts: tuple[int, ...]) -> Iterator[BoundedCase]:
    """Yield the quotient at its poles, near them, and near them with a spacing that is a float."""
    poles = [(N, n, j, Fraction(0)) for N in counts for n in ORDERS for j in (1, 2, 7)]
    near = [(N, n, j, d) for N, n, j, _ in poles for d in AWAY]
    yield quotient_case("sin(Nx)/sin(x) at its poles, h exact", poles, False)
    yield quotient_case("... within 1e-3 to 1e-16 of them, h exact", near, False)
    yield quotient_case("... within 1e-3 to 1e-16 of them, h a float", near, True)


def quotient_case(name: str, places: list[tuple[int, int, int, Fraction]], as_float: bool) -> BoundedCase:
    """Return how far off the quotient is at the spacings 2 pi j/n (1 + d), at the worst."""
    import sympy

    def make() -> BoundedCase:
        off, naive, at = [], [], []
        for N, n, j, d in places:
            turns = Fraction(j, n) * (1 + d)
            with mp.workdps(50):
                exact = 2 * mp.pi * turns.numerator / turns.denominator
                double = float(exact)
                true = cosines(N, n, mp.mpf(double) if as_float else exact)
            spacing = (
                sympy.Float(double)
                if as_float
                else 2 * sympy.pi * sympy.Rational(*turns.as_integer_ratio())
            )
            off.append(ulps(float(dirichlet_quotient(N, n, spacing)), true))
            naive.append(ulps(_quotient(N, n, double), true if as_float else cosines(N, n, exact)))
            at.append(double)
        return worst_point(
            name, np.array(at), np.array(off), BOUND, ULP, {"quotient": np.array(naive)}, "h = "
        )

    return attempt(name, BOUND, ULP, make)


def cosines(N: int, n: int, h: Number) -> Number:
    """Return the sum of cos n h (j - (N - 1)/2) over the cylinders, which is the quotient."""
    with mp.workdps(50):
        return mp.fsum(mp.cos(n * h * (mp.mpf(2 * j - N + 1) / 2)) for j in range(N))


def _quotient(N: int, n: int, h: float) -> float:
    with np.errstate(all="ignore"):
        return float(np.sin(np.float64(N * n * h / 2)) / np.sin(np.float64(n * h / 2)))


def ulps(value: float, true: Number) -> float:
    """Return how many of its ulp a value is off; infinity where it is not finite."""
    if not np.isfinite(value):
        return float("inf")
    with mp.workdps(50):
        return float(abs(value - true) / float(np.spacing(abs(float(true)))))


def rows(counts: tuple[int, ...]) -> Iterator[BoundedCase]:
    """Yield the sums and the couples of evenly firing rows at some crank angles."""
    yield row_case("inline_sum, N to 100, n to 12", counts, inline_sum, False)
    yield row_case("inline_couple, N to 100, n to 12", counts, inline_couple, True)


def row_case(name: str, counts: tuple[int, ...], formula: Any, arms: bool) -> BoundedCase:
    """Return how far off a row's formula is, in ulp of its amplitude (of 1, where it vanishes)."""
    theta = Fraction(7, 10)

    def make() -> BoundedCase:
        off, at = [], []
        for N in counts:
            for n in (1, 2, 3, 4, 6, 12):
                expression = formula(N, n)
                value = float(expression.subs(symbol("theta"), theta))
                true, size = row_sum(N, n, theta, arms)
                off.append(float(abs(value - true)) / float(np.spacing(max(size, 1.0))))
                at.append(N)
        return worst_point(name, np.array(at), np.array(off), BOUND, ULP, None, "N = ")

    return attempt(name, BOUND, ULP, make)


def row_sum(N: int, n: int, theta: Fraction, arms: bool) -> tuple[Number, float]:
    """Return the sum over the cylinders at a crank angle, and its amplitude."""
    with mp.workdps(50):
        angle, lag = n * mp.mpf(theta.numerator) / theta.denominator, 4 * mp.pi * n / N
        weights = [mp.mpf(N - 1) / 2 - j if arms else mp.mpf(1) for j in range(N)]
        sign = -1 if arms else 1
        terms = [w * mp.expj(sign * j * lag) for j, w in enumerate(weights)]
        total = mp.fsum(terms)
        return (total * mp.expj(angle)).real, float(abs(total))
