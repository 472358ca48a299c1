"""Derivation of the linear equations of a rigid body at a node, in axes that turn with the crank.

The kinetic energy of a body of mass m, tensor I about its mass centre, in axes that turn at omega:

    T = m v.v/2 + Omega.I Omega/2,   v = r' + omega w x r,   r = (U, V, W) + (u, v, w) + A e,
    Omega = A^T omega w + (axis of A^T A'),   A a rotation by small theta_u, theta_v, theta_w.

Through the second order in the coordinates q and their rates it is, with powers of omega apart,

    T = q'.M q'/2 + omega (q'.B q + c.q') + omega^2 (b.q + q.N q/2) + ...

and Lagrange's equations for a speed that may vary (alpha = omega') are

    M q'' + omega (B - B^T) q' + (-omega^2 N + alpha B) q = F + omega^2 b - alpha c.

Hence G = B - B^T is skew and dK = -N symmetric whatever the body and the coordinates. In a rotation
vector the moment of F is that about the node, N in turning axes, less theta x N/2; the difference is of
the first order only where N stands at rest. Gravity acts along -X.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cache
from itertools import permutations
from typing import TYPE_CHECKING, Any, ClassVar

import sympy

from symbalance.crankshaft.equations.quantities import (
    COORDINATES,
    MOVING,
    OFFSET,
    OMEGA,
    PLACE,
    PRODUCTS,
    RING,
    SHIFT,
    THETA,
    M,
    RingElement,
    RingMatrix,
    RingVector,
    inertia_rows,
    matrix_product,
    matrix_times_vector,
    ring_element,
    ring_elements,
    scalar_product,
    time_derivative,
    transpose,
    vector_product,
)
from symbalance.crankshaft.equations.rotations import rotation_rows
from symbalance.document.result import Result

if TYPE_CHECKING:
    from symbalance.document.nodes import Document

SymbolMatrix = sympy.ImmutableMatrix
_SIZE = len(COORDINATES)


@dataclass(frozen=True, repr=False)
class NodeEquations(Result):
    """Linear equations of motion of a rigid body at a crankshaft's node, as symbolic matrices.

    M q'' + omega G q' + (omega^2 dK + alpha H) q = F + omega^2 F_M - alpha c + g F_g.

    6 x 6 `mass`, `gyroscopic`, `centrifugal`, `euler` and 6 x 1 `centrifugal_force`, `euler_force` (c),
    `gravity_force` (F_g), in u, v, w, theta_u, theta_v, theta_w and the symbols of `quantities`.
    """

    rotation: str
    mass: sympy.ImmutableMatrix
    gyroscopic: sympy.ImmutableMatrix
    centrifugal: sympy.ImmutableMatrix
    euler: sympy.ImmutableMatrix
    centrifugal_force: sympy.ImmutableMatrix
    euler_force: sympy.ImmutableMatrix
    gravity_force: sympy.ImmutableMatrix

    kind: ClassVar[str] = "crank-node"

    def summary(self) -> str:
        """Return the coordinates and the symbols, in one line."""
        symbols = ", ".join(sorted(str(symbol) for symbol in self.symbols))
        return f"Equations of a crankshaft's node in {self.coordinates}: of {symbols}"

    def document(self) -> Document:
        """Return the equations, their matrices, the published ones beside them, and a bearing's."""
        from symbalance.crankshaft.equations.node_document import node_document

        return node_document(self)

    def data(self) -> dict[str, Any]:
        """Return every matrix as rows of strings that SymPy reads."""
        rows = {name: matrix.tolist() for name, matrix in self.parts().items()}
        texts = {
            name: [[str(sympy.expand(cell)) for cell in row] for row in m] for name, m in rows.items()
        }
        return {"rotation": self.rotation, "coordinates": [str(q) for q in COORDINATES], **texts}

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each entry that is not zero: its matrix, row and column from 1, its text."""
        return [
            {"matrix": name, "row": i + 1, "column": j + 1, "entry": str(entry)}
            for name, matrix in self.parts().items()
            for i in range(matrix.rows)
            for j in range(matrix.cols)
            if (entry := sympy.expand(matrix[i, j])) != 0
        ]

    @property
    def coordinates(self) -> str:
        """What the turns are: "a rotation vector", "Cardan angles uvw"."""
        return "a rotation vector" if self.rotation == "vector" else f"Cardan angles {self.rotation}"

    def with_values(self, **values: object) -> NodeEquations:
        """Return the equations with symbols replaced, by name.

        >>> node_equations().with_values(e_u=0, e_v=0, e_w=0).centrifugal_force.T
        Matrix([[U*m, V*m, 0, I_vw, -I_uw, 0]])
        """
        by_name = {str(symbol): symbol for symbol in self.symbols}
        substitutions = {
            by_name[name]: sympy.sympify(value) for name, value in values.items() if name in by_name
        }
        return replace(
            self, **{name: matrix.subs(substitutions) for name, matrix in self.parts().items()}
        )

    def principal(self) -> NodeEquations:
        """Return the equations of the paper's node: mass centre at the node, principal axes U, V, W."""
        return self.with_values(**{str(symbol): 0 for symbol in (*OFFSET, *PRODUCTS)})

    def parts(self) -> dict[str, sympy.ImmutableMatrix]:
        """Return the matrices and vectors by name."""
        return {name: value for name, value in vars(self).items() if name != "rotation"}

    @property
    def symbols(self) -> set[sympy.Symbol]:
        """The symbols the equations hold."""
        return set().union(*(matrix.free_symbols for matrix in self.parts().values()))


