"""Ranges that a relation's sentence states in words: θ in the second quadrant, for negative a and b.

They are of that relation, as a condition in signs right behind it would be: nothing is confirmed there
on a condition that the words deny. A quadrant or an obtuse angle that no letter is named with is that of
the one angle in the relation. What a sentence of its own says right before, "x is negative.", goes on.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Constant, Formula, Name, Number, Product, names
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra.letters_in_waves import letters_in_waves
from symbalance.notes.checking.deciding.inequalities import sample_ranges
from symbalance.notes.checking.deciding.knowledge import Knowledge, StatedRange
from symbalance.notes.checking.words.case_words import clause_before, clause_start
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.text import lazy_patterns as re

_QUARTERS = {"first": 0, "second": 1, "third": 2, "fourth": 3, "1st": 0, "2nd": 1, "3rd": 2, "4th": 3,
             "ersten": 0, "zweiten": 1, "dritten": 2, "vierten": 3, "1.": 0, "2.": 1, "3.": 2, "4.": 3,
             "premier": 0, "deuxième": 1, "troisième": 2, "quatrième": 3,
             "primo": 0, "secondo": 1, "terzo": 2, "quarto": 3,
             "primer": 0, "segundo": 1, "tercer": 2, "cuarto": 3,
             "一": 0, "二": 1, "三": 2, "四": 3, "1": 0, "2": 1, "3": 2, "4": 3}  # fmt: skip
_WHICH = (
    rf"(?P<which>{'|'.join(map(re.escape, sorted(_QUARTERS, key=len, reverse=True)))})"
    r"[\s-]*(?:quadrant|cuadrante|象限)"
)
_WHICH_OF_SIGNS = r"(?P<sign>[一二三四1234])"
_QUADRANT = re.compile(
    rf"[$)\s]{{0,3}}(?:(?:is|lies|liegt|est)\s+)?(?:in|im|within|dans|が|は)\s*(?:the\s+|le\s+)?第?{_WHICH}",
    re.IGNORECASE,
)
_QUADRANT_ALONE = re.compile(
    r"(?<![^\W\d_])(?<!not )(?<!nicht )(?<!pas )(?<!non )(?<!no )(?<!or )(?<!and )"
    r"(?:in|im|within|dans|nel|en)\s+"
    rf"(?:(?:the|le|el|il)\s+)?{_WHICH}|第{_WHICH_OF_SIGNS}象限",
    re.IGNORECASE,
)
_OBTUSE = re.compile(
    r"(?<![^\W\d_])(?:obtuse|stumpf\w*|obtus(?:e?s?|[oi]s?|as?)|ottus[oi])(?![^\W\d_])|鈍角",
    re.IGNORECASE,
)
_ACUTE = re.compile(
    r"(?<![^\W\d_])(?:acute|spitz\w*|aigu(?:s|ë|ës)?|acut[oi]|agud[oa]s?)(?![^\W\d_])|鋭角", re.IGNORECASE
)
_NOT = re.compile(
    r"(?<![^\W\d_])(?:not|non|nicht|kein\w*|pas|no|never|neither|or|oder|ou|ni|unless|except|außer)(?![^\W\d_])|ない|以外",
    re.IGNORECASE,
)
"""Words with which an obtuse angle may be what is not meant."""
_ANGLE = (
    r"(?P<{0}>[-−+]?\s*(?:\\frac\s*\{{\s*[0-9]{{0,2}}\s*(?:\\pi|π)?\s*\}}\s*\{{\s*[0-9]{{1,2}}\s*\}}"
    r"|[0-9]{{0,3}}(?:\.[0-9]{{1,4}})?\s*(?:\\pi|π)?(?:\s*/\s*[0-9]{{1,2}})?)\s*(?:°|\^\s*\{{?\s*\\circ\s*\}}?)?)"
)
_IN_INTERVAL = re.compile(
    r"[$)}\s]{0,3}(?:\\in(?![A-Za-z])|∈)\s*(?:\\left\s*)?[(\[\]]\s*"
    rf"{_ANGLE.format('from')}\s*[,;]\s*(?:\\[,;]\s*)?{_ANGLE.format('to')}\s*(?:\\right\s*)?[)\]\[]"
)
_PARTS = re.compile(
    r"(?P<sign>[-−+]?)\s*(?:\\frac\s*\{\s*)?(?P<number>[0-9]*(?:\.[0-9]+)?)\s*(?P<pi>\\pi|π)?\s*(?:\}\s*\{|/)?\s*"
    r"(?P<below>[0-9]+)?\s*\}?\s*(?P<degrees>°|\^.*)?"
)
_STATES = re.compile(
    r"[\s$>*-]*(?:(?:let|here|now|suppose|assume|sei|hier|nun|es\s+sei|soit|ici|sia|qui|sea|aquí|where)(?:\s+that)?\s+)?[\s$\\]*",
    re.IGNORECASE,
)
"""Before the letter of a sentence that only says where it lies."""
_ENDS_STATEMENT = re.compile(r"[\s$)}]*\.?[\s$]*")
_OTHERWISE = re.compile(
    r"(?<![^\W\d_])(?:for|if|when|where|in|positive|non-?negative|otherwise|instead|always|für|wenn|bei|falls|positiv\w*|sonst"
    r"|pour|si|quand|positif|per|se|positivo|para|cuando|general\w*|allgemein|any|every|all|with|mit)(?![^\W\d_])"
    r"|場合|とき|一般|正の|常に",
    re.IGNORECASE,
)
"""Words of a clause that may speak of other values than the sentence before it."""
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
_PLACE_BEHIND = re.compile(
    r"[\s$)}\],]{0,4}(?P<words>(?:also\s+|auch\s+|even\s+)?(?:in|im|within|dans|nel|en|for|for\s+an|für|pour)\s[^.,;:!?。=\n]{2,40})",
    re.IGNORECASE,
)
_DEGREES_BEHIND = re.compile(
    r"[\s$)}\],]{0,4}(?:holds\s+|gilt\s+)?(?:also\s+|even\s+|auch\s+|aussi\s+|anche\s+|también\s+)?"
    r"(?:(?P<beyond>beyond|above|past|jenseits\s+von|über|au-delà\s+de|oltre|más\s+allá\s+de)|at|for|bei|für|à|pour|a|per|en|para)\s+"
    r"\$?(?P<degrees>[0-9]{1,3})\s*(?:°|\^\s?\{?\\circ\}?|degrees?|Grad)\$?(?=\s*(?:[.,;。]|$|\n))",
    re.IGNORECASE,
)
"""An angle behind a relation, at which it is said to hold, or from which on."""
_RIGHT = 90
_MAY_STATE = re.compile(
    r"quadrant|cuadrante|象限|between|zwischen|entre|tra\s|negativ|négatif|負|comple|komplex|vec|vek|複素|ベクトル"
    r"|∈|\\in(?![A-Za-z])|obtus|stumpf|ottus|鈍角|acute|spitz|aigu|acut|agud|鋭角",
    re.IGNORECASE,
)
"""What words have that state a range, or that there is none: they are looked at before every relation."""
_DEGREE_MARK = re.compile(r"°|circ|degree|Grad", re.IGNORECASE)
_STRAIGHT = 180
_BACK = 2
"""Characters that part two sentences."""


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
    stated = [
        (name, sign, bound)
        for name, start, end in _mentions(chain, words)
        for sign, bound in _of_letter(words, start, end)
    ]
    stated += [] if stated else list(_of_one_angle(chain, words))
    stated += [] if stated else list(_of_one_angle(chain, _words_behind(chain, document)))
    stated += [] if stated else list(_of_degrees_behind(chain, document))
    stated += [] if stated else list(_of_sentence_before(chain, document, words))
    for name, sign, bound in stated:
        yield StatedRange(Name(name), sign, bound, line, max(chain.lines))


def _of_one_angle(chain: Chain, words: str) -> Iterator[tuple[str, str, Formula]]:
    """Yield the bounds of a relation's only angle by words without a letter: in the second quadrant."""
    if _MAY_STATE.search(words) is None:
        return
    angles = {name for side in chain.sides for name in letters_in_waves(side.node)}
    if len(angles) != 1:
        return
    (angle,) = angles
    first = quarter_named(words)
    if first is not None:
        yield from ((angle, ">", _angle(first)), (angle, "<", _angle(first + 90)))


