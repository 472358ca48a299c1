"""Real cyclotomic numbers as short sums of cosines or sines, by vanishing sums of roots of unity."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from itertools import product
from math import lcm

from symbalance.exact.phasor import Phasor, prime_factors
from symbalance.exact.radicals.closed_forms import ClosedForm, wave

MOST_TO_SHORTEN = 100
"""A sum of more cosines is printed as it stands."""


def trigonometric_form(number: Phasor) -> ClosedForm:
    """Return a real number as a short rational combination of cosines, or of sines.

    Those that are short in radicals stand so.

    >>> trigonometric_form(Phasor.of(28, {1: 1, 27: 1, 3: 1, 25: 1})).spelling
    '2*sin(2*pi/7) + 2*sin(3*pi/7)'
    """
    rotated = number.rotated(Fraction(1, 4))
    cosines, sines = _shortest(number, 1), _shortest(rotated, -1)
    as_sines = _length(sines, rotated.modulus) < _length(cosines, number.modulus)
    terms, modulus = (sines, rotated.modulus) if as_sines else (cosines, number.modulus)
    function = "sin" if as_sines else "cos"
    waves = (wave(function, Fraction(2 * k, modulus)).scaled(c) for k, c in terms.items())
    return ClosedForm.of(term for form in waves for term in form.terms.items())


def _length(terms: dict[int, Fraction], modulus: int) -> tuple[int, int]:
    """Return what is compared between cosines and sines: how many, and how fine their angles."""
    return len(terms), sum(Fraction(2 * k, modulus).denominator for k in terms)


def _shortest(number: Phasor, parity: int) -> dict[int, Fraction]:
    """Return a number as few cosines (parity 1) or sines (-1) of 2 pi k/m, 0 <= k <= m/2.

    Sums over the p powers a p-th of a turn apart vanish; such a sum is taken away, so often as one of
    the coefficients says, wherever that leaves fewer terms or smaller ones.
    """
    common = 2 * lcm(*(c.denominator for c in number.terms.values()))
    whole = ((k, int(c * common)) for k, c in number.terms.items())
    terms = _fold(whole, number.modulus, parity)
    if len(terms) <= MOST_TO_SHORTEN:
        while _shorten(terms, number.modulus, parity):
            pass
    return {k: Fraction(c, common) for k, c in sorted(terms.items())}


def _shorten(terms: dict[int, int], modulus: int, parity: int) -> bool:
    """Take vanishing sums away from `terms` where that helps; tell whether any did."""
    helped, visited = False, set()
    for exponent, prime in product(list(terms), prime_factors(modulus)):
        step = modulus // prime
        if exponent not in terms or (prime, exponent % step) in visited:
            continue
        visited.add((prime, exponent % step))
        places = range(exponent % step, modulus, step)
        relation = _fold(((k, 1) for k in places), modulus, parity)
        # A sum with fewer than half its terms here would bring more terms than it takes.
        if 2 * len(terms.keys() & relation.keys()) >= len(relation):
            helped = _subtract(terms, relation) or helped
    return helped


def _subtract(terms: dict[int, int], relation: dict[int, int]) -> bool:
    """Subtract from `terms` the multiple of a vanishing sum that helps most; tell whether one does."""
    before = {k: terms.get(k, 0) for k in relation}
    multiples = {terms[k] // c for k, c in relation.items() if k in terms and terms[k] % c == 0}
    choices = [{k: v - t * relation[k] for k, v in before.items()} for t in multiples]
    best = min(choices, key=_cost, default=before)
    if _cost(best) >= _cost(before):
        return False
    for k, coefficient in best.items():
        terms.pop(k, None)
        if coefficient:
            terms[k] = coefficient
    return True


def _cost(terms: dict[int, int]) -> tuple[int, int, int]:
    values = [c for c in terms.values() if c]
    return len(values), sum(map(abs, values)), sum(c < 0 for c in values)


def _fold(terms: Iterable[tuple[int, int]], modulus: int, parity: int) -> dict[int, int]:
    """Return the terms with m - k folded onto k, as cos does (parity 1) or sin (-1)."""
    total: dict[int, int] = {}
    for exponent, coefficient in terms:
        k, sign = (exponent, 1) if 2 * exponent <= modulus else (modulus - exponent, parity)
        total[k] = total.get(k, 0) + sign * coefficient
    return {k: c for k, c in total.items() if c and not (parity < 0 and 2 * k % modulus == 0)}
