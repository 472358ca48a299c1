"""Turns and radians in one chain: 50 Hz = 314 rad/s, or 50 rev/s, says one speed in both ways.

A turn is 2π radians. What follows a letter is in that letter's unit: in ω = 314 rad/s = 50 Hz the hertz
are turned into radians, elsewhere the radians into turns. 50 Hz = 50 rad/s is as false as before.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Constant, Formula, Name, Number, Product, Quotient
from symbalance.notes.checking.units.own_units import BY_THE_SECOND
from symbalance.notes.reading.equations import Chain, ReadNotes, Side
from symbalance.text import lazy_patterns as re

_TURNS = re.compile(rf"(?<![A-Za-z]){BY_THE_SECOND}[\s}}$]*$")
_RADIANS = re.compile(
    r"(?<![A-Za-z])rad\s*(?:(?:/|\}\{)\s*(?:\\(?:mathrm|text)\s*\{)?s|(?:\\,|\s|·)?s(?:\^\{?-1|⁻¹))[\s}$]*$"
)
_PER_SECOND = re.compile(
    r"[0-9](?:[\s~{]|\\,|\\mathrm|\\text)*(?:1\s*/\s*s|s\s*\}?(?:\^\{?[-−]1|⁻¹))[\s}$]*$"
)


def with_turns(document: ReadNotes) -> ReadNotes:
    """Return a page whose chains of turns and radians are in one of the two."""
    if "rad" not in document.text:
        return document
    return replace(document, chains=tuple(_chain(chain, document) for chain in document.chains))


def _chain(chain: Chain, document: ReadNotes) -> Chain:
    units: list[str] = []
    for side in chain.sides:  # of s⁻¹ alone nobody can tell which it is: it goes on with the side before
        unit = _unit(side, document)
        units.append((units[-1] if units else "") if unit == "open" else unit)
    if not {"turns", "radians"} <= set(units):
        return chain
    first, head = next(unit for unit in units if unit), chain.sides[0].node
    is_angular = isinstance(head, Name) and (first == "radians" or head.name in ("omega", "Omega"))
    changed = "turns" if is_angular else "radians"
    sides = (
        replace(side, readings=tuple(_turned(node, changed) for node in side.readings))
        if unit == changed
        else side
        for side, unit in zip(chain.sides, units, strict=True)
    )
    return replace(chain, sides=tuple(sides))


def _unit(side: Side, document: ReadNotes) -> str:
    """Return in which unit a side is that is one number with its unit, "" for any other."""
    if isinstance(side.node, Product) and side.node.factors[1:] == (Number(Fraction(1, 60)),):
        return "turns"  # revolutions per minute of a letter that counts them
    if not isinstance(side.node, Number):
        return ""
    source = document.text[side.span[0] : side.span[1]]
    kinds = {"turns": _TURNS, "radians": _RADIANS, "open": _PER_SECOND}
    return next((kind for kind, pattern in kinds.items() if pattern.search(source)), "")


def _turned(node: Formula, unit: str) -> Formula:
    behind = (node.span[1], node.span[1])  # no text of its own, which would be of a unit
    turn = Product((Number(Fraction(2), span=behind), Constant("pi", span=behind)), span=behind)
    if isinstance(node, Number) and node.last_place is None and len(str(node.value.numerator)) > 2:
        node = replace(node, last_place=Fraction(1))  # 314 rad/s is rounded, as 2π is no whole number
    if unit == "turns":
        return Product((node, turn), span=node.span)
    return Product((node, Quotient(Number(Fraction(1), span=behind), turn, span=behind)), span=node.span)
