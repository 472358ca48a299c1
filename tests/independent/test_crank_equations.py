"""The node's equations: against exact kinematics in mpmath, by their laws, beside the published ones."""

from __future__ import annotations

import json
import random
import re
from itertools import product

import numpy as np
import pytest
import sympy
from mpmath import mp

import symbalance as sb
from symbalance.crankshaft.equations import compare_with_published, node_equations, turned_bearing
from symbalance.crankshaft.equations.bearings import DAMPING, STIFFNESS
from symbalance.crankshaft.equations.node_document import entry_formula
from symbalance.crankshaft.equations.published import published_matrices
from symbalance.crankshaft.equations.quantities import OFFSET, OMEGA, PRODUCTS, THETA, TURN
from symbalance.crankshaft.equations.rotations import CARDAN, ROTATIONS
from symbalance.crankshaft.frames import (
    gravity,
    rotation,
    turned_damping,
    turned_stiffness,
    turned_vectors,
)
from symbalance.crankshaft.rotor.matrices import Rotor
from symbalance.crankshaft.rotor.rigid_bodies import node_force, node_matrices, skew_matrix
from symbalance.crankshaft.rotor.rigid_body_mode import deflated, spin_growth, spin_motion
from symbalance.document.sympy_writer import formula_sympy
from symbalance.errors import SymbalanceError
from tests import ROOT

NAMES = ("m", "U", "V", "W", "e_u", "e_v", "e_w", "I_uu", "I_vv", "I_ww", "I_uv", "I_uw", "I_vw")


def body(seed: int) -> dict[str, float]:
    rng = random.Random(seed)
    values = {name: rng.uniform(-1, 1) for name in NAMES}
    return values | {"m": rng.uniform(1, 3)} | {f"I_{x}{x}": rng.uniform(3, 6) for x in "uvw"}


def vectors(values: dict[str, float]) -> tuple[list[float], list[float], list[list[float]]]:
    uv, uw, vw = (values[name] for name in ("I_uv", "I_uw", "I_vw"))
    tensor = [[values["I_uu"], uv, uw], [uv, values["I_vv"], vw], [uw, vw, values["I_ww"]]]
    return [values[x] for x in "UVW"], [values[f"e_{x}"] for x in "uvw"], tensor


def at(matrix: sympy.ImmutableMatrix, values: dict[str, float]) -> np.ndarray:
    named = {symbol: values[str(symbol)] for symbol in matrix.free_symbols}
    return np.array(matrix.subs(named).evalf(30), dtype=float)


# --- an independent route: exact motion, differentiated numerically ---------------------------------


def skew(a):
    return mp.matrix([[0, -a[2], a[1]], [a[2], 0, -a[0]], [-a[1], a[0], 0]])


def axis_turn(axis: str, angle):
    vector = [mp.mpf(axis == x) * angle for x in "uvw"]
    return finite_turn(vector)


def finite_turn(vector):
    """Rodrigues' formula: exact for any angle."""
    angle = mp.sqrt(mp.fsum(x * x for x in vector))
    if angle == 0:
        return mp.eye(3)
    k = skew([x / angle for x in vector])
    return mp.eye(3) + mp.sin(angle) * k + (1 - mp.cos(angle)) * k * k


def attitude(kind: str, angles):
    if kind == "vector":
        return finite_turn(angles)
    one, two, three = (axis_turn(x, angles["uvw".index(x)]) for x in kind)
    return one * two * three


def axial(matrix):
    return mp.matrix([matrix[2, 1], matrix[0, 2], matrix[1, 0]])


def derivative(function, point=0):
    """Fourth-order differences, exact to twenty digits at this step and precision."""
    h = mp.mpf(10) ** -7
    near, far = (function(point + step) - function(point - step) for step in (h, 2 * h))
    return (8 * near - far) / (12 * h)


