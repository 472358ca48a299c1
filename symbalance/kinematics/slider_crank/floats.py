"""Harmonics exact in lambda as doubles wrong by less than 0.51 ulp, from integers of about 100 bits.

With C(1/2, k) the binomial coefficient, q + 1/q = 4 lambda^2 - 2 = g and 1/sqrt(q) = lambda +
sqrt(lambda^2 - 1), the closed form reads

    A_2k = T_k q^(k - 1/2) F_k,    T_k = 4 k^2 C(1/2, k),    F_k = 2F1(-1/2, k - 1/2; k + 1; q^2),

and y_k = q^k F_k is the minimal solution of a contiguous relation of Gauss,

    y_{k-1} = g y_k - m_k y_{k+1},    m_k = (k + 3/2)(k - 1/2)/(k (k + 1)) = 1 - 3/(4 k (k + 1)).

`_downward` runs it towards smaller k, where errors shrink by q^2 a step, and scales by y_0; it must start
some 60/log2(1/q^2) steps above the order asked for. Where that is too many, rho near 1, `_upward` starts
from y_0 and y_1, known from the arithmetic-geometric mean, with as many more bits as the way up loses.
Formulas:
    q + 1/q = 4 lambda^2 - 2
    1/q = (lambda + sqrt(lambda^2 - 1))^2
    (k + 3/2) (k - 1/2)/(k (k + 1)) = 1 - 3/(4 k (k + 1))
    with q = (lambda - sqrt(lambda^2 - 1))^2; k a number

Either is good to a relative 2^-61, rounded to a double once: A_2k is wrong by less than 0.51 ulp, and
by less than one step of 2^-1074 where it is subnormal (there `ldexp` rounds a second time).
Source: expanded afresh; contiguous relations, 2F1 and the mean are in Abramowitz and Stegun, 15 and 17.
"""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from itertools import count
from math import acosh, isqrt, ldexp, log, log2

from symbalance.errors import SymbalanceError, shown, written
from symbalance.kinematics.slider_crank.arguments import HIGHEST_ORDER, checked_order

_BITS = 80
"""Fraction bits of the tables and of the way down; 60 would do without 500 roundings and their growth."""

_START = 60
"""How far above the order the way down starts, in factors of 2 that its first error shrinks by."""

_ACOSH_OCTAVES = 4 / log(2)


