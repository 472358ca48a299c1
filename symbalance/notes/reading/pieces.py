"""A stretch of mathematics to single equations: rows, separators, tags, punctuation."""

from __future__ import annotations

import re
from dataclasses import dataclass

from symbalance.document.letters import WORDS
from symbalance.document.wordlists import word_set
from symbalance.notes.reading.regions import ENVIRONMENTS
from symbalance.notes.reading.signs import RELATION_COMMANDS, RELATION_SIGNS
from symbalance.notes.reading.units import follows_number, scale_of, unit_set_at

_WORDS = "|".join(sorted(WORDS | {"intertext", "shortintertext"}, key=len, reverse=True))
_ROW = re.compile(
    r"\\(begin|end)\s*\{([A-Za-z]*)\*?\}|\\\\(?:\*?[ \t]*\[[^\]\n]{0,20}\])?|\\.|[{}&]", re.DOTALL
)
_PIECE = re.compile(
    rf"\\(?:{_WORDS})\s*(?=\{{)|\\q?quad(?![A-Za-z])|\\[A-Za-z]+|\\.|[{{}}()\[\],;、，∴⇒]", re.DOTALL
)
_ARROWS = ("\\therefore", "\\Rightarrow", "\\implies", "\\Longrightarrow", "∴", "⇒")
_RELATION = re.compile(
    r"\\(?:" + "|".join(sorted(RELATION_COMMANDS, key=len, reverse=True)) + r")(?![A-Za-z])|["
    + re.escape("".join(set(RELATION_SIGNS) - set("=<>"))) + r"]|=(?!>)|<(?!-)|(?<![-=])>|(?<=\s)~(?=\s)"
)  # fmt: skip
_SCAN = re.compile(rf"{_RELATION.pattern}|\\[A-Za-z]+|\\.|[{{}}()\[\]]", re.DOTALL)
_TAG = re.compile(
    r"(?:\\tag\*?\s*\{([^{}]{1,20})\}|\\(?:l|r)?eqno\s*\(([^()]{1,12})\)"
    r"|(?P<lead>\\q?quad|\\hfill|\\hspace\*?\{[^{}]*\}|\\cdots|\\dots|\\ldots|…+|\.{3,}|[・･]{3,}|⋯|\s{2,}|\t)"
    r"\s*(?:\\q?quad\s*)*[-–—−]?\s*\((?P<tag>[0-9A-Za-z.\-']{1,8})\))\s*$"
)
_TRAILING = re.compile(
    r"(?:\s|[.,;。、&]|\\end\s*\{[A-Za-z]*\*?\}|\\[,;:! ]|\\q?quad|\\nonumber|\\notag"
    r"|\\label\s*\{[^{}]*\}|\\\\|\\hfill)$"
)
_BOXED = re.compile(r"\\(?:boxed|fbox|framebox)\s*\{")
_ALIGNED = word_set("align aligned alignat alignedat flalign")
_BRACKETS = {"{": 1, "(": 1, "[": 1, "}": -1, ")": -1, "]": -1}


@dataclass(frozen=True, slots=True)
class Piece:
    """One equation, or a part of one, from `start` to `end`; `row` counts the rows of its display."""

    start: int
    end: int
    tag: str = ""
    row: int = 0


def pieces_of(text: str, start: int, end: int, environment: str = "") -> list[Piece]:
    """Cut a stretch of mathematics into rows and these at separators."""
    found: list[Piece] = []
    for row, (first, end_of_row) in enumerate(_rows(text, start, end, environment)):
        last, tag = without_tag(text, first, end_of_row)
        spans = [_unboxed(text, *trimmed(text, *span)) for span in _separate(text, first, last)]
        spans = [span for span in spans if span[0] < span[1]]
        if len(spans) > 1:
            spans = [span for span in spans if has_any_relation(text, *span)] or spans[:1]
        for place, (left, right) in enumerate(spans):
            found.append(Piece(left, right, tag if place == len(spans) - 1 else "", row))
    return found


def _unboxed(text: str, start: int, end: int) -> tuple[int, int]:
    """Return what stands in a frame, \\boxed{...}, where that is the whole span."""
    found = _BOXED.match(text, start, end)
    if not found or text[end - 1] != "}" or _after_words(text, found.end() - 1, end) != end:
        return start, end
    return trimmed(text, found.end(), end - 1)


def _rows(text: str, start: int, end: int, environment: str) -> list[tuple[int, int]]:
    rows: list[tuple[int, int]] = []
    cells, first, depth = [start], start, 0
    aligned = environment in _ALIGNED
    for found in [*_ROW.finditer(text, start, end), None]:
        sign = found.group() if found else "\\\\"
        if sign.startswith("\\\\") and (depth <= 0 or not found):
            stop = found.start() if found else end
            rows.extend(_cells(cells, stop) if aligned else [(first, stop)])
            first = found.end() if found else end
            cells, depth = [first], 0
        elif sign == "&" and depth <= 0 and found:
            cells.append(found.end())
        elif found and found.group(1):
            known = found.group(2) in ENVIRONMENTS
            aligned = aligned or found.group(2) in _ALIGNED
            depth += 0 if known else (1 if found.group(1) == "begin" else -1)
        else:
            depth += {"{": 1, "}": -1}.get(sign, 0)
    return rows


