"""Formulas cut into pieces by their dollars, `$a$ = 80 mm` and `$F$ $\\cdot$ $r$`, put together again."""

from __future__ import annotations

from bisect import bisect_left
from itertools import accumulate, pairwise

from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.notes.reading.signs import RELATION
from symbalance.notes.reading.units import scale_of
from symbalance.text import lazy_patterns as re

_QUANTITY = r"[-−]?[0-9]++(?:[.,]++[0-9]++)*+(?:\\,|~| )?(?:\\mathrm\{[^{}]{1,20}\}|\^\{?\\circ\}?)?"
_FORMULA = r"(?<!\\)\$[^$\n]{1,200}(?<!\\)\$"
_SEQUENCE = re.compile(rf"(?:{_FORMULA}|{_QUANTITY})(?:[ ~]*(?:{_FORMULA}|{_QUANTITY})){{1,12}}+")
_PART = re.compile(rf"({_FORMULA})|({_QUANTITY})")
_OPERATION = re.compile(
    r"(?:\\[,;: ]|\{\}|[ ~])*(?:[-+−·×=≈<>]|\\(?:cdot|times|approx|le|ge|leq|geq)(?![A-Za-z]))"
)
_UNIT = (
    r"(?:k?N ?m?|[kmc]?m(?:/s(?:\^?[2²])?)?|k?g|m?s|rpm|rad(?:/s)?|1/s|1/min|U/min|[kMG]?Pa|bar|k?W|k?J"
    r"|Hz|N/mm[²2]?|N/m|kg ?m[²2]?|°|%|\\%)"
)
_NUMBER_OUTSIDE = r"[-−]?(?:[1-9][0-9]{0,2}(?:[ ~][0-9]{3}(?![0-9]))+|[0-9][0-9.,]*[0-9]|[0-9])"
_OUTSIDE = re.compile(
    rf"({_FORMULA})(?P<sign>[ ~]*(?:[=≈<>≤≥])[ ~]*)(?P<number>{_NUMBER_OUTSIDE})"
    rf"(?:[ ~](?P<unit>{_UNIT}))?(?![\w$^]|[ ~][0-9]|[ ]?[-+−·×*/=(\\$])"
)
_SIGN = r"[ ~]*[=≈<>≤≥][ ~]*"
_SIDES_APART = re.compile(
    rf"{_FORMULA}(?:[ ~]?{_UNIT})?(?:{_SIGN}{_FORMULA}(?:[ ~]?{_UNIT}(?={_SIGN}))?){{1,6}}+"
)
_SIDE = re.compile(rf"(?P<formula>{_FORMULA})(?:[ ~]?(?P<unit>{_UNIT})(?={_SIGN}))?")
_PART_OF_UNIT = r"(?:1|[A-Za-zµμ]{1,6}\.?)(?:\^?[-−]?[1-4]|⁻?[¹²³⁴])?"
_UNIT_IN_PROSE = rf"{_PART_OF_UNIT}(?:[ ]?[/·⋅*‐‑-][ ]?{_PART_OF_UNIT}|[ ]{_PART_OF_UNIT}){{0,3}}"
_GOES_ON = re.compile(
    rf"(?<=[0-9}}])\$(?P<gap>[ ~]?)(?:(?P<unit>{_UNIT_IN_PROSE})(?P<space>[ ~]*))?"
    r"(?=(?P<sign>\$(?:\\[,;: ]|[ ~])*)?(?:[=≈<>≤≥]|\\(?:approx|le|ge)(?![A-Za-z])))"
)
_RESULT = re.compile(rf"[ ~]*[=≈][ ~]*[-−]?[0-9][0-9.,]*(?<=[0-9])(?:[ ~]?(?P<unit>{_UNIT_IN_PROSE}))?")
_OPERATION_BEHIND = re.compile(r"[\w$^]|[ ]?[-+−·×*/(\\$]|[ ]?[=≈]|[ ][A-Za-zα-ω](?![A-Za-z])")
"""What goes on with a formula behind a unit in prose, `$P = 8000$ lb $= 35.6$ kN`, `$…$ psi = 44 MPa`."""


Changes = dict[int, tuple[int, tuple[str | tuple[int, int], ...]]]
"""What is replaced, by where it begins: its end, and the texts and stretches put in its place."""


def with_units_between_dollars(text: str) -> Rewritten | None:
    r"""Return a text in which a formula goes on behind a unit in prose, None where none does.

    >>> with_units_between_dollars("so $P = 8000$ lb $= 35.6$ kN").text
    'so $P = 8000\\,\\mathrm{lb} = 35.6$ kN'
    >>> with_units_between_dollars("so $P/A = 6400$ psi = 44.1 MPa.").text
    'so $P/A = 6400\\,\\mathrm{psi} = 44.1 MPa.$'
    """
    rewriter = Rewriter(text)
    is_changed = False
    for match in _GOES_ON.finditer(text):
        start, unit = match.start(), match["unit"]
        is_known = unit is None or scale_of(unit.rstrip(".")) is not None
        if start < rewriter.place or not is_known or not _closes_relation(text, start):
            continue
        end = match.end() if match["sign"] else _end_of_results(text, match.end())
        if end == match.end() and not match["sign"]:
            continue
        is_changed = True
        set_unit = ("\\,\\mathrm{", match.span("unit"), "} ") if unit else (" ",)
        rewriter.replace(start, match.end() + len(match["sign"] or ""), *set_unit)
        if not match["sign"]:
            rewriter.replace(match.end(), end, (match.end(), end), "$")
    return rewriter.finish() if is_changed else None


