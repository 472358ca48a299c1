"""Check the founding derivations again and write what is said of them.

    python derivations/checked/regenerate.py                 from the equation sheets in this folder
    python derivations/checked/regenerate.py --from FOLDER   make the sheets anew from the documents first

A sheet NAME.txt holds the equations of a document at their own lines and columns, and nothing else of it:
checking the sheet gives the verdicts of the document. NAME.md is the checked document, errors.md the list
of everything refuted.
"""

from __future__ import annotations

import re
import sys
from dataclasses import replace
from pathlib import Path

from symbalance.checking import check
from symbalance.document.markdown_document import document_markdown
from symbalance.document.nodes import Code, Column, Document, Table, Words, inlines
from symbalance.notes.checking import Checked, Verdict
from symbalance.notes.checking.reports.report_document import one_line

HERE = Path(__file__).parent
LONGEST = 110
"""Characters of a wrong piece that are shown."""
NAMES = {
    "000_6d19e3a8fb7bcb72": "Inertia forces of one cylinder, of in-line and of vee engines",
    "001_7249841cd23ed9c0": "Balance of piston engines: two tables of unbalance",
    "002_f1efe5daf3818fe8": "Counterweight and balance shaft of a single-cylinder engine",
    "003_df624e4641130983": "Inertia forces and couples of a V12",
    "004_15a7b96dd30e08a0": "Motion and stress of a turning crankshaft, in matrices",
}


def main(arguments: list[str]) -> None:
    """Write the sheets (with --from) and the checked documents."""
    if arguments[:1] == ["--from"]:
        for name in NAMES:
            sheet = made_sheet(Path(arguments[1]) / f"{name}.txt", HERE / f"{name}.symbols.toml")
            (HERE / f"{name}.txt").write_text(sheet, encoding="utf-8")
    for path, text in documents().items():
        path.write_text(text, encoding="utf-8")


def documents() -> dict[Path, str]:
    """Return the checked documents and the list of errors, by file."""
    checked = {name: check(HERE / f"{name}.txt") for name in NAMES}
    found = {HERE / f"{name}.md": page(name, result) for name, result in checked.items()}
    return found | {HERE / "errors.md": errors(checked)}


def page(name: str, checked: Checked) -> str:
    """Return one checked document."""
    report = checked.document()
    lead = (
        "Every equation of ", Code(f"{name}.txt"), ", by line, as ", Code("symbalance check"),
        " judges it with ", Code(f"{name}.symbols.toml"), ". ", *inlines(report.lead),
    )  # fmt: skip
    return document_markdown(replace(report, title=NAMES[name], lead=lead))


def errors(checked: dict[str, Checked]) -> str:
    """Return the list of all that is refuted in the documents."""
    lead = (
        "What ", Code("symbalance check"), " refutes in the four documents: document and line, the piece "
        "that is wrong, what should stand there, and the kind of slip where it was found and proved. "
        "λ is each document's own.",
    )  # fmt: skip
    rows = [
        row
        for name, result in checked.items()
        for verdict in result.verdicts
        if verdict.is_bad
        for row in wrong_pieces(name[:3], verdict)
    ]
    columns = tuple(Column(head) for head in ("line", "as it stands", "should be", "kind"))
    return document_markdown(Document("Errors found", (Table("", columns, tuple(rows)),), lead))


def wrong_pieces(document: str, verdict: Verdict) -> list[tuple[Words, ...]]:
    """Return a row for each wrong piece of a refuted line, or one for the line."""
    faults = verdict.fix.faults if verdict.fix else ()
    if faults:
        return [
            (
                f"{document}:{fault.line}",
                Code(one_line(fault.source, LONGEST)) if fault.source else "nothing",
                fault.node or fault.should,
                fault.kind,
            )
            for fault in faults
        ]
    said = "; ".join(f"{d.term}: {d.exact}, not {d.claimed}" for d in verdict.differences[:4])
    source = Code(one_line(verdict.source, LONGEST))
    return [(f"{document}:{verdict.line}", source, said or verdict.exact or verdict.reason, verdict.bind)]


def made_sheet(document: Path, symbols: Path) -> str:
    """Return the equations of a document at their places: a run of its prose leaves a 、."""
    checked = check(document, symbols)
    lines = checked.derivation.text.split("\n")
    wanted = {line for chain in checked.derivation.chains for line in chain.lines}
    wanted |= {verdict.line for verdict in checked.verdicts}
    wanted |= {n for n, line in enumerate(lines, 1) if line.count("$$") % 2 and n - 1 in wanted}
    kept = [bare(line).rstrip() if number in wanted else "" for number, line in enumerate(lines, 1)]
    return "\n".join(kept).rstrip("\n") + "\n"


def bare(line: str) -> str:
    """Return a line with each run of Japanese text as one 、 and blanks; 度 after a number stays.

    >>> bare("連桿比 147.15/36.65=4.02")
    '、   147.15/36.65=4.02'
    """
    return re.sub(
        r"(?:(?!(?<=[0-9])度)[\u3000-\u9fff\uff00-\uffef])+",
        lambda run: "、" + " " * (len(run[0]) - 1),
        line,
    )


if __name__ == "__main__":
    main(sys.argv[1:])
