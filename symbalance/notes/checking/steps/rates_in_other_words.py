"""A frequency said again as a period or an angular frequency: f = 50 Hz, and ω = 314 rad/s.

Where a sentence goes straight on from the number of one to the number of another, and names it ("its
period is", "die Kreisfrequenz"), the second is computed from the first: ω = 2πf and T = 1/f. With any
other words between, of a natural frequency or of another shaft, both are data.
"""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import Constant, Formula, Name, Number, Product, Quotient, names, walk
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.deciding.numbers_put_in import is_lone_number
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.units.dimensions import written_unit
from symbalance.notes.checking.units.printed_digits import rounds_to
from symbalance.notes.checking.verdicts import DEFINITION, PREMISE, Verdict
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

FREQUENCY, ANGULAR, PERIOD = "frequency", "angular frequency", "period"
_NOUNS = {
    ANGULAR: r"(?:angular|circular)\s+(?:frequency|speed|velocity)|kreisfrequenz|winkelgeschwindigkeit"
    r"|pulsation|vitesse\s+angulaire|pulsazione|velocità\s+angolare|pulsación|velocidad\s+angular|角(?:周波数|振動数|速度)",
    PERIOD: r"period(?:endauer)?|schwingungsdauer|umlaufzeit|période|periodo|período|周期",
    FREQUENCY: r"frequency|frequenz|fréquence|frequenza|frecuencia|(?<!角)(?:周波数|振動数)",
}
_LINK = (
    r"(?:[\s$,;:.、。]|\\[,;: ]|\\\)|\\\(|よって|また|その|は|で|(?<![^\W\d_])"
    r"(?:and|so|that|is|thus|hence|i\.\s?e\.|or|therefore|the|its|a|an|corresponding|und|die|der|das|also|somit|ihre|seine|eine|d\.\s?h\.|et|donc|la|le|sa|une|soit|e|quindi|il|lo|sua|y|luego|su|el)"
    r"(?![^\W\d_]))"
)
_IS = r"(?:\s+(?:is|are|equals|ist|beträgt|wird|lautet|est|vaut|è|vale|es|becomes|then)|は|が)*"
_SAID_AGAIN = re.compile(
    rf"{_LINK}{{0,12}}(?:(?P<angular>{_NOUNS[ANGULAR]})|(?P<period>{_NOUNS[PERIOD]})|(?P<frequency>{_NOUNS[FREQUENCY]}))"
    rf"{_IS}[\s$(\\:]*",
    re.IGNORECASE,
)
"""All that stands between the two numbers: links, the noun of the second, and "is"."""
_OF_PERIOD = re.compile(rf"(?:{_NOUNS[PERIOD]}){_IS}[\s$(\\:]*$", re.IGNORECASE)
_SECONDS = ("s", "ms", "µs", "sec")
_TURNS = ("Hz", "kHz", "1/s", "s^-1", "s⁻¹")
_LONGEST = 120
"""Characters before a period in which words call it one."""
_ROUGHLY = 0.02
"""By how much a rate may be rounded beyond its digits, 310 for 314 rad/s: no slip is so small."""


def with_rates_said_again(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a rate said again in another form is computed from the first."""
    right, above = chain.sides[1], state.sections.chain_before(chain.start)
    is_given = (
        not k and verdict.verdict in (DEFINITION, PREMISE) and isinstance(chain.sides[0].node, Name)
    )
    if not is_given or above is None or not is_lone_number(right.node):
        return verdict
    text = state.document.text
    said = _SAID_AGAIN.fullmatch(text, above.sides[-1].span[1], chain.start)
    first = None if said is None else _rate_above(state, above)
    if said is None or first is None:
        return verdict
    kind = {"angular": ANGULAR, "period": PERIOD, "frequency": FREQUENCY}[said.lastgroup or ""]
    if kind == first[1]:
        return verdict
    knowledge = state.knowledge(chain.lines[0])
    exact, typed = number_of(_in_form(kind, *first), knowledge), number_of(right.node, knowledge)
    if not exact or not typed:
        return verdict
    sources = [state.document.source(side.span) for side in (right, above.sides[-1])]
    shown = f"{plain_text(above.sides[0].node)} = {text[slice(*above.sides[-1].span)]}"
    decision = Decision(REFUTED, f"not the {kind} of {shown}")
    if rounds_to(float(exact), float(typed), *sources):
        decision = Decision(PROVED, f"the {kind} of {shown}")
    elif abs(float(typed) / float(exact) - 1) < _ROUGHLY:
        return verdict  # 310 rad/s, said roughly
    return describe(state.document, chain, k, decision)


def _rate_above(state: JudgingState, above: Chain) -> tuple[Formula, str] | None:
    """Return the rate by the second that a relation ends in, or its period, and which of them it is."""
    value, text = above.sides[-1], state.document.text
    unit = written_unit(state.document.source(value.span))[1]
    if names(value.node) or not is_lone_number(value.node) or not isinstance(above.sides[0].node, Name):
        return None
    if unit in ("rad/s", "rad s^-1", "rad s⁻¹"):
        return value.node, ANGULAR
    if _is_by_the_minute(unit):  # read in turns or in radians, as the page's formulas want it
        return value.node, ANGULAR if Constant("pi") in walk(value.node) else FREQUENCY
    if unit in _TURNS[:2] or (unit in _TURNS and above.sides[0].node.name.startswith(("f", "nu"))):
        return value.node, FREQUENCY
    before = text[max(0, above.start - _LONGEST) : above.start]
    return (value.node, PERIOD) if unit in _SECONDS and _OF_PERIOD.search(before) else None


def _is_by_the_minute(unit: str) -> bool:
    return unit in ("rpm", "min^-1", "min⁻¹", "1/min", "U/min", "tr/min", "giri/min")


def _in_form(kind: str, value: Formula, given: str) -> Formula:
    """Return the formula that turns a rate or a period into the form named."""
    turn = Product((Number(Fraction(2)), Constant("pi")))
    if given == PERIOD:
        return Quotient(turn if kind == ANGULAR else Number(Fraction(1)), value)
    if kind == PERIOD:
        return Quotient(turn if given == ANGULAR else Number(Fraction(1)), value)
    return Product((turn, value)) if kind == ANGULAR else Quotient(value, turn)
