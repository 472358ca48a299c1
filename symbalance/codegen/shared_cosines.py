"""The cosines that a function's outputs are polynomials of, each computed once for all that need it."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

from symbalance.codegen.closed_forms import (
    add_full_range_square,
    add_on_grid_square,
    add_reduced_range_square,
)
from symbalance.codegen.cosines import Cosine
from symbalance.codegen.expression_ir import Kernel
from symbalance.codegen.harmonic_sum import ClosedForm
from symbalance.codegen.reinsch import Crest
from symbalance.text.reals import Real


class SharedCosines:
    """Cosines, crests and squares of a half angle's sine in the order they were first needed."""

    def __init__(self) -> None:
        self.cosines: list[Cosine] = []
        self.crests: list[Crest] = []
        self.squares: list[ClosedForm] = []

    def name(self, step: Fraction, phase: Real) -> str:
        """Return the name of cos(step theta - 2 pi phase), remembering that it is needed."""
        return f"c{_place(self.cosines, Cosine(step, phase))}"

    def crest(self, step: Fraction, phase: Real) -> tuple[str, ...]:
        """Return the names of a crest's m, sigma and sine, remembering that it is needed."""
        crest = Crest(step, phase)
        return crest.names(f"{_place(self.crests, crest)}p")

    def square(self, closed_form: ClosedForm) -> str:
        """Return the name of sin^2 of half the piston's crank angle."""
        if closed_form not in self.squares:
            self.squares.append(closed_form)
        return "sq"

    def kernel(self, where: str, used: set[str]) -> tuple[Kernel, tuple[str, ...]]:
        """Return the lines of what is `used` and the names they define; `where` is a key of `SQUARES`."""
        kernel, names = Kernel(), []
        for i, cosine in enumerate(self.cosines, 1):
            names.append(f"c{i}")
            getattr(cosine, f"add_{where}")(kernel, names[-1], str(i))
        for i, crest in enumerate(self.crests, 1):
            names.extend(name for name in crest.names(f"{i}p") if name in used)
            getattr(crest, f"add_{where}")(kernel, f"{i}p")
        for closed_form in self.squares:
            names.append("sq")
            SQUARES[where](kernel, closed_form, "sq")
        return kernel.pruned(names), tuple(names)

    def steps(self) -> list[Fraction]:
        """Return how often in a turn each cosine, crest and square repeats."""
        steps = [each.step for each in (*self.cosines, *self.crests)]
        return steps + [Fraction(1) for _ in self.squares] or [Fraction(1)]


def _place(known: list[Any], new: Any) -> int:
    """Return the place, from 1, of a cosine or crest among those known, adding it if it is new.

    Phases that agree to 1e-30 of a turn are one: they carry 40 digits, and a double 17.
    """
    for i, other in enumerate(known, 1):
        if other.step == new.step and abs(other.phase - new.phase) < 1e-30:
            return i
    known.append(new)
    return len(known)


SQUARES: dict[str, Callable[[Kernel, ClosedForm, str], None]] = {
    "reduced_range": add_reduced_range_square,
    "full_range": add_full_range_square,
    "on_grid": add_on_grid_square,
}
"""By where the square is computed: |theta| <= LIMIT, any angle, theta = 2 pi index/points."""
