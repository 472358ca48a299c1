"""Error against run time: over engine, rod ratio, order and target, the alternatives beside them."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass, field, fields
from fractions import Fraction
from itertools import groupby

import numpy as np

from symbalance.bench.evaluating.alternatives import (
    LAMBDIFY,
    NUMBA_COS,
    PER_CYLINDER,
    alternative,
    present,
)
from symbalance.bench.evaluating.candidates import Candidate, Floats, calls, from_plan
from symbalance.bench.evaluating.cases import ALL, Case
from symbalance.bench.evaluating.rounds import in_turn
from symbalance.bench.evaluating.speed import angles
from symbalance.bench.evaluating.truth import Error, Truth, truth
from symbalance.bench.timing import progress

RATIOS = tuple(Fraction(text) for text in ("5", "4", "3", "5/3", "10/9"))
ORDERS = (2, 4, 8, 12, 16, 24, 48, None)
ENGINES = (
    ("inline-1", "force.vertical"),
    ("inline-4", "force.vertical"),
    ("inline-5", "couple.vertical"),
    ("v8-90", "force.vertical"),
)
CANCELLED = (LAMBDIFY, NUMBA_COS)
COUNT = 100_000


@dataclass(frozen=True)
class Point:
    """One candidate on one case: its time and its error, as parts of the amplitude and in u of it."""

    engine: str
    output: str
    rod_ratio: str
    order: str
    target: str
    form: str
    ns_per_point: float
    error_relative: float
    error_u: float
    error_two_turns: float


@dataclass(frozen=True)
class Sweep:
    """What is swept over; `count` angles are timed, some `known` ones are held against the truth.

    Orders past the last that shows in a double are left out: they are "all".
    """

    engines: Sequence[tuple[str, str]] = ENGINES
    ratios: Sequence[Fraction] = RATIOS
    orders: Sequence[int | None] = ORDERS
    count: int = COUNT
    known: int = 300
    rounds: int = 3
    passes: int = 3
    budget: float = 0.02

    def points(self, targets: Sequence[str]) -> list[Point]:
        """Return all points, engine by engine."""
        entries = [
            entry
            for engine, output in self.engines
            for ratio in self.ratios
            for entry in self._of(engine, output, ratio, targets)
        ]
        theta, out = angles(self.count), np.ones(self.count)
        for number in range(self.passes):
            progress(f"timing {len(entries)} cases, {number + 1} of {self.passes}")
            for entry in entries:
                entry.time(theta, out, self.rounds, self.budget)
        return [point for entry in entries for point in entry.points(self.count)]

    def _of(self, engine: str, output: str, ratio: Fraction, targets: Sequence[str]) -> Iterator[_Entry]:
        progress(f"{engine} {output} at rho = {1 / float(ratio):.3g}")
        known = truth(Case(engine, output, None, ratio), self.known)
        showing = Case(engine, output, None, ratio).wave.through
        for order in self.orders:
            case = Case(engine, output, order, ratio)
            if case.wave.terms and (order is None or order <= showing):
                yield _entry(case, targets, known)


@dataclass
class _Entry:
    """One case: all candidates with their form and error, and the least times seen so far.

    Times are taken in several passes over all cases, so that a noisy minute spoils none.
    """

    case: Case
    candidates: dict[str, Candidate]
    forms: dict[str, str]
    errors: dict[str, Error]
    least: dict[str, float] = field(default_factory=dict)

    def time(self, theta: Floats, out: Floats, rounds: int, budget: float) -> None:
        """Time all candidates in turn, and keep the least."""
        functions = calls(self.candidates, theta, out)
        for name, times in in_turn(functions, rounds, budget, least=1).items():
            self.least[name] = min(times.best, self.least.get(name, times.best))

    def points(self, count: int) -> Iterator[Point]:
        """Yield what was found, candidate by candidate."""
        case = self.case
        for name, spent in self.least.items():
            yield Point(
                case.engine,
                case.output,
                str(case.known_ratio),
                case.reach,
                name,
                self.forms[name],
                1e9 * spent / count,
                self.errors[name].largest,
                self.errors[name].in_u,
                self.errors[name].near,
            )


def _entry(case: Case, targets: Sequence[str], known: Truth) -> _Entry:
    """Return a case with its candidates; the sum over the cylinders has no order: it is among "all"."""
    found, forms = {}, {}
    for target in targets:
        planned = case.planned(target)
        found[target], forms[target] = from_plan(planned, target), planned.outputs[0].form
    for name in [*CANCELLED, PER_CYLINDER] if case.order is None else CANCELLED:
        if name in present():
            found[name] = alternative(case, name)
            forms[name] = "exact kinematics" if name == PER_CYLINDER else "sum of cosines"
    return _Entry(case, found, forms, {name: known.error(one) for name, one in found.items()})


def as_csv(points: Sequence[Point]) -> str:
    """Return all points as comma-separated values, their names in the first line."""
    text = io.StringIO()
    writer = csv.DictWriter(text, [f.name for f in fields(Point)], lineterminator="\n")
    writer.writeheader()
    writer.writerows(asdict(point) for point in points)
    return text.getvalue()


def sweep_table(points: Sequence[Point]) -> str:
    """Return all points, a line for each case: nanoseconds an angle and the error of every candidate."""
    names = list(dict.fromkeys(p.target for p in points))
    lines = [f"{'order':<8}" + "".join(f"{name:>22}" for name in names)]
    for (engine, output, ratio), group in groupby(points, lambda p: (p.engine, p.output, p.rod_ratio)):
        lines.append(f"{engine} {output}, lambda = {ratio}, rho = {1 / float(Fraction(ratio)):.3g}")
        for order, row in groupby(group, lambda p: p.order):
            cells = {p.target: _cell(p) for p in row}
            lines.append(f"  {order:<6}" + "".join(f"{cells.get(name, ''):>22}" for name in names))
    lines += [
        "nanoseconds an angle; largest error to a million radians, of the amplitude (and to two turns);",
        f"{ALL}: every order that shows in a double; u = 1.1e-16",
    ]
    return "\n".join(lines)


def _cell(point: Point) -> str:
    return f"{point.ns_per_point:.3g}  {point.error_relative:.0e} ({point.error_two_turns:.0e})"
