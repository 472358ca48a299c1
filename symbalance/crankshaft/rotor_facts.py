"""What the documents of rotors share: the rotor in a line, its supports in a table, speeds in words."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from symbalance.document.decimals import rounded
from symbalance.document.formula import Name, number
from symbalance.document.nodes import Column, Table, Words

if TYPE_CHECKING:
    from symbalance.crankshaft.rotor import Rotor
    from symbalance.crankshaft.stationary import Support

RPM = 30 / np.pi
"""rpm of one rad/s."""
HERTZ = 1 / (2 * np.pi)
"""Hz of one rad/s."""
DIGITS = 5
"""Of frequencies and speeds."""
_PLACES = {"vv": (0, 0), "ll": (1, 1), "vl": (0, 1), "lv": (1, 0)}
"""Of a stiffness or a damping: v vertical, l lateral, the force before the motion it answers."""
SUPPORTS = ("v, l", "vertical, lateral; of two, the force's direction comes first")
"""What the letters of a supports' table mean, for facts."""


def speed_words(speed: float) -> str:
    """Return a speed in rad/s as words: "4000 rpm".

    >>> speed_words(100 * np.pi)
    '3000 rpm'
    """
    return f"{speed * RPM:.6g} rpm"


def rotor_entry(rotor: Rotor) -> tuple[Words, Words]:
    """Return a rotor in a line, for facts."""
    mass = float(np.diag(rotor.rigid_motions().T @ rotor.mass @ rotor.rigid_motions())[0])
    length = float(np.ptp(rotor.points[:, 2]))
    bearings = ", ".join(f"{place:.4g}" for place in rotor.points[list(rotor.journals), 2])
    where = f"; bearings at {bearings} m" if bearings else ""
    return "rotor", f"{mass:.5g} kg, {length:.4g} m long, {len(rotor.points)} nodes{where}"


def whirl_word(forward: float) -> str:
    """Return which way a motion turns that is forward to this share, 0 to 1."""
    return "forward" if forward >= 0.5 else "backward"


def percent(share: float) -> Words:
    """Return a share, 0 to 1, as a cell in percent."""
    return rounded(round(100 * share, 1), 4)


def supports_table(rotor: Rotor, supports: Sequence[Support]) -> Table:
    """Return the supports, a row for each bearing; columns that are zero throughout are left out."""
    heads = [Column("bearing"), Column("at m")]
    heads += [Column(Name(f"{letter}_{places}")) for letter in "KC" for places in _PLACES]
    heads.append(Column("tilt, N m/rad"))
    rows = []
    for bearing, (node, support) in enumerate(zip(rotor.journals, supports, strict=True), 1):
        values = [m[place] for m in support.matrices for place in _PLACES.values()] + [support.tilt]
        cells = ("" if value == 0 else rounded(float(value)) for value in values)
        rows.append((number(bearing), rounded(float(rotor.points[node, 2]), 4), *cells))
    return Table("Supports: stiffness K in N/m, damping C in N s/m", tuple(heads), tuple(rows))


def supports_data(supports: Sequence[Support] | None) -> list[dict[str, Any]] | None:
    """Return supports as plain values, None where they are a function of the speed."""
    if supports is None:
        return None
    return [
        {"stiffness": each.matrices[0].tolist(), "damping": each.matrices[1].tolist(), "tilt": each.tilt}
        for each in supports
    ]


def complex_data(values: np.ndarray[Any, Any]) -> Any:
    """Return complex values as nested lists, each number as [real, imaginary]."""
    return np.stack([values.real, values.imag], axis=-1).tolist()
