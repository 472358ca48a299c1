"""Thin spaces between thousands, a scanned nought before a comma, and logarithms to base ten."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

PROVED = ("holds", "holds_to_order")
CASES = [
    ("md", "F = 3\u2009000\u2009N = 3 kN", True),
    ("md", "F = 3\u202f000 N = 4 kN", False),
    ("html", "<p>F = 3&thinsp;000&thinsp;N = 3 kN</p>", True),
    ("html", "<p>F = 12&#8239;000 N = 13 kN</p>", False),
    ("txt", "r = O,04 m = 40 mm, und l = 0,16 m", True),
    ("txt", "r = O,04 m = 54 mm, und l = 0,16 m", False),
    ("md", r"$\log 100 = 2$", True),
    ("md", r"$\log 2 = 0.301$", True),
    ("md", r"$\log 2 = 0.693$", True),
    ("md", r"$\log 2 = 0.5$", False),
    ("md", r"$\log_{10} 100 = 2$", True),
    ("md", r"$\log_{10}(2) = 0.693$", False),
    ("md", r"$\alpha = 30^{\,\circ} = \pi/6$", True),
]


@pytest.mark.parametrize(("kind", "line", "is_right"), CASES)
def test_numbers_typed_otherwise(tmp_path, kind, line, is_right):
    path = tmp_path / f"page.{kind}"
    path.write_text(f"{line}\n", encoding="utf-8")
    words = [verdict.verdict for verdict in check(path, fixes=False).verdicts]
    if is_right:
        assert any(word in PROVED for word in words)
        assert "refuted" not in words
    else:
        assert "refuted" in words


@pytest.mark.parametrize(
    "line", [r"$\mathrm{arctg}\, 1 = \pi/4$", r"$\mathrm{sgn}\, x = 1$", r"$\log_2 8 = 3$"]
)
def test_an_unknown_function_is_no_product(tmp_path, line):
    path = tmp_path / "page.md"
    path.write_text(f"{line}\n", encoding="utf-8")
    assert [verdict.verdict for verdict in check(path, fixes=False).verdicts] == ["unreadable"]
