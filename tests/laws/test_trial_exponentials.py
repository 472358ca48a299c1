"""x = e^{st} may be tried in an equation of motion: its amplitude cancels."""

import pytest

from tests.checked_pages import last_in

LEAD = "The displacement is $x = 3$ mm at first; $m\\ddot x + c\\dot x + k x = 0$.\n\n"


@pytest.mark.parametrize("page", ["Let us try $x = e^{st}$.", "解を $x = e^{st}$ とおくと"])
def test_a_trial_is_given(page):
    assert last_in(LEAD + page) != "refuted"


def test_dimensions_are_judged_where_nothing_is_tried():
    assert last_in(LEAD + "Hence the largest displacement is $x = e^{st}$.") == "refuted"
