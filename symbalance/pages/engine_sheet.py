"""The handbook sheet of one engine: section, crank star, firing diagram and orders above its tables."""

from __future__ import annotations

from symbalance.document.fitting import plain_words
from symbalance.document.nodes import Paragraph
from symbalance.document.shapes import Drawing
from symbalance.drawing.crank_star import draw_star
from symbalance.drawing.firing_diagram import draw_firing
from symbalance.drawing.section import draw_section
from symbalance.errors import SymbalanceError
from symbalance.forces.free_forces import Balance
from symbalance.forces.pictures import draw_force_path, draw_orders
from symbalance.pages.sentence import sentence
from symbalance.pages.sheet_layout import Picture, sheet_pages, text_blocks

MOST_CYLINDERS, MOST_AXES, MOST_BARS = 64, 4, 14
HALF = 275.0
"""Pixels of a diagram's field that stands in half the page with its letters in their own size."""


def engine_pages(result: Balance) -> tuple[Drawing, ...]:
    """Return the sheet of a balance: a page, and more where its orders need them."""
    engine = result.engine
    if engine.has_symbols:
        raise SymbalanceError(engine.name, "has symbols for angles", "a sheet draws them in numbers")
    if len(engine.cylinders) > MOST_CYLINDERS:
        rule = f"has {len(engine.cylinders)} cylinders; a sheet shows {MOST_CYLINDERS} at most"
        raise SymbalanceError(engine.name, rule, "take symbalance balance")
    document = result.document().unfolded(full=False)
    blocks = list(document.blocks)
    if isinstance(blocks[-1], Paragraph):  # what the short document leaves out, and an option for it
        blocks[-1] = Paragraph(
            "rounded, and in short: symbalance balance --full has exact forms, and more"
        )
    title = plain_words(document.title)
    name = f"Sheet of {engine.name}"
    rows = _rows_of_pictures(result)
    return sheet_pages(title, sentence(result), rows, text_blocks(blocks), name)


def _rows_of_pictures(result: Balance) -> list[list[Picture]]:
    """Return the pictures in rows of two, those that there is something to see in."""
    engine = result.engine
    has_sizes = result.kinematics is None or result.ratio is not None
    pictures = [Picture("seen from the front, the crank turning clockwise", draw_section(engine))]
    order = min([*result.force.orders(), *result.couple.orders()], default=1)
    if len({c.bank for c in engine.cylinders}) <= MOST_AXES:
        pictures.append(Picture(f"crank star of order {order}", draw_star(engine, order)))
    elif has_sizes and (of := next((k for k in ("force", "couple") if getattr(result, k).orders()), "")):
        words = f"way of the {of} over a turn, seen from the front"
        pictures.append(Picture(words, draw_force_path(result, of)))
    if all(c.fires is not None for c in engine.cylinders):
        pictures.append(Picture("strokes, and degrees between firings", draw_firing(engine, HALF)))
    if has_sizes:
        orders = draw_orders(result, HALF - 100, MOST_BARS)
        pictures.append(Picture("orders, on a logarithmic scale", orders))
    return [pictures[:2], pictures[2:]] if len(pictures) > 2 else [pictures]
