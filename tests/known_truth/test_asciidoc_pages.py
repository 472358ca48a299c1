"""Pages in AsciiDoc: what a report quotes of them, their tables, and units behind stem:[…]."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

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
