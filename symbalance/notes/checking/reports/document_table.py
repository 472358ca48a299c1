"""Table of several checked derivations: how many relations of each hold, or why it was not checked."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any, ClassVar

from symbalance.document.fitting import plain_words
from symbalance.document.formula import number
from symbalance.document.letters import plain_letter
from symbalance.document.nodes import (
    UNKNOWN,
    Block,
    Code,
    Column,
    Details,
    Document,
    Facts,
    Heading,
    Inline,
    Jump,
    Paragraph,
    Strong,
    Table,
    Words,
    blocks,
)
from symbalance.document.result import Result
from symbalance.errors import printable
from symbalance.notes.checking.reports.typeset_relations import formula_of
from symbalance.notes.checking.verdicts import (
    CONTRADICTION,
    DECLARES_NOTHING,
    FAILING,
    MOST_LETTERS,
    PROVED_WORDS,
    REFUTED,
    STATED,
    TO_ITS_RIGHT,
    UNDECIDED,
    UNDECLARED,
    UNREADABLE,
)
from symbalance.text import lazy_patterns as re

RIGHT = (*PROVED_WORDS, *STATED)
"""The verdicts that the table counts as holding."""
LONGEST = 28
"""Characters of a name in the table, which has no room for more."""
MOST_ERRORS, MOST_PLACES = 60, 8
"""Errors in the first table, and documents named of each; the table of each document has all."""
FEWEST_ALIKE = 5
"""Relations that two documents share, of which they say nothing else, for one to be a copy."""
LONGEST_PIECE, LONGEST_TYPESET = 44, 120
"""Characters of a formula in the table of errors: as it was typed, and of one that is typeset."""
WRONG = (REFUTED, UNDECIDED, UNREADABLE)
_GROUPS = (
    ("What is wrong", (REFUTED, CONTRADICTION)),
    ("Not decided", (UNDECIDED,)),
    ("Not read", (UNREADABLE,)),
)
"""What a teacher looks at first, and what is no error of the author's."""
OF_THEIR_OWN = "declared nowhere and read as letters of their own: "
"""Before the letters of a report's note that nobody has declared."""


@dataclass(frozen=True)
class DocumentRow:
    """One document: its name, its report as data (None where it could not be checked), its exit code.

    `problem` says why it could not be checked, in one line; `file` is its own report, if it has one, from
    where the table lies.
    """

    name: str
    report: Mapping[str, Any] | None
    exit_code: int
    problem: str = ""
    file: str = ""

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


