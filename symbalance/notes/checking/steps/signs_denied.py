"""Results that hold if x ≥ 0, of a letter that words call negative, or of which all values count.

Of x² = 4 and y² = 9 the sum is 5 where neither is negative: "x and y are negative" says otherwise.
"""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import Name, Negative
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import UNDECIDED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONDITIONAL, Verdict
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_NOT_NEGATIVE = " ≥ 0"
_NEGATIVE = (
    r"(?<![A-Za-z\\])(?:[A-Za-z]\$?\s*(?:,|and|und|et|e|y)\s*\$?)*\\?(?:NAME)\$?"
    r"(?:\s*(?:,|and|und|et|e|y)\s*\$?\\?[A-Za-z]\$?)*\s+"
    r"(?:is|are|being|ist|sind|est|sont|è|sono|es|son)\s+(?:both\s+|all\s+|beide\s+|toutes?\s+(?:les\s+)?deux\s+|tous\s+(?:les\s+)?deux\s+)?"
    r"(?:negative?|négati(?:f|ve)s?|negativ[oiae]s?)(?![^\W\d_])|(?:NAME)\$?\s?(?:は|が)(?:ともに)?負"
)
_OTHER_CASE = re.compile(
    r"(?<![^\W\d_])(?:if|when|or|otherwise|not|wenn|falls|oder|sonst|nicht|si|ou|sinon|pas|se|non|o)(?![^\W\d_])|とき|場合|ない",
    re.IGNORECASE,
)

_POSITIVE = re.compile(r"(?<![^\W\d_])(?:posit|absolut|betrag|size|größe)|正", re.IGNORECASE)
"""Words of a relation's own sentence that speak of other values."""


def unless_sign_denied(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; what holds if a letter is not negative is open where words deny that."""
    if verdict.verdict != CONDITIONAL:
        return verdict
    parts = re.split("[;,] ", verdict.assumption)
    own = [text.removesuffix(_NOT_NEGATIVE) for text in parts if text.endswith(_NOT_NEGATIVE)]
    letters = [name for name in own if name in chain.letters]
    for name in letters:
        reason = ""
        if name in state.general:
            reason = f"said of all values of {name}, and it holds if {name}{_NOT_NEGATIVE}"
        elif _is_called_negative(state, chain, name):
            reason = f"it holds if {name}{_NOT_NEGATIVE}, and words call {name} negative"
        if reason and not _holds_of_negative(state, chain, k, name):
            return describe(state.document, chain, k, Decision(UNDECIDED, reason))
    return verdict


def _holds_of_negative(state: JudgingState, chain: Chain, k: int, name: str) -> bool:
    """Tell whether a relation holds with the letter's sign changed too: √(a²) = |a| does."""
    negative = Negative(Name(name))
    try:
        left, right = (
            side.changed(lambda node: substitute(node, name, negative)) for side in chain.sides[k : k + 2]
        )
    except NoFormError:
        return False
    knowledge = state.knowledge(chain.lines[0])
    return name not in knowledge.definitions and (
        decide(left, right, chain.relations[k].sign, knowledge).is_proved
        or decide(left, right, chain.relations[k].sign, _not_negative(name, knowledge)).is_proved
    )


def _not_negative(name: str, knowledge: Knowledge) -> Knowledge:
    meaning = replace(knowledge.meaning, positive=knowledge.meaning.positive | {name})
    return replace(knowledge, meaning=meaning)


def _is_called_negative(state: JudgingState, chain: Chain, name: str) -> bool:
    """Tell whether the last words of a relation's paragraph about a letter's sign call it negative."""
    sections, text = state.sections, state.document.text
    first = sections.start_of_line(sections.paragraph_start(chain.lines[0]))
    pattern = re.compile(_NEGATIVE.replace("NAME", re.escape(name)), re.IGNORECASE)
    match = pattern.search(text, first, chain.start)
    if match is None:
        return False
    sentence = re.split(r"[.;!?]\s|[。；]", text[first : match.end()])[-1]
    own = sections.sentence_before(chain)
    return _OTHER_CASE.search(sentence) is None and _POSITIVE.search(own) is None
