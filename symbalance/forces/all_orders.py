"""Largest force and couple of an engine over a turn, all orders together, with proved bounds.

As many orders are summed as make what is left out nothing beside them (`force_sums.left_out_above`); the
largest size of their sum over a turn is enclosed by `turn_maximum`.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import cache

from symbalance.errors import SymbalanceError
from symbalance.exact.spectrum import Spectrum
from symbalance.forces.force_sums import left_out_above, planar_vectors
from symbalance.forces.free_forces import Balance
from symbalance.forces.turn_maximum import TurnMaximum, turn_maximum
from symbalance.kinematics.slider_crank import HIGHEST_ORDER
from symbalance.text.reals import Real

Vectors = Callable[[int], tuple[Spectrum, Spectrum]]
FIRST_ORDERS = 24
"""Orders that are summed at first: at a rod ratio of 3 what is above them is 1e-17 of the force."""
NOTHING = 1e-8
"""Of the largest value: what may be left out, far within the 1e-6 that value and bound may differ by."""
ABSENT = 1e-12
"""Of one piston's first order: where all orders that are summed vanish, what is left out is below it."""


def turn_maxima(balance: Balance) -> dict[str, TurnMaximum]:
    """Return the largest force and couple over a turn, N and N m: by component, and of the vector."""
    engine = balance.engine
    if engine.has_symbols:
        rule = "has angles with symbols, and no largest value"
        raise SymbalanceError(f"engine {engine.name!r}", rule, "give the angles in numbers")
    # Force and couple come together, and mostly with the same orders: summed once for both.
    vectors = cache(lambda orders: planar_vectors(engine, orders, balance.reference))
    maxima: dict[str, TurnMaximum] = {}
    for of in ("force", "couple"):
        point = balance.operating_point
        if of == "couple" and point is not None and point.pitch is None:
            continue  # no order of it is free, or the operating point would have been refused
        unit = float(balance.unit_value(of))
        for name, top in _maxima(balance, of, vectors).items():
            maxima[name] = TurnMaximum(top.value * unit, top.bound * unit, top.angle)
    return maxima


def _maxima(balance: Balance, of: str, vectors: Vectors) -> dict[str, TurnMaximum]:
    """Return the maxima of the force or the couple in m r omega^2 (a)."""
    # What turns is in the sum as a whole: only the pistons' harmonics are bounded above it.
    orders = max([FIRST_ORDERS, *(abs(mass.speed) for mass in balance.engine.rotating_masses)])
    while True:
        force, couple = vectors(orders)
        harmonics = _harmonics(balance, force if of == "force" else couple)
        left_out = _left_out(balance, of, orders)
        size = max(abs(z) for z in harmonics.values()) if harmonics else 0.0
        if left_out <= NOTHING * size or left_out <= ABSENT or orders >= HIGHEST_ORDER:
            break
        orders = min(2 * orders, HIGHEST_ORDER)
    vertical, lateral = {}, {}
    for n in {abs(n) for n in harmonics}:
        forward, backward = harmonics.get(n, 0j), harmonics.get(-n, 0j)
        for sign, ahead, back in ((n, forward, backward), (-n, backward, forward)):
            vertical[sign] = (ahead + back.conjugate()) / 2
            lateral[sign] = (ahead - back.conjugate()) / 2j
    return {
        f"{of}.vertical": turn_maximum(vertical, left_out),
        f"{of}.lateral": turn_maximum(lateral, left_out),
        of: turn_maximum(harmonics, left_out),
    }


def _harmonics(balance: Balance, spectrum: Spectrum) -> dict[int, complex]:
    """Return c_n of vertical + i lateral in m r omega^2 (a), for n of both signs."""
    engine = balance.engine
    if balance.kinematics is None:
        return {n: complex(c.evaluated()) for n, c in spectrum.terms.items()}
    present = spectrum.orders()
    if present and max(present) > 1 and engine.ratio is None:
        raise SymbalanceError("ratio", "is not known", "add rod to [crank_train], or say --ratio λ")
    values = (
        {1: Real(1)} if engine.ratio is None else balance.kinematics.values_of(present, engine.ratio, 20)
    )
    return {n: complex(c.evaluated()) * float(values[abs(n)]) for n, c in spectrum.terms.items()}


def _left_out(balance: Balance, of: str, orders: int) -> float:
    engine = balance.engine
    if engine.ratio is None and balance.kinematics is not None:
        # Without a ratio only the first order is known: no other is there, at any lambda.
        return 0.0
    weights = (
        [Fraction(1)] * len(engine.cylinders) if of == "force" else engine.lever_arms(balance.reference)
    )
    return float(left_out_above(engine, orders, [Real(w) for w in weights]))
