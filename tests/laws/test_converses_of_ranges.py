"""An inequality that is equivalent to a double one is asked of both its halves: |x| < 2 ⇔ -2 < x < 2."""

from __future__ import annotations

import pytest

from tests.checked_pages import verdicts_of

RIGHT = [
    r"$|x|<2 \iff -2 < x < 2$",
    r"$x^2 < 4 \iff -2 < x < 2$",
    r"$x^2 \le 9 \iff -3 \le x \le 3$",
    r"$|x-1|<2 \iff -1 < x < 3$",
    r"$x^2 - 5x + 6 < 0 \iff 2 < x < 3$",
    r"$x^2 > 4 \iff x > 2$ or $x < -2$",
]
WRONG = [
    r"$|x|<2 \iff -3 < x < 2$",
    r"$|x|<2 \iff -2 < x < 3$",
    r"$|x-1|<2 \iff -1 < x < 4$",
    r"$|x|<2 \iff -2 < x < 1$",
    r"$x^2 - 5x + 6 < 0 \Leftrightarrow 2 < x < 4$",
]


@pytest.mark.parametrize("page", RIGHT)
def test_right_ones_are_not_refuted(tmp_path, page):
    assert not {"refuted", "contradiction"} & {*verdicts_of(tmp_path, page)}


@pytest.mark.parametrize("page", WRONG)
def test_wrong_ones_are_refuted(tmp_path, page):
    assert "refuted" in verdicts_of(tmp_path, page)
