"""From waves to a plan: which cosines, which polynomial, or the closed form, by a stated rule.

A wave that gives both its harmonics and a closed form takes the form with the fewer operations an angle,
a division or a square root counting `ROOT` of them; the closed form only where its rounding stays below
`MOST_ROUNDING` u of the amplitude (its parts may cancel) or below that of the harmonics. Waves that share
a cosine share its lines.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import gcd, lcm

from symbalance.codegen.bases import Bases
from symbalance.codegen.closed import (
    displacement_lines,
    secondary_cosine,
    secondary_lines,
    velocity_lines,
)
from symbalance.codegen.kernels import NAME, Kernel
from symbalance.codegen.polynomials import family
from symbalance.codegen.waves import Closed, Wave
from symbalance.codegen.ways import polynomials, prefix
from symbalance.text.reals import Exact, Real

ROOT = {"numpy": 3, "octave": 3}
"""Additions or multiplications one division or square root is worth; compiled: `COMPILED_ROOT`."""
COMPILED_ROOT = 6
CLOSED_ERROR = 8.0
"""What a closed form rounds, in u of the sum of its parts' sizes."""
MOST_ROUNDING = 12.0
"""Rounding, in u of the amplitude, a closed form may always have; else no more than the harmonics."""
OPERATOR = re.compile(r"[-+*]")


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

    def value(self, theta: Exact | Real) -> Real:
        """Return what the formula stands for at a crank angle, to its digits, 40 if it has none."""
        closed = self.wave.closed
        return closed.value(theta) if closed is not None and self.closed else self.wave.value(theta)

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
    """Return an output by its harmonics or by its closed form, adding its lines and bases."""
    if wave.closed is None and not wave.terms:
        if wave.mean:
            return _by_mean(wave, bases, tail)
        return Output(wave, "0.0", 0.0, 0.0, "zero: no order is left")
    size = wave.amplitude()
    if wave.closed is None:
        return _by_harmonics(wave, size, bases, tail)
    if not wave.terms:
        return _by_closed_form(wave, size, bases, tail)
    both = (_by_harmonics, _by_closed_form)
    drafts = [_draft(way, wave, size, ROOT.get(target, COMPILED_ROOT)) for way in both]
    (harmonics, cost), (closed, other) = drafts
    cheaper = other < cost and closed.rounding <= max(MOST_ROUNDING, harmonics.rounding)
    return both[cheaper](wave, size, bases, tail)


def _draft(
    way: Callable[[Wave, float, Bases, Kernel], Output], wave: Wave, size: float, root: int
) -> tuple[Output, int]:
    """Return an output made one way by itself, and the operations it takes an angle."""
    bases, tail = Bases(), Kernel()
    output = way(wave, size, bases, tail)
    near, _ = bases.kernel("near", tail.names().union(NAME.findall(output.formula)))
    formulas = [*(line.formula for line in (*near.lines, *tail.lines)), output.formula]
    counted = ((len(OPERATOR.findall(f)), f.count("/") + f.count("sqrt(")) for f in formulas)
    return output, sum(plain + root * dear for plain, dear in counted)


def _by_mean(wave: Wave, bases: Bases, tail: Kernel) -> Output:
    """Return a constant; a cosine times 0 gives it the angles' shape, and NaN where they are lost."""
    formula = f"{_mean(wave, tail)} + 0.0*{bases.name(Fraction(1), Real(0))}"
    return Output(wave, formula, abs(float(wave.mean)), 2.0, "the mean alone", scaled=True)


def _mean(wave: Wave, tail: Kernel) -> str:
    return tail.constant(f"{prefix(wave.name)}MEAN", wave.mean, "the mean")


def _by_harmonics(wave: Wave, size: float, bases: Bases, tail: Kernel) -> Output:
    formula, error, form = polynomials(wave, bases, tail, size)
    if wave.mean:
        formula, error = f"{_mean(wave, tail)} + {formula}", error + 1.5 * size
    return Output(wave, formula, size, error / size + 1.0, form, scaled=True)


def _by_closed_form(wave: Wave, size: float, bases: Bases, tail: Kernel) -> Output:
    assert wave.closed is not None
    formula = _closed(wave.closed, prefix(wave.name), bases, tail)
    error = CLOSED_ERROR * _cancelling(wave.closed, size)
    linear = wave.closed.kind == "secondary"
    return Output(wave, formula, size, error, "closed form", closed=True, scaled=linear)


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
        phase = Real(-closed.places[0][1])
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
