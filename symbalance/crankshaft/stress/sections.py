"""Section loads as linear functions of the rotor's displacements."""

from __future__ import annotations

import numpy as np

from symbalance.crankshaft.rotor import Array, Member, Rotor


def transmitted(rotor: Rotor, member: Member, point: Array) -> Array:
    """Return (6, n): what the part in front of a section bears on the part behind it, per displacement.

    Forces F and moments M about `point` (3,), all in U, V, W: the loads at the member's front end,
    stiffness times displacements, carried to the point, M = M_front + (front - point) x F. What the
    member itself weighs between is left out; what hangs on a web counts with the end it hangs on.

    A member stretched along W transmits F_w = -N: the part in front pulls forward.
    """
    carried = rotor.passing(member)
    arm = rotor.points[member.front] - np.asarray(point, dtype=float)
    carried[3:] += np.cross(arm, carried[:3], axisb=0, axisc=0)
    return carried


def members_of(rotor: Rotor, index: int) -> list[Member]:
    """Return the members of a part of the crank's chain, front to rear."""
    own = [m for m in rotor.members if m.index == index]
    return sorted(own, key=lambda m: rotor.points[m.front][2] + rotor.points[m.rear][2])
