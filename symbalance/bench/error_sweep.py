"""Error against run time, over engine, rod ratio, order and target: table, CSV and picture.

The true values are exact kinematics of every cylinder (`true_values`); nothing of `symbalance.codegen`
takes part in them. Errors are parts of the amplitude of the output, not of one cylinder's force.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict, dataclass, field, fields
from fractions import Fraction
from importlib import import_module
from itertools import groupby
from typing import Any

import numpy as np

from symbalance.bench.accuracy_alternatives import (
    HEYOKA,
    HEYOKA_POWERS,
    LAMBDIFY,
    NUMBA_COS,
    PER_CYLINDER,
    alternative,
    per_cylinder,
    present,
)
from symbalance.bench.evaluated_outputs import (
    ALL,
    NUMBA,
    NUMPY,
    C,
    Candidate,
    EvaluatedOutput,
    Floats,
    calls,
    from_plan,
)
from symbalance.bench.speed import angles
from symbalance.bench.timing import in_turn, progress
from symbalance.bench.true_values import Points, TrueValues, U, accelerations_at, weights

FARTHEST = 1e6
TWO_TURNS = 4 * np.pi
RATIOS = tuple(Fraction(text) for text in ("5", "4", "3", "5/3", "10/9"))
ORDERS = (2, 4, 8, 12, 16, 24, 48, None)
ENGINES = (
    ("inline-1", "force.vertical"),
    ("inline-4", "force.vertical"),
    ("inline-5", "couple.vertical"),
    ("v8-90", "force.vertical"),
)
CANCELLED = (LAMBDIFY, NUMBA_COS, HEYOKA, HEYOKA_POWERS)
"""The alternatives that start from the cancelled sum, and so have an order."""
COUNT = 100_000
MARKERS = {
    NUMPY: "o", NUMBA: "s", C: "^",
    LAMBDIFY: "P", NUMBA_COS: "X", HEYOKA: "v", HEYOKA_POWERS: "*", PER_CYLINDER: "D",
}  # fmt: skip
LABELS = {
    NUMPY: "symbalance, NumPy",
    NUMBA: "symbalance, Numba",
    C: "symbalance, C",
    LAMBDIFY: "lambdify of the cancelled sum",
    NUMBA_COS: "Numba with math.cos of it",
    HEYOKA: "heyoka with vector cosines of it",
    HEYOKA_POWERS: "heyoka with powers of one cosine",
    PER_CYLINDER: "NumPy per cylinder",
}
SYMBALANCE = (NUMPY, NUMBA, C)
DRAWN_RATIOS = ("4", "5/3", "10/9")
COLOURS = ("#0072b2", "#009e73", "#d55e00", "#cc79a7", "#555555")
ALL_ORDERS_STYLE = {"markeredgecolor": "black", "markeredgewidth": 1.2}
LOWEST = 3e-17
"""What an error of 0 is drawn at: a logarithmic axis has no 0."""
RESOLUTION, SHADES = 130, 128


@dataclass(frozen=True)
class RelativeError:
    """The largest |value - true| as a part of the amplitude: to a million radians, and to two turns."""

    largest: float
    near: float

    @property
    def in_u(self) -> float:
        """The largest in u = 2^-53 of the amplitude."""
        return self.largest / U


@dataclass(frozen=True)
class Judge:
    """True values of an output at some angles, all orders; `amplitude` is the largest over two turns."""

    angles: Floats
    true_values: TrueValues
    amplitude: float

    @classmethod
    def of(cls, case: EvaluatedOutput, count: int = 300) -> Judge:
        """Return the true values of a case, whatever its order, at about `count` angles."""
        angles = comparison_angles(count)
        turns = np.linspace(0.0, TWO_TURNS, 14401)
        amplitude = float(np.abs(per_cylinder(case)(turns)).max())
        every = accelerations_at(Points(angles), weights(case.preset_engine, case.output), case.rod_ratio)
        return cls(angles, every, amplitude)

    def error(self, function: Callable[[Floats], Floats]) -> RelativeError:
        """Return how far a function is off; NaN where it gives one."""
        relative = self.true_values.off(function(self.angles)) / self.amplitude
        within = np.abs(self.angles) <= TWO_TURNS
        return RelativeError(float(relative.max()), float(relative[within].max()))


def comparison_angles(count: int) -> Floats:
    """Return angles: over two turns, on to a million radians, and close to dead centres."""
    random = np.random.default_rng(20)
    third = max(count // 3, 2)
    signs = random.choice((-1.0, 1.0), third)
    turns = random.uniform(-TWO_TURNS, TWO_TURNS, third)
    far = signs * 10 ** random.uniform(np.log10(TWO_TURNS), np.log10(FARTHEST), third)
    centres = random.integers(-7, 8, third) * (np.pi / 2)
    near = centres + signs * 10 ** random.uniform(-9.0, -1.0, third)
    return np.concatenate(([0.0, FARTHEST, -FARTHEST], turns, far, near))


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
class ErrorSweep:
    """What is swept over; `count` angles are timed, values at `comparisons` others judged.

    Orders past the last that shows in a double are left out: they are "all".
    """

    engines: Sequence[tuple[str, str]] = ENGINES
    ratios: Sequence[Fraction] = RATIOS
    orders: Sequence[int | None] = ORDERS
    count: int = COUNT
    comparisons: int = 300
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
        judge = Judge.of(EvaluatedOutput(engine, output, None, ratio), self.comparisons)
        showing = EvaluatedOutput(engine, output, None, ratio).harmonic_sum.through
        for order in self.orders:
            case = EvaluatedOutput(engine, output, order, ratio)
            if case.harmonic_sum.terms and (order is None or order <= showing):
                yield _entry(case, targets, judge)


@dataclass
class _Entry:
    """One case: all candidates with their form and error, and the least times so far.

    Times are taken in several passes over all cases, so that a noisy minute spoils none.
    """

    case: EvaluatedOutput
    candidates: dict[str, Candidate]
    forms: dict[str, str]
    errors: dict[str, RelativeError]
    least: dict[str, float] = field(default_factory=dict)

    def time(self, theta: Floats, out: Floats, rounds: int, budget: float) -> None:
        """Time all candidates in turn, and keep the least."""
        functions = calls(self.candidates, theta, out)
        for name, times in in_turn(functions, rounds, budget, least=1).items():
            self.least[name] = min(times.best, self.least.get(name, times.best))

    def points(self, count: int) -> Iterator[Point]:
        """Yield the points, candidate by candidate."""
        case = self.case
        for name, seconds in self.least.items():
            yield Point(
                case.engine,
                case.output,
                str(case.rod_ratio),
                case.reach,
                name,
                self.forms[name],
                1e9 * seconds / count,
                self.errors[name].largest,
                self.errors[name].in_u,
                self.errors[name].near,
            )


def _entry(case: EvaluatedOutput, targets: Sequence[str], judge: Judge) -> _Entry:
    """Return a case with its candidates; the sum over the cylinders has no order: it is among "all"."""
    candidates, forms = {}, {}
    for target in targets:
        plan = case.plan(target)
        candidates[target], forms[target] = from_plan(plan, target), plan.outputs[0].form
    for name in [*CANCELLED, PER_CYLINDER] if case.order is None else CANCELLED:
        if name in present():
            candidates[name] = alternative(case, name)
            forms[name] = "exact kinematics" if name == PER_CYLINDER else "sum of cosines"
    return _Entry(case, candidates, forms, {name: judge.error(one) for name, one in candidates.items()})


def points_csv(points: Sequence[Point]) -> str:
    """Return all points as comma-separated values, their names in the first line."""
    text = io.StringIO()
    writer = csv.DictWriter(text, [f.name for f in fields(Point)], lineterminator="\n")
    writer.writeheader()
    writer.writerows(asdict(point) for point in points)
    return text.getvalue()


def points_table(points: Sequence[Point]) -> str:
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


def draw_points(points: Sequence[Point]) -> dict[str, bytes]:
    """Return the picture as PNG and PDF, by the ending of the file's name."""
    figure = _figure(points)
    png, pdf = io.BytesIO(), io.BytesIO()
    figure.savefig(png, format="png", dpi=RESOLUTION)
    figure.savefig(pdf, format="pdf", metadata={"CreationDate": None})
    return {".png": _smaller(png), ".pdf": pdf.getvalue()}


