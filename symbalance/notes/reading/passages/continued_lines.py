r"""Equations that go on in the next line: a line that begins with = continues the one above it.

cos t + cos(t + π)          the first side, which nothing marks as a formula
  = cos t − cos t
`M = a F − b F`             a line that ends with its formula,
`= (a − b) F`               and one that goes on with it
"""

from __future__ import annotations

from symbalance.notes.reading.signs import relation_at_start
from symbalance.notes.reading.sources import CELL_END
from symbalance.text import lazy_patterns as re

_MARKS = rf"\s$`*_{CELL_END}"
_OPENING = re.compile(rf"(?:[{_MARKS}&>]|\\\[|\\\(|\\displaystyle(?![A-Za-z])|\\begin\{{[a-z]+\*?\}})*")
_ENDED = re.compile(rf"(?:[{_MARKS},;&]|\\\]|\\\)|\\\\|\\end\{{[a-z]+\*?\}})*\Z")
_BETWEEN = re.compile(rf"(?:[{_MARKS},;&]|\\[][()]|\\\\|\\(?:end|begin)\{{[a-z]+\*?\}})*")
"""Marks between the end of a formula and a sign that goes on with it."""
_SHORT_UNIT = re.compile(r"(?<![A-Za-z])(?:lbs?|ft|in|oz|sec|min|hrs?|cwt|sq|cu|r\.?p\.?m|h\.?p|deg)$")
"""Units that are written with a point behind, which ends no sentence there."""
_IN_BRACKETS = re.compile(r"(?:[ \t$`]|\\\))*[ \t]\([ \t]*(?:\$|\\\(|`)?[ \t]*")
"""What stands before the second value of F = 4 kN (= 4000 N), the sign first in its brackets."""
MOST_LINE_ENDS = 2
"""Ends of lines between a formula and the = that goes on with it: one empty line."""
_EMPTY = re.compile(r"(?:[ \t]*\n){3,}")


_CELL_EDGE = re.compile(rf"(?:[ \t$`]|\\\))*(?:\||{CELL_END})")


def begins_with_relation(text: str, place: int) -> bool:
    r"""Tell whether the first sign behind a place, but for marks of a formula, is a relation.

    >>> begins_with_relation("a + b\n  $= c$", 5)
    True
    """
    opening = _OPENING.match(text, place)
    first = opening.end() if opening else place
    sign = relation_at_start(text[first : first + 20])
    return bool(sign) and not text.startswith(("=>", "==>", "->"), first)


def goes_on_below(text: str, end: int) -> bool:
    """Tell whether a formula that ends at a place ends its line, and the next begins with a relation.

    So it does where the next cell of its table begins with one: | cos 0° + cos 180° | = 0 |.
    """
    if (edge := _CELL_EDGE.match(text, end)) is not None and edge.end() < len(text):
        return begins_with_relation(text, edge.end())
    stop = text.find("\n", end)
    if stop < 0 or _ENDED.match(text[end:stop]) is None or _EMPTY.match(text, stop):
        return False
    return begins_with_relation(text, stop)


def goes_on_from(text: str, end: int, start: int) -> bool:
    r"""Tell whether nothing but marks and at most one empty line stands between two formulas.

    The point of a unit is no end: P = 9842 lbs. and below it = 4.39 tons.

    >>> goes_on_from("P = 9842 lbs.\n  = 4.39 t", 12, 16), goes_on_from("P = 9842.\n  = 4.39 t", 8, 12)
    (True, False)
    """
    between = text[end:start]
    if between[:1] == "." and _SHORT_UNIT.search(text, max(end - 12, 0), end):
        between = between[1:]
    if (edge := _CELL_EDGE.match(between)) is not None:
        between = between[edge.end() :]
    if _IN_BRACKETS.fullmatch(between):
        return True
    return between.count("\n") <= MOST_LINE_ENDS and _BETWEEN.fullmatch(between) is not None


def is_first_side(text: str, start: int, end: int) -> bool:
    """Tell whether what ends a line is the first side of an equation that goes on below.

    It has an operator or a function in it: a letter or a number alone may end any sentence.
    """
    return _OPERATION.search(text, start, end) is not None and goes_on_below(text, end)


_OPERATION = re.compile(r"(?<=[\w)}\]²³])\s*[-+−*·×/^]\s*[\w(\\√]|(?:sin|cos|tan|exp|√|Σ|∑)\s*[\w(\\]")
