"""A number repeated for another speed, place, engine or column is not proved by what it was before."""

import pytest

from symbalance.checking import check

PROVED = ("holds", "holds_to_order", "conditional")


def last(tmp_path, page):
    path = tmp_path / "page.md"
    path.write_text(page)
    return check(path, fixes=False).verdicts[-1]


@pytest.mark.parametrize(
    "page",
    [
        "At n = 3000 rpm, ω = 314.2 rad/s. At n = 6000 rpm, ω = 314.2 rad/s.",
        "Bei n = 3000 min⁻¹ ist ω = 314 1/s. Bei n = 6000 min⁻¹ ist ebenfalls ω = 314 1/s.",
        "At n = 3000 rpm, T = 20 ms. At n = 6000 rpm, T = 20 ms.",
        "The spring has c = 100 N/mm. At x = 2 mm, F = 200 N. At x = 5 mm, F = 200 N.",
        "Pour d = 2 cm, A = 3.14 cm². Pour d = 4 cm, A = 3.14 cm².",
        "At n = 3000 rpm and M = 200 Nm the power is P = 62.8 kW;"
        " at n = 6000 rpm and M = 150 Nm it gives P = 62.8 kW.",
        "For n = 1000 rpm, P = 2πnM = 10 kW. For n = 2000 rpm and the same M, P = 10 kW.",
        "Bei 60° ist cos φ = 0{,}5, bei 120° ebenfalls cos φ = 0{,}5.",
        "| quantity | A | B |\n|---|---|---|\n| m | m = 2 kg | m = 3 kg |\n"
        "| G = m g | G = 19.62 N | G = 19.62 N |\n",
    ],
)
def test_a_repeated_number_is_open(tmp_path, page):
    verdict = last(tmp_path, page)
    assert verdict.verdict == "undecided"
    assert "number of line" in (verdict.reason or "")


@pytest.mark.parametrize(
    "page",
    [
        "Motor A: m = 2 kg, a = 3 m/s², F = m a = 6 N. Motor B: m = 4 kg, a = 5 m/s², F = 6 N.",
        "Motor A: m = 2 kg, a = 3 m/s², F = m a = 6 N. Motor B has m = 4 kg and the same a,"
        " so F = 6 N as well.",
        "ω = 2πn/60\n\n| speed | result |\n|---|---|\n| n = 1000 rpm | ω = 104.7 rad/s |\n"
        "| n = 2000 rpm | ω = 104.7 rad/s |\n",
    ],
)
def test_a_repeated_number_is_refuted_by_its_formula(tmp_path, page):
    assert last(tmp_path, page).verdict == "refuted"


def test_a_repeated_datum_of_another_engine_is_given(tmp_path):
    page = "Motor A: r = 40 mm, l = 160 mm. Motor B: l = 150 mm, r = 40 mm."
    assert last(tmp_path, page).verdict in ("premise", "definition")


@pytest.mark.parametrize(
    "page",
    [
        "Motor A: m = 2 kg, a = 3 m/s², F = m a = 6 N. Motor B: m = 4 kg, a = 5 m/s², F = 20 N.",
        "For n = 1000 rpm, P = 2πnM = 10 kW. For n = 2000 rpm and the same M, P = 20 kW.",
        "ω = 2πn/60\n\n| speed | result |\n|---|---|\n| n = 1000 rpm | ω = 104.7 rad/s |\n"
        "| n = 2000 rpm | ω = 209.4 rad/s |\n",
        "x = 2, so x² = 4. Again x² = 4.",
        "Motor A: m = 2 kg, a = 6 m/s², F = m a = 12 N. Motor B: m = 4 kg, a = 3 m/s², F = 12 N.",
    ],
)
def test_the_right_number_there_holds(tmp_path, page):
    assert last(tmp_path, page).verdict in PROVED


def test_each_column_has_its_own(tmp_path):
    path = tmp_path / "page.md"
    rows = "| | A | B |\n|---|---|---|\n| x | x = 2 | x = 3 |\n| y = x² | y = 4 | y = {} |\n"
    path.write_text(rows.format(9))
    assert [v.verdict for v in check(path, fixes=False).verdicts][-2:] == ["holds", "holds"]
    path.write_text(rows.format(4))
    assert [v.verdict for v in check(path, fixes=False).verdicts][-2:] == ["holds", "refuted"]


@pytest.mark.parametrize(("volume", "expected"), [("573", "premise"), ("452", "refuted")])
def test_rows_above_their_formula(tmp_path, volume, expected):
    path = tmp_path / "page.md"
    path.write_text(
        "| engine | bore | stroke | volume |\n|---|---|---|---|\n"
        "| A | d = 80 mm | s = 90 mm | V = 452 cm³ |\n"
        f"| B | d = 90 mm | s = 90 mm | V = {volume} cm³ |\n\nwith V = π/4 d² s\n"
    )
    *_, row, formula = check(path, fixes=False).verdicts
    assert (row.verdict, formula.verdict) == (expected, "definition")
