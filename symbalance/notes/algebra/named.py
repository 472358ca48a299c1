"""Functions of forms by the names that formulas give them."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from symbalance.notes.algebra import functions
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.roots import root


def apply(function: str, argument: Form) -> Form:
    """Return a function of a form; what has no rule raises NoFormError.

    >>> from symbalance.notes.algebra.domain import Domain
    >>> third = Form.letter(Domain(), "pi").scaled(Fraction(1, 3))
    >>> apply("cos", third).rational()
    """
    if function in _CIRCULAR:
        return _CIRCULAR[function](argument)
    if function in ("asin", "acos", "atan"):
        return functions.opaque(function, argument)
    raise NoFormError(f"the function {function}")


def logarithm(base: Form) -> Form:
    """Return ln base; ln e is 1."""
    if base.equals(Form.letter(base.domain, "e")):
        return Form.number(base.domain, 1)
    if base.rational() == 1:
        return Form.number(base.domain, 0)
    return functions.opaque("ln", base)


def _over(first: Callable[[Form], Form], second: Callable[[Form], Form]) -> Callable[[Form], Form]:
    return lambda x: first(x).over(second(x))


def _one(argument: Form) -> Form:
    return Form.number(argument.domain, 1)


def _growing(sign: int) -> Callable[[Form], Form]:
    def function(x: Form) -> Form:
        back = functions.exponential(x.scaled(-1)).scaled(sign)
        return functions.exponential(x).plus(back).scaled(Fraction(1, 2))

    return function


_CIRCULAR: dict[str, Callable[[Form], Form]] = {
    "sin": functions.sine,
    "cos": functions.cosine,
    "tan": _over(functions.sine, functions.cosine),
    "cot": _over(functions.cosine, functions.sine),
    "sec": _over(_one, functions.cosine),
    "csc": _over(_one, functions.sine),
    "sinh": _growing(-1),
    "cosh": _growing(1),
    "tanh": _over(_growing(-1), _growing(1)),
    "exp": functions.exponential,
    "ln": logarithm,
    "log": logarithm,
    "sqrt": root,
    "abs": lambda x: root(x.times(x)),
}
