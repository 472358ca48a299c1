"""How a handbook sheet is laid out: pictures in rows, below them tables and words in columns.

A sheet is a drawing, so nobody measures its letters as they are set: a letter counts `text_width` of its
size, which is wide for every common font. Where all of it has room on one page, letters are as large as
that lets them be; where letters would be too small to read, tables go on over further pages, each part
under its own head.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import chain
from textwrap import wrap

from symbalance.document import nodes
from symbalance.document.fitting import fit_table, plain_words
from symbalance.document.shapes import (
    Drawing,
    Group,
    Label,
    Line,
    Shape,
    scaled,
    text_width,
)
from symbalance.errors import SymbalanceError

WIDE, HIGH, MARGIN = 794.0, 1123.0, 45.0
"""An A4 page in pixels of 1/96 inch, and its margin."""
INNER = WIDE - 2 * MARGIN
GAP = 14.0
PICTURES = (200.0, 330.0)
"""Pixels of a row of pictures: the least, where words need the room, and the most."""
LARGEST, LEAST, USUAL = 9.5, 8.0, 9.0
"""Letters' sizes: 7 pt; 6 pt, below which few read them on paper; those of a sheet of several pages."""
LEADING, PARTED = 1.3, 0.85
"""Of their size the distance of lines; of the longer column what is gained by parting a block."""
TITLE, TITLE_LINES = 16.0, 3
CHARACTERS = 70
"""Of a line of half the page."""
ROWS_BEFORE_BREAK = 4
"""Of a table, at the foot of a column: fewer go to the next one."""
_POWER = re.compile(" × 10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)")
_LOWERED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "−0123456789")


@dataclass(frozen=True, eq=False)
class TextLine:
    """A line of a sheet: words, each at tenths of the letters' size from the left edge."""

    words: tuple[tuple[float, str], ...]
    strong: bool = False
    rule: bool = False

    @property
    def width(self) -> float:
        """Its width over the letters' size."""
        return max((x + text_width(words) for x, words in self.words), default=0.0)


@dataclass(frozen=True, eq=False)
class TextBlock:
    """Lines that belong together; the first `head` of them are said again where it is parted."""

    lines: tuple[TextLine, ...]
    head: int = 0

    def parted(self, rows: int) -> tuple[TextBlock, TextBlock]:
        """Return the first lines, and the rest under the same head."""
        again = (*self.lines[: self.head], *self.lines[rows:])
        return TextBlock(self.lines[:rows], self.head), TextBlock(again, self.head)


_EMPTY = TextLine(())


def title_shapes(title: str, words: str, top: float) -> tuple[list[Shape], float]:
    """Return a sheet's head and the sentence below it, and where they end.

    A long name goes on over three lines; of a longer one the rest is cut, and the cut is shown.
    """
    size = TITLE if text_width(title) * TITLE <= INNER else 0.75 * TITLE
    lines = wrap(title, int(INNER / (size * text_width("n"))))
    if len(lines) > TITLE_LINES:
        lines = [*lines[: TITLE_LINES - 1], lines[TITLE_LINES - 1][:-1] + "…"]
    shapes: list[Shape] = []
    for line in lines:
        # Signs of double width: what was counted by letters may still be too wide.
        fitting = min(size, INNER / text_width(line))
        shapes.append(Label((MARGIN, top - 8), line, "start", fitting, strong=True))
        top -= 1.3 * size
    top -= 11
    for line in wrap(words, 118):
        shapes.append(Label((MARGIN, top), line, "start", 10.5))
        top -= 14
    return shapes, top


# Pictures ---------------------------------------------------------------------------------------
CAPTION = 9.5
"""Pixels of the letters above a picture."""


@dataclass(frozen=True, eq=False)
class Picture:
    """A drawing and the words above it."""

    caption: str
    drawing: Drawing


def rows_height(rows: Sequence[Sequence[Picture]], room: float) -> list[float]:
    """Return how high each row of pictures is to be, in all no more than `room` where that can be."""
    natural = []
    for row in rows:
        width = (INNER - GAP * (len(row) - 1)) / len(row)
        drawings = [picture.drawing for picture in row]
        natural.append(max(d.height * min(width / d.width, 1.0) for d in drawings))
    wanted = [min(max(height, 0.6 * PICTURES[0]), PICTURES[1]) for height in natural]
    room -= (GAP + 2 * CAPTION) * len(rows)
    if sum(wanted) <= room:
        return wanted
    return [max(height * room / sum(wanted), min(height, PICTURES[0])) for height in wanted]


def least_height(rows: Sequence[Sequence[Picture]]) -> float:
    """Return the pixels that rows of pictures take at the least, with the gaps below them."""
    return sum(rows_height(rows, 0.0)) + (GAP + 2 * CAPTION) * len(rows)


