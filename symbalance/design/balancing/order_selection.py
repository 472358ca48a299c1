r"""Selection of the orders that get a balance shaft where there are too few shafts for all of them.

Orders do not disturb each other, and twice the mean square of a vector over a turn is the sum over orders
of v |C_v|^2 + l |C_l|^2 (vertical and lateral amplitudes, weighted). With a = c_n and b = c_-n that is
(v + l)(|a|^2 + |b|^2) + 2 (v - l) Re(a b), the vertical amplitude being |conj(a) + b|. A device at +n
chooses a freely, one at -n b; the best beside the other part unchanged is -(v - l)/(v + l) of its
conjugate, and leaves 4 v l/(v + l) of its square. Force and couple (over a length) each count so, times
A_n^2. Where the weights there may be cannot have every force and couple (one station, a bound on their
size), what they miss counts too. The choice is then a knapsack over orders with at most four
options each, solved exactly by going through the orders: nothing is greedy.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction

from symbalance.design.balancing.design_limits import Weighting
from symbalance.engine.rotating_masses import unit_of_share
from symbalance.exact.amplitude import Amplitude
from symbalance.exact.phasor import ZERO
from symbalance.forces.free_forces import Balance
from symbalance.text.reals import Complex, Real

Pair = tuple[Amplitude, Amplitude]
"""The force and the couple of one signed order."""
Residuals = Callable[[dict[int, Pair], Sequence[int]], dict[int, Pair]]
"""From the parts of one order and those served to what these leave, by speed: weights that are limited
cannot have every force and couple."""


def parts_of(result: Balance, orders: Sequence[int]) -> dict[int, Pair]:
    """Return force and couple of the signed orders that are there, of the orders in question.

    >>> from symbalance.engine.catalogue import load
    >>> from symbalance.forces.free_forces import balance
    >>> sorted(parts_of(balance(load("v2-90"), 2), [1, 2]))
    [-2, 1, 2]
    """
    signed = [s * n for n in sorted(orders) for s in (1, -1)]
    pairs = {n: (result.force.terms.get(n, ZERO), result.couple.terms.get(n, ZERO)) for n in signed}
    return {n: pair for n, pair in pairs.items() if not all(x.is_zero() for x in pair)}


def targets_of(parts: dict[int, Pair], speed: int, other_served: bool, tilt: Fraction) -> Pair:
    """Return the force and couple a device must have: against its part, or the best beside the other."""
    part, other = parts.get(speed, (ZERO, ZERO)), parts.get(-speed, (ZERO, ZERO))
    if other_served or not tilt:
        return -part[0], -part[1]
    best = [part.conjugate().scaled(-tilt) for part in other]
    return best[0] - part[0], best[1] - part[1]


def select_orders(
    result: Balance,
    allowed: Sequence[int],
    free: Sequence[int],
    shafts: int,
    weighting: Weighting,
    residuals: Residuals | None = None,
) -> list[int]:
    """Return the signed orders to serve, at most `shafts` beside those in `free`, that leave the least.

    `allowed` are those that may be served, `free` those that are served anyway (+1, by the crank);
    `residuals` gives what limited weights leave, where that is not as little as it could be.
    """
    orders = sorted({abs(n) for n in allowed})
    best: dict[int, tuple[Real, list[int]]] = {0: (Real(0), [])}
    for n in orders:
        options = _options(result, n, [s for s in (n, -n) if s in allowed], free, weighting, residuals)
        reachable: dict[int, tuple[Real, list[int]]] = {}
        for used, (cost, served) in best.items():
            for more, extra, which in options:
                total = used + more
                new = (cost + extra, served + which)
                if total <= shafts and (total not in reachable or new[0] < reachable[total][0]):
                    reachable[total] = new
        best = reachable
    return min(best.values(), key=lambda pair: pair[0])[1]


def _options(
    result: Balance,
    n: int,
    allowed: Sequence[int],
    free: Sequence[int],
    weighting: Weighting,
    residuals: Residuals | None,
) -> list[tuple[int, Real, list[int]]]:
    """Return (shafts taken, what is left, signed orders served) for each way to treat an order."""
    always = [s for s in allowed if s in free]
    rest = [s for s in allowed if s not in free]
    options = [always, *([*always, s] for s in rest), *([always + rest] if len(rest) > 1 else [])]
    return [
        (len(option) - len(always), order_residual(result, n, option, weighting, residuals), option)
        for option in options
    ]


def order_residual(
    result: Balance,
    n: int,
    served: Sequence[int],
    weighting: Weighting,
    residuals: Residuals | None = None,
) -> Real:
    """Return what an order leaves with those of its parts served as well as can be, (m r omega^2)^2."""
    pairs = parts_of(result, [n])
    total = Real(0)
    if residuals is not None and served:
        pairs, served = pairs | residuals(pairs, served), []
    unit = unit_of_share(result.layout, n) if result.kinematics else Real(1)
    for which, over in ((0, Fraction(1)), (1, weighting.length)):
        forward, backward = (pairs[s][which].evaluated() if s in pairs else Complex(0) for s in (n, -n))
        total += _mean_square(forward, backward, n in served, -n in served, weighting) / over**2
    return total * unit**2


def _mean_square(a: Complex, b: Complex, serves_a: bool, serves_b: bool, weighting: Weighting) -> Real:
    v, side = weighting.vertical, weighting.lateral
    if serves_a and serves_b:
        return Real(0)
    if serves_a or serves_b:
        return 4 * v * side / (v + side) * abs(b if serves_a else a) ** 2
    return (v + side) * (abs(a) ** 2 + abs(b) ** 2) + 2 * (v - side) * (a * b).real
