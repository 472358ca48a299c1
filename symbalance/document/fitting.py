"""Tables fitted to a page or terminal's width: exact cells where they fit, decimals elsewhere.

Nothing is lost: an exact form that gives way to its decimal is listed below the table, once, with every
place it belongs to.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

from symbalance.document.formula import INFINITY, Decimal, Formula, Negative, Number
from symbalance.document.nodes import (
    UNKNOWN,
    Cell,
    Code,
    Column,
    Exact,
    Inline,
    Jump,
    Strong,
    Table,
    TooLong,
    Words,
    inlines,
)
from symbalance.document.text_writer import formula_text

SHORT = 14
"""An exact form of up to so many characters keeps its cell, whatever becomes of its column."""
LONGEST_PIECE = 60
"""Characters of an exact form that no sign parts; one with more has numbers that nobody reads."""
MOST_BELOW = 4
"""Exact forms that stand below a table of a short document; of more its reader is sent to the whole."""
SHORTEST = 3
"""No form shorter than this is worth a line below the table."""


@dataclass(frozen=True)
class LeftOut:
    """An exact form that has no room in its cell: where it belongs, what it is called, its value."""

    place: str
    name: str
    value: Formula


@dataclass(frozen=True)
class Fitted:
    """A table's columns and rows as they are to be written, and the exact forms that stand below it."""

    columns: tuple[Column, ...]
    rows: tuple[tuple[Words, ...], ...]
    left_out: tuple[LeftOut, ...]
    remark: Words = ""
    """What is said of exact forms that have no room: in any medium, or in a short document."""

    def cells(self, column: int) -> tuple[Words, ...]:
        """Return what stands in a column below its head."""
        return tuple(row[column] for row in self.rows)

    @cached_property
    def numeric(self) -> tuple[bool, ...]:
        """Whether all cells of a column are numbers, whose points stand in line; by column."""
        return tuple(all(map(is_number, self.cells(i))) for i in range(len(self.columns)))


def fit_table(table: Table, width: Callable[[Words], float], room: float, gap: float) -> Fitted:
    """Return a table with the exact cells that fit into `room`; `gap` lies between two columns.

    The widest column gives way first, its short cells last.
    """
    readable = [tuple(map(_readable, row)) for row in table.rows]
    filled = [i for i in range(len(table.columns)) if any(inlines(_full(row[i])) for row in readable)]
    columns = tuple(table.columns[i] for i in filled)
    cells = [tuple(row[i] for i in filled) for row in readable]
    unread = [
        cell
        for row, shown in zip(table.rows, readable, strict=True)
        for cell, words in zip(row, shown, strict=True)
        if words is not cell
    ]
    longest: dict[int, int] = {}  # by column: how long an exact form may be

    def width_of(i: int) -> float:
        body = (width(_words_in(row[i], longest.get(i))) for row in cells)
        return max(width(columns[i].head), *body)

    sizes = list(map(width_of, range(len(columns))))
    for limit in (SHORT, SHORTEST):
        open_columns = {i for i in range(len(columns)) if _can_give_way(cells, i, limit)}
        while open_columns and sum(sizes) + gap * (len(columns) - 1) > room:
            widest = max(open_columns, key=lambda i: sizes[i])
            open_columns.discard(widest)
            longest[widest] = limit
            sizes[widest] = width_of(widest)
    rows = tuple(tuple(_words_in(c, longest.get(i)) for i, c in enumerate(row)) for row in cells)
    keys = sum(i < table.keys for i in filled)
    left_out, remark = _left_out(keys, columns, cells, longest), _remark(unread)
    if table.in_short and len(left_out) > MOST_BELOW:
        said = (f"{remark}; " if remark else "", "the exact forms of what is rounded: ", Code("--full"))
        return Fitted(columns, rows, (), said)
    return Fitted(columns, rows, left_out, remark)


