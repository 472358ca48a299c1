"""A steady number above refutes nothing that is said of a letter's change."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check


@pytest.mark.parametrize(
    ("page", "word"),
    [
        ("ω = 31.42 rad/s\n\nthen dω/dt > 0\n", "undecided"),
        ("ω = 31.42 rad/s\n\nthe speed falls: dω/dt < 0\n", "undecided"),
        ("x = 3 sin t\n\ndx/dt = 3 cos t\n", "holds"),
        ("x = 3 sin t\n\ndx/dt = 3 sin t\n", "refuted"),
    ],
)
def test_a_rate_is_judged_by_a_motion_and_not_by_one_number(page, word):
    assert check(page, {"y": "variable"}).verdicts[-1].verdict == word
