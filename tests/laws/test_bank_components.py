"""Two banks' forces in letters: one sine for a cosine is found where another component is right."""

import pytest

from symbalance.checking import check

RIGHT = {
    "γ/2": "A V-twin, both rods on one pin:\n\nY1 = 2*m*r*omega^2 * cos(gamma/2)^2 * cos(phi)\n\n",
    "α": "V2, halber Winkel α zwischen den Bänken:\n\nX1 = 2*m*r*omega^2 * sin(alpha)^2 * sin(phi)\n\n",
}
HALF = {"γ/2": ("gamma/2", "gamma"), "α": ("alpha", "2*alpha")}


def last(page: str) -> dict[str, str]:
    return check(page).data()["links"][-1]


@pytest.mark.parametrize("angle", RIGHT)
@pytest.mark.parametrize(
    ("first", "second", "wave", "verdict"),
    [
        ("cos", "cos", "cos", "conditional"),
        ("sin", "sin", "sin", "conditional"),
        ("sin", "cos", "sin", "refuted"),
        ("cos", "sin", "cos", "refuted"),
        ("cos", "sin", "sin", "definition"),  # a difference along
        ("sin", "cos", "cos", "definition"),  # a sum across
    ],
)
def test_a_second_order_of_two_banks(angle, first, second, wave, verdict):
    half, full = HALF[angle]
    formula = f"2*q*m*r*omega^2 * {first}({half}) * {second}({full}) * {wave}(2*phi)"
    page = RIGHT[angle] + f"With q = r/l\n\nW = {formula}\n"
    assert last(page)["verdict"] == verdict


def test_what_is_right_at_one_angle_is_judged_by_the_mended_formula():
    page = (
        RIGHT["γ/2"] + "With q = r/l\n\nX2 = 2*q*m*r*omega^2 * sin(gamma/2) * cos(gamma) * sin(2*phi)\n\n"
        "At gamma = 90° we have X2 = {}*q*m*r*omega^2*sin(2*phi).\n"
    )
    assert last(page.format("sqrt(2)"))["verdict"] == "conditional"
    assert last(page.format("sqrt(3)"))["verdict"] == "refuted"
