"""What tables say of an engine's counterweights and balance shafts, one line each."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import sympy

from symbalance.document.expressions import latex, text
from symbalance.engine.balancers import BalanceShaft, Counterweight, Weight
from symbalance.engine.engine import Engine
from symbalance.exact.amplitude import Amplitude
from symbalance.exact.spectrum import Component
from symbalance.text.reals import atan2, nstr, pi

LONGEST = 34
"""An exact size whose text is longer than this is printed rounded."""


@dataclass(frozen=True)
class Style:
    """How numbers and angles are printed: as text, or as LaTeX."""

    number: Callable[[Any], str]
    degree: str
    nearly: str
    math: Callable[[str], str]


TEXT = Style(text, "°", "≈ ", lambda formula: formula)
LATEX = Style(latex, r"^\circ", r"\approx ", lambda formula: rf"\({formula}\)")


def balancer_lines(layout: Engine, style: Style = TEXT) -> list[str]:
    """Return what is said of the balancers of an engine, and of rotating masses it takes as balanced.

    >>> from symbalance.engine.builders import inline
    >>> single = inline("1").balanced_by(Counterweight(throw=1, overbalance="1/2"))
    >>> balancer_lines(single.balanced_by(BalanceShaft(-1, [Weight(share="1/2", phase=180)])))[1]
    'shaft at -1 times the crank: share 1/2 at 180°, station 0'
    """
    found = layout.balancers
    if not found.counterweights:
        turning = [c for c in layout.cylinders if c.rotating_mass]
        lines = ["rotating masses are taken as balanced, throw by throw"] if turning else []
        if layout.has_link_pin_masses:
            lines.append("but for what link pins move those on them beside the crank pins")
    else:
        lines = [_counterweight(c, style) for c in found.counterweights]
    return lines + [_shaft(s, style) for s in found.shafts]


def _counterweight(counterweight: Counterweight, style: Style) -> str:
    where = [f"throw {counterweight.throw}"] if counterweight.throw else []
    where += [f"web {counterweight.web}"] if counterweight.web else []
    opposite = ", from opposite its pin" if where else ""
    if counterweight.station is not None or not where:
        where.append(f"station {style.math(str(counterweight.station or 0))}")
    head = f"counterweight on {', '.join(where)}: "
    if counterweight.weight is None:
        share = style.math(style.number(_rational(counterweight.overbalance)))
        tail = f" from opposite the pin, by {counterweight.angle.as_text()} degrees"
        turned = tail if counterweight.angle.turns or counterweight.angle.symbols else ""
        return f"{head}for its rotating mass and {share} of its reciprocating mass{turned}"
    return head + _size(counterweight.weight.vector, counterweight.weight.in_kg_mm, style) + opposite


def _shaft(shaft: BalanceShaft, style: Style) -> str:
    turned = shaft.phase.turns or shaft.phase.symbols
    phase = f", from {shaft.phase.as_text()} degrees" if turned else ""
    weights = "; ".join(_weight(w, style) for w in shaft.weights)
    at = f", axis at x = {float(shaft.x):g}, y = {float(shaft.y):g} mm" if shaft.x or shaft.y else ""
    return f"shaft at {style.math(f'{shaft.speed:+d}')} times the crank: {weights}{phase}{at}"


def _weight(weight: Weight, style: Style) -> str:
    station = style.math(str(weight.station))
    return f"{_size(weight.vector, weight.in_kg_mm, style)}, station {station}"


def _size(vector: Amplitude, in_kg_mm: bool, style: Style) -> str:
    printed, unit = size(vector, style), " kg mm" if in_kg_mm else ""
    return f"{'' if in_kg_mm else 'share '}{style.math(printed)}{unit} at {direction(vector, style)}"


def size(vector: Amplitude, style: Style = TEXT) -> str:
    """Return a weight's size: exactly if that is short, else rounded."""
    part = Component(vector)
    exact = style.number(part.amplitude)
    if len(text(part.amplitude)) <= LONGEST and not part.amplitude.has(sympy.Float):
        return exact
    return exact if vector.has_symbols else style.nearly + rounded(size_of(vector))


def nearly(vector: Amplitude, style: Style = TEXT) -> str:
    """Return a weight's size rounded, empty where the exact one says it all or symbols stand in it."""
    exact = size(vector, style)
    if vector.has_symbols or exact.startswith(style.nearly):
        return ""
    near = rounded(size_of(vector)).removesuffix(".0")
    return "" if near == exact else near


def size_of(vector: Amplitude) -> Any:
    """Return a weight's size in decimals."""
    return vector.size()


def rounded(value: Any) -> str:
    """Return a decimal to five digits."""
    return nstr(value, 5)


def direction(vector: Amplitude, style: Style = TEXT) -> str:
    """Return a weight's direction in degrees from straight up, rounded where it is no fine fraction.

    >>> from symbalance.exact.phasor import Phasor
    >>> direction(Phasor.root(Fraction(1, 7))), direction(Phasor.of(4, {0: 3, 1: 1}))
    ('360/7°', '≈ 18.435°')
    """
    phase = Component(vector).phase
    turned = phase * 180 / sympy.pi
    if turned.is_Rational:
        return style.math(f"{style.number(turned)}{style.degree}")
    if vector.has_symbols:
        return style.math(style.number(phase))
    near = vector.evaluated()
    degrees = atan2(near.imag, near.real) * 180 / pi()
    return style.math(f"{style.nearly}{rounded(degrees)}{style.degree}")


def _rational(number: Fraction | None) -> sympy.Expr:
    return sympy.Rational(0) if number is None else sympy.Rational(number.numerator, number.denominator)
