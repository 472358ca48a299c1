"""Values of formulas of vectors and matrices, in numbers drawn at random for their letters.

Their products do not commute, a vector times a vector is a number, and nothing is divided by either: what
is true of numbers may fail here. A vector is a column of numbers, a number is a float.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Mapping
from functools import reduce
from typing import Any

from symbalance.document.formula import (
    Apply,
    Call,
    Constant,
    Derivative,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
)
from symbalance.document.text_writer import formula_text

SIZE = 4
"""Rows of the vectors and matrices: more than of any relation that holds in a plane only."""
VECTOR, MATRIX = "vector", "matrix"
Rows = list[list[float]]
Value = float | Rows
_LARGEST = 9
"""Of the whole numbers that are drawn."""
_TERMS = 200
"""Of the series of an exponential, whose terms are all positive here."""
_MOST_TIMES = 12
_CONSTANTS = {"pi": math.pi, "e": math.e}
_FUNCTIONS: dict[str, Callable[[float], float]] = {
    "sin": math.sin, "cos": math.cos, "tan": math.tan, "sqrt": math.sqrt, "abs": abs, "exp": math.exp,
    "ln": math.log, "acos": math.acos, "asin": math.asin, "atan": math.atan,
}  # fmt: skip


class MisfitError(Exception):
    """A product, sum or quotient that vectors and matrices do not have."""


class NoArrayError(Exception):
    """A formula of a kind whose value is not known here."""


class ArrayValues:
    """The values of formulas at one point; `is_array` tells which letters are set as vectors or matrices.

    With `of_one_direction` all vectors are positive multiples of one.
    """

    def __init__(
        self,
        kinds: Mapping[str, str],
        values: Mapping[str, Formula],
        is_array: Callable[[Name], bool],
        seed: int,
        *,
        of_one_direction: bool = False,
    ) -> None:
        self.kinds, self.values, self.is_array = kinds, values, is_array
        self._chance = random.Random(f"arrays {seed}")
        self._drawn: dict[tuple[str, bool], Value] = {}
        self._direction = [self._number() for _ in range(SIZE)] if of_one_direction else []
        self._open: set[tuple[str, bool]] = set()

    def value(self, node: Formula) -> Value:
        """Return a formula's value; what has none raises MisfitError, what is not known NoArrayError."""
        try:
            return self._value(node)
        except (ZeroDivisionError, ValueError, OverflowError, RecursionError):
            raise NoArrayError from None

    def _value(self, node: Formula) -> Value:
        rule = _RULES.get(type(node))
        if rule is None:
            raise NoArrayError
        return rule(self, node)

    def array(self, name: str) -> Value:
        """Return the value of a letter that is set as a vector or a matrix."""
        key = (name, True)
        if key in self._drawn or key in self._open or name not in self.values:
            return self._random(key, self.kinds.get(name, VECTOR))
        self._open.add(key)
        try:
            known = self._value(self.values[name])
        except (MisfitError, NoArrayError):
            known = 0.0
        finally:
            self._open.discard(key)
        return known if isinstance(known, list) else self._random(key, self.kinds.get(name, VECTOR))

    def printed(self) -> dict[str, str]:
        """Return the letters with what was drawn for them, as a witness names them."""
        return {name: _printed(value) for (name, _), value in self._drawn.items()}

    def letter(self, node: Name) -> Value:
        """Return a letter's value: by its definition where that is of its kind, else a random one."""
        if self.is_array(node):
            return self.array(node.name)
        key = (node.name, False)
        if key not in self._drawn and key not in self._open and node.name in self.values:
            self._open.add(key)
            try:
                known = self._value(self.values[node.name])
                if not isinstance(known, list):
                    return known
            except (MisfitError, NoArrayError):
                pass
            finally:
                self._open.discard(key)
        for own in (node.name, f"vec_{node.name}"):  # the same letter set plainly is its length
            if self.kinds.get(own) == VECTOR:
                return _length(self.array(own))
        return self._random(key, "")

    def _random(self, key: tuple[str, bool], kind: str) -> Value:
        if key not in self._drawn:
            columns = {VECTOR: 1, MATRIX: SIZE}.get(kind, 0)
            rows = [[self._number() for _ in range(columns)] for _ in range(SIZE)]
            if self._direction and kind == VECTOR:
                size = self._number()
                rows = [[size * entry] for entry in self._direction]
            self._drawn[key] = rows if columns else self._number()
        return self._drawn[key]

    def _number(self) -> float:
        return float(self._chance.randint(1, _LARGEST))

    def derivative(self, node: Derivative) -> Value:
        """Return the value of a letter with dots, as one of a letter of its own."""
        if not isinstance(node.expression, Name):
            raise NoArrayError
        is_array = self.is_array(node.expression)
        kind = self.kinds.get(node.expression.name, "") if is_array else ""
        return self._random((formula_text(node, plain=True), is_array), kind)


def _constant(node: Constant) -> Value:
    if node.name not in _CONSTANTS:
        raise NoArrayError
    return _CONSTANTS[node.name]


def _quotient(above: Value, below: Value) -> Value:
    if isinstance(below, list):
        raise MisfitError
    return _times(1 / below, above)


def _power(base: Value, exponent: Value) -> Value:
    if isinstance(exponent, list):
        if base == math.e:
            return _exponential(exponent)
        raise NoArrayError
    if not isinstance(base, list):
        power = base**exponent
        if isinstance(power, complex):
            raise NoArrayError
        return power
    count = round(exponent)
    if not count or count != exponent or abs(count) > _MOST_TIMES:
        raise NoArrayError
    return reduce(_times, [base if count > 0 else inverse(base)] * abs(count))


