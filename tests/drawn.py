"""Every drawing, sheet and page, as text: what a planted fault must change to count."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

import symbalance as sb
from symbalance import draw
from symbalance.document.shapes import Drawing

ENGINES = ("inline-3", "vw-vr6", "v8-90", "boxer-4", "kharkiv-v2", "r-985", "honda-nt650")
"""One of each kind, those that are not alike from both sides among them."""
KINDS: dict[str, Callable[[sb.Engine], Drawing]] = {
    "section": lambda e: draw.section(e, 35),
    "plan": lambda e: draw.plan(e, 35),
    "oblique": lambda e: draw.oblique(e, 35),
    "star": lambda e: draw.star(e, 1),
    "firing": draw.firing,
    "orders": draw.orders,
    "forces": draw.forces,
    "path": lambda e: draw.path(e, "force" if sb.balance(e).force.orders() else "couple"),
    "torque": draw.torque,
}


@cache
def known(name: str) -> sb.Engine:
    """Return a preset with a rod ratio."""
    engine = sb.load(name)
    return engine if engine.ratio or engine.link_pins else engine.with_ratio(4)


def _drawn(kind: str, name: str) -> str:
    drawing = KINDS[kind](known(name))
    return "\n".join((draw.to_svg(drawing, standalone=True), draw.to_tikz(drawing), drawing.shows))


def _atlas() -> str:
    from symbalance.pages.atlas import atlas_entry, atlas_index
    from symbalance.pages.published_tables import published_cells

    rows = [(f"{name}.html", atlas_entry(known(name)).row) for name in ENGINES[:4]]
    return atlas_index(rows, (), 12, published_cells())


DRAWN: dict[str, Callable[[], str]] = {
    **{
        f"{kind}-{name}": lambda kind=kind, name=name: _drawn(kind, name)
        for kind in KINDS
        for name in ENGINES
    },
    **{f"sheet-{name}": lambda name=name: sb.sheet(known(name)).svg() for name in ENGINES[1:5]},
    "sheet-compared": lambda: sb.sheet(*map(known, ENGINES[:3]), compare=True, order=6).svg(),
    **{f"page-{name}": lambda name=name: sb.page(known(name)).html for name in ENGINES[1:6]},
    "page-ja": lambda: sb.page(known("v8-90"), lang="ja").html,
    "atlas": _atlas,
}
"""By name, a function that returns all of a drawing or a page as text."""
