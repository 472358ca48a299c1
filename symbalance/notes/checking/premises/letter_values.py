"""Relations that give a letter its value: which they are, and whether the value may stand."""

from __future__ import annotations

from symbalance.document.formula import (
    Apply,
    Evaluation,
    Extremum,
    Formula,
    Integral,
    Limit,
    Name,
    names,
    walk,
)
from symbalance.notes.algebra.domain import Domain, NoFormError, TooLargeError
from symbalance.notes.algebra.evaluation import FormEvaluator
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.algebra.values import letters
from symbalance.notes.checking.deciding.equality import Decision, without_dots
from symbalance.notes.checking.deciding.inequalities import SATISFIED_BY
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.premises.another_value import define_anew
from symbalance.notes.checking.premises.cases_of_angles import ANOTHER_ANGLE, case_of_angle
from symbalance.notes.checking.premises.condition_solutions import decide_solution, refute_solution
from symbalance.notes.checking.premises.definitions import Definitions
from symbalance.notes.checking.premises.impossible_values import (
    outside_meaning,
    outside_range,
    refuse_value,
)
from symbalance.notes.checking.premises.measured_values import define_measured
from symbalance.notes.checking.premises.premise_decisions import (
    decide_by_premises,
    is_refused,
    must_follow,
)
from symbalance.notes.checking.premises.sizes_by_number import define_size
from symbalance.notes.checking.premises.system import Premise
from symbalance.notes.checking.verdicts import CONDITION, CONTRADICTION, DEFINITION, PREMISE, STATED
from symbalance.notes.reading.equations import Chain

_OF_A_POINT = (Apply, Evaluation, Extremum, Integral, Limit)
"""Parts of a side that computes something of what is known, and is no value of a size."""


def define_letter(
    definitions: Definitions, chain: Chain, k: int, knowledge: Knowledge
) -> Decision | None:
    """Return the decision on a relation that gives a letter its value, after defining it."""
    decision = _define_letter(definitions, chain, k, knowledge)
    head, value = chain.sides[0].node, chain.sides[k + 1].node
    is_refused = decision is not None and decision.status == CONTRADICTION and not k
    if not is_refused or not isinstance(head, Name) or names(value):
        return decision
    if not definitions.sections.is_chosen(chain, chain.lines[0]):
        return decision
    definitions.define(head.name, value, chain)
    return Decision(PREMISE, "chosen, whatever the equations above give")


def _define_letter(
    definitions: Definitions, chain: Chain, k: int, knowledge: Knowledge
) -> Decision | None:
    pair = _letter_defined(definitions, chain, k) or _letter_within(chain, k, knowledge)
    if pair is None or knowledge.assumes(pair[0]):
        return None
    name, value = pair
    if k == 0 and chain.inline and not names(value) and definitions.sections.is_denied(chain):
        return Decision(CONDITION, "named as what is left out")
    is_result = chain.sides[k].node is value
    is_of_point = is_result and knowledge.measures(name) and _is_at_a_point(value)
    if is_of_point or name in knowledge.meaning.kinds.identities:
        return None  # min x = r claims something
    outside = outside_meaning(name, value, knowledge, is_result=is_result)
    outside = outside if chain.relations[k].sign == "=" else None
    stated = outside or define_measured(definitions, name, value, chain, k, knowledge)
    if stated is not None:
        return stated
    if name in knowledge.meaning.values:
        contradiction = _against_law(definitions, name, value, chain, knowledge)
        return contradiction or define_size(definitions, name, value, chain, knowledge)
    solution = decide_solution(definitions, name, value, chain, k, knowledge)
    is_settled = solution is not None or _may_be_wrong(definitions, name, value, chain, k, knowledge)
    return solution if is_settled else _define(definitions, name, value, chain, k, knowledge)


def _letter_defined(definitions: Definitions, chain: Chain, k: int) -> tuple[str, Formula] | None:
    """Return the letter a relation may define, and its value."""
    left, right = chain.sides[k].node, chain.sides[k + 1].node
    is_new = isinstance(right, Name) and right.name not in names(left) | definitions.letters_in_use
    is_head = all(side.node == left for side in chain.sides[:k])  # ω = φ̇ = 2πn, the dot being ω
    if is_head and isinstance(left, Name) and left.name not in names(right):
        has_number = any(e.definition.numeric for e in definitions.values.get(left.name, [])[-1:])
        if not (has_number and is_new):  # u = 3, then u = v: that is what v is
            return left.name, right
    if isinstance(right, Name) and right.name not in names(left) | definitions.letters_in_use:
        return right.name, left
    return None


