"""The value of a number as the program writes it: `6*sqrt(3)`, `pi/4 - atan2(1, 3)`, `7.4e-5`.

The strings of a record may come from hostile documents, so nothing is evaluated by Python: a string
is parsed, and only arithmetic and the functions below have a value, computed with mpmath.
"""

from __future__ import annotations

import ast
import warnings
from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

import mpmath

DIGITS = 60
LONGEST = 50_000
LARGEST_EXPONENT = 100_000
"""Towers of powers would otherwise take all memory; no result comes near."""
SAME = mpmath.mpf(10) ** -30
NOTHING = mpmath.mpf(10) ** -45
"""A sum of terms near 1 that is below this is the rounding of a zero at 60 digits."""
LETTERS = {
    "lam": ("3.7", "4.21", "17/8"),
    "rho": ("0.27", "0.31", "0.44"),
    "lambda": ("3.7", "4.21", "17/8"),
}
"""Values that formulas in a letter are compared at: two that agree at all are taken as one."""
NAMES = {"pi": lambda c: +c.pi, "E": lambda c: +c.e, "I": lambda c: c.mpc(0, 1)}
FUNCTIONS = {
    "sqrt": "sqrt",
    "cos": "cos",
    "sin": "sin",
    "tan": "tan",
    "acos": "acos",
    "asin": "asin",
    "atan": "atan",
    "atan2": "atan2",
    "exp": "exp",
    "log": "log",
    "Abs": "fabs",
    "hyp2f1": "hyp2f1",
}

Values = tuple[Any, ...]


def values(text: str) -> Values | None:
    """Return the values of a number or formula, one for each trial value of its letters; None for words.

    >>> values("in-line four") is None
    True
    >>> mpmath.nstr(values("sqrt(50)")[0], 6)
    '7.07107'
    """
    if len(text) > LONGEST or not any(c.isdigit() or c == "p" for c in text):
        return None
    tree = _parsed(text.strip())
    if tree is None:
        return None
    context = mpmath.MPContext()
    context.dps = DIGITS
    try:
        return tuple(_value(tree, text.strip(), context, number) for number in range(3))
    except (_NoNumberError, ArithmeticError, ValueError, RecursionError, TypeError):
        return None


def relative_difference(old: Values, new: Values) -> Any:
    """Return the largest difference in parts of the larger value, 0 where both are the rounding of zero.

    >>> float(relative_difference(values("2*sqrt(2)"), values("sqrt(8)")))
    0.0
    """
    worst = mpmath.mpf(0)
    for a, b in zip(old, new, strict=True):
        scale = max(abs(a), abs(b))
        if scale > NOTHING and abs(a - b) > SAME * scale:
            worst = max(worst, abs(a - b) / scale)
    return worst


def is_opposite(old: Values, new: Values) -> bool:
    """Return whether one is minus the other."""
    return relative_difference(old, tuple(-b for b in new)) == 0


class _NoNumberError(Exception):
    """The string holds something that is no arithmetic."""


def _parsed(text: str) -> ast.expr | None:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # "'int' object is not callable", of 2(x)
        try:
            return ast.parse(text, mode="eval").body
        except (SyntaxError, ValueError, RecursionError, MemoryError):
            return None


def _value(node: ast.expr, text: str, context: Any, number: int) -> Any:
    """Return the value of a node, the letters at their `number`-th trial value."""

    def of(child: ast.expr) -> Any:
        return _value(child, text, context, number)

    match node:
        case ast.Constant(value=bool()) | ast.Constant(value=complex()):
            raise _NoNumberError
        case ast.Constant(value=int() | float()):
            # The parser has rounded a float to a double: the digits as they are written count.
            return context.mpf(ast.get_source_segment(text, node))
        case ast.Name(id=name) if name in NAMES:
            return NAMES[name](context)
        case ast.Name(id=name) if name in LETTERS:
            trial = Fraction(LETTERS[name][number])
            return context.mpf(trial.numerator) / trial.denominator
        case ast.UnaryOp(op=ast.USub(), operand=inner):
            return -of(inner)
        case ast.UnaryOp(op=ast.UAdd(), operand=inner):
            return of(inner)
        case ast.BinOp(left=left, op=operator, right=right):
            return _combined(of(left), operator, of(right), context)
        case ast.Call(func=ast.Name(id=name), args=arguments, keywords=[]) if name in FUNCTIONS:
            return _called(getattr(context, FUNCTIONS[name]), [of(a) for a in arguments], context)
        case _:
            raise _NoNumberError


def _combined(left: Any, operator: ast.operator, right: Any, context: Any) -> Any:
    match operator:
        case ast.Add():
            return left + right
        case ast.Sub():
            return left - right
        case ast.Mult():
            return left * right
        case ast.Div():
            return left / right
        case ast.Pow():
            _refuse_large(right)
            if left and abs(context.log(abs(left))) * abs(right) > LARGEST_EXPONENT:
                raise _NoNumberError
            return context.power(left, right)
        case _:
            raise _NoNumberError


def _called(function: Callable[..., Any], arguments: Sequence[Any], context: Any) -> Any:
    for argument in arguments:
        _refuse_large(argument)
    return function(*arguments)


def _refuse_large(value: Any) -> None:
    if abs(value) > LARGEST_EXPONENT:
        raise _NoNumberError
