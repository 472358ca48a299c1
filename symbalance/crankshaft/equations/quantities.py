"""Symbols of a node's equations, and the polynomial ring in which they are derived.

Everything is a polynomial with rational coefficients: in the mass, the place, the offset, the inertia
tensor, the six coordinates and their rates. SymPy's sparse rings keep them in normal form, so that a
zero is a comparison.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import sympy
from sympy.polys.rings import PolyRing, ring

M = sympy.Symbol("m", positive=True)
PLACE = sympy.symbols("U V W", real=True)
OFFSET = sympy.symbols("e_u e_v e_w", real=True)
PRODUCTS = sympy.symbols("I_uv I_uw I_vw", real=True)
MOMENTS = sympy.symbols("I_uu I_vv I_ww", positive=True)
OMEGA = sympy.Symbol("omega", positive=True)
THETA = sympy.Symbol("theta", real=True)
SHIFT = sympy.symbols("u v w", real=True)
TURN = sympy.symbols("theta_u theta_v theta_w", real=True)
COORDINATES = (*SHIFT, *TURN)
RATES = tuple(sympy.Symbol(f"{name}_dot", real=True) for name in COORDINATES)

PARAMETERS = (M, *PLACE, *OFFSET, *MOMENTS, *PRODUCTS)
RING: PolyRing = ring((*COORDINATES, *RATES, OMEGA, *PARAMETERS), sympy.QQ)[0]
MOVING = len(COORDINATES) + len(RATES)
"""How many of the ring's generators, the first, are small."""

RingElement = Any
"""An element of the ring: SymPy's types do not say what their sums are."""
RingVector = list[RingElement]
RingMatrix = list[RingVector]


def ring_element(symbol: sympy.Expr | int) -> RingElement:
    """Return a symbol, or a sum of products of them, as an element of the ring."""
    return RING.from_expr(sympy.sympify(symbol))


def ring_elements(symbols: tuple[sympy.Symbol, ...]) -> RingVector:
    """Return several symbols as elements of the ring."""
    return [ring_element(symbol) for symbol in symbols]


def inertia_rows() -> RingMatrix:
    """Return the inertia tensor about the mass centre, with I_uv = -(integral of u v dm) and so on."""
    uu, vv, ww = ring_elements(MOMENTS)
    uv, uw, vw = ring_elements(PRODUCTS)
    return [[uu, uv, uw], [uv, vv, vw], [uw, vw, ww]]


def truncated(value: RingElement, degree: int = 2) -> RingElement:
    """Return a polynomial without its terms of higher degree in the small quantities."""
    terms = {powers: c for powers, c in value.terms() if sum(powers[:MOVING]) <= degree}
    return RING.from_dict(terms)


def ring_sum(values: Iterable[RingElement]) -> RingElement:
    """Return the sum."""
    return sum(values, RING.zero)


def scalar_product(one: RingVector, other: RingVector, degree: int = 2) -> RingElement:
    """Return the scalar product, through a degree in the small quantities."""
    return truncated(ring_sum(a * b for a, b in zip(one, other, strict=True)), degree)


def matrix_times_vector(rows: RingMatrix, vector: RingVector) -> RingVector:
    """Return matrix times vector, through the second degree."""
    return [scalar_product(row, vector) for row in rows]


def matrix_product(one: RingMatrix, other: RingMatrix) -> RingMatrix:
    """Return matrix times matrix, through the second degree."""
    return [[scalar_product(row, list(column)) for column in zip(*other, strict=True)] for row in one]


def transpose(rows: RingMatrix) -> RingMatrix:
    """Return the transpose."""
    return [list(column) for column in zip(*rows, strict=True)]


def vector_product(one: RingVector, other: RingVector) -> RingVector:
    """Return the vector product, through the second degree."""
    return [
        scalar_product([one[1], -one[2]], [other[2], other[1]]),
        scalar_product([one[2], -one[0]], [other[0], other[2]]),
        scalar_product([one[0], -one[1]], [other[1], other[0]]),
    ]


def time_derivative(value: RingElement) -> RingElement:
    """Return the time derivative of a polynomial in the coordinates."""
    pairs = zip(ring_elements(COORDINATES), ring_elements(RATES), strict=True)
    return ring_sum(value.diff(q) * q_dot for q, q_dot in pairs)
