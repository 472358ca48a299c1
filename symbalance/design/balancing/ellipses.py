r"""The ellipse that one order of a force or couple draws, from its two rotating parts.

forward e^(i n theta) + backward e^(-i n theta) draws an ellipse with semi-axes |forward| + |backward| and
||forward| - |backward||, the long one at half the sum of the parts' directions. It is a circle where one
part is 0 and a straight line where both are equal; it is run through with the crank where the forward
part is the larger. (Both follow from where the
two counter-rotating vectors stand in line.)
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar

import sympy

from symbalance.document.result import Result
from symbalance.errors import SymbalanceError, brief
from symbalance.exact.amplitude import Amplitude
from symbalance.exact.decimal_phasor import LEAST
from symbalance.exact.phasor import ZERO
from symbalance.exact.spectrum import Component
from symbalance.forces.balance_data import VALUE_DIGITS, component_values, unit
from symbalance.forces.free_forces import Balance, checked_balance
from symbalance.forces.rows import plane_key
from symbalance.text.numbers import checked_whole, decimal_text
from symbalance.text.reals import Exact, Real, atan2, expj, pi

if TYPE_CHECKING:
    from symbalance.document.nodes import Document


@dataclass(frozen=True, repr=False)
class Ellipse(Result):
    """The ellipse drawn by one order of a balance's "force" or "couple" (`of`), in the balance's units.

    `forward` is c_n, which turns with the crank, and `backward` c_-n, both as directions at theta = 0;
    the unit is F_n = A_n m r omega^2 (couples F_n a), or m r omega^2 where cylinders are unlike.

    >>> from symbalance.engine.builders import inline
    >>> from symbalance.forces.free_forces import balance
    >>> line = ellipse(balance(inline("1", name="single"), 1))
    >>> line
    Free force of order 1 of single: line
    >>> line.major, line.minor, line.direction, line.shape
    (1, 0, 0, 'line')
    """

    balance: Balance
    of: str
    order: int
    forward: Amplitude
    backward: Amplitude

    kind: ClassVar[str] = "ellipse"

    def summary(self) -> str:
        """Return which order this is of, and what it draws, in one line."""
        return f"Free {self.of} of order {self.order} of {self.balance.engine.name}: {self.description}"

    def document(self) -> Document:
        """Return the semi-axes and the two rotating parts, then how to read them."""
        from symbalance.design.balancing.ellipse_document import ellipse_document

        return ellipse_document(self)

    def data(self) -> dict[str, Any]:
        """Return the semi-axes and the rotating parts, exact numbers as strings that SymPy reads.

        `cos` and `sin` of its parts are those straight up and to the right at theta = 0; `decimal` is the
        long and the short semi-axis and the direction in radians, None with symbols in them.
        """
        decimals = None
        if not self.has_symbols:
            numbers = (*self.decimal_axes, self.decimal_direction)
            decimals = [decimal_text(x, VALUE_DIGITS) for x in numbers]
        return {
            "engine": self.balance.engine.name,
            "reference_plane": plane_key(self.balance.reference),
            "unit": unit(self.balance, self.of),
            "order": str(self.order),
            "of": self.of,
            **self.axes_data(),
            "sense": None if self.has_symbols else self.sense,
            "decimal": decimals,
            "forward": dict(component_values(Component(self.forward))),
            "backward": dict(component_values(Component(self.backward))),
        }

    def axes_data(self) -> dict[str, Any]:
        """Return what it is, exactly: its shape, semi-axes and direction in radians."""
        return {
            "shape": self.shape,
            "major": str(self.major),
            "minor": str(self.minor),
            "direction": str(self.direction),
        }

    def records(self) -> list[dict[str, Any]]:
        """Return one row: semi-axes and direction in decimals where there are no symbols in them.

        Keys: order, of (force or couple), drawn, major, minor and direction_deg (floats, None with
        symbols in them), exact_major, exact_minor, unit.
        """
        major = minor = degrees = None
        if not self.has_symbols:
            major, minor = map(float, self.decimal_axes)
            degrees = float(self.decimal_direction * 180 / pi())
        return [
            {
                "order": self.order,
                "of": self.of,
                "drawn": self.description,
                "major": major,
                "minor": minor,
                "direction_deg": degrees,
                "exact_major": str(self.major),
                "exact_minor": str(self.minor),
                "unit": unit(self.balance, self.of),
            }
        ]

    @cached_property
    def _sizes(self) -> tuple[sympy.Expr, sympy.Expr]:
        return Component(self.forward).amplitude, Component(self.backward).amplitude

    @property
    def major(self) -> sympy.Expr:
        """The long semi-axis, exactly."""
        return self._sizes[0] + self._sizes[1]

    @property
    def minor(self) -> sympy.Expr:
        """The short semi-axis, exactly; with symbols |forward| - |backward|, of either sign."""
        forward, backward = self._sizes
        if self.forward.is_zero() or self.backward.is_zero():
            return self.major
        if forward.free_symbols or backward.free_symbols:
            return forward - backward
        return backward - forward if self.sense < 0 else forward - backward

    @property
    def sense(self) -> int:
        """+1 if it is run through with the crank, -1 against it, 0 for a straight line."""
        forward, backward = self.forward.size(), self.backward.size()
        gap = forward - backward
        return 0 if abs(gap) <= LEAST * (forward + backward) else (1 if gap > 0 else -1)

    @property
    def decimal_axes(self) -> tuple[Real, Real]:
        """The long and the short semi-axis in decimals; with symbols refused."""
        forward, backward = self.forward.size(), self.backward.size()
        return forward + backward, abs(forward - backward)

    @property
    def decimal_direction(self) -> Real:
        """Where the long semi-axis points in decimals, as `direction`; with symbols refused."""
        # The product of two exact numbers would take the product of their terms.
        both = self.forward.evaluated() * self.backward.evaluated()
        return atan2(both.imag, both.real) / 2

    @cached_property
    def direction(self) -> sympy.Expr:
        """Where the long semi-axis points, radians from straight up, + to the right; 0 for a circle."""
        both = self.forward.times(self.backward)
        return sympy.S.Zero if both.is_zero() else Component(both).phase / 2

    @property
    def shape(self) -> str:
        """Nothing, circle, line or ellipse; only a circle is decided with symbols."""
        none = self.forward.is_zero(), self.backward.is_zero()
        if any(none):
            return "nothing" if all(none) else "circle"
        if self._sizes[0].free_symbols or self._sizes[1].free_symbols:
            return "ellipse"
        return "ellipse" if self.sense else "line"

    @property
    def description(self) -> str:
        """What it draws in words, and in which sense: "circle, against the crank"."""
        if self.shape == "circle":
            return f"circle, {'with' if self.backward.is_zero() else 'against'} the crank"
        if self.shape == "ellipse" and not self.has_symbols:
            return f"ellipse, {'with' if self.sense > 0 else 'against'} the crank"
        return self.shape

    @property
    def has_symbols(self) -> bool:
        """Whether its size depends on a symbolic angle."""
        return bool(self.major.free_symbols)

    def reach(self, direction: Exact | Real) -> Real:
        """Return how far it reaches along a direction (radians from straight up): its amplitude there."""
        rotation = expj(-direction)
        forward, backward = (n.evaluated() * rotation for n in (self.forward, self.backward))
        return abs(forward.conjugate() + backward)


def ellipse(result: Balance, order: int = 1, kind: str = "force") -> Ellipse:
    """Return the ellipse of one order of a balance's free force, or of its couple.

    >>> from symbalance.engine.catalogue import load
    >>> from symbalance.forces.free_forces import balance
    >>> twin = ellipse(balance(load("v2-90"), 1))
    >>> twin.major, twin.minor, twin.shape
    (1, 1, 'circle')
    """
    checked_balance(result)
    if kind not in ("force", "couple"):
        raise SymbalanceError(f"kind = {brief(kind)}", "must be force or couple", "ask for one of them")
    rule = f"of a balance to order {result.highest}"
    checked_whole(order, "order", 1, result.highest, f"{rule}; ask balance for more")
    terms = (result.force if kind == "force" else result.couple).terms
    return Ellipse(result, kind, order, terms.get(order, ZERO), terms.get(-order, ZERO))
