"""Angles that are said to solve the condition before them: cos θ = 0.25, so θ = 75.5°."""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import Formula, names
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.checking.deciding.equality import REFUTED, UNDECIDED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide, written_out
from symbalance.notes.checking.deciding.rounding import decimals
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.premises.angles_at import (
    changes_sign_nearby,
    is_round_angle,
    solves_as_printed,
)
from symbalance.notes.checking.premises.definitions import Definitions
from symbalance.notes.checking.verdicts import CONDITION
from symbalance.notes.checking.words.plain_formulas import lone_side, plain_text
from symbalance.notes.reading.equations import Chain


def decide_solution(
    definitions: Definitions, name: str, value: Formula, chain: Chain, k: int, knowledge: Knowledge
) -> Decision | None:
    """Return the decision on an angle that is said to follow from the condition right before it.

    cos θ = 0.25, so θ = 75.5°: it is one of the solutions to the digits printed, or it is none.
    """
    condition = definitions.open_condition(name, chain.lines[0])
    if condition is None or k or names(value) or not definitions.sections.is_consequence(chain):
        return None
    violated = refute_solution(definitions, name, value, chain, k, knowledge)
    is_solution = solves_as_printed(condition, name, value, knowledge)
    text = f"{condition.text} of line {condition.line}"
    if violated is not None or is_solution is None:
        return violated
    if is_solution:
        return Decision(CONDITION, f"solves {text}")
    if decimals(value) and chain.relations[0].sign == "=":
        return Decision(UNDECIDED, f"near a solution of {text}, but none to the digits printed")
    return None  # 76° is said of 75.96°


def refute_solution(
    definitions: Definitions, name: str, value: Formula, chain: Chain, k: int, knowledge: Knowledge
) -> Decision | None:
    """Return the contradiction between the value of an angle and the condition solved by it."""
    line = chain.lines[0]
    condition = definitions.open_condition(name, line)
    if condition is None or names(value) - names(condition.left) - names(condition.right):
        return None
    if condition.line > line or definitions.sections.premise_end(chain, is_number=True) is not None:
        return None
    sides = condition.left, condition.right
    try:
        if name not in condition.names:
            sides = tuple(written_out(node, knowledge, name) for node in sides)
        at_value = [substitute(node, name, value) for node in sides]
    except (NoFormError, TooLargeError):
        return None
    written = replace(condition, left=sides[0], right=sides[1])
    decision = decide(lone_side(at_value[0]), lone_side(at_value[1]), "=", knowledge)
    if decision.status != REFUTED:
        return None
    is_rounded = chain.relations[k].sign == "≈" or bool(decimals(value)) or not is_round_angle(value)
    # x = r at θ = π/2, but for what the rod's length adds
    is_nearly = name not in condition.names and bool(names(condition.right))
    if (is_rounded and changes_sign_nearby(written, name, value, knowledge)) or (
        is_nearly and decide(lone_side(at_value[0]), lone_side(at_value[1]), "≈", knowledge).is_proved
    ):
        return None
    text = f"{plain_text(condition.left)} = {plain_text(condition.right)}"
    reason = f"does not satisfy {text} of line {condition.line}"
    return replace(decision, status=REFUTED, reason=reason)
