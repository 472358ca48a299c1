"""Where the crank angle counts from: θ = 0 at top dead centre is no case that the lines below are about.

A rate in letters holds for every angle, whatever number the angle has above: ẋ = rω(sin θ + ...) is not
proved by θ = 0. So does a relation between two sides that both change with the angle, where the words
beside the number say that it is the origin.
"""

from __future__ import annotations

from symbalance.document.formula import Call, Derivative, Formula, Name, names, parts_of_kind
from symbalance.document.letters import is_greek
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_DEAD_CENTRE = (
    r"(?:(?:the|its|dem|der|le|el|il|au|al)\s)?(?:(?:top|upper|inner|outer|bottom|lower|oberen?|unteren?|inneren?)\s)?"
    r"(?:TDC|BDC|OT|UT|PMH|PMB|PMS|PMI|dead[\s-](?:cent(?:re|er)|point)|Totpunkt|Totlage|point\smort|punto\smort?o|punto\smuerto"
    r"|there\b|dort\b|là\b)"
)
_AT_BEHIND = re.compile(rf"\$?\)?[,;]?\s(?:at|in|im|am|au|à|en|al|nel)\s{_DEAD_CENTRE}", re.IGNORECASE)
"""Behind the number: θ = 0 at TDC."""
_AT_BEFORE = re.compile(
    r"(?:TDC|BDC|OT|UT|PMH|PMB|PMS|PMI|dead[\s-](?:cent(?:re|er)|point)|Totpunkt|Totlage|point\smort[^.;]{0,9}|上死点|下死点)"
    r"(?:\s?(?:for|is|where|with|by|bei|für|ist|mit|pour|avec|per|con|para)|[はでをにが]|\s?\(|,)?\s?\$?\\?\(?$",
    re.IGNORECASE,
)
"""Before the angle: from TDC (θ = 0), 上死点で θ = 0."""
_BEFORE, _BEHIND = 40, 40


def letters_of_every_angle(state: JudgingState, chain: Chain, k: int) -> frozenset[str]:
    """Return the angles of a relation whose number above is not meant: it holds for all of them."""
    left, right = chain.sides[k].node, chain.sides[k + 1].node
    values = state.definitions.values
    both = names(left) | names(right)
    angles = [
        n for n in sorted(both) if is_greek(n) and any(e.definition.numeric for e in values.get(n, ()))
    ]
    if not angles or not names(left) or not names(right):
        return frozenset()
    has_rate = any(True for side in (left, right) for _ in parts_of_kind(side, Derivative))
    found = {angle for angle in angles if has_rate and _is_turned(angle, left, right)}
    rest = [angle for angle in angles if angle not in found and _is_turned(angle, left, right)]
    if rest:
        knowledge = state.knowledge(chain.lines[0])
        moves = [n for n in rest if all(_moves(side, n, state, knowledge) for side in (left, right))]
        found.update(angle for angle in moves if _is_origin(state, angle, chain))
    return frozenset(found)


def _is_turned(angle: str, left: Formula, right: Formula) -> bool:
    """Tell whether a sine or the like of an angle stands in a relation."""
    return any(angle in names(call) for side in (left, right) for call in parts_of_kind(side, Call))


def _moves(node: Formula, angle: str, state: JudgingState, knowledge: Knowledge) -> bool:
    """Tell whether a side changes with an angle: by itself, or by what lines above say of its letters."""
    if angle in names(node) or any(True for _ in parts_of_kind(node, Derivative)):
        return True
    formulas = knowledge.formulas
    by_formula = any(angle in names(formulas[n].node) for n in names(node) if n in formulas)
    return by_formula or any(
        angle in premise.names and not names(node).isdisjoint(premise.names)
        for premise in state.definitions.premises
    )


def _is_origin(state: JudgingState, angle: str, chain: Chain) -> bool:
    """Tell whether words say of an angle's number above that the angle counts from there."""
    text = state.document.text
    return any(
        _AT_BEHIND.match(text, above.end, above.end + _BEHIND)
        or _AT_BEFORE.search(text, max(0, above.start - _BEFORE), above.start)
        for above in state.sections.chains_of(Name(angle))
        if above.start < chain.start and len(above.sides) == 2 and not names(above.sides[1].node)
    )
