"""What a case gives its letters proves nothing where words turn to its opposite, or to every case."""

from __future__ import annotations

import pytest

from symbalance.checking import check
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


EQUAL = [
    "If $m_1 = m_2$, then $m_1 + m_2 = 2 m_1$.\n{} $m_1 + m_2 = 2m_1$.",
    "For $m_1 = m_2$ we have $m_1 + m_2 = 2 m_1$.\n\n{} $m_1 + m_2 = 2m_1$.",
    "Für $m_1 = m_2$ gilt $m_1 + m_2 = 2 m_1$. {} $m_1 + m_2 = 2m_1$.",
]
LEFT = [
    "In general", "Otherwise", "For unequal masses", "If the masses are different,", "Im Allgemeinen",
    "Sonst", "Bei verschiedenen Massen", "Sinon", "En général",
]  # fmt: skip
GOES_ON = ["Therefore", "So", "Also", "That is, with equal masses", "Damit wird"]


@pytest.mark.parametrize("page", EQUAL)
@pytest.mark.parametrize("words", LEFT)
def test_a_case_of_two_equal_letters_ends_with_its_opposite(page, words):
    last = check(page.format(words)).verdicts[-1]
    assert last.verdict not in {"holds", "conditional", "holds_to_order"}


@pytest.mark.parametrize("page", EQUAL)
@pytest.mark.parametrize("words", GOES_ON)
def test_it_goes_on_otherwise(page, words):
    assert check(page.format(words)).verdicts[-1].verdict == "conditional"


@pytest.mark.parametrize(
    "page",
    [
        "## Equal discs\n\n$J_1 = J_2$: $J_1 + J_2 = 2J_1$.\n\n## Different discs\n\n$J_1 + J_2 = 2J_1$.",
        "Case 1. $a = b$: $a^2 - b^2 = 0$.\nCase 2. $a > b$: $a^2 - b^2 = 0$.",
        "Fall 1: $a = b$, also $a^2 - b^2 = 0$.\n\nFall 2: $a > b$, also $a^2 - b^2 = 0$.",
        "Without damping, $D = 0$, $\\sqrt{1 - D^2} = 1$. With damping $\\sqrt{1-D^2} = 1$.",
        "Ohne Dämpfung, $D = 0$, ist $\\sqrt{1 - D^2} = 1$. Mit Dämpfung ist $\\sqrt{1-D^2} = 1$.",
        "A long rod, for $k = 0$: $1 + k = 1$. For a rod of finite length $1 + k = 1$.",
    ],
)
def test_so_do_titles_numbered_cases_and_what_is_zero(page):
    last = check(page).verdicts[-1]
    assert last.verdict not in {"holds", "conditional", "holds_to_order"}


@pytest.mark.parametrize(
    "page",
    [
        "Case 1. $a = b$: $a^2 - b^2 = 0$.\nHere $a^3 - b^3 = 0$.",
        "## Equal discs\n\n$J_1 = J_2$: $J_1 + J_2 = 2J_1$.\n\nTherefore $J_1 + J_2 = 2J_2$.",
        "Without damping, $D = 0$, $\\sqrt{1 - D^2} = 1$. With this $\\sqrt{1+D^2} = 1$.",
    ],
)
def test_within_its_case_it_holds(page):
    assert check(page).verdicts[-1].verdict in {"holds", "conditional"}
