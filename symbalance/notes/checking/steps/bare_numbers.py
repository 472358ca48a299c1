"""Numbers without a unit beside quantities, read in theirs: B = 2.5 kN and A = 10 - B = 7.5 kN.

Put in as quantities the letters give nonsense there, since the 10 has no unit, or that of F = 3x. It is
meant in the units of the page: so a result is read that is refuted as it stands, and is right by the
numbers as they are printed. A formula whose numbers all are pure, as m v/2, is not read so.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from fractions import Fraction
from types import MappingProxyType

from symbalance.document.formula import Constant, Formula, Name, Negative, Number, Sum, names, walk
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.units.conversions import Quantity, quantity_of
from symbalance.notes.checking.units.dimensions import NONE, Dimension, Dimensions, unit_of
from symbalance.notes.checking.units.formulas_between_numbers import (
    TypedNumber,
    numbers_with_units,
    typed_number,
)
from symbalance.notes.checking.units.own_units import is_divided_by_minute
from symbalance.notes.checking.verdicts import CONTRADICTION, REFUTED, Verdict
from symbalance.notes.reading.equations import Chain
from symbalance.notes.reading.formulas.result_units import value_of, without_unit_of_result

BARE = "its numbers without a unit are in the units that go with those of the others"
MOST_BEFORE = 4
"""Relations before a result among which the equation stands that it solves."""
_PURE = {Fraction(2) ** power for power in range(-5, 6)}
"""Numbers that a formula between quantities has itself: the 2 of d = 2 r, the 8 of F l/8."""
_SAME = 1e-9
"""By how much numbers that are put in may differ from those that letters have."""


def unless_of_bare_numbers(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a refuted one is right if its bare numbers have the page's units."""
    if verdict.verdict not in (REFUTED, CONTRADICTION) or chain.relations[k].sign not in "=≈":
        return verdict
    right = chain.sides[k + 1]
    if names(right.node):
        return verdict
    knowledge = state.knowledge(chain.lines[0])
    result = quantity_of(right, state.document)
    behind = quantity_of(chain.sides[-1], state.document)
    number, unit = without_unit_of_result(right), result or behind
    if result is not None and not k and _solves_by_numbers(state, chain, result, knowledge):
        return describe(state.document, chain, k, Decision(PROVED, assumptions=(BARE,)))
    left = chain.sides[k].node
    for formula in _formulas(state, chain, k):
        stem = _stem(left.name) if isinstance(left, Name) else ""
        is_law = bool(stem) and all(_stem(name) != stem for name in names(formula))
        value = _by_numbers(state, formula, unit, knowledge, is_law=is_law)
        if value is None:
            continue
        if result is not None:
            is_right = abs(value - float(result.value)) <= float(result.half) * (1 + _SAME)
        else:
            typed = None if any(numbers_with_units(number, state.document)) else value_of(number)
            is_right = typed is not None and math.isclose(value, typed, rel_tol=_SAME)
        if is_right:
            if result is not None and isinstance(chain.sides[0].node, Name):
                state.definitions.define(chain.sides[0].node.name, right.node, chain)
            return describe(state.document, chain, k, Decision(PROVED, assumptions=(BARE,)))
    return verdict


def _formulas(state: JudgingState, chain: Chain, k: int) -> list[Formula]:
    """Return what a result may be of: the formula before it, or the one that its letter has above."""
    left = chain.sides[k].node
    if not isinstance(left, Name):
        return [left]
    above = state.sections.chains_above(left, chain.start)
    same = [c for c in above if state.sections.same_section(c.lines[0], chain.lines[0])]
    nodes = [side.node for c in same[-1:] for side in c.sides[1:]]
    return [node for node in nodes if names(node) and left.name not in names(node)]


