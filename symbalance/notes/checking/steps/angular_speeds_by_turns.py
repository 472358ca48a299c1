"""Angular speeds of a letter that words count in revolutions: for N revolutions a minute, ω = π N/30.

Nobody says what ω is in such a sentence, and everybody knows. Where words give N its revolutions and
their time, a multiple of N for ω is right or wrong by itself: wrong only by a factor that is usual, as
another one may be of a camshaft, or of a gear.
"""

from __future__ import annotations

import math
from fractions import Fraction

from symbalance.document.formula import (
    PI,
    Derivative,
    Formula,
    Name,
    Number,
    Product,
    Quotient,
    names,
    walk,
)
from symbalance.document.letters import plain_letter
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.algebra.tree_values import sample_trees
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.declared.symbol_roles import role_of
from symbalance.notes.checking.meant.engine_speeds import speeds_of
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.units.rounded_wholes import DIGITS_PRINTED
from symbalance.notes.checking.verdicts import DEFINITION, HOLDS, PREMISE, UNDECIDED, Verdict
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_REVOLUTIONS = r"(?:revolutions?|revs?\.?|turns|Umdrehungen|Umdr\.|tours|giri|vueltas|revoluciones)"
_EACH = r"\s*(?:/|per|an?|in\s+an?|each|every|pro|je|in\s+der|par|al|por)\s*"
_TIME = (
    r"(?:(?P<minute>min(?:uten?|ute|uto)?\b|min\.)"
    r"|(?P<second>s(?:ec(?:onds?)?|ekunde|econde|econdo|egundo)?\b))"
)
_COUNTED = re.compile(
    rf"(?<![^\W\d_\\])(?P<letter>[nN])\$?\s+(?:{_REVOLUTIONS}{_EACH}{_TIME}|(?P<rpm>r\.?\s?p\.?\s?m\b))"
    r"|毎(?P<minute_ja>分)\s*\$?(?P<letter_ja>[nN])\$?\s*回転",
    re.IGNORECASE,
)
"""A letter right before the revolutions that it counts."""
_OTHER = re.compile(
    r"cam|gear|whirl|natural|critical|resonan|excit|Eigen|Erreg|kritisch|固有|共振|half|twice|double|order|belt|wheel\s+of|ratio|Nocken|Getriebe|halb|doppelt|Ordnung|カム|歯車|次",
    re.IGNORECASE,
)
"""Words of another shaft, or of a multiple."""
_REACH = 240
"""Characters before a formula in which words count its letter."""
_NEAR_WORDS = 120
"""Characters before a number in which words name the speed that it is of."""
USUAL_FACTORS = (1 / 2, 2, 60, 1 / 60, 30, 1 / 30, 1 / math.pi, 1 / (2 * math.pi), math.pi, 2 * math.pi)
"""Factors by which who converts revolutions goes wrong."""
_NEAR, ROUNDED = 1e-3, 5e-3
"""Parts by which a coefficient, and a printed number, may be off."""
_AT = re.compile(
    r"[\s$a-z/^{}\\1⁻¹-]{0,14}?\s(?:at|bei|à|a|per|um)\s+[$\s]*(?:[nN]\s*=\s*)?[0-9][^,;.]{0,24}",
    re.IGNORECASE,
)
"""A speed right behind a number: at 3000 rpm."""
_JUDGED = (DEFINITION, PREMISE, UNDECIDED, HOLDS)


