r"""Cosines of multiples of the crank angle, which is reduced exactly to 2^20 rad, without branches.

To compute is cos(s theta - phase), in + and * alone.

The angle itself is reduced, never s theta, which would be rounded: with P = 2 pi/s the period,
n = rint(theta/P - phase/2 pi) whole periods are taken off as theta - n P_1, where P_1 holds so few bits
of P that n P_1 is exact, and so is the difference; n P_2 (P = P_1 + P_2) is a small correction. What
is left, r, is folded to x = s P/4 - s |r|, and cos(s r) = sin x: a sine's relative error stays small
where its argument is, so that each rounding of x costs at most 0.56 u, and no sign is left over. From
1 rad on there is one: s (P/4 - |r|) is exact but for the correction.

    |theta| <= 2^20: n < 2^20 s/2 pi + 3; P_1 and P/4 share a grid so coarse that n P_1 < 2^53 steps.

Above 2^20 rad the lines for any angle start from the library's own cos theta and sin theta and raise
e^(i theta) to the power s: exactly reduced where the library does so, at an error of about s u.
Source of the idea: Cody and Waite, Software Manual for the Elementary Functions (1980), ch. 8.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from math import ceil, log2

from symbalance.codegen.expression_ir import Kernel, horner
from symbalance.text.reals import Exact, Real, cos, ldexp, nint, pi, sin, solve, sqrt

LIMIT = 2.0**20
"""The largest |theta| in radians that is reduced exactly: 166,000 turns, 27 minutes at 6000 rpm."""
DIGITS = 70
"""Of pi where a period is cut into parts of 53 bits and less."""
SINE_DEGREE = 17
"""Odd: the polynomial of this degree errs by less than a rounding on |x| <= pi/2."""


@lru_cache
def sine_coefficients() -> tuple[float, ...]:
    """Return S_3, S_5, ... with sin x = x + x^3 (S_3 + x^2 (S_5 + ...)), within 3e-17 x on |x| <= pi/2.

    Interpolated at Chebyshev's points in x^2, in 40 digits; a little beyond pi/2, for angles rounded up.
    """
    count = (SINE_DEGREE - 1) // 2
    end = (pi() / 2 + 2.0**-10) ** 2
    return sine_polynomial(end, count)


def sine_polynomial(end: Real, count: int) -> tuple[float, ...]:
    """Return `count` coefficients of (sin x/x - 1)/x^2 in powers of x^2, on 0 < x^2 < end."""
    nodes = [end * (1 + cos(pi() * (2 * i + 1) / (2 * count))) / 2 for i in range(count)]
    rows = [[u**j for j in range(count)] for u in nodes]
    return tuple(float(c) for c in solve(rows, [(sin(sqrt(u)) / sqrt(u) - 1) / u for u in nodes]))


@dataclass(frozen=True)
class Cosine:
    """cos(step theta - phase), phase in turns; `step` is n or n/2, above 0."""

    step: Fraction
    phase: Real

    def add_reduced_range(self, kernel: Kernel, name: str, mark: str) -> None:
        """Add the lines that compute it into `name` for |theta| <= LIMIT; `mark` keeps names apart."""
        sine_lines(kernel, name, _folded_argument(self, kernel, mark), mark)

    def add_on_grid(self, kernel: Kernel, name: str, mark: str) -> None:
        """Add the lines at theta = 2 pi index/points: whole numbers take the turns off, exactly."""
        times, under = self.step.numerator, self.step.denominator
        around = "points" if under == 1 else f"({under}.0*points)"
        index = "index" if times == 1 else f"{times}.0*index"
        shift = (
            f" - {kernel.constant(f'SHIFT_TURNS{mark}', self.phase, 'the phase, in turns')}"
            if self.phase
            else ""
        )
        n = kernel.line(f"n{mark}", f"rint({index}*{per_point(kernel, under)}{shift})", "whole periods")
        back = f" - {around}*SHIFT_TURNS{mark}" if self.phase else ""
        m = kernel.line(f"m{mark}", f"({index} - {n}*{around}){back}")
        half = kernel.constant("HALF_PI", pi() / 2)
        step = kernel.line(f"step_{under}", f"{half}/{around}", "a quarter of the angle of a point")
        x = kernel.line(f"x{mark}", f"({around} - 4.0*abs({m}))*{step}", "a quarter less that")
        sine_lines(kernel, name, x, mark)

    def add_full_range(self, kernel: Kernel, name: str, mark: str) -> None:
        """Add the lines for any other angle, from cos and sin of the angle itself."""
        full_range_cosine(self, kernel, name, mark)


def per_point(kernel: Kernel, turns: int = 1) -> str:
    """Add the line of 1/(turns points), to count whole periods of a grid by; return its name.

    A division an angle is what a grid's loop would wait for. The reciprocal's rounding moves a count
    only between two periods that are equally near.
    """
    name = "per_point" if turns == 1 else f"per_point_{turns}"
    return kernel.line(name, "1.0/points" if turns == 1 else f"1.0/({turns}.0*points)")


def full_range_cosine(cosine: Cosine, kernel: Kernel, name: str, mark: str) -> str:
    """Add the lines of a cosine from the library's own cos theta and sin theta; return its name."""
    half = cosine.step.denominator == 2
    theta, base = ("0.5*theta", "_half") if half else ("theta", "")
    c, s = kernel.line(f"cos_1{base}", f"cos({theta})"), kernel.line(f"sin_1{base}", f"sin({theta})")
    c, s = _power(kernel, c, s, cosine.step.numerator, base)
    if cosine.phase == 0:
        return kernel.line(name, c)
    angle = 2 * pi(50) * cosine.phase
    cosine_of, sine_of = (
        kernel.constant(f"{word}_SHIFT{mark}", f(angle)) for word, f in (("COS", cos), ("SIN", sin))
    )
    return kernel.line(name, f"{c}*{cosine_of} + {s}*{sine_of}")


