"""Relations with = that are true of a long rod alone, and are written in its angle: F_N = F_K sin β.

Whoever has the rod's angle in a formula has cut off no series: sin β stands for tan β by mistake, though
both are λ sin θ at the first order. Where words say that it is roughly so, it is.
"""

from __future__ import annotations

from symbalance.document.formula import Call, names, parts_of_kind
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.relations import MEANT_ROUGHLY
from symbalance.notes.checking.declared.symbol_roles import role_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.steps.meant_roughly import ROUGH_WORDS
from symbalance.notes.checking.verdicts import CONDITIONAL, HOLDS, HOLDS_TO_ORDER, Verdict
from symbalance.notes.reading.equations import Chain

BEHIND = 60
"""Characters behind a relation in which words may say that it is rough."""


def unless_rough_in_rod_angle(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; refuted for an = between what the rod's angle makes only roughly equal."""
    is_rough = verdict.reason == MEANT_ROUGHLY and chain.relations[k].sign == "="
    if not is_rough or verdict.verdict not in (HOLDS, HOLDS_TO_ORDER, CONDITIONAL):
        return verdict
    symbols = state.declarations.symbols_at(chain.lines[0])
    definitions = state.knowledge(chain.lines[0]).definitions
    own = {n for part in parts_of_kind(chain.sides[k + 1].node, Call) for n in names(part)}
    of_rod = {n for n in own if role_of(symbols.get(n, "")) == "rod angle"}
    of_rod |= {n for n in own if n in definitions and definitions[n].is_rod_angle}
    text = state.document.text
    words = state.sections.sentence_before(chain) + text[chain.end : chain.end + BEHIND]
    if not of_rod or ROUGH_WORDS.search(words):
        return verdict
    reason = "only to the first order of the rod ratio, and its angle stands in it"
    return describe(state.document, chain, k, Decision(REFUTED, reason))
