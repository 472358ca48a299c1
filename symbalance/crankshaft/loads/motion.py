"""Motion of pistons and rods in closed form for arrays of crank angles, in floating point.

The same closed forms as `symbalance.kinematics.mechanisms` has for single angles.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from symbalance.crankshaft.arrays import Array
from symbalance.kinematics.mechanisms import LinkRod, Mechanism, SliderCrank

Complex = NDArray[np.complex128]


@dataclass(frozen=True)
class PistonMotion:
    """A piston's height y over r and its rod's angle phi, with their derivatives by p.

    `pin` is the place of the pin that the rod turns on, over r.
    """

    pin: Complex
    height: Array
    speed: Array
    acceleration: Array
    angle: Array
    angle_rate: Array
    angle_acceleration: Array


def piston_motion(mechanism: Mechanism, p: Array) -> PistonMotion:
    """Return the motion of a piston and its rod at the cylinder's own crank angles `p`, radians.

    y = Re w + l cos phi, sin phi = (Im w - eps)/l, w the place of the rod's pin; over r, r omega, ....

    >>> piston = piston_motion(SliderCrank(4), np.array([0.0, np.pi / 2]))
    >>> piston.acceleration.round(9).tolist(), piston.angle_rate.round(9).tolist()
    ([-1.25, 0.25819889], [0.25, 0.0])
    """
    place, first, second = _pin(mechanism, p)
    length, offset = float(mechanism.length), float(mechanism.offset)
    sine = (place.imag - offset) / length
    cosine = np.sqrt((1 - sine) * (1 + sine))
    angle_rate = first.imag / (length * cosine)
    angle_acceleration = (second.imag / length + sine * angle_rate**2) / cosine
    return PistonMotion(
        place,
        place.real + length * cosine,
        first.real - length * sine * angle_rate,
        second.real - length * (sine * angle_acceleration + cosine * angle_rate**2),
        np.arcsin(sine),
        angle_rate,
        angle_acceleration,
    )


def _pin(mechanism: Mechanism, p: Array) -> tuple[Complex, Complex, Complex]:
    """Return the place of the rod's pin and its two derivatives by p."""
    turn = np.exp(1j * p)
    if isinstance(mechanism, SliderCrank):
        return turn, 1j * turn, -turn
    rod = piston_motion(mechanism.master, p + 2 * np.pi * float(mechanism.bank_difference))
    arm = link_arm(mechanism) * np.exp(-1j * rod.angle)
    first = 1j * (turn - arm * rod.angle_rate)
    return turn + arm, first, -turn - arm * (1j * rod.angle_acceleration + rod.angle_rate**2)


def link_arm(link: LinkRod) -> complex:
    """Return L e^(i chi): the link pin from the crank pin where the master's rod angle is 0."""
    return complex(float(link.link_radius) * np.exp(2j * np.pi * float(link.pin_direction)))
