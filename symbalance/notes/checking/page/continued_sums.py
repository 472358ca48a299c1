"""Sums with dots between their terms, written out: 1 + 2 + … + 10 has ten terms, cos θ + … + cos 5θ five.

The last term differs from the one before the dots in some numbers, which run on in equal steps; the terms
before the dots have to be those of the same steps. Numbers alone may also grow by one factor, as in
1 + 2 + 4 + … + 64. A sum that goes on in two ways stays as it is, and so does one whose end is a letter.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from math import prod

from symbalance.document.formula import (
    Dots,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Span,
    Sum,
    children,
    walk,
    with_children,
)
from symbalance.notes.algebra.number_formulas import rational_node
from symbalance.notes.algebra.open_sums import goes_on_within
from symbalance.notes.reading.equations import ReadNotes, Side

MOST_TERMS = 64
"""Terms with letters that are written out."""
MOST_NUMBERS = 10_000
"""Numbers that are added up."""
LARGEST_POWER = 64
"""An exponent that a power of numbers is worked out to."""
FEWEST_OF_A_FACTOR = 3
"""Numbers from which on a sum without end is seen to shrink by one factor."""


Place = tuple[int, ...]
"""Which part of which part of a formula."""
Leaf = tuple[Place, Fraction, Fraction]
"""A number or an index before the dots, and what stands in its place behind them."""


def with_continued_sums(page: ReadNotes) -> ReadNotes:
    """Return a page whose sums with dots between their terms are written out, where that is one sum."""
    sides = [side for chain in page.chains for side in chain.sides]
    if not any(isinstance(part, Dots) for side in sides for node in side.readings for part in walk(node)):
        return page

    def expanded(side: Side) -> Side:
        return side.changed(_expanded)

    chains = (replace(c, sides=tuple(map(expanded, c.sides))) for c in page.chains)
    return replace(page, chains=tuple(chains))


def _expanded(node: Formula) -> Formula:
    parts = children(node)
    if parts:
        inner = tuple(map(_expanded, parts))
        node = (
            with_children(node, inner)
            if any(a is not b for a, b in zip(inner, parts, strict=True))
            else node
        )
    if isinstance(node, Sum) and goes_on_within(node):
        return _written_out(node) or node
    if isinstance(node, Sum) and isinstance(node.terms[-1], Dots):
        return _without_end(node) or node
    return node


def _written_out(node: Sum) -> Formula | None:
    """Return a sum with its terms in the place of the dots, None where they are not known for certain."""
    place = next(k for k, term in enumerate(node.terms) if isinstance(term, Dots))
    before, after = node.terms[:place], node.terms[place + 1 :]
    if len(before) < 2 or any(isinstance(term, Dots) for term in after):
        return None
    ways = [*_in_equal_steps(before, after), *_by_a_factor(before, after)]
    if len(ways) != 1:
        return None
    (terms,) = ways
    numbers = [_value(term) for term in terms]
    if all(number is not None for number in numbers):
        total = sum((number for number in numbers if number is not None), Fraction(0))
        return _moved(rational_node(total), node.span)
    if len(terms) > MOST_TERMS:
        return None
    return replace(node, terms=tuple(_moved(term, node.span) for term in terms))


def _without_end(node: Sum) -> Formula | None:
    """Return the sum of numbers without end that shrink by one factor, 1 + 1/2 + …, or None."""
    values = [_value(term) for term in node.terms[:-1]]
    numbers = [value for value in values if value is not None]
    if len(numbers) < len(values) or len(values) < FEWEST_OF_A_FACTOR or not all(numbers):
        return None
    factor = numbers[1] / numbers[0]
    is_steady = all(b == a * factor for a, b in pairwise(numbers))
    if not is_steady or abs(factor) >= 1:
        return None
    return _moved(rational_node(numbers[0] / (1 - factor)), node.span)


# The terms between


def _in_equal_steps(before: tuple[Formula, ...], after: tuple[Formula, ...]) -> Iterator[list[Formula]]:
    """Yield the terms of a sum whose numbers run on in equal steps between the dots."""
    last, end = before[-1], after[0]
    ends = list(_leaves_that_differ(last, end) or ())
    if not ends:
        return
    for count in _counts(before[-2], last, ends):
        if all(
            _same(_at_step(last, ends, Fraction(k - len(before) + 1, count)), t)
            for k, t in enumerate(before)
        ):
            further = (_at_step(last, ends, Fraction(count + k, count)) for k in range(len(after)))
            if all(_same(term, other) for term, other in zip(further, after, strict=True)):
                between = [_at_step(last, ends, Fraction(k, count)) for k in range(1, count)]
                yield [*before, *between, *after]
                return


def _counts(first: Formula, last: Formula, ends: list[Leaf]) -> Iterator[int]:
    """Yield how many steps may lie between the dots, as many as the term before them says."""
    (_, start, end), *_ = ends
    own = _leaves_that_differ(first, last)
    if own:
        step = next((b - a for place, a, b in own if place == ends[0][0]), None)
        count = (end - start) / step if step else None
        if count is not None and count.denominator == 1 and 1 <= count <= MOST_NUMBERS:
            yield int(count)
        return
    difference = abs(end - start)
    if difference.denominator == 1 and difference <= MOST_TERMS:
        yield from (n for n in range(int(difference), 0, -1) if difference % n == 0)


def _leaves_that_differ(first: Formula, second: Formula, place: Place = ()) -> list[Leaf] | None:
    """Return where numbers or indices of two formulas differ, None for formulas of two shapes."""
    if isinstance(first, Number) and isinstance(second, Number):
        is_like = (first.last_place is None) == (second.last_place is None)
        return _differing(place, first.value, second.value) if is_like else None
    if isinstance(first, Name) and isinstance(second, Name) and first.name != second.name:
        own, other = (name.name.rpartition("_") for name in (first, second))
        is_like = own[0] == other[0] != "" and own[2].isdecimal() and other[2].isdecimal()
        return _differing(place, Fraction(own[2]), Fraction(other[2])) if is_like else None
    parts, others = children(first), children(second)
    if len(parts) != len(others) or _bare(first) != _bare(second):
        return None
    inner = [
        _leaves_that_differ(a, b, (*place, k)) for k, (a, b) in enumerate(zip(parts, others, strict=True))
    ]
    return None if None in inner else [leaf for leaves in inner for leaf in leaves or ()]


def _differing(place: Place, start: Fraction, end: Fraction) -> list[Leaf]:
    return [] if start == end else [(place, start, end)]


def _bare(node: Formula) -> Formula:
    """Return a formula with nothing in it, to compare what else it is."""
    parts = children(node)
    if not parts:
        return replace(node, span=(0, 0))
    return replace(with_children(node, (Number(Fraction(0)),) * len(parts)), span=(0, 0))


def _at_step(node: Formula, ends: list[Leaf], share: Fraction) -> Formula:
    """Return a term with its numbers at a share of the way from one end to the other."""
    for place, start, end in ends:
        node = _with_leaf(node, place, start + (end - start) * share)
    return node


def _with_leaf(node: Formula, place: Place, value: Fraction) -> Formula:
    if place:
        parts = list(children(node))
        parts[place[0]] = _with_leaf(parts[place[0]], place[1:], value)
        return with_children(node, tuple(parts))
    if isinstance(node, Name):
        is_index = value.denominator == 1 and value >= 0
        return Name(f"{node.name.rpartition('_')[0]}_{value}") if is_index else Number(value)
    return Number(value)


def _by_a_factor(before: tuple[Formula, ...], after: tuple[Formula, ...]) -> Iterator[list[Formula]]:
    """Yield the terms of a sum of numbers that grow or shrink by one factor, 1 + 2 + 4 + … + 64."""
    shown = [_value(term) for term in (*before, *after)]
    numbers = [number for number in shown if number is not None]
    if len(numbers) < len(shown) or not all(numbers):
        return
    factor = numbers[1] / numbers[0]
    if abs(factor) == 1:
        return
    whole = [numbers[0]]
    for _ in range(MOST_TERMS):
        if whole[-len(after) :] == numbers[-len(after) :] and len(whole) > len(before):
            break
        whole.append(whole[-1] * factor)
    if whole[-len(after) :] == numbers[-len(after) :] and whole[: len(before)] == numbers[: len(before)]:
        yield [rational_node(number) for number in whole]


# Comparing and working out


def _same(first: Formula, second: Formula) -> bool:
    """Tell whether two terms are the same but for factors and exponents 1 and terms 0."""
    return _simple(first) == _simple(second)


def _simple(node: Formula) -> Formula:
    """Return a formula without factors and exponents 1, terms 0, places in the text and last digits."""
    if (value := _value(node)) is not None:
        return Number(value)
    parts = tuple(map(_simple, children(node)))
    if isinstance(node, Product):
        factors = [f for part in parts for f in (part.factors if isinstance(part, Product) else (part,))]
        return _NOTHING if _NOTHING in factors else _joined(Product, factors, _ONE)
    if isinstance(node, Sum):
        return _joined(Sum, parts, _NOTHING)
    if isinstance(node, Power) and parts[1] == _NOTHING:
        return _ONE
    is_whole = isinstance(node, Quotient | Power) and parts[1] == _ONE
    if is_whole or (isinstance(node, Quotient) and parts[0] == _NOTHING):
        return parts[0]
    return replace(with_children(node, parts) if parts else node, span=(0, 0))


def _joined(kind: type[Sum] | type[Product], parts: Iterable[Formula], idle: Formula) -> Formula:
    """Return a sum or product of the parts that change it."""
    own = tuple(part for part in parts if part != idle)
    return own[0] if len(own) == 1 else kind(own)


def _value(node: Formula) -> Fraction | None:
    """Return the value of an arithmetic of exact numbers, None for other formulas."""
    if isinstance(node, Number):
        return node.value
    rule = _VALUES.get(type(node))
    numbers = [_value(part) for part in children(node)] if rule else [None]
    return None if rule is None or None in numbers else rule([n for n in numbers if n is not None])


def _quotient(numbers: list[Fraction]) -> Fraction | None:
    above, below = numbers
    return above / below if below else None


def _power(numbers: list[Fraction]) -> Fraction | None:
    base, exponent = numbers
    is_small = exponent.denominator == 1 and abs(exponent) <= LARGEST_POWER
    return base ** int(exponent) if is_small and (base or exponent >= 0) else None


_NOTHING, _ONE = Number(Fraction(0)), Number(Fraction(1))
_VALUES: dict[type, Callable[[list[Fraction]], Fraction | None]] = {
    Negative: lambda numbers: -numbers[0],
    Sum: lambda numbers: sum(numbers, Fraction(0)),
    Product: lambda numbers: prod(numbers, start=Fraction(1)),
    Quotient: _quotient,
    Power: _power,
}


def _moved(node: Formula, span: Span) -> Formula:
    """Return a term with every part at the place of the sum: no part of it stands alone in the text."""
    parts = children(node)
    moved = with_children(node, tuple(_moved(part, span) for part in parts)) if parts else node
    return replace(moved, span=span)
