"""Force and couple of any number N of cylinders in a row that fire evenly, 1-2-…-N, as formulas.

The closed forms of `symbalance.forces.inline_sums` with N a symbol: order n survives in the force where
u = n strokes/(2 N) is whole, as N cos n theta, and in the couple where it is not.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

from symbalance.document.expressions import formula_of
from symbalance.document.formula import Name, Subscript, number
from symbalance.document.nodes import Column, Document, Exact, Facts, Table, Words
from symbalance.document.result import SequenceResult
from symbalance.engine.engine import checked_strokes
from symbalance.forces.inline_sums import condition, inline_couple, inline_sum
from symbalance.kinematics.slider_crank import checked_order


@dataclass(frozen=True)
class RowOrder:
    """One order: u, the force where u is whole (unit F_n), the couple where it is not (unit F_n a)."""

    order: int
    condition: Any
    force: Any
    couple: Any


@dataclass(frozen=True, repr=False, eq=False)
class RowFormulas(SequenceResult[RowOrder]):
    """Orders of an evenly firing row of N cylinders, N a symbol."""

    strokes: int
    items: tuple[RowOrder, ...]
    kind: ClassVar[str] = "row-formulas"

    def summary(self) -> str:
        """Return what the formulas are of, in one line."""
        return f"N cylinders in a row, firing evenly 1-2-…-N, {self.strokes}-stroke, to order {len(self)}"

    def document(self) -> Document:
        """Return a table of formulas, an order a line."""
        unit = Subscript(Name("F"), Name("n"))
        columns = (
            Column("order"),
            Column(Name("u")),
            Column(("force, ", unit), "force"),
            Column(("couple, ", unit * Name("a")), "couple"),
        )
        rows = tuple(
            (
                number(one.order),
                *(Exact(formula_of(x)) for x in (one.condition, one.force, one.couple)),
            )
            for one in self
        )
        legend: tuple[tuple[Words, Words], ...] = (
            (
                "force",
                ("where ", Name("u"), " is a whole number, else 0: the cylinders then push as one"),
            ),
            ("couple", ("where ", Name("u"), " is no whole number, else 0; + pushes the front up")),
            (Name("theta"), "crank angle, 0 with cylinder 1, the front one, at top dead centre"),
        )
        return Document(self.summary(), (Table("", columns, rows), Facts(legend, "How to read it")))

    def data(self) -> dict[str, Any]:
        """Return every order's formulas as text that SymPy reads."""
        return {"strokes": self.strokes, "orders": [_texts(one) for one in self]}

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each order, formulas as text that SymPy reads."""
        return [_texts(one) for one in self]


def _texts(one: RowOrder) -> dict[str, Any]:
    return {
        "order": str(one.order),
        "u": str(one.condition),
        "force": str(one.force),
        "couple": str(one.couple),
    }


def tabulate_row(order: int = 6, strokes: int = 4) -> RowFormulas:
    """Return the formulas of orders 1 to `order` for a row of N cylinders, N a symbol.

    >>> [str(part) for part in (tabulate_row(2)[1].force, tabulate_row(2)[1].couple)]
    ['N*cos(2*theta)', 'N*sin(2*theta + 4*pi/N)/(2*sin(4*pi/N))']
    """
    import sympy

    count = sympy.Symbol("N", integer=True, positive=True)
    checked_strokes(strokes)
    orders = []
    for n in range(1, checked_order(order) + 1):
        sums: Any = inline_sum(count, n, strokes)
        couples: Any = inline_couple(count, n, strokes)
        force = sums.args[0][0]
        couple = couples.args[1][0].replace(
            sympy.cos, lambda angle: sympy.sin(sympy.expand(angle + sympy.pi / 2))
        )
        orders.append(RowOrder(n, condition(count, n, strokes), force, couple))
    return RowFormulas(strokes, tuple(orders))