def _cells(cells: list[int], stop: int) -> list[tuple[int, int]]:
    """Join the columns of an aligned row in pairs: left and right of an alignment point."""
    starts = cells[::2] if len(cells) > 2 else cells[:1]
    return list(zip(starts, [*starts[1:], stop], strict=True))


def _separate(text: str, start: int, end: int) -> list[tuple[int, int]]:
    """Cut at prose, and at commas and wide spaces where an equation of its own follows."""
    cuts: list[tuple[int, int, bool]] = []
    depth, place = 0, start
    while found := _PIECE.search(text, place, end):
        sign, place = found.group(), found.end()
        depth = max(depth + _BRACKETS.get(sign, 0), 0)
        if depth:
            continue
        if unit := _unit_at(text, start, found.start(), end):
            place = unit
        elif sign.rstrip().lstrip("\\") in WORDS | {"intertext", "shortintertext"}:
            place = _after_words(text, place, end)
            cuts.append((found.start(), place, True))
        elif sign in (",", ";", "、", "，", "\\quad", "\\qquad") or sign in _ARROWS:
            last = cuts[-1] if cuts else (start, start, True)
            introduces = sign in _ARROWS and last[2] and not text[last[1] : found.start()].strip(" \t\n&")
            cuts.append((found.start(), found.end(), introduces))
    return _joined(text, start, end, cuts)


def _unit_at(text: str, start: int, place: int, end: int) -> int:
    """Return where a unit such as \\text{mm} behind a number ends, 0 where it is none."""
    if text[place] != "\\" or not follows_number(text, start, place):
        return 0
    found = unit_set_at(text, place, end)
    return found[1] if found and scale_of(found[0]) else 0


def _after_words(text: str, place: int, end: int) -> int:
    depth = 0
    for at in range(place, end):
        depth += {"{": 1, "}": -1}.get(text[at], 0)
        if depth == 0:
            return at + 1
    return end


def _joined(text: str, start: int, end: int, cuts: list[tuple[int, int, bool]]) -> list[tuple[int, int]]:
    """Cut where what follows is an equation of its own; a label before a wide space is dropped."""
    spans: list[tuple[int, int]] = []
    first, before, cut = start, start, start
    for at, after, prose in [*cuts, (end, end, True)]:
        if before > first and _stands_alone(text, before, at):
            if has_relation(text, first, cut):
                spans.append((first, cut))
                first = before
            elif text[cut] == "\\":
                first = before
        if prose:
            spans.append((first, at))
            first = after
        before, cut = after, at
    return spans


def _stands_alone(text: str, start: int, end: int) -> bool:
    begin = text[start:end].lstrip()
    if not begin or begin[0] in "+-−=<>" or _RELATION.match(begin):
        return False
    return has_relation(text, start, end)


def has_any_relation(text: str, start: int, end: int) -> bool:
    """Tell whether a relation stands anywhere."""
    return _RELATION.search(text, start, end) is not None


def has_relation(text: str, start: int, end: int) -> bool:
    """Tell whether a relation stands outside all brackets."""
    depth = 0
    for found in _SCAN.finditer(text, start, end):
        sign = found.group()
        if sign in _BRACKETS:
            depth += _BRACKETS[sign]
        elif depth <= 0 and _RELATION.fullmatch(sign):
            return True
    return False


def relation_at_start(text: str) -> str:
    """Return the relation a text begins with, "" if none."""
    found = _RELATION.match(text)
    if not found:
        return ""
    sign = found.group()
    return RELATION_COMMANDS[sign[1:]] if sign[0] == "\\" else RELATION_SIGNS.get(sign, "≈")


def without_tag(text: str, start: int, end: int) -> tuple[int, str]:
    """Return where an equation ends before its number, and the number.

    >>> without_tag(r"a = b \\quad - (1)", 0, 17)
    (6, '1')
    """
    while start < end and text[end - 1] in " \t\n,.;" and text[max(start, end - 3) : end] != "...":
        end -= 1
    offset = max(start, end - 120)
    found = _TAG.search(text[offset:end])
    if not found:
        return end, ""
    stop = offset + found.start()
    tag = found.group(1) or found.group(2) or found.group("tag")
    lead = found.group("lead") or ""
    if lead.strip() and not lead.startswith(("\\q", "\\h")):
        before = text[start:stop].rstrip()
        if before[-1:] in "+-−·*/=" or not before:
            stop += len(lead)
    elif (
        lead and not lead.strip() and not tag.rstrip("abc'").replace(".", "").replace("-", "").isdecimal()
    ):
        return end, ""
    return stop, tag


def trimmed(text: str, start: int, end: int) -> tuple[int, int]:
    """Return a span without the space and punctuation at its edges."""
    while start < end and (text[start].isspace() or text[start] in "、。,;"):
        start += 1
    while start < end:
        if text[max(start, end - 3) : end] == "..." or text[end - 1] == "…":
            break
        found = _TRAILING.search(text[max(start, end - 80) : end])
        if not found:
            break
        end -= len(found.group())
    return start, end
