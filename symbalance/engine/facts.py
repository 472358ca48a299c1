"""What is said of an engine in words: its banks, its firing order, what stands where at theta = 0."""

from __future__ import annotations

from fractions import Fraction

from symbalance.engine.engine import Engine
from symbalance.engine.tops import firing_dead_centres, has_moved, lead_of
from symbalance.exact.angles import Angle

NEAR = 20
"""Degrees from a dead centre within which it is named."""


def strokes(layout: Engine) -> str:
    """Return "four-stroke" or "two-stroke"."""
    return {2: "two-stroke", 4: "four-stroke"}[layout.strokes]


def banks(layout: Engine) -> str:
    """Return where the banks stand, each angle once, in the order of the layout."""
    angles = list(dict.fromkeys(c.bank for c in layout.cylinders))
    if angles == [Angle(Fraction(0))]:
        return "one bank, upright"
    where = ", ".join(map(angle_text, angles))
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
    intervals = [f"{decimal_text(step)}°" for step in steps[:period]]
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


def origin(layout: Engine) -> str:
    """Return what stands where at theta = 0.

    >>> from symbalance.engine.builders import inline
    >>> origin(inline("1-2")), origin(inline(throws=[30, 90]))
    ('cylinder 1 at firing top dead centre', 'the pin of cylinder 1 at 30° from straight up')
    """
    first = min(layout.cylinders, key=lambda c: c.number)
    dead_centre = f"{'firing ' if first.fires == 0 else ''}top dead centre"
    lead = Fraction(0) if first.delay.symbols else lead_of(first)
    if not lead and first.delay == Angle(Fraction(0)):
        return f"cylinder {first.number} at {dead_centre}"
    where = f"the pin of cylinder {first.number} at {angle_text(first.throw)} from straight up"
    past = Fraction(0) if first.delay.symbols else round(first.delay.in_degrees() - lead, 2)
    if not lead or abs(past) > NEAR:
        return where
    side = f"{decimal_text(abs(past))}° {'past' if past > 0 else 'before'} its " if past else "at its "
    return f"{where}, {side}{dead_centre}"


def angle_text(angle: Angle) -> str:
    """Return an angle in degrees, short decimals as decimals and others as fractions; symbols in radians.

    >>> angle_text(Angle(Fraction(-1, 12))), angle_text(Angle(Fraction(1, 7)))
    ('−30°', '360/7°')
    """
    if angle.symbols:
        from symbalance.document.expressions import formula_of
        from symbalance.document.text_writer import formula_text

        return formula_text(formula_of(angle.expression()))
    return f"{decimal_text(angle.in_degrees())}°".replace("-", "−")


def decimal_text(number: Fraction) -> str:
    """Return a number as a decimal where it is short, else as a fraction.

    >>> decimal_text(Fraction(45, 2)), decimal_text(Fraction(360, 7))
    ('22.5', '360/7')
    """
    return f"{float(number):.12g}" if 10_000 % number.denominator == 0 else str(number)
