"""Words before a formula that compute with it are part of its relation; words that name it are not."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

OPERATIONS = [
    "Die Summe aus 200 N und 300 N = {} N.",
    "Der Mittelwert aus 10 N und 20 N = {} N.",
    "The sum of 2 and 3 = {}.",
    "The mean of 2, 3 and 7 = {}.",
    "The mean of 2, 3, 7 = {}.",
    "The ratio of 10 to 5 = {}.",
    "The difference between 7 and 4 = {}.",
    "Die Wurzel aus 9 = {}.",
    "2 hoch 3 = {}.",
    "10 to the power of 2 = {}.",
    "The sine of 30° = {}.",
    "Le cosinus de 60° = {}.",
    "Der Betrag von $-3 = {}$.",
    "The sum of $3$ and $4 = {}$.",
    "4 cylinders at 500 cm³ = {} cm³.",
    "lim x→0 sin(x)/x = {}",
    "In the limit λ→0 cos β = {}.",
    "∫ from 0 to π sin x dx = {}",
    "Integral from 0 to 1 x dx = {}",
    "sum(1..10) = {}",
    "2+2 ﹦ {}",
    "2+2 ꞊ {}",
    "2+2 ≕ {}",
]
PROSE = [
    "The force is F = 3 N.",
    "The sum of the forces F = 3 N.",
    "The sum of $F_1$ and $F_2$ is $F = 3$ N.",
    "so that x = 2",
    "The ratio of $s$ to $d$, $s/d = 0.9$.",
    "The sine of $2\\theta = 60°$ is taken.",
    "For 3 pistons of 0.5 kg = 500 g each.",
    "A ratio of λ = 0.25 is usual.",
    "With a stroke of 80 mm and a bore of 90 mm = 0.09 m.",
    "An engine of 4 cylinders at 6000 rpm = 628.3 rad/s.",
    "Der Kolben ist 50 mm hoch, h = 50 mm.",
    "f: x → y = 2x",
    "x = 3 → 2x = 6",
    "Für λ → 0 ist cos β = 1.",
    "with 3 cylinders of bore B = 90 mm",
    "Cosine of θ = 60° is taken.",
]


def _verdicts(page: str) -> list[str]:
    return [link["verdict"] for link in check(page).data()["links"]]


@pytest.mark.parametrize("page", OPERATIONS)
@pytest.mark.parametrize("number", ["0", "3", "4", "20", "300", "500"])
def test_a_last_operand_is_not_judged_alone(page: str, number: str):
    assert _verdicts(page.format(number) + "\n") == ["unreadable"]


@pytest.mark.parametrize("page", PROSE)
def test_words_that_name_a_formula_stay_apart(page: str):
    verdicts = _verdicts(page + "\n")
    assert verdicts
    assert not {"unreadable", "refuted"} & set(verdicts)


COUPLE = """m = 0.42 kg, r = 41 mm, ω = 576 1/s, a = 82 mm and M = √3 m r ω² a = 811 N m.

The couple needed is

   B = {} m r ω² a

{} B = {} N m.
"""


@pytest.mark.parametrize(
    "words",
    [
        "This is half of 811 N m, so",
        "Here half of 811 N m:",
        "Die Hälfte von 811 N m, also",
        "C'est la moitié de 811 N m, soit",
        "Es la mitad de 811 N m, o sea",
        "この例では811 N·mの半分、",
        "Here one half of 811 N m, so",
    ],
)
def test_a_number_that_words_compute_is_no_slip_of_its_own(words: str):
    assert _verdicts(COUPLE.format("√3", words, 406))[-1] == "undecided"  # the formula may be wrong
    assert _verdicts(COUPLE.format("√3", words, 460))[-1] == "refuted"
    assert _verdicts(COUPLE.format("√3/2", words, 406))[-1] not in ("refuted", "undecided")
    assert _verdicts(COUPLE.format("√3", "So", 406))[-1] == "refuted"
