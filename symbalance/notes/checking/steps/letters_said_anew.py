"""Letters that words make another thing, or formulas that belong to two conditions or two authors.

"Let now x be the distance from the crankshaft": the x above is forgotten. "F = F_0 for t < 0 and F = 2F_0
for t > 0" has two cases, each named right behind its formula. "Others write λ = l/r" is no claim here.
"""

from __future__ import annotations

from symbalance.document.formula import Name, names
from symbalance.document.text_writer import formula_text
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import PREMISE
from symbalance.notes.checking.words.case_words import clause_before
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_NOW = (
    r"(?:(?:let\s+now|now\s+let|let)\s+{letter}\s+(?:now\s+)?(?:be|denote|stand|mean)|(?:sei|bezeichne)\s+(?:nun|jetzt)\s+{letter}"
    r"|(?:nun|jetzt)\s+(?:sei|ist|bezeichnet|bezeichne)\s+{letter}|(?:now|here)\s+{letter}\s+(?:is|denotes|means|stands\s+for)"
    r"|{letter}\s+(?:is\s+now|now\s+is|now\s+denotes|ist\s+(?:nun|jetzt)|est\s+maintenant)|hier\s+(?:ist|bezeichnet)\s+{letter}"
    r"|soit\s+maintenant\s+{letter}|ici,?\s+{letter}\s+(?:est|désigne)|(?:ここで|今度は){letter}[はを])"
    r"(?:(?<=[はを])|\s+(?:the|an?|its|der|die|das|eine?|le|la|les|un|une)\s|\s+l['’])"
)
_SINCE = re.compile(r"(?<![^\W\d_])(?:now|nun|jetzt|maintenant)(?![^\W\d_])|今度は", re.IGNORECASE)
"""Words by which a letter was another thing before."""
_OTHERS = re.compile(
    r"(?<![^\W\d_])(?:others|other\s+(?:authors?|books?|texts?|writers?)|some\s+(?:authors?|books?|texts?)|andere(?:\s+Autoren)?|manche"
    r"|d'autres(?:\s+auteurs)?|altri\s+autori|otros(?:\s+autores)?)(?![^\W\d_])|他の(?:文献|著者)",
    re.IGNORECASE,
)
REACH = 200
"""Characters before a formula in which its clause begins."""
_CONDITION = re.compile(
    r"[\s$,)]*(?:for|when|if|at|where|while|wenn|für|bei|falls|pour|si|quand|lorsque|à|para|cuando|per|se|quando)[\s$\\(]*",
    re.IGNORECASE,
)


def leave_letter_said_anew(state: JudgingState, chain: Chain, k: int) -> None:
    """Forget what a letter is above, where words say before its formula that it is another thing now."""
    head, line, above = chain.sides[0].node, chain.lines[0], _relations_above(state, chain, k)
    if not above or not isinstance(head, Name):
        return
    if any(chain.sides[1].node in [side.node for side in c.sides] for c in above):
        return
    words = clause_before(state.document.text, chain.start)
    ways = {head.name, f"\\{head.name}", formula_text(head, plain=True)}
    letter = rf"\$?(?:{'|'.join(map(re.escape, sorted(ways, key=len, reverse=True)))})\$?"
    if re.search(_NOW.format(letter=letter), words, re.IGNORECASE) is None:
        return
    is_below = not any(state.sections.same_section(c.lines[0], line) for c in above)
    if is_below or _SINCE.search(words):
        state.definitions.forget_all(head.name)


def leave_formula_of_condition(state: JudgingState, chain: Chain, k: int) -> bool:
    """Forget the formula that a letter has under another condition, or with others; tell of any."""
    head, line, above = chain.sides[0].node, chain.lines[0], _relations_above(state, chain, k)
    if not above or not isinstance(head, Name):
        return False
    before, own = (_condition_behind(state, c) for c in (above[-1], chain))
    is_other = before is not None and own is not None and _are_two(before, own)
    if not is_other and not _OTHERS.search(state.sections.heading_above(line)):
        return False
    state.definitions.forget_all(head.name)
    return True


def _relations_above(state: JudgingState, chain: Chain, k: int) -> list[Chain]:
    """Return the relations above of a letter that nobody has declared, where one gives it a formula."""
    head = chain.sides[0].node
    if k or not isinstance(head, Name) or head.name in state.declarations.symbols_at(chain.lines[0]):
        return []
    above = state.sections.chains_above(head, chain.start)
    return above if names(chain.sides[1].node) else []


def _condition_behind(state: JudgingState, chain: Chain) -> Chain | None:
    """Return the relation that stands right behind another one as its condition: for t < 0."""
    following = (c for c in state.sections.in_order if c.start >= chain.end and c.relations)
    behind = next(following, None)
    if behind is None or len(chain.relations) > 1 or len(behind.relations) > 1:
        return None
    between = state.document.text[chain.end : behind.start]
    return behind if _CONDITION.fullmatch(between) else None


def _are_two(first: Chain, second: Chain) -> bool:
    """Tell whether two conditions are of the same letter, and not the same."""
    relations = [(c.relations[0].sign, c.sides[1].node) for c in (first, second)]
    return first.sides[0].node == second.sides[0].node and relations[0] != relations[1]


def as_formula_of_others(state: JudgingState, chain: Chain, k: int) -> Decision | None:
    """Return that a formula is said to be how others define a letter, which changes nothing here."""
    if k or not isinstance(chain.sides[0].node, Name) or not names(chain.sides[1].node):
        return None
    first = max(state.sections.end_before(chain.start) or 0, chain.start - REACH)
    words = clause_before(state.document.text, chain.start)[-(chain.start - first) :]
    return Decision(PREMISE, "what others take the letter for") if _OTHERS.search(words) else None
