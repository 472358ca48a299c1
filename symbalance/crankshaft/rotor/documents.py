"""Documents of the results on rotors: modes, torsion, Campbell diagrams, whirl, unbalance."""

from __future__ import annotations

from cmath import phase
from collections.abc import Iterator, Sequence
from math import degrees
from typing import TYPE_CHECKING, Any

import numpy as np

from symbalance.document.decimals import fixed, rounded
from symbalance.document.formula import Name, number
from symbalance.document.nodes import Cell, Column, Details, Document, Facts, Strong, Table, Words, blocks

if TYPE_CHECKING:
    from symbalance.crankshaft.arrays import Array
    from symbalance.crankshaft.rotor.campbell_diagram import Campbell
    from symbalance.crankshaft.rotor.matrices import Rotor
    from symbalance.crankshaft.rotor.modes import Modes
    from symbalance.crankshaft.rotor.stationary import Support
    from symbalance.crankshaft.rotor.torsion import TorsionalChain
    from symbalance.crankshaft.rotor.unbalance import UnbalanceResponse
    from symbalance.crankshaft.rotor.whirling import CriticalSpeeds, Whirl

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
ABREAST = 6
"""Modes beside one another in a table."""
SHOWN = 24
"""Motions in a table, the slowest; the others are in the data."""
WHIRL = ("forward %", "the share of the motion that turns with the shaft; the rest turns against it")
MICRO = 1e6
PLACES = 4
MOST_ROWS = 60
"""Of the table of all nodes at all speeds; a longer one is left to the data."""
NAMED = 4
"""Speeds that a title names."""
_ORBIT = ("rpm", "at m", "largest µm", "forward µm", "phase °", "backward µm", "phase °")
_FORCE = ("rpm", "bearing", "vertical N", "phase °", "lateral N", "phase °")


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


def campbell_document(lines: Campbell) -> Document:
    """Return a Campbell diagram's lines as a document."""
    first, last = (speed_words(float(lines.speeds[i])) for i in (0, -1))
    span = f"from {first} to {last}" if len(lines.speeds) > 1 else f"at {first}"
    constraint = (
        "free" if lines.is_free else "on a given stiffness, alike in all directions across the axis"
    )
    entries: tuple[tuple[Words, Words], ...] = (
        rotor_entry(lines.rotor),
        ("held", constraint),
        ("turning axes", "turn with the rotor"),
        ("stationary axes", "the stronger line of a mode there; negative: it whirls backward"),
        ("growth", "real part of the root in 1/s; above 0: unstable"),
        ("mode", "tracked over the speed by its shape"),
    )
    return Document(
        f"Natural frequencies over speed, {span}",
        blocks(
            _courses(lines),
            tuple(_over_speed("Stationary axes, Hz", lines, lines.stationary * HERTZ)),
            tuple(_over_speed("Turning axes, Hz", lines, lines.rotating * HERTZ)),
            tuple(_over_speed("Growth, 1/s", lines, lines.growth)) if lines.unstable.any() else None,
            Facts(entries, "How to read it"),
        ),
        _verdict(lines),
    )


def _verdict(lines: Campbell) -> Words:
    """Return at which speeds something grows."""
    growing = lines.speeds[lines.unstable.any(axis=1)]
    if not len(growing):
        return "Nothing grows at these speeds."
    return Strong(f"Unstable at {', '.join(speed_words(float(speed)) for speed in growing)}.")


def _courses(lines: Campbell) -> Table:
    """Return a row for each mode: what moves, and its frequencies at the first and the last speed."""
    ends = [0, -1] if len(lines.speeds) > 1 else [0]
    heads = [Column("mode"), Column("motion")]
    heads += [Column(f"stationary Hz at {speed_words(float(lines.speeds[i]))}") for i in ends]
    heads += [Column("largest growth 1/s")]
    rows = tuple(_course(lines, k, ends) for k in range(lines.rotating.shape[1]))
    return Table("Modes", tuple(heads), rows)


def _course(lines: Campbell, mode: int, ends: list[int]) -> tuple[Cell, ...]:
    motion = whirl_word(float(lines.forward[-1, mode])) if lines.lateral[-1, mode] else "axial or torsion"
    hertz = [rounded(float(lines.stationary[i, mode]) * HERTZ, DIGITS) for i in ends]
    growth = float(lines.growth[:, mode].max())
    return number(mode + 1), motion, *hertz, rounded(growth if abs(growth) > lines.rounding else 0.0, 3)


def _over_speed(title: str, lines: Campbell, values: Array) -> Iterator[Table]:
    """Yield tables of values (speed, mode), some modes each."""
    count = values.shape[1]
    for start in range(0, count, ABREAST):
        stop = min(start + ABREAST, count)
        heads = (Column("rpm"), *(Column(f"mode {k + 1}") for k in range(start, stop)))
        rows = tuple(
            (rounded(float(speed) * RPM), *(rounded(float(value), DIGITS) for value in row[start:stop]))
            for speed, row in zip(lines.speeds, values, strict=True)
        )
        yield Table(title, heads, rows)


