r"""A series is not proved by a number that happens to fit, nor where its letter is said to be large."""

import pytest

from symbalance.checking import check

PROVED = {"holds", "conditional", "holds_to_order"}


@pytest.mark.parametrize(
    ("left", "wrong", "right"),
    [
        ("\\sqrt{1-D^2}", "1 - D", "1 - D^2/2"),
        ("\\frac{1}{1-D}", "1 + 2D", "1 + D"),
        ("\\frac{1}{1+D}", "1 + D", "1 - D"),
        ("\\sqrt{1+D}", "1 + D", "1 + D/2"),
        ("\\cos D", "1 - D", "1 - \\frac{D^2}{2}"),
        ("e^{D}", "1 - D", "1 + D"),
    ],
)
@pytest.mark.parametrize("number", ["0.05", "0.02", "0.01"])
def test_a_number_proves_no_series(left, wrong, right, number):
    page = f"$D = {number}$\n\n${left} \\approx CLAIM$"
    assert check(page.replace("CLAIM", wrong)).verdicts[-1].verdict not in PROVED
    assert check(page.replace("CLAIM", right)).verdicts[-1].verdict in PROVED


@pytest.mark.parametrize("claim", ["\\sqrt{1-D^2} \\approx 0.9987", "\\sqrt{1-D^2} \\approx 1"])
def test_a_number_is_proved_by_numbers(claim):
    assert check(f"$D = 0.05$\n\n${claim}$").verdicts[-1].verdict in PROVED


@pytest.mark.parametrize(
    "page",
    [
        "For $\\eta > 2$ we have\n\n$\\frac{1}{1-\\eta^2} \\approx 1 + \\eta^2$",
        "With $x = 3$: $\\sin x \\approx x$",
        "For large $\\eta$, $\\eta \\gg 1$:\n\n$\\frac{1}{1-\\eta^2} \\approx 1 + \\eta^2$",
        "$q = 5$. $\\sqrt{1 + q} \\approx 1 + q/2$",
    ],
)
def test_what_is_said_to_be_large_is_not_taken_for_small(page):
    last = check(page).verdicts[-1]
    assert last.verdict not in PROVED


@pytest.mark.parametrize(
    "page",
    [
        "For small $\\eta$ we have\n\n$\\frac{1}{1-\\eta^2} \\approx 1 + \\eta^2$",
        "With $x = 0.03$: $\\sin x \\approx x$",
        "For $\\eta < 1$: $\\frac{1}{1-\\eta^2} \\approx 1 + \\eta^2$",
    ],
)
def test_what_may_be_small_is(page):
    assert check(page).verdicts[-1].verdict in PROVED
