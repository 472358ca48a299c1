"""Results in a row for values in a row: for θ = 0, 90° and 180° it is a = 1.25, a = -0.25 and a = -0.75.

The reader has the values as a list that the letter runs through. The first result goes with the first
value, and each is judged by the formula of its letter there.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Constant, Formula, Name, Negative, Number, Product, names
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.relations import decide_at_value
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import Verdict
from symbalance.notes.checking.words.lists_of_data import sets_number
from symbalance.notes.checking.words.numbers_by_place import SENTENCE_END
from symbalance.notes.checking.words.plain_formulas import lone_side, plain_text
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_AND = r"(?:,\s*(?:(?:and|und|et|e|y)\s+)?|\s+(?:and|und|et|e|y|or|oder|ou)\s+|、|と)"
_VALUE = r"[-−]?[0-9]+(?:\.[0-9]+)?\s*(?:°|\^\s*\{?\s*\\circ\s*\}?)?"
_LIST = re.compile(rf"[^=]*=\s*\$?(?P<values>{_VALUE}(?:\$?{_AND}\$?{_VALUE})+)\s*")
_DEGREES = re.compile(r"°|circ")
_STRAIGHT = 180


def unless_wrong_in_turn(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a result in a row is judged at the value that has its turn in the list before."""
    head = chain.sides[0].node
    if k or not sets_number(chain) or not isinstance(head, Name):
        return verdict
    formula = _formula_above(state, chain, head)
    found = None if formula is None else _value_of_its_turn(state, chain, head)
    if formula is None or found is None:
        return verdict
    name, value, typed = found
    knowledge = state.knowledge(chain.lines[0])
    others = {n: d for n, d in knowledge.definitions.items() if n not in (head.name, name)}
    nodes = {n: d.node for n, d in others.items()}
    if name not in names_behind(formula, nodes):
        return verdict
    known = replace(knowledge, definitions=others)
    sides = lone_side(formula), chain.sides[1]
    there = decide_at_value(*sides, chain.relations[0].sign, known, name, value)
    at = f"{plain_text(Name(name))} = {typed}"
    if there.is_proved:
        there = replace(there, assumptions=(*there.assumptions, at))
        return describe(state.document, chain, k, there)
    if there.status == REFUTED:
        return describe(state.document, chain, k, Decision(REFUTED, f"at {at}, which has its turn"))
    return verdict


def _formula_above(state: JudgingState, chain: Chain, head: Name) -> Formula | None:
    """Return the last formula of a letter above a relation of its section."""
    if not state.sections.has_formula_above(head, chain.start):
        return None
    above = [c for c in state.sections.chains_above(head, chain.start) if len(c.sides) > 1]
    own = [c for c in above if names(c.sides[1].node) and c.relations[0].sign == "="]
    if not own or not state.sections.same_section(own[-1].lines[0], chain.lines[0]):
        return None
    return None if own[-1].sides[1].span[0] in state.refuted else own[-1].sides[1].node


def _value_of_its_turn(state: JudgingState, chain: Chain, head: Name) -> tuple[str, Formula, str] | None:
    """Return the letter and the value that a result goes with by its turn in its sentence, as typed."""
    text, sections = state.document.text, state.sections
    first = chain.start - len(sections.sentence_before(chain))
    ends = SENTENCE_END.search(text, chain.end)
    stop = ends.start() if ends is not None else len(text)
    before = [c for c in sections.chains_between(first, chain.start) if len(c.letters) == 1]
    for listed in reversed(before):
        match = _LIST.fullmatch(text, listed.start, listed.end)
        if match is None or any(relation.sign == "=" for relation in listed.relations):
            continue
        values = re.split(rf"\$?{_AND}\$?", match["values"])
        results = [c for c in sections.chains_between(listed.end, stop) if c.sides[0].node == head]
        if len(results) != len(values) or not all(map(sets_number, results)):
            return None
        typed = values[results.index(chain)].strip()
        is_angle = any(_DEGREES.search(value) for value in values)
        return next(iter(listed.letters)), _value(typed, is_angle=is_angle), typed
    return None


def _value(typed: str, *, is_angle: bool) -> Formula:
    """Return a typed number, in degrees where its list is one of angles."""
    digits = re.sub(r"[^0-9.]", "", typed.replace("circ", ""))
    size = Fraction(digits)
    number: Formula = Number(size)
    if is_angle and size:
        number = Product((Number(size / _STRAIGHT), Constant("pi")))
    return Negative(number) if typed[0] in "-−" and size else number