def generalised_load(kind, values, motion, omega, alpha):
    """Return the load that moves the body as it does at t = 0, from Newton and Euler alone."""
    place, offset, tensor = (mp.matrix(part) for part in vectors(values))

    def coordinates(t):
        return [q + t * dq + t * t * ddq / 2 for q, dq, ddq in zip(*motion, strict=True)]

    def frame(t):
        return axis_turn("w", omega * t + alpha * t * t / 2)

    def centre(t):
        q = coordinates(t)
        return frame(t) * (place + mp.matrix(q[:3]) + attitude(kind, q[3:]) * offset)

    def orientation(t):
        return frame(t) * attitude(kind, coordinates(t)[3:])

    def angular_momentum(t):
        now = orientation(t)
        spin = axial(derivative(orientation, t) * now.T)
        return now * tensor * now.T * spin

    force = values["m"] * derivative(lambda t: derivative(centre, t))
    angles = coordinates(0)[3:]
    now = attitude(kind, angles)
    moment = derivative(angular_momentum) + skew(now * offset) * force
    return [*force, *(along(kind, angles, i, now, moment) for i in range(3))]


def along(kind, angles, i, now, moment):
    """Return the moment's work on the coordinate i."""

    def moved(step):
        return attitude(kind, [a + step * (j == i) for j, a in enumerate(angles)])

    direction = axial(derivative(moved) * now.T)
    return mp.fsum(a * b for a, b in zip(direction, moment, strict=True))


@pytest.mark.slow
@pytest.mark.parametrize(("kind", "seed"), [("vector", 1), ("vector", 2), *((k, 3) for k in CARDAN)])
def test_the_equations_are_those_of_exact_motion(kind, seed):
    values, rng = body(seed), random.Random(seed + 100)
    omega, alpha = 1.7, 0.9
    q, dq, ddq = ([rng.uniform(-1, 1) for _ in range(6)] for _ in range(3))
    node = node_equations(kind)
    M, G, dK, H = (at(m, values) for m in (node.mass, node.gyroscopic, node.centrifugal, node.euler))
    rest = -(omega**2) * at(node.centrifugal_force, values) + alpha * at(node.euler_force, values)
    linear = M @ ddq + omega * G @ dq + (omega**2 * dK + alpha * H) @ q
    with mp.workdps(60):
        small = mp.mpf(10) ** -8
        loads = [
            generalised_load(
                kind, values, [[sign * small * x for x in xs] for xs in (q, dq, ddq)], omega, alpha
            )
            for sign in (1, -1)
        ]
        even = [float((a + b) / 2) for a, b in zip(*loads, strict=True)]
        odd = [float((a - b) / (2 * small)) for a, b in zip(*loads, strict=True)]
    np.testing.assert_allclose(even, rest.ravel(), rtol=1e-12, atol=1e-12)
    np.testing.assert_allclose(odd, linear, rtol=1e-12, atol=1e-12)


# --- laws -------------------------------------------------------------------------------------------


@pytest.mark.parametrize("kind", ROTATIONS)
def test_gyroscopic_is_skew_and_centrifugal_symmetric(kind):
    node = node_equations(kind)
    assert (node.gyroscopic + node.gyroscopic.T).expand().is_zero_matrix
    assert (node.centrifugal - node.centrifugal.T).expand().is_zero_matrix
    assert (node.mass - node.mass.T).expand().is_zero_matrix


@pytest.mark.spread(2)
@pytest.mark.parametrize("kind", CARDAN)
def test_coordinates_matter_only_where_a_couple_stands_at_rest(kind):
    """R_a R_b R_c has the rotation vector theta + (a x b theta_a theta_b + ...)/2: F_M's couple works."""
    vector, node = node_equations(), node_equations(kind)
    for name in ("mass", "gyroscopic", "centrifugal_force", "euler_force", "gravity_force"):
        assert getattr(vector, name) == getattr(node, name)
    couple = vector.centrifugal_force[3:, 0]
    second = sympy.zeros(3, 1)
    for i, j in ((0, 1), (0, 2), (1, 2)):
        a, b = ["uvw".index(kind[k]) for k in (i, j)]
        axes = sympy.eye(3)
        second += axes[:, a].cross(axes[:, b]) * TURN[a] * TURN[b] / 2
    work = (couple.T * second)[0]
    expected = -sympy.hessian(work, TURN)
    found = (node.centrifugal - vector.centrifugal)[3:, 3:]
    assert (found - expected).expand().is_zero_matrix
    assert not expected.is_zero_matrix
    assert node.principal().centrifugal == vector.principal().centrifugal


