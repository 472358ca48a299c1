"""Formula trees: parsed from hand notes, derived step by step, and printed in every format.

Every node is frozen and compares by what it says; where it stands in a document (`span`) does not count.
Nothing is evaluated, ordered or simplified: `2/4` stays a quotient of 2 and 4, so that a derivation shows
the very steps a person would take. Python's operators build larger formulas from smaller ones.

>>> theta, r = Name("theta"), Name("r")
>>> r * (1 - cos(theta)) == Product((r, Sum((number(1), Negative(Call("cos", theta))))))
True
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from fractions import Fraction
from operator import attrgetter, is_
from typing import Any, TypeVar

Span = tuple[int, int]
"""First and one past the last character, as offsets in the document's text; (0, 0): made by program."""

FUNCTIONS = frozenset(
    {
        *("sin", "cos", "tan", "cot", "sec", "csc", "asin", "acos", "atan"),
        *("sinh", "cosh", "tanh", "exp", "ln", "log", "lg", "abs", "sqrt", "re", "im", "conj", "arg"),
    }
)


class _Letters:
    """Places in each formula for its letters and the kinds of its parts, filled when first asked for."""

    __slots__ = ("_kinds", "_letters")
    _letters: frozenset[str]
    _kinds: frozenset[type]


@dataclass(frozen=True, slots=True)
class Formula(_Letters):
    """A formula or a part of one."""

    span: Span = field(default=(0, 0), compare=False, kw_only=True)

    def __add__(self, other: Value) -> Sum:
        return Sum((*_terms(self), *_terms(formula(other))))

    def __radd__(self, other: Value) -> Sum:
        return formula(other) + self

    def __sub__(self, other: Value) -> Sum:
        return Sum((*_terms(self), Negative(formula(other))))

    def __rsub__(self, other: Value) -> Sum:
        return formula(other) - self

    def __neg__(self) -> Negative:
        return Negative(self)

    def __mul__(self, other: Value) -> Product:
        return Product((*_factors(self), *_factors(formula(other))))

    def __rmul__(self, other: Value) -> Product:
        return formula(other) * self

    def __truediv__(self, other: Value) -> Quotient:
        return Quotient(self, formula(other))

    def __rtruediv__(self, other: Value) -> Quotient:
        return Quotient(formula(other), self)

    def __pow__(self, exponent: Value) -> Power:
        return Power(self, formula(exponent))


Value = Formula | int | Fraction
"""What an operator takes beside a formula: numbers become `Number` nodes."""


@dataclass(frozen=True, slots=True)
class Number(Formula):
    """A number as written; `last_place` is the value of one unit of the last printed digit after a point.

    `4.02` is Number(Fraction(201, 50), Fraction(1, 100)); `7` has no last_place: it is exact.
    """

    value: Fraction
    last_place: Fraction | None = None


@dataclass(frozen=True, slots=True)
class Decimal(Formula):
    """A decimal as it is to be printed, rounded before: "7.4379e-5" is 7.4379 x 10^-5."""

    text: str


@dataclass(frozen=True, slots=True)
class Name(Formula):
    """A letter, by its canonical name: `theta` for θ and \\theta, `lam`, `m_1`, `Delta x` for Δx."""

    name: str


@dataclass(frozen=True, slots=True)
class Constant(Formula):
    """`pi`, `e`, `i` or `infinity`."""

    name: str


@dataclass(frozen=True, slots=True)
class Upright(Formula):
    """Upright words within a formula: a unit, a name in full."""

    text: str


@dataclass(frozen=True, slots=True)
class Sum(Formula):
    """a + b + c; a subtracted term is a Negative. Dots may be among the terms."""

    terms: tuple[Formula, ...]


@dataclass(frozen=True, slots=True)
class Product(Formula):
    """a b c."""

    factors: tuple[Formula, ...]


@dataclass(frozen=True, slots=True)
class Quotient(Formula):
    """a/b, written with a bar or a slash."""

    numerator: Formula
    denominator: Formula


@dataclass(frozen=True, slots=True)
class Power(Formula):
    """a^b; the n-th root is the power 1/n (Quotient of Numbers), the square root a Call of `sqrt`."""

    base: Formula
    exponent: Formula


