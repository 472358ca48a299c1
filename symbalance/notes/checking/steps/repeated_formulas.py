"""Formulas that a page has once more, of another thing: a repetition proves nothing there.

In one with a 180° crank the primary force is the formula of the twin with 360°: the letter's formula
above would make it true whatever the cranks are. Where the words of its own sentence, or its heading,
name another thing, it is a first formula again, and may be refuted by what is known of the thing.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from symbalance.document.formula import Name, names
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.meant.meant_words import NOBODY
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import DEFINITION, PROVED_WORDS, STATED, Verdict
from symbalance.notes.checking.words.bodies_named import body_named
from symbalance.notes.checking.words.case_labels import telling_words, thing_said_anew
from symbalance.notes.reading.equations import Chain


def unless_repeated(
    state: JudgingState, chain: Chain, k: int, verdict: Verdict, judge_again: Callable[[], Verdict]
) -> Verdict:
    """Return a verdict; what only repeats the formula of another thing is its letter's first again."""
    head = chain.sides[0].node
    if k or verdict.verdict not in PROVED_WORDS or not isinstance(head, Name):
        return verdict
    above = state.sections.chains_above(head, chain.start)
    if not above or not any(side.node == chain.sides[1].node for side in above[-1].sides[1:]):
        return verdict
    last = above[-1]
    if not _is_of_another(state, last, chain):
        return verdict
    lines = {c.lines[0] for c in above}
    definitions = state.definitions
    definitions.forget_all(head.name)
    definitions.premises = [
        p for p in definitions.premises if p.line not in lines or head.name not in p.names
    ]
    anew = judge_again()
    is_by_it = (anew.reason or "").startswith(f"by line {last.lines[0]}")  # through other letters
    if anew.verdict in PROVED_WORDS and (is_by_it or _is_by_words_above(state, anew, last, chain)):
        anew = describe(state.document, chain, k, Decision(DEFINITION))
    if anew.verdict not in STATED:
        return anew
    if len(chain.sides) > k + 2 and not names(chain.sides[-1].node):
        return verdict  # F = m r ω² = 6 kN of another engine's numbers: what is new is the number
    return replace(anew, reason=f"in line {last.lines[0]} it was said of another thing")


def _is_of_another(state: JudgingState, earlier: Chain, chain: Chain) -> bool:
    """Tell whether the words of a formula, or its heading, name another thing than an earlier one's."""
    sections, text = state.sections, state.document.text
    spans = (earlier.start, earlier.end), (chain.start, chain.end)
    if thing_said_anew(text, *spans, sections.end_before(chain.start) or 0):
        return True
    lines = (earlier.lines[0], chain.lines[0])
    if sections.is_of_another_engine(chain, lines[0]):
        return True
    if sections.same_section(*lines):
        return False
    bodies = [body_named(heading, len(heading)) for heading in map(sections.heading_above, lines)]
    return bodies[0] != bodies[1] and all(bodies)


def _is_by_words_above(state: JudgingState, verdict: Verdict, earlier: Chain, chain: Chain) -> bool:
    """Tell whether a proof rests on what only the words of the earlier formula name: a V-twin at 90°."""
    before, own = (telling_words(state.sections.sentence_before(c)) for c in (earlier, chain))
    rested_on = telling_words(verdict.assumption.partition(NOBODY)[0])
    return bool(rested_on & before - own)
