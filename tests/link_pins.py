"""Masses on the link pins of articulated rods, by positions alone: an independent planar model.

A link pin stands at L e^(i (psi + tau)) from the crank pin, tau the direction from the crank pin to the
master's piston: it swings with the master rod, and a mass on it pushes with -m z''. Nothing here uses
the library's mechanisms; positions are sampled over a turn and transformed.
"""

from __future__ import annotations

from math import pi

import numpy as np

import symbalance as sb

POINTS = 512


def link_pin(layout: sb.Engine, cylinder: sb.Cylinder, theta: np.ndarray) -> np.ndarray:
    """Return where a cylinder's link pin stands, vertical + i lateral, over the crank radius."""
    assert cylinder.link is not None
    master = next(c for c in layout.cylinders if c.number == cylinder.link.master)
    train = master.sizes
    assert train.stroke is not None
    assert train.rod is not None
    radius, length, aside = (float(x) for x in (train.stroke / 2, train.rod, train.offset or 0))
    axis = np.exp(2j * pi * float(master.bank.turns))
    pin = radius * np.exp(1j * (theta + 2 * pi * float(master.throw.turns)))
    along = pin / axis  # the pin seen along the master's axis: its piston stands at h + i aside
    height = along.real + np.sqrt(length**2 - (along.imag - aside) ** 2)
    rod = axis * (height + 1j * aside - along) / length
    return (
        pin + float(cylinder.link.radius) * rod * np.exp(2j * pi * float(cylinder.link.angle))
    ) / radius


def force_series(layout: sb.Engine, masses: dict[int, float]) -> dict[int, complex]:
    """Return n -> c_n of the force of masses on link pins, sum of c_n e^(i n theta), in kg r omega^2.

    + n turns with the crank, - n against it; `masses` in kg by cylinder, r the crank radius.
    """
    theta = 2 * pi * np.arange(POINTS) / POINTS
    total = sum(
        masses[c.number] * link_pin(layout, c, theta) for c in layout.cylinders if c.number in masses
    )
    numbers = np.fft.fft(total) / POINTS
    return {n: complex(n * n * numbers[n]) for n in range(-12, 13)}
