"""The cross-section of an engine seen from the front: crank, rods and pistons at a crank angle.

Of each direction of an axis the front cylinder is drawn in full and those behind it faded. Every moving
part is a group of its own, in its own frame: `crank` turns about the origin, `rod-3` stands at its pin,
`piston-3` at its piston pin. Off-centre axes are dimensioned.
"""

from __future__ import annotations

from dataclasses import replace
from math import degrees, pi

from symbalance.document.shapes import Circle, Drawing, Group, Label, Line, Point, Shape, labels_of
from symbalance.drawing.positions import Machine
from symbalance.engine.cylinders import Cylinder
from symbalance.engine.engine import Engine

SIZE = 420.0
"""Pixels of the longer side."""
HEAD, SKIRT = 0.34, 0.30
"""A piston above and below its pin, over the bore."""
GAP = 0.07
"""Between a piston at the top and the cylinder's head, over the bore."""


def draw_section(engine: Engine, theta: float = 0.0) -> Drawing:
    """Return the cross-section at a crank angle in degrees, clockwise.

    >>> from symbalance.engine.builders import inline
    >>> draw_section(inline("1-2-3"), 30).title
    'Cross-section of engine at θ = 30°'
    """
    machine = Machine(engine)
    turn = theta * pi / 180
    scale = section_scale(machine)
    front = _front(machine)
    shapes: list[Shape] = []
    ordered = sorted(machine.front_to_rear, key=lambda c: (c in front, c.station))
    shapes += [_axis(machine, cylinder, scale) for cylinder in front]
    shapes.append(Circle((0, 0), scale * machine.radius(engine.first), "path"))
    for cylinder in ordered:
        shapes += _master(machine, cylinder, turn, scale, cylinder not in front)
    for cylinder in ordered:
        shapes += _moving(machine, cylinder, turn, scale, cylinder not in front)
    shapes.append(_crank(machine, turn, scale))
    for sign in (1, -1):  # what the axes of one side have in common is written once
        beside = [c for c in front if machine.offset(c) * sign > 0]
        shapes += [shape for c in beside for shape in _offset(machine, c, scale, words=c is beside[0])]
    shapes += _numbers(machine, scale)
    left, bottom, right, top = _box(machine, scale)
    title = f"Cross-section of {engine.name} at θ = {_degrees(theta)}"
    drawing = Drawing(tuple(shapes), left, bottom, right, top, title, _words(machine, front, theta))
    for label in (each.box for each in labels_of(drawing)):
        left, bottom = min(left, label[0] + 20), min(bottom, label[1] + 20)
        right, top = max(right, label[2] - 20), max(top, label[3] - 20)
    return replace(drawing, left=left - 26, bottom=bottom - 26, right=right + 26, top=top + 26)


def section_scale(machine: Machine) -> float:
    """Return the pixels that a length of one takes in the cross-section."""
    left, bottom, right, top = _box(machine, 1.0)
    return SIZE / max(right - left, top - bottom)


def point(place: complex, scale: float) -> Point:
    """Return up + i right as a point of the sheet."""
    return place.imag * scale, place.real * scale


def _front(machine: Machine) -> list[Cylinder]:
    """Return the front cylinder of each direction and offset of an axis."""
    front: dict[tuple[object, float], Cylinder] = {}
    for cylinder in machine.front_to_rear:
        front.setdefault((cylinder.bank, machine.offset(cylinder)), cylinder)
    return list(front.values())


def _axis(machine: Machine, cylinder: Cylinder, scale: float) -> Shape:
    """Return an axis and the bore about it, from the lowest skirt to the head, in the axis' own frame."""
    x, half = scale * machine.offset(cylinder), scale * machine.bore / 2
    low, high = machine.travel(cylinder)
    foot = scale * (low - 0.6 * SKIRT * machine.bore)
    head = scale * (high + (HEAD + GAP) * machine.bore)
    # It ends below the cylinders' numbers.
    line = Line(((x, -0.35 * scale * machine.radius(cylinder)), (x, head + 3)), "axis")
    bore = Line(((x - half, foot), (x - half, head), (x + half, head), (x + half, foot)), "part")
    turned = degrees(2 * pi * float(cylinder.bank.turns))
    return Group((line, bore), turned=turned, name=f"axis-{cylinder.number}")


def _moving(machine: Machine, cylinder: Cylinder, theta: float, scale: float, faded: bool) -> list[Shape]:
    """Return a cylinder's piston and rod as groups where they stand."""
    posture = machine.posture(cylinder, theta)
    bore = machine.bore * scale
    half, head, skirt = 0.475 * bore, HEAD * bore, SKIRT * bore
    crown = Line(((-half, -skirt), (-half, head), (half, head), (half, -skirt)), "piston", closed=True)
    pin = Circle((0, 0), 0.11 * bore, "part", opaque=True)
    length = scale * abs(posture.piston_pin - posture.rod_pin)
    big, small = 0.17 * bore, 0.13 * bore
    shank = Line(
        (
            (-0.8 * small, length - small),
            (-0.8 * big, big),
            (0.8 * big, big),
            (0.8 * small, length - small),
        ),
        "rod",
        closed=True,
    )
    rod = (Circle((0, 0), big, "rod"), Circle((0, length), small, "rod"), shank)
    number = cylinder.number
    parts: list[Shape] = [
        Group(
            (crown, pin),
            point(posture.piston_pin, scale),
            degrees(2 * pi * float(cylinder.bank.turns)),
            f"piston-{number}",
            faded,
        ),
        Group(rod, point(posture.rod_pin, scale), degrees(posture.rod_angle), f"rod-{number}", faded),
    ]
    return parts


