"""A relation is judged by the number that its own sentence gives a letter in words: where μ is 0.25.

Another number of the letter stands above, in a relation, and would be in force. What is true with the
number of the sentence holds with it; what is true with the other one alone is open.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from symbalance.document.formula import Formula, Name, names
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Definition
from symbalance.notes.checking.page.page_data import bare_cell, quantity_typed
from symbalance.notes.checking.page.values_in_prose import values_said
from symbalance.notes.checking.premises.definitions import Entry
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONTRADICTION, PROVED_WORDS, REFUTED, UNDECIDED, Verdict
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain
from symbalance.notes.reading.letters.macro_letters import letter_in


def by_numbers_in_sentence(
    state: JudgingState, chain: Chain, k: int, verdict: Verdict, again: Callable[[], Verdict]
) -> Verdict:
    """Return a verdict that rests on the numbers that a relation's own sentence gives letters."""
    if verdict.verdict not in (*PROVED_WORDS, REFUTED, CONTRADICTION, UNDECIDED):
        return verdict
    said = {
        name: node
        for name, node in _numbers_said(state, chain)
        if _is_another(state, chain, k, name, node)
    }
    if not said:
        return verdict
    definitions, values = state.definitions, state.definitions.values
    own = {n: [Entry(Definition(node, chain.lines[0], numeric=True), ())] for n, node in said.items()}
    definitions.values = {name: [*values.get(name, []), *own.get(name, [])] for name in {**values, **own}}
    try:
        there = again()
    finally:
        definitions.values = values
    shown = " and ".join(f"{plain_text(Name(n))} = {plain_text(node)}" for n, node in said.items())
    if there.verdict in PROVED_WORDS:
        return there
    if verdict.verdict not in PROVED_WORDS:
        return verdict
    reason = f"its sentence says {shown}, and with that it does not hold"
    return describe(state.document, chain, k, Decision(UNDECIDED, reason))


def _numbers_said(state: JudgingState, chain: Chain) -> Iterator[tuple[str, Formula]]:
    """Yield the letters to which the sentence before a relation gives a number in words, the last one."""
    text, start = state.document.text, chain.start
    first = start - len(state.sections.sentence_before(chain))
    has_commas = any(note.startswith("decimal commas") for note in state.document.notes)
    found: dict[str, list[Formula]] = {}
    for given in values_said(text, first, start):
        name = letter_in(text, bare_cell(given.letter))
        node = quantity_typed(given.value, given.value_span, has_commas=has_commas)
        if name is not None and node is not None:
            found.setdefault(name, []).append(node)
    yield from ((name, nodes[0]) for name, nodes in found.items() if len(nodes) == 1)


def _is_another(state: JudgingState, chain: Chain, k: int, name: str, node: Formula) -> bool:
    """Tell whether a letter of a relation has another number in force, given before these words."""
    if all(name not in names(side.node) for side in chain.sides[k : k + 2]) or chain.sides[
        0
    ].node == Name(name):
        return False
    knowledge = state.knowledge(chain.lines[0])
    now = knowledge.definitions.get(name)
    if now is None or not now.numeric or now.node.span[0] > node.span[0]:
        return False
    sizes = [number_of(each, knowledge) for each in (now.node, node)]
    return None not in sizes and sizes[0] != sizes[1]
