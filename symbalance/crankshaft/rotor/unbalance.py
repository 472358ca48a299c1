"""Response of a rotor to unbalance: by amplitudes if it is axisymmetric, else as a periodic system.

A mass m at the distance e and the angle alpha (from U towards V) pulls a node with U = m e e^{i alpha}:
vertically Re(U w^2 e^{iwt}), laterally Re(-i U w^2 e^{iwt}).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from symbalance.crankshaft.arrays import DOF, Array
from symbalance.crankshaft.frames import GRAVITY, rotation
from symbalance.crankshaft.rotor.constraints import constrained_matrices
from symbalance.crankshaft.rotor.documents import RPM, complex_data, supports_data
from symbalance.crankshaft.rotor.matrices import Rotor
from symbalance.crankshaft.rotor.stationary import Support, Supports, stationary_rotor, supports_at
from symbalance.crankshaft.system import Film, PeriodicSystem
from symbalance.document.result import Result
from symbalance.errors import SymbalanceError, brief

if TYPE_CHECKING:
    from symbalance.document.nodes import Document

Unbalances = Mapping[float, complex]
"""Place along the shaft (m) to unbalance (kg m), complex where its angle is not 0."""
NEAR = 1e-6
"""How far from a node, in m, the place of an unbalance may be."""


@dataclass(frozen=True, repr=False)
class UnbalanceResponse(Result):
    """Steady response x = Re(a e^{iwt}) to unbalance at `speeds` (s,) in rad/s.

    `vertical`, `lateral` (s, n): complex amplitudes at the nodes, m; `forces` (s, b, 2): the shaft's on
    its supports, vertical and lateral, N. `unbalances` are pairs of place (m) and kg m; `supports` is
    None where they were given as a function of the speed.
    """

    speeds: Array
    places: Array
    vertical: NDArray[np.complex128]
    lateral: NDArray[np.complex128]
    forces: NDArray[np.complex128]
    rotor: Rotor
    unbalances: tuple[tuple[float, complex], ...]
    supports: tuple[Support, ...] | None

    kind: ClassVar[str] = "unbalance-response"

    def summary(self) -> str:
        """Return the largest orbit and where it is, in one line."""
        from symbalance.crankshaft.rotor.documents import speeds_words

        if not self.largest.size:
            return "Answer to unbalance at no speed"
        s, n = np.unravel_index(np.argmax(self.largest), self.largest.shape)
        size, place = self.largest[s, n] * 1e6, self.places[n]
        where = f"at {place:.4g} m" + (
            f", {self.speeds[s] * RPM:.6g} rpm" if len(self.speeds) > 1 else ""
        )
        return f"Answer to unbalance at {speeds_words(self)}: largest orbit {size:.4g} µm {where}"

    def document(self) -> Document:
        """Return the largest orbits, the forces on the supports, and what was put in."""
        from symbalance.crankshaft.rotor.documents import unbalance_document

        return unbalance_document(self)

    def data(self) -> dict[str, Any]:
        """Return amplitudes at every node in m and forces in N by speed, as [real, imaginary] pairs."""
        return {
            "speeds_rpm": (self.speeds * RPM).tolist(),
            "places": self.places.tolist(),
            "vertical": complex_data(self.vertical),
            "lateral": complex_data(self.lateral),
            "forces": complex_data(self.forces),
            "unbalances": [
                {"place": place, "kg_m": [amount.real, amount.imag]} for place, amount in self.unbalances
            ],
            "supports": supports_data(self.supports),
        }

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each node at each speed: sizes in m, phases in degrees."""
        return [
            {
                "rpm": float(speed) * RPM,
                "place": float(place),
                "largest": float(self.largest[s, n]),
                "forward": float(np.abs(self.forward[s, n])),
                "forward_phase": float(np.degrees(np.angle(self.forward[s, n]))),
                "backward": float(np.abs(self.backward[s, n])),
                "backward_phase": float(np.degrees(np.angle(self.backward[s, n]))),
            }
            for s, speed in enumerate(self.speeds)
            for n, place in enumerate(self.places)
        ]

    @property
    def forward(self) -> NDArray[np.complex128]:
        """The part that turns with the shaft, (s, n): radius and angle of its circle."""
        return (self.vertical + 1j * self.lateral) / 2

    @property
    def backward(self) -> NDArray[np.complex128]:
        """The part that turns against it, (s, n)."""
        return (self.vertical - 1j * self.lateral) / 2

    @property
    def largest(self) -> Array:
        """The half major axis of each node's orbit, (s, n), m."""
        return np.abs(self.forward) + np.abs(self.backward)


