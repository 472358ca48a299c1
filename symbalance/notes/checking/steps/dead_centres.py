"""Values of motions at the dead centres that words name: in the dead positions b₁ = r ω² (1 + λ).

Where no line puts the crank angle in, "at bottom dead centre" does. A letter with an index beside one
that is known in that angle, b₁ and b₂ of b, is taken to be that one's value there: it holds for this
reason, and is refuted where the other index has the value of one dead centre, and it has the same size
with the other sign. Anything else stays a definition: b₁ and b₂ may be the orders of b.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import (
    Call,
    Constant,
    Derivative,
    Formula,
    Name,
    Negative,
    Number,
    names,
    walk,
)
from symbalance.document.letters import plain_letter
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide, decide_at_value, written_out
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.declared.symbol_roles import role_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain, Side
from symbalance.text import lazy_patterns as re

CENTRES: tuple[Formula, ...] = (Number(Fraction(0)), Constant("pi"))
"""The crank angles at top and at bottom dead centre."""
_BOTH = re.compile(
    r"(?:dead\s+(?:cent(?:re|er)s|points|positions)|Totlagen|Totpunkten?|両死点|上下死点)", re.IGNORECASE
)
_INDEX = re.compile(r"[0-9]")
_PLACES = {"ot": 0, "tdc": 0, "top": 0, "ut": 1, "bdc": 1, "bot": 1, "bottom": 1}
"""Indices that name a dead centre, by its place in `CENTRES`."""


def angle_of_crank(state: JudgingState, line: int, knowledge: Knowledge) -> str:
    """Return the crank angle's letter, by its declaration, by words or as what turns; "" for none."""
    theta = knowledge.crank.theta if knowledge.crank is not None else None
    if isinstance(theta, Name) and theta.name in knowledge.letters:
        return theta.name
    _, proposed = state.meant.words.sizes(line)
    by_words = [n for n, text in proposed.items() if role_of(text) == "crank angle"]
    turning = [*by_words, *sorted(state.motions.turning(line))]
    return next(iter(turning), "")


def angle_there(
    state: JudgingState, chain: Chain, k: int, knowledge: Knowledge
) -> tuple[str, Formula] | None:
    """Return the crank angle and its value at the dead centre that a relation's sentence names.

    Where nothing says which letter that is, it is the only one that turns behind the left side.
    """
    centre = state.sections.dead_centre(chain)
    if centre is None:
        return None
    name = angle_of_crank(state, chain.lines[0], knowledge)
    if not name:
        values = {n: d.node for n, d in knowledge.definitions.items()}
        turned = {n for node in values.values() for n in _turned(node)} - values.keys()
        turned &= {*names_behind(chain.sides[k].node, values)}
        name = next(iter(turned)) if len(turned) == 1 else ""
    return (name, CENTRES[bool(centre)]) if name else None


def angle_named(state: JudgingState, chain: Chain, knowledge: Knowledge) -> tuple[str, Formula] | None:
    """Return the crank angle and its value that a relation's sentence names: at 90°, bei 90°."""
    name = angle_of_crank(state, chain.lines[0], knowledge)
    place = state.sections.place_of_sentence(chain) if name else None
    if place is None or not place.may_be_of(name, state.document.text):
        return None
    return name, place.angle


def _turned(node: Formula) -> set[str]:
    waves = (p for p in walk(node) if isinstance(p, Call) and p.function in ("sin", "cos"))
    return {name for wave in waves for name in names(wave.argument)}


