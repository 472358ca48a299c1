"""Cells of published tables beside the right values: what a page says, what the engine has, and why.

The tables stand in `published/tables.toml`, with the engines that they draw; what is right is computed
each time.
"""

from __future__ import annotations

import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from math import hypot
from pathlib import Path
from typing import Any

from symbalance.document.expressions import formula_of
from symbalance.document.text_writer import formula_text
from symbalance.drawing.charts import figure
from symbalance.engine.catalogue import load
from symbalance.exact.spectrum import Component
from symbalance.forces.free_forces import Balance, balance

FOLDER = Path(__file__).parent / "published"
HIGHEST = 12
RHO = 0.25
LEADING = {1: 1.0, 2: RHO, 4: RHO**3 / 4, 6: 9 / 128 * RHO**5}
"""The first term of A_n at lambda = 4: what the last column of the founding tables is computed from."""
NEAR = 1e-9
"""Of a cell that is exact: the rounding of its figure here."""


@dataclass(frozen=True)
class PublishedCell:
    """A cell of a published table, and what is right."""

    table: str
    source: str
    line: int | None
    engine: str
    quantity: str
    printed: str
    value: float
    right: float
    right_text: str
    last: float
    why: str

    @property
    def holds(self) -> bool:
        """Whether the cell is right to its last digit, rounded."""
        return abs(self.value - self.right) <= 0.5 * self.last + NEAR

    @property
    def off(self) -> float | None:
        """By how much of the right value the cell is off; None where that is zero."""
        return abs(self.value - self.right) / abs(self.right) if abs(self.right) > NEAR else None


def published_cells() -> tuple[PublishedCell, ...]:
    """Return every cell of the tables, in their order.

    >>> cell = next(cell for cell in published_cells() if cell.line == 137)
    >>> cell.printed, cell.right_text, cell.holds
    ('(3/2) sqrt(3) F q6', '3√3 ≈ 5.196', False)
    """
    tables = tomllib.loads((FOLDER / "tables.toml").read_text(encoding="utf-8"))["table"]
    return tuple(_cell(table, cell) for table in tables for cell in table["cells"])


def _cell(table: Mapping[str, Any], cell: Mapping[str, Any]) -> PublishedCell:
    of, order = cell["of"], cell.get("order", 0)
    result = _balance(cell["engine"])
    right, text = _right(result, of, order)
    return PublishedCell(
        table["title"],
        table["source"],
        cell.get("line"),
        cell["engine"].removesuffix(".toml"),
        _quantity(of, order),
        cell["printed"],
        float(cell["value"]),
        right,
        text,
        float(cell.get("last", 0.0)),
        cell.get("why", ""),
    )


@cache
def _balance(engine: str) -> Balance:
    return balance(load(FOLDER / engine if engine.endswith(".toml") else engine), HIGHEST)


def _quantity(of: str, order: int) -> str:
    """Return what a cell is about, in words."""
    if of == "piston":
        return f"order {order}, per cent of the first"
    kind, _, part = of.partition(".")
    if kind == "leading":
        return f"{part}, share of what is left"
    part = part.removesuffix(".cos")
    turning = {"forward": "with the crank", "backward": "against the crank"}.get(part)
    return f"{kind}, order {order}, {turning or part}"


def _right(result: Balance, of: str, order: int) -> tuple[float, str]:
    """Return what is right, as a number and in words."""
    if of == "piston":
        value = 100 * abs(float(result.values[order]))
        return value, figure(value)
    kind, _, part = of.partition(".")
    if kind == "leading":
        value = hypot(
            *(_size(getattr(result, part).component(n, "vertical")) * q for n, q in LEADING.items())
        )
        return value, f"{value:.3g}"
    component = getattr(result, kind).component(order, part.removesuffix(".cos"))
    if part.endswith(".cos"):
        value = float(component.decimal(20)[0])
        exact = component.form("cos").expression()
    else:
        value, exact = _size(component), component.amplitude
    if component.is_zero():
        return 0.0, "0"
    text = formula_text(formula_of(exact))
    near = figure(value)
    return value, text if text == near else f"{text} ≈ {near}"


def _size(component: Component) -> float:
    return hypot(*map(float, component.decimal(20)))


def cells_by_engine(cells: Sequence[PublishedCell]) -> dict[str, list[PublishedCell]]:
    """Return the cells that do not hold, by their engine's name."""
    wrong: dict[str, list[PublishedCell]] = {}
    for cell in cells:
        if not cell.holds:
            wrong.setdefault(cell.engine, []).append(cell)
    return wrong
