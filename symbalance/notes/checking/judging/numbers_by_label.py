"""A result is judged by the data of its own label: "A: n = 3000. B: n = 6000. For A, P = 31.4".

The data given last are in force, whatever the label before a result says. With those of its own label it
may hold, or fail; what holds with those of another one alone is not said to hold.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from symbalance.document.formula import Name, names
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.judging.worded_cases import shown_numbers, with_numbers
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import (
    CONTRADICTION,
    PREMISE,
    PROVED_WORDS,
    REFUTED,
    UNDECIDED,
    Verdict,
)
from symbalance.notes.checking.words.lists_of_data import sets_number
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_OF_ANOTHER = re.compile(r"one of the two is wrong$|another (?:engine|case)")
"""Reasons by which a relation may be of another case: its label says of which it is."""


def by_data_of_label(
    state: JudgingState,
    chain: Chain,
    k: int,
    verdict: Verdict,
    again: Callable[[], Verdict],
    judged_whole: Callable[[], Verdict],
) -> Verdict:
    """Return a verdict that rests on the numbers that a relation's own label has.

    What these refute by `again` is refuted where nothing else that may be meant is found for it either,
    as `judged_whole` tells.
    """
    labelled = state.labelled_data
    judged = (*PROVED_WORDS, REFUTED, CONTRADICTION, UNDECIDED, PREMISE)
    if verdict.verdict not in judged or not labelled.givers or labelled.gives(chain):
        return verdict
    is_datum = not k and sets_number(chain)
    if is_datum and not state.sections.has_formula_above(chain.sides[0].node, chain.start):
        return verdict
    if verdict.verdict in PROVED_WORDS and labelled.is_of_several(chain):
        return _of_several(state, chain, k, verdict, again)
    numbers = labelled.numbers_at(chain)
    behind = _behind(state, chain, k) if numbers else frozenset[str]()
    chosen = {name: giver for name, giver in numbers.items() if name in behind}
    if not chosen or any(_is_given_since(state, name, chain) for name in chosen):
        return verdict
    is_in_force = all(_is_in_force(state, name, giver, chain) for name, giver in chosen.items())
    if is_in_force and verdict.verdict in (*PROVED_WORDS, REFUTED, CONTRADICTION):
        return verdict
    return _by_chosen(state, chain, k, verdict, chosen, (again, judged_whole), behind)


def _by_chosen(
    state: JudgingState,
    chain: Chain,
    k: int,
    verdict: Verdict,
    chosen: Mapping[str, Chain],
    judges: tuple[Callable[[], Verdict], Callable[[], Verdict]],
    behind: frozenset[str],
) -> Verdict:
    """Return the verdict on a relation with the numbers of its label."""
    state.told_by_words.add((chain.start, k))
    definitions, again, judged_whole = state.definitions, *judges
    premises, moments = definitions.premises, definitions.open_conditions
    definitions.premises = [p for p in premises if p.right is not chain.sides[k + 1].node]
    there = with_numbers(state, chosen, again)
    if there.verdict in PROVED_WORDS:
        return there
    is_against = there.verdict in (REFUTED, CONTRADICTION)
    if is_against and behind.isdisjoint(state.labelled_data.of_others(chain)):
        whole = with_numbers(state, chosen, judged_whole)
        is_against = (
            whole.verdict in (REFUTED, CONTRADICTION)
            or _OF_ANOTHER.search(whole.reason or "") is not None
        )
    else:
        is_against = False
    definitions.premises, definitions.open_conditions = premises, moments
    if is_against:
        return there
    if verdict.verdict not in (*PROVED_WORDS, REFUTED, CONTRADICTION):
        return verdict
    reason = f"its label has {shown_numbers(chosen)}, and with that it is not shown to hold"
    return describe(state.document, chain, k, Decision(UNDECIDED, reason))


_AT = re.compile(
    r"[\s$)]{0,6}(?:at|for|with|when|where|if|bei|für|mit|wenn|pour|à|avec|quand|per|con|a|para|cuando)\s+\$?\s*",
    re.IGNORECASE,
)
"""Between a result and the datum right behind it: ω = 314 rad/s at n = 3000 rpm."""


def by_datum_behind(
    state: JudgingState, chain: Chain, k: int, verdict: Verdict, again: Callable[[], Verdict]
) -> Verdict:
    """Return a verdict that rests on the number that is given right behind a result, and no other one."""
    is_judged = verdict.verdict in (*PROVED_WORDS, REFUTED) and k + 2 == len(chain.sides)
    datum = _datum_behind(state, chain, k) if is_judged else None
    if datum is None:
        return verdict
    name, giver = datum
    there = with_numbers(state, {name: giver}, again)
    is_refuted = there.verdict == REFUTED and verdict.verdict in PROVED_WORDS
    if there.verdict in PROVED_WORDS or is_refuted:
        return there
    if verdict.verdict == REFUTED:
        return verdict
    reason = f"with {shown_numbers({name: giver})} behind it, it is not shown to hold"
    return describe(state.document, chain, k, Decision(UNDECIDED, reason))


def _datum_behind(state: JudgingState, chain: Chain, k: int) -> tuple[str, Chain] | None:
    """Return what is given right behind a result that rests on it: its letter, and what gives it."""
    opened = _AT.match(state.document.text, chain.end)
    datum = next(state.sections.chains_behind(chain.end - 1), None) if opened else None
    if opened is None or datum is None or datum.start > opened.end() or not sets_number(datum):
        return None
    head, behind = datum.sides[0].node, _behind(state, chain, k)
    if not isinstance(head, Name) or head.name not in behind or head == chain.sides[0].node:
        return None
    now = state.knowledge(chain.lines[0]).definitions.get(head.name)
    return (head.name, datum) if now is None or not names(now.node) else None


def _is_in_force(state: JudgingState, name: str, giver: Chain, chain: Chain) -> bool:
    """Tell whether a letter has the number of its label at a relation anyhow."""
    now = state.knowledge(chain.lines[0]).definitions.get(name)
    return now is not None and now.node == giver.sides[1].node


def _of_several(
    state: JudgingState, chain: Chain, k: int, verdict: Verdict, again: Callable[[], Verdict]
) -> Verdict:
    """Return a verdict on what is said of several labels: open where it fails with a number of one."""
    behind = _behind(state, chain, k)
    for numbers in state.labelled_data.numbers_of_each(chain):
        chosen = {name: giver for name, giver in numbers.items() if name in behind}
        if chosen and with_numbers(state, chosen, again).verdict not in PROVED_WORDS:
            reason = f"said of several; with {shown_numbers(chosen)} it does not hold"
            return describe(state.document, chain, k, Decision(UNDECIDED, reason))
    return verdict


def _behind(state: JudgingState, chain: Chain, k: int) -> frozenset[str]:
    """Return the letters of a relation, and those behind them."""
    knowledge = state.knowledge(chain.lines[0])
    nodes = {**knowledge.meaning.values, **{n: d.node for n, d in knowledge.definitions.items()}}
    return frozenset(n for side in chain.sides[k : k + 2] for n in names_behind(side.node, nodes))


def _is_given_since(state: JudgingState, name: str, chain: Chain) -> bool:
    """Tell whether a letter has another number in force than one that a label gives it."""
    now = state.knowledge(chain.lines[0]).definitions.get(name)
    values = [g.chain.sides[1].node for g in state.labelled_data.givers[name]]
    return now is not None and not names(now.node) and now.node not in values and Name(name) != now.node
