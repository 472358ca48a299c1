"""Oil films of an engine at a speed: linear about the orbits of its journals, or from a file's table.

A tangent is the film's stiffness and damping for small departures from an orbit. Taken about the orbit
r_0(t) (`about` = orbit) the film's force is F_0 + K (r - r_0) + C (r' - r_0'), with F_0, K, C those of
the film at r_0, r_0': exact to first order. Taken as springs about the centre (`about` = centre), K r + C
r', as the paper has it, the same tangents leave r_0 out, and orbits come out that no bearing has.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from typing import Any

import numpy as np

from symbalance.crankshaft.arrays import Array
from symbalance.crankshaft.bearings.film_tables import film_from_tables, read_film
from symbalance.crankshaft.bearings.orbits import bearing_films as film_states
from symbalance.crankshaft.bearings.orbits import journal_orbit
from symbalance.crankshaft.bearings.short_film import Bearing
from symbalance.crankshaft.files import RunningEngine
from symbalance.crankshaft.system import Film, Housing
from symbalance.errors import MissingPartError

FEWEST_ANGLES = 720
"""Angles of a cycle at which films are computed, at least: a film almost dry needs them (360 gave an
in-line four stresses half as large again at one speed).
"""
CLOSEST = 0.98
"""The share of the clearance to which a journal's place is limited before its film is computed."""


@dataclass(frozen=True)
class OrbitFilms:
    """Journals' places r_0 in their bearings at even angles (s,), their films' forces and tangents.

    `force` (s, b, 2) is the shaft's on the films, `housing_place` z_0 the housings' displacement.
    """

    theta: Array
    place: Array
    force: Array
    housing_place: Array
    film: Film


def table_film(engine: RunningEngine) -> Film | None:
    """Return the films of a file's table, None where there is none."""
    table = engine.bearings.table
    cycle = engine.layout.strokes * np.pi
    return None if table is None else read_film(table, len(engine.bearings.clearance), cycle)


def loaded_places(
    engine: RunningEngine, omega: float, loads: Callable[[Array], Array], steps: int
) -> Array:
    """Return the journals' places (s, b, 2) at even angles, on their periodic orbits under loads, N."""
    cycle = engine.layout.strokes * np.pi
    count = max(steps, FEWEST_ANGLES)
    theta = cycle * np.arange(count) / count
    return journal_orbit(plain_bearings(engine), loads(theta), omega, cycle).place


def orbits_about(
    engine: RunningEngine, omega: float, place: Array, housing: Housing | None
) -> OrbitFilms:
    """Return the films' forces and tangents along given places (s, b, 2) at even angles of a cycle, m.

    Places outside `CLOSEST` of the clearance are moved in to it.
    """
    cycle = engine.layout.strokes * np.pi
    theta = cycle * np.arange(len(place)) / len(place)
    limit = CLOSEST * np.array(engine.bearings.clearance)[:, None]
    size = np.linalg.norm(place, axis=-1, keepdims=True)
    inside = place * np.minimum(1.0, limit / np.maximum(size, 1e-300))
    velocity = omega * periodic_spline(theta, inside, cycle)(theta, 1)
    state = film_states(plain_bearings(engine), inside, velocity, omega)
    film = film_from_tables(theta, state.stiffness, state.damping, cycle)
    return OrbitFilms(
        theta, inside, state.force, housing_places(state.force, housing, cycle, omega), film
    )


def housing_places(force: Array, housing: Housing | None, cycle: float, omega: float) -> Array:
    """Return z (s, b, 2), K_B z + C_B z' = `force` at even angles of a cycle, solved order by order."""
    if housing is None:
        return np.zeros_like(force)
    spectrum = np.fft.rfft(force, axis=0)
    rates = 2j * np.pi / cycle * omega * np.arange(len(spectrum))
    springs = housing.stiffness + rates[:, None, None, None] * housing.damping
    places = np.linalg.solve(springs, spectrum[..., None])[..., 0]
    return np.fft.irfft(places, n=len(force), axis=0)


def periodic_spline(theta: Array, values: Array, cycle: float) -> Any:
    """Return the periodic cubic spline through values (s, ...): a function (angle, derivative)."""
    try:
        splines = import_module("scipy.interpolate")
    except ImportError:
        rule, remedy = "SciPy is not installed", "pip install 'symbalance[crankshaft]'"
        raise MissingPartError("films", rule, remedy) from None
    around = np.concatenate([values, values[:1]])
    curve = splines.CubicSpline(np.append(theta, theta[0] + cycle), around, bc_type="periodic")
    return lambda angle, order=0: curve(np.mod(angle, cycle), order)


def plain_bearings(engine: RunningEngine) -> list[Bearing]:
    """Return the main bearings as plain ones."""
    bearings = engine.bearings
    rows = zip(bearings.diameter, bearings.length, bearings.clearance, bearings.viscosity, strict=True)
    return [Bearing(*row) for row in rows]
