"""A node's equations as text: every entry that is not zero, named by its row and column."""

from __future__ import annotations

from collections.abc import Iterator

import sympy

from symbalance.crankshaft.equations.node import NodeEquations

_STATEMENT = """A node of the turning crankshaft
  M q'' + omega G q' + (omega^2 dK + alpha B) q = F + omega^2 F_M - alpha c + g F_g
  q = (u, v, w, theta_u, theta_v, theta_w), in axes that turn about W at omega; alpha = omega'
  m: mass at the node (U, V, W); e: mass centre from the node; I: inertia about the mass centre,
  I_uv = -(integral of u v dm); theta in F_g: the crank angle, gravity pulls down
"""
_NAMES = {
    "mass": ("M", "symmetric"),
    "gyroscopic": ("G", "skew"),
    "centrifugal": ("dK", "symmetric"),
    "euler": ("B", "whole"),
    "centrifugal_force": ("F_M", "whole"),
    "euler_force": ("c", "whole"),
    "gravity_force": ("F_g", "whole"),
}


def equations_text(equations: NodeEquations) -> str:
    """Return the equations as text: of a symmetric or skew matrix the upper entries.

    >>> from symbalance.crankshaft.equations.node import node_equations
    >>> lines = equations_text(node_equations().principal()).splitlines()
    >>> [line for line in lines if line.startswith("  G[")]
    ['  G[1,2] = -2*m', '  G[4,5] = -I_uu - I_vv + I_ww']
    """
    parts = (_entries(name, matrix) for name, matrix in equations.parts().items())
    turn = "rotation vector" if equations.rotation == "vector" else f"Cardan angles {equations.rotation}"
    lines = [f"  theta_u, theta_v, theta_w: {turn}", *(line for part in parts for line in part)]
    return _STATEMENT + "\n".join(lines) + "\n"


def _entries(name: str, matrix: sympy.ImmutableMatrix) -> Iterator[str]:
    short, kind = _NAMES[name]
    yield f"\n{short}" + {"symmetric": ", symmetric", "skew": ", skew", "whole": ""}[kind]
    for i in range(matrix.rows):
        for j in range(matrix.cols):
            value = sympy.expand(matrix[i, j])
            if value != 0 and (kind == "whole" or i <= j):
                place = f"{i + 1}" if matrix.cols == 1 else f"{i + 1},{j + 1}"
                yield f"  {short}[{place}] = {value}"