def _smaller(png: io.BytesIO) -> bytes:
    """Return the same picture in a palette of its own, a third of the size."""
    smaller = io.BytesIO()
    with import_module("PIL.Image").open(png) as picture:
        picture.convert("RGB").quantize(SHADES).save(smaller, format="png", optimize=True)
    return smaller.getvalue()


def _figure(points: Sequence[Point]) -> Any:
    panels = [(head, list(group)) for head, group in groupby(points, lambda p: (p.engine, p.output))]
    rows = (len(panels) + 1) // 2
    figure = import_module("matplotlib.figure").Figure(
        figsize=(10.5, 4.1 * rows + 1.1), layout="constrained"
    )
    axes = figure.subplots(rows, 2, sharex=True, sharey=True, squeeze=False).flat
    ratios = [r for r in dict.fromkeys(p.rod_ratio for p in points) if r in DRAWN_RATIOS]
    colours: dict[str, str] = dict(zip(ratios, COLOURS, strict=False))
    for axis, (head, group) in zip(axes, panels, strict=False):
        _panel(axis, f"{head[0]}: {head[1]}", group, colours)
    for axis in list(axes)[len(panels) :]:
        axis.set_visible(False)
    figure.supxlabel("time per crank angle, ns (one thread)")
    figure.supylabel("largest error to $10^6$ rad, relative to the amplitude")
    names = [name for name in MARKERS if any(p.target == name for p in points)]
    figure.legend(
        handles=_legend(names, colours),
        loc="outside upper center",
        ncols=3,
        frameon=False,
        fontsize=10,
    )
    return figure


