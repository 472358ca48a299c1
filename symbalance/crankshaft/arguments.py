"""Checks of constructors' arguments: a wrong kind is refused at once, not by an AttributeError later."""

from __future__ import annotations

from collections.abc import Iterable
from math import isfinite
from numbers import Real

from symbalance.errors import SymbalanceError, shown, written


def check_kind(value: object, kind: type, name: str, remedy: str) -> None:
    """Refuse a value that is not of a class.

    >>> check_kind("steel", int, "material", "write a number")
    Traceback (most recent call last):
    symbalance.errors.SymbalanceError: material of type str: must be of type int; write a number
    """
    if not isinstance(value, kind):
        what = f"{name} of type {type(value).__name__}"
        raise SymbalanceError(what, f"must be of type {kind.__name__}", remedy)


def check_function(value: object, name: str, remedy: str) -> None:
    """Refuse a value that cannot be called."""
    if not callable(value):
        raise SymbalanceError(f"{name} of type {type(value).__name__}", "must be a function", remedy)


def check_number(value: object, name: str, unit: str, *, signed: bool = False) -> None:
    """Refuse what is no finite number, and without `signed` a negative one.

    >>> check_number("0.02", "web width", "m")
    Traceback (most recent call last):
    symbalance.errors.SymbalanceError: web width = '0.02': must be a number; m
    """
    if isinstance(value, bool) or not isinstance(value, Real):
        raise SymbalanceError(f"{name} = {written(value)}", "must be a number", unit)
    if not isfinite(value):
        raise SymbalanceError(f"{name} = {shown(value)}", "must be finite", unit)
    if value < 0 and not signed:
        raise SymbalanceError(f"{name} = {shown(value)}", "must be finite, not negative", unit)


def check_fields(owner: object, name: str, units: Iterable[tuple[str, str]]) -> None:
    """Refuse an owner, called `name`, whose fields (field, unit) are no finite numbers, or negative."""
    for field, unit in units:
        check_number(getattr(owner, field), f"{name} {field}", unit)