def _solves_by_numbers(state: JudgingState, chain: Chain, result: Quantity, knowledge: Knowledge) -> bool:
    """Tell whether a result solves an equation before it by the numbers: A + B = 10, A = 7.5 kN."""
    head, before = chain.sides[0].node, chain
    if not isinstance(head, Name) or not result.half:
        return False
    for _ in range(MOST_BEFORE):
        equation = state.sections.chain_before(before.start)
        if equation is None or not state.sections.same_section(equation.lines[0], chain.lines[0]):
            return False
        is_one = len(equation.relations) == 1 and equation.relations[0].sign == "="
        is_of_it = is_one and head.name in equation.letters and len(equation.letters) > 1
        if is_of_it and equation.sides[0].node != head:
            gap = Sum((equation.sides[0].node, Negative(equation.sides[1].node)))
            sizes = (result.value - result.half, result.value + result.half)
            own = [TypedNumber(Number(v), Number(v * result.scale), result.unit) for v in sizes]
            gaps = [_by_numbers(state, gap, result, knowledge, {head.name: each}) for each in own]
            return None not in gaps and (gaps[0] or 0) * (gaps[1] or 0) <= 0
        before = equation
    return False


def _by_numbers(
    state: JudgingState,
    node: Formula,
    unit: Quantity | None,
    knowledge: Knowledge,
    own: Mapping[str, TypedNumber] = MappingProxyType({}),
    *,
    is_law: bool = False,
) -> float | None:
    """Return what a formula with a bare number comes to by the numbers of its letters as printed.

    A letter of the unit's own kind counts in it: 2500 N beside kN as 2.5. A law F = 3x between two kinds
    of quantities has its number bare. None for other formulas.
    """
    letters = names(node)
    typed = {n: own.get(n) or typed_number(n, state.document, knowledge) for n in letters}
    given = {name: pair for name, pair in typed.items() if pair is not None}
    if len(given) != len(typed) or not given or unit is None:
        return None
    if not (_has_bare_term(state, node, given) or (is_law and _has_bare_factor(node, given, unit))):
        return None
    kind = unit_of(unit.unit)
    for name, pair in given.items():
        exact = value_of(pair.exact)
        number: Formula = pair.number
        if kind is not None and exact is not None and unit_of(pair.unit) == kind:
            number = Number(pair.number.value * _scale(pair, exact) / unit.scale)
        try:
            node = substitute(node, name, number)
        except NoFormError:  # a derivative by the letter: it has no value
            return None
    return value_of(node)


def _scale(pair: TypedNumber, exact: float) -> Fraction:
    """Return what the unit of a printed number is worth."""
    if not pair.number.value:
        return Fraction(1)
    return (Fraction(exact) / pair.number.value).limit_denominator(10**9)


def _has_bare_term(state: JudgingState, node: Formula, given: Mapping[str, TypedNumber]) -> bool:
    """Tell whether a number without a unit is added to a quantity: 10 - B, with B in kN."""
    dimensions = _dimensions(given)
    measured = {id(part) for part in numbers_with_units(node, state.document)}
    for part in walk(node):
        if not isinstance(part, Sum):
            continue
        bare = [term for term in part.terms if not names(term) and value_of(term)]
        bare = [term for term in bare if not any(id(each) in measured for each in walk(term))]
        others = [dimensions.side(term, "") for term in part.terms if names(term)]
        if bare and any(each not in (None, NONE) for each in others):
            return True
    return False


def _has_bare_factor(node: Formula, given: Mapping[str, TypedNumber], unit: Quantity) -> bool:
    """Tell whether a number is what one quantity is of another by: F = 3x, x in mm and F in N."""
    parts = [*walk(node)]
    numbers = [abs(part.value) for part in parts if isinstance(part, Number)]
    is_pure = all(number in _PURE for number in numbers) or any(isinstance(p, Constant) for p in parts)
    if len(given) != 1 or is_pure or is_divided_by_minute(node):
        return False
    own: Dimension | None = _dimensions(given).side(node, "")
    return own not in (None, NONE) and unit_of(unit.unit) not in (None, NONE, own)


def _stem(name: str) -> str:
    """Return a letter without its subscript: nine volumes V_1 are a volume V."""
    return name.partition("_")[0]


def _dimensions(given: Mapping[str, TypedNumber]) -> Dimensions:
    return Dimensions({name: f"size, {pair.unit}" for name, pair in given.items() if pair.unit}, {})
