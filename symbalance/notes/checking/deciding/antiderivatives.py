"""Decisions on integrals without bounds, which are known up to a constant: ∫ x² dx = x³/3 + C.

Both sides are differentiated by the letter of the integral, whose sign goes away with that. What an
author leaves out, the constant, is named as an assumption where no letter stands for it.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import (
    Derivative,
    Formula,
    Integral,
    Name,
    Negative,
    Number,
    Product,
    Quotient,
    Sum,
    children,
    names,
    walk,
    with_children,
)
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge

UP_TO_A_CONSTANT = "a constant of integration is left out"
_ZERO = Number(Fraction(0))


def decide_antiderivatives(
    left: Formula,
    right: Formula,
    knowledge: Knowledge,
    decide: Callable[[Formula, Formula, Knowledge], Decision],
) -> Decision | None:
    """Return the decision on a relation with integrals without bounds, by its derivative; else None.

    None too where a side does not say on what it depends: W = ∫ p dV names a quantity, and gives no
    antiderivative.
    """
    parts = [part for node in (left, right) for part in walk(node)]
    variables = {
        part.variable for part in parts if isinstance(part, Integral) and is_without_bounds(part)
    }
    if len(variables) != 1:
        return None
    (variable,) = variables
    if not any(_is_written_out(node, variable.name) for node in (left, right)):
        return None
    sides = [_derivative(node, variable) for node in (left, right)]
    if sides[0] is None or sides[1] is None:
        return None
    name = variable.name
    free = replace(
        knowledge,
        definitions={n: d for n, d in knowledge.definitions.items() if n != name},
    )
    decision = decide(sides[0], sides[1], free)
    if not decision.is_proved or _has_constant(left, right, name):
        return decision
    if all(map(_has_integral, (left, right))):
        return decision
    return replace(decision, assumptions=(*decision.assumptions, UP_TO_A_CONSTANT))


def is_without_bounds(node: Formula) -> bool:
    """Tell whether a formula is an integral without bounds, and not over a closed path."""
    return isinstance(node, Integral) and node.lower is None and node.upper is None and not node.closed


def _is_written_out(node: Formula, name: str) -> bool:
    """Tell whether a side has a term in the letter of the integral that is no integral itself."""
    terms = node.terms if isinstance(node, Sum) else (node,)
    return any(name in names(term) and not _has_integral(term) for term in terms)


def _has_integral(node: Formula) -> bool:
    return any(is_without_bounds(part) for part in walk(node))


def _derivative(node: Formula, variable: Name) -> Formula | None:
    """Return a side differentiated by a letter; None where an integral stands within another formula."""
    if isinstance(node, Integral) and is_without_bounds(node):
        return node.body
    if not _has_integral(node):
        return Derivative(node, variable) if variable.name in names(node) else _ZERO
    if not _is_linear(node, variable.name):
        return None
    parts = [_derivative(part, variable) if _has_integral(part) else None for part in children(node)]
    if isinstance(node, Sum):
        parts = [_derivative(part, variable) for part in node.terms]
        return None if None in parts else Sum(tuple(part for part in parts if part is not None))
    inner = [own or part for own, part in zip(parts, children(node), strict=True)]
    is_open = any(own is None and _has_integral(part) for own, part in zip(parts, inner, strict=True))
    return None if is_open else with_children(node, tuple(inner))


def _is_linear(node: Formula, name: str) -> bool:
    """Tell whether a formula has its one integral without anything beside it that depends on a letter."""
    if isinstance(node, Sum | Negative):
        return True
    if not isinstance(node, Product | Quotient):
        return False
    others = [part for part in children(node) if not _has_integral(part)]
    is_below = isinstance(node, Quotient) and _has_integral(node.denominator)
    return (
        len(others) == len(children(node)) - 1
        and not is_below
        and not any(name in names(p) for p in others)
    )


def _has_constant(left: Formula, right: Formula, name: str) -> bool:
    """Tell whether a term of letters stands for the constant of an integral: x³/3 + C, g t + v_0."""
    terms = [term for node in (left, right) if isinstance(node, Sum) for term in node.terms]
    return any(names(term) and name not in names(term) for term in terms)
