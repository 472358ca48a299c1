"""Scripts as formats mark them in prose, F<sub>2</sub>, F~2~ and :sub:, and Swiss thousands."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

LINES = [
    ("md", "*F*<sub>2</sub> = 3 and *x*<sup>2</sup> = 16", "2 *F*<sub>2</sub> = {}"),
    ("md", "_F_<sub>2</sub> = 3", "2 _F_<sub>2</sub> = {}"),
    ("md", "*F*<sub>*max*</sub> = 3", "2 *F*<sub>*max*</sub> = {}"),
    ("md", "F~2~ = 3", "2 *F*~2~ = {}"),
    ("md", "x = 3", "x^2^ - 3 = {}"),
    ("adoc", "_F_~1~ = 3", "2 F~1~ = {}"),
    ("adoc", "x = 3", "x^2^ - x = {}"),
    ("rst", "F\\ :sub:`1` = 3 and |lambda| = 0.25", "8 |lambda| F\\ :sub:`1` = {}"),
    ("rst", "x = 3", "x\\ :sup:`2` - 3 = {}"),
    ("txt", "F2 = 3 + 3\n-- \nMax Muster", "F2 = {}"),
    ("txt", "x = 6'000", "x/1000 = {}"),
    ("txt", "x = 6’000’000.0", "x/1'000'000 = {}"),
]


@pytest.mark.parametrize(("kind", "given", "line"), LINES)
@pytest.mark.parametrize(
    ("last", "words"), [("6", ("holds", "conditional")), ("8", ("refuted", "contradiction"))]
)
def test_scripts_of_prose_are_read(tmp_path, kind, given, line, last, words):
    path = tmp_path / f"page.{kind}"
    path.write_text(
        f"Here {given}.\n\nHence {line.format(last)}.\n".replace("Muster.", "Muster"), encoding="utf-8"
    )
    verdicts = [verdict.verdict for verdict in check(path, fixes=False).verdicts]
    assert "unreadable" not in verdicts
    assert verdicts[-1] in words


def test_minutes_of_an_angle_are_no_thousands(tmp_path):
    path = tmp_path / "page.txt"
    path.write_text("α = 12°30' = 12.5°\n", encoding="utf-8")
    assert check(path, fixes=False).verdicts[-1].verdict == "holds"
