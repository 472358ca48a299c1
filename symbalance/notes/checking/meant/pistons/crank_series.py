"""Exact series of what moves in a slider-crank: its harmonics, each a polynomial in λ = r/l.

From two functions of the crank angle θ, counted from top dead centre,

    cos β = √(1 - λ² sin²θ)          of the rod's angle, sin β = λ sin θ
    x/r   = 1 - cos θ + (1 - cos β)/λ   the way of the piston

all others follow by products and derivatives. They are cut off at a power of λ that no page reaches.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from math import comb, factorial
from typing import NamedTuple

HIGHEST = 8
"""The highest power of λ that is kept."""
_HALF = Fraction(1, 2)


class Harmonic(NamedTuple):
    """One function of a multiple of an angle: cos 2θ; or, in powers of a sine, cos θ sin²θ."""

    function: str
    order: int


Series = Mapping[Harmonic, Mapping[int, Fraction]]
"""Coefficients by harmonic and by power of λ."""


@dataclass(frozen=True)
class _Wave:
    """A function of θ as Σ c z^n λ^p with z = e^(iθ), or -i times that where it is odd."""

    terms: Mapping[tuple[int, int], Fraction]
    is_odd: bool = False

    def __add__(self, other: _Wave) -> _Wave:
        total = defaultdict(Fraction, self.terms)
        for key, value in other.terms.items():
            total[key] += value
        return _Wave(_nonzero(total), self.is_odd)

    def __mul__(self, other: _Wave) -> _Wave:
        sign = -1 if self.is_odd and other.is_odd else 1
        total = defaultdict[tuple[int, int], Fraction](Fraction)
        for (n, p), a in self.terms.items():
            for (m, q), b in other.terms.items():
                if p + q <= HIGHEST:
                    total[n + m, p + q] += sign * a * b
        return _Wave(_nonzero(total), self.is_odd != other.is_odd)

    def scaled(self, factor: Fraction | int, power: int = 0) -> _Wave:
        """Return the function times a number and a power of λ."""
        return _Wave({(n, p + power): factor * c for (n, p), c in self.terms.items()}, self.is_odd)

    def derivative(self) -> _Wave:
        """Return the derivative by θ."""
        sign = 1 if self.is_odd else -1
        return _Wave({(n, p): sign * n * c for (n, p), c in self.terms.items() if n}, not self.is_odd)

    def series(self) -> Series:
        """Return the coefficients of cos nθ or sin nθ."""
        harmonics = defaultdict[Harmonic, dict[int, Fraction]](dict)
        for (n, p), c in sorted(self.terms.items()):
            if n >= 0 and p < HIGHEST:  # a quotient by λ leaves less than the highest power
                function = "sin" if self.is_odd else "cos"
                harmonics[Harmonic(function, n)][p] = 2 * c if n else c
        return dict(harmonics)


def _nonzero(terms: Mapping[tuple[int, int], Fraction]) -> dict[tuple[int, int], Fraction]:
    return {key: value for key, value in terms.items() if value}


_ONE = _Wave({(0, 0): Fraction(1)})
_COSINE = _Wave({(1, 0): _HALF, (-1, 0): _HALF})
_SINE = _Wave({(1, 0): _HALF, (-1, 0): -_HALF}, is_odd=True)


def _of_square(coefficients: list[Fraction]) -> _Wave:
    """Return Σ c_k (λ sin θ)^2k."""
    total, power = _Wave({}), _ONE
    for coefficient in coefficients:
        total = total + power.scaled(coefficient)
        power = power * (_SINE * _SINE).scaled(1, 2)
    return total


def _root(exponent: Fraction) -> list[Fraction]:
    """Return the coefficients of (1 - u)^e by powers of u."""
    coefficients = [Fraction(1)]
    for k in range(1, HIGHEST // 2 + 1):
        coefficients.append(-coefficients[-1] * (exponent - k + 1) / k)
    return coefficients


def _arcsine() -> list[Fraction]:
    """Return the coefficients of asin(u)/u by powers of u²."""
    return [
        Fraction(factorial(2 * k), 4**k * factorial(k) ** 2 * (2 * k + 1))
        for k in range(HIGHEST // 2 + 1)
    ]


@cache
def known_series() -> Mapping[str, Series]:
    """Return the series of a slider-crank's quantities, over r, ω, m or the piston's force.

    >>> known_series()["inertia torque"][Harmonic("sin", 3)][1]
    Fraction(3, 4)
    >>> known_series()["acceleration"][Harmonic("cos", 2)][3]
    Fraction(1, 4)
    """
    cos_rod, secant = _of_square(_root(_HALF)), _of_square(_root(-_HALF))
    lifted = (_ONE + cos_rod.scaled(-1)).scaled(1, -1)
    path = _ONE + _COSINE.scaled(-1) + lifted
    speed = path.derivative()
    rate = speed.derivative()
    sin_rod = _SINE.scaled(1, 1)
    tangent, swing = sin_rod * secant, _COSINE.scaled(1, 1) * secant
    waves = {
        "displacement": path,
        "displacement from the bottom": _ONE.scaled(2) + path.scaled(-1),
        "position": _COSINE + cos_rod.scaled(1, -1),
        "velocity": speed,
        "acceleration": rate,
        "jerk": rate.derivative(),
        "inertia torque": speed * rate,
        "reduced moment of inertia": speed * speed,
        "radial force": _COSINE + (tangent * _SINE).scaled(-1),
        "side force of the mass forces": rate * tangent,
        "cosine of the rod's angle": cos_rod,
        "secant of the rod's angle": secant,
        "tangent of the rod's angle": tangent,
        "rod's angle": sin_rod * _of_square(_arcsine()),
        "rod's angular speed": swing,
        "rod's angular acceleration": swing.derivative(),
    }
    return {name: wave.series() for name, wave in waves.items()}


def turned(series: Series, quarters: int) -> Series:
    """Return a series with its angle counted from elsewhere: so many quarter turns before.

    >>> turned({Harmonic("sin", 1): {0: Fraction(1)}}, 1)
    {Harmonic(function='cos', order=1): {0: Fraction(1, 1)}}
    """
    result: dict[Harmonic, dict[int, Fraction]] = {}
    for (function, order), powers in series.items():
        part = order * quarters % 4
        # cos(nθ + part·90°) and sin(nθ + part·90°)
        sines = {"cos": ("cos", "sin", "cos", "sin"), "sin": ("sin", "cos", "sin", "cos")}[function]
        signs = {"cos": (1, -1, -1, 1), "sin": (1, 1, -1, -1)}[function]
        result[Harmonic(sines[part], order)] = {p: signs[part] * c for p, c in powers.items()}
    return result


def in_powers_of_sine(series: Series) -> Series:
    """Return a series in powers of sin θ, and in cos θ times these.

    >>> in_powers_of_sine({Harmonic("cos", 2): {0: Fraction(1)}})[Harmonic("1", 2)]
    {0: Fraction(-2, 1)}
    """
    result = defaultdict[Harmonic, defaultdict[int, Fraction]](lambda: defaultdict(Fraction))
    for (function, order), powers in series.items():
        # cos nθ + i sin nθ = Σ C(n, j) cos^(n-j) (i sin)^j
        for j in range(order + 1):
            if (j % 2 == 1) != (function == "sin"):
                continue
            size = comb(order, j) * (-1) ** (j // 2)
            pairs, is_odd = divmod(order - j, 2)
            for k in range(pairs + 1):  # cos² = 1 - sin²
                key = Harmonic("cos" if is_odd else "1", j + 2 * k)
                for p, c in powers.items():
                    result[key][p] += c * size * comb(pairs, k) * (-1) ** k
    return {
        key: own for key, each in sorted(result.items()) if (own := {p: c for p, c in each.items() if c})
    }
