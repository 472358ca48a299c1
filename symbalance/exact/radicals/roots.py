"""Square roots of exact numbers with their square factors taken out."""

from __future__ import annotations

from functools import lru_cache
from math import isqrt
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import sympy

LARGEST_PRIME = 1000
"""Square factors of larger primes are not looked for: numbers of many digits cannot be factored."""


@lru_cache(maxsize=1024)
def tidy_root(form: sympy.Expr) -> sympy.Expr:
    """Return the root of a positive number with the square factors of its content before it.

    >>> import sympy
    >>> tidy_root(sympy.Rational(5, 4) - sympy.sqrt(5) / 2)
    sqrt(5 - 2*sqrt(5))/2
    """
    import sympy

    content, rest = form.primitive()
    outside, inside = sympy.S.One, sympy.S.One
    factors: Any = sympy.factorrat(content, limit=LARGEST_PRIME)
    for divisor, times in factors.items():
        root = isqrt(int(divisor))  # what is left of large numbers may be a square still
        prime, power = (root, 2 * times) if root * root == divisor and root > 1 else (divisor, times)
        half = int(power / 2)  # towards zero, so that an odd power of a denominator stays inside
        outside *= sympy.Integer(prime) ** half
        inside *= sympy.Integer(prime) ** (power - 2 * half)
    return outside * sympy.sqrt(sympy.expand(inside * rest))
