"""Motions of one page count in one direction: beside v = rω (sin θ + ...) it is a = +rω² (cos θ + ...).

A velocity or an acceleration alone may be counted towards the crank or away from it. Where the page has
the one before, the other is its rate, with that sign. An inertia force has the sign of -m a only where
words say that forces and motions are counted in the same direction, or that it is opposite to the
acceleration where the page says which direction is positive; the size of a force has no sign.
"""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import (
    Call,
    Constant,
    Formula,
    Name,
    Number,
    Quotient,
    names,
    parts_of_kind,
)
from symbalance.document.letters import is_greek
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, UNDECIDED, Decision, without_dots
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.declared.symbol_roles import role_of
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.steps.judging_state import CountedMotion, JudgingState
from symbalance.notes.checking.verdicts import PROVED_WORDS, Verdict
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_ROLE = re.compile(
    r"is the (?:(?P<way>displacement from top dead centre|piston position)"
    r"|piston(?:'s)? (?:(?P<velocity>velocity)|(?P<acceleration>acceleration))"
    r"|(?P<force>inertia force)) \("
)
"""In an assumption: what a letter is taken to be."""
_DECLARED = {
    "piston acceleration": "acceleration",
    "piston velocity": "velocity",
    "inertia force": "force",
}
"""What a letter is declared as, where no words had to be taken for it."""
_OPPOSITE = re.compile(
    r"(?<![^\W\d_])(?:(?:opposite|opposed|contrary|counter)(?:\s+in\s+direction)?\s+(?:to\s+)?(?:that\s+of\s+)?(?:the\s+|its\s+)?(?:piston(?:'s)?\s+)?acceleration"
    r"|against\s+the\s+(?:piston(?:'s)?\s+)?acceleration"
    r"|(?:kolben)?beschleunigung\s+entgegen\w*|entgegen(?:gesetzt|gerichtet)?\s+(?:zu\s?)?(?:de[rm]|zur)\s+(?:kolben)?beschleunigung"
    r"|(?:opposée?s?|contraire)\s+à\s+(?:l['’]|cette\s+)accélération|(?:opposta|opposto|contraria|contrario)\s+all['’]\s?accelerazione"
    r"|(?:opuesta|opuesto|contraria)\s+a\s+la\s+aceleración|(?:en\s+)?sens\s+(?:inverse|contraire|opposé)\s+(?:de|à)\s+l['’]accélération)"
    r"|加速度(?:と|に|とは)(?:は)?(?:逆|反対)(?:の)?(?:向き|方向)",
    re.IGNORECASE,
)
"""Words by which an inertia force is against the acceleration."""
_POSITIVE = re.compile(
    r"(?<![^\W\d_])(?:positive|positiv|positif|positive[sn]?|positiv[ao]s?)(?![^\W\d_])|(?:を|が)正|正の?(?:向き|方向)|正と",
    re.IGNORECASE,
)
"""Words that say which direction is positive."""
_SIZE = re.compile(
    r"(?<![^\W\d_])(?:magnitude|size|amount|absolute|betrag\w*|größe|norme|module|intensité|modulo|intensità|módulo|magnitud"
    r"|amplitude|outwards?|positive\s+outwards?|away)(?![^\W\d_])|大きさ|振幅|絶対値|外向き",
    re.IGNORECASE,
)
"""Words for the mere size of a force, or for another direction that it counts in."""
_FOLLOWS = re.compile(
    r"(?<![^\W\d_])(?:therefore|thus|hence|then|so|differentiat\w+|deriv\w+|also|somit|daher|daraus|folglich|ableit\w+"
    r"|abgeleitet|donc|ainsi|d['’]où|dériv\w+|quindi|dunque|perciò|deriva\w+|luego|entonces|por\s+tanto)(?![^\W\d_])"
    r"|したがって|よって|ゆえに|微分",
    re.IGNORECASE,
)
"""Words by which one motion follows from the one before."""
_SAME_DIRECTION = re.compile(
    r"(?<![^\W\d_])(?:(?:the\s)?same\s(?:direction|sense|sign)|(?:der|die)?selben?\sRichtung|gleiche[rn]?\sRichtung|même\ssens"
    r"|stess[oa]\s(?:verso|direzione)|mismo\ssentido)(?![^\W\d_])|同じ(?:向き|方向)",
    re.IGNORECASE,
)
_DIRECTED = re.compile(
    r"(?<![^\W\d_])positiv\w*\s+(?:towards?|away|in|to|from|up|down|zur?|vo[mn]|nach|vers|verso|hacia|versol['’])"
    r"|(?:向きを|方向を)正|counted\s+(?:towards?|away)",
    re.IGNORECASE,
)
"""Words by which one of the motions has a direction of its own."""
_RATIOS = frozenset({"lambda", "rho", "epsilon", "kappa", "mu"})
_TENTH = Number(Fraction(1, 10))
_SHORT, _LONG = Number(Fraction(1)), Number(Fraction(10))
_LONGER = ("l", "L", "ell", "n")
"""Letters of the rod's length, or of its ratio to the crank."""
_NOUGHT, _QUARTER, _HALF = (
    Number(Fraction(0)),
    Quotient(Constant("pi"), Number(Fraction(2))),
    Constant("pi"),
)


