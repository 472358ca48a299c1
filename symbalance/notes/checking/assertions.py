"""Claims: lines, and pieces of lines, bound to a quantity the library knows."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable
from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Formula, Product, Span, names
from symbalance.document.text_writer import formula_text
from symbalance.errors import SymbalanceError
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.harmonics import components
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, UNDECIDED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.rounding import decimals
from symbalance.notes.checking.descriptions import differences, exact_value, lines_of, word_for
from symbalance.notes.checking.engines import Sources
from symbalance.notes.checking.quantities import quantity
from symbalance.notes.checking.repair.fixes import add_fix, is_proved_as_far
from symbalance.notes.checking.sidecar import Binding
from symbalance.notes.checking.verdicts import UNREADABLE, Verdict
from symbalance.notes.reading import ReadingError, read_expression
from symbalance.notes.reading.equations import Chain, Document, Side


def by_line(binds: Iterable[Binding]) -> dict[int, list[Binding]]:
    """Return the binds of whole lines, by line."""
    result: dict[int, list[Binding]] = defaultdict(list)
    for bind in binds:
        if not bind.text:
            result[bind.line].append(bind)
    return result


def side_of(document: Document, chain: Chain, bind: Binding) -> int:
    """Return which side of a chain a bind means: the last that stands on its line."""
    touching = [
        k
        for k, side in enumerate(chain.sides)
        if document.line_of(side.span[0]) <= bind.line <= document.line_of(max(side.span[1] - 1, 0))
    ]
    return touching[-1] if touching else len(chain.sides) - 1


def side(
    document: Document,
    chain: Chain,
    index: int,
    bind: Binding,
    knowledge: Knowledge,
    sources: Sources,
    step: Verdict | None,
    excused: bool = False,
) -> Verdict:
    """Return the verdict on a bound side; where its relation was judged too, the claim decides."""
    claimed = chain.sides[index]
    line = chain.relations[index - 1].line if index else document.line_of(claimed.span[0])
    decision = decide_assertion(claimed, bind, knowledge, sources)
    base = Verdict(
        line=line,
        link=1,
        source=document.source(claimed.span).strip(),
        verdict=word_for(decision),
        lines=lines_of(document, claimed, line),
        column=document.column_of(claimed.span[0]),
        notes=chain.notes,
        tag=chain.tag,
        inline=chain.inline,
        span=claimed.span,
        claimed=formula_text(claimed.node, plain=True),
        node=claimed.node,
    )
    if decision.status == REFUTED and knowledge.crank is not None and bind.quantity != "harmonic":
        base = _add_fix(base, document, claimed, decision, bind, knowledge, sources)
    reason = ""
    if step is not None and step.verdict == REFUTED and decision.proved and not excused:
        return replace(
            step, bind=bind.title, reason="the right side is what it claims to be, the left is not"
        )
    if step is not None and step.verdict == REFUTED and decision.proved:
        reason = "right as it stands, though it does not follow from the side before"
    elif step is not None and step.fix is not None and base.fix is not None:
        base = replace(base, notes=(*base.notes, f"as a step: {step.fix.kind}, {step.fix.text}"))
    return with_fault_of(step, with_answer(base, decision, bind, reason))


def with_fault_of(step: Verdict | None, claim: Verdict) -> Verdict:
    """Return the verdict on a claim, and in it the fault of symbalance that its relation's step met.

    The claim decides, but the step was not judged, or not mended: that must not be lost with it.
    """
    if step is None or not step.fault or step.fault == claim.fault:
        return claim
    note = step.reason if step.verdict == UNDECIDED else step.notes[-1]
    return replace(
        claim,
        notes=(*claim.notes, f"as a step: {note}"),
        fault=claim.fault or step.fault,
        traceback=claim.traceback + step.traceback,
    )


def _add_fix(
    base: Verdict,
    document: Document,
    claimed: Side,
    decision: Decision,
    bind: Binding,
    knowledge: Knowledge,
    sources: Sources,
) -> Verdict:
    def proves(node: Formula) -> bool:
        return is_proved_as_far(
            decide_assertion(Side((node,), claimed.span), bind, knowledge, sources), decision
        )

    return add_fix(base, document, claimed, decision, knowledge, proves)


def with_answer(base: Verdict, decision: Decision, bind: Binding, reason: str = "") -> Verdict:
    """Return a verdict filled from the answer of a claim."""
    bad = not decision.proved
    exact, exact_node = exact_value(decision) if bad else ("", None)
    return replace(
        base,
        verdict=word_for(decision),
        bind=bind.title,
        reason=reason or decision.reason,
        order=decision.order if decision.proved else "",
        assumption=", ".join(decision.assumptions) if decision.proved else "",
        exact=exact,
        exact_node=exact_node,
        witness=decision.witness if bad else {},
        differences=differences(decision) if bad else (),
    )


def decide_assertion(claimed: Side, bind: Binding, knowledge: Knowledge, sources: Sources) -> Decision:
    """Decide whether a side is the quantity it is bound to."""
    if bind.quantity == "harmonic":
        return _harmonic(claimed, bind, knowledge)
    if knowledge.crank is None:
        return Decision(UNDECIDED, "no geometry")
    exact = expected(claimed.node, bind, knowledge, sources)
    plain = decimals(claimed.node) or not names(claimed.node)
    return decide(Side((exact,), (0, 0)), claimed, "=" if plain else "≈", knowledge, bind.through)


def expected(claimed: Formula, bind: Binding, knowledge: Knowledge, sources: Sources) -> Formula:
    """Return what a bound side ought to be, in the document's letters."""
    assert knowledge.crank is not None
    exact = quantity(bind, knowledge.crank, sources, bool(decimals(claimed)) and not names(claimed))
    if bind.scale:
        try:
            scale = read_expression(bind.scale, knowledge.letters)[0]
        except ReadingError as problem:
            raise SymbalanceError(
                f"scale = {bind.scale}", problem.what, problem.remedy, f"{bind.place}: bind"
            ) from None
        exact = Product((scale, exact))
    return exact


