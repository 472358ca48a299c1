"""The natural modes of a whole crank as a solid, hanging free: what beam models are measured against.

A crank that is its own mirror image, in the plane of its throws or front to rear, is cut there and solved
for even and odd motions; their frequencies together are the whole's.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import product
from typing import Any

import numpy as np

from symbalance.crankshaft.crank import Crank, Pin, Web
from symbalance.crankshaft.rotor import Array
from symbalance.crankshaft.solid.drawing import draw_crank, halved
from symbalance.crankshaft.solid.elasticity import Solid, elastic_solid, factored
from symbalance.crankshaft.solid.meshing import meshed


def solid_frequencies(crank: Crank, size: float, count: int = 20) -> Array:
    """Return the lowest `count` elastic natural frequencies (Hz) of the free crank, without end discs.

    `size` (m) is the elements'. ARPACK, shifted and inverted just below zero.
    """
    planes = mirrors(crank)
    middle = crank.length / 2
    mesh = meshed(lambda occ: halved(occ, draw_crank(occ, crank), [*planes], middle * 1e3), size)
    body = elastic_solid(mesh, crank.material)
    found: list[float] = []
    for parity in product((True, False), repeat=len(planes)):
        held = np.zeros(body.size, dtype=bool)
        for axis, even in zip(planes, parity, strict=True):
            held |= body.held_by_mirror(axis, middle if axis == 2 else 0.0, even=even)
        found += _frequencies(body, ~held, count + 6)
    elastic = np.sort([f for f in found if f > 1.0])
    return elastic[:count]


def _frequencies(body: Solid, free: Any, count: int) -> list[float]:
    from scipy.sparse.linalg import LinearOperator, eigsh

    shift = -((2 * np.pi * 20.0) ** 2)
    stiffness, mass = (m.tocsr()[free][:, free].tocsc() for m in (body.stiffness, body.mass))
    factors = factored(body.stiffness - shift * body.mass, free)
    inverse = LinearOperator(stiffness.shape, factors.solve)
    squares = eigsh(stiffness, count, mass, sigma=shift, OPinv=inverse, return_eigenvectors=False)
    return [*(np.sqrt(np.maximum(squares, 0.0)) / (2 * np.pi))]


def mirrors(crank: Crank) -> tuple[int, ...]:
    """Return the crank's mirror planes: 1, that of its throws (v = 0); 2, its middle.

    >>> from symbalance.crankshaft.crank import Journal
    >>> web, end = Web(0.02, 0.08, 0.04, 0.04), Journal(0.06, 0.03)
    >>> mirrors(Crank((end, web, Pin(0.05, 0.03, 0.04, 0.0, (1,)), web, end)))
    (1, 2)
    """
    angles = [p.angle for p in crank.pins]
    weights = [p.counterweight for p in crank.parts if isinstance(p, Web) and p.counterweight]
    angles += [w.angle for w in weights if w.outer]
    flat = bool(np.all(np.abs(np.sin(angles)) < 1e-9))
    plain = [replace(p, cylinders=()) if isinstance(p, Pin) else p for p in crank.parts]
    return (*((1,) if flat else ()), *((2,) if plain == plain[::-1] else ()))
