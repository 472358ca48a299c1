r"""Cosines of multiples of the crank angle in float32 alone, for angles to 2^31 rad; u32 = 2^-24.

theta is cut into whole numbers of at most 11 bits, and turned into turns in three sums:

    theta = 2^20 z + 2^8 a + 2^-4 b + 2^-16 c + d,         |z|, |a|, |b|, |c| <= 2^11, |d| <= 2^-17
    2^20/2 pi = whole + Z1 + Z2 + Z3, and so for a, b, c:  Z1 on the grid 2^-12, |Z2| <= 2^-13 on 2^-24

Each of z, a, b, c is a rint of what is left, and taking it off is exact: both are multiples of theta's
last place. Whole turns drop out. Then

    coarse = z Z1 + a A1 + b B1      multiples of 2^-12 below 2^12: every product and sum exact
    middle = z Z2 + a A2 + b B2 + c C2       multiples of 2^-24 below 1: every product and sum exact
    fine   = z Z3 + a A3 + b B3 + c C3 + d/2 pi        below 2^-12, rounded by less than 2^-35

and turns = f + e, f on the grid 2^-12 (coarse, and middle rounded to it, less whole turns) and e below
2^-11. So s f - phase stays exact for any order s to 2^11, its whole turns too; what is left, v, is
folded to w = 1/4 - |v|, also exact, and only then corrected by s e: cos = sin(2 pi w) keeps its last
bits near its zeros. Exact products stay exact where a compiler fuses them into the sums.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from math import lcm

from symbalance.codegen.cosines import Cosine, sine_polynomial, split_on_grids
from symbalance.codegen.expression_ir import Kernel, horner
from symbalance.codegen.harmonic_sum import ClosedForm
from symbalance.codegen.reinsch import Crest
from symbalance.codegen.shared_cosines import SharedCosines
from symbalance.text.reals import Real, ldexp, nint, pi

LIMIT32 = 2.0**31
"""The largest |theta| in radians that is cut into parts without loss."""
CUTS = (("z", 20), ("a", 8), ("b", -4), ("c", -16))
"""The parts of theta: names, and the powers of two they count."""
FLOAT32_SINE_DEGREE = 11
"""Odd; the polynomial of degree 9 would err by 0.6 u32, this one does by 0.01."""
REST = 2.0**-11
"""More than |e|, in turns."""


@lru_cache
def float32_sine_coefficients(margin: float) -> tuple[float, ...]:
    """Return S_3, S_5, ..., with sin x = x + x^3 (S_3 + x^2 (...)) on |x| <= pi/2 + margin.

    Off by at most 0.01 u32 there for the margin of order 24; degree 9 would be by 0.6.
    """
    count = (FLOAT32_SINE_DEGREE - 1) // 2
    return sine_polynomial((pi() / 2 + margin) ** 2, count)


def float32_kernel(shared: SharedCosines, used: tuple[str, ...]) -> Kernel:
    """Return the lines of every base, from a float32 theta, in float32."""
    if not used:
        return Kernel()
    kernel, steps = Kernel(), shared.steps()
    under = lcm(*(step.denominator for step in steps))
    margin = 2 * float(pi()) * REST * (1 + float(max(steps)) * under)
    turn_lines(kernel, under)
    lines = _Float32Lines(kernel, under, margin)
    for i, cosine in enumerate(shared.cosines, 1):
        lines.cosine(cosine, f"c{i}", str(i))
    for i, crest in enumerate(shared.crests, 1):
        lines.crest(crest, f"{i}p")
    for closed_form in shared.squares:
        lines.square(closed_form, "sq")
    return kernel.pruned(used)


def turn_lines(kernel: Kernel, under: int) -> None:
    """Add f and e with f + e = theta/(2 pi under) less whole numbers."""
    rest = "theta"
    turns = 1 / (2 * pi() * under)
    for i, (name, power) in enumerate(CUTS):
        kernel.line(name, f"rint({_times(rest, -power)})", f"theta = 2^{power} {name} + ...")
        after = CUTS[i + 1][0] if i + 1 < len(CUTS) else "d"
        kernel.line(f"to_{after}", f"{rest} - {_times(name, power)}", "exact")
        rest = f"to_{after}"
        share = ldexp(turns, power)
        parts = split_on_grids(share - nint(share), 12, 12, 2)
        note = f"2^{power}/(2 pi{f' {under}' if under > 1 else ''}) less whole turns, cut in three"
        for j, part in enumerate(parts, 1):
            kernel.constant(f"{name.upper()}{j}", part, note if j == 1 else "")
    kernel.constant("D3", turns)
    kernel.line("middle", "((z*Z2 + a*A2) + b*B2) + c*C2", "exact, multiples of 2^-24 below 1")
    kernel.line("near_middle", "rint(middle*4096.0)/4096.0", "on the grid 2^-12")
    kernel.line("coarse", "((z*Z1 + a*A1) + b*B1) + near_middle", "exact, multiples of 2^-12")
    kernel.line("f", "coarse - rint(coarse)", "exact: turns less whole ones")
    fine = f"(((z*Z3 + a*A3) + b*B3) + c*C3) + {rest}*D3"
    kernel.line("e", f"(middle - near_middle) + ({fine})", "what f leaves out, below 2^-11")


def _times(name: str, power: int) -> str:
    """Return the formula of a name times a power of two."""
    return f"{name}*{2.0**power!r}" if power > 0 else f"{name}/{2.0**-power!r}"


@dataclass(frozen=True)
class _Float32Lines:
    """Lines of cosines, crests and squares from f and e; `under` turns of the crank are one of theirs."""

    kernel: Kernel
    under: int
    margin: float

    def part(self, step: Fraction, phase: Real, mark: str) -> tuple[str, str]:
        """Return step theta - phase in turns: the exact part, as a line's name, and the rest."""
        high, low = split_on_grids(phase, 12, 0, 1)
        exact = self._less(f"{float(step * self.under)!r}*f", high, f"PHASE{mark}_1")
        rest = self._less(f"{float(step * self.under)!r}*e", low, f"PHASE{mark}_2")
        return self.kernel.line(f"y{mark}", exact, "exact"), rest

    def _less(self, formula: str, value: Real, name: str) -> str:
        formula = formula.removeprefix("1.0*")
        return f"{formula} - {self.kernel.constant(name, value)}" if value else formula

    def cosine(self, cosine: Cosine, name: str, mark: str) -> None:
        """Add name = cos(step theta - phase)."""
        exact, rest = self.part(cosine.step, cosine.phase, mark)
        v = self.kernel.line(f"v{mark}", f"{exact} - rint({exact})", "exact: turns from the crest")
        fold = f"(0.25 - abs({v})) - side({v})*({rest})"
        w = self.kernel.line(f"w{mark}", fold, "a quarter turn less that")
        self.sine(name, self.kernel.line(f"x{mark}", f"{self._pi(2)}*{w}"), mark)

    def crest(self, crest: Crest, mark: str) -> None:
        """Add m, sigma and sin(psi'), as `reinsch` defines them."""
        m, sigma, q = crest.names(mark)
        line = self.kernel.line
        exact, rest = self.part(crest.step, crest.phase, mark)
        n = line(f"n{mark}", f"rint(2.0*{exact})", "half turns")
        h = line(f"x{mark}", f"{self._pi(1)}*(({exact} - 0.5*{n}) + ({rest}))", "half of psi'")
        sine = self.sine(f"sin_h{mark}", h, mark)
        line(m, f"4.0*({sine}*{sine})")
        line(sigma, f"1.0 - 2.0*abs({n} - 2.0*rint(0.5*{n}))", "1 on a crest, -1 in a trough")
        line(q, f"2.0*{sine}*sqrt(1.0 - 0.25*{m})", "sin(psi')")

    def square(self, closed_form: ClosedForm, name: str) -> None:
        """Add name = sin^2 of half a piston's crank angle."""
        turns = closed_form.places[0][1]
        away = round(turns) - turns
        exact, rest = self.part(Fraction(1), Real(away), "_top")
        v = self.kernel.line("v_top", f"{exact} - rint({exact})", "exact: turns from the top")
        h = self.kernel.line("x_top", f"{self._pi(1)}*({v} + ({rest}))", "half the crank angle")
        sine = self.sine("sin_top", h, "_top")
        self.kernel.line(name, f"{sine}*{sine}")

    def sine(self, name: str, x: str, mark: str) -> str:
        """Add name = sin x."""
        u = self.kernel.line(f"u{mark}", f"{x}*{x}")
        note = "sin x = x + x^3 (R3 + x^2 (R5 + ...)), for float32"
        names = [
            self.kernel.constant(f"R{2 * j + 3}", s, "" if j else note)
            for j, s in enumerate(float32_sine_coefficients(self.margin))
        ]
        return self.kernel.line(name, f"{x} + {x}*{u}*({horner(names, u)})")

    def _pi(self, times: int) -> str:
        return self.kernel.constant("TAU" if times == 2 else "PI", times * pi())
