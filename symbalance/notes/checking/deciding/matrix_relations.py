"""Decisions on relations between matrices, with a witness in numbers for those that differ."""

from __future__ import annotations

import random
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from symbalance.document import formula
from symbalance.document.formula import Equation, Formula, Name
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra import values
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.matrices import (
    Factor,
    Kinds,
    Literal,
    MatrixEvaluator,
    Value,
    Words,
    holds_matrices,
    sum_name,
)
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, UNDECIDED, Decision, digits
from symbalance.notes.checking.deciding.knowledge import Knowledge, Level

SIZE = 2
"""Rows of the matrices that letters stand for in a witness: the least that do not commute."""


def is_of_matrices(left: Formula, right: Formula, knowledge: Knowledge) -> bool:
    """Tell whether a relation is one between matrices."""
    kinds = _kinds(knowledge)
    return any(holds_matrices(side, kinds) for side in (left, right))


def _kinds(knowledge: Knowledge) -> Kinds:
    """Return which letters are matrices: as declared, and those that the page gives rows of entries."""
    kinds = knowledge.meaning.kinds
    given = {name for name, d in knowledge.definitions.items() if isinstance(d.node, formula.Matrix)}
    return replace(kinds, matrices=kinds.matrices | (given - kinds.letters)) if given else kinds


def decide_matrices(left: Formula, right: Formula, sign: str, knowledge: Knowledge) -> Decision:
    """Decide an equality of matrices, with as little knowledge as it takes."""
    return replace(_decide_matrices(left, right, sign, knowledge), of_matrices=True)


def _decide_matrices(left: Formula, right: Formula, sign: str, knowledge: Knowledge) -> Decision:
    if sign not in ("=", "≡"):
        return Decision(UNDECIDED, "matrices are compared for equality only")
    last = Decision(UNDECIDED, "nothing to compare")
    for level in knowledge.levels(left, right):
        last = _at_level(left, right, knowledge, level)
        if last.is_proved:
            return last
    if last.status == REFUTED:
        lines = [
            f"{name} is that of line {knowledge.definitions[name].line}"
            for name in _names(left, right)
            if name in knowledge.definitions
        ]
        return Decision(REFUTED, "; ".join([r for r in (last.reason, *lines) if r]), witness=last.witness)
    return last


def _names(*nodes: Formula) -> list[str]:
    """Return the letters of formulas, and the sums of vectors that are letters of their own."""
    names: dict[str, None] = {}
    for node in nodes:
        for part in formula.walk(node):
            if isinstance(part, Name):
                names[part.name] = None
            elif isinstance(part, formula.Summation):
                names[sum_name(part)] = None
    return list(names)


def _at_level(left: Formula, right: Formula, knowledge: Knowledge, level: Level) -> Decision:
    evaluator = MatrixEvaluator(knowledge.evaluator(level), _kinds(knowledge))
    try:
        first, second = evaluator.value(left), evaluator.value(right)
        return _compare(first, second, evaluator, level)
    except (NoFormError, TooLargeError) as problem:
        return Decision(UNDECIDED, f"not compared: {problem}", level=level)


def _compare(first: Value, second: Value, evaluator: MatrixEvaluator, level: Level) -> Decision:
    for one, other in ((first, second), (second, first)):
        if isinstance(one, Form) and one.is_zero() is not True and isinstance(other, Words):
            first, second = Words({(): one}), other  # M⁻¹M = 1: the identity written as a number
    if isinstance(first, Literal) and isinstance(second, Literal) and first.shape != second.shape:
        shapes = {"left": "{} × {}".format(*first.shape), "right": "{} × {}".format(*second.shape)}
        return Decision(REFUTED, "matrices of different size", level=level, witness=shapes)
    gap = evaluator.plus(first, evaluator.scaled(second, evaluator.number(-1)))
    assumptions = (*level.assumptions, *evaluator.domain.assumptions)
    if isinstance(gap, Form):
        rows: Sequence[Sequence[Form]] = [[gap]]
    elif isinstance(gap, Literal):
        rows = gap.rows
    elif not gap.terms:
        return Decision(PROVED, assumptions=assumptions, level=level)
    else:
        return _of_words(first, second, evaluator, level)
    zero = [[entry.is_zero() for entry in row] for row in rows]
    if all(answer is True for row in zero for answer in row):
        return Decision(PROVED, assumptions=assumptions, level=level)
    place = next(
        (i, k) for i, row in enumerate(zero) for k, answer in enumerate(row) if answer is not True
    )
    return _at_place(first, second, place, level)


def _entry(value: Value, place: tuple[int, int]) -> Form:
    if isinstance(value, Literal):
        return value.rows[place[0]][place[1]]
    if isinstance(value, Form):
        return value
    raise NoFormError("letters beside entries")


