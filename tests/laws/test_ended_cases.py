"""What a case gives its letters proves nothing where words turn to its opposite, or to every case."""

from __future__ import annotations

import pytest

from tests.checked_pages import last_verdict

SYMBOLS = (
    '[symbols]\n"x" = "a number"\n"y" = "a number"\n"k" = "a number"\n"u" = "a number"\n'
    '"n" = "an integer"\n"lambda" = "crank ratio r/l"\n"theta" = "crank angle"\n'
)
WRONG = [
    "If $x = 2$, $$x^2 = 4$$ otherwise $$x^2 = 4$$",
    "Für $k = 3$ ist $k^2 = 9$, sonst ist $k^2 = 9$.",
    "Si $u = 5$, alors $u + 1 = 6$ ; sinon $u + 1 = 6$.",
    "$u = 5$ ならば $u + 1 = 6$、そうでなければ $u + 1 = 6$。",
    "For $k = 3$ we get $k^2 = 9$. Without this assumption $k^2 = 9$.",
    "For $x = 2$ $$x^2 = 4$$ In general $$x^2 = 4$$",
    r"Bei $\lambda = 0$ gilt $\lambda + \cos\theta = \cos\theta$, "
    r"im Allgemeinen $\lambda + \cos\theta = \cos\theta$",
    r"For $x = 2$ $$y = x^2 = 4$$ for $x \ne 2$ $$y = 4$$",
    r"Suppose $x = 2$. Then $$x^2 = 4$$ So $x \ne 2$ and $$x^2 = 4$$",
    "If $x = 2$, then $x^2 = 4$. If $x > 2$, then $x^2 = 4$.",
    "For $k = 3$: $k^2 = 9$. For $k < 3$: $k^2 = 9$.",
    "If $x$ were 2, i.e. if $x = 2$ were true, $x + 1 = 3$. In fact $x + 1 = 3$.",
    "Unless $n$ is odd, $$(-1)^n = -1$$",
    r"Bei $\theta = 90°$ ist $\sin\theta = 1$. Sonst ist $\sin\theta < 0.5$.",
]
RIGHT = [
    "If $x = 2$, then $x^2 = 4$ and $x^3 = 8$.",
    r"If $x = 2$, then $x^2 = 4$. Otherwise $x^2 = x \cdot x$.",
    "If $x = 2$, then $x^2 = 4$. Otherwise $x = 3$ and $x^2 = 9$.",
    "Take $k = 3$. Then $k^2 = 9$. Otherwise said, $k + 1 = 4$.",
    "In general $(x+1)^2 = x^2 + 2x + 1$; for $x = 2$ $(x+1)^2 = 9$.",
    r"For $x = 2$ $$y = x^2 = 4$$ for $x \ne 2$ $$y = x^2$$",
    "Für $k = 3$ ist $k^2 = 9$, für $k = 4$ ist $k^2 = 16$.",
    "If $n$ is odd, $(-1)^n = -1$.",
    r"The crank has $r = 40$ mm. If it were $r = 50$ mm, it would be too long. "
    r"We have $2 r = 80\,\mathrm{mm}$",
    r"At $\theta = 60°$ it is $2\cos\theta = 1$. For $\theta < 90°$ it is positive. "
    r"Then $4\cos\theta = 2$.",
    "Wäre $x = 2$, so wäre $2x = 4$. Dann wäre auch $3x = 6$.",
    "Unless $n$ is odd, $(-1)^n = 1$.",
]


@pytest.mark.parametrize("page", WRONG)
def test_the_case_before_does_not_prove_it(tmp_path, page):
    assert last_verdict(tmp_path, page, SYMBOLS) in ("refuted", "undecided", "contradiction")


@pytest.mark.parametrize("page", RIGHT)
def test_what_is_right_there_is_proved(tmp_path, page):
    assert last_verdict(tmp_path, page, SYMBOLS) in ("holds", "holds_to_order", "conditional")
