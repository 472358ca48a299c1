"""The choice of the fastest way to compute harmonic sums: shared cosines, polynomials or closed form.

A sum that gives both its harmonics and a closed form takes the form with the fewer operations an angle,
a division or a square root counting `ROOT` of them; the closed form only where its rounding stays below
`MOST_ROUNDING` u of the amplitude (its parts may cancel) or below that of the harmonics. Sums that share
a cosine share its lines.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import gcd, lcm

from symbalance.codegen.closed_forms import (
    displacement_formula,
    secondary_cosine,
    secondary_lines,
    velocity_formula,
)
from symbalance.codegen.evaluation_scheme import constant_prefix, sum_formula
from symbalance.codegen.expression_ir import NAME, Kernel
from symbalance.codegen.harmonic_sum import ClosedForm, HarmonicSum
from symbalance.codegen.keyword_defaults import ALL_ONE, KeywordDefaults
from symbalance.codegen.polynomials import family
from symbalance.codegen.shared_cosines import SharedCosines
from symbalance.text.reals import Exact, Real

ROOT = {"numpy": 3, "octave": 3}
"""Additions or multiplications one division or square root is worth; compiled: `COMPILED_ROOT`."""
COMPILED_ROOT = 6
"""The same where the source is compiled: there an addition costs less beside a division."""
CLOSED_FORM_ERROR = 8.0
"""What a closed form rounds, in u of the sum of its parts' sizes."""
MOST_ROUNDING = 12.0
"""Rounding, in u of the amplitude, a closed form may always have; else no more than the harmonics."""
OPERATOR = re.compile(r"[-+*]")


@dataclass(frozen=True)
class Output:
    """One planned output: its formula in the cosines, and what it may err, in u of the amplitude.

    `is_linear`: the formula is linear in the output's own constants, so that a unit may go into those.
    """

    harmonic_sum: HarmonicSum
    formula: str
    amplitude: float
    rounding: float
    form: str
    uses_closed_form: bool = False
    is_linear: bool = False

    def value(self, theta: Exact | Real) -> Real:
        """Return what the formula stands for at a crank angle, to its digits, 40 if it has none."""
        closed_form = self.harmonic_sum.closed_form
        if closed_form is not None and self.uses_closed_form:
            return closed_form.value(theta)
        return self.harmonic_sum.value(theta)

    @property
    def prefix(self) -> str:
        """What the names of its own constants begin with."""
        return constant_prefix(self.harmonic_sum.name)


@dataclass
class Plan:
    """Constants and lines of the shared cosines, then those of the outputs.

    `reduced_range`, `full_range` and `on_grid` compute the same quantities, named in `basis`: for angles
    to `cosines.LIMIT`, for any angle, at theta = 2 pi index/points. `tail` is what the outputs compute of
    them. All outputs repeat `step` times in a turn; `highest_step` is that of the fastest cosine.
    """

    reduced_range: Kernel
    full_range: Kernel
    on_grid: Kernel
    tail: Kernel
    basis: tuple[str, ...]
    outputs: tuple[Output, ...]
    ratio: Fraction
    step: Fraction
    highest_step: float
    shared: SharedCosines
    defaults: KeywordDefaults = ALL_ONE
    """The keywords where a call gives none: 1 each, or an engine's sizes at a speed."""

    @property
    def factors(self) -> set[str]:
        """The keywords that some output depends on."""
        return {factor for output in self.outputs for factor in output.harmonic_sum.unit.factors}


def choose_plan(sums: Sequence[HarmonicSum], ratio: Fraction, target: str) -> Plan:
    """Return the cheapest plan for `sums` on a target, by the rule above."""
    shared, tail = SharedCosines(), Kernel()
    outputs = tuple(_cheapest(harmonic_sum, target, shared, tail) for harmonic_sum in sums)
    used = tail.names().union(*(NAME.findall(o.formula) for o in outputs))
    reduced_range, names = shared.kernel("reduced_range", used)
    full_range, on_grid = shared.kernel("full_range", used)[0], shared.kernel("on_grid", used)[0]
    steps = shared.steps()
    under = lcm(*(s.denominator for s in steps))
    common = Fraction(gcd(*(int(s * under) for s in steps)), under)
    return Plan(
        reduced_range,
        full_range,
        on_grid,
        tail,
        names,
        outputs,
        ratio,
        common,
        float(max(steps)),
        shared,
    )


