"""Long formulas over several lines: broken before a sign, inside brackets only where it must be.

An equation becomes pieces that may not be split, nested as its brackets are. A piece that does not fit
what is left of a line goes to the next one; one that fits no line is broken at the signs inside it.
How wide a piece is, says the medium: text counts columns, LaTeX the width of digits. Displayed equations
share one left column, and a bar or root over a whole sum, which no line break can cross, is taken apart
(`expand_radicals`).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from typing import NamedTuple, Protocol

from symbalance.document.formula import (
    Call,
    Dots,
    Equation,
    Formula,
    Negative,
    Number,
    Product,
    Quotient,
    Sum,
    Summation,
    monomial,
    number,
)
from symbalance.document.formula_printing import PRODUCT


class Medium(Protocol):
    """A writer that knows how wide what it writes is, in a unit of its own."""

    minus: str

    def write(self, node: Formula, least: int = 0, closed: bool = False) -> str:
        """Return a formula in print."""
        ...

    def relation(self, sign: str) -> str:
        """Return the sign of a relation in print."""
        ...

    def width(self, printed: str) -> float:
        """Return how much room something printed takes."""
        ...

    def fences(self, value: Sum, printed: str) -> tuple[str, str]:
        """Return the brackets around a sum, `printed`, that may run over several lines."""
        ...

    def factor(self, value: Formula, closed: bool = False, last: bool = False) -> str:
        """Return a factor of a product, in brackets where it needs them."""
        ...

    def between(self, before: Formula, piece: str, after: Formula) -> str:
        """Return what stands between a factor and the one after it, which prints as `piece`."""
        ...


@dataclass(frozen=True, slots=True)
class Piece:
    """Something printed, its width, and the smaller pieces it may be broken into (none: it may not)."""

    printed: str
    width: float
    inside: tuple[Piece, ...] = ()


@dataclass(slots=True)
class Line:
    """A line as it fills up; `depth` counts the brackets it continues."""

    depth: int
    printed: str
    width: float


def break_link(relation: str, right: Formula, medium: Medium, room: float, indent: float) -> list[Line]:
    """Return `relation right` in lines no wider than `room` where that can be.

    Each bracket a line continues takes up `indent` of its room.

    >>> from symbalance.document.text_writer import TextWriter
    >>> from symbalance.document.formula import Name
    >>> a, b, c = map(Name, "abc")
    >>> [line.printed for line in break_link("=", a * (a + b * (a + b) - c), TextWriter(), 14, 2)]
    ['= a [a', '+ b (a + b)', '− c]']
    """
    piece = _glued(_piece(right, medium), f"{medium.relation(relation)} ", "", medium)
    return fill_lines((piece,), room, indent)


def break_equation(equation: Equation, medium: Medium, room: float, indent: float) -> list[Line]:
    """Return what stands right of an equation's left side, in lines: short links together on one.

    >>> from symbalance.document.text_writer import TextWriter
    >>> from symbalance.document.formula import Name, equal
    >>> a, b, c = map(Name, "abc")
    >>> [line.printed for line in break_equation(equal(a, b, c, a + b + c), TextWriter(), 9, 2)]
    ['= b = c', '= a + b', '+ c']
    """
    lines: list[Line] = []
    space, may_run_on = medium.width(" "), False
    for sign, right in equation.links:
        link = break_link(sign, right, medium, room, indent)
        head = link[0]
        if may_run_on and len(link) == 1 and lines[-1].width + space + head.width <= room:
            lines[-1] = Line(
                0, f"{lines[-1].printed} {head.printed}", lines[-1].width + space + head.width
            )
            continue
        lines += link
        may_run_on = len(link) == 1
    return lines


def break_sum(value: Formula, medium: Medium, room: float, first: float, indent: float) -> list[Line]:
    """Return a formula in lines of which the first has `first` of the room, the others all but `indent`.

    >>> from symbalance.document.text_writer import TextWriter
    >>> from symbalance.document.formula import Name
    >>> a, b, c = map(Name, "abc")
    >>> [line.printed for line in break_sum(a + b - c, TextWriter(), 10, 3, 2)]
    ['a', '+ b − c']
    """
    piece = _piece(value, medium)
    lines = fill_lines(piece.inside or (piece,), room, indent, used=room - first, depth=1)
    # Whole on one line it has brackets that grow, which the pieces of a broken one cannot have.
    return lines if len(lines) > 1 else [Line(0, medium.write(value), lines[0].width)]


def fill_lines(
    pieces: Iterable[Piece], room: float, indent: float, used: float = 0, depth: int = 0
) -> list[Line]:
    """Return pieces in lines no wider than `room` where that can be; `used` is gone from the first.

    Lines after the first are `depth` brackets deep.
    """
    lines = [Line(0, "", used)]
    _fill(pieces, lines, room, indent, depth)
    return lines


def _fill(pieces: Iterable[Piece], lines: list[Line], room: float, indent: float, depth: int) -> None:
    for piece in pieces:
        fresh = not lines[-1].printed
        if lines[-1].width + piece.width <= room or (fresh and not piece.inside):
            lines[-1].printed += piece.printed.lstrip() if fresh else piece.printed
            lines[-1].width += piece.width
        elif not piece.inside or (not fresh and depth * indent + piece.width <= room):
            lines.append(Line(depth, piece.printed.lstrip(), depth * indent + piece.width))
        else:
            if not fresh:
                lines.append(Line(depth, "", depth * indent))
            _fill(piece.inside, lines, room, indent, depth + 1)


def _piece(value: Formula, medium: Medium) -> Piece:
    if isinstance(value, Sum) and len(value.terms) > 1:
        return _joined([_term(term, not place, medium) for place, term in enumerate(value.terms)])
    if isinstance(value, Product) and any(isinstance(factor, Sum) for factor in value.factors):
        return _product(value, medium)
    printed = medium.write(value)
    return Piece(printed, medium.width(printed))


def _term(term: Formula, first: bool, medium: Medium) -> Piece:
    negative = isinstance(term, Negative)
    operand = term.operand if negative else term
    sign = medium.minus if negative else "" if first else "+"
    if not first:
        sign = f" {sign} "
    if isinstance(operand, Sum):
        piece = _bracketed(operand, medium)
    elif isinstance(operand, Product):
        piece = _piece(operand, medium)
    else:
        bare = isinstance(operand, Summation | Dots) or not sign
        printed = medium.write(operand, 0 if bare else PRODUCT)
        piece = Piece(printed, medium.width(printed))
    return _glued(piece, sign, "", medium)


def _product(value: Product, medium: Medium) -> Piece:
    """Return a product that may be broken inside the last of its bracketed factors."""
    factors, last = value.factors, len(value.factors) - 1
    place, inner = [(i, factor) for i, factor in enumerate(factors) if isinstance(factor, Sum)][-1]
    printed = [medium.factor(factor, i < last, i == last) for i, factor in enumerate(factors)]
    between = [
        medium.between(left, piece, right)
        for (left, right), piece in zip(pairwise(factors), printed[1:], strict=True)
    ]
    before = "".join(printed[i] + between[i] for i in range(place))
    after = "".join(between[i] + printed[i + 1] for i in range(place, last))
    return _glued(_bracketed(inner, medium), before, after, medium)


def _bracketed(value: Sum, medium: Medium) -> Piece:
    piece = _piece(value, medium)
    return _glued(piece, *medium.fences(value, piece.printed), medium)


def _glued(piece: Piece, before: str, after: str, medium: Medium) -> Piece:
    """Return a piece with something unbreakable before its first part and after its last."""
    if not piece.inside:
        return Piece(
            before + piece.printed + after, medium.width(before) + piece.width + medium.width(after)
        )
    first, *rest = piece.inside
    parts = [_glued(first, before, "" if rest else after, medium), *rest]
    if rest:
        parts[-1] = _glued(parts[-1], "", after, medium)
    return _joined(parts)


def _joined(parts: list[Piece]) -> Piece:
    return Piece("".join(p.printed for p in parts), sum(p.width for p in parts), tuple(parts))


class DisplayedLine(NamedTuple):
    """A line of displayed equations: what stands left of the relation, its indent, the rest."""

    left: str
    depth: int
    printed: str


def display_lines(
    equations: Sequence[Equation], writer: Medium, room: float, indent: float, column: float = 0
) -> Iterator[DisplayedLine]:
    """Yield the lines of equations that share one left column, none wider than `room` where that can be.

    Lengths are in the writer's own unit; each bracket that a line continues takes up `indent`, and the
    left column at least `column`.
    """
    space = writer.width(" ")
    names = [writer.write(each.left) for each in equations]
    left = max(column, *map(writer.width, names)) + space
    for name, each in zip(names, equations, strict=True):
        for place, line in enumerate(break_equation(each, writer, room - left, indent)):
            yield DisplayedLine("" if place else name, line.depth, line.printed)


def expand_radicals(value: Formula) -> tuple[int, Formula]:
    """Return (power, formula) such that value^power is the formula, a sum without a bar or root over it.

    The power is 2 for a root, whose sign the square does not tell, else 1. What is neither stays.

    >>> from symbalance.document.formula import Name, sqrt
    >>> from symbalance.document.text_writer import formula_text
    >>> a, b = Name("a"), Name("b")
    >>> formula_text(expand_radicals((a - 3 * b) / 2)[1])
    'a/2 − 3b/2'
    >>> power, square = expand_radicals(sqrt((a + b) / 2) / 3)
    >>> power, formula_text(square)
    (2, 'a/18 + b/18')
    """
    factor, rest = _factor(value)
    if isinstance(rest, Call) and rest.function == "sqrt":
        inner, below = _factor(rest.argument)
        return 2, _scaled(below, factor**2 * inner)
    return 1, _scaled(rest, factor) if isinstance(rest, Sum) else value


def _factor(value: Formula) -> tuple[Fraction, Formula]:
    """Return a rational factor of a formula, and what is left."""
    if isinstance(value, Negative):
        factor, rest = _factor(value.operand)
        return -factor, rest
    if isinstance(value, Quotient) and isinstance(value.denominator, Number):
        factor, rest = _factor(value.numerator)
        return factor / value.denominator.value, rest
    if isinstance(value, Product) and isinstance(value.factors[0], Number):
        factors = value.factors[1:]
        return value.factors[0].value, factors[0] if len(factors) == 1 else Product(factors)
    return Fraction(1), value


def _scaled(value: Formula, factor: Fraction) -> Formula:
    """Return factor times a sum, term by term."""
    terms = value.terms if isinstance(value, Sum) else (value,)
    return Sum(tuple(_scaled_term(term, factor) for term in terms))


def _scaled_term(term: Formula, factor: Fraction) -> Formula:
    coefficient, rest = _factor(term)
    whole = coefficient * factor
    if isinstance(rest, Number):
        whole, rest = whole * rest.value, number(1)
    size = monomial(abs(whole), rest, 0 if rest == number(1) else 1)
    return size if whole > 0 else Negative(size)
