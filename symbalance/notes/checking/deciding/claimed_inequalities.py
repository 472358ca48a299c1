"""Inequalities claimed of all values: |sin θ + cos θ| ≤ √2 for every θ is proved, with 1 for √2 refuted.

Without such words an inequality between letters says where they lie, and narrows them. With them it is a
claim: a value at which it fails refutes it, amplitudes and squares prove it, and else it is undecided.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

from symbalance.document.formula import Call, Formula, Negative, Number, Sum, names
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra import polynomials as poly
from symbalance.notes.algebra.domain import Domain, NoFormError, Polynomial, TooLargeError
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.harmonics import components
from symbalance.notes.algebra.letters_behind import letters_behind
from symbalance.notes.algebra.number_formulas import number_node
from symbalance.notes.algebra.values import Point
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, UNDECIDED, Decision
from symbalance.notes.checking.deciding.inequalities import (
    SATISFIED_BY,
    compare,
    lone_letter,
    witness_of,
)
from symbalance.notes.checking.deciding.knowledge import Knowledge, StatedRange
from symbalance.notes.checking.deciding.satisfiability import failing_point, sign_at, survey
from symbalance.notes.checking.verdicts import RANGE
from symbalance.notes.reading.equations import Chain, ReadNotes

NEAR = 3
"""Lines before a claim in which a range may be that of its letters."""
DRAWS = 5
"""Values of the letters that are not spoken of, for each of which the claim has to fail."""
_ZERO = Number(Fraction(0))


def decide_claimed(
    chain: Chain,
    k: int,
    decision: Decision,
    general: frozenset[str],
    near: tuple[StatedRange, ...],
    knowledge: Knowledge,
) -> Decision:
    """Return the decision on an inequality that would be a range, as one claimed of all values.

    `general` are the letters of all of whose values it is claimed, `near` the ranges that stand before
    it: for 0 < x < π, sin x > 0 for all x. Where none of them stands in it, or
    one that nobody declared decides (a x² > 0 for all x), it says where that one lies; so does a letter
    between numbers: for all x, 0 < x < 1.
    """
    left, right, sign = chain.sides[k].node, chain.sides[k + 1].node, chain.relations[k].sign
    alone = lone_letter(StatedRange(left, sign, right, chain.lines[0]))
    if decision.status != RANGE or sign == "≠" or (alone is not None and alone[0] in general):
        return decision
    level = list(knowledge.levels(left, right))[-1]
    meaning = replace(knowledge.meaning, values=level.values)
    own = {name for node in (left, right) for name in letters_behind(node, meaning.values)}
    if not own & general:
        return decision
    if _is_proved(left, right, sign, knowledge):
        return Decision(PROVED, level=level)
    others = own - general
    failures: list[tuple[Point, Any, Any] | None] = []
    inside = [r for r in (*knowledge.ranges, *near) if names(r.left) | names(r.right) <= others]
    for values in _draws(sorted(others), left, right, meaning, inside):
        there = replace(meaning, values={**meaning.values, **values})
        where = _within((*knowledge.ranges, *near), own, there)
        failures.append(failing_point(left, right, there, SATISFIED_BY[sign], where))
    if failures and all(failures):
        point, first, second = next(f for f in failures if f is not None)
        return Decision(
            REFUTED, "said of all values", level=level, witness=witness_of(point, first, second)
        )
    ranges = (*knowledge.ranges, *near)
    is_within = any(own & (names(r.left) | names(r.right)) for r in ranges) and not any(failures)
    if others <= knowledge.meanings.keys() and not is_within:
        reason = "for some values of its other letters only" if any(failures) else "not proved"
        return Decision(UNDECIDED, f"said of all values: {reason}", level=level)
    return decision


def ranges_near(document: ReadNotes, chain: Chain) -> tuple[StatedRange, ...]:
    """Return the ranges of letters that stand in the lines before a relation, of a case or not."""
    first, start = chain.lines[0] - NEAR, chain.start
    before = [c for c in document.chains if first <= c.lines[0] <= chain.lines[-1] and c.end <= start]
    stated = [
        StatedRange(c.sides[n].node, relation.sign, c.sides[n + 1].node, c.lines[0])
        for c in before
        for n, relation in enumerate(c.relations)
        if relation.sign in SATISFIED_BY
    ]
    return tuple(
        each
        for each in stated
        if lone_letter(each) is not None or len(names(each.left) | names(each.right)) == 1
    )


def _within(
    ranges: tuple[StatedRange, ...], own: set[str], meaning: SymbolValue
) -> Callable[[Point], bool]:
    """Return what tells whether a point satisfies the ranges of some letters."""
    near = [r for r in ranges if own & (names(r.left) | names(r.right))]

    def satisfies(point: Point) -> bool:
        return all(sign_at(r.left, r.right, meaning, point) in SATISFIED_BY[r.sign] for r in near)

    return satisfies


def _draws(
    others: list[str],
    left: Formula,
    right: Formula,
    meaning: SymbolValue,
    inside: Sequence[StatedRange],
) -> Iterator[Mapping[str, Formula]]:
    """Yield values for letters, within their own ranges, at which both sides are real somewhere."""
    if not others:
        yield {}
        return
    chance, tries = random.Random(f"{others}"), 0
    draws = 0
    while draws < DRAWS and tries < 8 * DRAWS:
        tries += 1
        values = {name: Number(_draw(name, meaning, chance)) for name in others}
        there = replace(meaning, values={**meaning.values, **values})
        if any(sign_at(r.left, r.right, there, {}) not in SATISFIED_BY[r.sign] for r in inside):
            continue
        if survey(left, right, there, roots=False).tried:
            draws += 1
            yield values


def _draw(name: str, meaning: SymbolValue, chance: random.Random) -> Fraction:
    if name in meaning.integer:
        return Fraction(chance.randint(0, 9))
    value = Fraction(round(10 ** chance.uniform(3, 5)), 10**4)
    return value if name in meaning.positive or chance.random() < 0.5 else -value


def _is_proved(left: Formula, right: Formula, sign: str, knowledge: Knowledge) -> bool:
    """Tell whether the larger side minus the smaller one is never negative, or always positive.

    A size on the smaller side is two claims: |a| ≤ b where a ≤ b and -a ≤ b.
    """
    small, large = (left, right) if sign in "<≤" else (right, left)
    if sign in "≤≥" and _is_triangle(small, large):
        return True
    smaller = (
        (small.argument, Negative(small.argument))
        if isinstance(small, Call) and _is_size(small)
        else (small,)
    )
    return all(
        _is_above(Sum((large, Negative(node))), knowledge, strictly=sign in "<>") for node in smaller
    )


def _is_size(node: Formula) -> bool:
    return isinstance(node, Call) and node.function == "abs"


def _is_triangle(small: Formula, large: Formula) -> bool:
    """Tell whether the size of a sum stands below the sum of its terms' sizes: |a + b| ≤ |a| + |b|."""
    if not (isinstance(small, Call) and _is_size(small) and isinstance(small.argument, Sum)):
        return False
    sizes = large.terms if isinstance(large, Sum) else ()
    inner = [node.argument for node in sizes if isinstance(node, Call) and _is_size(node)]
    terms = [t.operand if isinstance(t, Negative) else t for t in small.argument.terms]
    return len(inner) == len(sizes) and sorted(map(formula_text, inner)) == sorted(
        map(formula_text, terms)
    )


