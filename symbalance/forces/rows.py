"""Rows of a table of free forces, couples and roll moments: one component of one order each."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import sympy

from symbalance.document.decimals import SHOWN_DIGITS, shown
from symbalance.exact.spectrum import Component
from symbalance.forces.free_forces import Balance, Order, Resultant
from symbalance.forces.shaft_moments import has_shafts_aside, shaft_moment
from symbalance.text.reals import atan2, hypot, pi

NEAR = Fraction(1, 10**20)
"""Of such a part; a phase as far off is another number."""
PLAIN_PARTS = 60
"""Parts of pi that a decimal component's phase is recognised in: 3 degrees."""


@dataclass(frozen=True)
class Row:
    """One component of one order, exact and (where it has no symbols) in decimals."""

    order: int | Fraction
    name: str
    component: Component

    @property
    def has_symbols(self) -> bool:
        """Whether the component depends on a symbolic angle."""
        return self.component.number.has_symbols

    @property
    def is_decimal(self) -> bool:
        """Whether the component is a number of some digits, with no exact form."""
        return self.component.number.is_decimal

    def decimals(self) -> tuple[str, str, str, str] | None:
        """Return cos, sin, amplitude and phase in decimals, or None with symbols in them."""
        if self.has_symbols:
            return None
        cos, sin = self.component.decimal(SHOWN_DIGITS + 10)
        values = (cos, sin, hypot(cos, sin), atan2(sin, cos))
        cos_text, sin_text, amplitude, phase = (shown(v) for v in values)
        return cos_text, sin_text, amplitude, phase

    def phase_in_turns(self) -> sympy.Expr | None:
        """Return the phase of a decimal component where it is a plain fraction of pi, else None."""
        cos, sin = self.component.decimal(SHOWN_DIGITS + 24)
        parts = atan2(sin, cos) / pi() * PLAIN_PARTS
        near = round(parts)
        return sympy.pi * near / PLAIN_PARTS if abs(parts - near) < NEAR else None

    def exact(self) -> tuple[sympy.Expr, sympy.Expr, sympy.Expr, sympy.Expr]:
        """Return cos, sin, amplitude and phase exactly; an endless amplitude as the root of C^2 + S^2."""
        part = self.component
        return part.cos, part.sin, _short(part.amplitude), part.phase


def _short(amplitude: Any) -> sympy.Expr:
    squares = amplitude.base.args if amplitude.is_Pow and amplitude.base.is_Add else ()
    if squares and all(square.is_Pow and square.exp == 2 for square in squares):
        return sympy.sqrt(sympy.Symbol("C") ** 2 + sympy.Symbol("S") ** 2)
    return amplitude


def rows(balance: Balance, resultant: str) -> list[Row]:
    """Return the vertical and lateral parts of the force or the couple that do not vanish, by order."""
    return [
        Row(order.order, name, part)
        for order in balance.orders
        for name in ("vertical", "lateral")
        if not (part := _of(order, resultant).component(name)).is_zero()
    ]


def rotating(balance: Balance, resultant: str) -> list[tuple[Row, Row]]:
    """Return each order's forward and backward part; empty where all is in one plane.

    There every order is two equal halves, one turning with the crank and one against it, each with
    half the amplitude and the phase of the whole.
    """
    if len({row.name for row in rows(balance, resultant)}) < 2:
        return []
    pairs = []
    for order in balance.orders:
        whole = _of(order, resultant)
        if not whole.is_zero():
            forward = Row(order.order, "forward", whole.forward)
            pairs.append((forward, Row(order.order, "backward", whole.backward)))
    return pairs


def _of(order: Order, resultant: str) -> Resultant:
    return order.force if resultant == "force" else order.couple


def roll_rows(balance: Balance) -> list[Row]:
    """Return the roll moment of an engine's shafts by order; empty where all run on the crank's axis.

    Units F_n r, or m r^2 omega^2 where components hold the kinematics; a stroke has to be known.
    """
    layout = balance.layout
    if not has_shafts_aside(layout) or layout.first.stroke is None:
        return []
    moments = shaft_moment(layout).items()
    return [Row(n, "roll", part) for n, part in moments if n <= balance.highest]


IN_ONE_PLANE = "each order is two equal halves, turning with and against the crank"


def plane(reference: Fraction | None) -> str:
    """Return in words what couples are taken about."""
    return "the mean of all stations" if reference is None else f"station {reference}"


def plane_key(reference: Fraction | None) -> str:
    """Return what couples are taken about, as JSON has it of every result."""
    return "mean of stations" if reference is None else f"station {reference}"
