"""Modal reduction of a rotor on bearings: its lowest free modes, and its static answers to unit loads.

Plain modes converge slowly where forces enter at points: the stress at a pin is a sum over all of them.
The static answer to each force (an attachment vector) puts the sum's tail in at once, so that the modes
need only carry what resonates.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from symbalance.crankshaft.arrays import Array
from symbalance.crankshaft.integrators.coefficients import bearing_rows
from symbalance.crankshaft.system import PeriodicSystem, check_system
from symbalance.errors import SymbalanceError, brief

SUPPORT = 1e8
"""Springs (N/m) at the bearings on which the static answers are taken: a free rotor has none."""
DEPENDENT = 1e-12
"""Shapes of the load below this share of the largest are rounding, and left out."""
NEW = 1e-8
"""What a unit column must add to the columns before it, in the metric of M, to count."""


def reduce_system(
    system: PeriodicSystem, modes: int = 20, *, attachments: bool = True, angles: int = 360
) -> tuple[PeriodicSystem, Array]:
    """Return the system reduced to fewer unknowns a, and the basis (n, m): x = basis a.

    The basis is the first `modes` modes of M and the symmetric part of the stiffness, and with
    `attachments` the static answers to unit forces at the bearings and to the shapes that the loads have
    at `angles` equal angles. Its columns are orthonormal in M. `unreduced` takes a trajectory back.
    """
    check_system(system)
    if not isinstance(modes, int | np.integer) or not 1 <= modes <= system.size:
        raise SymbalanceError(f"modes = {brief(modes)}", f"must lie in 1 to {system.size}", "20 is usual")
    stiffness = (system.stiffness + system.stiffness.T) / 2
    columns: list[Array] = [lowest_modes(stiffness, system.mass, modes)]
    if attachments:
        points = bearing_rows(system)
        theta = system.cycle / angles * np.arange(angles)
        shapes = _load_shapes(system.force(theta))
        stiffness_on_springs = stiffness + SUPPORT * points.T @ points
        columns.append(np.linalg.solve(stiffness_on_springs, np.hstack([points.T, shapes.T])))
    return projected(system, columns)


def projected(system: PeriodicSystem, columns: Sequence[Array]) -> tuple[PeriodicSystem, Array]:
    """Return the system on the span of columns (n, k), and an M-orthonormal basis of that span."""
    basis = _orthonormal(columns, system.mass)
    points = system.points @ basis
    force = system.force
    projection = replace(
        system,
        mass=basis.T @ system.mass @ basis,
        damping=basis.T @ system.damping @ basis,
        stiffness=basis.T @ system.stiffness @ basis,
        points=points,
        force=lambda theta: force(theta) @ basis,
    )
    return projection, basis


def lowest_modes(stiffness: Array, mass: Array, count: int) -> Array:
    """Return the modes (n, count) of the lowest frequencies, M-orthonormal.

    >>> lowest_modes(np.diag([8.0, 1.0]), np.diag([2.0, 1.0]), 1).ravel().round(6) + 0.0
    array([0., 1.])
    """
    lower = np.linalg.inv(np.linalg.cholesky(mass))
    vectors = np.linalg.eigh(lower @ stiffness @ lower.T)[1][:, :count]
    shapes = lower.T @ vectors
    return shapes * np.where(shapes[np.abs(shapes).argmax(axis=0), np.arange(count)] < 0, -1.0, 1.0)


def _load_shapes(loads: Array) -> Array:
    """Return the shapes (r, n) that span loads (s, n), those below `DEPENDENT` left out."""
    sizes, shapes = np.linalg.svd(loads, full_matrices=False)[1:]
    return shapes[sizes > DEPENDENT * sizes[0]]


def _orthonormal(columns: Sequence[Array], mass: Array) -> Array:
    """Return an M-orthonormal basis, each group of columns cleared of those before it.

    In y = R x, M = R^t R, the metric is the plain one, where a singular value tells what is new.
    """
    root = np.linalg.cholesky(mass).T
    basis = np.zeros((len(mass), 0))
    for group in columns:
        scaled_group = root @ group
        scaled_group = scaled_group / np.linalg.norm(scaled_group, axis=0)
        for _ in range(2):  # once leaves rounding as large as a nearly dependent column
            scaled_group = scaled_group - basis @ (basis.T @ scaled_group)
        directions, sizes = np.linalg.svd(scaled_group, full_matrices=False)[:2]
        fresh = directions[:, sizes > NEW]
        fresh = fresh - basis @ (basis.T @ fresh)
        basis = np.hstack([basis, np.linalg.qr(fresh)[0]])
    return np.linalg.solve(root, basis)
