"""What is right of a page's own angle is not refuted by a crank angle that nobody declared."""

import pytest

from symbalance.checking import check

SYMBOLS = {
    "r": "crank radius",
    "l": "rod length",
    "lambda": "crank ratio r/l",
    "varphi": "position of the big end",
    "omega": "angular speed",
    "beta": "rod angle",
    "x": "distance of the piston pin from the crank axis",
}
LOOP = "$\\dot\\varphi = \\omega$. $r\\sin\\varphi = l\\sin\\beta$. "
COEFFICIENTS = (
    "$x = r\\cos\\varphi + l\\cos\\beta$ and $$\\frac{x}{r} = A_0 + \\cos\\varphi + A_2\\cos 2\\varphi + "
    "A_4\\cos 4\\varphi + \\dots$$ with "
)


@pytest.mark.parametrize(
    "line",
    [
        "$\\dot\\beta = \\omega\\frac{\\lambda\\cos\\varphi}{\\cos\\beta}$",
        "$\\dot\\beta = \\omega\\frac{\\lambda\\sin\\varphi}{\\cos\\beta}$",
        "$\\ddot x \\approx -r\\omega^2(\\cos\\varphi + \\lambda\\cos 2\\varphi)$",
        COEFFICIENTS + "$A_2 = \\frac{\\lambda}{4} + \\frac{\\lambda^3}{16} + O(\\lambda^5)$",
    ],
)
def test_a_relation_of_an_angle_that_may_be_the_cranks_is_undecided(line):
    last = check(LOOP + line + "\n", SYMBOLS).verdicts[-1]
    assert last.verdict == "undecided"
    assert last.reason


@pytest.mark.parametrize("role", ["crank angle from top dead centre", "Kurbelwinkel ab OT"])
def test_with_the_angle_declared_right_and_wrong_are_told_apart(role):
    declared = {**SYMBOLS, "varphi": role}
    right = "$\\dot\\beta = \\omega\\frac{\\lambda\\cos\\varphi}{\\cos\\beta}$\n"
    wrong = "$\\dot\\beta = \\omega\\frac{\\lambda\\sin\\varphi}{\\cos\\beta}$\n"
    assert check(LOOP + right, declared).verdicts[-1].verdict == "holds"
    assert check(LOOP + wrong, declared).verdicts[-1].verdict == "refuted"
