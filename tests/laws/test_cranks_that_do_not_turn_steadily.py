"""Nothing holds by a steady, centred crank where the page's own line says that its crank is another."""

from __future__ import annotations

import pytest

from tests.checked_pages import in_displays, last_verdict

SYMBOLS = """[symbols]
"theta" = "crank angle"
"beta" = "rod angle"
"omega" = "angular speed"
"t" = "time"
"r" = "crank radius"
"l" = "rod length"
"lambda" = "crank ratio r/l"
"alpha" = "a constant"
"omega_0" = "a constant"
"theta_0" = "a constant"
"delta" = "a constant"
"varphi_0" = "a constant"
"e" = "distance of the two axes"
"""
WRONG = [
    (r"\theta = \omega t + \alpha t^2", r"\ddot\theta = 0"),
    (r"\theta = \omega t + \alpha t^2", r"\ddot\theta = \alpha"),
    (r"\theta = \alpha t^2", r"\dot\theta = \alpha t"),
    (r"\omega = \omega_0 + \alpha t", r"\frac{d\omega}{dt} = 0"),
    (r"\omega = \omega_0(1+\delta\sin\theta)", r"\frac{d^2}{dt^2} r\cos\theta = -r\omega^2\cos\theta"),
    (r"\theta = \omega_0 t + \frac12\alpha t^2", r"\dot\theta = \omega_0 + \frac12\alpha t"),
    (
        r"\theta = \omega t + \varphi_0\sin(2\omega t)",
        r"\dot\theta = \omega + \varphi_0\omega\cos(2\omega t)",
    ),
    (r"\ddot\theta = \alpha", r"\frac{d\omega}{dt} = 0"),
    (r"\ddot\theta = \alpha", r"\frac{d^2}{dt^2}\cos\theta = -\omega^2\cos\theta"),
    (r"\dot\omega \ne 0", r"\ddot\theta = 0"),
    (r"\theta = \omega t + \theta_0", r"\theta = \omega t - \theta_0"),
    (r"l\sin\beta = r\sin\theta - e", r"\sin\beta = \lambda\sin\theta + 7\frac{e}{l}"),
]
RIGHT = [
    (r"\theta = \omega t + \alpha t^2", r"\ddot\theta = 2\alpha"),
    (r"\theta = \alpha t^2", r"\dot\theta = 2\alpha t"),
    (r"\omega = \omega_0 + \alpha t", r"\frac{d\omega}{dt} = \alpha"),
    (r"\theta = \omega_0 t + \frac12\alpha t^2", r"\dot\theta = \omega_0 + \alpha t"),
    (r"\ddot\theta = \alpha", r"\frac{d^2}{dt^2}\cos\theta = -\omega^2\cos\theta - \alpha\sin\theta"),
    (r"\theta = \omega t + \theta_0", r"\omega t = \theta - \theta_0"),
    (r"\theta = \omega t", r"\frac{d^2}{dt^2} r\cos\theta = -r\omega^2\cos\theta"),
]
PROVED = ("holds", "holds_to_order", "conditional")


@pytest.mark.parametrize("lines", WRONG)
def test_what_a_steady_crank_does_does_not_hold(tmp_path, lines):
    assert last_verdict(tmp_path, in_displays(lines), SYMBOLS) not in (*PROVED, "definition", "premise")


@pytest.mark.parametrize("lines", RIGHT)
def test_what_this_crank_does_holds(tmp_path, lines):
    assert last_verdict(tmp_path, in_displays(lines), SYMBOLS) in PROVED
