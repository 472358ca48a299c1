"""Coefficients of fluctuation beside a tolerance of the speed: for ± 0.5 % it is C_s = 0.01, not 0.005.

The coefficient is the whole way between the greatest and the least speed over the mean one, a tolerance
is half of it to each side. Where the page defines it as half the difference nothing is said.
"""

from __future__ import annotations

from dataclasses import replace
from math import isclose

from symbalance.document.formula import Name, Number, names, walk
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import DEFINITION, PREMISE, UNDECIDED, Verdict
from symbalance.notes.reading.equations import Chain
from symbalance.notes.reading.formulas.result_units import value_of
from symbalance.text import lazy_patterns as re

_COEFFICIENT = re.compile(
    r"(?:coefficient|degree|ratio)\s+of\s+(?:the\s+)?(?:cyclic\s+)?(?:speed\s+)?(?:fluctuation|irregularity|non-?uniformity)"
    r"|(?:cyclic\s+)?(?:speed\s+)?fluctuation\s+coefficient|ungleichförmigkeitsgrad"
    r"|(?:coefficient|degré)\s+(?:d['’]irrégularité|de\s+fluctuation)|(?:grado|coefficiente)\s+d(?:i\s+|['’])(?:irregolarità|fluttuazione)"
    r"|(?:coeficiente|grado)\s+de\s+(?:fluctuación|irregularidad)|(?:速度|回転)変動率|不(?:規則|等)[度率]",
    re.IGNORECASE,
)
"""Words for the difference of the greatest and the least speed over the mean one."""
_TOLERANCE = re.compile(
    r"(?:±|\\pm(?![A-Za-z])|\+/-|plus\s+or\s+minus|plus\s+oder\s+minus)[\s$]{0,3}(?P<number>[0-9]+(?:(?:[.,]|\{,\})[0-9]+)?)[\s~$]{0,3}"
    r"(?:\\[,;: ])?\s?\\?(?:%|％|percent|per\s+cent|Prozent|pour\s?cent)"
)
"""A tolerance to both sides: ± 0.5 %."""
_BETWEEN_BOTH = re.compile(
    r"total|whole|overall|insgesamt|gesamt|from\s+peak\s+to\s+peak|peak[- ]to[- ]peak|全体", re.IGNORECASE
)
_FAR = 1e-9


def unless_half_fluctuation(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a coefficient of fluctuation beside a tolerance of its sentence is twice that."""
    head, value = chain.sides[0].node, chain.sides[1].node
    is_open = verdict.verdict in (DEFINITION, PREMISE, UNDECIDED)
    if (
        k
        or not is_open
        or not isinstance(head, Name)
        or names(value)
        or chain.relations[0].sign not in "=≈"
    ):
        return verdict
    sentence = state.sections.sentence_before(chain)
    tolerances = list(_TOLERANCE.finditer(sentence))
    number = value_of(value)
    if len(tolerances) != 1 or not number or _BETWEEN_BOTH.search(sentence):
        return verdict
    if not _is_coefficient(state, head, chain, sentence) or _is_halved(state, head):
        return verdict
    typed = tolerances[0]["number"]
    half = float(typed.replace("{,}", ".").replace(",", ".")) / 100
    said = f"± {typed} % is {2 * half:g} from the least to the greatest speed"
    if isclose(number, 2 * half, rel_tol=_FAR):
        return describe(state.document, chain, k, Decision(PROVED, assumptions=(said,)))
    if not isclose(number, half, rel_tol=_FAR):
        return verdict
    state.definitions.forget(head.name, chain.lines[0])
    return replace(describe(state.document, chain, k, Decision(REFUTED, said)), fix=None)


def _is_coefficient(state: JudgingState, head: Name, chain: Chain, sentence: str) -> bool:
    """Tell whether a letter is declared as a coefficient of fluctuation, or called so on the page."""
    meaning = state.declarations.symbols_at(chain.lines[0]).get(head.name, "")
    if meaning or _COEFFICIENT.search(sentence):
        return _COEFFICIENT.search(meaning or sentence) is not None
    first = state.sections.chains_of(head)[0]
    return _COEFFICIENT.search(state.sections.sentence_before(first)) is not None


def _is_halved(state: JudgingState, head: Name) -> bool:
    """Tell whether the page defines a letter by a formula with a number in it: (ω_1 - ω_2)/(2 ω)."""
    formulas = [
        side.node for c in state.sections.chains_of(head) for side in c.sides[1:] if names(side.node)
    ]
    parts = (part for node in formulas for part in walk(node))
    return any(isinstance(part, Number) and part.value == 2 for part in parts)
