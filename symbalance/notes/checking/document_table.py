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
                Heading("Not checked") if problems else None,
                tuple(Paragraph(words) for words in problems),
                Facts(legend, "How to read it"),
            ),
        )

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
