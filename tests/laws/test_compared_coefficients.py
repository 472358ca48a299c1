"""The coefficients of two forms of one equation of motion that words compare are the same."""

from __future__ import annotations

import pytest

from tests.checked_pages import verdicts_of

FIRST = r"$\ddot{x} + 2\delta\dot{x} + \omega_0^2 x = 0$"
ENGLISH = (
    rf"The motion obeys {FIRST}. "
    rf"Comparing with $m\ddot{{x}} + b\dot{{x}} + k x = 0$ gives $\delta = VALUE$."
)
GERMAN = (
    rf"Es gilt {FIRST}. Der Vergleich der Koeffizienten mit $m\ddot{{x}} + b\dot{{x}} + k x = 0$ "
    rf"liefert $\delta = VALUE$."
)
FRENCH = rf"On a {FIRST}. On l'identifie à $m\ddot{{x}} + b\dot{{x}} + k x = 0$, d'où $\delta = VALUE$."
ITALIAN = (
    rf"Si ha {FIRST}. Confrontando con $m\ddot{{x}} + b\dot{{x}} + k x = 0$ si ottiene $\delta = VALUE$."
)


@pytest.mark.parametrize("page", [ENGLISH, GERMAN, FRENCH, ITALIAN])
@pytest.mark.parametrize(
    ("value", "is_right"), [(r"\frac{b}{2m}", True), (r"\frac{b}{m}", False), (r"\frac{2m}{b}", False)]
)
def test_a_letter_follows_from_the_coefficients(tmp_path, page, value, is_right):
    last = verdicts_of(tmp_path, page.replace("VALUE", value))[-1]
    assert (last != "refuted") is is_right


def test_two_bodies_are_not_compared(tmp_path):
    second = r"the second one $m\ddot{x} + b\dot{x} + k x = 0$. Choose $\delta = \frac{b}{m}$."
    assert "refuted" not in verdicts_of(tmp_path, f"The first body has {FIRST}, {second}")
