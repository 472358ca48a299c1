"""The witness of a refuted relation at sizes that machines have: positive, the rod longer than the crank.

Any point at which two sides differ refutes; one with a mass of -1.42 convinces nobody who builds engines.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from itertools import product

from symbalance.notes.algebra.tree_values import NO_VALUE
from symbalance.notes.algebra.values import Point, Valuation
from symbalance.notes.checking.deciding.equality import Decision, differ, witness_at

SIDES = ("left", "right")
RODS, CRANKS = ("l", "L"), ("r", "R")
CLOSEST = 2
"""Crank radii in a rod, at least."""


def usual_witness(decision: Decision) -> Mapping[str, str]:
    """Return the witness of a decision, at usual sizes where both sides differ there too."""
    left, right = decision.left, decision.right
    if left is None or right is None or not set(SIDES) <= decision.witness.keys():
        return decision.witness
    try:
        point = {n: Fraction(text) for n, text in decision.witness.items() if n not in SIDES}
        usual = _usual(point, left.domain.ranges)
        if usual == point:
            return decision.witness
        valuation = Valuation(left.domain, usual)
        pair = [valuation.of(left), valuation.of(right)]
    except NO_VALUE:
        return decision.witness
    return witness_at(usual, pair) if differ(*pair) else decision.witness


def _usual(point: Mapping[str, Fraction], ranges: Mapping[str, object]) -> Point:
    """Return a point with positive values, and a rod that is longer than its crank."""
    usual = {name: value if name in ranges else abs(value) for name, value in point.items()}
    for rod, crank in product(RODS, CRANKS):
        is_open = rod in usual and crank in usual and rod not in ranges
        if is_open and usual[rod] < CLOSEST * usual[crank]:
            usual[rod] += CLOSEST * usual[crank]
    return usual
