"""An order of a torque whose two factors stand in the prose has the sign and size of their product."""

from __future__ import annotations

import pytest

from tests.checked_pages import last_in

FORCE = r"$-m r\omega^2(\cos\theta+\lambda\cos 2\theta)$"
LEVER = r"$r\left(\sin\theta+\frac{\lambda}{2}\sin 2\theta\right)$"
PAGES = [
    f"Multiply the inertia force {FORCE} by {LEVER}. The second-order part of the torque is ",
    f"Man multipliziert die Massenkraft {FORCE} mit {LEVER}. Der Anteil zweiter Ordnung ist ",
    f"En multipliant la force d'inertie {FORCE} par {LEVER}. La partie du deuxième ordre est ",
    f"Moltiplicando la forza d'inerzia {FORCE} per {LEVER}. La parte del secondo ordine è ",
    f"慣性力 {FORCE} に {LEVER} を掛ける。トルクの2次成分は ",
]


@pytest.mark.parametrize("page", PAGES)
def test_the_second_order_has_the_sign_of_the_product(page: str) -> None:
    assert last_in(page + r"$M_2 = -\frac{1}{2} m r^2\omega^2\sin 2\theta$.") != "refuted"
    for wrong in (r"\frac{1}{2} m r^2", r"-2 m r^2", r"-m r^2"):
        assert last_in(page + rf"$M_2 = {wrong}\omega^2\sin 2\theta$.") == "refuted"


def test_the_third_order_too() -> None:
    page = PAGES[0].replace("second-order", "third-order")
    assert last_in(page + r"$M_3 = -\frac{3\lambda}{4} m r^2\omega^2\sin 3\theta$.") != "refuted"
    assert last_in(page + r"$M_3 = \frac{3\lambda}{4} m r^2\omega^2\sin 3\theta$.") == "refuted"


@pytest.mark.parametrize(
    "words",
    [
        "The second-order part for all four cylinders is $M_2 = -2 m r^2\\omega^2\\sin 2\\theta$.",
        "The amplitude of the second-order part is $M_2 = \\frac{1}{2} m r^2\\omega^2$.",
    ],
)
def test_more_cylinders_or_a_mere_size_are_not_accused(words: str) -> None:
    page = PAGES[0].partition(" The second")[0]
    assert last_in(f"{page} {words}") != "refuted"
