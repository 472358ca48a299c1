"""Conditions that are written once more in other letters: where T = T_m, i.e. 900 sin 2θ = 480 cos 2θ.

An equation between two functions of an angle is true at some angles only. Behind one that says where
something is looked at, and after words that restate it, it is that condition with its letters put in: the
difference of its sides is the one above, or minus that.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import (
    Call,
    Name,
    Negative,
    Number,
    Product,
    Quotient,
    Sum,
    Summation,
    names,
)
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, Decision
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONDITION, CONTRADICTION, REFUTED, UNDECIDED, Verdict
from symbalance.notes.checking.words.plain_formulas import lone_side
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_RESTATES = re.compile(
    r"[\s$,;:.()]*(?:(?:i\.\s?e\.|that\s+is(?:\s+to\s+say)?|or|so|hence|thus|which\s+means|that\s+means|d\.\s?h\.|das\s+heißt"
    r"|also|somit|oder|bzw\.|c['’]est-à-dire|soit|donc|cioè|ossia|ovvero|quindi|es\s+decir|o\s+sea|luego)(?![^\W\d_])"
    r"|すなわち|つまり|よって|\\(?:Rightarrow|implies)(?![A-Za-z])|⇒)?"
    r"(?:[\s$,;:.()\[&]|\\(?:q?quad(?![a-z])|[\\,;\[(]))*",
    re.IGNORECASE,
)
"""Words between two equations by which the second is the first one again."""
_WHERE = re.compile(
    r"[\s$),\]\\]*(?:(?:precisely|exactly|only|just|genau\s+dort|dort|là|allí)\s+)?"
    r"(?:where(?:ver)?|wherever|when(?:ever)?|wo|où|lorsque|quand|dove|quando|donde|cuando)(?![^\W\d_])[\s$(\[\\]*",
    re.IGNORECASE,
)
"""Words between an equation and the one that says at which angles it is true: T = T_m where …"""


def unless_condition_again(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a refuted equation that is the condition right before it is a condition too.

    So is the second of two sums that are to vanish: Σ cos α_k = 0, Σ sin α_k = 0.
    """
    if _is_beside_condition(state, chain, k, verdict):
        return describe(
            state.document, chain, k, Decision(CONDITION, f"beside that of line {chain.lines[0]}")
        )
    if k or verdict.verdict not in (REFUTED, CONTRADICTION) or chain.relations[0].sign != "=":
        return verdict
    if (there := _where_behind(state, chain)) is not None:
        return describe(state.document, chain, k, there)
    before = state.sections.chain_before(chain.start)
    if (
        before is None
        or len(before.relations) != 1
        or before.lines[0] not in _lines_of_conditions(state, chain)
    ):
        return verdict
    if _RESTATES.fullmatch(state.document.text[before.end : chain.start]) is None:
        return verdict
    solved = _solved(state, before, chain) or _as_condition(state, before, chain)
    return verdict if solved is None else describe(state.document, chain, k, solved)


def _where_behind(state: JudgingState, chain: Chain) -> Decision | None:
    """Return that an equation is true where the one right behind it says, with its letters put in.

    T = T_m where 8000 sin 2θ = 6000 cos 2θ: the difference of its sides is that of the other's, or minus
    that. Else None: with another sign in one of them nothing says where it would be true.
    """
    behind = next(state.sections.chains_behind(chain.end - 1), None)
    if behind is None or len(chain.relations) != 1 or not behind.relations:
        return None
    if behind.relations[0].sign != "=" or not all(names(side.node) for side in behind.sides[:2]):
        return None
    if _WHERE.fullmatch(state.document.text[chain.end : behind.start]) is None:
        return None
    first, second = (Sum((c.sides[0].node, Negative(c.sides[1].node))) for c in (chain, behind))
    knowledge = state.knowledge(chain.lines[0])
    is_same = any(
        decide(lone_side(first), lone_side(side), "=", knowledge).is_proved
        for side in (second, Negative(second))
    )
    return Decision(CONDITION, f"where that of line {behind.lines[0]} is true") if is_same else None


def _as_condition(state: JudgingState, before: Chain, chain: Chain) -> Decision | None:
    """Return that an equation is the condition above with its letters put in; None for another."""
    if not all(names(side.node) for side in chain.sides):
        return None  # |y| = 3, so y = 3, is one solution of two
    first, own = (Sum((each.sides[0].node, Negative(each.sides[1].node))) for each in (before, chain))
    knowledge = state.knowledge(chain.lines[0])
    others = {n: d for n, d in knowledge.definitions.items() if n not in chain.letters}
    knowledge = replace(knowledge, definitions=others, solved={}, solved_from=())
    is_same = any(
        decide(lone_side(first), lone_side(side), "=", knowledge).is_proved
        for side in (own, Negative(own))
    )
    if not is_same:
        return None
    state.definitions.conditions[chain.lines[0]] = chain.letters
    return Decision(CONDITION, f"line {before.lines[0]} once more")


def _is_beside_condition(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> bool:
    """Tell whether an open sum is set to zero right beside another one that was taken as given."""
    if (
        k
        or verdict.verdict not in (UNDECIDED, REFUTED, CONTRADICTION)
        or len(chain.relations) != 1
        or not _is_sum_set_to_zero(chain)
    ):
        return False
    before = state.sections.chain_before(chain.start)
    if before is None or len(before.relations) != 1 or not _is_sum_set_to_zero(before):
        return False
    between = state.document.text[before.end : chain.start]
    is_near = _RESTATES.fullmatch(between) is not None and "\n" not in between
    is_near = is_near and before.letters == chain.letters
    return is_near and before.sides[0].span[0] not in state.refuted


def _is_sum_set_to_zero(chain: Chain) -> bool:
    """Tell whether a sum, written out or not, is set to zero."""
    is_sum = isinstance(chain.sides[0].node, Sum | Summation)
    return is_sum and chain.sides[1].node == Number(Fraction(0))


def _solved(state: JudgingState, before: Chain, chain: Chain) -> Decision | None:
    """Return the proof that a wave's number solves the condition above: tan 2θ = 480/900; else None."""
    wave, number = chain.sides[0].node, chain.sides[1].node
    own = names(wave)
    is_tangent = isinstance(wave, Call) and wave.function == "tan"  # a sine's number has two angles
    if not isinstance(wave, Call) or not is_tangent or names(number) or len(own) != 1:
        return None
    if not all(names(side.node) for side in before.sides):
        return None
    (name,) = own
    angle = Call("atan", number)
    if isinstance(wave.argument, Product):
        angle = Quotient(angle, Product(tuple(f for f in wave.argument.factors if names(f) != own)))
    elif wave.argument != Name(name):
        return None
    try:
        left, right = (lone_side(substitute(side.node, name, angle)) for side in before.sides)
    except NoFormError:
        return None
    decision = decide(left, right, "=", state.knowledge(chain.lines[0]))
    return Decision(PROVED, f"satisfies line {before.lines[0]}") if decision.is_proved else None


def _lines_of_conditions(state: JudgingState, chain: Chain) -> set[int]:
    line = chain.lines[0]
    return {p.line for p in state.definitions.premises_at(line)} | {*state.definitions.conditions}
