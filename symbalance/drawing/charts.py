"""Charts as drawings: curves over an angle, a path in the plane, bars on a logarithmic scale."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product
from math import atan2, ceil, cos, floor, hypot, log10, pi, sin
from textwrap import wrap

from symbalance.document.shapes import LETTER, Drawing, Group, Label, Line, Point, Shape, scaled

WIDTH, HEIGHT = 560.0, 260.0
LEFT, RIGHT, BOTTOM, TOP = 64.0, 16.0, 44.0, 40.0
"""Pixels around a chart's field, for its figures and words."""
BARS, FIGURE = 380.0, 40.0
"""Pixels of a scale of bars, and of a figure below it."""
BETWEEN = 20.0
"""Pixels between drawings side by side."""


@dataclass(frozen=True)
class Curve:
    """A named row of values at even steps of an angle, and how it is drawn."""

    name: str
    values: tuple[float, ...]
    look: str


@dataclass(frozen=True)
class Bar:
    """A named value above zero, or None for one that is exactly zero."""

    name: str
    value: float | None
    look: str


def round_steps(low: float, high: float, most: int = 6) -> list[float]:
    """Return round numbers from `low` to `high` at 1, 2 or 5 times a power of ten, `most` or fewer.

    >>> round_steps(-2.4, 3.1)
    [-2.0, -1.0, 0.0, 1.0, 2.0, 3.0]
    """
    span = high - low
    if span <= 0:
        return [low]
    power = 10.0 ** floor(log10(span / most))
    step = next(m * power for m in (1, 2, 5, 10, 20) if span / (m * power) <= most)
    return [
        round(k * step, 12) + 0.0 for k in range(ceil(low / step - 1e-9), floor(high / step + 1e-9) + 1)
    ]


def figure(value: float) -> str:
    """Return a number for a drawing: at most four digits."""
    return f"{value:.4g}".replace("-", "−").replace("e−0", "e−").replace("e+0", "e")


def draw_curves(curves: Sequence[Curve], cycle: float, unit: str, title: str, shows: str) -> Drawing:
    """Return curves over an angle of 0 to `cycle` degrees, whose names stand above them."""
    values = [v for curve in curves for v in curve.values]
    low, high = min([0.0, *values]), max([0.0, *values])
    if high - low < 1e-300:
        low, high = -1.0, 1.0
    margin = 0.06 * (high - low)
    low, high = low - margin, high + margin
    across, up = WIDTH / cycle, HEIGHT / (high - low)
    shapes: list[Shape] = []
    for value in round_steps(low, high):
        y = (value - low) * up
        look = "ink" if value == 0 else "faint"
        shapes += [Line(((0, y), (WIDTH, y)), look), Label((-8, y), figure(value), "end", 11)]
    step = 90 if cycle <= 360 else 180
    for tick in range(0, round(cycle) + 1, step):
        shapes += [
            Line(((tick * across, 0), (tick * across, -5)), "ink"),
            Label((tick * across, -14), f"{tick}°", size=11),
        ]
    shapes.append(Label((WIDTH / 2, -32), "crank angle θ", size=11))
    shapes.append(Label((-8, HEIGHT + 14), unit, "end", 11))
    x = 0.0
    for curve in curves:
        step_x = WIDTH / (len(curve.values) - 1)
        # A tenth of a pixel is enough for a curve, and keeps pages small.
        points = tuple(
            (round(k * step_x, 1), round((v - low) * up, 1)) for k, v in enumerate(curve.values)
        )
        shapes.append(Line(points, curve.look))
        shapes += [
            Line(((x, HEIGHT + 14), (x + 26, HEIGHT + 14)), curve.look),
            Label((x + 32, HEIGHT + 14), curve.name, "start", 11),
        ]
        x += 44 + 7 * len(curve.name)
    shapes.append(Line(((0, 0), (WIDTH, 0), (WIDTH, HEIGHT), (0, HEIGHT)), "faint", closed=True))
    return Drawing(tuple(shapes), -LEFT, -BOTTOM, WIDTH + RIGHT, HEIGHT + TOP, title, shows)


def draw_path(
    points: Sequence[Point],
    look: str,
    unit: str,
    title: str,
    shows: str,
    marks: Sequence[tuple[int, str]],
) -> Drawing:
    """Return the closed path of a vector's end, lateral to the right, vertical up, with marked points."""
    size = max((hypot(*p) for p in points), default=0.0) or 1.0
    half = 170.0
    scale = half / size
    shapes: list[Shape] = []
    for value in round_steps(-size, size, 5):
        at = value * scale
        shapes.append(Label((at, -half - 26), figure(value), size=11))
        shapes.append(Label((-half - 26, at), figure(value), "end", 11))
        shapes += [
            Line(((at, -half - 14), (at, half + 14)), "faint"),
            Line(((-half - 14, at), (half + 14, at)), "faint"),
        ]
    shapes += [
        Line(((0, -half - 14), (0, half + 14)), "axis"),
        Line(((-half - 14, 0), (half + 14, 0)), "axis"),
    ]
    path = tuple((round(x * scale, 1), round(y * scale, 1)) for x, y in points)
    shapes.append(Line(path, look, closed=True))
    outline = [(x * scale, y * scale) for x, y in points]
    following = [*outline[1:], *outline[:1]]
    way = [  # as close as a name is high
        (u + (x - u) * k / 4, v + (y - v) * k / 4)
        for (u, v), (x, y) in zip(outline, following, strict=True)
        for k in range(4)
    ]
    labels: list[Label] = []
    for place, name in _apart(marks, points, 14 / scale):
        x, y = outline[place]
        shapes.append(Line(((x - 3, y), (x, y + 3), (x + 3, y), (x, y - 3)), "ink", closed=True))
        labels.append(_clear_label((x, y), name, way, labels, half + 14))
    shapes += labels
    shapes += [
        Label((0, half + 26), f"vertical, {unit}", size=11),
        Label((0, -half - 42), f"lateral, {unit}", size=11),
    ]
    edge = half + 56
    return Drawing(tuple(shapes), -edge - 24, -edge, edge, edge - 14, title, shows)


