"""A sum of harmonics as a polynomial in one cosine, or in a cosine and a sine.

With psi = s theta - phase, cos k psi = T_k(c) and sin k psi = sin psi U_{k-1}(c), Chebyshev's polynomials
in c = cos psi. Harmonics whose phases are all multiples of one another need the cosine alone.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import gcd, lcm

from symbalance.codegen.expression_ir import Kernel, horner
from symbalance.codegen.harmonic_sum import HarmonicTerm
from symbalance.text.reals import DIGITS, Complex, Real, atan2, expjpi, nint, pi

ALIGNED = Fraction(1, 10 ** (DIGITS - 8))
"""Sines smaller than this, of the largest harmonic, are rounding of the coefficients."""
FEW_TERMS = 3
"""Harmonics that may each have a cosine of their own."""
LONG = 8
"""Brackets a line of Horner's rule may nest."""


@dataclass(frozen=True)
class Family:
    """Harmonics as sum of even[k] cos k psi + odd[k] sin k psi, psi = step theta - 2 pi phase, k >= 1."""

    step: Fraction
    phase: Real
    even: tuple[Real, ...]
    odd: tuple[Real, ...]


def family(terms: Sequence[HarmonicTerm]) -> Family:
    """Return harmonics on their common step, and on a phase where all are cosines, or all sines.

    Where there is none of either the largest needs no sine.

    >>> one = HarmonicTerm(Fraction(2), Real(0), Real(3))
    >>> harmonics = family([one])
    >>> harmonics.step, float(harmonics.phase), float(harmonics.even[1])
    (Fraction(2, 1), 0.25, 3.0)
    """
    step = _step([t.order for t in terms])
    numbers = {int(t.order / step): Complex(t.cos, t.sin, DIGITS) for t in terms}
    count, largest = max(numbers), max(abs(z) for z in numbers.values())
    for phase in _phases(numbers):
        aligned = {k: z * expjpi(-2 * k * phase) for k, z in numbers.items()}
        if all(abs(z.imag) <= ALIGNED * largest for z in aligned.values()):
            return Family(step, phase, _row(aligned, count, "real"), ())
    for phase in _phases({k: z * -1j for k, z in numbers.items()}):
        aligned = {k: z * expjpi(-2 * k * phase) for k, z in numbers.items()}
        if all(abs(z.real) <= ALIGNED * largest for z in aligned.values()):
            return Family(step, phase, (), _row(aligned, count, "imag"))
    chief = max(numbers, key=lambda k: abs(numbers[k]))  # the largest needs no sine: least is rounded
    phase = _phases({chief: numbers[chief]})[0]
    aligned = {k: z * expjpi(-2 * k * phase) for k, z in numbers.items()}
    return Family(step, phase, _row(aligned, count, "real"), _row(aligned, count, "imag", chief))


def decompositions(terms: Sequence[HarmonicTerm]) -> list[list[Family]]:
    """Return the ways to cut harmonics into families, the shortest to compute first.

    Centred cylinders have the first order and even ones: on a cosine of their own the even orders need
    half the degree, and round less. Where one cosine does for all it comes first. A few harmonics far
    apart can have a cosine each.
    """
    whole = family(terms)
    first = [t for t in terms if t.order == 1]
    rest = [t for t in terms if t.order != 1]
    single = [[family([t]) for t in terms]] if 1 < len(terms) <= FEW_TERMS else []
    if not first or not rest or any(t.order % 2 for t in rest):
        return [[whole], *single]
    apart = [family(first), family(rest)]
    return [apart, [whole], *single] if any(whole.odd) else [[whole], apart, *single]


def _step(orders: Sequence[Fraction]) -> Fraction:
    under = lcm(*(n.denominator for n in orders))
    return Fraction(gcd(*(int(n * under) for n in orders)), under)


