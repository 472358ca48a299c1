"""Numbers as short decimals for the cells of tables."""

from __future__ import annotations

from fractions import Fraction
from math import isinf, isnan

from symbalance.document.formula import INFINITY, Decimal, Formula
from symbalance.document.nodes import UNKNOWN
from symbalance.text.numbers import decimal_text
from symbalance.text.reals import Real

SHOWN_DIGITS = 6
LEAST_PLAIN, MOST_PLAIN = -3, 7
"""Powers of ten from which on, and below which, a float is written without one."""


def short_decimal(value: Real, digits: int = SHOWN_DIGITS) -> str:
    """Return a decimal as tables print it.

    >>> short_decimal(Real("7.43790327e-5")), short_decimal(Real(3))
    ('7.4379e-5', '3')
    """
    text = decimal_text(value, digits)
    mantissa, *exponent = text.split("e")
    mantissa = mantissa.rstrip("0").rstrip(".") if "." in mantissa else mantissa
    return "e".join([mantissa, *exponent])


def decimal(value: float | Fraction | Real, digits: int = SHOWN_DIGITS) -> Formula | str:
    """Return a number as a cell, to so many significant digits; `UNKNOWN` for NaN.

    >>> [decimal(x, 4) for x in (1234.56, 0.5, -2.5e-7, float("nan"))]  # doctest: +ELLIPSIS
    [Decimal(..., text='1235'), Decimal(..., text='0.5'), Decimal(..., text='-2.5e-7'), '–']
    """
    if isinstance(value, Fraction | Real):
        return Decimal(short_decimal(Real(value), digits))
    if isnan(value) or isinf(value):
        return _not_finite(value)
    mantissa, exponent = f"{value:.{digits - 1}e}".split("e")
    if LEAST_PLAIN <= int(exponent) < MOST_PLAIN:
        return Decimal(_bare(f"{float(f'{mantissa}e{exponent}'):.{max(0, digits - 1 - int(exponent))}f}"))
    return Decimal(f"{_bare(mantissa)}e{int(exponent)}")


def fixed_cell(value: float, places: int) -> Formula | str:
    """Return a float as a cell, to so many places after the point; `UNKNOWN` for NaN.

    >>> fixed_cell(2.0, 1), fixed_cell(float("nan"), 1)
    (Decimal(span=(0, 0), text='2.0'), '–')
    """
    if isnan(value) or isinf(value):
        return _not_finite(value)
    text = f"{value:.{places}f}"
    return Decimal(text if float(text) else text.lstrip("-"))


def _not_finite(value: float) -> Formula | str:
    if isnan(value):
        return UNKNOWN
    return INFINITY if value > 0 else -INFINITY


def _bare(text: str) -> str:
    """Return a decimal without zeros at its end, and zero without a sign."""
    bare = text.rstrip("0").rstrip(".") if "." in text else text
    return bare if float(bare) else "0"
