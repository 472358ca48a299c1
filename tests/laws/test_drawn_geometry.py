"""Plans, oblique views, stars, diagrams and charts, read back and computed anew: all is in its place."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import pytest

import symbalance as sb
from symbalance import draw
from symbalance.document.shapes import Arrow, Circle, Drawing, Group, Label, Line, Shape, placed
from tests.drawn import known
from tests.placed import direction, heights, met

UNEVEN = ["vw-vr6", "kharkiv-v2", "r-985", "v8-90", "inline-5", "boxer-4"]
"""Engines that a mirror or a rotation the other way round would change."""


def flat(
    shapes: Sequence[Shape], at: tuple[float, float] = (0.0, 0.0), turned: float = 0.0
) -> list[Shape]:
    """Return the lines, arrows, circles and labels of groups where they stand on the sheet."""
    parts: list[Shape] = []
    for shape in shapes:
        if isinstance(shape, Group):
            parts += flat(shape.shapes, placed(shape.at, at, turned), turned + shape.turned)
        elif isinstance(shape, Line):
            points = tuple(placed(p, at, turned) for p in shape.points)
            parts.append(Line(points, shape.look, shape.closed))
        elif isinstance(shape, Arrow):
            ends = placed(shape.start, at, turned), placed(shape.end, at, turned)
            parts.append(Arrow(*ends, shape.look))
        elif isinstance(shape, Circle):
            parts.append(Circle(placed(shape.centre, at, turned), shape.radius, shape.look, shape.opaque))
        else:
            where = placed(shape.at, at, turned)
            parts.append(Label(where, shape.text, shape.align, shape.size, shape.look, shape.strong))
    return parts


def only(drawing: Drawing, kind: type) -> list:
    return [shape for shape in flat(drawing.shapes) if isinstance(shape, kind)]


def group(drawing: Drawing, name: str) -> Group:
    return next(s for s in drawing.shapes if isinstance(s, Group) and s.name == name)


def pin_place(cylinder: sb.Cylinder, theta: float) -> complex:
    return complex(np.exp(1j * theta)) * direction((cylinder.master or cylinder).throw)


def rises(engine: sb.Engine, cylinder: sb.Cylinder, theta: np.ndarray) -> np.ndarray:
    """Return a piston's heights, in mm or, where no stroke is known, in radii of the crank."""
    if cylinder.sizes.stroke is not None or cylinder.link is not None:
        return heights(engine, cylinder, theta)
    pin = np.exp(1j * theta) * direction(cylinder.throw)
    assert cylinder.ratio is not None
    return met(pin, direction(cylinder.bank), cylinder.ratio, None)


def radius_of(cylinder: sb.Cylinder) -> float:
    return 1.0 if cylinder.radius is None else float(cylinder.radius)


def piston(engine: sb.Engine, cylinder: sb.Cylinder, theta: float) -> complex:
    """Return where a piston pin stands, in radii of the crank or in mm, up + i right."""
    height = rises(engine, cylinder, np.array([theta]))[0]
    return complex(height, float(cylinder.offset or 0)) * direction(cylinder.bank)


# Views ------------------------------------------------------------------------------------------


