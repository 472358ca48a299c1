"""One entry a cylinder, as people give it: a letter, or a list of numbers and polynomials."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from symbalance.engine.engine import Engine
from symbalance.errors import SymbalanceError, shown
from symbalance.exact.symbolic_polynomials import Polynomial, polynomial
from symbalance.text.numbers import listed

LONGEST_PREFIX = 20


def entries(layout: Engine, given: object, name: str) -> list[Polynomial] | None:
    """Return one polynomial a cylinder, None where nothing is given."""
    if given is None:
        return None
    count = len(layout.cylinders)
    if isinstance(given, str):
        import sympy

        if not given.isidentifier() or len(given) > LONGEST_PREFIX:
            raise SymbalanceError(f"{name} = {shown(given)}", "must be a letter or a list", 'write "m"')
        return [
            {((sympy.Symbol(f"{given}_{c.number}", real=True), 1),): Fraction(1)}
            for c in layout.cylinders
        ]
    values = listed(given, name, "[m1, m2, 0.6]")
    if len(values) != count:
        what = f"{name} holds {len(values)} values"
        raise SymbalanceError(what, f"the engine has {count} cylinders", "give one for each")
    return [polynomial(value, f"{name}[{i}]") for i, value in enumerate(values)]


def symbols_in(given: Sequence[Polynomial] | None) -> list[Any]:
    """Return the symbols of some polynomials, each once, in their order."""
    return list(
        dict.fromkeys(symbol for one in given or () for monomial in one for symbol, _ in monomial)
    )
