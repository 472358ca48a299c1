"""The size that an inequality asks for has to satisfy it."""

import pytest

from tests.checked_pages import last_in


@pytest.mark.parametrize(
    ("page", "enough", "too_small"),
    [
        (
            "$\\tau = \\frac{{16T}}{{\\pi d^3}} \\le 50$ MPa with $T = 100$ N m: $d \\ge {}$ mm.",
            "21.7",
            "12.7",
        ),
        (
            "$\\tau = \\frac{{16T}}{{\\pi d^3}} \\le 50$ MPa with $T = 100$ N m: $d \\ge {}$ mm.",
            "25",
            "20",
        ),
        ("$F/A \\le 200$, $F = 10000$: $A \\ge {}$.", "50", "40"),
        ("$2x + 1 \\le y$, $y = 7$, so $x \\le {}$.", "3", "4"),
        ("$\\sigma = F/A \\le 200$ MPa, $F = 10$ kN, also $A \\ge {}$ mm².", "50", "40"),
    ],
)
def test_a_size_that_is_needed(page, enough, too_small):
    assert last_in(page.format(enough)) == "range"
    assert last_in(page.format(too_small)) == "refuted"


@pytest.mark.parametrize(
    "page",
    [
        "$F/A \\le 200$, $F = 10000$. Shops have $A \\ge 40$ in stock.",
        "$F/A \\le 200$. Now $A \\ge 40$.",
        "$F/A \\le 200$, $F = 10000$. For $A \\ge 40$ it is too small.",
    ],
)
def test_another_bound_is_not_held_against_it(page):
    assert last_in(page) == "range"
