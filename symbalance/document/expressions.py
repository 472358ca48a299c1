"""SymPy expressions as formulas: exact numbers as handbooks write them.

A sum over a common denominator is one fraction, and products stand as in 6√3, √((25 − 11√5)/2),
3 cos(π/7). Phases and orders stay as they are: SymPy's own printers would turn a cosine into a sine, or a
short fraction into an ambiguous one.
"""

from __future__ import annotations

from functools import lru_cache
from math import lcm
from typing import Any

import sympy

from symbalance.document.formula import (
    Apply,
    Call,
    Constant,
    Decimal,
    Formula,
    Matrix,
    Name,
    Power,
    Product,
    Quotient,
    Sum,
    number,
    signed,
)
from symbalance.errors import SymbalanceError, brief


def formula_of(expression: Any) -> Formula:
    """Return a SymPy expression as a formula, its factors and terms in the order of handbooks.

    Sums of rational multiples stand over their common denominator; a power with a negative exponent goes
    below the bar. Functions that formulas do not know keep SymPy's name; anything else, such as an
    integral, is refused.

    >>> formula_of(sympy.sqrt(3) * 6) == number(6) * Call("sqrt", number(3))
    True
    >>> formula_of(sympy.Rational(1, 2) - sympy.sqrt(5) / 2) == (1 - Call("sqrt", number(5))) / number(2)
    True
    >>> from symbalance.document.text_writer import formula_text
    >>> formula_text(formula_of(sympy.sqrt(sympy.Rational(25, 2) - 11 * sympy.sqrt(5) / 2)))
    '√((25 − 11√5)/2)'
    """
    if isinstance(expression, sympy.MatrixBase):
        return Matrix(tuple(tuple(map(formula_of, row)) for row in expression.tolist()))
    if expression.is_Add:
        return _sum(expression)
    return signed(*_signed(expression))


_Part = tuple[Any, Any]
"""A term's rational factor, and the rest of it."""


def _part(expression: Any) -> _Part:
    if expression.is_Add:  # the content of a sum stays inside it
        return sympy.S.One, expression
    return expression.as_coeff_Mul(rational=True)


def _signed(expression: Any) -> tuple[int, Formula]:
    """Return the sign of an expression and the rest of it."""
    factor, rest = _part(expression)
    return _scaled(factor.p, factor.q, rest)


def _scaled(above: int, below: int, rest: Any) -> tuple[int, Formula]:
    """Return the sign and the size of above/below times `rest`."""
    sign, above = (-1, -above) if above < 0 else (1, above)
    if rest is sympy.S.One:
        top: Formula = number(above)
        return sign, top if below == 1 else Quotient(top, number(below))
    over, under = _factors(rest)
    if above != 1 or not over:
        over = (number(above), *over)
    if below != 1:
        under = (number(below), *under)
    top = over[0] if len(over) == 1 else Product(over)
    if not under:
        return sign, top
    return sign, Quotient(top, under[0] if len(under) == 1 else Product(under))


def _sum(expression: Any) -> Formula:
    """Return a sum over the common denominator of its terms' rational factors."""
    parts = [_part(term) for term in expression.args]
    common = lcm(*(factor.q for factor, _ in parts))
    terms = _added(
        [(f.p * (common // f.q), 1, rest) for f, rest in sorted(parts, key=_rank)],
    )
    return terms if common == 1 else Quotient(terms, number(common))


def _added(terms: list[tuple[int, int, Any]]) -> Formula:
    printed = tuple(signed(*_scaled(*term)) for term in terms)
    return printed[0] if len(printed) == 1 else Sum(printed)


def _rank(part: _Part) -> tuple[bool, bool, str]:
    """Rationals first, and where there is none a positive term first."""
    factor, rest = part
    return (rest is not sympy.S.One, factor.p < 0, _spelling(rest))


@lru_cache(maxsize=4096)
def _spelling(expression: Any) -> str:
    """Return what terms of one sign are ordered by: SymPy's spelling takes long."""
    return str(expression)


def _factors(expression: Any) -> tuple[tuple[Formula, ...], tuple[Formula, ...]]:
    """Return the factors above and below the bar of a product without a rational factor."""
    over, under = [], []
    factors: tuple[Any, ...] = sympy.Mul.make_args(expression)
    for factor in factors:
        below = factor.is_Pow and factor.exp.is_Rational and factor.exp.is_negative
        (under if below else over).append(_factor(1 / factor if below else factor))
    return tuple(over), tuple(under)


def _factor(expression: Any) -> Formula:
    if expression.is_Add:
        return _sum(expression)
    if expression.is_Pow:
        return _power(expression)
    if expression.is_Function:
        return _applied(expression)
    if expression.is_Symbol:
        return Name(expression.name)
    if expression in _CONSTANTS:
        return Constant(_CONSTANTS[expression])
    if expression.is_Float:
        return Decimal(str(expression))
    raise SymbalanceError(
        brief(str(expression)), "is no formula of ours", "write it with functions and powers"
    )


def _power(expression: Any) -> Formula:
    if expression.exp == sympy.S.Half:
        return Call("sqrt", formula_of(expression.base))
    return Power(formula_of(expression.base), formula_of(expression.exp))


def _applied(expression: Any) -> Formula:
    name = type(expression).__name__
    arguments = tuple(formula_of(argument) for argument in expression.args)
    if name in _CALLS and len(arguments) == 1:
        return Call(_CALLS[name], arguments[0])
    return Apply(name, arguments)


_CONSTANTS = {
    sympy.pi: "pi",
    sympy.E: "e",
    sympy.I: "i",
    sympy.oo: "infinity",
}
_CALLS = {
    **{name: name for name in ("sin", "cos", "tan", "cot", "sec", "csc", "asin", "acos", "atan")},
    **{name: name for name in ("sinh", "cosh", "tanh", "exp")},
    **{"log": "ln", "Abs": "abs"},
}
