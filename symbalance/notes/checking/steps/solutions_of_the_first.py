"""Solutions that squaring has added: √(x + 1) = x - 1 ⇒ x + 1 = (x - 1)², and "only x = 0 is a solution".

The squared equation has x = 0, the one that is to be solved has not. What words call a solution has to
satisfy the first of the equations that follow from one another.
"""

from __future__ import annotations

from symbalance.document.formula import Name, names
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.premises.angles_at import solves_as_printed
from symbalance.notes.checking.premises.system import Premise
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import (
    CONDITION,
    DEFINITION,
    PREMISE,
    PROVED_WORDS,
    UNDECIDED,
    Verdict,
)
from symbalance.notes.checking.words.lists_of_data import sets_number
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_THING = (
    r"(?:solutions?|roots?|zeros?|lösung(?:en)?|wurzeln?|nullstellen?|racines?|soluzion[ei]|radic[ei]|solución|soluciones|raíz|raíces)"
    r"(?![^\W\d_])"
)
_BEFORE = re.compile(
    rf"(?:(?<![^\W\d_])(?:only|just|nur|allein|seule?|seulement|solo|soltanto|sólo)[\s$(]*"
    rf"|{_THING}\s+(?:is|are|ist|est|è|es)\s+(?:therefore\s+|then\s+|only\s+|also\s+|nur\s+|donc\s+)?[\s$(]*|解は[\s$(]*)$",
    re.IGNORECASE,
)
"""Words right before a number that call it a solution: only, the solution is."""
_BEHIND = re.compile(
    rf"[\s$)]*(?:is|ist|est|è|es)\s+(?:indeed\s+|really\s+|tatsächlich\s+|bien\s+)?(?:the|an?|die|eine?|la|une|l['’]|una)?\s*"
    rf"(?:(?:only|true|real|unique|einzige|wahre|seule|vraie|unica|vera|única)\s+)?{_THING}"
    r"|[\s$)]*(?:solves|satisfies|fulfils|löst|erfüllt|satisfait|vérifie|soddisfa|verifica|satisface|cumple)(?![^\W\d_])"
    r"|[\s$)]*(?:だけ|のみ)?が(?:唯一の)?解",
    re.IGNORECASE,
)
"""Words right behind a number that call it a solution."""
_DENIED = re.compile(
    r"(?<![^\W\d_])(?:not|no|if|wenn|falls|nicht|kein\w*|pas|si|non|would|wäre|neither)(?![^\W\d_])",
    re.IGNORECASE,
)
_FOLLOWS = re.compile(
    r"⇒|⟹|\\(?:Rightarrow|Longrightarrow|implies)(?![A-Za-z])|=>"
    r"|(?<![^\W\d_])(?:squar\w+|quadrier\w*|élev\w+|elev\w+|multipl\w+)(?![^\W\d_])|[2二]乗",
    re.IGNORECASE,
)
"""What leads from an equation to one that may have further solutions."""
_NEAR, _LONGEST, _MOST = 60, 100, 12
"""Characters before a number, and between two equations, that are looked at; equations in a row."""


def unless_added_by_squaring(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; refuted where words call a number a solution that the first equation has not."""
    head = chain.sides[0].node
    if k or not sets_number(chain) or not isinstance(head, Name):
        return verdict
    if verdict.verdict not in (*PROVED_WORDS, CONDITION, PREMISE, DEFINITION, UNDECIDED):
        return verdict
    first = _first_equation(state, chain, head.name) if _is_called_solution(state, chain) else None
    if first is None:
        return verdict
    line = first.lines[0]
    condition = Premise(first.sides[0].node, first.sides[1].node, line)
    if solves_as_printed(condition, head.name, chain.sides[1].node, Knowledge()) is not False:
        return verdict
    return describe(
        state.document, chain, k, Decision(REFUTED, f"does not satisfy the equation of line {line}")
    )


def _is_called_solution(state: JudgingState, chain: Chain) -> bool:
    """Tell whether the words right before or behind a number call it a solution."""
    text = state.document.text
    before = text[max(0, chain.start - _NEAR) : chain.start]
    sentence = state.sections.sentence_before(chain)
    behind = _BEHIND.match(text, chain.end)
    is_only = behind is not None or _BEFORE.search(before) is not None
    last = state.sections.chain_before(chain.start)
    own = (
        sentence
        if last is None or last.end <= chain.start - len(sentence)
        else text[last.end : chain.start]
    )
    return is_only and _DENIED.search(own) is None


def _first_equation(state: JudgingState, chain: Chain, name: str) -> Chain | None:
    """Return the first of the equations of one letter that lead to its number, None for none."""
    sections, text = state.sections, state.document.text
    section = sections.start_of_line(sections.section_start(chain.lines[0]))
    first: Chain | None = None
    later = sections.chain_before(chain.start)
    for _ in range(_MOST):
        if later is None or later.start < section or later.letters != {name}:
            break
        is_equation = len(later.relations) == 1 and later.relations[0].sign == "="
        if not is_equation:
            break
        if not sets_number(later):
            first = later
        before = sections.chain_before(later.start)
        between = "" if before is None else text[before.end : later.start]
        is_solved = sets_number(later) and len(between) <= _LONGEST  # so x = 0 or x = 3
        if not (is_solved or _FOLLOWS.search(between[-_LONGEST:])):
            break
        later = before
    return first if first is not None and names(first.sides[0].node) else None
