"""What a letter's formula never is, what is not so always, and roots that words list."""

import pytest

import symbalance as sb

IMPOSSIBLE = [
    ("Let $x = y^2$ with RANGE.\n", "$x < 0$", "$x > 0$"),
    ("Sei $x = y^2 + z^2$ mit RANGE.\n", "$x < 0$", "$x < 4$"),
    ("Soit $x = -y^2$, RANGE.\n", "$x > 0$", "$x < 0$"),
    ("$q = 1 + \\cos^2\\theta$ with RANGE.\n", "$q < 1$", "$q < 2$"),
    ("$z = \\cos\\theta$ and RANGE.\n", "$z > 2$", "$z > 0.2$"),
    ("Let RANGE and $x = y^2$.\n", "$x<0$", "$x>0$"),
    (
        "$\\sigma = F/A = 12000/100 = 120$ N/mm².\n\nRANGE.\n",
        "$\\sigma < 100$ N/mm²",
        "$\\sigma > 100$ N/mm²",
    ),
    ("$p = F/A = 7{,}5$ MPa.\n\nAlso RANGE.\n", "$p < 7$ MPa", "$p < 8$ MPa"),
    ("We have $s = a^2 + b^2$. Take $s = RANGE$.\n", "-4", "4"),
]
POSSIBLE = [
    "$x = y^2$. The case $x<0$ is impossible.\n",
    "$D = b^2 - 4ac$. If $D < 0$ there is no real root.\n",
    "$\\lambda = r/l$, $\\lambda < 1$.\n",
    "$\\sigma = F/A = 120$ N/mm². Required: $\\sigma < 100$ N/mm².\n",
    "$x = -y^2$, so $x \\le 0$.\n",
]
ALWAYS = [
    ("Always $y^2 \\ge NUMBER$.\n", "1", "0"),
    ("Es gilt stets $x^2 + NUMBER \\geq 2x$.\n", "0", "1"),
    ("In every case $a^2 + b^2 \\ge NUMBER ab$.\n", "3", "2"),
    ("Pour tout $x$, $x^2 \\ge NUMBER$.\n", "1", "-1"),
    ("Sempre $y^2 \\ge NUMBER$.\n", "1", "0"),
    ("En todo caso $a^2 + b^2 \\ge -NUMBER ab$.\n", "5", "2"),
    ("常に $x^2 \\ge NUMBER$ である。\n", "4", "0"),
]
NOT_ALWAYS = [
    "It is not always so that $x^2 \\ge 4$.\n",
    "Since always $l > 2r$, the rod passes.\n",
    "The load is always $F > 100$ N.\n",
]
LISTED = [
    ("$y^2 - 8y + 15 = 0$, so y = 3 or ROOT.\n", "7", "5"),
    ("$y^2 - 8y + 15 = 0$\n\n$y = 3$ oder $ROOT$\n", "7", "5"),
    ("$y^2 - 8y + 15 = 0$ is true for $y \\in \\{3, ROOT\\}$.\n", "7", "5"),
    ("The solutions of $x^2-5x+6=0$ are 2 and ROOT.\n", "4", "3"),
    ("Die Lösungen von $x^2-5x+6=0$ sind 2 und ROOT.\n", "4", "3"),
    ("Les racines de $x^2-5x+6=0$ sont 2 et ROOT.\n", "4", "3"),
    ("$x^2 - 4x + 1 = 0$ gives $x = 3.73$ or $ROOT$.\n", "0.628", "0.268"),
    ("The quadratic $2x^2 - 7x + 3 = 0$ gives $x_1 = 3$, $x_2 = ROOT$.\n", "2", "\\frac12"),
]


def test_a_decimal_comma_is_no_list():
    page = "$\\sin\\beta = 0{,}15$\n\n$\\beta = 8,63°$, $y = 7,73$ mm\n"
    assert not _is_accused(page)
    assert not _is_accused("$x^2 - 4x + 1 = 0$, also $x = 3,73$ oder $0,268$.\n")


def _verdicts(page):
    return [link["verdict"] for link in sb.check(page, {}).data()["links"]]


def _is_accused(page):
    return bool({"refuted", "contradiction"} & {*_verdicts(page)})


@pytest.mark.parametrize(("page", "wrong", "right"), IMPOSSIBLE)
def test_a_range_that_a_formula_never_has(page, wrong, right):
    assert _verdicts(page.replace("RANGE", wrong))[-1] == "contradiction"
    assert not _is_accused(page.replace("RANGE", right))


@pytest.mark.parametrize("page", [*POSSIBLE, *NOT_ALWAYS])
def test_what_may_be_so_is_not_accused(page):
    assert not _is_accused(page)


@pytest.mark.parametrize(("page", "wrong", "right"), ALWAYS)
def test_what_is_said_to_be_so_always(page, wrong, right):
    assert _verdicts(page.replace("NUMBER", wrong)) == ["refuted"]
    assert not _is_accused(page.replace("NUMBER", right))


@pytest.mark.parametrize(("page", "wrong", "right"), LISTED)
def test_each_listed_root_solves_the_equation(page, wrong, right):
    assert _is_accused(page.replace("ROOT", wrong))
    assert not _is_accused(page.replace("ROOT", right))
