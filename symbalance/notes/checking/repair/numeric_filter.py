"""A quick filter for changed formulas by their values in floats at a few points, before any proof."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from symbalance.document import formula
from symbalance.document.formula import Formula
from symbalance.notes.algebra import values
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.evaluation import FormEvaluator, complex_parts
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge

Values = tuple[complex, ...]
CLOSE = 1e-9
"""Relative: well above what floats round, and far below what a slip changes."""

_FUNCTIONS: dict[str, Callable[[complex], complex]] = {
    "sin": cmath.sin,
    "cos": cmath.cos,
    "tan": cmath.tan,
    "cot": lambda x: 1 / cmath.tan(x),
    "sec": lambda x: 1 / cmath.cos(x),
    "csc": lambda x: 1 / cmath.sin(x),
    "asin": cmath.asin,
    "acos": cmath.acos,
    "atan": cmath.atan,
    "sinh": cmath.sinh,
    "cosh": cmath.cosh,
    "tanh": cmath.tanh,
    "exp": cmath.exp,
    "ln": cmath.log,
    "log": cmath.log,
    "sqrt": cmath.sqrt,
    "abs": abs,
}
_CONSTANTS = {"pi": complex(math.pi), "e": complex(math.e), "i": 1j}


@dataclass(frozen=True)
class Case:
    """A refuted side: the formula, the decision that refuted it, and how a changed one is proved."""

    node: Formula
    decision: Decision
    knowledge: Knowledge
    proves: Callable[[Formula], bool]


def filter_of(case: Case) -> tuple[list[Values], NumericFilter] | None:
    """Return the values the side should have at a few points, and a filter for its changed copies."""
    decision, knowledge = case.decision, case.knowledge
    if decision.left is None or decision.right is None or decision.level is None:
        return None
    points = _points(case)
    if not points:
        return None
    count = 1 + len(decision.further)
    targets = [tuple(complex(rows[n]) for _, rows in points) for n in range(count)]
    evaluator = knowledge.evaluator(decision.level)
    numeric = NumericFilter(ValuesOfLetters(evaluator, [point for point, _ in points]), len(points))
    for part in formula.walk(case.node):
        if isinstance(part, formula.Derivative):
            try:
                form = evaluator.form(part)
                numeric.set_values(part, tuple(complex(values.value(form, p)) for p, _ in points))
            except (NoFormError, TooLargeError, KeyError):
                return None
    try:
        numeric.store(case.node)
    except NoValueError:
        return None
    return targets, numeric


def letters_of(case: Case) -> list[str]:
    """Return the letters that stand in the side or may be put into it."""
    letters_in_side = dict.fromkeys(sorted(formula.names(case.node)))
    extra = [n for n in sorted(case.knowledge.letters) if n not in letters_in_side][:30]
    return [
        *letters_in_side,
        *extra,
        *[n for n in sorted(case.knowledge.definitions) if n not in letters_in_side and n not in extra][
            :20
        ],
    ]


def _points(case: Case) -> list[tuple[values.Point, list[Any]]]:
    """Return points for all letters, with the values there of the exact side and its later cut-offs."""
    assert case.decision.left is not None
    assert case.decision.level is not None
    meaning, own = case.knowledge.meaning, case.decision.level.values
    behind = {n for name in letters_of(case) for n in names_behind(formula.Name(name), own)}
    # those that have values too: of letters that rest on each other one is taken as it is
    others = {part for n in behind for part in (complex_parts(n) if n in meaning.complex else (n,))}
    return values.sample([case.decision.left, *case.decision.further], others=others)


def fits(node: Formula, numeric: NumericFilter, targets: list[Values]) -> bool:
    """Tell whether a changed side has one of the rows of values it may have."""
    try:
        row = numeric.values(node)
        return any(is_close(row, target) for target in targets) or (
            not any(map(any, targets)) and _cancels(node, row, numeric)
        )
    except NoValueError:
        return False


def _cancels(node: Formula, row: Values, numeric: NumericFilter) -> bool:
    """Tell whether a sum is 0 but for the rounding of its terms."""
    if not isinstance(node, formula.Sum):
        return False
    sizes = [max(map(abs, terms)) for terms in zip(*map(numeric.values, node.terms), strict=True)]
    return all(abs(value) <= CLOSE * size for value, size in zip(row, sizes, strict=True))


# Formulas in complex floats


class NoValueError(Exception):
    """A formula without a value here: a pole, an unknown letter, a derivative."""


class ValuesOfLetters(Mapping[str, Values]):
    """The values of letters at a few points, each found when it is first asked for.

    What a letter stands for is evaluated as it is written; only what has no value so, such as a
    derivative, is brought to its normal form. What has none is 1: proofs decide on what is put in.
    """

    def __init__(self, evaluator: FormEvaluator, points: Sequence[values.Point]) -> None:
        self._evaluator, self._points = evaluator, points
        self._rows: dict[str, Values] = {}
        self._open: set[str] = set()
        self._numeric = NumericFilter(self, len(points))

    def __getitem__(self, name: str) -> Values:
        if name not in self._rows:
            if name in self._open:  # of letters that rest on each other one is taken as it is
                return self._at_points(name)
            self._open.add(name)
            try:
                self._rows[name] = self._row(name)
            finally:
                self._open.remove(name)
        return self._rows[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._rows)

    def __len__(self) -> int:
        return len(self._rows)

    def _row(self, name: str) -> Values:
        meaning = self._evaluator.meaning
        node = meaning.values.get(name)
        try:
            if node is not None:
                return self._numeric.values(node)
        except NoValueError:
            return self._row_of_form(name)
        return self._row_of_form(name) if name in meaning.complex else self._at_points(name)

    def _at_points(self, name: str) -> Values:
        return tuple(complex(point[name]) for point in self._points)

    def _row_of_form(self, name: str) -> Values:
        try:
            form = self._evaluator.letter(name)
            return tuple(complex(values.value(form, point)) for point in self._points)
        except (NoFormError, TooLargeError, KeyError, ZeroDivisionError, ValueError, OverflowError):
            return (complex(1),) * len(self._points)


class NumericFilter:
    """Values of one formula and of its changed copies: parts they share are evaluated once.

    `letters` gives the letters' values, one a point; `known` may give the values of whole parts (of
    derivatives, which are not evaluated here).
    """

    def __init__(self, letters: Mapping[str, Sequence[complex]], points: int) -> None:
        self.letters, self.points = letters, points
        self._values: dict[int, Values] = {}
        self._alive: list[Formula] = []  # values are found by `id`, which must not be used anew

    def store(self, node: Formula) -> Values:
        """Return a formula's values, and keep those of all its parts."""
        for part in formula.children(node):
            try:
                self.store(part)
            except NoValueError:
                continue
        row = self.values(node)
        self.set_values(node, row)
        return row

    def set_values(self, node: Formula, values: Values) -> None:
        """Take the values of a part as they are."""
        self._values[id(node)] = values
        self._alive.append(node)

    def values(self, node: Formula) -> Values:
        """Return a formula's values at the points."""
        row = self._values.get(id(node))
        if row is not None:
            return row
        try:
            return self._evaluate(node)
        except (ZeroDivisionError, OverflowError, ValueError, KeyError) as problem:
            raise NoValueError from problem

    def _evaluate(self, node: Formula) -> Values:
        if isinstance(node, formula.Number):
            return (complex(float(node.value)),) * self.points
        if isinstance(node, formula.Name):
            return tuple(self.letters[node.name])
        if isinstance(node, formula.Constant):
            return (_CONSTANTS[node.name],) * self.points
        rule = _rule(node)
        rows = [self.values(p) for p in formula.children(node) if not isinstance(p, formula.Dots)]
        if not rows:  # dots alone
            raise NoValueError
        return tuple(rule(column) for column in zip(*rows, strict=True))


def _rule(node: Formula) -> Callable[[Sequence[complex]], complex]:
    """Return what a part does with the values of its parts."""
    if isinstance(node, formula.Call):
        function = _FUNCTIONS[node.function]
        return lambda column: function(column[0])
    if type(node) not in _RULES:
        raise NoValueError
    return _RULES[type(node)]


_RULES: dict[type[Formula], Callable[[Sequence[complex]], complex]] = {
    formula.Negative: lambda column: -column[0],
    formula.Quotient: lambda column: column[0] / column[1],
    formula.Power: lambda column: column[0] ** column[1],
    formula.Sum: sum,
    formula.Product: math.prod,
}


def is_close(left: Values, right: Values) -> bool:
    """Tell whether two rows of values agree, all to nine digits."""
    return all(abs(a - b) <= CLOSE * max(abs(a), abs(b), 1e-30) for a, b in zip(left, right, strict=True))
