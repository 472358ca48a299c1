"""Checks of arguments for slider-crank functions: orders, powers, rod ratios, quantities."""

from __future__ import annotations

from fractions import Fraction

from symbalance.errors import SymbalanceError, brief
from symbalance.text.numbers import LARGEST_QUOTIENT, checked_whole, exact

HIGHEST_ORDER = 1000
"""`floats` keeps tables of this length; no engine has a use for more."""
HIGHEST_POWER = 10_000
QUANTITIES = ("displacement", "velocity", "acceleration", "force", "rod-angle")


def checked_order(order: int, name: str = "order", highest: int = HIGHEST_ORDER) -> int:
    """Return `order`, or refuse what is no whole number from 1 to `highest`."""
    return checked_whole(order, name, 1, highest, "12 shows what matters in most engines")


def checked_ratio(ratio: object, name: str = "ratio") -> Fraction:
    """Return the rod ratio lambda = l/r as a fraction; the rod must be longer than the crank."""
    number = exact(ratio, name, LARGEST_QUOTIENT)
    if number <= 1:
        raise SymbalanceError(
            f"{name} = {brief(ratio)}",
            "the rod must be longer than the crank, lambda = l/r > 1",
            "engines have 3 to 4.5; r/l is the inverse",
        )
    return number


def checked_quantity(quantity: str) -> str:
    """Return the name of a quantity, or refuse an unknown one."""
    if quantity not in QUANTITIES:
        raise SymbalanceError(
            f"quantity = {brief(quantity)}",
            f"must be one of {', '.join(QUANTITIES)}",
            "force is the default",
        )
    return quantity


def checked_power(power: int, name: str = "power") -> int:
    """Return a highest power of 1/lambda, or refuse what is no whole number from 0 to `HIGHEST_POWER`."""
    return checked_whole(power, name, 0, HIGHEST_POWER, "leave it out for the usual powers")


def surviving(order: int) -> bool:
    """Tell whether a centred slider-crank has that order at all: 1 and the even ones."""
    return order == 1 or order % 2 == 0
