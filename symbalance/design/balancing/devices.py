"""Counterweights and balance shafts of a design: for each order served, weights that balance it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from math import floor
from typing import Any

from symbalance.design.balancing.bounded_weights import bounded_vectors, joint_vectors
from symbalance.design.balancing.design_limits import Limits
from symbalance.design.balancing.order_selection import (
    Pair,
    Residuals,
    parts_of,
    select_orders,
    targets_of,
)
from symbalance.design.balancing.planes import PlacedVector, in_planes
from symbalance.engine.balance_masses import BalanceShaft, Counterweight, Weight, directed
from symbalance.engine.engine import Engine
from symbalance.engine.rotating_masses import has_unit_share, unit_of_share
from symbalance.errors import SymbalanceError
from symbalance.exact.amplitude import Amplitude
from symbalance.exact.arithmetic import station_of, total
from symbalance.exact.decimal_phasor import DecimalPhasor
from symbalance.exact.phasor import ZERO, Phasor
from symbalance.forces.free_forces import Balance


@dataclass(frozen=True)
class Device:
    """Balance weights turning at `speed` times the crank's speed: counterweights, or a balance shaft's.

    `force` and `couple` (about the mean of the stations) are what its weights have, in the unit of the
    order; `weights` its (station, share) pairs, empty for counterweights that stand on throws.
    """

    speed: int
    on_crank: bool
    force: Amplitude
    couple: Amplitude
    weights: tuple[PlacedVector, ...]
    parts: tuple[Counterweight | BalanceShaft, ...] = field(compare=False)


def devices_for(before: Balance, orders: Sequence[int], limits: Limits) -> list[Device]:
    """Return what serves the orders to remove, slowest first, the crank before shafts."""
    parts = parts_of(before, orders)
    served = _orders_to_serve(before, parts, limits)
    devices = []
    for n in sorted({abs(s) for s in served}):
        vectors = _weights_by_speed(before, parts, [s for s in (n, -n) if s in served], limits)
        devices += [_device(before, speed, weights, limits) for speed, weights in vectors.items()]
    return [device for device in devices if device.parts]


def _orders_to_serve(before: Balance, parts: dict[int, Pair], limits: Limits) -> list[int]:
    """Return the signed orders that get a device."""
    free = [1] if limits.counterweights else []
    candidates = set(parts)
    if limits.weighting.tilt:  # a part that is zero may then make up for the other
        candidates |= {-n for n in parts}
    able = sorted(n for n in candidates if n > 0 or limits.counter_rotation)
    crank, others = [n for n in able if n in free], [n for n in able if n not in free]
    if limits.shafts is None or len(others) <= limits.shafts:
        return able
    if limits.shafts == 0:
        return crank
    return select_orders(before, able, free, limits.shafts, limits.weighting, _residuals(before, limits))


def _residuals(before: Balance, limits: Limits) -> Residuals | None:
    """Return what computes what limited weights leave, None where they can have any force and couple."""
    places = limits.stations and set(limits.stations)
    if limits.most is None and (not places or len(places) > 1):
        return None

    def residuals(parts: dict[int, Pair], served: Sequence[int]) -> dict[int, Pair]:
        vectors = _weights_by_speed(before, parts, served, limits)
        return {
            s: _sum(parts.get(s, (ZERO, ZERO)), _resultant(before.engine, w)) for s, w in vectors.items()
        }

    return residuals


def _resultant(engine: Engine, weights: Sequence[PlacedVector]) -> Pair:
    """Return the force and the couple about the mean of the stations that weights have."""
    plane = engine.mean_station
    return total(w for _, w in weights), total(w.scaled(z - plane) for z, w in weights)


def _sum(one: Pair, other: Pair) -> Pair:
    return one[0] + other[0], one[1] + other[1]


def _weights_by_speed(
    before: Balance, parts: dict[int, Pair], served: Sequence[int], limits: Limits
) -> dict[int, list[PlacedVector]]:
    """Return, by speed, the weights that serve one order: stations and vectors in its unit."""
    engine, tilt = before.engine, limits.weighting.tilt
    targets = {s: targets_of(parts, s, -s in served, tilt) for s in served}
    weights = {s: _weights(engine, s, target, limits) for s, target in targets.items()}
    if limits.most is None or not tilt or len(served) < 2:
        return weights
    if all(_is_exact(engine, weights[s], targets[s]) for s in served):
        return weights
    plane = engine.mean_station
    arms = sorted({z for target in targets.values() for z in _arms(engine, target, limits.stations)})
    bound = _bound(engine, served[0], limits.most)
    both = joint_vectors([targets[s] for s in served], arms[::-1], bound, limits.weighting.length, tilt)
    return {s: [(z + plane, w) for z, w in side] for s, side in zip(served, both, strict=True)}


def _is_exact(engine: Engine, weights: Sequence[PlacedVector], target: Pair) -> bool:
    resultant = _resultant(engine, weights)
    return all((t - r).is_zero() for t, r in zip(target, resultant, strict=True))


def _device(before: Balance, speed: int, weights: Sequence[PlacedVector], limits: Limits) -> Device:
    on_crank = speed == 1 and limits.counterweights
    if on_crank and limits.per_throw:
        return _on_throws(before.engine)
    shares = [(station, _share(before.engine, speed, vector)) for station, vector in weights]
    if not shares:  # from the stations there are, nothing is better than something
        parts: Any = ()
    elif on_crank:
        parts = tuple(Counterweight(0, station, share=vector) for station, vector in shares)
    else:
        parts = (BalanceShaft(speed, [Weight(station, share=vector) for station, vector in shares]),)
    return Device(speed, on_crank, *_resultant(before.engine, weights), tuple(shares), parts)


def _on_throws(engine: Engine) -> Device:
    """Return counterweights for half of the reciprocating mass on every throw."""
    half = tuple(Counterweight(throw=c.number, overbalance="1/2") for c in engine.cylinders)
    rows = zip(engine.cylinders, engine.sizes, strict=True)
    pulls = [(c.station, directed(Phasor.of(1, {0: -size / 2}), c.throw)) for c, size in rows]
    return Device(1, True, *_resultant(engine, pulls), (), half)


def _weights(engine: Engine, speed: int, targets: Pair, limits: Limits) -> list[PlacedVector]:
    """Return stations and vectors, in the unit of the order, with a force and couple."""
    plane, length = engine.mean_station, limits.weighting.length
    arms = _arms(engine, targets, limits.stations)
    vectors = in_planes(*targets, arms, spread=limits.spread, length=length)
    if limits.most is not None:
        bound = _bound(engine, speed, limits.most)
        if any(vector.size() > bound for _, vector in vectors):
            vectors = bounded_vectors(*targets, sorted(set(arms), reverse=True), bound, length)
    return [(arm + plane, vector) for arm, vector in vectors if not vector.is_zero()]


def _arms(engine: Engine, targets: Pair, stations: tuple[Fraction, ...] | None) -> list[Fraction]:
    """Return the arms weights may have: the ends of the engine, and the one place that does alone."""
    if stations is not None:
        plane = engine.mean_station
        return [station - plane for station in stations]
    places = engine.lever_arms()
    half = Fraction(1, 2)
    front, rear = max(places), min(places)
    single_arm = station_of(*targets)
    ends = [front, rear] if front != rear else [half, -half]
    if single_arm is None or not rear - half <= single_arm <= front + half:
        return ends
    return [*ends, single_arm]


def _share(engine: Engine, speed: int, vector: Amplitude) -> Amplitude:
    """Return a vector in its order's unit as a share: itself, but where orders are not geometric."""
    if has_unit_share(engine, speed):
        return vector
    return DecimalPhasor(vector.evaluated() / unit_of_share(engine, speed))


