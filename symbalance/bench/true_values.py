"""True values of forces, couples, motions and coefficients, to 60 digits and more, from kinematics alone.

Nothing here rests on `symbalance.codegen` or on the exact phasors. cos theta and sin theta come from
mpmath; a cylinder's own angle, powers of e^(i theta) and square roots are then taken in whole numbers
of 2^-BITS, which is as exact and much faster. A true value is held as a double and what that leaves out.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property, lru_cache
from math import isqrt
from typing import Any

import numpy as np
from mpmath.ctx_mp import MPContext

from symbalance.engine.cylinders import Cylinder
from symbalance.engine.engine import Engine

Array = Any
Number = Any
"""A number of mpmath."""
mp: Any = MPContext()
"""mpmath as the bench's judge, in a context of its own: it heeds nobody's settings, and changes none."""
BITS, DIGITS = 256, 100
"""Fraction bits of the whole numbers, and mpmath's digits: above BITS, and enough for theta = 10^15."""
CANCELLED = mp.mpf(10) ** -60
"""Sums of unit vectors smaller than this cancel."""
SMALL_RATIO = Fraction(5, 4)
"""Below this rod ratio Gauss's function takes many terms, for its argument nears 1."""
ROOT = np.frompyfunc(isqrt, 1, 1)
U = 2.0**-53


@dataclass(frozen=True)
class TrueValues:
    """True values, each as the nearest double and the rest."""

    high: Array
    low: Array

    def off(self, values: Array) -> Array:
        """Return how far values are from the true ones."""
        return np.abs((np.asarray(values, np.float64) - self.high) - self.low)


@dataclass(frozen=True)
class Term:
    """One harmonic, cos * cos(order theta) + sin * sin(order theta)."""

    order: int
    cos: Number
    sin: Number


