"""Coefficients of two forms of one equation of motion that words compare: 2ξω₀ = ω₀/Q, so Q = 1/(2ξ).

"We identify it with the form ẍ + (ω₀/Q) ẋ + ω₀² x = 0": the factors of each derivative are the same in
both forms, once those of the highest one are. A letter of the one follows from the letters of the other.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from symbalance.document.formula import Formula, Name, Product, names
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.deciding.values_at_points import value_at
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONDITION, DEFINITION, PREMISE, UNDECIDED, Verdict
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_JUDGED = (CONDITION, DEFINITION, PREMISE, UNDECIDED)
_COMPARED = re.compile(
    r"identif|compar(?:ing|ison|ed|e\b|aison|ant|ando|azione|ación)|coefficient|koeffizient|vergleich|confront|gleichsetz|match(?:ing|ed|es)\b|same\s+form|equating"
    r"|égalant|uguagliando|igualando|係数|比較",
    re.IGNORECASE,
)
"""Words by which two equations are said to be one."""
_FORMS = 2
_REACH = 900
"""Characters before a formula in which words compare two equations."""
_POINTS = ((1.3, 0.7, 2.1, 1.7, 0.4, 2.9), (0.6, 2.3, 1.1, 0.8, 3.1, 1.9), (2.7, 1.6, 0.5, 3.3, 1.2, 0.9))
_CLOSE = 1e-9


def unless_of_other_coefficients(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; that on a letter by the coefficients of the two forms that words compare."""
    head, right = chain.sides[0].node, chain.sides[1].node
    is_formula = (
        not k and isinstance(head, Name) and bool(names(right)) and chain.relations[0].sign == "="
    )
    is_open = verdict.verdict in _JUDGED and len(state.equations_of_motion) >= _FORMS
    if not is_formula or not is_open or not isinstance(head, Name) or head.name in names(right):
        return verdict
    balances = [
        (left, other)
        for left, other in _balances(state, chain)
        if head.name in names(left) | names(other) and names(right) <= names(left) | names(other)
    ]
    if len(balances) != 1:
        return verdict
    outcomes = list(_outcomes(balances[0], head.name, right))
    if len(outcomes) == len(_POINTS) and all(outcomes):
        said = Decision(PROVED, assumptions=("the two forms of the equation of motion are one",))
        return describe(state.document, chain, k, said)
    if len(outcomes) < len(_POINTS) or any(outcomes):
        return verdict
    state.definitions.forget(head.name, chain.lines[0])
    reason = "does not follow from the coefficients of the two forms above"
    return describe(state.document, chain, k, Decision(REFUTED, reason))


def _balances(state: JudgingState, chain: Chain) -> Iterator[tuple[Formula, Formula]]:
    """Yield the equations between the factors of the two equations of motion that words compare."""
    sections = state.sections
    first_line = sections.paragraph_start(chain.lines[0])
    start = max(min(sections.start_of_line(first_line), chain.start), chain.start - _REACH)
    forms = [e for e in state.equations_of_motion if first_line <= e.line <= chain.lines[0]]
    if len(forms) != _FORMS or not _COMPARED.search(state.document.text[start : chain.start]):
        return
    first, second = (form.factors for form in forms)
    if first.keys() != second.keys() or len(forms[0].moving) != 1 or len(first) < _FORMS:
        return
    highest = max(first, key=lambda key: key[1])
    for key in first:
        if key != highest:
            yield Product((first[key], second[highest])), Product((second[key], first[highest]))


def _outcomes(balance: tuple[Formula, Formula], head: str, right: Formula) -> Iterator[bool]:
    """Yield at some points whether a formula makes the balance of two factors true."""
    others = sorted((names(balance[0]) | names(balance[1]) | names(right)) - {head})
    for point in _POINTS:
        if len(others) > len(point):
            return
        values = dict(zip(others, point, strict=False))
        claimed = value_at(right, values)
        if claimed is None:
            return
        sides = [value_at(node, {**values, head: claimed}) for node in balance]
        if sides[0] is None or sides[1] is None:
            return
        yield math.isclose(sides[0], sides[1], rel_tol=_CLOSE)
