"""What a quantity comes to at a multiple of a letter follows from its formula: F(2n) = 4 F(n)."""

import pytest

from tests.checked_pages import last_in

PAGES = {
    "speed": ("$F = m r \\left(\\frac{2\\pi n}{60}\\right)^2$", "F(2n) = {} F(n)", "4", "2"),
    "half": (
        "$F = m r \\left(\\frac{2\\pi n}{60}\\right)^2$",
        "F(n/2) = {} F(n)",
        "\\frac14",
        "\\frac12",
    ),
    "ratio": ("$F = m r (2\\pi n)^2$", "F(3n)/F(n) = {}", "9", "3"),
    "energy": ("$E = \\frac12 J\\omega^2$", "E(2\\omega) = {} E(\\omega)", "4", "2"),
    "half the energy": (
        "$E = \\frac12 J\\omega^2$",
        "E(\\omega/2) = {} E(\\omega)",
        "\\frac14",
        "\\frac12",
    ),
    "root": ("$\\omega_n = \\sqrt{k/m}$", "\\omega_n(4k) = {}\\,\\omega_n(k)", "2", "4"),
    "two formulas": (
        "$\\sigma = \\rho v^2$ with $v = \\pi D n$",
        "\\sigma(3n) = {}\\,\\sigma(n)",
        "9",
        "3",
    ),
    "power": (
        "$\\varphi = \\frac{T l}{G I_p}$ with $I_p = \\frac{\\pi}{32} d^4$",
        "\\varphi\\left(\\frac{d}{2}\\right) = {}\\,\\varphi(d)",
        "16",
        "8",
    ),
}


@pytest.mark.parametrize("page", PAGES.values(), ids=PAGES)
def test_the_formula_says_what_it_comes_to(page):
    formula, claim, right, wrong = page
    assert last_in(f"We have {formula}. Then ${claim.replace('{}', right)}$.") == "holds"
    assert last_in(f"We have {formula}. Then ${claim.replace('{}', wrong)}$.") == "refuted"


def test_nothing_is_known_of_a_letter_without_a_formula():
    assert last_in("A mass $m$ at the radius $r$: $m(2r) = 2 m(r)$.") == "undecided"


def test_a_function_of_the_page_is_judged_as_such():
    assert last_in("Let $f(x) = 3x$. Then $f(2x) = 2 f(x)$.") in ("holds", "conditional")
