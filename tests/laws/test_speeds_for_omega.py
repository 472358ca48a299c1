"""A number whose formula has an ω of which revolutions alone are given is judged by them."""

import pytest

from tests.checked_pages import last_in

FORCE = "$F = m r\\omega^2$, $m = 0.5$ kg, $r = 40$ mm, $n = 3000$ rpm. $F = {}$ N."
MINUTES = (
    "$F = m r\\omega^2$\n\nWith $m = 0.5$ kg, $r = 40$ mm and $n = 3000$ min⁻¹ the force is\n\n"
    "$$F = {}\\,\\mathrm{{N}}$$"
)


@pytest.mark.parametrize(
    ("page", "right", "wrong"),
    [
        ("$P = T\\omega$, $P = 50$ kW, $n = 3000$ rpm: $T = {}$ N m.", "159", "195"),
        (FORCE, "1974", "1794"),
        (MINUTES, "1974", "1794"),
    ],
)
def test_omega_is_the_speed_given_in_revolutions(page, right, wrong):
    assert last_in(page.format(right)) == "conditional"
    assert last_in(page.format(wrong)) == "refuted"


def test_an_omega_with_a_value_of_its_own_is_that():
    page = "$F = m r\\omega^2$. At $\\omega = 300$ rad/s, $m = 0.5$ kg, $r = 40$ mm. $F = {}$ N."
    assert last_in(page.format("1800")) == "conditional"
    assert last_in(page.format("1974")) == "refuted"
