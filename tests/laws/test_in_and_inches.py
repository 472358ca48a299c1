"""The word in behind a formula is an inch at a clause's end, and none before a reference."""

import pytest

from symbalance.notes.checking import check


@pytest.mark.parametrize(
    ("page", "source"),
    [
        ("Putting $c = \\tfrac12$ in \\eqref{eq:res}, we get half.", "\\tfrac12"),
        ("Putting $c = 3$ in Eq. 4, we get half.", "3"),
        ("With $c = \\frac12$ in \\ref{a}.", "\\frac12"),
        ("Its length is $c = 7$ in. Then it turns.", "7$ in"),
        ("Its length is $c = 7$ in, and it turns.", "7$ in"),
    ],
)
def test_what_is_read(page, source):
    (verdict,) = check(page + "\n").verdicts
    assert verdict.data()["source"] == source
