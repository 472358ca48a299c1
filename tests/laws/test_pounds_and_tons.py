"""A pound is a mass or a force, a ton one of three: what holds in one of these readings is right."""

import pytest

from symbalance.checking import check

RIGHT = (
    "C = 20600 ft.-lb. ≈ 9.2 ft.-tons",
    "E = 33600 foot-pounds = 15 foot-tons.",
    "M = 247200 in.-lb. = 110.4 in.-tons",
    "F = 12000 lb = 6 tons = 53.4 kN",
    "σ = 15 tons per sq. in. = 33600 lb. per sq. in. = 232 MPa",
    "k = 500 lb/in = 87.6 N/mm.",
    "k = 500 lb. per in. = 87.6 N/mm.",
    "w = 3 lb/ft = 4.46 kg/m",
    "U = 17.9 lb-in = 206 kg·mm",
    "T = 286 oz-in = 2.02 N m",
)
WRONG = (
    "C = 20600 ft.-lb. ≈ 8.2 ft.-tons",
    "E = 33600 foot-pounds = 25 foot-tons.",
    "M = 247200 in.-lb. = 9.2 in.-tons",
    "F = 12000 lb = 8 tons",
    "σ = 15 tons per sq. in. = 36300 lb. per sq. in.",
    "k = 500 lb/in = 78.6 N/mm.",
    "w = 3 lb/ft = 6.46 kg/m",
    "U = 17.9 lb-in = 306 kg·mm",
    "T = 286 oz-in = 20.2 N m",
)
REFUTED = ("refuted", "contradiction")


@pytest.mark.parametrize("page", RIGHT)
def test_what_holds_for_pounds_as_a_mass_or_as_a_force_is_right(page):
    verdicts = [v.verdict for v in check(page + "\n").verdicts]
    assert verdicts
    assert not {*verdicts} & {*REFUTED, "undecided", "unreadable"}


@pytest.mark.parametrize("page", WRONG)
def test_what_holds_for_neither_is_refuted(page):
    assert any(v.verdict in REFUTED for v in check(page + "\n").verdicts)
