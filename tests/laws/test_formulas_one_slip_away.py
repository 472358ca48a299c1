"""A number that fits a formula one slip from the page's own is not accused; a slip of digits is."""

import pytest

from symbalance.checking import check

MEAN = (
    r"The stress lies between $\sigma_o = 66.9$ MPa and $\sigma_u = -12.6$ MPa, with $q = {formula}$."
    + "\n\n"
)
TWIST = "J1 = 1.83 kg m^2, J2 = 0.285 kg m^2, k = 0.70e6 N m.\n\nQ = {formula}\n\n"


def _last(page):
    return check(page).data()["links"][-1]


@pytest.mark.parametrize(
    ("formula", "number", "verdict"),
    [
        (r"\frac{\sigma_o + \sigma_u}{2}", "27.15", "holds"),
        (r"\frac{\sigma_o - \sigma_u}{2}", "27.15", "undecided"),  # the sum comes to it
        (r"\frac{\sigma_o + \sigma_u}{2}", "27.51", "refuted"),
        (r"\frac{\sigma_o + \sigma_u}{2}", "271.5", "refuted"),
        (r"\frac{\sigma_o + \sigma_u}{2}", "31.4", "refuted"),
    ],
)
def test_a_number_beside_a_formula_of_the_page(formula, number, verdict):
    last = _last(MEAN.replace("{formula}", formula) + f"In numbers $q = {number}$ MPa.\n")
    assert last["verdict"] == verdict
    if verdict == "undecided":
        assert "one of the two is wrong" in last["reason"]


def test_a_fraction_upside_down_may_be_what_is_wrong():
    numbers = "Q = sqrt(0.70e6*2.115/0.52155)\n"
    assert _last(TWIST.format(formula="sqrt(k*(J1 + J2)/(J1*J2))") + numbers)["verdict"] != "refuted"
    assert _last(TWIST.format(formula="sqrt(k*J1*J2/(J1 + J2))") + numbers)["verdict"] == "undecided"
    wrong = numbers.replace("2.115", "2.511")
    assert _last(TWIST.format(formula="sqrt(k*(J1 + J2)/(J1*J2))") + wrong)["verdict"] == "refuted"


def test_the_seconds_of_a_minute_are_no_slip_of_a_formula():
    page = "With $f = 280$ Hz and $q = 2$: $n = {formula}$ rpm, and so $n = {number}$ rpm.\n"
    assert _last(page.format(formula="60 f/q", number="8400"))["verdict"] == "conditional"
    assert _last(page.format(formula="60 f/q", number="4200"))["verdict"] == "refuted"


@pytest.mark.parametrize(
    ("formula", "number", "verdict"),
    [
        ("T*b/(G*Ip)", "3.1*10^-4", "holds_to_order"),
        ("T*b/(E*Ip)", "3.1*10^-4", "undecided"),  # with G it is right to its digits
        ("T*b/(E*Ip)", "1.2*10^-4", "holds_to_order"),
        ("T*b/(G*Ip)", "3.5*10^-4", "refuted"),
        ("T*b/(E*Ip)", "2.1*10^-4", "refuted"),
    ],
)
def test_one_letter_of_a_dimension_may_stand_for_another(formula, number, verdict):
    data = (
        "The steel has E = 210 GPa, G = 80 GPa, Rm = 900 MPa. T = 380 Nm, b = 40 mm, Ip = 61.36 cm^4.\n\n"
    )
    assert _last(f"{data}   phi = {formula}\n   phi ~= {number} rad\n")["verdict"] == verdict


def test_a_number_below_a_refuted_formula_may_be_right():
    page = "E = 210 GPa, G = 80 GPa, T = 380 Nm, b = 40 mm, Ip = 61.36 cm^4.\n\n"
    page += "   phi = T*b/(E*Ip)\n   phi ~= {} rad\n"
    meanings = {"phi": "angle of twist", "E": "Young's modulus", "G": "shear modulus", "T": "torque"}
    meanings |= {"b": "length of the pin", "Ip": "polar moment of area"}
    words = [
        [e["verdict"] for e in check(page.format(n), meanings).data()["links"]][-2:]
        for n in ("3.1*10^-4", "2.1*10^-4")
    ]
    assert words == [["refuted", "undecided"], ["refuted", "refuted"]]