@dataclass(frozen=True, slots=True)
class Negative(Formula):
    """-a."""

    operand: Formula


@dataclass(frozen=True, slots=True)
class Call(Formula):
    """A function of FUNCTIONS applied to one argument."""

    function: str
    argument: Formula


@dataclass(frozen=True, slots=True)
class Apply(Formula):
    """A function of several arguments, or of one that is written in a way of its own.

    `atan2`, `binomial` (upper, lower), `hyp2f1` (a, b, c, z), `factorial` (n), `besselj` (order, z),
    `kronecker` (m, n), `transpose` (M), `max`, `min`, `det`, and `at` (a letter, a place): x(π).
    """

    function: str
    arguments: tuple[Formula, ...]


@dataclass(frozen=True, slots=True)
class Subscript(Formula):
    """A letter with an index that is a formula of its own: A_(2k). A fixed index belongs to the Name."""

    base: Formula
    index: Formula


@dataclass(frozen=True, slots=True)
class Derivative(Formula):
    """d^n(expression)/d(variable)^n; a dot over a letter is a derivative by the Name `t`."""

    expression: Formula
    variable: Name
    order: int = 1


@dataclass(frozen=True, slots=True)
class Summation(Formula):
    """A sum sign; without bounds all three of index, lower, upper may be None."""

    body: Formula
    index: Name | None = None
    lower: Formula | None = None
    upper: Formula | None = None


@dataclass(frozen=True, slots=True)
class IndexedProduct(Formula):
    """A product sign with its index and bounds."""

    body: Formula
    index: Name
    lower: Formula
    upper: Formula


@dataclass(frozen=True, slots=True)
class Integral(Formula):
    """The integral of `body` over a letter; without bounds `lower` and `upper` are None.

    `closed` is the circle on the sign: over one whole cycle of the letter.
    """

    body: Formula
    variable: Name
    lower: Formula | None = None
    upper: Formula | None = None
    closed: bool = False


@dataclass(frozen=True, slots=True)
class Evaluation(Formula):
    """A formula at a value of a letter, f|_(x=b); with `lower`, its increase from there, [f]_a^b."""

    expression: Formula
    variable: Name
    upper: Formula
    lower: Formula | None = None


@dataclass(frozen=True, slots=True)
class Limit(Formula):
    """What `body` tends to as a letter tends to a point; `side` is 1 or -1 for one-sided limits."""

    body: Formula
    variable: Name
    point: Formula
    side: int = 0


@dataclass(frozen=True, slots=True)
class Extremum(Formula):
    """The largest ("max") or smallest ("min") value of `body` over all values of a letter."""

    function: str
    body: Formula
    variable: Name


@dataclass(frozen=True, slots=True)
class PlusMinus(Formula):
    """±a, or ∓a where `upper` is -1: all upper signs of an equation belong together, and all lower."""

    operand: Formula
    upper: int = 1


@dataclass(frozen=True, slots=True)
class Cases(Formula):
    """One of several values, each with its condition: a relation (left, sign, right), None for "else"."""

    values: tuple[Formula, ...]
    conditions: tuple[tuple[Formula, str, Formula] | None, ...]


@dataclass(frozen=True, slots=True)
class Dots(Formula):
    """Three dots as a term of a sum: at its end the sum is cut off, within it a progression goes on.

    `order` is what O(λ³) says that is left out is no larger than, times a number.
    """

    order: Formula | None = None


@dataclass(frozen=True, slots=True)
class Matrix(Formula):
    """Rows of formulas, all of one length; a vector has rows of one."""

    rows: tuple[tuple[Formula, ...], ...]


@dataclass(frozen=True, slots=True)
class Equation:
    """left, then every relation ("=", "≈", "≤") with what follows it."""

    left: Formula
    links: tuple[tuple[str, Formula], ...]


PI, INFINITY = Constant("pi"), Constant("infinity")


# Building ---------------------------------------------------------------------------------------