def by_turns_counted(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; that on ω = c N by words that count N, or on ω = 1300/60 at 1300 rpm."""
    head, claim = chain.sides[0].node, chain.sides[1].node
    if k or verdict.verdict not in _JUDGED or not isinstance(head, Name):
        return verdict
    declared = state.declarations.symbols_at(chain.lines[0]).get(head.name, "")
    if head.name not in ("omega", "Omega", "w") or (declared and role_of(declared) != "angular speed"):
        return verdict
    own = names(claim)
    beside = None if own else _of_speed_beside(state, chain)
    if beside is not None:
        return describe(state.document, chain, k, beside)
    if verdict.verdict == HOLDS or any(isinstance(part, Derivative) for part in walk(claim)):
        return verdict
    if not own:
        return _of_speed_in_words(state, chain, verdict)
    return verdict if len(own) > 1 or declared else _of_letter(state, chain, verdict, next(iter(own)))


def _of_letter(state: JudgingState, chain: Chain, verdict: Verdict, name: str) -> Verdict:
    """Return a verdict; that on a multiple of a letter that words count in revolutions."""
    head, claim = chain.sides[0].node, chain.sides[1].node
    counted = _counted(state, chain, name)
    if counted is None or not isinstance(head, Name):
        return verdict
    right = Quotient(Product((PI, Name(name))), Number(Fraction(30)))
    right = right if counted else Product((Number(Fraction(2)), PI, Name(name)))
    ratio = _ratio(claim, right, name)
    time = "minute" if counted else "second"
    text = f"{plain_letter(head.name)} is the angular speed of {plain_letter(name)} revolutions a {time}"
    if ratio is not None and math.isclose(ratio, 1, rel_tol=_NEAR):
        return describe(state.document, chain, 0, Decision(PROVED, assumptions=(text,)))
    if ratio is None or not any(math.isclose(ratio, f, rel_tol=_NEAR) for f in USUAL_FACTORS):
        return verdict
    reason = f"if {text}: that is {formula_text(right, plain=True)}"
    state.definitions.forget(head.name, chain.lines[0])
    return describe(state.document, chain, 0, Decision(REFUTED, reason))


def _of_speed_beside(state: JudgingState, chain: Chain) -> Decision | None:
    """Return the decision on ω = 314 rad/s by the one speed of its clause, "at 3000 rpm"; else None."""
    text, value = state.document.text, chain.sides[-1]
    before = re.split(r"[,;:.]\s|\n\n", text[max(0, chain.start - _NEAR_WORDS) : chain.start])[-1]
    behind = _AT.match(text, chain.end)
    words = (behind[0] if behind is not None else before).replace("$", "")
    speeds = speeds_of(words)
    number = number_of(value.node, state.knowledge(chain.lines[0]))
    is_lone = (
        len(chain.relations) == 1
        and "rad" in state.document.source(value.span) + text[chain.end : chain.end + 8]
    )
    if len(speeds) != 1 or not is_lone or not number or _OTHER.search(words):
        return None
    (speed,) = speeds
    ratio = float(number) / (math.pi * speed / 30)
    shown = f"{speed} revolutions a minute are {math.pi * speed / 30:.4g} rad/s"
    if math.isclose(ratio, 1, rel_tol=ROUNDED):
        return Decision(PROVED, shown, order=DIGITS_PRINTED)
    is_slip = any(math.isclose(ratio, f, rel_tol=ROUNDED) for f in USUAL_FACTORS)
    return Decision(REFUTED, shown) if is_slip else None


def is_of_another_shaft(words: str) -> bool:
    """Tell whether words name another shaft than the crank, or a multiple of its speed."""
    return _OTHER.search(words) is not None


def _of_speed_in_words(state: JudgingState, chain: Chain, verdict: Verdict) -> Verdict:
    """Return a verdict; refuted for ω = 1300/60 "at 1300 rpm", which are revolutions a second."""
    claim, text = chain.sides[1], state.document.text
    words = text[max(0, chain.start - _NEAR_WORDS) : chain.start]
    typed = state.document.source(claim.span)
    number = number_of(claim.node, state.knowledge(chain.lines[0]))
    if number is None or not number or _OTHER.search(words):
        return verdict
    for speed in speeds_of(words):
        ratio = float(number) / (math.pi * speed / 30)
        is_slip = any(math.isclose(ratio, f, rel_tol=_NEAR) for f in (1 / (2 * math.pi), 0.5, 60))
        if str(speed) in re.sub(r"[\s,.\\{}~]", "", typed) and is_slip:
            right = f"2 π {speed}/60 at {speed} revolutions a minute"
            state.definitions.forget("omega", chain.lines[0])
            return describe(state.document, chain, 0, Decision(REFUTED, f"an angular speed is {right}"))
    return verdict


def _counted(state: JudgingState, chain: Chain, name: str) -> bool | None:
    """Return whether words count a letter by the minute, or by the second; None where they do not."""
    text = state.document.text[max(0, chain.start - _REACH) : chain.end + _REACH // 2]
    near = text.partition("\n\n\n")[0]
    found = [m for m in _COUNTED.finditer(near) if name in (m["letter"], m["letter_ja"])]
    if not found or _OTHER.search(state.sections.sentence_before(chain)):
        return None
    by_minute = {bool(m["minute"] or m["rpm"] or m["minute_ja"]) for m in found}
    return by_minute.pop() if len(by_minute) == 1 else None


def _ratio(claim: Formula, right: Formula, name: str) -> float | None:
    """Return how many times another formula in one letter a formula is, None where that varies."""
    sizes = []
    for value in (3, 7):
        at = Number(Fraction(value))
        points = sample_trees(
            [substitute(claim, name, at), substitute(right, name, at)], SymbolValue(), 1
        )
        if not points or not points[0][1][1]:
            return None
        sizes.append(float(abs(points[0][1][0]) / abs(points[0][1][1])))
    return sizes[0] if math.isclose(sizes[0], sizes[1], rel_tol=_NEAR) else None
