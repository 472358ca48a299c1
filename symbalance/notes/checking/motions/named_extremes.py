"""The largest or least value of a quantity that has a formula: M = m r ω² (cos θ + λ cos 2θ), M_max.

Nobody has declared M, and its formula says how it changes with the crank angle. What stands for M_max in
the same section, in M's own letters, is compared with the largest size of a turn; the sign of the value
there is as the page counts it.
"""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import Call, Extremum, Formula, Name, Negative, names, walk
from symbalance.notes.algebra.letters_behind import letters_behind, names_behind
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, UNDECIDED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.motions.extreme_sizes import decide_largest_size
from symbalance.notes.checking.motions.extremes import (
    BY_NUMBERS,
    GRID,
    at_dead_centre,
    theta_name,
    values_over_turn,
)
from symbalance.notes.reading.equations import Chain, Side
from symbalance.text import lazy_patterns as re

_LARGEST = re.compile(r"(?P<base>.+)[_,]max|hat_(?P<hat>.+)")


TINY = 1e-6
"""Relative difference of values on the grid: half a turn there is 22/7, and not π."""


_LEAST = re.compile(r"(?P<base>.+)_min")
_MATCHES, _DIFFERS = 1e-4, 0.02
"""Parts of the largest size by which a least value may be off, and from which on it is another."""


def base_of_least(name: str) -> str:
    """Return M of M_min, "" for other letters."""
    match = _LEAST.fullmatch(name)
    return match["base"] if match else ""


def base_of_extreme(name: str) -> str:
    """Return M of M_max and of M_min, "" for other letters."""
    return base_of_largest(name) or base_of_least(name)


def base_of_largest(name: str) -> str:
    """Return M of M_max and of M with a hat, "" for other letters.

    >>> [base_of_largest(name) for name in ("M_max", "hat_F_2", "M_2,max", "M_2")]
    ['M', 'F_2', 'M_2', '']
    """
    match = _LARGEST.fullmatch(name)
    return (match["base"] or match["hat"]) if match else ""


def decide_named_extreme(chain: Chain, knowledge: Knowledge) -> Decision | None:
    """Decide what a line says of the largest value of a letter with a formula; None for nothing.

    It is decided only where the claim has no letter that the formula has not: a force per area has.
    """
    head, right = chain.sides[0], chain.sides[1]
    name = head.node.name if isinstance(head.node, Name) else ""
    base = base_of_extreme(name)
    definition = knowledge.definitions.get(base)
    if not isinstance(head.node, Name) or definition is None or knowledge.has_meaning(head.node.name):
        return None
    values = {n: d.node for n, d in knowledge.definitions.items()} | dict(knowledge.meaning.values)
    behind = {*letters_behind(definition.node, values)}
    theta = theta_name(knowledge)
    inside, own = {*names_behind(definition.node, values)}, names(right.node)
    is_formula = not (definition.numeric or definition.assumption) and theta in behind
    if not is_formula or not own or not own <= inside - {theta}:
        return None
    if _has_branches(definition.node) or any(_has_branches(values.get(name)) for name in inside):
        return None  # of a root the sizes have to be those of an engine
    positive = knowledge.meaning.positive | behind - {theta}  # masses, lengths, speeds: all sizes
    knowledge = replace(knowledge, meaning=replace(knowledge.meaning, positive=positive))
    span = head.span
    if base_of_least(name):
        return _as_least(Name(base, span=span), right, knowledge)
    size = Extremum("max", Call("abs", Name(base, span=span), span=span), Name(theta), span=span)
    decision = decide_largest_size(Side((size,), span), right, chain.relations[0].sign, knowledge)
    if decision is not None and decision.status == UNDECIDED and chain.relations[0].sign == "=":
        decision = _at_its_place(Name(base, span=span), right, knowledge) or decision
    if decision is None or not (decision.is_proved or decision.status == REFUTED):
        return None
    return replace(decision, assumptions=tuple(a for a in decision.assumptions if " ≥ 0" not in a))


def _as_least(motion: Formula, right: Side, knowledge: Knowledge) -> Decision | None:
    """Return whether a formula is the least value of a turn; None where it may be the smallest size."""
    rows = values_over_turn(motion, right.node, knowledge)
    gaps, others = [], []
    for _, turn, claim in rows:
        size = max(abs(value) for value in turn)
        if not size:
            return None
        gaps.append(abs(claim - min(turn)) / size)
        others.append(min(abs(claim - each) / size for each in (min(map(abs, turn)), -max(turn))))
    if gaps and max(gaps) <= _MATCHES:
        worst = f"{float(max(gaps)):.1e}"
        return Decision(
            PROVED, f"within {worst} of the least value, by numbers", order=f"{BY_NUMBERS} {worst}"
        )
    if gaps and min(gaps) > _DIFFERS and min(others) > _DIFFERS:
        point, turn, claim = rows[0]
        witness = {name: f"{float(value):.6g}" for name, value in point.items()}
        witness |= {"left": f"{float(min(turn)):.6g}", "right": f"{float(claim):.6g}"}
        return Decision(REFUTED, "not the least value of a turn", witness=witness)
    return None


def _at_its_place(motion: Formula, right: Side, knowledge: Knowledge) -> Decision | None:
    """Refute a value that is not the one at the dead centre where a motion is largest; None for none."""
    rows = values_over_turn(motion, right.node, knowledge)
    half = GRID // 2
    for place in (0, 1):
        is_there = all(abs(turn[place * half]) >= max(map(abs, turn)) * (1 - TINY) for _, turn, _ in rows)
        claims = (right, Side((Negative(right.node),), right.span))
        decisions = [at_dead_centre(motion, claim, "=", place, knowledge) for claim in claims]
        if rows and is_there and all(decision.status == REFUTED for decision in decisions):
            where = f"θ = {'π' if place else '0'}"
            return replace(decisions[0], reason=f"not the value at {where}, where it is largest")
    return None


def _has_branches(node: Formula | None) -> bool:
    return node is not None and any(
        isinstance(part, Call)
        and part.function in ("sqrt", "asin", "acos", "atan")
        and bool(names(part.argument))
        for part in walk(node)
    )
