"""Values of motions at the dead centres that words name: in the dead positions b₁ = r ω² (1 + λ), b₂ = …

Where no line puts the crank angle in, "at bottom dead centre" does. A letter with an index beside one that
is known in that angle, b₁ and b₂ of b, is taken to be that one's value there: it holds for this reason, and
is refuted where the other index has the value of one dead centre, and it has the same size with the other
sign. Anything else stays a definition: b₁ and b₂ may be the orders of b.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Constant, Formula, Name, Negative, Number, names
from symbalance.document.letters import plain_letter
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide_at_value
from symbalance.notes.checking.judging_state import JudgingState
from symbalance.notes.checking.plain_formulas import plain_text
from symbalance.notes.checking.symbol_roles import role_of
from symbalance.notes.reading.equations import Chain, Side

CENTRES: tuple[Formula, ...] = (Number(Fraction(0)), Constant("pi"))
"""The crank angles at top and at bottom dead centre."""
_BOTH = re.compile(
    r"(?:dead\s+(?:cent(?:re|er)s|points|positions)|Totlagen|Totpunkten?|両死点|上下死点)", re.IGNORECASE
)
_INDEX = re.compile(r"[0-9]")


def angle_of_crank(state: JudgingState, line: int, knowledge: Knowledge) -> str:
    """Return the crank angle's letter, by its declaration or by words; "" where nothing says so."""
    theta = knowledge.crank.theta if knowledge.crank is not None else None
    if isinstance(theta, Name) and theta.name in knowledge.letters:
        return theta.name
    _, proposed = state.meant.words.sizes(line)
    said = [n for n, p in state.meant.words.proposals.items() if p.words]
    return next((n for n in said if role_of(proposed.get(n, "")) == "crank angle"), "")


def angle_there(state: JudgingState, chain: Chain, knowledge: Knowledge) -> tuple[str, Formula] | None:
    """Return the crank angle and its value at the dead centre that a relation's sentence names."""
    centre = state.sections.dead_centre(chain)
    name = angle_of_crank(state, chain.lines[0], knowledge) if centre is not None else ""
    return (name, CENTRES[bool(centre)]) if name else None


def value_at_dead_centre(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Decide a new letter with an index as a motion's value at a dead centre that words name."""
    left, right = chain.sides[k].node, chain.sides[k + 1]
    if k or not isinstance(left, Name):
        return None
    base, _, index = left.name.rpartition("_")
    theta = angle_of_crank(state, chain.lines[0], knowledge)
    motion = knowledge.definitions.get(base)
    if not base or not _INDEX.fullmatch(index) or not theta or motion is None:
        return None
    if theta not in names(motion.node) or theta in names(right.node) or not names(right.node):
        return None
    sign = chain.relations[0].sign
    there = list(_at_centres(Side((Name(base),), right.span), right, sign, theta, state, chain, knowledge))
    for decision, text in there:
        if decision.is_proved:
            named = f"{plain_letter(left.name)} is {plain_letter(base)} {text}, by the words before"
            return replace(decision, assumptions=(*decision.assumptions, named))
    if len(there) != len(CENTRES):
        return None
    return _beside_another(left.name, base, right, there, theta, chain, knowledge)


def _beside_another(
    name: str,
    base: str,
    right: Side,
    there: list[tuple[Decision, str]],
    theta: str,
    chain: Chain,
    knowledge: Knowledge,
) -> Decision | None:
    """Refute a value that is that of the other letter with its sign changed: b₂ = -b₁, where b₁ = b(0)."""
    sign, motion = chain.relations[0].sign, Side((Name(base),), right.span)
    negative = Side((Negative(right.node),), right.span)
    for other, definition in knowledge.definitions.items():
        stem, _, index = other.rpartition("_")
        if other == name or stem != base or not _INDEX.fullmatch(index):
            continue
        if definition.line not in chain.lines:
            continue
        value = Side((definition.node,), right.span)
        for place, angle in enumerate(CENTRES):
            has_value = decide_at_value(motion, value, sign, knowledge, theta, angle).is_proved
            is_negated = decide_at_value(motion, negative, sign, knowledge, theta, angle).is_proved
            rest, text = there[1 - place]
            if has_value and is_negated and rest.status == REFUTED:
                reason = f"{plain_letter(base)} {text}; {plain_letter(other)} is that at the other one"
                return replace(rest, reason=reason)
    return None


def _at_centres(
    motion: Side,
    right: Side,
    sign: str,
    theta: str,
    state: JudgingState,
    chain: Chain,
    knowledge: Knowledge,
) -> Iterator[tuple[Decision, str]]:
    """Yield the decisions at the dead centres that a relation's sentence may speak of, with the place."""
    named = state.sections.dead_centre(chain)
    both = _BOTH.search(state.sections.sentence_before(chain)) is not None
    for place, angle in enumerate(CENTRES):
        if both or (named is not None and place == bool(named)):
            text = f"at {plain_text(Name(theta))} = {plain_text(angle)}"
            yield decide_at_value(motion, right, sign, knowledge, theta, angle), text
