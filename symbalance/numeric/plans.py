"""From waves to a plan: which cosines, which polynomial, or the closed form, by a stated rule.

A wave that gives both its harmonics and a closed form takes the closed form where the harmonics need
more polynomial terms than `DEARER` says one closed form is worth on the target, and where the closed
form's parts do not cancel. Waves that share a cosine share its lines.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import gcd, lcm
from typing import Any

from mpmath import mp

from symbalance.numeric.bases import Bases
from symbalance.numeric.closed import (
    displacement_lines,
    secondary_cosine,
    secondary_lines,
    velocity_lines,
)
from symbalance.numeric.kernels import NAME, Kernel
from symbalance.numeric.polynomials import family
from symbalance.numeric.waves import DIGITS, Closed, Wave
from symbalance.numeric.ways import polynomials, prefix
from symbalance.rational import Real

QUARTER = Fraction(1, 4)
DEARER = {"numpy": 7, "octave": 7}
"""Polynomial terms one closed form (a division and a root) is worth; on every other target `DEAR`."""
DEAR = 16
CLOSED_ERROR = 8.0
"""What a closed form rounds, in u of the sum of its parts' sizes."""
WORTH_IT = 1.5
"""A closed form whose parts exceed their sum more than this loses digits: the harmonics stay."""


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
    found: Bases


def plan(waves: Sequence[Wave], ratio: Fraction, target: str) -> Plan:
    """Return the cheapest plan for `waves` on a target, by the rule above."""
    with mp.workdps(DIGITS + 10):  # whatever precision the caller has set
        return _plan(waves, ratio, target)


def _plan(waves: Sequence[Wave], ratio: Fraction, target: str) -> Plan:
    bases, tail = Bases(), Kernel()
    outputs = tuple(_planned(wave, target, bases, tail) for wave in waves)
    wanted = tail.names().union(*(NAME.findall(o.formula) for o in outputs))
    near, names = bases.kernel("near", wanted)
    far, on_grid = bases.kernel("far", wanted)[0], bases.kernel("on_grid", wanted)[0]
    steps = bases.steps()
    under = lcm(*(s.denominator for s in steps))
    common = Fraction(gcd(*(int(s * under) for s in steps)), under)
    return Plan(near, far, on_grid, tail, names, outputs, ratio, common, float(max(steps)), bases)


def _planned(wave: Wave, target: str, bases: Bases, tail: Kernel) -> Output:
    size = wave.amplitude()
    if wave.closed is not None and _closed_is_cheaper(wave, target):
        formula = _closed(wave.closed, prefix(wave.name), bases, tail)
        linear = wave.closed.kind == "secondary"
        error = CLOSED_ERROR * _cancelling(wave.closed, size)
        return Output(wave, formula, size, error, "closed form", closed=True, scaled=linear)
    if not wave.terms:
        return Output(wave, "0.0", 0.0, 0.0, "zero: no order is left")
    formula, error, form = polynomials(wave, bases, tail, size)
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


def _closed(closed: Closed, own: str, bases: Bases, tail: Kernel) -> str:
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
