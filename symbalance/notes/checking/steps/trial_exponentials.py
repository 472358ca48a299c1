"""Trial solutions without an amplitude: x = e^{st}, put into an equation of motion.

The equation is linear, so what stands before e^{st} cancels and is left out. Dimensions say nothing then.
"""

from __future__ import annotations

from symbalance.document.formula import Call, Formula, Name, Power
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import PREMISE, REFUTED, Verdict
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_TRIED = re.compile(
    r"(?<![^\W\d_])(?:let|put|putting|try|trying|tried|trial|assum\w+|set|setting|substitut\w+|ansatz"
    r"|setze?n?|gesetzt|soit|posons|poser|essa\w+|cherch\w+|pon\w+|prueb\w+)(?![^\W\d_])"
    r"|と(?:お|置|仮定)|仮定|代入",
    re.IGNORECASE,
)
_BEHIND = 16
"""Characters behind a formula in which 「とおく」 stands."""
_BY_DIMENSIONS = "dimensions:"


def unless_trial_exponential(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a premise for x = e^{st} that is tried, whatever x is counted in."""
    is_of_dimensions = verdict.verdict == REFUTED and verdict.reason.startswith(_BY_DIMENSIONS)
    if k or not is_of_dimensions or not isinstance(chain.sides[0].node, Name):
        return verdict
    text = state.document.text
    words = state.sections.sentence_before(chain) + text[chain.end : chain.end + _BEHIND]
    if not _is_exponential(chain.sides[1].node) or not _TRIED.search(words):
        return verdict
    reason = "a trial solution, whose amplitude cancels in a linear equation"
    return describe(state.document, chain, k, Decision(PREMISE, reason))


def _is_exponential(node: Formula) -> bool:
    """Tell whether a formula is e to some power, with nothing before it."""
    if isinstance(node, Call):
        return node.function == "exp"
    return isinstance(node, Power) and node.base == Name("e")
