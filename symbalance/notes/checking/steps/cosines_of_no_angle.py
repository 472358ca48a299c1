"""A sine or cosine that no angle has: cos θ = (-1 - √(1 + 8 λ²))/(4 λ), which for λ = 1/4 is -2.22.

It satisfies the quadratic equation that it is a root of, and the crank is never there.
"""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import Call, PlusMinus, names, walk
from symbalance.notes.algebra.tree_values import sample_trees
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, UNDECIDED, Decision
from symbalance.notes.checking.steps.impossible_ranges import is_only_tried
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONTRADICTION, Verdict
from symbalance.notes.reading.equations import Chain

_WAVES = {"sin": "sine", "cos": "cosine"}
_POINTS = 12
_ROUNDED = 1.005
"""Above it a number is no 1 that is rounded up."""


def unless_of_no_angle(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; refuted where a sine or cosine is a number beyond 1.

    A formula that is so by the numbers of its letters is undecided, as there may be others:
    cos θ = -1/(2 λ) of rods that nobody builds. So is one of two values: words below may take the other.
    """
    left, right = chain.sides[0].node, chain.sides[k + 1].node
    is_equation = chain.relations[k].sign in "=≈" and verdict.verdict not in (REFUTED, CONTRADICTION)
    if not is_equation or not isinstance(left, Call) or left.function not in _WAVES:
        return verdict
    if k and (names(right) or not names(chain.sides[k].node)):
        return verdict  # the relation before it says so
    angles = names(left.argument)
    has_both_signs = any(isinstance(part, PlusMinus) for part in walk(right))
    if not angles or angles & names(right) or has_both_signs:
        return verdict
    knowledge = state.knowledge_of(chain, state.knowledge(chain.lines[0]))
    if angles & knowledge.meaning.complex:
        return verdict
    values = {n: d.node for n, d in knowledge.definitions.items() if n not in angles}
    meaning = replace(knowledge.meaning, values={**values, **knowledge.meaning.values})
    points = sample_trees([right], meaning, _POINTS, 2 * _POINTS)
    if not points or any(abs(row[0]) <= _ROUNDED for _, row in points) or is_only_tried(state, chain):
        return verdict
    printed = {f"{float(row[0].real):.3g}" for _, row in points}
    shown = "beyond 1 for all values tried" if len(printed) > 1 else printed.pop()
    reason = f"no angle has this {_WAVES[left.function]}: it is {shown}"
    is_wrong = not names(right) and _is_its_only_value(state, chain)
    return describe(state.document, chain, k, Decision(REFUTED if is_wrong else UNDECIDED, reason))


def _is_its_only_value(state: JudgingState, chain: Chain) -> bool:
    """Tell whether no other relation of the section gives the same sine or cosine a value."""
    sections, line = state.sections, chain.lines[0]
    others = (c for c in sections.chains_of(chain.sides[0].node) if c.start != chain.start)
    return not any(sections.same_section(other.lines[0], line) for other in others)