def acceleration_floats(order: int, ratio: Fraction | float | int) -> dict[int, float]:
    """Return A_1 and every even A_n to `order`, exact in lambda = l/r, as doubles wrong by < 0.51 ulp.

    A float is taken as the very double it is, unlike elsewhere, where 0.1 is a tenth: 4.2 then differs
    from Fraction("4.2"). Units: r omega^2, or m r omega^2 of force. Subnormal values: wrong by < 2^-1074.

    >>> acceleration_floats(6, 4)
    {1: 1.0, 2: 0.25402504230697526, 4: -0.004098111172029278, 6: 7.437903279419574e-05}
    """
    half = checked_order(order) // 2
    over, under = _terms(ratio)
    octaves = _octaves(over, under)
    if octaves * (8 + half // 3) > _START:
        return _downward(half, over, under, octaves)
    return _upward(half, over, under, octaves)


def _terms(ratio: Fraction | float | int) -> tuple[int, int]:
    """Return lambda as an exact quotient, or refuse what is none above 1."""
    try:
        over, under = ratio.as_integer_ratio()
    except (AttributeError, OverflowError, ValueError):  # no number, infinite, not a number
        rule, remedy = "must be a finite number", "give a fraction, a float or an int, not text"
        raise SymbalanceError(f"ratio = {written(ratio)}", rule, remedy) from None
    if over <= under:
        raise SymbalanceError(
            f"ratio = {shown(ratio)}",
            "the rod must be longer than the crank, lambda = l/r > 1",
            "engines have 3 to 4.5; r/l is the inverse",
        )
    return over, under


def _octaves(over: int, under: int) -> float:
    """Return log2(1/q^2) = 4 acosh(lambda)/log 2 to 1e-7 at least, however large lambda is."""
    try:
        return _ACOSH_OCTAVES * acosh(over / under)
    except OverflowError:
        return 4 * (1 + log2(over) - log2(under))


@cache
def _binomials() -> list[int]:
    """Return |C(1/2, k)| = Catalan(k-1) / 2^(2k-1), k = 0, 1, ..., with `_BITS` fraction bits."""
    values, catalan = [1 << _BITS], 1
    for k in range(1, HIGHEST_ORDER):
        values.append((catalan << _BITS + 1) >> 2 * k)
        catalan = catalan * (4 * k - 2) // (k + 1)
    return values


@cache
def _shapes() -> list[int]:
    """Return T_k = 4 k^2 C(1/2, k), k = 1, 2, ..., with `_BITS` fraction bits."""
    return [4 * k * k * (b if k % 2 else -b) for k, b in enumerate(_binomials()[1:], 1)]


@cache
def _squares() -> list[int]:
    """Return C(1/2, n)^2, n = 0, 1, ..., the coefficients of F_0 in q^2, with `_BITS` fraction bits."""
    return [b * b >> _BITS for b in _binomials()]


@cache
def _weights() -> list[int]:
    """Return m_k, k = 1, 2, ... from place 1 on, with `_BITS` fraction bits."""
    one = 1 << _BITS
    return [one, *(one - 3 * one // (4 * k * (k + 1)) for k in range(1, HIGHEST_ORDER + 20))]


@cache
def _rises() -> list[tuple[int, int]]:
    """Return 1/m_k, k = 1, 2, ..., as numerators and denominators."""
    return [(4 * k * (k + 1), (2 * k + 3) * (2 * k - 1)) for k in range(1, HIGHEST_ORDER // 2 + 1)]


def _quotient(over: int, under: int, bits: int) -> int:
    """Return over 2^bits / under, rounded down."""
    return (over << bits) // under if bits >= 0 else over // (under << -bits)


def _downward(half: int, over: int, under: int, octaves: float) -> dict[int, float]:
    """Return the A_n from the recurrence run towards smaller k, scaled by y_0 = F_0.

    Integers Y_k = y_k 2^(e k) to scale, e = floor(log2 1/q), so that Y_{k-1} >= Y_k >= 2^80. With
    x = q^2, s_k = F_{k-1}/F_k - 1 and t_k = 1 - m_k = 3/(4 k (k + 1)) the relation is

        s_k = x (s_{k+1} + t_k)/(1 + s_{k+1}),    of slope between 0 and x in s_{k+1}.

    Started at M = K + extra from s_{M+1} = 0, truly at most x t/(1 - x), the F_k/F_0 are wrong by
    x^(extra + 2) t_M/(1 - x)^2 < 2^-66. One step rounds by 2^-78 of Y, such errors shrink by x a step
    too: together 500 * 2^-78/(1 - x) < 2^-66, as extra <= 8 + K/3 keeps 1 - x above 1/5.
    """
    exponent, extra = int(octaves / 2), int(_START / octaves)
    square, rest = under * under, over * over - under * under
    lift = max(0, _BITS - rest.bit_length() // 2)
    root, crank = (over << lift) + isqrt(rest << 2 * lift), under << lift
    growth = _quotient(4 * rest + 2 * square, square, _BITS - exponent)
    q = _quotient(crank * crank, root * root, _BITS + exponent)
    *places, last = _descent(growth, q, 2 * exponent, _weights()[half + extra : 0 : -1])
    mean = _mean(q * q >> _BITS + 2 * exponent, extra)
    bits = last.bit_length() - exponent // 2
    scale = _quotient(mean * root, last * crank, bits)
    values, powers = {1: 1.0}, count(-bits - 2 * _BITS - exponent, -exponent)
    for n, shape, place, power in zip(
        range(2, 2 * half + 1, 2), _shapes(), places[::-1], powers, strict=False
    ):
        values[n] = ldexp(shape * place * scale, power)
    return values


def _descent(growth: int, q: int, twice: int, weights: list[int]) -> list[int]:
    """Return Y_M, ..., Y_1, Y_0 from Y_{M+1} = q Y_M, for the weights m_M, ..., m_1."""
    above, here = q, 1 << _BITS
    places = [here]
    for weight in weights:
        above, here = here, (growth * here - (weight * above >> twice)) >> _BITS
        places.append(here)
    return places


def _mean(square: int, extra: int) -> int:
    """Return F_0 = sum of C(1/2, n)^2 x^n; the terms left out, n > extra + 1, are below 2^-66."""
    total = 0
    for coefficient in _squares()[extra + 1 :: -1]:
        total = coefficient + (total * square >> _BITS)
    return total


def _upward(half: int, over: int, under: int, octaves: float) -> dict[int, float]:
    """Return the A_n from the recurrence run towards larger k, from V_0 and V_1, V_k = y_k/sqrt(q).

    Its Casoratian is V_k U_{k+1} - V_{k+1} U_k = V_0/(m_1 ... m_k) <= (3 pi/4) V_0 with U the solution
    from 0 and 1: an error of 1 in V_1 grows to U_K <= 2.4 K (K + 1) q^(-2K) V_K, as F_k > (k + 1)^(-1/2),
    and one in V_0 or made on the way grows no more. K + 2 of them, of at most 7 units of 2^-bits, stay
    below 2^(5 - bits) (K + 1)^3 q^(-2K) <= 2^-62 of V_K.
    """
    bits = 68 + int(octaves * half) + 3 * half.bit_length()
    here, above = _first_two(over, under, bits)
    growth = (4 * over * over - 2 * under * under << bits) // (under * under)
    values, power = {1: 1.0}, -bits - _BITS
    for n, shape, (rise, fall) in zip(range(2, 2 * half + 1, 2), _shapes(), _rises(), strict=False):
        values[n] = ldexp(shape * above, power)
        here, above = above, ((growth * above >> bits) - here) * rise // fall
    return values


def _first_two(over: int, under: int, bits: int) -> tuple[int, int]:
    """Return V_0 = 2 S/(r M) and V_1 = 4 ((2 l^2 - r^2) S - 2 l^2 (l^2 - r^2))/(3 r^3 M), fixed-point.

    That is 2 c_0/rho and 2 c_1/rho, c_n the cosine coefficients of sqrt(1 - rho^2 sin^2 theta), from the
    complete elliptic integrals K = pi l/(2 M) and E = K S/l^2. The rod l gets as many bits more as
    sqrt(l^2 - r^2), and S, which is about l^2/log(4/k'), have leading zeros.
    """
    square, rest = over * over, over * over - under * under
    deep = (square.bit_length() - rest.bit_length()) // 2 + 1
    lift = max(0, bits + deep + 2 * deep.bit_length() + 8 - over.bit_length())
    rod, crank = over << lift, under << lift
    mean, rest = _elliptic(rod, crank)
    square, short = rod * rod, crank * crank
    second = (2 * square - short) * rest - 2 * square * (square - short)
    return (2 * rest << bits) // (crank * mean), (4 * second << bits) // (3 * crank * short * mean)


def _elliptic(rod: int, crank: int) -> tuple[int, int]:
    """Return M = AGM(l, sqrt(l^2 - r^2)) and S = l^2 - r^2/2 - sum of 2^(n-1) c_n^2, c_n = (a - b)/2.

    The last step is a series: where c^4 < (2 a)^3, M = a - c^2/(4 a) is off by less than a unit.
    """
    wide, narrow = rod, isqrt(rod * rod - crank * crank)
    rest, doubling = rod * rod - crank * crank // 2, 0
    while True:
        product, gap, wide = wide * narrow, (wide - narrow) >> 1, (wide + narrow) >> 1
        rest -= gap * gap << doubling
        if 4 * gap.bit_length() <= 3 * wide.bit_length():
            return wide - gap * gap // (4 * wide), rest
        narrow, doubling = isqrt(product), doubling + 1
