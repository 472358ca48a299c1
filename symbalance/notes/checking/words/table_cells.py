"""The cells of a page's tables: what the first cell of a row and the head of a column say."""

from __future__ import annotations

from bisect import bisect_right
from dataclasses import dataclass
from functools import cached_property, lru_cache

from symbalance.notes.checking.words.tables import Cell, tables_of


@dataclass(frozen=True, slots=True)
class TableCell:
    """Where something stands in a table: what its row, its column and the column of rows are called."""

    row: str
    column: str
    """The head of its column, "" in the head itself."""
    rows: str
    """The head of the first column, in which the rows are named."""
    start: int
    """Where its own text begins."""
    labels: tuple[Cell, ...] = ()
    """The head of its column and the first cell of its row, unless it is one of them."""
    others: tuple[Cell, ...] = ()
    """The heads of the other columns, but for the first."""


@dataclass
class TableCells:
    """The tables of one text, in every markup.

    >>> cell = TableCells("|order|four|six|\\n|--|--|--|\\n|2|A|B|\\n").at(33)
    >>> cell.row, cell.column, cell.rows
    ('2', 'six', 'order')
    """

    text: str

    def at(self, place: int) -> TableCell | None:
        """Return the cell at a place of the text, None outside of tables."""
        k = bisect_right(self._starts, place) - 1
        if k < 0:
            return None
        cell, table, row, column = self._cells[k]
        if place > cell.span[1]:
            return None
        heads = table[0]
        is_below, is_labelled = row > 0, column > 0
        head = heads[column] if is_below and column < len(heads) else None
        label = table[row][0]
        labels = (*([head] if head else []), *([label] if is_labelled else []))
        others = tuple(each for k, each in enumerate(heads) if is_below and k not in (0, column))
        return TableCell(
            row=label.text,
            column=head.text if head else "",
            rows=heads[0].text if is_below else "",
            start=cell.span[0],
            labels=labels,
            others=others,
        )

    @cached_property
    def _cells(self) -> list[tuple[Cell, list[list[Cell]], int, int]]:
        """Each cell with its table, its row and its column, in the order of the page."""
        tables = [[_without_frame(row) for row in table] for table in tables_of(self.text)]
        placed = [
            (cell, table, row, column)
            for table in tables
            if table and table[0]
            for row, cells in enumerate(table)
            for column, cell in enumerate(cells)
        ]
        return sorted(placed, key=lambda each: each[0].span)

    @cached_property
    def _starts(self) -> list[int]:
        return [cell.span[0] for cell, *_ in self._cells]


@lru_cache(maxsize=8)
def cells_of(text: str) -> TableCells:
    """Return the tables of a page, which are looked for once."""
    return TableCells(text)


def _without_frame(row: list[Cell]) -> list[Cell]:
    """Return a row without the empty cell behind its last bar."""
    return row[:-1] if len(row) > 1 and not row[-1].text else row
