"""Error against run time as a picture: a panel for each engine, a colour for each rod ratio."""

from __future__ import annotations

import io
from collections.abc import Sequence
from fractions import Fraction
from importlib import import_module
from itertools import groupby
from typing import Any

from symbalance.bench.evaluating.alternatives import LAMBDIFY, NUMBA_COS, PER_CYLINDER
from symbalance.bench.evaluating.candidates import NUMBA, NUMPY, C
from symbalance.bench.evaluating.cases import ALL
from symbalance.bench.evaluating.sweep import Point
from symbalance.bench.evaluating.truth import UNIT

MARKERS = {NUMPY: "o", NUMBA: "s", C: "^", LAMBDIFY: "P", NUMBA_COS: "X", PER_CYLINDER: "D"}
NAMES = {
    NUMPY: "symbalance, NumPy",
    NUMBA: "symbalance, Numba",
    C: "symbalance, C",
    LAMBDIFY: "lambdify of the cancelled sum",
    NUMBA_COS: "Numba with math.cos of it",
    PER_CYLINDER: "NumPy per cylinder",
}
OURS = (NUMPY, NUMBA, C)
SHOWN = ("4", "5/3", "10/9")
COLOURS = ("#0072b2", "#009e73", "#d55e00", "#cc79a7", "#555555")
EVERYTHING = {"markeredgecolor": "black", "markeredgewidth": 1.2}
LOWEST = 3e-17
RESOLUTION, SHADES = 130, 128


def drawn(points: Sequence[Point]) -> dict[str, bytes]:
    """Return the picture as PNG and PDF, by the ending of the file's name."""
    figure = _figure(points)
    png, pdf = io.BytesIO(), io.BytesIO()
    figure.savefig(png, format="png", dpi=RESOLUTION)
    figure.savefig(pdf, format="pdf", metadata={"CreationDate": None})
    return {".png": _smaller(png), ".pdf": pdf.getvalue()}


def _smaller(png: io.BytesIO) -> bytes:
    """Return the same picture in a palette of its own, a third of the size."""
    found = io.BytesIO()
    with import_module("PIL.Image").open(png) as picture:
        picture.convert("RGB").quantize(SHADES).save(found, format="png", optimize=True)
    return found.getvalue()


def _figure(points: Sequence[Point]) -> Any:
    panels = [(head, list(group)) for head, group in groupby(points, lambda p: (p.engine, p.output))]
    rows = (len(panels) + 1) // 2
    figure = import_module("matplotlib.figure").Figure(
        figsize=(10.5, 4.1 * rows + 1.1), layout="constrained"
    )
    axes = figure.subplots(rows, 2, sharex=True, sharey=True, squeeze=False).flat
    ratios = [r for r in dict.fromkeys(p.rod_ratio for p in points) if r in SHOWN]
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
    axis.axhline(UNIT, color="0.6", linewidth=0.8, linestyle=":")
    across = axis.get_yaxis_transform()
    axis.text(0.985, UNIT * 1.3, "u = $2^{-53}$", transform=across, ha="right", va="bottom", fontsize=8)
    for (ratio, name), group in _by_line(points):
        if ratio in colours:
            ordered, everything = (
                [p for p in group if p.order != ALL],
                [p for p in group if p.order == ALL],
            )
            style = _style(name, colours[ratio])
            axis.plot(*_places(ordered), **style)
            edged = style | EVERYTHING | {"markerfacecolor": colours[ratio]}
            axis.plot(*_places(everything), **edged)
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
    """Return how a candidate is drawn: ours filled, on a line; the alternatives hollow, on dashes."""
    ours = name in OURS
    return {
        "marker": MARKERS[name],
        "color": colour,
        "markerfacecolor": colour if ours else "white",
        "markersize": 6 if ours else 6.5,
        "linewidth": 0.9 if ours else 0.6,
        "linestyle": "-" if ours else "--",
    }


def _places(points: Sequence[Point]) -> tuple[list[float], list[float]]:
    return [p.ns_per_point for p in points], [max(p.error_relative, LOWEST) for p in points]


def _legend(names: Sequence[str], colours: dict[str, str]) -> list[Any]:
    """Return three columns: ours, the alternatives, the rod ratios."""
    Line2D = import_module("matplotlib.lines").Line2D

    def mark(name: str) -> Any:
        return Line2D([], [], label=NAMES[name], **_style(name, "black"))

    nothing = Line2D([], [], linestyle="none", label=" ")
    whole = {"marker": "o", "color": "0.8", "linestyle": "none"} | EVERYTHING
    every = Line2D([], [], label="every order that shows in a double", **whole)
    columns = [
        [mark(name) for name in names if name in OURS],
        [mark(name) for name in names if name not in OURS] + [every],
        [
            Line2D([], [], color=colour, linewidth=3, label=f"ρ = {1 / float(Fraction(ratio)):.2g}")
            for ratio, colour in colours.items()
        ],
    ]
    rows = max(map(len, columns))
    return [line for column in columns for line in column + [nothing] * (rows - len(column))]
