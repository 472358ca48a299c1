"""The document of an order with symbols left in: formulas of force and couple, then their letters."""

from __future__ import annotations

import re
from typing import Any

import sympy

from symbalance.design.variations.legend import MASS, OMEGA, PITCH, RADIUS, Entry
from symbalance.design.variations.symbolic_orders import SymbolicOrder, SymbolResultant
from symbalance.document.expressions import formula_of
from symbalance.document.formula import (
    Equation,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Upright,
    cos,
    equal,
    number,
    signed,
    sin,
)
from symbalance.document.nodes import Block, Document, Facts, Formulas, Heading, Inline, Paragraph
from symbalance.engine.engine_document import SIGNS, origin_facts
from symbalance.forces.rows import plane
from symbalance.kinematics.series_printing import series_formula

_THETA, _R, _L, _E = Name("theta"), Name("r"), Name("l"), Name("e")


def symbolic_order_document(order: SymbolicOrder) -> Document:
    """Return an order as a document: the parts of its force and couple that do not vanish."""
    title: list[Inline] = [f"{order.engine.name}: order {order.order} with symbols left in"]
    for symbol in order.derivative_by:
        title += [", derivative by ", _letter(symbol)]
    force = _unit(order)
    couple = force if "stations" in order.sizes else force * PITCH
    parts = (
        *_formulas(order, ("Free force, unit ", force), order.force),
        *_formulas(order, ("Free couple about ", *_plane(order), ", unit ", couple), order.couple),
    )
    return Document(tuple(title), (*parts, _legend(order)))


def _unit(order: SymbolicOrder) -> Formula:
    """Return omega^2 with what the sums do not hold: A_n, and the mass and radius that are not given."""
    factors: list[Formula] = [] if order.coefficient is None else [_coefficient(order)]
    factors += [
        letter for size, letter in (("masses", MASS), ("radii", RADIUS)) if size not in order.sizes
    ]
    return Product((*factors, OMEGA**2)) if factors else OMEGA**2


def _coefficient(order: SymbolicOrder) -> Name:
    return Name(f"A_{order.order}")


def _plane(order: SymbolicOrder) -> tuple[Inline, ...]:
    """Return what couples are taken about, a station with symbols as a formula."""
    if getattr(order.reference, "free_symbols", None):
        return "station ", formula_of(order.reference)
    return (plane(order.reference),)


def _formulas(order: SymbolicOrder, title: Any, resultant: SymbolResultant) -> tuple[Block, ...]:
    equations = [
        Equation(Upright(name) * Name(letter), (("=", _formula(value, order.all_symbols)),))
        for name in ("vertical", "lateral")
        for letter, value in (("C", resultant.component(name).cos), ("S", resultant.component(name).sin))
        if value != 0
    ]
    body = Formulas(tuple(equations)) if equations else Paragraph("none: it vanishes for all values")
    return Heading(title), body


def _formula(value: sympy.Expr, symbols: tuple[Any, ...]) -> Formula:
    """Return a sum over monomials in the symbols given, each with its exact coefficient before it."""
    coefficients: dict[Any, Any] = {}
    for term in sympy.Add.make_args(value):
        coefficient, monomial = term.as_independent(*symbols, as_Add=False)
        coefficients[monomial] = coefficients.get(monomial, 0) + coefficient
    place = {symbol: i for i, symbol in enumerate(symbols)}
    powers = {monomial: _powers(monomial, place) for monomial in coefficients}
    ranked = sorted(coefficients, key=lambda monomial: _rank(powers[monomial]))
    terms = tuple(_term(coefficients[monomial], powers[monomial]) for monomial in ranked)
    return terms[0] if len(terms) == 1 else Sum(terms)


Powers = list[tuple[int, Any, int]]
"""Of a monomial: each symbol's place among those given, the symbol and its exponent."""


def _powers(monomial: Any, place: dict[Any, int]) -> Powers:
    factors = monomial.as_powers_dict().items()
    return sorted((place[symbol], symbol, int(power)) for symbol, power in factors if symbol in place)


def _rank(powers: Powers) -> tuple[list[int], int, list[tuple[int, int]]]:
    """Rank terms by the cylinders that they are of, then by degree, then by their symbols."""
    cylinders = sorted({int(end[0]) for _, s, _ in powers if (end := re.findall(r"\d+$", str(s)))})
    return cylinders, sum(abs(power) for *_, power in powers), [(i, -power) for i, _, power in powers]


def _term(coefficient: Any, powers: Powers) -> Formula:
    """Return coefficient times monomial as one fraction, with its sign."""
    value = formula_of(coefficient)
    sign, size = (-1, value.operand) if isinstance(value, Negative) else (1, value)
    over, under = (size.numerator, size.denominator) if isinstance(size, Quotient) else (size, number(1))
    above = [over, *(_power(symbol, power) for _, symbol, power in powers if power > 0)]
    below = [under, *(_power(symbol, -power) for _, symbol, power in powers if power < 0)]
    top, bottom = _product(above), _product(below)
    return signed(sign, top if bottom == number(1) else Quotient(top, bottom))


def _letter(symbol: Any) -> Name:
    return Name(str(symbol))


def _power(symbol: Any, exponent: int) -> Formula:
    base = _letter(symbol)
    return base if exponent == 1 else Power(base, number(exponent))


def _product(factors: list[Formula]) -> Formula:
    flat = [part for each in factors for part in (each.factors if isinstance(each, Product) else (each,))]
    other = [part for part in flat if not (isinstance(part, Number) and part.value == 1)]
    if not other:
        return number(1)
    return other[0] if len(other) == 1 else Product(tuple(other))


def _legend(order: SymbolicOrder) -> Block:
    angle = _THETA if order.order == 1 else order.order * _THETA
    wave = Name("C") * cos(angle) + Name("S") * sin(angle)
    entries: list[Entry] = [("a component", wave), ("what is not listed", "vanishes for all values")]
    if order.coefficient is not None:
        series = series_formula(order.coefficient, ellipsis=True)
        entries.append((equal(_coefficient(order), series), "of one cylinder, λ = l/r its rod ratio"))
    if order.through is not None:
        parts = (_R / _L, " and ", _E / _L)
        entries.append(("kept through", (f"the total power {order.through} of ", *parts)))
    if order.values:
        pairs = [(", ", equal(_letter(symbol), number(value))) for symbol, value in order.values]
        entries.append(("put in", tuple(part for pair in pairs for part in pair)[1:]))
    entries += [(letter, meaning) for size, letter, meaning in _UNITS if size not in order.sizes]
    if "masses" not in order.sizes and len({c.reciprocating_mass for c in order.engine.cylinders}) > 1:
        entries.append(("masses", f"of the others over that of cylinder {order.engine.first.number}, m"))
    if order.sizes:
        entries.append(("units", f"besides, those in which {' and '.join(order.sizes)} are given"))
    return Facts((*entries, *origin_facts(order.engine), SIGNS), "How to read it")


_UNITS = (
    ("masses", MASS, "reciprocating mass of one cylinder"),
    ("radii", RADIUS, "crank radius"),
    ("stations", PITCH, "cylinder pitch"),
)
"""Sizes, and the units that their sums are in where they are not given."""
