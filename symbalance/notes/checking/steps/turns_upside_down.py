"""Revolutions per minute made from those by the second with the wrong end up: N = f/60 for 60 f.

As quantities the two are equal, as numbers of their units one is sixty times the other. A sixtieth the
other way round is right in no reading, and nothing but the units says so.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from math import isclose

from symbalance.document.formula import Formula, Name, Product, Quotient, names
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.meant.letter_units import unit_written
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.units.own_units import ANGULAR_LETTERS
from symbalance.notes.checking.units.stated_units import StatedUnit
from symbalance.notes.checking.verdicts import DEFINITION, PREMISE, UNDECIDED, Verdict
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain
from symbalance.notes.reading.formulas.result_units import value_of
from symbalance.text import lazy_patterns as re

_BRACKETED = re.compile(r"[\[(]([^\])]{1,24})[\])]\s*$")
"""The unit at the end of a meaning: natural frequency [Hz]."""
_SIXTY = 60
_IN_WORDS = re.compile(
    r"(?:(?:in|as)\s+(?:revolutions|turns|cycles|vibrations)\s+(?:per|a)\s+minute|in\s+Umdrehungen\s+(?:pro|je)\s+Minute"
    r"|en\s+tours\s+par\s+minute|in\s+giri\s+al\s+minuto|en\s+(?:revoluciones|vueltas)\s+por\s+minuto|毎分(?:の)?回転数(?:で|に))[^.;=。]{0,40}$",
    re.IGNORECASE,
)
"""Right before a formula: its letter counts by the minute."""


def unless_turns_upside_down(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a number per minute that is a sixtieth of one by the second is refuted."""
    head = chain.sides[0].node
    is_open = verdict.verdict in (DEFINITION, PREMISE, UNDECIDED)
    if k or not is_open or not isinstance(head, Name) or chain.relations[0].sign not in "=≈":
        return verdict
    factor, other = _times_a_letter(chain.sides[1].node)
    if (
        not factor
        or other is None
        or {head.name.partition("_")[0], other.partition("_")[0]} & {*ANGULAR_LETTERS}
    ):
        return verdict
    first, second = _unit_of(state, head.name, chain, is_head=True), _unit_of(state, other, chain)
    if first is None or second is None or first.dimension != second.dimension:
        return verdict
    ratio = second.scale / first.scale
    is_of_minutes = ratio in (_SIXTY, Fraction(1, _SIXTY)) and {first.scale, second.scale} == {
        1,
        Fraction(1, _SIXTY),
    }
    if not is_of_minutes or not isclose(factor * ratio, 1):
        return verdict
    state.definitions.forget(head.name, chain.lines[0])
    right = (
        f"{_SIXTY} {plain_text(Name(other))}"
        if ratio == _SIXTY
        else f"{plain_text(Name(other))}/{_SIXTY}"
    )
    reason = (
        f"{plain_text(head)} in {first.text} is {right} of {plain_text(Name(other))} in {second.text}"
    )
    return replace(describe(state.document, chain, k, Decision(REFUTED, reason)), fix=None)


def _times_a_letter(node: Formula) -> tuple[float, str | None]:
    """Return the factor and the letter of a number times a letter; no letter for other formulas."""
    match node:
        case Name(name=name):
            return 1.0, name
        case Quotient(numerator=above, denominator=below) if not names(below):
            factor, name = _times_a_letter(above)
            value = value_of(below)
            return (factor / value, name) if value else (0.0, None)
        case Product(factors=factors):
            lettered = [part for part in factors if names(part)]
            numbers = [value_of(part) for part in factors if not names(part)]
            if len(lettered) != 1 or not all(numbers):
                return 0.0, None
            factor, name = _times_a_letter(lettered[0])
            for number in numbers:
                factor *= number or 0.0
            return factor, name
    return 0.0, None


def _unit_of(state: JudgingState, name: str, chain: Chain, *, is_head: bool = False) -> StatedUnit | None:
    """Return the unit in which a letter is declared, or in which words near count it."""
    meaning = state.declarations.symbols_at(chain.lines[0]).get(name, "")
    declared = _BRACKETED.search(meaning)
    if declared is not None:
        return unit_written(declared[1], chain.start)
    if is_head and _IN_WORDS.search(state.sections.sentence_before(chain)):
        return unit_written("rpm", chain.start)
    units = state.named.units
    return units.of_head(name, chain) if is_head else units.of(name, chain)
