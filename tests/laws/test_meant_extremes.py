"""Largest values of motions that only words name are judged: ẋ_max is r ω (1 + λ²/2), not r ω (1 + λ)."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check
from symbalance.notes.checking.verdicts import CONDITIONAL, DEFINITION, REFUTED, UNDECIDED

PAGE = r"""Crank radius $r$, rod length $l$, crank angle $\theta = \omega t$, angular speed $\omega$,
$\lambda = r/l$.

The displacement of the piston from top dead centre is
$x = r(1-\cos\theta)+l(1-\sqrt{1-\lambda^2\sin^2\theta})$.

The piston velocity is $v \approx r\omega(\sin\theta+\frac{\lambda}{2}\sin 2\theta)$ and the piston
acceleration is $a \approx r\omega^2(\cos\theta+\lambda\cos 2\theta)$. Then

$$%s$$
"""
RIGHT = [
    r"\dot x_{max} \approx r\omega(1+\lambda^2/2)", r"v_{max} \approx r\omega(1+\frac{\lambda^2}{2})",
    r"v_{max} \approx r\omega\sqrt{1+\lambda^2}", r"a_{max} = r\omega^2(1+\lambda)",
    r"\ddot x_{max} = r\omega^2(1+\lambda)", r"x_{max} = 2r",
]  # fmt: skip
WRONG = [
    r"\dot x_{max} \approx r\omega(1+\lambda)", r"v_{max} \approx r\omega(1+\lambda)",
    r"v_{max} \approx 2r\omega", r"a_{max} = r\omega^2(1+\lambda^2)", r"a_{max} = r\omega^2(1+2\lambda)",
    r"x_{max} = r",
]  # fmt: skip
OPEN = [r"v_{max} = 30", r"v_{max} = \frac{p}{q}", r"u_{max} = r\omega(1+\lambda)", r"F_{max} = p A"]


def verdict_on(line: str):
    checked = check(PAGE % line, {})
    assert not checked.faults
    return checked.verdicts[-1]


@pytest.mark.parametrize("line", RIGHT)
def test_a_right_extreme_holds_for_what_the_words_name(line):
    verdict = verdict_on(line)
    assert verdict.verdict == CONDITIONAL
    assert "nobody declared it" in verdict.assumption


@pytest.mark.parametrize("line", WRONG)
def test_a_wrong_extreme_is_refuted_with_the_same_assumption(line):
    verdict = verdict_on(line)
    assert verdict.verdict == REFUTED
    assert "nobody declared it" in verdict.reason


@pytest.mark.parametrize("line", OPEN)
def test_other_extremes_stay_definitions(line):
    assert verdict_on(line).verdict == DEFINITION


@pytest.mark.parametrize("letter", ["a", "q"])
@pytest.mark.parametrize(
    "words", ["The largest acceleration is", "Peak acceleration:", "größte Beschleunigung"]
)
def test_a_declared_motion_has_the_largest_value_that_words_give_it(letter, words):
    page = f"$\\lambda = r/L$, rod length $L$.\n\n{words} ${letter} = r\\omega^2(@)$."
    declared = {"symbols": {letter: "piston acceleration"}}
    right = check(page.replace("@", "1+\\lambda"), declared).verdicts[-1]
    assert (right.verdict, "nobody" in right.assumption) == (CONDITIONAL, False)
    for wrong in ("1-\\lambda", "1+2\\lambda", "2+\\lambda"):
        assert check(page.replace("@", wrong), declared).verdicts[-1].verdict in (UNDECIDED, REFUTED)
