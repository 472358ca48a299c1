"""Ranges that a relation's sentence states in words: θ in the second quadrant, for negative a and b.

They are of that relation, as a condition in signs right behind it would be: nothing is confirmed there
on a condition that the words deny.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Constant, Formula, Name, Number, Product
from symbalance.document.text_writer import formula_text
from symbalance.notes.checking.deciding.inequalities import sample_ranges
from symbalance.notes.checking.deciding.knowledge import Knowledge, StatedRange
from symbalance.notes.checking.words.case_words import clause_before
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.text import lazy_patterns as re

_QUARTERS = {"first": 0, "second": 1, "third": 2, "fourth": 3, "1st": 0, "2nd": 1, "3rd": 2, "4th": 3,
             "ersten": 0, "zweiten": 1, "dritten": 2, "vierten": 3, "1.": 0, "2.": 1, "3.": 2, "4.": 3,
             "premier": 0, "deuxième": 1, "troisième": 2, "quatrième": 3,
             "一": 0, "二": 1, "三": 2, "四": 3, "1": 0, "2": 1, "3": 2, "4": 3}  # fmt: skip
_QUADRANT = re.compile(
    rf"[$)\s]{{0,3}}(?:(?:is|lies|liegt|est)\s+)?(?:in|im|within|dans|が|は)\s*(?:the\s+|le\s+)?第?"
    rf"(?P<which>{'|'.join(map(re.escape, sorted(_QUARTERS, key=len, reverse=True)))})"
    r"[\s-]*(?:quadrant|象限)",
    re.IGNORECASE,
)
_DEGREES = r"\$?\s*(?P<{}>-?[0-9]{{1,3}})\s*(?:\^?\s?\{{?\\circ\}}?|°|degrees?|Grad)?\$?"
_BETWEEN = re.compile(
    rf"[$)\s]{{0,3}}(?:(?:is|lies|liegt|est)\s+)?(?:between|zwischen|entre|tra)\s+{_DEGREES.format('least')}"
    rf"\s+(?:and|und|et|e|y)\s+{_DEGREES.format('most')}",
    re.IGNORECASE,
)
_NEGATIVE_BEHIND = re.compile(
    r"[$)\s]{0,3}(?:(?:and|und|et|,)\s*\$?\\?[A-Za-z]{1,6}\$?\s*)?(?:(?:is|are|ist|sind|est|sont)\s+)"
    r"(?:both\s+|beide\s+)?(?:negative?|négatifs?)(?![A-Za-z])|[$)\s]{0,3}が負",
    re.IGNORECASE,
)
_NEGATIVE_BEFORE = re.compile(
    r"(?<![\w-])(?<!\sor )(?<!\soder )(?<!\snot )(?<!\snicht )(?:negative[nrsm]?|négatifs?|負の)\s*"
    r"(?:(?:real|reelle[nr]?|numbers?|values?\s+of|Zahlen|nombres)\s+){0,2}"
    r"(?:\$?\\?[A-Za-z]{1,6}\$?\s*(?:,|and|und|et)\s*)?\$?\s*\\?$",
    re.IGNORECASE,
)
_NO_SIGN = re.compile(
    r"(?<![^\W\d_])(?:complex(?:\s+(?:numbers?|quantit(?:y|ies)|amplitudes?))?|vectors?|komplexe[nrs]?(?:\s+Zahl(?:en)?)?|Vektor(?:en)?"
    r"|(?:nombres?\s+)?complexes?|vecteurs?|複素数|ベクトル)\s*"
    r"(?:\$?\\?[A-Za-z]{1,6}\$?\s*(?:,|and|und|et|、|と)\s*)?\$?\s*\\?$",
    re.IGNORECASE,
)
"""Before a letter of what is neither positive nor negative."""
_MAY_STATE = re.compile(
    r"quadrant|象限|between|zwischen|entre|tra\s|negativ|négatif|負|comple|komplex|vec|vek|複素|ベクトル",
    re.IGNORECASE,
)
"""What words have that state a range, or that there is none: they are looked at before every relation."""
_DEGREE_MARK = re.compile(r"°|circ|degree|Grad", re.IGNORECASE)
_STRAIGHT = 180


def with_ranges_in_words(chain: Chain, document: ReadNotes, knowledge: Knowledge) -> Knowledge:
    """Return what is known with the ranges that the words before a relation state of its letters."""
    stated = tuple(_ranges_in_words(chain, document))
    if not stated:
        return knowledge
    drawn = sample_ranges(stated)
    meaning = replace(knowledge.meaning, ranges={**knowledge.meaning.ranges, **drawn})
    return replace(knowledge, meaning=meaning, ranges=(*stated, *knowledge.ranges))


def letters_without_sign(chain: Chain, document: ReadNotes) -> frozenset[str]:
    """Return the letters of a relation that the words before it call complex numbers or vectors."""
    words = clause_before(document.text, chain.start)
    return frozenset(n for n, start, _ in _mentions(chain, words) if _NO_SIGN.search(words[:start]))


def _ranges_in_words(chain: Chain, document: ReadNotes) -> Iterator[StatedRange]:
    words, line = clause_before(document.text, chain.start), chain.lines[0]
    for name, start, end in _mentions(chain, words):
        for sign, bound in _of_letter(words, start, end):
            yield StatedRange(Name(name), sign, bound, line, max(chain.lines))


def _mentions(chain: Chain, words: str) -> Iterator[tuple[str, int, int]]:
    """Yield where words that may state a range name the letters of a relation."""
    if _MAY_STATE.search(words) is None:
        return
    for name in sorted(chain.letters):
        plain = formula_text(Name(name), plain=True)
        ways = sorted({name, f"\\{name}", plain}, key=len, reverse=True)
        written = re.compile(rf"(?<![A-Za-z\\])(?:{'|'.join(map(re.escape, ways))})(?![A-Za-z0-9_])")
        for place in written.finditer(words):
            yield name, place.start(), place.end()


def _of_letter(words: str, start: int, end: int) -> Iterator[tuple[str, Formula]]:
    """Yield on which sides of which bounds words around a letter keep it."""
    quarter, between = _QUADRANT.match(words, end), _BETWEEN.match(words, end)
    if quarter is not None:
        first = 90 * _QUARTERS[quarter["which"].lower()]
        yield from ((">", _angle(first)), ("<", _angle(first + 90)))
    elif between is not None:
        is_angle = _DEGREE_MARK.search(between[0]) is not None
        bound = _angle if is_angle else _number
        yield from ((">", bound(int(between["least"]))), ("<", bound(int(between["most"]))))
    elif _NEGATIVE_BEHIND.match(words, end) or _NEGATIVE_BEFORE.search(words[:start]):
        yield "<", _number(0)


def _angle(degrees: int) -> Formula:
    return Product((Number(Fraction(degrees, _STRAIGHT)), Constant("pi"))) if degrees else _number(0)


def _number(value: int) -> Formula:
    return Number(Fraction(value))
