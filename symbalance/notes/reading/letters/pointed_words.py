"""Abbreviations with points left of a relation: I.H.P. = 2 π N T/33000, Work per min. = 80 ft.-lb.

The letters of I.H.P. are one name; the points of other words would end the sentence right before its
equals sign. Behind a number they are units, and stay.
"""

from __future__ import annotations

from symbalance.notes.reading.letters.letter_names import letter_of_initials
from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.text import lazy_patterns as re

_INITIALS = re.compile(
    r"(?<![\w.])(?<![0-9][ ])(?:[A-Z]\.[ ]?){2,5}(?=[ \t]*(?:[=≈]|[×*/·+−][ \t]*[0-9A-Z(]))"
)
_BEHIND_OPERATOR = re.compile(
    r"(?<=[×*/·+−=(] )(?:[A-Z]\.){2,5}(?=[ \t]*(?:[×*/·+−=≈)\n]|$))", re.MULTILINE
)
_WORDS = re.compile(
    r"(?:^|(?<=[.;:] ))[ \t]*[A-Z][a-z]{1,15}\.?(?:[ ][A-Za-z]{2,15}\.?){0,7}[ \t]*(?=[=≈])", re.MULTILINE
)


def with_points_left_out(text: str) -> Rewritten | None:
    """Return a text with such abbreviations without their points, None where there are none.

    >>> with_points_left_out("I.H.P. = 3 and so on.\\nWork per min. = 2 × 40").text
    'I_{HP} = 3 and so on.\\nWork per min  = 2 × 40'
    """
    changes: dict[int, tuple[int, str]] = {}
    for pattern in (_INITIALS, _BEHIND_OPERATOR):
        for match in pattern.finditer(text):
            tail = " " if match[0].endswith(" ") else ""
            changes[match.start()] = (match.end(), f"{letter_of_initials(match[0])}{tail}")
    for match in _WORDS.finditer(text):
        for point in re.finditer(r"\.", match[0]):
            place = match.start() + point.start()
            if not any(start <= place < end for start, (end, _) in changes.items()):
                changes[place] = (place + 1, " ")
    if not changes:
        return None
    rewriter = Rewriter(text)
    for start, (end, written) in sorted(changes.items()):
        if start >= rewriter.place:
            rewriter.replace(start, end, written)
    return rewriter.finish()
