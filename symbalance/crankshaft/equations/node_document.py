"""The document of a node's equations: their matrices, beside the published ones, and a bearing's."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import sympy

from symbalance.crankshaft.equations.bearings import turned_bearing
from symbalance.crankshaft.equations.published import HOLDS, PublishedEntry, compare_with_published
from symbalance.crankshaft.equations.quantities import COORDINATES, OFFSET, PLACE, THETA, M
from symbalance.document.expressions import formula_of
from symbalance.document.formula import (
    Derivative,
    Equation,
    Formula,
    Matrix,
    Name,
    Negative,
    Power,
    Product,
    Subscript,
    equal,
    number,
)
from symbalance.document.nodes import (
    Block,
    Column,
    Document,
    Facts,
    Formulas,
    Heading,
    Inline,
    Paragraph,
    Table,
    Words,
    blocks,
)
from symbalance.document.text_writer import formula_text

if TYPE_CHECKING:
    from symbalance.crankshaft.equations.node import NodeEquations

WIDEST = 62
"""Characters of a matrix's row, as text: a wider one is written entry by entry."""
_ROWS, _HALF = 3, number(Fraction(1, 2))
_G, _B, _DK, _H, _F_M, _C, _F_G = map(Name, ("G", "B", "Delta K", "H", "F_M", "c", "F_g"))
_MASS, _Q, _T, _E, _P = map(Name, ("M", "q", "t", "E", "p"))
_OMEGA, _ALPHA, _LOAD, _GRAVITY = map(Name, ("omega", "alpha", "F", "g"))
_X, _Y = Name("X"), Name("Y")
_LETTERS = {"mass": _MASS, "gyroscopic": _G, "centrifugal": _DK, "centrifugal_force": _F_M}
_SOURCE = (
    "J. Mizuhaya, I. Honda, K. Ota, H. Shimokouchi, T. Tsubota, Analysis of Dynamic Stress of Engine "
    "Crankshaft in Operating Condition (Mitsubishi Heavy Industries)"
)


def node_document(equations: NodeEquations) -> Document:
    """Return a node's equations as a document."""
    return Document(
        "A node of the turning crankshaft",
        blocks(
            Formulas((_motion(),)),
            Heading("Matrices"),
            Paragraph("In blocks of three rows and columns, shifts before turns:"),
            _blocks_of(_MASS, equations.mass, 1),
            _blocks_of(_G, equations.gyroscopic, -1),
            _blocks_of(_DK, equations.centrifugal, 1),
            Paragraph((_B, " is half of ", _G, " and a symmetric part ", _H, ":")),
            Formulas((equal(_B, _HALF * _G + _H),)),
            _blocks_of(_H, (equations.euler + equations.euler.T) / 2, 1),
            Heading("Forces"),
            _forces(equations),
            _comparison(equations),
            _bearing(),
            _derivation(),
            _how_to_read(equations),
        ),
    )


def _motion() -> Equation:
    """Return the equations of motion in matrices."""
    acceleration, rate = Derivative(_Q, _T, 2), Derivative(_Q, _T)
    inertia = _MASS * acceleration + _OMEGA * _G * rate + (_OMEGA**2 * _DK + _ALPHA * _B) * _Q
    return equal(inertia, _LOAD + _OMEGA**2 * _F_M - _ALPHA * _C + _GRAVITY * _F_G)


def entry_formula(value: Any) -> Formula:
    """Return an entry, what the mass multiplies collected.

    >>> from symbalance.crankshaft.equations.node import node_equations
    >>> formula_text(entry_formula(node_equations().mass[4, 4]))
    'Iᵥᵥ + m (eᵤ² + e_w²)'
    """
    flat = sympy.expand(value)
    by_mass = flat.coeff(M, 1)
    rest = sympy.expand(flat - M * by_mass)
    if by_mass == 0:
        return formula_of(flat)
    terms = sympy.Add.make_args(by_mass)
    sign = -1 if all(term.could_extract_minus_sign() for term in terms) else 1
    mass = _times_mass(sympy.expand(sign * by_mass))
    if rest == 0:
        return mass if sign > 0 else Negative(mass)
    return formula_of(rest) + mass if sign > 0 else formula_of(rest) - mass


