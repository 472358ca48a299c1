"""A crank that a page does not let turn steadily: θ = ω t + α t², ω = ω_0 + α t, θ̈ = α, or ω̇ ≠ 0.

The declared crank turns with ω, and a speed is a constant. From a line on that says otherwise the angle
and the speed change as the line has it, and the velocities, accelerations and inertia forces that the
declared motion gives are those of another crank: nothing is known of them.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction

from symbalance.document.formula import (
    Derivative,
    Formula,
    Name,
    Number,
    Product,
    Quotient,
    Span,
    Sum,
    names,
    walk,
)
from symbalance.notes.algebra.evaluation import SymbolValue, derivative_name
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.declared.sidecar import Declarations
from symbalance.notes.checking.declared.symbol_roles import letters_by_role
from symbalance.notes.checking.meant.motion_in_time import time_letter
from symbalance.notes.checking.units.dimensions import Dimensions
from symbalance.notes.reading.equations import ReadNotes

_ZERO = Number(Fraction(0))


@dataclass(frozen=True, slots=True)
class VaryingSpeed:
    """What a line says of how a letter changes with the time: the angle's rate, or the speed's."""

    line: int
    place: tuple[Span, Span]
    letter: str
    rate: Formula
    speed: str
    time: str


def varying_speed(page: ReadNotes, declarations: Declarations) -> VaryingSpeed | None:
    """Return the first line of a page that lets its declared crank turn otherwise than steadily."""
    roles, time = letters_by_role(declarations.symbols), time_letter(page, declarations)
    angles, speeds = roles.get("crank angle", []), roles.get("angular speed", [])
    if time is None or not angles or not speeds:
        return None
    dimensions = Dimensions(declarations.symbols, {})
    for chain in page.chains:
        for k, relation in enumerate(chain.relations):
            left, right = chain.sides[k], chain.sides[k + 1]
            sides = left.node, right.node
            said = next(_rates(sides, relation.sign, angles[0], speeds[0], time), None)
            if said is not None and dimensions.mismatch(*sides, ("", "")) is None:
                return VaryingSpeed(chain.lines[0], (left.span, right.span), *said, speeds[0], time)
    return None


def with_varying_speed(meaning: SymbolValue, said: VaryingSpeed | None, line: int) -> SymbolValue:
    """Return what letters stand for at a line, by the line above it that lets the crank's speed vary."""
    if said is None or line <= said.line:
        return meaning
    values = {
        name: node
        for name, node in meaning.values.items()
        if name != said.time and said.speed not in names_behind(node, meaning.values)
    }
    rates = {name: dict(rate) for name, rate in meaning.rates.items()}
    rates.setdefault(said.time, {})[said.letter] = said.rate
    return replace(meaning, values=values, rates=rates, constant=meaning.constant - {said.speed})


def _rates(
    sides: tuple[Formula, Formula], sign: str, angle: str, speed: str, time: str
) -> Iterator[tuple[str, Formula]]:
    """Yield a letter and its rate by which a relation does not let the crank turn steadily."""
    own_rate = {Derivative(Name(angle), Name(time), 2), Derivative(Name(speed), Name(time))}
    for head, value in (sides, sides[::-1]):
        if head in own_rate and sign == "≠" and value == _ZERO:
            yield speed, Name(derivative_name(Derivative(Name(speed), Name(time))))
        elif sign != "=":
            continue
        elif head in own_rate and not names(value) & {angle, speed} and value not in (_ZERO, *own_rate):
            yield speed, value
        elif head == Name(speed) and not _is_steady(value, angle, speed, time):
            yield speed, Derivative(value, Name(time))
        elif head == Name(angle) and not _is_linear(value, angle, time):
            yield angle, Derivative(value, Name(time))


def _is_steady(value: Formula, angle: str, speed: str, time: str) -> bool:
    """Tell whether a speed is no formula of angle or time, or an angle over its time: θ/t, dθ/dt."""
    is_rate = any(isinstance(part, Derivative) for part in walk(value))
    if is_rate or speed in names(value) or not names(value) & {angle, time}:
        return True
    return (
        isinstance(value, Quotient) and value.numerator == Name(angle) and value.denominator == Name(time)
    )


def _is_linear(value: Formula, angle: str, time: str) -> bool:
    """Tell whether an angle is a sum of terms of which each has the time once, as a factor, or not."""
    if angle in names(value) or time not in names(value):
        return True
    terms = value.terms if isinstance(value, Sum) else (value,)
    return all(
        time not in names(term)
        or term == Name(time)
        or (
            isinstance(term, Product)
            and sum(time in names(f) for f in term.factors) == 1
            and Name(time) in term.factors
        )
        for term in terms
    )
