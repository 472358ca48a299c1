"""The closed form of a real cyclotomic number: radicals, else cosines."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache

from symbalance.exact.phasor import Phasor
from symbalance.exact.radicals.characters import radical_form
from symbalance.exact.radicals.closed_forms import ClosedForm, denested_root
from symbalance.exact.radicals.cosines import trigonometric_form

MOST_RADICALS = 4
"""A sum of more radicals is written with cosines where these are fewer."""


def exact_form(number: Phasor) -> ClosedForm:
    """Return the closed form of a real cyclotomic number.

    >>> exact_form(Phasor.of(5, {1: 2, 4: 2})).spelling
    '-1 + sqrt(5)'
    >>> exact_form(Phasor.of(7, {1: 1, 6: 1})).spelling
    '2*cos(2*pi/7)'
    """
    return _cached_form(number.modulus, tuple(sorted(number.terms.items())))


@lru_cache(maxsize=4096)
def _cached_form(modulus: int, terms: tuple[tuple[int, int | Fraction], ...]) -> ClosedForm:
    number = Phasor(modulus, dict(terms))
    form = radical_form(number.primitive())
    if form is None:
        return trigonometric_form(number)
    if len(form.terms) <= MOST_RADICALS:
        return form
    return min(form, trigonometric_form(number), key=lambda f: len(f.terms))


def square_root_form(square: Phasor) -> ClosedForm:
    """Return the positive root of a positive real cyclotomic number.

    >>> square_root_form(Phasor.of(1, {0: 10})).spelling
    'sqrt(10)'
    >>> square_root_form(Phasor.of(12, {0: 2, 1: 1, 11: 1})).spelling  # of 2 + sqrt(3)
    'sqrt(2)/2 + sqrt(6)/2'
    """
    return denested_root(exact_form(square))
