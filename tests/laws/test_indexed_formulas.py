"""A formula with an index gives each number of it: S_n = 2 + 2 cos nπ says that S_4 is 4."""

import pytest

from tests.checked_pages import last_in

PAGES = {
    "sum": ("$S_n = 2[1+(-1)^n]$, hence $S_4 = {}$.", "4", "0"),
    "nothing": ("$S_n = 2[1+(-1)^n]$, hence $S_1 = {}$.", "0", "2"),
    "fraction": ("$c_k = \\frac{1}{k^2}$, so $c_3 = {}$.", "\\frac19", "\\frac16"),
    "speed": ("$n_k = \\frac{60 f}{k}$ with $f = 100$ Hz, so $n_4 = {}$.", "1500", "1200"),
}


@pytest.mark.parametrize("page", PAGES.values(), ids=PAGES)
def test_a_number_of_the_index_is_put_in(page):
    text, right, wrong = page
    assert last_in(text.replace("{}", right)) in ("holds", "holds_to_order")
    assert last_in(text.replace("{}", wrong)) == "refuted"


@pytest.mark.parametrize(
    "page",
    [
        "$a_n = \\frac{4}{n\\pi}$ for odd $n$, and $a_2 = 0$.",
        "$a_n = \\frac{4}{n\\pi}$, and $a_0 = 1/2$.",
        "$n_k = 60 f/k$ with $f = 50$ Hz. On the stand $n_2 = 1400$ was measured.",
    ],
)
def test_a_number_outside_the_formula_is_given(page):
    assert last_in(page) in ("definition", "premise")


def test_a_number_with_decimals_counts_its_zeros():
    page = "$v_m = s n/30$ with $s = 0.09$ m and $n$ in rpm, so at 6000 rpm $v_m = {}$ m/s."
    assert last_in(page.replace("{}", "18.0")) == "holds_to_order"
    assert last_in(page.replace("{}", "9.0")) == "refuted"
