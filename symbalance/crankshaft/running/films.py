"""stub until the bearings' room is here."""

from __future__ import annotations

import numpy as np

from symbalance.crankshaft.system import Film, PeriodicSystem


def films(engine, omega, loads):
    b = len(engine.supports.clearance)
    K = np.tile(4e8 * np.eye(2), (b, 1, 1))
    C = np.tile(5e4 * np.eye(2), (b, 1, 1))
    return Film(lambda t: np.broadcast_to(K, (len(t), b, 2, 2)), lambda t: np.broadcast_to(C, (len(t), b, 2, 2)))


def in_series(system: PeriodicSystem) -> PeriodicSystem:
    return system
