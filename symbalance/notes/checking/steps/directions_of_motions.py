"""Motions of one page count in one direction: beside v = rω (sin θ + ...) it is a = +rω² (cos θ + ...).

A velocity or an acceleration alone may be counted towards the crank or away from it. Where the page has
the one before, the other is its rate, with that sign. An inertia force has the sign of -m a only where
words say that forces and motions are counted in the same direction.
"""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import (
    Call,
    Constant,
    Formula,
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
_BEHIND = 60
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


_REACH = 240
"""Characters before a motion in which words say how it is counted."""


def unless_against_direction(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; refuted or open for a motion counted against the one before, else noted."""
    match = _ROLE.search(verdict.assumption)
    if k or match is None or verdict.verdict not in PROVED_WORDS:
        return verdict
    kind, line = match.lastgroup or "", chain.lines[0]
    sign = _sign(kind, without_dots(chain.sides[1].node)[0])
    text = state.document.text
    above = (
        [m for m in state.counted_motions if state.sections.same_section(m.line, line)] if sign else []
    )
    for motion in above:
        if motion.sign == sign or motion.start >= chain.start:
            continue
        words = text[max(0, motion.start - _REACH) : chain.start]
        if kind != "force" and _DIRECTED.search(f"{words} {text[chain.end : chain.end + _BEHIND]}"):
            continue
        if kind == "force" and not _SAME_DIRECTION.search(words):
            continue
        follows = kind == "force" or _FOLLOWS.search(text, motion.start, chain.start) is not None
        reason = f"line {motion.line} counts in the other direction"
        return describe(state.document, chain, k, Decision(REFUTED if follows else UNDECIDED, reason))
    if sign and kind != "force":
        state.counted_motions.append(CountedMotion(sign, chain.start, line))
    return verdict


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
