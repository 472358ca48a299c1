r"""Terms of one sum that differ in nothing but the power of a rate: ½ J_1 φ̇_1 + ½ J_2 φ̇_2².

Masses and moments of inertia with the same stem, J_1 and J_2, are of one dimension, and so are the
rates of φ_1 and φ_2: such terms cannot be added. Of dampers, d_1 ẋ_1 + d_2 ẋ_2², nothing is said.
"""

from __future__ import annotations

from collections.abc import Iterator
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
    if len(unlike) != 1 or not unlike[0][1] or len(first) < 2:
        return None
    return unlike[0] if min(first[unlike[0]], second[unlike[0]]) > 0 else None


def _indices(term: Formula) -> set[str]:
    """Return the letters of a term with their subscripts; one without is of no numbered kind."""
    own = {part.name for part in walk(term) if isinstance(part, Name)} - {"t"}
    return own if all("_" in name for name in own) else own | {""}


def _powers(term: Formula) -> dict[Kind, Fraction]:
    """Return the powers of the kinds of letters in a product, nothing for what is no such product."""
    powers: dict[Kind, Fraction] = {}
    for factor, power in _factors(term, Fraction(1)):
        letter = factor.expression if isinstance(factor, Derivative) else factor
        in_time = not isinstance(factor, Derivative) or factor.variable.name == "t"
        if not isinstance(letter, Name) or not in_time:
            return {}
        kind = letter.name.partition("_")[0], factor.order if isinstance(factor, Derivative) else 0
        powers[kind] = powers.get(kind, Fraction(0)) + power
    return powers


def _factors(node: Formula, power: Fraction) -> Iterator[tuple[Formula, Fraction]]:
    """Yield the factors of a product with their powers, numbers left out."""
    if isinstance(node, Negative):
        yield from _factors(node.operand, power)
    elif isinstance(node, Product):
        for factor in node.factors:
            yield from _factors(factor, power)
    elif isinstance(node, Quotient):
        yield from _factors(node.numerator, power)
        yield from _factors(node.denominator, -power)
    elif isinstance(node, Power) and isinstance(node.exponent, Number):
        yield from _factors(node.base, power * node.exponent.value)
    elif not isinstance(node, Number | Constant):
        yield node, power
