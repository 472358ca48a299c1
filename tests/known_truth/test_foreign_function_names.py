"""Functions under foreign names in plain text are read; a formula behind an unknown one is not cut."""

import pytest

from symbalance.checking import check


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("1 - sen² α = cos² α", ["holds"]),
        ("1 + sen² α = cos² α", ["refuted"]),
        ("sen 2α = 2 sen α cos α", ["holds"]),
        ("tg α = sen α/cos α ,      cos 2α = 1 - 2 sen² α                (4)", ["holds", "holds"]),
        ("v ≈ r ω [ sen α + (λ/2) sen 2α ]          (5)", ["definition"]),
    ],
)
def test_sines_and_tangents_of_plain_text(tmp_path, line, words):
    page = tmp_path / "notes.txt"
    page.write_text(f"Se tiene\n\n     {line}\n\npara todo ángulo.\n")
    assert [link["verdict"] for link in check(page).data()["links"]] == words


@pytest.mark.parametrize(
    "line",
    [
        "v = r ω [ foo α + (λ/2) cos 2α ]",
        "v = 2 r foo² α",
        "v = r ω foo α",
        "v = r ω foo(α)",
        "x = a ( foo α + b )",
    ],
)
def test_a_formula_with_an_unknown_function_is_not_read_in_part(tmp_path, line):
    page = tmp_path / "notes.txt"
    page.write_text(f"We have\n\n     {line}\n\nfor all angles.\n")
    assert [link["verdict"] for link in check(page).data()["links"]] == ["unreadable"]


@pytest.mark.parametrize(
    "line", ["x = 3 a for α", "x = 3 a and β", "x = 5 mm long", "x = 3 a (see α below)"]
)
def test_words_behind_a_formula_are_no_functions(tmp_path, line):
    page = tmp_path / "notes.txt"
    page.write_text(f"We have\n\n     {line}\n\n.\n")
    assert [link["verdict"] for link in check(page).data()["links"]] == ["definition"]


def test_one_letter_words_are_no_factors_of_a_unit(tmp_path):
    page = tmp_path / "notes.txt"
    page.write_text(
        "La biela es larga. Con el radio r = 3,5 m y l = 2,5 m se tiene para x = 2 y un valor.\n"
    )
    links = check(page).data()["links"]
    assert [link["claimed"] for link in links] == ["3.5", "2.5", "2y"]