def _at_place(first: Value, second: Value, place: tuple[int, int], level: Level) -> Decision:
    """Return the decision on two entries that are not proved equal."""
    left = _entry(first, place)
    right = _entry(second, place) if isinstance(second, Literal) or isinstance(first, Form) else second
    if not isinstance(right, Form):
        raise NoFormError("letters beside entries")
    where = "" if isinstance(first, Form) else f"entry ({place[0] + 1}, {place[1] + 1})"
    for point, pair in values.sample([left, right]):
        scale = max(abs(pair[0]), abs(pair[1]), values.context().mpf(10) ** -300)
        if abs(pair[0] - pair[1]) > scale * values.context().mpf(10) ** -25:
            witness = {name: f"{float(number):.6g}" for name, number in point.items()}
            witness |= {"left": digits(pair[0]), "right": digits(pair[1])}
            return Decision(REFUTED, where, level=level, witness=witness)
    return Decision(UNDECIDED, f"{where} equal at the points tried, not proved".strip(), level=level)


def _of_words(first: Value, second: Value, evaluator: MatrixEvaluator, level: Level) -> Decision:
    """Refute by matrices of two rows put in for the letters: the product of all, entry by entry."""
    assert isinstance(first, Words) or isinstance(second, Words)
    chance = random.Random("matrices")
    numbers = Numbers(evaluator.kinds, chance)
    sides = [side.terms if isinstance(side, Words) else {} for side in (first, second)]
    scalars = [scalar for side in sides for scalar in side.values()]
    points = values.sample(scalars)
    if not points:
        return Decision(UNDECIDED, "no point where both sides are real", level=level)
    point, sizes = points[0]
    try:
        pair = []
        for side in sides:
            own, sizes = sizes[: len(side)], sizes[len(side) :]
            pair.append(numbers.of(list(zip(side, own, strict=True))))
    except ShapeError:
        return Decision(UNDECIDED, "the sizes of its matrices and vectors do not fit", level=level)
    for i, row in enumerate(pair[0] or pair[1]):
        for k in range(len(row)):
            left, right = (side[i][k] if side else values.context().mpf(0) for side in pair)
            if abs(left - right) > values.context().mpf(10) ** -20 * (abs(left) + abs(right)):
                witness = {name: f"{float(number):.6g}" for name, number in point.items()}
                witness |= numbers.printed()
                witness |= {"left": digits(left), "right": digits(right)}
                return Decision(REFUTED, f"entry ({i + 1}, {k + 1})", level=level, witness=witness)
    return Decision(UNDECIDED, "equal for the matrices tried, not proved", level=level)


class ShapeError(Exception):
    """A sum or product of matrices whose sizes do not fit."""


class Numbers:
    """Matrices of small whole numbers that the letters of words stand for."""

    def __init__(self, kinds: Kinds, chance: random.Random) -> None:
        self.kinds, self.chance, self.mp = kinds, chance, values.context()
        self._matrices: dict[tuple[str, int], list[list[Any]]] = {}

    def of(self, terms: list[tuple[tuple[Factor, ...], Any]]) -> list[list[Any]]:
        """Return the value of a sum of words, an empty list of none."""
        total: list[list[Any]] = []
        for word, scalar in terms:
            part = self._word(word)
            part = [[scalar * entry for entry in row] for row in part]
            if total and (len(total), len(total[0])) != (len(part), len(part[0])):
                raise ShapeError
            total = (
                [
                    [a + b for a, b in zip(one, two, strict=True)]
                    for one, two in zip(total, part, strict=True)
                ]
                if total
                else part
            )
        return total

    def _word(self, word: tuple[Factor, ...]) -> list[list[Any]]:
        total = [[self.mp.mpf(i == k) for k in range(SIZE)] for i in range(SIZE)]
        is_first = True
        for factor in word:
            part = self._factor(factor)
            if is_first:
                total, is_first = part, False
                continue
            if len(total[0]) != len(part):
                raise ShapeError
            total = [
                [
                    self.mp.fsum(a * b for a, b in zip(row, column, strict=True))
                    for column in zip(*part, strict=True)
                ]
                for row in total
            ]
        return total

    def _factor(self, factor: Factor) -> list[list[Any]]:
        rows = self._letter(factor.name, factor.dots)
        if factor.is_inverted:
            (a, b), (c, d) = rows
            below = a * d - b * c
            rows = [[d / below, -b / below], [-c / below, a / below]]
        return [list(column) for column in zip(*rows, strict=True)] if factor.is_transposed else rows

    def _letter(self, name: str, dots: int) -> list[list[Any]]:
        key = (name, dots)
        if key not in self._matrices:
            columns = SIZE if name in self.kinds.matrices else 1
            rows = [[self.mp.mpf(self.chance.randint(1, 9)) for _ in range(columns)] for _ in range(SIZE)]
            if name in self.kinds.symmetric:
                rows[1][0] = rows[0][1]
            if columns == SIZE and rows[0][0] * rows[1][1] == rows[0][1] * rows[1][0]:
                rows[0][0] += 1
            self._matrices[key] = rows
        return self._matrices[key]

    def printed(self) -> dict[str, str]:
        """Return the letters with their matrices, as a witness names them."""
        named = {}
        for (name, dots), rows in self._matrices.items():
            entries = "; ".join(", ".join(str(int(entry)) for entry in row) for row in rows)
            named[f"{name}{'˙' * dots}"] = f"[{entries}]"
        return named


