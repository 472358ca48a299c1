"""Numbers of degrees Celsius put into formulas: T + 273 has them, and T₂ - T₁; a quotient needs kelvins.

A temperature in °C is read in kelvin. What is refuted so may be meant of the degrees as they are typed:
the difference of two temperatures is the same in both, and T + 273 turns one into the other. Where one
temperature is divided by another, degrees are wrong. Elsewhere, as in 331 + 0.6 T, nobody can tell.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Formula, Number, Quotient, Sum, names, walk
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, UNDECIDED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.units.temperatures import has_temperature, in_degrees, speaks_of_celsius
from symbalance.notes.checking.verdicts import PROVED_WORDS, Verdict
from symbalance.notes.checking.verdicts import REFUTED as REFUTED_WORD
from symbalance.notes.reading.equations import Chain, Side
from symbalance.text import lazy_patterns as re

IN_KELVIN = "a quotient of temperatures is of kelvins, and 0 °C is 273.15 K"
BESIDE_KELVIN = "one temperature is in K, one in °C, and 0 °C is 273.15 K"
_KELVIN = re.compile(r"(?:\s|[~$]|\\[,;: ]|\\(?:mathrm|text)\s?\{){0,4}K(?![A-Za-z/·])")
_DIGITS = re.compile(r"[0-9.,]*[0-9]")
OPEN = "right for the number of degrees Celsius, and wrong in kelvin: which is meant is not said"
_ZEROS = {Number(Fraction(text)) for text in ("273", "273.15", "273.16", "273.2")}
_SAME = 1e-9


def unless_in_degrees(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; temperatures in °C are judged in kelvin, and in degrees where that is meant."""
    left, right, sign = chain.sides[k], chain.sides[k + 1], chain.relations[k].sign
    is_judged = sign in "=≈" and verdict.verdict in (*PROVED_WORDS, REFUTED_WORD)
    if not is_judged or not speaks_of_celsius(state.document.text):
        return verdict
    knowledge = state.knowledge(chain.lines[0])
    values = {name: d.node for name, d in knowledge.definitions.items()}
    behind = {n for side in (left, right) for n in (*names(side.node), *names_behind(side.node, values))}
    nodes = [left.node, right.node, *(values[n] for n in sorted(behind & values.keys()))]
    if not any(map(has_temperature, nodes)):
        return verdict
    degrees = _knowledge_in_degrees(knowledge)
    there = decide(_side_in_degrees(left), _side_in_degrees(right), sign, degrees)
    is_same = _is_same(left, knowledge, degrees)
    if verdict.verdict != REFUTED_WORD:
        is_wrong = is_same and _is_same(right, knowledge, degrees) and there.status == REFUTED
        return describe(state.document, chain, k, there) if is_wrong else verdict
    if not there.is_proved:
        return verdict
    given = [values[name] for name in behind & values.keys()]
    against = IN_KELVIN if any(_is_quotient(node, values) for node in nodes) else ""
    against = against or (BESIDE_KELVIN if any(_is_of_kelvins(node, state) for node in given) else "")
    if against:
        return replace(verdict, reason=against)
    is_meant = (is_same and not names(right.node)) or any(_adds_zero(node) for node in nodes)
    decision = Decision(PROVED, order=there.order) if is_meant else Decision(UNDECIDED, OPEN)
    return describe(state.document, chain, k, decision)


def _side_in_degrees(side: Side) -> Side:
    return replace(side, readings=tuple(map(in_degrees, side.readings)))


def _knowledge_in_degrees(knowledge: Knowledge) -> Knowledge:
    """Return what is known with every temperature as the degrees typed."""
    definitions = {
        name: replace(
            d,
            node=in_degrees(d.node),
            formula=None if d.formula is None else in_degrees(d.formula),
            rounded=None if d.rounded is None else in_degrees(d.rounded),
        )
        for name, d in knowledge.definitions.items()
    }
    return replace(knowledge, definitions=definitions)


def _is_same(side: Side, kelvins: Knowledge, degrees: Knowledge) -> bool:
    """Tell whether a side is the same number in kelvin and in degrees, as a difference is."""
    first = number_of(side.node, kelvins)
    second = number_of(in_degrees(side.node), degrees)
    if first is None or second is None:
        return False
    return abs(float(first) - float(second)) <= _SAME * max(abs(float(first)), 1.0)


def _is_of_kelvins(node: Formula, state: JudgingState) -> bool:
    """Tell whether a letter's value is typed in kelvin: then no degrees are counted beside it."""
    if not isinstance(node, Number) or has_temperature(node):
        return False
    text = state.document.text
    digits = _DIGITS.match(text, node.span[0])
    return digits is not None and _KELVIN.match(text, digits.end()) is not None


def _is_quotient(node: Formula, values: dict[str, Formula]) -> bool:
    """Tell whether one temperature is divided by another in a formula."""

    def is_of_temperature(part: Formula) -> bool:
        behind = {*names(part), *names_behind(part, values)} & values.keys()
        return has_temperature(part) or any(has_temperature(values[n]) for n in behind)

    quotients = (part for part in walk(node) if isinstance(part, Quotient))
    return any(is_of_temperature(q.numerator) and is_of_temperature(q.denominator) for q in quotients)


def _adds_zero(node: Formula) -> bool:
    """Tell whether 273 is added to or taken from anything in a formula: T + 273."""
    sums = (part for part in walk(node) if isinstance(part, Sum))
    numbers = (n for part in sums for term in part.terms for n in walk(term) if isinstance(n, Number))
    return any(Number(number.value) in _ZEROS for number in numbers)
