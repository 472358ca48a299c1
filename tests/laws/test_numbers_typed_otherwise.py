"""Thin spaces between thousands, a scanned nought before a comma, and logarithms to base ten."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

PROVED = ("holds", "holds_to_order", "conditional")
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
    (
        "md",
        r"$F = 22\,810\ \text{N}$, $Q = 3944\ \text{N}$, $P = F - Q = 22\,810 - 3944 = 18\,866$ N",
        True,
    ),
    (
        "md",
        r"$F = 22\,810\ \text{N}$, $Q = 3944\ \text{N}$, $P = F - Q = 22\,810 - 3944 = 18\,886$ N",
        False,
    ),
    ("txt", "The force is then\n.0000284 x 880 x 14.5 x 250^2 = 22,650 lb.", True),
    ("txt", "The force is then\n.0000284 x 880 x 14.5 x 250^2 = 26,250 lb.", False),
    ("txt", "as in Fig.25 x 8 = 200 and (.25 x 8 = 2)", True),
    ("txt", "n = 267 x √(22000 ÷ 4170) = 613 r. p. m.", True),
    ("txt", "n = 267 x √(22000 ÷ 4170) = 631 r. p. m.", False),
    ("txt", "that is 60 x 101.5 ÷ (3.1416 x 7) = 277 r. p. m.", True),
    ("txt", "that is 60 x 101.5 ÷ (3.1416 x 7) = 272 r. p. m.", False),
    ("txt", "E = W v² ÷ 2 u = .5 W v² ÷ u", True),
    ("txt", "E = W v² ÷ 2 u = .5 W v² u", False),
    ("txt", "E = W v² / 2 u = .5 W v² / u", True),
    ("txt", "n = 12 x 88 S ÷ π D = 336 S ÷ D", True),
    ("txt", "n = 12 x 88 S ÷ π D = 363 S ÷ D", False),
    ("tex", r"$\SI{6000}{rev/min} = \SI{628}{rad/s}$", True),
    ("tex", r"$\SI{6000}{U/min} = \SI{682}{1/s}$", False),
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