@cache
def node_equations(rotation: str = "vector") -> NodeEquations:
    """Derive the equations of a general node; `rotation` is "vector" or a Cardan order such as "uvw".

    >>> node_equations().principal().gyroscopic[3, 4]
    -I_uu - I_vv + I_ww
    >>> node_equations().centrifugal[5, 5]
    U*e_u*m + V*e_v*m
    """
    attitude = rotation_rows(rotation)
    centre = _mass_centre(attitude)
    linear, quadratic = _coefficients(_kinetic_energy(centre, attitude))
    B = _matrix(quadratic[1], rows=_SIZE)
    return NodeEquations(
        rotation=rotation,
        mass=_matrix(quadratic[0], rows=_SIZE, columns=_SIZE),
        gyroscopic=B - B.T,
        centrifugal=-_matrix(quadratic[2]),
        euler=B,
        centrifugal_force=_column(linear[2]),
        euler_force=_column(linear[1], rows=_SIZE),
        gravity_force=_gravity(centre),
    )


def _mass_centre(attitude: RingMatrix) -> RingVector:
    """Return the place of the mass centre in turning axes, (U, V, W) + (u, v, w) + A e."""
    arm = matrix_times_vector(attitude, ring_elements(OFFSET))
    return [p + d + a for p, d, a in zip(ring_elements(PLACE), ring_elements(SHIFT), arm, strict=True)]


def _kinetic_energy(centre: RingVector, attitude: RingMatrix) -> RingElement:
    """Return the kinetic energy through the second order in coordinates and rates."""
    axis = [RING.zero, RING.zero, RING.one]
    transport = vector_product(axis, centre)
    omega = ring_element(OMEGA)
    velocity = [time_derivative(r) + omega * c for r, c in zip(centre, transport, strict=True)]
    body_axes = transpose(attitude)
    turning = matrix_product(body_axes, [[time_derivative(cell) for cell in row] for row in attitude])
    own = [turning[2][1], turning[0][2], turning[1][0]]
    spin = [omega * a + o for a, o in zip(matrix_times_vector(body_axes, axis), own, strict=True)]
    return (
        ring_element(M) * scalar_product(velocity, velocity)
        + scalar_product(spin, matrix_times_vector(inertia_rows(), spin))
    ) / 2


DerivativeTables = list[dict[tuple[int, ...], sympy.Expr]]


def _coefficients(energy: RingElement) -> tuple[DerivativeTables, DerivativeTables]:
    """Return the first and the second derivatives at rest, a table for each power of omega."""
    tables: dict[int, DerivativeTables] = {1: [{}, {}, {}], 2: [{}, {}, {}]}
    for powers, number in energy.terms():
        moving, power = powers[:MOVING], powers[MOVING]
        places = tuple(i for i, n in enumerate(moving) for _ in range(n))
        if not places:
            continue
        weight = RING.from_dict({(0,) * (MOVING + 1) + powers[MOVING + 1 :]: number}).as_expr()
        for order in set(permutations(places)):
            table = tables[len(places)][power]
            twice = 2 if len(set(places)) < len(places) else 1
            table[order] = table.get(order, sympy.S.Zero) + twice * weight
    return tables[1], tables[2]


def _matrix(table: dict[tuple[int, ...], sympy.Expr], rows: int = 0, columns: int = 0) -> SymbolMatrix:
    """Return six rows and columns of second derivatives, from this row and column on."""
    return SymbolMatrix(_SIZE, _SIZE, lambda i, j: table.get((rows + i, columns + j), 0))


def _column(table: dict[tuple[int, ...], sympy.Expr], rows: int = 0) -> SymbolMatrix:
    """Return six first derivatives, from this row on."""
    return SymbolMatrix(_SIZE, 1, lambda i, _: table.get((rows + i,), 0))


def _gravity(centre: RingVector) -> SymbolMatrix:
    """Return the force of gravity per g: the X of the mass centre is r_u cos theta - r_v sin theta."""
    along, across = (_coefficients(ring_element(M) * r)[0][0] for r in centre[:2])
    down = -sympy.cos(THETA), sympy.sin(THETA)
    u, v = _column(along), _column(across)
    return SymbolMatrix(_SIZE, 1, lambda i, _: down[0] * u[i] + down[1] * v[i])
