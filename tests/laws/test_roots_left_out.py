"""A root that an equation has beside the one a page goes on with is named as what is left out."""

import pytest

from symbalance.checking import check


def links(page: str) -> list[dict[str, object]]:
    return check(page, fixes=False).data()["links"]


@pytest.mark.parametrize(
    ("page", "left_out"),
    [
        ("$$x(x-1) = 0 \\Rightarrow x = 1$$", "x ≠ 0"),
        ("$$x^2 = 2x$$\n\nDividing by $x$:\n\n$$x = 2$$", "x ≠ 0"),
        ("$$x^2 - 5x + 6 = 0$$\n\nso $x = 2$.", "x ≠ 3"),
        ("$$y^2 - 3y = 0$$\n\nalso $y = 3$.", "y ≠ 0"),
        ("From $x^2 = 9$ it follows that $x = 3$.", "x ≥ 0"),
    ],
)
def test_one_root_of_two_holds_on_condition(page, left_out):
    for link in links(page)[1:]:
        assert link["verdict"] == "conditional"
        assert left_out in str(link["assumption"])


@pytest.mark.parametrize(
    "page",
    [
        "$$x^2 - 5x + 6 = 0$$\n\nso $x = 2$ or $x = 3$.",
        "$x^2 = 2x$ so $x = 2$ or $x = 0$.",
        "$$x^2 - 5x + 6 = 0$$\n\nThe smaller root is $x = 2$.",
        "$$x^2 - 5x + 6 = 0$$\n\nHence $x_1 = 2$, $x_2 = 3$.",
        "$$2x + 1 = 7$$\n\nso $x = 3$.",
        "$$x^3 - 8 = 0$$\n\nso $x = 2$.",
    ],
)
def test_a_root_that_is_the_only_one_or_one_of_those_named_holds_as_it_is(page):
    assert [link["verdict"] for link in links(page)[1:]] != []
    assert all(link["verdict"] in ("holds", "holds_to_order") for link in links(page)[1:])
