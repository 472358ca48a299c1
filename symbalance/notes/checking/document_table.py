"""Table of several checked derivations: how many relations of each hold, or why it was not checked."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, ClassVar

from symbalance.document.formula import number
from symbalance.document.nodes import (
    UNKNOWN,
    Code,
    Column,
    Document,
    Facts,
    Heading,
    Paragraph,
    Table,
    Words,
    blocks,
)
from symbalance.document.result import Result
from symbalance.errors import printable
from symbalance.notes.checking.verdicts import (
    CONTRADICTION,
    PROVED_WORDS,
    REFUTED,
    STATED,
    UNDECIDED,
    UNREADABLE,
)

RIGHT = (*PROVED_WORDS, *STATED)
"""The verdicts that the table counts as holding."""
LONGEST = 28
"""Characters of a name in the table, which has no room for more."""
MOST_ERRORS, MOST_PLACES = 60, 8
"""Errors in the table, and places named of each; the JSON has all."""
WRONG = (REFUTED, UNDECIDED, UNREADABLE)


@dataclass(frozen=True)
class DocumentRow:
    """One document: its name, its report as data (None where it could not be checked), its exit code.

    `problem` says why it could not be checked, in one line.
    """

    name: str
    report: Mapping[str, Any] | None
    exit_code: int
    problem: str = ""

    @staticmethod
    def _wrong(counts: Mapping[str, int]) -> list[int]:
        """Return the counts of WRONG; a contradiction is counted with what is refuted."""
        return [counts[v] + (counts[CONTRADICTION] if v == REFUTED else 0) for v in WRONG]

    @property
    def counts(self) -> list[int] | None:
        """How many relations were seen, and how many hold, are refuted, undecided, unreadable."""
        if self.report is None:
            return None
        counts = self.report["counts"]
        return [self.report["seen"], sum(counts[v] for v in RIGHT), *self._wrong(counts)]


@dataclass(frozen=True, repr=False)
class DocumentTable(Result):
    """Several checked derivations, a row for each, in the order in which they were named."""

    rows: tuple[DocumentRow, ...] = field(hash=False)

    kind: ClassVar[str] = "document-table"

    def summary(self) -> str:
        """Return how many documents there are, and of how many nothing is wrong."""
        right = sum(not row.exit_code for row in self.rows)
        return f"Checked documents: {right} of {len(self.rows)} without a fault"

    def document(self) -> Document:
        """Return a table with a line for each document, then what kept some from being checked."""
        heads = ("document", "seen", "hold", *WRONG, "exit")
        rows = tuple(
            (name, *_cells(row), number(row.exit_code))
            for name, row in zip(_short_names(self.rows), self.rows, strict=True)
        )
        problems = [(Code(row.name), f": {row.problem}") for row in self.rows if row.problem]
        legend = (
            (
                "hold",
                "also to an order or under a condition that is stated; definitions, premises, "
                "conditions and ranges are counted here",
            ),
            ("exit", "0 nothing wrong, 1 not to be relied on, 2 not checked, 3 a fault of symbalance"),
        )
        table = Table("", tuple(Column(head) for head in heads), rows)
        return Document(
            self.summary(),
            blocks(
                table,
                self._errors(),
                Heading("Not checked") if problems else None,
                tuple(Paragraph(words) for words in problems),
                Facts(legend, "How to read it"),
            ),
        )

    def _errors(self) -> Table | None:
        """Return what is wrong in them, the commonest first, and who has it on which line."""
        places: dict[tuple[Any, ...], list[str]] = {}
        shown: dict[tuple[Any, ...], Words] = {}
        for row, name in zip(self.rows, _short_names(self.rows), strict=True):
            for entry in (row.report or {"links": ()})["links"]:
                if "continues" in entry or entry["verdict"] not in WRONG:
                    continue
                key, words = _error(entry)
                places.setdefault(key, []).append(f"{name}:{entry['line']}")
                shown.setdefault(key, words)
        ordered = sorted(places, key=lambda key: (-len(places[key]), key))[:MOST_ERRORS]
        rows = tuple((shown[key], number(len(places[key])), _who(places[key])) for key in ordered)
        more = len(places) - len(ordered)
        title = f"What is wrong, the commonest first{f'; {more} more are in the JSON' if more else ''}"
        columns = (Column("error"), Column("times"), Column("document and line"))
        return Table(title, columns, rows) if rows else None

    def data(self) -> dict[str, Any]:
        """Return every document's report, with its exit code."""
        return {"documents": [_data(row) for row in self.rows]}

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each document."""
        names = ("seen", "hold", *WRONG)
        return [
            {
                "document": row.name,
                **dict(zip(names, row.counts or [None] * len(names), strict=True)),
                "exit": row.exit_code,
                "problem": row.problem,
            }
            for row in self.rows
        ]


def _error(entry: Mapping[str, Any]) -> tuple[tuple[Any, ...], Words]:
    """Return what makes two errors the same, and the error in words: its verdict, kind and change."""
    if entry["verdict"] == UNREADABLE:
        reason = str(entry["reason"] or "").partition(": ")[2] or str(entry["reason"])
        return (UNREADABLE, reason), f"{UNREADABLE}: {reason.partition(';')[0]}"
    wrong = entry["wrong"]
    if wrong:
        change = tuple((each["source"], each["should"]) for each in wrong)
        first = wrong[0]
        piece = Code(_one_line(first["source"])) if first["source"] else "nothing"
        more = f" (and {len(wrong) - 1} more)" if len(wrong) > 1 else ""
        words: Words = (f"{entry['fix_kind']}: for ", piece, " put ", _one_line(first["should"]), more)
        return (entry["verdict"], entry["fix_kind"], change), words
    source = " ".join(str(entry["source"]).split())
    return (entry["verdict"], "", source), (f"{entry['verdict']}: ", Code(_one_line(source)))


def _one_line(text: str) -> str:
    line = " ".join(text.split())
    return line if len(line) <= LONGEST else f"{line[: LONGEST - 1]}…"


def _who(places: list[str]) -> str:
    """Return documents with their lines, the first few of many."""
    more = f" and {len(places) - MOST_PLACES} more" if len(places) > MOST_PLACES else ""
    return ", ".join(places[:MOST_PLACES]) + more


def _short_names(rows: tuple[DocumentRow, ...]) -> list[str]:
    """Return names that fit a column: without the folders that all share, and of long ones the end."""
    folders = [row.name.split("/")[:-1] for row in rows]
    shared = 0
    while len(rows) > 1 and len({tuple(folder[: shared + 1]) for folder in folders}) == 1:
        if shared == len(folders[0]):
            break
        shared += 1
    names = ["/".join(printable(row.name).split("/")[shared:]) for row in rows]
    return [name if len(name) <= LONGEST else f"…{name[1 - LONGEST :]}" for name in names]


def _cells(row: DocumentRow) -> tuple[Any, ...]:
    if row.counts is None:
        return (UNKNOWN,) * (2 + len(WRONG))
    return tuple(number(count) for count in row.counts)


def _data(row: DocumentRow) -> dict[str, Any]:
    if row.report is None:
        return {"document": row.name, "exit": row.exit_code, "problem": row.problem}
    return {**row.report, "document": row.name, "exit": row.exit_code}
