"""A corrected formula as a person writes it: no factor 1, no term 0, no product within a product."""

from __future__ import annotations

from collections.abc import Collection
from fractions import Fraction
from math import prod

from symbalance.document import formula
from symbalance.document.formula import (
    Constant,
    Formula,
    Negative,
    Number,
    Product,
    Quotient,
    Sum,
)


def tidied(node: Formula, own: Collection[int] = ()) -> Formula:
    """Return a formula of the same value; parts whose `id` is in `own` stay as their author wrote them.

    >>> from symbalance.document.text_writer import formula_text
    >>> from symbalance.document.formula import Name
    >>> one, two, x = Number(Fraction(1)), Number(Fraction(2)), Name("x")
    >>> formula_text(tidied(Product((two, Product((one, x)))))), formula_text(tidied(Quotient(x, one)))
    ('2x', 'x')
    """
    parts = formula.children(node)
    if id(node) in own or not parts:
        return node
    changed = formula.with_children(node, tuple(tidied(part, own) for part in parts))
    if isinstance(changed, Product):
        return _product(changed)
    if isinstance(changed, Sum):
        terms = tuple(term for term in changed.terms if not _is(term, 0))
        return _of(terms, Sum, 0) if len(terms) < len(changed.terms) else changed
    if isinstance(changed, Quotient) and (_is(changed.numerator, 0) or _is(changed.denominator, 1)):
        return changed.numerator
    return _negative(changed.operand) if isinstance(changed, Negative) else changed


def _negative(node: Formula) -> Formula:
    """Return a formula with its sign turned, of a sum a positive term in front: −(4a − 3b) is 3b − 4a."""
    if isinstance(node, Negative):
        return node.operand
    if _is(node, 0):
        return node
    if not isinstance(node, Sum):
        return Negative(node)
    terms = [term.operand if isinstance(term, Negative) else Negative(term) for term in node.terms]
    first = next((k for k, term in enumerate(terms) if not isinstance(term, Negative)), 0)
    return Sum((terms[first], *terms[:first], *terms[first + 1 :]))


def _product(node: Product) -> Formula:
    """Return a product with its whole numbers as one in front, those of inner products among them."""
    factors: list[Formula] = []
    sign = 1
    for factor in node.factors:
        inner = factor
        if isinstance(inner, Negative) and isinstance(inner.operand, Product | Number | Constant):
            inner, sign = inner.operand, -sign
        factors += inner.factors if isinstance(inner, Product) else (inner,)
    numbers = [f for f in factors if isinstance(f, Number) and f.last_place is None]
    if len(numbers) == len(factors) and len(factors) > 1:
        return node  # 2 · 3, as somebody calculates
    if any(_is(number, 0) for number in numbers):
        return Number(Fraction(0))
    value = prod((number.value for number in numbers), start=Fraction(1))
    rest = tuple(f for f in factors if f not in numbers)
    first = () if value == 1 else (Number(value),)
    if value.denominator != 1:
        return node
    whole = _of((*first, *rest), Product, 1)
    return Negative(whole) if sign < 0 else whole


def _of(parts: tuple[Formula, ...], kind: type[Sum] | type[Product], empty: int) -> Formula:
    if not parts:
        return Number(Fraction(empty))
    return parts[0] if len(parts) == 1 else kind(parts)


def _is(node: Formula, value: int) -> bool:
    return isinstance(node, Number) and node.value == value
