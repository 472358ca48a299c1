"""The quantities all outputs are polynomials of, each computed once for all that need it."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from symbalance.codegen.closed import displacement_base, displacement_far, displacement_on_grid
from symbalance.codegen.cosines import Cosine
from symbalance.codegen.crests import Crest
from symbalance.codegen.kernels import Kernel
from symbalance.codegen.waves import Closed
from symbalance.text.reals import Real


class Bases:
    """The cosines, crests and squares found necessary so far, each under its names."""

    def __init__(self) -> None:
        self.cosines: list[Cosine] = []
        self.crests: list[Crest] = []
        self.squares: list[Closed] = []

    def name(self, step: Fraction, phase: Real) -> str:
        """Return the name of cos(step theta - 2 pi phase), remembering that it is needed."""
        return f"c{_place(self.cosines, Cosine(step, phase))}"

    def crest(self, step: Fraction, phase: Real) -> tuple[str, ...]:
        """Return the names of a crest's m, sigma and sine, remembering that it is needed."""
        crest = Crest(step, phase)
        return crest.names(f"{_place(self.crests, crest)}p")

    def square(self, closed: Closed) -> str:
        """Return the name of sin^2 of half the piston's crank angle."""
        if closed not in self.squares:
            self.squares.append(closed)
        return "sq"

    def kernel(self, where: str, wanted: set[str]) -> tuple[Kernel, tuple[str, ...]]:
        """Return the lines near, far or on_grid of every base `wanted`, and the names they define."""
        kernel, names = Kernel(), []
        for i, cosine in enumerate(self.cosines, 1):
            names.append(f"c{i}")
            getattr(cosine, where)(kernel, names[-1], str(i))
        for i, crest in enumerate(self.crests, 1):
            names.extend(name for name in crest.names(f"{i}p") if name in wanted)
            getattr(crest, where)(kernel, f"{i}p")
        for closed in self.squares:
            names.append("sq")
            SQUARES[where](kernel, closed, "sq")
        return kernel.pruned(names), tuple(names)

    def steps(self) -> list[Fraction]:
        """Return how often in a turn each base repeats."""
        found = [base.step for base in (*self.cosines, *self.crests)]
        return found + [Fraction(1) for _ in self.squares] or [Fraction(1)]


def _place(known: list[Any], base: Any) -> int:
    """Return the place, from 1, of a base among those known, adding it if it is new."""
    for i, other in enumerate(known, 1):
        if other.step == base.step and abs(other.phase - base.phase) < 1e-30:
            return i
    known.append(base)
    return len(known)


SQUARES = {"near": displacement_base, "far": displacement_far, "on_grid": displacement_on_grid}
