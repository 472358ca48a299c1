r"""Torques of groups of like cylinders: each group's harmonics times the exact star of its cylinders.

Cylinder j has C_n cos n p_j + S_n sin n p_j, p_j = theta + delta_j, with z_n = C_n + i S_n of its group:
the engine has z_n sum of e^(-i n delta_j), the sum over like cylinders decided exactly, so that an order
that cancels among them is gone. What is left of several groups is a number of 40 digits.

Link rods turn the crank through their master rod. By virtual work that changes nothing: the torque is
the power of what moves, over omega. Counted are the masses that go along the cylinders
(`reciprocating_mass`), those on link pins (`rotating_mass` of link rods) and the couples of J_x.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction

from symbalance.engine.cylinders import Cylinder
from symbalance.engine.engine import Engine
from symbalance.errors import SymbalanceError
from symbalance.exact.decimal_phasor import DecimalPhasor
from symbalance.exact.spectrum import Component
from symbalance.kinematics.mechanisms import LinkRod, Mechanism
from symbalance.kinematics.mechanisms.moving_masses import has_link_pin
from symbalance.text.reals import Complex
from symbalance.torque.stars import summed

Part = tuple[tuple[Cylinder, ...], Mapping[int, Complex], Fraction]
"""Like cylinders, n -> C + iS of one of them, and what that is multiplied with."""


@dataclass(frozen=True)
class TorqueGroup:
    """Like cylinders: their mechanism, m r^2 and r over those of the first, J_x in kg mm^2 (0: none)."""

    mechanism: Mechanism
    size: Fraction
    radius: Fraction
    excess: Fraction
    cylinders: tuple[Cylinder, ...]


def torque_groups(layout: Engine) -> list[TorqueGroup]:
    """Return the cylinders in groups that have one inertia torque, in the order of the first of each.

    >>> from symbalance.engine.catalogue import load
    >>> [(g.size, g.excess, len(g.cylinders)) for g in torque_groups(load("inline-4"))]
    [(Fraction(1, 1), Fraction(0, 1), 4)]
    """
    _check_numbers(layout)
    size, radius = _by_number(layout, layout.sizes), _by_number(layout, layout.radii)
    groups = layout.grouped(
        lambda c: (c.mechanism, size[c.number] * radius[c.number], radius[c.number], c.excess)
    )
    return [
        TorqueGroup(cylinders[0].known_mechanism, of_mass, of_radius, excess, cylinders)
        for (_, of_mass, of_radius, excess), cylinders in groups.items()
    ]


def has_common_torque(layout: Engine) -> bool:
    """Tell whether all pistons have one t_n m r^2 omega^2, of a centred rod: one group, J_x apart.

    Then an order is its t_n times a sum over angles, which is exact whatever lambda is.
    """
    return layout.has_common_harmonics and {*layout.sizes} == {*layout.radii} == {1}


def link_pin_masses(layout: Engine) -> list[tuple[LinkRod, Fraction, tuple[Cylinder, ...]]]:
    """Return the masses on link pins by group: mechanism, m r^2 over that of cylinder 1, cylinders."""
    if not any(c.rotating_mass and has_link_pin(c.mechanism) for c in layout.cylinders):
        return []
    _check_numbers(layout)
    mass, radius = _by_number(layout, layout.rotating_sizes), _by_number(layout, layout.radii)
    groups = layout.grouped(lambda c: (c.mechanism, mass[c.number] * radius[c.number]))
    return [
        (mechanism, size, cylinders)
        for (mechanism, size), cylinders in groups.items()
        if size and isinstance(mechanism, LinkRod) and has_link_pin(mechanism)
    ]


def _by_number(layout: Engine, values: Iterable[Fraction]) -> dict[int, Fraction]:
    return {c.number: value for c, value in zip(layout.cylinders, values, strict=True)}


def _check_numbers(layout: Engine) -> None:
    if layout.has_symbols:
        rule = "has angles with symbols, and cylinders or rods that need numbers"
        raise SymbalanceError(f"engine {layout.name!r}", rule, "give the angles in numbers")


def summed_groups(parts: Iterable[Part]) -> dict[int, Component]:
    """Return the orders of all groups together that do not vanish, to 40 digits: n -> C + iS."""
    total: dict[int, DecimalPhasor] = {}
    for cylinders, harmonics, weight in parts:
        for n, number in harmonics.items() if weight else ():
            star = star_number(cylinders, n)
            if number and star:
                part = DecimalPhasor(number * star * weight)
                total[n] = total[n] + part if n in total else part
    return {n: Component(total[n]) for n in sorted(total) if not total[n].is_zero()}


def star_number(cylinders: tuple[Cylinder, ...], n: int) -> Complex:
    """Return the sum of e^(-i n delta_j), an exact 0 where it vanishes."""
    star = summed([c.delay.scaled(-n) for c in cylinders])
    return Complex(0) if star.is_zero() else star.evaluated()
