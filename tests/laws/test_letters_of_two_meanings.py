"""A letter that words and units make another quantity's has two meanings, and no slip in its unit."""

from __future__ import annotations

import pytest

from tests.checked_pages import verdicts_of

POWER = (
    "The torque is $T = 200$ N m. The temperature is $T = 300$ K. "
    "The power at $\\omega = 100$ rad/s is $P = T\\omega = {}$ kW."
)
RIGHT = [
    POWER.format(20),
    "$T$ is the torque, $T = 200$ N m. The temperature $T = 300$ K.",
    "Das Drehmoment ist $M = 200$ N m. Die Masse ist $M = 300$ kg.",
    "Il momento è $M = 200$ N m. La massa è $M = 300$ kg.",
    "The torque $T = 200$ N m. The period is $T = 0.5$ s.",
]
WRONG = [
    POWER.format(21),
    "The torque is $T = 200$ N m. The torque is $T = 300$ K.",
    "The torque is $T = 200$ N m. So $T = 200$ N.",
    "The torque is $M = 200$ N m. With the force it is $M = 200$ N.",
    "The torque is $M = 200$ N m. The moment of the force is $M = 200$ N.",
    "The torque is $T = 200$ N m. The force is $T = 200$ N m.",
]


@pytest.mark.parametrize("page", RIGHT)
def test_two_meanings_are_no_contradiction(tmp_path, page):
    assert not {"refuted", "contradiction"} & {*verdicts_of(tmp_path, page)}


@pytest.mark.parametrize("page", WRONG)
def test_a_unit_that_the_noun_does_not_ask_for_is_one(tmp_path, page):
    assert verdicts_of(tmp_path, page)[-1] == "refuted"
