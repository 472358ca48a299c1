"""Benchmark: support for offsets, link rods and unlike cylinders costs an engine without them nothing.

A balance of the in-line four is measured beside the same sums without a look at such things, in turn in
one run; its function beside that of a four whose cylinders state their equal sizes one by one, which must
be the very same source.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

import numpy as np

from symbalance.bench.timing import Measurement, at_most, in_turn, progress
from symbalance.codegen import to_function
from symbalance.engine.builders import from_cylinders, inline
from symbalance.engine.catalogue import load
from symbalance.engine.cylinders import Cylinder
from symbalance.forces.force_sums import geometry
from symbalance.forces.free_forces import Balance, balance
from symbalance.kinematics.slider_crank import surviving

ORDER = 12
MOST = 1.25
"""How many times the stripped sums a balance may take; the rest of it checks its arguments."""
ANGLES = 100_000
ROUNDS, CALLS = 60, 5


def ideal_engine() -> list[Measurement]:
    """Measure balance and function of the in-line four beside their stripped equivalents."""
    progress("what an ideal engine pays for others")
    one_by_one, shared = functions()
    pairs = (
        ("balance of the in-line four to order 12, engine included", whole, "the sums alone", stripped),
        ("its force at 100 000 angles, sizes one by one", one_by_one, "sizes shared", shared),
    )
    rows = []
    for name, function, alternative, simple in pairs:
        times = in_turn({"": function, alternative: simple}, ROUNDS, float("inf"), CALLS)
        rows.append(at_most(MOST, name, times[""].best, alternative, times[alternative].best))
    return rows


def whole() -> Balance:
    """Return the balance as users ask for it, of a fresh engine."""
    return balance(inline("1-3-4-2", ratio=Fraction(7, 2)), ORDER)


def stripped() -> Balance:
    """Return the same without a look at whether cylinders are alike."""
    engine = inline("1-3-4-2", ratio=Fraction(7, 2))
    orders = [n for n in range(1, ORDER + 1) if surviving(n)]
    arms = engine.lever_arms()
    ones = [Fraction(1)] * len(arms)
    return Balance(engine, ORDER, geometry(engine, orders, ones), geometry(engine, orders, arms))


def functions() -> tuple[Callable[[], object], Callable[[], object]]:
    """Return two calls: of the function of a four whose cylinders each state their sizes, and of a four
    whose cylinders share them.

    AssertionError where their sources differ.
    """
    shared = load("inline-4")
    rows = [
        Cylinder(c.number, c.throw.in_degrees(), 0, c.station, c.fires, offset=0)
        for c in shared.cylinders
    ]
    one_by_one = from_cylinders(rows, name=shared.name, ratio=shared.ratio)
    function, alternative = (
        to_function(balance(engine), outputs="force.vertical", tolerance=0)
        for engine in (one_by_one, shared)
    )
    if function.source != alternative.source:
        raise AssertionError("equal sizes stated one by one gave another function")
    theta = np.linspace(0, 4 * np.pi, ANGLES)
    return (lambda: function(theta)), (lambda: alternative(theta))
