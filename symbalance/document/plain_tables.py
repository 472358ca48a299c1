"""Tables of figures with a few lines of heading, as text and as LaTeX."""

from __future__ import annotations

from collections.abc import Sequence
from textwrap import wrap

from symbalance.document.grid import WIDTH, grid
from symbalance.document.latex_parts import ROWS_PER_TABLE, escaped, in_document


def figure(value: float, digits: int = 6) -> str:
    """Return a number to some digits, with a minus sign of its own.

    >>> figure(-0.0000012345678), figure(0.0)
    ('−1.23457e−06', '0')
    """
    return f"{value:.{digits}g}".replace("-", "−")


def numbered(numbers: Sequence[int]) -> str:
    """Return numbers as runs.

    >>> numbered([4, 1, 2, 3, 7])
    '1–4, 7'
    """
    runs: list[list[int]] = []
    for number in sorted(numbers):
        if runs and number == runs[-1][-1] + 1:
            runs[-1].append(number)
        else:
            runs.append([number])
    return ", ".join(f"{r[0]}–{r[-1]}" if len(r) > 2 else ", ".join(map(str, r)) for r in runs)


def table_text(head: Sequence[str], columns: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Return a heading and a table, or that there is none."""
    lines = [part for line in head for part in wrap(line, WIDTH, subsequent_indent="  ")]
    body = grid([list(columns), *map(list, rows)]) if rows else ["  none"]
    return "\n".join([*lines, "", *body]) + "\n"


def table_latex(head: Sequence[str], columns: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Return a heading and a table as a complete LaTeX document (booktabs)."""
    title, *about = (escaped(line) for line in head)
    lines = [rf"\textbf{{{title}}}\par", *(rf"{line}\par" for line in about)]
    for first in range(0, max(len(rows), 1), ROWS_PER_TABLE):
        lines += _tabular(columns, rows[first : first + ROWS_PER_TABLE])
    return in_document("\n".join(lines))


def _tabular(columns: Sequence[str], rows: Sequence[Sequence[str]]) -> list[str]:
    body = [" & ".join(map(escaped, row)) + r" \\" for row in rows] or [r"none \\"]
    top = " & ".join(map(escaped, columns)) + r" \\ \midrule"
    shape = "r" + "l" * (len(columns) - 1)
    return ["", r"\medskip", rf"\begin{{tabular}}{{{shape}}} \toprule", top, *body,
            r"\bottomrule \end{tabular}", ""]  # fmt: skip
