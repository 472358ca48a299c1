"""Neither a zero of a motion nor a number without a value makes a relation true."""

import pytest

from symbalance.notes.checking import check

MOTION = {
    "a": "piston acceleration",
    "v": "piston velocity",
    "r": "crank radius",
    "λ": "crank radius over rod length",
    "ω": "angular speed",
    "θ": "crank angle",
}
HOLDS = ("holds", "holds_to_order", "conditional")


def last_word(page: str, symbols: dict[str, str] | None = None) -> str:
    checked = check(page + "\n", symbols or {})
    return max(checked.verdicts, key=lambda v: (v.line, v.span)).verdict


@pytest.mark.parametrize(
    "page",
    [
        "Near mid-stroke $a = 0$.\n\n" + r"$v = rω(\cosθ+\frac{λ}{2}\cos 2θ)$",
        "$v = 0$\n\n$a = rω^2λ$",
        "$v = 0$\n\n$a = ωv$",
    ],
)
def test_a_motion_that_is_zero_somewhere_makes_no_size_zero(page):
    assert last_word(page, MOTION) not in HOLDS


def test_beside_such_a_zero_the_right_formula_holds():
    page = "Near mid-stroke $a = 0$.\n\n" + r"$v = rω(\sinθ+\frac{λ}{2}\sin 2θ)$"
    assert last_word(page, MOTION) in HOLDS


@pytest.mark.parametrize(
    ("page", "wrong"),
    [
        (r"$\frac{x^2-1}{x-1} = 2 \Rightarrow x = 1$", True),
        (r"$\frac{x^2-4}{x-2} = 4$" + "\n\nSo $x = 2$.", True),
        (r"$\frac{x^2-1}{x-1} = 3 \Rightarrow x = 2$", False),
        (r"$\frac{6}{x-1} = 3 \Rightarrow x = 3$", False),
    ],
)
def test_a_number_at_which_an_equation_divides_by_zero_is_no_solution(page, wrong):
    assert (last_word(page) not in HOLDS) is wrong


@pytest.mark.parametrize(
    ("page", "has_value"),
    [
        (r"$\log(-5) = \log(-5)$", False),
        (r"$\arcsin 2 = \arcsin 2$", False),
        ("$x = -5$\n\n" + r"$\ln x = \ln x$", False),
        (r"$\log(5) = \log(5)$", True),
        (r"$\ln(x) = \ln(x)$", True),
        (r"$\ln(0.5) = -0.693$", True),
        (r"$\arccos(-0.5) = 120°$", True),
    ],
)
def test_what_has_no_real_value_equals_nothing(page, has_value):
    assert (last_word(page) in HOLDS) is has_value
