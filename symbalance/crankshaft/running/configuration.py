"""An engine made ready to run: its rotor, its channels and, at a speed, its periodic system."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from symbalance.crankshaft.arrays import Array
from symbalance.crankshaft.assembly import assemble, web_flexibility
from symbalance.crankshaft.files import RunningEngine
from symbalance.crankshaft.loads import big_end_masses, pin_loads
from symbalance.crankshaft.rotor.constraints import held
from symbalance.crankshaft.rotor.matrices import Rotor
from symbalance.crankshaft.rotor.modes import Modes, natural_modes
from symbalance.crankshaft.running.loading import Loading, bearing_points, quasi_static, stationary
from symbalance.crankshaft.running.oil_films import Orbits, loaded_places, orbits_about, table_film
from symbalance.crankshaft.solid.store import open_store
from symbalance.crankshaft.stress import Channel, channels, stress_matrix
from symbalance.crankshaft.system import Film, Housing, PeriodicSystem
from symbalance.crankshaft.webs.arm import Arm, Elastic
from symbalance.text.numbers import checked_whole

OMEGA = np.pi / 30
"""rad/s of one rpm."""
RIGID, MODES_SHOWN = 6, 20
MOST_STEPS = 46_080
Loads = Callable[[Array], Array]


@dataclass(frozen=True)
class Setting:
    """An engine, its rotor (webs and big ends in it), and how it is solved.

    `about` is what the films are linear about: orbit, the journals' own, or centre, as the paper has it
    (a table is always about the centre); up to `passes` times under the loads found.
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
    passes: int = 9
    compliances: tuple[Elastic, ...] = ()
    """The webs' compliances that the rotor was assembled with, front to rear."""

    @property
    def how(self) -> tuple[object, ...]:
        """How it is solved, for a key."""
        return self.webs, self.modes, self.connection, self.steps, self.about, self.passes

    @cached_property
    def channels(self) -> list[Channel]:
        """The stresses and twists."""
        return channels(self.engine.crank, self.rotor)

    @cached_property
    def stress(self) -> Array:
        """Psi (c, n): the channels per displacement."""
        return stress_matrix(self.channels)

    def loading(self, rpm: float) -> Loading:
        """Return the loads at a speed."""
        return Loading(self.rotor, pin_loads(self.engine, rpm * OMEGA))

    def bearing_loads(self, rpm: float, theta: Array) -> Array:
        """Return (s, b, 2): the shaft's quasi-static forces on the bearings, stationary axes, N."""
        return stationary(quasi_static(self.rotor, self.loading(rpm).at(theta)), theta)

    def orbits(self, rpm: float, loads: Loads | None = None) -> Orbits:
        """Return the films along the orbits under bearing loads, by default the quasi-static ones, N."""
        omega = rpm * OMEGA
        loads = loads or (lambda theta: self.bearing_loads(rpm, theta))
        place = loaded_places(self.engine, omega, loads, self.steps)
        return orbits_about(self.engine, omega, place, self.housing)

    @cached_property
    def housing(self) -> Housing | None:
        """The structure behind the films, None if rigid."""
        given = self.engine.supports.housing
        if given is None:
            return None
        stiffness = np.array([np.diag(row[:2]) for row in given])
        damping = np.array([row[2] * np.eye(2) for row in given])
        return Housing(stiffness, damping)

    @cached_property
    def table(self) -> Film | None:
        """The films of the file's table, if it names one."""
        return table_film(self.engine)

    def system(self, rpm: float, film: Film | None = None) -> PeriodicSystem:
        """Return the full periodic system at a speed, the films in series with an exact housing.

        Without a `film`: the table's, or that of the orbits under the quasi-static loads.
        """
        holding = self._held(rpm)
        return PeriodicSystem(
            mass=holding.mass,
            damping=holding.damping,
            stiffness=holding.stiffness,
            points=bearing_points(self.rotor),
            film=film or self.table or self.orbits(rpm).film,
            housing=self.housing,
            force=self.loading(rpm).at,
            omega=rpm * OMEGA,
            cycle=self.engine.layout.strokes * np.pi,
        )

    def _held(self, rpm: float) -> Any:
        supports = self.engine.supports
        thrust = self.rotor.journals[supports.thrust]
        return held(self.rotor, rpm * OMEGA, thrust, supports.thrust_stiffness)

    @cached_property
    def modes_at_rest(self) -> Modes:
        """The lowest elastic modes of the free crank at rest."""
        return natural_modes(self.rotor, min(MODES_SHOWN, self.rotor.size - RIGID))

    def at_speeds(self, rpm: tuple[float, ...]) -> Setting:
        """Return the same setting with other speeds."""
        return replace(self, engine=self.engine.at_speeds(rpm))


def setting(
    engine: RunningEngine,
    *,
    webs: str = "formula",
    modes: int = 0,
    connection: str = "exact",
    steps: int = 720,
    about: str = "orbit",
    passes: int = 9,
    store: Path | None = None,
    say: Callable[[str], None] = lambda line: None,
) -> Setting:
    """Return an engine made ready to run; `say` hears of a file of solved webs that is not believed.

    `webs` is the way to the webs' stiffness (see `assembly.WEBS`), `modes` how many are kept beside the
    static shapes, 0 for the full model; webs solved by the mesher are kept in the file `store`. Every
    rod's big end turns with its pin's node.
    """
    for name, value, low, high in (
        ("modes", modes, 0, 10_000),
        ("steps", steps, 90, MOST_STEPS),
        ("passes", passes, 1, 20),
    ):
        checked_whole(value, name, low, high, "see symbalance crankshaft --help")
    kept = open_store(store, say) if webs in ("solid", "fitted") else None
    flexibility, used = web_flexibility(webs, kept), []

    def recorded(arm: Arm) -> Elastic:
        web = flexibility(arm)
        used.append(web if isinstance(web, Elastic) else Elastic(web))
        return used[-1]

    rotor = assemble(
        engine.crank,
        webs=recorded,
        pin_masses=big_end_masses(engine),
        damping_ratio=engine.operation.damping,
    )
    return Setting(engine, rotor, webs, modes, connection, steps, about, passes, tuple(used))
