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
    words, near = size(vector), nearly(vector)
    if below_zero:
        words, near = (*words[:-1], -words[-1]), -near if isinstance(near, Decimal) else near
    return Exact(words[0], near, beside=True) if near else words
