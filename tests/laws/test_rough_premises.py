"""What a rough line alone makes true holds if that line is exact; it refutes and proves no inequality."""

import pytest

from tests.checked_pages import last_verdict

LETTERS = '[symbols]\n"x" = "variable"\n"y" = "variable"\n'
BY_ROUGH_LINES = (
    "$$x \\approx y$$\n\nHence exactly\n\n$$x - y = 0$$",
    "Es gilt $u \\sim 2 v$. Daher ist $u/v = 2$.",
    "On a $u \\simeq v + w$. Donc $u - v = w$.",
    "$u ≃ v^2$ である。よって $u/v^2 = 1$。",
    "$u - v \\approx w$. Therefore $u = v + w$.",
    "We find $x \\approx 3$. So $x^2 = 9$ exactly.",
)
BY_EXACT_LINES = (
    "We have $u = v + w$. Hence $u - v = w$.",
    "We have $u \\approx v + w$. Hence $(u+1)^2 = u^2 + 2u + 1$.",
    "We have $x \\approx y$. Hence $x - y \\approx 0$.",
)
OPEN = (
    "We have $x \\approx y$, but $x \\ne y$.",
    "$$x \\approx y$$\n\n$$x \\le y$$",
)


@pytest.mark.parametrize("page", BY_ROUGH_LINES)
def test_what_follows_from_a_rough_line_rests_on_it(tmp_path, page):
    assert last_verdict(tmp_path, page, LETTERS) == "conditional"


@pytest.mark.parametrize("page", BY_EXACT_LINES)
def test_what_needs_no_rough_line_holds(tmp_path, page):
    assert last_verdict(tmp_path, page, LETTERS) == "holds"


@pytest.mark.parametrize("page", OPEN)
def test_a_rough_line_decides_no_inequality(tmp_path, page):
    assert last_verdict(tmp_path, page, LETTERS) == "range"


def test_an_angle_is_congruent_to_what_is_whole_turns_away_and_not_equal(tmp_path):
    page = "$\\theta = 400°$, $\\theta \\equiv 40°$"
    assert last_verdict(tmp_path, page) == "holds"
    assert last_verdict(tmp_path, page + ", $\\sin\\theta = \\sin 40°$") == "holds"
    assert last_verdict(tmp_path, page + " so $\\theta = 40°$") != "holds"
