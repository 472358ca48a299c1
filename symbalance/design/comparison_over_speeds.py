"""Several engines side by side over their speeds: the largest force and couple of each, in N and N m."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any, ClassVar

from symbalance.design.comparison import KINDS, EngineComparison
from symbalance.document.result import Result
from symbalance.errors import SymbalanceError
from symbalance.forces.operating_point import UNITS
from symbalance.forces.speed_table import SpeedTable, over_speeds

if TYPE_CHECKING:
    from symbalance.document.nodes import Document, Table

MOST_COLUMNS = 6
"""Engines of one table, which fits 80 columns so."""


@dataclass(frozen=True, repr=False)
class ComparisonOverSpeeds(Result):
    """Several engines at several speeds: of each the largest force and couple over a turn.

    All orders together, in whatever direction; the orders one by one are in its data and records.
    """

    engines: tuple[SpeedTable, ...]

    kind: ClassVar[str] = "comparison-over-speeds"
    record_keys: ClassVar[tuple[str, ...]] = ("engine", "rpm", "of", "order", "value", "value_unit")

    @property
    def _names(self) -> list[str]:
        return [table.balances[0].engine.name for table in self.engines]

    def summary(self) -> str:
        """Return the engines and the speeds, in one line."""
        speeds = self.engines[0].records()
        between = f"{speeds[0]['rpm']:g} to {speeds[-1]['rpm']:g} rpm"
        return f"Comparison of {', '.join(self._names)} at {len(speeds)} speeds, {between}"

    def data(self) -> dict[str, Any]:
        """Return every engine with a row for each speed, as a balance over speeds has them."""
        return {"engines": [table.data() for table in self.engines]}

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each engine, speed, and order of force and couple; order 0 is all together."""
        return list(self._rows())

    def _rows(self) -> Iterator[dict[str, Any]]:
        for name, table in zip(self._names, self.engines, strict=True):
            for row in table.records():
                for key, value in row.items():
                    of, _, order = key.partition(".")
                    if of in KINDS:
                        place = {"engine": name, "rpm": row["rpm"], "of": of, "order": int(order or 0)}
                        yield {**place, "value": value, "value_unit": UNITS[of]}

    def document(self) -> Document:
        """Return a table of the force and one of the couple, a row for each speed, an engine a column."""
        from symbalance.document.nodes import Document, Facts

        all_orders = "all orders together, the largest over a turn in whatever direction; not their sum"
        order_by_order = "in the JSON and CSV, or in the table of one engine alone"
        facts = Facts((("cells", all_orders), ("order by order", order_by_order)), "How to read it")
        tables = tuple(table for of in KINDS for table in self._tables(of))
        return Document(f"{len(self.engines)} engines compared over speeds", (*tables, facts))

    def _tables(self, of: str) -> Iterator[Table]:
        from symbalance.document.decimals import decimal
        from symbalance.document.formula import number
        from symbalance.document.nodes import Column, Table

        speeds = [table.records() for table in self.engines]
        for start in range(0, len(speeds), MOST_COLUMNS):
            part = slice(start, start + MOST_COLUMNS)
            # An engine whose orders all cancel has no such key.
            rows = tuple(
                (
                    decimal(at_speed[0]["rpm"], 5),
                    *(decimal(row[of], 5) if of in row else number(0) for row in at_speed[part]),
                )
                for at_speed in zip(*speeds, strict=True)
            )
            goes_on = ", further engines" if start else ""
            columns = (Column("rpm"), *map(Column, self._names[part]))
            title = f"Free {of} in {UNITS[of]}, all orders together{goes_on}"
            yield Table(title, columns, rows, topic=of)


def compare_over_speeds(comparison: EngineComparison, speeds: Sequence[Fraction]) -> ComparisonOverSpeeds:
    """Return a comparison's engines at several speeds, in turns a minute, each with its own sizes.

    >>> from symbalance.design.comparison import compare
    >>> from symbalance.engine.catalogue import load
    >>> six = load("vq30de")
    >>> table = compare_over_speeds(compare([six, six], 4), [Fraction(3000), Fraction(6000)])
    >>> [round(row["value"]) for row in table.records() if row["of"] == "couple" and row["order"] == 1]
    [394, 1577, 394, 1577]
    """
    tables = []
    for line in comparison:
        try:
            tables.append(over_speeds(line.balance, speeds))
        except SymbalanceError as problem:
            raise problem.within(line.engine.name) from None
    return ComparisonOverSpeeds(tuple(tables))
