"""A letter behind a number that is also a unit's sign, ½ m and 2 s: told by the formula and the page."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

PROVED = ("holds", "holds_to_order", "conditional")
LETTERS = [
    ("Each cylinder has the mass $m$.", r"$a = m_r + \tfrac12 m$", r"$2 a = 2 m_r + m$"),
    ("", r"$a = (m_\mathrm{rot} + 0.5 m) r$", r"$2 a = 2 m_\mathrm{rot} r + m r$"),
    ("Der Hub s = 80 mm.", "r = 1/2 s", "r = 40 mm"),
    ("The stroke s = 80 mm.", "x = 3/2 s", "x = 120 mm"),
    ("The mass m = 3 kg.", "m_2 = 2 m", "m_2 = 6 kg"),
    ("The mass is $m$.", "$M = 4 m$", "$M - 3 m = m$"),
    ("The stroke is $s$.", r"$V = A \cdot 2 s$", r"$V = 2 A s$"),
    ("s = 100 mm", "h = 0.5 s", "h = 50 mm"),
    ("The masses $m$ and $g$.", "$F_g = 3 m g$", "$F_g/g = 3 m$"),
    ("Le travail vaut $W = 3.6$ kJ.", "$E = 0.38\\,W = 1.37$ kJ", "$E/2 = 684$ J"),
    ("Die Höhe $h$.", r"$x = (a + 2h)$", r"$x - h = a + h$"),
]
UNITS = [
    ("The mass is $m$.", "$l = 0.25 m$", "$l = 250$ mm"),
    ("The mass is $m$.", "$x = 1.5 m + 0.5 m$", "$x = 2000$ mm"),
    ("", "F = 0.3 kN", "F/2 = 150 N"),
    ("There are $N$ cylinders.", "Z = 3 N", "2 Z = 6 N"),
    ("", r"$n = \frac{1500}{\mathrm{min}}$", r"$n = 25/\mathrm{s}$"),
]


@pytest.mark.parametrize(("given", "line", "result"), [*LETTERS, *UNITS])
def test_the_reading_bears_out_the_result(tmp_path, given, line, result):
    path = tmp_path / "page.md"
    path.write_text(f"{given}\n\n{line}\n\n{result}\n", encoding="utf-8")
    words = [verdict.verdict for verdict in check(path, fixes=False).verdicts]
    assert "unreadable" not in words
    assert words[-1] in PROVED


@pytest.mark.parametrize(
    ("given", "line", "result"),
    [
        ("The stroke s = 80 mm.", "x = 3/2 s", "x = 140 mm"),
        ("The mass m = 3 kg.", "m_2 = 2 m", "m_2 = 7 kg"),
        ("Each cylinder has the mass $m$.", r"$a = m_r + \tfrac12 m$", r"$2 a = m_r + m$"),
    ],
)
def test_a_wrong_result_is_refuted(tmp_path, given, line, result):
    path = tmp_path / "page.md"
    path.write_text(f"{given}\n\n{line}\n\n{result}\n", encoding="utf-8")
    assert check(path, fixes=False).verdicts[-1].verdict in ("refuted", "contradiction")
