"""What is written of a whirling rotor: its motions at a speed, and its critical speeds."""

from __future__ import annotations

from typing import TYPE_CHECKING

from symbalance.crankshaft.rotor_facts import (
    DIGITS,
    HERTZ,
    RPM,
    SUPPORTS,
    percent,
    rotor_entry,
    speed_words,
    supports_table,
    whirl_word,
)
from symbalance.document.decimals import rounded
from symbalance.document.formula import number
from symbalance.document.nodes import Column, Document, Facts, Strong, Table, Words, blocks

if TYPE_CHECKING:
    from symbalance.crankshaft.whirling import CriticalSpeeds, Whirl

SHOWN = 24
"""Motions in a table, the slowest; the others are in the data."""
WHIRL = ("forward %", "the share of the motion that turns with the shaft; the rest turns against it")


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
    shown = f"the lowest {SHOWN} of {count}" if count > SHOWN else ""
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
        blocks(Table(shown, heads, rows), supports, Facts(tuple(entries), "How to read it")),
    )