def _bound(engine: Engine, speed: int, most: Fraction) -> Fraction:
    """Return the largest vector a weight of so many kg mm may have, rounded to 12 digits."""
    unit = engine.unit_unbalance
    if unit is None:
        rule, remedy = "is in kg mm", "give stroke and reciprocating_mass in [crank_train]"
        raise SymbalanceError(f"most = {most}", rule, remedy)
    if abs(speed) == 1 or not engine.counts_in_orders:
        return most * speed * speed / unit
    per_share = unit_of_share(engine, speed)
    share = most * speed * speed / unit
    return Fraction(floor(abs(share * 10**12 / per_share)), 10**12)


def rotating_counterweights(engine: Engine, devices: Sequence[Device]) -> list[Counterweight]:
    """Return what balances rotating masses throw by throw: they count once there are counterweights."""
    has_new_counterweights = any(d.on_crank for d in devices) and not engine.balancers.counterweights
    if not has_new_counterweights or any(
        p.overbalance is not None for d in devices for p in _on_crank(d)
    ):
        return []
    pairs = zip(engine.cylinders, engine.rotating_sizes, strict=True)
    return [Counterweight(throw=c.number, overbalance=0) for c, share in pairs if share]


def _on_crank(device: Device) -> list[Counterweight]:
    return [p for p in device.parts if isinstance(p, Counterweight)]
