"""Exact numbers written as formulas: rationals, roots, and sums of them."""

from __future__ import annotations

from fractions import Fraction

from symbalance.document import formula
from symbalance.notes.algebra import polynomials as poly
from symbalance.notes.algebra.domain import ONE, QUARTER, TURN, Domain, Polynomial
from symbalance.notes.algebra.roots import root_of_rational
from symbalance.notes.algebra.values import Valuation, context
from symbalance.notes.algebra.zero import is_zero

_ROOTS = (1, 2, 3, 5, 6, 7, 10, 11, 13, 14, 15)
_LARGEST_DENOMINATOR = 10**7  # of a guess, which is proved before it is used


def number_node(domain: Domain, number: Polynomial) -> formula.Formula:
    """Return a number made of turns and roots as a formula: q√d where it is one, else a sum."""
    if poly.is_rational(number):
        return rational_node(number.get(ONE, Fraction(0)))
    imaginary = _imaginary(domain, number)
    if is_zero(domain, imaginary) is False:
        unit, rest = formula.Constant("i"), poly.minus(number, _times_i(domain, imaginary))
        along = formula.Product((number_node(domain, imaginary), unit))
        return along if is_zero(domain, rest) else formula.Sum((number_node(domain, rest), along))
    simple = as_root(domain, number)
    if simple is not None:
        return _root_node(*simple)
    return _sum_node(domain, number)


def _imaginary(domain: Domain, number: Polynomial) -> Polynomial:
    """Return the imaginary part, (z - conj z)/(2i), as a polynomial in turns and primes."""
    conjugate: Polynomial = {}
    for monomial, coefficient in number.items():
        reflection = tuple((g, -e) if g == TURN else (g, e) for g, e in monomial)
        factor, image = domain.raised(reflection, 1)
        conjugate = poly.plus(conjugate, {image: coefficient * factor})
    difference = poly.scale(poly.minus(number, conjugate), Fraction(-1, 2))
    return _times_i(domain, difference)


def _times_i(domain: Domain, number: Polynomial) -> Polynomial:
    return poly.times(domain, number, {((TURN, QUARTER),): Fraction(1)})


def as_root(domain: Domain, number: Polynomial) -> tuple[Fraction, int] | None:
    """Return (q, d) with number = q√d, proved, or None."""
    value = Valuation(domain, {}).polynomial(number)
    if abs(value.imag) > context().mpf(10) ** -20:
        return None
    for square in _ROOTS:
        guess = _nearby(value.real / context().sqrt(square))
        if guess is not None:
            candidate = root_of_rational(domain, Fraction(square)).scaled(guess).numerator
            if is_zero(domain, poly.minus(number, candidate)) is True:
                return guess, square
    return None


def _nearby(value: object) -> Fraction | None:
    """Return the rational of moderate denominator that a 40-digit number is, if it is one."""
    exact = Fraction(str(value)) if value else Fraction(0)
    guess = exact.limit_denominator(_LARGEST_DENOMINATOR)
    return guess if abs(guess - exact) < Fraction(1, 10**25) else None


def _root_node(factor: Fraction, square: int) -> formula.Formula:
    if square == 1:
        return rational_node(factor)
    if factor < 0:
        return formula.Negative(_root_node(-factor, square))
    root: formula.Formula = formula.Call("sqrt", formula.Number(Fraction(square)))
    if factor.numerator != 1:
        root = formula.Product((formula.Number(Fraction(factor.numerator)), root))
    if factor.denominator == 1:
        return root
    return formula.Quotient(root, formula.Number(Fraction(factor.denominator)))


def rational_node(value: Fraction) -> formula.Formula:
    """Return a rational as a formula, its sign outside."""
    if value < 0:
        return formula.Negative(rational_node(-value))
    above = formula.Number(Fraction(value.numerator))
    if value.denominator == 1:
        return above
    return formula.Quotient(above, formula.Number(Fraction(value.denominator)))


def rational_of(node: formula.Formula) -> Fraction | None:
    """Return the value of a number or of a quotient of two, None of anything else."""
    if isinstance(node, formula.Number):
        return node.value
    if isinstance(node, formula.Quotient):
        above, below = rational_of(node.numerator), rational_of(node.denominator)
        return above / below if above is not None and below else None
    if isinstance(node, formula.Negative):
        inner = rational_of(node.operand)
        return None if inner is None else -inner
    return None


def _sum_node(domain: Domain, number: Polynomial) -> formula.Formula:
    """Return the real number as a sum of cosines of its turns times roots of primes."""
    terms: list[formula.Formula] = []
    for monomial, coefficient in number.items():
        turn = next((e for g, e in monomial if g == 0), Fraction(0))
        factors: list[formula.Formula] = (
            [] if abs(coefficient) == 1 else [rational_node(abs(coefficient))]
        )
        for g, e in monomial:
            if g:
                prime = formula.Number(Fraction(domain.generators[g].content))
                root = formula.Call("sqrt", prime)
                factors.append(
                    root if e == Fraction(1, 2) else formula.Power(prime, rational_node(Fraction(e)))
                )
        if turn:
            angle = formula.Product((rational_node(Fraction(turn) * 2), formula.Constant("pi")))
            factors.append(formula.Call("cos", angle))
        factors = factors or [formula.Number(Fraction(1))]
        term = factors[0] if len(factors) == 1 else formula.Product(tuple(factors))
        terms.append(formula.Negative(term) if coefficient < 0 else term)
    return terms[0] if len(terms) == 1 else formula.Sum(tuple(terms))
