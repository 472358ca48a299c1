"""The table of cylinders by kind, where they are not all alike: what each kind's rod and axis are."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from symbalance.document.decimals import shown
from symbalance.engine.engine import Engine, Group
from symbalance.kinematics.mechanisms import LinkRod
from symbalance.text.reals import Real

MOST_NAMED = 8
"""Cylinders of one kind that are named one by one."""


@dataclass(frozen=True)
class Column:
    """A column of the table: its heads in text and LaTeX, and its cells, empty where it says nothing."""

    text: str
    latex: str
    cells: tuple[str, ...]


def kind_columns(layout: Engine) -> list[Column]:
    """Return the columns that say something: cylinders, rod, l/r, offset, link pin, m r.

    >>> from symbalance.engine.catalogue import load
    >>> for column in kind_columns(load("vw-vr6")):
    ...     print(column.text, *column.cells, sep=" | ")
    cylinders | 1, 3, 5 | 2, 4, 6
    l/r | 3.64444 | 3.64444
    e/r | -0.277778 | 0.277778
    """
    rows = [_cells(layout, group) for group in layout.groups]
    heads = [
        ("cylinders", "cylinders"),
        ("rod on", "rod on"),
        ("l/r", r"\(l/r\)"),
        ("e/r", r"\(e/r\)"),
        ("L/r", r"\(L/r\)"),
        ("ψ", r"\(\psi\)"),
        ("m r (first = 1)", r"\(m\,r\) (first = 1)"),
    ]
    columns = [Column(*head, cells) for head, cells in zip(heads, zip(*rows, strict=True), strict=True)]
    return [column for column in columns if any(column.cells)]


def kind_legend(layout: Engine) -> list[str]:
    """Return what the columns' letters mean, those that occur."""
    used = {column.text for column in kind_columns(layout)}
    lines = ["l: length of the rod"]
    if "e/r" in used:
        lines.append("e: offset of the axis, + towards the side the pin moves to after top dead centre")
    if "L/r" in used:
        lines.append("L, ψ: link pin's distance from the crank pin, and angle from the master rod")
    return lines


def kind_lines(layout: Engine) -> list[str]:
    """Return the same as lines of text, for a heading: which cylinders share what, and what m and r are.

    >>> from symbalance.engine.catalogue import load
    >>> print(*kind_lines(load("vw-vr6"))[:2], sep="; ")
    cylinders 1, 3, 5: l/r = 3.64444, e/r = -0.277778; cylinders 2, 4, 6: l/r = 3.64444, e/r = 0.277778
    """
    names, *columns = kind_columns(layout)
    lines = []
    for i, numbers in enumerate(names.cells):
        said = [(c.text, c.cells[i]) for c in columns if c.cells[i]]
        parts = [f"{name} {cell}" if name == "rod on" else f"{name} = {cell}" for name, cell in said]
        lines.append(f"cylinders {numbers}: {', '.join(parts)}")
    first = layout.first.number
    return [
        *lines,
        *kind_legend(layout),
        f"m, r: reciprocating mass and crank radius of cylinder {first}",
    ]


def _cells(layout: Engine, group: Group) -> tuple[str, ...]:
    kind, cylinders = group.mechanism, group.cylinders
    numbers = [str(c.number) for c in cylinders]
    if len(numbers) > MOST_NAMED:
        numbers = [*numbers[: MOST_NAMED - 1], f"... ({len(numbers)})"]
    offset = _decimal(kind.offset) if kind and kind.offset else ""
    length = _decimal(kind.length) if kind else ""
    share = "" if group.size == 1 else _decimal(group.size)
    if not isinstance(kind, LinkRod):
        hangs = any(c.link for c in layout.cylinders)
        return ", ".join(numbers), "crank pin" if hangs else "", length, offset, "", "", share
    masters = sorted({c.link.master for c in cylinders if c.link})
    on = "rod of " + (str(masters[0]) if len(masters) == 1 else "its master")
    radius, angle = _decimal(kind.link_radius), _decimal(kind.link_angle * 360) + "°"
    return ", ".join(numbers), on, length, offset, radius, angle, share


def _decimal(number: Fraction) -> str:
    return shown(Real(number))
