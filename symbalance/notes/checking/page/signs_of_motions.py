"""Which way a page counts a velocity or an acceleration whose declaration does not say it.

Where x is the height of the piston pin above the crank's centre, v = dx/dt is negative on the way down,
and v = -r ω sin(θ + β)/cos β is right. The page's own formulas tell: a letter that is more often the
negative of the quantity towards the crank is counted away from it, and so it is on the whole page.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from itertools import islice

from symbalance.document.formula import Call, Formula, Name, names, walk
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.algebra.tree_values import sample_trees
from symbalance.notes.checking.declared.motion_directions import AWAY, direction_of
from symbalance.notes.checking.declared.sidecar import Declarations
from symbalance.notes.checking.declared.symbol_roles import FROM_MIDDLE, FROM_PIN, FROM_TOP, role_of
from symbalance.notes.checking.declared.symbols import meaning_of
from symbalance.notes.reading.equations import Chain, ReadNotes

_MOTIONS = ("piston velocity", "piston acceleration")
_NEAR = 0.4
"""Relative difference of a formula to what it is taken for: a slip in a small term leaves less."""
_HEIGHT, _AS_HEIGHT = "height of the piston pin", 0.02
"""A letter that no page has, and the relative difference of a formula to it: that of a short series."""
_MOST = 12
"""Formulas of one letter that are looked at."""


def with_signs_of_motions(page: ReadNotes, declarations: Declarations) -> tuple[ReadNotes, Declarations]:
    """Return a page and its declarations with the direction of each motion that the page counts upwards.

    Only where a letter is declared the height above the crank, or has its formula, and none is declared
    the way from top dead centre.
    """
    symbols = declarations.symbols
    roles = {role_of(text) for text in symbols.values()}
    if FROM_TOP in roles:
        return page, declarations
    open_letters = [
        n for n, text in symbols.items() if role_of(text) in _MOTIONS and not direction_of(text)
    ]
    if not open_letters or not (roles & {FROM_PIN, FROM_MIDDLE} or _has_height(page, symbols)):
        return page, declarations
    meaning, changed, notes = meaning_of(symbols)[0], dict(symbols), list[str]()
    for name in open_letters:
        lines = _upward_lines(name, page, meaning)
        if lines:
            changed[name] = f"{symbols[name]}, {AWAY}"
            notes.append(f"{name} is counted {AWAY}, as in line {lines[0]}")
    return replace(page, notes=(*page.notes, *notes)), replace(declarations, symbols=changed)


def _upward_lines(name: str, page: ReadNotes, meaning: SymbolValue) -> list[int]:
    """Return the lines that give a letter the negative of its quantity, if no fewer than give it that."""
    formulas = [(node, chain.lines[0]) for chain in page.chains for node in _formulas(name, chain)][
        :_MOST
    ]
    signs = [(_sign(name, node, meaning), line) for node, line in formulas]
    upward = [line for sign, line in signs if sign < 0]
    return upward if len(upward) >= sum(sign > 0 for sign, _ in signs) else []


def _has_height(page: ReadNotes, symbols: Mapping[str, str]) -> bool:
    """Tell whether a formula of the page is the height of the piston pin: x = r cos θ + l cos β."""
    meaning = meaning_of({**symbols, _HEIGHT: FROM_PIN})[0]
    formulas = (
        side.node
        for chain in page.chains
        if isinstance(chain.sides[0].node, Name) and chain.sides[0].node.name not in meaning.positive
        for side in chain.sides[1:]
        if any(isinstance(part, Call) for part in walk(side.node))
    )
    return any(_sign(_HEIGHT, node, meaning, _AS_HEIGHT) > 0 for node in islice(formulas, _MOST))


def _formulas(name: str, chain: Chain) -> list[Formula]:
    """Return the sides of a chain that begins with a letter, but those that name it again."""
    if chain.sides[0].node != Name(name):
        return []
    return [side.node for side in chain.sides[1:] if name not in names(side.node)]


def _sign(name: str, node: Formula, meaning: SymbolValue, near: float = _NEAR) -> int:
    """Return whether a formula is a letter's quantity, 1, its negative, -1, or neither, 0."""
    rows = [row for _, row in sample_trees([Name(name), node], meaning)]
    scale = max((abs(own) for own, _ in rows), default=0)
    for sign in (1, -1):
        if rows and all(abs(own - sign * value) <= near * scale for own, value in rows):
            return sign
    return 0
