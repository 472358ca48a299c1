"""The order of a force in brackets above its letter, F_x^{(2)}: another letter, and no square of F_x."""

from __future__ import annotations

import pytest

import symbalance as sb
from symbalance.checking import check
from symbalance.notes.checking.verdicts import DEFINITION, HOLDS, REFUTED
from symbalance.notes.reading import read_expression

FIRST = r"""The crank angle is $\theta$.

$$F_x = F_0\cos\alpha[\cos(\theta-\alpha) + \cos(\theta+\alpha)]$$

$$F_x^{(2)} = \lambda F_0\cos\alpha[\cos 2(\theta-\alpha) + \cos 2(\theta+\alpha)]$$

"""


def verdicts(page: str) -> list[str]:
    checked = sb.check(page + "\n", {})
    assert not checked.faults
    return [v.verdict for v in sorted(checked.verdicts, key=lambda v: (v.line, v.span))]


@pytest.mark.parametrize("written", ["F_x^{(2)}", "F_{x}^{(2)}", "F^{(2)}_x", r"F_x^{\left(2\right)}"])
def test_a_known_letter_with_an_order_is_its_own_letter(written):
    (node, *_) = read_expression(written, frozenset({"F_x", "F_x,(2)"}))
    assert node.name == "F_x,(2)"


def test_a_square_stays_a_square():
    for written in ("F_x^2", "F_x^{2}", "(F_x)^{(2)}"):
        (node, *_) = read_expression(written, frozenset({"F_x"}))
        assert node.exponent.value == 2


def test_the_second_order_does_not_contradict_the_first():
    assert verdicts(FIRST) == [DEFINITION, DEFINITION]
    right = r"$$F_x^{(2)} = 2\lambda F_0\cos\alpha\cos 2\alpha\cos 2\theta$$"
    wrong = r"$$F_x^{(2)} = 2\lambda F_0\cos\alpha\sin 2\alpha\cos 2\theta$$"
    assert verdicts(FIRST + right)[-1] == HOLDS
    assert verdicts(FIRST + wrong)[-1] == REFUTED


@pytest.mark.parametrize("words", ["The first-order force is", "The second order of the force is"])
@pytest.mark.parametrize("letter", ["\\varphi", "\\theta", "\\alpha"])
def test_a_sum_of_two_orders_is_none_of_them(words, letter):
    page = "A single cylinder, $\\lambda = r/l$, crank angle $@$, $F_0 = m r\\omega^2$.\n\n"
    page += words + " $F_x = F_0(\\cos @ + \\lambda\\cos 2@)$.\n"
    verdict = check(page.replace("@", letter)).verdicts[-1]
    assert "is order" not in verdict.assumption
