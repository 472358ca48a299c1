"""The number of harmonics from which a closed form is faster than a polynomial, with the errors of both.

Both forms are written here, of one harmonic sum each, whatever the rule of `codegen.plans` chooses; its
choice for every order that shows in a double stands beside them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from itertools import pairwise

import numpy as np

from symbalance.bench.error_sweep import Judge
from symbalance.bench.evaluated_outputs import Candidate, EvaluatedOutput, Floats, calls, from_plan
from symbalance.bench.speed import angles, three_digits
from symbalance.bench.timing import in_turn, progress
from symbalance.codegen.plans import choose_plan

COUNT, PASSES = 100_000, 4
NEVER = float("inf")
CASES = tuple(
    EvaluatedOutput(engine, output, None, Fraction(ratio))
    for engine, output in (
        ("inline-1", "force.vertical"),
        ("inline-4", "force.vertical"),
        ("inline-5", "couple.vertical"),
        ("v8-90", "force.vertical"),
    )
    for ratio in ("5/3", "10/9")
)
COUNTS = (2, 4, 6, 8, 12, 16, 24)


@dataclass
class Crossover:
    """One harmonic sum on one target: candidates by the number of harmonics, 0 being the closed form."""

    case: EvaluatedOutput
    target: str
    places: int
    candidates: dict[int, Candidate]
    every: int
    rule_is_closed: bool
    closed_u: float
    polynomial_u: float
    least: dict[int, float] = field(default_factory=dict)

    def time(self, theta: Floats, out: Floats) -> None:
        """Time all in turn, and keep the least, nanoseconds an angle."""
        functions = calls(self.candidates, theta, out)
        for count, times in in_turn(functions, 3, 0.03, least=1).items():
            nanoseconds = 1e9 * times.best / theta.size
            self.least[count] = min(nanoseconds, self.least.get(count, nanoseconds))

    @property
    def closed_form(self) -> float:
        """The closed form's time."""
        return self.least[0]

    @property
    def polynomials(self) -> dict[int, float]:
        """The polynomials' times, by the number of harmonics."""
        return {count: time for count, time in sorted(self.least.items()) if count}

    @property
    def pays_from(self) -> float:
        """The number of harmonics from which the closed form is faster, by straight lines between."""
        times = list(self.polynomials.items())
        for (few, fast), (many, slow) in pairwise(times):
            if fast < self.closed_form <= slow:
                return few + (many - few) * (self.closed_form - fast) / (slow - fast)
        return times[0][0] if times[0][1] >= self.closed_form else NEVER


def crossovers(
    cases: Sequence[EvaluatedOutput], targets: Sequence[str], counts: Sequence[int]
) -> list[Crossover]:
    """Measure both forms of some harmonic sums on every target, in passes over all of them."""
    rows = [_crossover(case, target, counts) for case in cases for target in targets]
    theta, out = angles(COUNT), np.ones(COUNT)
    for _ in range(PASSES):
        for row in rows:
            row.time(theta, out)
    return rows


def _crossover(case: EvaluatedOutput, target: str, counts: Sequence[int]) -> Crossover:
    progress(f"closed form: {case.engine} at lambda = {case.rod_ratio}, {target}")
    whole, ratio = case.harmonic_sum, case.rod_ratio
    step = int(whole.terms[-1].order - whole.terms[-2].order)
    most = step * (max(*counts, len(whole.terms)) + 1)
    longer = EvaluatedOutput(case.engine, case.output, most, ratio).harmonic_sum.terms
    sums = {0: replace(whole, terms=())}
    sums |= {n: replace(whole, terms=longer[:n], closed_form=None) for n in (*counts, len(whole.terms))}
    candidates = {n: from_plan(choose_plan([one], ratio, target), target) for n, one in sums.items()}
    judge, places = (
        Judge.of(case, 150),
        len(whole.closed_form.places) if whole.closed_form else 0,
    )
    every = len(whole.terms)
    is_closed = choose_plan([whole], ratio, target).outputs[0].uses_closed_form
    errors = judge.error(candidates[0]).in_u, judge.error(candidates[every]).in_u
    return Crossover(case, target, places, candidates, every, is_closed, *errors)


def crossover_table(rows: Sequence[Crossover]) -> str:
    """Return a line for each sum and target."""
    counts = sorted(set.intersection(*(set(row.polynomials) for row in rows)))
    heads = "".join(f"{n:>6}" for n in counts)
    lines = [f"{'harmonics':<28}{heads}{'all':>12}{'closed':>8}{'places':>7}{'from':>6}  rule"]
    for row in rows:
        name = f"{row.case.engine} λ = {row.case.rod_ratio}, {row.target}"
        cells = "".join(f"{three_digits(row.polynomials[n]):>6}" for n in counts)
        every = f"{three_digits(row.polynomials[row.every])} ({row.every})"
        pays = "never" if row.pays_from == NEVER else f"{row.pays_from:.0f}"
        forms = [("closed", row.closed_u), ("harmonics", row.polynomial_u)]
        (form, error), (_, other) = forms if row.rule_is_closed else reversed(forms)
        lines.append(
            f"{name:<28}{cells}{every:>12}{three_digits(row.closed_form):>8}{row.places:>7}{pays:>6}  "
            f"{form}, {error:.1f} u (the other {other:.1f})"
        )
    lines += [
        "nanoseconds an angle; all (how many): every order that shows; from: the number of harmonics",
        "from which the closed form is faster; rule: what `plans` chooses for all of them, and its error",
    ]
    return "\n".join(lines)
