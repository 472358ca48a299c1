"""Assumptions and reasons in their author's numbers: "holds if l = 150 mm", not "l = 150 (1/1000)".

What is calculated with stands in metres, kilograms and radians; a report names a value as its page does,
and a line of a notebook by its cell.
"""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import names
from symbalance.document.text_writer import formula_text
from symbalance.notes.checking.reports.typeset_relations import as_written, is_readable
from symbalance.notes.checking.verdicts import Checked, Verdict
from symbalance.notes.reading.equations import ReadNotes
from symbalance.text import lazy_patterns as re


def with_written_assumptions(checked: Checked) -> Checked:
    """Return a checked page whose verdicts give values with the digits and units of the page."""
    if not any(" = " in verdict.assumption + verdict.reason for verdict in checked.verdicts):
        return checked
    written = _written_values(checked.derivation)
    if not written:
        return checked
    values = "|".join(map(re.escape, sorted(written, key=len, reverse=True)))
    pattern = re.compile(rf"(?<== )(?:{values})(?=[,:;]| and |$)")

    def rewrite(verdict: Verdict) -> Verdict:
        texts = [pattern.sub(_written, text) for text in (verdict.assumption, verdict.reason)]
        is_same = texts == [verdict.assumption, verdict.reason]
        return verdict if is_same else replace(verdict, assumption=texts[0], reason=texts[1])

    def _written(match: re.Match[str]) -> str:
        return written[match[0]]

    return replace(checked, verdicts=tuple(map(rewrite, checked.verdicts)))


def with_cells(checked: Checked) -> Checked:
    """Return a checked notebook whose reasons name lines as its places do: line 6:2, of cell 6."""
    page = checked.derivation
    if all(verdict.cell is None for verdict in checked.verdicts):
        return checked

    def in_cells(lines: re.Match[str]) -> str:
        return _NUMBER.sub(lambda number: _in_cell(page, int(number[0])), lines[0])

    def rewrite(verdict: Verdict) -> Verdict:
        texts = [_LINES.sub(in_cells, text) for text in (verdict.assumption, verdict.reason)]
        notes = tuple(_LINES.sub(in_cells, note) for note in verdict.notes)
        return replace(verdict, assumption=texts[0], reason=texts[1], notes=notes)

    return replace(checked, verdicts=tuple(map(rewrite, checked.verdicts)))


_LINES = re.compile(r"\blines? [0-9]+(?:(?:, | and | to )[0-9]+)*(?![0-9:])")
_NUMBER = re.compile("[0-9]+")


def _in_cell(page: ReadNotes, line: int) -> str:
    place = page.cell_of(line)
    return f"{line}" if place is None else f"{place[0]}:{place[1]}"


def _written_values(page: ReadNotes) -> dict[str, str]:
    """Return for each number with a unit, as it is calculated with, how the page writes it."""
    written: dict[str, str] = {}
    for chain in page.chains:
        for side in chain.sides:
            if names(side.node) or not is_readable(side.node):
                continue
            calculated = formula_text(side.node, plain=True)
            shown = formula_text(as_written(side.node, page.text), plain=True)
            if shown != calculated:
                written.setdefault(calculated, shown)
    return written
