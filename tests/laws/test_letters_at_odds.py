"""A letter that two sections give different formulas: wrong by a slip, or another engine's."""

import pytest

from symbalance.checking import check

OTHER = """The single has $F = m r ω² \\cos θ$ at any crank angle θ.

# Another rig

The rig of the second chapter has $F = {right}$ in its bearing.
"""


def verdicts(right: str, **options: bool) -> list[tuple[str, str | None]]:
    links = check(OTHER.replace("{right}", right), **options).data()["links"]
    return [(link["verdict"], link["reason"]) for link in links]


@pytest.mark.parametrize(
    "right", ["m r ω² \\cos 2θ", "-m r ω² \\cos θ", "2 m r ω² \\cos θ", "m r ω \\cos θ", "m r ω² \\sin θ"]
)
@pytest.mark.parametrize("fixes", [True, False])
def test_a_slip_from_the_formula_above_is_refuted(right: str, fixes: bool) -> None:
    assert [verdict for verdict, _ in verdicts(right, fixes=fixes)] == ["definition", "refuted"]


@pytest.mark.parametrize(
    "right", ["m r ω² (\\cos θ + 4 \\cos (3θ - 1))", "m r ω² (7 \\sin (5θ + 1) + \\tan θ)"]
)
@pytest.mark.parametrize("fixes", [True, False])
def test_what_no_slip_explains_may_be_another_engines(right: str, fixes: bool) -> None:
    (first, _), (second, reason) = verdicts(right, fixes=fixes)
    assert (first, second) == ("definition", "undecided")
    assert reason == "not the F of line 1, and no single slip lies between: used anew, or wrong"
