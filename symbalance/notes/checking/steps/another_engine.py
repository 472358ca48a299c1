"""Quantities of another engine: max C_P of the five cylinders, where C_P was that of the three.

A page that goes on to another engine may speak of the largest value of a force or a couple without a
formula of its own for it. The formula above is of the engine before, and no statement is refuted by it:
what is said of the largest value is new, as F_max = … would be, and a second value is not. Nor is one by
the formula of the same engine with its cranks at other angles.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from functools import partial

from symbalance.document.formula import Call, Extremum, Formula, Name, Negative, names, walk
from symbalance.document.letters import is_greek
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.evaluation import FormEvaluator
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import DEFINITION
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_KIND = (
    r"(?:force|couple|moment|torque|kraft|kräfte|paar|effort|fuerza|par|forza|coppia|momento|força|binário"
    r"|力)"
)
_ORDER = r"(?:primary|secondary|primär|sekundär|order|ordnung|ordre|orden|ordine|ordem|次)"
_OF_AN_ORDER = re.compile(rf"{_KIND}.{{0,40}}{_ORDER}|{_ORDER}.{{0,40}}{_KIND}", re.IGNORECASE)
"""What a letter is declared as that is of each engine by itself: couple of the second order."""


def leave_engine(state: JudgingState, chain: Chain, k: int) -> bool:
    """Forget the formula of a quantity of the engine before; tell whether there was one.

    The quantity is what a relation begins with, its largest value or its size, or F_2 of F_1 = F_2 = 0;
    one that is declared is the same on the whole page, but for the forces and couples of an order, which
    every engine has for itself, below a heading of its own.
    """
    left, line = chain.sides[k].node, chain.lines[0]
    is_number = not names(chain.sides[-1].node)
    is_of_each = (
        is_number and len(chain.sides) > 2 and all(isinstance(s.node, Name) for s in chain.sides[:-1])
    )
    is_lone = isinstance(left, Name) and bool(k or is_of_each)
    name = left.name if isinstance(left, Name) and is_lone else "" if k else _measured(left)
    is_known = False if k or name else _leave_sizes(state, chain)
    declared = state.declarations.symbols_at(line).get(name, "") if name else ""
    if not name or (declared and not _OF_AN_ORDER.search(declared)):
        return is_known
    knowledge, claim = state.knowledge(line), chain.sides[-1 if is_number else k + 1].node
    is_other = (
        (lambda earlier: bool(state.sections.headings_name_other_engines(line, earlier)))
        if declared
        else partial(state.sections.is_of_another_engine, chain)
    )
    lines = [
        entry.definition.line
        for entry in state.definitions.values.get(name, ())
        if is_other(entry.definition.line)
        and not _is_of_another_order(entry.definition.node, claim, knowledge)
    ]
    for earlier in lines:
        state.definitions.forget(name, earlier)
    if lines and is_number:  # M_1 = M_2 = 0 says so of both
        others = [s.node.name for s in chain.sides[k + 1 :] if isinstance(s.node, Name)]
        for entry in [e for other in others for e in state.definitions.values.get(other, ())]:
            if is_other(entry.definition.line):
                for other in others:
                    state.definitions.forget(other, entry.definition.line)
    return bool(lines)


def _leave_sizes(state: JudgingState, chain: Chain) -> bool:
    """Forget what letters are in sections whose headings name another engine, of |S_1|² + |S_2|² = 25."""
    line, sections = chain.lines[0], state.sections
    sizes = {_measured(part) for part in walk(chain.sides[0].node)} - {""}
    is_known = False
    for name in sizes - set(state.declarations.symbols_at(line)):
        for entry in list(state.definitions.values.get(name, ())):
            if sections.headings_name_other_engines(line, entry.definition.line):
                state.definitions.forget(name, entry.definition.line)
                is_known = True
    return is_known


def leave_cranks(state: JudgingState, chain: Chain, k: int) -> bool:
    """Forget the formula that a letter has at other crank angles; tell whether there was one.

    F_1 = 0 stands below δ_2 = 180°; where the sentence before another F_1 says δ_2 = 360°, it is of
    other cranks. In a formula that holds the letter of the angle itself, its value is only put in.
    """
    left, line = chain.sides[k].node, chain.lines[0]
    if not isinstance(left, Name) or left.name in state.declarations.symbols_at(line):
        return False
    given = {c.sides[0].node: c for c in state.document.chains if _gives_crank(c) and _is_above(c, chain)}
    lines = []
    for entry in state.definitions.values.get(left.name, ()):
        earlier, own = entry.definition.line, names(entry.definition.node)
        cranks = (c for c in given.values() if c.lines[0] > earlier and c.lines[0] == line)
        if any(_has_other_value(state, c, earlier) and not c.letters & own for c in cranks):
            lines.append(earlier)
    for earlier in lines:
        state.definitions.forget(left.name, earlier)
    return bool(lines)


def _is_above(crank: Chain, chain: Chain) -> bool:
    return crank.sides[0].span[0] < chain.sides[0].span[0]


def _gives_crank(chain: Chain) -> bool:
    """Tell whether a relation gives the angle of one crank: δ_2 = 180°."""
    head = chain.sides[0].node
    if len(chain.sides) != 2 or not isinstance(head, Name) or names(chain.sides[1].node):
        return False
    base, _, index = head.name.partition("_")
    return is_greek(base) and index.isdecimal() and chain.relations[0].sign == "="


def _has_other_value(state: JudgingState, crank: Chain, last: int) -> bool:
    """Tell whether a line up to another one gave a crank's angle otherwise."""
    head, value = crank.sides[0].node, crank.sides[1].node
    return any(
        c.lines[0] <= last and _gives_crank(c) and c.sides[0].node == head and c.sides[1].node != value
        for c in state.document.chains
    )