def number(value: int | Fraction) -> Number:
    """Return an exact number as a formula.

    >>> number(3).value
    Fraction(3, 1)
    """
    return Number(value if isinstance(value, Fraction) else Fraction(value))


def formula(value: Value) -> Formula:
    """Return a number as a formula, a formula as it is."""
    return value if isinstance(value, Formula) else number(value)


def equal(left: Value, *rights: Value) -> Equation:
    """Return left = right = right ...."""
    return Equation(formula(left), tuple(("=", formula(right)) for right in rights))


def sin(argument: Formula, power: Value | None = None) -> Formula:
    """Return sin^power(argument)."""
    call = Call("sin", argument)
    return call if power in (None, 1) else Power(call, formula(power))


def cos(argument: Formula) -> Call:
    """Return cos(argument)."""
    return Call("cos", argument)


def sqrt(argument: Value) -> Call:
    """Return the square root."""
    return Call("sqrt", formula(argument))


def absolute(argument: Formula) -> Call:
    """Return the absolute value."""
    return Call("abs", argument)


def alternating(exponent: Value) -> Power:
    """Return (-1)^exponent."""
    return Power(number(-1), formula(exponent))


def binomial(upper: Value, lower: Value) -> Apply:
    """Return the binomial coefficient C(upper, lower)."""
    return Apply("binomial", (formula(upper), formula(lower)))


def hypergeometric(a: Value, b: Value, c: Value, z: Value) -> Apply:
    """Return Gauss' hypergeometric function 2F1(a, b; c; z)."""
    return Apply("hyp2f1", (formula(a), formula(b), formula(c), formula(z)))


def total(index: Name, first: Value, last: Value | None, body: Formula) -> Summation:
    """Return the sum of `body` over `index` from `first` to `last`, or without end where that is None."""
    return Summation(body, index, formula(first), INFINITY if last is None else formula(last))


def monomial(coefficient: Fraction, base: Formula, exponent: int, of: Formula | None = None) -> Formula:
    """Return coefficient x base^exponent x `of` as one fraction; the coefficient is positive.

    >>> x = Name("x")
    >>> monomial(Fraction(3, 8), x, -2) == Quotient(number(3), number(8) * x**2)
    True
    >>> monomial(Fraction(1), x, 1, of=Name("y")) == x * Name("y")
    True
    """
    above, below = coefficient.as_integer_ratio()
    power = base if abs(exponent) == 1 else Power(base, number(abs(exponent)))
    over: list[Formula] = [number(above)] if above != 1 else []
    under: list[Formula] = [number(below)] if below != 1 else []
    if exponent:
        (over if exponent > 0 else under).append(power)
    if of is not None:
        over.append(of)
    return Quotient(_product(over), _product(under)) if under else _product(over)


def _product(factors: list[Formula]) -> Formula:
    if len(factors) == 1:
        return factors[0]
    return Product(tuple(factors)) if factors else number(1)


def signed(sign: int, value: Formula) -> Formula:
    """Return a term of a sum with its sign: the value, or its negative."""
    return value if sign > 0 else Negative(value)


def _terms(value: Formula) -> tuple[Formula, ...]:
    return value.terms if isinstance(value, Sum) else (value,)


def _factors(value: Formula) -> tuple[Formula, ...]:
    return value.factors if isinstance(value, Product) else (value,)


Part = TypeVar("Part", bound=Formula)

# Walking ----------------------------------------------------------------------------------------

_SINGLE: dict[type[Formula], tuple[str, ...]] = {
    Quotient: ("numerator", "denominator"),
    Power: ("base", "exponent"),
    Negative: ("operand",),
    Call: ("argument",),
    Subscript: ("base", "index"),
    Derivative: ("expression", "variable"),
    Summation: ("body", "index", "lower", "upper"),
    IndexedProduct: ("body", "index", "lower", "upper"),
    Integral: ("body", "variable", "lower", "upper"),
    Evaluation: ("expression", "variable", "upper", "lower"),
    Limit: ("body", "variable", "point"),
    Extremum: ("body", "variable"),
    PlusMinus: ("operand",),
}
_SEVERAL: dict[type[Formula], str] = {Sum: "terms", Product: "factors", Apply: "arguments"}
_PAIRS: dict[type[Formula], Callable[[Any], tuple[Formula, ...]]] = {
    Quotient: attrgetter("numerator", "denominator"),
    Power: attrgetter("base", "exponent"),
}
"""The most frequent formulas of two parts, which are always there."""
_LEAVES = frozenset({Name, Number, Constant})
"""The most frequent formulas without parts."""


