"""What is written of a rotor's answer to unbalance: its orbits, and the forces on its supports."""

from __future__ import annotations

from cmath import phase
from math import degrees
from typing import TYPE_CHECKING

import numpy as np

from symbalance.crankshaft.rotor_facts import RPM, SUPPORTS, rotor_entry, speed_words, supports_table
from symbalance.document.decimals import rounded
from symbalance.document.formula import number
from symbalance.document.nodes import Cell, Column, Details, Document, Facts, Table, Words, blocks

if TYPE_CHECKING:
    from symbalance.crankshaft.unbalance import UnbalanceResponse

MICRO = 1e6
DIGITS = 4
MOST_ROWS = 60
"""Of the table of all nodes at all speeds; a longer one is left to the data."""
NAMED = 4
"""Speeds that a title names."""
_ORBIT = ("rpm", "at m", "largest µm", "forward µm", "phase °", "backward µm", "phase °")
_FORCE = ("rpm", "bearing", "vertical N", "phase °", "lateral N", "phase °")


def unbalance_document(answer: UnbalanceResponse) -> Document:
    """Return the answer to unbalance as a document."""
    largest = tuple(_orbit(answer, s, int(np.argmax(row))) for s, row in enumerate(answer.largest))
    forces = tuple(
        (rounded(float(speed) * RPM), number(b + 1), *_sized(force[0], 1.0), *_sized(force[1], 1.0))
        for speed, row in zip(answer.speeds, answer.forces, strict=True)
        for b, force in enumerate(row)
    )
    supports = answer.supports
    return Document(
        f"Answer to unbalance at {speeds_words(answer)}",
        blocks(
            Table("The largest orbit at each speed", tuple(map(Column, _ORBIT)), largest),
            Table("Forces of the shaft on its supports", tuple(map(Column, _FORCE)), forces, keys=2),
            _everywhere(answer),
            Table("Unbalances", tuple(map(Column, ("at m", "kg m", "angle °"))), _unbalances(answer)),
            None if supports is None else supports_table(answer.rotor, supports),
            _how_to_read(answer),
        ),
    )


def speeds_words(answer: UnbalanceResponse) -> str:
    """Return the speeds in words: all of a few, or the first and the last."""
    if len(answer.speeds) <= NAMED:
        return ", ".join(f"{speed * RPM:.6g}" for speed in answer.speeds) + " rpm"
    first, last = (speed_words(float(answer.speeds[i])) for i in (0, -1))
    return f"{len(answer.speeds)} speeds from {first} to {last}"


def _orbit(answer: UnbalanceResponse, speed: int, node: int) -> tuple[Cell, ...]:
    forward, backward = (complex(part[speed, node]) for part in (answer.forward, answer.backward))
    return (
        rounded(float(answer.speeds[speed]) * RPM),
        rounded(float(answer.places[node]), DIGITS),
        rounded(float(answer.largest[speed, node]) * MICRO, DIGITS),
        *_sized(forward, MICRO),
        *_sized(backward, MICRO),
    )


def _sized(value: complex, scale: float) -> tuple[Cell, Cell]:
    """Return a complex amplitude's size and phase; of nothing there is no phase."""
    size = abs(value) * scale
    return rounded(size, DIGITS), rounded(round(degrees(phase(value)), 1), DIGITS) if size else ""


def _everywhere(answer: UnbalanceResponse) -> Details | None:
    speeds, nodes = answer.vertical.shape
    if nodes * speeds > MOST_ROWS:
        return None
    rows = tuple(_orbit(answer, s, n) for s in range(speeds) for n in range(nodes))
    return Details("Every node", (Table("Orbits", tuple(map(Column, _ORBIT)), rows, keys=2),))


def _unbalances(answer: UnbalanceResponse) -> tuple[tuple[Cell, ...], ...]:
    return tuple((rounded(place, DIGITS), *_sized(amount, 1.0)) for place, amount in answer.unbalances)


def _how_to_read(answer: UnbalanceResponse) -> Facts:
    entries: list[tuple[Words, Words]] = [
        rotor_entry(answer.rotor),
        ("largest", "half the major axis of the orbit"),
        ("forward, backward", "radii of the circles, with and against the shaft, that make up an orbit"),
        ("phase", "ahead of axis U of the rotor, which stands straight up at angle 0"),
    ]
    entries.append(SUPPORTS if answer.supports else ("supports", "a function of the speed"))
    return Facts(tuple(entries), "How to read it")
