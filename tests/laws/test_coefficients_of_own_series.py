"""A page's own series r ω² (cos θ + A_2 cos 2θ + …) says what its coefficients are, and fixes none."""

import pytest

from symbalance.checking import check
from tests.checked_pages import last_verdict

HEADS = {
    "a": "Piston acceleration with λ = r/l.\n\n$$a = r ω^2",
    "x": "Wer es genauer braucht, nimmt mit λ = r/l die Fourierreihe\n\n$$\\ddot x = r ω^2",
    "/": "加速度。λ = r/l。\n\n$$\\frac{a}{r ω^2} = ",
    "F": "La force d'inertie, λ = r/l :\n\n$$F = m r ω^2",
    "≈": "With λ = r/l the acceleration is $a = r ω^2 (\\cos θ + λ\\cos 2θ)$.\nBetter:\n\n$$a = r ω^2",
}
SERIES = "\\left(\\cos θ + A_2\\cos 2θ {}A_4\\cos 4θ + A_6\\cos 6θ + \\dots\\right)$$\n\n$$A_{} = {}$$\n"


def verdicts(head: str, sign: str, order: int, value: str) -> list[str]:
    links = check(HEADS[head] + SERIES.format(sign, order, value)).data()["links"]
    return [link["verdict"] for link in links[-2:]]


@pytest.mark.parametrize("head", HEADS)
def test_each_coefficient_is_the_exact_one_with_its_sign(head: str) -> None:
    for sign, order, value in [
        ("+", 2, "λ + λ^3/4 + 15λ^5/128"),
        ("+", 4, "-λ^3/4 - 3λ^5/16"),
        ("-", 4, "λ^3/4 + \\dots"),
        ("+", 6, "0.0703 λ^5"),
    ]:
        series, coefficient = verdicts(head, sign, order, value)
        assert series in ("premise", "definition")
        assert coefficient == "conditional"


@pytest.mark.parametrize("head", HEADS)
def test_a_coefficient_of_another_series_is_refuted(head: str) -> None:
    for sign, order, value in [
        ("+", 2, "λ - λ^3/4"),
        ("+", 4, "-λ^3/8 - 3λ^5/16"),
        ("+", 4, "λ^3/4"),
        ("-", 4, "-λ^3/4 - 3λ^5/16"),
    ]:
        series, coefficient = verdicts(head, sign, order, value)
        assert series in ("premise", "definition")
        assert coefficient == "refuted"


def test_a_displacement_and_a_velocity_have_others() -> None:
    page = """Velocity and displacement, λ = r/l.

  v = r ω (sin θ + B_2 sin 2θ + B_4 sin 4θ)
  B_2 = λ/2 + λ³/8
  B_4 = -λ³/16
  x = r (C_0 - cos θ - C_2 cos 2θ - C_4 cos 4θ)
  C_2 = λ/4 + λ³/16
  C_4 = -λ³/64
"""
    assert "refuted" not in [link["verdict"] for link in check(page).data()["links"]]


OWN_SERIES = """The crank radius $r$, rod length $l$, $q = r/l$, $\\varphi$ the crank angle.

$$\\ddot s = r\\omega^2\\left(\\cos\\varphi+A_2\\cos2\\varphi+A_4\\cos4\\varphi+\\dots\\right)$$

$$A_2 = q + \\frac{q^3}{4} + \\frac{15q^5}{128}$$

$$A_4 = -\\left(\\frac{q^3}{4} + \\frac{3q^5}{16}\\right)$$

"""
LETTERS = """[symbols]
"r" = "crank radius"
"l" = "rod length"
"\\\\varphi" = "crank angle"
"s" = "displacement from top dead centre"
"\\\\omega" = "angular speed"
"""


@pytest.mark.parametrize(
    "case", ["For $q = 0.3$ we have", "Take $q = 0.3$. Then", "For a typical $q = 0.3$ these are"]
)
@pytest.mark.parametrize(
    ("values", "is_right"),
    [
        ("$A_4 = -0.0072$", True),
        ("$A_2 = 0.3070$ and $A_4 = -0.0072$", True),
        ("$A_2 = 0.3070$ and $A_4 = -0.0027$", False),
        ("$A_4 = -0.0072$ and $A_2 = 0.3700$", False),
    ],
)
def test_a_coefficient_of_one_ratio_is_computed_with_it(tmp_path, case, values, is_right):
    verdict = last_verdict(tmp_path, f"{OWN_SERIES}{case} {values}.", LETTERS)
    proved = ("holds", "holds_to_order", "conditional")
    assert verdict in proved if is_right else verdict == "refuted"
