"""Cranks that a page places in groups are where it says: cranks 1 and 4 at 0, cranks 2 and 3 at 180°."""

import pytest

from symbalance.checking import check
from symbalance.notes.checking.words.crank_angles_listed import crank_angles


@pytest.mark.parametrize(
    "words",
    [
        "With cranks 1 and 4 at $0$ and cranks 2 and 3 at $180^{\\circ}$ one finds",
        "Die Kröpfungen 1 und 4 stehen bei 0°, 2 und 3 bei 180°.",
        "Cylinders 1, 4 at 0°, 2 and 3 at 180°.",
        "Manetons 1 et 4 à 0°, 2 et 3 à 180°.",
    ],
)
def test_groups_of_cranks_are_read(words):
    assert [list(map(int, each.degrees)) for each in crank_angles(words)] == [[0, 180, 180, 0]]


@pytest.mark.parametrize(
    "words", ["Cranks 1 and 2 at 90° to each other.", "Cranks 1 and 3 at 0° and 2 and 3 at 180°."]
)
def test_what_leaves_a_crank_open_is_no_list(words):
    assert crank_angles(words) == ()


@pytest.mark.parametrize(("total", "verdict"), [(4, "conditional"), (2, "refuted")])
def test_a_sum_goes_over_the_groups_of_its_own_section(total, verdict):
    page = (
        "## Three lines\n\nCranks at $0$, $120^{\\circ}$ and $240^{\\circ}$.\n\n## Four lines\n\n"
        "With cranks 1 and 4 at $0$ and cranks 2 and 3 at $180^{\\circ}$ one finds"
        f" $\\sum_i\\cos 2\\alpha_i = {total}$."
    )
    assert check(page, fixes=False).data()["links"][-1]["verdict"] == verdict
