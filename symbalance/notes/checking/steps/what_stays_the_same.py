"""Proportions of which words say what stays the same: for given ΔE and δ, J_min ∝ 1/ω².

The words and the claim name all letters of one equation above. What they leave to change are two letters,
and that equation says how one of them grows with the other.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from symbalance.document.formula import Formula, Name, names, walk
from symbalance.document.letters import plain_letter
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.steps.proportional import SIGN, decide_by_equation
from symbalance.notes.checking.verdicts import PREMISE, UNDECIDED, Verdict
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_STAYS = re.compile(
    r"(?<![^\W\d_])(?:given|fixed|constant|same|unchanged|gegeben\w*|fest\w*|konstant\w*|gleich\w*|donnée?s?|fixée?s?|constante?s?"
    r"|mêmes?|dat[oaie]|fissat\w+|stess\w+|costant[ei]|dad[oa]s?|fij[oa]s?|mism[oa]s?)(?![^\W\d_])|一定|同じ|与えられた",
    re.IGNORECASE,
)
"""Words that keep letters as they are."""
_INDEX = re.compile(r"_(?:min|max|req|erf|nec|nöt|nötig|0|1|2|new|neu)$")
"""Subscripts of one value of a letter: J_min is the least J that does."""


def unless_other_things_change(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a proportion that no formula shows is decided by what words keep the same."""
    head, right = chain.sides[k].node, chain.sides[k + 1].node
    is_open = verdict.verdict in (PREMISE, UNDECIDED) and chain.relations[k].sign == SIGN
    if not is_open or not isinstance(head, Name) or not names(right):
        return verdict
    sentence = state.sections.sentence_before(chain)
    if not _STAYS.search(sentence):
        return verdict
    stem = _INDEX.sub("", head.name)
    for equation, letters in _equations(state, chain, {stem, *names(right)}):
        others = letters.keys() - {stem, *names(right)}
        if not others or not all(_stands_in(sentence, letters[n], n) for n in others):
            continue
        try:
            decision = decide_by_equation(equation, Name(stem), right, state.knowledge(chain.lines[0]))
        except NoFormError:
            continue
        if decision is not None:
            return describe(state.document, chain, k, decision)
    return verdict


def _equations(
    state: JudgingState, chain: Chain, own: set[str]
) -> Iterator[tuple[tuple[Formula, Formula], dict[str, str]]]:
    """Yield the equations above a claim that have its letters, the nearest first, as they are typed."""
    for above in reversed(state.document.chains):
        if above.start >= chain.start or not own <= above.letters:
            continue
        for first, second in pairwise(side.node for side in above.sides):
            if own <= names(first) | names(second):
                parts = (part for node in (first, second) for part in walk(node))
                letters = {p.name: state.document.source(p.span) for p in parts if isinstance(p, Name)}
                yield (first, second), letters


def _stands_in(sentence: str, typed: str, name: str) -> bool:
    """Tell whether a letter stands in a sentence, as it is typed in its equation or plainly."""
    spellings = {typed.strip(), name, plain_letter(name)} - {""}
    return any(
        re.search(rf"(?<![A-Za-z\\]){re.escape(each)}(?![A-Za-z_])", sentence) for each in spellings
    )
