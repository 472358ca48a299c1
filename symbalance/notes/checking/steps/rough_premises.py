"""What is true by a rough line alone, x - y = 0 by x ≈ y: it holds if that line is exact.

A letter that a line gives roughly is put in as what it is about. So a step of several letters comes out
whose sides differ by as much as that line leaves open. Nor does such a line refute that x ≠ y, or prove
that x ≤ y: such a line stands as if the letter had no value.
"""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import names
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.inequalities import SATISFIED_BY, decide_inequality
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONDITIONAL, HOLDS, PROVED_WORDS, REFUTED, Verdict
from symbalance.notes.reading.equations import Chain

ROUGH_SIGNS = frozenset("≈")


def unless_roughly_known(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; one that rests on what a line says roughly tells so."""
    left, right, sign = chain.sides[k], chain.sides[k + 1], chain.relations[k].sign
    is_inequality = sign in SATISFIED_BY
    is_claim = verdict.verdict == HOLDS or (is_inequality and verdict.verdict in (*PROVED_WORDS, REFUTED))
    if not is_claim or sign in ROUGH_SIGNS:
        return verdict
    knowledge = state.knowledge(chain.lines[0])
    rough = _rough_letters(chain, k, knowledge, {*state.lines_with_rough_sign})
    if not rough:
        return verdict
    exact = {n: d for n, d in knowledge.definitions.items() if n not in rough}
    without = replace(knowledge, definitions=exact)
    if is_inequality:
        with_it, there = (decide_inequality(chain, k, each) for each in (knowledge, without))
        is_by_it = there.status != with_it.status
        return describe(state.document, chain, k, there) if is_by_it else verdict
    with_it, there = (decide(left, right, sign, each) for each in (knowledge, without))
    if not with_it.is_proved or with_it.order or there.is_proved:
        return verdict
    lines = sorted({knowledge.definitions[name].line for name in rough})
    shown = f"line{'s' if len(lines) > 1 else ''} {' and '.join(map(str, lines))}"
    assumption = f"what {shown} says roughly is exact"
    assumption = "; ".join(filter(None, (verdict.assumption, assumption)))
    return replace(verdict, verdict=CONDITIONAL, assumption=assumption)


def _rough_letters(chain: Chain, k: int, knowledge: Knowledge, lines: set[int]) -> frozenset[str]:
    """Return the letters behind a relation that a line gives with ≈; no numbers of an inequality.

    Where a line has = and means ≈, those below it do so as well.
    """
    values = {name: d.node for name, d in knowledge.definitions.items()}
    behind = {n for side in chain.sides[k : k + 2] for n in names_behind(side.node, values)}
    of_letters = chain.relations[k].sign in SATISFIED_BY
    return frozenset(
        name
        for name in behind & values.keys()
        if knowledge.definitions[name].is_rough
        and (knowledge.definitions[name].line in lines or not names(values[name]))
        and (names(values[name]) or not of_letters)
    )
