r"""Words set in a formula right behind a number, 6\,\text{daN}, which may be a unit or go on with it.

What they say belongs to the number: a unit that is not known, or an operation in words, \text{ plus two}.
The number is not read without them.
"""

from __future__ import annotations

from symbalance.document.wordlists import word_set
from symbalance.notes.reading.failures import ReadingError
from symbalance.notes.reading.passages.words_behind_numbers import says_multiple_of
from symbalance.notes.reading.units import scale_of
from symbalance.text import lazy_patterns as re

_SPACE = r"(?:\s|~|\\[,;:! ])*"
_SET = re.compile(
    rf"{_SPACE}\\(?:text|textrm|textnormal|mbox|mathrm|textit)\s*\{{(?P<words>[^{{}}$]{{1,60}})\}}(?P<power>\s*\^)?"
)
_JOINING = re.compile(
    r"(?:and\s+|und\s+)?(?:plus|minus|times|divided\s+by|multiplied\s+by|mal|geteilt\s+durch|fois|squared"
    r"|cubed|percent|per\s+cent|prozent|thousand|million|hundred|tausend|hundert)\b|[-+−*×·/^]",
    re.IGNORECASE,
)
_BEHIND = re.compile(
    rf"{_SPACE}(?:$|[.,;)\]=<>≈≤≥]|\\(?:approx|le|ge|simeq|quad|qquad|\\|end)(?![A-Za-z])|&)"
)
_UNIT_LIKE = re.compile(
    r"[^\W\d_]{0,4}[°µΩ²³/^·⁻][^\s]{0,8}|[^\W\d_]{1,2}|[^\W\d_]{1,4}[A-Z][A-Za-z]{0,3}\.?"
)
_WORDS = word_set(
    "a ab al an as at au az by c d da de di do du el en er es et ex go he ie if in is it la le lo me my"
    " na no nu ob of ok on or os ou où pf qu re se si so to ud un up us va vs wo y zu"
)
"""Short words of several languages that are no units."""


def doubt_of_words_set(text: str, start: int, end: int, limit: int) -> ReadingError | None:
    r"""Return why an equation that ends in a number is not whole without the words set behind it.

    >>> text = r"2 \cdot 3 = 6\,\text{daX}"
    >>> print(doubt_of_words_set(text, 0, 13, len(text)))
    at character 14: a unit that is not known: daX; give the value in SI units
    >>> doubt_of_words_set(r"2 \cdot 3 = 6\,\text{cylinders}", 0, 13, 31)
    """
    if not text[end - 1 : end].isdecimal() or (match := _SET.match(text, end, limit)) is None:
        return None
    words = " ".join(match["words"].replace("~", " ").split()).strip(" ,;:")
    if says_multiple_of(text, start, end, words):
        return None
    if _JOINING.match(words):
        return ReadingError(
            end, f"a formula that goes on in words: {words}", "write it in signs, or end it"
        )
    first, _, more = words.partition(" ")
    if more and first.lower() not in _WORDS and scale_of(first) is not None and scale_of(words) is None:
        return ReadingError(end, f"a unit with words: {words}", "set the unit apart from the words")
    is_last = match["power"] is not None or _BEHIND.match(text[match.end() : limit]) is not None
    is_unit = _UNIT_LIKE.fullmatch(words) is not None and words.lower() not in _WORDS
    if not is_last or not is_unit or scale_of(words) is not None or match["words"][-1:] in ",;:":
        return None
    return ReadingError(end, f"a unit that is not known: {words}", "give the value in SI units")
