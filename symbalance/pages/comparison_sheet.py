"""Several engines on one handbook sheet: their sections and firing diagrams above one table."""

from __future__ import annotations

from math import ceil

from symbalance.design.comparison import EngineComparison
from symbalance.document.fitting import plain_words
from symbalance.document.nodes import Paragraph
from symbalance.document.shapes import Drawing
from symbalance.drawing.firing_diagram import draw_firing
from symbalance.drawing.section import draw_section
from symbalance.errors import SymbalanceError
from symbalance.forces.pictures import draw_orders
from symbalance.pages.sentence import sentence
from symbalance.pages.sheet_layout import (
    GAP,
    INNER,
    Picture,
    TextBlock,
    TextLine,
    sheet_pages,
    text_blocks,
)

MOST_ENGINES = 12
ACROSS = 4
"""Engines side by side."""
CHARACTERS = 118
"""Of a line across the page."""
MOST_BARS = 10


def comparison_pages(comparison: EngineComparison) -> tuple[Drawing, ...]:
    """Return the sheet of a comparison: a page, and more where its orders need them."""
    engines = [line.engine for line in comparison]
    if len(engines) > MOST_ENGINES:
        rule = f"{len(engines)} engines are compared; a sheet shows {MOST_ENGINES} at most"
        raise SymbalanceError("engines", rule, "take symbalance balance, whose table has no pictures")
    for engine in engines:
        if engine.has_symbols:
            raise SymbalanceError(engine.name, "has symbols for angles", "a sheet draws them in numbers")
    document = comparison.document()
    said: list[TextLine] = []
    for line in comparison:
        words = f"{line.engine.name}: {sentence(line.balance)}"
        said += [line for block in text_blocks((Paragraph(words),), CHARACTERS) for line in block.lines]
    head = TextLine(((0.0, "What shakes"),), strong=True)
    blocks = [*text_blocks(document.blocks, CHARACTERS), TextBlock((head, *said), 1)]
    names = ", ".join(engine.name for engine in engines)
    return sheet_pages(
        plain_words(document.title),
        "Sections are drawn to scales of their own.",
        _rows_of_pictures(comparison),
        blocks,
        f"Comparison of {names}",
        columns=1,
    )


def _rows_of_pictures(comparison: EngineComparison) -> list[list[Picture]]:
    """Return a row of sections; of few engines their firing diagrams and orders in rows of their own."""
    lines = [*comparison]
    engines = [line.engine for line in lines]
    sections = [Picture(engine.name, draw_section(engine)) for engine in engines]
    # Rows of about one length: five engines are three and two, not four and one.
    across = ceil(len(sections) / ceil(len(sections) / ACROSS))
    rows = [sections[k : k + across] for k in range(0, len(sections), across)]
    if len(engines) > ACROSS:
        return rows
    field = (INNER - GAP * (len(engines) - 1)) / len(engines)
    if all(c.fires is not None for engine in engines for c in engine.cylinders):
        long = min(field - 70, 300)
        rows.append([Picture(f"strokes of {e.name}", draw_firing(e, long)) for e in engines])
    balances = [line.balance for line in lines]
    if all(each.kinematics is None or each.ratio is not None for each in balances):
        long = max(min(field - 190, 260), 130)
        drawings = [draw_orders(each, long, MOST_BARS) for each in balances]
        rows.append([Picture(f"orders of {e.name}", d) for e, d in zip(engines, drawings, strict=True)])
    return rows
