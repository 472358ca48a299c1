"""The handbook sheet of an engine: everything on one A4 page, drawn as one drawing.

Section, crank star, firing diagram and orders stand above the tables of the free forces and couples, the
cylinders and the sizes. Being a drawing, it is the same in SVG and in TeX, and is one page whatever the
engine: where the tables are long their letters are smaller.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import chain
from textwrap import wrap

from symbalance.document import nodes
from symbalance.document.fitting import fit_table, plain_words
from symbalance.document.shapes import Arrow, Circle, Drawing, Group, Label, Line, Point, Shape
from symbalance.drawing.crank_star import draw_star
from symbalance.drawing.firing_diagram import draw_firing
from symbalance.drawing.section import draw_section
from symbalance.engine.engine import Engine, checked_engine
from symbalance.errors import SymbalanceError
from symbalance.forces.free_forces import Balance, balance
from symbalance.forces.pictures import draw_orders
from symbalance.pages.sentence import sentence

WIDE, HIGH, MARGIN = 794.0, 1123.0, 45.0
"""An A4 page in pixels of 1/96 inch, and its margin."""
INNER = WIDE - 2 * MARGIN
GAP = 14.0
PICTURES_HIGH = 225.0
"""Pixels of a row of pictures."""
LETTERS = 0.6
"""Of its size a letter's width, on the wide side: tables keep their columns apart by it."""
MOST_CYLINDERS, MOST_AXES = 64, 4
TITLE = 110
"""Characters of the sheet's head, beyond which it is cut."""


@dataclass(frozen=True, eq=False)
class _Text:
    """A line of the sheet's lower part: words at tenths of the letters' size from its left edge."""

    words: tuple[tuple[float, str], ...]
    strong: bool = False
    rule: bool = False


def sheet(subject: Engine | Balance) -> Drawing:
    """Return the sheet of an engine, or of a balance, as a drawing of one A4 page.

    >>> from symbalance.engine.catalogue import load
    >>> sheet(load("inline-3"))
    Drawing: Sheet of inline-3
    """
    result = subject if isinstance(subject, Balance) else balance(checked_engine(subject))
    engine = result.engine
    if engine.has_symbols:
        raise SymbalanceError(engine.name, "has symbols for angles", "a sheet draws them in numbers")
    if len(engine.cylinders) > MOST_CYLINDERS:
        rule = f"has {len(engine.cylinders)} cylinders; a sheet shows {MOST_CYLINDERS} at most"
        raise SymbalanceError(engine.name, rule, "take symbalance balance")
    document = result.document()
    blocks = tuple(b for b in document.blocks if not isinstance(b, nodes.Details))
    document = replace(document, blocks=blocks)
    top = HIGH - MARGIN
    name = plain_words(document.title)
    head = name if len(name) <= TITLE else name[: TITLE - 1] + "…"
    size = min(16.0, INNER / (LETTERS * len(head)))
    shapes: list[Shape] = [Label((MARGIN, top - 8), head, "start", size, strong=True)]
    top -= 30
    for line in wrap(sentence(result), 120):
        shapes.append(Label((MARGIN, top), line, "start", 10.5))
        top -= 14
    for row in _rows_of_pictures(result):
        shapes += _side_by_side(row, top)
        top -= PICTURES_HIGH + GAP
    shapes += _columns(_lines(document.blocks), top)
    title = f"Sheet of {engine.name}"
    return Drawing(tuple(shapes), 0.0, 0.0, WIDE, HIGH, title, sentence(result))


def _rows_of_pictures(result: Balance) -> list[list[Drawing]]:
    """Return the pictures in rows of two, those that there is something to see in."""
    engine = result.engine
    pictures = [draw_section(engine)]
    order = min([*result.force.orders(), *result.couple.orders()], default=1)
    if len({c.bank for c in engine.cylinders}) <= MOST_AXES:
        pictures.append(draw_star(engine, order))
    if all(c.fires is not None for c in engine.cylinders):
        pictures.append(draw_firing(engine))
    if result.kinematics is None or result.ratio is not None:
        pictures.append(draw_orders(result))
    return [pictures[:2], pictures[2:]] if len(pictures) > 2 else [pictures]


def _side_by_side(drawings: Sequence[Drawing], top: float) -> list[Shape]:
    """Return drawings in cells of one row, each as large as its cell lets it be."""
    room = (INNER - GAP * (len(drawings) - 1)) / len(drawings)
    shapes: list[Shape] = []
    for place, drawing in enumerate(drawings):
        scale = min(room / drawing.width, PICTURES_HIGH / drawing.height, 1.0)
        x = MARGIN + place * (room + GAP) + (room - scale * drawing.width) / 2 - scale * drawing.left
        y = top - (PICTURES_HIGH - scale * drawing.height) / 2 - scale * drawing.top
        shapes.append(Group(tuple(_scaled(s, scale) for s in drawing.shapes), (x, y)))
    return shapes


