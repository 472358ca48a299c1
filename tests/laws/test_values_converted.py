"""A value that words say again in another unit is the same size, or wrong."""

from __future__ import annotations

import pytest

from tests.checked_pages import verdicts_of

FORCE = "The mass is $m = 500$ g. {} $m = {}$ kg it is heavy."
WRONG = [
    "Mit $v = 10$ m/s wird $v = 63$ km/h.",
    "With $v = 10$ m/s we get $v = 35$ km/h.",
    "Con $v = 10$ m/s si ha $v = 63$ km/h.",
    "Avec $m = 500$ g on a $m = 5$ kg.",
    FORCE.format("In SI units with", 5),
    "Die Masse ist $m = 500$ g. Umgerechnet ist $m = 5$ kg.",
]
RIGHT = [
    "Mit $v = 10$ m/s wird $v = 36$ km/h.",
    "With $n = 3000$ rpm we have $n = 50$ 1/s.",
    FORCE.format("In SI units with", 0.5),
    FORCE.format("For another body with", 5),
    "At $v = 10$ m/s and at $v = 63$ km/h.",
    "With $v = 10$ m/s it takes $t = 5$ s, with $v = 63$ km/h only $t = 3$ s.",
]


@pytest.mark.parametrize("page", WRONG)
def test_another_size_is_refuted(tmp_path, page):
    assert "refuted" in verdicts_of(tmp_path, page)


@pytest.mark.parametrize("page", RIGHT)
def test_the_same_size_and_another_case_are_not(tmp_path, page):
    assert not {"refuted", "contradiction"} & {*verdicts_of(tmp_path, page)}
