"""Drawings as data: lines, circles, arrows and labels on a sheet, written as SVG, TikZ, PNG and PDF.

Coordinates count CSS pixels (96 to the inch), x to the right and y *up*. A `Group` has a place and an
angle of its own, so that a moving part is drawn once and then put where it stands: a page moves a part by
changing its group's transform, and nothing is drawn anew.

======  ==============================================================================================
look    what is drawn with it
======  ==============================================================================================
axis    axes and centre lines: dash and dot
part    outlines of what does not move: cylinders
crank   crank throws and pins, heavy
rod     connecting rods
piston  pistons, filled
path    the way a point goes
force   arrows and curves of forces;  couple: of couples;  third: of what stands beside both
open    a thing that is there but does not count: dashed
faint   guide lines and rings
ink     a plain line;  solid: a plain filled shape;  shade: a filled one of a second kind
======  ==============================================================================================

Looks differ in line as well as in colour, for those who do not see the colours and for print.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import cos, hypot, radians, sin
from unicodedata import east_asian_width

from symbalance.errors import visible

LETTER = 0.56
"""The width of a letter over the size of its type, on average: what a label is taken to need."""

RAISED = frozenset("⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺ⁿ₀₁₂₃₄₅₆₇₈₉ₙ")
"""Raised and lowered signs, which are narrower."""


def text_width(text: str) -> float:
    """Return about how wide words are over the size of their type; East Asian signs are square.

    >>> round(text_width("ab"), 3), text_width("横置")
    (1.12, 2.0)
    """
    return sum(
        LETTER if c.isascii() else 0.4 if c in RAISED else 1.0 if east_asian_width(c) in "WF" else LETTER
        for c in text
    )


Point = tuple[float, float]


@dataclass(frozen=True)
class Look:
    """How a shape is drawn: colours in light and dark surroundings, the line's width and dashes."""

    light: str
    dark: str
    width: float = 1.0
    dashes: tuple[float, ...] = ()
    filled: bool = False


LOOKS = {
    "axis": Look("#6b7280", "#9ca3af", 0.8, (8, 3, 2, 3)),
    "part": Look("#6b7280", "#9ca3af", 1.2),
    "crank": Look("#1f2937", "#e5e7eb", 2.6),
    "rod": Look("#374151", "#d1d5db", 2.0),
    "piston": Look("#9aa5b5", "#5b6675", 1.0, filled=True),
    "path": Look("#6b7280", "#9ca3af", 0.8, (2, 2)),
    "force": Look("#b91c1c", "#f87171", 2.0),
    "couple": Look("#1d4ed8", "#7db2ff", 2.0, (7, 3)),
    "third": Look("#047857", "#4fd1a5", 2.0, (2, 2.5)),
    "open": Look("#6b7280", "#9ca3af", 1.2, (4, 3)),
    "faint": Look("#d1d5db", "#4b5563", 0.8),
    "ink": Look("#1f2937", "#e5e7eb", 1.0),
    "solid": Look("#b91c1c", "#f87171", 0.8, filled=True),
    "shade": Look("#cbd5e1", "#475569", 0.8, filled=True),
}
"""Colours that carry a meaning have a contrast of 4.5 or more against white and near black."""


@dataclass(frozen=True, eq=False)
class Line:
    """Points joined by straight lines, and the last with the first if `closed`."""

    points: tuple[Point, ...]
    look: str = "ink"
    closed: bool = False


@dataclass(frozen=True, eq=False)
class Circle:
    """A circle; with `opaque` what lies below it does not show through."""

    centre: Point
    radius: float
    look: str = "ink"
    opaque: bool = False


@dataclass(frozen=True, eq=False)
class Arrow:
    """A straight line with a head at its end."""

    start: Point
    end: Point
    look: str = "force"


