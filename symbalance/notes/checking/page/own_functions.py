"""Functions that a page defines itself: S(k) = (1-k)² + k², then S'(k), dS/dk and S(1/2).

S is the formula, S(k) is S, S(1/2) its value there, and S'(k) its derivative by k. A letter that is given
as a function of two different letters, f(x) and f(t), is left as it is.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from symbalance.document.formula import (
    Apply,
    Derivative,
    Evaluation,
    Formula,
    Name,
    Power,
    Product,
    Span,
    children,
    names,
    walk,
    with_children,
)
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.text import lazy_patterns as re

HIGHEST = 3
"""Dashes behind a function, f'''."""
_SIGNS = ("=", "≈", "≡")
_BRACKET = re.compile(r"(?:\\left\s?)?\(")
_OF_TIME = re.compile(r"\(\s?\\?(?P<letter>[^\W\d_]+)\s?\)$")
"""The t of x(t), which is read as x."""


def with_own_functions(document: ReadNotes) -> ReadNotes:
    """Return a page with its own functions as letters that have formulas."""
    variables = _functions(document)
    if not variables:
        return document
    chains = tuple(_chain(chain, document.text, variables) for chain in document.chains)
    return replace(document, chains=chains)


def _functions(document: ReadNotes) -> dict[str, str]:
    """Return the letters that a page defines as functions, each with the letter it is a function of."""
    variables: dict[str, set[str]] = {}
    for chain in document.chains:
        for part in (part for side in chain.sides for part in walk(side.node)):
            if isinstance(part, Name) and (place := _OF_TIME.search(document.source(part.span))):
                variables.setdefault(part.name, set()).add(place["letter"])
            applied = _applied(part)
            if applied is not None and isinstance(applied[1], Name):
                variables.setdefault(applied[0].name.rstrip("'"), set()).add(applied[1].name)
    defined = {name for chain in document.chains if (name := _defined(chain))}
    return {name: min(variables[name]) for name in defined if len(variables.get(name, ())) == 1}


def _applied(node: Formula) -> tuple[Name, Formula] | None:
    """Return the letter and the place of a letter with a place behind it, None for other formulas."""
    if not isinstance(node, Apply) or node.function != "at":
        return None
    letter, place = node.arguments
    return (letter, place) if isinstance(letter, Name) else None


def _defined(chain: Chain) -> str:
    """Return the function that a chain gives a formula in its variable, "" for none."""
    head = _applied(chain.sides[0].node)
    if head is None or not chain.relations or chain.relations[0].sign not in _SIGNS:
        return ""
    (letter, place), right = head, names(chain.sides[1].node)
    is_own = isinstance(place, Name) and place.name in right and letter.name not in right
    return letter.name if is_own else ""


def _chain(chain: Chain, text: str, variables: Mapping[str, str]) -> Chain:
    sides = (
        replace(side, readings=tuple(_written_out(node, text, variables) for node in side.readings))
        for side in chain.sides
    )
    changed = replace(chain, sides=tuple(sides))
    return chain if changed.sides == chain.sides else changed


def _written_out(node: Formula, text: str, variables: Mapping[str, str]) -> Formula:
    """Return a formula with the page's functions as letters, derivatives and values at a place."""
    parts = [_written_out(part, text, variables) for part in children(node)]
    if (applied := _applied(node)) is not None:
        value = _at_place(applied[0], parts[1], node.span, variables)
        return with_children(node, tuple(parts)) if value is None else value
    if isinstance(node, Product):
        parts = _factors(parts, text, variables)
        if len(parts) == 1:
            return parts[0]
        return replace(node, factors=tuple(parts)) if tuple(parts) != node.factors else node
    is_same = all(a is b for a, b in zip(parts, children(node), strict=True))
    return node if is_same else with_children(node, tuple(parts))


def _factors(factors: list[Formula], text: str, variables: Mapping[str, str]) -> list[Formula]:
    """Return the factors of a product; a bracket right behind a function has its place: S(1 - k)²."""
    result: list[Formula] = []
    for factor in factors:
        last = result[-1] if result else None
        bracket = factor.base if isinstance(factor, Power) else factor
        if isinstance(last, Name) and _BRACKET.match(text, last.span[1], factor.span[1]):
            is_behind = factor.span[0] == last.span[1]
            value = _at_place(last, bracket, (last.span[0], factor.span[1]), variables)
            if is_behind and value is not None:
                result[-1] = replace(factor, base=value) if isinstance(factor, Power) else value
                continue
        result.append(factor)
    return result


def _at_place(
    letter: Formula, place: Formula, span: Span, variables: Mapping[str, str]
) -> Formula | None:
    """Return a function of the page at a place; None for any other letter."""
    name = letter.name if isinstance(letter, Name) else ""
    stem = name.rstrip("'")
    order, variable = len(name) - len(stem), variables.get(stem)
    if variable is None or order > HIGHEST:
        return None
    value: Formula = Name(stem, span=span)
    if order:
        value = Derivative(value, Name(variable), order, span=span)
    return value if place == Name(variable) else Evaluation(value, Name(variable), place, span=span)