def whirl_document(whirl: Whirl) -> Document:
    """Return the motions of a rotor at a speed as a document."""
    heads = ("mode", "Hz", "natural Hz", "damping ratio", "log decrement", "whirl", "forward %")
    rows = tuple(
        (
            number(k + 1),
            rounded(float(abs(whirl.frequencies[k])) * HERTZ, DIGITS),
            rounded(float(whirl.natural[k]) * HERTZ, DIGITS),
            rounded(float(whirl.damping_ratios[k]), 3),
            rounded(float(whirl.log_decrements[k]), 3),
            whirl_word(float(whirl.forward[k])),
            percent(float(whirl.forward[k])),
        )
        for k in range(min(len(whirl.roots), SHOWN))
    )
    count = len(whirl.roots)
    title = f"Motions, the slowest {SHOWN} of {count}" if count > SHOWN else "Motions"
    entries: tuple[tuple[Words, Words], ...] = (
        rotor_entry(whirl.rotor),
        ("Hz", "with damping; natural: the size of the root"),
        ("damping ratio", "below 0: the motion grows"),
        WHIRL,
        SUPPORTS,
        ("overdamped", f"{len(whirl.overdamped)} motions do not oscillate"),
    )
    return Document(
        f"Whirl at {speed_words(whirl.speed)}",
        blocks(
            Table(title, tuple(map(Column, heads)), rows),
            supports_table(whirl.rotor, whirl.supports),
            Facts(entries, "How to read it"),
        ),
        "Stable: nothing grows." if whirl.is_stable else Strong("Unstable: a motion grows."),
    )


def critical_document(critical: CriticalSpeeds) -> Document:
    """Return critical speeds as a document."""
    rows = tuple(
        (
            number(k),
            rounded(float(speed) * RPM, DIGITS),
            rounded(float(speed), DIGITS),
            rounded(float(speed) * HERTZ, DIGITS),
            whirl_word(float(forward)),
            percent(float(forward)),
        )
        for k, (speed, forward) in enumerate(
            zip(critical.speeds[:SHOWN], critical.forward[:SHOWN], strict=True), 1
        )
    )
    heads = tuple(map(Column, ("number", "rpm", "rad/s", "Hz", "whirl", "forward %")))
    limit = "" if critical.most is None else f" up to {speed_words(critical.most)}"
    count = len(critical.speeds)
    caption = f"the lowest {SHOWN} of {count}" if count > SHOWN else ""
    entries: list[tuple[Words, Words]] = [
        rotor_entry(critical.rotor),
        ("critical", "a whirl has the frequency of the turning itself"),
        ("forward", "excited by unbalance; backward only where supports differ in two directions"),
        WHIRL,
    ]
    if critical.supports is None:
        entries.append(("supports", "a function of the speed"))
        supports = None
    else:
        entries.append(SUPPORTS)
        supports = supports_table(critical.rotor, critical.supports)
    return Document(
        f"Critical speeds{limit}",
        blocks(Table(caption, heads, rows), supports, Facts(tuple(entries), "How to read it")),
    )


def unbalance_document(answer: UnbalanceResponse) -> Document:
    """Return the answer to unbalance as a document."""
    largest = tuple(_orbit(answer, s, int(np.argmax(row))) for s, row in enumerate(answer.largest))
    forces = tuple(
        (
            rounded(float(speed) * RPM),
            number(b + 1),
            *_size_and_phase(force[0], 1.0),
            *_size_and_phase(force[1], 1.0),
        )
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
        rounded(float(answer.places[node]), PLACES),
        rounded(float(answer.largest[speed, node]) * MICRO, PLACES),
        *_size_and_phase(forward, MICRO),
        *_size_and_phase(backward, MICRO),
    )


def _size_and_phase(value: complex, scale: float) -> tuple[Cell, Cell]:
    """Return a complex amplitude's size and phase; of nothing there is no phase."""
    size = abs(value) * scale
    return rounded(size, PLACES), rounded(round(degrees(phase(value)), 1), PLACES) if size else ""


def _everywhere(answer: UnbalanceResponse) -> Details | None:
    speeds, nodes = answer.vertical.shape
    if nodes * speeds > MOST_ROWS:
        return None
    rows = tuple(_orbit(answer, s, n) for s in range(speeds) for n in range(nodes))
    return Details("Every node", (Table("Orbits", tuple(map(Column, _ORBIT)), rows, keys=2),))


def _unbalances(answer: UnbalanceResponse) -> tuple[tuple[Cell, ...], ...]:
    return tuple(
        (rounded(place, PLACES), *_size_and_phase(amount, 1.0)) for place, amount in answer.unbalances
    )


def _how_to_read(answer: UnbalanceResponse) -> Facts:
    entries: list[tuple[Words, Words]] = [
        rotor_entry(answer.rotor),
        ("largest", "half the major axis of the orbit"),
        ("forward, backward", "radii of the circles, with and against the shaft, that make up an orbit"),
        ("phase", "ahead of axis U of the rotor, which stands straight up at angle 0"),
    ]
    entries.append(SUPPORTS if answer.supports else ("supports", "a function of the speed"))
    return Facts(tuple(entries), "How to read it")
