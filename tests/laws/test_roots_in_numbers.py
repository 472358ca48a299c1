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


@pytest.mark.parametrize(
    ("left", "right", "verdict"),
    [
        (r"50\cos 60^\circ + \sqrt{200^2 - 50^2\sin^2 60^\circ}", r"25 + \sqrt{40000 - 1875}", "holds"),
        (r"50\cos 60^\circ + \sqrt{200^2 - 50^2\sin^2 60^\circ}", r"25 + \sqrt{40000 - 1876}", "refuted"),
        (r"1 + \sqrt{\sin^2 60^\circ + 1/4}", "2", "holds"),
        (r"1 + \sqrt{\sin^2 30^\circ + 1/4}", "2", "refuted"),
        (r"1 + \sqrt{1 - \lambda^2\sin^2 60^\circ}", r"1 + \sqrt{1 - \frac34\lambda^2}", "holds"),
        (r"1 + \sqrt{1 + x^2\sin^2 60^\circ}", r"1 + \sqrt{1 + \frac34 x^2}", "holds"),
        (r"1 + \sqrt{1 + x^2\sin^2 60^\circ}", r"1 + \sqrt{1 + \frac14 x^2}", "refuted"),
    ],
)
def test_sines_of_given_angles_under_a_root_are_their_numbers(left, right, verdict):
    assert _last(f"$\\lambda$ is small and positive.\n\n$${left} = {right}$$\n") == verdict
