"""Speeds of one subscript in two units: at n_0 = 800 rpm it is ω_0 = 83.8 rad/s, and f_0 = ω_0/2π.

Who writes both with one subscript means one speed. A value is right by itself then, and wrong where a
factor is off that is usual, as another one may be of another shaft.
"""

from __future__ import annotations

import math

from symbalance.document.formula import Name, Product, names
from symbalance.document.letters import plain_letter
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.steps.angular_speeds_by_turns import (
    ROUNDED,
    USUAL_FACTORS,
    is_of_another_shaft,
)
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.units.rounded_wholes import DIGITS_PRINTED
from symbalance.notes.checking.verdicts import DEFINITION, PREMISE, UNDECIDED, Verdict
from symbalance.notes.reading.equations import Chain, Side
from symbalance.text import lazy_patterns as re

_INDEXED = re.compile(r"(?P<stem>omega|Omega|f|n|N)_(?P<index>\w+)")
_TURNING, _COUNTED = ("omega", "Omega"), ("n", "N", "f")
_OF_ONE_SPEED: dict[str, tuple[str, ...]] = {
    **dict.fromkeys(_TURNING, _COUNTED),
    **dict.fromkeys(_COUNTED, ("omega",)),
}
"""The letters that give the same speed in another unit."""
_BY_MINUTE = re.compile(r"min|r\.?\s?p\.?\s?m", re.IGNORECASE)
_BY_SECOND = re.compile(r"rad|hz|hertz|(?<![A-Za-z])s(?:ec|econd)?(?![A-Za-z])", re.IGNORECASE)
"""The time that a speed's unit has."""
_BEHIND = 14


def by_speed_of_one_index(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; that on a speed in numbers by the one with its subscript in another unit."""
    head = chain.sides[0].node
    if not isinstance(head, Name) or (match := _INDEXED.fullmatch(head.name)) is None:
        return verdict
    is_open = not k and len(chain.relations) == 1 and verdict.verdict in (DEFINITION, PREMISE, UNDECIDED)
    if not is_open or is_of_another_shaft(state.sections.sentence_before(chain)):
        return verdict
    typed = _speed(state, head.name, chain.sides[1], chain.lines[0])
    if typed is None or state.sections.chains_above(head, chain.start):
        return verdict
    for stem in _OF_ONE_SPEED[match["stem"]]:
        other = f"{stem}_{match['index']}"
        there = _above(state, chain, other)
        if there is None:
            continue
        ratio = typed / there
        shown = f"{plain_letter(other)} is {there:.4g} rad/s"
        if math.isclose(ratio, 1, rel_tol=ROUNDED):
            return describe(state.document, chain, k, Decision(PROVED, shown, order=DIGITS_PRINTED))
        if any(math.isclose(ratio, factor, rel_tol=ROUNDED) for factor in USUAL_FACTORS):
            return describe(state.document, chain, k, Decision(REFUTED, shown))
    return verdict


def _above(state: JudgingState, chain: Chain, name: str) -> float | None:
    """Return the last speed that a letter has above in its section, in radians a second."""
    for above in reversed(state.sections.chains_above(Name(name), chain.start)):
        if not state.sections.same_section(above.lines[0], chain.lines[0]):
            return None
        if above.sides[1].span[0] in state.refuted:
            return None
        return _speed(state, name, above.sides[-1], above.lines[0])
    return None


def _speed(state: JudgingState, name: str, side: Side, line: int) -> float | None:
    """Return the printed speed of a letter in radians a second, None where its unit has no time."""
    number = None if names(side.node) else number_of(side.node, state.knowledge(line))
    source = re.split(r",\s", state.document.text[side.span[0] : side.span[1] + _BEHIND])[0]
    is_by_minute = _BY_MINUTE.search(source) is not None
    if not number or not (is_by_minute or _BY_SECOND.search(source)):
        return None
    if is_by_minute and not isinstance(side.node, Product):  # the page counts it in 2π N/60
        if re.sub(r"[^0-9].*", "", source.lstrip("\\SI{ $")) != f"{float(number):.0f}":
            return None
        number /= 60
    return float(number) * (1.0 if "mega" in name else 2 * math.pi)