def _times_mass(factor: Any) -> Formula:
    """Return the mass times a factor, a number before it and a denominator below all."""
    above, below = sympy.fraction(sympy.together(factor))
    size, rest = sympy.expand(above).as_coeff_Mul()
    product: Formula = Name("m") if rest == 1 else Name("m") * formula_of(rest)
    if size != 1:
        product = number(int(size)) * product
    return product if below == 1 else product / number(int(below))


def _matrix(matrix: Any) -> Matrix:
    return Matrix(tuple(tuple(map(entry_formula, row)) for row in matrix.tolist()))


def _is_wide(matrix: Matrix) -> bool:
    columns = zip(*matrix.rows, strict=True)
    return sum(max(len(formula_text(cell)) for cell in column) + 2 for column in columns) > WIDEST


def _blocks_of(name: Name, matrix: Any, sign: int) -> tuple[Block, ...]:
    """Return a matrix as its blocks: shift, coupling X, turn Y; the fourth follows by symmetry.

    `sign` is +1 for a symmetric matrix, -1 for a skew one.
    """
    shift, coupling, turn = matrix[:_ROWS, :_ROWS], matrix[:_ROWS, _ROWS:], matrix[_ROWS:, _ROWS:]
    zero = number(0)
    corner: Formula = zero if shift.is_zero_matrix else Name("S")
    beside: Formula = zero if coupling.is_zero_matrix else _X
    below: Formula = zero if coupling.is_zero_matrix else Power(_X, Name("T"))
    below = Negative(below) if sign < 0 and not coupling.is_zero_matrix else below
    blocks_by_letter = [(Name("S"), shift), (_X, coupling)]
    equations = [equal(name, Matrix(((corner, beside), (below, _Y))))]
    equations += [
        equal(letter, _matrix(block)) for letter, block in blocks_by_letter if not block.is_zero_matrix
    ]
    whole = _matrix(turn)
    if not _is_wide(whole):
        return (Formulas((*equations, equal(_Y, whole))),)
    kind = "symmetric" if sign > 0 else "skew"
    sentence = Paragraph(
        (_Y, f" is {kind}; its entries, numbered as those of ", name, ", from the diagonal up:")
    )
    return (Formulas(tuple(equations)), sentence, Formulas(tuple(_entries(name, turn))))


def _entries(name: Name, turn: Any) -> Iterator[Equation]:
    """Yield the entries of a block of turns, on and above the diagonal, that are not zero."""
    for i in range(_ROWS):
        for j in range(i, _ROWS):
            if sympy.expand(turn[i, j]) != 0:
                yield equal(_entry_name(name, i + _ROWS, j + _ROWS), entry_formula(turn[i, j]))


def _entry_name(name: Name, *places: int) -> Formula:
    return Subscript(name, number(int("".join(str(place + 1) for place in places))))


def _forces(equations: NodeEquations) -> Formulas:
    pairs = (
        (_F_M, equations.centrifugal_force),
        (_C, equations.euler_force),
        (_F_G, equations.gravity_force),
    )
    return Formulas(tuple(equal(name, _matrix(vector)) for name, vector in pairs))


def _comparison(equations: NodeEquations) -> tuple[Block, ...]:
    """Return the published equation beside the derived one, entry by entry."""
    plain = [entry.verdict for entry in compare_with_published(equations.principal())]
    rows = [
        _row(entry)
        for entry in compare_with_published(equations)
        if entry.verdict != HOLDS and _is_upper(entry)
    ]
    sentence = (
        f"{plain.count(HOLDS)} of its {len(plain)} entries hold where the mass centre is the node and "
        "the principal axes are U, V, W. For this body these do not; rows and columns count from 1, "
        "and of a symmetric or skew pair the upper one stands here."
    )
    columns = tuple(map(Column, ("entry", "published", "derived", "verdict")))
    table = Table("", columns, tuple(rows), empty="none: every entry holds")
    return (Heading("Beside the published equation (1)"), Paragraph(sentence), table)


def _is_upper(entry: PublishedEntry) -> bool:
    return entry.matrix == "centrifugal_force" or entry.row <= entry.column


