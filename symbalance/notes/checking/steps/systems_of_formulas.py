"""Two formulas of one letter that are a system to be solved: y = 2x and y = x + 3, so x = 3 and y = 6.

The second is no slip of the first where words say that both are to be solved, or that two lines meet, or
where a number right below satisfies both. It is taken as given beside the first.
"""

from __future__ import annotations

from symbalance.document.formula import Name, names
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.premises.system import Premise
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONDITION, CONTRADICTION, REFUTED, UNDECIDED, Verdict
from symbalance.notes.checking.words.lists_of_data import sets_number
from symbalance.notes.checking.words.plain_formulas import lone_side
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_TO_BE_SOLVED = re.compile(
    r"(?<![^\W\d_])(?:solv\w+|simultaneous\w*|(?:two|both|these)\s+(?:equations|conditions|relations)|system|intersect\w*|meet|cross"
    r"|lös\w+|auflösen|gleichungssystem\w*|(?:zwei|beiden|diese[nr]?)\s+gleichungen|schneide\w*|treffen|résou\w+|système|(?:deux|ces)\s+équations|coupe\w*"
    r"|risolv\w+|sistema|(?:due|queste)\s+equazioni|incontra\w*|resolv\w+|resuelv\w+|(?:dos|estas)\s+ecuaciones|cortan?)(?![^\W\d_])"
    r"|連立|解く|解いて|交わ",
    re.IGNORECASE,
)
_FROM_BOTH = re.compile(
    r"(?<![^\W\d_])(?:from|by|aus|mit|de|da|par)\s+(?:\w+\s+){0,2}\(?[0-9]{1,2}\)?\s+(?:and|und|et|e|y)\s+\(?[0-9]{1,2}\)?",
    re.IGNORECASE,
)
_BETWEEN = re.compile(
    r"(?:[\s$&,.;{}]|\\\\|\\[\[\]()]|\\tag\s*\{[^{}]*\}|\\(?:q?quad|begin|end|aligned|text)(?![A-Za-z])|aligned|align\*?|\([0-9]{1,2}\)"
    r"|(?<![^\W\d_])(?:and|und|et|e|y)(?![^\W\d_])|と|および)*"
)
_REACH = 160


def unless_of_a_system(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a second formula of a letter is given where both are equations to be solved."""
    head, value = chain.sides[0].node, chain.sides[1].node
    is_against = verdict.verdict in (REFUTED, CONTRADICTION, UNDECIDED)
    if not is_against or len(chain.relations) != 1 or not isinstance(head, Name) or not names(value):
        return verdict
    first = state.sections.chain_before(chain.start)
    if first is None or len(first.relations) != 1 or first.sides[0].node != head:
        return verdict
    unknowns = names(value) & names(first.sides[1].node)
    given = state.knowledge(chain.lines[0]).definitions
    is_open = any(name not in given for name in unknowns) and head.name not in names(value)
    signs = (first.relations[0].sign, chain.relations[0].sign)
    text = state.document.text
    if not is_open or signs != ("=", "=") or _BETWEEN.fullmatch(text, first.end, chain.start) is None:
        return verdict
    if not (_is_said(state, first, chain) or _is_solved_below(state, first, chain, unknowns)):
        return verdict
    line = chain.lines[0]
    state.definitions.premises.append(
        Premise(head, value, line, state.definitions.sections.section_end(line))
    )
    reason = f"to be solved together with line {first.lines[0]}"
    return describe(state.document, chain, k, Decision(CONDITION, reason))


def _is_said(state: JudgingState, first: Chain, chain: Chain) -> bool:
    """Tell whether words before two equations, or right behind them, say that they are to be solved."""
    text = state.document.text
    before = state.sections.sentence_leading_to(first)
    behind = re.split(r"[.!?]\s|。", text[chain.end : chain.end + _REACH])[0]
    return any(_TO_BE_SOLVED.search(words) for words in (before, behind)) or bool(
        _FROM_BOTH.search(behind)
    )


def _is_solved_below(state: JudgingState, first: Chain, chain: Chain, unknowns: frozenset[str]) -> bool:
    """Tell whether a number right below two equations satisfies both of them."""
    below = next(state.sections.chains_behind(chain.start), None)
    head = None if below is None else below.sides[0].node
    if below is None or not isinstance(head, Name) or head.name not in unknowns or not sets_number(below):
        return False
    try:
        sides = [substitute(c.sides[1].node, head.name, below.sides[1].node) for c in (first, chain)]
    except NoFormError:
        return False
    knowledge = state.knowledge(chain.lines[0])
    return decide(lone_side(sides[0]), lone_side(sides[1]), "=", knowledge).is_proved
