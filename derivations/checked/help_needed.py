"""How much a reader must say before the errors of the founding documents are found: a table.

    python derivations/checked/help_needed.py --from FOLDER

FOLDER holds the documents themselves: what their words propose cannot be drawn from the sheets here.
Each document is checked with no symbols file; with its letters alone (the drafted file, nothing in it
confirmed); with all its proposals taken unread; with the letters of the file here, but no line bound; and
with that whole file. An error is a relation that the last refutes; it is found where a refuted relation
covers its lines. Wrongly accused is what is refuted on lines that hold no error.
"""

from __future__ import annotations

import sys
from pathlib import Path

from symbalance.checking import check, sidecar_draft
from symbalance.notes.checking import Checked
from symbalance.notes.checking.verdicts import REFUTED
from symbalance.text.files import toml_table

HERE = Path(__file__).parent
NAMES = ("000_6d19e3a8fb7bcb72", "001_7249841cd23ed9c0", "002_f1efe5daf3818fe8", "003_df624e4641130983")
HEADS = ("nothing", "letters alone", "proposals unread", "letters by hand", "letters and binds by hand")
Errors = set[tuple[int, int, str]]


def main(arguments: list[str]) -> None:
    """Print the table."""
    if len(arguments) != 2 or arguments[0] != "--from":
        sys.exit("help_needed.py: name the folder of the documents: --from FOLDER")
    print("| document | errors |", " | ".join(HEADS), "|")
    print("| --- " * (len(HEADS) + 2) + "|")
    totals = [0] * (len(HEADS) + 1)
    accused = [0] * len(HEADS)
    for name in NAMES:
        runs = list(checked(Path(arguments[1]) / f"{name}.txt", name))
        errors = refuted(runs[-1])
        wrong = {line for first, last, _ in errors for line in range(first, last + 1)}
        found = [sum(is_found(error, run) for error in errors) for run in runs]
        for k, run in enumerate(runs):
            accused[k] += sum(not wrong & set(range(e[0], e[1] + 1)) for e in refuted(run))
        print(f"| {name[:3]} | {len(errors)} |", " | ".join(map(str, found)), "|")
        totals = [a + b for a, b in zip(totals, (len(errors), *found), strict=True)]
    print("| all |", " | ".join(map(str, totals)), "|")
    print("| wrongly accused | |", " | ".join(map(str, accused)), "|")


def checked(document: Path, name: str) -> list[Checked]:
    """Return what is said of a document with ever more help."""
    by_hand = toml_table((HERE / f"{name}.symbols.toml").read_text(encoding="utf-8"), name)
    scopes = [
        {key: value for key, value in scope.items() if key != "given"}
        for scope in by_hand.get("scope", ())
    ]
    letters = {"symbols": by_hand["symbols"], "scope": scopes}
    draft = toml_table(sidecar_draft(document, {}).toml(), name)
    return [
        check(document, {}),
        check(document, draft),
        check(document, draft, accept_proposals=True),
        check(document, letters),
        check(document, HERE / f"{name}.symbols.toml"),
    ]


def refuted(run: Checked) -> Errors:
    """Return the refuted relations: their first and last line, and a bound piece's text."""
    return {
        (v.line, max(v.lines or (v.line,)), v.source if v.piece else "")
        for v in run.verdicts
        if v.verdict == REFUTED
    }


def is_found(error: tuple[int, int, str], run: Checked) -> bool:
    """Tell whether a run refutes something on an error's lines: of a table's cells, the same one."""
    first, last, piece = error
    return any(
        a <= last and first <= b and (not piece or not text or text == piece)
        for a, b, text in refuted(run)
    )


if __name__ == "__main__":
    main(sys.argv[1:])
