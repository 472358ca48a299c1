"""Short passages by writers who had not seen the checker: nothing right is refuted."""

import pytest

from tests.passages import PASSAGES, outcomes

FOUND = {"course": 283, "drive-and-balance": 296, "strength-and-engines": 293}
"""Wrong formulas that are refuted."""
SLACK = 0.97
"""Some are found by a search that a busy machine may cut off."""
CONFIRMED = 1
"""An arithmetic that is right, of a factor that its words make upside down."""


@pytest.mark.slow
@pytest.mark.parametrize("name", FOUND)
def test_passages(name: str):
    found = outcomes(PASSAGES / f"{name}.toml")
    assert [text for kind, text, said in found if kind != "wrong" and said == "refuted"] == []
    wrong = [said for kind, _, said in found if kind == "wrong"]
    assert wrong.count("confirmed") <= CONFIRMED
    assert wrong.count("refuted") >= SLACK * FOUND[name]


def test_every_file_of_passages_is_tested():
    assert {path.stem for path in PASSAGES.glob("*.toml")} == set(FOUND)
