"""1 mm = 50 N m is the scale of a diagram, and no equation; 1 cm = 100 mm is a wrong conversion."""

import pytest

from tests.checked_pages import verdicts_in


@pytest.mark.parametrize(
    "scale",
    [
        "1 mm = 50 N m",
        "1 mm = 2°",
        "$1\\,\\mathrm{cm} = 5\\,\\mathrm{kN}$",
        "$1\\,\\mathrm{cm} = 2^\\circ$",
    ],
)
def test_a_scale_is_given(scale):
    assert verdicts_in(f"The diagram is drawn to the scale {scale}.") == ["premise"]


@pytest.mark.parametrize(
    "page",
    [
        "Torque scale: 1 mm = 50 N m, crank angle scale: 1 mm = 2°.",
        "Maßstab: 1 mm = 50 N m.",
        "線図の縮尺は 1 mm = 50 N m である。",
    ],
)
def test_a_scale_is_given_where_a_scale_is_named(page):
    assert set(verdicts_in(page)) == {"premise"}


def test_one_length_is_no_other_quantity_where_nothing_is_drawn():
    assert verdicts_in("We find that 1 m = 50 N holds.") == ["refuted"]


@pytest.mark.parametrize("wrong", ["1 cm = 100 mm", "1 mm = 0.1 m", "50 N m = 50 N"])
def test_a_conversion_is_judged(wrong):
    assert verdicts_in(f"Here {wrong}.") == ["refuted"]
