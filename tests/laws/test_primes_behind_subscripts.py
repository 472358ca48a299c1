"""Greek names with primes in plain text, sigma_W' and lambda', are letters of their own."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check


@pytest.mark.parametrize(
    "letter", ["sigma_W'", "lambda'", "omega_1'", "theta'_1", "phi_max''", "m_A'", "σ_W′"]
)
@pytest.mark.parametrize(("last", "word"), [("7.5", "holds"), ("7.7", "refuted")])
def test_a_letter_with_a_prime_has_its_value(tmp_path, letter, last, word):
    path = tmp_path / "page.txt"
    path.write_text(f"{letter} = 2.5*1.2\n\nand 2.5*{letter} = {last}\n", encoding="utf-8")
    assert check(path, fixes=False).verdicts[-1].verdict == word


def test_words_in_prose_stay_words(tmp_path):
    path = tmp_path / "page.txt"
    path.write_text("The angle theta's cosine is small, so r = 3.\n", encoding="utf-8")
    assert [verdict.verdict for verdict in check(path, fixes=False).verdicts] == ["definition"]


@pytest.mark.parametrize("unit", ["rpm", "1/min", "/min"])
@pytest.mark.parametrize("size", [30, 60])
def test_a_speed_of_thirty_turns_no_minutes_into_seconds(tmp_path, unit, size):
    path = tmp_path / "page.txt"
    turns = 900 // size
    lines = (
        f"n = 900 {unit}\n\nΔn = n/{turns} = {size} {unit}\n\nk = 1/{turns}\n\nx = k·n = {size} {unit}\n"
    )
    path.write_text(lines.replace(" /", "/"), encoding="utf-8")
    assert check(path, fixes=False).verdicts[-1].verdict == "holds"


@pytest.mark.parametrize(("given", "word"), [("x = 900", "definition"), ("x > 0", "undecided")])
def test_a_prime_is_no_derivative_by_what_has_a_value(tmp_path, given, word):
    path = tmp_path / "page.txt"
    path.write_text(f"{given}\n\nsigma_W = 0.45*x\n\nsigma_W' = 300\n", encoding="utf-8")
    assert check(path, fixes=False).verdicts[-1].verdict == word
