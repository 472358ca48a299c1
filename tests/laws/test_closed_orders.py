"""Relations that cannot be together are refuted, though each alone only states where letters lie."""

from __future__ import annotations

import pytest

from tests.checked_pages import last_verdict

SYMBOLS = (
    '[symbols]\n"r" = "crank radius"\n"l" = "rod length"\n"omega" = "angular speed"\n"x" = "a number"\n'
    '"y" = "a number"\n"z" = "a number"\n"u" = "a number"\n"w" = "a number"\n"n" = "a number"\n'
)
WRONG = [
    "$$p = q = t - 3 = p + 2$$",
    "Es gilt $u > w = u$.",
    "$$x = y < z = x$$",
    "$$0 < x < y < 1 < x$$",
    "$$x = y$$ $$y < z$$ $$z = x$$",
    r"$$x \le y,\; y \le x$$ hence $$x < y$$",
    r"$x \geq y$, hence $x > y$.",
    r"$$x \ge y \Rightarrow x > y$$",
    "$x < y$, hence $x z < y z$.",
    "For all $y > 0$ we have $$y^2 > y$$",
    r"For every $n \ge 1$, $$2^n > n^2$$",
    "Für alle $y > 0$ gilt $y^2 > y$.",
    "Pour tout $x > 1$, $x^2 > 2x$.",
    "すべての $y > 0$ について $y^2 > y$ が成り立つ。",
    "$$y < 0$$ $$|y| = 3$$ $$y = 3$$",
    "With $u < 0$ and $|u| = 2$ we get $u = 2$.",
]
RIGHT = [
    "$$p = q = t - 3$$",
    "Es gilt $u > w$.",
    "$x > y$, $y > z$ und $x > z$.",
    r"$x \le y$ et $y \le z$, donc $x \le z$.",
    r"$$x \le y,\; y \le x$$",
    r"$x > y$, hence $x \geq y$.",
    r"$r < l$, hence $r\omega < l\omega$.",
    "For all $y > 1$ we have $$y^2 > y$$",
    "For every $n > 4$, $$2^n > n^2$$",
    "For all $x > 0$ we take $y > x$.",
    "If $x < y$, the engine runs. If $y < x$, it stalls.",
    "$$|y| = 3$$ $$y = -3$$",
    "$$y < 0$$ $$|y| = 3$$ $$y = -3$$",
]


@pytest.mark.parametrize("page", WRONG)
def test_what_cannot_be_together_does_not_pass(tmp_path, page):
    assert last_verdict(tmp_path, page, SYMBOLS) in ("refuted", "undecided", "contradiction")


@pytest.mark.parametrize("page", RIGHT)
def test_what_can_be_stays(tmp_path, page):
    assert last_verdict(tmp_path, page, SYMBOLS) not in ("refuted", "undecided", "contradiction")
