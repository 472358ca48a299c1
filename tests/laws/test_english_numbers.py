"""Bare numbers that are an English unit away from their letters are open, and accused of nothing."""

import pytest

from symbalance.checking import check

PAGE = (
    "The stroke is 24 in. Here r = 12 in., and g = 32·2 ft. per sec. per sec.\n\n"
    "The load per inch at the crank pin is\n\n     q = w ω² r/g ,\n\nr being here in feet. With ω = 15·71"
    " radians per second, and w = 0·28 × 7·07 = 1·98 lb.\n\n     q = {} lb. per inch,\n"
)


def last(page: str) -> str:
    return check(page, fixes=False).data()["links"][-2]["verdict"]


def test_numbers_of_inches_and_feet_are_open():
    assert last(PAGE.format("1·98 × 15·71² × 1/32·2 = 15·18")) == "undecided"


@pytest.mark.parametrize("numbers", ["1·98 × 15·71² × 2/32·2 = 30·35", "1·98 × 17·51² × 1/32·2 = 18·85"])
def test_others_are_not_proved(numbers):
    assert last(PAGE.format(numbers)) in ("refuted", "undecided")
