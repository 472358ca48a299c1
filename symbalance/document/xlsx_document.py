"""A result's rows as an Excel workbook: one sheet, heads in bold that stay in view, numbers as numbers.

The same rows as in CSV. Every text is stored as a text, marked as one, so that no spreadsheet takes it
for a formula. What is unknown is an empty cell. The writer of workbooks, openpyxl, is an extra, and is
imported here alone.
"""

from __future__ import annotations

import io
import math
import re
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from symbalance.document.csv_document import is_risky, table_of
from symbalance.errors import MissingPartError, SymbalanceError, brief, visible

if TYPE_CHECKING:
    from symbalance.document.result import Result

MOST_ROWS, MOST_CHARACTERS = 1_048_576, 32_767
"""Of a sheet, and of a cell: spreadsheets drop what is more."""
EXACT = 2**53
"""Whole numbers up to here are exact as spreadsheets hold them; larger ones are written as texts."""
WIDEST = 60
"""Columns are as wide as their longest cell, and no wider than so many characters."""
_CODE = re.compile(r"_(?=x[0-9A-Fa-f]{4}_)")
"""What the format would read as the code of a character, as in _x0007_: its first sign is coded."""


def result_xlsx(result: Result) -> bytes:
    """Return a result's records as an xlsx workbook."""
    try:
        from openpyxl import Workbook
        from openpyxl.styles import Font
        from openpyxl.utils import get_column_letter
    except ImportError:
        rule, remedy = "is not installed", "pip install 'symbalance[xlsx]'"
        raise MissingPartError("openpyxl", rule, remedy) from None
    keys, rows = table_of(result)
    if len(rows) >= MOST_ROWS:
        rule = f"has {len(rows)} rows, and a sheet holds {MOST_ROWS - 1}"
        raise SymbalanceError(f"the result {result.kind!r}", rule, "write it as csv")
    book = Workbook()
    sheet = book.worksheets[0]
    sheet.title = result.kind[:31]  # a sheet's name may not be longer
    table = [list(keys), *([_value(v) for v in row] for row in rows)]
    for i, values in enumerate(table, 1):
        for j, value in enumerate(values, 1):
            if value is not None:
                cell: Any = sheet.cell(i, j)
                cell.value = value
                if isinstance(value, str):
                    cell.data_type = "s"  # openpyxl takes what begins with = for a formula
                    cell.quotePrefix = is_risky(value)  # and a spreadsheet would, once it is edited
                if i == 1:
                    cell.font = Font(bold=True)
    for j, column in enumerate(zip(*table, strict=True), 1):
        width = max(len(str(value)) for value in column if value is not None)
        sheet.column_dimensions[get_column_letter(j)].width = min(width, WIDEST) + 2
    sheet.freeze_panes = "A2"
    stream = io.BytesIO()
    book.save(stream)
    return stream.getvalue()


def _value(value: Any) -> Any:
    """Return a value as a cell holds it: a number, a yes or no, a text, None for an empty one.

    >>> [_value(v) for v in (None, True, 2, 0.5, Fraction(1, 4), 2**60, "=1", "_x0007_")]
    [None, True, 2, 0.5, 0.25, '1152921504606846976', '=1', '_x005F_x0007_']
    """
    if value is None or isinstance(value, bool):
        return value
    if isinstance(value, int):
        return value if abs(value) <= EXACT else str(value)
    if isinstance(value, Fraction | float):
        return float(value) if math.isfinite(value) else str(value)
    if not isinstance(value, str):
        raise TypeError(f"a record holds {brief(value)}, which is no plain value")
    text = _CODE.sub("_x005F_", visible(value))
    if len(text) > MOST_CHARACTERS:
        rule = f"has {len(text)} characters, and a cell holds {MOST_CHARACTERS}"
        raise SymbalanceError(f"the text {brief(value)}", rule, "write it as csv")
    return text
