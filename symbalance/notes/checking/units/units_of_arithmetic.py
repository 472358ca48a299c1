"""The unit that an arithmetic makes of its numbers: 0.5 · 40 · 628² of kg, mm and 1/s makes kg mm/s².

A bare number may be one of several things: a quantity in the unit that stands at this number elsewhere, a
number that formulas have, or something open. Each choice of these is a reading of the arithmetic, and has
a dimension and a scale; a sum needs terms of one unit.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from math import isclose, prod

from symbalance.document.formula import (
    Call,
    Constant,
    Formula,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
)
from symbalance.notes.checking.units.dimensions import NONE, Dimension

MOST_READINGS = 600
"""Choices of units for the numbers of one arithmetic that are looked at."""
_ScaledUnit = tuple[Dimension, float]


@dataclass(frozen=True, slots=True)
class Unit:
    """What one of a number is worth, in kg, m and s.

    `is_open` tells that it may also convert, `is_shifted` that its decimal point stands elsewhere.
    """

    dimension: Dimension = NONE
    scale: float = 1.0
    is_open: bool = False
    is_shifted: bool = False


@dataclass(frozen=True, slots=True)
class UnitReading:
    """An arithmetic's dimension and scale, with what each number of it was taken for."""

    dimension: Dimension
    scale: float
    numbers: tuple[tuple[Fraction, Unit], ...]

    @property
    def open_numbers(self) -> list[Fraction]:
        """The numbers that may also convert a unit."""
        return [value for value, unit in self.numbers if unit.is_open]

    @property
    def is_shifted(self) -> bool:
        """Tell whether a number's decimal point stands elsewhere than at its unit."""
        return any(unit.is_shifted for _, unit in self.numbers)


def numbers_of(node: Formula) -> list[Number] | None:
    """Return the numbers of an arithmetic that may have units; None for other formulas.

    Exponents have none, nor what a function is taken of: cos 60°, √10.
    """
    parts: tuple[Formula, ...] | None = None
    match node:
        case Number():
            return [node]
        case Constant() | Call(function="sqrt", argument=Number()):
            parts = ()
        case Negative(operand=part) | Call(function="sqrt", argument=part):
            parts = (part,)
        case Call():
            parts = ()
        case Power(base=base, exponent=exponent) if _rational(exponent) is not None:
            parts = (base,)
        case Product(factors=several) | Sum(terms=several):
            parts = several
        case Quotient(numerator=above, denominator=below):
            parts = (above, below)
    rows = [None] if parts is None else [numbers_of(part) for part in parts]
    return None if None in rows else [number for row in rows for number in row or ()]


def unit_readings(node: Formula, options: list[tuple[Unit, ...]]) -> list[UnitReading] | None:
    """Return each reading of an arithmetic that adds up; None where they are too many.

    `options` are the units that each of its numbers may have, in the order of `numbers_of`.
    """
    numbers = numbers_of(node)
    if numbers is None or prod(len(units) for units in options) > MOST_READINGS:
        return None
    readings = []
    for units in product(*options):
        whole = _unit_of_formula(node, iter(units))
        if whole is not None:
            pairs = tuple((number.value, unit) for number, unit in zip(numbers, units, strict=True))
            readings.append(UnitReading(*whole, pairs))
    return readings


def _unit_of_formula(node: Formula, units: Iterator[Unit]) -> _ScaledUnit | None:
    """Return the dimension and the scale of a formula, its numbers' units taken in order."""
    scaled: _ScaledUnit | None = NONE, 1.0  # of constants and functions
    match node:
        case Number():
            unit = next(units)
            scaled = unit.dimension, unit.scale
        case Negative(operand=operand):
            scaled = _unit_of_formula(operand, units)
        case Power(base=base, exponent=exponent):
            scaled = _raised(_unit_of_formula(base, units), _rational(exponent))
        case Call(function="sqrt", argument=argument) if not isinstance(argument, Number):
            scaled = _raised(_unit_of_formula(argument, units), Fraction(1, 2))
        case Product(factors=parts):
            scaled = _times([_unit_of_formula(part, units) for part in parts])
        case Quotient(numerator=above, denominator=below):
            over, under = _unit_of_formula(above, units), _unit_of_formula(below, units)
            scaled = _times([over, _raised(under, Fraction(-1))])
        case Sum(terms=parts):
            scaled = _common([_unit_of_formula(part, units) for part in parts])
    return scaled


def _common(rows: list[_ScaledUnit | None]) -> _ScaledUnit | None:
    """Return the unit that the terms of a sum have together; None where they differ."""
    first = rows[0]
    for row in rows:
        is_same = first is not None and row is not None and row[0] == first[0]
        if not is_same or row is None or first is None or not isclose(row[1], first[1], rel_tol=1e-6):
            return None
    return first


def _times(rows: list[_ScaledUnit | None]) -> _ScaledUnit | None:
    dimension, scale = NONE, 1.0
    for row in rows:
        if row is None:
            return None
        dimension = tuple(a + b for a, b in zip(dimension, row[0], strict=True))
        scale *= row[1]
    return dimension, scale


def _raised(row: _ScaledUnit | None, exponent: Fraction | None) -> _ScaledUnit | None:
    if row is None or exponent is None:
        return None
    return tuple(exponent * part for part in row[0]), row[1] ** float(exponent)


def _rational(node: Formula) -> Fraction | None:
    """Return the number that an exponent is, 3/2 or -1."""
    match node:
        case Number(value=value):
            return value
        case Negative(operand=operand):
            value = _rational(operand)
            return None if value is None else -value
        case Quotient(numerator=Number(value=above), denominator=Number(value=below)) if below:
            return above / below
    return None
