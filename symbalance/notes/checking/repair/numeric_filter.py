"""A quick filter for changed formulas by their values in floats at a few points, before any proof."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from symbalance.document import formula
from symbalance.document.formula import Formula
from symbalance.notes.algebra import values
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.forms import Form
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
    letters = {
        name: [complex(row[k]) for _, row in points] for k, name in enumerate(letters_of(case), count)
    }
    numeric = NumericFilter(letters, len(points))
    evaluator = knowledge.evaluator(decision.level)
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
    """Return points with the values there of the exact side, its later cut-offs, and the letters."""
    assert case.decision.left is not None
    assert case.decision.level is not None
    evaluator = case.knowledge.evaluator(case.decision.level)
    evaluator.domain = case.decision.left.domain
    forms: list[Form] = [case.decision.left, *case.decision.further]
    for name in letters_of(case):
        try:
            forms.append(evaluator.letter(name))
        except (NoFormError, TooLargeError):
            forms.append(Form.number(case.decision.left.domain, 1))
    samples = values.sample(forms)
    if samples:
        return samples
    count = 1 + len(case.decision.further)  # some letter has no value: leave it out
    unit = Form.number(case.decision.left.domain, 1)
    alone = [f if values.sample([f], 1) else unit for f in forms[count:]]
    samples = values.sample([*forms[:count], *alone])
    if samples:
        return samples
    usable = [f if values.sample([case.decision.left, f], 1) else unit for f in forms[count:]]
    return values.sample([*forms[:count], *usable])


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