def test_a_paper_node_has_every_entry_of_the_published_equation():
    for kind in ROTATIONS:
        entries = list(compare_with_published(node_equations(kind).principal()))
        assert len(entries) == 114
        assert {entry.verdict for entry in entries} == {"holds"}


def test_a_general_node_has_entries_that_the_published_equation_lacks():
    entries = {(e.matrix, e.row, e.column): e for e in compare_with_published(node_equations())}
    assert entries["mass", 3, 4].verdict == "missing"
    assert entries["centrifugal_force", 0, 0].verdict == "differs"
    without_offset = compare_with_published(node_equations().with_values(**{str(e): 0 for e in OFFSET}))
    lacking = {
        (e.matrix, e.row, e.column) for e in without_offset if e.verdict != "holds" and e.row <= e.column
    }
    pairs = {(3, 4), (3, 5), (4, 5)}
    assert {p[1:] for p in lacking if p[0] == "mass"} == pairs
    assert {p[1:] for p in lacking if p[0] == "gyroscopic"} == {(3, 5), (4, 5)}
    assert {p[1:] for p in lacking if p[0] == "centrifugal"} == pairs


@pytest.mark.slow
def test_an_uneven_throw_needs_the_product_of_inertia():
    """A body with I_uv = 0 has one when it is turned by 120 degrees about W."""
    tensor = sympy.diag(1, 2, 3)
    turn = sympy.rot_ccw_axis3(sympy.pi * 2 / 3)
    rotated = turn * tensor * turn.T
    assert rotated[0, 1] == sympy.sqrt(3) / 4
    node = node_equations()
    values = {
        "I_uu": rotated[0, 0],
        "I_vv": rotated[1, 1],
        "I_uv": rotated[0, 1],
        "I_ww": 3,
        "I_uw": 0,
        "I_vw": 0,
    }
    straight = {"I_uu": 1, "I_vv": 2, "I_uv": 0, "I_ww": 3, "I_uw": 0, "I_vw": 0}
    none = dict.fromkeys(("e_u", "e_v", "e_w", "U", "V"), 0)
    both = sympy.diag(turn, turn)
    for name in ("mass", "gyroscopic", "centrifugal"):
        there, here = (getattr(node.with_values(**none, **v), name) for v in (values, straight))
        assert (there - both * here * both.T).expand().is_zero_matrix, name


# --- numbers ----------------------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(5))
def test_the_functions_are_the_symbolic_forms(seed):
    values = body(seed)
    point, offset, tensor = vectors(values)
    node = node_equations()
    found = (
        *node_matrices(values["m"], offset, tensor, point),
        node_force(values["m"], point, offset, tensor),
    )
    derived = (node.mass, node.gyroscopic, node.centrifugal, node.centrifugal_force)
    for number, symbolic in zip(found, derived, strict=True):
        np.testing.assert_allclose(number, at(symbolic, values).reshape(number.shape), atol=1e-14)


def test_a_node_may_be_described_from_elsewhere_on_the_body():
    """M and G are carried by the rigid arm alone; dK also by the force whose arm turns."""
    mass, offset, tensor = 2.5, np.array([0.03, -0.02, 0.05]), np.diag([3.0, 4.0, 6.0])
    point = np.array([0.2, -0.4, 0.7])
    arm = np.eye(6)
    arm[:3, 3:] = -skew_matrix(offset)
    there = node_matrices(mass, np.zeros(3), tensor)
    here = node_matrices(mass, offset, tensor, point)
    for far, near in zip(there[:2], here[:2], strict=True):
        np.testing.assert_allclose(near, arm.T @ far @ arm, atol=1e-14)
    force = mass * np.diag([1, 1, 0]) @ (point + offset)
    expected = np.zeros((6, 6))
    expected[3:, 3:] = (
        force @ offset * np.eye(3) - (np.outer(force, offset) + np.outer(offset, force)) / 2
    )
    np.testing.assert_allclose(here[2] - arm.T @ there[2] @ arm, expected, atol=1e-14)
    far_force = node_force(mass, point + offset, np.zeros(3), tensor)
    np.testing.assert_allclose(node_force(mass, point, offset, tensor), arm.T @ far_force, atol=1e-14)