def _scaled(shape: Shape, by: float) -> Shape:
    """Return a shape larger or smaller about the origin; lines keep their width."""

    def at(point: Point) -> Point:
        return by * point[0], by * point[1]

    if isinstance(shape, Line):
        return replace(shape, points=tuple(map(at, shape.points)))
    if isinstance(shape, Circle):
        return replace(shape, centre=at(shape.centre), radius=by * shape.radius)
    if isinstance(shape, Arrow):
        return replace(shape, start=at(shape.start), end=at(shape.end))
    if isinstance(shape, Label):
        return replace(shape, at=at(shape.at), size=by * shape.size)
    return replace(shape, at=at(shape.at), shapes=tuple(_scaled(s, by) for s in shape.shapes))


# Tables and facts as lines ----------------------------------------------------------------------
COLUMN = 74
"""Characters of a line of the lower part."""


def _lines(blocks: Sequence[nodes.Block]) -> list[list[_Text]]:
    """Return blocks as lines, those of a block together."""
    return [lines for block in blocks if (lines := _block(block))]


def _block(block: nodes.Block) -> list[_Text]:
    if isinstance(block, nodes.Table):
        return _table(block)
    if isinstance(block, nodes.Facts):
        lines = [_Text(((0.0, plain_words(block.title)),), strong=True)] if block.title else []
        for name, value in block.entries:
            words = plain_words(name) + (f": {plain_words(value)}" if value else "")
            lines += [_Text(((0.0, line),)) for line in wrap(words, COLUMN, subsequent_indent="  ")]
        return lines
    if isinstance(block, nodes.Paragraph):
        return [_Text(((0.0, line),)) for line in wrap(plain_words(block.words), COLUMN)]
    if isinstance(block, nodes.Details):
        return [line for each in block.blocks for line in _block(each)]
    raise SymbalanceError(type(block).__name__, "has no form on a sheet", "give it one in sheet.py")


def _table(table: nodes.Table) -> list[_Text]:
    title = plain_words(table.title)
    if not table.rows:
        return [_Text(((0.0, f"{title}: {table.empty}"),))]
    fit = fit_table(table, lambda words: len(plain_words(words)), COLUMN, 2)
    grid = [[plain_words(c.head) for c in fit.columns], *[[plain_words(c) for c in r] for r in fit.rows]]
    widths = [max(len(row[i]) for row in grid) for i in range(len(fit.columns))]
    starts = [LETTERS * (sum(widths[:i]) + 2 * i) for i in range(len(widths))]
    lines = [_Text(((0.0, title),), strong=True)]
    for row in grid:
        cells = tuple((x, words) for x, words in zip(starts, row, strict=True) if words)
        lines.append(_Text(cells, rule=row is grid[0]))
    for form in fit.left_out:
        words = f"{form.place} {form.name} = {plain_words(form.value)}"
        lines += [_Text(((0.0, line),)) for line in wrap(words, COLUMN, subsequent_indent="  ")]
    remark = plain_words(fit.remark)
    return [*lines, *(_Text(((0.0, line),)) for line in wrap(remark, COLUMN))]


def _columns(groups: list[list[_Text]], top: float) -> list[Shape]:
    """Return lines in two columns, in letters as large as their number and length let them be.

    A column ends where a table does.
    """
    room, half = top - MARGIN, (INNER - GAP) / 2
    spaced = [[*group, _Text(())] for group in groups]
    splits = [[[*chain(*spaced[:k])], [*chain(*spaced[k:])]] for k in range(1, len(spaced) + 1)]
    columns = min(splits, key=lambda split: max(map(len, split)))
    widest = max(x + LETTERS * len(words) for side in columns for line in side for x, words in line.words)
    size = min(9.5, half / widest, room / (1.3 * max(map(len, columns))))
    shapes: list[Shape] = []
    places = [(k, row, line) for k, side in enumerate(columns) for row, line in enumerate(side)]
    for column, row, line in places:
        x, y = MARGIN + column * (half + GAP), top - 1.3 * size * (row + 0.5)
        for start, words in line.words:
            shapes.append(Label((x + start * size, y), words, "start", size, strong=line.strong))
        if line.rule:
            shapes.append(Line(((x, y - 0.62 * size), (x + half, y - 0.62 * size)), "faint"))
    return shapes