@dataclass(frozen=True, eq=False)
class Label:
    """Words at a point, which is their start, middle or end at half the height of a capital."""

    at: Point
    text: str
    align: str = "middle"
    size: float = 12.0
    look: str = "ink"
    strong: bool = False

    def __post_init__(self) -> None:
        object.__setattr__(self, "text", visible(self.text))

    @property
    def box(self) -> tuple[float, float, float, float]:
        """Left, bottom, right and top of about the room that the words take."""
        width = self.size * text_width(self.text)
        left = self.at[0] - {"start": 0.0, "middle": width / 2, "end": width}[self.align]
        return left, self.at[1] - 0.5 * self.size, left + width, self.at[1] + 0.5 * self.size


@dataclass(frozen=True, eq=False)
class Group:
    """Shapes put at a place, turned clockwise by an angle in degrees; `faded` ones stand behind.

    `name` says to programs which part it is: "piston-3".
    """

    shapes: tuple[Shape, ...]
    at: Point = (0.0, 0.0)
    turned: float = 0.0
    name: str = ""
    faded: bool = False


Shape = Line | Circle | Arrow | Label | Group


@dataclass(frozen=True, eq=False, repr=False)
class Drawing:
    """Shapes within a box, with a title and what they show in words, for those who do not see it."""

    shapes: tuple[Shape, ...]
    left: float
    bottom: float
    right: float
    top: float
    title: str
    shows: str

    def __post_init__(self) -> None:
        # A name may hold marks that turn the direction of what follows it, wherever it is shown.
        object.__setattr__(self, "title", visible(self.title))
        object.__setattr__(self, "shows", visible(self.shows))

    @property
    def width(self) -> float:
        """Pixels from left to right."""
        return self.right - self.left

    @property
    def height(self) -> float:
        """Pixels from bottom to top."""
        return self.top - self.bottom

    def __repr__(self) -> str:
        return f"Drawing: {self.title}"

    def _repr_svg_(self) -> str:
        from symbalance.document.svg_writer import drawing_svg

        return drawing_svg(self)

    def _repr_html_(self) -> str:
        # As HTML too: of an SVG alone a converted notebook makes an image without its words.
        return self._repr_svg_()


def labels_of(drawing: Drawing) -> list[Label]:
    """Return all labels of a drawing where they stand on the sheet, those of turned groups too."""
    return [*_labels(drawing.shapes, (0.0, 0.0), 0.0)]


def _labels(shapes: Sequence[Shape], at: Point, turned: float) -> list[Label]:
    labels: list[Label] = []
    for shape in shapes:
        if isinstance(shape, Label):
            place = placed(shape.at, at, turned)
            labels.append(Label(place, shape.text, shape.align, shape.size, shape.look, shape.strong))
        elif isinstance(shape, Group):
            labels += _labels(shape.shapes, placed(shape.at, at, turned), turned + shape.turned)
    return labels


def placed(point: Point, at: Point, turned: float) -> Point:
    """Return where a point of a group stands: turned clockwise by degrees, then moved.

    >>> tuple(round(x, 12) for x in placed((0.0, 2.0), (1.0, 1.0), 90.0))
    (3.0, 1.0)
    """
    c, s = cos(radians(turned)), sin(radians(turned))
    return at[0] + c * point[0] + s * point[1], at[1] + c * point[1] - s * point[0]


def scaled(shape: Shape, by: float) -> Shape:
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
    return replace(shape, at=at(shape.at), shapes=tuple(scaled(s, by) for s in shape.shapes))


def arrow_head(start: Point, end: Point, size: float = 9.0) -> tuple[Point, Point, Point]:
    """Return the corners of an arrow's head; an arrow shorter than two heads has a smaller one."""
    length = hypot(end[0] - start[0], end[1] - start[1])
    if length == 0:
        return end, end, end
    x, y = (end[0] - start[0]) / length, (end[1] - start[1]) / length
    long = min(size, length / 2)
    base = end[0] - long * x, end[1] - long * y
    side = 0.38 * long
    return end, (base[0] - side * y, base[1] + side * x), (base[0] + side * y, base[1] - side * x)
