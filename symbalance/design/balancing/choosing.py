r"""Which signed orders get a shaft where there are not shafts for all of them.

Orders do not disturb each other, and twice the mean square of a vector over a turn is the sum over orders
of v |C_v|^2 + l |C_l|^2 (vertical and lateral amplitudes, weighted). With a = c_n and b = c_-n that is
(v + l)(|a|^2 + |b|^2) + 2 (v - l) Re(a b), the vertical amplitude being |conj(a) + b|. A device at +n
chooses a freely, one at -n b; the best beside the other part left as it is, is -(v - l)/(v + l) of its
conjugate, and leaves 4 v l/(v + l) of its square. Force and couple (over a length) each count so, times
A_n^2. Where the weights there may be cannot have every force and couple (one station, a bound on their
size), what they miss counts too. The choice is then a knapsack over orders with at most four
options each, solved exactly by going through the orders: nothing is greedy.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction

from symbalance.design.balancing.limits import Weighting
from symbalance.engine.rotating_masses import unit_of_share
from symbalance.exact.amplitude import Amplitude
from symbalance.exact.phasor import ZERO
from symbalance.forces.free_forces import Balance
from symbalance.text.reals import Complex, Real

Pair = tuple[Amplitude, Amplitude]
"""The force and the couple of one signed order."""
Left = Callable[[dict[int, Pair], Sequence[int]], dict[int, Pair]]
"""What the parts served of one order's leave, by speed, where weights cannot have what they should."""


def parts_of(found: Balance, orders: Sequence[int]) -> dict[int, Pair]:
    """Return force and couple of the signed orders that are there, of the orders asked for.

    >>> from symbalance.engine.catalogue import load
    >>> from symbalance.forces.free_forces import balance
    >>> sorted(parts_of(balance(load("v2-90"), 2), [1, 2]))
    [-2, 1, 2]
    """
    signed = [s * n for n in sorted(orders) for s in (1, -1)]
    pairs = {n: (found.force.terms.get(n, ZERO), found.couple.terms.get(n, ZERO)) for n in signed}
    return {n: pair for n, pair in pairs.items() if not all(x.is_zero() for x in pair)}


def targets_of(parts: dict[int, Pair], speed: int, other_served: bool, tilt: Fraction) -> Pair:
    """Return the force and couple a device must have: to end its part, or the best beside the other."""
    own, other = parts.get(speed, (ZERO, ZERO)), parts.get(-speed, (ZERO, ZERO))
    if other_served or not tilt:
        return -own[0], -own[1]
    wanted = [part.conjugate().scaled(-tilt) for part in other]
    return wanted[0] - own[0], wanted[1] - own[1]


def chosen(
    found: Balance,
    able: Sequence[int],
    free: Sequence[int],
    shafts: int,
    weighting: Weighting,
    left: Left | None = None,
) -> list[int]:
    """Return the signed orders to serve, at most `shafts` beside those in `free`, that leave the least.

    `able` are those that may be served, `free` those that are served anyway (+1, by the crank); `left`
    tells what the weights there may be leave, where that is not as little as wished for.
    """
    orders = sorted({abs(n) for n in able})
    best: dict[int, tuple[Real, list[int]]] = {0: (Real(0), [])}
    for n in orders:
        options = _options(found, n, [s for s in (n, -n) if s in able], free, weighting, left)
        reached: dict[int, tuple[Real, list[int]]] = {}
        for used, (cost, served) in best.items():
            for more, extra, which in options:
                total = used + more
                new = (cost + extra, served + which)
                if total <= shafts and (total not in reached or new[0] < reached[total][0]):
                    reached[total] = new
        best = reached
    return min(best.values(), key=lambda pair: pair[0])[1]


def _options(
    found: Balance,
    n: int,
    able: Sequence[int],
    free: Sequence[int],
    weighting: Weighting,
    left: Left | None,
) -> list[tuple[int, Real, list[int]]]:
    """Return (shafts taken, what is left, signed orders served) for each way to treat an order."""
    always = [s for s in able if s in free]
    rest = [s for s in able if s not in free]
    ways = [always, *([*always, s] for s in rest), *([always + rest] if len(rest) > 1 else [])]
    return [(len(way) - len(always), left_at(found, n, way, weighting, left), way) for way in ways]


def left_at(
    found: Balance,
    n: int,
    served: Sequence[int],
    weighting: Weighting,
    left: Left | None = None,
) -> Real:
    """Return what an order leaves with those of its parts served as well as can be, (m r omega^2)^2."""
    pairs = parts_of(found, [n])
    total = Real(0)
    if left is not None and served:
        pairs, served = pairs | left(pairs, served), []
    unit = unit_of_share(found.layout, n) if found.kinematics else Real(1)
    for which, over in ((0, Fraction(1)), (1, weighting.length)):
        ahead, against = (pairs[s][which].evaluated() if s in pairs else Complex(0) for s in (n, -n))
        total += _mean_square(ahead, against, n in served, -n in served, weighting) / over**2
    return total * unit**2


def _mean_square(a: Complex, b: Complex, ahead: bool, against: bool, weighting: Weighting) -> Real:
    v, side = weighting.vertical, weighting.lateral
    if ahead and against:
        return Real(0)
    if ahead or against:
        return 4 * v * side / (v + side) * abs(b if ahead else a) ** 2
    return (v + side) * (abs(a) ** 2 + abs(b) ** 2) + 2 * (v - side) * (a * b).real
