"""The function `derive` and its result: a slider-crank's harmonics derived step by step.

    geometry -> root -> its series -> multiple angles -> harmonics -> derivatives -> what is left out

Every coefficient comes from the integers of `symbalance.kinematics.slider_crank`. To order N the powers
of sin theta are kept to the N-th, and with them the powers of 1/lambda to the (N-1)-th (rod angle: the
N-th). The steps are data; `symbalance.kinematics.derivation.document` makes a document of them.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from symbalance.document.result import Result
from symbalance.errors import SymbalanceError, brief
from symbalance.kinematics.conventions import convention_named
from symbalance.kinematics.derivation.expansion_steps import (
    even_powers,
    geometry,
    inverse_sine,
    inverse_sine_series,
    odd_powers,
    root,
    root_series,
)
from symbalance.kinematics.derivation.harmonic_steps import collection_steps
from symbalance.kinematics.derivation.remainder_step import left_out_step
from symbalance.kinematics.derivation.request import SHORTENED, Request, Step
from symbalance.kinematics.slider_crank import (
    HIGHEST_ORDER,
    QUANTITIES,
    Harmonics,
    Series,
    acceleration_series,
    checked_order,
    integrated,
    rod_angle_series,
)
from symbalance.kinematics.slider_crank import harmonics as all_harmonics
from symbalance.text.numbers import checked_whole

if TYPE_CHECKING:
    from symbalance.document.nodes import Document


@dataclass(frozen=True, repr=False)
class Derivation(Result):
    """A quantity's harmonics to `order`, with the steps that lead there.

    `power` is the highest power of 1/lambda kept; `harmonics` the result, in powers of 1/lambda with
    lambda = l/r whatever the convention (above order 40 two terms of each coefficient).
    """

    quantity: str
    convention: str
    order: int
    power: int
    harmonics: Harmonics
    steps: tuple[Step, ...]

    kind: ClassVar[str] = "derivation"

    def summary(self) -> str:
        """Return what is derived, in one line."""
        return f"Derivation of the {self.quantity} of one slider-crank to order {self.order}"

    def document(self) -> Document:
        """Return the steps, each with its words and equations."""
        from symbalance.kinematics.derivation.document import derivation_document

        return derivation_document(self)

    def data(self) -> dict[str, Any]:
        """Return the harmonics as exact series, and the steps as text."""
        from symbalance.kinematics.derivation.document import derivation_data

        return derivation_data(self)

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each power of 1/lambda of each order."""
        return self.harmonics.records()


def derive(
    quantity: str = "force", order: int = 6, convention: str = "l/r", power: int | None = None
) -> Derivation:
    """Return the derivation of a quantity of `slider_crank.QUANTITIES` to `order`, 1 to 1000.

    `power` keeps powers of 1/lambda to it; it must leave every harmonic at least one term.

    Formulas:
        sin phi = rho sin theta
        v = omega dx/dtheta
        a = omega dv/dtheta
        F = m a

    >>> [step.title for step in derive("displacement", 2).steps][:3]
    ['Geometry', 'The root', 'The root as a series']
    >>> derive("force", 6, power=3)
    Traceback (most recent call last):
    symbalance.errors.SymbalanceError: power = 3: leaves order 6 no term; keep at least 5
    """
    if quantity not in QUANTITIES:
        raise SymbalanceError(f"quantity = {brief(quantity)}", f"must be one of {', '.join(QUANTITIES)}")
    convention_named(convention)
    highest_power = _checked_power(power, quantity, checked_order(order))
    request = Request(quantity, order, highest_power, convention)
    outcome = _harmonics(request)
    return Derivation(quantity, convention, order, highest_power, outcome, _steps(request, outcome))


def _steps(request: Request, outcome: Harmonics) -> tuple[Step, ...]:
    """Return the steps; the rod's angle needs no root and no derivative."""
    if request.rod_angle:
        before = (geometry, inverse_sine, inverse_sine_series, odd_powers)
    else:
        before = (geometry, root, root_series, even_powers)
    return (
        *(step(request) for step in before),
        *collection_steps(request, outcome),
        left_out_step(request, outcome),
    )


def _checked_power(power: int | None, quantity: str, order: int) -> int:
    """Return the highest power of 1/lambda to keep, refusing one that leaves a harmonic no term."""
    if quantity == "rod-angle":
        highest = order - 1 + order % 2
        least, usual = highest, order
    else:
        highest = order - order % 2
        least, usual = max(highest - 1, 0), order - 1
    if power is None:
        return usual
    power = checked_whole(power, "power", 0, HIGHEST_ORDER, "leave it out for the usual powers")
    if power < least:
        rule = f"leaves order {highest} no term"
        raise SymbalanceError(f"power = {power}", rule, f"keep at least {least}")
    return power


def _harmonics(request: Request) -> Harmonics:
    """Return the harmonics; of a long derivation two terms of each."""
    if not request.long:
        return all_harmonics(request.quantity, request.order, request.power)
    first = all_harmonics(request.quantity, 1, min(request.power, 3))
    if request.quantity == "rod-angle":
        rows = {n: rod_angle_series(n, min(request.power, n + 2)) for n in request.orders()}
    else:
        rows = {n: _shortened(request, n) for n in request.orders()}
    return Harmonics(request.quantity, first.function, first.constant, rows)


def _shortened(request: Request, n: int) -> Series:
    """Return the leading terms of one coefficient of a piston quantity."""
    through = min(request.power, n - 1 + 2 * (SHORTENED - 1)) if n > 1 else 0
    return acceleration_series(n, through).scaled(integrated(request.quantity, n))
