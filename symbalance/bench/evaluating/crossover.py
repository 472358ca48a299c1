"""When a closed form pays: its time and its error beside a polynomial of so many harmonics.

Both forms are made here, of one wave each, whatever the rule of `codegen.plans` says; which one that
takes for every order that shows in a double is told beside them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from itertools import pairwise

import numpy as np

from symbalance.bench.evaluating.candidates import Candidate, Floats, calls, from_plan
from symbalance.bench.evaluating.cases import Case
from symbalance.bench.evaluating.rounds import in_turn
from symbalance.bench.evaluating.speed import angles, short
from symbalance.bench.evaluating.truth import truth
from symbalance.bench.timing import progress
from symbalance.codegen.plans import choose_plan

COUNT, PASSES = 100_000, 4
NOT_REACHED = float("inf")
CASES = tuple(
    Case(engine, output, None, Fraction(ratio))
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
    """One wave on one target: its candidates by the number of harmonics, 0 being the closed form."""

    case: Case
    target: str
    places: int
    candidates: dict[int, Candidate]
    every: int
    closed_is_taken: bool
    closed_u: float
    polynomial_u: float
    least: dict[int, float] = field(default_factory=dict)

    def time(self, theta: Floats, out: Floats) -> None:
        """Time all in turn, and keep the least, nanoseconds an angle."""
        functions = calls(self.candidates, theta, out)
        for count, times in in_turn(functions, 3, 0.03, least=1).items():
            spent = 1e9 * times.best / theta.size
            self.least[count] = min(spent, self.least.get(count, spent))

    @property
    def closed(self) -> float:
        """The closed form's time."""
        return self.least[0]

    @property
    def polynomials(self) -> dict[int, float]:
        """The polynomials' times, by the number of harmonics."""
        return {count: spent for count, spent in sorted(self.least.items()) if count}

    @property
    def pays_from(self) -> float:
        """The number of harmonics from which the closed form is faster, by straight lines between."""
        known = list(self.polynomials.items())
        for (few, fast), (many, slow) in pairwise(known):
            if fast < self.closed <= slow:
                return few + (many - few) * (self.closed - fast) / (slow - fast)
        return known[0][0] if known[0][1] >= self.closed else NOT_REACHED


def crossovers(cases: Sequence[Case], targets: Sequence[str], counts: Sequence[int]) -> list[Crossover]:
    """Measure both forms of some waves on every target, in passes over all of them."""
    rows = [_crossover(case, target, counts) for case in cases for target in targets]
    theta, out = angles(COUNT), np.ones(COUNT)
    for _ in range(PASSES):
        for row in rows:
            row.time(theta, out)
    return rows


def _crossover(case: Case, target: str, counts: Sequence[int]) -> Crossover:
    progress(f"closed form: {case.engine} at lambda = {case.known_ratio}, {target}")
    wave, ratio = case.wave, case.known_ratio
    step = int(wave.terms[-1].order - wave.terms[-2].order)
    most = step * (max(*counts, len(wave.terms)) + 1)
    longer = Case(case.engine, case.output, most, ratio).wave.terms
    waves = {0: replace(wave, terms=())}
    waves |= {n: replace(wave, terms=longer[:n], closed_form=None) for n in (*counts, len(wave.terms))}
    found = {n: from_plan(choose_plan([one], ratio, target), target) for n, one in waves.items()}
    known, places = truth(case, 150), len(wave.closed_form.places) if wave.closed_form else 0
    every = len(wave.terms)
    taken = choose_plan([wave], ratio, target).outputs[0].uses_closed_form
    errors = known.error(found[0]).in_u, known.error(found[every]).in_u
    return Crossover(case, target, places, found, every, taken, *errors)


def crossover_table(rows: Sequence[Crossover]) -> str:
    """Return a line for each wave and target."""
    counts = sorted(set.intersection(*(set(row.polynomials) for row in rows)))
    heads = "".join(f"{n:>6}" for n in counts)
    lines = [f"{'harmonics':<28}{heads}{'all':>12}{'closed':>8}{'places':>7}{'from':>6}  taken"]
    for row in rows:
        name = f"{row.case.engine} λ = {row.case.known_ratio}, {row.target}"
        cells = "".join(f"{short(row.polynomials[n]):>6}" for n in counts)
        every = f"{short(row.polynomials[row.every])} ({row.every})"
        pays = "never" if row.pays_from == NOT_REACHED else f"{row.pays_from:.0f}"
        taken = f"{row.closed_u:.1f} u" if row.closed_is_taken else f"{row.polynomial_u:.1f} u"
        other = f"{row.polynomial_u:.1f}" if row.closed_is_taken else f"{row.closed_u:.1f}"
        form = "closed" if row.closed_is_taken else "harmonics"
        lines.append(
            f"{name:<28}{cells}{every:>12}{short(row.closed):>8}{row.places:>7}{pays:>6}  "
            f"{form}, {taken} (the other {other})"
        )
    lines += [
        "nanoseconds an angle; all (how many): every order that shows; from: the number of harmonics",
        "from which the closed form is faster; taken: what the rule takes for all of them, and its error",
    ]
    return "\n".join(lines)
