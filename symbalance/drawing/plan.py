"""The plan of an engine: crank and pistons seen from above, the front to the left, at a crank angle.

A pin stands as far to the side as it does at that angle; a cylinder's bore is drawn where its axis is at
the piston pin. The lever arms of couples are the distances from the mean of all stations, a line across.
"""

from __future__ import annotations

from math import pi

from symbalance.document.shapes import Circle, Drawing, Group, Label, Line, Point, Shape
from symbalance.drawing.positions import Machine
from symbalance.drawing.section import HEAD, SKIRT
from symbalance.engine.cylinders import Cylinder
from symbalance.engine.engine import Engine

LENGTH, HEIGHT = 620.0, 420.0
"""Pixels that a plan may be long and high."""
EDGE = 30.0


def draw_plan(engine: Engine, theta: float = 0.0) -> Drawing:
    """Return the plan at a crank angle in degrees.

    >>> from symbalance.engine.builders import boxer
    >>> draw_plan(boxer("1-2")).title
    'Plan of engine at θ = 0°, the front to the left'
    """
    machine, turn = Machine(engine), theta * pi / 180
    scale, width = plan_scale(machine)
    stations = [c.station for c in engine.cylinders]
    front = float(max(stations))

    def across(station: float) -> float:
        return scale * machine.pitch * (front - station)

    shapes: list[Shape] = []
    for cylinder in reversed(machine.front_to_rear):
        axis, x = machine.axis(cylinder), across(float(cylinder.station))
        posture = machine.posture(cylinder, turn)
        middle = posture.piston_pin.imag * scale
        # Seen from above, a piston of an axis at an angle shows its crown and its side.
        half = 0.475 * machine.bore * scale
        low, high = (-SKIRT * machine.bore * scale, HEAD * machine.bore * scale)
        ends = sorted(h * axis.imag for h in (low, high))
        foot, head = ends[0] - abs(axis.real) * half, ends[1] + abs(axis.real) * half
        corners = ((-half, foot), (half, foot), (half, head), (-half, head))
        piston = Line(corners, "piston", closed=True)
        disc = Circle((0, 0), 9, "ink", opaque=True)
        label = Label((0, 0), str(cylinder.number), size=11)
        rod = Line(((x, posture.rod_pin.imag * scale), (x, middle)), "rod")
        shapes.append(Group((rod,), name=f"rod-{cylinder.number}"))
        shapes.append(Group((piston, disc, label), (x, middle), name=f"piston-{cylinder.number}"))
    shapes += _crank(machine, turn, scale, front)
    mean = across(float(engine.mean_station))
    low, high = -0.5 * width * scale - 8, 0.5 * width * scale + 8
    shapes.append(Line(((mean, low), (mean, high)), "axis"))
    shapes.append(Label((mean, low - 9), "mean of stations", size=11))
    left = -0.6 * machine.bore * scale - EDGE
    right = across(float(min(stations))) + 0.6 * machine.bore * scale + EDGE
    words = ", ".join(
        f"{c.number} at {float(c.station - engine.mean_station):g}".replace("-", "−")
        for c in machine.front_to_rear
    )
    return Drawing(
        tuple(shapes),
        left,
        low - EDGE,
        right,
        high + EDGE / 2,
        f"Plan of {engine.name} at θ = {theta:g}°, the front to the left".replace("-0°", "0°"),
        f"Stations in pitches from the mean, + towards the front: {words}.",
    )


def plan_scale(machine: Machine) -> tuple[float, float]:
    """Return the pixels that a length of one takes in the plan, and how wide the engine is."""
    engine = machine.engine
    stations = [c.station for c in engine.cylinders]
    length = machine.pitch * float(max(stations) - min(stations)) + 1.2 * machine.bore
    sides = [
        abs(machine.axis(c).imag) * (machine.travel(c)[1] + HEAD * machine.bore)
        + abs(machine.axis(c).real) * 0.475 * machine.bore
        + abs(machine.offset(c))
        for c in engine.cylinders
    ]
    width = 2 * max(machine.bore, 1.2 * machine.radius(engine.first), *sides)
    return min(LENGTH / length, HEIGHT / width), width


def throws_in_plan(machine: Machine) -> list[Cylinder]:
    """Return a cylinder of each throw, from the front to the rear: what the crank's line goes out to."""
    throws: dict[tuple[object, complex], Cylinder] = {}
    for cylinder in machine.front_to_rear:
        pin = machine.pin(cylinder, 0.0)
        throws.setdefault((cylinder.station, complex(round(pin.real, 9), round(pin.imag, 9))), cylinder)
    return list(throws.values())


def _crank(machine: Machine, theta: float, scale: float, front: float) -> list[Shape]:
    """Return the crank as a line that goes out to each throw's pin and back."""
    half = min(0.25 * machine.pitch, 0.3 * machine.bore) * scale
    points: list[Point] = [(-0.6 * machine.bore * scale - 18, 0.0)]
    for cylinder in throws_in_plan(machine):
        x = scale * machine.pitch * (front - float(cylinder.station))
        side = machine.pin(cylinder, theta).imag * scale
        points += [(x - half, 0.0), (x - half, side), (x + half, side), (x + half, 0.0)]
    stations = [c.station for c in machine.engine.cylinders]
    points.append(
        (scale * machine.pitch * (front - float(min(stations))) + 0.6 * machine.bore * scale + 18, 0.0)
    )
    return [Group((Line(tuple(points), "crank"),), name="crank")]
