"""One result fixes the one letter that has no value; ω is that of the speed in turns, if there is one."""

import pytest

import symbalance as sb


@pytest.mark.parametrize(("stress", "is_wrong"), [("0.793", False), ("7.93", True)])
def test_a_result_fixes_the_one_letter_without_a_value(stress, is_wrong):
    """What is computed with it later is judged."""
    page = (
        "The rim has $R_a = 0.32$ m and $\\rho = 7850$ kg/m³. There $u = R_a \\omega = 10.05$ m/s.\n\n"
        f"So $\\sigma = \\rho u^2 = {stress}$ MPa.\n"
    )
    links = sb.check(page, {}).data()["links"]
    assert [link["verdict"] for link in links][-3] in ("premise", "definition")
    assert (links[-1]["verdict"] in ("refuted", "contradiction")) is is_wrong


@pytest.mark.parametrize(("power", "verdict"), [("254.8", "conditional"), ("245", "undecided")])
def test_an_angular_speed_is_that_of_the_turns(power, verdict):
    page = f"$T = 811$ N m at $n = 3000$ rpm.\n\n$P = T\\omega = {power}$ kW\n"
    last = sb.check(page, {}).data()["links"][-1]
    assert last["verdict"] == verdict
    assert "ω = 2π n" in (last["assumption"] or last["reason"])


OPEN_LETTERS = {
    "sum": (
        "The inertia is $J = J_1 + J_2 = 0.8$ kg m², $\\Omega = 150$ 1/s.\n\n$J\\Omega^2 = {}$",
        "18000",
        "16000",
    ),
    "quotient": (
        "Stiffness $k = \\frac{{G I_p}}{{L}} = 2.0\\cdot 10^5$ N m/rad. The disc: $J = 0.5$ kg m².\n\n"
        "$\\omega = \\sqrt{{k/J}} = {}$ rad/s",
        "632.5",
        "623.5",
    ),
    "quotient with its numbers": (
        "Steifigkeit $k = \\frac{{G I_p}}{{L}} = \\frac{{80\\cdot 400}}{{0.5}}$"
        " N m/rad, und mit $J = 0.25$ kg m² wird\n\n$\\omega = \\sqrt{{k/J}} = {}$ rad/s",
        "506",
        "560",
    ),
    "product": (
        "F_1 = m r ω² = 11.6 kN par cylindre, et λ = 0.25.\n\n4 λ F_1 = {} kN",
        "11.6",
        "12.6",
    ),
    "product in Japanese": (
        "荷重 $F = m r ω^2 = 8.0$ kN。クランク腕 $e = 30$ mm。\n\n$M = F e = {}$ N m",
        "240",
        "2400",
    ),
}


@pytest.mark.parametrize("kind", OPEN_LETTERS)
@pytest.mark.parametrize("is_wrong", [False, True])
def test_a_number_for_a_formula_of_open_letters_is_the_value_of_its_letter(kind, is_wrong):
    """J = J_1 + J_2 = 0.8 gives J its value, though nobody gives J_1 or J_2 any."""
    page, right, wrong = OPEN_LETTERS[kind]
    last = sb.check(page.format(wrong if is_wrong else right) + "\n", {}).data()["links"][-1]
    assert last["verdict"] in (("refuted",) if is_wrong else ("holds", "holds_to_order", "conditional"))


def test_the_formula_of_open_letters_still_counts():
    page = "$F_1 = m r \\omega^2 = 11.6$ kN.\n\n$4 F_1 = {} m r \\omega^2$\n"
    verdicts = [sb.check(page.format(n), {}).data()["links"][-1]["verdict"] for n in (4, 2)]
    assert verdicts == ["holds", "refuted"]
