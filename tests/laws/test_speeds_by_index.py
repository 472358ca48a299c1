"""Two speeds with one subscript are one speed in two units: n_0 = 800 rpm, ω_0 = 83.8 rad/s."""

import pytest

from tests.checked_pages import last_in


@pytest.mark.parametrize(
    ("page", "right", "wrong"),
    [
        ("At idle ($n_0 = 800$ rpm) this is only $\\omega_0 = {}$ rad/s.", "83.8", "41.9"),
        (
            "Au ralenti, à $N_0 = 1200~\\mathrm{tr/min}$, c'est $\\omega_0 = {}~\\mathrm{rad/s}$.",
            "125.7",
            "62,8",
        ),
        (
            "It is $\\omega_n = \\sqrt{1.131\\times 10^5/0.08936} = 1125$ rad/s.\n\n"
            "In cycles per second: $f_n = {}$ Hz.",
            "179.05",
            "358.1",
        ),
        ("With $\\omega_1 = 100$ rad/s the speed is $n_1 = {}$ rpm.", "955", "1910"),
    ],
)
def test_a_speed_of_one_subscript_in_another_unit(page, right, wrong):
    def fill(number):
        return page.replace("{}", number)

    assert last_in(fill(right)) == "holds_to_order"
    assert last_in(fill(wrong)) == "refuted"


@pytest.mark.parametrize(
    "page",
    [
        "At $n_0 = 800$ rpm the camshaft has $\\omega_0 = 41.9$ rad/s.",
        "At $n_0 = 800$ rpm it is $\\omega_1 = 41.9$ rad/s.",
        "At $n_0 = 800$ rpm it is $v_0 = 41.9$ m/s.",
        "# A\n\nAt $n_0 = 800$ rpm it runs.\n\n# B\n\nHere $\\omega_0 = 41.9$ rad/s.",
    ],
)
def test_another_speed_is_left_alone(page):
    assert last_in(page) != "refuted"
