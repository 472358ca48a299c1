"""A relation about engine A is judged by the numbers of engine A, though engine B's stand right above."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Definition
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONTRADICTION, PROVED_WORDS, REFUTED, UNDECIDED, Verdict
from symbalance.notes.checking.words.labels_of_cases import LabelsOfCases
from symbalance.notes.reading.equations import Chain


def by_own_numbers(
    state: JudgingState, chain: Chain, k: int, verdict: Verdict, again: Callable[[], Verdict]
) -> Verdict:
    """Return a verdict that rests on no number of another labelled engine or case.

    What is proved by such a number is proved again by the own ones, or undecided; what is refuted by
    one may be proved by the own.
    """
    labels, line = state.labels_of_cases, chain.lines[0]
    judged = (*PROVED_WORDS, REFUTED, CONTRADICTION, UNDECIDED)
    if not labels.are_several or verdict.verdict not in judged:
        return verdict
    own = labels.behind(chain.end) or labels.at(chain.start, line)
    if not own:
        return verdict
    knowledge = state.knowledge(line)
    known = knowledge.definitions
    nodes = {**knowledge.meaning.values, **{name: d.node for name, d in known.items()}}
    behind = {n for side in chain.sides[k : k + 2] for n in names_behind(side.node, nodes)}
    strange = [
        name
        for name in sorted(behind & known.keys())
        if known[name].numeric and _owner(labels, known[name]) not in ("", own)
    ]
    definitions = state.definitions
    values = definitions.values
    has_own = {
        name
        for name, entries in values.items()
        if any(e.definition.numeric and _owner(labels, e.definition) == own for e in entries)
    }
    if not strange or not has_own.issuperset(strange):
        return verdict  # what the own case does not give anew is as it was
    kept = {
        name: [
            replace(entry, last_line=None)  # the other case's numbers have ended it
            if name in strange and _owner(labels, entry.definition) == own
            else entry
            for entry in entries
            if not entry.definition.numeric or _owner(labels, entry.definition) in ("", own)
        ]
        for name, entries in values.items()
    }
    definitions.values = {name: entries for name, entries in kept.items() if entries}
    try:
        there = again()
    finally:
        definitions.values = values
    if there.verdict in PROVED_WORDS:
        return there
    if verdict.verdict not in PROVED_WORDS:
        return verdict
    reason = f"it holds with the numbers of another case; its words name {own}"
    return describe(state.document, chain, k, Decision(UNDECIDED, reason))


def _owner(labels: LabelsOfCases, definition: Definition) -> str:
    """Return the label of the case that a value is of; one that was computed is its line's."""
    place = definition.node.span[0] or labels.end_of_line(definition.line)
    return labels.at(place, definition.line)
