"""The smallest change that makes a refuted line true, looked for and then proved.

First single changes of what is written (`edits`), sieved in floats and proved exactly, cheapest first;
then integers solved for; then a common factor; then every wrong term by its exact value. A change that is
not proved is not reported.
"""

from __future__ import annotations

import math
from cmath import isfinite
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction

from symbalance.document import formula
from symbalance.document.formula import Formula, Name, Number, Product, Quotient
from symbalance.notes.algebra import values
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.numbers import rational_node
from symbalance.notes.checking.deciding.changing import substituted, upright
from symbalance.notes.checking.premises import counts
from symbalance.notes.checking.repair.change import Edit, parts, ways
from symbalance.notes.checking.repair.edits import edits
from symbalance.notes.checking.repair.floats import NoValueError, Sieve, Values
from symbalance.notes.checking.repair.sieving import Case, fits, letters_of, sieve_of
from symbalance.notes.checking.repair.term_repair import kinds, repaired

MOST_PROOFS = 8
LARGEST = 10**7


@dataclass(frozen=True, slots=True)
class Repair:
    """A changed formula that is proved right: kind, the parts replaced and what replaces them."""

    kind: str
    node: Formula
    changes: tuple[tuple[Formula, Formula], ...]
    cost: float


def diagnosed(case: Case) -> Repair | None:
    """Return the cheapest change that is proved, or None."""
    rounded = _rounded(case)
    if rounded is not None:
        return rounded
    sieve = sieve_of(case)
    if sieve is not None:
        targets, quick = sieve
        for edit in _passing(case, quick, targets):
            changed = edit.applied(ways(case.node))
            if case.proves(changed):
                return Repair(edit.kind, changed, ((edit.old, edit.new),), edit.cost)
    return _by_factor(case) or _by_terms(case)


def _rounded(case: Case) -> Repair | None:
    """Return the exact value rounded as the side is, where that is one decimal number."""
    place = case.node.last_place if isinstance(case.node, Number) else None
    points = values.sample([case.answer.left]) if place and case.answer.left is not None else []
    if not place or not points or points[0][0]:
        return None
    if not values.context().isfinite(points[0][1][0]):
        return None  # ln 0
    exact = Fraction(str(points[0][1][0].real))
    while exact and abs(exact) < 10 * place:  # at least two digits
        place /= 10
    number = Number(round(exact / place) * place, place)
    return Repair("value", number, ((case.node, number),), 1.0) if case.proves(number) else None


def _passing(case: Case, sieve: Sieve, targets: list[Values]) -> list[Edit]:
    """Return the changes whose values fit, cheapest first."""
    way = ways(case.node)
    found: list[Edit] = list(_integers(case, sieve, targets, way))
    variables = (
        [case.knowledge.crank.time, *formula.names(case.knowledge.crank.theta)]
        if case.knowledge.crank
        else []
    )
    for edit in edits(case.node, letters_of(case), variables):
        if isinstance(edit.new, formula.Derivative):
            found.append(edit)
            continue
        if fits(edit.applied(way), sieve, targets):
            found.append(edit)
    found += _conventions(case, sieve, targets)
    return sorted(found, key=lambda e: e.cost)[:MOST_PROOFS]


def _integers(case: Case, sieve: Sieve, targets: list[Values], way: dict[int, Formula]) -> Iterator[Edit]:
    """Yield the whole numbers and fractions that, put for a printed number, give the right values.

    The side is taken as a + b y, or a + b/y, in that number y; two trial values give a and b.
    """
    for part, role in parts(case.node):
        if (
            not isinstance(part, Number)
            or part.value == 0
            or role in ("exponent", "argument", "angle term", "phase")
        ):
            continue
        try:
            here = sieve.values(case.node)
            doubled = sieve.values(Edit("", 0, part, rational_node(part.value * 2)).applied(way))
        except NoValueError:
            continue
        for value, inverse in _solutions(here[0], doubled[0], targets[0][0], part.value):
            if value != part.value and abs(value) <= LARGEST:
                new = rational_node(Fraction(value))
                if fits(Edit("", 0, part, new).applied(way), sieve, targets):
                    simple = value.denominator == 1
                    shown = f"{value} for {part.value}"
                    kind = f"number misprinted ({shown})" if abs(value) != abs(part.value) else "sign"
                    odd = 0.6 if value.denominator > 12 or abs(value) > 20 * abs(part.value) else 0
                    cost = (1.1 if simple else 1.4) + (0.05 if inverse else 0) + odd
                    yield Edit(kind, cost, part, new)


