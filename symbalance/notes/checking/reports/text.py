"""The readable report: line, source, verdict, reason, fix."""

from __future__ import annotations

from collections.abc import Callable

from symbalance.document.formula import Name
from symbalance.document.text_writer import formula_text
from symbalance.notes.checking.verdicts import DEFINITION, HOLDS, REFUTED, Checked, Verdict

WIDTH = 100
_TITLES = {
    "holds": "holds",
    "holds_to_order": "holds to order",
    "conditional": "holds if",
    "refuted": "REFUTED",
    "undecided": "UNDECIDED",
    "definition": "definition",
    "unreadable": "UNREADABLE",
}


def report_text(checked: Checked, *, everything: bool = True, quoted: Callable[[str], str] = str) -> str:
    """Return the report on a document: every verdict in line order, then the count.

    `quoted` spells what is not the checker's own: the document's name and what stands in it.
    """
    lines = [quoted(checked.document.name), ""]
    for verdict in checked.verdicts:
        if everything or verdict.verdict not in (HOLDS, DEFINITION):
            lines += _block(verdict, quoted)
    return "\n".join([*lines, "", summary(checked)]) + "\n"


def summary(checked: Checked) -> str:
    """Return the counts of the verdicts in one line."""
    counts = checked.counted()
    if not checked.seen:
        return "No relation was seen: nothing is checked."
    listed = ", ".join(f"{count} {_TITLES[name].lower()}" for name, count in counts.items())
    return f"{checked.seen} {'relation' if checked.seen == 1 else 'relations'} seen: {listed}."


def _block(verdict: Verdict, quoted: Callable[[str], str]) -> list[str]:
    place = f"{verdict.line}" if verdict.link == 1 else f"{verdict.line}.{verdict.link}"
    head = f"{place:>6}  {verdict_words(verdict):<28} {quoted(one_line(verdict.source))}"
    lines = [head]
    lines += [f"{'':8}{detail}" for detail in details(verdict, quoted)]
    return lines


def verdict_words(verdict: Verdict) -> str:
    """Return the verdict as it is read: with its order or its assumption."""
    title = _TITLES[verdict.verdict]
    if verdict.verdict == "holds_to_order":
        return f"{title} {verdict.order}"
    if verdict.verdict == "conditional":
        return f"{title} {verdict.assumption}"
    return title


def one_line(source: str, limit: int = 72) -> str:
    """Return a source of several lines on one, shortened."""
    joined = " ".join(source.replace("\\displaystyle", " ").split())
    return joined if len(joined) <= limit else joined[: limit - 1] + "…"


def details(verdict: Verdict, quoted: Callable[[str], str] = str) -> list[str]:
    """Return what is said below a verdict's line."""
    found: list[str] = []
    if verdict.bind:
        found.append(f"claims to be: {verdict.bind}")
    if verdict.reason:
        found.append(verdict.reason)
    found += [f"note: {note}" for note in verdict.notes]
    for difference in verdict.differences[:6]:
        found.append(f"{difference.term}: claimed {difference.claimed}, exact {difference.exact}")
    if verdict.verdict == REFUTED and verdict.witness:
        found.append(f"witness: {witness_text(verdict)}")
    if verdict.fix:
        found.append(f"found: {verdict.fix.kind}")
        for fault in verdict.fix.faults:
            put = (
                f"for {quoted(one_line(fault.source, 48))} put {fault.should}"
                if fault.source
                else f"add {fault.should}"
            )
            found.append(f"  line {fault.line}, column {fault.column}: {put}")
    elif verdict.is_bad and verdict.exact:
        found.append(f"exact: {one_line(verdict.exact, 400)}")
    return found


def witness_text(verdict: Verdict) -> str:
    """Return a witness as `θ = 1.2, λ = 3.7: left 0.5, right 0.25`."""
    at = ", ".join(
        f"{formula_text(Name(n), plain=True)} = {v}"
        for n, v in verdict.witness.items()
        if n not in ("left", "right")
    )
    sides = ", ".join(f"{n} {verdict.witness[n]}" for n in ("left", "right") if n in verdict.witness)
    return f"{at}: {sides}" if at else sides
