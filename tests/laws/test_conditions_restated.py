"""An equation that restates the condition before it is a condition, and its tangent a solution."""

import pytest

from tests.checked_pages import verdicts_in

PAGE = r"""$$T(\theta) = 1800 + 900\sin 2\theta - 480\cos 2\theta$$

The mean is $T_m = 1800$. The curves cross where $T(\theta) = T_m$, i.e.

$$SINES, \qquad \tan 2\theta = \frac{480}{900} = 0.533$$
"""


def test_a_condition_once_more_is_no_claim():
    assert verdicts_in(PAGE.replace("SINES", r"900\sin 2\theta = 480\cos 2\theta"))[3] == "condition"
    assert verdicts_in(PAGE.replace("SINES", r"900\sin 2\theta = 440\cos 2\theta"))[3] == "refuted"


@pytest.mark.parametrize(
    "page",
    [
        "$$y < 0$$ $$|y| = 3$$ $$y = 3$$",
        "θ is obtuse with sin θ = 0.6, so cos θ = 0.8.",
        "$$x^2 = 4 ⇔ x = 2$$",
    ],
)
def test_one_solution_of_two_is_not_the_condition_again(page):
    assert verdicts_in(page)[-1] in ("refuted", "contradiction")
