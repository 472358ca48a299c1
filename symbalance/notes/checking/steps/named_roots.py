"""Roots of an equation that stand below it: "with the roots ω_I = √(k/J), ω_II = √(3k/J)".

Each root's letter is the unknown with a subscript of its own. Nothing else on the page says what it is,
and put into the equation it satisfies it, or it is no root. One solution of several, "the solution ω = 0
is the rigid rotation; the other is", gives the unknown no value for the lines below.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Name, Negative, Number, names
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.rounding import decimals
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.premises.angles_at import solves_as_printed
from symbalance.notes.checking.premises.system import Premise
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.words.plain_formulas import lone_side
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

FARTHEST = 400
"""Characters between an equation and its last root."""
_NEAR = 160
"""Characters before and behind a formula that name it a solution."""
_ROOTS = re.compile(
    r"(?<![A-Za-z])(?:roots?|solutions?|eigenvalues?|zeros|Wurzeln?|Lösung(?:en)?|Nullstellen?|Eigenwerte?|racines?)(?![A-Za-z])|根|解",
    re.IGNORECASE,
)
_LEADING = re.compile(rf"(?:{_ROOTS.pattern})[ \t\n]*[$:`\\(]*$", re.IGNORECASE)
"""One of those words right before a formula."""
_ANOTHER = re.compile(
    r"(?<![A-Za-z])(?:the\s+(?:other|second)|die\s+(?:andere|zweite)|l['’]autre|another)(?![A-Za-z])|他の|もう一つ",
    re.IGNORECASE,
)
_NONE = re.compile(r"(?<![A-Za-z])(?:of|other|another|square|cube|von|approximate\w*)\s*$", re.IGNORECASE)


def as_named_root(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Return the decision on a root of the equation above by that equation; None for other relations."""
    head, value = chain.sides[0].node, chain.sides[1].node
    if k or chain.relations[0].sign != "=" or not isinstance(head, Name) or "_" not in head.name:
        return None
    unknown = head.name.partition("_")[0]
    equation = _equation_above(state, chain, unknown)
    if equation is None or {unknown, head.name} & names(value):
        return None
    if not names(value):
        return _as_number(state, chain, equation, unknown)
    return _as_formula(state, chain, equation, unknown, knowledge)


def _as_formula(
    state: JudgingState, chain: Chain, equation: Chain, unknown: str, knowledge: Knowledge
) -> Decision | None:
    """Return the decision on a formula in the letters of an equation as its root."""
    head, value = chain.sides[0].node, chain.sides[1].node
    sides = [side.node for side in equation.sides]
    own = names(sides[0]) | names(sides[1])
    if not isinstance(head, Name) or head.name in own or not names(value) <= own:
        return None
    left, right = (lone_side(substitute(node, unknown, value)) for node in sides)
    formulas = {
        n: d
        for n, d in knowledge.definitions.items()
        if n not in (unknown, head.name) and not d.numeric and not d.solved
    }
    decision = decide(left, right, "=", replace(knowledge, definitions=formulas))
    if decision.is_proved:
        state.definitions.define(head.name, value, chain)
        return Decision(PROVED, f"satisfies line {equation.lines[0]}", assumptions=decision.assumptions)
    if decision.status == REFUTED:
        return Decision(REFUTED, f"does not satisfy line {equation.lines[0]}", witness=decision.witness)
    return None


def _as_number(state: JudgingState, chain: Chain, equation: Chain, unknown: str) -> Decision | None:
    """Return the decision on a number as a root of an equation between numbers, each as it is printed.

    A whole number may be rounded to its last digit; one with a unit is left open.
    """
    head, value = chain.sides[0].node, chain.sides[1].node
    own = names(equation.sides[0].node) | names(equation.sides[1].node)
    is_bare = re.search(r"[^\W\d_]", state.document.source(chain.sides[1].span)) is None
    if own != {unknown} or not isinstance(head, Name) or not is_bare:
        return None
    condition = Premise(equation.sides[0].node, equation.sides[1].node, equation.lines[0])
    free = Knowledge()
    number = value.operand if isinstance(value, Negative) else value
    is_solution = solves_as_printed(condition, unknown, value, free)
    if is_solution:
        state.definitions.define(head.name, value, chain)
        is_printed = any(decimals(node) for node in (value, condition.left, condition.right))
        reason = f"satisfies line {equation.lines[0]}"
        return Decision(PROVED, reason, order="the digits printed" if is_printed else "")
    if isinstance(number, Number) and number.last_place is None:
        rough = replace(number, last_place=Fraction(1))
        rough_value = Negative(rough) if isinstance(value, Negative) else rough
        is_solution = None if solves_as_printed(condition, unknown, rough_value, free) else is_solution
    reason = f"does not satisfy line {equation.lines[0]}"
    return Decision(REFUTED, reason) if is_solution is False else None


def as_one_solution(state: JudgingState, chain: Chain, k: int) -> Decision | None:
    """Return the proof that a number solves the equation above, one solution of several; else None.

    The equation alone proves it, whatever else its letters are; the number is the unknown's nowhere else.
    """
    head, value = chain.sides[0].node, chain.sides[1].node
    is_given = len(chain.relations) == 1 and chain.relations[k].sign == "=" and isinstance(head, Name)
    if not is_given or not isinstance(head, Name) or names(value):
        return None
    text, start = state.document.text, chain.sides[0].span[0]
    is_named = _LEADING.search(text, max(start - _NEAR, 0), start) is not None
    if not is_named or not _ANOTHER.search(text, chain.end, chain.end + _NEAR):
        return None
    above = [c for c in state.document.chains if c.end <= start and start - c.end < FARTHEST]
    for other in sorted(above, key=lambda c: c.end, reverse=True):
        if head.name not in names(other.sides[0].node) | names(other.sides[-1].node):
            continue
        sides = [side.node for side in (other.sides[0], other.sides[-1])]
        if Name(head.name) in sides:
            return None
        left, right = (lone_side(substitute(node, head.name, value)) for node in sides)
        decision = decide(left, right, "=", Knowledge())
        is_solution = decision.is_proved and not decision.assumptions
        return Decision(PROVED, f"satisfies line {other.lines[0]}") if is_solution else None
    return None


def _equation_above(state: JudgingState, chain: Chain, unknown: str) -> Chain | None:
    """Return the equation in an unknown whose roots the words before a relation name, None for none."""
    text, start = state.document.text, chain.sides[0].span[0]
    above = [c for c in state.document.chains if c.end <= start and start - c.end < FARTHEST]
    above.sort(key=lambda c: c.sides[0].span[0], reverse=True)
    for other in above:
        is_root = isinstance(other.sides[0].node, Name) and other.sides[0].node.name.startswith(
            f"{unknown}_"
        )
        if is_root:
            continue
        own = names(other.sides[0].node) | names(other.sides[-1].node)
        if len(other.sides) != 2 or other.relations[0].sign != "=" or unknown not in own:
            return None
        if isinstance(other.sides[0].node, Name):
            return None
        named = _ROOTS.search(text, other.end, start)
        return other if named and not _NONE.search(text, other.end, named.start()) else None
    return None
