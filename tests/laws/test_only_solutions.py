"""A solution that words call the only one is refuted where another one turns up."""

import pytest

from symbalance.checking import check

PROVED = ("holds", "holds_to_order", "conditional", "condition")


def last_link(page: str) -> dict[str, object]:
    return check(page, fixes=False).data()["links"][-1]


@pytest.mark.parametrize(
    ("page", "other"),
    [
        ("$x^2 = 4$, and $x = 2$ is the only solution.", "x = -2"),
        ("$x^2 - 5x + 6 = 0$. Die einzige Lösung ist $x = 2$.", "x = 3"),
        ("$x^2 - 3.7x + 3 = 0$. The only solution is $x = 2.5$.", "x ≈ 1.2"),
        ("$y^4 = 81$. La seule solution est $y = 3$.", "y = -3"),
        ("From $x(x-1) = 0$, $x = 1$ is the only root.", "x = 0"),
    ],
)
def test_another_solution_refutes_that_it_is_the_only_one(page, other):
    link = last_link(page)
    assert link["verdict"] == "refuted"
    assert other in str(link["reason"])


@pytest.mark.parametrize(
    "page",
    [
        "$x^2 = 4$, and $x = 2$ is a solution.",
        "$x^3 = 8$, and $x = 2$ is the only real solution.",
        "$x^2 - 4x + 4 = 0$. The only solution is $x = 2$.",
        "$x^2 = 4$ with $x > 0$. $x = 2$ is the only solution.",
        "$1/x = 2$. The only solution is $x = 1/2$.",
        "$\\cos\\theta = 0$. $\\theta = 90°$ is the only solution.",
    ],
)
def test_the_only_solution_where_it_lies_is_one(page):
    assert last_link(page)["verdict"] in PROVED
