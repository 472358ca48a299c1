"""Where words place a zero, a pole or an extreme of a formula, the formula has one, or it is wrong."""

from __future__ import annotations

import pytest

from tests.checked_pages import verdicts_of

WRONG = [
    "$y = x^2 - 4$ vanishes at $x = 2$ and $x = 3$.",
    "$y = x^2 - 4$ vanishes at $x = 3$.",
    "The function $y = x^2 - 4x$ has its minimum at $x = 4$ with $y = 0$.",
    "The function $y = x^2 - 4x$ has a maximum at $x = 2$.",
    r"The pole of $\frac{1}{x-1}$ is at $x = -1$.",
    r"$f(x) = \frac{1}{x-1}$, defined for $x \ne -1$.",
    r"$f(x) = \frac{1}{x-1}$ has a pole at $x = 2$.",
    "Die Funktion $y = x^3 - 3x$ hat ein Maximum bei $x = 1$.",
    "La fonction $y = x^2 - 2$ s'annule pour $x = 1.52$.",
    r"$y = \sin x$ vanishes at $x = \pi/2$.",
    "The zeros of $x^2 - 9$ are at $x = 3$ and $x = -4$.",
]
RIGHT = [
    "$y = x^2 - 4$ vanishes at $x = 2$ and $x = -2$.",
    "The function $y = x^2 - 4x$ has its minimum at $x = 2$ with $y = -4$.",
    r"The pole of $\frac{1}{x-1}$ is at $x = 1$.",
    r"$f(x) = \frac{1}{x-1}$, defined for $x \ne 1$.",
    "Die Funktion $y = x^3 - 3x$ hat ein Maximum bei $x = -1$ und ein Minimum bei $x = 1$.",
    "La fonction $y = x^2 - 2$ s'annule pour $x = 1.41$.",
    r"$y = \sin x$ vanishes at $x = \pi$.",
    "$y = x^2 - 4$ does not vanish at $x = 3$.",
    r"For $0 \le x \le 4$ the function $y = x^2 - 4x$ has its maximum at $x = 4$.",
    "$y = x^4$ has its minimum at $x = 0$.",
]


@pytest.mark.parametrize("page", WRONG)
def test_wrong_places_are_refuted(tmp_path, page):
    assert "refuted" in verdicts_of(tmp_path, page)


@pytest.mark.parametrize("page", RIGHT)
def test_right_places_are_not(tmp_path, page):
    assert not {"refuted", "contradiction"} & {*verdicts_of(tmp_path, page)}
