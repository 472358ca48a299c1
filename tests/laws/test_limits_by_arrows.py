r"""Limits that are written with an arrow are judged: for x → 0 sin x/x → 1."""

import pytest

from symbalance.checking import check

PROVED = {"holds", "conditional", "holds_to_order"}
PAGES = [
    "For $x \\to 0$ we have $\\frac{\\sin x}{x} \\to CLAIM$.",
    "We have $\\frac{\\sin x}{x} \\to CLAIM$ for $x \\to 0$.",
    "As $x \\rightarrow 0$,\n\n$$\\frac{\\sin x}{x} \\rightarrow CLAIM$$",
    "$$\\frac{\\sin x}{x} \\to CLAIM \\quad (x \\to 0)$$",
    "Für $x \\to 0$ geht $\\frac{\\sin x}{x} \\to CLAIM$.",
    "$y = \\frac{\\sin x}{x}$. For $x \\to 0$ it becomes $y \\to CLAIM$.",
    "$y = \\frac{\\sin x}{x}$. For $x \\to 0$ we get $y = CLAIM$.",
    "$y = \\frac{x}{1 + x}$. Pour $x \\to \\infty$ on a $y \\to CLAIM$.",
    "$y = \\frac{x}{1 + x}$. Per $x → ∞$ si ha $y → CLAIM$.",
]


@pytest.mark.parametrize("page", PAGES)
@pytest.mark.parametrize(("claim", "is_right"), [("1", True), ("2", False), ("0", False)])
def test_a_limit_by_an_arrow_is_judged(page, claim, is_right):
    last = check(page.replace("CLAIM", claim)).verdicts[-1]
    assert (last.verdict in PROVED) == is_right
    assert is_right or last.verdict == "refuted"


@pytest.mark.parametrize(
    "page",
    [
        "The map $f: A \\to B$ is given.",
        "It turns from $0° \\to 180°$.",
        "The gas goes $1 \\to 2$.",
        "With $x \\to 0$ in mind. The state changes $A \\to B$.",
    ],
)
def test_another_arrow_is_no_limit(page):
    assert not check(page).verdicts
