"""Letters that a sentence names before an equation, crank radius r, rod l, λ = r/l, are no part of it."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

NAMED = [
    ("Kurbelradius *r*, Pleuellänge *l*, λ = r/l.", "md"),
    ("Radius _r_, rod _l_, _λ_ = _r_/_l_.", "md"),
    ("where r is the radius, l, λ = r/l.", "md"),
    ("crank radius r, rod length l, λ = r/l.", "txt"),
    ("mit λ = r/l; a, b und c sind Abstände.", "txt"),
    ("<p>Kurbelradius <i>r</i>, Pleuell&auml;nge <i>l</i>, &lambda; = <i>r</i>/<i>l</i></p>", "html"),
]


@pytest.mark.parametrize(("line", "kind"), NAMED)
def test_the_equation_alone_is_read(tmp_path, line, kind):
    path = tmp_path / f"page.{kind}"
    path.write_text(f"{line}\n\nr = 3 and l = 12\n\nλ = 0.25\n", encoding="utf-8")
    verdicts = [verdict.verdict for verdict in check(path, fixes=False).verdicts]
    assert verdicts[0] == "definition"
    assert verdicts[-1] == "holds"


@pytest.mark.parametrize("line", ["for x, y = 0 only", "of l, m, λ = r/l"])
def test_a_list_that_may_share_its_value_is_not_cut(tmp_path, line):
    path = tmp_path / "page.txt"
    path.write_text(f"{line}\n", encoding="utf-8")
    assert not any(verdict.verdict == "definition" for verdict in check(path, fixes=False).verdicts)
