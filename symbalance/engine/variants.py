"""Variants of an engine: the same engine with another rod ratio, bank angle, offset, size or pitch.

Only the sizes named change. The crank stays as it is: throws and stations are those of the engine given,
also where its banks open or close, so that cylinders then fire at other intervals.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction

from symbalance.engine.crank_train import checked_size
from symbalance.engine.cylinders import Cylinder, unchecked_copy
from symbalance.engine.engine import Engine, joined_cylinders
from symbalance.errors import SymbalanceError, brief
from symbalance.exact.angles import degrees

TRAIN_SIZES = ("stroke", "rod")
"""What is a link rod's master's, or the link rod's own: changed of the rods on crank pins alone."""
SIZES = (*TRAIN_SIZES, "offset", "reciprocating_mass", "rotating_mass")
VARIABLES = {
    "ratio": "λ = l/r",
    "bank": "degrees",
    "offset": "mm",
    "stroke": "mm",
    "rod": "mm",
    "pitch": "mm",
    "reciprocating_mass": "kg",
    "rotating_mass": "kg",
}
"""What can be changed of an engine as a whole, and the unit of its values."""


def varied_engine(engine: Engine, values: Mapping[str, object]) -> Engine:
    """Return an engine with other values of some of `VARIABLES`.

    `bank` is the angle that the two banks of a vee enclose. A `stroke` or a `rod` gives the rod ratio
    anew where both lengths are known; a `ratio` beside both would contradict them, and is refused.

    >>> from symbalance.engine.builders import vee
    >>> twin = varied_engine(vee(90, pins=[0]), {"bank": 60, "ratio": "7/2"})
    >>> [c.bank.as_text() for c in twin.cylinders], twin.ratio
    (['-30', '30'], Fraction(7, 2))
    """
    for name in values:
        if name not in VARIABLES:
            remedy = f"one of {', '.join(VARIABLES)}"
            raise SymbalanceError(f"variable = {brief(name)}", "is none of an engine's", remedy)
    if {"ratio", *TRAIN_SIZES} <= {*values}:
        raise SymbalanceError("ratio", "follows from stroke and rod", "leave one of the three out")
    changed = engine
    for name in SIZES:
        if name in values:
            changed = _with_size(changed, name, checked_size(name, values[name]))
    if not {*TRAIN_SIZES}.isdisjoint(values):
        changed = _with_own_ratio(changed)
    if "pitch" in values:
        changed = unchecked_copy(changed, pitch=checked_size("pitch", values["pitch"]))
    if "bank" in values:
        changed = _with_bank(changed, values["bank"])
    return changed.with_ratio(values["ratio"]) if "ratio" in values else _rejoined(changed)


def _rejoined(engine: Engine) -> Engine:
    """Return the engine with its link rods on the masters as they are now, their reach checked."""
    return unchecked_copy(engine, cylinders=joined_cylinders(engine.cylinders))


def _with_size(engine: Engine, name: str, value: Fraction) -> Engine:
    changed = [c for c in engine.cylinders if c.link is None or name not in TRAIN_SIZES]
    if len({getattr(c.sizes, name) for c in changed}) > 1:
        rule = f"cannot be set for {engine.name}, whose cylinders have values of their own"
        raise SymbalanceError(f"{name} = {brief(value)}", rule, "change its file, a variant a file")
    cylinders = [
        unchecked_copy(c, sizes=replace(c.sizes, **{name: value})) if c in changed else c
        for c in engine.cylinders
    ]
    return unchecked_copy(engine, cylinders=tuple(cylinders))


def _with_own_ratio(engine: Engine) -> Engine:
    """Return the engine with the ratio that its stroke and rod have, where both are known."""

    def of_lengths(c: Cylinder) -> Cylinder:
        if c.link is not None or c.sizes.given_ratio is None:
            return c
        if c.sizes.stroke is None:
            rule = "gives no ratio without the stroke"
            raise SymbalanceError(f"rod = {brief(c.sizes.rod)}", rule, "give stroke = ..., in mm")
        known = None if c.sizes.rod is not None else c.sizes.given_ratio
        return unchecked_copy(c, sizes=replace(c.sizes, given_ratio=known))

    return unchecked_copy(engine, cylinders=tuple(map(of_lengths, engine.cylinders)))


def _with_bank(engine: Engine, angle: object) -> Engine:
    """Return a vee whose banks enclose another angle, each turned as far from their middle.

    Firing angles follow the banks: a piston is at its top where its pin passes its axis.
    """
    value = degrees(angle, "bank").in_degrees()
    what = f"bank = {brief(angle)}"
    if not 0 <= value < 360:
        raise SymbalanceError(what, "must lie in [0, 360)", "degrees between the two banks")
    if any(c.bank.symbols or c.link for c in engine.cylinders):
        rule = f"cannot be set for {engine.name}, whose banks are symbols or on link rods"
        raise SymbalanceError(what, rule, "take an engine of numbers, each rod on its crank pin")
    banks = sorted({c.bank.in_degrees() for c in engine.cylinders})
    if len(banks) != 2:
        raise SymbalanceError(what, f"is of two banks, and {engine.name} has {len(banks)}", "take a vee")
    lower, upper = banks if banks[1] - banks[0] <= 180 else banks[::-1]  # across the narrow side
    opening = (value - (upper - lower) % 360) / 2
    shift_of = {lower: -opening, upper: opening}
    shifts = [shift_of[c.bank.in_degrees()] for c in engine.cylinders]
    start = shift_of[engine.first.bank.in_degrees()]
    cylinders = [
        unchecked_copy(
            c,
            bank=degrees(c.bank.in_degrees() + shift).normalized(),
            fires=None if c.fires is None else (c.fires + shift - start) % 720,
        )
        for c, shift in zip(engine.cylinders, shifts, strict=True)
    ]
    return unchecked_copy(engine, cylinders=tuple(cylinders))
