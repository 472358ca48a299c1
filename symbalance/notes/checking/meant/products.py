"""Formulas that are one product: a number, powers of letters, and at most one cosine or sine."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from math import isclose, isfinite

from symbalance.document.formula import (
    Call,
    Constant,
    Formula,
    Name,
    Negative,
    Power,
    Product,
    Quotient,
    Sum,
    names,
)
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.algebra.tree_values import NO_VALUE, TreeValues
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.rounding import decimals

_WAVES = ("cos", "sin")
_SAME = 1e-9
_SIZES = frozenset({"omega", "Omega", "w", "r", "R", "l", "L", "ell", "m", "M"})
"""Letters that stay where products are written out, ω though it is 2πn/60."""
_DEPTH = 3
"""How many definitions deep letters are written out."""


class NoProductError(Exception):
    """A formula is not one product."""


@dataclass(frozen=True, slots=True)
class ProductOfPowers:
    """A formula as a number, powers of letters, and a wave where it has one."""

    number: float
    powers: Mapping[str, Fraction] = field(default_factory=dict)
    wave: Call | None = None
    rounding: float = _SAME
    """By what part of itself the number may be off, as printed."""

    def __post_init__(self) -> None:
        """Refuse a number beyond what a float holds, 1e400: nothing is compared with it."""
        if not isfinite(self.number):
            raise NoProductError

    def times(self, other: ProductOfPowers, exponent: Fraction = Fraction(1)) -> ProductOfPowers:
        """Return this times a power of another product."""
        powers = dict(self.powers)
        for name, power in other.powers.items():
            powers[name] = powers.get(name, Fraction(0)) + power * exponent
        if other.wave is not None and (self.wave is not None or exponent != 1):
            raise NoProductError
        if other.number < 0 and exponent.denominator > 1:
            raise NoProductError
        if not other.number and exponent < 0:
            raise NoProductError
        try:
            raised = other.number ** (float(exponent) if exponent.denominator > 1 else exponent.numerator)
        except OverflowError as problem:
            raise NoProductError from problem
        return ProductOfPowers(
            self.number * raised,
            {name: power for name, power in powers.items() if power},
            self.wave or other.wave,
            max(self.rounding, other.rounding),
        )


_ONE = ProductOfPowers(1.0)


def product_of(node: Formula) -> ProductOfPowers:
    """Return a formula as one product; sums are added up where all their terms have the same letters."""
    if not names(node):
        return _number(node)
    product: ProductOfPowers | None = None
    match node:
        case Name(name=name):
            product = ProductOfPowers(1.0, {name: Fraction(1)})
        case Negative(operand=operand):
            product = product_of(operand).times(ProductOfPowers(-1.0))
        case Product(factors=factors):
            product = _ONE
            for factor in factors:
                product = product.times(product_of(factor))
        case Quotient(numerator=above, denominator=below):
            product = product_of(above).times(product_of(below), Fraction(-1))
        case Power(base=base, exponent=exponent):
            product = _ONE.times(product_of(base), _exponent(exponent))
        case Call(function="sqrt", argument=argument):
            product = _ONE.times(product_of(argument), Fraction(1, 2))
        case Call(function=function) if function in _WAVES:
            product = ProductOfPowers(1.0, {}, node)
        case Sum(terms=terms):
            product = _added([product_of(term) for term in terms])
    if product is None:
        raise NoProductError
    return product


def terms_of(node: Formula) -> tuple[Formula, ...]:
    """Return the terms of a sum, and of a product with one sum each of its terms times the rest.

    >>> a, b, c = Name("a"), Name("b"), Name("c")
    >>> terms_of(a * (b + c)) == (a * b, a * c)
    True
    """
    if isinstance(node, Sum):
        return tuple(part for term in node.terms for part in terms_of(term))
    if isinstance(node, Negative):
        return tuple(Negative(part) for part in terms_of(node.operand))
    if not isinstance(node, Product):
        return (node,)
    sums = [factor for factor in node.factors if isinstance(factor, Sum) and names(factor)]
    if len(sums) != 1:
        return (node,)
    rest = tuple(factor for factor in node.factors if factor is not sums[0])
    return tuple(Product((*rest, term)) for term in sums[0].terms)


def written_out(product: ProductOfPowers, knowledge: Knowledge) -> ProductOfPowers:
    """Return a product with what the page defines as products of letters put in: K of K = m r ω².

    >>> from symbalance.notes.checking.deciding.knowledge import Definition
    >>> known = Knowledge().with_definition("K", Definition(2 * Name("m") * Name("r"), 1))
    >>> written_out(product_of(Name("K") * Name("a")), known).number
    2.0
    """
    for _ in range(_DEPTH):
        for name in [*product.powers]:
            definition = knowledge.definitions.get(name)
            is_size = name.partition("_")[0] in _SIZES
            if is_size or definition is None or definition.numeric or not names(definition.node):
                continue
            try:
                value = product_of(definition.node)
                if value.wave is None and name not in value.powers:
                    rest = {n: p for n, p in product.powers.items() if n != name}
                    rest_of_it = ProductOfPowers(product.number, rest, product.wave, product.rounding)
                    product = rest_of_it.times(value, product.powers[name])
            except NoProductError:
                continue
    return product


def _number(node: Formula) -> ProductOfPowers:
    try:
        value = TreeValues(SymbolValue(), {}).value(node)
    except NO_VALUE as problem:
        raise NoProductError from problem
    if abs(value.imag) > _SAME * abs(value):
        raise NoProductError
    rounding = _SAME
    for number in decimals(node):
        if number.value and number.last_place:
            rounding = max(rounding, 0.6 * abs(float(number.last_place / number.value)))
    return ProductOfPowers(float(value.real), {}, None, rounding)


def _exponent(node: Formula) -> Fraction:
    if isinstance(node, Constant) or names(node):
        raise NoProductError
    value = _number(node).number
    near = Fraction(value).limit_denominator(12)
    if not isclose(near, value, rel_tol=_SAME):
        raise NoProductError
    return near


def _added(products: list[ProductOfPowers]) -> ProductOfPowers:
    first = products[0]
    if any(each.powers != first.powers or each.wave != first.wave for each in products[1:]):
        raise NoProductError
    number = sum(each.number for each in products)
    rounding = max(each.rounding for each in products)
    return ProductOfPowers(number, first.powers, first.wave, rounding)