@dataclass(frozen=True)
class _Error:
    """An error that documents have in common: its relations by the place of their document."""

    verdict: str
    words: Words
    entries: dict[int, list[Mapping[str, Any]]] = field(default_factory=dict)


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
        """Return a line for each document, what is wrong in them, and why some were not checked."""
        heads = ("document", "seen", "hold", *WRONG, "exit")
        rows = tuple(
            (Jump(name, file=row.file) if row.file else name, *_cells(row), number(row.exit_code))
            for name, row in zip(_short_names(self.rows), self.rows, strict=True)
        )
        problems = [(Code(row.name), f": {_problem(row)}") for row in self.rows if _problem(row)]
        legend = (
            (
                "hold",
                "also to an order or under a condition that is stated; definitions, premises, "
                "conditions and ranges are counted here",
            ),
            ("exit", "0 nothing wrong, 1 not to be relied on, 2 not checked, 3 a fault of symbalance"),
        )
        table = Table("", tuple(Column(head) for head in heads), rows)
        undeclared, copies = self._undeclared(), self._copies()
        return Document(
            self.summary(),
            blocks(
                Paragraph(undeclared) if undeclared else None,
                *map(Paragraph, self._unread_letters()),
                table,
                *map(Paragraph, copies),
                *self._tables_of_errors(),
                self._each_document(),
                Heading("Not checked") if problems else None,
                tuple(Paragraph(words) for words in problems),
                Facts(legend, "How to read it"),
            ),
        )

    def _undeclared(self) -> Words:
        """Return which letters nobody has declared, in how many documents, and how they are."""
        letters: set[str] = set()
        count = 0
        for row in self.rows:
            here = {m[1] for entry in _entries(row) if (m := UNDECLARED.search(entry["reason"] or ""))}
            for note in row.report["notes"] if row.report is not None else ():
                if note.startswith(OF_THEIR_OWN):
                    here |= {*note.removeprefix(OF_THEIR_OWN).split(", ")}
            letters |= here
            count += bool(here)
        if not letters:
            return ""
        shown = ", ".join(sorted(map(plain_letter, letters))[:MOST_LETTERS])
        more = ", …" if len(letters) > MOST_LETTERS else ""
        documents = "1 document has" if count == 1 else f"{count} documents have"
        return (
            Strong(f"{documents} letters that nobody has declared: "),
            f"{shown}{more}. For all documents of a folder: ",
            Code("symbalance check FOLDER/ --declare -o FOLDER/symbols.toml"),
            ", and confirm what it proposes.",
        )

    def _unread_letters(self) -> list[Words]:
        """Return each line of a symbols file that declares nothing, once for all documents it is of."""
        said = (row.report.get("remarks", ()) for row in self.rows if row.report is not None)
        lines = dict.fromkeys(
            each for remarks in said for each in remarks if each.startswith(DECLARES_NOTHING)
        )
        return [(Strong(DECLARES_NOTHING), each.removeprefix(DECLARES_NOTHING)) for each in lines]

    def _copies(self) -> list[Words]:
        """Return which documents have the same relations on the same lines, as copies have."""
        alike: dict[str, list[str]] = {}
        for row, name in zip(self.rows, _short_names(self.rows), strict=True):
            entries = [(e["line"], e["link"], e.get("left"), e["source"]) for e in _entries(row)]
            if len(entries) >= FEWEST_ALIKE:
                alike.setdefault(repr(entries), []).append(name)
        return [
            (Strong("The same relations on the same lines: "), ", ".join(names), ".")
            for names in alike.values()
            if len(names) > 1
        ]

    def _errors(self) -> list[_Error]:
        """Return what is wrong in them, the commonest first, and who has it where."""
        errors: dict[tuple[Any, ...], _Error] = {}
        for k, row in enumerate(self.rows):
            for entry in _entries(row):
                if _is_error(entry):
                    key, words = _error(entry)
                    error = errors.setdefault(key, _Error(entry["verdict"], words))
                    error.entries.setdefault(k, []).append(entry)
        return sorted(errors.values(), key=lambda error: -len(error.entries))

    def _tables_of_errors(self) -> Iterator[Block]:
        """Yield the errors, what was not decided and what was not read, each the commonest first."""
        columns = (Column("error"), Column("documents"), Column("document: lines"))
        errors, names = self._errors(), _short_names(self.rows)
        for title, verdicts in _GROUPS:
            rows = tuple(
                (error.words, number(len(error.entries)), self._who(error.entries, names))
                for error in errors
                if error.verdict in verdicts
            )
            if rows:
                yield Table(f"{title}, the commonest first", columns, rows[:MOST_ERRORS])
            if more := rows[MOST_ERRORS:]:
                table = Table("", columns, more)
                yield Details(f"{title}: {len(more)} more, which fewer have", (table,))

    def _each_document(self) -> Details | None:
        """Return for every document all of its errors, each leading to its line in the report."""
        columns = (Column("document"), *(Column(title.lower()) for title, _ in _GROUPS))
        rows: list[tuple[Words, ...]] = []
        for row, name in zip(self.rows, _short_names(self.rows), strict=True):
            errors = [entry for entry in _entries(row) if _is_error(entry)]
            cells = [
                _lines([entry for entry in errors if entry["verdict"] in verdicts], row.file)
                for _, verdicts in _GROUPS
            ]
            if errors:
                rows.append((Jump(name, file=row.file) if row.file else name, *cells))
        if not rows:
            return None
        table = Table("", columns, tuple(rows))
        return Details("Each document with its errors", (table,), optional=True, named=False)

    def _who(self, places: Mapping[int, list[Mapping[str, Any]]], names: list[str]) -> Words:
        """Return documents with their lines, the first few of many; each line leads to its report's."""
        words: list[Inline] = []
        for k in [*places][:MOST_PLACES]:
            words.append(f"{'; ' if words else ''}{names[k]}: ")
            for n, entry in enumerate(places[k]):
                words += [", "] if n else []
                words.append(_jump(entry, self.rows[k].file))
        more = len(places) - MOST_PLACES
        return (*words, f" and {more} more") if more > 0 else tuple(words)

    def data(self) -> dict[str, Any]:
        """Return every document's report, with its exit code, and the errors with all who have them."""
        errors = [
            {
                "error": plain_words(error.words),
                "verdict": error.verdict,
                "documents": [
                    {"document": self.rows[k].name, "places": list(map(_place, entries))}
                    for k, entries in error.entries.items()
                ],
            }
            for error in self._errors()
        ]
        return {"documents": [_data(row) for row in self.rows], "errors": errors}

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


