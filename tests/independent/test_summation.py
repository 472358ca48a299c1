"""Closed forms for N cylinders against the sums they stand for, term by term in mpmath."""

from itertools import product

import pytest
import sympy
from mpmath import mp

from symbalance.document.symbols import symbol
from symbalance.forces.inline_sums import condition, dirichlet_quotient, inline_couple, inline_sum

ANGLES = (0.3, 1.7, -2.2)
COUNTS = range(2, 14)
ORDERS = (1, 2, 3, 4, 6, 7, 8, 12, 24)


def summed(count: int, order: int, strokes: int, weights, theta: float) -> mp.mpf:
    """Cylinder j fires j steps after the first: its own crank angle is theta - j h."""
    step = strokes * mp.pi / count
    return mp.fsum(w * mp.cos(order * (theta - j * step)) for j, w in enumerate(weights))


def value(expression: sympy.Expr, theta: float) -> mp.mpf:
    return mp.mpf(str(sympy.N(expression.subs(symbol("theta"), sympy.Float(theta, 25)), 20)))


@pytest.mark.slow
@pytest.mark.parametrize("strokes", [2, 4])
@pytest.mark.parametrize("count", COUNTS)
def test_force_and_couple_of_evenly_firing_cylinders(count, strokes):
    arms = [mp.mpf(count - 1) / 2 - j for j in range(count)]
    for order in ORDERS:
        for theta in ANGLES:
            force = summed(count, order, strokes, [1] * count, theta)
            couple = summed(count, order, strokes, arms, theta)
            assert abs(value(inline_sum(count, order, strokes), theta) - force) < 1e-12
            assert abs(value(inline_couple(count, order, strokes), theta) - couple) < 1e-11


@pytest.mark.spread(2)
@pytest.mark.parametrize("count", COUNTS)
def test_the_symbolic_count_holds_every_count(count):
    N = sympy.Symbol("N", integer=True, positive=True)
    for order in ORDERS:
        force = inline_sum(N, order).subs(N, count)
        couple = inline_couple(N, order).subs(N, count)
        for theta in ANGLES:
            assert abs(value(force - inline_sum(count, order), theta)) < 1e-12
            assert abs(value(couple - inline_couple(count, order), theta)) < 1e-11


def test_the_condition_of_the_table():
    """u = 2n/N of the first seed's table, N = 2..6 and n = 1, 2, 4, 6."""
    assert [condition(5, n) for n in (1, 2, 4, 6)] == [sympy.Rational(2 * n, 5) for n in (1, 2, 4, 6)]


@pytest.mark.parametrize("turns", ["1/14", "1/3", "1/2", "2", "1/5"])
def test_the_quotient_and_its_limit(turns):
    spacing = 2 * sympy.pi * sympy.Rational(turns)
    for count, order in product((2, 3, 6, 7), (1, 2, 3, 7, 14)):
        with mp.workdps(30):
            near = mp.mpf(str(sympy.N(spacing, 30))) + mp.mpf(10) ** -9
            quotient = mp.sin(count * order * near / 2) / mp.sin(order * near / 2)
            found = dirichlet_quotient(count, order, spacing)
            assert abs(mp.mpf(str(sympy.N(found, 20))) - quotient) < 1e-6
