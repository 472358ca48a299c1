"""What an ideal engine pays for offsets, link rods and unlike cylinders that it does not have: nothing.

A balance of the in-line four is measured beside the same sums with every look at such things left out,
in turn in one run; its function beside that of a four whose cylinders say their equal sizes one by
one, which must be the very same source.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from time import perf_counter

import numpy as np

from symbalance.bench.timing import Measurement, progress
from symbalance.codegen import to_function
from symbalance.engine.builders import from_cylinders, inline
from symbalance.engine.catalogue import load
from symbalance.engine.cylinders import Cylinder
from symbalance.forces.force_sums import geometry
from symbalance.forces.free_forces import Balance, balance
from symbalance.kinematics.slider_crank import surviving

ORDER = 12
MOST = 1.25
"""How many times the stripped sums a balance may take; the rest of it checks what it is given."""
ANGLES = 100_000


def ideal_engine() -> list[Measurement]:
    """Measure balance and function of the in-line four beside their stripped equivalents."""
    progress("what an ideal engine pays for others")
    ours, bare = in_turn(whole, stripped)
    theirs, plain = in_turn(*functions())
    return [
        _as_fast(
            "balance of the in-line four to order 12, layout included", ours, "the sums alone", bare
        ),
        _as_fast("its force at 100 000 angles, sizes said one by one", theirs, "sizes shared", plain),
    ]


def whole() -> Balance:
    """Return the balance as users ask for it, of a fresh layout."""
    return balance(inline("1-3-4-2", ratio=Fraction(7, 2)), ORDER)


def stripped() -> Balance:
    """Return the same without a look at whether cylinders are alike."""
    layout = inline("1-3-4-2", ratio=Fraction(7, 2))
    orders = [n for n in range(1, ORDER + 1) if surviving(n)]
    arms = layout.arms()
    ones = [Fraction(1)] * len(arms)
    return Balance(layout, ORDER, geometry(layout, orders, ones), geometry(layout, orders, arms))


def functions() -> tuple[Callable[[], object], Callable[[], object]]:
    """Return two calls: of the function of a four with sizes of its cylinders' own, and of the plain one.

    Raises if their sources differ.
    """
    shared = load("inline-4")
    rows = [
        Cylinder(c.number, c.throw.in_degrees(), 0, c.station, c.fires, offset=0)
        for c in shared.cylinders
    ]
    own = from_cylinders(rows, name=shared.name, ratio=shared.ratio)
    of_own, of_shared = (
        to_function(balance(layout), outputs="force.vertical", tolerance=0) for layout in (own, shared)
    )
    if of_own.source != of_shared.source:
        raise AssertionError("equal sizes said one by one gave another function")
    theta = np.linspace(0, 4 * np.pi, ANGLES)
    return (lambda: of_own(theta)), (lambda: of_shared(theta))


def in_turn(
    left: Callable[[], object], right: Callable[[], object], rounds: int = 60, calls: int = 5
) -> tuple[float, float]:
    """Return the least time of each of two calls, made in turn so that both see the same machine."""
    least = [float("inf")] * 2
    for _ in range(rounds):
        for side, call in enumerate((left, right)):
            start = perf_counter()
            for _ in range(calls):
                call()
            least[side] = min(least[side], (perf_counter() - start) / calls)
    return least[0], least[1]


def _as_fast(what: str, seconds: float, against: str, other: float) -> Measurement:
    met = seconds <= MOST * other
    return Measurement(what, seconds, against, other, f"no more than {MOST:g} times that", met)
