"""What is written of a torsional chain: its discs and springs, frequencies and shapes."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from symbalance.crankshaft.rotor_facts import DIGITS
from symbalance.document.decimals import fixed, rounded
from symbalance.document.formula import number
from symbalance.document.nodes import Column, Document, Facts, Table, blocks

if TYPE_CHECKING:
    from symbalance.crankshaft.torsion import TorsionalChain

ABREAST = 6
"""Modes beside one another in a table."""


def torsion_document(chain: TorsionalChain) -> Document:
    """Return a torsional chain as a document."""
    hertz, shapes = chain.modes()
    frequencies = tuple(
        (number(k), rounded(float(f), DIGITS), rounded(float(f) * 60, DIGITS))
        for k, f in enumerate(hertz, 1)
    )
    springs = [*(rounded(float(c)) for c in chain.stiffnesses), ""]
    discs = tuple(
        (number(i), rounded(float(inertia)), spring)
        for i, (inertia, spring) in enumerate(zip(chain.inertias, springs, strict=True), 1)
    )
    entries = (
        ("shape", "the turn of each disc over the largest; the free turning of the whole is left out"),
        ("per minute", "the speed at which order 1 excites the mode; order n does at an n-th of it"),
    )
    return Document(
        f"Torsional chain of {len(chain.inertias)} discs",
        blocks(
            Table("Natural frequencies", tuple(map(Column, ("mode", "Hz", "per minute"))), frequencies),
            tuple(_shapes(shapes)),
            Table("Discs", tuple(map(Column, ("disc", "kg m²", "spring behind, N m/rad"))), discs),
            Facts(entries, "How to read it"),
        ),
    )


def _shapes(shapes: np.ndarray) -> Iterator[Table]:
    """Yield tables of the modes' shapes, some modes each."""
    largest = shapes[np.argmax(np.abs(shapes), axis=0), range(shapes.shape[1])]
    relative = shapes / largest
    count = relative.shape[1]
    for start in range(0, count, ABREAST):
        stop = min(start + ABREAST, count)
        heads = (Column("disc"), *(Column(f"mode {k + 1}") for k in range(start, stop)))
        rows = tuple(
            (number(i), *(fixed(float(x), 4) for x in row[start:stop]))
            for i, row in enumerate(relative, 1)
        )
        yield Table("Shapes", heads, rows)