def _letter_within(chain: Chain, k: int, knowledge: Knowledge) -> tuple[str, Formula] | None:
    """Return the letter that a chain gives its value behind an inequality, and the value: 3 > y = 2."""
    left, right = chain.sides[k].node, chain.sides[k + 1].node
    if not k or chain.relations[k - 1].sign not in SATISFIED_BY or not isinstance(left, Name):
        return None
    is_open = not knowledge.knows(left.name) and left.name not in names(right)
    return (left.name, right) if is_open else None


def _is_at_a_point(value: Formula) -> bool:
    return any(isinstance(part, _OF_A_POINT) for part in walk(value))


def _against_law(
    definitions: Definitions, name: str, value: Formula, chain: Chain, knowledge: Knowledge
) -> Decision | None:
    """Return the contradiction between a number and what premises give by a letter's law: λ = r/l."""
    if names(value) or definitions.sections.opens_case(chain):
        return None
    statement = Premise(knowledge.meaning.values[name], value, chain.lines[0])
    decision = decide_by_premises(definitions, statement, knowledge)
    return decision if decision is not None and decision.status == CONTRADICTION else None


def _may_be_wrong(
    definitions: Definitions, name: str, value: Formula, chain: Chain, k: int, knowledge: Knowledge
) -> bool:
    """Tell whether a relation between a letter and a value is a claim, not its definition."""
    # λ = 2l/r says something of the geometry, and x = y, y = x + 1 nothing new: both may be wrong.
    says_of_geometry = knowledge.measures(name) and name in _letters_of(value, knowledge)
    if says_of_geometry or _is_circular(definitions, name, value, chain.lines[0], knowledge):
        return True
    if not must_follow(definitions, chain, k):
        return False
    by_premises = decide_by_premises(definitions, definitions.premise_of(chain, k), knowledge)
    return by_premises is None or by_premises.status != PREMISE


def _letters_of(value: Formula, knowledge: Knowledge) -> list[str]:
    """Return the letters a formula comes down to by the meanings alone."""
    try:
        return letters(FormEvaluator(Domain(), knowledge.meaning).form(value))
    except (NoFormError, TooLargeError):
        return []


def _is_circular(
    definitions: Definitions, name: str, value: Formula, line: int, knowledge: Knowledge
) -> bool:
    """Tell whether a value comes down to its own letter, by what was defined before.

    What was defined where the letter was declared as another one does not hold this one.
    """
    owner = definitions.declarations.owner
    values = {
        n: d.node
        for n, d in knowledge.definitions.items()
        if n != name and not (name in names(d.node) and owner(name, d.line) != owner(name, line))
    }
    return name in names_behind(value, values)


def _define(
    definitions: Definitions, name: str, value: Formula, chain: Chain, k: int, knowledge: Knowledge
) -> Decision | None:
    """Return the decision on a letter's value: of a condition, another one, or its first."""
    violated = (
        refute_solution(definitions, name, value, chain, k, knowledge) if knowledge.angles else None
    )
    if violated is not None:
        return violated
    if name in knowledge.definitions:
        return define_anew(definitions, name, value, chain, k, knowledge)
    return refuse_value(name, value, knowledge) or _define_first(
        definitions, name, value, chain, knowledge
    )


def _define_first(
    definitions: Definitions, name: str, value: Formula, chain: Chain, knowledge: Knowledge
) -> Decision:
    """Return the decision on a letter's first value, which premises and ranges may contradict."""
    bare, line = without_dots(value)[0], chain.lines[0]
    by_premises = decide_by_premises(definitions, Premise(Name(name), bare, line), knowledge)
    if is_refused(by_premises):
        by_premises = case_of_angle(definitions, name, bare, chain) or by_premises
    if by_premises is not None and by_premises.status not in STATED:
        return by_premises
    if by_premises is not None and by_premises.reason == ANOTHER_ANGLE:
        definitions.define(name, bare, chain, definitions.sections.case_end(line))
        return by_premises
    contradiction = outside_range(definitions, name, bare, line, knowledge)
    if contradiction is not None:
        return contradiction
    is_premise = definitions.define(name, bare, chain)
    return by_premises or Decision(PREMISE if is_premise else DEFINITION)
