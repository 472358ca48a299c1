"""Words behind a number divided by 9.81 that only name it: 12991/9.81 ≈ 1324 times gravity."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

WORDS = [
    "times gravity",
    "times $g$",
    "times the acceleration of gravity",
    "mal die Erdbeschleunigung",
    "times that of gravity",
]


@pytest.mark.parametrize("words", WORDS)
@pytest.mark.parametrize("sign", ["\\approx", "="])
@pytest.mark.parametrize(
    ("last", "word"), [("1324", "holds_to_order"), ("132", "refuted"), ("1423", "refuted")]
)
def test_a_multiple_of_gravity_is_judged(tmp_path, words, sign, last, word):
    path = tmp_path / "page.md"
    path.write_text(f"which is about $12991/9.81 {sign} {last}$ {words}.\n", encoding="utf-8")
    assert check(path, fixes=False).verdicts[-1].verdict == word


@pytest.mark.parametrize(
    "line",
    [
        "It is $98.1/2 = 5$ times gravity.",
        "It is $12991/9.81 = 2$ times gravity times 662.",
        "It is $12991/9.81 = 2$ times the square root of gravity.",
    ],
)
def test_words_that_may_be_put_in_are_not_left_out(tmp_path, line):
    path = tmp_path / "page.md"
    path.write_text(f"{line}\n", encoding="utf-8")
    assert not any(verdict.verdict == "refuted" for verdict in check(path, fixes=False).verdicts)
