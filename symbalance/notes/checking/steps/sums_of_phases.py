"""Sums of one wave at several phases said to be what they are not: cos 2θ + cos(2θ + 360°) is not 0.

Who adds up the cylinders of an engine means every angle, whether or not the page has said what θ is. Such
a sum is one wave; said to be a number or another wave, it is wrong, unless words or what follows
look for the angle at which it is.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction

from symbalance.document.formula import (
    Call,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    names,
)
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.meant.engines.order_indices import wave_of
from symbalance.notes.checking.meant.products import NoProductError, product_of, terms_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONDITION, UNDECIDED, Verdict
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_WAVES = ("cos", "sin")
_BEFORE, _BEHIND = 120, 240
"""Characters before a sum and behind it in which the page may look for an angle."""
_LOOKS_FOR_ANGLE = re.compile(
    r"\b(?:where|when(?:ever)?|(?:at|for|find|which)\s+(?:(?:the|an|what|that)\s+)?angles?|angles?\s+(?:follows?|results?|is\s+given|are\s+given)|solv\w*|solution|roots?|deriv\w*|differentiat\w*|extrem\w*|maxim\w*|minim\w*"
    r"|large?st|greatest|smallest|stationary|condition|if|until|require\w*|vanish\w*\s+(?:at|for|when)|set(?:ting)?"
    r"|wo|wenn|(?:bei|für|beim|welche[mnrs]?)\s+(?:\w{3,6}\s+)?winkel\w*|winkel\s+(?:folgt|ergibt|erhält)|lös\w*|ableit\w*|nullstelle\w*|bedingung|größte\w*|kleinste\w*|setz\w*|dériv\w*|condition"
    r"|si|quand|lorsque|ángulo\w*|cuando|derivad\w*|condición|angolo|quando|derivat\w*|condizione)\b"
    r"|角|とき|場合|微分|条件|最大|最小|極",
    re.IGNORECASE,
)


def unless_phases_remain(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a sum of one wave at several phases is refuted as what it is not.

    Letters that are factors of all waves, and of the other side, play no part: no premise is needed.
    """
    left, right = chain.sides[k], chain.sides[k + 1]
    if verdict.verdict not in (CONDITION, UNDECIDED) or chain.relations[k].sign != "=":
        return verdict
    waves = _waves_of(left.node)
    if waves is None or not waves.are_phases(is_step=k > 0) or not _is_of_same_kind(waves, right.node):
        return verdict
    if waves.angle in state.knowledge(chain.lines[0]).definitions or _is_looked_for(
        state, chain, waves.angle
    ):
        return verdict
    decision = decide(left, right, "=", Knowledge(SymbolValue()))
    if decision.status != REFUTED:
        return verdict
    state.definitions.forget_moment(right.node)
    reason = "the waves of these phases do not add up to that at every angle"
    return describe(state.document, chain, k, Decision(REFUTED, reason, witness=decision.witness))


@dataclass(frozen=True, slots=True)
class _Waves:
    """The waves of a sum whose terms have the same letters as factors."""

    angle: str
    orders: frozenset[int]
    functions: frozenset[str]
    count: int
    powers: Mapping[str, Fraction]

    def are_phases(self, *, is_step: bool) -> bool:
        """Tell whether several waves are of one order: one wave, too, which a step may write as such."""
        is_one_function = len(self.functions) == 1 or is_step
        return self.count > 1 and len(self.orders) == 1 and is_one_function


def _is_of_same_kind(waves: _Waves, right: Formula) -> bool:
    """Tell whether a right side is a number, 0 if letters are factors, or waves of the same letters."""
    if not names(right):
        return not waves.powers or (isinstance(right, Number) and not right.value)
    own = _waves_of(right)
    return own is not None and own.angle == waves.angle and own.powers == waves.powers


def _waves_of(node: Formula) -> _Waves | None:
    """Return the waves that a formula adds up; None for another formula."""
    terms = [_wave_and_powers(term) for term in terms_of(node)]
    found = [term for term in terms if term is not None]
    if len(found) != len(terms) or any(powers != found[0][1] for _, powers in found):
        return None
    turning = {_wave_turning(call) for call, _ in found}
    angles = {angle for _, angle in turning}
    orders = frozenset(order for order, _ in turning)
    angle = angles.pop() if len(angles) == 1 else ""
    if not angle or 0 in orders or angle in found[0][1]:
        return None
    functions = frozenset(call.function for call, _ in found)
    return _Waves(angle, orders, functions, len(found), found[0][1])


def _wave_turning(wave: Call) -> tuple[int, str]:
    """Return n and θ of a wave of n θ + δ, and of n (θ + δ)."""
    terms = terms_of(wave.argument)
    return wave_of(replace(wave, argument=Sum(terms)) if len(terms) > 1 else wave)


def _wave_and_powers(term: Formula) -> tuple[Call, Mapping[str, Fraction]] | None:
    """Return the sine or cosine that a term has, or a power of it, and the letters that are factors."""
    bare = _without_sign(term)
    above = bare.numerator if isinstance(bare, Quotient) else bare
    factors = [_without_sign(f) for f in (above.factors if isinstance(above, Product) else (above,))]
    turning = [f.base if isinstance(f, Power) else f for f in factors]
    places = [
        place
        for place, each in enumerate(turning)
        if isinstance(each, Call) and each.function in _WAVES and names(each.argument)
    ]
    wave = turning[places[0]] if len(places) == 1 else None
    if not isinstance(wave, Call):
        return None
    others = (factor for place, factor in enumerate(factors) if place != places[0])
    rest: Formula = Product((Number(Fraction(1)), *others))
    rest = Quotient(rest, bare.denominator) if isinstance(bare, Quotient) else rest
    try:
        product = product_of(rest)
    except NoProductError:
        return None
    return None if product.wave is not None else (wave, product.powers)


def _without_sign(node: Formula) -> Formula:
    return node.operand if isinstance(node, Negative) else node


def _is_looked_for(state: JudgingState, chain: Chain, angle: str) -> bool:
    """Tell whether words around a sum look for an angle, or what follows gives the angle a value."""
    text = state.document.text
    around = (
        text[max(0, chain.start - _BEFORE) : chain.start] + text[chain.end : chain.end + _BEHIND // 2]
    )
    if _LOOKS_FOR_ANGLE.search(around):
        return True
    return any(
        0 <= other.start - chain.end < _BEHIND
        and other.relations
        and not names(other.sides[-1].node)
        and names(other.sides[0].node) == {angle}
        and (isinstance(other.sides[0].node, Name | Call))
        for other in state.document.chains
    )
