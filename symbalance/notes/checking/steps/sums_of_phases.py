"""Sums of one wave at several phases that are said to vanish: cos 2θ + cos(2θ + 360°) is not 0.

Who adds up the cylinders of an engine means every angle, whether or not the page has said what θ is. Such
a sum is one wave; said to be a number that it is not, it is wrong, unless words or what follows
look for the angle at which it is.
"""

from __future__ import annotations

from symbalance.document.formula import Call, Formula, Name, Negative, Number, Power, Product, Sum, names
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.meant.engines.order_indices import wave_of
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
    """Return a verdict; a sum of one wave at several phases is refuted as a number that it is not."""
    left, right = chain.sides[k], chain.sides[k + 1]
    if verdict.verdict not in (CONDITION, UNDECIDED) or chain.relations[k].sign != "=":
        return verdict
    angle = "" if names(right.node) else _angle_of_phases(left.node)
    if not angle or _is_looked_for(state, chain, angle):
        return verdict
    decision = decide(left, right, "=", Knowledge(SymbolValue()))
    if decision.status != REFUTED:
        return verdict
    state.definitions.forget_moment(right.node)
    reason = "the waves of these phases do not add up to that at every angle"
    return describe(state.document, chain, k, Decision(REFUTED, reason, witness=decision.witness))


def _angle_of_phases(node: Formula) -> str:
    """Return the angle of a sum of one order's waves at phases in numbers; "" for another formula."""
    terms = node.terms if isinstance(node, Sum) else ()
    waves = [_wave(term) for term in terms]
    calls = [wave for wave in waves if wave is not None]
    if len(calls) < 2 or len(calls) != len(waves) or len({wave.function for wave in calls}) != 1:
        return ""
    orders = {wave_of(wave) for wave in calls}
    has_phase = any(isinstance(wave.argument, Sum) for wave in calls)
    ((order, angle),) = orders if len(orders) == 1 else ((0, ""),)
    letters = {name for wave in calls for name in names(wave.argument)}
    return angle if order and has_phase and letters == {angle} else ""


def _wave(term: Formula) -> Call | None:
    """Return the sine or cosine that a term is, or a power of it, with a sign or a number before it."""
    bare = term.operand if isinstance(term, Negative) else term
    powers = bare.factors if isinstance(bare, Product) else (bare,)
    factors = [each.base if isinstance(each, Power) and names(each.base) else each for each in powers]
    waves = [each for each in factors if isinstance(each, Call) and each.function in _WAVES]
    others = [each for each in factors if not isinstance(each, Number)]
    return waves[0] if len(waves) == 1 and others == waves else None


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
