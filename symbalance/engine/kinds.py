"""The table of cylinders by kind, where they are not all alike: what each kind's rod and axis are."""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.decimals import shown
from symbalance.document.formula import Decimal, Formula, Name, Product
from symbalance.document.nodes import Cell, Column, Table, Words
from symbalance.engine.engine import Engine, Group
from symbalance.kinematics.mechanisms import LinkRod
from symbalance.text.reals import Real

MOST_NAMED = 8
"""Cylinders of one kind that are named one by one."""
_L, _R, _E, _LINK = Name("l"), Name("r"), Name("e"), Name("L")
_COLUMNS = (
    Column("cylinders"),
    Column("rod on"),
    Column(_L / _R),
    Column(_E / _R),
    Column(_LINK / _R),
    Column((Name("psi"), ", degrees")),
    Column((Product((Name("m"), _R)), " (first = 1)")),
)


def kind_table(engine: Engine) -> Table:
    """Return what each kind of cylinder is: its rod, ratio, offset, link pin and m r.

    >>> from symbalance.engine.catalogue import load
    >>> [row[0] for row in kind_table(load("vw-vr6")).rows]
    ['1, 3, 5', '2, 4, 6']
    """
    rows = tuple(_cells(engine, group) for group in engine.groups)
    return Table("Cylinders by kind", _COLUMNS, rows)


def kind_facts(engine: Engine) -> list[tuple[Words, Words]]:
    """Return what the letters of the table's columns mean, those that occur."""
    rows = [_cells(engine, group) for group in engine.groups]
    entries: list[tuple[Words, Words]] = [(_L, "length of the rod")]
    if any(row[3] != "" for row in rows):
        about = "offset of the axis, + towards the side the pin moves to after top dead centre"
        entries.append((_E, about))
    if any(row[4] != "" for row in rows):
        about = "link pin's distance from the crank pin, and angle from the master rod"
        entries.append(((_LINK, ", ", Name("psi")), about))
    return entries


def _cells(engine: Engine, group: Group) -> tuple[Cell, ...]:
    kind, cylinders = group.mechanism, group.cylinders
    numbers = [str(c.number) for c in cylinders]
    if len(numbers) > MOST_NAMED:
        numbers = [*numbers[: MOST_NAMED - 1], f"… ({len(numbers)})"]
    named = ", ".join(numbers)
    offset = _decimal(kind.offset) if kind and kind.offset else ""
    length = _decimal(kind.length) if kind else ""
    share = "" if group.size == 1 else _decimal(group.size)
    if not isinstance(kind, LinkRod):
        hangs = any(c.link for c in engine.cylinders)
        return named, "crank pin" if hangs else "", length, offset, "", "", share
    masters = sorted({c.link.master for c in cylinders if c.link})
    on = "rod of " + (str(masters[0]) if len(masters) == 1 else "its master")
    radius, angle = _decimal(kind.link_radius), _decimal(kind.link_angle * 360)
    return named, on, length, offset, radius, angle, share


def _decimal(number: Fraction) -> Formula:
    return Decimal(shown(Real(number)))
