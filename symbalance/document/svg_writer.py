"""Drawings as SVG: one element that stands in a page or alone, readable in light and dark surroundings.

It asks for nothing from outside, has a title and a description for those who hear it, and marks moving
parts by `data-part`, so that a script can place them.
"""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from zlib import crc32

from symbalance.document.shapes import (
    LOOKS,
    Arrow,
    Circle,
    Drawing,
    Group,
    Label,
    Line,
    Look,
    Point,
    Shape,
    arrow_head,
)

PAPER = ("#ffffff", "#111827")
"""What opaque shapes are filled with, in light and in dark surroundings."""
MANY = 8
"""Points of a line from which it counts as a curve."""


def style() -> str:
    """Return the rules that drawings are styled by, once for any number of them in a page."""
    light = "".join(_rules(name, look, look.light) for name, look in LOOKS.items())
    dark = "".join(_rules(name, look, look.dark, colours=True) for name, look in LOOKS.items())
    return (
        ".sbd{font:12px system-ui,sans-serif}.sbd .faded{opacity:.35}"
        f"{light}.sbd .opaque{{fill:{PAPER[0]}}}"
        # Paper is light whatever the screen is.
        f"@media screen and (prefers-color-scheme:dark){{{dark}.sbd .opaque{{fill:{PAPER[1]}}}}}"
    )


def _rules(name: str, look: Look, colour: str, colours: bool = False) -> str:
    fill = colour if look.filled else "none"
    line = "" if colours else f";stroke-width:{_n(look.width)}"
    if look.dashes and not colours:
        line += f";stroke-dasharray:{' '.join(map(_n, look.dashes))}"
    ink = LOOKS["ink"]
    edge = (ink.light if colour == look.light else ink.dark) if name == "piston" else colour
    return (
        f".sbd .{name}{{stroke:{edge};fill:{fill}{line}}}"
        f".sbd .head.{name}{{fill:{colour}{'' if colours else ';stroke-dasharray:none;stroke-width:.5'}}}"
        f".sbd text.{name}{{fill:{colour};stroke:none}}"
    )


def drawing_svg(drawing: Drawing, *, standalone: bool = False, styled: bool = True) -> str:
    """Return a drawing as an `<svg>` element, or with `standalone` as a file of its own.

    Where a page holds several, `styled` false leaves out the rules, which `style` returns once.
    """
    # Of its words, so that the same document is the same file whatever was drawn before.
    number = crc32(f"{drawing.title}\n{drawing.shows}".encode())
    ids = f"sbd{number:x}t", f"sbd{number:x}d"
    if standalone:
        ids = "title", "description"  # the same drawing is the same file
    box = f"{_n(drawing.left)} {_n(-drawing.top)} {_n(drawing.width)} {_n(drawing.height)}"
    space = ' xmlns="http://www.w3.org/2000/svg"' if standalone else ""
    head = (
        f'<svg{space} class="sbd" role="img" aria-labelledby="{ids[0]} {ids[1]}" viewBox="{box}" '
        f'width="{_n(drawing.width)}" height="{_n(drawing.height)}">'
    )
    words = (
        f'<title id="{ids[0]}">{escape(drawing.title)}</title>'
        f'<desc id="{ids[1]}">{escape(drawing.shows)}</desc>'
    )
    rules = f"<style>{style()}</style>" if styled else ""
    parts = [head, words, rules, *map(_shape, drawing.shapes), "</svg>"]
    text = "\n".join(part for part in parts if part)
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + text + "\n" if standalone else text


def _shape(shape: Shape) -> str:
    if isinstance(shape, Line):
        return _line(shape)
    if isinstance(shape, Circle):
        look = f"{shape.look} opaque" if shape.opaque else shape.look
        x, y = shape.centre
        return f'<circle class="{look}" cx="{_n(x)}" cy="{_n(-y)}" r="{_n(shape.radius)}"/>'
    if isinstance(shape, Arrow):
        head = arrow_head(shape.start, shape.end)
        (x1, y1), base = shape.start, ((head[1][0] + head[2][0]) / 2, (head[1][1] + head[2][1]) / 2)
        line = f'x1="{_n(x1)}" y1="{_n(-y1)}" x2="{_n(base[0])}" y2="{_n(-base[1])}"'
        return (
            f'<line class="{shape.look}" {line}/>'
            f'<polygon class="head {shape.look}" '
            f'points="{_points(head)}"/>'
        )
    if isinstance(shape, Label):
        x, y = shape.at
        more = "" if shape.size == 12 else f' font-size="{_n(shape.size)}"'
        more += ' font-weight="bold"' if shape.strong else ""
        anchor = "" if shape.align == "start" else f' text-anchor="{shape.align}"'
        # Half a capital's height below its middle: `dominant-baseline` is not drawn alike everywhere.
        low = -y + 0.35 * shape.size
        place = f'x="{_n(x)}" y="{_n(low)}"{anchor}{more}'
        return f'<text class="{shape.look}" {place}>{escape(shape.text)}</text>'
    return _group(shape)


def _line(shape: Line) -> str:
    if len(shape.points) == 2 and not shape.closed:
        (x1, y1), (x2, y2) = shape.points
        return f'<line class="{shape.look}" x1="{_n(x1)}" y1="{_n(-y1)}" x2="{_n(x2)}" y2="{_n(-y2)}"/>'
    if shape.closed and _is_upright_box(shape.points):
        corners = list(shape.points)
        (x1, y1), (x2, y2) = corners[0], corners[2]
        return f'<path class="{shape.look}" d="M{_n(x1)} {_n(-y1)}H{_n(x2)}V{_n(-y2)}H{_n(x1)}z"/>'
    kind = "polygon" if shape.closed else "polyline"
    return f'<{kind} class="{shape.look}" points="{_points(shape.points)}"/>'


def _is_upright_box(points: Sequence[Point]) -> bool:
    """Tell whether points are a box that stands upright: a path says it in half the room."""
    if len(points) != 4:
        return False
    (ax, ay), (bx, by), (cx, cy), (dx, dy) = points
    return ay == by and bx == cx and cy == dy and dx == ax


def _group(group: Group) -> str:
    transform = ""
    if group.at != (0.0, 0.0) or group.turned or group.name:
        turn = f" rotate({_exactly(group.turned)})" if group.turned or group.name else ""
        transform = f' transform="translate({_exactly(group.at[0])} {_exactly(-group.at[1])}){turn}"'
    name = f' data-part="{escape(group.name)}"' if group.name else ""
    faded = ' class="faded"' if group.faded else ""
    return f"<g{name}{faded}{transform}>" + "".join(map(_shape, group.shapes)) + "</g>"


def _points(points: Sequence[Point]) -> str:
    # Of a curve, or a rounded outline, a tenth of a pixel is enough.
    places = 1 if len(points) > MANY else 2
    return " ".join(f"{_n(x, places)},{_n(-y, places)}" for x, y in points)


def _n(value: float, places: int = 2) -> str:
    """Return a number of pixels to a hundredth, which nobody sees; pages are small by it."""
    text = f"{value:.{places}f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def _exactly(value: float) -> str:
    """Return a number to a millionth of a pixel: where parts stand is read back by tests."""
    return _n(value, 6)
