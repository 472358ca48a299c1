"""Configuration of a run: an engine's rotor, its stress channels and, at a speed, its periodic system."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path

import numpy as np

from symbalance.crankshaft.arrays import Array
from symbalance.crankshaft.assembly import assemble, web_flexibility
from symbalance.crankshaft.files import RunningEngine
from symbalance.crankshaft.loads import big_end_masses, pin_loads
from symbalance.crankshaft.rotor.constraints import ConstrainedMatrices, constrained_matrices
from symbalance.crankshaft.rotor.matrices import Rotor
from symbalance.crankshaft.rotor.modes import Modes, natural_modes
from symbalance.crankshaft.running.loading import (
    RotorLoads,
    bearing_points,
    quasi_static_reactions,
    to_stationary_axes,
)
from symbalance.crankshaft.running.oil_films import OrbitFilms, loaded_places, orbits_about, table_film
from symbalance.crankshaft.solid.store import open_store
from symbalance.crankshaft.stress import Channel, channels, stress_matrix
from symbalance.crankshaft.system import Film, Housing, PeriodicSystem
from symbalance.crankshaft.webs.arm import Arm, WebCompliance
from symbalance.text.numbers import checked_whole

OMEGA = np.pi / 30
"""rad/s of one rpm."""
RIGID, MODES_SHOWN = 6, 20
MOST_STEPS = 46_080
"""Of a cycle: 64 times the usual 720."""
Loads = Callable[[Array], Array]


@dataclass(frozen=True)
class RunConfiguration:
    """Settings of a run: the engine, its rotor with webs and big ends, and the solution method.

    `about` is what the films are linear about: orbit, the journals' own, or centre, as the paper has it
    (a table is always about the centre); up to `iterations` times
    under the loads of the last solution.
    `modes` 0 keeps every unknown; `connection` is exact (a housing state a bearing) or equivalent (the
    paper's K(K + K_B)^-1 K_B as one film); `steps` are those of a cycle.
    """

    engine: RunningEngine
    rotor: Rotor
    webs: str
    modes: int
    connection: str
    steps: int
    about: str = "orbit"
    iterations: int = 9
    compliances: tuple[WebCompliance, ...] = ()
    """The webs' compliances that the rotor was assembled with, front to rear."""

    @property
    def solver_options(self) -> tuple[object, ...]:
        """All that decides how it is solved, for the key of a saved outcome."""
        return self.webs, self.modes, self.connection, self.steps, self.about, self.iterations

    @cached_property
    def channels(self) -> list[Channel]:
        """The stresses and twists."""
        return channels(self.engine.crank, self.rotor)

    @cached_property
    def stress(self) -> Array:
        """Psi (c, n): the channels per displacement."""
        return stress_matrix(self.channels)

    def rotor_loads(self, rpm: float) -> RotorLoads:
        """Return the loads at a speed."""
        return RotorLoads(self.rotor, pin_loads(self.engine, rpm * OMEGA))

    def bearing_loads(self, rpm: float, theta: Array) -> Array:
        """Return (s, b, 2): the shaft's quasi-static forces on the bearings, stationary axes, N."""
        return to_stationary_axes(
            quasi_static_reactions(self.rotor, self.rotor_loads(rpm).at(theta)), theta
        )

    def orbits(self, rpm: float, loads: Loads | None = None) -> OrbitFilms:
        """Return the films along the orbits under bearing loads, by default the quasi-static ones, N."""
        omega = rpm * OMEGA
        loads = loads or (lambda theta: self.bearing_loads(rpm, theta))
        place = loaded_places(self.engine, omega, loads, self.steps)
        return orbits_about(self.engine, omega, place, self.housing)

    @cached_property
    def housing(self) -> Housing | None:
        """The structure behind the films, None if rigid."""
        rows = self.engine.bearings.housing
        if rows is None:
            return None
        stiffness = np.array([np.diag(row[:2]) for row in rows])
        damping = np.array([row[2] * np.eye(2) for row in rows])
        return Housing(stiffness, damping)

    @cached_property
    def table(self) -> Film | None:
        """The films of the file's table, if it names one."""
        return table_film(self.engine)

    def system(self, rpm: float, film: Film | None = None) -> PeriodicSystem:
        """Return the full periodic system at a speed, the films in series with an exact housing.

        Without a `film`: the table's, or that of the orbits under the quasi-static loads.
        """
        matrices = self._matrices(rpm)
        return PeriodicSystem(
            mass=matrices.mass,
            damping=matrices.damping,
            stiffness=matrices.stiffness,
            points=bearing_points(self.rotor),
            film=film or self.table or self.orbits(rpm).film,
            housing=self.housing,
            force=self.rotor_loads(rpm).at,
            omega=rpm * OMEGA,
            cycle=self.engine.engine.strokes * np.pi,
        )

    def _matrices(self, rpm: float) -> ConstrainedMatrices:
        bearings = self.engine.bearings
        thrust = self.rotor.journals[bearings.thrust]
        return constrained_matrices(self.rotor, rpm * OMEGA, thrust, bearings.thrust_stiffness)

    @cached_property
    def modes_at_rest(self) -> Modes:
        """The lowest elastic modes of the free crank at rest."""
        return natural_modes(self.rotor, min(MODES_SHOWN, self.rotor.size - RIGID))

    def at_speeds(self, rpm: tuple[float, ...]) -> RunConfiguration:
        """Return the same configuration at other speeds."""
        return replace(self, engine=self.engine.at_speeds(rpm))


def configure_run(
    engine: RunningEngine,
    *,
    webs: str = "formula",
    modes: int = 0,
    connection: str = "exact",
    steps: int = 720,
    about: str = "orbit",
    iterations: int = 9,
    store: Path | None = None,
    say: Callable[[str], None] = lambda line: None,
) -> RunConfiguration:
    """Return the configuration of a run; `say` gets a line if the file of solved webs is invalid.

    `webs` is the model of the webs' stiffness (see `assembly.WEBS`), `modes` how many are kept beside the
    static shapes, 0 for the full model; webs solved by the mesher are kept in the file `store`. Every
    rod's big end turns with its pin's node.
    """
    for name, value, low, high in (
        ("modes", modes, 0, 10_000),
        ("steps", steps, 90, MOST_STEPS),
        ("passes", iterations, 1, 20),
    ):
        checked_whole(value, name, low, high, "see symbalance crankshaft --help")
    solved_webs = open_store(store, say) if webs in ("solid", "fitted") else None
    flexibility, compliances = web_flexibility(webs, solved_webs), []

    def record(arm: Arm) -> WebCompliance:
        web = flexibility(arm)
        compliances.append(web if isinstance(web, WebCompliance) else WebCompliance(web))
        return compliances[-1]

    rotor = assemble(
        engine.crank,
        webs=record,
        pin_masses=big_end_masses(engine),
        damping_ratio=engine.operation.damping,
    )
    return RunConfiguration(
        engine, rotor, webs, modes, connection, steps, about, iterations, tuple(compliances)
    )
