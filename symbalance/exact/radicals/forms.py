"""The closed form of a real cyclotomic number as a SymPy expression: radicals, else cosines."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from symbalance.exact.phasor import Phasor
from symbalance.exact.radicals.characters import radical_form
from symbalance.exact.radicals.cosines import MOST_TO_SHORTEN, trigonometric_form, trigonometric_text
from symbalance.exact.radicals.roots import tidy_root

if TYPE_CHECKING:
    import sympy

MOST_RADICALS = 4
"""A sum of more radicals is written with cosines where these are fewer."""


def exact_form(number: Phasor) -> sympy.Expr:
    """Return a real cyclotomic number as a SymPy expression.

    >>> exact_form(Phasor.of(5, {1: 2, 4: 2}))
    -1 + sqrt(5)
    >>> exact_form(Phasor.of(7, {1: 1, 6: 1}))
    2*cos(2*pi/7)
    """
    return _cached_form(number.modulus, tuple(sorted(number.terms.items())))


def exact_text(number: Phasor) -> str:
    """Return a real cyclotomic number as text that SymPy reads: its exact form.

    >>> exact_text(Phasor.of(5, {1: 2, 4: 2}))
    '-1 + sqrt(5)'
    """
    if len(number.terms) > MOST_TO_SHORTEN and radical_form(number.primitive()) is None:
        text = trigonometric_text(number)
        if text is not None:
            return text
    return str(exact_form(number))


@lru_cache(maxsize=4096)
def _cached_form(modulus: int, terms: tuple[tuple[int, int | Fraction], ...]) -> sympy.Expr:
    number = Phasor(modulus, dict(terms))
    form = radical_form(number.primitive())
    if form is None:
        return trigonometric_form(number)
    if len(form.args) <= MOST_RADICALS or not form.is_Add:
        return form
    return min(form, trigonometric_form(number), key=lambda f: len(f.args))


def square_root_form(square: Phasor) -> sympy.Expr:
    """Return the positive root of a positive real cyclotomic number.

    Formulas:
        (sqrt(6)/2 + sqrt(2)/2)^2 = 2 + sqrt(3)

    >>> square_root_form(Phasor.of(1, {0: 10}))
    sqrt(10)
    >>> square_root_form(Phasor.of(12, {0: 2, 1: 1, 11: 1}))  # of 2 + sqrt(3)
    sqrt(2)/2 + sqrt(6)/2
    """
    import sympy

    form = exact_form(square)
    rational, root = form.as_coeff_Add()
    radicand: Any
    factor, radicand = root.as_coeff_Mul()
    if radicand.is_Pow and radicand.exp == sympy.Rational(1, 2) and radicand.base.is_Rational:
        return _denested(rational, factor, radicand.base)
    return tidy_root(form)


def _denested(rational: sympy.Expr, factor: sympy.Expr, base: sympy.Expr) -> sympy.Expr:
    """Return sqrt(a + b sqrt(d)) as sqrt(x) +- sqrt(y) where x and y are rational."""
    import sympy

    inner = sympy.sqrt(rational**2 - factor**2 * base)
    if not inner.is_Rational:
        return tidy_root(rational + factor * sympy.sqrt(base))
    large, small = (rational + inner) / 2, (rational - inner) / 2
    return sympy.sqrt(large) + (1 if factor > 0 else -1) * sympy.sqrt(small)
