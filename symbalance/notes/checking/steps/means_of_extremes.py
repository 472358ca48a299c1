"""Means of the greatest and the least speed: ω_max + ω_min ≈ 2ω, beside a ω that has its own number.

Of a flywheel the mean speed is what lies midway. Such a relation says so, and nothing has to be small
for it; with another factor than 2 it says something else.
"""

from __future__ import annotations

from symbalance.document.formula import Formula, Name, Number, Product, Quotient, Sum
from symbalance.document.letters import plain_letter
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, Decision
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import UNDECIDED, Verdict
from symbalance.notes.reading.equations import Chain

_EXTREMES = frozenset({"max", "min"})
_OF_MEAN = ("", "m", "0", "mean", "mit", "moy", "med", "av")


def unless_mean_of_extremes(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; an open relation that calls a letter the mean of its extremes is taken so."""
    if verdict.verdict != UNDECIDED or chain.relations[k].sign not in "=≈":
        return verdict
    sides = [side.node for side in chain.sides[k : k + 2]]
    for first, second in (sides, sides[::-1]):
        stem = _stem_of_extremes(first)
        mean = _mean(second) or ""
        own, _, index = mean.partition("_")
        if stem and own == stem and index in _OF_MEAN:
            text = f"{plain_letter(mean)} is the mean of the greatest and the least one"
            return describe(state.document, chain, k, Decision(PROVED, assumptions=(text,)))
    return verdict


def _stem_of_extremes(node: Formula) -> str:
    """Return the letter of a sum of its greatest and its least value; "" for other formulas."""
    if (
        not isinstance(node, Sum)
        or len(node.terms) != 2
        or not all(isinstance(t, Name) for t in node.terms)
    ):
        return ""
    parts = [term.name.partition("_") for term in node.terms if isinstance(term, Name)]
    stems, indices = {part[0] for part in parts}, {part[2] for part in parts}
    return stems.pop() if len(stems) == 1 and indices == _EXTREMES else ""


def _mean(node: Formula) -> str | None:
    """Return the letter of twice a letter; None for other formulas."""
    match node:
        case Product(factors=(Number(value=value), Name(name=name))) if value == 2:
            return name
        case Quotient(numerator=Name(name=name), denominator=Number(value=value)) if value * 2 == 1:
            return name
    return None
