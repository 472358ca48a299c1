"""Table of an engine's largest forces and couples over its speeds, in N and N m."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar

from symbalance.document.result import Result
from symbalance.errors import SymbalanceError
from symbalance.forces.free_forces import NEGLIGIBLE, Balance, slight_orders
from symbalance.forces.operating_point import UNITS

if TYPE_CHECKING:
    from symbalance.document.nodes import Block, Document

MOST_COLUMNS = 6
"""Orders of a table, which fits 80 columns so."""


@dataclass(frozen=True, repr=False)
class SpeedTable(Result):
    """A balance at several speeds: each order's largest force and couple, and those of all together.

    Everything grows with the square of the speed. The largest of an order is its size in whatever
    direction; that of all orders together is no more than the sum, since they are not largest at once.
    """

    balances: tuple[Balance, ...]

    kind: ClassVar[str] = "balance-over-speeds"

    def summary(self) -> str:
        """Return the engine and the speeds, in one line."""
        first, last = (
            b.operating_point.rpm for b in (self.balances[0], self.balances[-1]) if b.operating_point
        )
        name = self.balances[0].engine.name
        return f"Free forces and couples of {name} at {len(self.balances)} speeds, {first} to {last} rpm"

    @cached_property
    def _outputs(self) -> list[tuple[str, int]]:
        """What is tabled: ("force", 2) for an order that is free, ("force", 0) for all together."""
        first = self.balances[0]
        free = {"force": first.force.orders(), "couple": first.couple.orders()}
        return [(of, n) for of, orders in free.items() if orders for n in (*orders, 0)]

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each speed: rpm, and N or N m of each order and of all together."""
        return [
            {"rpm": float(balance.operating_point.rpm)}
            | {_key(of, n): self._value(balance, of, n) for of, n in self._outputs}
            for balance in self.balances
            if balance.operating_point
        ]

    def _value(self, balance: Balance, of: str, order: int) -> float:
        if not order:
            return balance.turn_maxima[of].value
        spectrum = balance.force if of == "force" else balance.couple
        size = sum(
            float(abs(spectrum.terms[n].evaluated())) for n in (order, -order) if n in spectrum.terms
        )
        return size * abs(float(balance.share(order) * balance.unit_value(of)))

    def data(self) -> dict[str, Any]:
        """Return the engine and a row for each speed."""
        first = self.balances[0]
        point = first.operating_point
        sizes = {k: v for k, v in point.data().items() if k != "rpm"} if point else {}
        return {"engine": first.engine.name, **sizes, "speeds": self.records()}

    def document(self) -> Document:
        """Return a table of the force and one of the couple, with a row for each speed."""
        from symbalance.document.nodes import Document, Paragraph
        from symbalance.engine.engine_document import engine_title

        title = engine_title(self.balances[0].engine)
        if not self._outputs:
            return Document(title, (Paragraph(f"no order is free, to order {self.balances[0].highest}"),))
        blocks = tuple(block for of in ("force", "couple") for block in self._blocks(of))
        return Document(title, blocks)

    def _blocks(self, of: str) -> list[Block]:
        """Return the tables of the force or the couple, and a line of the orders that are slight."""
        from symbalance.document.decimals import decimal
        from symbalance.document.nodes import Column, Paragraph, Table

        first, records = self.balances[0], self.records()
        free = [n for which, n in self._outputs if which == of and n]
        one_piston = float(first.unit_value(of)) if free else 0.0
        slight = [n for n in free if self._value(first, of, n) < NEGLIGIBLE * one_piston]
        shown = [n for n in free if n not in slight] + [0] * bool(free)
        blocks: list[Block] = []
        for start in range(0, len(shown), MOST_COLUMNS):
            part = shown[start : start + MOST_COLUMNS]
            columns = (Column("rpm"), *(Column(f"order {n}" if n else "all orders") for n in part))
            rows = tuple(
                tuple(decimal(record[key], 5) for key in ("rpm", *(_key(of, n) for n in part)))
                for record in records
            )
            goes_on = ", further orders" if start else ""
            title = f"Free {of} in {UNITS[of]}, largest over a turn in whatever direction{goes_on}"
            blocks.append(Table(title, columns, rows))
        return blocks + ([Paragraph(slight_orders(slight))] if slight else [])


def _key(of: str, order: int) -> str:
    return f"{of}.{order}" if order else of


def over_speeds(balance: Balance, speeds: Sequence[Fraction]) -> SpeedTable:
    """Return a balance at several speeds, in turns a minute.

    >>> from symbalance.engine.catalogue import load
    >>> from symbalance.forces.free_forces import balance
    >>> table = over_speeds(balance(load("vq30de"), 6), [Fraction(3000), Fraction(6000)])
    >>> [round(row["couple.1"]) for row in table.records()]
    [394, 1577]
    """
    if not speeds:
        raise SymbalanceError("speeds", "are none", "give one at least")
    at_speeds = tuple(balance.at(rpm=speed) for speed in speeds)
    for one in at_speeds[1:]:  # the largest over a turn grows as everything does: it is found once
        _scale_maxima(at_speeds[0], one)
    return SpeedTable(at_speeds)


def _scale_maxima(first: Balance, other: Balance) -> None:
    """Take over the largest values, times the square of the speeds' ratio."""
    a, b = first.operating_point, other.operating_point
    assert a is not None
    assert b is not None
    factor = float((b.rpm / a.rpm) ** 2)
    vars(other)["turn_maxima"] = {
        output: top._replace(value=top.value * factor, bound=top.bound * factor)
        for output, top in first.turn_maxima.items()
    }