def children(node: Formula) -> tuple[Formula, ...]:
    """Return the parts of a formula, in the order written.

    >>> children(Quotient(number(1), Name("s")))
    (Number(span=(0, 0), value=Fraction(1, 1), last_place=None), Name(span=(0, 0), name='s'))
    """
    kind = type(node)
    if kind in _LEAVES:
        return ()
    if kind in _SEVERAL:
        return getattr(node, _SEVERAL[kind])
    if kind in _PAIRS:
        return _PAIRS[kind](node)
    if isinstance(node, Matrix):
        return tuple(entry for row in node.rows for entry in row)
    if isinstance(node, Cases):
        sides = [side for condition in node.conditions if condition for side in condition[::2]]
        return (*node.values, *(side for side in sides if isinstance(side, Formula)))
    parts = (getattr(node, name) for name in _SINGLE.get(kind, ()))
    return tuple(part for part in parts if part is not None)


def with_parts_changed(node: Formula, change: Callable[[Formula], Formula]) -> Formula:
    """Return a formula with each part changed, that very object where no part is another."""
    parts = children(node)
    changed = tuple(map(change, parts))
    return node if all(map(is_, parts, changed)) else with_children(node, changed)


def with_children(node: Formula, parts: tuple[Formula, ...]) -> Formula:
    """Return the formula with its parts (as `children` lists them) replaced."""
    if isinstance(node, Sum):
        return Sum(parts, span=node.span)
    if isinstance(node, Product):
        return Product(parts, span=node.span)
    if isinstance(node, Apply):
        return replace(node, arguments=parts)
    replacements = iter(parts)
    if isinstance(node, Matrix):
        return replace(node, rows=tuple(tuple(next(replacements) for _ in row) for row in node.rows))
    if isinstance(node, Cases):
        values = tuple(next(replacements) for _ in node.values)
        conditions = tuple(c and (next(replacements), c[1], next(replacements)) for c in node.conditions)
        return replace(node, values=values, conditions=conditions)
    own = (name for name in _SINGLE.get(type(node), ()) if getattr(node, name) is not None)
    changes = {name: next(replacements) for name in own}
    return replace(node, **changes) if changes else node


def walk(node: Formula) -> Iterator[Formula]:
    """Yield the formula and everything in it, outermost first."""
    waiting = [node]
    while waiting:
        part = waiting.pop()
        yield part
        if type(part) not in _LEAVES:
            waiting.extend(reversed(children(part)))


def parts_of_kind(node: Formula, *kinds: type[Part]) -> Iterator[Part]:
    """Yield the parts of a formula that are of a kind, outermost first; without any it costs one look.

    >>> list(parts_of_kind(Name("s") * Call("sin", Name("theta")), Call))
    [Call(span=(0, 0), function='sin', argument=Name(span=(0, 0), name='theta'))]
    """
    if not _kinds_in(node).isdisjoint(kinds):
        for part in walk(node):
            if isinstance(part, kinds):
                yield part


def _kinds_in(node: Formula) -> frozenset[type]:
    try:
        return node._kinds
    except AttributeError:
        kinds = frozenset({type(node)}.union(*map(_kinds_in, children(node))))
        object.__setattr__(node, "_kinds", kinds)
        return kinds


def names(node: Formula) -> frozenset[str]:
    """Return the letters that occur in a formula.

    >>> sorted(names(Name("s") * Call("sin", Name("theta"))))
    ['s', 'theta']
    """
    try:
        return node._letters  # a checker asks for those of one side thousands of times
    except AttributeError:
        letters = {node.name} if isinstance(node, Name) else set[str]()
        letters.update(*map(names, children(node)))
        object.__setattr__(node, "_letters", frozenset(letters))
        return node._letters
