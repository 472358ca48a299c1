"""Torque of groups of like cylinders: one body's harmonics times the group's star diagram.

Cylinder j has C_n cos n p_j + S_n sin n p_j, p_j = theta + delta_j, with z_n = C_n + i S_n of its group:
the engine has z_n sum of e^(-i n delta_j), the sum over like cylinders decided exactly, so that an order
that cancels among them is gone. What is left of several groups is a number of 40 digits.

Link rods turn the crank through their master rod. By virtual work that changes nothing: the torque is
the power of what moves, over omega. Counted are the masses that go along the cylinders
(`reciprocating_mass`), those on link pins (`rotating_mass` of link rods) and the couples of J_x.

Formulas:
    C cos n (theta + d) + S sin n (theta + d) = P cos n theta + Q sin n theta
    (C + i S) e^(-i n d) = P + i Q
    with P = C cos n d + S sin n d; Q = S cos n d - C sin n d; C, S numbers; n a whole number; d an angle
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from symbalance.engine.cylinders import Cylinder
from symbalance.engine.engine import Engine
from symbalance.errors import SymbalanceError
from symbalance.exact.decimal_phasor import DecimalPhasor
from symbalance.exact.spectrum import Component
from symbalance.kinematics.bodies import EXCESS, RECIPROCATING, ROTATING, Body, bodies
from symbalance.text.reals import Complex
from symbalance.torque.star_diagrams import unit_vector_sum

MASSES = (RECIPROCATING, ROTATING)


@dataclass(frozen=True)
class TorqueGroup:
    """One body of like cylinders, and its m r^2 over that of cylinder 1, or its J_x in kg mm^2."""

    body: Body
    size: Fraction
    cylinders: tuple[Cylinder, ...]


def torque_groups(engine: Engine, measures: Sequence[str] = MASSES) -> list[TorqueGroup]:
    """Return what moves with the cylinders, in groups that have one torque each.

    >>> from symbalance.engine.catalogue import load
    >>> [(g.body.measure, g.size, len(g.cylinders)) for g in torque_groups(load("inline-4"))]
    [('reciprocating mass', Fraction(1, 1), 4)]
    """
    if engine.has_symbols:
        rule = "has angles with symbols, and cylinders or rods that need numbers"
        raise SymbalanceError(f"engine {engine.name!r}", rule, "give the angles in numbers")
    groups = []
    for measure in measures:
        size = dict(zip(engine.cylinders, _sizes(engine, measure), strict=True))
        for (_, weight), like in engine.grouped(lambda c, of=size: (c.mechanism, of[c])).items():
            moving = bodies(like[0].known_mechanism) if weight else ()
            groups += [TorqueGroup(body, weight, like) for body in moving if body.measure == measure]
    return groups


def _sizes(engine: Engine, measure: str) -> list[Fraction]:
    if measure == EXCESS:
        return [c.excess for c in engine.cylinders]
    if measure == ROTATING and not engine.has_link_pin_masses:
        return [Fraction(0)] * len(engine.cylinders)  # what it counts in need not be given
    masses = engine.sizes if measure == RECIPROCATING else engine.rotating_sizes
    return [mass * radius for mass, radius in zip(masses, engine.radii, strict=True)]


def has_common_torque(engine: Engine) -> bool:
    """Tell whether all pistons have one t_n m r^2 omega^2, of a centred rod: one group, J_x apart.

    Then an order is its t_n times a sum over angles, which is exact whatever lambda is.
    """
    return engine.has_common_harmonics and {*engine.sizes} == {*engine.radii} == {1}


def total_torque(groups: Sequence[TorqueGroup], order: int) -> dict[int, Component]:
    """Return the orders of the groups' torque on the crank that do not vanish: n -> C + iS."""
    return _total([(group, group.body.torque(order)) for group in groups])


def total_moment(groups: Sequence[TorqueGroup], order: int) -> dict[int, Component]:
    """Return the same of what the frame gets besides the torque's opposite."""
    return _total([(group, group.body.moment(order)) for group in groups])


def _total(parts: Sequence[tuple[TorqueGroup, Mapping[int, Complex]]]) -> dict[int, Component]:
    """Return the sum of the groups' harmonics times their stars, to 40 digits."""
    total: dict[int, DecimalPhasor] = {}
    for group, harmonics in parts:
        for n, number in harmonics.items():
            star = star_number(group.cylinders, n)
            if number and star:
                part = DecimalPhasor(number * star * group.size)
                total[n] = total[n] + part if n in total else part
    return {n: Component(total[n]) for n in sorted(total) if not total[n].is_zero()}


def star_number(cylinders: tuple[Cylinder, ...], n: int) -> Complex:
    """Return the sum of e^(-i n delta_j), an exact 0 where it vanishes."""
    star = unit_vector_sum([c.delay.scaled(-n) for c in cylinders])
    return Complex(0) if star.is_zero() else star.evaluated()
