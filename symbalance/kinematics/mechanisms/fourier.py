"""Harmonics of a mechanism to any number of digits, by the trapezoidal rule with a proved error.

In the strip |Im p| <= a of `mechanism_types` the function f = y - cos p, or f = phi, is analytic with
|sin phi| <= 1, hence bounded:

    |phi| <= pi/2,    |y - cos p| <= sqrt(2) l + sqrt(3) L

(|asin z| <= asin |z|, |cos phi|^2 <= 1 + |sin phi|^2, and for the arm |cos(chi - phi)|^2 <= |cos phi|^2 +
|sin phi|^2). So |c_n| <= M e^(-a |n|), M being that bound, and N points alias onto an order n <= `order`
at most 2 M e^(-a (N - order))/(1 - e^(-a N)). N is chosen to bring that below 10^-digits e^(-a order -
8), and bits are carried to match: the error is that small in every coefficient, so that coefficients
which fall like e^(-a n) keep about `digits` digits of their own, not only of the largest.
Source: Trefethen and Weideman, The exponentially convergent trapezoidal rule, SIAM Review 56 (2014).
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import lru_cache
from math import ceil, log

from symbalance.errors import SymbalanceError
from symbalance.kinematics.mechanisms.mechanism_types import (
    LinkRod,
    Mechanism,
    alternates,
    checked_mechanism,
    depends_on_sine,
    simplified,
)
from symbalance.kinematics.mechanisms.motion import height, rod_angle
from symbalance.kinematics.slider_crank import checked_order
from symbalance.text.numbers import checked_whole
from symbalance.text.reals import Complex, Real, cos, digits_of, expjpi, fixed, ldexp, pi

MOST_POINTS = 20_000
"""A rod that lies across so nearly that this is too few is refused: it would take minutes."""
MOST_DIGITS = 1000
GUARD = 8.0
"""Nepers between what a coefficient may be wrong by and what the bounds add up to."""
GUARD_BITS = 48
"""Bits for the roundings of the samples, where the rod nearly lies across too."""


def harmonics_of(mechanism: Mechanism, order: int, digits: int = 20) -> dict[int, Complex]:
    """Return n -> c_n, n = 0..order, of the height y(p) = sum of c_n e^(inp) over r, c_-n = conj(c_n).

    Every c_n is within 10^-digits e^(-a order) of the truth, a > 0 as in the module's head: `digits`
    significant digits of the largest, and about as many of the smallest. Orders that symmetry makes
    zero are left out; of a slider-crank the even ones are real. Refused where the rod comes so
    near to lying across that the rule would take more than `MOST_POINTS` points.

    >>> from symbalance.text.reals import nstr
    >>> from symbalance.kinematics.mechanisms import SliderCrank
    >>> for n, c in harmonics_of(SliderCrank(4, "1/2"), 3).items():
    ...     print(n, nstr(c, 8))
    0 (3.9037849 + 0.0j)
    1 (0.5 - 0.064583693j)
    2 (0.032564602 + 0.0j)
    3 (0.0 + 0.00054119972j)
    """
    return dict(_harmonics(simplified(mechanism), *_checked(order, digits), "height"))


def force_harmonics(mechanism: Mechanism, order: int, digits: int = 20) -> dict[int, tuple[Real, Real]]:
    """Return n -> (A_n, B_n), n = 1..order: the inertia force A_n cos np + B_n sin np over m r omega^2.

    A_n - i B_n = 2 n^2 c_n of `harmonics_of`, with its errors times that. A centred slider-crank has

    Formulas:
        F/(m r omega^2) = cos theta + A_2 cos 2 theta + A_4 cos 4 theta + ...

    >>> from symbalance.text.reals import nstr
    >>> from symbalance.kinematics.mechanisms import SliderCrank
    >>> nstr(force_harmonics(SliderCrank(4), 4)[2][0], 12)
    '0.254025042307'
    """
    checked_mechanism(mechanism)
    heights = harmonics_of(mechanism, order, digits)
    forces = {n: c * (2 * n * n) for n, c in heights.items() if n}
    return {n: (c.real, -c.imag) for n, c in forces.items()}


def rod_angle_harmonics(mechanism: Mechanism, order: int, digits: int = 20) -> dict[int, Complex]:
    """Return n -> d_n, n = 0..order, of the rod's angle phi(p) = sum of d_n e^(inp) in radians.

    Errors and left out orders as in `harmonics_of`. Without offset d_n = -i R_n/2, n odd, with R_n of
    `symbalance.kinematics.slider_crank`.

    >>> from symbalance.text.reals import nstr
    >>> from symbalance.kinematics.mechanisms import SliderCrank
    >>> {n: nstr(c, 8) for n, c in rod_angle_harmonics(SliderCrank(4), 4).items()}
    {1: '(0.0 - 0.12600023j)', 3: '(0.0 + 0.00033743188j)'}
    """
    return dict(_harmonics(simplified(mechanism), *_checked(order, digits), "rod-angle"))


def series_of(mechanism: Mechanism, order: int, digits: int, quantity: str) -> dict[int, Complex]:
    """Return the harmonics of the "height" or the "rod-angle" to any order, which is not checked.

    For products of series, whose factors are needed beyond the order of the product.
    """
    return dict(_harmonics(simplified(mechanism), order, digits, quantity))


def _checked(order: int, digits: int) -> tuple[int, int]:
    return checked_order(order), checked_whole(digits, "digits", 1, MOST_DIGITS, "20 is usual")


@lru_cache(maxsize=256)
def _harmonics(
    mechanism: Mechanism, order: int, digits: int, quantity: str
) -> tuple[tuple[int, Complex], ...]:
    nepers = digits * log(10) + mechanism.strip * order + GUARD
    points, bits = _points(mechanism, order, nepers), ceil(nepers / log(2)) + GUARD_BITS
    orders = [n for n in range(order + 1) if _survives(mechanism, n, quantity)]
    working = digits_of(bits + int(mechanism.length).bit_length())
    of_orders = means(_samples(mechanism, quantity, points, bits, working), bits)
    series = {n: _pure(mechanism, n, of_orders[n]) for n in orders}
    if quantity == "height":
        series[1] = series.get(1, Complex(0, 0, working)) + 0.5
    return tuple(sorted(series.items()))


def _points(mechanism: Mechanism, order: int, nepers: float) -> int:
    """Return how many points, a power of 2, make the rule's error small enough."""
    arm = mechanism.link_radius if isinstance(mechanism, LinkRod) else 0
    bound = 4 * (1.5 * float(mechanism.length) + 1.8 * float(arm) + 1.6)
    needed = (nepers + max(log(bound), 0)) / mechanism.strip if mechanism.strip else float("inf")
    if needed > MOST_POINTS:
        what = f"length = {float(mechanism.length):.12g}"
        rule = f"lets the rod lie across so nearly that {MOST_POINTS} points do not give the harmonics"
        raise SymbalanceError(what, rule, "lengthen the rod, or ask for fewer digits or orders")
    return 1 << (order + ceil(needed)).bit_length()


