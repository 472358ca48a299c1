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


OF_THE_COURSE = {
    "x": "displacement from top dead centre",
    "θ": "crank angle",
    "r": "crank radius",
    "l": "rod length",
    "λ": "crank ratio r/l",
}
RIGHT = r"x = r(1-\cos\alpha) + l(1-\sqrt{1-\lambda^2\sin^2\alpha})"
NAMING = {
    "let": "Let $\\alpha$ be the crank angle. ",
    "denote": "Here $\\alpha$ denotes the crank angle. ",
    "macro": "\\newcommand{\\ph}{\\alpha}\nLet $\\ph$ be the crank angle. ",
    "list": "Notation: $\\alpha$ crank angle, $r$ crank radius. ",
    "unnamed": "",
}


@pytest.mark.parametrize("naming", NAMING)
@pytest.mark.parametrize("words", ["The displacement is", "Displacement from TDC:", "Kolbenweg ab OT:"])
def test_the_angle_of_a_course_accuses_no_page_that_has_another(naming, words):
    right = check(f"{NAMING[naming]}{words} ${RIGHT}$.\n", OF_THE_COURSE).verdicts[-1]
    assert right.verdict == ("undecided" if naming == "unnamed" else "holds")


@pytest.mark.parametrize("naming", [name for name in NAMING if name != "unnamed"])
def test_the_angle_that_a_page_names_refutes_what_is_wrong_of_it(naming):
    wrong = RIGHT.replace("lambda^2", "lambda")
    assert check(f"{NAMING[naming]}So ${wrong}$.\n", OF_THE_COURSE).verdicts[-1].verdict == "refuted"


def test_a_path_counted_from_a_dead_centre_is_not_taken_there():
    at_bottom = check("At BDC: $x = 3r$. At BDC $x = 2r$. At TDC: $x = 0$.", OF_THE_COURSE)
    assert [v.verdict for v in at_bottom.verdicts] == ["refuted", "conditional", "conditional"]
