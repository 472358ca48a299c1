"""What every document about an engine says of the engine itself: its title, and what its letters mean."""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import Name, Upright, cos, equal, sin
from symbalance.document.nodes import Words
from symbalance.engine.balancer_facts import balancer_facts
from symbalance.engine.engine import Engine
from symbalance.engine.facts import banks, firing, origin, strokes
from symbalance.engine.kinds import kind_facts
from symbalance.text.numbers import short_text

_M, _R, _L, _A, _N = Name("m"), Name("r"), Name("l"), Name("a"), Name("n")
_THETA, _LAM = Name("theta"), Name("lam")
_ANGLE = _N * _THETA
WAVE = equal(
    Name("C") * cos(_ANGLE) + Name("S") * sin(_ANGLE),
    Upright("amplitude") * cos(_ANGLE - Upright("phase")),
)
"""What an order's coefficients, amplitude and phase are."""
ORDER: tuple[Words, Words] = (("order ", _N), WAVE)
SIGNS: tuple[Words, Words] = (
    "signs",
    "+ is up or right seen from the front; a couple + pushes the front up or right",
)
"""What directions and couples count as positive."""


def engine_words(engine: Engine) -> str:
    """Return an engine in a line without its name: strokes, cylinders and banks.

    >>> from symbalance.engine.catalogue import load
    >>> engine_words(load("v8-90"))
    'four-stroke, 8 cylinders, banks at 45°, −45° from vertical'
    """
    count = len(engine.cylinders)
    return f"{strokes(engine)}, {count} cylinder{'s' if count > 1 else ''}, {banks(engine)}"


def engine_title(engine: Engine) -> str:
    """Return an engine in a line: its name, strokes, cylinders and banks."""
    return f"{engine.name}: {engine_words(engine)}"


def origin_facts(engine: Engine) -> list[tuple[Words, Words]]:
    """Return the firing order, where it is known, and where the crank angle is counted from."""
    fires = firing(engine)
    entries: list[tuple[Words, Words]] = [("fires", fires)] if fires else []
    entries.append(((_THETA, " = 0"), f"{origin(engine)}; θ runs clockwise seen from the front"))
    return entries


def size_facts(
    engine: Engine, ratio: Fraction | None, *, alike: bool, pitch: bool = True
) -> list[tuple[Words, Words]]:
    """Return what λ, m, r, with `pitch` a, and the letters of unlike cylinders' rods mean.

    `alike` says whether results are in the sizes that all cylinders share, else in cylinder 1's.
    """
    entries: list[tuple[Words, Words]] = []
    letters: Words = (_M, ", ", _R, ", ", _A) if alike and pitch else (_M, ", ", _R)
    if alike:
        here = ", not given" if ratio is None else f", here {short_text(ratio)}"
        entries.append((equal(_LAM, _L / _R), f"connecting rod over crank radius{here}"))
        also = ", cylinder pitch" if pitch else ""
        joined = ", crank radius" if pitch else " and crank radius"
        entries.append((letters, f"reciprocating mass of one cylinder{joined}{also}"))
        return entries
    entries.append((letters, f"reciprocating mass and crank radius of cylinder {engine.first.number}"))
    if pitch:
        entries.append((_A, "cylinder pitch"))
    return entries + kind_facts(engine)


def balancer_entries(engine: Engine) -> list[tuple[Words, Words]]:
    """Return the counterweights and balance shafts of an engine, an entry each."""
    return [("balanced by", said) for said in balancer_facts(engine)]
