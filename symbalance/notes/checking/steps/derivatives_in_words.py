"""Derivatives and integrals that words name: "differentiating x = r cos ωt gives v = -r ω sin ωt".

The letters alone say nothing of each other. By the words the second formula is the first one's derivative
by the time, or the first is the second's; with a constant that is to be chosen it is so too.
"""

from __future__ import annotations

from symbalance.document.formula import Derivative, Formula, Name, Sum, names
from symbalance.notes.checking.deciding.equality import REFUTED, Decision, decide_equality
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_TIME = Name("t")
_LONGEST = 40
"""Characters of the words before the first formula, and between the two."""
_NAMED = re.compile(
    r"(?<![^\W\d_])(?:(?P<rate>differentiating|differentiation\s+of|ableiten\s+von|ableitung\s+von|differenzieren\s+von)"
    r"|(?:integrating|integration\s+(?:of|von)|integrieren\s+von))[\s$(\\\[]*$",
    re.IGNORECASE,
)
_GIVES = re.compile(
    r"[\s$,)\\\]]*(?:with\s+respect\s+to\s+(?:the\s+)?time|nach\s+der\s+Zeit)?[\s,]*"
    r"(?:gives|yields|leads\s+to|results\s+in|we\s+(?:get|obtain|find)|ergibt|liefert|gibt|führt\s+auf)[\s$(\\\[:]*",
    re.IGNORECASE,
)


def refute_named_rate(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Return the refutation of a formula that is not the derivative or integral that words call it."""
    text = state.document.text
    before = state.sections.chain_before(chain.start)
    if k or before is None or len(before.sides) != 2 or chain.start - before.end > 2 * _LONGEST:
        return None
    named = _NAMED.search(text, max(before.start - _LONGEST, 0), before.start)
    if named is None or _GIVES.fullmatch(text[before.end : chain.start]) is None:
        return None
    heads = [before.sides[0].node, chain.sides[0].node]
    first, second = before.sides[1].node, chain.sides[1].node
    whole, rate = (first, second) if named["rate"] else (second, first)
    own = names(rate) if named["rate"] else names(rate) | _factors_of_constants(whole)
    is_of_letters = all(isinstance(head, Name) for head in heads) and heads[0] != heads[1]
    is_alone = own <= names(first) | {_TIME.name} and _TIME.name in names(first)
    others = names(first) & knowledge.definitions.keys() - {_head(before)}
    if not is_of_letters or not is_alone or others:
        return None
    if decide_equality(Derivative(whole, _TIME, 1), rate, Knowledge()).status != REFUTED:
        return None
    what = "derivative" if named["rate"] else "integral"
    return Decision(REFUTED, f"not the {what} by the time of line {before.lines[0]}")


def _factors_of_constants(whole: Formula) -> frozenset[str]:
    """Return the letters of an integral, but those of terms without the time: they may be constants."""
    terms = whole.terms if isinstance(whole, Sum) else (whole,)
    return frozenset[str]().union(*(names(term) for term in terms if _TIME.name in names(term)))


def _head(chain: Chain) -> str:
    head = chain.sides[0].node
    return head.name if isinstance(head, Name) else ""