def _harmonic(claimed: Side, bind: Binding, knowledge: Knowledge) -> Decision:
    """Decide whether a side holds the bound order only."""
    order = Fraction(bind.order or 1)
    for level in list(knowledge.levels(claimed.node))[-1:]:
        try:
            form = knowledge.evaluator(level).form(claimed.node)
        except (NoFormError, TooLargeError) as problem:
            return Decision(UNDECIDED, str(problem))
        orders = {
            max((abs(e) for _, e in place.angle), default=0)
            for place in components(form.domain, form.numerator)
        }
        if orders == {order}:
            return Decision(PROVED, "", "", (), level, form, form)
        has = ", ".join(str(n) for n in sorted(orders)) or "none"
        return Decision(REFUTED, f"holds order {has}, not {order}", level=level)
    return Decision(UNDECIDED, "nothing known")


def piece(
    document: Document, bind: Binding, knowledge: Knowledge, letters: frozenset[str], sources: Sources
) -> Verdict:
    """Return the verdict on a piece of a line: a table's cell, or a number in prose."""
    span = span_of(document, bind)
    base = Verdict(
        bind.line,
        1,
        bind.text,
        UNREADABLE,
        lines=(bind.line,),
        column=document.column_of(span[0]),
        piece=True,
        span=span,
        claimed=bind.text,
    )
    try:
        readings = read_expression(bind.text, letters, span[0])
    except ReadingError as problem:
        return replace(base, reason=f"{problem.what}; {problem.remedy}", bind=bind.title)
    claimed = Side(readings, span)
    decision = decide_assertion(claimed, bind, knowledge, sources)
    base = replace(
        base,
        claimed=formula_text(claimed.node, plain=True),
        node=claimed.node,
        verdict=word_for(decision),
    )
    if decision.status == REFUTED and bind.quantity != "harmonic":
        base = _add_fix(base, document, claimed, decision, bind, knowledge, sources)
    return with_answer(base, decision, bind)


def span_of(document: Document, bind: Binding) -> Span:
    """Return where the piece of a line stands that a bind means."""
    start = _line_start(document, bind)
    line_text = document.text[start:].split("\n", 1)[0]
    at = (bind.column - 1) if bind.column else line_text.find(bind.text)
    if at < 0 or not line_text.startswith(bind.text, at):
        raise SymbalanceError(
            f"text = {bind.text}",
            f"does not stand on line {bind.line}",
            "copy it from the line",
            bind.place,
        )
    return start + at, start + at + len(bind.text)


def _line_start(document: Document, bind: Binding) -> int:
    starts = [0] + [k + 1 for k, c in enumerate(document.text) if c == "\n"]
    if bind.line > len(starts):
        raise SymbalanceError(
            f"line = {bind.line}", f"the document has {len(starts)} lines", "name one of them", bind.place
        )
    return starts[bind.line - 1]


def name_unreadable(verdicts: list[Verdict], document: Document, bind: Binding) -> bool:
    """Say of what could not be read on a bind's line what it claims to be; tell whether there is any.

    It is the last that stands on the line, as with what could be read, and is counted once.
    """

    def stands_on(span: Span) -> bool:
        return document.line_of(span[0]) <= bind.line <= document.line_of(max(span[1] - 1, span[0]))

    touching = [k for k, v in enumerate(verdicts) if v.verdict == UNREADABLE and stands_on(v.span)]
    if not touching:
        return False
    last = verdicts[touching[-1]]
    titles = f"{last.bind}; {bind.title}" if last.bind else bind.title
    verdicts[touching[-1]] = replace(last, bind=titles)
    return True


def missing_equation(document: Document, bind: Binding) -> Verdict:
    """Return the verdict on a bind whose line holds no equation."""
    start = _line_start(document, bind)
    source = document.text[start:].split("\n", 1)[0].strip()
    reason = "no equation was found on this line; bind a piece of it with text"
    return Verdict(
        bind.line, 1, source, UNREADABLE, reason, lines=(bind.line,), bind=bind.title, span=(start, start)
    )