@pytest.mark.parametrize("degrees", [10, 137])
@pytest.mark.parametrize("name", UNEVEN)
def test_a_plan_has_stations_from_the_left_and_pistons_to_their_side(name: str, degrees: int) -> None:
    engine, theta = known(name), math.radians(degrees)
    plan = draw.plan(engine, degrees)
    at = {c: group(plan, f"piston-{c.number}").at for c in engine.cylinders}
    stations = np.array([float(c.station) for c in engine.cylinders])
    across = np.array([at[c][0] for c in engine.cylinders])
    if np.ptp(stations):
        slope, start = np.polyfit(stations, across, 1)
        assert slope < 0  # the front stands to the left
        assert across == pytest.approx(start + slope * stations, abs=1e-6)
    sides = np.array([piston(engine, c, theta).imag for c in engine.cylinders])
    drawn = np.array([at[c][1] for c in engine.cylinders])
    if np.abs(sides).max() > 1e-9:
        scale = float(drawn @ sides / (sides @ sides))
        assert scale > 0
        assert drawn == pytest.approx(scale * sides, abs=1e-6)
        for cylinder in engine.cylinders:
            (line,) = group(plan, f"rod-{cylinder.number}").shapes
            assert isinstance(line, Line)
            if cylinder.link is None:
                radius = radius_of(cylinder)
                pin = scale * radius * pin_place(cylinder, theta).imag
                assert line.points[0] == pytest.approx((at[cylinder][0], pin), abs=1e-6)
            assert line.points[1] == pytest.approx(at[cylinder], abs=1e-6)
    (crank,) = group(plan, "crank").shapes
    assert isinstance(crank, Line)
    pins = {(round(float(c.station), 9), round(pin_place(c, theta).imag, 6)) for c in engine.cylinders}
    ups = [
        b for a, b in zip(crank.points, crank.points[1:], strict=False) if a[1] == b[1] and a[0] != b[0]
    ]
    assert len([u for u in ups if u[1]]) >= len([p for p in pins if abs(p[1]) > 1e-6])
    mean = next(s for s in only(plan, Line) if s.look == "axis")
    middle = across.mean()  # as many cylinders before as behind: the mean of all stations
    assert mean.points[0][0] == pytest.approx(middle, abs=1e-6)


@pytest.mark.parametrize("degrees", [10, 251])
@pytest.mark.parametrize("name", UNEVEN)
def test_an_oblique_view_moves_what_is_behind_up_and_to_the_right(name: str, degrees: int) -> None:
    engine, theta = known(name), math.radians(degrees)
    view = draw.oblique(engine, degrees)
    labels = {label.text: complex(*label.at) for label in only(view, Label)}
    cylinders = engine.cylinders
    places = np.array([piston(engine, c, theta) for c in cylinders])
    flat_places = places.imag + 1j * places.real  # x + i y of the sheet
    stations = np.array([-float(c.station) for c in cylinders])
    drawn = np.array([labels[str(c.number)] for c in cylinders])
    unknown = np.column_stack([flat_places, stations, np.ones(len(cylinders))])
    (scale, along, start), *_ = np.linalg.lstsq(unknown, drawn, rcond=None)
    assert np.abs(unknown @ np.array([scale, along, start]) - drawn).max() < 1e-4 * abs(drawn).max()
    assert scale.real > 0
    assert abs(scale.imag) < 1e-6 * scale.real
    if np.ptp(stations):
        assert along.real > 0
        assert along.imag > 0
    # Each rod ends at a piston pin; of rods on the crank the other end is the crank pin.
    rods = [line for line in only(view, Line) if line.look == "rod"]
    ends = [complex(*line.points[1]) for line in rods]
    assert sorted(map(str, np.round(ends, 0))) == sorted(map(str, np.round(drawn, 0))) or all(
        min(abs(end - place) for place in drawn) < 0.2 for end in ends
    )
    for c in cylinders:
        if c.link is None:
            pin = pin_place(c, theta) * radius_of(c)
            foot = scale * (pin.imag + 1j * pin.real) + along * -float(c.station) + start
            assert min(abs(complex(*line.points[0]) - foot) for line in rods) < 0.2
    assert len(rods) == len(cylinders)


# Stars and diagrams -----------------------------------------------------------------------------


