"""Relation signs of parts that nobody reads: a page's head in YAML, what a notebook's programs print.

They are no derivation, but nothing vanishes: each is counted, with its line and the reason.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator

from symbalance.notes.reading.accounting import relation_places
from symbalance.notes.reading.equations import Passed
from symbalance.notes.reading.markup.notebooks import OUTPUT
from symbalance.notes.reading.markup.page_marks import FRONT_MATTER
from symbalance.text import lazy_patterns as re

IN_HEAD = "in the head of the page"
IN_OUTPUT = "in what a program printed"
_FRONT = re.compile(FRONT_MATTER, re.MULTILINE)


def signs_left_aside(text: str, lines: Collection[int]) -> Iterator[Passed]:
    """Yield the signs of a page's head and of its programs' output; `lines` have signs that were read.

    >>> [p.line for p in signs_left_aside("---\\ntitle: E = m\\n---\\nx", ())]
    [2]
    """
    front = _FRONT.match(text)
    for place in relation_places(front.group()) if front else ():
        line = text.count("\n", 0, place) + 1
        if line not in lines:
            column = place - text.rfind("\n", 0, place)
            yield Passed(line, column, IN_HEAD, (place, place + 1))
    for match in OUTPUT.finditer(text):
        line = text.count("\n", 0, match.start()) + 1
        for _ in range(int(match["count"])):
            yield Passed(line, 1, IN_OUTPUT, match.span())