@dataclass(frozen=True)
class Points:
    """Crank angles (doubles, taken as exact), with their cosines, sines and powers as far as needed."""

    theta: Array
    _powers: dict[int, tuple[Array, Array]] = field(default_factory=dict, repr=False)

    @cached_property
    def circle(self) -> tuple[Array, Array]:
        """The cosine and the sine of every angle, in whole numbers."""
        with mp.workdps(DIGITS):
            pairs = [mp.cos_sin(mp.mpf(float(angle))) for angle in self.theta]
            return _objects(whole(c) for c, _ in pairs), _objects(whole(s) for _, s in pairs)

    def rotated(self, turns: Fraction) -> tuple[Array, Array]:
        """Return cosine and sine of theta + 2 pi turns."""
        with mp.workdps(DIGITS):
            angle = 2 * mp.mpf(turns.numerator) / turns.denominator
            return times(self.circle, (whole(mp.cospi(angle)), whole(mp.sinpi(angle))))

    def power(self, n: int) -> tuple[Array, Array]:
        """Return cosine and sine of n theta."""
        if n == 1:
            return self.circle
        if n not in self._powers:
            self._powers[n] = times(self.power(n // 2), self.power(n - n // 2))
        return self._powers[n]


def whole(value: Number) -> int:
    """Return a number in units of 2^-BITS."""
    return int(mp.nint(mp.ldexp(value, BITS)))


def times(one: tuple[Array, Array], other: tuple[Array, Array]) -> tuple[Array, Array]:
    """Return cosine and sine of the sum of two angles."""
    (c, s), (d, t) = one, other
    return c * d - s * t >> BITS, s * d + c * t >> BITS


def _objects(values: Iterable[int]) -> Array:
    return np.array(list(values), dtype=object)


def _true_values(values: Array, scale: int = 0) -> TrueValues:
    """Return whole numbers, times 2^scale, as doubles and the rest."""
    one = 1 << BITS
    high = np.array([v / one for v in values])
    back = _objects(int(np.ldexp(h, BITS)) for h in high)
    low = np.array([v / one for v in values - back])
    return TrueValues(np.ldexp(high, scale), np.ldexp(low, scale))


def weights(engine: Engine, name: str) -> list[tuple[Number, Fraction]]:
    """Return the weight of every cylinder's force in an output, and by how many turns it leads.

    Vertical or lateral: cos or sin of the bank, times the arm in a couple; the piston's own: 1.
    """
    kind, _, part = name.partition(".")
    if kind == "piston":
        return [(mp.mpf(1), engine.first.delay.turns)]
    onto = mp.cospi if part == "vertical" else mp.sinpi
    with mp.workdps(DIGITS):
        return [
            (_number(_arm(engine, c, kind)) * onto(2 * _number(c.bank.turns)), c.delay.turns)
            for c in engine.cylinders
        ]


def terms(engine: Engine, name: str, order: int, ratio: Fraction) -> list[Term]:
    """Return an output's harmonics to an order; what is smaller than CANCELLED is zero."""
    with mp.workdps(DIGITS):
        vectors = ((n, a, _vector(engine, name, n)) for n, a in true_coefficients(order, ratio).items())
        return [Term(n, a * z.real, -a * z.imag) for n, a, z in vectors if abs(z) > CANCELLED]


def _vector(engine: Engine, name: str, n: int) -> Number:
    """Return z with the output's part in order n = A_n Re(z e^(i n theta)), from every cylinder."""
    kind, _, part = name.partition(".")
    if part in ("forward", "backward"):
        sign = 1 if part == "forward" else -1
        vectors = (
            _number(_arm(engine, c, kind)) * _turn(sign * c.bank.turns + n * c.delay.turns)
            for c in engine.cylinders
        )
        return mp.fsum(vectors) / 2
    return mp.fsum(w * _turn(n * turns) for w, turns in weights(engine, name))


def _arm(engine: Engine, cylinder: Cylinder, kind: str) -> Fraction:
    return cylinder.station - engine.mean_station if kind == "couple" else Fraction(1)


def _turn(turns: Fraction) -> Number:
    return mp.expjpi(2 * _number(turns % 1))


def _number(value: Fraction) -> Number:
    return mp.mpf(value.numerator) / value.denominator


@lru_cache(maxsize=64)
def true_coefficients(order: int, ratio: Fraction) -> dict[int, Number]:
    """Return A_1 and every even A_n to an order, exact in lambda: A_2k = 4 k^2 c_k/rho.

    The c_k are the cosine coefficients of sqrt(1 - rho^2 sin^2 theta): Gauss's function where it
    converges fast, else upward from the elliptic integrals, with the digits that takes.
    """
    if ratio >= SMALL_RATIO:
        return {1: mp.mpf(1)} | {n: gauss(n, ratio) for n in range(2, order + 1, 2)}
    with mp.workdps(DIGITS + 2 * order):
        rho = 1 / _number(ratio)
        q = (rho / (1 + mp.sqrt(1 - rho * rho))) ** 2
        second, first = mp.ellipe(rho**2), mp.ellipk(rho**2)
        below = 4 * second / mp.pi
        here = 4 * ((2 - rho**2) * second - 2 * (1 - rho**2) * first) / (3 * mp.pi * rho**2)
        values = {1: mp.mpf(1)}
        for k in range(1, order // 2 + 1):
            values[2 * k] = 4 * k * k * here / rho
            above = (1 + q * q) * k * here + q * (k - mp.mpf(1.5)) * below
            below, here = here, -above / (q * (k + mp.mpf(1.5)))
        return values


def gauss(n: int, ratio: Fraction) -> Number:
    """Return A_n from Gauss's function: c_k = (1 + k') C(1/2, k) q^k 2F1(-1/2, k - 1/2; k + 1; q^2)."""
    k = n // 2
    with mp.workdps(DIGITS):
        rho = 1 / _number(ratio)
        root = mp.sqrt(_number(ratio * ratio - 1)) * rho
        q = (rho / (1 + root)) ** 2
        tail = mp.hyp2f1(mp.mpf(-0.5), k - mp.mpf(0.5), k + 1, q * q)
        return 4 * k * k / rho * (1 + root) * mp.binomial(mp.mpf(0.5), k) * q**k * tail


def harmonics_at(points: Points, sums: Sequence[Term]) -> TrueValues:
    """Return the sum of harmonics; computed relative to the largest, however small that is."""
    with mp.workdps(DIGITS):
        scale = max(int(mp.frexp(mp.hypot(t.cos, t.sin))[1]) for t in sums)
        total = _objects(0 for _ in points.theta)
        for term in sums:
            c, s = points.power(term.order)
            total = total + c * whole(mp.ldexp(term.cos, -scale)) + s * whole(mp.ldexp(term.sin, -scale))
    return _true_values(total >> BITS, scale)


def accelerations_at(
    points: Points, places: Sequence[tuple[Number, Fraction]], ratio: Fraction
) -> TrueValues:
    """Return the sum of weight times a piston's whole acceleration at theta + 2 pi turns.

    With c, s of the piston's own angle and R^2 = lambda^2 - s^2: c + (c^2 - s^2)/R + s^2 c^2/R^3.
    """
    with mp.workdps(DIGITS):
        square = whole(_number(ratio * ratio))
        rows = [(whole(weight), points.rotated(turns)) for weight, turns in places]
    total = _objects(0 for _ in points.theta)
    for weight, (c, s) in rows:
        cc, ss = c * c >> BITS, s * s >> BITS
        rest = square - ss
        root = ROOT(rest << BITS)
        own = c + (((cc - ss) + (cc * ss // rest)) << BITS) // root
        total = total + (own * weight >> BITS)
    return _true_values(total)


def piston_at(points: Points, part: str, engine: Engine, ratio: Fraction) -> TrueValues:
    """Return a piston's displacement or velocity; relative digits are kept near dead centres."""
    one: Callable[[Number, Number], Number] = {"displacement": _displacement, "velocity": _velocity}[part]
    with mp.workdps(DIGITS):
        lead = 2 * mp.pi * _number(engine.first.delay.turns)
        values = [one(mp.mpf(float(angle)) + lead, _number(ratio)) for angle in points.theta]
        high = np.array([float(v) for v in values])
        return TrueValues(high, np.array([float(v - h) for v, h in zip(values, high, strict=True)]))


def _displacement(p: Number, lam: Number) -> Number:
    square = mp.sin(p) ** 2
    return 2 * mp.sin(p / 2) ** 2 + square / (lam + mp.sqrt(lam * lam - square))


def _velocity(p: Number, lam: Number) -> Number:
    c, s = mp.cos_sin(p)
    return s * (1 + c / mp.sqrt(lam * lam - s * s))
