"""Periodic orbits of journals under given loads, with stiffness and damping of their films along them.

A film has no mass: at every angle F(r, r') = load. The equation is discretised over the cycle by Radau
IIA with two stages (order 3, L-stable) and solved by Newton's method on the whole closed orbit
(`periodic_newton`), or, should that fail, by going round until it closes. Stiffness and damping along the
orbit are then the film's own tangents: what a small departure from this orbit meets, not springs about
the centre.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from symbalance.crankshaft.arguments import check_kind
from symbalance.crankshaft.arrays import Array
from symbalance.crankshaft.bearings.periodic_newton import periodic_places
from symbalance.crankshaft.bearings.short_film import MAKE, Bearing, FilmState, equilibrium, film_states
from symbalance.crankshaft.integrators.tableau import radau_iia
from symbalance.crankshaft.system import UnsolvedError
from symbalance.errors import SymbalanceError, brief
from symbalance.text.numbers import as_list

MOST_CYCLES, MOST_NEWTON = 40, 60
CLOSES, NEWTON = 1e-7, 1e-11
"""When an orbit closes, and when a Newton step is small enough, over the clearance."""
CARRIED = 1e-6
"""How far the films' forces along an orbit may be from the loads, of the largest."""
FARTHEST = 0.9995
"""The eccentricity at which Newton's steps are cut short: the film's force has no bound towards 1."""
COARSE = 120
"""About how many steps the cycle has from which the whole orbit's Newton method starts."""


@dataclass(frozen=True)
class Orbit:
    """Periodic journal orbits: positions (s, b, 2) in m at angles (s,), velocities, film coefficients."""

    theta: Array
    place: Array
    velocity: Array
    stiffness: Array
    damping: Array

    def eccentricity(self, bearings: Sequence[Bearing]) -> Array:
        """Return |r|/c (s, b)."""
        return np.linalg.norm(self.place, axis=-1) / [b.clearance for b in bearings]


def journal_orbit(bearings: Sequence[Bearing], loads: Array, omega: float, cycle: float) -> Orbit:
    """Return the journals' periodic orbits under `loads` (s, b, 2) on the films, N, at equal angles.

    Refuses loads under which no orbit closes: none turns, or a load too large for the film.
    """
    for number, bearing in enumerate(as_list(bearings, "bearings", "[sb.crankshaft.Bearing(...)]"), 1):
        check_kind(bearing, Bearing, f"bearing {number}", MAKE)
    steps, count = loads.shape[:2]
    if count != len(bearings):
        raise SymbalanceError(f"{count} bearing loads", f"must be {len(bearings)}", "one per bearing")
    if not np.isfinite(loads).all():
        raise SymbalanceError("bearing loads", "must be finite")
    march = _March(bearings, loads, omega, cycle / steps / omega)
    place = _at_once(march, cycle) if steps > COARSE else None
    return _tangents(
        bearings, march.march_until_closed() if place is None else place, loads, omega, cycle
    )


