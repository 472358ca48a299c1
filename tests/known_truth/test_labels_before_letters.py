"""Words in a column before a letter are no factors of it, and a crank pin is not π n."""

import pytest

from symbalance.notes.checking import check

LETTERS = {"n": "engine speed", "d": "pin diameter", "D": "bore", "x": "variable", "y": "variable"}


def words(tmp_path, text: str) -> list[str]:
    path = tmp_path / "notes.txt"
    path.write_text(text + "\n", encoding="utf-8")
    return [verdict.verdict for verdict in check(path, LETTERS).verdicts]


@pytest.mark.parametrize(
    "line",
    [
        "crank pin       d = 50 mm",
        "crank pin d = 50 mm",
        "big end pin  d = 50 mm (solid)",
        "   bore            D = 86 mm\n   crank pin       d = 50 mm (solid first)",
    ],
)
def test_a_label_is_no_factor(tmp_path, line):
    assert {*words(tmp_path, line)} == {"definition"}


@pytest.mark.parametrize(
    ("line", "word"),
    [
        ("n = 50 and 2 pin = 314.2", "holds_to_order"),
        ("crank pin       d = 50 mm\n\nd/2 = 25 mm", "holds"),
        ("crank pin       d = 50 mm\n\nd/2 = 52 mm", "refuted"),
    ],
)
def test_products_and_what_follows_are_read_as_before(tmp_path, line, word):
    assert words(tmp_path, line)[-1] == word
