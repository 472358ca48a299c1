"""Relations with = that words, or a rough relation above, say are meant roughly: "nearly", "whence".

    It is accurate enough to put cos B = 1 - (sin A)²/(2n²), nearly,
    whence x = R [1 - cos A + (sin A)²/(2n)].

Such a relation is decided as if ≈ stood there. What follows from a rough relation of its section is rough
too, where it keeps the letter in which that was cut off.
"""

from __future__ import annotations

from bisect import bisect_left
from dataclasses import replace

from symbalance.document.formula import Quotient, names
from symbalance.document.letters import plain_letter
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.order_agreement import power_written
from symbalance.notes.checking.deciding.relations import MEANT_ROUGHLY, decide
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.reading.equations import Chain, Side
from symbalance.text import lazy_patterns as re

ROUGH_WORDS = re.compile(
    r"(?<!without )(?<!without any )(?<!ohne )(?<!ohne jede )(?<!sans )(?<!sans aucune )"
    r"(?<!senza )(?<!sin )"
    r"\b(?:nearly|approximat\w+|roughly|neglect\w*|ignoring|disregarding|accurate enough|close enough"
    r"|sufficient(?:ly)? (?:accura\w+|exact\w*)|to (?:a |the )?(?:first|second|good|close) approximation"
    r"|to (?:the )?(?:first|second|lowest|leading) order|for (?:a )?(?:long|small|large)"
    r"|(?:one|two|three|few)[- ]terms?|first (?:two|three) terms|zweigliedrig\w*|dreigliedrig\w*"
    r"|deux termes|due termini|dos términos"
    r"|näherung\w*|annäher\w+|angenähert\w*|genähert\w*|vernachlässig\w*|genau genug|hinreichend genau"
    r"|environ|approximativ\w+|approché\w*|à peu près|sensiblement|en néglige\w+|on néglige"
    r"|approssim\w+|trascura\w+|aproximad\w+|despreci\w+)\b|近似|無視|ほぼ|省略|二項(?:式|まで)",
    re.IGNORECASE,
)
_RATIOS = frozenset({"lambda", "epsilon", "varepsilon", "mu", "rho"})
"""Usual letters of ratios, in which a series is cut off."""
BEHIND = 40
"""Characters behind a relation in which its sentence may say so."""
_SENTENCE_ENDS = re.compile(r"[.;:。；](?:\s|$)|\n\s*\n")


def decide_as_rough(
    state: JudgingState, chain: Chain, k: int, decision: Decision, knowledge: Knowledge
) -> Decision:
    """Return the proof of a refuted relation as a rough one where that is said; else its decision."""
    right = chain.sides[k + 1]
    if chain.relations[k].sign != "=" or not names(right.node):
        return decision
    is_said = is_said_roughly(state, chain)
    if not is_said and not _follows_rough(state, chain):
        return decision
    there = decide(chain.sides[k], right, "≈", knowledge)
    if there.status == REFUTED and there.through is not None and is_said:
        return there  # by the powers that it keeps: which one is wrong is seen there
    if not there.is_proved or there.through is None or not _is_cut_in_ratio(there, right, knowledge):
        return decision
    state.rough_lines.append(chain.lines[0])
    return replace(there, reason=MEANT_ROUGHLY)


def _is_cut_in_ratio(there: Decision, right: Side, knowledge: Knowledge) -> bool:
    """Tell whether a series is one in a ratio that the relation keeps, or in a length that is large."""
    values = {name: each.node for name, each in knowledge.definitions.items()}
    usual = knowledge.crank.small[0] if knowledge.crank is not None and knowledge.crank.small else ""
    for name in names_behind(right.node, values):
        letter = plain_letter(name)
        if letter not in there.order and f"{letter} is large" not in there.assumptions:
            continue
        is_ratio = name == usual or name in knowledge.small or isinstance(values.get(name), Quotient)
        is_ratio = is_ratio or name in _RATIOS or f"{letter} is large" in there.assumptions
        if is_ratio:
            return not _keeps_more(there, right, name, knowledge)
    return False


def _keeps_more(there: Decision, right: Side, name: str, knowledge: Knowledge) -> bool:
    """Tell whether a relation has higher powers than those through which the sides agree."""
    try:
        power = power_written(right.node, name, there, knowledge)
        return power is not None and power > (there.through or 0)
    except (NoFormError, TooLargeError):
        return True


def is_said_roughly(state: JudgingState, chain: Chain) -> bool:
    """Tell whether the words of a relation's sentence say that it is rough."""
    behind = _SENTENCE_ENDS.split(state.document.text[chain.end : chain.end + BEHIND])[0]
    before = f"{state.sections.sentence_leading_to(chain)} {state.sections.sentence_before(chain)}"
    return ROUGH_WORDS.search(before) is not None or ROUGH_WORDS.search(behind) is not None


def _follows_rough(state: JudgingState, chain: Chain) -> bool:
    """Tell whether a rough relation stands above in the same section, by its sign or by words."""
    line, by_sign = chain.lines[0], state.lines_with_rough_sign
    near = [*state.rough_lines[-1:], *by_sign[: bisect_left(by_sign, line)][-1:]]
    return any(state.sections.same_section(above, line) for above in near)
