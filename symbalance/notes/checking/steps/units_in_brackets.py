"""Formulas with a unit behind each letter, beside one between quantities: P[kW] = T[Nm] n[rpm]/5252.

The constant of such a formula turns its units into one another. What the page says of the quantities
themselves, P = T ω, with the angular speed 2π n of n revolutions, fixes it: 9549 here, and 5252 for hp
and lb-ft.
"""

from __future__ import annotations

from dataclasses import replace
from math import pi

from symbalance.document.formula import Formula, Name, names, walk
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.meant.letter_units import unit_in_brackets
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.units.own_units import ANGULAR_LETTERS
from symbalance.notes.checking.units.stated_units import StatedUnit, are_near, powers_of, scale_between
from symbalance.notes.checking.verdicts import Verdict
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_IN_BRACKETS = re.compile(r"\[\s*([^\[\]]{1,40}?)\s*\]\s*$")
_A_TURN = 2 * pi


def unless_units_in_brackets(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a formula between numbers of units is judged by that between the quantities."""
    head, right = chain.sides[0].node, chain.sides[1].node
    is_plain = not k and len(chain.relations) == 1 and chain.relations[0].sign in "=≈"
    if not is_plain or not isinstance(head, Name) or not names(right):
        return verdict
    units = _units_of(state, chain)
    if head.name not in units or not names(right) <= units.keys():
        return verdict
    powers = powers_of(right)
    scale = None if powers is None else scale_between(head.name, powers[1], units)
    if powers is None or scale is None:
        return verdict
    for formula, line in _formulas_above(state, head, chain):
        wanted = _with_turns(formula, names(right), units)
        if wanted is None or wanted[1] != powers[1]:
            continue
        constant = wanted[0] * scale
        shown = f"the factor between these units is {constant:.4g}, by line {line}"
        if are_near(powers[0], constant):
            return describe(state.document, chain, k, Decision(PROVED, assumptions=(shown,)))
        state.definitions.forget(head.name, chain.lines[0])
        inverse = f", or 1/{1 / constant:.5g}" if constant < 1 else ""
        refuted = Decision(
            REFUTED, f"the factor between these units is {constant:.4g}{inverse}, by line {line}"
        )
        return replace(describe(state.document, chain, k, refuted), fix=None)
    return verdict


def _units_of(state: JudgingState, chain: Chain) -> dict[str, StatedUnit | None]:
    """Return the units that stand in square brackets behind the letters of a relation."""
    found: dict[str, StatedUnit | None] = {}
    for side in chain.sides[:2]:
        for part in walk(side.node):
            if not isinstance(part, Name):
                continue
            match = _IN_BRACKETS.search(state.document.source(part.span))
            unit = None if match is None else unit_in_brackets(match[1], part.span[0])
            if unit is not None:
                found[part.name] = unit
    return found


def _formulas_above(state: JudgingState, head: Name, chain: Chain) -> list[tuple[Formula, int]]:
    """Return what lines above say a letter is, in letters without units, the last one first."""
    above = reversed(state.sections.chains_above(head, chain.start))
    return [
        (side.node, c.lines[0])
        for c in above
        for side in c.sides[1:]
        if names(side.node) and side.span[0] not in state.refuted
        if "[" not in state.document.source(side.span)
    ]


def _with_turns(
    formula: Formula, own: frozenset[str], units: dict[str, StatedUnit | None]
) -> tuple[float, dict[str, object]] | None:
    """Return the factor and powers of a formula with 2π n for its angular speed, if only n is at hand."""
    angular = [n for n in names(formula) - own if n.partition("_")[0] in ANGULAR_LETTERS]
    turning = sorted(own - names(formula))
    if len(angular) > 1 or len(angular) != len(turning):
        return None
    if angular:
        try:
            formula = substitute(formula, angular[0], Name(turning[0]))
        except NoFormError:
            return None
    powers = powers_of(formula)
    if powers is None:
        return None
    factor, letters = powers
    if angular:
        factor *= _A_TURN ** float(letters[turning[0]])
    return factor, dict(letters)
