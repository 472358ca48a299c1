"""Decisions on sums without end, Σ_{k=0}^∞ of powers of a letter: power by power, to a high order.

The terms through that order are written out, and O( ) of the first one left out stands for the others:

    √(1 - u) = Σ C(1/2, k) (-u)^k    becomes    √(1 - u) = 1 - u/2 - … + C(1/2, 8) u^8 + O(u^9)
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from itertools import pairwise

from symbalance.document.formula import (
    INFINITY,
    Dots,
    Formula,
    Name,
    Number,
    Power,
    Sum,
    Summation,
    children,
    parts_of_kind,
    walk,
    with_children,
)
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.sums import at_index, indexed_letters
from symbalance.notes.checking.deciding.equality import UNDECIDED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge, Level
from symbalance.notes.checking.deciding.order_agreement import decide_agreement
from symbalance.notes.checking.deciding.remainders import decide_remainder, has_remainder
from symbalance.notes.checking.deciding.substitution import substitute

LEAST_ORDER = 8
"""Through which the powers are compared, and further by the highest that the other side writes."""
MOST_TERMS = 60
FEWEST_TERMS = 4
"""Terms in which a letter's power is seen to rise with the index."""
NO_POWERS = "a sum without end that is not in rising powers of a letter"
TERM_BY_TERM = "term by term"


def has_infinite_sum(*nodes: Formula) -> bool:
    """Tell whether a sum over an index without end stands in formulas."""
    return any(is_infinite(part) for node in nodes for part in parts_of_kind(node, Summation))


def is_infinite(node: Formula) -> bool:
    """Tell whether a formula is a sum over an index without end."""
    return isinstance(node, Summation) and node.index is not None and node.upper == INFINITY


def states_powers(left: Formula, right: Formula) -> bool:
    """Tell whether a relation is on powers of a letter: O( ) or a sum without end stands in it."""
    return has_infinite_sum(left, right) or has_remainder(left) or has_remainder(right)


def decide_powers(left: Formula, right: Formula, sign: str, knowledge: Knowledge) -> Decision:
    """Decide a relation with O( ), or between a sum without end and a closed form, dots or another."""
    if not has_infinite_sum(left, right):
        return decide_remainder(left, right, sign, knowledge)
    best = Decision(UNDECIDED, NO_POWERS)
    highest = LEAST_ORDER + max(map(_highest_power, (left, right)))
    for level in knowledge.levels(left, right):
        try:
            first, second = (_written_out(node, highest, knowledge, level) for node in (left, right))
        except (NoFormError, TooLargeError) as problem:
            best = Decision(UNDECIDED, f"no normal form: {problem}", level=level)
            continue
        return _decide_written_out(first, second, sign, knowledge)
    return best


def _decide_written_out(left: Formula, right: Formula, sign: str, knowledge: Knowledge) -> Decision:
    is_cut = sign == "≈" or any(_has_bare_dots(node) for node in (left, right))
    if is_cut:
        first, second = (_without_remainders(node) for node in (left, right))
        return decide_agreement(first, second, knowledge, loose=_has_bare_dots(right))
    if not has_remainder(right):
        turned = decide_remainder(right, left, sign, knowledge)
        decision = replace(turned, left=turned.right, right=turned.left, witness=_turned(turned))
    else:
        decision = decide_remainder(left, right, sign, knowledge)
    return replace(decision, reason=TERM_BY_TERM) if decision.is_proved else decision


def _turned(decision: Decision) -> dict[str, str]:
    witness = dict(decision.witness)
    if {"left", "right"} <= witness.keys():
        witness["left"], witness["right"] = witness["right"], witness["left"]
    return witness


def _has_bare_dots(node: Formula) -> bool:
    return any(isinstance(part, Dots) and part.order is None for part in walk(node))


def _without_remainders(node: Formula) -> Formula:
    """Return a formula without the O( ) of its sums, its own dots left."""
    if isinstance(node, Sum):
        terms = [t for t in node.terms if not isinstance(t, Dots) or t.order is None]
        return replace(node, terms=tuple(map(_without_remainders, terms)))
    parts = children(node)
    return with_children(node, tuple(map(_without_remainders, parts))) if parts else node


def _highest_power(node: Formula) -> int:
    """Return the highest power that is written as a number outside sums without end."""
    if is_infinite(node):
        return 0
    own = 0
    if isinstance(node, Power) and isinstance(node.exponent, Number):
        own = int(abs(node.exponent.value))
    return max([own, *map(_highest_power, children(node))])


def _written_out(node: Formula, highest: int, knowledge: Knowledge, level: Level) -> Formula:
    """Return a formula with the terms of its sums without end written out, and O( ) of the next."""
    if not isinstance(node, Summation) or not is_infinite(node):
        parts = children(node)
        if not parts:
            return node
        return with_children(node, tuple(_written_out(p, highest, knowledge, level) for p in parts))
    assert node.index is not None
    assert node.lower is not None
    evaluator = knowledge.evaluator(level)
    start = evaluator.form(node.lower).rational()
    if start is None or start.denominator != 1 or indexed_letters(node.body, node.index.name):
        raise NoFormError(NO_POWERS)
    terms, forms = [], []
    for place in range(MOST_TERMS):
        body = at_index(node.body, node.index.name, int(start) + place)
        term = substitute(body, node.index.name, Number(start + place))
        terms.append(term)
        forms.append(evaluator.form(term))
        if place + 1 < FEWEST_TERMS:
            continue
        letter, sign = _rising_letter(forms, knowledge)
        order = _least_power(forms[-1], letter, sign)
        if order is not None and order > highest:
            rest = Dots(order=Power(Name(letter), Number(Fraction(sign * order))))
            return Sum((*terms[:-1], rest))
    raise NoFormError(NO_POWERS)


def _rising_letter(forms: list[Form], knowledge: Knowledge) -> tuple[str, int]:
    """Return the letter whose powers rise evenly from term to term, and -1 where it stands below.

    In x^(n(20 - n)) they rise at first only: what is left out is of a higher order if they go on evenly.
    """
    usual = knowledge.crank.small[0] if knowledge.crank and knowledge.crank.small else ""
    letters = {name for form in forms for name in _symbols(form)}
    ordered = sorted(letters, key=lambda name: (name != usual, name not in knowledge.small, name))
    for name in ordered:
        for sign in (1, -1):
            powers = [
                (place, p)
                for place, form in enumerate(forms)
                if (p := _least_power(form, name, sign)) is not None
            ]
            steps = {Fraction(b - a, n - m) for (m, a), (n, b) in pairwise(powers)}
            if len(powers) >= FEWEST_TERMS // 2 and len(steps) == 1 and min(steps) > 0 <= powers[0][1]:
                return name, sign
    raise NoFormError(NO_POWERS)


def _symbols(form: Form) -> set[str]:
    generators = form.domain.generators
    return {generators[g].content for m in form.numerator for g, _ in m if generators[g].kind == "symbol"}


def _least_power(form: Form, letter: str, sign: int) -> int | None:
    """Return the least power of a letter, or of one over it, in a form; None for 0 or half powers."""
    number = form.domain.symbol(letter)
    powers = [sign * Fraction(dict(monomial).get(number, 0)) for monomial in form.numerator]
    if not powers or not form.is_polynomial or any(p.denominator != 1 for p in powers):
        return None
    return int(min(powers))
