r"""Torques of cylinders that are not alike: each kind's harmonics times the exact star of its cylinders.

Cylinder j has C_n cos n p_j + S_n sin n p_j, p_j = theta + delta_j, with z_n = C_n + i S_n of its kind:
the engine has z_n sum of e^(-i n delta_j), the sum over like cylinders decided exactly, so that an order
that cancels among them is gone. What is left of several kinds is a number of 40 digits.

Link rods turn the crank through their master rod. By virtual work that changes nothing: the torque is
the power of what moves, over omega. Counted are the masses that go along the cylinders
(`reciprocating_mass`) and the couples of J_x. A mass at a link pin moves with the master rod, neither
steadily round nor along an axis: it is not counted.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction

from mpmath import mp

from symbalance.engine.cylinders import Cylinder
from symbalance.engine.layout import Layout
from symbalance.engine.unlike import mechanism_of, sizes
from symbalance.errors import SymbalanceError
from symbalance.exact.decimal_phasor import DIGITS, DecimalPhasor
from symbalance.exact.radicals import evaluated
from symbalance.exact.spectrum import Component
from symbalance.kinematics.mechanisms import Mechanism
from symbalance.text.numbers import Real, real
from symbalance.torque.stars import summed


@dataclass(frozen=True)
class Kind:
    """Like cylinders: their mechanism, m r^2 and r over those of the first, J_x in kg mm^2 (0: none)."""

    mechanism: Mechanism
    size: Fraction
    radius: Fraction
    excess: Fraction
    cylinders: tuple[Cylinder, ...]


Harmonics = Callable[[Mechanism, int, int], Mapping[int, Real]]


def torque_kinds(layout: Layout) -> list[Kind]:
    """Return the cylinders by kind, in the order of the first of each.

    >>> from symbalance.engine.catalogue import load
    >>> [(k.size, k.excess, len(k.cylinders)) for k in torque_kinds(load("inline-4"))]
    [(Fraction(1, 1), Fraction(0, 1), 4)]
    """
    if layout.has_symbols:
        rule = "has angles with symbols, and cylinders or rods that need numbers"
        raise SymbalanceError(f"engine {layout.name!r}", rule, "give the angles in numbers")
    found: dict[tuple[Mechanism, Fraction, Fraction, Fraction], list[Cylinder]] = {}
    for cylinder, size in zip(layout.cylinders, sizes(layout), strict=True):
        radius = _radius(layout, cylinder)
        rod = layout.train_of(cylinder).rod_split
        key = (mechanism_of(layout, cylinder), size * radius, radius, rod.excess if rod else Fraction(0))
        found.setdefault(key, []).append(cylinder)
    return [Kind(*key, tuple(cylinders)) for key, cylinders in found.items()]


def _radius(layout: Layout, cylinder: Cylinder) -> Fraction:
    own, first = layout.stroke_of(cylinder), layout.stroke_of(layout.first)
    return Fraction(1) if own is None or first is None else own / first


def joined(
    kinds: list[Kind], harmonics: Harmonics, size: Callable[[Kind], Fraction], order: int
) -> dict[int, Component]:
    """Return the orders of all kinds together that do not vanish, to 40 digits: n -> C + iS."""
    total: dict[int, DecimalPhasor] = {}
    for kind in kinds:
        weight = size(kind)
        if not weight:
            continue
        for n, number in harmonics(kind.mechanism, order, DIGITS).items():
            star = star_number(kind.cylinders, n)
            if number and star:
                with mp.workdps(DIGITS):
                    part = DecimalPhasor(number * star * real(weight))
                total[n] = total[n] + part if n in total else part
    return {n: Component(total[n]) for n in sorted(total) if not total[n].is_zero()}


def star_number(cylinders: tuple[Cylinder, ...], n: int) -> Real:
    """Return the sum of e^(-i n delta_j), an exact 0 where it vanishes."""
    star = summed([c.delay.scaled(-n) for c in cylinders])
    if star.is_zero():
        return mp.mpf(0)
    assert not hasattr(star, "parts")
    with mp.workdps(DIGITS + 5):
        return mp.mpc(evaluated(star.real(), DIGITS), evaluated(star.imaginary(), DIGITS))  # type: ignore[union-attr]
