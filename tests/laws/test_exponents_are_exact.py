"""A decimal exponent is meant as it stands: no result is right by a rounding of κ - 1 = 0.4."""

import pytest

from tests.checked_pages import last_in


@pytest.mark.parametrize(
    ("page", "right", "wrong"),
    [
        ("$T_2 = T_1 c^{{k-1}} = 300\\cdot 9^{{0.4}} = {}$ K.", "722", "700"),
        ("$T_2 = 293\\cdot 12^{{0.4}} = {}$ K.", "792", "729"),
        ("$20\\cdot 3^{{1.4}} = {}$", "93.1", "91.3"),
        ("$\\eta = 1 - 9^{{-0.4}} = {}$", "0.585", "0.575"),
        ("$\\eta = 1 - c^{{1-k}}$ with $c = 9$ and $k = 1.4$ is $\\eta = {}$.", "0.585", "0.545"),
    ],
)
def test_a_power_with_a_decimal_exponent(page, right, wrong):
    assert last_in(page.format(right)) in ("holds", "holds_to_order", "conditional")
    assert last_in(page.format(wrong)) == "refuted"


@pytest.mark.parametrize(
    "page",
    [
        "$n = \\frac{v}{2s}$, $v = 20$ m/s, $s = 90$ mm: $n = 6667$ rpm.",
        "$a = \\frac{v^2}{2s}$, $v = 20$ m/s, $s = 100$ m: $a = 2$ m/s².",
        "$t = \\frac{2s}{v}$, $v = 20$ m/s, $s = 100$ m: $t = 10$ s.",
        "$E = \\frac{p^2}{2m}$, $p = 6$ kg m/s, $m = 2$ kg: $E = 9$ J.",
        "$a = v^2/(2s)$, $v = 20$ m/s, $s = 100$ m: $a = 2$ m/s².",
        "$v = \\frac{100\\,m}{2s} = 50$ m/s.",
    ],
)
def test_twice_a_letter_is_no_quantity(page):
    assert last_in(page) in ("holds", "holds_to_order", "conditional")
