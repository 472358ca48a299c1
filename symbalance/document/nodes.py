"""The document tree: the headings, paragraphs, tables and formulas that every writer renders.

A result's room builds a `Document` of the nodes below; each medium is written once, by `text_document`,
`latex_document`, `html_document` and `markdown_document`.

=============  ==================================================================================
node           what it is
=============  ==================================================================================
Heading        a title within the document, level 2 or 3
Paragraph      words and formulas
Facts          names and what is said of them: a speed, a unit, what a letter means
Table          rows under named columns, with a title; numbers stand with their points in line
Formulas       equations, displayed, their relation signs in line
Figure         a picture, with words for those who do not see it
Source         lines somebody wrote, each with its verdict and notes
Details        what a reader may skip
Marked         a line somebody wrote, typeset and coloured, which opens to what is said of it
=============  ==================================================================================

A `Document` holds no character that a reader does not see: what a file's words hold of such is written by
its code.

Words are an `Inline` or several: a string, a formula, an equation, `Code` (taken literally) or `Strong`.

Nodes are compared by identity: classes that compare by content take twice as long to make, and they are
made at every start.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, fields, is_dataclass, replace
from operator import is_
from typing import TYPE_CHECKING, Any

from symbalance.document.formula import Equation, Formula
from symbalance.errors import visible

if TYPE_CHECKING:
    from symbalance.document.shapes import Drawing


@dataclass(frozen=True, eq=False)
class Code:
    """Something taken literally: a file's name, a key, a line somebody wrote."""

    text: str


@dataclass(frozen=True, eq=False)
class Strong:
    """Words that must not be missed."""

    text: str


@dataclass(frozen=True, eq=False)
class Jump:
    """Words that lead to a `Marked` line of the same document, where a medium can follow them.

    With `file` to one of another document, or to its head: a path from where this document lies.
    """

    text: str
    anchor: str = ""
    file: str = ""


Inline = str | Formula | Equation | Code | Strong | Jump
Words = Inline | tuple[Inline, ...]
"""One inline, or several that follow one another; strings carry the spaces between them."""


@dataclass(frozen=True, eq=False)
class Exact:
    """A cell with an exact value and its decimal, each medium showing what its room allows.

    Where `value` fits it is shown, followed by ≈ `near` if `beside`; where it does not, `near` stands in
    the cell (or "below" if there is none) and the exact value below the table.
    """

    value: Formula
    near: Formula | None = None
    beside: bool = False


@dataclass(frozen=True, eq=False)
class TooLong:
    """A cell whose exact value no medium has room for: `near` stands there, and the table says so."""

    near: Words


Cell = Words | Exact | TooLong
UNKNOWN = "–"
"""The cell of a number that is not known: it stands among the numbers of its column."""


@dataclass(frozen=True, eq=False)
class Column:
    """A column's head; `name` is what the column is called in a sentence, where that differs."""

    head: Words
    name: str = ""


@dataclass(frozen=True, eq=False)
class Heading:
    """A title within a document; it never parts from what follows it."""

    words: Words
    level: int = 2


@dataclass(frozen=True, eq=False)
class Paragraph:
    """Words and formulas."""

    words: Words


@dataclass(frozen=True, eq=False)
class Facts:
    """Names and what is said of each."""

    entries: tuple[tuple[Words, Words], ...]
    title: Words = ""


@dataclass(frozen=True, eq=False)
class Table:
    """Rows of cells under columns; the first `keys` columns say what a row is about.

    A table without rows is written as its title and the words `empty`. A column whose cells are all
    empty is left out. `topic` is what it is about in a word, which labels name it by: "force". Of a
    table `in_short` many exact forms that have no room in it are left to the whole document.
    """

    title: Words
    columns: tuple[Column, ...]
    rows: tuple[tuple[Cell, ...], ...]
    keys: int = 1
    empty: str = "none"
    topic: str = ""
    in_short: bool = False


@dataclass(frozen=True, eq=False)
class Formulas:
    """Equations displayed one below the other; long ones are broken between terms."""

    equations: tuple[Equation, ...]


@dataclass(frozen=True, eq=False)
class Figure:
    """A picture: its file's name, its bytes (PNG) or text (SVG), and what it shows in words.

    Or a function that draws it, which is called by a medium that shows it and by no other; the drawing
    itself says what it shows.
    """

    name: str
    picture: bytes | str | Callable[[], Drawing]
    caption: Words
    shows: str = ""

    def drawing(self) -> Drawing | None:
        """Return the drawing, drawn now; None where the picture is bytes or text."""
        return self.picture() if callable(self.picture) else None


@dataclass(frozen=True, eq=False)
class SourceLine:
    """A line somebody wrote: its place, its text, a verdict in a word or two, and what is said of it.

    `typeset` is the line as a formula, where it could be read: media for print show it, not the text.
    `bad` marks a verdict a reader must act on; `notes` and `formulas` stand below the line.
    """

    place: str
    text: str
    verdict: str
    bad: bool = False
    notes: tuple[Words, ...] = ()
    formulas: tuple[tuple[str, Formula], ...] = ()
    typeset: Formula | Equation | None = None


