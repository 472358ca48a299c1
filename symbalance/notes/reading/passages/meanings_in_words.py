r"""Letters that a page explains in words: m = recip mass, `ω` = angular speed, r = \text{crank radius}.

Such a line says what a letter means and claims nothing. A single letter, alone left of the sign, and
words of prose right of it are one; what has a number, an operation or letters in it is a formula.
"""

from __future__ import annotations

from collections.abc import Collection
from typing import NamedTuple

from symbalance.document.formula import Span
from symbalance.document.letters import FUNCTION_WORDS, GREEK_SIGN, NAME_OF_SIGN
from symbalance.document.wordlists import word_set
from symbalance.notes.reading.passages.prose import is_function_of_letter
from symbalance.notes.reading.sources import CELL_END
from symbalance.text import lazy_patterns as re

LONGEST_BEFORE = 60
"""Characters left of a sign in which the letter and its marks stand."""
LONGEST_MEANING = 120
_GREEK_COMMANDS = "|".join(sorted(GREEK_SIGN, key=len, reverse=True))
_SCRIPT = r"_\{[^{}\n]{1,20}\}|_[^\W_]{1,12}|[0-9]{1,2}|[₀-₉]{1,3}"
LETTER = rf"(?:\\(?:var)?(?:{_GREEK_COMMANDS})(?![A-Za-z])|[^\W\d_])(?:{_SCRIPT})?['′]?"
_MARK = rf"[\s$`*_~{CELL_END}\ue001\ue002]|\\[()]|</?[A-Za-z]{{1,6}}>|\[/?[A-Za-z]{{1,3}}\]"
_LETTER_BEFORE = re.compile(
    rf"(?:\A|(?<=[\s,;.:(|{CELL_END}\u3000-\u30ff])|(?<=\$|`|\*|>|\]|&)|(?<=\\\())"
    rf"(?P<letter>{LETTER})(?:{_MARK}|&){{0,12}}\Z"
)
_WHAT_STANDS_BEFORE = re.compile(r"(?P<word>[^\W\d_][\w'’]*)?(?P<sign>[^\w\s])?(?:\s)*\Z")
_SETTING_BEFORE = re.compile(
    r"(?:\\\\|\\begin\s?\{[^{}]{0,20}\}|\\(?:text|mathrm|mbox|textrm)\s?\{[^{}]{0,60}\}|\\q?quad|\\[\[,;:])[\s&$]*\Z"
)
"""What begins a row or parts one from the letter: a line break, words that are set, a wide space."""
_MARKS_LAST = re.compile(rf"(?:{_MARK}|&|-(?=\s))+\Z")
_OPENED = re.compile(
    rf"(?:{_MARK}|&){{0,12}}(?P<set>\\(?:text|mathrm|mathit|operatorname|mbox|textrm|textit)\s?\{{\s*)?"
)
_LETTER_AND_SIGN = re.compile(rf"{LETTER}\s*&?\s*(?:=|:=|\\equiv|\\triangleq|\\coloneqq)\s*&?\s*")
_SET_UPRIGHT = re.compile(
    rf"{_LETTER_AND_SIGN.pattern}\\(?:mathrm|mathit|operatorname)\s?"
    r"\{(?P<words>[A-Za-z](?:[A-Za-z~]|\\? ){3,80})\}\s*"
)
"""m = \\mathrm{mass} is no product of its letters."""
_SET_WORDS = re.compile(
    r"[\s&]*\\(?:text|mathrm|mbox|textrm|textit)\s?\{(?P<words>[^{}\n\\$]{2,120}?)[.,;]?(?:\([^(){}\n]{0,30}\))?\}"
    r"(?=\s*(?:[,;.&$)\]]|\\(?:[,;:!\\\])]|q?quad|end|text|tag|label|hfill)|\Z|\n))"
)
_ANY_MARKS = r"[$`*_ \ue000]{0,3}"
_PHRASE_END = re.compile(
    rf"[.,;:()\[\]{{}}|、。，；$\n=≈<>{CELL_END}\\]|\s[-–—]\s|\Z"
    rf"|\s(?:and|und|et|y|with|mit)\s+(?={_ANY_MARKS}\\?\w[\w{{}}]{{0,12}}{_ANY_MARKS}=)"
)
_WORD = re.compile(r"[^\W\d_][\w'’-]*")
_WORDS_ONLY = re.compile(r"[\w'’ /-]+")
_NUMBERED = re.compile(
    r"(?P<words>.*\s(?:of|at|for|in|on|from|to|von|am|an|im|bei|de|du)\s[^0-9]{3,40}\s)[0-9]{1,2}\Z"
)
"""Words that end with the number of a thing: displacement of piston 1."""
_SPOKEN = re.compile(r"[aeiouyAEIOUY]|[^\x00-\x7f]")
"""A word has a vowel, or no Latin letters: m r w without spaces is no word."""
_HALF_STROKE = re.compile(
    r"half (?:of )?(?:the )?(?:piston )?stroke|half-stroke|halber (?:Kolben)?hub", re.IGNORECASE
)
"""A crank's radius, whose name has a word of an operation."""
OPERATIONS = word_set(
    "plus minus times half twice double squared cubed over divided product sum mal durch halbe doppelte"
    " quarter third thirds tenth multiplied subtracted added"
)


