"""The crank with rods and pistons in an oblique view from the front, at a crank angle.

The front's plane is drawn as it is; what lies behind it is moved up and to the right. The rear is drawn
first, so that the front covers it.
"""

from __future__ import annotations

from cmath import phase
from collections.abc import Callable
from itertools import product
from math import cos, degrees, pi, sin

from symbalance.document.shapes import Circle, Drawing, Label, Line, Point, Shape
from symbalance.drawing.positions import Machine
from symbalance.drawing.section import HEAD, SKIRT
from symbalance.engine.cylinders import Cylinder
from symbalance.engine.engine import Engine

WIDTH, HEIGHT = 560.0, 460.0
ALONG, UP = 0.80, 0.42
"""Of a length along the crank: to the right and up."""
CORNERS = 16
"""Of what is drawn for a circle across an axis."""


def draw_oblique(engine: Engine, theta: float = 0.0) -> Drawing:
    """Return the oblique view at a crank angle in degrees.

    >>> from symbalance.engine.builders import inline
    >>> draw_oblique(inline("1-3-4-2")).shows
    'Pins seen from the front, clockwise from straight up: 1 at 0°, 2 at 180°, 3 at 180°, 4 at 0°.'
    """
    machine, turn = Machine(engine), theta * pi / 180
    front = float(max(c.station for c in engine.cylinders))
    shapes: list[Shape] = []

    def at(place: complex, station: float) -> Point:
        back = machine.pitch * (front - station)
        return place.imag + ALONG * back, place.real + UP * back

    half = min(0.22 * machine.pitch, 0.3 * machine.bore) / machine.pitch
    rear = min(float(c.station) for c in engine.cylinders)
    previous = rear - 0.7
    shapes_of_throw: dict[float, None] = {}
    for cylinder in reversed(machine.front_to_rear):
        station, posture = float(cylinder.station), machine.posture(cylinder, turn)
        if station not in shapes_of_throw:
            shapes_of_throw[station] = None
            pins = {
                _rounded(machine.pin(c, turn)): machine.pin(c, turn)
                for c in engine.cylinders
                if float(c.station) == station
            }
            shapes.append(Line((at(0j, previous), at(0j, station - half)), "crank"))
            for pin in pins.values():
                places = (
                    (0j, station - half),
                    (pin, station - half),
                    (pin, station + half),
                    (0j, station + half),
                )
                shapes.append(Line(tuple(at(*place) for place in places), "crank"))
            previous = station + half
        axis = machine.axis(cylinder)
        shapes.append(Line((at(posture.rod_pin, station), at(posture.piston_pin, station)), "rod"))
        rings = [
            _ring(machine, posture.piston_pin + h * machine.bore * axis, axis, station, at)
            for h in (-SKIRT, HEAD)
        ]
        shapes.append(_hull([*rings[0], *rings[1]]))
        # The crown, or the skirt, is what one sees of a piston's ends.
        shapes.append(Line(tuple(rings[1] if axis.real >= -0.2 else rings[0]), "piston", closed=True))
        middle = at(posture.piston_pin, station)
        shapes += [Label(middle, str(cylinder.number))]
    shapes.append(Line((at(0j, previous), at(0j, front + 0.7)), "crank"))
    xs, ys = zip(*_reach(machine, at, rear - 0.7, front + 0.7), strict=True)
    scale = min(WIDTH / (max(xs) - min(xs)), HEIGHT / (max(ys) - min(ys)))
    shapes = [_scaled(shape, scale) for shape in shapes]
    pins_text = ", ".join(
        f"{c.number} at {_pin_degrees(machine, c, turn):g}°"
        for c in sorted(engine.cylinders, key=lambda c: c.number)
    )
    return Drawing(
        tuple(shapes),
        scale * min(xs) - 14,
        scale * min(ys) - 14,
        scale * max(xs) + 14,
        scale * max(ys) + 14,
        f"{engine.name} seen obliquely from the front at θ = {theta:g}°",
        f"Pins seen from the front, clockwise from straight up: {pins_text}.",
    )


def _reach(
    machine: Machine, at: Callable[[complex, float], Point], rear: float, front: float
) -> list[Point]:
    """Return what bounds the view over a whole turn, so that its frame stands still."""
    reach = [at(0j, rear), at(0j, front)]
    across = 0.475 * machine.bore
    half = min(0.22 * machine.pitch, 0.3 * machine.bore) / machine.pitch
    for cylinder in machine.engine.cylinders:
        axis, station = machine.axis(cylinder), float(cylinder.station)
        low, high = machine.travel(cylinder)
        for height in (low - SKIRT * machine.bore, high + HEAD * machine.bore):
            middle = complex(height, machine.offset(cylinder)) * axis
            for side, along in product((-across, across), (-1, 1)):
                reach.append(at(middle + 1j * side * axis, station + along * across / machine.pitch))
        # The pin a link rod turns on goes round further out than the crank pin.
        link = float(cylinder.link.radius) if cylinder.link and cylinder.link.radius else 0.0
        radius = machine.radius(cylinder) + link
        for place, along in product((radius, -radius, 1j * radius, -1j * radius), (-half, half)):
            reach.append(at(place, station + along))
    return reach


def _pin_degrees(machine: Machine, cylinder: Cylinder, turn: float) -> float:
    return round(round(degrees(phase(machine.pin(cylinder, turn))), 3) % 360, 3)


def _rounded(value: complex) -> complex:
    return complex(round(value.real, 6), round(value.imag, 6))


def _ring(
    machine: Machine,
    middle: complex,
    axis: complex,
    station: float,
    at: Callable[[complex, float], Point],
) -> list[Point]:
    """Return a circle of the bore across an axis: one diameter along the crank, one across."""
    half = 0.475 * machine.bore
    ring = []
    for k in range(CORNERS):
        t = 2 * pi * k / CORNERS
        ring.append(at(middle + 1j * axis * half * cos(t), station + half * sin(t) / machine.pitch))
    return ring


def _hull(points: list[Point]) -> Line:
    """Return the convex outline of points: of a cylinder, what covers the things behind it."""
    ordered = sorted(set(points))

    def chain(row: list[Point]) -> list[Point]:
        line: list[Point] = []
        for x, y in row:
            while len(line) > 1 and (line[-1][0] - line[-2][0]) * (y - line[-2][1]) <= (
                line[-1][1] - line[-2][1]
            ) * (x - line[-2][0]):
                line.pop()
            line.append((x, y))
        return line[:-1]

    return Line((*chain(ordered), *chain(ordered[::-1])), "piston", closed=True)


def _scaled(shape: Shape, scale: float) -> Shape:
    if isinstance(shape, Line):
        # A tenth of a pixel is enough for a view, and keeps pages small.
        points = tuple((round(scale * x, 1), round(scale * y, 1)) for x, y in shape.points)
        return Line(points, shape.look, shape.closed)
    if isinstance(shape, Label):
        return Label((scale * shape.at[0], scale * shape.at[1]), shape.text, shape.align, shape.size)
    assert isinstance(shape, Circle)
    return Circle((scale * shape.centre[0], scale * shape.centre[1]), scale * shape.radius, shape.look)