def _survives(mechanism: Mechanism, n: int, quantity: str) -> bool:
    """Tell whether symmetry leaves f an order n: the even ones of y - cos p, the odd ones of phi."""
    return not alternates(mechanism) or n % 2 == (quantity == "rod-angle")


def _pure(mechanism: Mechanism, n: int, value: Complex) -> Complex:
    """Return c_n real at even n and imaginary at odd n where f depends on sin p alone."""
    if not depends_on_sine(mechanism):
        return value if n else Complex(value.real)
    return Complex(0, value.imag) if n % 2 else Complex(value.real)


def _samples(mechanism: Mechanism, quantity: str, points: int, bits: int, digits: int) -> list[int]:
    """Return f at `points` crank angles, in units of 2^-bits, computed to `digits`."""
    function: Callable[[Mechanism, Real], Real] = rod_angle if quantity == "rod-angle" else height
    samples, turn = [], 2 * pi(digits)
    for i in range(points):
        p = turn * i / points
        value = function(mechanism, p) - (cos(p) if quantity == "height" else 0)
        samples.append(fixed(value, bits))
    return samples


def means(samples: list[int], bits: int) -> list[Complex]:
    """Return the means of sample times e^(-inp), n = 0, 1, ..., by an integer fast Fourier transform.

    Samples are in units of 2^-bits; so many bits the means carry.
    """
    points, digits = len(samples), digits_of(bits)
    roots = [expjpi(Fraction(2 * i, points), digits) for i in range(points // 2)]
    cosines, sines = [fixed(z.real, bits) for z in roots], [fixed(z.imag, bits) for z in roots]
    totals = zip(*_sums(samples, cosines, sines, bits), strict=True)
    scale = ldexp(Real(Fraction(1, points), digits), -bits)
    return [Complex(real * scale, imaginary * scale) for real, imaginary in totals]


def _sums(
    samples: list[int], cosines: list[int], sines: list[int], bits: int
) -> tuple[list[int], list[int]]:
    """Return the real and imaginary parts of the sums, of 2^k samples, halving and joining."""
    if len(samples) == 1:
        return samples, [0]
    even = _sums(samples[::2], cosines[::2], sines[::2], bits)
    odd = _sums(samples[1::2], cosines[::2], sines[::2], bits)
    rotated = [
        ((c * x + s * y) >> bits, (c * y - s * x) >> bits)
        for c, s, x, y in zip(cosines, sines, *odd, strict=True)
    ]
    real = [x + t for x, (t, _) in zip(even[0], rotated, strict=True)]
    imaginary = [y + t for y, (_, t) in zip(even[1], rotated, strict=True)]
    real += [x - t for x, (t, _) in zip(even[0], rotated, strict=True)]
    imaginary += [y - t for y, (_, t) in zip(even[1], rotated, strict=True)]
    return real, imaginary