@pytest.mark.parametrize("order", [1, 2, 3])
@pytest.mark.parametrize("name", ["v8-90", "vw-vr6", "inline-5", "kharkiv-v2", "boxer-4", "inline-3"])
def test_arrows_of_a_star_point_where_cylinders_push(name: str, order: int) -> None:
    engine = known(name)
    star = draw.star(engine, order)
    rings = only(star, Circle)
    arrows = only(star, Arrow)
    labels = [label for label in only(star, Label) if label.size == 12]
    banks = engine.grouped(lambda c: c.bank)
    assert len(rings) == len(banks)
    for ring, cylinders in zip(rings, banks.values(), strict=True):
        x, y = ring.centre
        total = 0j
        for c in cylinders:
            angle = 2 * math.pi * order * float(c.throw.turns - c.bank.turns)
            total += complex(math.cos(angle), math.sin(angle))
            tip = x + ring.radius * math.sin(angle), y + ring.radius * math.cos(angle)
            assert any(
                a.look == "ink" and a.start == ring.centre and math.dist(a.end, tip) < 1e-6
                for a in arrows
            ), c
            near = min(
                (label for label in labels if label.text[0].isdigit()),
                key=lambda label: math.dist(label.at, tip),
            )
            assert str(c.number) in near.text.split()
            assert math.dist(near.at, ring.centre) > ring.radius  # outside the ring
        rests = [a for a in arrows if a.look == "force" and a.start == ring.centre]
        verdict = min(
            (label for label in labels if label.text.startswith(("closes", "leaves"))),
            key=lambda label: math.dist(label.at, ring.centre),
        )
        if abs(total) < 1e-9:
            assert not rests
            assert verdict.text == "closes: 0, proved"
        else:
            (rest,) = rests
            size = ring.radius / len(cylinders)
            assert math.dist(rest.end, (x + size * total.imag, y + size * total.real)) < 1e-6
            words = verdict.text.split()
            assert float(words[1]) == pytest.approx(abs(total), abs=1e-4)
            turned = math.degrees(math.atan2(total.imag, total.real)) % 360
            assert float(words[-1].rstrip("°")) % 360 == pytest.approx(turned % 360, abs=1e-3)
            assert words[2] == ("arrow" if abs(abs(total) - 1) < 1e-9 else "arrows")
    for ring, bank in zip(rings, banks, strict=True):
        if len(banks) > 1:
            text = f"axis at {float(bank.in_degrees()):g}°".replace("-", "−")
            title = min(
                (label for label in only(star, Label) if label.text == text), key=lambda label: label.size
            )
            assert abs(title.at[0] - ring.centre[0]) < 1e-6
            assert title.at[1] > ring.centre[1] + ring.radius


def near(one: float, other: float, cycle: float) -> bool:
    """Tell whether two places of a cycle so many pixels long are one, to a tenth of a degree."""
    apart = (one - other) % cycle
    return min(apart, cycle - apart) < cycle / 7200 + 0.02


def top_dead_centre(engine: sb.Engine, cylinder: sb.Cylinder, near: float) -> float:
    """Return the crank angle in degrees of the highest piston, within a third of a turn of `near`."""
    theta = np.radians(near + np.linspace(-60, 60, 24001))
    up = rises(engine, cylinder, theta)
    return float(np.degrees(theta[int(np.argmax(up))]))


