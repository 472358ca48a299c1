"""Drawings as PNG and PDF, by matplotlib: what neither SVG nor TeX can be put into."""

from __future__ import annotations

from importlib import import_module
from io import BytesIO
from typing import Any

from symbalance.document.shapes import (
    LOOKS,
    Arrow,
    Circle,
    Drawing,
    Group,
    Label,
    Line,
    Point,
    Shape,
    arrow_head,
    placed,
)
from symbalance.errors import MissingPartError

PIXELS = 96.0
"""Of an inch."""
FADED = 0.35


def drawing_picture(drawing: Drawing, form: str, dpi: float = 2 * PIXELS) -> bytes:
    """Return a drawing as the bytes of a "png" or "pdf", by matplotlib: the extra `plot`."""
    try:
        figure_class = import_module("matplotlib.figure").Figure
    except ImportError:
        rule, remedy = (
            "matplotlib is not installed",
            "pip install 'symbalance[plot]', or write .svg or .tex",
        )
        raise MissingPartError(f".{form}", rule, remedy) from None
    figure = figure_class(figsize=(drawing.width / PIXELS, drawing.height / PIXELS))
    axes = figure.add_axes((0, 0, 1, 1))
    axes.set_xlim(drawing.left, drawing.right)
    axes.set_ylim(drawing.bottom, drawing.top)
    axes.axis("off")
    for order, shape in enumerate(drawing.shapes):
        _draw(axes, shape, (0.0, 0.0), 0.0, 1.0, order)
    stream = BytesIO()
    # No date: the same drawing is the same file.
    metadata = (
        {"CreationDate": None, "Title": drawing.title} if form == "pdf" else {"Title": drawing.title}
    )
    figure.savefig(stream, format=form, dpi=dpi, metadata=metadata)
    return stream.getvalue()


def _draw(axes: Any, shape: Shape, at: Point, turned: float, alpha: float, order: float) -> None:
    patches = import_module("matplotlib.patches")

    def put(point: Point) -> Point:
        return placed(point, at, turned)

    if isinstance(shape, Group):
        inner = alpha * (FADED if shape.faded else 1.0)
        for each in shape.shapes:
            _draw(axes, each, put(shape.at), turned + shape.turned, inner, order)
        return
    look = LOOKS[shape.look]
    width = 0.75 * look.width
    style: dict[str, Any] = {"alpha": alpha, "zorder": order, "linewidth": width}
    if look.dashes:
        # matplotlib counts dashes in widths of the line.
        style["linestyle"] = (0, [each / look.width for each in look.dashes])
    if isinstance(shape, Line):
        points = [put(p) for p in shape.points]
        edge = LOOKS["ink"].light if shape.look == "piston" else look.light
        if shape.closed:
            fill = look.light if look.filled else "none"
            axes.add_patch(patches.Polygon(points, closed=True, facecolor=fill, edgecolor=edge, **style))
        else:
            axes.plot(*zip(*points, strict=True), color=edge, **style)
    elif isinstance(shape, Circle):
        fill = "white" if shape.opaque else look.light if look.filled else "none"
        axes.add_patch(
            patches.Circle(put(shape.centre), shape.radius, facecolor=fill, edgecolor=look.light, **style)
        )
    elif isinstance(shape, Arrow):
        head = [put(p) for p in arrow_head(shape.start, shape.end)]
        base = (head[1][0] + head[2][0]) / 2, (head[1][1] + head[2][1]) / 2
        axes.plot(*zip(put(shape.start), base, strict=True), color=look.light, **style)
        axes.add_patch(patches.Polygon(head, closed=True, color=look.light, alpha=alpha, zorder=order))
    else:
        _write(axes, shape, put, alpha, order, look.light)


def _write(axes: Any, label: Label, put: Any, alpha: float, order: float, colour: str) -> None:
    x, y = put(label.at)
    align = {"start": "left", "middle": "center", "end": "right"}[label.align]
    axes.text(
        x,
        y,
        label.text.replace("$", r"\$"),
        ha=align,
        va="center_baseline",
        fontsize=0.75 * label.size,
        fontweight="bold" if label.strong else "normal",
        color=colour,
        alpha=alpha,
        zorder=order,
    )
