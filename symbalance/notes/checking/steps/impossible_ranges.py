"""Ranges and numbers that a letter's formula never has: x = y² and x < 0, z = cos θ and z > 2.

A range alone says where a letter lies. With the formula that the page gives the letter, one that is true
at no value of the formula's letters says what cannot be, unless words tell that it is only tried, denied
or a case that does not come up.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Formula, Name, Negative, Number, names
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.inequalities import FEWEST, SATISFIED_BY, lone_letter
from symbalance.notes.checking.deciding.knowledge import StatedRange
from symbalance.notes.checking.deciding.satisfiability import survey
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONTRADICTION, DEFINITION, PREMISE, RANGE, Verdict
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_FARTHEST = 400
"""Characters between a letter's formula and its range."""
_ZERO = Number(Fraction(0))
_ONLY_TRIED = re.compile(
    r"(?<![^\W\d_])(?:impossible|cannot|can't|never|not|no|nowhere|if|when|unless|were|would|contradict\w*|absurd|excluded"
    r"|must|should|shall|required|requirement|demand(?:ed)?|allowed|muss|müssen|soll|sollte|zulässig|gefordert"
    r"|unmöglich|nie|nicht|kein\w*|falls|wenn|wäre\w*|würde\w*|widerspr\w*|ausgeschlossen|jamais|pas|si|impossibile|mai"
    r"|non|se|imposible|nunca|another|other|different|ander\w*|autre|altr\w*|otr[oa])(?![^\W\d_])|ない|なら|場合|矛盾|別の",
    re.IGNORECASE,
)
"""Words of what is only tried, or said not to be."""


def unless_impossible(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a range or number of a letter that its formula never has is a contradiction."""
    if len(chain.relations) != 1 or verdict.verdict not in (RANGE, DEFINITION, PREMISE):
        return verdict
    for stated, value, line in _pairs(state, chain, verdict):
        if is_only_tried(state, chain) or not _is_nowhere(state, chain, stated, value):
            continue
        reason = f"no values of its letters make it so: {stated.text}, and {_formula_of(stated, value)}"
        there = "" if line in chain.lines else f" of line {line}"
        return describe(state.document, chain, k, Decision(CONTRADICTION, f"{reason}{there}"))
    return verdict


def _pairs(
    state: JudgingState, chain: Chain, verdict: Verdict
) -> Iterator[tuple[StatedRange, Formula, int]]:
    """Yield a letter's range and its formula, one of them stated by a relation, with the other's line."""
    left, right, line = chain.sides[0].node, chain.sides[1].node, chain.lines[0]
    sign = chain.relations[0].sign
    stated = StatedRange(left, sign, right, line)
    alone = lone_letter(stated) if sign in SATISFIED_BY and sign != "≠" else None
    if verdict.verdict == RANGE and alone is not None:
        yield from ((stated, value, there) for value, there in _formulas(state, chain, alone[0]))
    if sign != "=" or not isinstance(left, Name) or verdict.verdict == RANGE:
        return
    if names(right) and left.name not in names(right):
        for other in state.knowledge(line).ranges:
            own = lone_letter(other)
            is_near = state.sections.same_section(other.line, line) and other.line <= line
            if own is not None and own[0] == left.name and own[1] != "≠" and is_near:
                yield other, right, other.line
    elif isinstance(right, Negative) and isinstance(right.operand, Number) and right.operand.value > 0:
        below = StatedRange(left, "<", _ZERO, line)
        yield from ((below, value, there) for value, there in _formulas(state, chain, left.name))


def _formulas(state: JudgingState, chain: Chain, name: str) -> list[tuple[Formula, int]]:
    """Return the one formula of a letter above in the section, and its line; [] for none or several.

    Where its line comes to a number, σ = F/A = 120, that is its value, whatever F and A are.
    """
    above = [
        other
        for other in state.sections.chains_above(Name(name), chain.start)
        if state.sections.same_section(other.lines[0], chain.lines[0]) and len(other.sides) > 1
    ]
    if len(above) != 1 or above[0].relations[0].sign != "=" or chain.start - above[0].end > _FARTHEST:
        return []
    value, result = above[0].sides[1].node, above[0].sides[-1].node
    if not names(value) or name in names(value):
        return []
    return [(result if not names(result) else value, above[0].lines[0])]


def is_only_tried(state: JudgingState, chain: Chain) -> bool:
    """Tell whether the words around a relation deny it, or make it a case."""
    text = state.document.text
    before = state.sections.sentence_leading_to(chain)
    behind = re.split(r"[.;!?]\s|[。；]|\n\s*\n", text[chain.end : chain.end + 80])[0]
    return _ONLY_TRIED.search(f"{before} {behind}") is not None or state.sections.opens_case(chain)


def _is_nowhere(state: JudgingState, chain: Chain, stated: StatedRange, value: Formula) -> bool:
    """Tell whether a range is true at none of the points tried, with a formula in its letter's place."""
    own = lone_letter(stated)
    if own is None:
        return False
    name, sign, bound = own
    knowledge = state.knowledge_of(chain, state.knowledge(chain.lines[0]))
    values = {n: d.node for n, d in knowledge.definitions.items() if n != name and not d.solved}
    if any(d.alternatives for n, d in knowledge.definitions.items() if n in names(value)):
        return False
    meaning = replace(knowledge.meaning, values={**values, **knowledge.meaning.values})
    meaning = replace(meaning, values={n: v for n, v in meaning.values.items() if n != name})
    signs = survey(value, bound, meaning, roots=True)
    is_none = not any(s in SATISFIED_BY[sign] for s in signs.counts)
    fewest = FEWEST if names(value) or names(bound) else 1  # two numbers are compared once
    return signs.tried >= fewest and is_none and not (signs.has_root and sign in "≤≥")


def _formula_of(stated: StatedRange, value: Formula) -> str:
    own = lone_letter(stated)
    return f"{plain_text(Name(own[0])) if own else ''} = {plain_text(value)}"