def _master(machine: Machine, cylinder: Cylinder, theta: float, scale: float, faded: bool) -> list[Shape]:
    """Return the big end that link rods hang on: a disc about the crank pin."""
    linked = [
        c
        for c in machine.engine.cylinders
        if c.link and c.link.master == cylinder.number and c.link.radius
    ]
    if not linked:
        return []
    posture = machine.posture(cylinder, theta)
    reach = scale * max(float(c.link.radius) for c in linked if c.link)
    disc = (Circle((0, 0), reach + 0.16 * machine.bore * scale, "shade"),)
    return [
        Group(
            disc,
            point(posture.crank_pin, scale),
            degrees(posture.rod_angle),
            f"master-{cylinder.number}",
            faded,
        )
    ]


def _crank(machine: Machine, theta: float, scale: float) -> Shape:
    """Return the crank: its journal, and a web and a pin for each throw, the front one in full."""
    bore = machine.bore * scale
    webs: dict[complex, Cylinder] = {}
    for cylinder in machine.front_to_rear:
        pin = machine.pin(cylinder, 0.0)
        webs.setdefault(complex(round(pin.real, 9), round(pin.imag, 9)), cylinder)
    shapes: list[Shape] = []
    for place, pin in enumerate(webs):
        end = point(pin, scale)
        throw = (Line(((0, 0), end), "crank"), Circle(end, 0.12 * bore, "crank", opaque=True))
        shapes.append(Group(throw, name=f"throw-{webs[pin].number}", faded=place > 0))
    shapes = [*reversed(shapes), Circle((0, 0), 0.16 * bore, "crank", opaque=True)]
    return Group(tuple(shapes), (0, 0), degrees(theta), "crank")


def _offset(machine: Machine, cylinder: Cylinder, scale: float, words: bool) -> list[Shape]:
    """Return the dimension of an axis that passes beside the crank: a short line and e = …"""
    offset = machine.offset(cylinder)
    axis = machine.axis(cylinder)
    low = -1.3 * machine.radius(cylinder)
    ends = [point(complex(low, x) * axis, scale) for x in (0.0, offset)]
    line = Line((ends[0], ends[1]), "force")
    if not words:
        return [line]
    text = f"e = {float(abs(cylinder.offset)):g} mm"
    # Below all that turns, whatever the axis' angle.
    low = -scale * (1.3 * machine.radius(cylinder) + 0.17 * machine.bore) - 12
    return [line, Label((10 if offset > 0 else -10, low), text, "start" if offset > 0 else "end", 11)]


def _numbers(machine: Machine, scale: float) -> list[Shape]:
    """Return the cylinders' numbers outside the head of each axis, from front to rear."""
    labels: list[Shape] = []
    groups: dict[tuple[object, float], list[int]] = {}
    for cylinder in machine.front_to_rear:
        groups.setdefault((cylinder.bank, machine.offset(cylinder)), []).append(cylinder.number)
    cylinders = {c.number: c for c in machine.engine.cylinders}
    for numbers in groups.values():
        cylinder = cylinders[numbers[0]]
        axis = machine.axis(cylinder)
        high = machine.travel(cylinder)[1] + (HEAD + GAP) * machine.bore
        x, y = point(complex(high, machine.offset(cylinder)) * axis, scale)
        text = numbers_text(numbers)
        # As far out as its nearest corner needs to clear the head.
        away = 6 + 3.4 * len(text) * abs(axis.imag) + 6 * abs(axis.real)
        at = x + away * axis.imag, y + away * axis.real
        labels.append(Group((Label((0.0, 0.0), text),), at, name=f"numbers-{cylinder.number}"))
    return labels


def numbers_text(numbers: list[int]) -> str:
    """Return cylinders' numbers as they stand in a drawing, long rows shortened.

    >>> numbers_text([1, 3, 5]), numbers_text([1, 2, 3, 4, 5, 6, 7, 8])
    ('1 3 5', '1 2 … 8')
    """
    shown = numbers if len(numbers) <= 6 else [*numbers[:2], "…", numbers[-1]]
    return " ".join(map(str, shown))


def _box(machine: Machine, scale: float) -> tuple[float, float, float, float]:
    """Return left, bottom, right and top of all that is drawn."""
    reach = [(0.0, 0.0)]
    links = [float(c.link.radius) for c in machine.engine.cylinders if c.link and c.link.radius]
    crank = scale * (machine.radius(machine.engine.first) + max([0.0, *links]) + 0.2 * machine.bore)
    reach += [(-crank, -crank), (crank, crank)]
    for cylinder in machine.engine.cylinders:
        axis, half = machine.axis(cylinder), 0.62 * machine.bore
        head = machine.travel(cylinder)[1] + (HEAD + GAP) * machine.bore
        for side in (-half, half):
            reach.append(point(complex(head, machine.offset(cylinder) + side) * axis, scale))
    xs, ys = zip(*reach, strict=True)
    return min(xs), min(ys), max(xs), max(ys)


def _words(machine: Machine, front: list[Cylinder], theta: float) -> str:
    engine = machine.engine
    parts = [f"{len(engine.cylinders)} cylinders seen from the front, the crank turning clockwise"]
    turn = theta * pi / 180
    for cylinder in front[:4]:
        posture, (low, high) = machine.posture(cylinder, turn), machine.travel(cylinder)
        height = (posture.piston_pin / machine.axis(cylinder)).real
        down = 100 * (high - height) / (high - low)
        parts.append(f"piston {cylinder.number} stands {down:.0f} % of its stroke below the top")
    if machine.assumed:
        parts.append("assumed for the drawing: " + ", ".join(machine.assumed))
    return "; ".join(parts) + "."


def _degrees(theta: float) -> str:
    return f"{theta:g}°".replace("-", "−")
