"""Largest, smallest and mean values in numbers, of a formula above: M = 100 + 50 sin 2θ, M_max = 150.

The formula right above has one angle without a value, and everything else in numbers. It is followed
through a turn. That such a number is right is known by numbers alone, to the digits printed.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from math import tau

from symbalance.document.formula import Name, Number, names
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.algebra.letters_in_waves import letters_in_waves
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.deciding.numbers_put_in import is_lone_number
from symbalance.notes.checking.deciding.substitution import put_in
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.units.printed_digits import rounds_to
from symbalance.notes.checking.units.rounded_wholes import DIGITS_PRINTED
from symbalance.notes.checking.verdicts import DEFINITION, PREMISE, Verdict
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_NOUNS = {
    "largest": r"largest|greatest|highest|maxim|peak|größt|höchst|massim|máxim|最大",
    "smallest": r"smallest|least|lowest|minim|kleinst|niedrigst|mínim|最小",
    "mean": r"mean|average|mittel|mittler|moyen|medi[oa]|平均",
}
_ENDS = {"max": "largest", "min": "smallest", "m": "mean", "mean": "mean", "mittel": "mean", "av": "mean"}
_PART = re.compile(r"(?P<stem>.+)_(?P<end>max|min|m|mean|mittel|av)")
_OF_A_PART = re.compile(
    r"between|from|within|zwischen|von|entre|permiss|allow|zuläss|admis|rated|nominal|rms|effekti|half|first|second",
    re.IGNORECASE,
)
"""Words of an extreme that is not that of a whole turn, or is no extreme of the formula."""
_STEPS, _THIRDS = 96, 40
"""Places of a turn that are looked at: their mean is exact for every order below that number. And how
often the neighbourhood of the best one loses a third: to a ten-millionth of itself."""
_REACH = 120
"""Characters before a number in which words say what it is."""
_TINY = 1e-9
"""By how much a zero is missed that floating-point numbers come to."""


def unless_no_such_value(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a number said to be the largest, smallest or mean value is computed."""
    head, right = chain.sides[0].node, chain.sides[1]
    match = _PART.fullmatch(head.name) if isinstance(head, Name) else None
    is_open = not k and verdict.verdict in (DEFINITION, PREMISE) and chain.relations[0].sign in "=≈"
    if match is None or not is_open or not is_lone_number(right.node):
        return verdict
    kind = _ENDS[match["end"]]
    before = state.document.text[max(0, chain.start - _REACH) : chain.start]
    sentence = re.split(r"[.;。]\s", before)[-1]
    if not re.search(_NOUNS[kind], sentence, re.IGNORECASE) or _OF_A_PART.search(sentence):
        return verdict
    found = _formula(state, chain, match["stem"])
    values = (
        _between_ends(state, chain, match["stem"], kind) if found is None else _over_turn(found[0], kind)
    )
    if values is None:
        return verdict
    of = f" of line {found[1]} over a turn" if found else " between its ends"
    formula = f"{plain_text(Name(match['stem']))}{of}"
    typed = number_of(right.node, state.knowledge(chain.lines[0]))
    source = state.document.source(right.span)
    if typed is None:
        return verdict
    if any(abs(value - typed) < _TINY or rounds_to(value, float(typed), source) for value in values):
        holds = Decision(PROVED, f"the {kind} value of {formula}, by numbers", order=DIGITS_PRINTED)
        return describe(state.document, chain, k, holds)
    reason = f"the {kind} value of {formula} is {values[0]:.6g} in SI units"
    return describe(state.document, chain, k, Decision(REFUTED, reason))


def _between_ends(state: JudgingState, chain: Chain, stem: str, kind: str) -> tuple[float, ...] | None:
    """Return the mean of the largest and the smallest value of a letter, where the page has both."""
    knowledge = state.knowledge(chain.lines[0])
    ends = [knowledge.definitions.get(f"{stem}_{end}") for end in ("max", "min")]
    sizes = [number_of(d.node, knowledge) for d in ends if d is not None and d.numeric]
    if kind != "mean" or len(sizes) != 2 or None in sizes:
        return None
    return (float(sizes[0] + sizes[1]) / 2,)


def _formula(
    state: JudgingState, chain: Chain, stem: str
) -> tuple[Callable[[float], float | None], int] | None:
    """Return a letter's formula above as a function of its one angle, and its line."""
    above = state.sections.last_above(Name(stem), chain.start)
    if above is None or not state.sections.same_section(above.lines[0], chain.lines[0]):
        return None
    node = next((side.node for side in above.sides[1:] if names(side.node)), None)
    if node is None:
        return None
    knowledge = state.knowledge(chain.lines[0])
    turning = letters_in_waves(node)
    numbers = {n: d.node for n, d in knowledge.definitions.items() if d.numeric and n not in turning}
    if len(turning) != 1 or names(node) - turning - numbers.keys():
        return None
    (angle,) = turning

    def value(at: float) -> float | None:
        try:
            number = number_of(put_in(node, {**numbers, angle: Number(Fraction(at))}), knowledge)
        except NoFormError:
            return None
        return None if number is None else float(number)

    return value, above.lines[0]


def _over_turn(value: Callable[[float], float | None], kind: str) -> tuple[float, ...] | None:
    """Return the extreme or the mean over a turn, and the largest size where it is another number."""
    places = [tau * n / _STEPS for n in range(_STEPS)]
    found = [value(place) for place in places]
    values = [each for each in found if each is not None]
    if len(values) < _STEPS:
        return None
    if kind == "mean":
        return (sum(values) / _STEPS,)
    sign = 1 if kind == "largest" else -1
    best = max(range(_STEPS), key=lambda n: sign * values[n])
    extreme = _refined(lambda at: sign * (value(at) or 0.0), places[best])
    sizes = (max(map(abs, values)),) if kind == "largest" else ()
    return (sign * extreme, *sizes)


def _refined(value: Callable[[float], float], place: float) -> float:
    """Return the largest value near a place, by thirds."""
    low, high = place - tau / _STEPS, place + tau / _STEPS
    for _ in range(_THIRDS):
        first, second = low + (high - low) / 3, high - (high - low) / 3
        low, high = (first, high) if value(first) < value(second) else (low, second)
    return value((low + high) / 2)
