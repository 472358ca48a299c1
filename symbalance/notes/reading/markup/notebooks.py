"""Jupyter notebooks as text: the cells one below the other, each below a line that names it.

Markdown cells and those of %%latex stand as they are, code in fences, to be passed over as program
code. Of what a program printed only the number of its relation signs is left: nobody wrote it. A line
of the text is so a line of a cell.
"""

from __future__ import annotations

import json
from typing import Any

from symbalance.errors import SymbalanceError
from symbalance.notes.reading.signs import RELATION
from symbalance.text import lazy_patterns as re

SUFFIX = ".ipynb"
MOST_CELLS = 10_000
_HEAD = re.compile(r"<!-- cell ([0-9]{1,6}): [a-z]+ -->$")
OUTPUT = re.compile(r"^<!-- output: (?P<count>[0-9]{1,6}) relation signs -->$", re.MULTILINE)
"""Stands below a cell whose program printed relations."""
_SHOWN = re.compile(r"\s*%%(?:latex|markdown|html)\b")
"""How a cell begins whose text Jupyter shows as it stands."""
_FENCE = re.compile(r"`{3,}")


def notebook_text(source: str, name: str) -> str:
    """Return the cells of a notebook, the JSON that Jupyter writes, as one Markdown text.

    >>> print(notebook_text('{"cells": [{"cell_type": "markdown", "source": ["$a = b$"]}]}', "n.ipynb"))
    <!-- cell 1: markdown -->
    $a = b$
    """
    try:
        notebook = json.loads(source)
    except (ValueError, RecursionError) as problem:
        what = f"is no JSON: {problem}" if isinstance(problem, ValueError) else "is nested too deeply"
        raise SymbalanceError(name, what, "save it again with Jupyter") from None
    cells = _cells(notebook)
    if cells is None or len(cells) > MOST_CELLS:
        rule = (
            "is no notebook: it has no list of cells" if cells is None else f"has over {MOST_CELLS} cells"
        )
        raise SymbalanceError(name, rule, "save it again with Jupyter, as format 4")
    texts = (_cell_text(cell, number, name) for number, cell in enumerate(cells, 1))
    between = (f"\n{_output_mark(cell)}\n" for cell in cells)  # printed or not, one line
    return "".join(part for pair in zip(texts, between, strict=True) for part in pair).rstrip("\n")


def _cells(notebook: Any) -> list[Any] | None:
    """Return the cells, of format 4 or, within a worksheet, 3."""
    if not isinstance(notebook, dict):
        return None
    sheets = notebook.get("worksheets")
    if "cells" not in notebook and isinstance(sheets, list) and all(isinstance(s, dict) for s in sheets):
        inside = [sheet.get("cells") for sheet in sheets]
        return [cell for cells in inside if isinstance(cells, list) for cell in cells]
    cells = notebook.get("cells")
    return cells if isinstance(cells, list) else None


def _source(cell: Any) -> str | None:
    """Return what the author typed into a cell, of format 4 or 3; None where it is no text."""
    lines = cell.get("source", cell.get("input", "")) if isinstance(cell, dict) else None
    parts = lines if isinstance(lines, list) else [lines]
    if not all(isinstance(part, str) for part in parts):
        return None
    return "".join(map(str, parts)).replace("\r\n", "\n").rstrip("\n")


def _cell_text(cell: Any, number: int, name: str) -> str:
    kind, source = cell.get("cell_type") if isinstance(cell, dict) else None, _source(cell)
    if not isinstance(kind, str) or source is None:
        raise SymbalanceError(
            f"{name}: cell {number}", "is no cell of a notebook", "save it again with Jupyter"
        )
    head = f"<!-- cell {number}: {re.sub('[^a-z]', '', kind.lower()) or 'other'} -->"
    if kind in ("markdown", "heading"):
        return f"{head}\n{source}"
    if _SHOWN.match(source):
        shown = source.partition("\n")[2]
        return f"{head}\n\n{shown}"
    fence = max(["```", *_FENCE.findall(source)], key=len)
    fence += "`" if fence in source else ""
    return f"{head}\n{fence}code\n{source}\n{fence}"


def _output_mark(cell: Any) -> str:
    """Return the line between a cell and the next one, which says how many relations it printed."""
    printed = len(RELATION.findall(_printed(cell)))
    return f"<!-- output: {printed} relation signs -->" if printed else ""


def _printed(cell: Any) -> str:
    """Return what the program of a cell printed, as the reader of the notebook sees it."""
    parts: list[Any] = []
    outputs = cell.get("outputs") if cell.get("cell_type") == "code" else ()
    if _SHOWN.match(_source(cell) or ""):
        return ""  # %%latex: the output is the cell again
    for output in outputs if isinstance(outputs, list) else ():
        if not isinstance(output, dict):
            continue
        data = output.get("data")
        kinds = data if isinstance(data, dict) else output
        shown = (
            kinds.get(kind) for kind in ("text/latex", "text/markdown", "text/plain", "text", "latex")
        )
        parts.append(next((each for each in shown if each), ""))
    lines = ("".join(map(str, part)) if isinstance(part, list) else str(part) for part in parts)
    return "\n".join(lines)


def cell_place(text: str, line: int) -> tuple[int, int] | None:
    """Return the cell, from 1, on which a line of such a text stands, and its line there.

    >>> cell_place("<!-- cell 1: markdown -->\\n$a = b$", 2)
    (1, 1)
    """
    lines = text.split("\n", line)[:line]
    for back, words in enumerate(reversed(lines)):
        if match := _HEAD.match(words):
            return int(match[1]), back
    return None