def _is_above(difference: Formula, knowledge: Knowledge, *, strictly: bool) -> bool:
    level = list(knowledge.levels(difference))[-1]
    try:
        form = knowledge.evaluator(level).form(difference)
    except (NoFormError, TooLargeError):
        return False
    if not form.is_polynomial:
        return False
    by_waves = _least_of_waves(form, knowledge, strictly=strictly)
    return by_waves or _is_sum_of_squares(form.domain, form.numerator, strictly=strictly)


def _least_of_waves(form: Form, knowledge: Knowledge, *, strictly: bool) -> bool:
    """Tell whether the constant outweighs the amplitudes of all waves: √2 those of sin θ + cos θ."""
    constant: Formula = _ZERO
    squares: dict[object, Fraction] = {}
    for key, number in components(form.domain, form.numerator).items():
        if key.letters:
            return False
        if key.function == "1":
            constant = number_node(form.domain, number)
            continue
        square = poly.times(form.domain, number, number)
        if not poly.is_rational(square):
            return False
        squares[key.angle] = squares.get(key.angle, Fraction(0)) + square.get((), Fraction(0))
    if not squares:
        return False
    amplitudes = [Negative(Call("sqrt", Number(square))) for square in squares.values()]
    least = compare(Sum((constant, *amplitudes)), _ZERO, ">" if strictly else "≥", knowledge)
    return least is not None and least.is_proved


def _is_sum_of_squares(domain: Domain, polynomial: Polynomial, *, strictly: bool) -> bool:
    """Tell whether a quadratic polynomial of letters is a sum of squares: a² + b² - 2ab."""
    letters = sorted({g for monomial in polynomial for g, _ in monomial})
    if not letters or any(domain.generators[g].kind != "symbol" for g in letters):
        return False
    place = {g: n for n, g in enumerate(letters, 1)}
    size = len(letters) + 1
    rows = [[Fraction(0)] * size for _ in range(size)]
    for monomial, coefficient in polynomial.items():
        factors = [place[g] for g, e in monomial for _ in range(int(e)) if e in (1, 2)]
        if len(factors) != sum(e for _, e in monomial) or len(factors) > 2:
            return False
        a, b = [0, 0, *factors][-2:]
        rows[a][b] += Fraction(coefficient) / 2
        rows[b][a] += Fraction(coefficient) / 2
    return _is_positive_definite(rows) if strictly else _is_semidefinite(rows)


def _is_positive_definite(rows: list[list[Fraction]]) -> bool:
    """Tell whether a symmetric matrix with 1 for its first unknown has only positive pivots before it."""
    return _is_semidefinite([[rows[0][0] - Fraction(1, 10**9), *rows[0][1:]], *rows[1:]])


def _is_semidefinite(rows: list[list[Fraction]]) -> bool:
    """Tell whether a symmetric matrix has no negative pivot, and no row left beside a pivot of zero."""
    rows = [list(row) for row in rows]
    waiting = set(range(len(rows)))
    while waiting:
        pivot = max(waiting, key=lambda n: rows[n][n])
        value = rows[pivot][pivot]
        if value < 0:
            return False
        if not value:
            return all(not rows[a][b] for a in waiting for b in waiting)
        waiting.remove(pivot)
        for a in waiting:
            factor = rows[a][pivot] / value
            for b in waiting:
                rows[a][b] -= factor * rows[pivot][b]
    return True
