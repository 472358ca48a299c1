"""From an answer to a verdict: its word, its place, and the texts that go with it."""

from __future__ import annotations

from dataclasses import replace
from traceback import format_exception

from symbalance.document.formula import Span
from symbalance.document.text_writer import formula_text
from symbalance.errors import fault_of
from symbalance.notes.checking.deciding.steps import Answer
from symbalance.notes.checking.differences import differences, exact_value
from symbalance.notes.checking.verdicts import (
    CONDITIONAL,
    DEFINITION,
    HOLDS,
    HOLDS_TO_ORDER,
    REFUTED,
    UNDECIDED,
    UNREADABLE,
    Verdict,
)
from symbalance.notes.reading.equations import Chain, Document, Side, Unreadable


def described(document: Document, chain: Chain, k: int, answer: Answer) -> Verdict:
    """Return the verdict on a relation with its place, texts and differences; `link` is left at 1."""
    side = chain.sides[k + 1]
    line = chain.relations[k].line
    word = word_for(answer)
    bad = word in (REFUTED, UNDECIDED)
    exact, exact_node = exact_value(answer) if bad else ("", None)
    return Verdict(
        line=line,
        link=1,
        source=document.source(side.span).strip(),
        verdict=word,
        reason=answer.reason,
        order=answer.order if word != REFUTED else "",
        assumption=", ".join(answer.assumptions) if word == CONDITIONAL else "",
        claimed=formula_text(side.node, plain=True),
        exact=exact,
        exact_node=exact_node,
        witness=answer.witness if bad else {},
        differences=differences(answer) if word == REFUTED else (),
        lines=lines_of(document, side, line),
        column=document.column_of(side.span[0]),
        inline=chain.inline,
        notes=chain.notes,
        tag=chain.tag,
        span=side.span,
        node=side.node,
    )


def word_for(answer: Answer) -> str:
    """Return the verdict's word."""
    if answer.status == DEFINITION:
        return DEFINITION
    if not answer.proved:
        return answer.status
    if answer.assumptions:
        return CONDITIONAL
    return HOLDS_TO_ORDER if answer.order else HOLDS


def lines_of(document: Document, side: Side, line: int) -> tuple[int, ...]:
    """Return the lines a relation's right side stands on."""
    last = document.line_of(max(side.span[1] - 1, side.span[0]))
    return tuple(range(line, max(last, line) + 1))


def unjudged(
    document: Document, span: Span, line: int, problem: Exception, lines: tuple[int, ...] = ()
) -> Verdict:
    """Return the verdict on a relation whose judging failed, by a fault that is not the document's."""
    return Verdict(
        line,
        1,
        document.source(span).strip(),
        UNDECIDED,
        f"not judged, by a fault of symbalance: {fault_of(problem)}; please report it",
        lines=lines or (line,),
        column=document.column_of(span[0]),
        span=span,
        fault=fault_of(problem),
        traceback="".join(format_exception(problem)),
    )


def with_fault(
    document: Document, chain: Chain, found: list[Verdict], problem: Exception
) -> list[Verdict]:
    """Return a chain's verdicts where judging broke off: what is judged stays, the rest is undecided."""
    judged = {verdict.span for verdict in found}
    places = [(chain.sides[k + 1].span, relation.line) for k, relation in enumerate(chain.relations)]
    places = places or [(chain.sides[-1].span, chain.lines[0])]
    rest = [place for place in places if place[0] not in judged]
    if rest:
        return [*found, *(unjudged(document, span, line, problem) for span, line in rest)]
    fault, last = fault_of(problem), found[-1]
    note = f"what follows may lack its letters, by a fault of symbalance: {fault}; please report it"
    traceback = last.traceback + "".join(format_exception(problem))
    return [*found[:-1], replace(last, notes=(*last.notes, note), fault=fault, traceback=traceback)]


def unreadable(document: Document, found: Unreadable) -> Verdict:
    """Return the verdict on what could not be read."""
    source = document.source(found.span).strip()
    reason = f"column {found.column}: {found.what}; {found.remedy}"
    return Verdict(
        found.line,
        1,
        source,
        UNREADABLE,
        reason,
        lines=(found.line,),
        column=found.column,
        span=found.span,
    )