def _clear_label(
    at: Point, name: str, path: Sequence[Point], others: Sequence[Label], room: float
) -> Label:
    """Return a mark's name beside it, where the fewest points of the path and no other name stand."""
    x, y = at
    out = atan2(y, x)
    best: tuple[float, Label] | None = None
    for step, turned in product(range(3), (0.0, 1.0, 0.5, -0.5, 0.25, -0.25, 0.75, -0.75)):
        way = out + pi * turned
        far = 12.0 + 8 * step + 3.2 * (len(name) - 1) * abs(cos(way))
        label = Label((x + far * cos(way), y + far * sin(way)), name, size=11)
        left, bottom, right, top = label.box
        hidden = sum(left <= u <= right and bottom <= v <= top for u, v in path)
        hidden += 1000 * any(_boxes_meet(label.box, other.box) for other in others)
        hidden += 1000 * (max(-left, right, -bottom, top) > room)
        # The axes' lines are crossed where nothing better is near.
        hidden += 0.5 * (left < 0 < right) + 0.5 * (bottom < 0 < top) + 0.25 * step
        if best is None or hidden < best[0]:
            best = hidden, label
    assert best is not None
    return best[1]


def _boxes_meet(one: tuple[float, float, float, float], other: tuple[float, float, float, float]) -> bool:
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]


def _apart(
    marks: Sequence[tuple[int, str]], points: Sequence[Point], distance: float
) -> list[tuple[int, str]]:
    """Return marks that stand that far apart, the names of those that fall together joined."""
    groups: list[list[tuple[int, str]]] = []
    for place, name in marks:
        x, y = points[place]
        for group in groups:
            u, v = points[group[0][0]]
            if hypot(u - x, v - y) < distance:
                group.append((place, name))
                break
        else:
            groups.append([(place, name)])
    return [(group[0][0], ", ".join(name for _, name in group)) for group in groups]


def stacked(drawings: Sequence[Drawing], title: str) -> Drawing:
    """Return drawings one below the other as one."""
    left, right = min(d.left for d in drawings), max(d.right for d in drawings)
    shapes: list[Shape] = []
    top = 0.0
    for drawing in drawings:
        shapes.append(Group(drawing.shapes, (0.0, top - drawing.top)))
        top -= drawing.height
    return Drawing(tuple(shapes), left, top, right, 0.0, title, " ".join(d.shows for d in drawings))


def beside(drawings: Sequence[Drawing], high: float, title: str) -> Drawing:
    """Return drawings side by side as one, each `high` pixels high or as high as it is."""
    shapes: list[Shape] = []
    x = 0.0
    for drawing in drawings:
        by = min(1.0, high / drawing.height)
        y = -(high - by * drawing.height) / 2 - by * drawing.top
        shapes.append(Group(tuple(scaled(s, by) for s in drawing.shapes), (x - by * drawing.left, y)))
        x += by * drawing.width + BETWEEN
    words = " ".join(drawing.shows for drawing in drawings)
    return Drawing(tuple(shapes), 0.0, -high, x - BETWEEN, 0.0, title, words)


def draw_bars(
    bars: Sequence[Bar],
    unit: str,
    least: float,
    title: str,
    shows: str,
    room: float = BARS,
    notes: Sequence[str] = (),
) -> Drawing:
    """Return bars on a logarithmic scale down to `least`; what is exactly zero has words instead.

    The scale is `room` pixels long; a short one has a figure at every second or third power of ten.
    `notes` stand below it.
    """
    row = 20.0
    high = max([b.value for b in bars if b.value is not None] + [least * 10])
    top, bottom = ceil(log10(high) - 1e-9), floor(log10(least) + 1e-9)
    scale = room / (top - bottom)
    shapes: list[Shape] = []
    deep = -row * len(bars) - 6
    for power in range(bottom, top + 1):
        x = (power - bottom) * scale
        name = {0: "1", 1: "10"}.get(power, f"1e{power}".replace("-", "−"))
        shapes.append(Line(((x, 4), (x, deep)), "faint"))
        if (power - top) % ceil(FIGURE / scale) == 0:
            shapes.append(Label((x, deep - 12), name, size=11))
    for place, bar in enumerate(bars):
        y = -row * (place + 0.5)
        shapes.append(Label((-10, y), bar.name, "end"))
        if bar.value is None:
            shapes.append(Label((6, y), "0, proved", "start", 11))
            continue
        end = (log10(bar.value) - bottom) * scale
        if end <= 0:
            shapes.append(Label((6, y), f"{figure(bar.value)}, below this scale", "start", 11))
            continue
        half = 0.32 * row
        shapes.append(
            Line(((0, y - half), (end, y - half), (end, y + half), (0, y + half)), bar.look, closed=True)
        )
        shapes.append(Label((end + 6, y), figure(bar.value), "start", 11))
    shapes.append(Label((room / 2, deep - 30), unit, size=11))
    low = deep - 44
    for line in (line for note in notes for line in wrap(note, int((room + 180) / (11 * LETTER)))):
        shapes.append(Label((-110, low - 6), line, "start", 11))
        low -= 16
    return Drawing(tuple(shapes), -120, low, room + 70, 12, title, shows)
