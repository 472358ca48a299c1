"""By which power of a letter a quantity goes: F = m r ω² with the square of ω, δ = W/(J ω²) as 1/J.

The formulas that the page gives the letters of a formula are gone through as deep as they lead. Where a
letter has two formulas of two powers, or a formula is no product of powers, nothing is said.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from fractions import Fraction

from symbalance.document.formula import (
    Call,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    names,
)
from symbalance.notes.checking.words.sections import Sections

_DEEPEST = 6
"""Formulas behind formulas that are gone through."""


@dataclass(frozen=True)
class PowersOfLetter:
    """The powers by which formulas of a page go with the letters that `is_changed` is true of."""

    sections: Sections
    is_changed: Callable[[str], bool]
    deep: bool = True
    """Whether the formulas of a formula's letters are gone through."""

    def of_letter(self, name: str, before: int) -> Fraction | None:
        """Return the power in the formulas that a letter has above a place; None if they differ."""
        above = self.sections.chains_above(Name(name), before)
        return _only(self.of(side.node) for c in above for side in c.sides[1:] if names(side.node))

    def of(self, node: Formula, depth: int = 0) -> Fraction | None:
        """Return the power with which a formula goes; None where that is not one power."""
        power: Fraction | None = None
        match node:
            case Negative(operand=inner) | Call(function="abs", argument=inner):
                power = self.of(inner, depth)
            case Product(factors=factors):
                power = _total([self.of(factor, depth) for factor in factors])
            case Quotient(numerator=above, denominator=below):
                less = self.of(below, depth)
                power = _total([self.of(above, depth), None if less is None else -less])
            case Power(base=base, exponent=Number(value=exponent)):
                power = _times(self.of(base, depth), exponent)
            case Call(function="sqrt", argument=inner):
                power = _times(self.of(inner, depth), Fraction(1, 2))
            case Sum(terms=terms):
                power = _only(self.of(term, depth) for term in terms)
            case Name(name=name):
                power = self._behind(name, depth)
            case _:
                is_wave = isinstance(node, Call) and node.function in ("sin", "cos")
                power = Fraction(0) if is_wave or not names(node) else None
        return power

    def _behind(self, name: str, depth: int) -> Fraction | None:
        if self.is_changed(name):
            return Fraction(1)
        if not self.deep:
            return Fraction(0)
        above = [side.node for c in self.sections.chains_of(Name(name)) for side in c.sides[1:]]
        formulas = [node for node in above if names(node) and name not in names(node)]
        if not formulas:
            return Fraction(0)
        return _only(self.of(node, depth + 1) for node in formulas) if depth <= _DEEPEST else None


def _only(powers: Iterable[Fraction | None]) -> Fraction | None:
    different = set(powers)
    return different.pop() if len(different) == 1 else None


def _total(powers: list[Fraction | None]) -> Fraction | None:
    known = [power for power in powers if power is not None]
    return sum(known, Fraction(0)) if len(known) == len(powers) else None


def _times(power: Fraction | None, exponent: Fraction) -> Fraction | None:
    return None if power is None else power * exponent
