"""Letters that are differentiated, integrated or summed by get no number put in, and nothing breaks."""

from __future__ import annotations

import pytest

import symbalance as sb

PINS = "The crank pins are at 0°, 180°, 180°, 0°.\n\n"
SPEED = "n = 3000 1/min: $ω = 2πn$.\n\n"


@pytest.mark.parametrize(
    "page",
    [
        PINS + r"$$\sum_i \frac{d}{d\theta_i} \sin\theta_i = 0$$",
        PINS + r"$$\sum_i \int_0^{\theta_i} \cos\theta_i d\theta_i = 0$$",
        SPEED + r"$$ω = \int_0^1 \frac{n π}{30} dn$$",
        SPEED + r"$$ω = \frac{d}{dn} \frac{π n^2}{60}$$",
        SPEED + r"$$ω = \lim_{n \to 0} \frac{n π}{30}$$",
    ],
)
def test_a_bound_letter_is_no_fault(page):
    checked = sb.check(page + "\n", {})
    assert not checked.faults
    assert not any("fault of symbalance" in each.reason for each in checked.verdicts)


@pytest.mark.parametrize("number", ["1e400", "1e200^2", "1e-400", r"10^{200} \cdot 10^{200}"])
@pytest.mark.parametrize("letter", ["J_1", "z_2", "F", "k"])
def test_a_number_beyond_floats_is_no_fault(letter, number):
    checked = sb.check(f"${letter} = {number}$ and ${letter} = 2 a {number}$\n", {})
    assert not checked.faults


def test_the_digits_of_a_number_below_floats_are_counted():
    checked = sb.check("k = 25/100 = 1/4 (c = 25, d = 100/10^{400} = 50)\n", {})
    assert not checked.faults
    assert [one.verdict for one in checked.verdicts].count("refuted") == 1
