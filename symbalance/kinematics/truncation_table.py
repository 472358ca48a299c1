"""Table of proved bounds on what a truncated series leaves out, order by order."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any, ClassVar

from symbalance.document.decimals import short_decimal
from symbalance.document.formula import Decimal, number
from symbalance.document.nodes import Column, Document, Facts, Table
from symbalance.document.result import SequenceResult
from symbalance.kinematics.slider_crank import checked_order, checked_quantity, checked_ratio
from symbalance.kinematics.truncation import left_out
from symbalance.text.numbers import decimal_text, exact, short_text
from symbalance.text.reals import Real

UNITS = {
    "displacement": "r",
    "velocity": "r ω",
    "acceleration": "r ω²",
    "force": "m r ω²",
    "rod-angle": "rad",
}


@dataclass(frozen=True, repr=False, eq=False)
class TruncationBounds(SequenceResult[tuple[int, Real]]):
    """Bounds on a quantity's error by the order its harmonics are kept to, at a rod ratio."""

    quantity: str
    ratio: Fraction
    items: tuple[tuple[int, Real], ...]
    kind: ClassVar[str] = "truncation-bounds"

    def summary(self) -> str:
        """Return what is bounded, in one line."""
        last = self.items[-1][0]
        return f"Bounds on the {self.quantity} at λ = {short_text(self.ratio)}, orders 1 to {last}"

    def document(self) -> Document:
        """Return a table of bounds by order."""
        columns = (Column("harmonics to order"), Column(f"error at most, {UNITS[self.quantity]}"))
        rows = tuple((number(order), Decimal(short_decimal(bound))) for order, bound in self)
        legend = (
            ("error", "largest over a turn, every coefficient kept exact in λ; proved, and reached"),
            ("λ", "connecting rod over crank radius"),
        )
        if self.quantity == "velocity":
            legend = (("error", "largest over a turn, every coefficient exact in λ; proved"), legend[1])
        return Document(self.summary(), (Table("", columns, rows), Facts(legend, "How to read it")))

    def data(self) -> dict[str, Any]:
        """Return the bounds to 20 digits."""
        bounds = [{"order": str(n), "bound": decimal_text(bound, 20)} for n, bound in self]
        unit = UNITS[self.quantity].replace("ω²", "omega^2").replace("ω", "omega")
        return {"quantity": self.quantity, "ratio": str(self.ratio), "unit": unit, "bounds": bounds}

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each order."""
        return [{"order": n, "bound": float(bound)} for n, bound in self]


def truncation_bounds(
    quantity: str = "acceleration", ratio: object = 4, order: int = 12
) -> TruncationBounds:
    """Return proved bounds on the errors of keeping harmonics to order 1, 2, ..., `order` only.

    Units r, r omega, r omega^2, m r omega^2 or rad; `symbalance.kinematics.truncation` has the proof. Of
    the rod angle kept to order 1 the bound is asin rho - R_1:

    Formulas:
        asin rho - R_1 = rho^3/24 + 9 rho^5/320 + ...

    >>> from symbalance.text.reals import nstr
    >>> nstr(truncation_bounds(order=6)[-1][1], 6)
    '1.35724e-6'
    """
    checked_order(order)
    checked_quantity(quantity)
    at = checked_ratio(exact(ratio, "ratio"))
    bounds = tuple((n, left_out(n, at, quantity)) for n in range(1, order + 1))
    return TruncationBounds(quantity, at, bounds)
