"""Congruences: two numbers or angles whose difference is a whole multiple of the modulus typed behind.

What is congruent is not equal: n ≡ 1 (mod 4) gives n no value. Letters whose values are not known leave a
congruence a premise where one stands alone, and undecided elsewhere, unless they cancel.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Constant, Formula, Name, Negative, Number, Product, Sum, names
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
from symbalance.text import lazy_patterns as re

_DEGREES = re.compile(r"°|\\circ|\\deg(?![a-z])|(?<![A-Za-z])deg")
_NEAR = 1e-9
"""How near a whole number of moduli floats come to one; then it is proved exactly."""


def decide_congruence(text: str, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Return the decision on a congruence of a page's text; None for other relations."""
    is_congruence = any(relation.sign in ("≡", "=") for relation in chain.relations)
    modulus = modulus_at(text, chain.sides[-1].span[1]) if is_congruence else None
    if modulus is None or modulus.value is None:
        unread = "the modulus is not read: write (mod 4), (mod 360°) or (mod N)"
        is_typed = modulus is not None
        return Decision(UNDECIDED, unread) if is_typed else _whole_turns_apart(text, chain, k, knowledge)
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


def _whole_turns_apart(text: str, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Return the proof of θ ≡ 40° after θ = 400°: of angles in degrees nobody has to type the 360°."""
    left, right = chain.sides[k], chain.sides[k + 1]
    is_of_degrees = chain.relations[k].sign == "≡" and _DEGREES.search(text, *right.span) is not None
    if not is_of_degrees or names(right.node) or not isinstance(left.node, Name):
        return None
    turn = Product((Number(Fraction(2)), Constant("pi")))
    ratio = _ratio(Sum((left.node, Negative(right.node))), turn, knowledge)
    if ratio is None or abs(ratio - round(ratio)) >= _NEAR:
        return None
    further = Sum((right.node, Product((Number(Fraction(round(ratio))), turn))))
    decision = decide_equality(left.node, further, knowledge)
    return replace(decision, reason="modulo 360°") if decision.is_proved else None


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
