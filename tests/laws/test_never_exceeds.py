"""An inequality that words say of every angle is a claim: "never exceeds", "at every angle"."""

import pytest

from symbalance.checking import check

SYMBOLS = {
    "r": "crank radius",
    "\\omega": "angular velocity",
    "\\lambda": "crank ratio r/l",
    "\\theta": "crank angle",
}
WAVE = "\\cos x + \\sin x"


def last_word(page: str, symbols: dict[str, str] | None = None) -> str:
    return check(page, symbols, fixes=False).data()["links"][-1]["verdict"]


@pytest.mark.parametrize(
    ("words", "right", "wrong"),
    [
        ("The sum never exceeds this:", f"{WAVE} \\le 2", f"{WAVE} \\le 1"),
        ("At every angle", f"{WAVE} \\le 2", f"{WAVE} \\le 1"),
        ("Die Summe wird nie negativ:", f"2 + {WAVE} \\ge 0", f"1 + {WAVE} \\ge 0"),
        ("La somme ne dépasse jamais 2 :", f"{WAVE} \\le 2", f"2{WAVE} \\le 2"),
    ],
)
def test_what_never_happens_is_claimed_of_every_angle(words, right, wrong):
    assert last_word(f"{words} ${right}$.") == "holds"
    assert last_word(f"{words} ${wrong}$.") == "refuted"


def test_a_wave_is_claimed_for_all_its_angles_and_for_positive_sizes():
    page = "It never exceeds this: $r \\omega^2 (\\cos\\theta + \\lambda \\cos 2\\theta) \\le {}$."
    assert last_word(page.format("r \\omega^2 (1 + \\lambda)"), SYMBOLS) == "holds"
    assert last_word(page.format("r \\omega^2"), SYMBOLS) == "refuted"
    assert last_word(page.format("r \\omega^2 (1 + \\lambda)")) != "refuted"


@pytest.mark.parametrize(
    "page", ["The speed never exceeds the limit: $n \\le 6000$.", "He never said why. $n \\le 6000$."]
)
def test_a_bound_of_a_letter_is_no_claim(page):
    assert last_word(page) == "range"
