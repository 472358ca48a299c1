"""One shaft that runs backwards takes half of what swings: U b = (√3/2) m r a, not √3 m r a.

A force or a couple that swings in one plane is two of half its size, which turn with the crank and
against it. Where words say that one shaft runs against the crank and that half is meant, its formula has
half of the number that the swing has in the same letters further up. One with the whole is refuted.
"""

from __future__ import annotations

from fractions import Fraction
from math import sqrt

from symbalance.document.formula import Name, names
from symbalance.document.letters import plain_letter
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision, without_dots
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.meant.engines.engine_letters import EngineLetters, same
from symbalance.notes.checking.meant.engines.engine_resultants import EngineResultants
from symbalance.notes.checking.meant.engines.order_indices import wave_of
from symbalance.notes.checking.meant.meant_words import NOBODY
from symbalance.notes.checking.meant.products import (
    NoProductError,
    ProductOfPowers,
    product_of,
)
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_SHAFT = re.compile(
    r"(?<![A-Za-z])shaft|balancer|ausgleichswelle|\bwelle\b|\barbre|alber[oi]\b|\beje\b|バランサ|軸",
    re.IGNORECASE,
)
_BACKWARDS = re.compile(
    r"backwards?|(?:counter|contra)-?rotat|opposite\s+to\s+(?:the|its)\s+crank|against\W{1,3}the\s+crank"
    r"|rückwärts|gegenläufig|gegensinnig|sens\s+(?:inverse|contraire|opposé)|contro-?rotant|senso\s+(?:inverso|contrario)"
    r"|contrarrotante|sentido\s+contrario|逆(?:回り|回転|転|方向)",
    re.IGNORECASE,
)
_HALF = re.compile(
    r"\bhalf\b|\bhalves\b|½|\\[dt]?frac\s?\{?1\}?\s?\{?2\}?|1/2|hälfte|\bhalbe?[rnms]?\b|moitié|metà|mitad|半分",
    re.IGNORECASE,
)
_OTHERWISE = re.compile(
    r"(?:two|both|pair\s+of|2)\s+(?:[\w-]+\s+){0,2}shafts|shafts\b|wellen\b|\barbres|\balberi\b|\bejes\b"
    r"|[2２二両]\s?本|\btotal\b|together|zusammen|gesamt|insgesamt|合計|合わせ"
    r"|twice|double|doppelt|zweifach|2\s?倍|ensemble|insieme|instead|without|ohne\b|would",
    re.IGNORECASE,
)
"""Words for several shafts, for both weights together, or for twice the speed."""
_OF_SECOND = re.compile(r"[二2]\s?次|second|zweite[rnms]?\s|secondaire|segund[oa]", re.IGNORECASE)
"""Words for the second order, which a sentence further up may be about."""
_BLANK = re.compile(r"\n[^\S\n]*\n")
_NEAR, _FAR = 420, 900
"""Characters before a formula in which words name the shaft, and in which they say that half is meant."""
_SPEEDS = frozenset({"omega", "Omega", "w"})
_WHOLE = (1.0, sqrt(2.0), sqrt(3.0))
"""What swings over one cylinder's force, or that times the pitch: of one, a twin, a three."""


def decide_half_of_a_swing(
    resultants: EngineResultants, chain: Chain, k: int, knowledge: Knowledge
) -> Decision | None:
    """Return the decision on what a backward shaft takes; None where words or letters leave it open."""
    head = chain.sides[0].node
    is_known = isinstance(head, Name) and head.name in knowledge.letters
    if k or is_known or chain.relations[0].sign not in "=≈" or not _is_half_said(resultants, chain):
        return None
    own = _of_engine(resultants.letters, chain, knowledge)
    largest, line = (0.0, 0) if own is None else _largest_swing(resultants, chain, own, knowledge)
    if own is None or not any(same(largest, whole) for whole in _WHOLE):
        return None
    text = f"one shaft turns against the crank and takes half of what swings in line {line} ({NOBODY})"
    if same(abs(own.number), largest / 2, own.rounding):
        return Decision(PROVED, assumptions=(text,))
    is_whole = same(abs(own.number), largest, own.rounding)
    if is_whole and not _is_above(resultants, chain, own, knowledge):
        return Decision(REFUTED, f"if {text}: a factor 1/2 is missing")
    return None


