"""From a proved repair to what the report says: which piece of which line, and what should be there."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from traceback import format_exception

from symbalance.document.formula import Formula
from symbalance.document.text_writer import formula_text
from symbalance.errors import SymbalanceError, fault_of
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.steps import Answer
from symbalance.notes.checking.repair.diagnosis import Repair, diagnosed
from symbalance.notes.checking.repair.sieving import Case
from symbalance.notes.checking.repair.term_repair import kind
from symbalance.notes.checking.verdicts import REFUTED, Fault, Fix, Verdict
from symbalance.notes.reading.equations import Document, Side

OTHER_SIDE = 0.2
MOST_OTHER = 2.0


def mended(
    verdict: Verdict,
    document: Document,
    side: Side,
    answer: Answer,
    knowledge: Knowledge,
    proves: Callable[[Formula], bool],
    other: tuple[Side, Callable[[Formula], bool]] | None = None,
) -> Verdict:
    """Return a refuted verdict with the change that makes its line true, if one is found.

    `other` is the left side and how a changed one is proved: it may hold the slip just as well.
    """
    if verdict.verdict != REFUTED or answer.left is None:
        return verdict
    try:
        return _with_fix(verdict, document, side, answer, knowledge, proves, other)
    except SymbalanceError:
        raise  # a declaration that cannot be used
    except Exception as problem:  # refuted all the same: only its correction is lost
        fault = fault_of(problem)
        note = f"no correction was found, by a fault of symbalance: {fault}; please report it"
        notes = (*verdict.notes, note)
        return replace(verdict, notes=notes, fault=fault, traceback="".join(format_exception(problem)))


def _with_fix(
    verdict: Verdict,
    document: Document,
    side: Side,
    answer: Answer,
    knowledge: Knowledge,
    proves: Callable[[Formula], bool],
    other: tuple[Side, Callable[[Formula], bool]] | None,
) -> Verdict:
    found = diagnosed(Case(side.node, answer, knowledge, proves))
    where, title = side, ""
    if other is not None and (found is None or found.cost > 1.0 + OTHER_SIDE):
        turned = replace(answer, left=answer.right, right=answer.left)
        rival = diagnosed(Case(other[0].node, turned, knowledge, other[1]))
        if (
            rival is not None
            and rival.cost < MOST_OTHER
            and (found is None or rival.cost + OTHER_SIDE < found.cost)
        ):
            found, where, title = rival, other[0], "left side: "
    if found is None:
        return verdict
    return replace(verdict, fix=fix_of(found, document, where, title))


def repaired(changed: Answer, refuted: Answer) -> bool:
    """Tell whether a changed line is proved, and as much as it was to say: through no lower an order."""
    if not changed.proved:
        return False
    if refuted.kept is None:
        return changed.kept is None
    return changed.kept is None or changed.kept >= refuted.kept


def fix_of(repair: Repair, document: Document, side: Side, title: str = "") -> Fix:
    """Return what the report says of a repair."""
    several = len(repair.changes) > 1
    faults = tuple(
        _fault(old, new, document, side, kind(old, new) if several else repair.kind)
        for old, new in repair.changes
    )
    text = title + formula_text(repair.node, plain=True)
    return Fix(repair.kind, text, repair.node, faults, of_left=bool(title))


def _fault(old: Formula, new: Formula, document: Document, side: Side, kind_of: str) -> Fault:
    span = old.span if old.span != (0, 0) else (side.span[1], side.span[1])
    source = document.source(span).strip()
    return Fault(
        document.line_of(span[0]),
        document.column_of(span[0]),
        source,
        formula_text(new, plain=True),
        kind_of,
        new,
    )
