r"""Terms of one sum that differ in nothing but the power of a rate: ½ J_1 φ̇_1 + ½ J_2 φ̇_2².

Masses and moments of inertia with the same stem, J_1 and J_2, are of one dimension, and so are the rates of
φ_1 and φ_2: such terms cannot be added. Of dampers, d_1 ẋ_1 + d_2 ẋ_2², nothing is said.
"""

from __future__ import annotations

from collections import Counter
from fractions import Fraction
from itertools import combinations

from symbalance.document.formula import (
    Constant,
    Derivative,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    walk,
)
from symbalance.document.text_writer import formula_text

_INERTIAS = frozenset({"m", "M", "J", "I", "Theta"})
"""Letters of masses and moments of inertia: what stands with them has one dimension."""
Kind = tuple[str, int]
"""The stem of a letter, and how often it is differentiated by the time."""


def unlike_terms(node: Formula) -> str:
    """Return why two terms of a sum in a formula cannot be added, "" where nothing says so."""
    for part in walk(node):
        if not isinstance(part, Sum):
            continue
        for one, other in combinations(part.terms, 2):
            if (kind := _unlike_rate(one, other)) is not None:
                terms = " and ".join(formula_text(_bare(term), plain=True) for term in (one, other))
                powers = " and ".join(str(_powers(term)[kind]) for term in (one, other))
                return f"dimensions: {terms} hold one kind of rate to the powers {powers}"
    return ""


def _bare(term: Formula) -> Formula:
    return term.operand if isinstance(term, Negative) else term


def _unlike_rate(one: Formula, other: Formula) -> Kind | None:
    """Return the rate whose power alone is another in two terms of the same kinds of letters."""
    first, second = _powers(one), _powers(other)
    if first.keys() != second.keys() or _indices(one) & _indices(other):
        return None
    if not all(order or stem in _INERTIAS for stem, order in first):
        return None
    unlike = [kind for kind in first if first[kind] != second[kind]]
    is_rate = len(unlike) == 1 and unlike[0][1] > 0
    return unlike[0] if is_rate and len(first) > 1 and min(first[unlike[0]], second[unlike[0]]) > 0 else None


def _indices(term: Formula) -> set[str]:
    """Return the letters of a term with their subscripts; one without is of no numbered kind."""
    own = {part.name for part in walk(term) if isinstance(part, Name)} - {"t"}
    return own if all("_" in name for name in own) else own | {""}


def _powers(term: Formula) -> Counter[Kind]:
    """Return the powers of the kinds of letters in a product, nothing for what is no product of powers."""
    powers: Counter[Kind] = Counter()
    return powers if _count(term, Fraction(1), powers) else Counter()


def _count(node: Formula, power: Fraction, powers: Counter[Kind]) -> bool:
    if isinstance(node, Number | Constant):
        return True
    if isinstance(node, Negative):
        return _count(node.operand, power, powers)
    if isinstance(node, Product):
        return all([_count(factor, power, powers) for factor in node.factors])
    if isinstance(node, Quotient):
        return _count(node.numerator, power, powers) and _count(node.denominator, -power, powers)
    if isinstance(node, Power) and isinstance(node.exponent, Number):
        return _count(node.base, power * node.exponent.value, powers)
    order = node.order if isinstance(node, Derivative) else 0
    letter = node.expression if isinstance(node, Derivative) else node
    if not isinstance(letter, Name) or (isinstance(node, Derivative) and node.variable.name != "t"):
        return False
    powers[letter.name.partition("_")[0], order] += power  # type: ignore[assignment]
    return True