def leave_premises(state: JudgingState, chain: Chain) -> bool:
    """Forget equations of another engine's section that fix an undeclared letter here; tell of any.

    The balance mass of the V-twin, m_c r_c = m r, is not that of the V8 below its own heading.
    """
    line = chain.lines[0]
    own = chain.letters - set(state.declarations.symbols_at(line))
    other = state.sections.headings_name_other_engines
    premises = [
        p for p in state.definitions.premises_at(line) if p.fixes in own or p.names & own == p.names
    ]
    premises = [p for p in premises if other(line, p.line)]
    for premise in premises:
        state.definitions.forget(premise.fixes, premise.line)
        state.definitions.premises.remove(premise)
    return bool(premises)


def _is_of_another_order(node: Formula, claim: Formula, knowledge: Knowledge) -> bool:
    """Tell whether a quantity goes with one power of the rod's ratio and what is said of it with another.

    A couple of the second order has 1/n in every engine: 4.98 m r ω² a is none where all terms of the
    formula are times 1/n. Of sums of several orders nothing is said.
    """
    powers = [_power_of_ratio(each, knowledge) for each in (node, claim)]
    return None not in powers and powers[0] != powers[1]


def _power_of_ratio(node: Formula, knowledge: Knowledge) -> Fraction | None:
    """Return the power of the rod's ratio that all terms of a formula have; None where they differ."""
    if knowledge.crank is None or knowledge.crank.small is None:
        return None
    values = {n: d.node for n, d in knowledge.definitions.items() if not d.numeric}
    meaning = replace(knowledge.meaning, values={**values, **knowledge.meaning.values})
    domain = meaning.domain()
    try:
        form = FormEvaluator(domain, meaning).form(node)
    except (NoFormError, TooLargeError):
        return None
    small = domain.symbol(knowledge.crank.small[0])
    if domain.opaque or not form.numerator:
        return None
    powers = [{dict(m).get(small, 0) for m in part} for part in (form.numerator, form.denominator)]
    if any(len(each) != 1 for each in powers):
        return None
    return Fraction(powers[0].pop()) - Fraction(powers[1].pop())


def as_new_extreme(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Return that a relation says how large a quantity without a formula gets; None for others."""
    name, right = _measured(chain.sides[0].node), chain.sides[1]
    is_new = name and not knowledge.has_meaning(name) and name not in names(right.node)
    if k or not is_new or not isinstance(chain.sides[0].node, Extremum):
        return None
    key = (chain.sides[0].node.function, name)
    earlier = state.extremes.setdefault(key, (right, chain.lines[0]))
    if earlier[0] is not right and state.sections.same_section(earlier[1], chain.lines[0]):
        return None
    state.extremes[key] = (right, chain.lines[0])
    text = f"the {'largest' if key[0] == 'max' else 'smallest'} value of {plain_text(Name(name))}"
    return Decision(DEFINITION, f"{text}, of which no formula stands above")


def _measured(node: Formula) -> str:
    """Return the letter of max F, |F| and -max F; "" for anything else."""
    if isinstance(node, Negative):
        return _measured(node.operand)
    inner: Formula | None = None
    if isinstance(node, Extremum):
        inner = node.body
    elif isinstance(node, Call) and node.function == "abs":
        inner = node.argument
    if isinstance(inner, Call) and inner.function == "abs":
        inner = inner.argument
    return inner.name if isinstance(inner, Name) else ""
