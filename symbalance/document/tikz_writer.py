r"""Drawings as TikZ: a `tikzpicture` for an article (package tikz, as in Debian's texlive-pictures)."""

from __future__ import annotations

from collections.abc import Sequence

from symbalance.document.latex_characters import escaped
from symbalance.document.shapes import (
    LOOKS,
    Arrow,
    Circle,
    Drawing,
    Group,
    Label,
    Line,
    Point,
    Shape,
    arrow_head,
)

POINT = 0.75
"""TeX's big points to a pixel of 1/96 inch."""


def drawing_tikz(drawing: Drawing, *, scale: float = 1.0) -> str:
    r"""Return a drawing as a tikzpicture, at its own size times `scale`.

    Colours are those of light surroundings, defined within the picture.
    """
    unit = f"{POINT * scale:.4f}bp"
    colours = "".join(
        f"\\definecolor{{sbd{name}}}{{HTML}}{{{look.light[1:].upper()}}}%\n"
        for name, look in LOOKS.items()
    )
    low, high = (drawing.left, drawing.bottom), (drawing.right, drawing.top)
    box = f"\\path[use as bounding box] {_p(low)} rectangle {_p(high)};"
    body = [line for shape in drawing.shapes for line in _shape(shape, scale)]
    head = f"\\begin{{tikzpicture}}[x={unit},y={unit},line join=round]"
    return "\n".join([head, colours + box, *body, "\\end{tikzpicture}"]) + "\n"


def _style(name: str, scale: float, dashed: bool = True) -> str:
    look = LOOKS[name]
    parts = [
        f"draw=sbd{name if name != 'piston' else 'ink'}",
        f"line width={look.width * POINT * scale:.2f}bp",
    ]
    if look.dashes and dashed:
        pairs = list(zip(look.dashes[::2], look.dashes[1::2], strict=True))
        pattern = " ".join(
            f"on {on * POINT * scale:.2f}bp off {off * POINT * scale:.2f}bp" for on, off in pairs
        )
        parts.append(f"dash pattern={pattern}")
    if look.filled:
        parts.append(f"fill=sbd{name}")
    return ",".join(parts)


def _shape(shape: Shape, scale: float) -> list[str]:
    if isinstance(shape, Line):
        end = " -- cycle" if shape.closed else ""
        return [f"\\draw[{_style(shape.look, scale)}] {' -- '.join(map(_p, shape.points))}{end};"]
    if isinstance(shape, Circle):
        style = _style(shape.look, scale) + (",fill=white" if shape.opaque else "")
        return [f"\\draw[{style}] {_p(shape.centre)} circle[radius={_n(shape.radius)}];"]
    if isinstance(shape, Arrow):
        head = arrow_head(shape.start, shape.end)
        base = (head[1][0] + head[2][0]) / 2, (head[1][1] + head[2][1]) / 2
        return [
            f"\\draw[{_style(shape.look, scale)}] {_p(shape.start)} -- {_p(base)};",
            f"\\fill[sbd{shape.look}] {' -- '.join(map(_p, head))} -- cycle;",
        ]
    if isinstance(shape, Label):
        anchor = {"start": "base west", "middle": "base", "end": "base east"}[shape.align]
        # On one line whatever is in it: half a capital's height below its middle, as in SVG.
        low = shape.at[0], shape.at[1] - 0.35 * shape.size
        size = f"\\fontsize{{{shape.size * POINT * scale:.1f}}}{{{shape.size * scale:.1f}}}\\selectfont"
        strong = "\\bfseries" if shape.strong else ""
        words = "-{}-".join(map(escaped, shape.text.split("--")))  # two hyphens are no dash
        node = f"\\node[anchor={anchor},inner sep=0,text=sbd{shape.look},font={size}{strong}]"
        return [f"{node} at {_p(low)} {{{words}}};"]
    return _group(shape, scale)


def _group(group: Group, scale: float) -> list[str]:
    inner: Sequence[str] = [line for shape in group.shapes for line in _shape(shape, scale)]
    options = [f"shift={{{_p(group.at)}}}"] if group.at != (0.0, 0.0) else []
    options += [f"rotate={_n(-group.turned)}"] if group.turned else []
    options += ["opacity=.35"] if group.faded else []
    if not options:
        return [*inner]
    return [f"\\begin{{scope}}[{','.join(options)}]", *inner, "\\end{scope}"]


def _p(point: Point) -> str:
    return f"({_n(point[0])},{_n(point[1])})"


def _n(value: float) -> str:
    text = f"{value:.4f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text
