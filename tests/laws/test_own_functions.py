"""Functions that a page defines: their values, their derivatives, and where these are set to zero."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check
from symbalance.notes.checking.verdicts import (
    CONDITION,
    CONTRADICTION,
    DEFINITION,
    PROVED_WORDS,
    REFUTED,
    UNDECIDED,
)

SQUARES = "The sum of the squares is $S(k) = (1-k)^2 + k^2$. "
CUBE = "Die Funktion\n\n$$f(x) = x^3 - 12x + 1$$\n\n"
PLAIN = "    A(u) = 3 u^2 - 12 u\n\n"
LENGTH = "Let $L(x) = \\sqrt{1 + x^2}$. "

RIGHT = (
    SQUARES + "Then $S'(k) = -2(1-k) + 2k$",
    SQUARES + "Then $\\frac{dS}{dk} = 4k - 2$",
    SQUARES + "Then $S''(k) = 4$",
    SQUARES + "There $S(\\tfrac12) = \\tfrac12$",
    SQUARES + "There $S(1-k) = S(k)$",
    CUBE + "hat die Ableitung $f'(x) = 3x^2 - 12$",
    CUBE + "Dort ist $f(2) = -15$",
    PLAIN + "    dA/du = 6 u - 12",
    LENGTH + "So $L'(x) = x/L(x)$",
)
WRONG = (
    SQUARES + "Then $S'(k) = 2(1-k) + 2k$",
    SQUARES + "Then $\\frac{dS}{dk} = 2(1-k) + 2k$. The balance factor is $k = 0.6$",
    SQUARES + "There $S(\\tfrac12) = \\tfrac14$",
    CUBE + "hat die Ableitung $f'(x) = 3x^2 - 12x$",
    CUBE + "Dort ist $f(2) = 15$",
    SQUARES + "There $S\\left(1-k\\right) = -S(k)$",
    PLAIN + "    dA/du = 6 u + 12",
    LENGTH + "So $L'(x) = 1/L(x)$",
)


def words(page: str) -> list[str]:
    ordered = sorted(check(page + "\n", {}).verdicts, key=lambda v: (v.line, v.span))
    return [verdict.verdict for verdict in ordered]


@pytest.mark.parametrize("page", RIGHT)
def test_what_a_function_gives_is_proved(page):
    first, second, *_ = words(page)
    assert first == DEFINITION
    assert second in PROVED_WORDS


@pytest.mark.parametrize("page", WRONG)
def test_what_it_does_not_give_is_refuted(page):
    first, second, *_ = words(page)
    assert first == DEFINITION
    assert second == REFUTED


ZERO = (
    (
        SQUARES + "To zero:\n\n$$\\frac{dS}{dk} = {}2(1-k) + 2k = 0$$\n\nso that $$k = {}\\tfrac12$$",
        "-",
        "",
    ),
    (
        SQUARES + "Set the derivative to zero:\n\n$$S'(k) = {}2 + 4k = 0$$\n\nSo $k = {}\\tfrac12$",
        "-",
        "",
    ),
    ("Let $S = (1-k)^2 + k^2$. Thus $\\frac{dS}{dk} = 4k {} 2 = 0$, so $k = {}0.5$", "-", ""),
    (PLAIN + "    dA/du = 6 u {} 12 = 0\n\nso\n\n    u = {}2", "-", ""),
)


@pytest.mark.parametrize(("page", "sign", "no_sign"), ZERO)
@pytest.mark.parametrize("is_right_slope", [True, False])
@pytest.mark.parametrize("is_right_root", [True, False])
def test_a_derivative_set_to_zero_is_solved_by_what_it_is(
    page, sign, no_sign, is_right_slope, is_right_root
):
    text = page.replace("{}", sign if is_right_slope else "+", 1)
    text = text.replace("{}", no_sign if is_right_root else "-", 1)
    _, slope, zero, root = words(text)
    assert (slope in PROVED_WORDS) is is_right_slope
    assert is_right_slope or slope == REFUTED
    assert zero == CONDITION
    assert (root in PROVED_WORDS) is is_right_root


@pytest.mark.parametrize("page", ["With $f(x) = 2x$ and $f(t) = t^2$ it is $f(3) = 9$", "$g(2) = 5$"])
def test_of_a_letter_that_is_no_one_function_nothing_is_refuted(page):
    assert REFUTED not in words(page)


MAKER = (
    SQUARES + "To zero:\n\n$$\\frac{dS}{dk} = 4k - 2 = 0$$\n\nso that $k = 0.5$ is best."
    "{}The makers use $k = 0.6$ and have $S = {}$."
)


@pytest.mark.parametrize(
    "between", [" ", "\n\n", "\n\nFar below stands more.\n\nAnd more.\n\n", "\n\n# Two\n\n"]
)
def test_another_value_than_the_best_is_not_accused(between):
    *_, value, result = words(MAKER.replace("{}", between, 1).replace("{}", "0.52"))
    assert value not in (REFUTED, CONTRADICTION, UNDECIDED)
    assert result in PROVED_WORDS
    *_, result = words(MAKER.replace("{}", between, 1).replace("{}", "0.25"))
    assert result in (REFUTED, CONTRADICTION)


INERTIA = (
    """The crank angle is $\\varphi$. The inertia is $J(\\varphi) = J_0 + m r^2\\sin^2\\varphi$.\n\n"""
)
RATE = "$$\\frac{\\mathrm{d}}{\\mathrm{d}t}(J\\dot\\varphi) = J\\ddot\\varphi + "


def test_a_prime_without_its_place_is_the_derivative():
    assert words(INERTIA + RATE + "J'\\dot\\varphi^2$$")[1] in PROVED_WORDS
    assert words(INERTIA + RATE + "\\frac12 J'\\dot\\varphi^2$$")[1] == REFUTED
    assert words(INERTIA + "$$J' = 2 m r^2\\sin\\varphi\\cos\\varphi$$")[1] in PROVED_WORDS


@pytest.mark.parametrize(("factor", "outcomes"), [("", PROVED_WORDS), ("\\frac12", (REFUTED,))])
def test_so_it_is_where_the_place_is_a_macro(tmp_path, factor, outcomes):
    page = INERTIA + RATE + factor + "J'\\dot\\varphi^2$$\n"
    path = tmp_path / "page.tex"
    path.write_text("\\newcommand{\\ph}{\\varphi}\n" + page.replace("\\varphi", "\\ph"), encoding="utf-8")
    assert check(path).verdicts[-1].verdict in outcomes


def test_a_prime_is_a_mark_where_its_letter_is_another():
    another = "With the flywheel it is $J' = J + J_S$, so $J' - J = J_S$."
    assert words(INERTIA + another)[1] == DEFINITION
    assert REFUTED not in words(INERTIA + another)
    plain = "The crank angle is $\\varphi$. The inertia is $J = J_0 + m r^2\\sin^2\\varphi$.\n\n"
    assert words(plain + "The other is $J' = 2 m r^2$.")[1] == DEFINITION
