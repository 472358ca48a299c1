"""Decimals as tables print them."""

from __future__ import annotations

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


def figure(value: float, digits: int = SHOWN_DIGITS) -> Decimal:
    """Return a float as tables print it.

    >>> figure(-0.0000012345678), figure(0.0)
    (Decimal(span=(0, 0), text='-1.23457e-6'), Decimal(span=(0, 0), text='0'))
    """
    mantissa, *exponent = f"{value:.{digits}g}".split("e")
    return Decimal("e".join([mantissa, *(str(int(power)) for power in exponent)]))
