"""Documents as plain text, 80 columns wide or as wide as a terminal is."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from textwrap import wrap
from typing import assert_never

from symbalance.document import nodes
from symbalance.document.fitting import Fitted, fitted
from symbalance.document.displayed import displayed
from symbalance.document.formula import Decimal, Equation, Formula, Number
from symbalance.document.nodes import Inline, Words, inlines
from symbalance.document.text_writer import TextWriter, formula_text

WIDTH = 80
_INDENT = "  "
_GAP = 2
_HARD = "\u00a0"
_NARROWEST = 12
"""No column of words is wrapped to less."""
_POINT = re.compile(r"[−-]?\d+")

Spelled = Callable[[str], str]


def document_text(document: nodes.Document, width: int = WIDTH, quoted: Spelled = str) -> str:
    """Return a document as text of at most `width` columns, where its words allow.

    `quoted` spells what is taken literally, `Code` and the lines of a `Source`.
    """
    return _Writer(width, quoted).document(document)


class _Writer:
    def __init__(self, width: int, quoted: Spelled) -> None:
        self.width = width - 1
        """The last column stays free: some terminals wrap a line that fills it."""
        self.quoted = quoted

    def document(self, document: nodes.Document) -> str:
        title = self.plain(document.title)
        head = [*self.wrapped(document.title)]
        if any(isinstance(block, nodes.Heading) for block in document.blocks):
            head.append("=" * min(len(title), self.width))
        parts = ["\n".join(head)]
        if inlines(document.lead):
            parts[0] += "\n" + "\n".join(self.wrapped(document.lead))
        parts += ["\n".join(self.block(block)) for block in document.blocks]
        return "\n\n".join(part for part in parts if part) + "\n"

    def block(self, block: nodes.Block) -> list[str]:
        """Return a block's lines."""
        match block:
            case nodes.Heading():
                title = self.plain(block.words)
                return [*self.wrapped(block.words), "-" * min(len(title), self.width)]
            case nodes.Paragraph():
                return self.wrapped(block.words)
            case nodes.Facts():
                return self.facts(block)
            case nodes.Table():
                return self.table(block)
            case nodes.Formulas():
                return self.formulas(block.equations)
            case nodes.Figure():
                caption = f"{self.plain(block.caption)}: " if inlines(block.caption) else ""
                return self.wrapped(f"{caption}[{block.name}] {block.shows}")
            case nodes.Source():
                return [line for each in block.lines for line in self.source_line(each)]
            case nodes.Details():
                inner = ["\n".join(self.block(each)) for each in block.blocks]
                return [block.summary, *"\n\n".join(inner).split("\n")]
        assert_never(block)

    # Words --------------------------------------------------------------------------------------

    def plain(self, words: Words) -> str:
        """Return words as one line; the spaces within a formula may not become line ends."""
        return "".join(map(self.inline, inlines(words))).replace(_HARD, " ")

    def inline(self, inline: Inline) -> str:
        match inline:
            case str():
                return inline
            case nodes.Code():
                return self.quoted(inline.text)
            case nodes.Strong():
                return inline.text
            case Formula() | Equation():
                return formula_text(inline).replace(" ", _HARD)
        assert_never(inline)

    def wrapped(self, words: Words, first: str = "", rest: str = "", width: int = 0) -> list[str]:
        """Return words as lines; a formula wider than a line is broken before a sign."""
        text = "".join(map(self.inline, inlines(words)))
        room = width or self.width
        if any(len(piece) > room - len(rest) for piece in text.split(" ")):
            text = _SIGNS.sub(" ", text)
        lines = wrap(
            text, room, initial_indent=first, subsequent_indent=rest, break_long_words=False,
            break_on_hyphens=False,
        )  # fmt: skip
        return [line.replace(_HARD, " ") for line in lines or [first.rstrip()]]

    def facts(self, facts: nodes.Facts) -> list[str]:
        """Return facts, names in a column of their own where they are short."""
        head = self.wrapped(facts.title) if inlines(facts.title) else []
        names = [self.plain(name) for name, _ in facts.entries]
        column = max(map(len, names), default=0)
        lines = []
        for name, (_, value) in zip(names, facts.entries, strict=True):
            lead = f"{_INDENT}{name:<{column}}  " if value != "" else f"{_INDENT}{name}"
            lines += self.wrapped(value, lead, " " * len(lead))
        return [*head, *lines]

    def source_line(self, line: nodes.SourceLine) -> list[str]:
        head = f"{line.place:>6}  {line.verdict:<28} {self.quoted(line.text)}".rstrip()
        below = [part for note in line.notes for part in self.wrapped(note, " " * 8, " " * 10)]
        for name, formula in line.formulas:
            below += self.wrapped((f"{name}: ", formula), " " * 8, " " * 10)
        return [head, *below]

    # Formulas -----------------------------------------------------------------------------------

    def formulas(self, equations: Sequence[Equation]) -> list[str]:
        rows = list(displayed(equations, TextWriter(), self.width - len(_INDENT), len(_INDENT)))
        left = max((len(name) for name, _, _ in rows), default=0)
        return [f"{_INDENT}{name:>{left}} {_INDENT * depth}{line}" for name, depth, line in rows]

    # Tables -------------------------------------------------------------------------------------

    def table(self, table: nodes.Table) -> list[str]:
        title = self.wrapped(table.title) if inlines(table.title) else []
        if not table.rows:
            return [*title, *self.wrapped(table.empty, _INDENT, _INDENT)]
        room = self.width - len(_INDENT)
        fit = fitted(table, lambda words: len(self.plain(words)), room, _GAP)
        return [*title, *self.grid(fit, room), *self.left_out(fit)]

    def grid(self, fit: Fitted, room: int) -> list[str]:
        columns = [
            self.column([fit.columns[i].head, *(row[i] for row in fit.rows)])
            for i in range(len(fit.columns))
        ]
        widths = [max(map(len, column)) for column in columns]
        spare = room - sum(widths) - _GAP * (len(widths) - 1)
        if spare < 0:
            widths = self.narrowed(fit, widths, -spare)
        rows = []
        for i in range(len(fit.rows) + 1):
            words = [column.head for column in fit.columns] if i == 0 else fit.rows[i - 1]
            cells = [
                [column[i]] if len(column[i]) <= width else self.wrapped(words[k], "", "", width)
                for k, (column, width) in enumerate(zip(columns, widths, strict=True))
            ]
            rows.append(_side_by_side(cells, widths))
        rule = _INDENT + "─" * (max(len(line) for row in rows for line in row) - len(_INDENT))
        return [*rows[0], rule, *(line for row in rows[1:] for line in row)]

    def column(self, cells: Sequence[Words]) -> list[str]:
        """Return a column's cells; where all below the head are numbers, their points stand in line."""
        head, *body = map(self.plain, cells)
        if not all(_is_number(cell) for cell in cells[1:]):
            return [head, *body]
        before = max(len(_whole(cell)) for cell in body)
        body = [" " * (before - len(_whole(cell))) + cell if cell else "" for cell in body]
        if all(cell.strip().lstrip("−-").isdecimal() for cell in body if cell):
            head = head.rjust(before)
            body = [cell.rjust(len(head)) for cell in body]
        return [head, *body]

    def narrowed(self, fit: Fitted, widths: list[int], over: int) -> list[int]:
        """Return widths that fit, the widest columns of words giving way."""
        narrow = list(widths)
        while over > 0:
            open_columns = [
                i
                for i, width in enumerate(narrow)
                if width > _NARROWEST and not all(_is_number(row[i]) for row in fit.rows)
            ]
            if not open_columns:
                break
            narrow[max(open_columns, key=lambda i: narrow[i])] -= 1
            over -= 1
        return narrow

    def left_out(self, fit: Fitted) -> list[str]:
        """Return the exact forms that have no room in the table, a line each."""
        lines = [
            part
            for each in fit.left_out
            for part in self.wrapped(
                (f"{each.place} {each.name} = ", each.value), _INDENT, _INDENT + "    "
            )
        ]
        return [f"{_INDENT}exactly:", *lines] if lines else []


_SIGNS = re.compile(f"{_HARD}(?=[+−=≈] ?)")
"""Where a formula too wide for a line may be broken."""


def _is_number(words: Words) -> bool:
    parts = inlines(words)
    return not parts or (len(parts) == 1 and isinstance(parts[0], Decimal | Number))


def _whole(cell: str) -> str:
    """Return what stands before a number's point."""
    found = _POINT.match(cell)
    return found[0] if found else cell


def _side_by_side(cells: Sequence[Sequence[str]], widths: Sequence[int]) -> list[str]:
    """Return the lines of a row whose cells may have several lines."""
    lines = []
    for k in range(max(map(len, cells))):
        parts = [
            (cell[k] if k < len(cell) else "").ljust(width)
            for cell, width in zip(cells, widths, strict=True)
        ]
        lines.append((_INDENT + (" " * _GAP).join(parts)).rstrip())
    return lines
