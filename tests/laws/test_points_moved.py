"""The digits of a value in another unit and another size are that value converted wrongly."""

import pytest

from tests.checked_pages import verdicts_in


@pytest.mark.parametrize(
    ("page", "right", "wrong"),
    [
        ("The crank has $r = 43$ mm. We need $r = {}$ m.", "43\\times10^{-3}", "43\\times10^{-2}"),
        ("The mass is $m = 350$ g.\n\n$m = {}$ kg.", "0.35", "0.035"),
        ("$p = 12$ bar.\n\nSo $p = {}$ Pa.", "1.2\\cdot 10^6", "1.2\\cdot 10^5"),
    ],
)
def test_a_point_that_has_moved(page, right, wrong):
    assert verdicts_in(page.format(right))[-1] in ("holds", "holds_to_order", "conditional")
    assert verdicts_in(page.format(wrong))[-1] in ("refuted", "contradiction")


def test_what_follows_goes_on_with_the_value_above():
    page = "$m = 2$ kg, $r = 43$ mm.\n\n$r = 43\\times10^{-2}$ m.\n\n$m r = 0.086$ kg m."
    assert verdicts_in(page)[-1] in ("holds", "holds_to_order", "conditional")


@pytest.mark.parametrize(
    "page",
    [
        "The crank has $r = 43$ mm. The other one has $r = 4.3$ m.",
        "The speed is $v = 25$ m/s. With $v = 25$ km/h it takes longer.",
        "The force is $F = 4$ N. The load is $F = 4$ kN.",
    ],
)
def test_another_value_is_no_conversion(page):
    assert verdicts_in(page)[-1] != "refuted"
