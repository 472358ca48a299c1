"""Whole results put in for a formula of rounded angles are rounded themselves."""

import pytest

from tests.checked_pages import verdicts_in

PAGE = r"""$\theta_1 = 18.43^\circ$, $\theta_2 = 108.43^\circ$.
$$ \Bigl[-4000\cos 2\theta - 3000\sin 2\theta\Bigr]_{\theta_1}^{\theta_2} = VALUE $$
"""


@pytest.mark.parametrize("right", ["5000 - (-5000)", "5000 + 5000", "10000"])
def test_a_difference_of_two_results(right):
    assert verdicts_in(PAGE.replace("VALUE", right))[-1] == "holds_to_order"


@pytest.mark.parametrize("wrong", ["5000 - 5000", "5000 - (-4000)", "5001 - (-5000)", "9000"])
def test_a_wrong_difference_is_not_proved(wrong):
    assert verdicts_in(PAGE.replace("VALUE", wrong))[-1] in ("refuted", "undecided")
