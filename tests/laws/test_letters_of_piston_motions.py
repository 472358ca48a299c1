"""A piston's motion is judged in whatever letters a page has for crank radius, rod and angle."""

import pytest

import symbalance as sb

PAGES = [
    "The throw is $e$, the rod $L$ and $q = e/L$. Piston acceleration near enough\n\n"
    "$$ a = e\\,\\Omega^2\\left(\\cos\\theta + TERM\\cos 2\\theta\\right) $$\n",
    "The crank radius is $a$, the rod $b$ long and $q = a/b$. The acceleration of the piston is\n\n"
    "$$ \\ddot x = a\\omega^2\\left(\\cos\\theta + TERM\\cos 2\\theta\\right) $$\n",
    "Throw $R$, rod $L$, $q = R/L$, angular speed $w$. Piston acceleration, near enough:\n\n"
    "$$ a = R w^2 (\\cos t + TERM \\cos 2t) $$\n",
]


@pytest.mark.parametrize("page", PAGES)
@pytest.mark.parametrize("wrong", [r"\frac{q}{4}", r"\frac{1}{q}", "2q"])
def test_the_second_order_of_an_acceleration_is_judged_in_any_letters(page, wrong):
    def last(term):
        return sb.check(page.replace("TERM", term), {}).data()["links"][-1]["verdict"]

    assert last("q") in ("conditional", "holds_to_order")
    assert last(wrong) == "refuted"


OTHERS = [
    "$q = e/L$ where $e$ is the diameter of the crank circle and $L$ the rod. The piston acceleration is "
    "$a = e\\omega^2(\\cos\\theta + q\\cos 2\\theta)$.\n",
    "$\\lambda = L/b$ with the rod $L$ and the bore $b$. The piston acceleration is "
    "$a = b\\omega^2(\\cos\\theta + \\lambda\\cos 2\\theta)$.\n",
    "The crank radius is $r$, the rod $l$. $q = r/l$. The acceleration of the counterweight is "
    "$a = r\\omega^2(\\cos\\theta + q\\cos 2\\theta)$.\n",
]


@pytest.mark.parametrize("page", OTHERS)
def test_another_length_or_body_leaves_a_definition(page):
    assert sb.check(page, {}).data()["links"][-1]["verdict"] == "definition"