def _words_behind(chain: Chain, document: ReadNotes) -> str:
    """Return the words right behind a relation that say where its angle lies: in the second quadrant."""
    match = _PLACE_BEHIND.match(document.text, chain.end)
    return "" if match is None else match["words"]


def _of_degrees_behind(chain: Chain, document: ReadNotes) -> Iterator[tuple[str, str, Formula]]:
    """Yield the bounds of a relation's only angle by a number behind it: at 120°, also beyond 90°."""
    match = _DEGREES_BEHIND.match(document.text, chain.end)
    if match is None or not all(names(side.node) for side in chain.sides):
        return
    angles = {name for side in chain.sides for name in letters_in_waves(side.node)}
    if len(angles) != 1:
        return
    (angle,) = angles
    degrees = int(match["degrees"])
    if match["beyond"]:
        yield from ((angle, ">", _angle(degrees)), (angle, "<", _angle(degrees + _RIGHT)))
    else:
        near = 2  # a function of it keeps its sign that near, and the interval has points
        yield from ((angle, ">", _angle(degrees - near)), (angle, "<", _angle(degrees + near)))


def quarter_named(words: str) -> int | None:
    """Return at how many degrees the quarter of a turn begins that words name, None for none.

    >>> quarter_named("in the third quadrant"), quarter_named("is obtuse, hence"), quarter_named("so")
    (180, 90, None)
    """
    quarters = list(_QUADRANT_ALONE.finditer(words))
    is_obtuse, is_acute = _OBTUSE.search(words) is not None, _ACUTE.search(words) is not None
    if len(quarters) == 1:
        return 90 * _QUARTERS[(quarters[0]["which"] or quarters[0]["sign"]).lower()]
    if is_obtuse != is_acute and not quarters and _NOT.search(words) is None:
        return 90 if is_obtuse else 0
    return None


