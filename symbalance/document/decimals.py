"""Decimals as tables print them."""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import Decimal
from symbalance.text.numbers import decimal_text
from symbalance.text.reals import Real

SHOWN_DIGITS = 6


def shown(value: Real, digits: int = SHOWN_DIGITS) -> str:
    """Return a decimal as tables print it.

    >>> shown(Real("7.43790327e-5")), shown(Real(3))
    ('7.4379e-5', '3')
    """
    text = decimal_text(value, digits)
    mantissa, *exponent = text.split("e")
    mantissa = mantissa.rstrip("0").rstrip(".") if "." in mantissa else mantissa
    return "e".join([mantissa, *exponent])


def rounded(value: float | Fraction | Real, digits: int = SHOWN_DIGITS) -> Decimal:
    """Return a number as a formula, rounded as tables print it.

    >>> rounded(-2 / 3)
    Decimal(span=(0, 0), text='-0.666667')
    """
    return Decimal(shown(Real(value), digits))
