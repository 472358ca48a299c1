"""Axisymmetric rotors in stationary axes, on supports of any kind: equations with constant matrices.

With x = T(theta) q, q in turning axes, T' = omega T S and S the quarter turn at every node, a rotor that
looks alike from all sides (M, K, C and G commute with T) obeys in stationary axes

    M x'' + (C + omega (G - 2 M S)) x' + (K - omega C S) x = F,

as dK - G S + M S S = 0 then: the rotor's damping C, which turns, brings a circulatory stiffness. Supports
stand still and may have cross terms, differ in two directions and depend on the speed. A rotor that is
not round has periodic coefficients on such supports: see `system_on_supports`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from numbers import Real

import numpy as np
from numpy.typing import ArrayLike

from symbalance.crankshaft.arguments import check_kind, check_number
from symbalance.crankshaft.arrays import DOF, Array
from symbalance.crankshaft.frames import QUARTER_TURN
from symbalance.crankshaft.rotor.matrices import Rotor, check_rotor
from symbalance.errors import SymbalanceError, brief, literal
from symbalance.text.measurements import as_float
from symbalance.text.numbers import as_list

ROUND = 1e-8
"""How far a matrix may be from commuting with a quarter turn, relative to its largest entry."""
LATERAL = (0, 1, 3, 4)
"""Places of u, v, theta_u, theta_v among a node's unknowns."""


@dataclass(frozen=True)
class Support:
    """The support of a bearing in stationary axes: `stiffness` in N/m and `damping` in N s/m.

    Each a number, alike in all directions; a pair, vertical and lateral; or (2, 2) with cross terms, the
    force's direction first: the shaft's force on the support per displacement and velocity. `tilt`
    (N m/rad) resists a turn of the shaft's direction, alike in both planes.

    >>> Support((1e6, 8e5), damping=100.0).stiffness
    array([[1000000.,       0.],
           [      0.,  800000.]])
    """

    stiffness: ArrayLike
    damping: ArrayLike = 0.0
    tilt: float = 0.0

    def __post_init__(self) -> None:
        for name in ("stiffness", "damping"):
            object.__setattr__(self, name, _square(getattr(self, name), f"support {name}"))
        check_number(self.tilt, "support tilt", "N m/rad")

    @property
    def matrices(self) -> tuple[Array, Array]:
        """Stiffness and damping, (2, 2) each."""
        return np.asarray(self.stiffness), np.asarray(self.damping)


Supports = Sequence[Support] | Callable[[float], Sequence[Support]]
"""One for each of the rotor's bearings, front to rear as given; or these as a function of rad/s."""


def _square(value: ArrayLike, name: str) -> Array:
    # Text would become a number here, and None nan.
    kind = np.asarray(value, dtype=object)
    if not all(isinstance(x, Real) and not isinstance(x, bool) for x in kind.ravel()):
        rule = "must be a finite number, a pair or (2, 2)"
        raise SymbalanceError(f"{name} = {literal(value)}", rule, "N/m, N s/m; vertical, lateral")
    table = np.asarray(value, dtype=float)
    if table.shape == ():
        table = float(table) * np.eye(2)
    elif table.shape == (2,):
        table = np.diag(table)
    if table.shape != (2, 2) or not np.isfinite(table).all():
        rule = "must be a finite number, a pair or (2, 2)"
        raise SymbalanceError(f"{name} of shape {table.shape}", rule, "N/m, N s/m; vertical, lateral")
    return table


@dataclass(frozen=True)
class StationaryRotor:
    """A round rotor's lateral matrices in stationary axes: x holds u, v, theta_u, theta_v of every node.

    Per rad/s the speed adds `gyroscopic` to the damping and takes `circulatory` from the stiffness.
    """

    rotor: Rotor
    mass: Array
    damping: Array
    stiffness: Array
    gyroscopic: Array
    circulatory: Array

    def at(self, supports: Supports, omega: float) -> tuple[Array, Array]:
        """Return damping and stiffness on these supports at a speed in rad/s."""
        damping = self.damping + omega * self.gyroscopic
        stiffness = self.stiffness - omega * self.circulatory
        for node, support in zip(
            self.rotor.journals, supports_at(self.rotor, supports, omega), strict=True
        ):
            here = slice(4 * node, 4 * node + 2)
            spring, damper = support.matrices
            stiffness[here, here] += spring
            damping[here, here] += damper
            for tilt in (4 * node + 2, 4 * node + 3):
                stiffness[tilt, tilt] += support.tilt
        return damping, stiffness


def number_of(value: object, name: str) -> float:
    """Return a number as a float, infinite or NaN too, for the caller to bound; refuse what is none."""
    return float(value) if isinstance(value, Real) else as_float(value, name)


def checked_rotor_speed(value: object) -> float:
    """Return a speed in rad/s, or refuse what is no finite number, or negative."""
    speed = number_of(value, "speed")
    if not 0 <= speed < np.inf:
        raise SymbalanceError(f"speed = {brief(value)} rad/s", "must be finite, not negative")
    return speed


def supports_at(rotor: Rotor, supports: Supports, omega: float) -> Sequence[Support]:
    """Return the supports at a speed; refuses another number than that of the rotor's bearings."""
    check_rotor(rotor)
    checked_rotor_speed(omega)
    answer = as_list(
        supports(omega) if callable(supports) else supports,
        "supports",
        "[sb.crankshaft.rotor.Support(1e6)] * 2",
    )
    for number, support in enumerate(answer, 1):
        check_kind(
            support,
            Support,
            f"support {number}",
            "sb.crankshaft.rotor.Support(stiffness, damping), N/m and N s/m",
        )
    if len(answer) != len(rotor.journals):
        what = f"{len(answer)} supports"
        raise SymbalanceError(what, f"must be one a bearing, {len(rotor.journals)}", "shaft(bearings=…)")
    return answer


def stationary_rotor(rotor: Rotor) -> StationaryRotor:
    """Return a round rotor's matrices in stationary axes; refuses a rotor that is not round."""
    check_rotor(rotor)
    turn = np.kron(np.eye(2 * len(rotor.points)), np.pad(QUARTER_TURN, (0, 1)))
    _check_round(rotor, turn)
    gyroscopic = rotor.gyroscopic - 2 * rotor.mass @ turn
    places = np.add.outer(DOF * np.arange(len(rotor.points)), LATERAL).ravel()
    lateral = np.ix_(places, places)
    parts = (rotor.mass, rotor.damping, rotor.stiffness, gyroscopic, rotor.damping @ turn)
    return StationaryRotor(rotor, *(part[lateral] for part in parts))


def _check_round(rotor: Rotor, turn: Array) -> None:
    for name in ("mass", "stiffness", "damping", "gyroscopic"):
        matrix = getattr(rotor, name)
        if np.abs(matrix @ turn - turn @ matrix).max() > ROUND * np.abs(matrix).max():
            rule = "must look alike from all sides in stationary axes"
            remedy = "system_on_supports and steady_state give its Floquet multipliers"
            raise SymbalanceError(f"the rotor's {name}", rule, remedy)
