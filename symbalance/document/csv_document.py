"""A result's rows as CSV: one table for spreadsheets and programs, with a row of heads.

UTF-8 text of RFC 4180: commas, lines ended by CR LF, quotes round what holds a comma, a quote or a
line's end. Numbers are decimals with a point, in the fewest digits that read back as the same number;
yes and no are `true` and `false`, what is unknown is empty. Characters that a terminal obeys, or that do
not show, are written by their codes; line breaks within a text stay.

A spreadsheet takes a text that begins with = + - or @ for a formula and runs it. Texts come from files
of others; so such a text, and one that begins with an apostrophe, gets an apostrophe before it. A program
takes one apostrophe off again. Exact numbers such as -sqrt(3) are texts; plain ones such as -2 are not.
"""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from symbalance.errors import SymbalanceError, brief, visible

if TYPE_CHECKING:
    from symbalance.document.result import Result

_PLAIN = re.compile(r"[+-]?\d+(\.\d+)?([eE][+-]?\d+)?")
"""A number, which does no harm as one: -2, 1.5e-7."""
_FORMULAS = tuple("=+-@＝＋－＠")
"""What a formula begins with, in East Asian widths too, where spreadsheets take them alike."""


def result_csv(result: Result) -> str:
    """Return a result's records as CSV."""
    keys, rows = table_of(result)
    stream = io.StringIO(newline="")
    writer = csv.writer(stream, lineterminator="\r\n")
    writer.writerow(map(_cell, keys))
    writer.writerows([_cell(value) for value in row] for row in rows)
    return stream.getvalue()


def table_of(result: Result) -> tuple[tuple[str, ...], list[list[Any]]]:
    """Return a result's records as heads and rows; what is nested has its keys joined by points.

    >>> from symbalance.document.result import Result
    >>> class Nested(Result):
    ...     def records(self):
    ...         return [{"order": 1, "force": {"cos": 2.0, "sin": [0, 1]}}]
    >>> table_of(Nested())
    (('order', 'force.cos', 'force.sin.1', 'force.sin.2'), [[1, 2.0, 0, 1]])
    """
    flat = [dict(_flattened("", record)) for record in result.records()]
    keys = tuple(dict.fromkeys(key for record in flat for key in record)) or result.record_keys
    heads = list(dict.fromkeys(key.partition(".")[0] for key in keys))
    keys = tuple(sorted(keys, key=lambda key: heads.index(key.partition(".")[0])))  # parts stand together
    if not keys:
        rule = "has no rows, and so no table"
        raise SymbalanceError(f"the result {result.kind!r}", rule, "take another format, such as json")
    return keys, [[record.get(key) for key in keys] for record in flat]


def _flattened(place: str, value: Any) -> Sequence[tuple[str, Any]]:
    """Return (key, value) of everything in a record, keys of what is nested joined by points."""
    inner: Sequence[tuple[Any, Any]]
    if isinstance(value, Mapping):
        inner = list(value.items())
    elif isinstance(value, list | tuple):
        inner = list(enumerate(value, 1))
    else:
        return [(place, value)]
    head = f"{place}." if place else ""
    return [pair for key, part in inner for pair in _flattened(f"{head}{key}", part)]


def _cell(value: Any) -> str:
    """Return a value as it stands in a cell.

    >>> [_cell(value) for value in (None, True, 0.1, -2, "-sqrt(3)", "-2", "=1+1", "'tis", " @x")]
    ['', 'true', '0.1', '-2', "'-sqrt(3)", '-2', "'=1+1", "''tis", "' @x"]
    """
    if value is None:
        return ""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int | float):
        return repr(value)
    if isinstance(value, Fraction):
        return str(value)
    if not isinstance(value, str):
        raise TypeError(f"a record holds {brief(value)}, which is no plain value")
    text = visible(value)
    return f"'{text}" if is_risky(text) or text.startswith("'") else text


def is_risky(text: str) -> bool:
    """Tell whether a spreadsheet would take a text for a formula."""
    if _PLAIN.fullmatch(text):
        return False
    return text.lstrip().startswith(_FORMULAS) or text.startswith(("\t", "\r"))
