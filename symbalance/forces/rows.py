"""Rows of a table of free forces, couples and roll moments: one component of one order each."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from symbalance.document.decimals import SHOWN_DIGITS, short_decimal
from symbalance.document.formula import Formula, Name, sqrt
from symbalance.exact.exact_forms import ExactForm, FromSymPy
from symbalance.exact.radicals import multiple_of_pi
from symbalance.exact.spectrum import Component
from symbalance.forces.free_forces import Balance, Order, Resultant
from symbalance.forces.shaft_moments import has_shafts_aside, shaft_moment
from symbalance.text.reals import atan2, hypot, pi

NEAR = Fraction(1, 10**20)
"""Of such a part; a phase as far off is another number."""
PLAIN_PARTS = 60
"""Parts of pi that a decimal component's phase is recognised in: 3 degrees."""


@dataclass(frozen=True)
class Row:
    """One component of one order, exact and (where it has no symbols) in decimals."""

    order: int | Fraction
    name: str
    component: Component

    @property
    def has_symbols(self) -> bool:
        """Whether the component depends on a symbolic angle."""
        return self.component.number.has_symbols

    @property
    def is_decimal(self) -> bool:
        """Whether the component is a number of some digits, with no exact form."""
        return self.component.number.is_decimal

    def decimals(self) -> tuple[str, str, str, str] | None:
        """Return cos, sin, amplitude and phase in decimals, or None with symbols in them."""
        if self.has_symbols:
            return None
        cos, sin = self.component.decimal(SHOWN_DIGITS + 10)
        values = (cos, sin, hypot(cos, sin), atan2(sin, cos))
        cos_text, sin_text, amplitude, phase = (short_decimal(v) for v in values)
        return cos_text, sin_text, amplitude, phase

    def phase_in_decimals(self) -> Formula | None:
        """Return the phase of a decimal component where it is a plain fraction of pi, else None."""
        cos, sin = self.component.decimal(SHOWN_DIGITS + 24)
        parts = atan2(sin, cos) / pi() * PLAIN_PARTS
        near = round(parts)
        plain = abs(parts - near) < NEAR
        return multiple_of_pi(Fraction(near, PLAIN_PARTS)).as_formula() if plain else None

    def exact(self) -> tuple[Formula, Formula, Formula, Formula]:
        """Return cos, sin, amplitude and phase exactly; an endless amplitude as the root of C^2 + S^2."""
        form = self.component.form
        return (
            form("cos").as_formula(),
            form("sin").as_formula(),
            _short(form("amplitude")),
            form("phase").as_formula(),
        )


def _short(amplitude: ExactForm) -> Formula:
    # Numbers without symbols come here in closed form, or as the root of two squares that stay apart.
    if isinstance(amplitude, FromSymPy):
        value = amplitude.value
        squares = value.base.args if value.is_Pow and value.base.is_Add else ()
        if squares and all(square.is_Pow and square.exp == 2 for square in squares):
            return sqrt(Name("C") ** 2 + Name("S") ** 2)
    return amplitude.as_formula()


def rows(balance: Balance, resultant: str) -> list[Row]:
    """Return the vertical and lateral parts of the force or the couple that do not vanish, by order."""
    return [
        Row(order.order, name, part)
        for order in balance.orders
        for name in ("vertical", "lateral")
        if not (part := _of(order, resultant).component(name)).is_zero()
    ]


def rotating(balance: Balance, resultant: str) -> list[tuple[Row, Row]]:
    """Return each order's forward and backward part; empty where all is in one plane.

    There every order is two equal halves, one turning with the crank and one against it, each with
    half the amplitude and the phase of the whole.
    """
    if len({row.name for row in rows(balance, resultant)}) < 2:
        return []
    pairs = []
    for order in balance.orders:
        whole = _of(order, resultant)
        if not whole.is_zero():
            forward = Row(order.order, "forward", whole.forward)
            pairs.append((forward, Row(order.order, "backward", whole.backward)))
    return pairs


def _of(order: Order, resultant: str) -> Resultant:
    return order.force if resultant == "force" else order.couple


def roll_rows(balance: Balance) -> list[Row]:
    """Return the roll moment of an engine's shafts by order; empty where all run on the crank's axis.

    Units F_n r, or m r^2 omega^2 where components hold the kinematics; a stroke has to be known.
    """
    engine = balance.engine
    if not has_shafts_aside(engine) or engine.first.stroke is None:
        return []
    moments = shaft_moment(engine).items()
    return [Row(n, "roll", part) for n, part in moments if n <= balance.highest]


IN_ONE_PLANE = "each order is two equal halves, turning with and against the crank"


def plane(reference: Fraction | None) -> str:
    """Return in words what couples are taken about."""
    return "the mean of all stations" if reference is None else f"station {reference}"


def plane_key(reference: Fraction | None) -> str:
    """Return what couples are taken about, as JSON has it of every result."""
    return "mean of stations" if reference is None else f"station {reference}"
