"""A crank turns steadily, φ̇ = ω, where a page names its angle and its speed and says no more.

The geometry of declared letters has that for its crank angle; here it is for the letter that the page's
own words call the crank angle, else for the only one that turns with ω in its formulas: r ω² cos φ. What
rests on it names it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import (
    Call,
    Constant,
    Derivative,
    Formula,
    Name,
    Number,
    Power,
    Product,
    Quotient,
    names,
    parts_of_kind,
    walk,
)
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.declared.proposals import meanings_from_words
from symbalance.notes.checking.declared.sidecar import Declarations
from symbalance.notes.checking.declared.symbol_roles import KNOWN, letters_by_role, role_of
from symbalance.notes.checking.meant.motion_in_time import Motion, Motions, has_another_rate, time_letter
from symbalance.notes.checking.words.glossary import glossary_of
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import ReadNotes

_ANGLE = "crank angle"
_SPEED, _TURNS = "angular speed", "engine speed rpm"
_OF_SPEED = ("omega", "Omega")
_WAVES = ("sin", "cos")
_RATE_OF_TURNS = Quotient(Constant("pi"), Number(Fraction(30)))


def with_steady_crank(page: ReadNotes, declarations: Declarations, motions: Motions) -> Motions:
    """Return motions with that of the crank, where the page differentiates and says nothing of it."""
    roles, time = letters_by_role(declarations.symbols), time_letter(page, declarations)
    is_open = time is not None and _ANGLE not in roles and not declarations.scopes
    if time is None or not is_open or not _differentiates_by(time, page):
        return motions
    meanings = meanings_from_words(page, declarations.symbols_at, glossary_of(page.text).english)
    named = {p.letter: p.meaning for p in meanings.values()}
    in_words = [p.letter for p in meanings.values() if p.words and p.meaning == _ANGLE]
    named |= {name: role_of(text) for name, text in declarations.symbols.items()}
    angles = in_words or [name for name, role in named.items() if role == _ANGLE]
    rate = _speed(page, named)
    if rate is None or (not in_words and _has_waves_in(time, page)):  # φ of ω t - φ is a phase
        return motions
    angles = angles or list(_turning_with(rate, page, named))
    if len(angles) != 1:
        return motions
    (angle,) = angles
    is_stated = any(motion.name == angle for motion in motions.motions)
    if is_stated or angle in names(rate) or has_another_rate(angle, rate, page, time):
        return motions
    steady = Motion(angle, rate, time, 0, is_assumed=True)
    return replace(motions, motions=(*motions.motions, steady))


def rate_assumed(sides: tuple[Formula, ...], values: dict[str, Formula], motions: Motions) -> str:
    """Return the assumption that a relation rests on if it differentiates by the time: φ̇ = ω, else ""."""
    for motion in motions.motions:
        if not motion.is_assumed:
            continue
        nodes = [
            *sides,
            *(values[n] for side in sides for n in names_behind(side, values) if n in values),
        ]
        for part in (p for node in nodes for p in parts_of_kind(node, Derivative)):
            if part.variable.name == motion.time and motion.name in names_behind(part.expression, values):
                turning = Derivative(Name(motion.name), Name(motion.time))
                return f"{plain_text(turning)} = {plain_text(motion.rate)} is constant"
    return ""


def _differentiates_by(time: str, page: ReadNotes) -> bool:
    sides = (side for chain in page.chains for side in chain.sides)
    return any(
        part.variable.name == time for side in sides for part in parts_of_kind(side.node, Derivative)
    )


def _speed(page: ReadNotes, named: dict[str, str]) -> Formula | None:
    """Return the letter of a page's angular speed, or π n/30 where it has revolutions per minute."""
    used = {name for chain in page.chains for side in chain.sides for name in names(side.node)}
    for choices in (
        [name for name, role in named.items() if role == _SPEED and name in used],
        [name for name in _OF_SPEED if name in used and named.get(name, _SPEED) == _SPEED],
    ):
        if choices:
            return Name(choices[0]) if len(choices) == 1 else None
    turns = [name for name, role in named.items() if role == _TURNS and name in used]
    return Product((_RATE_OF_TURNS, Name(turns[0]))) if len(turns) == 1 else None


def _has_waves_in(time: str, page: ReadNotes) -> bool:
    """Tell whether a sine or a cosine of a page has the time in it: cos(ω t - φ)."""
    sides = (side.node for chain in page.chains for side in chain.sides)
    waves = (call for node in sides for call in parts_of_kind(node, Call) if call.function in _WAVES)
    return any(time in names(call.argument) for call in waves)


def _turning_with(rate: Formula, page: ReadNotes, named: dict[str, str]) -> Iterator[str]:
    """Yield the letters whose waves stand in products with ω: r ω² (cos φ + λ cos 2φ)."""
    beside_rate = dict[str, None]()
    for side in (side for chain in page.chains for side in chain.sides):
        for part in walk(side.node):
            if not isinstance(part, Product):
                continue
            turning = [factor for factor in part.factors if _is_speed(factor, rate)]
            waves = (call for factor in part.factors for call in parts_of_kind(factor, Call))
            if turning:
                beside_rate |= {
                    name: None for call in waves if call.function in _WAVES
                    for name in names(call.argument)
                }  # fmt: skip
    yield from (name for name in beside_rate if named.get(name) not in KNOWN)


def _is_speed(factor: Formula, rate: Formula) -> bool:
    return factor == rate or (isinstance(factor, Power) and factor.base == rate)
