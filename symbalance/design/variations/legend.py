"""Explanation of units and letters, shared by the documents of `symbalance.design.variations`."""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import Formula, Name, Upright
from symbalance.document.nodes import Words
from symbalance.engine.engine import Engine

MASS, RADIUS, PITCH, OMEGA = Name("m"), Name("r"), Name("a"), Name("omega")
Entry = tuple[Words, Words]
"""A name and what is said of it."""
TURNING: Entry = (
    "what turns",
    "counterweights, shafts and rotating masses stay where they are; a size moves pistons and rods",
)
AS_BUILT: Entry = (
    "what turns",
    "counterweights, shafts and rotating masses count as built, without errors",
)


def unit_formulas(engine: Engine, at_speed: bool, mass: Formula = MASS) -> tuple[Formula, Formula]:
    """Return the units of force and couple: `mass` r omega^2 (a), or at a speed N and N m.

    >>> from symbalance.document.text_writer import formula_text
    >>> from symbalance.engine.builders import inline
    >>> engine = inline("1-2")
    >>> [formula_text(unit) for at_speed in (False, True) for unit in unit_formulas(engine, at_speed)]
    ['m r ω²', 'm r ω² a', 'N', 'N a']
    """
    if at_speed:
        return Upright("N"), Upright("N") * (PITCH if engine.pitch is None else Upright("m"))
    force = mass * RADIUS * OMEGA**2
    return force, force * PITCH


def letters_entry(engine: Engine) -> Entry:
    """Return what m, r and a are."""
    first = engine.first.number
    return (
        (MASS, ", ", RADIUS, ", ", PITCH),
        f"reciprocating mass and crank radius of cylinder {first}, cylinder pitch",
    )


def as_decimal(number: Fraction) -> str:
    """Return a number as a decimal where it ends soon, else as a fraction.

    >>> as_decimal(Fraction(1, 2)), as_decimal(Fraction(3000)), as_decimal(Fraction(1, 3))
    ('0.5', '3000', '1/3')
    """
    return f"{float(number):.12g}" if 10**9 % number.denominator == 0 else str(number)
