"""Measuring of a case in `bench stability`: worst error and where, its bound, the naive error."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from math import inf, isnan
from typing import Any

import numpy as np

ULP, OF_AMPLITUDE, WRONG = "ulp", "u", "wrong"
NAME, WHERE, NUMBER = 56, 40, 9
"""Widths of the columns."""


@dataclass(frozen=True)
class BoundedCase:
    """What was computed, where the error is largest, and that error in `unit`; "wrong" counts values.

    `naive` holds the largest errors of other ways of computing the same, each under its name.
    """

    name: str
    where: str
    error: float
    bound: float
    unit: str = OF_AMPLITUDE
    naive: Mapping[str, float] = field(default_factory=dict)

    @property
    def is_met(self) -> bool:
        """Whether the error is within the bound; what is not a number is not."""
        return self.error <= self.bound

    def line(self) -> str:
        """Return the case as a row of the table."""
        naive = "; ".join(f"{size_text(size)} {name}" for name, size in self.naive.items())
        row = f"{self.name:<{NAME}} {self.where:<{WHERE}} {size_text(self.error):>{NUMBER}}"
        verdict = "ok" if self.is_met else "FAILED"
        return f"{row} {size_text(self.bound):>{NUMBER}} {self.unit:<5}  {verdict:<6}  {naive}".rstrip()


@dataclass(frozen=True)
class Part:
    """Cases under a title, and the text above them."""

    title: str
    introduction: str
    cases: Sequence[BoundedCase]

    def text(self) -> str:
        """Return the part as it is printed."""
        head = f"{'case':<{NAME}} {'worst at':<{WHERE}} {'error':>{NUMBER}} {'bound':>{NUMBER}}"
        rows = [head + " " * 16 + "naive", *(case.line() for case in self.cases)]
        return "\n".join([self.title, "─" * len(self.title), self.introduction, "", *rows])


def size_text(value: float) -> str:
    """Return a size in three digits.

    >>> size_text(3.14159), size_text(412345.6), size_text(0.0), size_text(float("inf"))
    ('3.14', '4.12e+05', '0', 'inf')
    """
    return f"{value:.0f}" if abs(value) < 1e4 and value == int(value) else f"{value:.3g}"


def worst(cases: Sequence[BoundedCase], name: str = "") -> BoundedCase:
    """Return the case that is nearest to its bound or past it, with the worst naive sizes of all."""
    case = max(cases, key=lambda c: inf if isnan(c.error) else _share(c))
    ways = dict.fromkeys(way for c in cases for way in c.naive)
    naive = {way: max(c.naive.get(way, 0.0) for c in cases) for way in ways}
    return BoundedCase(name or case.name, case.where, case.error, case.bound, case.unit, naive)


def _share(case: BoundedCase) -> float:
    return case.error / case.bound if case.bound else inf if case.error else 0.0


def worst_point(
    name: str,
    theta: Any,
    off: Any,
    bound: float,
    unit: str = OF_AMPLITUDE,
    naive: Mapping[str, Any] | None = None,
    note: str = "",
) -> BoundedCase:
    """Return the case of errors `off` (in `unit`) at the angles; NaN counts as past every bound."""
    sizes = np.where(np.isnan(off), inf, off)
    k = int(np.argmax(sizes))
    others = {way: float(np.nanmax(values)) for way, values in (naive or {}).items()}
    return BoundedCase(name, f"{note}{float(theta[k])!r}", float(sizes[k]), bound, unit, others)


def attempt(name: str, bound: float, unit: str, make: Callable[[], BoundedCase]) -> BoundedCase:
    """Return the case that `make` measures; one that raises is a case that fails, and says how."""
    try:
        return make()
    except Exception as error:
        text = " ".join(f"raised {type(error).__name__}: {error}".split())
        return BoundedCase(name, text[:WHERE], inf, bound, unit)
