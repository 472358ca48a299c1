"""Cells in aligned columns, for a terminal of 80 columns."""

from __future__ import annotations

from collections.abc import Sequence

WIDTH = 79


def grid(table: Sequence[Sequence[str]]) -> list[str]:
    """Return the lines of a table; the first column is flush right, empty columns are left out."""
    kept = [i for i in range(len(table[0])) if any(row[i] for row in table[1:])]
    widths = [max(len(row[i]) for row in table) for i in kept]
    lines = []
    for row in table:
        cells = [row[i].ljust(w) for i, w in zip(kept, widths, strict=True)]
        cells[0] = row[kept[0]].rjust(widths[0])
        lines.append("  " + "  ".join(cells).rstrip())
    return [lines[0], "  " + "─" * (max(map(len, lines)) - 2), *lines[1:]]
