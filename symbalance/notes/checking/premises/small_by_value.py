"""Letters that are small because the page gives them a small value: λ = r/l = 0.2.

Where nobody has declared what is small, `≈` may rest on any letter. One that the page puts at most at a
half is what it rests on, so that an expansion in it can be refuted too.
"""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import Formula, Name, Quotient, names
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge, length_by_ratio
from symbalance.notes.checking.deciding.order_agreement import (
    HIGHEST_ORDER,
    SmallLetter,
    agreement_through,
    degree,
)
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.verdicts import REFUTED
from symbalance.notes.reading.equations import Chain

LARGEST = 0.5


def refuted_in_small_letter(chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Return the refutation of `left ≈ right` as a series in each letter whose value is small.

    None where there is no such letter, or where the sides agree in one of them.
    """
    left, right = chain.sides[k], chain.sides[k + 1]
    refutation = None
    for name in sorted(names(right.node)):
        definition = knowledge.definitions.get(name)
        if definition is None or not _is_small(definition.node, knowledge):
            continue
        free = _with_letter_free(name, knowledge)
        if decide(left, right, chain.relations[k].sign, free).status != REFUTED:
            return None
        refutation = refutation or _by_series(left.node, right.node, name, free)
    return refutation


def _by_series(left: Formula, right: Formula, name: str, knowledge: Knowledge) -> Decision | None:
    """Return the refutation of two sides by their powers of a letter, as many as the right one keeps."""
    level = list(knowledge.levels(left, right))[-1]
    evaluator = knowledge.evaluator(level)
    try:
        first, second = evaluator.form(left), evaluator.form(right)
        order = degree(second, name, 1)
        if not order or order > HIGHEST_ORDER:
            return None
        small = SmallLetter(name, 1, order)
        decision = agreement_through(first, second, small, level, False, with_witness=True)
    except (NoFormError, TooLargeError):
        return None
    return decision if decision.status == REFUTED else None


def _is_small(node: Formula, knowledge: Knowledge) -> bool:
    value = number_of(node, knowledge)
    return value is not None and 0 < value <= LARGEST


def _with_letter_free(name: str, knowledge: Knowledge) -> Knowledge:
    """Return what is known without an example's numbers, one letter free and small.

    Of λ = r/l the length becomes r/λ, where no formula gives it.
    """
    own = knowledge.definitions[name]
    formulas = {
        each: definition
        for each, definition in knowledge.formulas.items()
        if each != name and not (knowledge.definitions[each].numeric and name in names(definition.node))
    }
    ratio = own.formula if own.numeric else own.node
    if isinstance(ratio, Quotient) and isinstance(ratio.denominator, Name):
        length = ratio.denominator.name
        if length not in formulas and length not in names(ratio.numerator):
            formulas[length] = replace(own, node=length_by_ratio(name, ratio), numeric=False)
    return replace(knowledge, definitions=formulas, small=knowledge.small | {name})
