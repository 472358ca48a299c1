"""Numbers put in on pages of inches and pounds: q = 1.98 × 15.71² × 1/32.2, with r in feet there.

Old books say once in which unit a letter is meant, and type bare numbers. Where these come to another
size than the letters do, by what an inch, a foot, a pound or gravity is, the units are left out.
"""

from __future__ import annotations

import math
from itertools import product

from symbalance.document.formula import Name, names
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import UNDECIDED, Decision
from symbalance.notes.checking.deciding.numbers_put_in import is_lone_number
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONTRADICTION, REFUTED, Verdict
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_ENGLISH = re.compile(
    r"(?<![A-Za-z])(?:lbs?\.|lb\b|ft\.|feet|inch(?:es)?|in\.(?=[\s³⁴,;]))", re.IGNORECASE
)
_INCH, _FOOT, _POUND, _GRAVITY = 0.0254, 0.3048, 0.45359237, 9.80665
_UNITS = (_INCH, _FOOT, _POUND, _GRAVITY, _FOOT / _INCH)
_CLOSE = 2e-3
"""Part by which the sizes may be off a product of units, as numbers are rounded."""


def unless_in_english_units(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; open where bare numbers are a unit of feet or pounds away from their letters."""
    left, right = chain.sides[0].node, chain.sides[k + 1].node
    if verdict.verdict not in (REFUTED, CONTRADICTION) or names(right) or not isinstance(left, Name):
        return verdict
    if k or is_lone_number(right) or not _ENGLISH.search(state.document.text):
        return verdict
    knowledge = state.knowledge(chain.lines[0])
    formula = next(
        (c for c in reversed(state.sections.chains_above(left, chain.start)) if names(c.sides[1].node)),
        None,
    )
    exact = None if formula is None else number_of(formula.sides[1].node, knowledge)
    typed = number_of(right, knowledge)
    if not exact or not typed or not _are_units_apart(abs(float(typed) / float(exact))):
        return verdict
    reason = "the numbers come to it but for units of inches and pounds that are left out"
    return describe(state.document, chain, k, Decision(UNDECIDED, reason))


def _are_units_apart(ratio: float) -> bool:
    """Tell whether a ratio is a product of two units or their inverses, and no power of ten."""
    singles = [unit**power for unit in _UNITS for power in (1, -1)]
    pairs = [a * b for a, b in product(singles, repeat=2)]
    return any(math.isclose(ratio, each, rel_tol=_CLOSE) for each in (*singles, *pairs) if each != 1)
