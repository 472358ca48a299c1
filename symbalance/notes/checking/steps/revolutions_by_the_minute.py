"""Formulas that count by the second, and by the minute: ω = 2πn, and then ω = πn/30.

With n = 3000 rpm both are right: in the first n is a speed, in the second the number before its unit.
They differ by a 60 for each of these letters, and by nothing else.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Formula, Name, Number, Product, Quotient, names, walk
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.words.plain_formulas import lone_side, plain_text
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_BY_MINUTE = re.compile(
    r"[\s~$}]{0,4}(?:\\[,;: ]){0,2}(?:\\(?:mathrm|text|textrm|operatorname|rm)\s?\{?\s?)?"
    r"(?:rpm|rev/min|r/min|U/min|1/min|/min|tr/min|min\}?\s?(?:⁻¹|\^\s?\{?[-−]1\}?)|\\frac\{1\}\{(?:\\mathrm\{)?min)",
    re.IGNORECASE,
)
_PER_MINUTE = Number(Fraction(60))


def by_the_minute(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Return that a formula or a result is right with revolutions by the other time; None if not."""
    of_number = not names(chain.sides[k + 1].node)
    return (_result_by_the_second if of_number else _formula_by_the_minute)(state, chain, k, knowledge)


def _formula_by_the_minute(
    state: JudgingState, chain: Chain, k: int, knowledge: Knowledge
) -> Decision | None:
    head, value = chain.sides[0].node, chain.sides[1].node
    known = knowledge.definitions.get(head.name) if isinstance(head, Name) else None
    if k or known is None or chain.relations[0].sign != "=":
        return None
    formulas = [node for node in (known.node, known.formula) if node is not None and names(node)]
    counted = sorted(n for n in names(value) if _is_given_by_minute(state, n, chain))
    if not formulas or not counted:
        return None
    letters = {n: d for n, d in knowledge.definitions.items() if not d.numeric}
    free = replace(knowledge, definitions=letters)
    was_by_minute, is_by_minute = (_is_by_minute(node) for node in (formulas[0], value))
    if was_by_minute == is_by_minute:
        return None
    claim = value
    try:
        for name in counted:
            letter = Name(name)
            turned = Product((_PER_MINUTE, letter)) if is_by_minute else Quotient(letter, _PER_MINUTE)
            claim = substitute(claim, name, turned)
    except NoFormError:  # n is differentiated or integrated by: no number of revolutions is put in for it
        return None
    there = decide(lone_side(formulas[0]), lone_side(claim), "=", free)
    if not there.is_proved:
        return None
    shown = ", ".join(plain_text(Name(name)) for name in counted)
    which = "the number per minute" if is_by_minute else "counted in the seconds of the formula"
    return replace(there, assumptions=(*there.assumptions, f"{shown} is {which} here"))


def _result_by_the_second(
    state: JudgingState, chain: Chain, k: int, knowledge: Knowledge
) -> Decision | None:
    """Return that a result is right with revolutions in a second: P = p V n/2 beside ω = 2πn/60."""
    node = chain.sides[k].node
    given = {
        name for each in state.data for name in names(each.sides[0].node) if _is_by_unit(state, each)
    }
    counted = sorted(n for n in names(node) if n in given or _is_given_by_minute(state, n, chain))
    counted = [name for name in counted if _is_count(knowledge.definitions.get(name))]
    if len(counted) != 1 or _is_by_minute(node):
        return None
    try:
        by_second = substitute(node, counted[0], Quotient(Name(counted[0]), _PER_MINUTE))
    except NoFormError:
        return None
    there = decide(lone_side(by_second), chain.sides[k + 1], chain.relations[k].sign, knowledge)
    if not there.is_proved:
        return None
    shown = f"{plain_text(Name(counted[0]))} is counted in a second here"
    return replace(there, assumptions=(*there.assumptions, shown))


def _is_count(definition: Definition | None) -> bool:
    """Tell whether a letter is the number before rpm, and no speed per second already."""
    return definition is not None and isinstance(definition.node, Number)


def _is_by_unit(state: JudgingState, chain: Chain) -> bool:
    """Tell whether a datum of a table is a number of revolutions per minute."""
    start, end = chain.sides[-1].span
    return _BY_MINUTE.search(state.document.text, start, end) is not None


def _is_by_minute(node: Formula) -> bool:
    """Tell whether a formula divides by the 60 seconds of a minute, or by 30 or 120 for them."""
    below = (part.denominator for part in walk(node) if isinstance(part, Quotient))
    numbers = (part.value for each in below for part in walk(each) if isinstance(part, Number))
    return any(number and not number % 30 for number in numbers)


def _is_given_by_minute(state: JudgingState, name: str, chain: Chain) -> bool:
    """Tell whether a line above gives a letter a number of revolutions per minute."""
    text = state.document.text
    above = state.sections.chains_above(Name(name), chain.start)
    numbers = [c for c in above if not names(c.sides[-1].node)]
    return any(
        _BY_MINUTE.match(text, c.end) or _BY_MINUTE.search(text, c.sides[-1].span[0], c.sides[-1].span[1])
        for c in numbers
    )
