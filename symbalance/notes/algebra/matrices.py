"""Matrices: letters as a free algebra with transpose and inverse, literal matrices entry by entry.

A value in letters is a sum of words with scalars before them. A word is a row of factors, letters that
are plain, transposed, inverted or have dots. No two factors change places, (AB)ᵗ is BᵗAᵗ, A⁻¹A is nothing
at all. Vectors change with time, matrices do not: the dots of Φa stand on a.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import reduce
from typing import Any

from symbalance.document import formula
from symbalance.document.formula import Formula, Matrix, Name
from symbalance.document.letters import is_greek, plain_letter
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra.conjugation import absolute_value
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.evaluation import FormEvaluator
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.matrix_letters import Kinds
from symbalance.notes.algebra.roots import root

MOST_WORDS = 2000
MOST_STEPS = 30_000
"""Products of two entries: a matrix of 30 rows times another."""
TRANSPOSE_LETTERS = ("T", "t", "top")

Rows = tuple[tuple[Form, ...], ...]


@dataclass(frozen=True, slots=True)
class Factor:
    """A letter of a word, or a literal matrix (`rows`); dots are derivatives by time."""

    name: str
    is_transposed: bool = False
    is_inverted: bool = False
    dots: int = 0


Word = tuple[Factor, ...]


@dataclass(frozen=True)
class Literal:
    """A matrix of forms."""

    rows: Rows

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns."""
        return len(self.rows), len(self.rows[0])


@dataclass(frozen=True)
class Words:
    """A sum of words, each with its scalar."""

    terms: Mapping[Word, Form]


Value = Form | Literal | Words


def sum_name(node: formula.Summation) -> str:
    """Return the letter that stands for a sum of vectors without end: Σ φ_n a_n."""
    return formula_text(node, plain=True)


def has_dots(node: Formula) -> bool:
    """Tell whether a matrix is written with dots, so that it only says what its columns are."""
    return any(isinstance(part, formula.Dots) for part in formula.walk(node))