def _end_of_results(text: str, place: int) -> int:
    """Return where `= 163 N·m = 0.163 kN m` ends, the place where nothing of the kind begins."""
    end = place
    while match := _RESULT.match(text, end):
        words = match["unit"] or ""
        ends = [len(words), *(m.start() for m in re.finditer(r"[ .]", words)), 0]
        length = next((n for n in sorted(ends, reverse=True) if scale_of(words[:n]) is not None), 0)
        stop = match.start("unit") + length if length else match.end() - len(words)
        end = stop if length else len(text[:stop].rstrip(" ~"))
    return place if end > place and _OPERATION_BEHIND.match(text, end) else end


def _closes_relation(text: str, place: int) -> bool:
    """Tell whether the dollar at a place closes a formula of its line that holds a relation."""
    line = text[max(place - 400, 0) : place].rpartition("\n")[2]
    return line.count("$") % 2 == 1 and RELATION.search(line.rpartition("$")[2]) is not None


_UNIT_AT_BAR = re.compile(
    rf"(?<=[0-9}}])\$[ ~]?(?P<unit>{_UNIT_IN_PROSE})(?P<bar>[ \t]*\|[ \t]*)"
    r"(?=\$?[ \t]*(?:=|≈|\\approx(?![A-Za-z])))"
)
"""A cell that ends in a unit, and the next one that goes on with it: $2\\cdot 3$ N | $= 6$ N."""
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
    changes: Changes = {}
    dollars, joined = _Dollars(text), set[int]()
    for match in _SIDES_APART.finditer(text):
        if dollars.opens(match.start()):
            changes |= _joints(text, *match.span())
            joined.add(match.start())
    for match in _OUTSIDE.finditer(text):
        start, end = match.span(1)
        if start in joined or RELATION.search(match[1]) or not dollars.opens(start):
            continue
        unit = match["unit"]
        tail = f"\\,\\mathrm{{{unit}}}$" if unit and unit not in "°%\\%" else f"{unit or ''}$"
        tail = "^{\\circ}$" if unit == "°" else tail.replace("%", "\\%") if unit == "%" else tail
        changes[start] = match.end(), ((start, end - 1), (end, match.end("number")), tail)
    _add_units_between(text, dollars, changes)
    place = 0
    while match := _SEQUENCE.search(text, place):
        if match.start() in joined or match.start() in changes or not dollars.opens(match.start()):
            first = _PART.match(text, match.start())
            place = first.end() - (first[1] is not None) if first else match.end()
            continue
        place = match.end()
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


def _add_units_between(text: str, dollars: _Dollars, changes: Changes) -> None:
    for match in _UNIT_BETWEEN.finditer(text):
        if match.start() not in changes and dollars.opens(match.start(1)):
            changes[match.end(1) - 1] = match.start("rest"), (_set_unit(match["unit"]),)
    for match in _UNIT_AT_BAR.finditer(text):
        if scale_of(match["unit"]) is not None:
            changes.setdefault(match.start(), (match.start("bar"), (f"{_set_unit(match['unit'])}$",)))


def _joints(text: str, start: int, end: int) -> Changes:
    """Return what joins the sides of `$2m$ = $3$ kg = $3000$`: their dollars go, units come inside."""
    joints: Changes = {}
    sides = list(_SIDE.finditer(text, start, end))
    for side, following in pairwise(sides):
        unit = (_set_unit(side["unit"]),) if side["unit"] else ()
        joints[side.end("formula") - 1] = following.start() + 1, (*unit, (side.end(), following.start()))
    return joints


def _set_unit(unit: str) -> str:
    """Return a unit of the prose as a formula has it."""
    unit = unit.strip().removeprefix("\\")
    return {"°": "^{\\circ}", "%": "\\%"}.get(unit, f"\\,\\mathrm{{{unit}}}")


def _ends_open(inside: str) -> bool:
    """Tell whether a formula ends with an operation that wants more."""
    bare = re.sub(r"(?:\\[,;: ]|\{\}|[ ~])+$", "", inside)
    return bare.endswith(("+", "-", "=", "\\cdot", "\\times", "\\approx"))


class _Dollars:
    """The single dollars of a text, to tell quickly what stands between them; $$ is none."""

    def __init__(self, text: str) -> None:
        self._spans = [match.span() for match in re.finditer(r"(?<![\\$])\$+", text)]
        self._starts = [start for start, _ in self._spans]
        self._counts = [0, *accumulate((end - start) % 2 for start, end in self._spans)]
        self._paragraphs = [match.end() for match in re.finditer(r"\n(?=\n)", text)]

    def opens(self, place: int) -> bool:
        """Tell whether a place stands outside the dollars of its paragraph."""
        paragraph = bisect_left(self._paragraphs, place)
        begin = self._paragraphs[paragraph - 1] if paragraph else 0
        first, last = bisect_left(self._starts, begin), bisect_left(self._starts, place)
        count = self._counts[last] - self._counts[first]
        if last > first and self._spans[last - 1][1] > place:  # of a row of dollars only those before it
            start, end = self._spans[last - 1]
            count += (place - start) % 2 - (end - start) % 2
        return count % 2 == 0
