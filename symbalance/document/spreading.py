"""Long numbers rewritten so that they can be broken over lines: no bar or root over a whole sum."""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import (
    Call,
    Formula,
    Negative,
    Number,
    Product,
    Quotient,
    Sum,
    monomial,
    number,
)


def expand_radicals(value: Formula) -> tuple[int, Formula]:
    """Return (power, formula) such that value^power is the formula, a sum without a bar or root over it.

    The power is 2 for a root, whose sign the square does not tell, else 1. What is neither stays.

    >>> from symbalance.document.formula import Name, sqrt
    >>> from symbalance.document.text_writer import formula_text
    >>> a, b = Name("a"), Name("b")
    >>> formula_text(expand_radicals((a - 3 * b) / 2)[1])
    'a/2 − 3b/2'
    >>> power, square = expand_radicals(sqrt((a + b) / 2) / 3)
    >>> power, formula_text(square)
    (2, 'a/18 + b/18')
    """
    factor, rest = _factor(value)
    if isinstance(rest, Call) and rest.function == "sqrt":
        inner, below = _factor(rest.argument)
        return 2, _scaled(below, factor**2 * inner)
    return 1, _scaled(rest, factor) if isinstance(rest, Sum) else value


def _factor(value: Formula) -> tuple[Fraction, Formula]:
    """Return a rational factor of a formula, and what is left."""
    if isinstance(value, Negative):
        factor, rest = _factor(value.operand)
        return -factor, rest
    if isinstance(value, Quotient) and isinstance(value.denominator, Number):
        factor, rest = _factor(value.numerator)
        return factor / value.denominator.value, rest
    if isinstance(value, Product) and isinstance(value.factors[0], Number):
        factors = value.factors[1:]
        return value.factors[0].value, factors[0] if len(factors) == 1 else Product(factors)
    return Fraction(1), value


def _scaled(value: Formula, factor: Fraction) -> Formula:
    """Return factor times a sum, term by term."""
    terms = value.terms if isinstance(value, Sum) else (value,)
    return Sum(tuple(_term(term, factor) for term in terms))


def _term(term: Formula, factor: Fraction) -> Formula:
    coefficient, rest = _factor(term)
    whole = coefficient * factor
    if isinstance(rest, Number):
        whole, rest = whole * rest.value, number(1)
    size = monomial(abs(whole), rest, 0 if rest == number(1) else 1)
    return size if whole > 0 else Negative(size)
