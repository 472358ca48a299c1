"""Letters as coefficients of a series, against integrals over a turn by mpmath's quadrature."""

from __future__ import annotations

from fractions import Fraction

import mpmath
import pytest

from symbalance.notes.algebra.domain import Domain
from symbalance.notes.algebra.evaluation import FormEvaluator
from symbalance.notes.algebra.means import mean
from symbalance.notes.algebra.values import value
from symbalance.notes.checking import check
from symbalance.notes.checking.verdicts import PROVED_WORDS, REFUTED
from symbalance.notes.reading import read_equation

SYMBOLS = {"theta": "crank angle", "lambda": "crank ratio r/l"}
FUNCTIONS = {
    "\\sqrt{1-\\lambda^2\\sin^2\\theta}": lambda x, k: mpmath.sqrt(1 - (k * mpmath.sin(x)) ** 2),
    "\\frac{\\sin\\theta\\cos\\theta}{\\sqrt{1-\\lambda^2\\sin^2\\theta}}": lambda x, k: (
        mpmath.sin(x) * mpmath.cos(x) / mpmath.sqrt(1 - (k * mpmath.sin(x)) ** 2)
    ),
    "\\frac{1}{1-\\lambda\\cos\\theta}": lambda x, k: 1 / (1 - k * mpmath.cos(x)),
}


def coefficient(function, kind: str, order: int, ratio: float) -> mpmath.mpf:
    wave = getattr(mpmath, kind)
    turn = [0, mpmath.pi, 2 * mpmath.pi]
    whole = mpmath.quad(lambda x: function(x, ratio) * wave(order * x), turn) / mpmath.pi
    return whole if order else whole / 2


@pytest.mark.slow
@pytest.mark.parametrize("text", FUNCTIONS, ids=range(len(FUNCTIONS)))
@pytest.mark.parametrize("order", [0, 1, 2, 4])
def test_a_number_for_a_coefficient_is_judged_by_the_integral(text, order):
    kind = "sin" if text.startswith("\\frac{\\sin") else "cos"
    orders = dict.fromkeys((0, 1, 2, 4) if kind == "cos" else (1, 2, 4))
    series = " + ".join(f"B_{k}\\{kind} {k}\\theta" if k else "B_0" for k in orders)
    if order not in orders:
        return
    exact = coefficient(FUNCTIONS[text], kind, order, 0.3)
    for off, words in ((0, PROVED_WORDS), (0.0003, (REFUTED,)), (-0.0003, (REFUTED,))):
        claim = f"For $\\lambda = 0.3$\n\n$$B_{order} = {float(exact) + off:.5f}$$\n"
        page = f"$${text} = {series} + \\dots$$\n\n{claim}"
        checked = check(page, SYMBOLS)
        assert checked.verdicts[-1].verdict in words, (page, checked.verdicts[-1].reason)


@pytest.mark.parametrize("text", FUNCTIONS, ids=range(len(FUNCTIONS)))
def test_a_mean_is_the_integral_over_a_turn(text):
    domain = Domain()
    side = read_equation(f"y = {text}", frozenset({"y", *SYMBOLS})).sides[1].node
    form = FormEvaluator(domain).form(side)
    wave = FormEvaluator(domain).form(
        read_equation("y = \\cos 2\\theta", frozenset({"y", *SYMBOLS})).sides[1].node
    )
    by_mean = value(mean(form.times(wave), domain.symbol("theta")), {"lambda": Fraction(2, 5)})
    assert abs(by_mean.real - coefficient(FUNCTIONS[text], "cos", 2, 0.4) / 2) < 1e-12