def picture_rows(rows: Sequence[Sequence[Picture]], top: float, room: float) -> tuple[list[Shape], float]:
    """Return rows of pictures, each as large as its cell lets it be, and where they end."""
    shapes: list[Shape] = []
    for row, high in zip(rows, rows_height(rows, room), strict=True):
        wide = (INNER - GAP * (len(row) - 1)) / len(row)
        for place, picture in enumerate(row):
            drawing = picture.drawing
            left = MARGIN + place * (wide + GAP)
            size = min(CAPTION, wide / max(text_width(picture.caption), 1.0))
            at = (left + wide / 2, top - CAPTION / 2)
            shapes.append(Label(at, picture.caption, size=size, strong=True))
            scale = min(wide / drawing.width, high / drawing.height, 1.0)
            x = left + (wide - scale * drawing.width) / 2 - scale * drawing.left
            y = top - 2 * CAPTION - (high - scale * drawing.height) / 2 - scale * drawing.top
            shapes.append(Group(tuple(scaled(s, scale) for s in drawing.shapes), (x, y)))
        top -= high + GAP + 2 * CAPTION
    return shapes, top


# Tables and facts as lines ----------------------------------------------------------------------


def text_blocks(blocks: Sequence[nodes.Block], characters: int = CHARACTERS) -> list[TextBlock]:
    """Return what is written of blocks; what a reader may skip and pictures are left out."""
    kept = (b for b in blocks if not isinstance(b, nodes.Details | nodes.Figure))
    return [block for each in kept if (block := _block(each, characters)).lines]


def _block(block: nodes.Block, characters: int) -> TextBlock:
    if isinstance(block, nodes.Table):
        return _table(block, characters)
    if isinstance(block, nodes.Facts):
        head = [TextLine(((0.0, plain_words(block.title)),), strong=True)] if block.title else []
        lines = []
        for name, value in block.entries:
            words = plain_words(name) + (f": {plain_words(value)}" if value else "")
            lines += _wrapped(words, characters)
        return TextBlock((*head, *lines), len(head))
    if isinstance(block, nodes.Heading):
        return TextBlock((TextLine(((0.0, plain_words(block.words)),), strong=True),))
    if isinstance(block, nodes.Paragraph):
        return TextBlock(tuple(_wrapped(plain_words(block.words), characters)))
    raise SymbalanceError(
        type(block).__name__, "has no form on a sheet", "give it one in sheet_layout.py"
    )


def _wrapped(words: str, characters: int) -> list[TextLine]:
    return [TextLine(((0.0, line),)) for line in wrap(words, characters, subsequent_indent="  ")]


def _cell_text(words: nodes.Words) -> str:
    """Return a cell as one line, a decimal's power of ten in short."""
    return _POWER.sub(lambda power: f"e{power[1].translate(_LOWERED)}", plain_words(words))


def _table(table: nodes.Table, characters: int) -> TextBlock:
    title = plain_words(table.title)
    if not table.rows:
        return TextBlock(tuple(_wrapped(f"{title}: {table.empty}", characters)))
    fit = fit_table(table, lambda words: len(_cell_text(words)), characters, 2)
    grid = [[plain_words(c.head) for c in fit.columns], *[[_cell_text(c) for c in r] for r in fit.rows]]
    signed = [
        fit.numeric[i] and any(row[i].startswith("−") for row in grid[1:]) for i in range(len(grid[0]))
    ]
    hung = text_width("−")
    starts, x = [], 0.0
    for i, has_sign in enumerate(signed):
        starts.append(x)
        cells = (text_width(row[i]) + (hung if has_sign else 0.0) for row in grid)
        x += max(cells) + 1.1
    head = [TextLine(((0.0, line),), strong=True) for line in wrap(title, characters)]
    lines = []
    for row in grid:
        cells = []
        for i, words in enumerate(row):
            # The figures of a column stand below each other, signs before them.
            indent = hung if signed[i] and not words.startswith("−") else 0.0
            if words:
                cells.append((starts[i] + indent, words))
        lines.append(TextLine(tuple(cells), rule=row is grid[0]))
    for form in fit.left_out:
        lines += _wrapped(f"{form.place} {form.name} = {plain_words(form.value)}", characters)
    if not table.in_short:  # of a short table it names an option of another command
        lines += _wrapped(plain_words(fit.remark), characters)
    return TextBlock((*head, *lines), len(head) + 1)


# Columns and pages ------------------------------------------------------------------------------


