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


def _series(values: np.ndarray) -> np.ndarray:
    return np.fft.fft(values) / len(values)


def _rate(values: np.ndarray) -> np.ndarray:
    """Return the derivative by theta of a periodic function."""
    n = np.fft.fftfreq(len(values), 1 / len(values))
    return np.fft.ifft(1j * n * np.fft.fft(values))


def torque_and_moment(layout: sb.Engine, masses: dict[int, float]) -> tuple[np.ndarray, np.ndarray]:
    """Return C + iS, by order, of what masses on link pins do to the crank's torque, and their moment.

    The torque gives back the kinetic energy, -dE/dtheta; the moment about the crank's axis is minus the
    change of the moment of momentum. In kg r^2 omega^2.
    """
    theta = 2 * pi * np.arange(POINTS) / POINTS
    energy, momentum = np.zeros(POINTS), np.zeros(POINTS)
    for cylinder in layout.cylinders:
        if cylinder.number in masses:
            place = link_pin(layout, cylinder, theta)
            speed = _rate(place)
            energy += masses[cylinder.number] * abs(speed) ** 2 / 2
            momentum += masses[cylinder.number] * (place.conj() * speed).imag
    torque, moment = (-_rate(values).real for values in (energy, momentum))
    return 2 * _series(torque).conj(), 2 * _series(moment).conj()