def _row(entry: PublishedEntry) -> tuple[Words, ...]:
    places = (entry.row, entry.column)[: 1 if entry.matrix == "centrifugal_force" else 2]
    name = _entry_name(_LETTERS[entry.matrix], *places)
    return (name, entry_formula(entry.published_value), entry_formula(entry.derived_value), entry.verdict)


def _bearing() -> tuple[Block, ...]:
    """Return a bearing's stiffness and damping in turning axes."""
    bearing = turned_bearing()
    stiffness, damping, turn, quarter = map(Name, ("K", "C", "R", "J"))
    transpose = Power(turn, Name("T"))
    circulatory = _OMEGA * transpose * damping * turn * quarter
    return (
        Heading("A bearing in turning axes"),
        Paragraph(
            (
                *(
                    "A bearing with stiffness ",
                    stiffness,
                    " and damping ",
                    damping,
                    " in stationary axes ",
                ),
                *("has in turning ones, ", turn, " being the rotation by ", Name("theta")),
                *(" and ", quarter, " that by 90°:"),
            )
        ),
        Formulas(
            (
                equal(Name("K_rot"), transpose * stiffness * turn + circulatory),
                equal(Name("C_rot"), transpose * damping * turn),
            )
        ),
        Paragraph(("The last term is circulatory. At ", equal(Name("theta"), 0), " it is")),
        Formulas((equal(circulatory, _plain(bearing.circulatory.subs(THETA, 0))),)),
        Paragraph("A bearing that is the same in all directions has"),
        Formulas((equal(Name("K_rot"), _plain(bearing.isotropic().stiffness)),)),
    )


def _plain(matrix: Any) -> Formula:
    return formula_of(matrix)


def _derivation() -> tuple[Block, ...]:
    """Return where the equations come from."""
    p, q, c, force = (Power(letter, Name("T")) for letter in (_P, _Q, _C, _F_M))
    energy = (
        _HALF * p * _MASS * _P
        + _OMEGA * (p * _B * _Q + c * _P)
        + _OMEGA**2 * (force * _Q - _HALF * q * _DK * _Q)
    )
    sentence = (
        "They are Lagrange's for the kinetic energy through the second order, with the rates ",
        equal(_P, Derivative(_Q, _T)),
        ":",
    )
    skew = (
        "Hence ",
        equal(_G, _B - Power(_B, Name("T"))),
        " is skew, and ",
        _DK,
        " symmetric, for any body.",
    )
    return (
        Heading("Where they come from"),
        Paragraph(sentence),
        Formulas((equal(_E, energy),)),
        Paragraph(skew),
    )


def _how_to_read(equations: NodeEquations) -> Facts:
    """Return what the letters mean."""
    kind = equations.rotation
    turn: tuple[Inline, ...] = ("a rotation vector",)
    if kind != "vector":
        attitude = Product(tuple(Name(f"R_{axis}") for axis in kind))
        turn = ("Cardan angles, the body turned by ", attitude)
    entries: list[tuple[Words, Words]] = [
        (
            _Q,
            (
                *_vector_words(COORDINATES),
                ": a shift and ",
                *turn,
                ", in axes that turn about W at ",
                _OMEGA,
            ),
        ),
        (_ALPHA, Derivative(_OMEGA, _T)),
        (Name("m"), ("mass of the rigid body at the node ", *_vector_words(PLACE))),
        (Name("e"), ("its mass centre from the node, ", *_vector_words(OFFSET))),
        (
            Name("I"),
            (
                *("its inertia tensor about that centre; ", Name("I_uv"), " is minus the integral of "),
                *(Name("u") * Name("v"), " over the mass"),
            ),
        ),
        ((_LOAD, ", ", _GRAVITY), "loads on the node; gravity, which pulls down"),
        (Name("theta"), "crank angle"),
        ("equation (1)", _SOURCE),
    ]
    return Facts(tuple(entries), "How to read it")


def _vector_words(symbols: tuple[sympy.Symbol, ...]) -> tuple[Inline, ...]:
    """Return symbols as a vector in brackets."""
    parts: list[Any] = ["("]
    for symbol in symbols:
        parts += [Name(symbol.name), ", "]
    return (*parts[:-1], ")")
