"""What is written of natural modes: frequencies, and what moves in each."""

from __future__ import annotations

from typing import TYPE_CHECKING

from symbalance.crankshaft.rotor_facts import DIGITS, percent, rotor_entry
from symbalance.document.decimals import rounded
from symbalance.document.formula import number
from symbalance.document.nodes import Column, Document, Facts, Table

if TYPE_CHECKING:
    from symbalance.crankshaft.modes import Modes


def modes_document(modes: Modes) -> Document:
    """Return natural modes as a document."""
    heads = ("mode", "Hz", "mostly", "bending U %", "bending V %", "axial %", "torsion %")
    rows = tuple(
        (number(i), rounded(float(hertz), DIGITS), kind, *map(percent, shares))
        for i, (hertz, kind, shares) in enumerate(
            zip(modes.frequencies, modes.kinds, modes.shares, strict=True), 1
        )
    )
    free = "free: its six rigid motions are left out" if modes.is_free else "on a given stiffness"
    entries = (
        rotor_entry(modes.rotor),
        ("at rest", free),
        ("shares", "of the kinetic energy of the main journals, where there are none of all nodes"),
        ("U, V", "across the axis, in axes that turn with the rotor"),
    )
    which = "a free rotor" if modes.is_free else "a rotor on supports"
    return Document(
        f"Natural modes of {which}",
        (Table("Frequencies", tuple(map(Column, heads)), rows), Facts(entries, "How to read it")),
    )
