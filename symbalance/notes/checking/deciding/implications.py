"""Relations said to follow from the one before, or to be equivalent: a point where only one is true.

x > 3, hence x > 5 is refuted by x = 4; x² = 4 ⇔ x = 2 by x = -2. Nothing is proved here: that no such
point turns up among those tried says nothing.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import product
from math import ceil, floor
from typing import Any

from symbalance.document.formula import Constant, Formula, Name, Negative, Number, Product, Sum, names
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.algebra.tree_values import sample_trees
from symbalance.notes.algebra.values import context
from symbalance.notes.checking.deciding.inequalities import SATISFIED_BY, witness_of
from symbalance.notes.checking.deciding.knowledge import Knowledge, StatedRange
from symbalance.notes.checking.deciding.satisfiability import sign_at, survey

MOST_LETTERS = 3
NEAR_ZERO = 20
"""Digits to which two sides agree that are equal."""
_HALVES = tuple(Fraction(n, 2) for n in (0, 2, -2, 4, -4, 1, -1, 6, -6))
_FEW = tuple(map(Fraction, (0, 1, -1, 2)))
"""Values where there are as many letters as are tried."""
_TWELFTHS = (6, -6, 12, -12, 4, -4, 18, 24, 3, 8)
"""Multiples of 15 degrees that are tried."""


def range_that_fails(stated: StatedRange, given: Sequence[StatedRange], knowledge: Knowledge) -> Any:
    """Return a point, with both sides, where ranges hold and one that is said to follow does not."""
    own = names(stated.left) | names(stated.right)
    covered = {name for r in given for name in names(r.left) | names(r.right)}
    if not own or not own <= covered:
        return None
    level = list(knowledge.levels(stated.left, stated.right))[-1]
    spans = _around(stated, given)
    meaning = replace(
        knowledge.meaning, values=level.values, ranges={**knowledge.meaning.ranges, **spans}
    )

    def satisfies(point: Mapping[str, Fraction]) -> bool:
        return all(sign_at(r.left, r.right, meaning, dict(point)) in SATISFIED_BY[r.sign] for r in given)

    nodes = [node for r in given for node in (r.left, r.right)]
    signs = survey(stated.left, stated.right, meaning, roots=False, where=satisfies, also=nodes)
    failing = [s for s in signs.examples if s not in SATISFIED_BY[stated.sign]]
    return witness_of(*signs.examples[failing[0]]) if failing else None


def _around(stated: StatedRange, given: Sequence[StatedRange]) -> dict[str, tuple[int, int]]:
    """Return where to draw the letters that stand alone beside numbers: between or around all of those.

    Between them a letter is drawn that has a least and a largest value: few points around 0.25 ≤ λ ≤ 0.3
    satisfy both.
    """
    bounds: dict[str, list[tuple[Fraction, str]]] = {}
    for r in (stated, *given):
        for node, other in ((r.left, r.right), (r.right, r.left)):
            number = other.operand if isinstance(other, Negative) else other
            if isinstance(node, Name) and isinstance(number, Number):
                value = number.value if number is other else -number.value
                is_lower = (r.sign in _LESS) is (node is r.right)
                kind = "" if r is stated else "least" if is_lower else "largest"
                bounds.setdefault(node.name, []).append((value, kind))
    spans = {}
    for name, rows in bounds.items():
        values = [value for value, _ in rows]
        margin = 0 if {"least", "largest"} <= {kind for _, kind in rows} else 1
        least, largest = 100 * (min(values) - margin), 100 * (max(values) + margin)
        spans[name] = (floor(least), max(ceil(largest), floor(least) + 1))
    return spans


_LESS = ("<", "≤", "≪")


def solution_lost(
    first: tuple[Formula, Formula],
    second: tuple[Formula, Formula],
    knowledge: Knowledge,
    given: Sequence[tuple[Formula, Formula]] = (),
) -> dict[str, Formula] | None:
    """Return values of the letters that satisfy one equation and not another; None if none turn up."""
    own = sorted({name for node in (*first, *second) for name in names(node)})
    if (
        not own
        or len(own) > MOST_LETTERS
        or any(knowledge.knows(n) for n in own if not _is_own(n, second))
    ):
        return None
    for point in _points(own, second, knowledge):
        meaning = replace(knowledge.meaning, values={**knowledge.meaning.values, **point})
        if _is_outside(point, knowledge):
            continue
        if all(_agree(*sides, meaning) is True for sides in (first, *given)) and (
            _agree(*second, meaning) is False
        ):
            return point
    return None


def _is_own(name: str, second: tuple[Formula, Formula]) -> bool:
    """Tell whether an equation gives a letter: its value by the lines before is the one in question."""
    return isinstance(second[0], Name) and second[0].name == name


def _points(
    own: Sequence[str], second: tuple[Formula, Formula], knowledge: Knowledge
) -> Iterator[dict[str, Formula]]:
    pi = Constant("pi")
    numbers: list[Formula] = [_number(value) for value in _HALVES]
    numbers += [Product((_number(Fraction(n, 12)), pi)) for n in _TWELFTHS]
    near: list[Formula] = []
    if not names(second[1]):
        value = second[1]
        turn = Product((_number(Fraction(2)), pi))
        near = [Negative(value), Sum((pi, Negative(value))), Sum((value, pi)), Sum((value, turn))]
    if len(own) == MOST_LETTERS:
        numbers = [_number(value) for value in _FEW]
    for values in product(near + numbers, repeat=len(own)):
        yield dict(zip(own, values, strict=True))


def _number(value: Fraction) -> Formula:
    return Number(value) if value >= 0 else Negative(Number(-value))


def _agree(left: Formula, right: Formula, meaning: SymbolValue) -> bool | None:
    """Tell whether two sides without free letters are equal, to twenty digits; None without values."""
    points = sample_trees([left, right], meaning, 1, tries=1)
    if not points or points[0][0]:
        return None
    first, second = points[0][1]
    return bool(abs(first - second) <= max(abs(first), abs(second), 1) * context().mpf(10) ** -NEAR_ZERO)


def _is_outside(point: Mapping[str, Formula], knowledge: Knowledge) -> bool:
    """Tell whether values contradict what the letters are declared to be, or a range."""
    meaning = replace(knowledge.meaning, values={**knowledge.meaning.values, **point})
    zero = Number(Fraction(0))
    for name in point:
        if name in meaning.positive and sign_at(Name(name), zero, meaning, {}) != 1:
            return True
        rows = sample_trees([Name(name)], meaning, 1, tries=1)
        if name in meaning.integer and (not rows or not context().isint(rows[0][1][0].real)):
            return True
    own = set(point)
    return any(
        sign_at(r.left, r.right, meaning, {}) not in SATISFIED_BY[r.sign]
        for r in knowledge.ranges
        if names(r.left) | names(r.right) <= own
    )


def point_text(point: Mapping[str, Formula]) -> str:
    """Return values of letters as `x = -2, y = 1`."""
    return ", ".join(
        f"{formula_text(Name(n), plain=True)} = {formula_text(v, plain=True)}" for n, v in point.items()
    )
