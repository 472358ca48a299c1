"""Position, velocity and acceleration of the piston and the rod at a crank angle, in closed form.

Values have the digits of the crank angle they are at, 40 where it carries none; every derivative is in
closed form, by d/dp of the formulas in the package's head. Times r, r omega, r omega^2; the rod's in rad,
omega, omega^2.

Formulas:
    dphi/dtheta = rho cos theta/cos phi
    d^2phi/dtheta^2 = -rho (1 - rho^2) sin theta/cos^3 phi
    d^2phi/dtheta^2 = (D^2 sin phi - rho sin theta)/cos phi
    with D = dphi/dtheta
"""

from __future__ import annotations

from typing import Generic, NamedTuple, TypeVar

from symbalance.kinematics.mechanisms.mechanism_types import LinkRod, Mechanism, SliderCrank
from symbalance.text.reals import Complex, Exact, Real, asin, expj, expjpi, pi, sqrt

Number = TypeVar("Number", Real, Complex)


class Motion(NamedTuple, Generic[Number]):
    """A quantity and its first and second derivative by the crank angle."""

    value: Number
    first: Number
    second: Number


def height(mechanism: Mechanism, p: Exact | Real) -> Real:
    """Return the piston's height y(p) along its axis from the crank's axis, over r.

    `p` is the cylinder's own crank angle in radians.

    >>> from symbalance.text.reals import nstr
    >>> nstr(height(SliderCrank(4, "1/4"), 0), 15)
    '4.99217985566783'
    """
    place = _pin_place(mechanism, p)
    return place.real + mechanism.length * _cosine(_slant(mechanism, place))


def rod_angle(mechanism: Mechanism, p: Exact | Real) -> Real:
    """Return phi(p) in radians, sin phi = (lateral place of the rod's pin - offset)/length.

    Of a `LinkRod` it is the link rod's own angle to its own cylinder's axis.
    """
    return asin(_slant(mechanism, _pin_place(mechanism, p)))


def rod_motion(mechanism: Mechanism, p: Exact | Real) -> Motion[Real]:
    """Return phi(p), phi' = v'/(l cos phi) and phi'' = (v''/l + phi'^2 sin phi)/cos phi, v = Im w."""
    return _rod_motion(mechanism, _pin_motion(mechanism, p))


def height_motion(mechanism: Mechanism, p: Exact | Real) -> Motion[Real]:
    """Return y(p), y' = u' - l phi' sin phi and y'' = u'' - l (phi'' sin phi + phi'^2 cos phi), u = Re w.

    The inertia force over m r omega^2 is -y''. Without offset:

    Formulas:
        dy/dtheta = -sin theta - lambda D sin phi
        with y = cos theta + lambda cos phi; D = dphi/dtheta

    >>> from symbalance.text.reals import nstr
    >>> nstr(height_motion(SliderCrank(4), 0).second, 15)  # -(1 + 1/lambda)
    '-1.25'
    """
    pin = _pin_motion(mechanism, p)
    rod = _rod_motion(mechanism, pin)
    length, sine = mechanism.length, _slant(mechanism, pin.value)
    cosine = _cosine(sine)
    return Motion(
        pin.value.real + length * cosine,
        pin.first.real - length * sine * rod.first,
        pin.second.real - length * (sine * rod.second + cosine * rod.first**2),
    )


def _slant(mechanism: Mechanism, place: Complex) -> Real:
    """Return sin phi of the rod whose pin is at a place."""
    return (place.imag - mechanism.offset) / mechanism.length


def _cosine(sine: Real) -> Real:
    return sqrt((1 - sine) * (1 + sine))


def _arm(link: LinkRod, digits: int) -> Complex:
    """Return L e^(i chi)."""
    return expjpi(2 * link.pin_direction, digits) * link.link_radius


def _master_angle(link: LinkRod, p: Real) -> Real:
    return p + 2 * pi(p.digits) * link.bank_difference


def _pin_place(mechanism: Mechanism, p: Exact | Real) -> Complex:
    """Return w, the place of the pin that the rod turns on."""
    p = Real(p)
    turn = expj(p)
    if isinstance(mechanism, SliderCrank):
        return turn
    sine = _slant(mechanism.master, expj(_master_angle(mechanism, p)))
    return turn + _arm(mechanism, p.digits) * Complex(_cosine(sine), -sine)


def _pin_motion(mechanism: Mechanism, p: Exact | Real) -> Motion[Complex]:
    p = Real(p)
    turn = expj(p)
    if isinstance(mechanism, SliderCrank):
        return Motion(turn, 1j * turn, -turn)
    rod = rod_motion(mechanism.master, _master_angle(mechanism, p))
    arm = _arm(mechanism, p.digits) * expj(-rod.value)
    return Motion(
        turn + arm, 1j * (turn - arm * rod.first), -turn - arm * Complex(rod.first**2, rod.second)
    )


def _rod_motion(mechanism: Mechanism, pin: Motion[Complex]) -> Motion[Real]:
    length, sine = mechanism.length, _slant(mechanism, pin.value)
    cosine = _cosine(sine)
    first = pin.first.imag / (length * cosine)
    return Motion(asin(sine), first, (pin.second.imag / length + sine * first**2) / cosine)
