"""Derivation of a bearing's stiffness and damping in coordinates that turn with the crank.

The bearing lives in stationary axes: force on the shaft -K x - C x', x = (vertical, lateral). In turning
axes x = Q z with Q = R(omega t); the force's components there are those of Q^T. The numbers are those of
`symbalance.crankshaft.frames`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import sympy

from symbalance.crankshaft.equations.quantities import OMEGA, THETA

STIFFNESS = sympy.Matrix(2, 2, sympy.symbols("K_xx K_xy K_yx K_yy", real=True))
DAMPING = sympy.Matrix(2, 2, sympy.symbols("C_xx C_xy C_yx C_yy", real=True))
_BOTH = (STIFFNESS, DAMPING)


@dataclass(frozen=True)
class TurnedBearing:
    """-`stiffness` z - `damping` z' is the force in turning axes, z = (u, v).

    `circulatory` is the part of the stiffness that the damping brings, omega Q^T C Q S.
    """

    stiffness: sympy.ImmutableMatrix
    damping: sympy.ImmutableMatrix

    @property
    def circulatory(self) -> sympy.ImmutableMatrix:
        """The stiffness that is left where K = 0."""
        return self.stiffness.subs(dict.fromkeys(STIFFNESS.flat(), 0))

    def isotropic(self) -> TurnedBearing:
        """Return the bearing that is the same in all directions: K_xx = K_yy, nothing crossed.

        >>> turned_bearing().isotropic().stiffness.tolist()
        [[K_xx, -C_xx*omega], [C_xx*omega, K_xx]]
        """
        same = {matrix[1, 1]: matrix[0, 0] for matrix in _BOTH}
        none = {matrix[i, 1 - i]: 0 for matrix in _BOTH for i in (0, 1)}
        matrices = (matrix.subs({**same, **none}) for matrix in (self.stiffness, self.damping))
        return TurnedBearing(*(in_normal_form(matrix) for matrix in matrices))


def turned_bearing() -> TurnedBearing:
    """Derive a bearing's stiffness and damping in turning axes, for the angle theta and speed omega.

    >>> turned_bearing().damping.subs(THETA, 0).tolist()
    [[C_xx, C_xy], [C_yx, C_yy]]
    >>> turned_bearing().circulatory.subs(THETA, 0).tolist()
    [[C_xy*omega, -C_xx*omega], [C_yy*omega, -C_yx*omega]]
    """
    time = sympy.Symbol("t", real=True)
    place = sympy.Matrix([sympy.Function(name)(time) for name in "uv"])
    angle = OMEGA * time
    turn = sympy.Matrix([[sympy.cos(angle), -sympy.sin(angle)], [sympy.sin(angle), sympy.cos(angle)]])
    shift = turn * place
    force = turn.T * (STIFFNESS * shift + DAMPING * shift.diff(time))
    force = force.applyfunc(sympy.expand)
    matrices = (force.jacobian(place), force.jacobian(place.diff(time)))
    return TurnedBearing(*(in_normal_form(matrix.subs(time, THETA / OMEGA)) for matrix in matrices))


def in_normal_form(matrix: sympy.Matrix) -> sympy.ImmutableMatrix:
    """Return a matrix of polynomials in cos theta, sin theta without any sin^2: cos^2 + sin^2 = 1."""
    cosine, sine = sympy.symbols("c s")
    circle = sine**2 + cosine**2 - 1

    def reduce(entry: Any) -> Any:
        flat = entry.subs({sympy.cos(THETA): cosine, sympy.sin(THETA): sine})
        rest = sympy.expand(sympy.rem(sympy.expand(flat), circle, sine))
        return rest.subs({cosine: sympy.cos(THETA), sine: sympy.sin(THETA)})

    return sympy.ImmutableMatrix(matrix.applyfunc(reduce))
