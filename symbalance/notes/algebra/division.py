"""Exact division of Laurent polynomials, to find the common denominator of two forms."""

from __future__ import annotations

from collections import defaultdict
from fractions import Fraction

from symbalance.notes.algebra.domain import Domain, Exponent, Monomial, Polynomial, plain
from symbalance.notes.algebra.polynomials import UNIT, times, worked

Exponents = tuple[Exponent, ...]
"""The exponents of one monomial, for a fixed row of generators."""


def quotient(domain: Domain, dividend: Polynomial, divisor: Polynomial) -> Polynomial | None:
    """Return dividend/divisor where it is a polynomial, else None; no divisor of turns or roots is tried.

    Before each product of turns and roots the dividend must be divisible for itself.

    >>> x, one = ((1, 1),), Fraction(1)
    >>> quotient(Domain(), {((1, 2),): one, (): -one}, {x: one, (): -one})
    {((1, 1),): Fraction(1, 1), (): Fraction(1, 1)}
    """
    if not divisor or any(not domain.is_free(g) for m in divisor for g, _ in m):
        return None
    groups: dict[Monomial, Polynomial] = defaultdict(dict)
    for monomial, coefficient in dividend.items():
        bound = tuple((g, e) for g, e in monomial if not domain.is_free(g))
        free = tuple((g, e) for g, e in monomial if domain.is_free(g)) if bound else monomial
        groups[bound][free] = coefficient
    found: Polynomial = {}
    for bound, group in groups.items():
        part = _free_quotient(domain, group, divisor)
        if part is None:
            return None
        found |= {tuple(sorted((*bound, *m))): c for m, c in part.items()}
    return found


def _free_quotient(domain: Domain, dividend: Polynomial, divisor: Polynomial) -> Polynomial | None:
    """Divide leading term by leading term, in the lexicographic order of exponents.

    Every exponent of the quotient lies between the differences of the lowest and of the highest ones: a
    term outside ends the search.
    """
    numbers = sorted({g for p in (dividend, divisor) for m in p for g, _ in m})
    rest, by = _rows(dividend, numbers), _rows(divisor, numbers)
    pairs = zip(_box(rest), _box(by), strict=True)
    box = [(low - low_, high - high_) for (low, high), (low_, high_) in pairs]
    if any(low > high for low, high in box):
        return None
    lead, found = max(by), dict[Exponents, Fraction]()
    while rest:
        first = max(rest)
        step = tuple(a - b for a, b in zip(first, lead, strict=True))
        if any(not low <= e <= high for e, (low, high) in zip(step, box, strict=True)):
            return None
        found[step] = rest[first] / by[lead]
        worked(domain, len(by))
        rest = _without(rest, by, step, found[step])
    return {_monomial(numbers, row): c for row, c in found.items()}


def _rows(polynomial: Polynomial, numbers: list[int]) -> dict[Exponents, Fraction]:
    powers = [(dict(monomial), coefficient) for monomial, coefficient in polynomial.items()]
    return {tuple(own.get(g, 0) for g in numbers): coefficient for own, coefficient in powers}


def _box(rows: dict[Exponents, Fraction]) -> list[tuple[Exponent, Exponent]]:
    return [(min(column), max(column)) for column in zip(*rows, strict=True)]


def _without(
    rest: dict[Exponents, Fraction], by: dict[Exponents, Fraction], step: Exponents, factor: Fraction
) -> dict[Exponents, Fraction]:
    """Return rest - factor step by."""
    left = dict(rest)
    for row, coefficient in by.items():
        place = tuple(a + b for a, b in zip(row, step, strict=True))
        left[place] = left.get(place, Fraction(0)) - factor * coefficient
        if not left[place]:
            del left[place]
    return left


def _monomial(numbers: list[int], row: Exponents) -> Monomial:
    return tuple((g, plain(e)) for g, e in zip(numbers, row, strict=True) if e)


def common(
    domain: Domain, left: Polynomial, right: Polynomial
) -> tuple[Polynomial, Polynomial, Polynomial]:
    """Return (a, b, c) with c = a left = b right: one of the two where the other divides it."""
    swapped = len(left) < len(right)
    large, small = (right, left) if swapped else (left, right)
    factor = quotient(domain, large, small)
    if factor is None:
        return right, left, times(domain, left, right)
    return (factor, UNIT, large) if swapped else (UNIT, factor, large)
