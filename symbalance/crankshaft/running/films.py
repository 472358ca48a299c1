"""The oil films of an engine at a speed: tangents along the orbits of its loads, or a file's table."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from symbalance.crankshaft.bearings.csv_table import read_film
from symbalance.crankshaft.bearings.orbits import Orbit, journal_orbit
from symbalance.crankshaft.bearings.periodic import film_from_tables
from symbalance.crankshaft.bearings.short_film import Bearing
from symbalance.crankshaft.files import RunningEngine
from symbalance.crankshaft.rotor import Array
from symbalance.crankshaft.system import Film

ANGLES = 720
"""Angles of a cycle at which films are computed: a table too coarse breaks every integrator."""


def films(engine: RunningEngine, omega: float, loads: Callable[[Array], Array]) -> Film:
    """Return the films at `omega` rad/s; `loads` are the shaft's on its bearings at angles, N.

    Without a table each bearing is a short one whose journal goes round under its load; stiffness and
    damping are the film's tangents along that orbit.
    """
    cycle = engine.layout.strokes * np.pi
    table = engine.supports.table
    if table is not None:
        return read_film(table, len(engine.supports.clearance), cycle)
    orbit = orbit_of(engine, omega, loads)
    return film_from_tables(orbit.theta, orbit.stiffness, orbit.damping, cycle)


def orbit_of(engine: RunningEngine, omega: float, loads: Callable[[Array], Array]) -> Orbit:
    """Return the journals' orbits under their loads."""
    cycle = engine.layout.strokes * np.pi
    theta = cycle * np.arange(ANGLES) / ANGLES
    return journal_orbit(plain_bearings(engine), loads(theta), omega, cycle)


def plain_bearings(engine: RunningEngine) -> list[Bearing]:
    """Return the main bearings as plain ones."""
    held = engine.supports
    rows = zip(held.diameter, held.length, held.clearance, held.viscosity, strict=True)
    return [Bearing(*row) for row in rows]
