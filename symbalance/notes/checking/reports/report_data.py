"""Verdicts as plain data for JSON and tables: an entry for each relation and continued line."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from symbalance.document.fitting import plain_words
from symbalance.document.text_writer import formula_text
from symbalance.notes.checking.reports.typeset_relations import (
    Sides,
    as_written,
    is_readable,
    sides_by_span,
)
from symbalance.notes.checking.verdicts import (
    FAILING,
    HOLDS,
    NOT_MATHEMATICS,
    REFUTED,
    VERDICTS,
    Checked,
    Verdict,
)


def report_data(checked: Checked) -> dict[str, Any]:
    """Return the report as plain data."""
    sides = sides_by_span(checked.derivation)
    entries = [
        entry
        for v in checked.verdicts
        for entry in ({**verdict_data(v), **_left(v, checked, sides)}, *continuations(v))
    ]
    return {
        "document": checked.derivation.name,
        "seen": checked.relation_count,
        "counts": dict.fromkeys((*VERDICTS, NOT_MATHEMATICS), 0) | checked.counts(),
        "notes": list(checked.derivation.notes),
        "not_mathematics": [
            {
                "line": p.line,
                "column": p.column,
                "why": p.why,
                "source": checked.derivation.source(p.span),
            }
            for p in checked.derivation.not_mathematics
        ],
        "links": sorted(entries, key=lambda entry: entry["line"]),
        **({"remarks": [plain_words(each) for each in checked.remarks]} if checked.remarks else {}),
    }


def _left(verdict: Verdict, checked: Checked, sides: Sides) -> dict[str, str]:
    """Return what stands before the relation's sign, as it is typed, where that was read."""
    chain, k = sides.get(verdict.span, (None, 0))
    if chain is None or not k:
        return {}
    source = checked.derivation.shown(chain.sides[k - 1].node, chain.sides[k - 1].span)
    left = {"left": source, "sign": chain.relations[k - 1].sign}
    nodes = chain.sides[k - 1].node, chain.sides[k].node
    if verdict.verdict not in FAILING or not all(map(is_readable, nodes)):
        return left
    shown = [formula_text(as_written(node, checked.derivation.text), plain=True) for node in nodes]
    return left | {"read": f"{shown[0]} {left['sign']} {shown[1]}"}


def verdict_data(verdict: Verdict) -> dict[str, Any]:
    """Return one verdict as plain data; what does not apply is null, empty or absent."""
    fix = verdict.fix
    entry: dict[str, Any] = {
        "line": verdict.line,
        "link": verdict.link,
        "column": verdict.column,
        "lines": list(verdict.lines),
        "source": verdict.source,
        "verdict": verdict.verdict,
        "order": verdict.order or None,
        "assumption": verdict.assumption or None,
        "reason": verdict.reason or None,
        "claimed": verdict.claimed,
        "exact": verdict.exact or None,
        "witness": dict(verdict.witness),
        "differences": [
            {"term": d.term, "claimed": d.claimed, "exact": d.exact} for d in verdict.differences
        ],
        "fix": fix.text if fix else None,
        "fix_kind": fix.kind if fix else None,
        "slip": fix.words if fix else None,
        "wrong": [
            {"line": f.line, "column": f.column, "source": f.source, "should": f.should}
            for f in (fix.faults if fix else ())
        ],
    }
    cell, line = verdict.cell or (0, 0)
    place = {"cell": cell, "cell_line": line}
    optional = place | {"bind": verdict.bind, "tag": verdict.tag, "notes": list(verdict.notes)}
    optional |= {"left": verdict.left, "sign": verdict.sign}  # of an arrow
    return entry | {key: value for key, value in optional.items() if value}


def continuations(verdict: Verdict) -> list[dict[str, Any]]:
    """Return entries for the further lines a relation's side stands on, each referring to it.

    Where the wrong pieces are known, only the lines that hold one are refuted.
    """
    wrong = {f.line for f in verdict.fix.faults} if verdict.fix else set()
    entries = []
    for line in verdict.lines[1:]:
        verdict_here = verdict.verdict
        if verdict_here == REFUTED and wrong and line not in wrong:
            verdict_here = HOLDS
        entries.append(
            {"line": line, "link": verdict.link, "continues": verdict.line, "verdict": verdict_here}
        )
    return entries


def verdict_records(verdicts: Iterable[Verdict]) -> list[dict[str, Any]]:
    """Return a row for each verdict, texts and numbers only; what does not apply is None."""
    return [
        {
            "line": v.line,
            "link": v.link,
            "column": v.column,
            "verdict": v.verdict,
            "source": f"{v.left} {v.sign} {v.source}" if v.sign else v.source,
            "order": v.order or None,
            "assumption": v.assumption or None,
            "bind": v.bind or None,
            "reason": v.reason or None,
            "claimed": v.claimed or None,
            "exact": v.exact or None,
            "fix": v.fix.text if v.fix else None,
            "fix_kind": v.fix.kind if v.fix else None,
            "tag": v.tag or None,
        }
        for v in verdicts
    ]
