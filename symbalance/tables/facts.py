"""What both printed tables say of an engine before the numbers, and how a component becomes a row."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import sympy
from mpmath import mp

from symbalance.angles import Angle
from symbalance.decimal_phasor import DecimalPhasor
from symbalance.layout import Layout
from symbalance.rational import Real, decimal_text
from symbalance.resultants import Balance, Order, Resultant
from symbalance.spectrum import Component, SymbolicPhasor
from symbalance.tops import firing_dead_centres, has_moved, lead_of

SHOWN_DIGITS = 6
PLAIN_PARTS = 60
"""Parts of pi that a decimal component's phase is recognised in: 3 degrees."""


@dataclass(frozen=True)
class Row:
    """One component of one order, exact and (where it has no symbols) in decimals."""

    order: int
    name: str
    component: Component

    @property
    def has_symbols(self) -> bool:
        """Whether the component depends on a symbolic angle."""
        return isinstance(self.component.number, SymbolicPhasor)

    @property
    def is_decimal(self) -> bool:
        """Whether the component is a number of some digits, with no exact form."""
        return isinstance(self.component.number, DecimalPhasor)

    def decimals(self) -> tuple[str, str, str, str] | None:
        """Return cos, sin, amplitude and phase in decimals, or None with symbols in them."""
        if self.has_symbols:
            return None
        cos, sin = self.component.decimal(SHOWN_DIGITS + 10)
        with mp.workdps(30):  # whatever precision the caller has set
            values = (cos, sin, mp.hypot(cos, sin), mp.atan2(sin, cos))
        cos_text, sin_text, amplitude, phase = (shown(v) for v in values)
        return cos_text, sin_text, amplitude, phase

    def phase_in_turns(self) -> sympy.Expr | None:
        """Return the phase of a decimal component where it is a plain fraction of pi, else None."""
        cos, sin = self.component.decimal(SHOWN_DIGITS + 24)
        with mp.workdps(SHOWN_DIGITS + 30):
            parts = mp.atan2(sin, cos) / mp.pi * PLAIN_PARTS
            near = int(mp.nint(parts))
            return sympy.pi * near / PLAIN_PARTS if abs(parts - near) < mp.mpf(10) ** -20 else None

    def exact(self) -> tuple[sympy.Expr, sympy.Expr, sympy.Expr, sympy.Expr]:
        """Return cos, sin, amplitude and phase exactly; an endless amplitude as the root of C^2 + S^2."""
        part = self.component
        return part.cos, part.sin, _short(part.amplitude), part.phase


def _short(amplitude: Any) -> sympy.Expr:
    squares = amplitude.base.args if amplitude.is_Pow and amplitude.base.is_Add else ()
    if squares and all(square.is_Pow and square.exp == 2 for square in squares):
        return sympy.sqrt(sympy.Symbol("C") ** 2 + sympy.Symbol("S") ** 2)
    return amplitude


def rows(balance: Balance, resultant: str) -> list[Row]:
    """Return the vertical and lateral parts of the force or the couple that do not vanish, by order."""
    return [
        Row(order.order, name, part)
        for order in balance.orders
        for name in ("vertical", "lateral")
        if not (part := _of(order, resultant).component(name)).is_zero()
    ]


def rotating(balance: Balance, resultant: str) -> list[tuple[Row, Row]]:
    """Return each order's forward and backward part; empty where all is in one plane.

    There every order is two equal halves, one turning with the crank and one against it, each with
    half the amplitude and the phase of the whole.
    """
    if len({row.name for row in rows(balance, resultant)}) < 2:
        return []
    pairs = []
    for order in balance.orders:
        whole = _of(order, resultant)
        if not whole.is_zero():
            forward = Row(order.order, "forward", whole.forward)
            pairs.append((forward, Row(order.order, "backward", whole.backward)))
    return pairs


def _of(order: Order, resultant: str) -> Resultant:
    return order.force if resultant == "force" else order.couple


NEAR = 20
"""Degrees from a dead centre within which it is named."""
IN_ONE_PLANE = "each order is two equal halves, turning with and against the crank"


def shown(value: Real, digits: int = SHOWN_DIGITS) -> str:
    """Return a decimal as tables print it.

    >>> shown(mp.mpf("7.43790327e-5")), shown(mp.mpf(3))
    ('7.4379e-5', '3')
    """
    text = decimal_text(value, digits)
    mantissa, *exponent = text.split("e")
    mantissa = mantissa.rstrip("0").rstrip(".") if "." in mantissa else mantissa
    return "e".join([mantissa, *exponent])


def strokes(layout: Layout) -> str:
    """Return "four-stroke" or "two-stroke"."""
    return {2: "two-stroke", 4: "four-stroke"}[layout.strokes]


def banks(layout: Layout, printed: Callable[[Angle], str]) -> str:
    """Return where the banks stand, each angle once, in the order of the layout."""
    angles = list(dict.fromkeys(c.bank for c in layout.cylinders))
    if angles == [Angle(Fraction(0))]:
        return "one bank, upright"
    where = ", ".join(map(printed, angles))
    return f"{'banks' if len(angles) > 1 else 'one bank'} at {where} from vertical"


def firing(layout: Layout) -> str:
    """Return the firing order and, where they are uneven, the intervals; empty if it is not known.

    >>> from symbalance.catalogue import load
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


def firing_intervals(layout: Layout) -> list[Fraction]:
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


def origin(layout: Layout, printed: Callable[[Angle], str]) -> str:
    """Return what stands where at theta = 0.

    >>> from symbalance.builders import inline
    >>> origin(inline("1-2"), degrees_text), origin(inline(throws=[30, 90]), degrees_text)
    ('cylinder 1 at firing top dead centre', 'the pin of cylinder 1 at 30 from straight up')
    """
    first = min(layout.cylinders, key=lambda c: c.number)
    dead_centre = f"{'firing ' if first.fires == 0 else ''}top dead centre"
    lead = Fraction(0) if first.delay.symbols else lead_of(layout, first)
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


def plane(balance: Balance) -> str:
    """Return what couples are taken about."""
    if balance.reference is None:
        return "the mean of all stations"
    return f"station {balance.reference}"
