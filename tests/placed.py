"""Free forces of any engine from where its pistons stand: circles and lines, and then numbers alone.

Nothing here knows a harmonic or a series: a pin goes round, a rod of its length meets the cylinder's
axis, a link rod hangs on a point of the master rod. The heights are sampled and transformed, in doubles,
or differentiated numerically, in mpmath.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
from mpmath import mp

import symbalance as sb

POINTS = 256
"""Samples of a turn: harmonics that alias onto the low orders are far below a rounding."""
THETA = 2 * np.pi * np.arange(POINTS) / POINTS


def direction(angle: Any) -> complex:
    """Return the direction of an angle from straight up, in the sense of rotation: up + i right."""
    return np.exp(2j * np.pi * float(angle.turns))


def met(pin: Any, axis: complex, length: Fraction, offset: Fraction | None) -> Any:
    """Return how far up a line along `axis`, `offset` to its right, a rod from `pin` reaches."""
    own = pin / axis
    return own.real + np.sqrt(float(length) ** 2 - (own.imag - float(offset or 0)) ** 2)


def heights(layout: sb.Engine, cylinder: sb.Cylinder, theta: Any = THETA) -> Any:
    """Return a piston's height in mm above the crank along its axis, at crank angles."""
    train, axis = cylinder.sizes, direction(cylinder.bank)
    if cylinder.link is None:
        assert train.stroke is not None
        pin = float(train.stroke) / 2 * np.exp(1j * theta) * direction(cylinder.throw)
        return met(pin, axis, train.rod, train.offset)
    master = next(c for c in layout.cylinders if c.number == cylinder.link.master)
    over, up = master.sizes, direction(master.bank)
    pin = float(over.stroke) / 2 * np.exp(1j * theta) * direction(master.throw)
    top = (met(pin, up, over.rod, over.offset) + 1j * float(over.offset or 0)) * up
    arm = (top - pin) / abs(top - pin) * np.exp(2j * np.pi * float(cylinder.link.angle))
    return met(pin + float(cylinder.link.radius) * arm, axis, cylinder.sizes.rod, train.offset)


def planar_series(layout: sb.Engine, arms: bool) -> Any:
    """Return force (couple) / m r omega^2, up + i right, two-sided: [n] belongs to e^(in theta)."""
    first = min(layout.cylinders, key=lambda c: c.number)
    mean = float(sum(c.station for c in layout.cylinders)) / len(layout.cylinders)
    orders = np.fft.fftfreq(POINTS, 1 / POINTS)
    total = np.zeros(POINTS, complex)
    for cylinder in layout.cylinders:
        train = cylinder.sizes
        mass = float(train.reciprocating_mass or 1) / float(first.reciprocating_mass or 1)
        arm = float(cylinder.station) - mean if arms else 1
        series = np.fft.fft(heights(layout, cylinder)) / POINTS / (float(first.stroke) / 2)
        total += mass * arm * orders**2 * series * direction(cylinder.bank)
    return total


def component(series: Any, n: int, name: str) -> tuple[float, float]:
    """Return (cos, sin) of the vertical or lateral part of order n."""
    forward, backward = series[n], series[-n]
    # Z = sum Z_n e^(in theta): up = Re Z, right = Im Z.
    value = forward + np.conj(backward) if name == "vertical" else (forward - np.conj(backward)) / 1j
    return float(value.real), float(-value.imag)


def stroke_and_top(layout: sb.Engine, cylinder: sb.Cylinder) -> tuple[float, float]:
    """Return a piston's stroke in mm and theta at its top dead centre in degrees, looking ever closer."""

    def best(sign: int) -> tuple[float, float]:
        low, high = 0.0, 2 * np.pi
        for _ in range(12):
            theta = np.linspace(low, high, 201)
            values = sign * heights(layout, cylinder, theta)
            i = int(np.argmax(values))
            step = (high - low) / 200
            low, high = theta[i] - step, theta[i] + step
        return float((low + high) / 2), float(sign * values[i])

    (top, highest), (_, lowest) = best(1), best(-1)
    return highest - lowest, float(np.degrees(top)) % 360


def planar(layout: sb.Engine, theta: Any, arms: bool) -> Any:
    """Return vertical + i lateral over m r omega^2 of cylinder 1 at one crank angle, in mpmath."""
    first = min(layout.cylinders, key=lambda c: c.number)
    total = mp.mpc(0)
    for cylinder in layout.cylinders:
        train = cylinder.sizes
        mass = exact((train.reciprocating_mass or 1) / (first.reciprocating_mass or Fraction(1)))
        force = -mp.diff(lambda t, c=cylinder: place(layout, c, t), theta, 2) / exact(first.stroke / 2)
        arm = exact(cylinder.station - layout.mean_station) if arms else 1
        total += mass * arm * force * rotated(cylinder.bank)
    return total


def place(layout: sb.Engine, cylinder: sb.Cylinder, theta: Any) -> Any:
    """Return how far a piston stands from the crank along its axis, in mm."""
    train = cylinder.sizes
    if cylinder.link is None:
        pin = exact(train.stroke / 2) * mp.expj(theta) * rotated(cylinder.throw)
        return along(pin, rotated(cylinder.bank), train.rod, train.offset)
    master = next(c for c in layout.cylinders if c.number == cylinder.link.master)
    over, up = master.sizes, rotated(master.bank)
    pin = exact(over.stroke / 2) * mp.expj(theta) * rotated(master.throw)
    top = mp.mpc(along(pin, up, over.rod, over.offset), exact(over.offset or 0)) * up
    arm = (top - pin) / abs(top - pin) * mp.expjpi(2 * exact(cylinder.link.angle))
    pin += exact(cylinder.link.radius) * arm
    return along(pin, rotated(cylinder.bank), cylinder.sizes.rod, train.offset)


def along(pin: Any, axis: Any, length: Fraction, offset: Fraction | None) -> Any:
    """Return where a rod from `pin` meets a line parallel to `axis`, `offset` to its right."""
    own = pin / axis
    return own.real + mp.sqrt(exact(length) ** 2 - (own.imag - exact(offset or 0)) ** 2)


def exact(number: Fraction | int) -> Any:
    return mp.mpf(Fraction(number).numerator) / Fraction(number).denominator


def rotated(angle: Any) -> Any:
    return mp.expjpi(2 * exact(angle.turns))
