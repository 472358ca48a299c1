"""An equation that is squared is to be solved by what follows; a candidate beside an "or" is open."""

from __future__ import annotations

import pytest

from tests.checked_pages import verdicts_of

SQUARED = r"$\sqrt{x+1} = x - 1 \Rightarrow x + 1 = (x-1)^2 \Rightarrow "
RIGHT = [
    SQUARED + "x = 0$ or $x = 3$. Only $x = 3$ is a solution.",
    SQUARED + r"x^2 - 3x = 0 \Rightarrow x = 0$ or $x = 3$.",
    r"$\sqrt{x+1} = x - 1$, daher $x + 1 = (x-1)^2$, somit $x = 0$ oder $x = 3$.",
    r"$\sqrt{2x+3} = x \Rightarrow 2x+3 = x^2 \Rightarrow x = 3$.",
    r"$\frac{1}{x-1} = \frac{2}{x+1} \Rightarrow x + 1 = 2(x-1) \Rightarrow x = 3$.",
]
WRONG = [
    SQUARED + "x = 0$ or $x = 4$.",
    r"$\sqrt{2x+3} = x \Rightarrow 2x+3 = x^2 \Rightarrow x = 2$.",
    r"$\frac{1}{x-1} = \frac{2}{x+1} \Rightarrow x + 1 = 2(x-1) \Rightarrow x = 4$.",
    r"$(x+1)^2 = x^2 + 2x + 2 \Rightarrow x^2+2x+1 = x^2 + 2x + 2$",
    r"$x + 1 = x + 2 \Rightarrow x + 3 = x + 4 \Rightarrow x = 5$.",
]


@pytest.mark.parametrize("page", RIGHT)
def test_nothing_right_is_refuted(tmp_path, page):
    assert not {"refuted", "contradiction"} & {*verdicts_of(tmp_path, page)}


@pytest.mark.parametrize("page", WRONG)
def test_what_is_wrong_is_refuted(tmp_path, page):
    assert {"refuted", "contradiction"} & {*verdicts_of(tmp_path, page)}


def test_only_the_root_that_solves_it_holds(tmp_path):
    wrong = verdicts_of(tmp_path, SQUARED + "x = 0$ or $x = 3$. Only $x = 0$ is a solution.")
    assert wrong[-1] not in ("holds", "holds_to_order", "conditional")