def _function(name: str, value: Value) -> Value:
    if not isinstance(value, list):
        if name not in _FUNCTIONS:
            raise NoArrayError
        return _FUNCTIONS[name](value)
    if name == "abs" and len(value[0]) == 1:
        return _length(value)
    if name == "exp":
        return _exponential(value)
    raise NoArrayError


def _applied(name: str, value: Value) -> Value:
    if name != "transpose":
        raise NoArrayError
    return transposed(value)


_RULES: dict[type[Formula], Callable[[ArrayValues, Any], Value]] = {
    Number: lambda at, node: float(node.value),
    Constant: lambda at, node: _constant(node),
    Name: lambda at, node: at.letter(node),
    Derivative: lambda at, node: at.derivative(node),
    Sum: lambda at, node: _total([at.value(term) for term in node.terms]),
    Product: lambda at, node: reduce(_times, map(at.value, node.factors)),
    Negative: lambda at, node: _times(-1.0, at.value(node.operand)),
    Quotient: lambda at, node: _quotient(at.value(node.numerator), at.value(node.denominator)),
    Power: lambda at, node: _power(at.value(node.base), at.value(node.exponent)),
    Call: lambda at, node: _function(node.function, at.value(node.argument)),
    Apply: lambda at, node: _applied(node.function, at.value(node.arguments[0])),
}


def is_close(first: Value, second: Value) -> bool | None:
    """Tell whether two values are the same but for rounding; None if of other kinds, and not 0."""
    if isinstance(first, list) != isinstance(second, list):
        array, number = (first, second) if isinstance(first, list) else (second, first)
        if number != 0 or not isinstance(array, list):
            return None
        second = [[0.0 for _ in row] for row in array]
        first = array
    if isinstance(first, list) and isinstance(second, list):
        if _shape(first) != _shape(second):
            return None
        pairs = list(zip(entries(first), entries(second), strict=True))
    else:
        assert not isinstance(first, list)
        assert not isinstance(second, list)
        pairs = [(first, second)]
    scale = max(max(abs(a), abs(b)) for a, b in pairs)
    return all(abs(a - b) <= scale * 1e-8 for a, b in pairs)


def entries(value: Value) -> list[float]:
    """Return the numbers of a value, row by row."""
    return [entry for row in value for entry in row] if isinstance(value, list) else [value]


def gap(first: Value, second: Value) -> Value:
    """Return the difference of two values."""
    return _total([first, _times(-1.0, second)])


def times(first: Value, second: Value) -> Value:
    """Return the product, the left factor first."""
    return _times(first, second)


def transposed(value: Value) -> Value:
    """Return a value with rows for columns."""
    return [list(column) for column in zip(*value, strict=True)] if isinstance(value, list) else value


def inverse(rows: Rows) -> Rows:
    """Return the inverse of a matrix."""
    size = len(rows)
    if size != len(rows[0]):
        raise MisfitError
    work = [[*row, *(float(i == k) for k in range(size))] for i, row in enumerate(rows)]
    for i in range(size):
        pivot = max(range(i, size), key=lambda r: abs(work[r][i]))
        if abs(work[pivot][i]) < 1e-9:
            raise NoArrayError
        work[i], work[pivot] = work[pivot], work[i]
        work[i] = [entry / work[i][i] for entry in work[i]]
        for k in range(size):
            if k != i:
                work[k] = [a - work[k][i] * b for a, b in zip(work[k], work[i], strict=True)]
    return [row[size:] for row in work]


def _shape(rows: Rows) -> tuple[int, int]:
    return len(rows), len(rows[0])


def _total(values: list[Value]) -> Value:
    arrays = [value for value in values if isinstance(value, list)]
    if not arrays:
        return math.fsum(value for value in values if not isinstance(value, list))
    if any(not isinstance(value, list) and value != 0 for value in values):
        is_matrix = any(len(one[0]) > 1 for one in arrays)
        raise MisfitError if is_matrix else NoArrayError  # a number for a vector: its size is meant
    if any(_shape(one) != _shape(arrays[0]) for one in arrays):
        raise MisfitError
    return [[math.fsum(parts) for parts in zip(*rows, strict=True)] for rows in zip(*arrays, strict=True)]


def _times(first: Value, second: Value) -> Value:
    if not isinstance(first, list):
        if not isinstance(second, list):
            return first * second
        return [[first * entry for entry in row] for row in second]
    if not isinstance(second, list):
        return _times(second, first)
    if _shape(first) == _shape(second) and len(first[0]) == 1:
        return math.fsum(a[0] * b[0] for a, b in zip(first, second, strict=True))
    if len(first[0]) != len(second):
        raise MisfitError
    columns = list(zip(*second, strict=True))
    rows = [
        [math.fsum(a * b for a, b in zip(row, column, strict=True)) for column in columns]
        for row in first
    ]
    return rows[0][0] if _shape(rows) == (1, 1) else rows


def _length(value: Value) -> float:
    if not isinstance(value, list):
        return abs(value)
    return math.sqrt(math.fsum(entry * entry for row in value for entry in row))


def _exponential(rows: Rows) -> Rows:
    size = len(rows)
    if size != len(rows[0]):
        raise MisfitError
    term: Rows = [[float(i == k) for k in range(size)] for i in range(size)]
    total = [row[:] for row in term]
    for count in range(1, _TERMS):
        product = _times(_times(1 / count, term), rows)
        assert isinstance(product, list)
        term = product
        total = [[a + b for a, b in zip(*pair, strict=True)] for pair in zip(total, term, strict=True)]
    return total


def _printed(value: Value) -> str:
    if not isinstance(value, list):
        return f"{value:g}"
    return f"[{'; '.join(', '.join(f'{entry:g}' for entry in row) for row in value)}]"
