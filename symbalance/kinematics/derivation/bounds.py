"""What a derivation leaves out, in figures.

The coefficients printed lack terms of their own sign only, so that the printed formula differs from
the exact quantity by at most

    sum over the harmonics printed of (|exact| - |printed|), and the harmonics left out.
"""

from __future__ import annotations

from decimal import ROUND_CEILING, Context, Decimal
from fractions import Fraction

from symbalance.document.formula import Formula, Name, Number, Over, Scientific, equal
from symbalance.kinematics.derivation.setting import LAM, RHO, L, Prose, R, Setting, prose
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
    "l/r": (equal(LAM, Number(4)),),
    "r/l": (equal(RHO, Over(Number(1), Number(4))),),
    "l/s": (equal(LAM, Number(2)), " (", equal(L / R, Number(4)), ")"),
}


def numbers(setting: Setting, found: Harmonics) -> tuple[Prose, ...]:
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
            *first.pieces,
            " With the coefficients as they are printed the error is at most ",
            printed,
            ".",
        ),
    )


def _with_unit(setting: Setting, value: Real) -> Formula:
    number = rounded_up(value)
    return number * Name("rad") if setting.rod_angle else number * setting.unit()


def rounded_up(value: Real) -> Scientific:
    """Return a bound to three digits, rounded up so that it stays one.

    >>> rounded_up(Real("1.52541e-6"))
    Scientific(mantissa='1.53', exponent=-6)
    """
    number = Context(prec=3, rounding=ROUND_CEILING).create_decimal(Decimal(nstr(value, 15)))
    exponent = number.adjusted()
    if exponent >= -2:
        return Scientific(str(number), 0)
    return Scientific(str(number.scaleb(-exponent).quantize(Decimal("0.01"))), exponent)


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
