"""A letter with a formula that changes is no constant under a derivative: F of F = m a in dF/dt."""

from __future__ import annotations

import pytest

from tests.checked_pages import in_displays, last_verdict

SYMBOLS = """[symbols]
"theta" = "crank angle"
"omega" = "angular speed"
"t" = "time"
"r" = "crank radius"
"l" = "rod length"
"lambda" = "crank ratio r/l"
"a" = "piston acceleration"
"x" = "displacement from top dead centre"
"m" = "mass, kg"
"F" = "force, N"
"V" = "volume"
"A" = "area"
"J" = "moment of inertia"
"J_0" = "moment of inertia of the shaft"
"k" = "loss of mass"
"u" = "speed of the pin along its crank"
"r_0" = "first radius"
"lambda_0" = "mean ratio"
"m_0" = "first mass"
"""
WRONG = [
    ("F = m a", r"\frac{dF}{dt} = 0"),
    ("V = A x", r"\frac{dV}{d\theta} = 0"),
    (r"F = m r\omega^2\cos\theta", r"\frac{d}{d\theta}(F\sin\theta) = F\cos\theta"),
    ("m = m_0 + k t", r"\frac{dm}{dt} = 0"),
    ("r = r_0 + u t", r"\frac{d}{dt}(r\cos\theta) = -r\omega\sin\theta"),
    (r"\lambda = \lambda_0(1+\cos\theta)", r"\frac{d\lambda}{d\theta} = 0"),
    (
        r"J = J_0 + m r^2\sin^2\theta",
        r"\frac{d}{dt}\left(\frac12 J\omega^2\right) = J\omega\dot\omega",
    ),
]
RIGHT = [
    (r"F = m r\omega^2\cos\theta", r"\frac{dF}{d\theta} = -m r\omega^2\sin\theta"),
    (
        r"F = m r\omega^2\cos\theta",
        r"\frac{d}{d\theta}(F\sin\theta) = m r\omega^2\cos2\theta",
    ),
    ("m = m_0 + k t", r"\frac{dm}{dt} = k"),
    ("m = 2 m_0", r"\frac{d}{dt}(m x) = m\frac{dx}{dt}"),
]


@pytest.mark.parametrize("lines", WRONG)
def test_what_moves_by_its_formula_is_not_constant(tmp_path, lines):
    assert last_verdict(tmp_path, in_displays(lines), SYMBOLS) == "refuted"


@pytest.mark.parametrize("lines", RIGHT)
def test_the_rate_of_its_formula_holds(tmp_path, lines):
    assert last_verdict(tmp_path, in_displays(lines), SYMBOLS) == "holds"


def test_a_ratio_may_change_with_a_length(tmp_path):
    assert last_verdict(tmp_path, in_displays([r"\frac{d\lambda}{dr} = 0"]), SYMBOLS) not in (
        "holds",
        "holds_to_order",
    )


INTEGRAL = r"$$\int_0^{\pi} F\sin\theta\,d\theta = 2F$$"
VARYING = ["The force $F(\\theta)$ varies.", "La force $F$ varie.", "$F$ ändert sich mit dem Winkel."]
CONSTANT = ["The force $F$ is constant.", "It is $F (\\theta - 1)$, a product."]


@pytest.mark.parametrize("words", VARYING)
def test_what_varies_by_the_page_is_not_taken_out_of_an_integral(tmp_path, words):
    assert last_verdict(tmp_path, f"{words}\n\n{INTEGRAL}", SYMBOLS) == "undecided"


@pytest.mark.parametrize("words", CONSTANT)
def test_what_does_not_is(tmp_path, words):
    assert last_verdict(tmp_path, f"{words}\n\n{INTEGRAL}", SYMBOLS) == "conditional"


def test_a_formula_that_is_left_open_is_not_forgotten_under_a_derivative(tmp_path):
    lines = (r"l = q + r\cos\theta", r"\frac{dl}{d\theta} = 0")
    assert last_verdict(tmp_path, in_displays(lines), SYMBOLS) in ("undecided", "refuted")
