"""What both printed tables say of an engine before the numbers, and how a component becomes a row."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from symbalance.engine.engine import Engine
from symbalance.engine.tops import firing_dead_centres, has_moved, lead_of
from symbalance.exact.angles import Angle

NEAR = 20
"""Degrees from a dead centre within which it is named."""


def strokes(layout: Engine) -> str:
    """Return "four-stroke" or "two-stroke"."""
    return {2: "two-stroke", 4: "four-stroke"}[layout.strokes]


def banks(layout: Engine, printed: Callable[[Angle], str]) -> str:
    """Return where the banks stand, each angle once, in the order of the layout."""
    angles = list(dict.fromkeys(c.bank for c in layout.cylinders))
    if angles == [Angle(Fraction(0))]:
        return "one bank, upright"
    where = ", ".join(map(printed, angles))
    return f"{'banks' if len(angles) > 1 else 'one bank'} at {where} from vertical"


def firing(layout: Engine) -> str:
    """Return the firing order and, where they are uneven, the intervals; empty if it is not known.

    >>> from symbalance.engine.catalogue import load
    >>> firing(load("v2-45")), firing(load("v6-90"))
    ('1-2 at intervals of 405°, 315°', '1-6-5-4-3-2 at intervals of 150°, 90°, and so on')
    """
    order = layout.firing_order()
    if order is None or len(order) < 2:
        return ""
    numbers = "-".join(map(str, order))
    steps = firing_intervals(layout)
    apart = ", dead centres apart by" if has_moved(layout) else " at intervals of"
    if len(set(steps)) == 1:
        return numbers
    period = next(k for k in range(1, len(steps) + 1) if steps == (steps[:k] * len(steps))[: len(steps)])
    intervals = [f"{_decimal(step)}°" for step in steps[:period]]
    intervals += ["and so on"] if period < len(steps) else []
    return f"{numbers}{apart} {', '.join(intervals)}"


def firing_intervals(layout: Engine) -> list[Fraction]:
    """Return the degrees after each firing of a layout whose firing angles are known.

    Dead centres that an offset or a link rod has moved count where they are, to 0.01 degrees.
    """
    cycle = 180 * layout.strokes
    if has_moved(layout):
        starts = sorted(round(top, 2) for top in firing_dead_centres(layout).values())
    else:
        starts = sorted(c.fires % cycle for c in layout.cylinders if c.fires is not None)
    ends = [*starts[1:], starts[0] + cycle]
    return [end - start for start, end in zip(starts, ends, strict=True)]


def origin(layout: Engine, printed: Callable[[Angle], str]) -> str:
    """Return what stands where at theta = 0.

    >>> from symbalance.engine.builders import inline
    >>> origin(inline("1-2"), degrees_text), origin(inline(throws=[30, 90]), degrees_text)
    ('cylinder 1 at firing top dead centre', 'the pin of cylinder 1 at 30 from straight up')
    """
    first = min(layout.cylinders, key=lambda c: c.number)
    dead_centre = f"{'firing ' if first.fires == 0 else ''}top dead centre"
    lead = Fraction(0) if first.delay.symbols else lead_of(first)
    if not lead and first.delay == Angle(Fraction(0)):
        return f"cylinder {first.number} at {dead_centre}"
    where = f"the pin of cylinder {first.number} at {printed(first.throw)} from straight up"
    past = Fraction(0) if first.delay.symbols else round(first.delay.in_degrees() - lead, 2)
    if not lead or abs(past) > NEAR:
        return where
    side = f"{_decimal(abs(past))}° {'past' if past > 0 else 'before'} its " if past else "at its "
    return f"{where}, {side}{dead_centre}"


def degrees_text(angle: Angle) -> str:
    """Return a number of degrees, short decimals as decimals and others as fractions."""
    return _decimal(angle.in_degrees())


def _decimal(number: Fraction) -> str:
    return f"{float(number):.12g}" if 10_000 % number.denominator == 0 else str(number)
