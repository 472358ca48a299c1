"""The firing and stroke diagram: what each cylinder does over a cycle, and the intervals between firings.

Each row is a cylinder, in firing order; of four strokes power is filled, compression shaded, exhaust and
intake open. Strokes are taken as half turns from its firing dead centre on, which is where an offset axis
or a link rod has it. An interval that is unlike the others is marked.
"""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.shapes import Drawing, Group, Label, Line, Shape
from symbalance.engine.dead_centres import firing_dead_centres
from symbalance.engine.engine import Engine

WIDTH, ROW, LEFT = 560.0, 24.0, 44.0
APART = 4.0
"""Pixels between intervals side by side."""
MANY, LEAST_ROW = 16, 13.0
"""Cylinders from which rows stand closer, and how close at the most."""
STROKES = {4: ("power", "exhaust", "intake", "compression"), 2: ("power", "compression")}
LOOK = {"power": "solid", "compression": "shade", "exhaust": "open", "intake": "faint"}
NEAR = Fraction(1, 20)
"""Degrees by which intervals may differ and count as one: makers round the angles of pins."""
STEP = 11.0
"""Pixels between the two rows of intervals."""


def firing_intervals(engine: Engine) -> list[tuple[int, Fraction, Fraction]]:
    """Return each cylinder in firing order with its firing dead centre and the degrees to the next one.

    >>> from symbalance.engine.builders import inline
    >>> [(n, int(at), int(to)) for n, at, to in firing_intervals(inline("1-3-4-2"))]
    [(1, 0, 180), (3, 180, 180), (4, 360, 180), (2, 540, 180)]
    """
    cycle = 180 * engine.strokes
    dead_centres = firing_dead_centres(engine)
    order = sorted(dead_centres, key=lambda n: (dead_centres[n] % cycle, n))
    angles = [dead_centres[n] % cycle for n in order]
    following = [*angles[1:], angles[0] + cycle]
    return [(n, a, b - a) for n, a, b in zip(order, angles, following, strict=True)]


def draw_firing(engine: Engine, width: float = WIDTH) -> Drawing:
    """Return the firing and stroke diagram over a cycle, which is `width` pixels long."""
    rows, cycle = firing_intervals(engine), 180 * engine.strokes
    scale = width / cycle
    # The usual interval is the one that most are near.
    usual = max((s for _, _, s in rows), key=lambda s: sum(abs(s - t) <= NEAR for _, _, t in rows))
    uneven = any(abs(step - usual) > NEAR for _, _, step in rows)
    shapes: list[Shape] = []
    high, row = 0.0, min(ROW, max(LEAST_ROW, MANY * ROW / len(rows)))
    for place, (number, at, _) in enumerate(rows):
        y = -row * (place + 1)
        shapes.append(Label((LEFT - 12, y), str(number), "end", min(12.0, 0.85 * row), strong=True))
        for stroke, name in enumerate(STROKES[engine.strokes]):
            shapes += _bar(float(at) + 180 * stroke, 180.0, float(cycle), scale, y, name, row)
        x = LEFT + float(at) * scale
        shapes.append(Line(((x, high + 2), (x, y + 0.4 * row)), "path"))
    shapes += _intervals(rows, usual, scale, width)
    low = -row * (len(rows) + 0.6)
    for tick in range(0, cycle + 1, 90 if engine.strokes == 2 else 180):
        x = LEFT + tick * scale
        shapes += [Line(((x, low), (x, low - 5)), "ink"), Label((x, low - 13), f"{tick}°", size=11)]
    shapes.append(Line(((LEFT, low), (LEFT + width, low)), "ink"))
    x, y = LEFT, low - 36
    for name in (*STROKES[engine.strokes], *(["* unlike the others"] if uneven else [])):
        if x + 104 > LEFT + width + 24:
            x, y = LEFT, y - 18
        if name in LOOK:
            shapes.append(_box(x, x + 22, y, LOOK[name]))
        shapes.append(Label((x + (28 if name in LOOK else 0), y), name, "start", 11))
        x += 104
    cursor = Line(((LEFT, high + 2), (LEFT, low)), "ink")
    shapes.append(Group((cursor,), name="cursor"))
    order = "-".join(str(number) for number, _, _ in rows)
    steps = ", ".join(f"{_figure(step)}°" for _, _, step in rows)
    even = f"every {_figure(usual)}°" if not uneven else f"unevenly, after {steps}"
    return Drawing(
        tuple(shapes),
        0.0,
        y - 16,
        LEFT + width + 24,
        30,
        f"Firing order and strokes of {engine.name}",
        f"Fires {order}, {even}.",
    )


def _intervals(
    rows: list[tuple[int, Fraction, Fraction]], usual: Fraction, scale: float, width: float
) -> list[Shape]:
    """Return the intervals above the rows, in two lines where one has no room for them."""
    labels = []
    for place, (_, at, step) in enumerate(rows):
        near = abs(step - usual) <= NEAR
        text = f"{_figure(usual if near else step)}°" + ("" if near else "*")
        middle = LEFT + (float(at) + float(step) / 2) * scale
        labels.append(Label((middle, 9 + STEP * (place % 2)), text, size=11))
    one_line = [Label((label.at[0], 9.0), label.text, size=11) for label in labels]
    for row in (one_line, labels):
        if not any(_overlap(a, b) for i, a in enumerate(row) for b in row[i + 1 :]):
            return [*row]
    # Too many for either: what they are stands in the description.
    return [Label((LEFT + width / 2, 9.0), f"{len(rows)} intervals, usually {_figure(usual)}°", size=11)]


def _overlap(one: Label, other: Label) -> bool:
    a, b = one.box, other.box
    return a[0] < b[2] + APART and b[0] < a[2] + APART and a[1] < b[3] and b[1] < a[3]


def _bar(
    start: float, length: float, cycle: float, scale: float, y: float, name: str, row: float
) -> list[Shape]:
    """Return a stroke's bar, in two parts where it goes over the end of the cycle."""
    begin = start % cycle
    ends = [(begin, min(begin + length, cycle))]
    if begin + length > cycle + 1e-9:
        ends.append((0.0, begin + length - cycle))
    return [_box(LEFT + a * scale, LEFT + b * scale, y, LOOK[name], row) for a, b in ends]


def _box(left: float, right: float, y: float, look: str, row: float = ROW) -> Shape:
    half = 0.32 * row
    return Line(
        ((left, y - half), (right, y - half), (right, y + half), (left, y + half)), look, closed=True
    )


def _figure(value: Fraction) -> str:
    return f"{float(round(value, 3)):g}"
