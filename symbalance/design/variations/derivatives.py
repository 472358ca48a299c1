r"""Derivatives of every order of the free force and couple by each size of each cylinder.

Of cylinder j, with its contribution c_{+-n}, f its harmonic and everything else held fixed:

=========  ============================  =============================================
parameter  the unit of its change        derivative of c_{+-n}
=========  ============================  =============================================
mass       m of cylinder 1               c_{+-n} m_1/m_j
throw      radian                        +-i n c_{+-n}
bank       radian                        i (1 -+ n) c_{+-n}
station    pitch (couples only)          c_{+-n}
stroke     r of cylinder 1, of radius    f replaced by d(r f)/dr  (half of that for the stroke)
rod        r                             f replaced by r df/dl
offset     r                             f replaced by r df/de
rotating   m of cylinder 1               c_1 = e^(i throw), c_-1 = 0, order 1 alone, of
                                         rods on crank pins; `rotating_pair` of link rods
=========  ============================  =============================================

A turn of the crank pin (throw) keeps the axis, a turn of the axis (bank) keeps the pin. The geometry is
exact, a `Phasor` of the engine's field; the kinematics stands beside it as one number of 40 digits. The
reference plane of couples stays where it is.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction

from symbalance.design.variations.articulated import MOVING, articulated_sensitivities, attached_cylinders
from symbalance.design.variations.contributions import (
    Contribution,
    contributions,
    mechanism_to,
    rotating_pair,
)
from symbalance.design.variations.length_derivatives import LengthDerivatives, length_derivatives
from symbalance.design.variations.sensitivity import Sensitivities, Sensitivity
from symbalance.design.variations.speeds import speed_scale
from symbalance.engine.cylinders import Cylinder
from symbalance.engine.engine import Engine
from symbalance.errors import SymbalanceError, brief
from symbalance.exact.decimal_phasor import DecimalPhasor
from symbalance.exact.phasor import ZERO, Phasor
from symbalance.forces.operating_point import checked_rpm
from symbalance.kinematics.mechanisms import SliderCrank
from symbalance.kinematics.mechanisms.moving_masses import link_pin_force
from symbalance.text.numbers import as_list, exact
from symbalance.text.reals import Complex, Real

HALF, QUARTER = Fraction(1, 2), Fraction(1, 4)
PARAMETERS = ("mass", "throw", "bank", "station", "stroke", "rod", "offset", "rotating")
LENGTHS = ("stroke", "rod", "offset")


def sensitivities(
    engine: Engine,
    order: int = 4,
    *,
    parameters: object = None,
    reference: object = None,
    rpm: object = None,
) -> Sensitivities:
    """Return derivatives of all orders by each cylinder's sizes, largest effects (of `STEPS`) first.

    `parameters` limits them to some of "mass", "throw", "bank", "station", "stroke", "rod", "offset",
    "rotating" (default: all but the last). Orders that cancel in the engine as drawn are among them.
    A master's angles and lengths move the cylinders attached to it too: its derivatives are of all of
    them. A link rod has neither throw nor stroke of its own, they are its master's. Counterweights,
    shafts and rotating masses, those on link pins too, stay where they are: a size moves pistons and rods
    alone. With `rpm`, and the engine's stroke, reciprocating_mass and pitch, steps are in N and N m.

    >>> from symbalance.engine.builders import inline
    >>> changes = sensitivities(inline("1-3-4-2", ratio=4), 2, parameters=["mass"])
    >>> [(s.order, s.cylinder, s.force.vertical.cos, float(s.couple.vertical.cos)) for s in changes[:2]]
    [(1, 1, 1, 1.5), (1, 4, 1, -1.5)]
    """
    names = _checked_parameters(parameters)
    speed = None if rpm is None else checked_rpm(rpm)
    speed_scale(engine, speed)  # refuses what it lacks
    plane = None if reference is None else exact(reference, "reference")
    by_order = contributions(engine, order, plane)
    lengths = _length_derivatives(engine, order) if set(names) & set(LENGTHS) else {}
    pins = [link_pin_force(c.mechanism, order) for c in engine.cylinders] if "rotating" in names else []
    changes = [*articulated_sensitivities(engine, by_order, order, names)]
    for n in range(1, order + 1):
        for name in names:
            if name == "rotating":
                changes += _rotating(engine, n, by_order[1], pins)
            else:
                changes += _of_order(engine, n, name, by_order, lengths)
    changes.sort(key=lambda s: (-max(s.step()), s.order, PARAMETERS.index(s.parameter), s.cylinder))
    return Sensitivities(engine, order, names, plane, tuple(changes), speed)


def _checked_parameters(parameters: object) -> tuple[str, ...]:
    if parameters is None:
        return PARAMETERS[:-1]
    names = tuple(as_list(parameters, "parameters", '["mass", "throw"]'))
    unknown = [name for name in names if name not in PARAMETERS]
    if unknown or not names:
        what = f"parameters = {brief(unknown[0]) if unknown else '[]'}"
        raise SymbalanceError(what, "is no parameter", f"choose from {', '.join(PARAMETERS)}")
    return names


def _length_derivatives(engine: Engine, order: int) -> dict[int, dict[int, LengthDerivatives]]:
    """Return, by cylinder, the derivatives by lengths, but of masters and link rods."""
    masters, by_cylinder = attached_cylinders(engine), {}
    for cylinder in engine.cylinders:
        mechanism = mechanism_to(engine, cylinder, order)
        if isinstance(mechanism, SliderCrank) and cylinder.number not in masters:
            by_cylinder[cylinder.number] = length_derivatives(mechanism, order)
    return by_cylinder


def _of_order(
    engine: Engine,
    n: int,
    name: str,
    by_order: Mapping[int, Sequence[Contribution]],
    lengths: dict[int, dict[int, LengthDerivatives]],
) -> Iterator[Sensitivity]:
    """Yield what one parameter, not "rotating", changes in one order, but for masters and link rods."""
    if n not in by_order and name not in LENGTHS:
        return
    # An order that no cylinder has may still have derivatives by lengths: an offset brings the odd ones.
    rows, masters = by_order.get(n) or [_absent(s, n) for s in by_order[1]], attached_cylinders(engine)
    for cylinder, contribution in zip(engine.cylinders, rows, strict=True):
        if name in MOVING and (cylinder.link or cylinder.number in masters):
            continue
        one = _one(engine, cylinder, contribution, name, lengths)
        if one.factor:
            yield one


def _absent(contribution: Contribution, n: int) -> Contribution:
    """Return the contribution to an order that a cylinder does not have."""
    return Contribution(
        contribution.number,
        n,
        contribution.axis,
        n * contribution.lead,
        contribution.arm,
        contribution.size,
        Complex(0),
    )


def _rotating(
    engine: Engine, n: int, first: Sequence[Contribution], pins: Sequence[Mapping[int, Complex]]
) -> Iterator[Sensitivity]:
    """Yield what a rotating mass adds: on the crank pin to order 1 forward, on a link pin to all.

    `first` are the cylinders' contributions to order 1, `pins` what their link pins add
    (`link_pin_force`).
    """
    for cylinder, contribution, radius, pin_terms in zip(
        engine.cylinders, first, engine.radii, pins, strict=True
    ):
        factor = Real(radius)
        if pin_terms:
            forward, backward = (DecimalPhasor(z) for z in rotating_pair(cylinder, pin_terms, n))
            yield Sensitivity(
                "rotating", contribution.number, n, (forward, backward), factor, contribution.arm
            )
        elif n == 1:
            pin = Phasor.root(cylinder.throw.turns)
            yield Sensitivity("rotating", contribution.number, 1, (pin, ZERO), factor, contribution.arm)


def _one(
    engine: Engine,
    cylinder: Cylinder,
    contribution: Contribution,
    name: str,
    lengths: dict[int, dict[int, LengthDerivatives]],
) -> Sensitivity:
    n, value, size = contribution.order, contribution.value, contribution.size
    if name in LENGTHS:
        value, size = getattr(lengths[contribution.number][n], name), _over_radius(engine, cylinder, size)
    if name == "mass":
        size = _over_mass(engine, cylinder, size)
    forward, backward = _geometry(contribution, name)
    if value.imag and value.real:  # a link rod: nothing exact to hold
        pair = (_decimal(forward, value), _decimal(backward, value.conjugate()))
        return Sensitivity(name, contribution.number, n, pair, Real(size), contribution.arm)
    quarter = QUARTER if value.imag else Fraction(0)
    factor = (value.imag if value.imag else value.real) * size
    pair = (forward.rotated(quarter), backward.rotated(-quarter))
    return Sensitivity(name, contribution.number, n, pair, factor, contribution.arm)


def _decimal(exact: Phasor, value: Complex) -> DecimalPhasor:
    return DecimalPhasor(value * exact.evaluated())


def _over_mass(engine: Engine, cylinder: Cylinder, size: Fraction) -> Fraction:
    """Return r_j/r_1: the contribution's size with its mass taken for that of cylinder 1."""
    mass, first = cylinder.reciprocating_mass, engine.first.reciprocating_mass
    return size * first / mass if mass and first else size


def _over_radius(engine: Engine, cylinder: Cylinder, size: Fraction) -> Fraction:
    """Return m_j/m_1: the contribution's size with its radius taken for that of cylinder 1."""
    own, radius = cylinder.radius, engine.first.radius
    return size * radius / own if own and radius else size


def _geometry(contribution: Contribution, name: str) -> tuple[Phasor, Phasor]:
    """Return the derivative of e^(i (axis +- lead))/2 by an angle, or that itself."""
    forward = Phasor.root(contribution.axis + contribution.lead).scaled(HALF)
    backward = Phasor.root(contribution.axis - contribution.lead).scaled(HALF)
    n = contribution.order
    if name == "throw":
        return forward.rotated(QUARTER).scaled(n), backward.rotated(QUARTER).scaled(-n)
    if name == "bank":
        return forward.rotated(QUARTER).scaled(1 - n), backward.rotated(QUARTER).scaled(1 + n)
    return forward, backward
