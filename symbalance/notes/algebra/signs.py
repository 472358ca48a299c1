"""Which polynomials are never negative, as far as the signs of their terms tell."""

from __future__ import annotations

from collections import defaultdict
from fractions import Fraction

from symbalance.notes.algebra.domain import Domain, Exponent, Monomial, Polynomial


def is_never_negative(domain: Domain, polynomial: Polynomial) -> bool:
    """Tell whether, before every product of letters, the constant outweighs all waves: 2 + 2 cos 2θ.

    >>> domain = Domain()
    >>> x = domain.symbol("x")
    >>> is_never_negative(domain, {((x, 2),): Fraction(1), (): Fraction(1)})
    True
    >>> is_never_negative(domain, {((x, 1),): Fraction(1), (): Fraction(1)})
    False
    """
    margins: dict[Monomial, Fraction] = defaultdict(Fraction)
    for monomial, coefficient in polynomial.items():
        waves = tuple((g, e) for g, e in monomial if domain.generators[g].kind == "exponential")
        letters = tuple(pair for pair in monomial if pair not in waves)
        if not all(_is_positive(domain, g, e) for g, e in letters):
            return False
        margins[letters] += -abs(coefficient) if waves else coefficient
    return all(margin >= 0 for margin in margins.values())


def _is_positive(domain: Domain, number: int, exponent: Exponent) -> bool:
    generator = domain.generators[number]
    if generator.kind == "symbol" and not generator.positive:
        return exponent % 2 == 0
    return generator.kind in ("symbol", "prime", "growth", "radical")
