"""What a letter is declared as may name its order: a secondary force goes with 2θ and with λ."""

import pytest

import symbalance as sb

OTHERS = {
    "m": "oscillating mass [kg]",
    "\\theta": "crank angle from top dead centre [rad]",
    "r": "crank radius [m]",
    "\\lambda": "ratio of crank radius to rod length",
    "\\omega": "angular speed [rad/s]",
    "n": "ratio of rod length to crank radius",
}
DECLARED = [
    "secondary inertia force [N]",
    "inertia force of the second order [N]",
    "Massenkraft 2. Ordnung [N]",
]
RIGHT = [r"\lambda m r\omega^2\cos 2\theta", r"m\frac{r}{4n}(2\omega)^2\cos 2\theta"]
WRONG = [
    r"\lambda m r\omega^2\cos\theta",
    r"m\frac{r}{2n}(2\omega)^2\cos 2\theta",
    r"m r\omega^2\cos 2\theta",
]

WRONG_WORDS = ("refuted", "contradiction")


def _verdicts(page, meaning):
    declarations = {"symbols": {**OTHERS, "F_2": meaning}}
    return [each["verdict"] for each in sb.check(page, declarations).data()["links"]]


@pytest.mark.parametrize("meaning", DECLARED)
@pytest.mark.parametrize("formula", RIGHT)
def test_a_formula_of_the_declared_order_holds(meaning, formula):
    assert _verdicts(f"$$F_2 = {formula}$$\n", meaning) == ["conditional"]


@pytest.mark.parametrize("meaning", DECLARED)
@pytest.mark.parametrize("formula", WRONG)
def test_a_formula_of_another_order_is_wrong(meaning, formula):
    assert _verdicts(f"$$F_2 = {formula}$$\n", meaning) == ["refuted"]


@pytest.mark.parametrize("formula", WRONG)
def test_a_force_that_is_declared_of_no_order_may_be_anything(formula):
    assert _verdicts(f"$$F_2 = {formula}$$\n", "force [N]")[0] not in WRONG_WORDS


@pytest.mark.parametrize(("wave", "is_wrong"), [("2\\theta", False), ("\\theta", True)])
def test_an_order_that_does_not_fit_the_sum_above_is_wrong(wave, is_wrong):
    page = (
        "With the doubled angle $\\sin^2\\theta = \\frac12(1 - \\cos 2\\theta)$. The inertia force is\n\n"
        "$$F_o = m r\\omega^2(\\cos\\theta + \\lambda\\cos 2\\theta) = F_1 + F_2$$\n\n"
        "with $F_1 = m r\\omega^2\\cos\\theta$,\n\n"
        f"$$F_2 = \\lambda m r\\omega^2\\cos {wave}.$$\n"
    )
    last = _verdicts(page, "secondary inertia force [N]")[-1]
    assert (last in WRONG_WORDS) is is_wrong
    assert (last == "conditional") is not is_wrong
