"""What a relation claims of a letter, in the letters of a standard formula: numbers put in, ±, sizes.

8879 (1 + 0.27 - 0.5) is F_0 (1 + λ - β) where these have the numbers, and Q cos θ is m r ω² cos θ where a
line above has Q = m r ω².
"""

from __future__ import annotations

from collections.abc import Collection
from fractions import Fraction

from symbalance.document.formula import (
    Call,
    Formula,
    Name,
    Number,
    PlusMinus,
    Power,
    Product,
    Quotient,
    children,
    names,
    walk,
)
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.substitution import replace_part, substitute

_MASSES, _ARMS = (
    frozenset({"m", "M", "B", "G", "W", "Q"}),
    frozenset({"r", "R", "b", "e", "rho", "a", "s", "y", "bar_y"}),
)
_SMALL_NUMBERS = frozenset(map(Fraction, range(1, 10)))
"""Numbers that stand for themselves in a formula with numbers put in."""


def name_of_head(node: Formula) -> str:
    """Return the letter that a formula is, or the two of a product m_A r_A; "" for anything else."""
    if isinstance(node, Name):
        return node.name
    factors = node.factors if isinstance(node, Product) else ()
    both = [part.name for part in factors if isinstance(part, Name)]
    stems = [name if name == "bar_y" else name.partition("_")[0] for name in both]
    is_moment = len(factors) == 2 and len(both) == 2 and stems[0] in _MASSES and stems[1] in _ARMS
    return " ".join(both) if is_moment else ""


def with_sizes(claim: Formula, knowledge: Knowledge) -> Formula:
    """Return a formula with each letter that the page defines as a product of letters put in."""
    for letter in sorted(names(claim)):
        definition = knowledge.definitions.get(letter)
        node = None if definition is None or definition.numeric else definition.node
        is_product = isinstance(node, Product) and all(isinstance(f, Name | Power) for f in node.factors)
        if node is not None and is_product and not names(node) & {letter}:
            claim = substitute(claim, letter, node)
    return claim


def with_ratios(claim: Formula, knowledge: Knowledge) -> Formula:
    """Return a formula with each letter put in that the page defines as a ratio n_1/n_2 of one kind."""
    for letter in sorted(names(claim)):
        definition = knowledge.definitions.get(letter)
        node = None if definition is None or definition.numeric else definition.node
        if not isinstance(node, Quotient):
            continue
        both = [part.name for part in (node.numerator, node.denominator) if isinstance(part, Name)]
        stems = {name.partition("_")[0] for name in both if name.partition("_")[2]}
        if len(both) == 2 and len(stems) == 1 and all("_" in name for name in both):
            claim = substitute(claim, letter, node)
    return claim


def in_letters(claim: Formula, knowledge: Knowledge, stated: Collection[Fraction]) -> Formula:
    """Return numbers put in as the letters that have them, 8879 (1 + 0.27 - 0.5) as F_0 (1 + λ - β).

    It stays as it is where a number is of two letters, or one with decimals of none.
    """
    letters: dict[Fraction, set[str]] = {}
    for name, definition in knowledge.definitions.items():
        for node in (definition.node, definition.rounded):
            if isinstance(node, Number):
                letters.setdefault(node.value, set()).add(name)
    numbers = {part for part in walk(claim) if isinstance(part, Number)}
    result = claim
    for number in sorted(numbers, key=lambda n: n.value):
        own = letters.get(number.value, set())
        is_count = number.value in _SMALL_NUMBERS and number.last_place is None
        if is_count or (not own and number.value in stated):
            continue
        if len(own) != 1:
            return claim
        result = replace_part(result, number, Name(next(iter(own))))
    return result


def with_exact_halves(node: Formula, stated: Collection[Fraction]) -> Formula:
    """Return a formula with 0.5 and 4.5 as the halves and quarters that they are, or a stated number."""
    for part in [p for p in walk(node) if isinstance(p, Number)]:
        if part.last_place is not None and (part.value.denominator in (2, 4) or part.value in stated):
            node = replace_part(node, part, Number(part.value))
    return node


def without_plus_minus(node: Formula) -> Formula:
    """Return the size of what is written with ± before it."""
    if isinstance(node, PlusMinus):
        return node.operand
    if isinstance(node, Product) and isinstance(node.factors[0], PlusMinus):
        return Product((node.factors[0].operand, *node.factors[1:]))
    return node


def outside_calls(node: Formula) -> frozenset[str]:
    """Return the letters of a formula that stand elsewhere than in a sine or cosine."""
    if isinstance(node, Name):
        return frozenset({node.name})
    if isinstance(node, Call) and node.function != "sqrt":
        return frozenset()
    return frozenset(name for part in children(node) for name in outside_calls(part))
