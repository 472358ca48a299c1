"""Templates of a wiki that stand for a part of a formula: {{frac|3|2}}, {{sqrt|2}}, {{pi}}.

A template that is not known is no blank within a formula: `y = {{name|1}} + 2` is refused there.
"""

from __future__ import annotations

import re

from symbalance.notes.reading.rewriting import Span

_FRACTIONS = ("frac", "sfrac", "tfrac", "dfrac", "fraction", "bruch")
_ROOTS = ("sqrt", "radic", "root", "wurzel")
_SIGNS = {
    "pi": "π",
    "=": "=",
    "!": "|",
    "minus": "−",
    "times": "×",
    "cdot": "·",
    "infin": "∞",
    "sdot": "·",
}
_AROUND = 12
_OPERATION_BEFORE = re.compile(r"(?:[=≈<>≤≥+−*/·×(^]|&(?:minus|middot|times|sdot);)[ '_]*$")
_OPERATION_BEHIND = re.compile(r"[ '_]*(?:[=≈+−*/·×^)]|&(?:minus|middot|times|sdot);)")


def formula_of_template(match: re.Match[str]) -> tuple[str | Span, ...] | None:
    """Return a template that is a part of a formula as one, None for any other."""
    parts = _arguments(match)
    name = match.string[slice(*parts[0])].strip().lower()
    values = parts[1:]
    if name in _SIGNS and not values:
        return (_SIGNS[name],)
    if name in _FRACTIONS and len(values) == 1:
        return (" (1/(", values[0], ")) ")
    if name in _FRACTIONS and len(values) == 2:
        return (" ((", values[0], ")/(", values[1], ")) ")
    if name in _FRACTIONS and len(values) == 3:
        return (" (", values[0], " + (", values[1], ")/(", values[2], ")) ")
    if name in _ROOTS and len(values) == 1:
        return (" √(", values[0], ") ")
    if name == "sup" and len(values) == 1:
        return ("^{", values[0], "}")
    if name == "sub" and len(values) == 1:
        return ("_{", values[0], "}")
    if name == "abs" and len(values) == 1:
        return (" |", values[0], "| ")
    return None


def stands_in_formula(match: re.Match[str]) -> bool:
    """Tell whether an operator or a relation stands right before a template, or right behind it."""
    text, start, end = match.string, match.start(), match.end()
    before, behind = text[max(start - _AROUND, 0) : start], text[end : end + _AROUND]
    return _OPERATION_BEFORE.search(before) is not None or _OPERATION_BEHIND.match(behind) is not None


def _arguments(match: re.Match[str]) -> list[Span]:
    """Return the spans of a template's name and of its arguments, those within tags whole."""
    spans, first = [], match.start(1)
    for bar in [*re.finditer(r"\|", match[1]), None]:
        end = match.start(1) + bar.start() if bar else match.end(1)
        spans.append((first, end))
        first = end + 1
    return spans