def sine_lines(kernel: Kernel, name: str, x: str, mark: str) -> None:
    """Add name = sin(x) for |x| <= pi/2."""
    u = kernel.line(f"u{mark}", f"{x}*{x}")
    kernel.line(name, f"{x} + {x}*{u}*({sine_tail(kernel, u)})")


def sine_tail(kernel: Kernel, u: str) -> str:
    """Return S3 + u (S5 + ...), with sin x = x + x^3 times that at u = x^2."""
    terms = [
        kernel.constant(f"S{2 * j + 3}", s, "sin x = x + x^3 (S3 + x^2 (S5 + ...))" if j == 0 else "")
        for j, s in enumerate(sine_coefficients())
    ]
    return horner(terms, u)


def split_on_grids(value: Real, grid: int, bits: int, parts: int) -> list[Real]:
    """Cut a number into `parts` multiples of 2^-grid, 2^-(grid + bits), ..., and the rest."""
    pieces, rest = [], value
    for i in range(parts):
        pieces.append(_on_grid(rest, grid + i * bits))
        rest -= pieces[-1]
    return [*pieces, rest]


def _folded_argument(cosine: Cosine, kernel: Kernel, mark: str) -> str:
    """Add the lines down to x, a quarter turn less what is left of the angle; return its name.

    With h = shift + n P all but the correction, x = s ((P/4 + side h) - side theta) + small: every sum
    but the last is exact, on the grid of P_1, for |theta| >= 1 their product with s too, and the
    last one's rounding is small where x is.
    """
    s = cosine.step
    period = 2 * pi(DIGITS) / s
    parts = _reduction(period, cosine.phase, kernel, mark, s)
    quarter = _two_parts(kernel, f"QUARTER{mark}", period / 4, parts.grid, s)
    n, t, times = parts.count, parts.rest, "" if s == 1 else f"{float(s)!r}*"
    if not cosine.phase:
        remainder = kernel.line(f"r{mark}", f"{t} - {n}*{parts.high}", "exact: what is left of the angle")
        side = kernel.line(f"side{mark}", f"side({remainder})")
        argument = f"{times}({quarter[0]} - abs({remainder})) + ({side}*({n}*{parts.low}) + {quarter[1]})"
    else:
        shift = _two_parts(kernel, f"SHIFT{mark}", period * cosine.phase, parts.grid, s)
        whole = kernel.line(f"h{mark}", f"{shift[0]} + {n}*{parts.high}", "exact: the nearest crest")
        side = kernel.line(f"side{mark}", f"side({t} - {whole})")
        small = f"({side}*({n}*{parts.low} + {shift[1]}) + {quarter[1]})"
        argument = f"{times}(({quarter[0]} + {side}*{whole}) - {side}*{t}) + {small}"
    return kernel.line(f"x{mark}", argument, "a quarter turn less the phase from its crest")