@pytest.mark.parametrize("width", [560.0, 275.0])
@pytest.mark.parametrize(
    "name", ["vw-vr6", "kharkiv-v2", "r-985", "v8-90", "honda-nt650", "wartsila-10rta96c"]
)
def test_strokes_begin_at_the_dead_centres(name: str, width: float) -> None:
    from symbalance.drawing.firing_diagram import LEFT, draw_firing

    engine = known(name)
    cycle = 180 * engine.strokes
    drawing = draw_firing(engine, width)
    shapes = flat(drawing.shapes)
    rows = {s.text: s.at[1] for s in shapes if isinstance(s, Label) and s.strong}
    assert len(rows) == len(engine.cylinders)
    first = top_dead_centre(engine, engine.first, 0.0)
    tops = {}
    for c in engine.cylinders:
        fires = 0.0 if c is engine.first else float(c.fires or 0)
        tops[c.number] = round(top_dead_centre(engine, c, fires + first) - first, 2) % cycle
    scale = width / cycle
    marks = [s for s in shapes if isinstance(s, Line) and s.look == "path"]
    solid = [s for s in shapes if isinstance(s, Line) and s.look == "solid"]
    for c in engine.cylinders:
        y = rows[str(c.number)]
        x = LEFT + scale * (tops[c.number] % cycle)
        assert any(near(m.points[0][0], x, width) for m in marks), c
        bars = [b for b in solid if abs((b.points[0][1] + b.points[2][1]) / 2 - y) < 1e-6]
        begins = [min(p[0] for p in b.points) for b in bars]
        assert any(near(begin, x, width) for begin in begins), c
        length = sum(b.points[1][0] - b.points[0][0] for b in bars)
        assert length == pytest.approx(180 * scale, abs=1e-6)  # a stroke is half a turn
        all_bars = [
            b
            for b in shapes
            if isinstance(b, Line) and b.closed and abs((b.points[0][1] + b.points[2][1]) / 2 - y) < 1e-6
        ]
        assert sum(b.points[1][0] - b.points[0][0] for b in all_bars) == pytest.approx(width, abs=1e-6)
        assert all(LEFT - 1e-6 <= p[0] <= LEFT + width + 1e-6 for b in all_bars for p in b.points)
        # In the order of the cycle: power, exhaust, intake, compression.
        order = {4: ["solid", "open", "faint", "shade"], 2: ["solid", "shade"]}[engine.strokes]
        for place, look in enumerate(order):
            middle = (tops[c.number] + 180 * place + 90) % cycle * scale + LEFT
            here = [b.look for b in all_bars if b.points[0][0] - 0.5 <= middle <= b.points[1][0] + 0.5]
            assert look in here
    down = sorted(rows, key=lambda n: -rows[n])
    assert down == [str(n) for n in sorted(tops, key=lambda n: tops[n])]
    stated = drawing.shows
    assert stated.startswith("Fires " + "-".join(down))
    steps = np.diff([*sorted(tops.values()), min(tops.values()) + cycle])
    assert ("every" in stated) == (np.ptp(steps) < 0.1)
    stars = [label for label in shapes if isinstance(label, Label) and label.text.endswith("*")]
    assert bool(stars) <= (np.ptp(steps) > 0.05)


# Charts -----------------------------------------------------------------------------------------


def scale_of_labels(labels: list[Label], axis: int) -> tuple[float, float]:
    """Return slope and start of the line through a scale's figures: value = slope x place + start."""
    values = [float(label.text.replace("−", "-")) for label in labels]
    slope, start = np.polyfit([label.at[axis] for label in labels], values, 1)
    return float(slope), float(start)


def is_figure(text: str) -> bool:
    try:
        float(text.replace("−", "-"))
    except ValueError:
        return False
    return True