_LETTERLESS = re.compile(r"\\[A-Za-z]+")
_SET = re.compile(r"\s|\$|\\(?:left|right|[bB]ig[lr]?)(?![A-Za-z])|\\[,;:! ]|(?<=\\)[dt](?=frac)")
"""What only sets a formula: x has the same error with \\left( and without."""


def line_anchor(place: str) -> str:
    """Return the anchor of the line at a place such as 22.2 or, in a notebook, 3:2."""
    return "line-" + place.replace(".", "-").replace(":", "-")


def _entries(row: DocumentRow) -> list[Mapping[str, Any]]:
    """Return the relations of a document; none if it could not be checked."""
    return [e for e in (row.report or {"links": ()})["links"] if "continues" not in e]


def _place(entry: Mapping[str, Any]) -> str:
    """Return a relation's place as its own report writes it."""
    line = f"{entry['cell']}:{entry['cell_line']}" if "cell" in entry else f"{entry['line']}"
    return line if entry["link"] == 1 else f"{line}.{entry['link']}"


def _problem(row: DocumentRow) -> str:
    """Return why a document was not checked, or that there was nothing in it to check."""
    if row.problem:
        return row.problem
    return "no relation was seen in it" if row.report is not None and not row.report["seen"] else ""


def _is_error(entry: Mapping[str, Any]) -> bool:
    """Tell whether a relation fails, and is not an arrow that fails because what it leads to does."""
    repeats = "sign" in entry and str(entry["reason"]).startswith(TO_ITS_RIGHT)
    return entry["verdict"] in FAILING and not repeats


def _jump(entry: Mapping[str, Any], file: str) -> Inline:
    """Return a relation's place, which leads to its line where its document has a report."""
    place = _place(entry)
    return Jump(place, line_anchor(place), file) if file else place


def _lines(entries: list[Mapping[str, Any]], file: str) -> Words:
    """Return the places of relations, each with what is wrong there in a few words, if that is known."""
    words: list[Inline] = []
    for entry in entries:
        slip = entry["slip"] or entry["fix_kind"]
        words += ["; " if words else "", _jump(entry, file), f" ({slip})" if slip else ""]
    return tuple(words)


def _error(entry: Mapping[str, Any]) -> tuple[tuple[Any, ...], Words]:
    """Return what makes two errors the same, and the error in words: what stands, what should.

    A number alone is a different error in another formula; a piece in letters is the same in each.
    """
    verdict = entry["verdict"]
    if verdict == UNREADABLE:
        reason = str(entry["reason"] or "").partition(": ")[2] or str(entry["reason"])
        undeclared = UNDECLARED.search(reason)
        if undeclared:
            reason = f"letter {plain_letter(undeclared[1])} is not declared"
        return (verdict, reason), reason.partition(";")[0]
    relation = " ".join(f"{entry.get('left', '')} {entry.get('sign', '')} {entry['source']}".split())
    wrong = entry["wrong"]
    if not wrong:
        is_proved = verdict == REFUTED
        reason = "" if is_proved else str(entry["reason"] or "").partition(";")[0]
        head = "contradiction: " if verdict == CONTRADICTION else ""
        words = (head, _typeset(relation, entry.get("read", "")), f" ({reason})" if reason else "")
        return (verdict, _SET.sub("", relation)), words
    change = tuple((_SET.sub("", each["source"]), each["should"]) for each in wrong)
    is_whole = wrong[0]["source"].strip() == entry["source"].strip()
    first = wrong[0]
    piece = _typeset(first["source"]) if first["source"] else "nothing"
    more = f" (and {len(wrong) - 1} more)" if len(wrong) > 1 else ""
    words: Words = (
        _typeset(relation, entry.get("read", "")),
        f": {entry['slip'] or entry['fix_kind']}, for ",
        piece,
        " put ",
        _typeset(first["should"]),
        more,
    )
    is_alike = not is_whole and any(each.isalpha() for each in _LETTERLESS.sub("", first["source"]))
    side = "" if is_alike else _SET.sub("", entry["source"])
    return (verdict, entry["fix_kind"], change, _SET.sub("", relation) if is_whole else side), words


def _typeset(source: str, read: str = "") -> Inline:
    """Return a relation or a piece of one as a formula; as it was typed where it is long or not read.

    `read` is the relation as its document's letters and macros read it.
    """
    formula = formula_of(read or source) if len(read or source) <= LONGEST_TYPESET else None
    return Code(_one_line(source)) if formula is None else formula


def _one_line(text: str) -> str:
    line = " ".join(text.split())
    return line if len(line) <= LONGEST_PIECE else f"{line[: LONGEST_PIECE - 1]}…"


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