# Relations that state something -------------------------------------------------------------------


def matrix_constraint(
    left: Formula, right: Formula, letters_in_use: set[str], knowledge: Knowledge
) -> tuple[str, Formula] | None:
    """Return a letter and what a relation of matrices says that it is, None where it must be a step.

    It is the last new letter that is a term by itself, or a sum of vectors that has no value yet. An
    equation of motion between columns of entries states one as well: its last entry that is new.
    """
    if not is_of_matrices(left, right, knowledge):
        return None
    for side, other in ((right, left), (left, right)):
        if isinstance(side, formula.Summation) and not knowledge.knows(sum_name(side)):
            return sum_name(side), other
    if isinstance(left, formula.Summation) or isinstance(right, formula.Summation):
        return None
    if right == formula.number(0) and _is_of_a_vector(left, knowledge):
        return formula_text(left, plain=True), right
    terms = right.terms if isinstance(right, formula.Sum) else (right,)
    for term in reversed(terms):
        if isinstance(term, Name) and _is_new(term.name, left, right, letters_in_use, knowledge):
            rest = tuple(formula.Negative(other) for other in terms if other is not term)
            return term.name, formula.Sum((left, *rest)) if rest else left
    return _new_entry(left, right, letters_in_use, knowledge)


def _is_new(
    name: str, left: Formula, right: Formula, letters_in_use: set[str], knowledge: Knowledge
) -> bool:
    count = sum(
        isinstance(p, Name) and p.name == name for side in (left, right) for p in formula.walk(side)
    )
    return count == 1 and name not in letters_in_use and not knowledge.has_meaning(name)


def _is_of_a_vector(left: Formula, knowledge: Knowledge) -> bool:
    """Tell whether all terms end in vectors without a value: (K - ω²M) φ = 0 is solved for φ."""
    level = list(knowledge.levels(left))[-1]
    try:
        value = MatrixEvaluator(knowledge.evaluator(level), _kinds(knowledge)).value(left)
    except (NoFormError, TooLargeError):
        return False
    vectors = _kinds(knowledge).vectors
    return isinstance(value, Words) and all(word and word[-1].name in vectors for word in value.terms)


def meaningless(left: Formula, right: Formula, knowledge: Knowledge) -> str:
    """Return why a relation between matrices can be none: A + 1, F = K; "" where it may be one."""
    if not is_of_matrices(left, right, knowledge):
        return ""
    level = Level({})
    if any(
        getattr(part, "function", "") in ("at", "abs")
        for side in (left, right)
        for part in formula.walk(side)
    ):  # R(β) is nothing without the R(α) above, |F| without the entries of F
        level = list(knowledge.levels(left, right))[-1]
    evaluator = MatrixEvaluator(knowledge.evaluator(level), _kinds(knowledge))
    try:
        sides = [evaluator.value(side) for side in (left, right)]
    except NoFormError as problem:
        return str(problem)
    except TooLargeError:
        return ""
    numbers, shapes = Numbers(evaluator.kinds, random.Random("sizes")), set()
    for side in sides:
        terms = side.terms if isinstance(side, Words) else {}
        if any(factor.name not in evaluator.kinds.letters for word in terms for factor in word):
            return ""  # a sum of vectors, a row of columns: of no known size
        try:
            rows = numbers.of([(word, 1) for word in terms])
        except ShapeError:
            return "sizes of matrices and vectors that do not fit"
        shapes |= {(len(rows), len(rows[0]))} if rows else set()
    return "a vector set equal to a matrix" if len(shapes) > 1 else ""


def decide_published(left: Formula, right: Formula, equation: Equation, knowledge: Knowledge) -> Decision:
    """Decide whether an equation of columns is the one that somebody who knows engines hands in."""
    level = list(knowledge.levels(left, right))[-1]
    evaluator = MatrixEvaluator(knowledge.evaluator(level), _kinds(knowledge))
    try:
        sides = [evaluator.value(side) for side in (left, right, equation.left, equation.links[0][1])]
        minus = evaluator.number(-1)
        gaps = [evaluator.plus(one, evaluator.scaled(two, minus)) for one, two in (sides[:2], sides[2:])]
        return replace(_compare(gaps[0], gaps[1], evaluator, level), of_matrices=True)
    except (NoFormError, TooLargeError) as problem:
        return Decision(UNDECIDED, f"not compared: {problem}", level=level)


def _new_entry(
    left: Formula, right: Formula, letters_in_use: set[str], knowledge: Knowledge
) -> tuple[str, Formula] | None:
    """Return a new letter of a column of new letters, which the other entries leave free."""
    for part in formula.walk(right):
        if not isinstance(part, formula.Matrix) or len(part.rows[0]) != 1:
            continue
        entries = [row[0] for row in part.rows]
        if all(
            isinstance(e, Name) and _is_new(e.name, left, right, letters_in_use, knowledge)
            for e in entries
        ):
            first = entries[0]
            assert isinstance(first, Name)
            return f"({formula_text(part, plain=True)})", left
    return None
