"""An inertia force at two speeds goes with their square: F(2600) is a quarter of F(5200)."""

import pytest

from tests.checked_pages import last_in

PAGES = {
    "letters": ("The force is F1 = m*r*w^2. At half of that speed ", "F1(3250) = F1(6500)/{}", "4", "2"),
    "ratio": (
        "The shake F1 = 0.650 * 0.042 * 418.9^2 = 4791 N at 4000 rpm grows by ",
        "F1(7000)/F1(6500) = {}",
        "(7000/6500)^2",
        "7000/6500",
    ),
    "hats": (
        "$F_{II} = 4 \\lambda m r\\omega^2$, and at half the speed ",
        "$\\hat F_{II}(2600) = {} \\hat F_{II}(5200)$",
        "\\frac14",
        "\\frac12",
    ),
    "units": (
        "$F_{II} = 4 \\lambda m r\\omega^2$, and at half the speed ",
        "$F_{II}(2600\\,\\mathrm{min}^{-1}) = {} F_{II}(5200\\,\\mathrm{min}^{-1})$",
        "0.25",
        "0.5",
    ),
}


@pytest.mark.parametrize("page", PAGES.values(), ids=PAGES)
def test_the_square_of_the_speeds_holds_and_the_plain_ratio_does_not(page):
    words, claim, right, wrong = page
    assert last_in(words + claim.replace("{}", right) + ".") == "holds"
    assert last_in(words + claim.replace("{}", wrong) + ".") == "refuted"


def test_a_force_without_a_speed_in_its_formula_is_open():
    assert last_in("The force is $F_1 = p A$, and $F_1(3250) = F_1(6500)/2$.") == "undecided"
