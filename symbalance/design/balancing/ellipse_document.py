"""The document of an ellipse: its semi-axes, the major axis' direction, the sense of rotation."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy

from symbalance.design.balancing.ellipses import Ellipse
from symbalance.design.balancing.weight_cells import size_cell
from symbalance.document.decimals import short_decimal
from symbalance.document.expressions import formula_of
from symbalance.document.formula import Decimal, Name, Subscript, number
from symbalance.document.nodes import Cell, Column, Document, Exact, Table, Words
from symbalance.document.text_writer import formula_text
from symbalance.engine.balance_mass_facts import LONGEST, direction, five_digits
from symbalance.forces.balance_document import conventions, unit
from symbalance.text.reals import Real, pi

_COLUMNS = (
    Column("order"),
    Column("of"),
    Column("long semi-axis"),
    Column("short", "short semi-axis"),
    Column("direction"),
    Column("drawn"),
)
_PARTS = (Column("part"), Column("amplitude"), Column(("at ", Name("theta"), " = 0")))
READING: tuple[tuple[Words, Words], ...] = (
    ("semi-axes", "sum and difference of the parts that turn with and against the crank"),
    ("direction", "of the long semi-axis, from straight up, + to the right"),
)
"""What the columns of a table of ellipses mean."""


def ellipse_document(ellipse: Ellipse) -> Document:
    """Return an ellipse as a document: its semi-axes, its two rotating parts, the conventions."""
    measure = unit(ellipse.balance, ellipse.of)
    ellipses = [] if ellipse.shape == "nothing" else [ellipse]
    parts = (("with the crank", ellipse.forward), ("against it", ellipse.backward))
    rows = tuple((name, size_cell(part), direction(part)) for name, part in parts if not part.is_zero())
    return Document(
        ellipse.summary(),
        (
            ellipse_table(("Ellipse, unit ", measure), ellipses),
            Table(("Rotating parts, unit ", measure), _PARTS, rows),
            *conventions(ellipse.balance, [*READING, *_units(ellipse)]),
        ),
    )


def _units(ellipse: Ellipse) -> list[tuple[Words, Words]]:
    """Return what F_n and the A_n of the ellipse's order are, where those stand apart from geometry."""
    value = ellipse.balance.values.get(ellipse.order)
    if ellipse.balance.kinematics is None:
        return []
    coefficient = Subscript(Name("A"), number(ellipse.order))
    here = () if value is None else (", here ", Decimal(short_decimal(value)))
    return [
        (unit(ellipse.balance, "force"), "force of order n of one cylinder"),
        (coefficient, ("coefficient of one cylinder", *here)),
    ]


def ellipse_table(title: Words, ellipses: Sequence[Ellipse]) -> Table:
    """Return a table of ellipses, a row each."""
    return Table(title, _COLUMNS, tuple(map(_cells, ellipses)), keys=2)


def _cells(ellipse: Ellipse) -> tuple[Cell, ...]:
    axes = (ellipse.major, ellipse.minor)
    decimals = (None, None) if ellipse.has_symbols else ellipse.decimal_axes
    sizes = [_axis(*pair) for pair in zip(axes, decimals, strict=True)]
    tilt = "" if ellipse.shape == "circle" else _tilt(ellipse)
    return number(ellipse.order), ellipse.of, *sizes, tilt, ellipse.description


def _axis(axis: sympy.Expr, decimal: Real | None) -> Cell:
    """Return a semi-axis exactly, beside its decimal; only that where the exact form is long."""
    value = formula_of(axis)
    if decimal is None:
        return value
    near = Decimal(_plain(decimal))
    if axis.has(sympy.Float) or len(formula_text(value)) > LONGEST:
        return ("≈ ", near)
    return Exact(value, near, beside=formula_text(near) != formula_text(value))


def _plain(value: Any) -> str:
    return five_digits(value).removesuffix(".0")


def _tilt(ellipse: Ellipse) -> Words:
    degrees = ellipse.direction * 180 / sympy.pi
    if degrees.is_Rational:
        return (formula_of(degrees), "°")
    if degrees.free_symbols:
        return formula_of(ellipse.direction)
    return ("≈ ", Decimal(_plain(ellipse.decimal_direction * 180 / pi())), "°")