def crest_angle(step: Fraction, phase: Real, kernel: Kernel, mark: str) -> tuple[str, str]:
    """Add the lines of n, half periods to the nearest crest or trough, and of r, the angle from there."""
    half = pi(DIGITS) / step
    parts = _reduction(half, 2 * phase, kernel, mark)
    n = parts.count
    if not phase:
        remainder = kernel.line(f"t{mark}h", f"{parts.rest} - {n}*{parts.high}", "exact")
        return n, kernel.line(f"r{mark}", f"{remainder} - {n}*{parts.low}", "what is left of the angle")
    shift = _two_parts(kernel, f"SHIFT{mark}", 2 * half * phase, parts.grid)
    remainder = kernel.line(f"t{mark}h", f"{parts.rest} - ({shift[0]} + {n}*{parts.high})", "exact")
    small = f"({n}*{parts.low} + {shift[1]})"
    return n, kernel.line(f"r{mark}", f"{remainder} - {small}", "what is left of the angle")


@dataclass(frozen=True)
class _Reduction:
    """Names of the whole periods, of what high and low parts are taken from, and the grid of `high`."""

    count: str
    rest: str
    high: str
    low: str
    grid: int


def _reduction(period: Real, phase: Real, kernel: Kernel, mark: str, times: Exact = 1) -> _Reduction:
    """Add the lines of n, with `low` already multiplied by `times`."""
    most = int(LIMIT / period) + 3
    bits = 53 - most.bit_length()
    grid = bits - ceil(log2(period))
    *first, high, low = _split_period(kernel, period, grid, most, mark, times)
    count = f"theta*{kernel.constant(f'PER_RADIAN{mark}', 1 / period, 'periods in a radian')}"
    if phase:
        count += f" - {kernel.constant(f'SHIFT_TURNS{mark}', phase, 'the phase, in periods')}"
    n = kernel.line(f"n{mark}", f"rint({count})", "whole periods")
    rest = kernel.line(f"t{mark}", f"theta - {n}*{first[0]}", "exact") if first else "theta"
    return _Reduction(n, rest, high, low, grid)


def _split_period(
    kernel: Kernel, period: Real, grid: int, most: int, mark: str, times: Exact
) -> list[str]:
    """Cut the period into parts on grids and a last double, till what is left does not matter."""
    bits = 53 - most.bit_length()
    count = next(k for k in (1, 2, 3) if ldexp(most, 5 - grid - (k - 1) * bits) < period)
    parts = split_on_grids(period, grid, bits, count)
    parts[-1] *= times
    note = "the period, cut so that n times the first part is exact"
    return [
        kernel.constant(f"PERIOD{mark}_{i}", part, note if i == 1 else "")
        for i, part in enumerate(parts, 1)
    ]


def _on_grid(value: Real, bits: int) -> Real:
    return ldexp(nint(ldexp(value, bits)), -bits)


def _two_parts(kernel: Kernel, name: str, value: Real, grid: int, times: Exact = 1) -> tuple[str, str]:
    high, low = split_on_grids(value, grid, 0, 1)
    return kernel.constant(f"{name}_1", high), kernel.constant(f"{name}_2", low * times)


def _power(kernel: Kernel, c: str, s: str, power: int, base: str) -> tuple[str, str]:
    """Add lines that raise cos + i sin to a whole power by squaring, and return the two names."""
    if power == 1:
        return c, s
    if power % 2:
        below = _power(kernel, c, s, power - 1, base)
        return _product(kernel, below, (c, s), f"{power}{base}")
    below = _power(kernel, c, s, power // 2, base)
    return _product(kernel, below, below, f"{power}{base}")


def _product(kernel: Kernel, a: tuple[str, str], b: tuple[str, str], mark: str) -> tuple[str, str]:
    cos = kernel.line(f"cos_{mark}", f"{a[0]}*{b[0]} - {a[1]}*{b[1]}")
    sin = kernel.line(f"sin_{mark}", f"{a[1]}*{b[0]} + {a[0]}*{b[1]}")
    return cos, sin
