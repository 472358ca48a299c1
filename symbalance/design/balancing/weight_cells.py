"""Table cells of a balance weight: its station and its size."""

from __future__ import annotations

from fractions import Fraction

import sympy

from symbalance.document.expressions import formula_of
from symbalance.document.formula import Decimal, Formula
from symbalance.document.nodes import Cell, Exact
from symbalance.engine.balance_mass_facts import nearly, size
from symbalance.exact.amplitude import Amplitude


def station_cell(station: Fraction) -> Formula:
    """Return a place along the crank, as a fraction of the pitch."""
    return formula_of(sympy.Rational(station.numerator, station.denominator))


def size_cell(vector: Amplitude, *, below_zero: bool = False) -> Cell:
    """Return how large a vector is: exactly, beside its decimal, where that is short."""
    *before, value = size(vector)
    near, signed = nearly(vector), -value if below_zero else value
    if not isinstance(near, Decimal):
        return (*before, signed)
    return Exact(signed, -near if below_zero else near, beside=True)