def _readable(cell: Cell) -> Words | Exact:
    """Return a cell; of an exact form that nobody reads its decimal alone."""
    if isinstance(cell, TooLong):
        return cell.near
    if not isinstance(cell, Exact) or cell.near is None:
        return cell
    pieces = formula_text(cell.value).split(" ")
    return cell if max(map(len, pieces)) <= LONGEST_PIECE else cell.near


def _remark(unread: Sequence[Cell]) -> str:
    long = sum(isinstance(cell, TooLong) for cell in unread)
    whys = (
        (long, "fills", "fill", "a page"),
        (len(unread) - long, "has", "have", "numbers longer than a line"),
    )
    parts = [
        f"{count} exact form{'' if count == 1 else 's'} {one if count == 1 else several} {what}"
        for count, one, several, what in whys
        if count
    ]
    return f"{' and '.join(parts)}: the JSON of this result has them" if parts else ""


def _full(cell: Words | Exact) -> Words:
    """Return a cell with its exact form, and its decimal where both are wanted."""
    if not isinstance(cell, Exact):
        return cell
    if cell.beside and cell.near is not None and cell.near != cell.value:
        return (cell.value, " ≈ ", cell.near)
    return cell.value


def _gives_way(cell: Words | Exact, limit: int | None) -> bool:
    return limit is not None and isinstance(cell, Exact) and len(formula_text(cell.value)) > limit


def _words_in(cell: Words | Exact, limit: int | None) -> Words:
    if isinstance(cell, Exact) and _gives_way(cell, limit):
        return "below" if cell.near is None else cell.near
    return _full(cell)


def _can_give_way(cells: list[tuple[Words | Exact, ...]], column: int, limit: int) -> bool:
    return any(_gives_way(row[column], limit) for row in cells)


def _left_out(
    keys: int,
    columns: tuple[Column, ...],
    cells: list[tuple[Words | Exact, ...]],
    longest: dict[int, int],
) -> tuple[LeftOut, ...]:
    """Return the exact forms that gave way, each once, with all the rows it belongs to.

    The first `keys` columns say which row it is.
    """
    rows_of: dict[tuple[Formula, str, int], list[str]] = {}
    for row in cells:
        names = [plain_words(_full(cell)) for cell in row[:keys]]
        for i, cell in enumerate(row):
            if isinstance(cell, Exact) and _gives_way(cell, longest.get(i)):
                place = (cell.value, " ".join(name for name in names[1:] if name), i)
                rows_of.setdefault(place, []).append(names[0])
    head = name_of(columns[0]) if columns else ""
    return tuple(
        LeftOut(
            " ".join(filter(None, (f"{head}{'s' if len(rows) > 1 else ''} {', '.join(rows)}", rest))),
            name_of(columns[i]),
            value,
        )
        for (value, rest, i), rows in rows_of.items()
    )


def is_number(words: Words) -> bool:
    """Tell whether a cell is a lone number, infinite, unknown or empty: points stand in line.

    >>> from symbalance.document.formula import number
    >>> is_number(number(3)), is_number(-number(3)), is_number("3 of 4"), is_number(UNKNOWN)
    (True, True, False, True)
    """
    match inlines(words):
        case ():
            return True
        case (only,):
            size = only.operand if isinstance(only, Negative) else only
            return isinstance(size, Decimal | Number) or size in (UNKNOWN, INFINITY)
        case _:
            return False


def name_of(column: Column) -> str:
    """Return what a column is called in a sentence."""
    return column.name or plain_words(column.head)


def plain_words(words: Words) -> str:
    """Return words as one line of text.

    >>> from symbalance.document.formula import Name
    >>> plain_words(("unit ", Name("r")))
    'unit r'
    """
    return "".join(map(_plain, inlines(words)))


def _plain(inline: Inline) -> str:
    if isinstance(inline, Code | Strong | Jump):
        return inline.text
    return inline if isinstance(inline, str) else formula_text(inline)
