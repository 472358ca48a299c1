"""What a hand-written formula says, as a tree: the reader's result and the checker's input.

Every node is frozen and compares by what it says; where it stands (`span`, character offsets in the
document) does not count. Nothing is evaluated, ordered or simplified: `2/4` stays a quotient of 2 and 4.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from fractions import Fraction

Span = tuple[int, int]
"""First and one past the last character, as offsets in the document's text; (0, 0): made by program."""

FUNCTIONS = frozenset(
    {
        *("sin", "cos", "tan", "cot", "sec", "csc", "asin", "acos", "atan"),
        *("sinh", "cosh", "tanh", "exp", "ln", "log", "abs", "sqrt"),
    }
)


@dataclass(frozen=True, slots=True)
class Node:
    """A part of a formula."""

    span: Span = field(default=(0, 0), compare=False, kw_only=True)


@dataclass(frozen=True, slots=True)
class Number(Node):
    """A number as written; `last_place` is the value of one unit of the last printed digit after a point.

    `4.02` is Number(Fraction(201, 50), Fraction(1, 100)); `7` has no last_place: it is exact.
    """

    value: Fraction
    last_place: Fraction | None = None


@dataclass(frozen=True, slots=True)
class Name(Node):
    """A declared letter, by its canonical name: `theta` for θ and \\theta, `m_1`, `omega`, `M1`."""

    name: str


@dataclass(frozen=True, slots=True)
class Constant(Node):
    """`pi`, `e`, `i` or `infinity`."""

    name: str


@dataclass(frozen=True, slots=True)
class Sum(Node):
    """a + b + c; a subtracted term is a Negative. Dots may be among the terms."""

    terms: tuple[Node, ...]


@dataclass(frozen=True, slots=True)
class Product(Node):
    """a b c."""

    factors: tuple[Node, ...]


@dataclass(frozen=True, slots=True)
class Quotient(Node):
    """a/b, written with a bar or a slash."""

    numerator: Node
    denominator: Node


@dataclass(frozen=True, slots=True)
class Power(Node):
    """a^b; the n-th root is the power 1/n (Quotient of Numbers), the square root a Call of `sqrt`."""

    base: Node
    exponent: Node


@dataclass(frozen=True, slots=True)
class Negative(Node):
    """-a."""

    operand: Node


@dataclass(frozen=True, slots=True)
class Call(Node):
    """A function of FUNCTIONS applied to one argument."""

    function: str
    argument: Node


@dataclass(frozen=True, slots=True)
class Derivative(Node):
    """d^n(expression)/d(variable)^n; a dot over a letter is a derivative by the Name `t`."""

    expression: Node
    variable: Name
    order: int = 1


@dataclass(frozen=True, slots=True)
class Summation(Node):
    """A sum sign; without bounds all three of index, lower, upper may be None."""

    body: Node
    index: Name | None = None
    lower: Node | None = None
    upper: Node | None = None


@dataclass(frozen=True, slots=True)
class Dots(Node):
    """Three dots as a term of a sum: at its end the sum is cut off, within it a progression goes on."""


_SINGLE: dict[type[Node], tuple[str, ...]] = {
    Quotient: ("numerator", "denominator"),
    Power: ("base", "exponent"),
    Negative: ("operand",),
    Call: ("argument",),
    Derivative: ("expression", "variable"),
    Summation: ("body", "index", "lower", "upper"),
}


def children(node: Node) -> tuple[Node, ...]:
    """Return the parts of a node, in the order written.

    >>> children(Quotient(Number(Fraction(1)), Name("s")))
    (Number(span=(0, 0), value=Fraction(1, 1), last_place=None), Name(span=(0, 0), name='s'))
    """
    if isinstance(node, Sum):
        return node.terms
    if isinstance(node, Product):
        return node.factors
    found = (getattr(node, name) for name in _SINGLE.get(type(node), ()))
    return tuple(part for part in found if part is not None)


def with_children(node: Node, parts: tuple[Node, ...]) -> Node:
    """Return the node with its parts (as `children` lists them) replaced."""
    if isinstance(node, Sum):
        return Sum(parts, span=node.span)
    if isinstance(node, Product):
        return Product(parts, span=node.span)
    given = iter(parts)
    own = (name for name in _SINGLE.get(type(node), ()) if getattr(node, name) is not None)
    changes = {name: next(given) for name in own}
    return replace(node, **changes) if changes else node


def walk(node: Node) -> Iterator[Node]:
    """Yield the node and everything in it, outermost first."""
    yield node
    for part in children(node):
        yield from walk(part)


def names(node: Node) -> frozenset[str]:
    """Return the letters that occur in a formula.

    >>> sorted(names(Product((Name("s"), Call("sin", Name("theta"))))))
    ['s', 'theta']
    """
    return frozenset(part.name for part in walk(node) if isinstance(part, Name))