class Meaning(NamedTuple):
    """Where a letter stands, the words that explain it, and where both end."""

    letter: Span
    words: Span
    end: int


def meaning_at(text: str, place: int, end: int, names: Collection[str]) -> Meaning | None:
    """Return the letter and the words around a sign at `place`, None where it explains no letter.

    >>> text = "with m = recip mass, r = throw"
    >>> found = meaning_at(text, 7, 8, ())
    >>> text[slice(*found.letter)], text[slice(*found.words)]
    ('m', 'recip mass')
    """
    letter = letter_before(text, place)
    opened = _OPENED.match(text, end, end + LONGEST_BEFORE)
    if letter is None or opened is None:
        return None
    start = opened.end()
    close = _PHRASE_END.search(text, start, start + LONGEST_MEANING)
    stop = close.start() if close else min(start + LONGEST_MEANING, len(text))
    stop = start + len(text[start:stop].rstrip(" \t`*_"))
    closing = text.find("}", stop, stop + LONGEST_BEFORE) if opened["set"] else stop - 1
    if closing < 0 or not is_meaning(text[start:stop], names):
        return None
    return Meaning(letter, (start, stop), closing + 1)


def is_explained_by_text(text: str, start: int, end: int) -> bool:
    r"""Tell whether a stretch is the beginning of m = \text{recip mass}: a letter and its sign.

    >>> text = r"m = \text{recip mass}, r = \text{ m}"
    >>> is_explained_by_text(text, 0, 3), is_explained_by_text(text, 23, 26)
    (True, False)
    """
    upright = _SET_UPRIGHT.fullmatch(text, start, end)
    if upright is not None:
        return is_meaning(upright["words"].replace("\\ ", " ").replace("~", " ").strip(), ())
    match = _LETTER_AND_SIGN.fullmatch(text, start, end)
    set_words = _SET_WORDS.match(text, end) if match else None
    return set_words is not None and is_meaning(set_words["words"].strip(), ())


def letter_before(text: str, place: int) -> Span | None:
    """Return the letter that stands alone left of a sign, None where more stands there."""
    first = max(place - LONGEST_BEFORE, 0)
    match = _LETTER_BEFORE.search(text, first, place)
    if match is None:
        return None
    before = text[first : match.start("letter")].rpartition("\n")[2]
    if _SETTING_BEFORE.search(before):
        return match.span("letter")
    before = _MARKS_LAST.sub(" ", before)
    last = _WHAT_STANDS_BEFORE.search(before)
    sign, word = (last["sign"], last["word"]) if last else (None, None)
    is_plain_word = word is None or (len(word) > 1 and word not in FUNCTION_WORDS)
    stands_alone = sign in (None, *',;.:(|"“„«、。，；-–—•') and (sign is not None or is_plain_word)
    is_number_before = sign is None and re.search(r"[\d)\]}]\s*\Z", before) is not None
    return match.span("letter") if stands_alone and not is_number_before else None


def is_meaning(phrase: str, names: Collection[str]) -> bool:
    """Tell whether a phrase is a meaning in words: no letters of formulas, numbers or operations."""
    if _HALF_STROKE.match(phrase) is not None:
        return True
    numbered = _NUMBERED.match(phrase)
    phrase = numbered["words"] if numbered else phrase
    own = _WORD.findall(phrase)
    if len(phrase) < 2 or not own or not is_word(own[0], names) or not _WORDS_ONLY.fullmatch(phrase):
        return False
    formula_words = OPERATIONS | set(FUNCTION_WORDS)
    if re.search(r"\d", phrase) or any(word.lower() in formula_words for word in own):
        return False
    if not (_SPOKEN.search(own[0]) or own[0].isupper()):
        return False  # mrw cos t is a product
    return any((len(word) > 2 and _SPOKEN.search(word)) or not word.isascii() for word in own)


def is_word(word: str, names: Collection[str]) -> bool:
    """Tell whether a run of letters is a word of prose and no letter or function."""
    if len(word) < 2 or not word[0].isalpha() or word in names or word in FUNCTION_WORDS:
        return False
    if word in ("pi",) or is_function_of_letter(word) or any(sign in NAME_OF_SIGN for sign in word):
        return False
    base = re.sub(r"[0-9'_]+$", "", word)
    return len(base) > 1 and base not in names and base not in FUNCTION_WORDS
