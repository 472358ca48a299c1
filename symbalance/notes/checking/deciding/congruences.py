"""Congruences: two numbers or angles whose difference is a whole multiple of the modulus typed behind.

What is congruent is not equal: n ≡ 1 (mod 4) gives n no value. Letters whose values are not known leave a
congruence a premise where one stands alone, and undecided elsewhere, unless they cancel.
"""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import Formula, Name, Negative, Number, Product, Sum, names
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.algebra.tree_values import NO_VALUE, TreeValues
from symbalance.notes.checking.deciding.equality import (
    REFUTED,
    UNDECIDED,
    Decision,
    decide_equality,
)
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.verdicts import PREMISE
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain
from symbalance.notes.reading.formulas.moduli import modulus_at

_NEAR = 1e-9
"""How near a whole number of moduli floats come to one; then it is proved exactly."""


def decide_congruence(text: str, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Return the decision on a congruence of a page's text; None for a relation without a modulus."""
    is_congruence = any(relation.sign in ("≡", "=") for relation in chain.relations)
    modulus = modulus_at(text, chain.sides[-1].span[1]) if is_congruence else None
    if modulus is None or modulus.value is None:
        unread = "the modulus is not read: write (mod 4), (mod 360°) or (mod N)"
        return Decision(UNDECIDED, unread) if modulus is not None else None
    left, right, typed = chain.sides[k].node, chain.sides[k + 1].node, f"modulo {modulus.text}"
    gap = Sum((left, Negative(right)))
    ratio = _ratio(gap, modulus.value, knowledge)
    if ratio is None:
        return Decision(UNDECIDED, f"{typed}: a side or the modulus has no value")
    if abs(ratio - round(ratio)) < _NEAR * max(1, abs(ratio)):
        further = Sum((right, Product((Number(Fraction(round(ratio))), modulus.value))))
        if (decision := decide_equality(left, further, knowledge)).is_proved:
            return decision
    values = {name: each.node for name, each in knowledge.definitions.items()}
    if all(name in values for name in names_behind(Sum((gap, modulus.value)), values)):
        return Decision(REFUTED, f"they are no whole multiple of {modulus.text} apart")
    if isinstance(left, Name) and left.name not in values and left.name not in names(right):
        return Decision(PREMISE, f"{typed}: it gives {plain_text(left)} no value")
    return Decision(UNDECIDED, f"{typed}, of letters without values")


def _ratio(gap: Formula, modulus: Formula, knowledge: Knowledge) -> float | None:
    """Return how many moduli two sides are apart, at one value of each letter; None for no number."""
    values = {name: each.node for name, each in knowledge.definitions.items()}
    values_of = TreeValues(knowledge.meaning, {})
    nodes = [gap, modulus]
    for name, node in values.items():
        nodes = [substitute(each, name, node) for each in nodes]
    for name in sorted({n for node in nodes for n in names(node)}):
        nodes = [substitute(each, name, Number(Fraction(1))) for each in nodes]
    try:
        return float((values_of.value(nodes[0]) / values_of.value(nodes[1])).real)
    except NO_VALUE:
        return None
