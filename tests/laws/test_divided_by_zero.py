r"""What is true by leaving a factor out is not where the factor is zero: x/x with x = 0."""

import pytest

from symbalance.checking import check

PROVED = {"holds", "conditional", "holds_to_order"}


@pytest.mark.parametrize(
    ("given", "claim"),
    [
        ("If $x = 0$, then", "$\\frac{x}{x} = 1$"),
        ("Let $D = 0$.", "$\\frac{D}{D} = 1$"),
        ("Let $a = 3$ and $b = 3$.", "$\\frac{a^2 - b^2}{a - b} = a + b$"),
        ("Sei $q = 1$.", "$\\frac{1 - q^2}{1 - q} = 1 + q$"),
        ("For $\\theta = 0$:", "$\\frac{\\sin 2\\theta}{\\sin\\theta} = 2\\cos\\theta$"),
    ],
)
def test_a_fraction_of_zeros_is_open(given, claim):
    last = check(f"{given} {claim}.").verdicts[-1]
    assert last.verdict not in PROVED


@pytest.mark.parametrize(
    ("given", "claim"),
    [
        ("If $x = 2$, then", "$\\frac{x}{x} = 1$"),
        ("Let $a = 4$ and $b = 3$.", "$\\frac{a^2 - b^2}{a - b} = a + b$"),
        ("We have", "$\\frac{1 - q^2}{1 - q} = 1 + q$"),
        ("For $\\theta = 0$:", "$\\frac{\\sin 2\\theta}{\\cos\\theta} = 2\\sin\\theta$"),
        ("Let $D = 0$.", "$\\frac{D}{1 + D} = 0$"),
    ],
)
def test_any_other_is_not(given, claim):
    assert check(f"{given} {claim}.").verdicts[-1].verdict in PROVED