def _at_once(march: _March, cycle: float) -> Array | None:
    """Return the closed orbit by Newton's method on all steps, from a march of one coarse cycle."""
    steps, every = len(march.loads), -(-len(march.loads) // COARSE)
    if steps % every:
        return None
    coarse = _March(march.bearings, march.loads[::every], march.omega, march.h * every)
    try:
        places, rates, _ = coarse.cycle(coarse.at_rest())
    except UnsolvedError:  # too coarse for these loads: the march at full steps says whether an orbit is
        return None
    share = (np.arange(every) / every)[:, None, None]
    between = places[:, None] * (1 - share) + np.roll(places, -1, axis=0)[:, None] * share
    start = between.reshape(steps, *places.shape[1:]), np.repeat(rates, every, axis=0)
    stages = start[0][:, None] + np.einsum("ij,njbc->nibc", march.inner, start[1])
    if not (np.linalg.norm(stages, axis=-1) < march.limits[:, 0]).all():
        return None  # the film has no force there, and Newton's method no start
    return periodic_places(march.at, march.stage_loads, march.inner, FARTHEST * march.limits, start)


def bearing_films(bearings: Sequence[Bearing], place: Array, velocity: Array, omega: float) -> FilmState:
    """Return all bearings' films at places (..., b, 2): force (..., b, 2), tangents (..., b, 2, 2)."""
    strength = np.array([b.strength for b in bearings])
    return film_states(strength, np.array([b.clearance for b in bearings]), place, velocity, omega)


class _March:
    """Steps of two-stage Radau IIA for all bearings together, by Newton on the stages' velocities."""

    def __init__(self, bearings: Sequence[Bearing], loads: Array, omega: float, h: float) -> None:
        tableau = radau_iia(2)
        self.bearings, self.loads, self.omega, self.h = bearings, loads, omega, h
        self.inner = h * tableau.matrix
        self.limits = np.array([[b.clearance] for b in bearings])
        self.stage_loads = np.stack(
            [_between(loads, tableau.nodes[0]), np.roll(loads, -1, axis=0)], axis=1
        )

    def at(self, place: Array, velocity: Array) -> FilmState:
        """Return all bearings' films."""
        return bearing_films(self.bearings, place, velocity, self.omega)

    def at_rest(self) -> Array:
        """Return the places where the journals would carry the first loads, were they steady."""
        every = zip(self.bearings, self.loads[0], strict=True)
        return np.array([equilibrium(b, load, self.omega) for b, load in every])

    def march_until_closed(self) -> Array:
        """Return the places (N, b, 2) of the closed orbit, by going round until it closes."""
        place = self.at_rest()
        for _ in range(MOST_CYCLES):
            places, _, end = self.cycle(place)
            if (np.abs(end - place) / self.limits).max() <= CLOSES:
                places[0] = end
                return places
            place = end
        rule = f"no orbit closes within {MOST_CYCLES} cycles"
        raise UnsolvedError("journal orbit", rule, "a wider bearing, more angles or smaller loads")

    def cycle(self, place: Array) -> tuple[Array, Array, Array]:
        """Return one cycle's places (N, b, 2), stage velocities (N, 2, b, 2) and end, from a place."""
        steps = len(self.loads)
        places, rates = np.empty((steps, *place.shape)), np.empty((steps, 2, *place.shape))
        rate = np.zeros((2, *place.shape))
        for k in range(steps):
            places[k] = place
            place, rate = self.step(k, place, rate)
            rates[k] = rate
        return places, rates, place

    def step(self, k: int, place: Array, rate: Array) -> tuple[Array, Array]:
        """Return places and stage velocities after step k; `rate` is where Newton's method begins."""
        count, inner = len(place), self.inner
        rate, stage = self._limited_change(place, 0 * rate, rate)
        for _ in range(MOST_NEWTON):
            at = self.at(stage, rate)
            matrix = np.einsum("ij,ibcd->bicjd", inner, at.stiffness)
            matrix[:, 0, :, 0] += at.damping[0]
            matrix[:, 1, :, 1] += at.damping[1]
            sides = (self.stage_loads[k] - at.force).transpose(1, 0, 2).reshape(count, 4, 1)
            change = np.linalg.solve(matrix.reshape(count, 4, 4), sides)
            change = change.reshape(count, 2, 2).transpose(1, 0, 2)
            rate, stage = self._limited_change(place, rate, change)
            if (np.abs(np.tensordot(inner, change, axes=1)) / self.limits).max() <= NEWTON:
                return stage[-1], rate
        rule = "Newton's method does not settle on the film's velocity"
        raise UnsolvedError(f"journal orbit at step {brief(k)}", rule, "more angles or smaller loads")

    def _limited_change(self, place: Array, rate: Array, change: Array) -> tuple[Array, Array]:
        """Return new rates and stage places, a bearing's change halved until its journal fits."""
        share = np.ones((1, len(place), 1))
        while True:
            stage = place + np.tensordot(self.inner, rate + share * change, axes=1)
            out = (np.linalg.norm(stage, axis=-1, keepdims=True) >= FARTHEST * self.limits).any(axis=0)
            if not out.any():
                return rate + share * change, stage
            share = share * np.where(out, 0.5, 1.0)
            if share.min() < 1e-9:
                rule = "the load presses the journal against the shell"
                raise UnsolvedError("journal orbit", rule, "a wider bearing or smaller loads")


def _between(loads: Array, share: float) -> Array:
    """Return the loads a share of a step after each angle, by a cubic through four."""
    x = np.array([-1.0, 0.0, 1.0, 2.0])
    weights = [float(np.prod((share - np.delete(x, i)) / (x[i] - np.delete(x, i)))) for i in range(4)]
    return sum((w * np.roll(loads, 1 - i, axis=0) for i, w in enumerate(weights)), np.zeros(()))


def _tangents(
    bearings: Sequence[Bearing], place: Array, loads: Array, omega: float, cycle: float
) -> Orbit:
    """Return the orbit with velocities that carry the loads exactly: V = C(V)^-1 F, iterated."""
    velocity = _derivative(place, cycle / omega)
    for _ in range(MOST_NEWTON):
        at = bearing_films(bearings, place, velocity, omega)
        velocity = velocity + np.linalg.solve(at.damping, (loads - at.force)[..., None])[..., 0]
    at = bearing_films(bearings, place, velocity, omega)
    weakest = np.array([b.strength * b.clearance for b in bearings])[:, None] * abs(omega)
    if not (np.abs(at.force - loads) <= CARRIED * (np.abs(loads).max() + weakest)).all():
        rule = "no velocity along it carries the loads"
        raise UnsolvedError("journal orbit", rule, "more angles or smaller loads")
    theta = cycle / len(place) * np.arange(len(place))
    return Orbit(theta, place, velocity, at.stiffness, at.damping)


def _derivative(values: Array, period: float) -> Array:
    """Return central differences along the first axis of a periodic table."""
    return (np.roll(values, -1, axis=0) - np.roll(values, 1, axis=0)) * (len(values) / (2 * period))
