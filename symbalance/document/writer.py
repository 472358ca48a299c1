"""What the two writers of formulas share: the protocol, and printing by the type of a formula."""

from __future__ import annotations

from typing import ClassVar, Protocol

from symbalance.document import formula as f
from symbalance.document.notation import signed


class Writer(Protocol):
    """Prints formulas; `width` is the room that something printed takes, in the writer's own unit."""

    minus: str
    relations: ClassVar[dict[str, str]]

    def write(self, value: f.Formula) -> str:
        """Return a formula in print."""
        ...

    def width(self, printed: str) -> float:
        """Return how much room something printed takes."""
        ...

    def fences(self, value: f.Sum) -> tuple[str, str]:
        """Return the brackets around a sum that may run over several lines."""
        ...

    def factor(self, value: f.Formula) -> str:
        """Return a factor of a product, in brackets where it needs them."""
        ...

    def product(self, left: f.Formula, right: f.Formula) -> str:
        """Return what stands between two factors."""
        ...


def holds_a_sum(value: f.Sum) -> bool:
    """Tell whether a bracketed sum stands inside `value`, which then takes square brackets.

    >>> x = f.Name("x")
    >>> holds_a_sum(1 + x * (1 + x)), holds_a_sum(1 + x)
    (True, False)
    """
    factors = (t.factors if isinstance(t, f.Times) else (t,) for _, t in value.terms)
    return any(isinstance(factor, f.Sum) for each in factors for factor in each)


class Visitor:
    """Prints by the type of the formula; what both writers share."""

    names: dict[str, str]
    minus: str

    def write(self, value: f.Formula) -> str:
        """Return a formula in print."""
        return getattr(self, f"_{type(value).__name__.lower()}")(value)

    def product(self, left: f.Formula, right: f.Formula) -> str:
        """Return what stands between two factors."""
        raise NotImplementedError

    def factor(self, value: f.Formula) -> str:
        """Return a factor of a product, in brackets where it needs them."""
        raise NotImplementedError

    def _name(self, value: f.Name) -> str:
        return self.names.get(value.name, value.name)

    def _sum(self, value: f.Sum) -> str:
        terms = [(s, self.factor(t) if isinstance(t, f.Sum) else self.write(t)) for s, t in value.terms]
        return signed(terms, self.minus)

    def _times(self, value: f.Times) -> str:
        printed = self.factor(value.factors[0])
        for left, right in zip(value.factors, value.factors[1:], strict=False):
            last = right is value.factors[-1] and isinstance(right, f.Over)
            printed += self.product(left, right) + (self.write(right) if last else self.factor(right))
        return printed


def meet(left: f.Formula, right: f.Formula) -> bool:
    """Tell whether two factors need a dot between them: digits meet digits."""
    return (isinstance(left, f.Number) and isinstance(right, f.Number | f.Scientific)) or (
        isinstance(left, f.Number) and isinstance(right, f.Power) and isinstance(right.base, f.Number)
    )


def bare_argument(value: f.Applied) -> bool:
    """Tell whether a function's argument goes without brackets, as in cos 2 theta."""
    if isinstance(value.argument, f.Times):
        return not any(isinstance(factor, f.Applied) for factor in value.argument.factors)
    return isinstance(value.argument, f.Name)
