"""Coefficients of cos nθ, sin nθ and products of letters in a polynomial, and formulas from them.

C cos x + S sin x = c_+ e^(ix) + c_- e^(-ix) with C = c_+ + c_- and S = i (c_+ - c_-). The numbers C and S
are polynomials in turns and primes only.
"""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass
from fractions import Fraction

from symbalance.document import formula
from symbalance.notes.algebra import polynomials as poly
from symbalance.notes.algebra.domain import QUARTER, TURN, Domain, Monomial, Polynomial
from symbalance.notes.algebra.number_formulas import number_node, rational_node
from symbalance.notes.algebra.zero import is_zero


@dataclass(frozen=True, slots=True)
class HarmonicKey:
    """The harmonic a number belongs to: `function` of an angle, times a product of letters."""

    function: str
    angle: Monomial
    letters: Monomial


Components = dict[HarmonicKey, Polynomial]


def components(domain: Domain, polynomial: Polynomial) -> Components:
    """Return the numbers of a polynomial by their harmonics; those that are zero are left out."""
    pairs: dict[tuple[Monomial, Monomial], list[Polynomial]] = defaultdict(lambda: [{}, {}])
    for monomial, coefficient in polynomial.items():
        number, angle, letters = split(domain, monomial)
        backward = bool(angle) and angle[0][1] < 0
        if backward:
            angle = tuple((g, -e) for g, e in angle)
        pair = pairs[angle, letters]
        pair[backward] = poly.plus(pair[backward], {number: coefficient})
    result: Components = {}
    for (angle, letters), (ahead, back) in pairs.items():
        parts = {"cos": poly.plus(ahead, back), "sin": _times_i(domain, poly.minus(ahead, back))}
        if not angle:
            parts = {"1": ahead}
        for function, number in parts.items():
            if is_zero(domain, number) is not True:
                result[HarmonicKey(function, angle, letters)] = number
    return result


def split(domain: Domain, monomial: Monomial) -> tuple[Monomial, Monomial, Monomial]:
    """Return a monomial's number, its angles and its letters."""
    number, angle, letters = [], [], []
    for entry in monomial:
        kind = domain.generators[entry[0]].kind
        if kind in ("turn", "prime"):
            number.append(entry)
        else:
            (angle if kind == "exponential" else letters).append(entry)
    return tuple(number), tuple(angle), tuple(letters)


def _times_i(domain: Domain, polynomial: Polynomial) -> Polynomial:
    return poly.times(domain, polynomial, {((TURN, QUARTER),): Fraction(1)})


def key_node(domain: Domain, key: HarmonicKey) -> formula.Formula | None:
    """Return the product of letters and the function of the angle; None for the constant."""
    factors = letter_nodes(domain, key.letters)
    if key.function != "1":
        factors.append(formula.Call(key.function, angle_node(domain, key.angle)))
    return _product(factors)


def angle_node(domain: Domain, angle: Monomial) -> formula.Formula:
    """Return the argument an angle stands for: 2θ for the square of e^(iθ)."""
    terms: list[formula.Formula] = []
    for number, exponent in angle:
        inner = letter_nodes(domain, domain.generators[number].content)
        term = _product(
            [*([] if abs(exponent) == 1 else [rational_node(Fraction(abs(exponent)))]), *inner]
        )
        term = term or rational_node(Fraction(1))  # an angle of 1 rad
        terms.append(formula.Negative(term) if exponent < 0 else term)
    return terms[0] if len(terms) == 1 else formula.Sum(tuple(terms))


def letter_nodes(domain: Domain, letters: Monomial) -> list[formula.Formula]:
    """Return the factors of a product of letters, roots and functions, negative powers as a quotient."""
    above = [_power(domain, g, e) for g, e in letters if e > 0]
    below = [_power(domain, g, -e) for g, e in letters if e < 0]
    if not below:
        return above
    return [formula.Quotient(_product(above) or rational_node(Fraction(1)), _product(below))]  # type: ignore[arg-type]