def _solutions(
    here: complex, doubled: complex, target: complex, value: Fraction
) -> Iterator[tuple[Fraction, bool]]:
    for inverse in (False, True):
        step = doubled - here if not inverse else -2 * (doubled - here)
        if abs(step) < 1e-14 * max(abs(here), 1e-30):
            continue
        ratio = 1 + (target - here) / step
        if not isfinite(ratio):
            continue
        if abs(ratio.imag) > 1e-7 * max(1, abs(ratio.real)) or abs(ratio) < 1e-9:
            continue
        exact = float(value) * ratio.real if not inverse else float(value) / ratio.real
        if not math.isfinite(exact):
            continue  # the number itself, or what it would be, is beyond a double
        if round(exact) and abs(exact - round(exact)) < 1e-6:
            yield Fraction(round(exact)), inverse
            continue
        guess = Fraction(ratio.real).limit_denominator(10_000)
        if guess.denominator > 64 or abs(guess.numerator) > 64:
            continue
        if guess and abs(float(guess) - ratio.real) < 1e-7 * max(1, abs(ratio.real)):
            found = value * guess if not inverse else value / guess
            yield found, inverse


def _conventions(case: Case, sieve: Sieve, targets: list[Values]) -> Iterator[Edit]:
    """Yield the side with λ doubled or halved throughout: l/r put for l/s, or the reverse."""
    small = case.knowledge.crank.small if case.knowledge.crank else None
    if small is None or small[0] not in formula.names(case.node):
        return
    letter = Name(small[0])
    for title, new in (
        ("rod ratio inverted (l/r for r/l)", Quotient(rational_node(Fraction(1)), letter)),
        (
            "rod ratio of the other convention (l/r, not l/s)",
            Product((rational_node(Fraction(2)), letter)),
        ),
        (
            "rod ratio of the other convention (l/s, not l/r)",
            Quotient(letter, rational_node(Fraction(2))),
        ),
    ):
        try:
            changed = upright(substituted(case.node, small[0], new))
        except NoFormError:  # a derivative by it
            continue
        if fits(changed, sieve, targets):
            once = counts(case.node)[small[0]] == 1 and "inverted" not in title
            yield Edit(title, 1.15 if once else 0.95, case.node, changed)


def _by_factor(case: Case) -> Repair | None:
    """Return the side times a factor of one term, where exact/claimed is one."""
    left, right = case.answer.left, case.answer.right
    if left is None or right is None or not (left.is_polynomial and right.is_polynomial):
        return None
    if max(len(left.numerator), len(right.numerator)) > 60:
        return None
    try:
        ratio = left.over(right)
        if not ratio.is_polynomial or len(ratio.numerator) != 1 or right.is_zero() is not False:
            return None
        from symbalance.notes.algebra.harmonics import polynomial_node

        (coefficient,) = ratio.numerator.values()
        if not (_is_simple(coefficient.numerator) and _is_simple(coefficient.denominator)):
            return None
        factor = polynomial_node(ratio.domain, ratio.numerator)
    except (NoFormError, TooLargeError):
        return None
    changed = Product((factor, case.node))
    return Repair("factor", changed, ((case.node, changed),), 2.0) if case.proves(changed) else None


def _is_simple(number: int) -> bool:
    """Tell whether a whole number is small, or a power of two: what a slip may have put in."""
    number = abs(number)
    return number <= 64 or (number & (number - 1) == 0 and number < 2**24)


def _by_terms(case: Case) -> Repair | None:
    """Return the side with each wrong term replaced by its exact value."""
    try:
        found = repaired(case.node, case.answer, case.knowledge)
    except (NoFormError, TooLargeError):
        return None
    if found is None:
        return None
    changed, changes = found
    if not case.proves(changed):
        return None
    return Repair(kinds(changes), changed, changes, 2.0 + len(changes))
