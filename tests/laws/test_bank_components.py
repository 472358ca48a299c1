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


GENERAL = {
    "any order": "# V-twin, one pin\n\nWith $P = m r\\omega^2$, $q = r/l$, θ from the bisector,\n\n"
    r"$X_n = 2F_n\cos\frac{\gamma}{2}\cos\frac{n\gamma}{2}\cos n\theta$, "
    r"$Y_n = 2F_n\sin\frac{\gamma}{2}\sin\frac{n\gamma}{2}\sin n\theta$, $F_1 = P$, $F_2 = q P$."
    + "\n\n",
    "Gabelwinkel": "# Zwei Kolben auf einem Zapfen\n\nθ zählt ab der Winkelhalbierenden, "
    "$P = m r\\omega^2$, $q = r/l$.\n\n"
    r"$X_1 = 2P\cos^2\beta\cos\theta$, $Y_1 = 2P\sin^2\beta\sin\theta$,"
    "\n\n"
    r"$X_2 = 2q P\cos\beta\cos2\beta\cos2\theta$, $Y_2 = 2q P\sin\beta\sin2\beta\sin2\theta$" + "\n\n",
}
CASES = {
    "any order": "## {} V\n\n",
    "Gabelwinkel": "## Der {}-Motor\n\nMit $\\beta = {{}}°$ wird\n\n",
}


@pytest.mark.parametrize("above", GENERAL)
@pytest.mark.parametrize(
    ("degrees", "formula", "right", "wrong"),
    [
        (90, r"$Y_1 = {}P\sin\theta$", "", "2"),
        (90, r"$Y_2 = {}q P\sin2\theta$", r"\sqrt2", "2"),
        (60, r"$Y_1 = {}P\sin\theta$", r"\frac12", ""),
        (60, r"$X_2 = {}q P\cos2\theta$", r"\frac{\sqrt3}{2}", r"\frac{\sqrt3}{4}"),
        (60, r"$Y_2 = {}q P\sin2\theta$", r"\frac{\sqrt3}{2}", r"\sqrt3"),
    ],
)
def test_an_angle_in_a_heading_is_put_into_the_rule_above(above, degrees, formula, right, wrong):
    case = CASES[above].format(f"{degrees}°").replace("{}", str(degrees // 2))
    page = GENERAL[above] + case + formula + "\n"
    assert last(page.replace("{}", right))["verdict"] == "conditional"
    assert last(page.replace("{}", wrong))["verdict"] == "refuted"
