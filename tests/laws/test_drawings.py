"""Every drawing of every kind of engine is well-formed, says what it shows, and overlaps no labels."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Sequence

import pytest

import symbalance as sb
from symbalance import draw
from symbalance.document.shapes import Arrow, Circle, Drawing, Group, Line, Shape, labels_of, placed

ENGINES = ["inline-3", "vw-vr6", "v8-90", "v12-60", "boxer-4", "bugatti-w16", "r-985", "kharkiv-v2"]
ENGINES += ["wartsila-10rta96c", "honda-nt650"]
SLOW = pytest.mark.slow
OTHERS = [name for name in ENGINES if name not in ("vw-vr6", "v8-90")]
QUICK = ("inline-3", "vw-vr6", "v8-90", "boxer-4", "kharkiv-v2")
TRIED = [name if name in QUICK else pytest.param(name, marks=SLOW) for name in ENGINES]
KINDS = {
    "section": lambda e: draw.section(e, 35),
    "plan": lambda e: draw.plan(e, 35),
    "oblique": lambda e: draw.oblique(e, 35),
    "star": lambda e: draw.star(e, 2),
    "firing": draw.firing,
    "orders": draw.orders,
    "forces": draw.forces,
    "path": lambda e: draw.path(e, "force" if sb.balance(e).force.orders() else "couple"),
    "overview": draw.overview,
    "torque": draw.torque,
}


def known(name: str) -> sb.Engine:
    engine = sb.load(name)
    return engine if engine.ratio or engine.link_pins else engine.with_ratio(4)


def hostile(name: str) -> sb.Engine:
    return sb.Engine(known("inline-3").cylinders, name=name)


@pytest.mark.parametrize("name", TRIED)
@pytest.mark.parametrize("kind", KINDS)
def test_a_drawing_is_well_formed_and_says_what_it_shows(name: str, kind: str) -> None:
    drawing = KINDS[kind](known(name))
    root = ET.fromstring(draw.to_svg(drawing, standalone=True))
    assert root.get("role") == "img"
    assert len(drawing.shows) > 10
    assert "nan" not in draw.to_tikz(drawing)
    assert "inf" not in draw.to_tikz(drawing)
    for label in labels_of(drawing):
        left, bottom, right, top = label.box
        assert drawing.left - 1 <= left, label
        assert right <= drawing.right + 1, label
        assert drawing.bottom - 1 <= bottom, label
        assert top <= drawing.top + 1, label


def overlaps(drawing: Drawing) -> list[tuple[str, str]]:
    labels = [label for label in labels_of(drawing) if label.text]
    pairs = []
    for place, one in enumerate(labels):
        for other in labels[place + 1 :]:
            a, b = one.box, other.box
            if a[0] < b[2] - 1 and b[0] < a[2] - 1 and a[1] < b[3] - 1 and b[1] < a[3] - 1:
                pairs.append((one.text, other.text))
    return pairs


@pytest.mark.parametrize("name", TRIED)
@pytest.mark.parametrize("kind", [kind for kind in KINDS if kind not in ("plan", "oblique")])
def test_no_two_labels_overlap(name: str, kind: str) -> None:
    assert overlaps(KINDS[kind](known(name))) == []


@pytest.mark.parametrize(
    "text", ["<script>alert(1)</script>", "]]>", r"\input{x}", "a & b", "横置き", "x" * 60]
)
def test_hostile_names_are_text(text: str) -> None:
    drawing = draw.section(hostile(text))
    root = ET.fromstring(draw.to_svg(drawing, standalone=True))
    title = root.find("{http://www.w3.org/2000/svg}title")
    assert title is not None
    assert text in (title.text or "")
    assert not list(root.iter("{http://www.w3.org/2000/svg}script"))


def corners(drawing: Drawing) -> list[tuple[float, float]]:
    """Return the points of all lines and the edges of all circles where they stand on the sheet."""
    reach: list[tuple[float, float]] = []

    def walk(shapes: Sequence[Shape], at: tuple[float, float], turned: float) -> None:
        for shape in shapes:
            if isinstance(shape, Group):
                walk(shape.shapes, placed(shape.at, at, turned), turned + shape.turned)
            elif isinstance(shape, Line):
                reach.extend(placed(point, at, turned) for point in shape.points)
            elif isinstance(shape, Arrow):
                reach.extend(placed(point, at, turned) for point in (shape.start, shape.end))
            elif isinstance(shape, Circle):
                x, y = placed(shape.centre, at, turned)
                r = shape.radius
                reach.extend([(x - r, y), (x + r, y), (x, y - r), (x, y + r)])

    walk(drawing.shapes, (0.0, 0.0), 0.0)
    return reach


@pytest.mark.parametrize("name", TRIED)
@pytest.mark.parametrize("kind", KINDS)
def test_nothing_is_cut(name: str, kind: str) -> None:
    drawing = KINDS[kind](known(name))
    for x, y in corners(drawing):
        assert drawing.left - 0.5 <= x <= drawing.right + 0.5
        assert drawing.bottom - 0.5 <= y <= drawing.top + 0.5


@pytest.mark.parametrize("degrees", [0, pytest.param(77, marks=SLOW), pytest.param(180, marks=SLOW), 253])
@pytest.mark.parametrize("name", ["vw-vr6", "v8-90", *(pytest.param(n, marks=SLOW) for n in OTHERS)])
def test_the_frame_of_a_moving_view_stands_still_and_cuts_nothing(name: str, degrees: int) -> None:
    engine = known(name)
    for view in (draw.section, draw.plan, draw.oblique):
        first, turned = view(engine, 35), view(engine, degrees)
        assert (first.width, first.height) == pytest.approx((turned.width, turned.height))
        for x, y in corners(turned):
            assert turned.left - 0.5 <= x <= turned.right + 0.5
            assert turned.bottom - 0.5 <= y <= turned.top + 0.5
        assert f"θ = {degrees}°" in turned.title


def test_a_proved_zero_is_said_in_words_and_has_no_bar() -> None:
    drawing = draw.orders(sb.balance(known("v8-90"), 4))
    assert "force 1 0, proved" in drawing.shows
    assert "couple 1 3.162" in drawing.shows


def test_a_drawing_is_the_same_file_twice() -> None:
    first, second = (draw.to_svg(draw.star(known("v8-90")), standalone=True) for _ in range(2))
    assert first == second


def test_a_drawing_shows_itself_in_a_notebook() -> None:
    assert draw.star(known("v8-90"))._repr_svg_().startswith("<svg")


@pytest.mark.slow
@pytest.mark.parametrize("form", ["png", "pdf"])
def test_pictures_have_their_signature(form: str) -> None:
    pytest.importorskip("matplotlib")
    data = draw.to_picture(draw.section(known("vw-vr6"), 20), form)
    assert data.startswith({"png": b"\x89PNG", "pdf": b"%PDF"}[form])
    assert len(data) > 2000