def value_at_dead_centre(
    state: JudgingState, chain: Chain, k: int, knowledge: Knowledge
) -> Decision | None:
    """Decide a new letter with an index as a motion's value at a dead centre that words name."""
    left, right = chain.sides[k].node, chain.sides[k + 1]
    by_index = None if k else _at_named_place(state, chain, knowledge)
    if by_index is not None or k or not isinstance(left, Name):
        return by_index
    base, _, index = left.name.rpartition("_")
    theta = angle_of_crank(state, chain.lines[0], knowledge)
    motion = knowledge.definitions.get(base)
    if not base or not _INDEX.fullmatch(index) or not theta or motion is None:
        return None
    if theta not in names(motion.node) or theta in names(right.node) or not names(right.node):
        return None
    sign = chain.relations[0].sign
    motion_side = Side((Name(base),), right.span)
    there = list(_at_centres(motion_side, right, sign, theta, state, chain, knowledge))
    for decision, text in there:
        if decision.is_proved:
            named = f"{plain_letter(left.name)} is {plain_letter(base)} {text}, by the words before"
            return replace(decision, assumptions=(*decision.assumptions, named))
    if len(there) != len(CENTRES):
        return None
    return _beside_another(left.name, base, right, there, theta, chain, knowledge)


def _at_named_place(state: JudgingState, chain: Chain, knowledge: Knowledge) -> Decision | None:
    """Decide a value of a letter whose index names the dead centre: a_tdc = r ω² (1 + λ), ẍ_UT.

    A number that does not agree is data: of another engine, it may be.
    """
    left, right = chain.sides[0].node, chain.sides[1]
    letter = left.expression if isinstance(left, Derivative) else left
    if not isinstance(letter, Name) or knowledge.knows(letter.name):
        return None
    stem, _, index = letter.name.rpartition("_")
    order = next((n for mark, n in (("ddot_", 2), ("dot_", 1)) if stem.startswith(mark)), 0)
    base = stem.removeprefix("ddot_").removeprefix("dot_")
    theta = angle_of_crank(state, chain.lines[0], knowledge)
    values = {n: d.node for n, d in knowledge.definitions.items()}
    if index.casefold() not in _PLACES or not theta or base not in values:
        return None
    time = knowledge.crank.time if knowledge.crank else "t"
    motion: Formula = Name(base)
    if isinstance(left, Derivative):
        motion = replace(left, expression=motion)
    elif order:
        motion = Derivative(motion, Name(time), order)
    behind = {*names_behind(motion, values)}
    is_of_motion = theta in behind and {*names_behind(right.node, values)} <= behind - {theta}
    if not is_of_motion or not _is_symmetric(Name(base), theta, chain, knowledge):
        return None
    angle, sign = CENTRES[_PLACES[index.casefold()]], chain.relations[0].sign
    there = decide_at_value(Side((motion,), right.span), right, sign, knowledge, theta, angle)
    text = f"{plain_letter(letter.name)} is that of {plain_letter(base)}"
    text = f"{text} at {plain_text(Name(theta))} = {plain_text(angle)}"
    if there.is_proved:
        return replace(there, assumptions=(*there.assumptions, text))
    negative = Side((Negative(right.node),), right.span)
    opposite = decide_at_value(Side((motion,), right.span), negative, sign, knowledge, theta, angle)
    if there.status != REFUTED or opposite.is_proved or not names(right.node):
        return None
    return replace(there, reason=f"if {text}")


def _is_symmetric(motion: Formula, theta: str, chain: Chain, knowledge: Knowledge) -> bool:
    """Tell whether a motion is the same, or its negative, before and behind the angle zero.

    That of a cylinder beside the crank is not: its dead centres are where crank and rod are in line.
    """
    try:
        node = written_out(motion, knowledge, theta)
        turned = substitute(node, theta, Negative(Name(theta)))
        span = chain.sides[0].span
        sides = [Side((each,), span) for each in (node, turned, Negative(turned))]
        return any(decide(sides[0], side, "=", knowledge).is_proved for side in sides[1:])
    except (NoFormError, TooLargeError):
        return False


def _beside_another(
    name: str,
    base: str,
    right: Side,
    there: list[tuple[Decision, str]],
    theta: str,
    chain: Chain,
    knowledge: Knowledge,
) -> Decision | None:
    """Refute a value that is the other letter's with its sign changed: b₂ = -b₁, where b₁ = b(0)."""
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
