"""Speeds of angles that the page gives as parts or multiples of another: φ = θ/2 and θ = ω t, so φ̇ = ω/2.

What turns the other angle at ω the page says anywhere near, as a relation (ω = θ̇ behind it too) or in
words (θ the crank angle, ω the angular speed of the crank).
"""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import Derivative, Formula, Name, Product, names, walk
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision, decide_equality
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.declared.symbol_roles import role_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import STATED, UNDECIDED, Verdict
from symbalance.notes.reading.equations import Chain

_TIME = Name("t")


def unless_rate_of_ratio(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; the speed of a multiple of another angle is that multiple of its speed."""
    if k or verdict.verdict not in (*STATED, UNDECIDED) or chain.relations[0].sign != "=":
        return verdict
    head = chain.sides[0].node
    is_rate = isinstance(head, Derivative) and head.variable == _TIME and head.order == 1
    if not is_rate or not isinstance(head, Derivative) or not isinstance(head.expression, Name):
        return verdict
    formula = _formula_of(state, chain, head.expression.name)
    decision = None if formula is None else _compared(state, chain, *formula)
    return verdict if decision is None else describe(state.document, chain, k, decision)


def _compared(state: JudgingState, chain: Chain, other: str, node: Formula, line: int) -> Decision | None:
    """Return whether a speed is that of an angle's formula in another angle; None where that is open."""
    value, speeds = chain.sides[1].node, _speeds_of(state, chain, other)
    if len(speeds) != 1 or speeds != names(value):
        return None
    (speed,) = speeds
    turned = Product((Name(speed), _TIME))
    known = replace(Knowledge(), definitions={other: Definition(turned, line)})
    try:
        moved = Derivative(substitute(node, other, turned), _TIME, 1)
    except NoFormError:
        return None
    decision = decide_equality(moved, value, known)
    if decision.is_proved:
        return Decision(PROVED, f"by line {line}")
    is_wrong = decision.status == REFUTED
    return replace(decision, reason=f"does not follow from line {line}") if is_wrong else None


def _formula_of(state: JudgingState, chain: Chain, name: str) -> tuple[str, Formula, int] | None:
    """Return the one letter of an angle's only formula in the section, that formula, and its line."""
    line, sections = chain.lines[0], state.sections
    found = [
        other
        for other in state.document.chains
        if other.relations
        and other.sides[0].node == Name(name)
        and other.relations[0].sign == "="
        and sections.same_section(other.lines[0], line)
    ]
    if len(found) != 1:
        return None
    node = found[0].sides[1].node
    own = names(node)
    is_plain = not any(isinstance(part, Derivative) for part in walk(node))
    return (next(iter(own)), node, found[0].lines[0]) if len(own) == 1 and is_plain else None


def _speeds_of(state: JudgingState, chain: Chain, name: str) -> frozenset[str]:
    """Return the letters that the section has as the speed of an angle, by relations or by its words."""
    rate = Derivative(Name(name), _TIME, 1)
    found: set[str] = set()
    for other in state.document.chains:
        if not other.relations or not state.sections.same_section(other.lines[0], chain.lines[0]):
            continue
        first, second = other.sides[0].node, other.sides[1].node
        for one, two in ((first, second), (second, first)):
            if one == rate and isinstance(two, Name):
                found.add(two.name)
            turned = names(two) - {_TIME.name}
            if (
                one == Name(name)
                and isinstance(two, Product)
                and _TIME in two.factors
                and len(turned) == 1
            ):
                found |= turned if len(two.factors) == 2 else set()
    if found:
        return frozenset(found)
    words = state.meant.words.proposals
    roles = {letter: role_of(proposal.meaning) for letter, proposal in words.items()}
    if roles.get(name) != "crank angle":
        return frozenset()
    return frozenset(letter for letter, role in roles.items() if role == "angular speed")
