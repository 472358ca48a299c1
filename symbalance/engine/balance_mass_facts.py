"""Counterweights and balance shafts described in words, one line each, for every engine's document."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any

from symbalance.document.formula import Decimal
from symbalance.document.nodes import Words
from symbalance.document.text_writer import formula_text
from symbalance.engine.balance_masses import BalanceShaft, Counterweight, Weight
from symbalance.engine.engine import Engine
from symbalance.engine.rotating_masses import share_sign
from symbalance.exact.amplitude import Amplitude
from symbalance.exact.phasor import Phasor
from symbalance.exact.radicals import ClosedForm
from symbalance.exact.spectrum import Component
from symbalance.text.reals import atan2, nstr, pi

LONGEST = 34
"""An exact size whose text is longer than this is written rounded."""


def balancer_facts(engine: Engine) -> list[Words]:
    """Return what is said of the balancers of an engine, and of rotating masses it takes as balanced.

    >>> from symbalance.document.fitting import plain_words
    >>> from symbalance.engine.builders import inline
    >>> single = inline("1").balanced_by(BalanceShaft(-1, [Weight(share="1/2", phase=180)]))
    >>> plain_words(balancer_facts(single)[0])
    'shaft at −1 times the crank: share 1/2 at 180°, station 0'
    """
    balancers = engine.balancers
    groups: list[list[Counterweight]] = []
    for counterweight in balancers.counterweights:
        if groups and _are_alike(groups[-1][-1], counterweight):
            groups[-1].append(counterweight)
        else:
            groups.append([counterweight])
    facts: list[Words] = [_counterweights(group) for group in groups]
    if not facts:
        if any(c.rotating_mass for c in engine.cylinders):
            facts.append("rotating masses are taken as balanced, throw by throw")
        if engine.has_link_pin_masses:
            facts.append("but for what link pins move those on them beside the crank pins")
    return facts + [_shaft(s, share_sign(engine, s.speed)) for s in balancers.shafts]


def _are_alike(one: Counterweight, other: Counterweight) -> bool:
    """Tell whether two counterweights differ in no more than the place where they are."""
    has_places = [(c.throw is None, c.web is None, c.station is None) for c in (one, other)]
    sizes = [(c.angle, c.weight, c.overbalance) for c in (one, other)]
    return has_places[0] == has_places[1] and sizes[0] == sizes[1]


def _counterweights(alike: Sequence[Counterweight]) -> Words:
    first = alike[0]
    where = [_places("throw", [c.throw for c in alike])] if first.throw else []
    where += [_places("web", [c.web for c in alike])] if first.web else []
    opposite = ", from opposite its pin" if where else ""
    if first.station is not None or not where:
        where.append(_places("station", [c.station for c in alike]))
    several = len(alike) > 1
    head = f"counterweight{'s' * several} on {', '.join(where)}: {'each ' * several}"
    if first.weight is None:
        share = first.overbalance or 0
        tail = f" from opposite the pin, by {first.angle.as_text()} degrees"
        direction = tail if first.angle.turns or first.angle.symbols else ""
        return f"{head}for its rotating mass and {share} of its reciprocating mass{direction}"
    return (head, *_size(first.weight.vector, first.weight.in_kg_mm), opposite)


MOST_PLACES = 4
"""Places that are listed one by one where they are evenly apart."""


def _places(name: str, places: Sequence[int | Fraction | None]) -> str:
    """Return places with what they are; of many that are evenly apart the first two and the last.

    >>> _places("throw", [1, 3, 5]), _places("station", [Fraction(n, 2) for n in (5, 3, 1, -1, -3)])
    ('throws 1, 3 and 5', 'stations 5/2, 3/2, …, −3/2')
    """
    *before, last = (with_minus(Fraction(place or 0)) for place in places)
    steps = {Fraction(b or 0) - Fraction(a or 0) for a, b in pairwise(places)}
    if len(places) > MOST_PLACES and len(steps) == 1:
        return f"{name}s {', '.join(before[:2])}, …, {last}"
    return f"{name}s {', '.join(before)} and {last}" if before else f"{name} {last}"


def _shaft(shaft: BalanceShaft, sign: int) -> Words:
    """Return a shaft in words; `sign` is that of what its shares are multiples of."""
    parts: list[Any] = [f"shaft at {shaft.speed:+d} times the crank: ".replace("-", "−")]
    for i, weight in enumerate(shaft.weights):
        parts += ["; "] if i else []
        parts += _weight(weight, 1 if weight.in_kg_mm else sign)
    if shaft.phase.turns or shaft.phase.symbols:
        parts.append(f", from {shaft.phase.as_text()} degrees")
    if shaft.x or shaft.y:
        parts.append(f", axis at x = {float(shaft.x):g}, y = {float(shaft.y):g} mm".replace("-", "−"))
    return tuple(parts)


def _weight(weight: Weight, sign: int) -> tuple[Any, ...]:
    return (*_size(weight.vector, weight.in_kg_mm, sign), f", station {with_minus(weight.station)}")


def _size(vector: Amplitude, in_kg_mm: bool, sign: int = 1) -> tuple[Any, ...]:
    if not in_kg_mm:
        *before, value = size(vector)
        signed = (*before, -value if sign < 0 else value)
        return ("share ", *signed, " at ", *direction(vector.scaled(Fraction(sign))))
    fraction = vector.rational() if isinstance(vector, Phasor) else None
    is_short = fraction is not None and fraction > 0 and 10_000 % fraction.denominator == 0
    measured = (Decimal(f"{float(fraction):.12g}"),) if fraction and is_short else size(vector)
    return (*measured, " kg mm at ", *direction(vector))


def size(vector: Amplitude) -> tuple[Any, ...]:
    """Return a weight's size in words: exactly if that is short, else ≈ and its decimal."""
    component = Component(vector)
    if component.is_long:
        return ("≈ ", Decimal(five_digits(vector.size())))
    exact = component.form("amplitude").as_formula()
    if vector.has_symbols or (not vector.is_decimal and len(formula_text(exact)) <= LONGEST):
        return (exact,)
    return ("≈ ", Decimal(five_digits(vector.size())))


def nearly(vector: Amplitude) -> Words:
    """Return a weight's size rounded, empty where the exact one says it all or symbols stand in it."""
    first, *more = size(vector)
    if vector.has_symbols or more:
        return ""
    near = five_digits(vector.size()).removesuffix(".0")
    return "" if near == formula_text(first) else Decimal(near)


def five_digits(value: Any) -> str:
    """Return a decimal to five digits."""
    return nstr(value, 5)


def direction(vector: Amplitude) -> tuple[Any, ...]:
    """Return a weight's direction in degrees from straight up, rounded where it is no fine fraction.

    >>> from symbalance.document.fitting import plain_words
    >>> from symbalance.exact.phasor import Phasor
    >>> plain_words(direction(Phasor.root(Fraction(1, 7))))
    '360/7°'
    >>> plain_words(direction(Phasor.of(4, {0: 3, 1: 1})))
    '≈ 18.435°'
    """
    component = Component(vector)
    turns = component.phase_in_turns
    if turns is not None:
        return (ClosedForm.rational(turns * 360).as_formula(), "°")
    if vector.has_symbols:
        return (component.form("phase").as_formula(),)
    near = vector.evaluated()
    degrees = atan2(near.imag, near.real) * 180 / pi()
    return ("≈ ", Decimal(five_digits(degrees)), "°")


def with_minus(number: Fraction | int) -> str:
    """Return a number with a minus sign of its own."""
    return str(number).replace("-", "−")
