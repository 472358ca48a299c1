"""A crank web in axes of its own: near end's axis at the origin, far end's along +u, faces 0 and t.

The near end is the journal's, the far end the pin's; a web between two pins has its front pin near. A web
that stands pin first is the mirror image, w to -w, of one that stands journal first.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from math import atan2, cos, hypot, sin

import numpy as np

from symbalance.crankshaft.arrays import DOF, Array
from symbalance.crankshaft.crank import Crank, Journal, Pin, Web
from symbalance.crankshaft.rotor.beams import element, transfer
from symbalance.crankshaft.rotor.parts import Material
from symbalance.crankshaft.rotor.rigid_bodies import RigidBody, turn_about_w

MIRROR = np.diag([1.0, 1.0, -1.0, -1.0, -1.0, 1.0])


@dataclass(frozen=True)
class WebCompliance:
    """A web's flexibility, clamped at its near face, in own axes: `flexibility` (6, 6) of the far face.

    With `body` (3,), from the near node to the centre of the body attached to the near end (heel and
    counterweight), it is (12, 12): far face, then the mean motion of that body under inertia forces.
    """

    flexibility: Array
    body: Array | None = None

    @property
    def face(self) -> Array:
        """The (6, 6) flexibility of the far face alone."""
        return self.flexibility[:DOF, :DOF]


@dataclass(frozen=True)
class Arm:
    """A web with what it joins: `near` and `far` parts, `reach` between their axes, material.

    `angle` turns its own u axis from U about W; `mirrored` where the near part is behind it; `axis`
    is the place (U, V) of the near part's axis.
    """

    web: Web
    near: Journal | Pin
    far: Journal | Pin
    material: Material
    reach: float
    angle: float
    mirrored: bool
    axis: tuple[float, float]

    @property
    def lever(self) -> Array:
        """From the near node to the far node, in the arm's own axes."""
        return np.array([self.reach, 0.0, self.web.thickness])

    @property
    def near_margin(self) -> float:
        """How far the web reaches beyond the near axis, away from the far one."""
        return self.web.heel if isinstance(self.near, Journal) else self.web.tip

    @property
    def far_margin(self) -> float:
        """How far the web reaches beyond the far axis."""
        return self.web.tip

    def canonical(self) -> Arm:
        """Return the same web standing near part first, with its arm along U."""
        near, far = (_turned_part(part, -self.angle) for part in (self.near, self.far))
        weight = self.web.counterweight
        if weight is not None:
            weight = replace(weight, angle=weight.angle - self.angle)
        web = replace(self.web, counterweight=weight)
        axis = axis_of(near)
        return replace(self, web=web, near=near, far=far, angle=0.0, mirrored=False, axis=axis)

    def web_stiffness(self, elastic: WebCompliance) -> Array:
        """Return a web's stiffness in U, V, W: front node, rear node, body if it has one."""
        levers = (self.lever,) if elastic.body is None else (self.lever, elastic.body)
        own = element(elastic.flexibility, *levers)
        count = len(own) // DOF
        if self.mirrored:
            order = [*range(DOF, 2 * DOF), *range(DOF), *range(2 * DOF, count * DOF)]
            flips = np.kron(np.eye(count), MIRROR)
            own = (flips @ own @ flips)[np.ix_(order, order)]
        turn = np.kron(np.eye(2 * count), turn_about_w(self.angle))
        return turn @ own @ turn.T

    def place_of(self, lever: Array, near: Array) -> Array:
        """Return the place in U, V, W of what is `lever` from the near node, at `near`, in own axes."""
        flip = np.array([1.0, 1.0, -1.0 if self.mirrored else 1.0])
        return near + turn_about_w(self.angle) @ (flip * lever)

    def in_rotor_axes(self, body: RigidBody) -> RigidBody:
        """Return a body given in own axes in U, V, W."""
        return (body.mirrored() if self.mirrored else body).turned(self.angle)


def axis_of(part: Journal | Pin) -> tuple[float, float]:
    """Return the (U, V) of a part's axis.

    >>> axis_of(Journal(0.06, 0.02))
    (0.0, 0.0)
    """
    if isinstance(part, Journal):
        return (0.0, 0.0)
    return (part.radius * cos(part.angle), part.radius * sin(part.angle))


def _turned_part(part: Journal | Pin, angle: float) -> Journal | Pin:
    return part if isinstance(part, Journal) else replace(part, angle=part.angle + angle)


def arms(crank: Crank) -> Iterator[tuple[int, Arm]]:
    """Yield the crank's webs with their places in the chain."""
    for index, part in enumerate(crank.parts):
        if isinstance(part, Web):
            yield index, _arm(crank, index, part)


def _arm(crank: Crank, index: int, web: Web) -> Arm:
    front, rear = crank.parts[index - 1], crank.parts[index + 1]
    assert not isinstance(front, Web)
    assert not isinstance(rear, Web)
    mirrored = isinstance(rear, Journal) and isinstance(front, Pin)
    near, far = (rear, front) if mirrored else (front, rear)
    (u0, v0), (u1, v1) = axis_of(near), axis_of(far)
    reach = hypot(u1 - u0, v1 - v0)
    if reach > 1e-9 * max(near.diameter, far.diameter):
        angle = atan2(v1 - v0, u1 - u0)
    else:
        angle = far.angle if isinstance(far, Pin) else 0.0
    return Arm(web, near, far, crank.material, reach, angle, mirrored, (u0, v0))


def chain_flexibility(pieces: list[tuple[Array, Array]]) -> Array:
    """Return the flexibility of the last end of pieces in a row, each (flexibility, lever)."""
    total, after = np.zeros((DOF, DOF)), np.zeros(3)
    for flexible, lever in reversed(pieces):
        shift = transfer(after)
        total += shift @ flexible @ shift.T
        after = after + lever
    return total
