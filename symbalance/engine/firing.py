"""What a builder is given, read: firing orders, intervals, banks' cylinders, stagger, stations."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import accumulate

from symbalance.engine.cylinders import MOST_CYLINDERS
from symbalance.errors import SymbalanceError, shown
from symbalance.exact.angles import degrees
from symbalance.text.numbers import exact, listed

FiringOrder = str | Sequence[int]
FIRING_AT = ("pins", "dead centres")


def read_firing_order(firing_order: FiringOrder) -> list[int]:
    """Return a firing order, given as text or as a list, as cylinder numbers."""
    numbers: Iterable[object]
    if isinstance(firing_order, str):
        parts = [part.strip() for part in firing_order[:10_000].split("-")]
        numbers = [int(p) if p.isascii() and p.isdigit() and len(p) < 6 else p for p in parts]
    else:
        numbers = listed(firing_order, "firing_order")
    order = []
    for number in numbers:
        if isinstance(number, bool) or not isinstance(number, int) or number < 1:
            raise SymbalanceError(
                f"firing_order = {shown(firing_order)}",
                f"holds {shown(number)}, which is no cylinder number",
                "write it like [1, 3, 4, 2]",
            )
        order.append(number)
    if not order:
        raise SymbalanceError("firing_order = []", "names no cylinder", "write it like [1, 3, 4, 2]")
    if len(order) > MOST_CYLINDERS:
        raise SymbalanceError(
            f"firing_order of {len(order)} numbers",
            f"an engine has 1 to {MOST_CYLINDERS} cylinders",
            "shorten it",
        )
    repeated = sorted({n for n in order if order.count(n) > 1})
    if repeated:
        raise SymbalanceError(
            f"firing_order = {shown(firing_order)}",
            f"must name each cylinder once, but repeats {repeated[0]}",
            "correct the order",
        )
    return order


def read_cylinders(
    cylinders: Sequence[Sequence[int]] | None, order: list[int], banks: int
) -> list[list[int]]:
    """Return the numbers in each bank, checked against the firing order."""
    if cylinders is None:
        if banks > 1:
            raise SymbalanceError(
                f"banks of {banks} angles",
                "need cylinders, the numbers in each",
                "as in [[1, 3, 5], [2, 4, 6]]",
            )
        cylinders = [sorted(order)]
    cylinders = [listed(bank, "cylinders") for bank in listed(cylinders, "cylinders")]
    if len(cylinders) != banks:
        raise SymbalanceError(
            f"cylinders = {shown(cylinders)}",
            f"has {len(cylinders)} lists for {banks} bank(s)",
            "give one list of numbers a bank",
        )
    if not all(cylinders):
        raise SymbalanceError(
            f"cylinders = {shown(cylinders)}",
            "holds an empty bank",
            "leave the bank out, or name its cylinders",
        )
    numbers = [n for bank in cylinders for n in bank]
    if 1 not in numbers:
        raise SymbalanceError(
            f"cylinders = {shown(cylinders)}", "lacks cylinder 1", "theta = 0 is its firing"
        )
    for number in order:
        if number not in numbers:
            raise SymbalanceError(
                f"firing_order = {shown(order)}",
                f"names cylinder {number}, which no bank holds",
                "make order and cylinders agree",
            )
    for number in numbers:
        if number not in order or numbers.count(number) > 1:
            what = "repeats" if numbers.count(number) > 1 else "holds, but the firing order misses,"
            raise SymbalanceError(
                f"cylinders = {shown(cylinders)}",
                f"{what} cylinder {shown(number)}",
                "name each cylinder once in both",
            )
    return [list(bank) for bank in cylinders]


def firing_angles(
    order: list[int], intervals: Sequence[object] | None, cycle: int
) -> dict[int, Fraction]:
    """Return each cylinder's firing angle after cylinder 1, in degrees."""
    if intervals is None:
        steps = [Fraction(cycle, len(order))] * len(order)
    else:
        given = listed(intervals, "firing_intervals")
        steps = [degrees(step, f"firing_intervals[{i}]").in_degrees() for i, step in enumerate(given, 1)]
        _check_intervals(steps, len(order), cycle)
    starts = [Fraction(0), *accumulate(steps)]
    first = starts[order.index(1)]
    return {number: (start - first) % cycle for number, start in zip(order, starts, strict=False)}


def _check_intervals(steps: list[Fraction], count: int, cycle: int) -> None:
    if len(steps) != count:
        raise SymbalanceError(
            f"firing_intervals of {len(steps)} values",
            f"must hold {count}, one after each firing",
            "the last leads back to the first",
        )
    if min(steps) < 0:
        raise SymbalanceError(
            f"firing_intervals that hold {shown(min(steps))}",
            "must not be negative",
            "use degrees after each firing",
        )
    if sum(steps) != cycle:
        raise SymbalanceError(
            f"firing_intervals that sum to {shown(sum(steps))}",
            f"must sum to {cycle}",
            "720 degrees in a four-stroke, 360 in a two-stroke",
        )


def read_stagger(stagger: Sequence[object] | None, banks: int) -> list[Fraction]:
    """Return each bank's shift towards the front, in pitches."""
    if stagger is None:
        return [Fraction(0)] * banks
    stagger = listed(stagger, "stagger")
    if len(stagger) != banks:
        raise SymbalanceError(
            f"stagger = {shown(stagger)}",
            f"has {len(stagger)} values for {banks} bank(s)",
            "give one value a bank, in pitches",
        )
    return [exact(value, f"stagger[{i}]") for i, value in enumerate(stagger, 1)]


def read_offset(offset: Sequence[object] | None, banks: int) -> list[Fraction | None]:
    """Return each bank's own offset in mm, None where it has none of its own."""
    if offset is None:
        return [None] * banks
    values = listed(offset, "offset")
    if len(values) != banks:
        rule = f"has {len(values)} values for {banks} bank(s)"
        raise SymbalanceError(f"offset = {shown(values)}", rule, "give one value a bank, in mm")
    return [exact(value, f"offset[{i}]") for i, value in enumerate(values, 1)]


def read_firing_at(firing_at: object) -> bool:
    """Tell whether intervals count between dead centres, not between the pins' passing the axes."""
    if firing_at not in FIRING_AT:
        what, rule = f"firing_at = {shown(firing_at)}", f"must be one of {', '.join(FIRING_AT)}"
        raise SymbalanceError(what, rule, "they differ where cylinders are offset")
    return firing_at == "dead centres"


def stations(numbers: list[list[int]], stagger: list[Fraction]) -> dict[int, Fraction]:
    """Return each cylinder's station: banks in pitches from the front, staggered, their mean at 0."""
    raw = {
        number: shift - place
        for bank, shift in zip(numbers, stagger, strict=True)
        for place, number in enumerate(bank)
    }
    mean = sum(raw.values(), Fraction(0)) / len(raw)
    return {number: station - mean for number, station in raw.items()}
