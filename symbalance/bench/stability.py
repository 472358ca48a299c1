"""`symbalance bench stability`: largest errors in ulp at the worst inputs known, naive formulas beside.

True values come from the kinematics alone (`true_values`), angles and rod ratios from what is known
to hurt. A case past its stated bound is a failure, and so is one that raises: the command exits with 1.
"""

from __future__ import annotations

import platform
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import mpmath
import numpy as np
import sympy

from symbalance.bench import closed_sum_cases, engine_cases, piston_cases, ratio_cases
from symbalance.bench.bounded_cases import BoundedCase, Part, worst
from symbalance.bench.output_requests import targets

UNITS = """\
u = 2^-53, half an ulp of 1, times the amplitude of the output; ulp: of the true value itself; wrong: 1
where a refusal fails to come. "error" is symbalance's largest, at the place named; "naive" the largest
of the naive form anywhere."""
PARTS: Sequence[Callable[[bool], Part]] = (
    piston_cases.piston_part,
    engine_cases.near_part,
    engine_cases.far_part,
    ratio_cases.coefficient_part,
    ratio_cases.function_part,
    engine_cases.high_order_part,
    closed_sum_cases.closed_sum_part,
    engine_cases.float32_part,
)


@dataclass(frozen=True)
class StabilityReport:
    """Cases under titles, below a line on the programs, above the verdict."""

    head: str
    parts: Sequence[Part]

    def cases(self) -> list[BoundedCase]:
        """Return all cases."""
        return [case for part in self.parts for case in part.cases]

    def missed_targets(self) -> list[BoundedCase]:
        """Return the cases past their stated bound."""
        return [case for case in self.cases() if not case.is_met]

    def text(self) -> str:
        """Return the report as it is printed."""
        body = "\n\n".join(part.text() for part in [*self.parts, self.summary()])
        return f"{self.head}\n{UNITS}\n\n{body}\n\n{self.verdict()}\n"

    def summary(self) -> Part:
        """Return, of every part, the case nearest to its bound or past it."""
        rows = [worst(part.cases, part.title) for part in self.parts]
        return Part("In short", "The case of each table that is nearest to its bound, or past it.", rows)

    def verdict(self) -> str:
        """Return the last lines: how many cases, and which are past their bounds."""
        count, failures = len(self.cases()), self.missed_targets()
        if not failures:
            return f"{count} cases, all within their bounds"
        return "\n".join(
            [f"FAILED: {len(failures)} of {count} cases", *(f"  {c.name}" for c in failures)]
        )


def report(quick: bool = False) -> StabilityReport:
    """Return all cases; `quick` takes fewer angles, engines and orders."""
    head = (
        f"Python {platform.python_version()}, NumPy {np.__version__}, mpmath {mpmath.__version__}, "
        f"SymPy {sympy.__version__}, {platform.machine()}; targets: {', '.join(targets())}"
    )
    return StabilityReport(head, [part(quick) for part in PARTS])
