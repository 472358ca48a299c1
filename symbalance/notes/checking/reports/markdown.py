"""The report as Markdown: a table of every equation with its verdict, and what should stand there."""

from __future__ import annotations

from pathlib import Path

from symbalance.document.latex_writer import formula_latex
from symbalance.notes.checking.reports.text import one_line, summary, verdict_words
from symbalance.notes.checking.verdicts import Checked, Verdict


def report_markdown(checked: Checked) -> str:
    """Return one table row for each verdict, in line order, and the count below."""
    rows = [_row(verdict) for verdict in checked.verdicts]
    head = ["| line | as it stands | verdict | corrected, and why |", "|---|---|---|---|"]
    return "\n".join([*head, *rows, "", summary(checked)]) + "\n"


def corrections_markdown(documents: list[Checked]) -> str:
    """Return one row for each wrong piece of each refuted line of several documents."""
    head = ["| line | as it stands | should be | kind |", "|---|---|---|---|"]
    rows = [
        row for checked in documents for v in checked.verdicts if v.is_bad for row in _errors(checked, v)
    ]
    return "\n".join([*head, *rows]) + "\n"


def _row(verdict: Verdict) -> str:
    place = f"{verdict.line}" if verdict.link == 1 else f"{verdict.line}.{verdict.link}"
    word = verdict_words(verdict)
    shown = f"**{word}**" if verdict.is_bad else word
    return f"| {place} | {_code(verdict.source)} | {_cell(shown)} | {_explained(verdict)} |"


def _explained(verdict: Verdict) -> str:
    """Return the corrected side, the claim, the reason and the notes in one cell."""
    parts = [f"${_cell(formula_latex(verdict.fix.node))}$" if verdict.fix else ""]
    if verdict.is_bad:
        parts.append(verdict.fix.kind if verdict.fix else _cell(differing(verdict)))
    parts += [f"claims {verdict.bind}" if verdict.bind else "", verdict.reason, *verdict.notes]
    return "; ".join(_cell(part) if k else part for k, part in enumerate(parts) if part)


def _errors(checked: Checked, verdict: Verdict) -> list[str]:
    document = Path(checked.document.name).name[:3]
    if not verdict.fix or not verdict.fix.faults:
        should = _cell(differing(verdict) or verdict.reason)
        return [
            f"| {document}:{verdict.line} | {_code(verdict.source)} | {should} | {_cell(verdict.bind)} |"
        ]
    return [
        f"| {document}:{fault.line} | {_code(fault.source or '(nothing)')} | "
        f"{_cell(fault.should)} | {_cell(fault.kind)} |"
        for fault in verdict.fix.faults
    ]


def differing(verdict: Verdict) -> str:
    """Return in which coefficients a line differs, or its exact value."""
    found = [f"{d.term}: {d.exact}, not {d.claimed}" for d in verdict.differences[:4]]
    return "; ".join(found) or verdict.exact


def _code(source: str) -> str:
    return f"`{_cell(one_line(source, 110))}`"


def _cell(text: str) -> str:
    return text.replace("|", "\\|").replace("\n", " ")
