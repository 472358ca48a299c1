r"""A bar over a formula of a turning angle is its mean over a turn, on a page with i the conjugate."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check
from symbalance.notes.checking.verdicts import DEFINITION, PROVED_WORDS, REFUTED

RIGHT = [
    r"\overline{\sin^2\varphi} = \frac12",
    r"\overline{\left(\sin\psi+\tfrac{\lambda}{2}\sin 2\psi\right)^2} = \frac12+\frac{\lambda^2}{8}",
    r"\overline{\left(\cos\theta+\lambda\cos 2\theta\right)^2} = \frac12+\frac{\lambda^2}{2}",
    r"\bar{\sin\alpha} = 0",
    r"\overline{\sin\psi\cos\psi} = 0",
    r"\overline{\cos^2\omega t} = \frac12",
    r"r^2\omega^2\,\overline{\sin^2\phi} = \frac{r^2\omega^2}{2}",
]
WRONG = [
    r"\overline{\sin^2\varphi} = \frac14",
    r"\overline{\left(\sin\psi+\tfrac{\lambda}{2}\sin 2\psi\right)^2} = \frac12+\frac{\lambda^2}{4}",
    r"\overline{\left(\cos\theta+\lambda\cos 2\theta\right)^2} = 1+\lambda^2",
    r"\overline{\sin\psi\cos\psi} = \frac12",
    r"\overline{\cos^2\omega t} = 1",
    r"r^2\omega^2\,\overline{\sin^2\phi} = r^2\omega^2",
]
LEADS = [
    "The mean over a revolution is",
    "括弧内の二乗平均は",
    "Im Mittel ist",
    "La moyenne sur un tour est",
    "La media è",
]


def last(page: str) -> str:
    return max(check(page, {}).verdicts, key=lambda v: (v.line, v.span)).verdict


@pytest.mark.parametrize("formula", RIGHT)
@pytest.mark.parametrize("lead", LEADS[:2])
def test_a_mean_over_a_turn_holds(lead, formula):
    assert last(f"{lead}\n\n$${formula}$$\n") in PROVED_WORDS


@pytest.mark.parametrize("formula", WRONG)
def test_another_mean_is_refuted(formula):
    assert last(f"So\n\n$${formula}$$\n") == REFUTED


@pytest.mark.parametrize("lead", LEADS)
def test_the_mean_of_a_square_is_that_of_its_formula_where_words_call_it_a_mean(lead):
    page = f"$v = r\\omega\\sin\\varphi$.\n\n{lead}\n\n"
    page += "$$\\overline{v^2} = \\frac{r^2\\omega^2}{VALUE}$$\n"
    assert last(page.replace("VALUE", "2")) in PROVED_WORDS
    assert last(page.replace("VALUE", "4")) == REFUTED


def test_on_a_page_with_i_a_bar_is_the_conjugate():
    page = "With $z = r e^{i\\varphi}$\n\n$$\\overline{r e^{i\\varphi}} = r e^{-i\\varphi}$$\n\n"
    formula = "$$\\overline{\\cos\\varphi + i\\sin\\varphi} = \\cos\\varphi SIGN i\\sin\\varphi$$\n"
    assert last(page + formula.replace("SIGN", "-")) in PROVED_WORDS
    assert last(page + formula.replace("SIGN", "+")) == REFUTED


def test_a_mean_of_half_orders_is_left_alone():
    assert last("$$\\overline{\\sin\\frac{\\varphi}{2}} = \\frac{2}{\\pi}$$\n") not in (
        REFUTED,
        DEFINITION,
    )
