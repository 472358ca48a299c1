"""One case of the bench of stability: where ours is worst, the naive form there too, the stated bound."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from math import inf
from typing import Any

import numpy as np

ULP, OF_AMPLITUDE, WRONG = "ulp", "u", "wrong"
WHAT, WHERE, NUMBER = 56, 40, 9


@dataclass(frozen=True)
class Case:
    """What was tried, where it was worst, and how far off it was, in `unit`; "wrong" counts values.

    `naive` holds what other ways of computing the same are off at worst, each under its name.
    """

    what: str
    where: str
    ours: float
    bound: float
    unit: str = OF_AMPLITUDE
    naive: Mapping[str, float] = field(default_factory=dict)

    @property
    def met(self) -> bool:
        """Whether ours is within the bound; what is not a number is not."""
        return self.ours <= self.bound

    def line(self) -> str:
        """Return the case as a row of the table."""
        naive = "; ".join(f"{shown(size)} {name}" for name, size in self.naive.items())
        row = f"{self.what:<{WHAT}} {self.where:<{WHERE}} {shown(self.ours):>{NUMBER}}"
        row += (
            f" {shown(self.bound):>{NUMBER}} {self.unit:<5}  {'ok' if self.met else 'FAILED':<6}  {naive}"
        )
        return row.rstrip()


@dataclass(frozen=True)
class Part:
    """Cases under a title, and what is to be said of them."""

    title: str
    says: str
    cases: Sequence[Case]

    def text(self) -> str:
        """Return the part as it is printed."""
        head = f"{'case':<{WHAT}} {'worst at':<{WHERE}} {'ours':>{NUMBER}} {'bound':>{NUMBER}}"
        rows = [head + " " * 16 + "naive", *(case.line() for case in self.cases)]
        return "\n".join([self.title, "─" * len(self.title), self.says, "", *rows])


def shown(value: float) -> str:
    """Return a size in three digits.

    >>> shown(3.14159), shown(412345.6), shown(0.0), shown(float("inf"))
    ('3.14', '4.12e+05', '0', 'inf')
    """
    return f"{value:.0f}" if abs(value) < 1e4 and value == int(value) else f"{value:.3g}"


def largest(cases: Sequence[Case], what: str = "") -> Case:
    """Return the case that is nearest to its bound or past it, with the worst naive sizes of all."""
    worst = max(cases, key=lambda c: inf if c.ours != c.ours else _share(c))
    names = dict.fromkeys(name for case in cases for name in case.naive)
    naive = {name: max(case.naive.get(name, 0.0) for case in cases) for name in names}
    return Case(what or worst.what, worst.where, worst.ours, worst.bound, worst.unit, naive)


def _share(case: Case) -> float:
    return case.ours / case.bound if case.bound else inf if case.ours else 0.0


def measured(
    what: str,
    theta: Any,
    off: Any,
    bound: float,
    unit: str = OF_AMPLITUDE,
    naive: Mapping[str, Any] | None = None,
    note: str = "",
) -> Case:
    """Return the case of errors `off` (in `unit`) at the angles; NaN counts as past every bound."""
    sizes = np.where(np.isnan(off), inf, off)
    k = int(np.argmax(sizes))
    others = {name: float(np.nanmax(values)) for name, values in (naive or {}).items()}
    return Case(what, f"{note}{float(theta[k])!r}", float(sizes[k]), bound, unit, others)


def tried(what: str, bound: float, unit: str, make: Callable[[], Case]) -> Case:
    """Return what `make` measures; a case that raises is a case that fails, and says how."""
    try:
        return make()
    except Exception as error:
        text = " ".join(f"raised {type(error).__name__}: {error}".split())
        return Case(what, text[:WHERE], inf, bound, unit)