def test_gravity_is_what_a_shift_of_the_whole_would_carry():
    """F_g = M (g, 0): so the assembled load is M times (g, 0, g, 0, ...)."""
    values = body(7)
    node = node_equations()
    for angle in (0.0, 0.4, 2.1):
        per_g = at(node.gravity_force.subs(THETA, angle), values).ravel()
        carried = at(node.mass, values) @ np.concatenate([gravity(angle), np.zeros(3)])
        np.testing.assert_allclose(carried, 9.80665 * per_g, atol=1e-14)


def test_gravity_points_down_at_every_angle():
    for angle in np.linspace(0, 7, 9):
        down = rotation(angle) @ gravity(angle)[:2]
        np.testing.assert_allclose(down, [-9.80665, 0], atol=1e-14)


# --- bearings ---------------------------------------------------------------------------------------

K = np.array([[12.808, 16.394], [-25.060, 8.8153]])
C = np.array([[0.2329, -0.081924], [-0.081924, 0.29491]])


@pytest.mark.slow
def test_the_turned_bearing_is_the_symbolic_one():
    rotated = turned_bearing()
    values = dict(zip([*STIFFNESS, *DAMPING], [*K.ravel(), *C.ravel()], strict=True)) | {OMEGA: 157.0}
    angles = np.array([0.0, 0.3, 1.9, 4.4])
    for angle, stiffness, damping in zip(
        angles, turned_stiffness(K, C, angles, 157.0), turned_damping(C, angles), strict=True
    ):
        there = {**values, THETA: angle}
        np.testing.assert_allclose(
            stiffness, np.array(rotated.stiffness.subs(there), dtype=float), atol=1e-12
        )
        np.testing.assert_allclose(
            damping, np.array(rotated.damping.subs(there), dtype=float), atol=1e-12
        )


def test_the_turned_bearing_gives_the_stationary_force():
    """A journal on any path: the force by stationary coefficients, and by turning ones, are one force."""
    omega, h = 157.0, 1e-6

    def turning(t):
        return np.array([np.cos(300 * t), 0.4 * np.sin(500 * t + 1)])

    def stationary(t):
        return rotation(omega * t) @ turning(t)

    for t in (0.0, 0.004, 0.011):
        x, z = stationary(t), turning(t)
        dx, dz = ((f(t + h) - f(t - h)) / (2 * h) for f in (stationary, turning))
        theta = omega * t
        force = turned_stiffness(K, C, theta, omega) @ z + turned_damping(C, theta) @ dz
        np.testing.assert_allclose(rotation(theta) @ force, K @ x + C @ dx, rtol=1e-6)
        np.testing.assert_allclose(turned_vectors(K @ x + C @ dx, theta), force, rtol=1e-6)


@pytest.mark.slow
def test_isotropic_damping_circulates():
    rotated = turned_bearing().isotropic()
    assert rotated.circulatory == sympy.Matrix([[0, -OMEGA * DAMPING[0]], [OMEGA * DAMPING[0], 0]])


def test_turned_shapes():
    angles = np.linspace(0, 1, 5)
    for shape in ((2, 2), (3, 2, 2), (5, 3, 2, 2)):
        expected = (5, 3, 2, 2) if len(shape) > 2 else (5, 2, 2)
        assert turned_stiffness(np.ones(shape), np.ones(shape), angles, 3.0).shape == expected


# --- the free spin ----------------------------------------------------------------------------------


