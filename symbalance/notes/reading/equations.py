"""Classes for what reading a document yields: chains of relations, and unreadable equations."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import cached_property
from html import unescape

from symbalance.document.formula import Call, Formula, Span, Summation, names, parts_of_kind, walk
from symbalance.document.text_writer import formula_text
from symbalance.notes.reading.markup.notebooks import SUFFIX, cell_place
from symbalance.text import lazy_patterns as re

_MATHML = re.compile(r"<(?:\w+:)?math[\s>]")
_MARK = re.compile(r"</?(?:i|b|em|strong|sub|sup|var|span|code|big|small|font)\b[^<>]*>", re.IGNORECASE)
_ENTITY = re.compile(r"&(?:[a-z]{2,8}|#[0-9]{2,5});", re.IGNORECASE)
_SUPERSCRIPT = re.compile(r"<sup>([-−+]?[0-9]{1,2})</sup>", re.IGNORECASE)
_SUBSCRIPT = re.compile(r"<sub>([^<>]{1,12})</sub>", re.IGNORECASE)
_RAISED = str.maketrans("0123456789-−+", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁻⁺")
RELATIONS = ("=", "≈", "<", ">", "≤", "≥", "≡", "≠", "≪", "≫", "∝")


@dataclass(frozen=True, slots=True)
class Side:
    """One side of a relation, in each way it may be read; the first reading is the usual one.

    `readings` has more than one entry only where usage differs: `1/2λ`, `cos θ/2`.
    """

    readings: tuple[Formula, ...]
    span: Span

    @property
    def node(self) -> Formula:
        """The usual reading."""
        return self.readings[0]

    def changed(self, change: Callable[[Formula], Formula]) -> Side:
        """Return the side with each of its readings changed."""
        return replace(self, readings=tuple(map(change, self.readings)))


@dataclass(frozen=True, slots=True)
class Relation:
    """A relation sign of RELATIONS and the line (from 1) where it stands; ≝ with a ! only demands."""

    sign: str
    line: int
    is_demanded: bool = False


@dataclass(frozen=True)
class Chain:
    """a = b = c: sides and the relations between them, one fewer. A lone expression has no relation.

    `lines` lists every line the chain stands on. `inline` tells that it stands within prose.
    `tag` is the equation's number as printed, without brackets. `notes` say what was read generously
    (for instance "\\sqrt( ) read as the root of the bracket").
    """

    sides: tuple[Side, ...]
    relations: tuple[Relation, ...]
    lines: tuple[int, ...]
    tag: str = ""
    inline: bool = False
    notes: tuple[str, ...] = field(default=())

    @cached_property
    def start(self) -> int:
        """The place of the chain's first character in the text."""
        return min(side.span[0] for side in self.sides)

    @cached_property
    def end(self) -> int:
        """The place behind the chain's last character."""
        return max(side.span[1] for side in self.sides)

    @cached_property
    def letters(self) -> frozenset[str]:
        """The letters that stand in its sides."""
        return frozenset(name for side in self.sides for name in names(side.node))

    @cached_property
    def calls(self) -> tuple[Call, ...]:
        """The functions of something that stand in its sides."""
        return tuple(call for side in self.sides for call in parts_of_kind(side.node, Call))

    @cached_property
    def has_sum(self) -> bool:
        """Whether a sum over cylinders stands in one of its sides."""
        return any(isinstance(part, Summation) for side in self.sides for part in walk(side.node))


@dataclass(frozen=True, slots=True)
class Unreadable:
    """An equation the reader refuses: where (line and column from 1), what, and the remedy."""

    line: int
    column: int
    what: str
    remedy: str
    span: Span


@dataclass(frozen=True, slots=True)
class Passed:
    """A relation sign that says nothing in mathematics, and why: words around it, a tag, a program."""

    line: int
    column: int
    why: str
    span: Span


@dataclass(frozen=True, slots=True)
class Explained:
    """A letter explained in words, m = recip mass: the place of the sign, the letter and its meaning."""

    line: int
    column: int
    letter: str
    words: str
    span: Span


@dataclass(frozen=True, slots=True)
class ReadNotes:
    """A text with the equations found in it, in the order of their lines.

    `notes` say what of the whole text was read generously (for instance its decimal commas).
    `not_mathematics` lists the relation signs that stand in no formula: every sign of the text is one of
    these, in a chain, or in something unreadable.
    """

    name: str
    text: str
    chains: tuple[Chain, ...]
    unreadable: tuple[Unreadable, ...]
    notes: tuple[str, ...] = ()
    not_mathematics: tuple[Passed, ...] = ()
    free_letters: tuple[str, ...] = ()
    """Letters that nobody declared and no line defines, read as letters of their own."""
    own_letters: frozenset[str] = frozenset()
    """Letters that elsewhere are numbers, as e, and are none on this page."""
    explained: tuple[Explained, ...] = ()
    """The relation signs that explain a letter in words."""
    as_typed: str = ""
    """The text as its author typed it, where `text` has the units that macros of its own stand for."""

    def line_of(self, offset: int) -> int:
        """Return the line, from 1, of a character offset."""
        return self.text.count("\n", 0, offset) + 1

    def column_of(self, offset: int) -> int:
        """Return the column, from 1, of a character offset."""
        return offset - (self.text.rfind("\n", 0, offset) + 1) + 1

    def cell_of(self, line: int) -> tuple[int, int] | None:
        """Return the cell of a notebook, from 1, that a line stands in, and its line there."""
        return cell_place(self.text, line) if self.name.lower().endswith(SUFFIX) else None

    def source(self, span: Span) -> str:
        """Return the text of a span."""
        return self.text[span[0] : span[1]]

    def typed(self, span: Span) -> str:
        """Return the text of a span as its author typed it, without the space around it."""
        return (self.as_typed or self.text)[span[0] : span[1]].strip()

    def shown(self, node: Formula, span: Span) -> str:
        """Return a side as its author typed it, without the marks of HTML; of MathML its formula."""
        return as_shown(self.typed(span), node)


def as_shown(typed: str, node: Formula) -> str:
    """Return a formula as it is typed, without the marks of HTML; of MathML the formula.

    >>> as_shown("<i>m</i><sub>c</sub> R<sup>2</sup>", Formula())
    'm_c R²'
    """
    if _MATHML.match(typed):
        return formula_text(node, plain=True)
    if _MARK.search(typed) is None and _ENTITY.search(typed) is None:
        return typed
    raised = _SUPERSCRIPT.sub(lambda match: match[1].translate(_RAISED), typed)
    return unescape(_MARK.sub("", _SUBSCRIPT.sub(r"_\1", raised))).strip()
