"""What is said of all whole numbers has to hold for each of them."""

import pytest

from symbalance.notes.checking.verdicts import PROVED_WORDS
from tests.checked_pages import last_verdict

COSINES = r"$\int_0^{2\pi}\cos m\theta\cos n\theta\,d\theta = 0$"
ROOTS = r"$\sum_{k=0}^{N-1} e^{2\pi i k n/N} = 0$"
SQUARES = r"$\frac1\pi\int_0^{2\pi}\cos^2 n\theta\,d\theta = 1$"
WRONG = [
    f"{COSINES} for all integers $m$, $n$.",
    f"{COSINES} für alle ganzen Zahlen $m$ und $n$.",
    f"{ROOTS} for all integers $n$.",
    f"For every integer $n$ {ROOTS}.",
    f"For $n = 0, 1, 2, \\dots$: {SQUARES}.",
    f"Für alle ganzen Zahlen $n$ gilt {SQUARES}.",
    f"すべての整数 $n$ に対して {SQUARES}",
]
RIGHT = [
    f"{COSINES} for all different integers $m$, $n$.",
    f"{COSINES}.",
    r"$\int_0^{2\pi}\cos m\theta\sin n\theta\,d\theta = 0$ for all integers $m$, $n$.",
    f"For every integer $n$ that is no multiple of $N$, {ROOTS}.",
    f"For $n = 1, 2, \\dots$: {SQUARES}.",
]


@pytest.mark.parametrize("page", WRONG)
def test_what_fails_for_one_of_all_is_refuted(tmp_path, page):
    assert last_verdict(tmp_path, page) == "refuted"


@pytest.mark.parametrize("page", RIGHT)
def test_what_holds_for_all_that_are_meant_is_not(tmp_path, page):
    assert last_verdict(tmp_path, page) in PROVED_WORDS