@dataclass(frozen=True, eq=False)
class Source:
    """Lines somebody wrote, with what is said of each."""

    lines: tuple[SourceLine, ...]


LONGEST = 20
"""Characters of an exact number in a short document's table."""


@dataclass(frozen=True, eq=False)
class Details:
    """What a reader may skip; folded where a medium can fold.

    What is `optional` is left out where it cannot, unless all is asked for: see `Document.unfolded`.
    What only shows again what stands elsewhere is not `named` as left out.
    """

    summary: str
    blocks: tuple[Block, ...]
    optional: bool = False
    named: bool = True


MARKS = ("right", "wrong", "unsure", "plain")


@dataclass(frozen=True, eq=False)
class Marked:
    """A line somebody wrote, typeset, with a verdict; it opens to what is said of it.

    `mark` is one of MARKS: how it is coloured. `anchor` is what a `Jump` leads to.
    """

    place: str
    words: Words
    verdict: str
    mark: str
    blocks: tuple[Block, ...] = ()
    anchor: str = ""


Block = Heading | Paragraph | Facts | Table | Formulas | Figure | Source | Details | Marked


@dataclass(frozen=True, eq=False)
class Document:
    """A title and blocks; `lead` are the words under the title, before the first block.

    `signs` are those that a web page shows in place of others, by code: a letter has two forms, and the
    one that somebody's own page shows need not be ours.
    """

    title: Words
    blocks: tuple[Block, ...]
    lead: Words = ""
    signs: Mapping[int, int] = field(default_factory=dict)

    def __post_init__(self) -> None:
        for name in ("title", "blocks", "lead"):
            object.__setattr__(self, name, _visible(getattr(self, name)))

    def unfolded(self, full: bool) -> Document:
        """Return the document for a medium that cannot fold: optional details in full, or their names."""
        omitted: dict[str, None] = {}
        shown = _unfolded(self.blocks, full, omitted)
        if omitted:
            shown = (*shown, Paragraph((f"in full also: {', '.join(omitted)} (", Code("--full"), ")")))
        return replace(self, blocks=shown)


def _unfolded(blocks: tuple[Block, ...], full: bool, omitted: dict[str, None]) -> tuple[Block, ...]:
    """Return blocks with optional details opened or left out, whose names are put into `omitted`."""
    shown: list[Block] = []
    for block in blocks:
        if isinstance(block, Table) and not full:
            shown.append(_rounded(block, omitted))
        elif not isinstance(block, Details):
            shown.append(block)
        elif not block.optional:
            shown.append(Details(block.summary, _unfolded(block.blocks, full, omitted)))
        elif full:
            shown += _unfolded(block.blocks, full, omitted)
        elif block.named:
            omitted[block.summary] = None
    return tuple(shown)


def _rounded(table: Table, omitted: dict[str, None]) -> Table:
    """Return a table whose long exact cells are in decimals, and say so in `omitted`."""
    from symbalance.document.text_writer import formula_text

    def short(cell: Cell) -> Cell:
        if not isinstance(cell, Exact) or cell.near is None or len(formula_text(cell.value)) <= LONGEST:
            return cell
        omitted["the exact form of what is rounded"] = None
        return cell.near

    rows = tuple(tuple(map(short, row)) for row in table.rows)
    return replace(table, rows=rows, in_short=True)


def _visible(value: Any) -> Any:
    """Return words or blocks with every text in them `visible`, whatever file it is from.

    Here, where every document passes, and not in the writers: a medium that forgot it would hand a
    terminal, or a page, what a stranger's file tells it to do.
    """
    if isinstance(value, str):
        return visible(value)
    if isinstance(value, tuple):
        parts = tuple(map(_visible, value))
        return value if all(map(is_, parts, value)) else parts
    if isinstance(value, Formula | Equation) or not is_dataclass(value):
        return value
    changed: dict[str, Any] = {}
    for each in fields(value):
        part = getattr(value, each.name)
        clean = part if each.name == "picture" else _visible(part)  # drawn here, and XML of its own
        if clean is not part:
            changed[each.name] = clean
    return replace(value, **changed) if changed else value  # type: ignore[type-var]


def inlines(words: Words) -> tuple[Inline, ...]:
    """Return words as a tuple, empty strings left out.

    >>> inlines("a"), inlines(("", Code("b")))
    (('a',), (Code(text='b'),))
    """
    several = words if isinstance(words, tuple) else (words,)
    return tuple(each for each in several if each != "")


def blocks(*parts: Block | tuple[Block, ...] | None) -> tuple[Block, ...]:
    """Return blocks in a row, from single ones, groups of them, and None for one that is not there."""
    flat: list[Any] = []
    for part in parts:
        if part is not None:
            flat += part if isinstance(part, tuple) else [part]
    return tuple(flat)
