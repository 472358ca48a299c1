"""Equations of motion in a difference of letters that move, ψ = φ_1 - φ_2, by those above.

With the equations of two discs divided by their inertias and subtracted, ψ̈ + k (1/J_1 + 1/J_2) ψ = 0.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from symbalance.document.formula import Formula, Name, Negative, Sum
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.motions.equations_of_motion import (
    EquationOfMotion,
    equation_of_motion,
    is_weighted_sum,
)
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_OF_A_CASE = re.compile(
    r"\b(?:if|when|for|held|fixed|clamped|forced|external|damp\w*|wenn|falls|für|fest\w*|eingespannt|gedämpft|si|quand|fixe|cuando)\b|固定|とき|場合",
    re.IGNORECASE,
)


def decide_relative_motion(
    chain: Chain,
    k: int,
    differentiated: Collection[str],
    above: Sequence[EquationOfMotion],
    words: str,
    knowledge: Knowledge,
) -> Decision | None:
    """Return the decision on an equation of motion in a difference of letters that move above, else None.

    `words` are those of its sentence: what they say of a case, one disc held, refutes nothing.
    """
    moving = frozenset[str]().union(*(each.moving for each in above))
    differences = {
        name: terms
        for name, definition in knowledge.definitions.items()
        if name in differentiated and (terms := _signed(definition.node)) and terms.keys() <= moving
    }
    if not differences:
        return None
    others = {n: d for n, d in knowledge.definitions.items() if n not in differences}
    equation = equation_of_motion(chain, k, differentiated, replace(knowledge, definitions=others))
    if equation is None or not equation.moving & differences.keys():
        return None
    written = _written_out(equation, differences)
    system = [each for each in above if each.moving & written.moving]
    follows = is_weighted_sum(written, system)
    if follows is None:
        return None
    lines = sorted({each.line for each in system})
    where = f"lines {lines[0]} to {lines[-1]}" if len(lines) > 1 else f"line {lines[0]}"
    if follows:
        return Decision(PROVED, f"by {where}")
    if _OF_A_CASE.search(words):
        return None
    return Decision(REFUTED, f"no sum of multiples of the equations of {where}")


def _signed(node: Formula) -> dict[str, int]:
    """Return the letters of a sum or difference with their signs; {} for other formulas."""
    terms: dict[str, int] = {}
    for term in node.terms if isinstance(node, Sum) else ():
        bare = term.operand if isinstance(term, Negative) else term
        if not isinstance(bare, Name) or bare.name in terms:
            return {}
        terms[bare.name] = -1 if bare is not term else 1
    return terms


def _written_out(equation: EquationOfMotion, differences: dict[str, dict[str, int]]) -> EquationOfMotion:
    """Return an equation in the letters that differences are of."""
    parts: dict[tuple[str, int], list[Formula]] = {}
    for (name, order), factor in equation.factors.items():
        for own, sign in differences.get(name, {name: 1}).items():
            parts.setdefault((own, order), []).append(factor if sign > 0 else Negative(factor))
    factors = {key: Sum(tuple(each)) if len(each) > 1 else each[0] for key, each in parts.items()}
    return replace(equation, factors=factors)
