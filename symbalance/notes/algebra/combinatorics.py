"""Factorials, binomial coefficients and Kronecker's delta of normal forms.

A factorial of letters keeps a base without a whole number beside it: (n + 2)! is (n + 1)(n + 2) n!, so
that quotients and sums of factorials cancel as by hand.
"""

from __future__ import annotations

from fractions import Fraction
from math import comb, factorial

from symbalance.notes.algebra.domain import ONE, NoFormError, TooLargeError
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.functions import opaque

LARGEST_FACTORIAL = 1000
"""Of a number: its factorial is multiplied out, to 2568 digits."""
MOST_FACTORS = 60
"""Between two factorials, and in a binomial coefficient whose upper number is a letter."""


def factorial_of(form: Form) -> Form:
    """Return n!: a number multiplied out, of letters as a multiple of the factorial of their part.

    >>> from symbalance.notes.algebra.domain import Domain
    >>> factorial_of(Form.number(Domain(), 5)).rational()
    Fraction(120, 1)
    """
    domain, value = form.domain, form.rational()
    if value is not None:
        return Form.number(domain, factorial(_whole(value, "factorial")))
    if not form.is_polynomial:
        raise NoFormError("the factorial of a quotient")
    constant = form.numerator.get(ONE, Fraction(0))
    if constant.denominator != 1 or abs(constant) > MOST_FACTORS:
        return opaque("factorial", form)
    base = Form.of(domain, {m: c for m, c in form.numerator.items() if m != ONE})
    result = opaque("factorial", base)
    for step in range(1, int(constant) + 1):
        result = result.times(base.plus(Form.number(domain, step)))
    for step in range(int(constant) + 1, 1):
        result = result.over(base.plus(Form.number(domain, step)))
    return result


def _whole(value: Fraction, what: str) -> int:
    if value.denominator != 1 or value < 0:
        raise NoFormError(f"the {what} of a number that is not 0, 1, 2, ...")
    if value > LARGEST_FACTORIAL:
        raise TooLargeError(f"the {what} of {value}")
    return int(value)


def binomial_of(upper: Form, lower: Form) -> Form:
    """Return the binomial coefficient: in numbers, with a number below, or by factorials."""
    domain = upper.domain
    n, k = upper.rational(), lower.rational()
    if n is not None and k is not None and n.denominator == 1 and n >= 0:
        return Form.number(domain, comb(_whole(n, "binomial"), _whole(k, "binomial")) if k >= 0 else 0)
    if k is not None:
        count = _whole(k, "binomial")
        if count > MOST_FACTORS:
            raise TooLargeError("a binomial coefficient of very many factors")
        result = Form.number(domain, 1)
        for step in range(count):
            result = result.times(upper.minus(Form.number(domain, step))).scaled(Fraction(1, step + 1))
        return result
    below = factorial_of(lower).times(factorial_of(upper.minus(lower)))
    return factorial_of(upper).over(below)


def kronecker_of(first: Form, second: Form) -> Form:
    """Return 1 where two indices are equal, 0 where they are not; of letters it has no form."""
    difference = first.minus(second)
    value = difference.rational()
    if value is None:
        raise NoFormError("Kronecker's delta of two letters, which may be equal")
    return Form.number(first.domain, 0 if value else 1)