@pytest.mark.parametrize("of", ["force", "couple"])
@pytest.mark.parametrize("name", ["vw-vr6", "v8-90", "kharkiv-v2", "boxer-4", "inline-3"])
def test_curves_and_paths_are_drawn_where_their_scales_say(name: str, of: str) -> None:
    from symbalance.forces.pictures import draw_one_of_forces

    result = sb.balance(known(name))
    if not getattr(result, of).orders():
        return
    outputs = (f"{of}.vertical", f"{of}.lateral")
    function = sb.to_function(result, outputs=outputs)
    theta = np.radians(np.linspace(0, 360, 181))
    values = {key: np.asarray(v) * np.ones(181) for key, v in function(theta).items()}
    chart = draw_one_of_forces(result, of)
    slope, start = scale_of_labels(
        [label for label in only(chart, Label) if label.align == "end" and is_figure(label.text)], 1
    )
    curves = [line for line in only(chart, Line) if len(line.points) == 181]
    shown = [key for key in outputs if np.abs(values[key]).max() > 0]
    assert len(curves) == len(shown)
    largest = max(np.abs(v).max() for v in values.values())
    degrees = [label for label in only(chart, Label) if label.text.endswith("°")]
    turn, zero = np.polyfit(
        [label.at[0] for label in degrees], [float(label.text[:-1]) for label in degrees], 1
    )
    for curve, key in zip(curves, shown, strict=True):
        xs, ys = np.array(curve.points).T
        assert slope * ys + start == pytest.approx(values[key], abs=0.005 * largest)
        assert turn * xs + zero == pytest.approx(np.linspace(0, 360, 181), abs=0.5)
    path = draw.path(result, of)
    marks = [label for label in only(path, Label) if is_figure(label.text)]
    right, from_left = scale_of_labels([label for label in marks if label.align == "middle"], 0)
    up, from_below = scale_of_labels([label for label in marks if label.align == "end"], 1)
    (line,) = [s for s in only(path, Line) if len(s.points) == 180]
    xs, ys = np.array(line.points).T
    assert right * xs + from_left == pytest.approx(values[outputs[1]][:-1], abs=0.005 * largest)
    assert up * ys + from_below == pytest.approx(values[outputs[0]][:-1], abs=0.005 * largest)
    sizes = np.hypot(values[outputs[0]], values[outputs[1]])
    words = path.shows.split()
    assert float(words[1].replace("−", "-")) == pytest.approx(sizes.max(), rel=1e-3)
    at = float(words[-1].rstrip("°."))
    assert sizes[round(at / 2)] == pytest.approx(sizes.max(), rel=1e-9)
    # Marks stand on the path at their angles.
    dots = [s for s in only(path, Line) if s.closed and len(s.points) == 4]
    for angle in (0, 90, 180, 270):
        point = np.array(line.points[angle // 2])
        assert min(np.abs(np.mean(d.points, axis=0) - point).max() for d in dots) < 15


@pytest.mark.parametrize("name", ["vw-vr6", "v8-90", "inline-3", "honda-nt650"])
def test_the_torque_is_drawn_where_its_scale_says(name: str) -> None:
    result = sb.inertia_torque(known(name))
    chart = draw.torque(result)
    slope, start = scale_of_labels(
        [label for label in only(chart, Label) if label.align == "end" and is_figure(label.text)], 1
    )
    (curve,) = [line for line in only(chart, Line) if len(line.points) == 181]
    values = np.asarray(sb.to_function(result)(np.radians(np.linspace(0, 360, 181))))
    ys = np.array(curve.points)[:, 1]
    assert slope * ys + start == pytest.approx(values, abs=0.005 * np.abs(values).max())
    assert float(chart.shows.split("±")[1].split()[0]) == pytest.approx(np.abs(values).max(), rel=1e-3)


@pytest.mark.parametrize("name", ["vw-vr6", "v8-90", "inline-3", "boxer-4", "kharkiv-v2"])
def test_bars_are_as_long_as_their_orders_are_large(name: str) -> None:
    result = sb.balance(known(name))
    chart = draw.orders(result)
    theta = 2 * np.pi * np.arange(256) / 256
    labels = only(chart, Label)
    names = {label.text: label.at[1] for label in labels if label.text.startswith(("force ", "couple "))}
    ticks = [label for label in labels if label.text.startswith("1e") or label.text in ("1", "10", "100")]
    powers = [math.log10(float(label.text.replace("−", "-"))) for label in ticks]
    slope, start = np.polyfit([label.at[0] for label in ticks], powers, 1)
    bars = {s.points[0][1]: s for s in only(chart, Line) if s.closed}
    for of in ("force", "couple"):
        outputs = (f"{of}.vertical", f"{of}.lateral")
        values = sb.to_function(result, outputs=outputs, tolerance=0.0)(theta)
        waves = [np.asarray(v) * np.ones(256) for v in values.values()]
        present = set(getattr(result, of).orders())
        for order in range(1, 13):
            row = names.get(f"{of} {order}")
            size = max(2 * abs(np.mean(w * np.exp(-1j * order * theta))) for w in waves)
            if order in present:
                assert row is not None
            if row is None:
                assert size < 1e-12
                continue
            (beside,) = [label for label in labels if label.at[1] == row and label.align == "start"]
            bar = next((b for b in bars.values() if b.points[0][1] < row < b.points[2][1]), None)
            if order not in present:
                assert (beside.text, bar) == ("0, proved", None)
            elif size < 1e-6:
                assert "below this scale" in beside.text
                assert bar is None
            else:
                assert bar is not None
                assert float(beside.text.replace("−", "-")) == pytest.approx(size, rel=1e-3)
                assert slope * bar.points[1][0] + start == pytest.approx(math.log10(size), abs=1e-6)
                assert slope * bar.points[0][0] + start == pytest.approx(-6, abs=1e-6)
                assert bar.look == {"force": "solid", "couple": "shade"}[of]
