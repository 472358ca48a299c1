"""Pages in AsciiDoc: what a report quotes of them, their tables, and units behind stem:[…]."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check
from symbalance.notes.reading.markup.ascii_math import with_ascii_math

TABLE = r"""== Data

[cols="2,1,1"]
|===
| Quantity | Symbol | Value

| Stroke | stem:[S] | 132 mm
| Bore | stem:[D] | 132 mm
|===

* Crank radius stem:[r = S/2 = {}] mm
* Displacement stem:[V = 9\cdot\frac{{\pi}}{{4}}D^2 S = {}] litres
"""


def verdicts_of(tmp_path, text):
    page = tmp_path / "engine.adoc"
    page.write_text(text, encoding="utf-8")
    return check(page).verdicts


def test_a_side_with_a_unit_behind_its_mark_is_quoted_alone(tmp_path):
    text = "* Angular velocity stem:[\\omega = 2\\pi\\cdot 2300/60 = 204.9] rad/s, of the crank\n"
    first, second = sorted(verdicts_of(tmp_path, text), key=lambda v: v.span)
    assert (first.verdict, first.source) == ("definition", r"2\pi\cdot 2300/60")
    assert (second.verdict, second.source) == ("refuted", "204.9] rad/s")


@pytest.mark.parametrize(
    ("radius", "volume", "words"),
    [
        ("66", "16.3", ("holds", "holds_to_order")),
        ("33", "16.3", ("refuted", "holds_to_order")),
        ("66", "1.63", ("holds", "refuted")),
        ("66", "16.9", ("holds", "refuted")),
    ],
)
def test_a_table_gives_letters_their_values(tmp_path, radius, volume, words):
    verdicts = verdicts_of(tmp_path, TABLE.format(radius, volume))
    by_line = {v.line: v.verdict for v in sorted(verdicts, key=lambda v: v.span)}
    assert tuple(by_line[line] for line in sorted(by_line)[-2:]) == words


ASCII_MATH = """= Balance shafts
:stem: asciimath

The mass is stem:[m = 0.96] kg and the radius stem:[r = S//2] of the stroke stem:[S = 94.6] mm.

[stem]
++++
U = 1/2 m r {}= 0.5 xx 0.96 xx 47.3 = {} " kg mm"
++++

With stem:[theta] the crank angle,

[stem]
++++
cos theta + cos(theta - 240^@) = {} cos(theta - 120^@)
++++

[stem]
++++
cos theta - cos(theta - 240^@) = sqrt 3 cos(theta {} 30^@), qquad sum_(k=1)^n k = (n(n+1))/{}
++++
"""


@pytest.mark.parametrize(
    ("gaps", "wrong"),
    [
        (("", "22.7", "-1", "-", "2"), []),
        (("", "27.2", "-1", "-", "2"), ["= 0.5 xx 0.96 xx 47.3 = "]),
        (("", "22.7", "+1", "-", "2"), ["cos theta + cos(theta - 240^@)"]),
        (("", "22.7", "-1", "+", "2"), ["cos theta - cos(theta - 240^@)"]),
        (("", "22.7", "-1", "-", "3"), ["sum_(k=1)^n k"]),
    ],
)
def test_ascii_math_is_read_by_its_own_grammar(tmp_path, gaps, wrong):
    """1/2 m r is half of m r, sqrt 3 a root of 3 alone, and "N" in quotes a unit."""
    text = ASCII_MATH.format(*gaps)
    verdicts = verdicts_of(tmp_path, text)
    refuted = [v for v in verdicts if v.verdict == "refuted"]
    assert len(refuted) == len(wrong)
    for verdict, line in zip(refuted, wrong, strict=True):
        assert line in text.split("\n")[verdict.line - 1]
    assert not [v for v in verdicts if v.verdict in ("unreadable", "undecided")]


def test_a_page_whose_attribute_says_latex_stays_as_it_is():
    page = "\n\n\\(1/2 m r\\)\n"
    assert with_ascii_math(f":stem: latexmath{page}") is None
    assert with_ascii_math(f":stem:{page}") is not None
