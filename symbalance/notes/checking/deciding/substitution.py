"""Substitution in formulas: a letter, or one part, replaced by another formula."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction

from symbalance.document import formula
from symbalance.document.formula import (
    Derivative,
    Formula,
    Name,
    Number,
    Product,
    Quotient,
    Summation,
    names,
)
from symbalance.notes.algebra.domain import NoFormError


def substitute(node: Formula, name: str, value: Formula) -> Formula:
    """Return a formula with a letter replaced; a sum's own index is another letter of the same name.

    Raises NoFormError for a derivative by the letter: d/dx of a value at one x is no formula.
    """
    if isinstance(node, Name) and node.name == name:
        return value
    if isinstance(node, Derivative) and node.variable.name == name:
        raise NoFormError(f"a derivative by {name}, which is given a value")
    bound = bound_letter(node)
    if bound == name:
        raise NoFormError(f"{name}, which is bound within, is given a value")
    if isinstance(node, Summation) and node.index is not None and node.index.name == name:
        bounds = {"lower": node.lower, "upper": node.upper}
        return replace(
            node, **{key: part and substitute(part, name, value) for key, part in bounds.items()}
        )
    return formula.with_parts_changed(node, lambda part: substitute(part, name, value))


def put_in(node: Formula, values: Mapping[str, Formula]) -> Formula:
    """Return a formula with the values of its letters put in; what stands in these stays as it is."""
    for name in names(node) & values.keys():
        node = substitute(node, name, values[name])
    return node


def bound_letter(node: Formula) -> str:
    """Return the letter that an integral, a limit or the like binds, "" if it is none."""
    if isinstance(node, formula.Integral | formula.Evaluation | formula.Limit | formula.Extremum):
        return node.variable.name
    return node.index.name if isinstance(node, formula.IndexedProduct) else ""


def replace_part(node: Formula, old: Formula, new: Formula) -> Formula:
    """Return a formula with one of its parts (that very object) replaced."""
    if node is old:
        return new
    return formula.with_parts_changed(node, lambda part: replace_part(part, old, new))


def with_every(node: Formula, old: Formula, new: Formula) -> Formula:
    """Return a formula with each part that equals another formula replaced."""
    if node == old:
        return new
    return formula.with_parts_changed(node, lambda part: with_every(part, old, new))


def without_stacked_fractions(node: Formula) -> Formula:
    """Return a formula without fractions below a fraction: a/(b/c) is a c/b.

    >>> from symbalance.document.text_writer import formula_text
    >>> from symbalance.document.formula import Number
    >>> one = Number(Fraction(1))
    >>> quarter = Quotient(one, Product((Number(Fraction(4)), Quotient(one, Name("l")))))
    >>> formula_text(without_stacked_fractions(quarter), plain=True)
    'l/4'
    """
    parts = tuple(without_stacked_fractions(part) for part in formula.children(node))
    if parts != formula.children(node):
        node = formula.with_children(node, parts)
    if not isinstance(node, Quotient):
        return node
    factors = node.denominator.factors if isinstance(node.denominator, Product) else (node.denominator,)
    factors_above = [f.denominator for f in factors if isinstance(f, Quotient)]
    if not factors_above:
        return node
    below = [f.numerator if isinstance(f, Quotient) else f for f in factors]
    above, denominator = _product([node.numerator, *factors_above]), _product(below)
    return above if denominator == Number(Fraction(1)) else Quotient(above, denominator)


def _product(factors: list[Formula]) -> Formula:
    rest = [f for f in factors if f != Number(Fraction(1))] or [Number(Fraction(1))]
    return rest[0] if len(rest) == 1 else Product(tuple(rest))