def test_the_spin_is_the_turn_of_the_whole():
    points = np.random.default_rng(2).uniform(-1, 1, (5, 3))
    small = 1e-7
    moved = points.copy()
    moved[:, :2] = points[:, :2] @ rotation(small).T
    spin = spin_motion(points).reshape(5, 6)
    np.testing.assert_allclose(spin[:, :3], (moved - points) / small, atol=1e-6)
    np.testing.assert_array_equal(spin[:, 3:], np.tile([0, 0, 1], (5, 1)))
    empty = np.zeros((30, 30))
    rotor = Rotor(points, *[empty] * 5, centrifugal_force=np.zeros(30), journals=(), pins=())
    np.testing.assert_array_equal(rotor.rigid_motions()[:, 5], spin_motion(points))


def lumps(seed: int) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return points and the assembled M, G, dK of a few general bodies."""
    rng = np.random.default_rng(seed)
    points = rng.uniform(-0.1, 0.1, (4, 3))
    M, G, dK = (np.zeros((24, 24)) for _ in range(3))
    for i, point in enumerate(points):
        tensor = np.diag(rng.uniform(0.01, 0.02, 3)) + 0.002 * (1 - np.eye(3))
        here = slice(6 * i, 6 * i + 6)
        M[here, here], G[here, here], dK[here, here] = node_matrices(
            rng.uniform(1, 2), rng.uniform(-0.02, 0.02, 3), tensor, point
        )
    return points, M, G, dK


def test_the_free_spin_is_falsely_unstable_until_deflated():
    points, M, G, dK = lumps(4)
    spin = spin_motion(points)
    assert abs(spin @ G @ spin) < 1e-15
    growth = spin_growth(dK, M, spin)
    assert growth > 0.1
    flat = deflated(dK, M, spin)
    np.testing.assert_allclose(flat, flat.T, atol=1e-16)
    np.testing.assert_allclose(flat @ spin, 0, atol=1e-15)
    assert spin_growth(flat, M, spin) < 1e-7
    rng = np.random.default_rng(1)
    motions = rng.normal(size=(24, 3))
    motions -= np.outer(spin, (M @ spin) @ motions) / (spin @ M @ spin)
    np.testing.assert_allclose(motions.T @ flat @ motions, motions.T @ dK @ motions, atol=1e-14)


def test_a_stiff_rotor_diverges_at_the_rate_stated():
    """Two masses on a stiff bar, held but for the spin: s^2 = omega^2 sum m r^2/J."""
    points = np.array([[0.06, 0.0, 0.0], [-0.06, 0.0, 0.1]])
    M, dK = np.zeros((12, 12)), np.zeros((12, 12))
    for i, point in enumerate(points):
        here = slice(6 * i, 6 * i + 6)
        M[here, here], _, dK[here, here] = node_matrices(
            2.0, np.zeros(3), np.diag([1e-3, 1e-3, 2e-2]), point
        )
    spin = spin_motion(points)
    J = 2 * (2.0 * 0.06**2 + 2e-2)
    assert spin @ M @ spin == pytest.approx(J)
    assert spin_growth(dK, M, spin) == pytest.approx(np.sqrt(2 * 2.0 * 0.06**2 / J))


# --- the page, the faults ---------------------------------------------------------------------------


@pytest.mark.slow
def test_the_page_is_as_it_was_and_compiles(golden, compile_latex):
    golden("crank-node.tex", sb.to_latex(node_equations()))
    compile_latex(sb.to_latex(node_equations(), standalone=True))
    compile_latex(sb.to_latex(node_equations("vuw").principal(), standalone=True))


def test_data_and_records_read_back_as_the_matrices():
    node = node_equations("uvw")
    known = {str(symbol): symbol for symbol in node.symbols}
    data = json.loads(sb.to_json(node))
    for name, matrix in node.parts().items():
        read = [[sympy.sympify(cell, locals=known) for cell in row] for row in data[name]]
        assert (sympy.Matrix(read) - matrix).expand().is_zero_matrix
    filled = sum(sympy.expand(cell) != 0 for matrix in node.parts().values() for cell in matrix)
    assert len(node.records()) == filled


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["vector", "wvu"])
def test_printed_entries_are_the_derived_ones(kind):
    """Every entry of every matrix, as written, is that matrix's: values in both are one number."""
    node = node_equations(kind)
    known = {str(symbol): symbol for symbol in node.symbols}
    for matrix in node.parts().values():
        for cell in matrix:
            printed = formula_sympy(entry_formula(cell))
            same = {symbol: known[symbol.name] for symbol in printed.free_symbols}
            assert sympy.expand(printed.subs(same, simultaneous=True) - cell) == 0


