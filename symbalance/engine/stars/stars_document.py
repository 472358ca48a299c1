"""The documents of crank stars and of firing orders: one table of each."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from symbalance.document.expressions import formula_of
from symbalance.document.formula import Decimal, Formula, number
from symbalance.document.nodes import Column, Document, Exact, Facts, Table, Words
from symbalance.document.text_writer import formula_text
from symbalance.engine.engine_document import degrees_text
from symbalance.engine.stars.cranks import CrankStars
from symbalance.engine.stars.firings import FiringOrders

MOST_NAMED = 2
"""Firing orders of one crank that are named in its row; of more, the first and how many there are."""


def crank_stars_document(cranks: CrankStars) -> Document:
    """Return a table of cranks, the smoothest first, with their couples and firing orders."""
    strokes = {2: "two-stroke", 4: "four-stroke"}[cranks.strokes]
    title = f"Cranks of an evenly firing {strokes} in-line {cranks.cylinders}: {len(cranks)}"
    columns = (
        Column("crank"),
        Column("throws, degrees"),
        Column("couple, order 1", "couple of order 1"),
        Column("order 2", "couple of order 2"),
        Column("stars"),
        Column("firing orders"),
    )
    rows = tuple(
        (
            number(place),
            ", ".join(degrees_text(throw) for throw in star.throws),
            _couple(star.first_couple),
            _couple(star.second_couple),
            number(star.stars),
            _listed([firing.as_text() for firing in star.firings]),
        )
        for place, star in enumerate(cranks, 1)
    )
    legend: tuple[tuple[Words, Words], ...] = (
        ("throws", "front to rear, cylinder 1 at 0"),
        ("couple", "exact amplitude, units F₁ a and F₂ a; sorted by the first, then the second"),
        ("stars", "arrangements that are the same but for turning, mirroring and seeing from the rear"),
    )
    return Document(title, (Table("", columns, rows), Facts(legend, "How to read it")))


def firing_orders_document(orders: FiringOrders) -> Document:
    """Return a table of firing orders with their intervals, alike ones written once."""
    which = "Even firing orders" if orders.even_only else "Firing orders"
    title = f"{which} that the crank of {orders.engine.name} allows: {len(orders)}"
    columns = (Column("firing order"), Column("intervals, degrees"))
    rows = tuple((firing.as_text(), _intervals(firing.intervals)) for firing in orders)
    entries: list[tuple[Words, Words]] = []
    if orders.simultaneous:
        entries.append(("together", "cylinders may fire at one moment: interval 0"))
    if orders.within:
        near = f"dead centres within {degrees_text(orders.within)}° of an even moment"
        entries.append(("within", f"{near} count as lying there"))
    empty = "none"
    if orders.even_only:
        wider = "" if orders.within else "--within 5 counts dead centres as near as 5°; "
        empty = f"none that is even; {wider}--uneven lists uneven ones too"
    blocks = (Table("", columns, rows, empty=empty),)
    return Document(title, (*blocks, Facts(tuple(entries), "How to read it")) if entries else blocks)


def _couple(expression: object) -> Exact | Formula:
    value = formula_of(expression)
    near = Decimal(f"{float(expression):.6g}")  # type: ignore[arg-type]
    return Exact(value, near, beside=formula_text(near) != formula_text(value))


LONGEST_DENOMINATOR = 1000
"""An interval with a larger one comes from dead centres that are rounded: a decimal says more."""


def _intervals(gaps: Sequence[Fraction]) -> str:
    if len(set(gaps)) == 1:
        return f"{_degrees(gaps[0])} each"
    return ", ".join(map(_degrees, gaps))


def _degrees(gap: Fraction) -> str:
    """Return an interval; to a hundredth of a degree where no exact one is readable.

    >>> [_degrees(Fraction(gap)) for gap in ("720/7", "117.5", "3823477/31250")]
    ['720/7', '117.5', '122.35']
    """
    exact = 10_000 % gap.denominator == 0 or gap.denominator <= LONGEST_DENOMINATOR
    return degrees_text(gap if exact else round(gap, 2))


def _listed(names: Sequence[str]) -> str:
    if len(names) > MOST_NAMED:
        return f"{names[0]} and {len(names) - 1} more"
    return ", ".join(names)
