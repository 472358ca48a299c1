"""Words in brackets right behind a unit, 11.8 kN(上向き) or 40 mm(radius), set apart from it.

Pages in Japanese have no space there. Without one the unit and its bracket look like a function of a
letter, or like a product.
"""

from __future__ import annotations

from symbalance.document.letters import FUNCTION_WORDS, GREEK_SIGN
from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.notes.reading.spellings.numerals import sign_of_unit
from symbalance.text import lazy_patterns as re

_UNIT = r"[A-Za-zµμΩ°%][A-Za-zµμΩ·⋅*/²³⁴⁻¹^0-9.-]{0,11}(?:[ ](?:[cm]?m|s|kg|rad)[²³]?)?"
_BEHIND = re.compile(
    rf"(?<=[0-9])(?<!_[0-9])[ ~\u2009\u202f]?(?P<unit>{_UNIT})[(（](?P<words>[^()（）=\n]{{1,60}})[)）]"
)
_OF_SIGNS = re.compile("[\u3041-\u9fff]")
_WORD = re.compile(r"[^\W\d_]{2,}\.?")


def with_words_apart(text: str) -> Rewritten | None:
    """Return a text with a space between a unit and words in brackets, None where there are none.

    >>> with_words_apart("F = 11.8 kN(上向き), r = 40 mm(radius)").text
    'F = 11.8 kN (上向き), r = 40 mm (radius)'
    >>> with_words_apart("F = 12 kN（力）とする。").text
    'F = 12 kN （力）とする。'
    >>> with_words_apart("x = 2 m(sin a), y = 3 N(r + l), z = 2 m(beta)") is None
    True
    """
    places = [
        match.end("unit")
        for match in _BEHIND.finditer(text)
        if _are_words(match["words"], 3 if len(match["unit"]) == 1 else 2) and sign_of_unit(match["unit"])
    ]
    if not places:
        return None
    rewriter = Rewriter(text)
    for place in places:
        rewriter.replace(place, place, " ")
    return rewriter.finish()


def _are_words(text: str, fewest: int) -> bool:
    """Tell whether a text in brackets is of words alone, one of so many letters, and of no names."""
    if _OF_SIGNS.search(text):
        return True
    words = text.split()
    are_words = all(_WORD.fullmatch(word) for word in words)
    are_names = any(word.lower() in FUNCTION_WORDS or word in GREEK_SIGN for word in words)
    return are_words and not are_names and any(len(word) >= fewest for word in words)