def unbalance_response(
    rotor: Rotor, supports: Supports, unbalances: Unbalances, speeds: Sequence[float]
) -> UnbalanceResponse:
    """Return an axisymmetric rotor's response to unbalances (kg m by place in m), by speed (rad/s).

    Jeffcott's rotor, e = 1 mm: at twice its critical speed it runs 4/3 mm out, opposite the unbalance.

    >>> from symbalance.crankshaft.rotor.parts import Disc, Material
    >>> from symbalance.crankshaft.rotor.shafts import Tube, shaft
    >>> from symbalance.crankshaft.rotor.stationary import Support
    >>> from symbalance.crankshaft.rotor.whirling import critical_speeds
    >>> light = Material(density=1e-3)
    >>> rotor = shaft([Tube(1.0, 0.09)], {0.5: Disc(20.0, 0.4, 0.2)}, (0.0, 1.0), light)
    >>> rigid = [Support(1e13), Support(1e13)]
    >>> critical = critical_speeds(rotor, rigid).speeds[0]
    >>> motions = unbalance_response(rotor, rigid, {0.5: 20.0 * 1e-3}, [2 * critical])
    >>> complex(motions.forward[0, 2].round(7))
    (-0.0013333+0j)
    """
    matrices = stationary_rotor(rotor)
    n = len(rotor.points)
    push = np.zeros((n, 4), dtype=complex)
    for node, amount in _unbalanced_nodes(rotor, unbalances):
        push[node, :2] += amount * np.array([1, -1j])
    motions, forces = [], []
    for speed in map(float, speeds):
        damping, stiffness = matrices.at(supports, speed)
        dynamic = stiffness + 1j * speed * damping - speed**2 * matrices.mass
        answer = np.linalg.solve(dynamic, speed**2 * push.ravel()).reshape(n, 4)[:, :2]
        motions.append(answer)
        pairs = [each.matrices for each in supports_at(rotor, supports, speed)]
        springs = [k + 1j * speed * c for k, c in pairs]
        forces.append([s @ answer[j] for s, j in zip(springs, rotor.journals, strict=True)])
    motion = np.array(motions).reshape(-1, n, 2)
    support_forces = np.array(forces, dtype=complex).reshape(len(motions), -1, 2)
    speeds_of = np.array([float(speed) for speed in speeds])
    amounts = tuple((float(place), complex(amount)) for place, amount in unbalances.items())
    below = None if callable(supports) else tuple(supports)
    places = rotor.points[:, 2]
    return UnbalanceResponse(
        speeds_of, places, motion[..., 0], motion[..., 1], support_forces, rotor, amounts, below
    )


def system_on_supports(
    rotor: Rotor,
    supports: Supports,
    omega: float,
    *,
    unbalances: Unbalances | None = None,
    weight: bool = False,
    thrust_stiffness: float = 1e9,
) -> PeriodicSystem:
    """Return the periodic system of any rotor at `omega` (rad/s) on its supports, for `steady_state`.

    One turn is a cycle; the Floquet multipliers are e^{sT}, T = 2 pi/omega. Unbalances, the rotor's own
    centrifugal forces and, with `weight`, gravity act. A spring at its first bearing holds it
    axially, a soft coupling at its end its rotation (see `constraints`).
    """
    bearings = supports_at(rotor, supports, omega)
    if not rotor.journals or not omega > 0:
        what = f"speed = {brief(omega)} rad/s, {len(rotor.journals)} bearings"
        raise SymbalanceError(what, "must be positive, with one bearing or more")
    whole = constrained_matrices(rotor, omega, rotor.journals[0], thrust_stiffness)
    stiffness = whole.stiffness.copy()
    for node, support in zip(rotor.journals, bearings, strict=True):
        for place in (DOF * node + 3, DOF * node + 4):
            stiffness[place, place] += support.tilt
    points = np.zeros((len(rotor.journals), 2, rotor.size))
    for j, node in enumerate(rotor.journals):
        points[j, :, DOF * node : DOF * node + 2] = np.eye(2)
    springs, dampers = (np.array([each.matrices[i] for each in bearings]) for i in (0, 1))
    film = Film(_constant(springs), _constant(dampers))
    force = _force(rotor, omega, unbalances or {}, weight)
    return PeriodicSystem(
        whole.mass, whole.damping, stiffness, points, film, None, force, omega, 2 * np.pi
    )


def _constant(table: Array) -> Callable[[Array], Array]:
    return lambda theta: np.broadcast_to(table, (len(theta), *table.shape)).copy()


def _force(rotor: Rotor, omega: float, unbalances: Unbalances, weight: bool) -> Callable[[Array], Array]:
    steady = rotor.centrifugal_force.copy()
    for node, amount in _unbalanced_nodes(rotor, unbalances):
        steady[DOF * node : DOF * node + 2] += [complex(amount).real, complex(amount).imag]
    fall = np.zeros((rotor.size, 2))
    fall[0::DOF, 0] = fall[1::DOF, 1] = -GRAVITY * weight
    pull = rotor.mass @ fall

    def force(theta: Array) -> Array:
        upward = np.swapaxes(rotation(theta), -1, -2)[..., 0]
        return omega**2 * steady + upward @ pull.T

    return force


def _unbalanced_nodes(rotor: Rotor, unbalances: Unbalances) -> list[tuple[int, complex]]:
    if not isinstance(unbalances, Mapping):
        remedy = "give {0.5: 1e-3}, kg m at a place in m"
        raise SymbalanceError(f"unbalances = {brief(unbalances)}", "must map places to amounts", remedy)
    nodes = []
    for place, amount in unbalances.items():
        node = int(np.argmin(np.abs(rotor.points[:, 2] - place)))
        if not abs(rotor.points[node, 2] - place) <= NEAR:
            rule = "must be that of a node, such as a disc or an element's end"
            raise SymbalanceError(f"place = {brief(place)} m", rule, "see Rotor.points")
        if not np.isfinite(amount):
            raise SymbalanceError(f"unbalance = {brief(amount)} kg m", "must be finite")
        nodes.append((node, complex(amount)))
    return nodes
