"""Check of lines that a sidecar file declares to be a known quantity, such as a force's order."""

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
from symbalance.notes.checking.deciding.descriptions import (
    differences,
    exact_value,
    source_lines,
    word_for,
)
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, UNDECIDED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.matrix_relations import decide_published
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.rounding import decimals
from symbalance.notes.checking.declared.engines import Sources
from symbalance.notes.checking.declared.quantities import EQUATIONS, equation_of, quantity
from symbalance.notes.checking.declared.sidecar import Binding
from symbalance.notes.checking.repair.fixes import add_fix, is_proved_as_far
from symbalance.notes.checking.verdicts import UNREADABLE, Verdict
from symbalance.notes.reading import ReadingError, read_expression
from symbalance.notes.reading.equations import Chain, ReadNotes, Side


def by_line(bindings: Iterable[Binding]) -> dict[int, list[Binding]]:
    """Return the bindings of whole lines, by line."""
    result: dict[int, list[Binding]] = defaultdict(list)
    for binding in bindings:
        if not binding.text:
            result[binding.line].append(binding)
    return result


def side_of(document: ReadNotes, chain: Chain, binding: Binding) -> int:
    """Return which side of a chain a binding means: the last that stands on its line."""
    touching = [
        k
        for k, side in enumerate(chain.sides)
        if document.line_of(side.span[0]) <= binding.line <= document.line_of(max(side.span[1] - 1, 0))
    ]
    return touching[-1] if touching else len(chain.sides) - 1


def side_verdict(
    document: ReadNotes,
    chain: Chain,
    index: int,
    binding: Binding,
    knowledge: Knowledge,
    sources: Sources,
    step: Verdict | None,
    is_excused: bool = False,
) -> Verdict:
    """Return the verdict on a bound side; where its relation was judged too, the binding decides."""
    side = chain.sides[index]
    line = chain.relations[index - 1].line if index else document.line_of(side.span[0])
    if binding.quantity in EQUATIONS:
        decision = _decide_equation(chain, index, binding, sources, knowledge)
    else:
        decision = decide_assertion(side, binding, knowledge, sources)
    base = Verdict(
        line=line,
        link=1,
        source=document.source(side.span).strip(),
        verdict=word_for(decision),
        lines=source_lines(document, side, line),
        column=document.column_of(side.span[0]),
        notes=chain.notes,
        tag=chain.tag,
        inline=chain.inline,
        span=side.span,
        claimed=formula_text(side.node, plain=True),
        node=side.node,
    )
    is_value = binding.quantity not in ("harmonic", *EQUATIONS)
    if decision.status == REFUTED and knowledge.crank is not None and is_value:
        base = _add_fix(base, document, side, decision, binding, knowledge, sources)
    reason = ""
    if step is not None and step.verdict == REFUTED and decision.is_proved and not is_excused:
        return replace(
            step, bind=binding.title, reason="the right side is what it claims to be, the left is not"
        )
    if step is not None and step.verdict == REFUTED and decision.is_proved:
        reason = "right as it stands, though it does not follow from the side before"
    elif step is not None and step.fix is not None and base.fix is not None:
        base = replace(base, notes=(*base.notes, f"as a step: {step.fix.kind}, {step.fix.text}"))
    return with_fault_of(step, with_decision(base, decision, binding, reason))


def _decide_equation(
    chain: Chain, index: int, binding: Binding, sources: Sources, knowledge: Knowledge
) -> Decision:
    """Decide whether a relation is the equation that it is bound to."""
    if not index:
        raise SymbalanceError(
            f"quantity = {binding.quantity}",
            "is an equation, and the line is none",
            "bind a line that holds the relation's right side",
            f"{binding.place}: bind",
        )
    equation = equation_of(binding, sources, knowledge.meanings)
    return decide_published(chain.sides[index - 1].node, chain.sides[index].node, equation, knowledge)


def with_fault_of(step: Verdict | None, assertion: Verdict) -> Verdict:
    """Return an assertion's verdict with the fault of symbalance that its relation's step met.

    The assertion decides, but the step was not judged, or not corrected: that must not be lost with it.
    """
    if step is None or not step.fault or step.fault == assertion.fault:
        return assertion
    note = step.reason if step.verdict == UNDECIDED else step.notes[-1]
    return replace(
        assertion,
        notes=(*assertion.notes, f"as a step: {note}"),
        fault=assertion.fault or step.fault,
        traceback=assertion.traceback + step.traceback,
    )


def _add_fix(
    base: Verdict,
    document: ReadNotes,
    side: Side,
    decision: Decision,
    binding: Binding,
    knowledge: Knowledge,
    sources: Sources,
) -> Verdict:
    """Return the verdict with the change that makes the side what it is bound to."""

    def proves(node: Formula) -> bool:
        return is_proved_as_far(
            decide_assertion(Side((node,), side.span), binding, knowledge, sources), decision
        )

    return add_fix(base, document, side, decision, knowledge, proves, side, None)


def with_decision(base: Verdict, decision: Decision, binding: Binding, reason: str = "") -> Verdict:
    """Return a verdict filled from the decision on an assertion."""
    bad = not decision.is_proved
    exact, exact_node = exact_value(decision) if bad else ("", None)
    return replace(
        base,
        verdict=word_for(decision),
        bind=binding.title,
        reason=reason or decision.reason,
        order=decision.order if decision.is_proved else "",
        assumption=", ".join(decision.assumptions) if decision.is_proved else "",
        exact=exact,
        exact_node=exact_node,
        witness=decision.witness if bad else {},
        differences=differences(decision) if bad else (),
        decision=decision,
    )


