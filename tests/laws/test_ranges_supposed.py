"""What a page supposes of a letter, or says of others' choices, is not held against its own number."""

import pytest

from symbalance.checking import check

PROVED = ("holds", "holds_to_order", "conditional")
ACCUSED = ("refuted", "contradiction")


def words_of(page: str) -> list[str]:
    return [link["verdict"] for link in check(page + "\n", fixes=False).data()["links"]]


@pytest.mark.parametrize(
    ("claim", "is_right"),
    [
        (r"$B > \frac12 \iff 1-B < B$", True),
        (r"$B > \frac12 \iff 1-B > B$", False),
        (r"$B > \frac12 \Rightarrow 1-B < B$", True),
        (r"$B > \frac12 \Rightarrow 1-B > B$", False),
    ],
)
def test_an_arrow_supposes_a_range_whatever_the_letter_is(claim, is_right):
    words = words_of(f"$B = 0.3$. {claim}.")
    assert (set(words) & set(ACCUSED) == set()) == is_right


def test_a_multiple_is_supposed_too():
    page = "$\\gamma = 45°$. $\\delta = 180° - 4\\gamma$. $2\\gamma > {}° \\Rightarrow \\delta < 0$."
    assert not set(words_of(page.format(90))) & set(ACCUSED)
    assert set(words_of(page.format(60))) & set(ACCUSED)


def test_what_others_choose_says_nothing_of_the_last_choice():
    page = "$B = 0.5$ makes them equal. {} $0.6 < B < 0.85$. With $B = 0.7$ it is right."
    assert not set(words_of(page.format("Most people use more,"))) & set(ACCUSED)
    assert set(words_of("$B = 0.5$. So $0.6 < B < 0.85$.")) & set(ACCUSED)


def test_what_is_said_of_a_small_angle_is_not_of_the_one_above():
    page = (
        "$\\varepsilon = 12°$, $F_0 = 14.5$ kN, $F = 2F_0\\sin(\\varepsilon/2)$. {} $F \\le 0.035 F_0$."
    )
    assert not set(words_of(page.format("For $\\varepsilon \\le 2°$ we have"))) & set(ACCUSED)
    assert set(words_of(page.format("So"))) & set(ACCUSED)


def test_the_largest_speed_is_judged_with_the_ratio_given():
    page = (
        "$R$ is the crank radius, $L$ the rod length, $\\alpha$ the crank angle, $\\omega$ the angular"
        " speed and $v$ the piston velocity.\n\nFor $\\lambda = 3.5$ we have"
        " $|v|_{{\\max}} \\approx {}\\,R\\omega$."
    )
    symbols = {
        "R": "crank radius", "L": "rod length", "\\alpha": "crank angle", "\\omega": "angular speed",
        "v": "piston velocity", "\\lambda": "rod ratio l/r",
    }  # fmt: skip
    right, wrong = (
        check(page.format(value), symbols, fixes=False).data()["links"][-1]["verdict"]
        for value in ("1.04", "3.04")
    )
    assert right in PROVED
    assert wrong not in PROVED


@pytest.mark.parametrize("sign", ["", "-"])
def test_heights_by_their_formula_count_speeds_upwards(sign):
    page = (
        "$$x = R\\cos\\theta + L\\cos\\beta$$\n\n"
        f"$$v = {sign}R\\omega\\left(\\sin\\theta + \\frac{{\\sin 2\\theta}}{{2\\lambda}}\\right)$$"
    )
    symbols = {
        "R": "crank radius", "L": "rod length", "\\theta": "crank angle", "\\omega": "angular speed",
        "v": "piston velocity", "\\lambda": "rod ratio l/r", "\\beta": "rod angle",
    }  # fmt: skip
    assert check(page, symbols, fixes=False).data()["links"][-1]["verdict"] != "refuted"


def test_a_cube_root_takes_numbers_in():
    assert words_of("$d = \\sqrt[3]{\\frac{32 M}{\\pi \\sigma}} = 49.7$ mm")[-1] == "premise"
    page = "$M = 900$ N m, $\\sigma = 75$ MPa. $d = \\sqrt[3]{{\\frac{{32 M}}{{\\pi \\sigma}}}} = {}$ mm"
    assert words_of(page.format("49.6"))[-1] in PROVED
    assert words_of(page.format("59.6"))[-1] == "refuted"


def test_a_wide_stroke_may_divide_by_all_behind_it():
    page = "The torsional stiffness of a round shaft of diameter d and length L is C = π G d⁴ / {}."
    assert words_of(page.format("32 L"))[-1] in PROVED
    assert words_of(page.format("(64 L)"))[-1] == "refuted"


def test_a_declared_j_is_the_imaginary_unit():
    page = "$|3 + j| = \\sqrt{{{}}}$"
    for meaning in ("imaginary unit", "虚数単位"):
        symbols = {"j": meaning}
        assert check(page.format(10), symbols).data()["links"][-1]["verdict"] == "holds"
        assert check(page.format(8), symbols).data()["links"][-1]["verdict"] == "refuted"


def test_minutes_turned_in_the_numbers_put_in():
    page = (
        "| quantity | sign | value |\n|---|---|---|\n| stroke | $s$ | 68 mm |\n"
        "| speed | $n$ | 8000 min⁻¹ |\n\n"
        "- $\\omega = \\frac{{\\pi n}}{{30}} = 838\\,\\text{{s}}^{{-1}}$\n"
        "- mean piston speed $c_m = 2 s n = 2 \\cdot 0.068 \\cdot \\frac{{8000}}{{60}} = {}$ m/s\n"
    )
    assert words_of(page.format("18.1"))[-1] in PROVED
    assert words_of(page.format("28.1"))[-1] == "refuted"


def test_declared_parts_may_be_named_as_a_sum():
    symbols = {"F_I": "first order force", "F_{II}": "second order force"}
    page = "$F_o = m r \\omega^2 (\\cos\\varphi + \\lambda\\cos 2\\varphi) = F_I + F_{II}$"
    assert check(page, symbols).data()["links"][-1]["verdict"] == "premise"
