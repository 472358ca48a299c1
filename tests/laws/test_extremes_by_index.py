"""T_max and T_min of a formula with one wave are what it comes to where the wave is 1 and -1."""

import pytest

from tests.checked_pages import last_in

NUMBERS = "$T = T_0 + T_1\\sin\\theta$, $T_0 = 100$ N m, $T_1 = 30$ N m. $T_{{{}}} = {}$ N m."


@pytest.mark.parametrize(
    ("page", "right", "wrong"),
    [
        ("$F = F_0\\cos\\omega t$, so $F_{{max}} = {}$.", "F_0", "2F_0"),
        ("$x = r(1-\\cos\\theta)$ and $x_{{\\max}} = {}$.", "2r", "r"),
        ("$y = a + b\\sin\\theta$, $y_{{min}} = {}$", "a - b", "a + b"),
        ("$T(\\theta) = 100 + 60\\sin 2\\theta$. $T_{{max}} = {}$.", "160", "150"),
    ],
)
def test_the_extreme_of_one_wave(page, right, wrong):
    assert last_in(page.format(right)) in ("holds", "holds_to_order", "conditional")
    assert last_in(page.format(wrong)) == "refuted"


@pytest.mark.parametrize(("kind", "right", "wrong"), [("max", "130", "100"), ("min", "70", "-30")])
def test_the_extreme_in_numbers(kind, right, wrong):
    assert last_in(NUMBERS.format(kind, right)) == "conditional"
    assert last_in(NUMBERS.format(kind, wrong)) == "refuted"


@pytest.mark.parametrize(
    "page",
    [
        "$F = F_0\\cos\\theta$. The allowed force is $F_{max} = 2F_0$.",
        "$F = c t\\cos t$. $F_{max} = 2c$.",
    ],
)
def test_another_largest_value_is_left_alone(page):
    assert last_in(page) != "refuted"
