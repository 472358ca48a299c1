"""Functions that a page defines itself: S(k) = (1-k)² + k², then S'(k), dS/dk and S(1/2).

S is the formula, S(k) is S, S(1/2) its value there, and S'(k) its derivative by k. A letter that is given
as a function of two different letters, f(x) and f(t), is left as it is.

J' without its place is the derivative too, where J(φ) has a wave of φ and J' is declared as no other
letter: a prime is a mark like any other elsewhere, J' = J + m r². Where the page says that its primes are
derivatives by a letter, all of them are.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from symbalance.document.formula import (
    Apply,
    Call,
    Derivative,
    Evaluation,
    Formula,
    Name,
    Power,
    Product,
    Span,
    Sum,
    children,
    names,
    walk,
    with_children,
    with_parts_changed,
)
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.notes.reading.letters.primes_said import variable_of_primes
from symbalance.text import lazy_patterns as re

HIGHEST = 3
"""Dashes behind a function, f'''."""
_SIGNS = ("=", "≈", "≡")
_BRACKET = re.compile(r"(?:\\left\s?)?\(")
_OF_TIME = re.compile(r"\(\s?\\?(?P<letter>[^\W\d_]+)\s?\)$")
"""The t of x(t), which is read as x."""


_DERIVATIVE = re.compile(
    r"derivative|ableitung|dérivée|deriva(?:ta|da)|afgeleide|derivata|pochodn|derivac|微分|導関数|rate",
    re.IGNORECASE,
)
"""Words of a declaration by which J' is what its prime says."""


def with_own_functions(document: ReadNotes, symbols: Mapping[str, str] | None = None) -> ReadNotes:
    """Return a page with its own functions as letters with formulas; `symbols` are those declared."""
    of_one = _variables(document)
    defined = {name for chain in document.chains if (name := _defined(chain))}
    variables = {name: variable for name, variable in of_one.items() if name in defined}
    chains = document.chains
    if variables:
        chains = tuple(_chain(chain, document.text, variables) for chain in chains)
    said = variable_of_primes(document.text)
    primed = _primed(chains, of_one, symbols or {}) | _primed_as_said(chains, said, symbols or {})
    if primed:
        chains = tuple(_with_derivatives(chain, primed) for chain in chains)
    return document if chains is document.chains else replace(document, chains=chains)


def _primed(
    chains: tuple[Chain, ...], variables: Mapping[str, str], symbols: Mapping[str, str]
) -> dict[str, Derivative]:
    """Return the derivatives that letters with primes are, those of functions that have a wave."""
    own = {part.name for c in chains for s in c.sides for part in walk(s.node) if isinstance(part, Name)}
    sides = [(c.sides[0].node, side.node) for c in chains for side in c.sides[1:]]
    primed: dict[str, Derivative] = {}
    for name in own:
        stem = name.rstrip("'")
        order, variable = len(name) - len(stem), variables.get(stem)
        if variable is None or not 0 < order <= HIGHEST:
            continue
        own_formulas = [right for left, right in sides if left == Name(stem)]
        has_wave = any(_has_wave_of(right, variable) for right in own_formulas)
        is_other = any(left == Name(name) and stem in names(right) for left, right in sides)
        is_told = _DERIVATIVE.search(symbols[name]) is not None if name in symbols else has_wave
        if is_told and not is_other:
            primed[name] = Derivative(Name(stem), Name(variable), order)
    return primed


def _primed_as_said(
    chains: tuple[Chain, ...], variable: str, symbols: Mapping[str, str]
) -> dict[str, Derivative]:
    """Return the derivatives that all letters with primes are by the page's words; none without words.

    A letter that is declared as something else is that, and so is one that adds to its bare letter.
    """
    own = [part.name for c in chains for s in c.sides for part in walk(s.node) if isinstance(part, Name)]
    sides = [(c.sides[0].node, side.node) for c in chains for side in c.sides[1:]]
    primed: dict[str, Derivative] = {}
    for name in sorted(set(own)) if variable else ():
        stem = name.rstrip("'")
        order = len(name) - len(stem)
        if not 0 < order <= HIGHEST or stem == variable:
            continue
        is_other = any(left == Name(name) and _adds(right, stem) for left, right in sides)
        is_told = name not in symbols or _DERIVATIVE.search(symbols[name]) is not None
        if is_told and not is_other:
            primed[name] = Derivative(Name(stem), Name(variable), order)
    return primed


def _adds(node: Formula, stem: str) -> bool:
    """Tell whether a letter is a term of a sum: in J' = J + m r² the prime makes another letter."""
    return isinstance(node, Sum) and Name(stem) in node.terms


def _has_wave_of(node: Formula, variable: str) -> bool:
    return any(isinstance(part, Call) and variable in names(part.argument) for part in walk(node))


def _with_derivatives(chain: Chain, primed: Mapping[str, Derivative]) -> Chain:
    """Return a chain with derivatives for letters with primes."""

    def changed(node: Formula) -> Formula:
        if isinstance(node, Name) and node.name in primed:
            return replace(primed[node.name], span=node.span)
        return with_parts_changed(node, changed)

    sides = tuple(replace(side, readings=tuple(map(changed, side.readings))) for side in chain.sides)
    return replace(chain, sides=sides) if sides != chain.sides else chain


def _variables(document: ReadNotes) -> dict[str, str]:
    """Return the letters that a page has as functions, each with the one letter it is a function of."""
    variables: dict[str, set[str]] = {}
    every = [part for chain in document.chains for side in chain.sides for part in walk(side.node)]
    sources = [(part, document.source(part.span)) for part in every if isinstance(part, Name)]
    written = {source.strip().lstrip("\\"): part.name for part, source in sources}  # \ph of a macro
    for chain in document.chains:
        for part in (part for side in chain.sides for part in walk(side.node)):
            if isinstance(part, Name) and (place := _OF_TIME.search(document.source(part.span))):
                variable = written.get(place["letter"], place["letter"])
                if variable != part.name:
                    variables.setdefault(part.name, set()).add(variable)
            applied = _applied(part)
            if applied is not None and isinstance(applied[1], Name):
                variables.setdefault(applied[0].name.rstrip("'"), set()).add(applied[1].name)
    return {name: min(own) for name, own in variables.items() if len(own) == 1}


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
