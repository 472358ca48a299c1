"""Templates of a wiki that stand for a part of a formula: {{frac|3|2}}, {{sqrt|2}}, {{pi}}.

A template that is not known is no blank within a formula: `y = {{name|1}} + 2` is refused there.
"""

from __future__ import annotations

from symbalance.notes.reading.rewriting import Span
from symbalance.text import lazy_patterns as re

_FRACTIONS = ("frac", "sfrac", "tfrac", "dfrac", "fraction", "bruch")
_AROUND_ARGUMENT = {
    **dict.fromkeys(("sqrt", "radic", "root", "wurzel"), (" √(", ") ")),
    "sup": ("^{", "}"),
    "sub": ("_{", "}"),
    "abs": (" |", "| "),
}
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
    first, *values = _arguments(match)
    name = match.string[slice(*first)].strip().lower()
    if name in _SIGNS and not values:
        return (_SIGNS[name],)
    if name in _FRACTIONS and len(values) in (1, 2, 3):
        return _fraction(values)
    if name in _AROUND_ARGUMENT and len(values) == 1:
        left, right = _AROUND_ARGUMENT[name]
        return (left, values[0], right)
    return None


def _fraction(values: list[Span]) -> tuple[str | Span, ...]:
    """Return {{frac|2}} as a half, {{frac|3|2}} as 3/2, {{frac|1|3|2}} as one and 3/2."""
    if len(values) == 1:
        return (" (1/(", values[0], ")) ")
    if len(values) == 2:
        return (" ((", values[0], ")/(", values[1], ")) ")
    return (" (", values[0], " + (", values[1], ")/(", values[2], ")) ")


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
