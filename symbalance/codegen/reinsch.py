r"""Reinsch's recurrence: sums of many harmonics, counted from the nearest crest, without loss of digits.

A cosine near 1 has lost the small angle it came from, and Clenshaw's recurrence grows there: with many
orders, or rho near 1, both cost digits. So psi = s theta - phase is reduced to psi' = psi - j pi within a
quarter turn, sigma = (-1)^j, and everything is built on m = 4 sin^2(psi'/2), which keeps its own digits:

    sum a_k cos k psi = sum sigma^k a_k cos k psi' = d_1 - m b_1/2,
    sum a_k sin k psi = sum sigma^k a_k sin k psi' = sin(psi') b_1,
    d_k = sigma^k a_k + d_{k+1} - m b_{k+1},   b_k = b_{k+1} + d_k.

Source: C. H. Reinsch, unpublished (1965), in J. Oliver, J. Inst. Math. Appl. 20 (1977) 379-391.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from symbalance.codegen.cosines import Cosine, crest_angle, full_range_cosine, per_point, sine_lines
from symbalance.codegen.expression_ir import Kernel
from symbalance.codegen.rounding import Grid
from symbalance.text.reals import Real, pi

ARGUMENT_ERROR = 7.0
"""What m errs at most, in u of itself: the reduction, s r/2, the sine, its square."""


@dataclass(frozen=True)
class Crest:
    """m, sigma and sin(psi') of psi = step theta - 2 pi phase."""

    step: Fraction
    phase: Real

    def names(self, mark: str) -> tuple[str, ...]:
        """Return the names of m, sigma and sin(psi')."""
        return f"m{mark}", f"sigma{mark}", f"q{mark}"

    def add_reduced_range(self, kernel: Kernel, mark: str) -> None:
        """Add the lines for |theta| <= LIMIT."""
        n, r = crest_angle(self.step, self.phase, kernel, mark)
        h = kernel.line(f"x{mark}", f"{float(self.step / 2)!r}*{r}", "half of psi'")
        self._from_half(kernel, n, h, mark)

    def add_on_grid(self, kernel: Kernel, mark: str) -> None:
        """Add the lines at theta = 2 pi index/points."""
        times, under = float(self.step.numerator), float(self.step.denominator)
        turns = f"{times!r}*index*{per_point(kernel, self.step.denominator)}"
        shift = (
            f" - {kernel.constant(f'PHASE{mark}', self.phase, 'the phase, in turns')}"
            if self.phase
            else ""
        )
        n = kernel.line(f"n{mark}", f"rint(2.0*({turns}{shift}))", "half turns")
        remainder = f"({times!r}*index - 0.5*{n}*({under!r}*points))/({under!r}*points){shift}"
        h = kernel.line(f"x{mark}", f"{kernel.constant('PI', pi())}*({remainder})", "half of psi'")
        self._from_half(kernel, n, h, mark)

    def _from_half(self, kernel: Kernel, n: str, h: str, mark: str) -> None:
        m, sigma, q = self.names(mark)
        sine_lines(kernel, f"sin_h{mark}", h, mark)
        kernel.line(m, f"4.0*(sin_h{mark}*sin_h{mark})")
        kernel.line(sigma, f"1.0 - 2.0*abs({n} - 2.0*rint(0.5*{n}))", "1 on a crest, -1 in a trough")
        kernel.line(q, f"2.0*sin_h{mark}*sqrt(1.0 - 0.25*{m})", "sin(psi')")

    def add_full_range(self, kernel: Kernel, mark: str) -> None:
        """Add the lines for any other angle."""
        m, sigma, q = self.names(mark)
        c = full_range_cosine(Cosine(self.step, self.phase), kernel, f"cos_p{mark}", mark)
        quarter = Cosine(self.step, self.phase + 0.25)
        s = full_range_cosine(quarter, kernel, f"sin_p{mark}", f"{mark}q")
        kernel.line(sigma, f"side({c})")
        kernel.line(m, f"2.0*{s}*{s}/(1.0 + abs({c}))")
        kernel.line(q, f"{sigma}*{s}")


def reinsch_lines(
    kernel: Kernel, prefix: str, row: Sequence[Real], m: str, sigma: str
) -> tuple[str, str]:
    """Add the recurrence of a row of harmonics a_1, a_2, ...; return the names of d_1 and b_1."""
    d = b = ""
    for k in range(max(k for k, a in enumerate(row) if a), 0, -1):
        a = kernel.constant(f"{prefix}{k}", row[k], f"harmonic {k}") if row[k] else ""
        terms = [f"{sigma}*{a}" if a and k % 2 else a, d]
        formula = " + ".join(t for t in terms if t)
        formula += f" - {m}*{b}" if b else ""
        d = kernel.line(f"{prefix.lower()}d{k}", formula)
        b = kernel.line(f"{prefix.lower()}b{k}", f"{b} + {d}" if b else d)
    return d, b


def reinsch_rounding(row: Sequence[float], psi: Grid, kind: str = "T") -> Grid:
    """Return what the recurrence rounds and its argument's error counts, in u, over angles psi.

    An error in d_k is as if a_k were changed; one in b_k counts 2 sin(psi'/2) times, or, over sin(psi'),
    1/cos(psi'/2) times.
    """
    trough = psi > np.pi / 2
    near = np.where(trough, np.pi - psi, psi)
    sigma, half = np.where(trough, -1.0, 1.0), np.sin(near / 2)
    m = 4 * half * half
    d = b = total = np.zeros_like(psi)
    for k in range(len(row) - 1, 0, -1):
        a = row[k] * sigma**k
        first, product = a + d, m * b
        d = first - product
        b = b + d
        local = abs(row[k]) + np.abs(first) + np.abs(product) + np.abs(d)
        total = total + local + 2 * half * np.abs(b)
    if kind == "U":
        total = total * 2 + np.abs(np.sin(near) * b) * 4
    slope = sum(k * a * (np.sin(k * psi) if kind == "T" else np.cos(k * psi)) for k, a in enumerate(row))
    return total + np.abs(m * b) + ARGUMENT_ERROR * np.tan(near / 2) * np.abs(slope)
