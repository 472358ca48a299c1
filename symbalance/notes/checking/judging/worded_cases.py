"""A relation is judged by the numbers that its words speak of: "at idle", "the small one", "for (a)".

Where a letter has several numbers, that given last is in force, though a later sentence may name an
earlier one. What is proved by the wrong number is open, and what it refutes may be true by the right one.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from itertools import islice

from symbalance.document.formula import Name, names
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.deciding.cases import FIXES, NUMBERS_PUT_IN
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Definition
from symbalance.notes.checking.premises.definitions import Entry
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import (
    CONDITION,
    CONTRADICTION,
    PREMISE,
    PROVED_WORDS,
    REFUTED,
    UNDECIDED,
    Verdict,
)
from symbalance.notes.checking.words.lists_of_data import sets_number
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.checking.words.words_of_numbers import (
    Spoken,
    number_by_place,
    numbers_spoken_of,
)
from symbalance.notes.reading.equations import Chain

_A_CASE = "a new case"
"""How the reason of a number begins that is taken for one of another case."""
MOST = 8
"""Numbers of a letter, the last ones, among which words choose."""


def by_numbers_spoken_of(
    state: JudgingState, chain: Chain, k: int, verdict: Verdict, again: Callable[[], Verdict]
) -> Verdict:
    """Return a verdict that rests on the numbers which the words before a relation are about."""
    is_put_in = verdict.verdict == PREMISE and verdict.reason.startswith((NUMBERS_PUT_IN, FIXES))
    if not _is_to_be_told(state, chain, verdict, is_put_in=is_put_in):
        return verdict
    spoken, every, is_denied = _numbers_told(state, chain, k)
    if every and is_denied:
        return _said_of_none(state, chain, k, verdict, every, again)
    if every and verdict.verdict in PROVED_WORDS:
        for chosen in every:
            if with_numbers(state, chosen, again).verdict not in PROVED_WORDS:
                reason = f"said of all of them; with {shown_numbers(chosen)} it does not hold"
                return describe(state.document, chain, k, Decision(UNDECIDED, reason))
    return _by_spoken(state, chain, k, verdict, spoken, again, is_put_in) if spoken else verdict


def _by_spoken(
    state: JudgingState,
    chain: Chain,
    k: int,
    verdict: Verdict,
    spoken: Mapping[str, Chain],
    again: Callable[[], Verdict],
    is_put_in: bool,
) -> Verdict:
    """Return the verdict with the numbers that words speak of, where others are in force."""
    premises, moments = state.definitions.premises, state.definitions.open_conditions
    if is_put_in:
        state.definitions.forget_moment(chain.sides[k + 1].node)  # it would prove itself
    there = with_numbers(state, spoken, again)
    if there.verdict in PROVED_WORDS:
        return there
    state.definitions.premises, state.definitions.open_conditions = premises, moments
    if verdict.verdict not in PROVED_WORDS:
        return verdict
    reason = f"its words speak of {shown_numbers(spoken)}, and with that it does not hold"
    return describe(state.document, chain, k, Decision(UNDECIDED, reason))


def _is_to_be_told(state: JudgingState, chain: Chain, verdict: Verdict, *, is_put_in: bool) -> bool:
    """Tell whether a relation is one that may rest on a number which words speak of."""
    if sets_number(chain) and not _has_formula(state, chain):
        return False
    is_case = verdict.verdict == PREMISE and verdict.reason.startswith(_A_CASE) and sets_number(chain)
    judged = (*PROVED_WORDS, REFUTED, CONTRADICTION, UNDECIDED, CONDITION)
    return verdict.verdict in judged or is_put_in or is_case


def _numbers_told(
    state: JudgingState, chain: Chain, k: int
) -> tuple[dict[str, Chain], list[dict[str, Chain]], bool]:
    """Return the numbers that words speak of and are not in force, those of each case, if of several.

    Last stands whether words say of the latter that it is so for none.
    """
    text, sections = state.document.text, state.sections
    spoken: dict[str, Chain] = {}
    every: list[dict[str, Chain]] = []
    is_denied = False
    for name, (givers, now) in _several_numbers(state, chain, k).items():
        if sets_number(chain):  # its words say of what it is, and may name it anew
            place = number_by_place(sections, text, chain, givers)
            told = Spoken(() if place is None else (place,))
        else:
            told = numbers_spoken_of(sections, text, chain, givers, now)
        if told.places:
            state.told_by_words.add((chain.start, k))
        if len(told.places) > 1:
            every = every or [{} for _ in told.places]
            is_denied = is_denied or told.is_denied
            for chosen, n in zip(every, told.places, strict=False):
                chosen[name] = givers[n]
        elif told.places:
            (place,) = told.places
            is_sure = place == now and not _has_several_printed(state, name)
            spoken |= {} if is_sure else {name: givers[place]}
    return spoken, every, is_denied


def _has_several_printed(state: JudgingState, name: str) -> bool:
    """Tell whether a line has proved several numbers of a letter: each may stand for it below."""
    return name in state.results.numbers and len(state.results.numbers[name][1]) > 1


def _has_formula(state: JudgingState, chain: Chain) -> bool:
    """Tell whether lines above have a formula for the letter of which a relation gives a number."""
    return state.sections.has_formula_above(chain.sides[0].node, chain.start)


def _said_of_none(
    state: JudgingState,
    chain: Chain,
    k: int,
    verdict: Verdict,
    every: list[dict[str, Chain]],
    again: Callable[[], Verdict],
) -> Verdict:
    """Return the verdict on a relation that words deny for each of several numbers.

    It claims nothing, unless it holds with one of them: then what the words say is false.
    """
    for chosen in every:
        if with_numbers(state, chosen, again).verdict in PROVED_WORDS:
            reason = f"said not to hold, and with {shown_numbers(chosen)} it does"
            return describe(state.document, chain, k, Decision(REFUTED, reason))
    if verdict.verdict != REFUTED:
        return verdict
    return describe(state.document, chain, k, Decision(CONDITION, "said not to hold for any of them"))


def _several_numbers(state: JudgingState, chain: Chain, k: int) -> dict[str, tuple[list[Chain], int]]:
    """Return the letters behind a relation that have several numbers above, and which is in force."""
    knowledge = state.knowledge(chain.lines[0])
    known = knowledge.definitions
    nodes = {**knowledge.meaning.values, **{name: d.node for name, d in known.items()}}
    behind = {n for side in chain.sides[k : k + 2] for n in names_behind(side.node, nodes)}
    several: dict[str, tuple[list[Chain], int]] = {}
    for name in sorted(n for n in behind & known.keys() if not names(known[n].node)):
        every = reversed(state.sections.chains_above(Name(name), chain.start))
        last = (c for c in every if sets_number(c) and c.sides[1].span[0] not in state.refuted)
        above = [*islice(last, MOST)][::-1]
        values = [c.sides[1].node for c in above]
        if known[name].node in values and len(set(values)) > 1:
            several[name] = above, len(values) - 1 - values[::-1].index(known[name].node)
    return several


def with_numbers(
    state: JudgingState, chosen: Mapping[str, Chain], again: Callable[[], Verdict]
) -> Verdict:
    """Return the verdict with the numbers that lines give letters."""
    definitions, values = state.definitions, state.definitions.values
    nodes = {name: entries[-1].definition.node for name, entries in values.items()}
    resting = {n for n in nodes if not chosen.keys().isdisjoint({n, *names_behind(Name(n), nodes)})}
    definitions.values = {name: [*entries] for name, entries in values.items()}
    for name, entries in definitions.values.items():
        if name in resting and name not in chosen and entries[-1].definition.rounded is not None:
            bare = replace(entries[-1].definition, rounded=None)  # as printed for other numbers
            entries[-1] = replace(entries[-1], definition=bare)
        if name not in chosen and _is_worked_out(entries[-1]):
            entries.extend(_solved_beside(state, entries, chosen))
    for name, giver in chosen.items():
        definition = Definition(giver.sides[1].node, giver.lines[0], numeric=True)
        definitions.values.setdefault(name, []).append(Entry(definition, ()))
    resting |= chosen.keys()
    printed = state.results.numbers
    state.results.numbers = {name: each for name, each in printed.items() if name not in resting}
    try:
        return again()
    finally:
        definitions.values, state.results.numbers = values, printed


def _solved_beside(state: JudgingState, entries: list[Entry], chosen: Mapping[str, Chain]) -> list[Entry]:
    """Return what a letter was solved for by chosen numbers: λ = r/l by their r and l."""
    solved = [e for e in entries if _is_worked_out(e)]
    for name, giver in chosen.items():
        givers = [c for c in state.sections.chains_of(Name(name)) if sets_number(c)]
        place = givers.index(giver)
        later = min((c.lines[0] for c in givers[place + 1 :]), default=giver.lines[0])
        own = [e for e in solved if giver.lines[0] <= e.definition.line < later]
        own = own or ([solved[place]] if len(solved) == len(givers) else [])
        if own:
            return [replace(own[-1], last_line=None)]
    return []


def _is_worked_out(entry: Entry) -> bool:
    """Tell whether a letter's number stands nowhere on the page: it follows from those of others."""
    return entry.definition.numeric and not entry.definition.node.span[1]


def shown_numbers(chosen: Mapping[str, Chain]) -> str:
    """Return the numbers that lines give letters as words: T = 300 of line 1."""
    return " and ".join(
        f"{plain_text(Name(name))} = {plain_text(c.sides[1].node)} of line {c.lines[0]}"
        for name, c in chosen.items()
    )
