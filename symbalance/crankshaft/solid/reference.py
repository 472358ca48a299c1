"""Reference cranks meshed whole: the natural frequencies with which every web model is compared.

    python -m symbalance.crankshaft.solid.reference derivations/crankshaft/solid_four.json [NAME ...]

writes the first twenty elastic frequencies of each crank named (by default all), on two meshes each; some
minutes. All ends are alike, so that a crank is its own mirror image twice and a quarter of it is solved.

- bare, weighted: an in-line four, radius 60, journals 65, pins 55, pitch 110 mm, the remaining sizes
  chosen: journals 30, pins 32, webs 24 long, webs 100 wide, 38 beyond the pin, 44 beyond the journal,
  fillets 4 mm; without and with sectors out to 85 mm over 2 x 60 degrees.
- short: two throws of radius 40 whose journals, 55, and pins, 47 mm, overlap.
- slender: two throws of radius 60 with webs 14 mm thick and counterweights out to 85 mm.

A crank that is its own mirror image, in the plane of its throws or front to rear, is cut there and solved
for even and odd motions; their frequencies together are the whole's.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Sequence
from dataclasses import replace
from itertools import product
from math import pi
from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np

from symbalance.crankshaft.arrays import Array
from symbalance.crankshaft.crank import Crank, Journal, Part, Pin, Web
from symbalance.crankshaft.rotor.parts import Material
from symbalance.crankshaft.solid.elasticity import ElasticBody, elastic_solid, sparse_factors
from symbalance.crankshaft.solid.meshing import draw_crank, halved, mesh_solid
from symbalance.crankshaft.webs.sector import sector_counterweight

SIZES = {
    "bare": (0.020, 0.016),
    "weighted": (0.020, 0.016),
    "short": (0.018, 0.014),
    "slender": (0.018, 0.014),
}
"""The elements' sizes, in m, by crank."""


def reference(name: str) -> Crank:
    """Return one of the cranks that were meshed whole: bare, weighted, short, slender."""
    if name in ("bare", "weighted"):
        return reference_four(weighted=name == "weighted")
    if name == "short":
        journal, slab = Journal(0.055, 0.026, fillet=0.003), Web(0.018, 0.085, 0.030, 0.035)
        pin = Pin(0.047, 0.026, 0.040, 0.0, (), fillet=0.003)
        return _crank((0.0, pi), journal, slab, pin, (0.070, 1.1))
    journal, slab = Journal(0.050, 0.030, fillet=0.002), Web(0.014, 0.075, 0.030, 0.035)
    pin = Pin(0.040, 0.030, 0.060, 0.0, (), fillet=0.002)
    return _crank((0.0, pi), journal, slab, pin, (0.085, 1.2))


def reference_four(*, weighted: bool) -> Crank:
    """Return the in-line four, with drawn counterweights or without.

    >>> round(reference_four(weighted=True).length, 6)
    0.47
    """
    journal, slab = Journal(0.065, 0.030, fillet=0.004), Web(0.024, 0.100, 0.038, 0.044)
    pin = Pin(0.055, 0.032, 0.060, 0.0, (), fillet=0.004)
    return _crank((0.0, pi, pi, 0.0), journal, slab, pin, (0.085, pi / 3) if weighted else None)


def _crank(
    angles: Sequence[float], journal: Journal, slab: Web, pin: Pin, sector: tuple[float, float] | None
) -> Crank:
    """Return equal throws at `angles`; `sector` is a counterweight's outer radius and half angle."""
    parts: list[Part] = [journal]
    for cylinder, angle in enumerate(angles, start=1):
        web = slab
        if sector is not None:
            weight = sector_counterweight(slab, 0.0, pin.radius, *sector, Material())
            web = replace(slab, counterweight=replace(weight, angle=angle + pi))
        parts += [web, replace(pin, angle=angle, cylinders=(cylinder,)), web, journal]
    return Crank(tuple(parts), Material())


def mesh_frequencies(name: str, count: int = 20) -> dict[str, object]:
    """Return a solid crank's frequencies (Hz) for each size of elements, and the seconds taken."""

    results: dict[str, object] = {}
    for size in SIZES[name]:
        start = perf_counter()
        frequencies = solid_frequencies(reference(name), size, count)
        seconds = round(perf_counter() - start, 1)
        row = [round(float(f), 3) for f in frequencies]
        results[f"{name} {size * 1e3:g}"] = {"frequencies": row, "seconds": seconds}
        print(f"{name}, {size * 1e3:g} mm: {seconds} s", file=sys.stderr, flush=True)
    return results


if __name__ == "__main__":
    place = Path(sys.argv[1])
    results = json.loads(place.read_text(encoding="utf-8")) if place.exists() else {}
    for name in sys.argv[2:] or SIZES:
        results |= mesh_frequencies(name)
        place.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")


def solid_frequencies(crank: Crank, size: float, count: int = 20) -> Array:
    """Return the lowest `count` elastic natural frequencies (Hz) of the free crank, without end discs.

    `size` (m) is the elements'. ARPACK, shifted and inverted just below zero.
    """
    planes = mirrors(crank)
    middle = crank.length / 2
    mesh = mesh_solid(lambda occ: halved(occ, draw_crank(occ, crank), [*planes], middle * 1e3), size)
    body = elastic_solid(mesh, crank.material)
    frequencies: list[float] = []
    for parity in product((True, False), repeat=len(planes)):
        zeros = np.zeros(body.size, dtype=bool)
        for axis, even in zip(planes, parity, strict=True):
            zeros |= body.zero_at_mirror(axis, middle if axis == 2 else 0.0, even=even)
        frequencies += _frequencies(body, ~zeros, count + 6)
    elastic = np.sort([f for f in frequencies if f > 1.0])
    return elastic[:count]


def _frequencies(body: ElasticBody, free: Any, count: int) -> list[float]:
    from scipy.sparse.linalg import LinearOperator, eigsh

    shift = -((2 * np.pi * 20.0) ** 2)
    stiffness, mass = (m.tocsr()[free][:, free].tocsc() for m in (body.stiffness, body.mass))
    factors = sparse_factors(body.stiffness - shift * body.mass, free)
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
