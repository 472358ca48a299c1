"""Angular speeds that a page gives as revolutions alone: P = T ω with n = 3000 rpm, T = 159 N m.

Where nothing says what ω is, and one speed is given in revolutions a minute, ω is that speed in radians.
A number that its formula gives with it holds on that condition, and another one is wrong.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import PI, Formula, Name, Number, Product, names
from symbalance.document.letters import plain_letter
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.rounding import whole_before_unit
from symbalance.notes.checking.deciding.substitution import replace_part
from symbalance.notes.checking.premises.angles_at import solves_as_printed
from symbalance.notes.checking.premises.system import Premise
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.units.dimensions import written_unit
from symbalance.notes.checking.verdicts import DEFINITION, PREMISE, Verdict
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_OTHER = re.compile(
    r"cam|gear|half|twice|motor\s+speed|Nocken|Getriebe|halb|doppelt|カム|歯車", re.IGNORECASE
)
"""Words of another shaft than the one that ω is of."""
FEWEST = 10
"""A whole number from here on may be a rounded result."""
_OMEGAS = ("omega", "Omega")
_SPEEDS = ("n", "N")
_BY_MINUTE = re.compile(
    r"rpm|r/min|rev/min|min\s*\^?\s*\{?[-−]1\}?|min⁻¹|1/min|/min|U/min|tr/min|giri/min"
)
"""How revolutions a minute are typed."""


def with_omega_of_speed(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; that on a number whose formula has an ω of which revolutions alone are given."""
    head, value = chain.sides[0].node, chain.sides[-1]
    is_open = verdict.verdict in (DEFINITION, PREMISE) and len(chain.relations) == 1
    if k or not is_open or not isinstance(head, Name) or names(value.node):
        return verdict
    knowledge = state.knowledge(chain.lines[0])
    if head.name in knowledge.angles:  # whatever turns, a place is chosen
        return verdict
    own = next((n for n in _OMEGAS if n in state.definitions.letters_in_use), "")
    is_open = own and head.name != own and (not knowledge.knows(own) or _is_solved(own, knowledge))
    speed = _speed(state, chain) if is_open else None
    if speed is None or not all(written_unit(state.document.source(value.span))):
        return verdict
    name, node = speed
    turned = Product((Number(Fraction(2)), PI, node))
    known = knowledge.with_definition(own, Definition(turned, chain.lines[0], numeric=True))
    decision = _decide(state, chain, head, known)
    if decision is None or not (decision.is_proved or decision.status == REFUTED):
        return verdict
    text = f"{plain_letter(own)} is {plain_letter(name)} in radians"
    if decision.status == REFUTED:
        reason = f"if {text}" + (f": {decision.reason}" if decision.reason else "")
        return describe(state.document, chain, k, replace(decision, reason=reason))
    return describe(
        state.document, chain, k, replace(decision, assumptions=(*decision.assumptions, text))
    )


def _is_solved(name: str, knowledge: Knowledge) -> bool:
    """Tell whether a letter has no value but what an equation was solved for: ω = P/T of P = T ω."""
    definition = knowledge.definitions.get(name)
    return definition is not None and definition.solved


def _decide(state: JudgingState, chain: Chain, head: Name, known: Knowledge) -> Decision | None:
    """Return whether a letter's number is what its formula, or an equation above with it, comes to."""
    line = chain.lines[0]
    entries = state.definitions.values.get(head.name, ())
    formula = next((e.definition for e in reversed(entries) if names(e.definition.node)), None)
    if formula is not None and state.sections.same_section(formula.line, line):
        others = {n: d for n, d in known.definitions.items() if n != head.name}
        left = replace(chain.sides[0], readings=(formula.node,))
        return decide(left, chain.sides[1], "=", replace(known, definitions=others))
    for name, each in state.definitions.values.items():
        number = known.definitions.get(name)
        above = next(
            (e.definition for e in reversed(each) if head.name in names(e.definition.node)), None
        )
        if above is None or number is None or not number.numeric or name == head.name:
            continue
        if state.sections.same_section(above.line, line):  # P = T ω, and P = 50 kW
            condition = Premise(above.node, number.node, above.line)
            is_root = solves_as_printed(condition, head.name, _as_rounded(chain.sides[1].node), known)
            return (
                None
                if is_root is None
                else Decision(
                    PROVED if is_root else REFUTED, order="the digits printed" if is_root else ""
                )
            )
    first = state.sections.section_start(line)
    return state.given_numbers.decide(head.name, chain.sides[1].node, line, first, known)


def _as_rounded(value: Formula) -> Formula:
    """Return a whole number of two digits as one that is rounded to it, with its unit."""
    whole = value if isinstance(value, Number) else whole_before_unit(value)
    if whole is None or whole.last_place is not None or abs(whole.value) < FEWEST:
        return value
    return replace_part(value, whole, replace(whole, last_place=Fraction(1)))


def _speed(state: JudgingState, chain: Chain) -> tuple[str, Formula] | None:
    """Return the one speed of the section that is given in revolutions a minute, None for none or two."""
    found = []
    for name in _SPEEDS:
        last = state.sections.last_above(Name(name), chain.start)
        if last is None or not state.sections.same_section(last.lines[0], chain.lines[0]):
            continue
        typed = state.document.source(last.sides[-1].span)
        behind = state.document.text[last.end : last.end + 12]
        is_of_other = _OTHER.search(state.sections.sentence_before(last)) is not None
        if not names(last.sides[-1].node) and not is_of_other and _BY_MINUTE.search(typed + behind):
            found.append((name, last.sides[-1].node))
    return found[0] if len(found) == 1 else None
