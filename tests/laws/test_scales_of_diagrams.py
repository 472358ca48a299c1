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


@pytest.mark.parametrize("wrong", ["1 cm = 100 mm", "1 mm = 0.1 m", "50 N m = 50 N"])
def test_a_conversion_is_judged(wrong):
    assert verdicts_in(f"Here {wrong}.") == ["refuted"]
