"""Formulas cut into pieces by their dollars, `$a$ = 80 mm` and `$F$ $\\cdot$ $r$`, put together again."""

from __future__ import annotations

import re

from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.notes.reading.signs import RELATION

_QUANTITY = (
    r"[-−]?[0-9][0-9.,]*(?:[0-9]|(?<=[0-9]))(?:\\,|~| )?(?:\\mathrm\{[^{}]{1,20}\}|\^\{?\\circ\}?)?"
)
_FORMULA = r"(?<!\\)\$[^$\n]{1,200}(?<!\\)\$"
_SEQUENCE = re.compile(rf"(?:{_FORMULA}|{_QUANTITY})(?:[ ~]*(?:{_FORMULA}|{_QUANTITY}))+")
_PART = re.compile(rf"({_FORMULA})|({_QUANTITY})")
_OPERATION = re.compile(
    r"(?:\\[,;: ]|\{\}|[ ~])*(?:[-+−·×=≈<>]|\\(?:cdot|times|approx|le|ge|leq|geq)(?![A-Za-z]))"
)
_UNIT = (
    r"(?:k?N ?m?|[kmc]?m(?:/s(?:\^?[2²])?)?|k?g|m?s|rpm|rad(?:/s)?|1/s|1/min|U/min|[kMG]?Pa|bar|k?W|k?J"
    r"|Hz|N/mm[²2]?|N/m|kg ?m[²2]?|°|%|\\%)"
)
_OUTSIDE = re.compile(
    rf"({_FORMULA})(?P<sign>[ ~]*(?:[=≈<>≤≥])[ ~]*)(?P<number>[-−]?[0-9][0-9.,]*[0-9]|[-−]?[0-9])"
    rf"(?:[ ~](?P<unit>{_UNIT}))?(?![\w$^]|[ ]?[-+−·×*/=(\\$])"
)


_UNIT_BETWEEN = re.compile(
    rf"({_FORMULA})[ ~]*(?P<unit>{_UNIT})[ ~]*"
    r"\$(?P<rest>[ ]*(?:[=≈]|\\approx(?![A-Za-z]))[^$\n]{1,200})(?<!\\)\$"
)
"""A quantity that the next formula goes on with: $m = 180$ g $= 0,180$ kg."""


def with_joined_dollars(text: str) -> Rewritten | None:
    r"""Return a text with such pieces within one pair of dollars, None where there are none.

    >>> with_joined_dollars("je $c$ = 150 N/mm und").text
    'je $c = 150\\,\\mathrm{N/mm}$ und'
    """
    if "$" not in text:
        return None
    changes: dict[int, tuple[int, tuple[str | tuple[int, int], ...]]] = {}
    for match in _OUTSIDE.finditer(text):
        start, end = match.span(1)
        if RELATION.search(match[1]) or not _opens(text, start):
            continue
        unit = match["unit"]
        tail = f"\\,\\mathrm{{{unit}}}$" if unit and unit not in "°%\\%" else f"{unit or ''}$"
        tail = "^{\\circ}$" if unit == "°" else tail.replace("%", "\\%") if unit == "%" else tail
        changes[start] = match.end(), ((start, end - 1), (end, match.end("number")), tail)
    for match in _UNIT_BETWEEN.finditer(text):
        if match.start() not in changes and _opens(text, match.start(1)):
            unit = match["unit"].removeprefix("\\")
            sign = {"°": "^{\\circ}", "%": "\\%"}.get(unit, f"\\,\\mathrm{{{unit}}}")
            changes[match.end(1) - 1] = match.start("rest"), (sign,)
    for match in _SEQUENCE.finditer(text):
        if match.start() in changes or not _opens(text, match.start()):
            continue
        parts = list(_PART.finditer(text, *match.span()))
        formulas = [part[1][1:-1] for part in parts if part[1]]
        if any(_OPERATION.match(inside) or _ends_open(inside) for inside in formulas):
            spans = [(p.start() + 1, p.end() - 1) if p[1] else p.span() for p in parts]
            changes[match.start()] = match.end(), ("$", *spans, "$")
    if not changes:
        return None
    rewriter = Rewriter(text)
    for start, (end, texts) in sorted(changes.items()):
        if start >= rewriter.place:
            rewriter.replace(start, end, *texts)
    return rewriter.finish()


def _ends_open(inside: str) -> bool:
    """Tell whether a formula ends with an operation that wants more."""
    bare = re.sub(r"(?:\\[,;: ]|\{\}|[ ~])+$", "", inside)
    return bare.endswith(("+", "-", "=", "\\cdot", "\\times", "\\approx"))


def _opens(text: str, place: int) -> bool:
    """Tell whether a place stands outside the dollars of its paragraph."""
    begin = text.rfind("\n\n", 0, place) + 1
    return len(re.findall(r"(?<!\\)\$", text[begin:place].replace("$$", ""))) % 2 == 0
