"""The report as Markdown: a table of every equation with its verdict, and what should stand there."""

from __future__ import annotations

from symbalance.checking.report_text import one_line, summary, verdict_words
from symbalance.checking.verdicts import Checked, Verdict


def report_markdown(checked: Checked) -> str:
    """Return one table row for each verdict, in line order, and the count below."""
    rows = [_row(verdict) for verdict in checked.verdicts]
    head = ["| line | as it stands | verdict | what should stand there, and why |", "|---|---|---|---|"]
    return "\n".join([*head, *rows, "", summary(checked)]) + "\n"


def errors_markdown(documents: list[Checked]) -> str:
    """Return one row for each refuted line of several documents."""
    head = ["| line | as it stands | should be | kind |", "|---|---|---|---|"]
    rows = [_error(checked, v) for checked in documents for v in checked.verdicts if v.is_bad]
    return "\n".join([*head, *rows]) + "\n"


def _row(verdict: Verdict) -> str:
    place = f"{verdict.line}" if verdict.link == 1 else f"{verdict.line}.{verdict.link}"
    word = verdict_words(verdict)
    shown = f"**{word}**" if verdict.is_bad else word
    return f"| {place} | {_code(verdict.source)} | {_cell(shown)} | {_cell(explained(verdict))} |"


def _error(checked: Checked, verdict: Verdict) -> str:
    mark = f"{checked.document.name[:3]}:{verdict.line}"
    kind = verdict.fix.kind if verdict.fix else (verdict.reason or "differs")
    return f"| {mark} | {_code(verdict.source)} | {_cell(corrected(verdict))} | {_cell(kind)} |"


def corrected(verdict: Verdict) -> str:
    """Return what should stand there: the changed pieces, or the exact value."""
    if verdict.fix and verdict.fix.faults:
        return "; ".join(
            f"`{one_line(f.source, 60)}` → {f.should}" if f.source else f"add {f.should}"
            for f in verdict.fix.faults
        )
    if verdict.differences:
        return "; ".join(f"{d.term}: {d.exact}, not {d.claimed}" for d in verdict.differences[:4])
    return verdict.exact


def explained(verdict: Verdict) -> str:
    """Return the reason, the claim and the correction in one line."""
    parts = [f"claims {verdict.bind}" if verdict.bind else "", verdict.reason]
    if verdict.is_bad:
        parts += [corrected(verdict), verdict.fix.kind if verdict.fix else ""]
    parts += list(verdict.notes)
    return "; ".join(part for part in parts if part)


def _code(source: str) -> str:
    return f"`{_cell(one_line(source, 110))}`"


def _cell(text: str) -> str:
    return text.replace("|", "\\|").replace("\n", " ")
