"""Roots of equations in a sine or cosine: 2λ cos²θ + cos θ - λ = 0, so cos θ = (√(1 + 8λ²) - 1)/(4λ).

The wave is the unknown, as a letter would be; an equation above that has its angle nowhere else is a
polynomial in it, which the value right below satisfies, or is wrong.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import (
    Call,
    Formula,
    Name,
    Number,
    PlusMinus,
    names,
    walk,
    with_parts_changed,
)
from symbalance.notes.checking.deciding.branches import with_sign
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONDITION, DEFINITION, PREMISE, UNDECIDED, Verdict
from symbalance.notes.checking.words.plain_formulas import lone_side
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_OPEN = (CONDITION, DEFINITION, PREMISE, UNDECIDED)
_WAVES = ("sin", "cos", "tan")
_UNKNOWN = "wave_itself"
_ZERO = Number(Fraction(0))
_FARTHEST = 400
"""Characters between an equation and its root."""
_APPLIES_NOT = re.compile(
    r"(?<![^\W\d_])(?:approx\w*|rough\w*|small|large|näherung\w*|klein\w*|petit\w*|circa|other|another|instead|without"
    r"|ohne|statt|sans|autre|altr[oa]|otr[oa])(?![^\W\d_])|近似|別の",
    re.IGNORECASE,
)
"""Words of what is no root of the equation as it stands."""


def unless_no_root_of_wave(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; the value of a sine or cosine has to satisfy the equation in it right above."""
    is_open = not k and verdict.verdict in _OPEN and chain.relations[0].sign == "="
    wave, value = chain.sides[0].node, chain.sides[1].node
    found = _equation_above(state, chain, wave) if is_open and _is_wave(wave, value) else None
    if found is None or not names(value) <= names(found[0]):
        return verdict
    equation, line = found
    knowledge = state.knowledge_of(chain, state.knowledge(chain.lines[0]))
    own = {name: each for name, each in knowledge.definitions.items() if name not in names(wave)}
    known = replace(knowledge, definitions=own)
    has_signs = any(isinstance(part, PlusMinus) for part in walk(value))
    values = [with_sign(value, sign) for sign in (1, -1)] if has_signs else [value]
    decisions = [_decide(equation, each, known) for each in values]
    if any(decision.status == REFUTED for decision in decisions):
        return describe(state.document, chain, k, Decision(REFUTED, f"does not satisfy line {line}"))
    if all(decision.is_proved for decision in decisions):
        return describe(state.document, chain, k, Decision(PROVED, f"satisfies line {line}"))
    return verdict


def _is_wave(wave: Formula, value: Formula) -> bool:
    """Tell whether a relation gives the sine, cosine or tangent of a letter a value in other letters."""
    return (
        isinstance(wave, Call)
        and wave.function in _WAVES
        and isinstance(wave.argument, Name)
        and bool(names(value))
        and wave.argument.name not in names(value)
    )


def _decide(equation: Formula, value: Formula, knowledge: Knowledge) -> Decision:
    """Return whether an equation set to zero is true with a value put in for its wave."""
    written = substitute(equation, _UNKNOWN, value)
    return decide(lone_side(written), lone_side(_ZERO), "=", knowledge)


def _equation_above(state: JudgingState, chain: Chain, wave: Formula) -> tuple[Formula, int] | None:
    """Return the last equation set to zero above, with a letter for the wave, and its line.

    The angle stands in no other wave there.
    """
    text, line, place = state.document.text, chain.lines[0], chain.start
    while (other := state.sections.chain_before(place)) is not None:
        is_near = chain.start - other.end <= _FARTHEST
        if not is_near or not state.sections.same_section(other.lines[0], line):
            return None
        if _APPLIES_NOT.search(text[other.end : place]):
            return None
        place = other.start
        left, right = other.sides[-2].node, other.sides[-1].node
        if other.relations[-1].sign != "=" or right != _ZERO:
            continue
        inside = _with_unknown(left, wave)
        is_wrong = any(side.span[0] in state.refuted for side in other.sides[1:])
        if _UNKNOWN in names(inside) and not names(wave) & names(inside) and not is_wrong:
            return inside, other.lines[0]
        return None
    return None


def _with_unknown(node: Formula, wave: Formula) -> Formula:
    """Return a formula with a letter in place of a wave."""
    if node == wave:
        return Name(_UNKNOWN)
    return with_parts_changed(node, lambda part: _with_unknown(part, wave))
