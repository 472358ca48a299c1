"""The cells of tables of Markdown: what the first cell of a row and the head of a column say."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property


@dataclass(frozen=True, slots=True)
class TableCell:
    """Where something stands in a table: what its row, its column and the column of rows are called."""

    row: str
    column: str
    """The head of its column, "" in the head itself."""
    rows: str
    """The head of the first column, in which the rows are named."""


@dataclass
class TableCells:
    """The tables of one text, whose rows begin with a bar."""

    text: str

    def at(self, place: int) -> TableCell | None:
        """Return the cell at a place of the text, None outside of tables."""
        own = self.text[self.text.rfind("\n", 0, place) + 1 : place]
        if not own.lstrip().startswith("|"):
            return None
        line = first = self.text.count("\n", 0, place)
        while first and self._lines[first - 1].lstrip().startswith("|"):
            first -= 1
        column, heads = own.count("|"), self._lines[first].split("|")
        is_below = first < line
        return TableCell(
            row=self._lines[line].split("|")[1],
            column=heads[column] if is_below and column < len(heads) else "",
            rows=heads[1] if is_below else "",
        )

    @cached_property
    def _lines(self) -> list[str]:
        return self.text.split("\n")
