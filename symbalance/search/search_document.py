"""The document of a search: what was searched and found, the front, its picture, what was cut."""

from __future__ import annotations

from html import escape
from urllib.parse import quote

from symbalance.document.decimals import decimal
from symbalance.document.formula import Decimal, number
from symbalance.document.nodes import (
    Block,
    Cell,
    Column,
    Details,
    Document,
    Exact,
    Facts,
    Figure,
    Paragraph,
    Table,
    Words,
)
from symbalance.document.shapes import Circle, Drawing, Label, Line, Shape
from symbalance.document.svg_writer import drawing_svg
from symbalance.document.text_writer import formula_text
from symbalance.drawing.charts import figure, round_steps
from symbalance.search.magnitudes import Magnitude
from symbalance.search.objectives import MEANINGS
from symbalance.search.search_result import CrankSearch, SearchPoint, SearchStar

MOST_ROWS = 20
"""Stars of one point that have a row of their own in a short document."""
MOST_COLUMNS = 4
"""Quantities of one table."""
WIDTH, HEIGHT = 420.0, 300.0


def search_document(result: CrankSearch) -> Document:
    """Return counts, the front as a table and a picture, and what was cut by which bound."""
    blocks: list[Block] = [Facts(tuple(_asked(result)), "Asked"), _counts(result)]
    if result.points:
        blocks += _front(result)
        rows = sum(min(len(point.stars), MOST_ROWS) for point in result.points)
        more = sum(point.counts.classes for point in result.points) - rows
        if more:
            blocks.append(Paragraph(f"and {more:,} more classes that attain the same values"))
        drawing = front_drawing(result)
        if drawing is not None:
            caption = f"The front: {result.minimized[1]} against {result.minimized[0]}"
            blocks.append(Figure("front.svg", _picture(result, drawing), caption, drawing.shows))
    else:
        opening = "None" if result.searched.stars else "No crank fires so at all: none"
        blocks.append(Paragraph(f"{opening} of {result.searched.stars:,} stars meets this: proved."))
    blocks.append(_walk(result))
    blocks.append(Facts(tuple(_legend(result)), "How to read it"))
    return Document(f"Search: {result.problem.words()}", tuple(blocks))


def _asked(result: CrankSearch) -> list[tuple[Words, Words]]:
    rows: list[tuple[Words, Words]] = []
    if result.minimized:
        rows.append(("to be small", ", ".join(result.minimized)))
    if result.conditions:
        words = (c.words().replace("<=", " ≤ ").replace("=", " = ") for c in result.conditions)
        rows.append(("conditions", ", ".join(words)))
    if result.after.words():
        rows.append(("after", result.after.words()))
    for place, mode in enumerate(result.modes, 1):
        rows.append((f"mode {place}", ", ".join(map(str, mode))))
    return rows or [("all", "no condition, nothing to be small")]


def _counts(result: CrankSearch) -> Table:
    columns = (Column(""), Column("cranks"), Column("stars"), Column("classes"))
    rows = tuple(
        (name, *(f"{n:,}" for n in (counts.cranks, counts.stars, counts.classes)))
        for name, counts in (("searched", result.searched), ("meet every condition", result.found))
    )
    return Table("Counts", columns, rows, topic="counts")


def _front(result: CrankSearch) -> list[Block]:
    """Return the stars as a table; more quantities than it has room for stand in further ones."""
    has_order = any(star.firing_order for star in result.items)
    chunks = [
        result.quantities[i : i + MOST_COLUMNS] for i in range(0, len(result.quantities), MOST_COLUMNS)
    ]
    title = "The front" if result.minimized else "Stars"
    tables: list[Block] = []
    for place, names in enumerate(chunks):
        about = (Column("firing order" if has_order else "throws, degrees"), Column("classes"))
        columns = (Column("point"), *map(Column, names), *(() if place else about))
        rows = tuple(
            _row(order, point, star, names, has_order and not place, not place)
            for order, point in enumerate(result.points, 1)
            for star in point.stars[:MOST_ROWS]
        )
        heading = title if not place else f"{title}, {names[0]} and on"
        tables.append(Table(heading, columns, rows, topic="front" if not place else f"front-{place + 1}"))
    return tables


def _row(
    place: int,
    point: SearchPoint,
    star: SearchStar,
    names: tuple[str, ...],
    has_order: bool,
    has_about: bool,
) -> tuple[Cell, ...]:
    values = (_value(star.values[name]) if name in star.values else "–" for name in names)
    if not has_about:
        return (number(place), *values)
    name = star.as_text() if has_order else ", ".join(map(str, star.throws))
    first = star is point.stars[0]
    return (number(place), *values, name, f"{point.counts.classes:,}" if first else "")


