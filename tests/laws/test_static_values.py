"""What a letter is at rest is not what it is in an equation of motion: y = F/k, then m ÿ + k y = 0."""

import pytest

import symbalance as sb

SPRING = "$k = 40000$ N/m. The deflection is $y = \\frac{F}{k}$.\n\n"
SHAFT = (
    "The twist of the shaft is $\\varphi = \\frac{T\\ell}{GJ}$, so $k = \\frac{GJ}{\\ell}$ with "
    "$J = \\frac{\\pi d^4}{32}$.\n\nEquation of motion: $I\\ddot\\varphi + k\\varphi = 0$.\n\n"
)


def _last(page):
    return sb.check(page, {}).data()["links"][-1]["verdict"]


@pytest.mark.parametrize(
    ("line", "verdict"),
    [
        ("Then $F = 600$ N.", "definition"),
        ("$F = 600$ N, so $2F = 1200$ N.", "holds"),
        ("$F = 600$ N, so $2F = 1300$ N.", "refuted"),
        ("$F = 600$ N, so $y = 0.015$ m.", "holds"),
        ("$F = 600$ N, so $y = 0.15$ m.", "refuted"),
    ],
)
def test_a_force_that_deflects_a_spring_may_be_given_below_its_equation_of_motion(line, verdict):
    assert _last(f"{SPRING}Equation of motion: $m\\ddot y + k y = 0$.\n\n{line}\n") == verdict


@pytest.mark.parametrize(
    ("root", "is_right"), [("\\sqrt{k/m}", True), ("\\sqrt{m/k}", False), ("k/m", False)]
)
def test_the_natural_frequency_is_that_of_the_equation(root, is_right):
    page = f"{SPRING}Equation of motion: $m\\ddot y + k y = 0$.\n\nSo $\\omega_n = {root}$.\n"
    assert (_last(page) in ("holds", "conditional")) is is_right
    assert (_last(page) == "refuted") is not is_right


def test_a_torque_that_twists_a_shaft_may_be_given_below_its_equation_of_motion():
    assert _last(SHAFT + "Same shaft, torque $T = 600$ N m.\n") == "definition"


def test_what_moves_by_a_formula_of_the_time_is_still_put_in():
    page = "$y = A t^2$ with constant $A$.\n\n$$m\\ddot y = FORMULA$$\n"
    assert _last(page.replace("FORMULA", "2 m A")) == "holds"
    assert _last(page.replace("FORMULA", "3 m A")) == "refuted"