class MatrixEvaluator:
    """Turns formulas of matrices into values; scalars go to an evaluator of forms."""

    def __init__(self, evaluator: FormEvaluator, kinds: Kinds) -> None:
        self.evaluator, self.kinds = evaluator, kinds
        self.domain = evaluator.domain
        self.steps = 0
        self._open: list[str] = []
        self._rules: dict[type, Callable[[Any], Value]] = {
            Name: lambda node: self._name(node.name),
            formula.Sum: lambda node: self._sum(map(self.value, node.terms)),
            formula.Product: self._product,
            formula.Negative: lambda node: self.scaled(self.value(node.operand), self.number(-1)),
            formula.Quotient: lambda node: self._quotient(*map(self.value, formula.children(node))),
            formula.Power: self._power,
            formula.Derivative: self._derivative,
            formula.Summation: self._summation,
            formula.Apply: self._apply,
            formula.Call: self._call,
            Matrix: self._literal,
        }

    def value(self, node: Formula) -> Value:
        """Return the value of a formula; what is no matrix is a form."""
        rule = self._rules.get(type(node))
        return self._scalar(node) if rule is None else rule(node)

    def _scalar(self, node: Formula) -> Form:
        """Return the form of a formula without matrices; a function of one has none here."""
        if holds_matrices(node, self.kinds):
            raise NoFormError("a function of a matrix")
        return self.evaluator.form(node)

    def _product(self, node: formula.Product) -> Value:
        total = self.value(node.factors[0])
        for factor in node.factors[1:]:
            total = self.times(total, self.value(factor))
        return total

    def _apply(self, node: formula.Apply) -> Value:
        if node.function == "transpose":
            return self.transposed(self.value(node.arguments[0]))
        if node.function == "det":
            if not holds_matrices(node.arguments[0], self.kinds):
                raise NoFormError("the determinant of what is not said to be a matrix")
            return self.determinant(self.value(node.arguments[0]))
        letter = node.arguments[0]
        if node.function == "at" and isinstance(letter, Name) and letter.name in self.kinds.letters:
            return self.value(self._at_angle(letter.name, node.arguments[1]))
        return self._scalar(node)

    def _call(self, node: formula.Call) -> Value:
        """Return the length of a vector whose entries are known; other functions are of no matrix."""
        if node.function != "abs" or not holds_matrices(node.argument, self.kinds):
            return self._scalar(node)
        value = self.value(node.argument)
        if isinstance(value, Form):
            return absolute_value(value)
        if not isinstance(value, Literal) or min(value.shape) > 1 or max(value.shape) < 2:
            raise NoFormError("a function of a matrix")
        sizes = [absolute_value(entry) for row in value.rows for entry in row]
        return root(reduce(Form.plus, (size.times(size) for size in sizes)))

    def _at_angle(self, name: str, place: Formula) -> Formula:
        """Return R(β) for R(α) = …: the entries with β for the one angle in them."""
        entries = self.evaluator.meaning.values.get(name)
        angles = [letter for letter in formula.names(entries) if is_greek(letter)] if entries else []
        if entries is None or len(angles) != 1:
            raise NoFormError(f"{plain_letter(name)}( ), a matrix that is not given as one of an angle")
        return _with_angle(entries, angles[0], place)

    def number(self, value: int | Fraction) -> Form:
        """Return a rational as a form."""
        return Form.number(self.domain, value)

    def _name(self, name: str) -> Value:
        node = self.evaluator.meaning.values.get(name)
        if name in self.kinds.identities:
            return Words({(): self.number(1)})
        if name not in self.kinds.letters:
            return self.evaluator.letter(name)
        if node is None or name in self._open or has_dots(node):
            return Words({(Factor(name),): self.number(1)})
        self._open.append(name)
        value = self.value(node)
        self._open.pop()
        return value

    def _summation(self, node: formula.Summation) -> Value:
        """Return a sum of vectors: what it was set equal to, or a vector of its own."""
        if not any(name in self.kinds.letters for name in formula.names(node.body)):
            return self._scalar(node)
        name = sum_name(node)
        known = self.evaluator.meaning.values.get(name)
        return self.value(known) if known is not None else Words({(Factor(name),): self.number(1)})

    def _literal(self, node: Matrix) -> Value:
        if has_dots(node):
            return Words({(Factor(formula_text(node, plain=True)),): self.number(1)})
        rows = tuple(tuple(map(self._entry, row)) for row in node.rows)
        return Literal(rows)

    def _entry(self, node: Formula) -> Form:
        entry = self.value(node)
        if not isinstance(entry, Form):
            raise NoFormError("a matrix within a matrix")
        return entry

    # Sums and products

    def _sum(self, values: Iterable[Value]) -> Value:
        total: Value | None = None
        for value in values:
            total = value if total is None else self.plus(total, value)
        return self.number(0) if total is None else total

    def plus(self, left: Value, right: Value) -> Value:
        """Return the sum; the number 0 is the zero of every size, no other number is added."""
        if isinstance(left, Form) and isinstance(right, Form):
            return left.plus(right)
        for one, other in ((left, right), (right, left)):
            if isinstance(one, Form):
                if one.is_zero() is True:
                    return other
                raise NoFormError("a number added to a matrix")
        if isinstance(left, Literal) and isinstance(right, Literal):
            if left.shape != right.shape:
                raise NoFormError(f"the sum of matrices of {_shape(left)} and {_shape(right)}")
            self.count(left.shape[0] * left.shape[1])
            pairs = zip(left.rows, right.rows, strict=True)
            return Literal(
                tuple(tuple(a.plus(b) for a, b in zip(one, two, strict=True)) for one, two in pairs)
            )
        if isinstance(left, Words) and isinstance(right, Words):
            terms = dict(left.terms)
            for word, scalar in right.terms.items():
                terms[word] = terms[word].plus(scalar) if word in terms else scalar
            return self._words(terms)
        raise NoFormError("a literal matrix added to one of letters")

    def _words(self, terms: dict[Word, Form]) -> Words:
        if len(terms) > MOST_WORDS:
            raise TooLargeError("products of very many matrices")
        return Words({word: scalar for word, scalar in terms.items() if scalar.is_zero() is not True})

    def scaled(self, value: Value, scalar: Form) -> Value:
        """Return a value times a number."""
        if isinstance(value, Form):
            return value.times(scalar)
        if isinstance(value, Literal):
            self.count(value.shape[0] * value.shape[1])
            return Literal(tuple(tuple(entry.times(scalar) for entry in row) for row in value.rows))
        return self._words({word: part.times(scalar) for word, part in value.terms.items()})

    def times(self, left: Value, right: Value) -> Value:
        """Return the product, the left factor first."""
        if isinstance(left, Form):
            return self.scaled(right, left)
        if isinstance(right, Form):
            return self.scaled(left, right)
        if isinstance(left, Literal) and isinstance(right, Literal):
            return self._product_of_literals(left, right)
        if isinstance(left, Words) and isinstance(right, Words):
            terms: dict[Word, Form] = {}
            self.count(len(left.terms) * len(right.terms))
            for first, a in left.terms.items():
                for second, b in right.terms.items():
                    word = self._joined(first, second)
                    scalar = a.times(b)
                    terms[word] = terms[word].plus(scalar) if word in terms else scalar
            return self._words(terms)
        raise NoFormError("a literal matrix times one of letters")

    def _product_of_literals(self, left: Literal, right: Literal) -> Value:
        (rows, inner), (height, columns) = left.shape, right.shape
        if inner != height:
            raise NoFormError(f"the product of matrices of {_shape(left)} and {_shape(right)}")
        self.count(rows * inner * columns)
        turned = list(zip(*right.rows, strict=True))
        entries = tuple(tuple(self._dot(row, column) for column in turned) for row in left.rows)
        return entries[0][0] if rows == columns == 1 and inner > 1 else Literal(entries)

    def _dot(self, row: tuple[Form, ...], column: tuple[Form, ...]) -> Form:
        total = self.number(0)
        for a, b in zip(row, column, strict=True):
            if a.numerator and b.numerator:
                total = total.plus(a.times(b))
        return total

    def count(self, steps: int) -> None:
        """Count operations on entries; too many raise TooLargeError."""
        self.steps += steps
        if self.steps > MOST_STEPS:
            raise TooLargeError("matrices with very many entries")

    def _joined(self, first: Word, second: Word) -> Word:
        """Return two words as one, A⁻¹A and AA⁻¹ left out; a number vᵗMw in one of its two spellings."""
        word = list(first)
        for factor in second:
            if word and word[-1] == replace(factor, is_inverted=not factor.is_inverted):
                word.pop()
            else:
                word.append(factor)
        joined = tuple(word)
        if len(joined) < 2:
            return joined
        vectors, head, tail = self.kinds.vectors, word[0], word[-1]
        ends = head.name in vectors and tail.name in vectors
        is_number = ends and head.is_transposed and not tail.is_transposed
        return min(joined, self._mirrored(joined), key=repr) if is_number else joined

    # Transpose, inverse, powers, determinants

    def _mirrored(self, word: Word) -> Word:
        return tuple(self._turned(factor) for factor in reversed(word))

    def _turned(self, factor: Factor) -> Factor:
        if factor.name in self.kinds.symmetric:
            return factor
        return replace(factor, is_transposed=not factor.is_transposed)

    def transposed(self, value: Value) -> Value:
        """Return the transpose."""
        if isinstance(value, Form):
            return value
        if isinstance(value, Literal):
            return Literal(tuple(zip(*value.rows, strict=True)))
        return self._words({self._mirrored(word): scalar for word, scalar in value.terms.items()})

    def inverted(self, value: Value) -> Value:
        """Return the inverse: of one word factor by factor, of a literal matrix by elimination."""
        if isinstance(value, Form):
            return self.number(1).over(value)
        if isinstance(value, Literal):
            return self._inverse_of_literal(value)
        if len(value.terms) != 1:
            raise NoFormError("the inverse of a sum of matrices")
        ((word, scalar),) = value.terms.items()
        if any(factor.name not in self.kinds.matrices for factor in word):
            raise NoFormError("the inverse of a vector")
        turned = tuple(replace(f, is_inverted=not f.is_inverted) for f in reversed(word))
        return Words({turned: self.number(1).over(scalar)})

    def _power(self, node: formula.Power) -> Value:
        base = self.value(node.base)
        if isinstance(base, Form):
            return self._power_of_number(node, base)
        exponent = node.exponent
        if isinstance(exponent, Name) and exponent.name in TRANSPOSE_LETTERS:
            return self.transposed(base)
        power = self.evaluator.form(exponent).rational()
        if power is None or power.denominator != 1 or abs(power) > 40:
            raise NoFormError("a power of a matrix that is no whole number")
        if power < 0:
            base, power = self.inverted(base), -power
        total: Value = base
        for _ in range(int(power) - 1):
            total = self.times(total, base)
        return total if power else self.number(1)

    def _power_of_number(self, node: formula.Power, base: Form) -> Form:
        """Return a power of a scalar, of a determinant or of vᵗw a whole one."""
        if not holds_matrices(node, self.kinds):
            return self.evaluator.form(node)
        exponent = self._scalar(node.exponent).rational()
        if exponent is None or exponent.denominator != 1:
            raise NoFormError("a power of a determinant that is no whole number")
        return base.raised(int(exponent))

    def _quotient(self, above: Value, below: Value) -> Value:
        if not isinstance(below, Form):
            raise NoFormError("a division by a matrix")
        return self.scaled(above, self.number(1).over(below))

    def _eliminated(self, literal: Literal, beside: list[list[Form]]) -> tuple[list[list[Form]], Form]:
        """Return what elimination makes of the columns beside a square matrix, and its determinant."""
        size, columns = literal.shape
        if size != columns:
            raise NoFormError(f"the determinant or inverse of a matrix of {_shape(literal)}")
        rows = [[*row, *more] for row, more in zip(literal.rows, beside, strict=True)]
        determinant = self.number(1)
        for k in range(size):
            pivot = next((i for i in range(k, size) if rows[i][k].is_zero() is False), None)
            if pivot is None:
                return [row[size:] for row in rows], self.number(0)
            if pivot != k:
                rows[k], rows[pivot] = rows[pivot], rows[k]
                determinant = determinant.scaled(-1)
            lead = rows[k][k]
            determinant = determinant.times(lead)
            rows[k] = [entry.over(lead) for entry in rows[k]]
            for i in range(size):
                factor = rows[i][k]
                if i != k and factor.numerator:
                    self.count(len(rows[k]))
                    rows[i] = [
                        a.minus(factor.times(b)) if b.numerator else a
                        for a, b in zip(rows[i], rows[k], strict=True)
                    ]
        return [row[size:] for row in rows], determinant

    def _inverse_of_literal(self, literal: Literal) -> Literal:
        size = literal.shape[0]
        unit = [[self.number(i == k) for k in range(size)] for i in range(size)]
        inverse, determinant = self._eliminated(literal, unit)
        if determinant.is_zero() is not False:
            raise NoFormError("the inverse of a matrix whose determinant is 0")
        return Literal(tuple(map(tuple, inverse)))

    def determinant(self, value: Value) -> Form:
        """Return the determinant: of letters the product of theirs, det Aᵗ being det A."""
        if isinstance(value, Form):
            return value
        if isinstance(value, Literal):
            return self._eliminated(value, [[] for _ in value.rows])[1]
        if len(value.terms) != 1:
            raise NoFormError("the determinant of a sum of matrices")
        ((word, scalar),) = value.terms.items()
        if not scalar.equals(self.number(1)):
            raise NoFormError("the determinant of a multiple of a matrix of unknown size")
        total = self.number(1)
        for factor in word:
            if factor.name not in self.kinds.matrices or factor.dots:
                raise NoFormError("the determinant of a vector")
            letter = Form.letter(self.domain, f"det {factor.name}")
            total = total.over(letter) if factor.is_inverted else total.times(letter)
        return total

    # Derivatives

    def _derivative(self, node: formula.Derivative) -> Value:
        inner = self.value(node.expression)
        if isinstance(inner, Form):
            return self._scalar(node)
        if node.variable.name != "t" or isinstance(inner, Literal):
            raise NoFormError("a derivative of a matrix")
        for _ in range(node.order):
            inner = self._dotted(inner)
        return inner

    def _dotted(self, value: Words) -> Words:
        terms: dict[Word, Form] = {}
        for word, scalar in value.terms.items():
            for place, factor in enumerate(word):
                if factor.name in self.kinds.matrices:
                    continue
                moved = (*word[:place], replace(factor, dots=factor.dots + 1), *word[place + 1 :])
                terms[moved] = terms[moved].plus(scalar) if moved in terms else scalar
        return self._words(terms)


def _with_angle(node: Formula, angle: str, place: Formula) -> Formula:
    """Return a formula with one angle put in for another."""
    if isinstance(node, Name):
        return place if node.name == angle else node
    if isinstance(node, formula.Derivative | formula.Integral | formula.Summation):
        raise NoFormError("a matrix at a place, with a derivative or sum in it")
    parts = formula.children(node)
    return (
        formula.with_children(node, tuple(_with_angle(p, angle, place) for p in parts)) if parts else node
    )


def _shape(literal: Literal) -> str:
    return "{} × {}".format(*literal.shape)


def holds_matrices(node: Formula, kinds: Kinds) -> bool:
    """Tell whether a formula holds a matrix: a letter that is one, or rows of entries."""
    matrix_letters = kinds.letters | kinds.identities
    return not matrix_letters.isdisjoint(formula.names(node)) or any(
        isinstance(part, Matrix) or part.function in ("det", "transpose")
        for part in formula.parts_of_kind(node, Matrix, formula.Apply)
    )
