r"""Equations behind one brace, `\begin{cases} a + b = 5 \\ a - b = 1 \end{cases}`, as rows of a display.

Behind a relation sign such a brace holds cases: f = { 0 for x < 0, 1 for x ≥ 0.
"""

from __future__ import annotations

from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.notes.reading.signs import RELATION
from symbalance.text import lazy_patterns as re

_ROWS = r"(?P<rows>(?:(?!\\begin|\\end).){1,4000}?)"
_BRACE = re.compile(
    r"\\left\s*\\(?:\{|lbrace)\s*\\begin\s*\{(?P<inner>aligned|array|gathered|alignedat|split|matrix)\}"
    rf"(?:\s*\{{[^{{}}]*\}})?{_ROWS}\\end\s*\{{(?P=inner)\}}\s*\\right\s*\."
    rf"|\\begin\s*\{{(?P<cases>d?cases)\}}{_ROWS.replace('rows', 'values')}\\end\s*\{{(?P=cases)\}}",
    re.DOTALL,
)
_RELATION_LAST = re.compile(rf"(?:{RELATION.pattern})$")
_BEFORE = 24  # characters before the brace in which its relation stands


def with_systems(text: str) -> Rewritten | None:
    r"""Return a text with systems as rows of equations, and cases as such; None where there are none.

    >>> with_systems(r"\[\begin{cases} a + b = 5 \\ a = 3 \end{cases}\]").text
    '\\[\\begin{aligned} a + b = 5 \\\\ a = 3 \\end{aligned}\\]'
    """
    if "\\begin" not in text:
        return None
    rewriter, changed = Rewriter(text), False
    for match in _BRACE.finditer(text):
        group = "values" if match["cases"] else "rows"
        before = text[max(match.start() - _BEFORE, 0) : match.start()].rstrip(" \t\n&")
        if _RELATION_LAST.search(before):
            name = "" if match["cases"] else "cases"
        else:
            rows = _rows(match[group])
            if match["cases"] and rows and all(RELATION.match(row.lstrip(" \t\n&")) for row in rows):
                rewriter.replace(*match.span(), *_with_relation_before(text, *match.span(group)))
                changed = True
                continue
            name = "aligned" if all(map(_is_equation, rows)) else ""
        if name:
            rewriter.replace(*match.span(), f"\\begin{{{name}}}", match.span(group), f"\\end{{{name}}}")
            changed = True
    return rewriter.finish() if changed else None


_ARRAY = re.compile(
    r"\\begin\s?\{array\}\s?(?:\[[a-z]\]\s?)?\{[rlc@{}\\,;!. ]{2,24}\}"
    r"(?P<rows>(?:(?!\\begin|\\end).){1,4000}?)\\end\s?\{array\}",
    re.DOTALL,
)
_RIGHT_BRACE = re.compile(
    r"\\left\s?\.\s*(?P<body>\\begin\s?\{(?P<name>aligned|gathered|alignedat|split)\}(?:(?!\\begin|\\end).){1,4000}?"
    r"\\end\s?\{(?P=name)\})\s*\\right\s?\\(?:\}|rbrace)",
    re.DOTALL,
)


def with_rows_of_relations(text: str) -> Rewritten | None:
    r"""Return a text with equations in columns of an array, or before one brace, as rows of a display.

    >>> with_rows_of_relations(r"\begin{array}{rcl} a &=& b \\ c &=& d \end{array}").text
    '\\begin{aligned} a &=& b \\\\ c &=& d \\end{aligned}'
    """
    if "\\begin" not in text:
        return None
    rewriter, changed = Rewriter(text), False
    matches = [*_ARRAY.finditer(text), *_RIGHT_BRACE.finditer(text)]
    for match in sorted(matches, key=lambda match: match.start()):
        if match.start() < rewriter.place:
            continue
        if match.re.pattern == _RIGHT_BRACE.pattern:
            rewriter.replace(*match.span(), match.span("body"))
            changed = True
        elif all(map(_has_column_of_relation, _rows(match["rows"]))):
            rewriter.replace(*match.span(), "\\begin{aligned}", match.span("rows"), "\\end{aligned}")
            changed = True
    return rewriter.finish() if changed else None


def _has_column_of_relation(row: str) -> bool:
    """Tell whether a cell of a row is a relation sign alone."""
    return any(RELATION.fullmatch(cell.strip()) for cell in row.split("&"))


def _with_relation_before(text: str, start: int, end: int) -> list[str | tuple[int, int]]:
    """Return { = a if …, = b else as = { a if …, b else; with several relations it is not read."""
    signs: set[str] = set()
    spans: list[tuple[int, int]] = []
    first = start
    for stop in [*(m.start() for m in re.compile(r"\\\\").finditer(text, start, end)), end]:
        begin = re.compile(r"[ \t\n&]*").match(text, first, stop)
        sign = RELATION.match(text, begin.end() if begin else first, stop)
        if sign is not None:
            signs.add(sign.group())
            spans.append((sign.end(), stop))
        first = stop + 2
    if len(signs) > 1:
        return ["\\begin{relations}", (start, end), "\\end{relations}"]
    parts: list[str | tuple[int, int]] = [f"{signs.pop()}\\begin{{cases}}"]
    for span in spans:
        parts += [span, "\\\\"]
    return [*parts[:-1], "\\end{cases}"]


def _rows(inside: str) -> list[str]:
    return [row for row in re.split(r"\\\\", inside) if row.strip()]


def _is_equation(row: str) -> bool:
    """Tell whether a relation stands in a row's first cell, or right behind it."""
    first, _, second = row.partition("&")
    return RELATION.search(first) is not None or RELATION.match(second.lstrip()) is not None