_BEHIND = 60
"""Characters behind a motion or a force that may say how it is counted: positive outwards."""
_REACH = 240
"""Characters before a motion in which words say how it is counted."""


def unless_against_direction(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; refuted or open for a motion counted against the one before, else noted."""
    if k or verdict.verdict not in PROVED_WORDS or not (kind := _kind(state, chain, verdict)):
        return verdict
    line = chain.lines[0]
    sign = _sign(kind, without_dots(chain.sides[1].node)[0])
    text = state.document.text
    above = (
        [m for m in state.counted_motions if state.sections.same_section(m.line, line)] if sign else []
    )
    if kind == "force" and len({motion.sign for motion in above}) > 1:
        return verdict  # the page counts in both directions
    for motion in above:
        if motion.sign == sign or motion.start >= chain.start:
            continue
        words = text[max(0, motion.start - _REACH) : chain.start]
        if kind != "force" and _DIRECTED.search(f"{words} {text[chain.end : chain.end + _BEHIND]}"):
            continue
        is_told = _SAME_DIRECTION.search(words) is not None or _is_opposite(state, chain, words)
        if kind == "force" and not is_told:
            continue
        follows = kind == "force" or _FOLLOWS.search(text, motion.start, chain.start) is not None
        reason = f"line {motion.line} counts in the other direction"
        return describe(state.document, chain, k, Decision(REFUTED if follows else UNDECIDED, reason))
    if sign and kind != "force":
        state.counted_motions.append(CountedMotion(sign, chain.start, line))
    return verdict


def _kind(state: JudgingState, chain: Chain, verdict: Verdict) -> str:
    """Return whether a letter is a way, a velocity, an acceleration or a force, "" for none of them."""
    if match := _ROLE.search(verdict.assumption):
        return match.lastgroup or ""
    head = chain.sides[0].node
    declared = state.declarations.symbols_at(chain.lines[0])
    meaning = declared.get(head.name, "") if isinstance(head, Name) else ""
    return _DECLARED.get(role_of(meaning), "") if meaning else ""


def _is_opposite(state: JudgingState, chain: Chain, words: str) -> bool:
    """Tell whether the sentence of a force says it is against an acceleration, of known direction."""
    sentence = state.sections.sentence_leading_to(chain)
    sentence += state.document.text[chain.end : chain.end + _BEHIND].partition("\n\n")[0]
    is_own = _SIZE.search(sentence) or _POSITIVE.search(sentence)  # a direction of the force alone
    is_opposite = _OPPOSITE.search(sentence) is not None and not is_own
    return is_opposite and _POSITIVE.search(words) is not None


def _sign(kind: str, node: Formula) -> int:
    """Return the sign that a motion's first harmonic has where the way is counted from the crank.

    That is the sign of x(0) - x(π), of -v(π/2), of -a(0), and of the force at 0.
    """
    angles = {name for call in parts_of_kind(node, Call) for name in names(call.argument)}
    angles = {name for name in angles if is_greek(name) and name not in _RATIOS}
    if len(angles) != 1:
        return 0
    (angle,) = angles
    for name in sorted(names(node) - angles):
        size = _TENTH if name in _RATIOS else _LONG if name.partition("_")[0] in _LONGER else _SHORT
        node = substitute(node, name, size)
    places = {"way": (_NOUGHT, _HALF), "velocity": (_QUARTER,)}.get(kind, (_NOUGHT,))
    values = [number_of(substitute(node, angle, place), Knowledge()) for place in places]
    if any(value is None for value in values):
        return 0
    size = values[0] - values[1] if kind == "way" else values[0] if kind == "force" else -values[0]
    return (size > 0) - (size < 0)
