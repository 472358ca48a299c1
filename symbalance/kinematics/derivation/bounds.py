"""What a derivation leaves out, in figures.

The coefficients printed lack terms of their own sign only, so that the printed formula differs from
the exact quantity by at most

    sum over the harmonics printed of (|exact| - |printed|), and the harmonics left out.
"""

from __future__ import annotations

import decimal
from fractions import Fraction

from symbalance.document.formula import Decimal, Formula, Quotient, Upright, equal, number
from symbalance.document.nodes import Paragraph, inlines
from symbalance.kinematics.derivation.setting import LAM, RHO, L, R, Setting, prose
from symbalance.kinematics.slider_crank import (
    Harmonics,
    acceleration_value,
    integrated,
    rod_angle_value,
    root_mean,
)
from symbalance.kinematics.truncation import left_out
from symbalance.text.reals import Real, nstr

RATIO = Fraction(4)
"""The rod ratio l/r at which bounds are given as numbers."""
_AT_RATIO = {
    "l/r": (equal(LAM, number(4)),),
    "r/l": (equal(RHO, Quotient(number(1), number(4))),),
    "l/s": (equal(LAM, number(2)), " (", equal(L / R, number(4)), ")"),
}


def numbers(setting: Setting, found: Harmonics) -> tuple[Paragraph, ...]:
    """Return what is left out at l/r = 4, in figures."""
    bound = _with_unit(setting, left_out(setting.order, RATIO, setting.quantity))
    at = _AT_RATIO[setting.convention]
    first = prose(
        "At ", *at, f" the harmonics above order {setting.order} amount to at most ", bound,
        ", with every coefficient kept exact.",
    )  # fmt: skip
    if setting.long:
        return (first,)
    printed = _with_unit(setting, printed_error(setting.order, found))
    if printed == bound:  # no coefficient is truncated
        return (first,)
    return (
        prose(
            *inlines(first.words),
            " With the coefficients as they are printed the error is at most ",
            printed,
            ".",
        ),
    )


def _with_unit(setting: Setting, value: Real) -> Formula:
    return rounded_up(value) * (Upright("rad") if setting.rod_angle else setting.unit())


def rounded_up(value: Real) -> Decimal:
    """Return a bound to three digits, rounded up so that it stays one.

    >>> rounded_up(Real("1.52541e-6")).text, rounded_up(Real("0.0123456")).text
    ('1.53e-6', '0.0124')
    """
    context = decimal.Context(prec=3, rounding=decimal.ROUND_CEILING)
    bound = context.create_decimal(decimal.Decimal(nstr(value, 15)))
    exponent = bound.adjusted()
    if exponent >= -2:
        return Decimal(str(bound))
    mantissa = bound.scaleb(-exponent).quantize(decimal.Decimal("0.01"))
    return Decimal(f"{mantissa}e{exponent}")


def printed_error(order: int, found: Harmonics, ratio: Fraction = RATIO) -> Real:
    """Return a bound on |exact - the truncated series in `found`| over all crank angles.

    >>> from symbalance.text.reals import nstr
    >>> from symbalance.kinematics.slider_crank import harmonics
    >>> nstr(printed_error(2, harmonics("force", 2)), 3)
    '0.0082'
    """
    total = left_out(order, ratio, found.quantity)
    for n, series in found.terms.items():
        total += _size(found.quantity, n, ratio) - abs(series.at(ratio))
    if found.quantity == "displacement":
        total += 1 + (1 - root_mean(ratio)) * ratio - found.constant.at(ratio)
    return total


def _size(quantity: str, n: int, ratio: Fraction) -> Real:
    if quantity == "rod-angle":
        return abs(rod_angle_value(n, ratio))
    return abs(acceleration_value(n, ratio)) * abs(integrated(quantity, n))