def _phases(numbers: dict[int, Complex]) -> list[Real]:
    """Return the phases, in turns, at which the lowest harmonic is a pure cosine, nearest to 0 first."""
    lowest = min(numbers)
    first = atan2(numbers[lowest].imag, numbers[lowest].real) / (2 * pi())
    phases = [(first + j / 2) / lowest for j in range(2 * lowest)]
    nearest = [x - nint(x) for x in phases]
    return sorted((Real(0) if abs(x) < ALIGNED else x for x in nearest), key=abs)


def _row(numbers: dict[int, Complex], count: int, part: str, without: int = 0) -> tuple[Real, ...]:
    """Return one part of the numbers by order; what is but rounding of the coefficients is 0."""
    least = ALIGNED * max(abs(z) for z in numbers.values())
    parts = {k: getattr(z, part) for k, z in numbers.items() if k != without}
    significant = {k: x for k, x in parts.items() if abs(x) > least}
    return tuple(significant.get(k, Real(0)) for k in range(count + 1))


def powers(chebyshev: Sequence[Real], kind: str = "T") -> list[Real]:
    """Return the coefficients in powers of c of sum a_k T_k(c), or of sum a_k U_{k-1}(c).

    >>> [int(p) for p in powers([0, 0, 0, 1])], [int(p) for p in powers([0, 0, 0, 1], "U")]
    ([0, -3, 0, 4], [-1, 0, 4])
    """
    before, here = ([1], [0, 1]) if kind == "T" else ([0], [1])
    total = [Real(0)] * max(len(chebyshev), 1)
    for a in chebyshev:
        for j, p in enumerate(before):
            total[j] += a * p
        after = [0, *(2 * p for p in here)]
        for j, p in enumerate(before):
            after[j] -= p
        before, here = here, after
    return total[: len(chebyshev) - 1] if kind == "U" and len(chebyshev) > 1 else total


def power_lines(kernel: Kernel, prefix: str, coefficients: Sequence[Real], c: str) -> str:
    """Return a power series in `c` as a formula; even and odd powers apart where that is shorter."""
    names = [
        kernel.constant(f"{prefix}{j}", p, f"times cos^{j}" if j else "") if p else ""
        for j, p in enumerate(coefficients)
    ]
    own = prefix.lower()
    if len(names) < 4 or 2 * sum(map(bool, names)) > len(names) + 4:
        return _nested(kernel, f"{own}p", names, c)
    z = kernel.line(f"z_{c}", f"{c}*{c}")
    even, odd = (
        _nested(kernel, f"{own}{word}", names[i::2], z) for i, word in enumerate(("even", "odd"))
    )
    return " + ".join(p for p in (even, f"{c}*{_in_brackets(odd)}" if odd else "") if p)


def _nested(kernel: Kernel, name: str, names: list[str], variable: str) -> str:
    """Return Horner's rule as a formula; beyond `LONG` brackets it begins on lines of its own."""
    names = _trim(names)
    while len(names) > LONG + 1:
        upper = kernel.line(f"{name}{len(names) - LONG}", horner(names[-LONG:], variable))
        names = [*names[:-LONG], upper]
    return horner(names, variable) if names else ""


def _trim(names: list[str]) -> list[str]:
    while names and not names[-1]:
        names = names[:-1]
    return names


def _in_brackets(formula: str) -> str:
    return f"({formula})" if " " in formula else formula


def clenshaw_lines(kernel: Kernel, prefix: str, row: Sequence[Real], c: str, kind: str = "T") -> str:
    """Add Clenshaw's recurrence for sum a_k T_k(c) or sum a_k U_{k-1}(c); return the last formula."""
    twice = kernel.line(f"twice_{c}", f"{c} + {c}")
    above, here = "", ""
    for k in range(max(k for k, a in enumerate(row) if a), 0, -1):
        a = kernel.constant(f"{prefix}{k}", row[k], f"harmonic {k}") if row[k] else ""
        terms = [a, f"{twice}*{here}" if here else ""]
        formula = " + ".join(t for t in terms if t) + (f" - {above}" if above else "")
        above, here = here, kernel.line(f"{prefix.lower()}b{k}", formula)
    return here if kind == "U" else f"{c}*{here}" + (f" - {above}" if above else "")
