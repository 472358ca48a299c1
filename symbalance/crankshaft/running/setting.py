"""An engine made ready to run: its rotor, its channels and, at a speed, its periodic system."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from symbalance.crankshaft.assembly import assemble
from symbalance.crankshaft.files import RunningEngine
from symbalance.crankshaft.loads import big_end_masses, pin_loads
from symbalance.crankshaft.rotor import Array, Rotor
from symbalance.crankshaft.running.films import films
from symbalance.crankshaft.running.holding import held
from symbalance.crankshaft.running.loading import Loading
from symbalance.crankshaft.running.reactions import bearing_points, quasi_static, stationary
from symbalance.crankshaft.stress import Channel, channels, stress_matrix
from symbalance.crankshaft.system import Film, Housing, PeriodicSystem

OMEGA = np.pi / 30
"""rad/s of one rpm."""
RIGID = 6


@dataclass(frozen=True)
class Setting:
    """An engine, its rotor (webs and big ends in it), and how it is solved.

    `modes` 0 keeps every unknown; `connection` is exact (a housing state a bearing) or equivalent (the
    paper's K(K + K_B)^-1 K_B as one film); `steps` are those of a cycle.
    """

    engine: RunningEngine
    rotor: Rotor
    webs: str
    modes: int
    connection: str
    steps: int

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

    def film(self, rpm: float) -> Film:
        """Return the films at a speed: from the quasi-static loads, or the file's table."""
        return films(self.engine, rpm * OMEGA, lambda theta: self.bearing_loads(rpm, theta))

    @cached_property
    def housing(self) -> Housing | None:
        """The structure behind the films, None if rigid."""
        given = self.engine.supports.housing
        if given is None:
            return None
        stiffness = np.array([np.diag(row[:2]) for row in given])
        damping = np.array([row[2] * np.eye(2) for row in given])
        return Housing(stiffness, damping)

    def system(self, rpm: float) -> PeriodicSystem:
        """Return the full periodic system at a speed, the films in series with an exact housing."""
        holding = self._held(rpm)
        return PeriodicSystem(
            mass=holding.mass,
            damping=holding.damping,
            stiffness=holding.stiffness,
            points=bearing_points(self.rotor),
            film=self.film(rpm),
            housing=self.housing,
            force=self.loading(rpm).at,
            omega=rpm * OMEGA,
            cycle=self.engine.layout.strokes * np.pi,
        )

    def _held(self, rpm: float) -> Any:
        supports = self.engine.supports
        thrust = self.rotor.journals[supports.thrust]
        return held(self.rotor, rpm * OMEGA, thrust, supports.thrust_stiffness)

    def frequencies(self, count: int = 20) -> list[float]:
        """Return the lowest natural frequencies of the free crank, rigid motions left out, Hz."""
        return natural_frequencies(self.rotor, count)

    def at_speeds(self, rpm: tuple[float, ...]) -> Setting:
        """Return the same setting with other speeds."""
        return replace(self, engine=self.engine.at_speeds(rpm))


def setting(
    engine: RunningEngine,
    *,
    webs: str = "formula",
    modes: int = 20,
    connection: str = "exact",
    steps: int = 720,
) -> Setting:
    """Return an engine made ready to run.

    `webs` is the way to the webs' stiffness (see `assembly.WEBS`), `modes` how many are kept beside the
    static shapes, 0 for the full model. Every rod's big end turns with its pin's node.
    """
    rotor = assemble(
        engine.crank,
        webs=webs,
        pin_masses=big_end_masses(engine),
        damping_ratio=engine.operation.damping,
    )
    return Setting(engine, rotor, webs, modes, connection, steps)


def natural_frequencies(rotor: Rotor, count: int) -> list[float]:
    """Return the lowest natural frequencies of the free rotor at rest, rigid motions left out, Hz."""
    inverse = np.linalg.inv(np.linalg.cholesky(rotor.mass))
    squares = np.linalg.eigvalsh(inverse @ rotor.stiffness @ inverse.T)[RIGID : RIGID + count]
    return [float(f) for f in np.sqrt(np.maximum(squares, 0.0)) / (2 * np.pi)]