def _cheapest(harmonic_sum: HarmonicSum, target: str, shared: SharedCosines, tail: Kernel) -> Output:
    """Return an output by its harmonics or by its closed form, adding its lines and cosines."""
    if harmonic_sum.closed_form is None and not harmonic_sum.terms:
        if harmonic_sum.mean:
            return _by_mean(harmonic_sum, shared, tail)
        return Output(harmonic_sum, "0.0", 0.0, 0.0, "zero: no order is left")
    size = harmonic_sum.amplitude()
    if harmonic_sum.closed_form is None:
        return _by_harmonics(harmonic_sum, size, shared, tail)
    if not harmonic_sum.terms:
        return _by_closed_form(harmonic_sum, size, shared, tail)
    both = (_by_harmonics, _by_closed_form)
    drafts = [_draft(method, harmonic_sum, size, ROOT.get(target, COMPILED_ROOT)) for method in both]
    (by_harmonics, cost), (by_closed_form, other) = drafts
    cheaper = other < cost and by_closed_form.rounding <= max(MOST_ROUNDING, by_harmonics.rounding)
    return both[cheaper](harmonic_sum, size, shared, tail)


def _draft(
    method: Callable[[HarmonicSum, float, SharedCosines, Kernel], Output],
    harmonic_sum: HarmonicSum,
    size: float,
    root: int,
) -> tuple[Output, int]:
    """Return an output by one method and by itself, and the operations it takes an angle."""
    shared, tail = SharedCosines(), Kernel()
    output = method(harmonic_sum, size, shared, tail)
    lines, _ = shared.kernel("reduced_range", tail.names().union(NAME.findall(output.formula)))
    formulas = [*(line.formula for line in (*lines.lines, *tail.lines)), output.formula]
    counts = ((len(OPERATOR.findall(f)), f.count("/") + f.count("sqrt(")) for f in formulas)
    return output, sum(cheap + root * dear for cheap, dear in counts)


def _by_mean(harmonic_sum: HarmonicSum, shared: SharedCosines, tail: Kernel) -> Output:
    """Return a constant; a cosine times 0 gives it the angles' shape, and NaN where they are lost."""
    formula = f"{_mean(harmonic_sum, tail)} + 0.0*{shared.name(Fraction(1), Real(0))}"
    mean = abs(float(harmonic_sum.mean))
    return Output(harmonic_sum, formula, mean, 2.0, "the mean alone", is_linear=True)


def _mean(harmonic_sum: HarmonicSum, tail: Kernel) -> str:
    return tail.constant(f"{constant_prefix(harmonic_sum.name)}MEAN", harmonic_sum.mean, "the mean")


def _by_harmonics(harmonic_sum: HarmonicSum, size: float, shared: SharedCosines, tail: Kernel) -> Output:
    formula, error, form = sum_formula(harmonic_sum, shared, tail, size)
    if harmonic_sum.mean:  # rounded itself, and once more in the sum
        formula, error = f"{_mean(harmonic_sum, tail)} + {formula}", error + 1.5 * size
    return Output(harmonic_sum, formula, size, error / size + 1.0, form, is_linear=True)


def _by_closed_form(
    harmonic_sum: HarmonicSum, size: float, shared: SharedCosines, tail: Kernel
) -> Output:
    closed_form = harmonic_sum.closed_form
    assert closed_form is not None
    formula = _closed_formula(closed_form, constant_prefix(harmonic_sum.name), shared, tail)
    error = CLOSED_FORM_ERROR * _cancellation(closed_form, size)
    linear = closed_form.kind == "secondary"
    return Output(
        harmonic_sum, formula, size, error, "closed form", uses_closed_form=True, is_linear=linear
    )


def _cancellation(closed_form: ClosedForm, size: float) -> float:
    """Return how many times the parts of a closed form, summed in size, exceed the whole."""
    if closed_form.kind != "secondary":
        return 1.0
    ratio = float(closed_form.ratio)
    largest = max(1 / ratio, 1 / (ratio * ratio * (1 - 1 / ratio**2)) ** 0.5)
    parts = sum(abs(w) for w, _ in closed_form.places) * largest
    parts += sum(t.size for t in closed_form.first)
    return max(float(parts) / size, 1.0)


def _closed_formula(closed_form: ClosedForm, prefix: str, shared: SharedCosines, tail: Kernel) -> str:
    if closed_form.kind == "displacement":
        return displacement_formula(tail, closed_form, shared.square(closed_form))
    if closed_form.kind == "velocity":
        phase = Real(-closed_form.places[0][1])
        cosine, sine = shared.name(Fraction(1), phase), shared.name(Fraction(1), phase + 0.25)
        return velocity_formula(tail, closed_form, cosine, sine)
    parts = []
    if closed_form.first:
        first = family(closed_form.first)
        weight = tail.constant(f"{prefix}FIRST", first.even[1], "the first order")
        parts.append(f"{weight}*{shared.name(first.step, first.phase)}")
    for i, (weight, turns) in enumerate(closed_form.places):
        cosine = secondary_cosine(closed_form.ratio, turns)
        name = shared.name(cosine.step, cosine.phase)
        value = secondary_lines(tail, closed_form.ratio, name, name.removeprefix("c"))
        parts.append(f"{tail.constant(f'{prefix}ABOVE_{i}', weight)}*{value}")
    return " + ".join(parts)
