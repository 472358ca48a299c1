"""Numerical values of formulas straight from their trees, where a normal form is missing or too large."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

from symbalance.document import formula
from symbalance.document.formula import Formula
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.evaluation import FormEvaluator, SymbolValue, complex_parts
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.letters_behind import letters_behind, names_behind
from symbalance.notes.algebra.open_sums import NOT_CONTINUED, goes_on_within
from symbalance.notes.algebra.sums import indexed_letters
from symbalance.notes.algebra.tree_constructs import CONSTRUCTS
from symbalance.notes.algebra.values import (
    DIGITS,
    Point,
    Valuation,
    context,
    power_of_ten,
    random_point,
)

DEEPEST = 40
"""Definitions that use definitions, one in the other."""
MOST_TERMS = 2000
"""Of all sums of one formula together, nested ones too."""


NO_VALUE = (
    NoFormError, TooLargeError, ZeroDivisionError, ValueError, KeyError, OverflowError, TypeError,
)  # fmt: skip
"""What is raised where a formula has no value at a point: a pole, a letter without a number."""


def sample_trees(
    nodes: list[Formula], meaning: SymbolValue, count: int = 3, tries: int = 24
) -> list[tuple[Point, list[Any]]]:
    """Return up to three points where all formulas are real, with their values to `DIGITS` digits."""
    names = sorted({name for node in nodes for name in letters_behind(node, meaning.values)})
    names = sorted({part for n in names for part in (complex_parts(n) if n in meaning.complex else (n,))})
    samples: list[tuple[Point, list[Any]]] = []
    derivatives: DerivativeForms = {}
    for seed in range(tries):
        point = random_point(names, meaning.domain(), seed)
        at = TreeValues(meaning, point, derivatives)
        try:
            row = [at.value(node) for node in nodes]
        except NO_VALUE:
            continue
        if all(abs(v.imag) <= abs(v) * power_of_ten(context(), -DIGITS // 2) for v in row):
            samples.append((point, row))
        if len(samples) == count:
            break
    return samples


DerivativeForms = dict[Formula, Form | NoFormError | TooLargeError]
"""The forms of derivatives, or why there is none: the same at every point."""


class TreeValues:
    """The values of formulas at one point."""

    def __init__(
        self, meaning: SymbolValue, point: Point, derivatives: DerivativeForms | None = None
    ) -> None:
        self.meaning, self.point, self.mp = meaning, point, context()
        self._numbers = (self.mp.mpf, self.mp.mpc)
        self.derivatives: DerivativeForms = {} if derivatives is None else derivatives
        self._derivative_values: dict[Formula, Any] = {}
        self._values: dict[str, Any] = {}
        self._outer: TreeValues | None = None
        self._rebound: frozenset[str] = frozenset()
        self._stays: dict[str, bool] = {}
        self._stays_without: dict[frozenset[str], dict[str, bool]] = {}
        self._depth = 0
        self.terms = 0
        self.bound: frozenset[str] = frozenset()
        """Letters that a construct binds: their number is the point's, whatever they stand for."""

    def with_letter(self, name: str, number: Any) -> TreeValues:
        """Return the values with a letter bound to a number."""
        inner = TreeValues(self.meaning, self.point, self.derivatives)
        inner._derivative_values = self._derivative_values  # by way of the point, which is the same
        inner.bound = self.bound | {name}
        inner._values = {n: v for n, v in self._values.items() if n in self.bound} | {name: number}
        inner.terms, inner._depth = self.terms, self._depth
        for moving, rate in self.meaning.rates.get(name, {}).items():
            inner.bound |= {moving}
            inner._values[moving] = self.value(rate) * number
        inner._outer, inner._rebound = self, frozenset({name, *self.meaning.rates.get(name, {})})
        inner._stays = self._stays_without.setdefault(inner._rebound, {})
        return inner

    def value(self, node: Formula) -> Any:
        """Return a formula's value; what has none raises NoFormError or ZeroDivisionError."""
        number = _RULES[type(node)](self, node)
        return number if type(number) in self._numbers else self.mp.mpc(number)

    def letter(self, name: str) -> Any:
        """Return a letter's value."""
        if name not in self._values:
            if name in self.meaning.complex and name not in self.meaning.values:
                real, imaginary = map(self.letter, complex_parts(name))
                self._values[name] = real + 1j * imaginary
            elif name in self.meaning.values and name not in self.bound:
                self._values[name] = self._defined(name)
            else:
                exact = self.point[name]
                self._values[name] = self.mp.mpf(exact.numerator) / exact.denominator
        return self._values[name]

    def _defined(self, name: str) -> Any:
        """Return the value of a letter that stands for a formula."""
        if self._outer is not None and self._stays_outside(name):
            terms = self._outer.terms
            value = self._outer.letter(name)
            self._outer.terms = terms
            return value
        self._depth += 1
        if self._depth > DEEPEST:
            raise NoFormError("definitions nested too deep")
        value = self.value(self.meaning.values[name])
        self._depth -= 1
        return value

    def _stays_outside(self, name: str) -> bool:
        """Tell whether a letter does not rest on those bound here: at all points its value is one."""
        if name not in self._stays:
            behind = names_behind(formula.Name(name), self.meaning.values)
            self._stays[name] = self._rebound.isdisjoint(behind)
        return self._stays[name]

    def derivative(self, node: Formula) -> Any:
        """Return the value of a derivative, by way of its form."""
        if node not in self._derivative_values:
            form = self._derivative_form(node)
            self._derivative_values[node] = Valuation(form.domain, self.point).of(form)
        return self._derivative_values[node]

    def _derivative_form(self, node: Formula) -> Form:
        if node not in self.derivatives:
            evaluator = FormEvaluator(self.meaning.domain(), self.meaning)
            try:
                self.derivatives[node] = evaluator.form(node)
            except (NoFormError, TooLargeError) as problem:
                self.derivatives[node] = problem
        form = self.derivatives[node]
        if isinstance(form, Exception):
            raise form
        return form


