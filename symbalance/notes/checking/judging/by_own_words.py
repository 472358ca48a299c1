"""What is proved by a number of another place or case than the relation's own words name is open.

"At top dead centre θ = 0, so cos θ = 1. At bottom dead centre cos θ = 1" is true for the angle of the
line above, and is said of another one. Such a relation is proved again by what its words say.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from symbalance.document.formula import Formula, Name
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import UNDECIDED, Decision
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.steps.values_in_own_words import (
    before_it,
    letters_said_otherwise,
    values_in_own_words,
)
from symbalance.notes.checking.verdicts import PROVED_WORDS, REFUTED, Verdict
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re


def unless_of_other_words(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; what is proved only by another value than its words name is open.

    What is refuted by the lines above may be true by what its words name.
    """
    is_plain = verdict.verdict == REFUTED and not verdict.reason  # no fault of units, say
    is_judged = is_plain or verdict.verdict in PROVED_WORDS
    if not is_judged or chain.relations[k].sign not in "=≈":
        return verdict
    knowledge = before_it(state, chain, state.knowledge_of(chain, state.knowledge(chain.lines[0])))
    kinds = values_in_own_words(state, chain, k, knowledge)
    left, right, sign = chain.sides[k], chain.sides[k + 1], chain.relations[k].sign
    is_proved = verdict.verdict in PROVED_WORDS
    together = {name: node for said in kinds for name, node in said[0].values.items()}
    words = " and ".join(f"“{said[0].words}”" for said in kinds)
    every = [(each.values, f"“{each.words}”") for said in kinds for each in said]
    for values, said in (*every, (together, words)) if kinds else ():
        there = decide(left, right, sign, _with_values(values, knowledge))
        if there.is_proved:
            in_force = {n: knowledge.definitions[n].node for n in values}
            is_of_it = not is_proved or _names_value(verdict, in_force)
            text = " and ".join(f"{plain_text(Name(n))} = {plain_text(v)}" for n, v in values.items())
            named = replace(there, assumptions=(*there.assumptions, f"{text} by {said}"))
            return describe(state.document, chain, k, named) if is_of_it else verdict
    if not is_proved:
        return verdict
    is_by_lines = decide(left, right, sign, knowledge).is_proved
    in_force = {name: knowledge.definitions[name].node for name in together}
    if kinds and (is_by_lines or _rests_on(verdict, in_force)):
        shown = _shown([*kinds[0][0].values], knowledge)
        reason = f"its words say “{kinds[0][0].words}”, and it holds with {shown} only"
        return describe(state.document, chain, k, Decision(UNDECIDED, reason))
    for letters, said in letters_said_otherwise(state, chain, k, knowledge) if is_by_lines else ():
        others = {n: d for n, d in knowledge.definitions.items() if n not in letters}
        if not decide(left, right, sign, replace(knowledge, definitions=others)).is_proved:
            reason = (
                f"its words say “{said}”, and it holds with {_shown(sorted(letters), knowledge)} only"
            )
            return describe(state.document, chain, k, Decision(UNDECIDED, reason))
    return verdict


def _rests_on(verdict: Verdict, values: Mapping[str, Formula]) -> bool:
    """Tell whether a verdict names the value in force of some letters, or one of another line."""
    parts = re.split(r"[;,] ", verdict.assumption)
    of_lines = [part for part in parts if " of line " in part]
    in_force = tuple(f"{plain_text(Name(n))} = {plain_text(v)}" for n, v in values.items())
    other = tuple(f"{plain_text(Name(n))} = " for n in values)
    return any(part.startswith(in_force) for part in parts) or any(p.startswith(other) for p in of_lines)


def _names_value(verdict: Verdict, values: Mapping[str, Formula]) -> bool:
    """Tell whether a verdict rests on one of some values of letters, by what it says itself."""
    parts = re.split(r"[;,] ", verdict.assumption)
    return any(f"{plain_text(Name(n))} = {plain_text(v)}" in parts for n, v in values.items())


def _with_values(values: Mapping[str, Formula], knowledge: Knowledge) -> Knowledge:
    """Return what is known where letters have other values; results printed for the old ones go."""
    definitions = {
        n: replace(d, rounded=None, node=d.node if d.formula is None or not d.numeric else d.formula)
        for n, d in knowledge.definitions.items()
    }
    known = replace(knowledge, definitions=definitions)
    for name, node in values.items():
        known = known.with_definition(name, Definition(node, knowledge.definitions[name].line, True))
    return known


def _shown(letters: Sequence[str], knowledge: Knowledge) -> str:
    each = [(name, knowledge.definitions[name]) for name in letters]
    return " and ".join(f"{plain_text(Name(n))} = {plain_text(d.node)} of line {d.line}" for n, d in each)
