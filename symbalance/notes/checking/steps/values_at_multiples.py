"""Quantities at multiples of a letter: F(2n) = 4 F(n) for a force that goes with the square of its speed.

F(2n) may be F times 2n. With two multiples of one letter in brackets it is what F comes to there, all
else staying as it is, and the formula that the page gives F says what that is.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

from symbalance.document.formula import (
    Apply,
    Formula,
    Name,
    Number,
    Product,
    Quotient,
    names,
    parts_of_kind,
)
from symbalance.document.letters import plain_letter
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, UNDECIDED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.steps.proportional import of_any_size, written_out
from symbalance.notes.checking.verdicts import Verdict
from symbalance.notes.checking.words.plain_formulas import lone_side
from symbalance.notes.reading import ReadingError, read_equation, read_expression
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_LETTER = (
    r"(?:\\hat\s*\{?\s*)?(?:\\[a-zA-Z]+|(?<![\\A-Za-z])[A-Za-zα-ωΑ-Ω])\}?(?:_\{[^{}]{1,12}\}|_\w{1,8})?"
)
_AT = re.compile(
    rf"(?P<head>{_LETTER})\s*(?:\\left\s*)?\(\s*(?P<place>[^()=]{{1,24}}?)\s*(?:\\right\s*)?\)"
)
"""A letter and something short in brackets behind it."""
_NO_LETTER = re.compile(
    r"\\(?:d?frac|tfrac|cdot|times|left|right|big|Big|sqrt|a?r?c?(?:sin|cos|tan)|cot|ln|log|exp|quad|text|mathrm).*"
)
"""Commands before a bracket that are no quantity."""
_STAND_INS = "y_9{}"
"""Letters that stand for the values until their formulas are put in."""


@dataclass(frozen=True)
class _Place:
    """Where a quantity is taken: at a multiple of a letter."""

    letter: str
    times: Formula


def unless_at_multiples(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; one on a quantity at two multiples of a letter, by the formula that it has."""
    typed = state.document.text[chain.sides[k].span[0] : chain.sides[k + 1].span[1]]
    places = _places(state, chain, typed)
    if not places or _has_own_function(chain):
        return verdict
    ((head, letter),) = {(head, place.letter) for (head, _), place in places.items()}
    knowledge = state.knowledge(chain.lines[0])
    formula = _formula_of(head, letter, knowledge)
    if formula is None:
        return describe(state.document, chain, k, _unknown(head))
    stands = {_STAND_INS.format(n): place for n, place in enumerate(places.values())}
    marks = dict(zip(places, stands, strict=True))
    text = _AT.sub(lambda match: _marked(state, match, marks), typed)
    try:
        read = read_equation(text, frozenset(stands) | chain.letters)
    except ReadingError:
        return describe(state.document, chain, k, _unknown(head))
    if len(read.sides) != 2 or not names(read.sides[0].node) | names(read.sides[1].node) <= {*stands}:
        return describe(state.document, chain, k, _unknown(head))
    first, second = (_put_in(side.node, stands, formula) for side in read.sides)
    bare = of_any_size(names(first) | names(second), knowledge)
    decision = decide(lone_side(first), lone_side(second), chain.relations[k].sign, bare)
    if decision.status not in (PROVED, REFUTED):
        return describe(state.document, chain, k, _unknown(head))
    reason = f"by the formula that {plain_letter(head)} has above, all but {plain_letter(letter)} staying"
    return describe(state.document, chain, k, Decision(decision.status, reason))


def _has_own_function(chain: Chain) -> bool:
    """Tell whether a relation has a function of the page's own, f(2x) of f(x) = 3x."""
    applied = (part for side in chain.sides for part in parts_of_kind(side.node, Apply))
    return any(part.function != "at" for part in applied)


def _places(state: JudgingState, chain: Chain, typed: str) -> dict[tuple[str, str], _Place]:
    """Return what one letter is taken at, by its name and the text in brackets; empty for a product.

    There are two multiples of one letter, one of them other than the letter itself.
    """
    if typed.count("(") < 2:
        return {}
    found: dict[tuple[str, str], _Place] = {}
    for match in _AT.finditer(typed):
        head, place = _head_of(match, chain), _place_of(state, chain, match["place"])
        if head and place is not None:
            found[head, match["place"]] = place
    alike = {(head, place.letter) for (head, _), place in found.items()}
    is_own = any(place.letter == head for (head, _), place in found.items())
    return found if len(alike) == 1 and len(found) > 1 and not is_own else {}


def _head_of(match: re.Match[str], chain: Chain) -> str:
    """Return the name of the letter before a bracket, "" for none."""
    return "" if _NO_LETTER.fullmatch(match["head"]) else _name(match["head"], chain)


def _name(typed: str, chain: Chain) -> str:
    try:
        node = read_expression(typed, chain.letters)[0]
    except ReadingError:
        return ""
    return node.name if isinstance(node, Name) else ""


def _place_of(state: JudgingState, chain: Chain, typed: str) -> _Place | None:
    """Return a place that is a multiple of one letter, None for another."""
    try:
        node = read_expression(typed, chain.letters)[0]
    except ReadingError:
        return None
    if len(names(node)) != 1 or not isinstance(node, Name | Product | Quotient):
        return None
    (letter,) = names(node)
    once, twice = (
        number_of(substitute(node, letter, Number(Fraction(n))), state.knowledge(chain.lines[0]))
        for n in (1, 2)
    )
    if once is None or twice is None or not once or abs(twice - 2 * once) > 1e-9 * abs(once):
        return None
    return _Place(letter, node)


def _marked(state: JudgingState, match: re.Match[str], marks: Mapping[tuple[str, str], str]) -> str:
    """Return the letter that stands for a value, in place of the value as typed."""
    found = [mark for (_, place), mark in marks.items() if place == match["place"]]
    return f" {found[0]} " if found and not _NO_LETTER.fullmatch(match["head"]) else match[0]


def _formula_of(head: str, letter: str, knowledge: Knowledge) -> Formula | None:
    """Return the formula that a letter has, in another one, None where it has none in it."""
    formulas = {
        name: definition.node
        for name, definition in knowledge.formulas.items()
        if names(definition.node) and name != letter
    }
    if head not in formulas:
        return None
    formula = written_out(Name(head), formulas)
    return formula if letter in names(formula) else None


def _put_in(node: Formula, stands: Mapping[str, _Place], formula: Formula) -> Formula:
    for mark, place in stands.items():
        node = substitute(node, mark, substitute(formula, place.letter, place.times))
    return node


def _unknown(head: str) -> Decision:
    return Decision(UNDECIDED, f"{plain_letter(head)}( ) at two places: no formula above says what it is")