def _number(at: TreeValues, node: formula.Number) -> Any:
    return at.mp.mpf(node.value.numerator) / node.value.denominator


def _constant(at: TreeValues, node: formula.Constant) -> Any:
    if node.name == "infinity":
        raise NoFormError("infinity")
    return 1j if node.name == "i" else +getattr(at.mp, node.name)


def _sum(at: TreeValues, node: formula.Sum) -> Any:
    if goes_on_within(node):
        raise NoFormError(NOT_CONTINUED)
    terms = [t for t in node.terms if not isinstance(t, formula.Dots)]
    return at.mp.fsum(at.value(t) for t in terms or node.terms)  # of dots alone: not the number 0


def _product(at: TreeValues, node: formula.Product) -> Any:
    total = at.mp.one
    for factor in node.factors:
        total = total * at.value(factor)
    return total


def _power(at: TreeValues, node: formula.Power) -> Any:
    exponent = at.value(node.exponent)
    if abs(exponent) > 10_000:
        raise NoFormError("a power beyond all bounds")
    whole = exponent.real == int(exponent.real) and not exponent.imag
    return at.value(node.base) ** (int(exponent.real) if whole else exponent)


def _call(at: TreeValues, node: formula.Call) -> Any:
    argument, mp = at.value(node.argument), at.mp
    if node.function in ("conj", "re", "im", "arg"):
        _refuse_unknown_parts(at, node)
    if node.function not in _OF_ANY_SIZE and abs(argument) > 10**9:
        raise NoFormError("a function of a huge number")
    if node.function == "arg" and set(names_behind(node.argument, at.meaning.values)) - {
        *at.meaning.values
    }:
        raise NoFormError("the angle of a complex number with letters in it")  # of which half-plane?
    if node.function == "abs":
        return abs(argument)
    return getattr(mp, {"ln": "log", "lg": "log10"}.get(node.function, node.function))(argument)


_OF_ANY_SIZE = frozenset({"sqrt", "abs", "ln", "log", "lg", "re", "im", "conj", "arg"})
"""Functions whose value is as exact as a huge argument is: √(σ² + 4 τ²) of stresses in pascals."""


def _refuse_unknown_parts(at: TreeValues, node: formula.Call) -> None:
    inner = node.argument
    known = {*at.meaning.values, *at.meaning.complex}
    if isinstance(inner, formula.Name) and inner.name not in known:
        raise NoFormError(f"{inner.name}, of which nothing says that it is complex; declare it so")


def _summation(at: TreeValues, node: formula.Summation) -> Any:
    if node.index is None or node.lower is None or node.upper is None:
        raise NoFormError("a sum without bounds")
    lower, upper = (int(at.value(bound).real) for bound in (node.lower, node.upper))
    if indexed_letters(node.body, node.index.name):
        raise NoFormError("a sum of letters that carry its index")
    at.terms += max(upper - lower, 0)
    if at.terms > MOST_TERMS:
        raise NoFormError("a long sum")
    total = at.mp.mpc(0)
    for k in range(lower, upper + 1):
        inner = TreeValues(at.meaning, {**at.point, node.index.name: Fraction(k)}, at.derivatives)
        inner.terms = at.terms
        total += inner.value(node.body)
        at.terms = inner.terms
    return total


def _dots(at: TreeValues, node: formula.Dots) -> Any:
    raise NoFormError("dots")


_RULES: dict[type, Callable[[TreeValues, Any], Any]] = {
    formula.Number: _number,
    formula.Name: lambda at, node: at.letter(node.name),
    formula.Constant: _constant,
    formula.Sum: _sum,
    formula.Product: _product,
    formula.Quotient: lambda at, node: at.value(node.numerator) / at.value(node.denominator),
    formula.Negative: lambda at, node: -at.value(node.operand),
    formula.Power: _power,
    formula.Call: _call,
    formula.Derivative: lambda at, node: at.derivative(node),
    formula.Summation: _summation,
    formula.Dots: _dots,
    **CONSTRUCTS,
}
