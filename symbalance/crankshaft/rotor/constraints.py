"""Springs that hold a free rotor as thrust bearing and driveline do, without bending it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from symbalance.crankshaft.arrays import DOF, Array
from symbalance.crankshaft.rotor.matrices import Rotor
from symbalance.crankshaft.rotor.rigid_body_mode import deflated, spin_motion

SPIN_ORDER = 0.05
"""Natural frequency of the rotor's rotation on its driveline, over the speed; half critically damped.

A soft coupling to a load at constant speed, as on a test bed: at order 2 it alters the flywheel's
swing by (0.05/2)^2 < 0.1 %.
"""
SPIN_DAMPING = 0.5
"""Of critical, of the rotation on the driveline."""
THRUST_DAMPING = 0.1
"""Of critical, of the whole crank on its thrust bearing."""


@dataclass(frozen=True)
class ConstrainedMatrices:
    """The constant matrices of M x'' + D x' + S x at a speed, without bearings."""

    mass: Array
    damping: Array
    stiffness: Array


def constrained_matrices(
    rotor: Rotor, omega: float, thrust: int, thrust_stiffness: float
) -> ConstrainedMatrices:
    """Return the rotor's matrices at `omega` rad/s, with springs on its rotation and its axial motion.

    D = C + omega G, S = K + omega^2 P^T dK P: the centrifugal matrix's false stiffness along the
    rigid-body rotation is taken out (see `rigid_body_mode`). `thrust` is the node of the thrust bearing,
    N/m.
    """
    spin = spin_motion(rotor.points)
    damping = rotor.damping + omega * rotor.gyroscopic
    stiffness = rotor.stiffness + omega**2 * deflated(rotor.centrifugal, rotor.mass, spin)
    inertia, swing = float(spin @ rotor.mass @ spin), SPIN_ORDER * omega
    end = DOF * driven_node(rotor) + 5
    stiffness[end, end] += inertia * swing**2
    damping[end, end] += 2 * SPIN_DAMPING * inertia * swing
    along = DOF * thrust + 2
    total = float(rotor.mass[2::DOF, 2::DOF].sum())
    stiffness[along, along] += thrust_stiffness
    damping[along, along] += 2 * THRUST_DAMPING * np.sqrt(thrust_stiffness * total)
    return ConstrainedMatrices(rotor.mass, damping, stiffness)


def driven_node(rotor: Rotor) -> int:
    """Return the node that the load turns with: the flywheel's, or the last main bearing's."""
    return rotor.journals[-1] if rotor.flywheel is None else rotor.flywheel
