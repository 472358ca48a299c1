"""The HTML report of a checked page: the author's page whole, coloured, each relation to be opened."""

from __future__ import annotations

import re

import pytest

from symbalance.checking import check
from symbalance.document.result import to_html
from symbalance.notes.algebra import values
from symbalance.notes.checking.reports.sides_plot import plot_sides
from tests import TESTS

PAGES = sorted(page for page in (TESTS / "hand").iterdir() if page.suffix in (".md", ".tex", ".txt"))
COLOURS = {
    "refuted": "wrong", "contradiction": "wrong", "undecided": "unsure", "unreadable": "unsure",
    "holds": "right", "holds_to_order": "right", "conditional": "right",
}  # fmt: skip
LETTERS = {"theta": "crank angle", "r": "crank radius", "lambda": "rod ratio l/r"}
WRONG = "# A title\n\nWords with $r$ in them.\n\n"
WRONG += "$$\\sin 2\\theta = \\sin\\theta\\cos\\theta$$\n\nLast words.\n"


@pytest.mark.spread(1)
@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_every_relation_stands_once_on_the_page_in_its_colour(page):
    checked = check(page)
    html = to_html(checked, standalone=True)
    marked = re.findall(r'<details class="marked ([a-z]+)" id="line-([0-9-]+)">', html)
    expected = [
        (COLOURS.get(v.verdict, "plain"), f"{v.line}" if v.link == 1 else f"{v.line}-{v.link}")
        for v in checked.verdicts
    ]
    assert sorted(marked) == sorted(expected)
    linked = re.findall(r'<a href="#line-([0-9-]+)">', html)
    assert sorted(linked) == sorted(where for colour, where in expected if colour in ("wrong", "unsure"))


def test_the_authors_words_stay_around_the_relations():
    html = to_html(check(WRONG, LETTERS), standalone=True)
    words = re.sub(r"<[^>]+>", "", html[html.index("The page") :])
    assert [w for w in ("A title", "Words with r in them.", "Last words.") if w not in words] == []
    assert html.index("To be mended") < html.index("The page") < html.index("A title")
    assert "$" not in words


def test_both_sides_are_drawn_where_the_witness_stands():
    (verdict,) = check(WRONG, LETTERS).verdicts
    picture = plot_sides(verdict.decision, verdict.witness)
    assert picture is not None
    curves = [
        [tuple(map(float, pair.split(","))) for pair in points.split()]
        for points in re.findall(r'points="([^"]+)"', str(picture.picture))
    ]
    left, right = ([y for _, y in curve] for curve in curves)
    middle = left[0]  # sin 0 = 0 on both sides
    assert right[0] == pytest.approx(middle)
    above = [(middle - a, middle - b) for a, b in zip(left, right, strict=True)]
    assert all(a == pytest.approx(2 * b, abs=0.25) for a, b in above)  # as sin 2θ = 2 sin θ cos θ


def test_sides_that_could_not_be_told_apart_are_drawn_as_their_difference():
    (verdict,) = check(
        "$$\\cos\\theta = \\cos\\theta + \\frac{1}{1000}\\cos 4\\theta$$", LETTERS
    ).verdicts
    picture = plot_sides(verdict.decision, verdict.witness)
    assert picture is not None
    assert "right side less the left one" in picture.shows
    assert "±0.001<" in str(picture.picture)


def test_a_picture_needs_values(monkeypatch):
    (verdict,) = check(WRONG, LETTERS).verdicts
    assert plot_sides(None, verdict.witness) is None
    assert plot_sides(verdict.decision, {}) is None
    monkeypatch.setattr(values, "value", lambda form, point: 1j)
    assert plot_sides(verdict.decision, verdict.witness) is None


def test_degrees_stand_as_they_were_written():
    html = to_html(check("$$\\cos(x + 90^\\circ) = -\\sin x$$", {"x": "rad"}))
    assert "90°" in html
    assert "180" not in html


def test_an_authors_words_are_no_markup():
    page = "<script>alert(1)</script> $$x = <b$$\n\n<img src=x onerror=alert(1)>\n\n$$1 = 2$$\n"
    html = to_html(check(page, {"x": "1"}), standalone=True)
    assert not re.search(r"<script|<img|<b[ >]|onerror=(?!alert\(1\)&gt;)", html)
