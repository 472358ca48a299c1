"""A case that is named once more: "Engine A: r = 40 mm. Engine B: r = 60 mm. Engine A: 2r = 80 mm".

A letter has the value there that its case gave it, not the one that was read last. A four-stroke engine
is a case beside a two-stroke one: its power is p V n/2, and p V n that of the other.
"""

from __future__ import annotations

from symbalance.document.formula import Name, names
from symbalance.notes.checking.premises.definitions import Entry
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.reading.equations import Chain


def return_to_case(state: JudgingState, chain: Chain) -> None:
    """Give letters once more what the case of a relation gave them, where another case gave them anew."""
    if not chain.relations:
        return
    is_named = bool(state.sections.case_named(chain))
    if not is_named and not state.sections.names_strokes:
        return
    for name in _letters_of_case(state, chain):
        above = state.sections.chains_above(Name(name), chain.start)
        givers = state.sections.of_its_named_case(chain, above) if is_named else []
        if givers := givers or state.sections.of_its_cycle(chain, above):
            _give_again(state, name, givers[-1], chain)


def _letters_of_case(state: JudgingState, chain: Chain) -> frozenset[str]:
    """Return the letters that a relation rests on; one to which it gives a number is given anew."""
    head = chain.sides[0].node
    is_datum = isinstance(head, Name) and not names(chain.sides[1].node)
    letters = chain.letters - {head.name} if is_datum and isinstance(head, Name) else chain.letters
    known = state.knowledge(chain.lines[0]).definitions
    return frozenset(letters).union(*(names(known[n].node) for n in letters if n in known))


def _give_again(state: JudgingState, name: str, giver: Chain, chain: Chain) -> None:
    """Let the value of a letter hold that a line above gave it."""
    definitions, value = state.definitions, giver.sides[1].node
    entries = definitions.values.get(name, [])
    now = definitions.at(chain.lines[0]).get(name)
    if giver.sides[1].span[0] in state.refuted or (now is not None and now.node == value):
        return
    own = [e for e in entries if e.definition.line == giver.lines[0] and e.definition.node == value]
    if own:
        entries.append(Entry(own[-1].definition, own[-1].scopes))
    elif names(value) and now is not None and names(now.node):
        definitions.define(name, value, chain)
