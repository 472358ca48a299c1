"""A run's report as a LaTeX page that compiles alone: amsmath, booktabs and, with pictures, graphicx."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from symbalance.crankshaft.reports.summary import Summary
from symbalance.crankshaft.reports.text import (
    MODE_HEAD,
    PLACE_HEAD,
    UNRELIABLE,
    comparison_lines,
    extreme_rows,
    head_lines,
    mode_rows,
    place_rows,
    reason_lines,
    speed_rows,
)
from symbalance.document.latex_characters import letter
from symbalance.errors import encodable_name

SPEED_HEAD = (r"rpm", r"$\lvert x\rvert/c$", r"off the orbit", r"bearing kN", r"multiplier", r"s")
EXTREME_HEAD = ("channel", "least", "largest", "unit", "rpm", "largest orders: amplitude")
LONGEST = 34
"""Rows of a table on one page."""
_SPECIAL = {
    **{c: "\\" + c for c in "%_&#${}"},
    "\\": r"\textbackslash{}",
    "~": r"\textasciitilde{}",
    "^": r"\textasciicircum{}",
    "|": r"\textbar{}",
}


def summary_page(found: Summary, pictures: Sequence[str] = ()) -> str:
    """Return the report as LaTeX; `pictures` are files beside it that it shows."""
    body = [rf"\section*{{{escaped(found.setting.engine.layout.name)}}}"]
    body += [escaped(line) + r"\\" for line in head_lines(found)]
    body += _table("Speeds", SPEED_HEAD, speed_rows(found))
    if lines := reason_lines(found):
        items = [rf"\item {escaped(line)}" for line in lines]
        body += [rf"\subsection*{{{UNRELIABLE}}}", r"\begin{itemize}", *items, r"\end{itemize}"]
    body += _table("Natural frequencies of the free crank", MODE_HEAD, mode_rows(found))
    if found.reliable:
        body += _table("Stresses and twists", EXTREME_HEAD, extreme_rows(found))
        body += _table("Durability, the worst speed of each place", PLACE_HEAD, place_rows(found))
    if found.comparisons:
        body += [r"\subsection*{Measured curves}", *(escaped(c) + r"\\" for c in comparison_lines(found))]
    if found.notes:
        items = [rf"\item {escaped(note)}" for note in found.notes]
        body += [r"\subsection*{Notes}", r"\begin{itemize}", *items, r"\end{itemize}"]
    for name in pictures:
        body += ["", rf"\noindent\includegraphics[width=\linewidth]{{{name}}}"]
    packages = ["amsmath", "booktabs", "lmodern", *(["graphicx"] if pictures else [])]
    head = [
        r"\documentclass[10pt]{article}",
        r"\usepackage[T1]{fontenc}",
        r"\usepackage[margin=15mm]{geometry}",
    ]
    head += [rf"\usepackage{{{package}}}" for package in packages]
    return "\n".join([*head, r"\begin{document}", r"\raggedright", *body, r"\end{document}", ""])


def escaped(text: str) -> str:
    """Return plain text as LaTeX shows it.

    >>> escaped("100 % of a_b |x|")
    '100 \\\\% of a\\\\_b \\\\textbar{}x\\\\textbar{}'
    """
    return "".join(_SPECIAL.get(c, c if c.isascii() else letter(c)) for c in encodable_name(text))


def _table(title: str, head: Sequence[str], rows: Iterable[Sequence[str]]) -> list[str]:
    """Return a table, broken into pieces that fit a page."""
    rows, lines = list(rows), [rf"\subsection*{{{escaped(title)}}}"]
    columns = "l" + "r" * (len(head) - 1)
    if head is EXTREME_HEAD:
        columns = "lrrlrl"
    for start in range(0, len(rows), LONGEST):
        named = [h if "$" in h else escaped(h) for h in head]
        lines += [
            "",
            r"\noindent{\footnotesize\setlength{\tabcolsep}{4pt}",
            rf"\begin{{tabular}}{{{columns}}}",
            r"\toprule",
        ]
        lines += [" & ".join(named) + r" \\", r"\midrule"]
        lines += [" & ".join(map(_cell, row)) + r" \\" for row in rows[start : start + LONGEST]]
        lines += [r"\bottomrule", r"\end{tabular}}"]
    return lines


def _cell(text: str) -> str:
    """Return a cell, a minus as such."""
    return re.sub(r"^-(?=[\d.])", "$-$", escaped(text))
