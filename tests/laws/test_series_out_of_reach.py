"""Series hold where they have a sum: not for a number of the page beyond it, whatever their powers."""

import pytest

from tests.checked_pages import last_in

PROVED = ("holds", "holds_to_order", "conditional")


GEOMETRIC = "Let $q = {}$. Then $$\\sum_{{k=0}}^{{\\infty}} q^k = \\frac{{1}}{{1-q}}.$$"
LOGARITHM = "With $x = {}$:\n\n$$\\ln(1+x) = x - \\frac{{x^2}}{{2}} + \\frac{{x^3}}{{3}} - \\ldots$$"
SINE = "With $x = {}$:\n\n$$\\sin x = x - \\frac{{x^3}}{{6}} + \\frac{{x^5}}{{120}} - \\ldots$$"
EXPONENTIAL = "Let $x = {}$. Then $$e^x = \\sum_{{k=0}}^{{\\infty}} \\frac{{x^k}}{{k!}}.$$"
SMALL = (
    "The angle is $\\theta = {}^\\circ$.\n\nSince $\\theta$ is small, $\\sin\\theta \\approx \\theta$."
)


@pytest.mark.parametrize(
    ("page", "inside", "outside"),
    [(GEOMETRIC, "0.5", "2"), (LOGARITHM, "0.3", "3"), (SMALL, "8", "80")],
)
def test_a_series_holds_only_within_its_reach(page, inside, outside):
    assert last_in(page.format(inside)) in PROVED
    assert last_in(page.format(outside)) == "undecided"


@pytest.mark.parametrize("page", [SINE, EXPONENTIAL])
def test_what_has_a_sum_everywhere_holds_everywhere(page):
    assert last_in(page.format("3")) in PROVED
