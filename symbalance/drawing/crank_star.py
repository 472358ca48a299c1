"""The crank star of an order: each cylinder an arrow at n times its crank angle, and what they add up to.

A cylinder of throw t on an axis at b pushes in order n with cos n(theta + t - b), along its own axis: an
arrow at n (t - b). Cylinders of one axis make one star, which closes or leaves a resultant. Whether it
closes is decided exactly, as everywhere.

Formulas:
    cos a + cos(a + 2 pi/3) + cos(a + 4 pi/3) = 0
    with a an angle
"""

from __future__ import annotations

from cmath import exp
from dataclasses import replace
from fractions import Fraction
from math import ceil, pi

from symbalance.document.shapes import Arrow, Circle, Drawing, Label, Shape
from symbalance.drawing.section import numbers_text
from symbalance.engine.cylinders import Cylinder
from symbalance.engine.engine import Engine
from symbalance.errors import SymbalanceError, brief
from symbalance.exact.phasor import Phasor

RADIUS = 78.0
"""Pixels of an arrow of one cylinder."""
CELL = 250.0
"""Pixels of a star with its labels."""
ACROSS = 3
"""Stars side by side."""
HIGHEST = 1000
CLOSED = 1e-9


def star_resultant(cylinders: tuple[Cylinder, ...], order: Fraction) -> Phasor:
    """Return the sum of e^(i n (throw - bank)) over cylinders: what a star leaves, exactly.

    Of a half order, which counts from the firing dead centre, a cylinder's angle is that at which it
    fires; refused where that is not known.

    >>> from symbalance.engine.builders import inline
    >>> star_resultant(inline("1-2-3").cylinders, Fraction(1)).is_zero()
    True
    """
    total = Phasor.of(1, {})
    for cylinder in cylinders:
        total = total + Phasor.root(star_turns(cylinder, order))
    return total


def star_turns(cylinder: Cylinder, order: Fraction) -> Fraction:
    """Return an arrow's direction in turns, from 0 up to 1."""
    if order.denominator == 1:
        return order * cylinder.delay.turns % 1
    if cylinder.fires is None:
        rule = "has no firing angle, which a half order counts from"
        raise SymbalanceError(f"cylinder {cylinder.number}", rule, "give fires, or a firing order")
    return -order * cylinder.fires / 360 % 1


def draw_star(engine: Engine, order: object = 1) -> Drawing:
    """Return the crank star of an order, one for each direction of an axis.

    >>> from symbalance.engine.builders import inline
    >>> draw_star(inline("1-3-4-2"), 2).shows
    'Order 2: 1 2 3 4 at 0°. Leaves 4 arrows at 0°.'
    """
    from symbalance.text.numbers import exact

    n = exact(order, "order")
    if not 0 < n <= HIGHEST or n.denominator > 2:
        rule = f"must be 1/2, 1, 3/2, … up to {HIGHEST}"
        raise SymbalanceError(f"order = {brief(order)}", rule, "as --order 2")
    if engine.has_symbols:
        raise SymbalanceError(engine.name, "has symbols for angles", "draw it with angles in numbers")
    banks = engine.grouped(lambda c: c.bank)
    across = 2 if len(banks) == 4 else min(len(banks), ACROSS)
    shapes: list[Shape] = []
    words = []
    for place, (bank, cylinders) in enumerate(banks.items()):
        x = CELL * (place % across - (across - 1) / 2)
        y = -CELL * (place // across)
        inner, said = _star(cylinders, n, x, y)
        shapes += inner
        name = f"axis at {float(bank.in_degrees()):g}°: ".replace("-", "−") if len(banks) > 1 else ""
        if name:
            shapes.append(Label((x, y + CELL / 2 - 12), name.removesuffix(": "), size=11))
        words.append(name + said)
    half = CELL * across / 2
    rows = ceil(len(banks) / across)
    return Drawing(
        tuple(shapes),
        -half,
        -CELL * (rows - 0.5),
        half,
        CELL / 2,
        f"Crank star of order {n} of {engine.name}",
        f"Order {n}: {'; '.join(words)}.",
    )


def draw_star_alone(engine: Engine, order: object = 1) -> Drawing:
    """Return the crank star of an order with the order written on it.

    >>> from symbalance.engine.builders import inline
    >>> draw_star_alone(inline("1-3-4-2"), 2).shapes[-1].text
    'order 2'
    """
    star = draw_star(engine, order)
    name = star.title.removeprefix("Crank star of ").removesuffix(f" of {engine.name}")
    label = Label((star.left + 8, star.top - 12), name, "start", strong=True)
    return replace(star, shapes=(*star.shapes, label))


def _star(
    cylinders: tuple[Cylinder, ...], order: Fraction, x: float, y: float
) -> tuple[list[Shape], str]:
    """Return a star about a place, and what it shows in words."""
    groups: dict[Fraction, list[int]] = {}
    for cylinder in sorted(cylinders, key=lambda c: c.number):
        groups.setdefault(star_turns(cylinder, order), []).append(cylinder.number)
    shapes: list[Shape] = [Circle((x, y), RADIUS, "faint")]
    for turns, numbers in groups.items():
        out = exp(2j * pi * float(turns))
        end = x + RADIUS * out.imag, y + RADIUS * out.real
        shapes.append(Arrow((x, y), end, "ink"))
        text = numbers_text(numbers)
        away = 12 + 3.0 * (len(text) - 1) * abs(out.imag)
        shapes.append(Label((x + (RADIUS + away) * out.imag, y + (RADIUS + away) * out.real), text))
    rest = star_resultant(cylinders, order)
    if rest.is_zero():
        verdict = "closes: 0, proved"
    else:
        value = complex(rest.evaluated(15))
        size, turns = abs(value), _turns(value)
        end = x + RADIUS * value.imag / len(cylinders), y + RADIUS * value.real / len(cylinders)
        shapes.append(Arrow((x, y), end, "force"))
        plural = "" if abs(size - 1) < CLOSED else "s"
        verdict = f"leaves {_figure(size)} arrow{plural} at {_figure(360 * turns)}°"
    shapes.append(Label((x, y - CELL / 2 + 14), verdict, strong=True))
    said = ", ".join(f"{' '.join(map(str, v))} at {_figure(float(360 * k))}°" for k, v in groups.items())
    return shapes, f"{said}. {verdict[0].upper()}{verdict[1:]}"


def _turns(value: complex) -> float:
    from cmath import phase

    turns = phase(value) / (2 * pi) % 1.0
    return 0.0 if turns > 1 - 1e-9 else turns


def _figure(value: float) -> str:
    return f"{round(value, 4):g}"