def _is_half_said(resultants: EngineResultants, chain: Chain) -> bool:
    """Tell whether the words before a formula speak of one backward shaft, and of half."""
    text = resultants.words.document.text
    sections = resultants.sections
    floor = sections.start_of_line(sections.section_start(chain.lines[0]))
    near = text[max(floor, chain.start - _NEAR) : chain.start]
    is_of_shaft = _SHAFT.search(near) and _BACKWARDS.search(near) and not _OTHERWISE.search(near)
    is_of_shaft = is_of_shaft and not _OF_SECOND.search(" ".join(_BLANK.split(near)[-2:]))
    is_half = _HALF.search(text, max(floor, chain.start - _FAR), chain.start)
    return bool(is_of_shaft and is_half)


def _largest_swing(
    resultants: EngineResultants, chain: Chain, own: ProductOfPowers, knowledge: Knowledge
) -> tuple[float, int]:
    """Return the largest number that a swing above has in the letters of a formula, and its line."""
    numbers = [
        (abs(product.number), other.lines[0])
        for other in resultants.words.document.chains
        if other.relations and other.end <= chain.start
        for product in _swings(resultants.letters, other, knowledge)
        if product.powers == own.powers
    ]
    return max(numbers, default=(0.0, 0))


def _is_above(
    resultants: EngineResultants, chain: Chain, own: ProductOfPowers, knowledge: Knowledge
) -> bool:
    """Tell whether a line above in the section gives the shaft's letters the same number.

    What is solved from a wrong line follows from it.
    """
    section = resultants.sections.section_start(chain.lines[0])
    for other in resultants.words.document.chains:
        is_above = other.relations and other.end <= chain.start and other.lines[0] >= section
        if not is_above or not names(other.sides[0].node) & names(chain.sides[0].node) - _SPEEDS:
            continue
        before = _of_engine(resultants.letters, other, knowledge)
        if before is not None and (before.number, before.powers) == (own.number, own.powers):
            return True
    return False


def _of_engine(letters: EngineLetters, chain: Chain, knowledge: Knowledge) -> ProductOfPowers | None:
    """Return what a formula has of the engine: without speeds, and without the shaft's mass and arms."""
    head = chain.sides[0].node
    try:
        left, right = product_of(head), product_of(without_dots(chain.sides[1].node)[0])
        right = letters.expanded(right, head.name if isinstance(head, Name) else "", knowledge)
    except NoProductError:
        return None
    if left.wave is not None or right.wave is not None or not left.number:
        return None
    powers = {n: p for n, p in right.powers.items() if p > 0 and not _is_speed(n)}
    is_simple = all(p == 1 for p in (*powers.values(), *left.powers.values()) if p != 2)
    if not powers or not is_simple or powers.keys() & left.powers.keys():
        return None
    return ProductOfPowers(right.number / left.number, powers, None, right.rounding)


def _swings(letters: EngineLetters, chain: Chain, knowledge: Knowledge) -> list[ProductOfPowers]:
    """Return the sides of a line that are products with the square of a speed, without that."""
    found: list[ProductOfPowers] = []
    for side in chain.sides[1:]:
        try:
            product = letters.expanded(product_of(without_dots(side.node)[0]), "", knowledge)
        except NoProductError:
            continue
        speeds = [p for n, p in product.powers.items() if _is_speed(n)]
        is_first = product.wave is None or wave_of(product.wave)[0] in (0, 1)
        if speeds == [Fraction(2)] and is_first:
            rest = {n: p for n, p in product.powers.items() if not _is_speed(n)}
            found.append(ProductOfPowers(product.number, rest))
    return found


def _is_speed(name: str) -> bool:
    return name in _SPEEDS or plain_letter(name) == "ω"
