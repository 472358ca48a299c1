"""From waves to a plan: which cosines, which polynomial, or the closed form, by a stated rule.

A wave that gives both its harmonics and a closed form takes the closed form where the harmonics need
more polynomial terms than `DEARER` says one closed form is worth on the target. A polynomial runs by
Horner's rule in powers of the cosine where its rounding stays small, by Clenshaw's recurrence where
powers would lose digits (many orders, rho near 1). Waves that share a cosine share its lines.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import gcd, lcm
from typing import Any

import numpy as np
from mpmath import mp

from symbalance.numeric import rounding
from symbalance.numeric.closed import (
    displacement_base,
    displacement_far,
    displacement_lines,
    displacement_on_grid,
    secondary_cosine,
    secondary_lines,
    velocity_lines,
)
from symbalance.numeric.cosines import Cosine
from symbalance.numeric.kernels import Kernel
from symbalance.numeric.polynomials import (
    Family,
    clenshaw_lines,
    families,
    family,
    power_lines,
    powers,
)
from symbalance.numeric.waves import Closed, Wave
from symbalance.rational import Real

QUARTER = Fraction(1, 4)
DEARER = {"numpy": 7, "octave": 7}
"""Polynomial terms one closed form (a division and a root) is worth; on every other target `DEAR`."""
DEAR = 16
CLOSED_ERROR = 8.0
"""What a closed form rounds, in u of the sum of its parts' sizes."""
WORTH_IT = 1.5
"""A closed form whose parts exceed their sum more than this loses digits: the harmonics stay."""
FEW = 4.0
"""Rounding, in u of the amplitude, up to which powers of the cosine are preferred to Clenshaw."""


@dataclass(frozen=True)
class Output:
    """One planned output: its formula in the cosines, and what it may err, in u of the amplitude.

    `scaled`: the formula is linear in the output's own constants, so that a unit may go into those.
    """

    wave: Wave
    formula: str
    amplitude: float
    rounding: float
    form: str
    closed: bool = False
    scaled: bool = False

    def value(self, theta: Any) -> Real:
        """Return what the formula stands for at a crank angle, to mpmath's working precision."""
        closed = self.wave.closed
        return (
            closed.value(mp.mpf(theta)) if closed is not None and self.closed else self.wave.value(theta)
        )

    @property
    def prefix(self) -> str:
        """What the names of its own constants begin with."""
        return prefix(self.wave.name)


def prefix(name: str) -> str:
    """Return what the names of an output's own constants begin with.

    >>> prefix("force.vertical")
    'FORCE_VERTICAL_'
    """
    return name.replace(".", "_").upper() + "_"


@dataclass
class Plan:
    """Constants, the lines of the cosines near and far, then those of the outputs."""

    near: Kernel
    far: Kernel
    on_grid: Kernel
    tail: Kernel
    bases: tuple[str, ...]
    outputs: tuple[Output, ...]
    ratio: Fraction
    step: Fraction
    highest_step: float


class _Bases:
    """The cosines found necessary so far, each under its name."""

    def __init__(self) -> None:
        self.cosines: list[Cosine] = []
        self.squares: list[Closed] = []

    def name(self, step: Fraction, phase: Real) -> str:
        """Return the name of cos(step theta - 2 pi phase), remembering that it is needed."""
        for i, known in enumerate(self.cosines):
            if known.step == step and abs(known.phase - phase) < 1e-30:
                return f"c{i + 1}"
        self.cosines.append(Cosine(step, phase))
        return f"c{len(self.cosines)}"

    def square(self, closed: Closed) -> str:
        if closed not in self.squares:
            self.squares.append(closed)
        return "sq"

    def kernel(self, where: str) -> tuple[Kernel, tuple[str, ...]]:
        """Return the lines of every cosine near, far or on_grid, and the names they define."""
        kernel, names = Kernel(), []
        for i, cosine in enumerate(self.cosines, 1):
            names.append(f"c{i}")
            getattr(cosine, where)(kernel, names[-1], str(i))
        for closed in self.squares:
            names.append("sq")
            SQUARES[where](kernel, closed, "sq")
        return kernel.pruned(names), tuple(names)

    def common_step(self) -> Fraction:
        """Return the step all cosines are multiples of: the outputs repeat that often in a turn."""
        steps = [c.step for c in self.cosines] + [Fraction(1) for _ in self.squares] or [Fraction(1)]
        under = lcm(*(s.denominator for s in steps))
        return Fraction(gcd(*(int(s * under) for s in steps)), under)


SQUARES = {"near": displacement_base, "far": displacement_far, "on_grid": displacement_on_grid}


def plan(waves: Sequence[Wave], ratio: Fraction, target: str) -> Plan:
    """Return the cheapest plan for `waves` on a target, by the rule above."""
    bases, tail = _Bases(), Kernel()
    outputs = tuple(_planned(wave, target, bases, tail) for wave in waves)
    near, names = bases.kernel("near")
    far, on_grid = bases.kernel("far")[0], bases.kernel("on_grid")[0]
    highest = float(max((c.step for c in bases.cosines), default=1))
    return Plan(near, far, on_grid, tail, names, outputs, ratio, bases.common_step(), highest)