def _panel(axis: Any, title: str, points: Sequence[Point], colours: dict[str, str]) -> None:
    """Draw one engine: a line runs through the orders of one candidate at one rod ratio."""
    axis.set(xscale="log", yscale="log", title=title, ylim=(LOWEST, 2.0))
    axis.axhline(U, color="0.6", linewidth=0.8, linestyle=":")
    across = axis.get_yaxis_transform()
    axis.text(0.985, U * 1.3, "u = $2^{-53}$", transform=across, ha="right", va="bottom", fontsize=8)
    for (ratio, name), group in _by_line(points):
        if ratio in colours:
            truncated = [p for p in group if p.order != ALL]
            whole = [p for p in group if p.order == ALL]
            style = _style(name, colours[ratio])
            axis.plot(*_places(truncated), **style)
            whole_style = style | ALL_ORDERS_STYLE | {"markerfacecolor": colours[ratio]}
            axis.plot(*_places(whole), **whole_style)
    _name_orders(
        axis, [p for p in points if p.target == NUMPY and p.rod_ratio == next(iter(colours), "")]
    )
    axis.xaxis.set_major_formatter("{x:g}")
    axis.grid(which="major", color="0.92", linewidth=0.6)
    axis.set_axisbelow(True)


def _by_line(points: Sequence[Point]) -> Any:
    def key(point: Point) -> tuple[str, str]:
        return point.rod_ratio, point.target

    return [(head, list(group)) for head, group in groupby(sorted(points, key=key), key)]


def _name_orders(axis: Any, points: Sequence[Point]) -> None:
    """Write the order beside the points of one line, as long as it changes the error."""
    for k, point in enumerate(points):
        if point.error_relative > 1e-14:
            where = point.ns_per_point, point.error_relative
            text = f"order {point.order}" if k == 0 else point.order
            axis.annotate(
                text, where, (-7, 0), textcoords="offset points", ha="right", va="center", fontsize=8
            )


def _style(name: str, colour: str) -> dict[str, Any]:
    """Return how a candidate is drawn: symbalance filled, on a line; alternatives hollow, on dashes."""
    is_symbalance = name in SYMBALANCE
    return {
        "marker": MARKERS[name],
        "color": colour,
        "markerfacecolor": colour if is_symbalance else "white",
        "markersize": 6 if is_symbalance else 6.5,
        "linewidth": 0.9 if is_symbalance else 0.6,
        "linestyle": "-" if is_symbalance else "--",
    }


def _places(points: Sequence[Point]) -> tuple[list[float], list[float]]:
    return [p.ns_per_point for p in points], [max(p.error_relative, LOWEST) for p in points]


def _legend(names: Sequence[str], colours: dict[str, str]) -> list[Any]:
    """Return three columns: symbalance, the alternatives, the rod ratios."""
    Line2D = import_module("matplotlib.lines").Line2D

    def mark(name: str) -> Any:
        return Line2D([], [], label=LABELS[name], **_style(name, "black"))

    nothing = Line2D([], [], linestyle="none", label=" ")
    whole = {"marker": "o", "color": "0.8", "linestyle": "none"} | ALL_ORDERS_STYLE
    every = Line2D([], [], label="every order that shows in a double", **whole)
    columns = [
        [mark(name) for name in names if name in SYMBALANCE],
        [mark(name) for name in names if name not in SYMBALANCE] + [every],
        [
            Line2D([], [], color=colour, linewidth=3, label=f"ρ = {1 / float(Fraction(ratio)):.2g}")
            for ratio, colour in colours.items()
        ],
    ]
    rows = max(map(len, columns))
    return [line for column in columns for line in column + [nothing] * (rows - len(column))]
