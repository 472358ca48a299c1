"""Decisions on relations in which letters count: the ends of sums, orders of harmonics.

A letter at the end of a sum is a whole number. One that multiplies the variable of an integral over
turns, or the index of a sum of phases, may be one: ∫_0^{2π} sin kφ dφ = 0 holds if k is an integer. What
holds but for single values, Σ e^(2πik/N) = 0 for N ≠ 1, is decided at each of those apart.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import (
    Call,
    Constant,
    Formula,
    Integral,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Summation,
    names,
    parts_of_kind,
    walk,
)
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.algebra.special_values import ANY_WHOLE
from symbalance.notes.checking.deciding.equality import REFUTED, Decision, decide_equality
from symbalance.notes.checking.deciding.inequalities import compare
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge, StatedRange
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.declared.symbol_roles import KNOWN, role_of
from symbalance.notes.checking.words.plain_formulas import plain_text

Decide = Callable[[Formula, Formula, Knowledge], Decision]

_SPEEDS = ("omega", "Omega")
"""Letters that are no orders, whatever multiplies them: ω t."""
_WHOLE_ROLES = ("integer", "constant", "positive")
"""Known meanings that leave open whether a letter is a whole number; a variable takes all values."""


def with_counts(left: Formula, right: Formula, knowledge: Knowledge) -> Knowledge:
    """Return what is known with the letters at the ends of sums as whole numbers.

    Those of another known meaning, a stroke, are none: such a sum is a slip or another letter.
    """
    ends = {
        name
        for node in behind(left, right, knowledge)
        for part in parts_of_kind(node, Summation)
        if part.index is not None
        for bound in (part.lower, part.upper)
        if bound is not None
        for name in names(bound)
    }
    return _counting(knowledge, {name for name in ends if _may_count(name, knowledge)})


def decide_with_whole_numbers(
    left: Formula, right: Formula, knowledge: Knowledge, decide: Decide
) -> Decision:
    """Decide a relation, its letters as whole numbers where they may be such, and at special values."""
    decision = decide(left, right, knowledge)
    multipliers = {} if decision.is_proved else _multipliers(left, right, knowledge)
    counting = _counting(knowledge, set(multipliers))
    attempts = [counting] if multipliers else []
    if not decision.is_proved and _has_order_in_sum(left, right, counting):
        attempts.append(replace(counting, meaning=replace(counting.meaning, closes_sums=True)))
    for known in attempts:
        there = decide(left, right, known)
        if there.is_proved:
            texts = (f"{plain_text(Name(name))} is an integer" for name in multipliers)
            decision = replace(there, assumptions=(*there.assumptions, *texts))
            return _at_special_values(left, right, decision, known, decide)
        if there.status == REFUTED and decision.status == REFUTED:
            decision = there
    return _at_special_values(left, right, decision, knowledge, decide)


def _has_order_in_sum(left: Formula, right: Formula, knowledge: Knowledge) -> bool:
    """Tell whether a whole number multiplies the index of a sum between numbers: it has a closed form."""
    return any(
        isinstance(part, Summation)
        and part.index is not None
        and part.upper is not None
        and not knowledge.meaning.integer.isdisjoint(_beside(part.body, part.index.name))
        for node in behind(left, right, knowledge)
        for part in walk(node)
    )


def orders_in(nodes: Iterable[Formula]) -> frozenset[str]:
    """Return the letters that multiply what integrals over turns and sums of phases go over."""
    orders: set[str] = set()
    for part in (part for node in nodes for part in walk(node)):
        if isinstance(part, Integral) and _is_over_turns(part):
            bounds = [bound for bound in (part.lower, part.upper) if bound is not None]
            outer = {name for bound in bounds for name in names(bound)}
            orders |= set(_beside(part.body, part.variable.name)) - outer
        elif isinstance(part, Summation) and part.index is not None:
            orders |= set(_beside(part.body, part.index.name))
    return frozenset(orders)


def behind(left: Formula, right: Formula, knowledge: Knowledge) -> list[Formula]:
    """Return two formulas with what the letters in them stand for by the page."""
    values = {name: d.node for name, d in knowledge.definitions.items()}
    letters = {n for node in (left, right) for n in names_behind(node, values)}
    return [left, right, *(values[n] for n in sorted(letters) if n in values)]


def _counting(knowledge: Knowledge, counts: set[str]) -> Knowledge:
    if counts <= knowledge.meaning.integer:
        return knowledge
    meaning = replace(knowledge.meaning, integer=knowledge.meaning.integer | counts)
    return replace(knowledge, meaning=meaning)


def may_count(name: str, meanings: Mapping[str, str]) -> bool:
    """Tell whether a letter may be a whole number, by what it is declared to be."""
    role = role_of(meanings.get(name, "integer"))
    return role not in KNOWN or role in _WHOLE_ROLES


def _may_count(name: str, knowledge: Knowledge) -> bool:
    is_angle = name in knowledge.angles - knowledge.meaning.integer
    return not is_angle and may_count(name, knowledge.meanings)


# Multipliers of angles ----------------------------------------------------------------------------


def _multipliers(left: Formula, right: Formula, knowledge: Knowledge) -> dict[str, None]:
    """Return the letters, not known to be whole, that multiply what is integrated or summed over."""
    nodes = behind(left, right, knowledge)
    own = {name for node in nodes for name in names(node)} - _bound(nodes)
    multipliers = (orders_in(nodes) | knowledge.orders) & own
    return {
        name: None
        for name in sorted(multipliers)
        if name not in knowledge.meaning.integer
        and name not in _SPEEDS
        and not knowledge.knows(name)
        and _may_count(name, knowledge)
    }


def _bound(nodes: Iterable[Formula]) -> set[str]:
    """Return the letters that sums and integrals go over."""
    parts = [part for node in nodes for part in walk(node)]
    indices = {part.index.name for part in parts if isinstance(part, Summation) and part.index}
    return indices | {part.variable.name for part in parts if isinstance(part, Integral)}


def _is_over_turns(node: Integral) -> bool:
    """Tell whether an integral goes over turns or parts of one: π stands in its bounds."""
    bounds = [bound for bound in (node.lower, node.upper) if bound is not None]
    has_pi = any(part == Constant("pi") for bound in bounds for part in walk(bound))
    return has_pi or (node.closed and not bounds)


def _beside(body: Formula, variable: str) -> Iterator[str]:
    """Yield the letters that multiply a variable in the sines, cosines and phases of a formula."""
    for part in walk(body):
        if isinstance(part, Call) and part.function in ("sin", "cos", "exp"):
            yield from _factors(part.argument, variable)
        elif isinstance(part, Power) and part.base == Constant("e"):
            yield from _factors(part.exponent, variable)


def _factors(node: Formula, variable: str) -> Iterator[str]:
    """Yield the letters among the factors beside a variable: k and m of k(φ + m ψ) for ψ."""
    if variable not in names(node):
        return
    if isinstance(node, Product):
        own = [part.name for part in node.factors if isinstance(part, Name)]
        yield from (name for name in own if name != variable)
    if isinstance(node, Product | Sum | Negative):
        for part in node.factors if isinstance(node, Product) else _parts(node):
            yield from _factors(part, variable)
    elif isinstance(node, Quotient):
        yield from _factors(node.numerator, variable)


def _parts(node: Sum | Negative) -> tuple[Formula, ...]:
    return node.terms if isinstance(node, Sum) else (node.operand,)


# Special values -----------------------------------------------------------------------------------


def _at_special_values(
    left: Formula, right: Formula, decision: Decision, knowledge: Knowledge, decide: Decide
) -> Decision:
    """Return a proof less the exceptions at which the relation holds too, or which the page excepts.

    One that the page's own range includes, and at which the relation is false, refutes it.
    """
    if not decision.is_proved or decision.left is None:
        return decision
    special = decision.left.domain.special
    remaining: list[str] = []
    for text in decision.assumptions:
        if text not in special:
            remaining.append(text)
            continue
        letter, value = special[text]
        if _is_excepted(letter, value, knowledge):
            continue
        there = decide_at(left, right, letter, value, knowledge, decide)
        if there is not None and there.is_proved and set(there.assumptions) <= set(decision.assumptions):
            continue
        remaining.append(text)
        if there is not None and there.status == REFUTED and _is_included(letter, value, knowledge):
            number = {letter: plain_text(value)}
            stated = next(r.text for r in knowledge.ranges if letter in names(r.left) | names(r.right))
            reason = f"{stated} includes {letter} = {number[letter]}, where it is false"
            return replace(there, reason=reason, witness={**number, **there.witness})
    return replace(decision, assumptions=tuple(remaining))


def decide_at(
    left: Formula, right: Formula, letter: str, value: Formula, knowledge: Knowledge, decide: Decide
) -> Decision | None:
    """Decide a relation where a letter has a value, None where it cannot be put in."""
    known = _counting(knowledge, {ANY_WHOLE}).with_definition(letter, Definition(value, 0))
    try:
        first, second = (substitute(node, letter, value) for node in (left, right))
    except NoFormError:
        return None
    return _at_special_values(first, second, decide(first, second, known), known, decide)


def _ranges_of(letter: str, knowledge: Knowledge) -> list[StatedRange]:
    return [r for r in knowledge.ranges if letter in names(r.left) | names(r.right)]


def _is_excepted(letter: str, value: Formula, knowledge: Knowledge) -> bool:
    """Tell whether a range on the page leaves out a letter's value: 1 by N ≥ 2, m = n by m ≠ n."""
    for stated in _ranges_of(letter, knowledge):
        first, second = (substitute(node, letter, value) for node in (stated.left, stated.right))
        if names(first) | names(second):
            if stated.sign == "≠" and decide_equality(first, second, knowledge).is_proved:
                return True
            continue
        there = compare(first, second, stated.sign, knowledge)
        if there is not None and there.status == REFUTED:
            return True
    return False


def _is_included(letter: str, value: Formula, knowledge: Knowledge) -> bool:
    """Tell whether a range of a letter alone is stated of the relation in hand, its value in it.

    One that is stated further above is of other relations: nobody says that they hold for the same N.
    """
    if not isinstance(value, Number) or value.value == Fraction(0):
        return False
    ranges = [r for r in _ranges_of(letter, knowledge) if names(r.left) | names(r.right) == {letter}]
    return any(r.line >= knowledge.own_ranges_from for r in ranges) and not _is_excepted(
        letter, value, knowledge
    )