def _of_sentence_before(
    chain: Chain, document: ReadNotes, words: str
) -> Iterator[tuple[str, str, Formula]]:
    """Yield what the sentence right before a relation's own says of a letter, and nothing else."""
    start = clause_start(document.text, chain.start)
    before = clause_before(document.text, max(start - _BACK, 0))
    before = document.text[max(start - _BACK, 0) - len(before) : start]
    if _OTHERWISE.search(words) or "\n\n" in before[-3:] or not _MAY_STATE.search(before):
        return
    for name, first, last in _mentions(chain, before):
        if _STATES.fullmatch(before, 0, first) is None:
            continue
        for way in (_QUADRANT, _BETWEEN, _NEGATIVE_BEHIND, _IN_INTERVAL):
            match = way.match(before, last)
            if match is not None and _ENDS_STATEMENT.fullmatch(before, match.end()):
                yield from ((name, *bound) for bound in _of_letter(before, first, last))


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
    elif (interval := _IN_INTERVAL.match(words, end)) is not None:
        bounds = [_bound(interval[end]) for end in ("from", "to")]
        yield from ((s, b) for s, b in zip("><", bounds, strict=True) if b is not None)
    elif _NEGATIVE_BEHIND.match(words, end) or _NEGATIVE_BEFORE.search(words[:start]):
        yield "<", _number(0)


def _bound(written: str) -> Formula | None:
    """Return the end of an interval, 3\\pi/2, 90° or -1; None where nothing is written."""
    parts = _PARTS.fullmatch(written.strip())
    if parts is None or not (parts["number"] or parts["pi"]):
        return None
    size = Fraction(parts["number"] or 1) / Fraction(parts["below"] or 1)
    size = -size if parts["sign"] in ("-", "−") else size
    if parts["degrees"]:
        size /= _STRAIGHT
    is_angle = parts["pi"] or parts["degrees"]
    return Product((Number(size), Constant("pi"))) if is_angle and size else Number(size)


def _angle(degrees: int | Fraction) -> Formula:
    return Product((Number(Fraction(degrees) / _STRAIGHT), Constant("pi"))) if degrees else _number(0)


def _number(value: int) -> Formula:
    return Number(Fraction(value))
