"""Square roots with their square factors taken out."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import sympy


def tidy_root(form: sympy.Expr) -> sympy.Expr:
    """Return the root of a positive number with the square factors of its content before it.

    >>> import sympy
    >>> tidy_root(sympy.Rational(5, 4) - sympy.sqrt(5) / 2)
    sqrt(5 - 2*sqrt(5))/2
    """
    import sympy

    content, rest = form.primitive()
    outside, inside = sympy.S.One, sympy.S.One
    factors: Any = sympy.factorrat(content)
    for prime, power in factors.items():
        half = int(power / 2)  # towards zero, so that an odd power of a denominator stays inside
        outside *= sympy.Integer(prime) ** half
        inside *= sympy.Integer(prime) ** (power - 2 * half)
    return outside * sympy.sqrt(sympy.expand(inside * rest))
