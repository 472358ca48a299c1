"""Angles typed without their degree sign: r (1 − cos 30) on a page with θ = 30° is of 30 degrees.

A calculator set to radians gives another number, and who prints that has slipped. Where the page names no
such angle a large bare number may be either: both readings stay, degrees first.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import (
    Call,
    Constant,
    Formula,
    Negative,
    Number,
    Product,
    Quotient,
    Span,
    children,
    parts_of_kind,
    with_children,
)
from symbalance.notes.reading.equations import Chain, ReadNotes, Side
from symbalance.text import lazy_patterns as re

MORE_THAN_A_TURN = 7
"""A whole number from it on is no angle in radians that anyone would type: 2π is less."""
_FUNCTIONS = ("sin", "cos", "tan", "cot")
_IN_DEGREES = re.compile(
    r"(?<![\w.,])(?P<number>[0-9]{1,4}(?:[.,][0-9]{1,4})?)"
    r"(?:[ ~]|\\[,;: ])?(?:°|\^\{?\\circ|\\degree|deg(?:rees?)?(?![a-z])|Grad(?![a-z])|度)"
    r"|\\ang\{(?P<typed>[0-9]{1,4}(?:[.,][0-9]{1,4})?)\}"
)


def with_bare_degrees(document: ReadNotes, *, only_named: bool = False) -> ReadNotes:
    """Return a page whose bare numbers in sines and cosines are degrees, where they may be.

    With `only_named` those only that the page names with their sign elsewhere: the others stay.
    """
    if not any(_bare(node) for chain in document.chains for s in chain.sides for node in s.readings):
        return document
    angles = frozenset(
        Fraction((m["number"] or m["typed"]).replace(",", "."))
        for m in _IN_DEGREES.finditer(document.text)
    )
    return replace(document, chains=tuple(_chain(chain, angles, only_named) for chain in document.chains))


def _chain(chain: Chain, angles: frozenset[Fraction], only_named: bool) -> Chain:
    return replace(chain, sides=tuple(_side(side, angles, only_named) for side in chain.sides))


def _side(side: Side, angles: frozenset[Fraction], only_named: bool) -> Side:
    own = [number for node in side.readings for number in _bare(node)]
    is_named = any(abs(number.value) in angles for number in own)
    if not own or (only_named and not is_named):
        return side
    in_degrees = tuple(_in_degrees(node) for node in side.readings)
    return replace(side, readings=in_degrees if is_named else (*in_degrees, *side.readings))


def _bare(node: Formula) -> list[Number]:
    """Return the bare numbers of which a formula takes sines and cosines."""
    calls = (part for part in parts_of_kind(node, Call) if part.function in _FUNCTIONS)
    numbers = (_number(call.argument) for call in calls)
    return [number for number in numbers if number is not None]


def _number(argument: Formula) -> Number | None:
    node = argument.operand if isinstance(argument, Negative) else argument
    is_bare = isinstance(node, Number) and node.last_place is None and node.value.denominator == 1
    return node if is_bare and isinstance(node, Number) and node.value >= MORE_THAN_A_TURN else None


def _in_degrees(node: Formula) -> Formula:
    if isinstance(node, Call) and node.function in _FUNCTIONS and (number := _number(node.argument)):
        angle: Formula = _degrees(number, number.span)
        if isinstance(node.argument, Negative):
            angle = replace(node.argument, operand=angle)
        return replace(node, argument=angle)
    parts = children(node)
    return with_children(node, tuple(map(_in_degrees, parts))) if parts else node


def _degrees(number: Number, span: Span) -> Product:
    place = (span[1] - 1, span[1])
    half_turn = Number(Fraction(180), span=place)
    unit = Quotient(Constant("pi", span=place), half_turn, span=place)
    return Product((number, unit), span=span)