def test_unknown_coordinates_and_a_massless_spin_are_refused():
    with pytest.raises(SymbalanceError, match="rotation = xyz: is unknown"):
        node_equations("xyz")
    with pytest.raises(SymbalanceError, match="moment of inertia"):
        deflated(np.eye(6), np.zeros((6, 6)), spin_motion([[0, 0, 0]]))


def test_every_product_of_inertia_enters():
    node = node_equations()
    for symbol, name in product(PRODUCTS, ("mass", "centrifugal")):
        assert symbol in getattr(node, name).free_symbols


def read_cell(cell: str) -> sympy.Expr:
    """Return a matrix's printed entry: signed sums of M, MU, MV and I_u, I_v, I_w."""
    names = {"M": "m", "MU": "m U", "MV": "m V", "I_u": "I_uu", "I_v": "I_vv", "I_w": "I_ww"}
    known = {str(s): s for s in node_equations().symbols}
    total = sympy.S.Zero
    for sign, number, letters in re.findall(r"(-?)\s*(\d*)(M[UV]?|I_[uvw])", cell):
        factors = [known[name] for name in names[letters].split()]
        total += sympy.prod(factors) * int(f"{sign}{number or 1}")
    return total


def test_the_published_matrices_are_those_quoted():
    """The derivation quotes the paper's lines; what is compared against is what stands there."""
    page = ROOT / "derivations" / "crankshaft-equations.md"
    lines = re.findall(r"^004:(?:89|90|91|92)  (.*)$", page.read_text("utf-8"), re.MULTILINE)
    found = [re.findall(r"begin\{bmatrix\}(.*?)\\end", line) for line in lines]
    quoted = [matrices[i] for matrices, i in zip(found, (0, 0, 0, 1), strict=True)]
    for matrix, text in zip(published_matrices().values(), quoted, strict=True):
        rows = [[read_cell(cell) for cell in row.split("&")] for row in text.split(r"\\")]
        assert matrix == sympy.ImmutableMatrix(rows)


def test_the_products_of_vectors_are_those_of_geometry():
    """Orthogonal to both, of the area's square, and back again: a x (b x c) = b (a c) - c (a b)."""
    from symbalance.crankshaft.equations import quantities as ring

    a, b, c = (
        ring.ring_elements(x) for x in (ring.PLACE, ring.MOMENTS, ring.PRODUCTS)
    )  # none of them small
    product = ring.vector_product(a, b)
    assert ring.scalar_product(a, product) == ring.scalar_product(b, product) == 0
    area = ring.scalar_product(a, a) * ring.scalar_product(b, b) - ring.scalar_product(a, b) ** 2
    assert ring.scalar_product(product, product) == area
    assert product[2].as_expr() == ring.PLACE[0] * ring.MOMENTS[1] - ring.PLACE[1] * ring.MOMENTS[0]
    twice = ring.vector_product(a, ring.vector_product(b, c))
    expected = [
        y * ring.scalar_product(a, c) - z * ring.scalar_product(a, b) for y, z in zip(b, c, strict=True)
    ]
    assert twice == expected
    rows = [a, b, c]
    assert ring.matrix_times_vector(ring.transpose(rows), a) == [
        row[0] for row in ring.matrix_product(ring.transpose(rows), [[x] for x in a])
    ]


@pytest.mark.slow
def test_the_printed_energy_is_the_one_whose_lagrange_equations_these_are():
    """d/dt dE/dp - dE/dq = M p' + w (B - B^T) p + w^2 dK q - w^2 F_M, term by term of what is printed."""
    text = sb.to_text(node_equations("vector"))
    assert "E = ½p^T M p + ω (p^T B q + c^T p) + ω² (F_M^T q − ½q^T ΔK q)" in text
    assert "G = B − B^T is skew" in text
