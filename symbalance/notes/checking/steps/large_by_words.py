"""Approximations whose words say that a letter is large, or an angle near half a turn, and none is small.

Where nobody has said which letter is small, ≈ may rest on any. "For large x" leaves x out: both sides are
compared where it is a million. Near 180° an angle is no small one either.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Formula, Number, names
from symbalance.document.letters import plain_letter
from symbalance.notes.algebra.tree_values import sample_trees
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, UNDECIDED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.order_agreement import IS_SMALL, known_not_small
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONDITION, PROVED_WORDS, Verdict
from symbalance.notes.checking.verdicts import REFUTED as REFUTED_WORD
from symbalance.notes.checking.verdicts import UNDECIDED as UNDECIDED_WORD
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_LARGE = r"(?:large|big|great|high|große[nsmr]?|hohe[nsmr]?|grande?s?|gran|elevat[oa]s?|élevée?s?)"
_VALUES = r"(?:values?\s+of|werte?\s+von|valeurs?\s+de|valori\s+di|valores\s+de)"
_LETTER = r"\$?\\?(?P<letter>[^\W\d_]+(?:_\{?\w{1,6}\}?)?)\$?"
_SAID_LARGE = re.compile(
    rf"(?<![^\W\d_\\])(?:{_LARGE}[ ~]|大きな|大きい)\s*(?:{_VALUES}\s*)?{_LETTER}(?![^\W\d_])"
    rf"|{_LETTER.replace('letter', 'limit')}\s*(?:→|\\to|->)\s*(?:∞|\\infty)"
    rf"|{_LETTER.replace('letter', 'much')}\s*(?:≫|\\gg)\s*1(?![0-9.,])",
    re.IGNORECASE,
)
_NEAR_A_TURN = re.compile(
    r"(?<![^\W\d_])(?:near|around|close\s+to|nahe|um|bei|autour\s+de|près\s+de|vicino\s+a|cerca\s+de)\s+\$?"
    r"(?:[^\W\d_]{1,8}\s*=\s*)?(?:9|18|27|36)0(?:\s*°|\^)|(?:90|180|270)°\s?付近",
    re.IGNORECASE,
)
_REGION_BEHIND = re.compile(
    r"[\s$,)]{0,5}(?:for|if|when|where|as|für|bei|wenn|falls|pour|si|quand|lorsque|per|se|quando|para|cuando)[\s$]+"
    r"(?P<region>[^.;:!?=≈。]{1,40})",
    re.IGNORECASE,
)
"""Words right behind a relation that say where it holds: x/(1+x) ≈ 1 for x ≫ 1."""
_JUDGED = (*PROVED_WORDS, REFUTED_WORD, UNDECIDED_WORD, CONDITION)
_REACH = 90
"""Characters before a relation in which words say what is large."""
_FIRST, _SECOND = 10**4, 10**8
"""Two values of a large letter: the second tells whether both sides come closer still."""
_SAME, _APART = 1e-3, 1e-2
"""Parts of themselves: below the first two sides are the same there, above the second they are not."""


def unless_large_by_words(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; an approximation is tried where its words say that a letter is large."""
    sign, sides = chain.relations[k].sign, (chain.sides[k].node, chain.sides[k + 1].node)
    rests = [text for text in verdict.assumption.split("; ") if text.endswith(IS_SMALL)]
    if verdict.verdict not in _JUDGED or (sign != "≈" and not rests):
        return verdict
    words = state.document.text[max(0, chain.start - _REACH) : chain.start]
    words = re.split(r"[.;!?。]\s|\n\s*\n", words)[-1]
    behind = _REGION_BEHIND.match(state.document.text, chain.end)
    said = _SAID_LARGE.search(words) or (behind and _SAID_LARGE.search(f" {behind['region']}"))
    if said is not None:
        plain = (said["letter"] or said["limit"] or said["much"]).replace("{", "").replace("}", "")
        name = next((n for n in names(sides[0]) | names(sides[1]) if plain in (n, plain_letter(n))), None)
        found = None if name is None else _where_large(sides, name, state.knowledge(chain.lines[0]))
        return verdict if found is None else describe(state.document, chain, k, found)
    letters = [text.removesuffix(IS_SMALL) for text in rests]
    knowledge = state.knowledge(chain.lines[0])
    own = [n for n in names(sides[0]) | names(sides[1]) if plain_letter(n) in letters]
    known = next(filter(None, (known_not_small(n, knowledge) for n in own)), "")
    near = _NEAR_A_TURN.search(words) if rests else None
    if not known and near is None:
        return verdict
    reason = f"it takes {letters[0] if letters else ''} for small: {known or (near and near[0].strip())}"
    return describe(state.document, chain, k, Decision(UNDECIDED, reason))


def _where_large(sides: tuple[Formula, Formula], name: str, knowledge: Knowledge) -> Decision | None:
    """Return the decision on two sides where a letter is large: alike more and more, or not at all."""
    first, second = (_apart(sides, name, size, knowledge) for size in (_FIRST, _SECOND))
    letter = plain_letter(name)
    if first is None or second is None:
        return Decision(UNDECIDED, f"no point where {letter} is large and both sides are real")
    if second < _SAME and second <= first:
        return Decision(PROVED, order=f"the leading term where {letter} is large, by numbers")
    return Decision(REFUTED, f"not so where {letter} is large") if second > _APART else None


def _apart(sides: tuple[Formula, Formula], name: str, size: int, knowledge: Knowledge) -> float | None:
    """Return by which part of themselves two sides differ at most where a letter has a large value."""
    level = list(knowledge.levels(*sides))[-1]
    values = {**level.values, name: Number(Fraction(size))}
    sizes = (names(sides[0]) | names(sides[1])) - knowledge.angles
    meaning = replace(knowledge.meaning, values=values, positive=knowledge.meaning.positive | sizes)
    points = sample_trees(list(sides), meaning)
    parts = [abs(a - b) / max(abs(a), abs(b)) for _, (a, b) in points if a or b]
    return float(max(parts)) if parts else None
