"""SymPy's and FLINT's fastest exact routes to slider-crank harmonics and to sums of roots of unity.

The harmonics are those of sqrt(1 - rho^2 sin^2 theta) in rho and z = e^(2 i theta): with
sin^2 theta = -(1 - z)^2/(4 z), the term of rho^(2m) is C(1/2, m) ((1 - z)^2/4)^m z^-m. Both libraries get
this form, which is the fastest we know for them (a series in two letters at once costs SymPy 50 times as
much at order 80), and deliver it: what symbalance delivers beyond that, the factors n^2 and the rows by
order, is not asked of them.

The sum over N evenly firing cylinders vanishes in order n where sum of zeta^(2 n j) is 0, zeta a
primitive N-th root of unity: in SymPy's cyclotomic field, as remainder modulo Phi_N with FLINT, and by
`equals(0)` on the sum of exponentials as one writes it.
"""

from __future__ import annotations

from functools import cache
from importlib import import_module
from importlib.util import find_spec
from typing import Any

import sympy
from sympy import QQ
from sympy.polys.ring_series import rs_mul, rs_nth_root
from sympy.polys.rings import ring


def has_flint() -> bool:
    """Tell whether python-flint is installed."""
    return find_spec("flint") is not None


def ring_harmonics(order: int) -> list[Any]:
    """Return the terms of rho^0, rho^2, ... as polynomials in z, by SymPy's `ring_series`."""
    half = order // 2
    series_ring, x = ring("x", QQ)
    root = rs_nth_root(series_ring(1) + x, 2, x, half + 1)
    polynomials, z = ring("z", QQ)
    square, power, terms = (1 - z) ** 2 / 4, polynomials(1), []
    for m in range(half + 1):
        terms.append(power * root.coeff(x**m if m else 1))
        power = rs_mul(power, square, z, 2 * half + 1)
    return terms


def ring_expressions(order: int) -> list[sympy.Expr]:
    """Return A_2, A_4, ... as SymPy expressions in lambda, from `ring_harmonics`.

    A_2k = 8 k^2 times the sum over m of t_m rho^(2m - 1), t_m the coefficient of z^(m + k) in the term of
    rho^(2m), which is that of z^(m - k) too.
    """
    terms, lam = ring_harmonics(order), sympy.Symbol("lambda", positive=True)
    z = terms[0].ring.gens[0]
    expressions = []
    for k in range(1, order // 2 + 1):
        parts = [
            sympy.Rational(*_fraction(terms[m].coeff(z ** (m + k)) * 8 * k * k)) * lam ** (1 - 2 * m)
            for m in range(k, order // 2 + 1)
        ]
        expressions.append(sympy.Add(*parts))
    return expressions


def _fraction(value: Any) -> tuple[int, int]:
    return int(value.numerator), int(value.denominator)


def flint_harmonics(order: int) -> list[tuple[Any, Any]]:
    """Return the same terms with FLINT: each an integer polynomial in z and the rational before it."""
    flint = import_module("flint")
    half, before = order // 2, flint.ctx.cap
    flint.ctx.cap = max(before, half + 1)  # the longest series FLINT computes
    try:
        root = (1 + flint.fmpq_series([0, 1], prec=half + 1)).sqrt()
    finally:
        flint.ctx.cap = before
    square, power, terms = flint.fmpz_poly([1, -2, 1]), flint.fmpz_poly([1]), []
    for m in range(half + 1):
        terms.append((power, root[m] / 4**m))
        power *= square
    return terms


@cache
def cyclotomic_field(count: int) -> Any:
    """Return SymPy's field of the N-th roots of unity, which is built untimed."""
    return QQ.cyclotomic_field(count)


def is_zero_in_field(count: int, order: int) -> bool:
    """Tell whether the sum vanishes in SymPy's cyclotomic field."""
    field = cyclotomic_field(count)
    roots = (field.unit ** (2 * order * j % count) for j in range(count))
    return sum(roots, field.zero) == field.zero


@cache
def _cyclotomic_polynomial(count: int) -> Any:
    return import_module("flint").fmpz_poly.cyclotomic(count)


def is_zero_by_flint(count: int, order: int) -> bool:
    """Tell whether the sum, as a polynomial in zeta, is divisible by Phi_N."""
    numbers = [0] * count
    for j in range(count):
        numbers[2 * order * j % count] += 1
    return not import_module("flint").fmpz_poly(numbers) % _cyclotomic_polynomial(count)


def is_zero_by_equals(count: int, order: int) -> bool:
    """Tell whether `equals(0)` calls the sum of exponentials zero, theta taken out of it."""
    turn = 4 * sympy.pi * sympy.I * order / sympy.Integer(count)
    return sympy.Add(*(sympy.exp(turn * j) for j in range(count))).equals(0) is True