@dataclass(frozen=True)
class Setting:
    """Letters of one size in columns: on the first page below its pictures, then on whole pages."""

    size: float
    pages: tuple[tuple[tuple[TextLine, ...], ...], ...]

    @property
    def first_height(self) -> float:
        """The pixels that the first page's columns take."""
        return LEADING * self.size * max(map(len, self.pages[0]), default=0)


def set_text(blocks: Sequence[TextBlock], room: float, columns: int = 2) -> Setting:
    """Return blocks set into columns `room` pixels high, and on more pages where they need them.

    Letters are no smaller than can be read.
    """
    wide = (INNER - GAP * (columns - 1)) / columns
    widest = max((line.width for block in blocks for line in block.lines), default=1.0)
    largest = min(LARGEST, wide / widest)
    sides = _columns(blocks, columns)
    longest = max(map(len, sides))
    size = min(largest, room / (LEADING * longest)) if longest else largest
    if size >= min(LEAST, largest) or not longest:
        return Setting(size, (sides,))
    size = min(USUAL, largest)
    return Setting(size, tuple(_pages(blocks, int(room / (LEADING * size)), size, columns)))


def _columns(blocks: Sequence[TextBlock], columns: int) -> tuple[tuple[TextLine, ...], ...]:
    """Return blocks in one or two columns of about one length.

    A column ends where a block does, unless a block parted makes the page much shorter.
    """
    spaced = [(*block.lines, _EMPTY) for block in blocks]
    if columns == 1 or not spaced:
        return (tuple(chain(*spaced)),)
    splits = [(tuple(chain(*spaced[:k])), tuple(chain(*spaced[k:]))) for k in range(1, len(spaced) + 1)]
    whole = min(splits, key=lambda split: max(map(len, split)))
    longest = max(map(len, whole))
    for most in range(sum(map(len, spaced)) // 2, int(PARTED * longest)):
        first, *others = _pages(blocks, most, LEAST, columns)
        if not others:
            return first
    return whole


def _pages(
    blocks: Sequence[TextBlock], most: int, size: float, columns: int
) -> Iterator[tuple[tuple[TextLine, ...], ...]]:
    """Yield pages of columns filled one after the other; blocks that are too long for one are parted.

    The first page's columns hold `most` lines, the others' what a page holds.
    """
    rest = [*blocks]
    while rest:
        page = []
        for _ in range(columns):
            column: list[TextLine] = []
            while rest and len(column) + len(rest[0].lines) <= most:
                column += [*rest.pop(0).lines, _EMPTY]
            left = most - len(column)
            if rest and left >= rest[0].head + ROWS_BEFORE_BREAK:
                first, rest[0] = rest[0].parted(left)
                column += first.lines
            page.append(tuple(column))
        yield tuple(page)
        most = int((HIGH - 2 * MARGIN - 2 * TITLE) / (LEADING * size))


def column_shapes(columns: Sequence[Sequence[TextLine]], size: float, top: float) -> list[Shape]:
    """Return columns of lines, side by side."""
    wide = (INNER - GAP * (len(columns) - 1)) / len(columns)
    shapes: list[Shape] = []
    for place, column in enumerate(columns):
        x = MARGIN + place * (wide + GAP)
        for row, line in enumerate(column):
            y = top - LEADING * size * (row + 0.5)
            for start, words in line.words:
                shapes.append(Label((x + start * size, y), words, "start", size, strong=line.strong))
            if line.rule:
                below = y - 0.62 * size
                shapes.append(Line(((x, below), (x + wide, below)), "faint"))
    return shapes


def sheet_pages(
    title: str,
    words: str,
    rows: Sequence[Sequence[Picture]],
    blocks: Sequence[TextBlock],
    name: str,
    columns: int = 2,
) -> tuple[Drawing, ...]:
    """Return the pages of a sheet: a head, words, rows of pictures, then blocks of text."""
    shapes, top = title_shapes(title, words, HIGH - MARGIN)
    setting = set_text(blocks, top - MARGIN - least_height(rows), columns)
    pictures, top = picture_rows(rows, top, top - MARGIN - setting.first_height)
    shapes += [*pictures, *column_shapes(setting.pages[0], setting.size, top)]
    pages = [Drawing(tuple(shapes), 0.0, 0.0, WIDE, HIGH, name, words)]
    count = len(setting.pages)
    for number, page in enumerate(setting.pages[1:], 2):
        head = f"{title}, page {number} of {count}"
        size = min(0.7 * TITLE, INNER / text_width(head))
        start = HIGH - MARGIN - 2 * TITLE
        further: list[Shape] = [Label((MARGIN, HIGH - MARGIN - 8), head, "start", size, strong=True)]
        further += column_shapes(page, setting.size, start)
        pages.append(Drawing(tuple(further), 0.0, 0.0, WIDE, HIGH, f"{name}, page {number}", words))
    return tuple(pages)
