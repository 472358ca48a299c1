"""Words in brackets right behind a unit, as in 11.8 kN(上向き), leave the unit what it is."""

import pytest

from symbalance.checking import check

DATA = "λ = 0.295、F₁ = 9140 N。\n\n"
RIGHT = (
    DATA + "F = (1+λ) F₁ ≈ 11.8 kN(上向き)",
    DATA + "F = (1+λ) F₁ ≈ 11.8 kN（上向き）",
    DATA + "F = (1+λ) F₁ ≈ 11.8 kN(upwards)",
    "T = 50 N·m(平均)、ω = 100 rad/s、P = T ω = 5 kW(出力)",
    "k = 20 N/mm(ばね定数)、x = 2 mm(たわみ)、F = k x = 40 N(引張)",
    "m = 0.42 kg(piston and pin), r = 31 mm(crank), m r = 13.0 kg mm(total)",
    "m = 0.5 kg, r = 3 m, l = 4 m, y = 2 m(r + l) = 7 kg m",
)
WRONG = (
    DATA + "F = (1+λ) F₁ ≈ 11.3 kN(上向き)",
    DATA + "F = (1+λ) F₁ ≈ 11.8 N（上向き）",
    DATA + "F = (1+λ) F₁ ≈ 18.1 kN(upwards)",
    "T = 50 N·m(平均)、ω = 100 rad/s、P = T ω = 50 kW(出力)",
    "k = 20 N/mm(ばね定数)、x = 2 mm(たわみ)、F = k x = 400 N(引張)",
    "m = 0.42 kg(piston and pin), r = 31 mm(crank), m r = 31.0 kg mm(total)",
    "m = 0.5 kg, r = 3 m, l = 4 m, y = 2 m(r + l) = 14 kg m",
)
REFUTED = ("refuted", "contradiction")


@pytest.mark.parametrize("page", RIGHT)
def test_a_right_result_with_words_behind_its_unit_is_not_refuted(page):
    verdicts = [v.verdict for v in check(page + "\n").verdicts]
    assert verdicts
    assert not {*verdicts} & {*REFUTED, "undecided", "unreadable"}


@pytest.mark.parametrize("page", WRONG)
def test_a_wrong_result_with_words_behind_its_unit_is_refuted(page):
    assert any(v.verdict in REFUTED for v in check(page + "\n").verdicts)
