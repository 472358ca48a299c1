"""No angle has a sine or cosine beyond 1, whatever equation it is a root of."""

import pytest

from symbalance.notes.checking.verdicts import PROVED_WORDS
from tests.checked_pages import last_verdict

PLACE = (
    "With $\\lambda = 0.25$ the velocity is greatest where "
    "$\\cos\\theta + \\lambda\\cos 2\\theta = 0$:\n\n"
)
WRONG = [
    r"$\cos\alpha = 1.5$",
    r"$\sin\alpha = 3 - \sqrt 2$",
]


@pytest.mark.parametrize("page", WRONG)
def test_a_cosine_beyond_one_is_refuted(tmp_path, page):
    assert last_verdict(tmp_path, page) == "refuted"


def test_one_of_two_roots_is_not_accused_and_does_not_hold(tmp_path):
    page = r"$\cos\theta = \sqrt{3} - 1$ and $\cos\theta = -1 - \sqrt{3}$. Only the first one counts."
    assert last_verdict(tmp_path, page) == "undecided"


def test_a_formula_that_is_beyond_one_by_numbers_above_does_not_hold(tmp_path):
    page = PLACE + r"$\cos\theta = \frac{-1 - \sqrt{1+8\lambda^2}}{4\lambda}$"
    assert last_verdict(tmp_path, page) == "undecided"


def test_the_root_within_stays(tmp_path):
    page = PLACE + r"$\cos\theta = \frac{-1 + \sqrt{1+8\lambda^2}}{4\lambda}$"
    assert last_verdict(tmp_path, page) in PROVED_WORDS
    assert last_verdict(tmp_path, r"The case $\cos\theta = 1.5$ is impossible.") != "refuted"
    assert last_verdict(tmp_path, r"$\lambda = 1.2$, $\sin\beta = \lambda\sin\theta$") != "refuted"