def decide_assertion(side: Side, binding: Binding, knowledge: Knowledge, sources: Sources) -> Decision:
    """Decide whether a side is the quantity it is bound to."""
    if binding.quantity == "harmonic":
        return _decide_harmonic(side, binding, knowledge)
    if knowledge.crank is None:
        return Decision(UNDECIDED, "no geometry")
    exact = expected_value(side.node, binding, knowledge, sources)
    plain = decimals(side.node) or not names(side.node)
    return decide(Side((exact,), (0, 0)), side, "=" if plain else "≈", knowledge, binding.through)


def expected_value(node: Formula, binding: Binding, knowledge: Knowledge, sources: Sources) -> Formula:
    """Return what a bound side ought to be, in the document's letters."""
    assert knowledge.crank is not None
    exact = quantity(binding, knowledge.crank, sources, bool(decimals(node)) and not names(node))
    if binding.scale:
        try:
            scale = read_expression(binding.scale, knowledge.declared)[0]
        except ReadingError as problem:
            raise SymbalanceError(
                f"scale = {binding.scale}", problem.what, problem.remedy, f"{binding.place}: bind"
            ) from None
        exact = Product((scale, exact))
    return exact


def _decide_harmonic(side: Side, binding: Binding, knowledge: Knowledge) -> Decision:
    """Decide whether a side holds the bound order only."""
    order = Fraction(binding.order or 1)
    for level in list(knowledge.levels(side.node))[-1:]:
        try:
            form = knowledge.evaluator(level).form(side.node)
        except (NoFormError, TooLargeError) as problem:
            return Decision(UNDECIDED, str(problem))
        orders = {
            max((abs(e) for _, e in key.angle), default=0)
            for key in components(form.domain, form.numerator)
        }
        if orders == {order}:
            return Decision(PROVED, level=level, left=form, right=form)
        has = ", ".join(str(n) for n in sorted(orders)) or "none"
        return Decision(REFUTED, f"holds order {has}, not {order}", level=level)
    return Decision(UNDECIDED, "nothing known")


def piece_verdict(
    document: ReadNotes, binding: Binding, knowledge: Knowledge, letters: frozenset[str], sources: Sources
) -> Verdict:
    """Return the verdict on a piece of a line: a table's cell, or a number in prose."""
    span = span_of(document, binding)
    base = Verdict(
        binding.line,
        1,
        binding.text,
        UNREADABLE,
        lines=(binding.line,),
        column=document.column_of(span[0]),
        piece=True,
        span=span,
        claimed=binding.text,
    )
    try:
        readings = read_expression(binding.text, letters, span[0])
    except ReadingError as problem:
        return replace(base, reason=f"{problem.what}; {problem.remedy}", bind=binding.title)
    side = Side(readings, span)
    decision = decide_assertion(side, binding, knowledge, sources)
    base = replace(
        base,
        claimed=formula_text(side.node, plain=True),
        node=side.node,
        verdict=word_for(decision),
    )
    if decision.status == REFUTED and binding.quantity != "harmonic":
        base = _add_fix(base, document, side, decision, binding, knowledge, sources)
    return with_decision(base, decision, binding)


def span_of(document: ReadNotes, binding: Binding) -> Span:
    """Return where the piece of a line stands that a binding means."""
    start = _line_start(document, binding)
    line_text = document.text[start:].split("\n", 1)[0]
    at = (binding.column - 1) if binding.column else line_text.find(binding.text)
    if at < 0 or not line_text.startswith(binding.text, at):
        raise SymbalanceError(
            f"text = {binding.text}",
            f"does not stand on line {binding.line}",
            "copy it from the line",
            binding.place,
        )
    return start + at, start + at + len(binding.text)


def _line_start(document: ReadNotes, binding: Binding) -> int:
    starts = [0] + [k + 1 for k, c in enumerate(document.text) if c == "\n"]
    if binding.line > len(starts):
        raise SymbalanceError(
            f"line = {binding.line}",
            f"the document has {len(starts)} lines",
            "name one of them",
            binding.place,
        )
    return starts[binding.line - 1]


def name_unreadable(verdicts: list[Verdict], document: ReadNotes, binding: Binding) -> bool:
    """Say of what could not be read on a binding's line what it claims to be; tell whether there is any.

    It is the last that stands on the line, as with what could be read, and is counted once.
    """

    def stands_on(span: Span) -> bool:
        return document.line_of(span[0]) <= binding.line <= document.line_of(max(span[1] - 1, span[0]))

    touching = [k for k, v in enumerate(verdicts) if v.verdict == UNREADABLE and stands_on(v.span)]
    if not touching:
        return False
    last = verdicts[touching[-1]]
    titles = f"{last.bind}; {binding.title}" if last.bind else binding.title
    verdicts[touching[-1]] = replace(last, bind=titles)
    return True


def missing_equation(document: ReadNotes, binding: Binding) -> Verdict:
    """Return the verdict on a binding whose line holds no equation."""
    start = _line_start(document, binding)
    source = document.text[start:].split("\n", 1)[0].strip()
    reason = "no equation was found on this line; bind a piece of it with text"
    return Verdict(
        binding.line,
        1,
        source,
        UNREADABLE,
        reason,
        lines=(binding.line,),
        bind=binding.title,
        span=(start, start),
    )
