"""Roots that have no normal form are judged by their values: cube roots, roots of squares of pascals."""

import pytest

import symbalance as sb

STRESSES = "sigma_b = 1133/12.27 = 92.3 MPa\n\ntau = 380/24.54 MPa ~= 15.5 MPa\n\n"
EQUIVALENT = STRESSES + "sigma_v = sqrt(sigma_b^2 + 4*tau^2)\n\n"
CUBE = (
    r"With $T = 710$ Nm and $\tau = 45$ MPa: $d = \sqrt[3]{16\,T/(\pi\,\tau)} \approx NUMBER\,\text{mm}$"
    "\n"
)


def _last(page):
    return sb.check(page, {}).data()["links"][-1]["verdict"]


@pytest.mark.parametrize(("number", "verdict"), [("43.2", "conditional"), ("34.2", "refuted")])
def test_a_cube_root_of_quantities(number, verdict):
    assert _last(CUBE.replace("NUMBER", number)) == verdict


@pytest.mark.parametrize(
    ("line", "verdict"),
    [
        ("sigma_v = sqrt(92.3^2 + 4*15.5^2) = 97.4 MPa", "holds_to_order"),
        ("sigma_v = sqrt(92.3^2 + 4*15.5^2) = 94.7 MPa", "refuted"),
        ("sigma_v = 97.4 MPa", "holds_to_order"),
        ("sigma_v = 94.7 MPa", "refuted"),
    ],
)
def test_a_root_of_squares_of_pascals(line, verdict):
    assert _last(EQUIVALENT + line + "\n") == verdict


def test_a_formula_without_a_normal_form_may_be_given_again():
    page = (
        r"A journal needs $d_e = \sqrt[3]{16\,T/(\pi\,\tau)}$."
        "\n\n"
        r"Again $d_e = \sqrt[3]{K\,T/(\pi\,\tau)}$."
        "\n"
    )
    assert _last(page.replace("K", "16")) == "holds"
    assert _last(page.replace("K", "61")) != "holds"


@pytest.mark.parametrize(("number", "is_wrong"), [("8.60", False), ("8.06", True)])
def test_a_cube_root_has_its_number_in_a_later_sentence(number, is_wrong):
    page = f"$V = 500$ cm³ and $D = \\sqrt[3]{{4V/\\pi}}$.\n\nSo $D = {number}$ cm.\n"
    assert (_last(page) == "refuted") is is_wrong