def _planned(wave: Wave, target: str, bases: _Bases, tail: Kernel) -> Output:
    size = wave.amplitude()
    if wave.closed is not None and _closed_is_cheaper(wave, target):
        formula = _closed(wave.closed, prefix(wave.name), bases, tail)
        linear = wave.closed.kind == "secondary"
        error = CLOSED_ERROR * _cancelling(wave.closed, size)
        return Output(wave, formula, size, error, "closed form", closed=True, scaled=linear)
    if not wave.terms:
        return Output(wave, "0.0", 0.0, 0.0, "zero: no order is left")
    formula, error, form = _polynomials(wave, bases, tail)
    return Output(wave, formula, size, error / size + 1.0, form, scaled=True)


def _closed_is_cheaper(wave: Wave, target: str) -> bool:
    if wave.closed is None or not wave.terms:
        return wave.closed is not None
    dearer = len(wave.terms) > DEARER.get(target, DEAR) * len(wave.closed.places)
    return dearer and _cancelling(wave.closed, wave.amplitude()) < WORTH_IT


def _cancelling(closed: Closed, size: float) -> float:
    """Return how many times the parts of a closed form, summed in size, exceed the whole."""
    if closed.kind != "secondary":
        return 1.0
    ratio = float(closed.ratio)
    largest = max(1 / ratio, 1 / (ratio * ratio * (1 - 1 / ratio**2)) ** 0.5)
    parts = sum(abs(w) for w, _ in closed.places) * largest + sum(t.size for t in closed.first)
    return max(float(parts) / size, 1.0)


def _closed(closed: Closed, own: str, bases: _Bases, tail: Kernel) -> str:
    if closed.kind == "displacement":
        return displacement_lines(tail, closed, bases.square(closed))
    if closed.kind == "velocity":
        phase = _turns(-closed.places[0][1])
        cosine, sine = bases.name(Fraction(1), phase), bases.name(Fraction(1), phase + 0.25)
        return velocity_lines(tail, closed, cosine, sine)
    parts = []
    if closed.first:
        one = family(closed.first)
        weight = tail.constant(f"{own}FIRST", one.even[1], "the first order")
        parts.append(f"{weight}*{bases.name(one.step, one.phase)}")
    for i, (weight, turns) in enumerate(closed.places):
        cosine = secondary_cosine(closed.ratio, turns)
        name = bases.name(cosine.step, cosine.phase)
        value = secondary_lines(tail, closed.ratio, name, name.removeprefix("c"))
        parts.append(f"{tail.constant(f'{own}ABOVE_{i}', weight)}*{value}")
    return " + ".join(parts)


def _turns(turns: Fraction) -> Real:
    return mp.mpf(turns.numerator) / turns.denominator


def _polynomials(wave: Wave, bases: _Bases, tail: Kernel) -> tuple[str, float, str]:
    """Return an output's formula, its rounding (absolute, in u) and its form in words."""
    parts, error = [], 0.0
    found = families(wave.terms)
    for i, one in enumerate(found):
        own = prefix(wave.name) + "ABC"[i] * (len(found) > 1)
        text, rounded = _polynomial(one, own, bases, tail)
        parts.append(text)
        error += rounded
    single = len(found) == 1 and not any(found[0].odd)
    return " + ".join(parts), error, f"polynomial{'' if single else 's'} in {_count(found)}"


def _count(found: Sequence[Family]) -> str:
    cosines = sum(1 + any(one.odd) for one in found)
    return {1: "one cosine", 2: "two cosines", 3: "three cosines"}[cosines]


def _polynomial(found: Family, own: str, bases: _Bases, tail: Kernel) -> tuple[str, float]:
    cosine = bases.name(found.step, found.phase)
    psi = rounding.angles(len(found.even))
    text, errors = _cheapest(found.even, "T", own, cosine, psi, tail)
    if any(found.odd):
        sine = bases.name(found.step, found.phase + mp.mpf(1) / 4)
        more, error = _cheapest(found.odd, "U", own + "S", cosine, psi, tail)
        text = f"{text} + {sine}*({more})"
        errors += error + 2.0 * sum(abs(float(a)) * k for k, a in enumerate(found.odd))
    return text, float(np.max(errors))


def _cheapest(
    row: Sequence[Real], kind: str, own: str, c: str, psi: rounding.Grid, tail: Kernel
) -> tuple[str, rounding.Grid]:
    """Return one polynomial's formula by Horner or by Clenshaw, and its rounding over `psi`."""
    floats = [float(a) for a in row]
    in_powers = powers(row, kind)
    of_cosine = rounding.cosine_error(psi) * rounding.derivative(floats, psi)
    by_horner = rounding.of_powers([float(p) for p in in_powers], psi)
    by_clenshaw = rounding.of_clenshaw(floats, psi, kind)
    size = max(abs(a) for a in floats)
    if np.max(by_horner) <= max(FEW * size, float(np.max(by_clenshaw))):
        return power_lines(tail, own, in_powers, c), of_cosine + by_horner
    return clenshaw_lines(tail, own, row, c, kind), of_cosine + by_clenshaw
