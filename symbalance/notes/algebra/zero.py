"""Exact test whether a polynomial is zero, by independent generators and cyclotomic coefficients.

What stands before each product of letters and exponentials is a number made of rationals, turns
e^(2 pi i x) and square roots of primes. A root of a prime p is a sum of p-th (or 4p-th) roots of unity
(Gauss 1811): sum over a of (a/p) e^(2 pi i a/p) is √p for p = 1 mod 4 and i√p for p = 3 mod 4, and
√2 = e^(pi i/4) + e^(-pi i/4). So the number is a `Phasor`, whose normal form decides.
"""

from __future__ import annotations

from cmath import rect
from collections import defaultdict
from fractions import Fraction
from functools import cache
from math import isfinite, prod, tau

from symbalance.errors import SymbalanceError
from symbalance.exact.phasor import Phasor
from symbalance.notes.algebra.domain import TURN, Domain, Monomial, Polynomial

LARGEST_PRIME = 200
LARGEST_PRODUCT = 5000
"""√p √q ... is a sum of about p q ... roots of unity."""


def is_zero(domain: Domain, polynomial: Polynomial) -> bool | None:
    """Return True (proved zero), False (proved not zero as a polynomial) or None (not decided).

    False is a statement on the polynomial: opaque functions may still obey a relation not known here.
    """
    if not polynomial:
        return True
    if all(not monomial or monomial[0][0] != TURN for monomial in polynomial):
        return False  # nothing but terms that are independent, as `_number_is_zero` has it of each group
    groups: dict[Monomial, list[tuple[Monomial, Fraction]]] = defaultdict(list)
    for monomial, coefficient in polynomial.items():
        number, rest = _split(domain, monomial)
        groups[rest].append((number, coefficient))
    answers = [_number_is_zero(domain, terms) for terms in groups.values()]
    if all(answer is True for answer in answers):
        return True
    return False if any(answer is False for answer in answers) else None


def with_numbers_worked_out(domain: Domain, polynomial: Polynomial) -> Polynomial:
    """Return a polynomial with the numbers in it that are rational as rationals: 1 - λ² sin² 60°.

    Its sin² 60° is a sum of turns, e^(2 pi i/3) and e^(-2 pi i/3) among them, and comes to 3/4.
    """
    if all(not monomial or monomial[0][0] != TURN for monomial in polynomial):
        return polynomial
    groups: dict[Monomial, list[tuple[Monomial, Fraction]]] = defaultdict(list)
    for monomial, coefficient in polynomial.items():
        number, rest = _split(domain, monomial)
        groups[rest].append((number, coefficient))
    result: Polynomial = {}
    for rest, terms in groups.items():
        value = _rational(domain, terms)
        if value is None:
            result |= {tuple(sorted((*number, *rest))): c for number, c in terms}
        elif value:
            result[rest] = value
    return result


def _rational(domain: Domain, terms: list[tuple[Monomial, Fraction]]) -> Fraction | None:
    """Return what a sum of turns and roots of primes comes to where it is a rational, else None."""
    try:
        total = sum((_phasor(domain, monomial).scaled(c) for monomial, c in terms), Phasor(1, {}))
        normal = total.normal
    except (SymbalanceError, _NotCyclotomicError):
        return None
    return Fraction(normal.get(0, 0)) if normal.keys() <= {0} else None


def _split(domain: Domain, monomial: Monomial) -> tuple[Monomial, Monomial]:
    """Return the part of a monomial that is a number, and the rest."""
    number = tuple((g, e) for g, e in monomial if g == TURN or domain.generators[g].kind == "prime")
    return (number, monomial) if not number else (number, tuple(p for p in monomial if p not in number))


def _number_is_zero(domain: Domain, terms: list[tuple[Monomial, Fraction]]) -> bool | None:
    if all(not monomial or monomial[0][0] != TURN for monomial, _ in terms):
        return False  # roots of different numbers are independent (Besicovitch 1940)
    if _is_clearly_not_zero(domain, terms):
        return False
    try:
        total = sum((_phasor(domain, monomial).scaled(c) for monomial, c in terms), Phasor(1, {}))
        return total.is_zero()
    except (SymbalanceError, _NotCyclotomicError):
        return None


def _is_clearly_not_zero(domain: Domain, terms: list[tuple[Monomial, Fraction]]) -> bool:
    """Tell whether the sum is far beyond what rounding in floats explains."""
    try:
        parts = [float(coefficient) * _float(domain, monomial) for monomial, coefficient in terms]
    except OverflowError:
        return False
    size = sum(abs(part) for part in parts)
    # Floats carry 16 digits and sums here have at most thousands of terms: 1e-9 is no rounding.
    return isfinite(size) and abs(sum(parts)) > 1e-9 * size


def _float(domain: Domain, monomial: Monomial) -> complex:
    value = complex(1)
    for generator, exponent in monomial:
        if generator == TURN:
            value *= rect(1.0, tau * float(exponent))
        else:
            value *= domain.generators[generator].content ** float(exponent)
    return value


class _NotCyclotomicError(Exception):
    """A cube root, or the root of a large prime."""


def _phasor(domain: Domain, monomial: Monomial) -> Phasor:
    total = Phasor(1, {0: 1})
    if prod(domain.generators[g].content for g, _ in monomial if g != TURN) > LARGEST_PRODUCT:
        raise _NotCyclotomicError
    for generator, exponent in monomial:
        if generator == TURN:
            total = total.rotated(Fraction(exponent))
        else:
            prime = domain.generators[generator].content
            if exponent != Fraction(1, 2) or prime > LARGEST_PRIME:
                raise _NotCyclotomicError
            total = total.times(root_of_prime(prime))
    return total


@cache
def root_of_prime(prime: int) -> Phasor:
    """Return √prime as a sum of roots of unity.

    >>> root_of_prime(3).times(root_of_prime(3)) == Phasor(1, {0: 3})
    True
    """
    if prime == 2:
        return Phasor.of(8, {1: 1, 7: 1})
    squares = {k * k % prime for k in range(1, prime)}
    gauss = Phasor.of(prime, {k: 1 if k in squares else -1 for k in range(1, prime)})
    return gauss if prime % 4 == 1 else gauss.rotated(Fraction(-1, 4))
