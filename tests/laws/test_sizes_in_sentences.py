"""A size that a sentence gives in words goes before the number that a line above gives its letter."""

import pytest

from symbalance.checking import check

PROVED = ("holds", "holds_to_order", "conditional")
SPRING = r"With $m = 2$ kg and $k = 200$ N/m: $\omega_0 = \sqrt{k/m} = 10$ rad/s. "
FORCE = r"With $m = 0.5$ kg, $r = 40$ mm, $\omega = 300$ rad/s: $F = mr\omega^2 = 1800$ N. "
TORQUE = r"At $n=3000$ rpm and $P=60$ kW the torque is $M = \frac{P}{2\pi n} = 191$ N m. "
FACTOR = r"At $\theta=60^\circ$ the factor is $\cos\theta+\frac14\cos2\theta = 0.375$. "
VOLUME = r"Avec $d = 80$ mm et $s = 90$ mm, $V = \frac\pi4 d^2 s = 452$ cm³. "


def last_word(page: str) -> str:
    return check(page + "\n", fixes=False).data()["links"][-1]["verdict"]


@pytest.mark.parametrize(
    "page",
    [
        SPRING + r"With a mass of 8 kg: $\omega_0 = 5$ rad/s.",
        TORQUE + "At 6000 rpm it is $M = 95.5$ N m.",
        FORCE + "Mit einer Masse von 0.4 kg ist $F = 1440$ N.",
        FORCE + "質量0.4 kgでは $F = 1440$ N。",
        FORCE + "For a radius of 50 mm $F = 2250$ N.",
        FORCE + "At half the speed it is $F = 450$ N.",
        FORCE + "At double the speed $F = 7200$ N.",
        VOLUME + "Avec un alésage de 90 mm, $V = 573$ cm³.",
        FACTOR + r"At 90 degrees it is $\cos\theta+\frac14\cos2\theta = -0.25$.",
    ],
)
def test_a_number_holds_with_the_size_of_its_sentence(page):
    assert last_word(page) in PROVED


@pytest.mark.parametrize(
    "page",
    [
        SPRING + r"With a mass of 8 kg: $\omega_0 = 10$ rad/s.",
        TORQUE + "At 6000 rpm it is $M = 191$ N m.",
        FORCE + "Mit einer Masse von 0.4 kg ist $F = 1800$ N.",
        FORCE + "At half the speed it is $F = 1800$ N.",
        FORCE + "At half the speed it is $F = 900$ N.",
        FACTOR + r"At 90 degrees it is $\cos\theta+\frac14\cos2\theta = 0.375$.",
    ],
)
def test_a_number_of_the_case_before_does_not(page):
    assert last_word(page) not in PROVED


@pytest.mark.parametrize(
    "page",
    [
        r"With $m = 0.5$ kg, $r = 40$ mm, $\omega = 300$ rad/s and a piston of 0.5 kg"
        r" $F = mr\omega^2 = 1800$ N.",
        r"Let $m = 0.5$ kg, $r = 40$ mm, $\omega = 300$ rad/s. With a tolerance of 2 mm the force is"
        r" $F = mr\omega^2 = 1800$ N.",
    ],
)
def test_a_size_of_something_else_changes_nothing(page):
    assert last_word(page) in PROVED
