"""A number with more digits than the one before it is the value of what stands further ahead."""

import pytest

from symbalance.notes.checking import check


def last_word(page: str) -> str:
    checked = check(page + "\n", {})
    return max(checked.verdicts, key=lambda v: (v.line, v.span)).verdict


@pytest.mark.parametrize(
    "page",
    [
        r"$λ = 45/150 = 0.3 = 0.34$",
        r"$x = 10/3 = 3.3 = 3.34$",
        r"$\sqrt{2} = 1.4 = 1.42$",
        r"$1{,}5^2 = 2{,}3 = 2{,}28$",
        r"$2/3 ≈ 0.7 = 72\,\%$",
        r"$F = 2218.41\,\mathrm{N} = 2.2\,\mathrm{kN} = 2240\,\mathrm{N}$",
        r"$A = \frac{π}{4} 0.08^2 = 0.0050\,\mathrm{m^2} = 50.4\,\mathrm{cm^2}$",
    ],
)
def test_digits_from_nowhere_are_refuted(page):
    assert last_word(page) == "refuted"


@pytest.mark.parametrize(
    "page",
    [
        r"$λ = 45/150 = 0.3 = 0.30$",
        r"$x = 10/3 = 3.3 = 3.33$",
        r"$\sqrt2 = 1.4 = 1.41 = 1.414$",
        r"$2/3 ≈ 0.667 ≈ 0.67 ≈ 0.7 = 70\,\%$",
        r"$2/3 ≈ 0.7 = 67\,\%$",
        r"$F = 2218.41\,\mathrm{N} = 2.2\,\mathrm{kN} = 2200\,\mathrm{N}$",
        r"$φ = \arcsin 0.3 = 0.30 = 17.2°$",
        r"$G = 2.5\cdot 9.81 = 24.5 = 24.53$",
        r"$m = 0.5$ kg, $r = 0.04$ m, $ω = 314.159$ 1/s"
        "\n\n" + r"$F = m r ω^2 = 0.5\cdot 0.04\cdot 314^2 = 1.97$ kN $= 1974$ N",
        "$x = 10/3 = 3.3$\n\n$x = 3.33$",
        "$x = 10/3 = 3.3$\n\n$x = 3.3$",
    ],
)
def test_digits_of_the_exact_value_hold(page):
    assert last_word(page) in ("holds", "holds_to_order")


@pytest.mark.parametrize("page", ["$x = 10/3 = 3.3$\n\n$x = 3.35$", "$F = 2218.4 = 2200$\n\n$F = 2240$"])
def test_the_same_letter_further_down_has_no_other_digits(page):
    assert last_word(page) not in ("holds", "holds_to_order")
