"""A letter before two numbers in brackets is a function at them, and no product with each."""

from __future__ import annotations

import pytest

from tests.checked_pages import last_verdict


@pytest.mark.parametrize("said", ["F(2600) = ½ F(5200)", "F(5200) = 4 F(2600)"])
def test_values_at_two_numbers_are_open(tmp_path, said):
    assert last_verdict(tmp_path, f"The free force grows with the speed: {said}.") not in (
        "holds",
        "refuted",
    )


def test_a_function_of_the_page_is_evaluated(tmp_path):
    page = "Let f(x) = x².\n\nThen f(4) = {} f(2)."
    assert last_verdict(tmp_path, page.format("4")) == "holds"
    assert last_verdict(tmp_path, page.format("2")) == "refuted"


def test_a_product_with_one_number_is_a_product(tmp_path):
    assert last_verdict(tmp_path, "a(2 + 3) = 5 a.") == "holds"