def _value(value: Magnitude) -> Cell:
    exact = value.as_formula()
    near = Decimal("0") if value.is_zero() else decimal(value.near)
    assert not isinstance(near, str)
    return Exact(exact, near, beside=formula_text(near) != formula_text(exact))


def _walk(result: CrankSearch) -> Details:
    tally = result.tally
    rows: list[tuple[Words, Words]] = [
        ("walked", f"{tally.nodes:,} nodes; {tally.leaves:,} complete classes, each judged"),
    ]
    for name, cut in zip(result.bounds, tally.cuts, strict=True):
        if cut:
            rows.append(
                (
                    f"cut by {name}",
                    f"{cut:,} branch{'es' if cut > 1 else ''}: whatever the rest, its limit is passed",
                )
            )
    rows.append(
        (
            "proof",
            "images of a star under a symmetry are walked once; zero is decided in integers, an order "
            "between two values by intervals, at last in the exact core",
        )
    )
    return Details("What was walked", (Facts(tuple(rows)),))


def _legend(result: CrankSearch) -> list[tuple[Words, Words]]:
    kinds = dict.fromkeys(name.split(".")[0] for name in result.quantities)
    rows: list[tuple[Words, Words]] = [(kind, MEANINGS[kind]) for kind in kinds]
    rear = "counts as another" if result.front_matters else "is the same class"
    rows += [
        ("cranks", "arrangements with cylinder 1 at its top dead centre"),
        ("stars", "cranks, mirror images once"),
        ("classes", f"stars, of which one looked at from the rear {rear}"),
    ]
    return rows


def _picture(result: CrankSearch, drawing: Drawing) -> str:
    """Return the front's picture; a point whose engine has a file of its own leads there."""
    # A file of its own, whose names are the same each time, within a page.
    picture = drawing_svg(drawing, standalone=True).partition("?>\n")[2]
    head, *points = picture.split(_POINT)
    links = [
        next((result.links[s.engine.name] for s in point.stars if s.engine.name in result.links), "")
        for point in result.points
    ]
    if not any(links):
        return picture
    assert len(points) == len(links)
    parts = [head.replace('role="img"', 'role="group"', 1)]  # of an image nobody would hear the links
    for place, (point, link) in enumerate(zip(points, links, strict=True), 1):
        mark, number, rest = point.partition("</text>")
        opened = f'<a href="{escape(quote(link))}" aria-label="point {place}">'
        parts.append(f"{opened}{_POINT}{mark}{number}</a>{rest}" if link else f"{_POINT}{point}")
    return "".join(parts)


_POINT = '<circle class="force"'
"""How a point of the front begins in its picture; its number follows."""


def front_drawing(result: CrankSearch) -> Drawing | None:
    """Return the front as points, the second quantity over the first; None for fewer than two points."""
    if len(result.minimized) < 2 or len(result.points) < 2:
        return None
    across, up = result.minimized[:2]
    pairs = [
        (float(point.stars[0].values[across].near), float(point.stars[0].values[up].near))
        for point in result.points
    ]
    widest, highest = max(x for x, _ in pairs) * 1.08 or 1.0, max(y for _, y in pairs) * 1.08 or 1.0
    shapes: list[Shape] = []
    for value in round_steps(0, widest):
        x = value / widest * WIDTH
        shapes += [Line(((x, 0), (x, HEIGHT)), "faint"), Label((x, -12), figure(value), size=11)]
    for value in round_steps(0, highest):
        y = value / highest * HEIGHT
        shapes += [Line(((0, y), (WIDTH, y)), "faint"), Label((-8, y), figure(value), "end", 11)]
    shapes.append(Line(((0, HEIGHT), (0, 0), (WIDTH, 0)), "ink"))
    for place, (x, y) in enumerate(pairs, 1):
        at = (x / widest * WIDTH, y / highest * HEIGHT)
        shapes += [Circle(at, 4, "force"), Label((at[0] + 8, at[1] + 8), str(place), "start", 11)]
    shapes += [
        Label((WIDTH / 2, -30), across, size=12),
        Label((0, HEIGHT + 14), up, "start", 12),
    ]
    words = "; ".join(f"{n}: {figure(x)}, {figure(y)}" for n, (x, y) in enumerate(pairs, 1))
    title = f"{up} against {across}: {result.problem.words()}"
    return Drawing(
        tuple(shapes), -70, -44, WIDTH + 30, HEIGHT + 30, title, f"Points of the front: {words}."
    )
