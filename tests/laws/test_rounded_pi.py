"""A result with the π that its page rounds holds on that condition; without it, it does not."""

import pytest

from tests.checked_pages import last_in


@pytest.mark.parametrize("given", ["$\\pi = 3.14$, $r = 2$: ", "$\\pi \\approx 3.14$. With $r = 2$: "])
def test_the_pi_of_the_page(given):
    assert last_in(given + "$A = \\pi r^2 = 12.56$.") == "conditional"
    assert last_in(given + "$A = \\pi r^2 = 12.66$.") == "refuted"


def test_without_it_pi_is_what_it_is():
    assert last_in("With $r = 2$: $A = \\pi r^2 = 12.56$.") == "refuted"