def _power(domain: Domain, number: int, exponent: int | Fraction) -> formula.Formula:
    """Return a power of one generator as a formula."""
    generator = domain.generators[number]
    base: formula.Formula
    if generator.kind == "symbol":
        base = formula.Name(generator.content)
    elif generator.kind == "constant":
        base = formula.Constant(generator.content)
    elif generator.kind == "radical":
        base = formula.Call("sqrt", polynomial_node(domain, generator.content))
    elif generator.kind == "prime":
        base = rational_node(Fraction(generator.content))
    elif generator.kind == "exponential":
        inner = [rational_node(Fraction(exponent)), *letter_nodes(domain, generator.content)]
        return formula.Call("exp", _product([formula.Constant("i"), *inner]))  # type: ignore[arg-type]
    elif generator.kind == "growth":
        inner = _product([rational_node(Fraction(exponent)), *letter_nodes(domain, generator.content)])
        return formula.Call("exp", inner)  # type: ignore[arg-type]
    else:
        function, argument = generator.content
        inside = polynomial_node(domain, argument.numerator)
        if not argument.is_polynomial:
            inside = formula.Quotient(inside, polynomial_node(domain, argument.denominator))
        base = _function_node(function, inside)
    return base if exponent == 1 else formula.Power(base, rational_node(Fraction(exponent)))


def _function_node(function: str, inside: formula.Formula) -> formula.Formula:
    if function == "sum":
        return formula.Summation(inside)
    if function == "over":
        return formula.Quotient(rational_node(Fraction(1)), inside)
    if function in ("factorial", "mean"):
        return formula.Apply(function, (inside,))
    if function.startswith("besselj"):
        return formula.Apply("besselj", (rational_node(Fraction(function[-1])), inside))
    return formula.Call(function, inside)


def polynomial_node(domain: Domain, polynomial: Polynomial) -> formula.Formula:
    """Return a polynomial as a sum over its harmonics, the lowest first."""
    numbers = components(domain, polynomial)
    terms = [term_node(domain, key, numbers[key]) for key in sort_keys(numbers)]
    if not terms:
        return rational_node(Fraction(0))
    return terms[0] if len(terms) == 1 else formula.Sum(tuple(terms))


def sort_keys(numbers: Components) -> list[HarmonicKey]:
    """Return the keys by harmonic, then by letters."""
    return sorted(
        numbers,
        key=lambda p: ([abs(e) for _, e in p.angle], p.function, [(g, abs(e)) for g, e in p.letters]),
    )


def term_node(domain: Domain, key: HarmonicKey, number: Polynomial) -> formula.Formula:
    """Return number times harmonic, the sign outside and whole denominators below."""
    coefficient, rest = number_node(domain, number), key_node(domain, key)
    if rest is None:
        return coefficient
    if isinstance(coefficient, formula.Negative):
        return formula.Negative(times_coefficient(coefficient.operand, rest))
    return times_coefficient(coefficient, rest)


def times_coefficient(coefficient: formula.Formula, rest: formula.Formula) -> formula.Formula:
    """Return coefficient times rest as it would be written by hand.

    >>> times_coefficient(formula.Number(Fraction(1)), formula.Name("s")).name
    's'
    """
    if coefficient == formula.Number(Fraction(1)):
        return rest
    top, bottom = _numerator_and_denominator(coefficient)
    factors = rest.factors if isinstance(rest, formula.Product) else (rest,)
    first = factors[0]
    if isinstance(first, formula.Quotient):
        above, below = _numerator_and_denominator(first)
        head = formula.Quotient(_times(top, above), _times(bottom, below))
        return _product([head, *factors[1:]])  # type: ignore[return-value]
    return _product([coefficient, *factors])  # type: ignore[return-value]


def _numerator_and_denominator(node: formula.Formula) -> tuple[formula.Formula, formula.Formula]:
    if isinstance(node, formula.Quotient):
        return node.numerator, node.denominator
    return node, rational_node(Fraction(1))


def _times(left: formula.Formula, right: formula.Formula) -> formula.Formula:
    one = rational_node(Fraction(1))
    parts = [
        p
        for node in (left, right)
        for p in (node.factors if isinstance(node, formula.Product) else (node,))
    ]
    return _product([p for p in parts if p != one]) or one


def _product(factors: list[formula.Formula]) -> formula.Formula | None:
    if not factors:
        return None
    return factors[0] if len(factors) == 1 else formula.Product(tuple(factors))
