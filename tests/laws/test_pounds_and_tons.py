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
    "p = 6400 lb/in² = 44.1 N/mm²",
    "U = 17.9 lb-in = 206 kg·mm",
    "T = 286 oz-in = 2.02 N m",
    "W = 5.5 lb. and r = 3.25 in.\n\nThe moment is W r = 17.9 lb. in.",
    "P = 7128 lb and A = 23.76 in².\n\np = P/A = 7128/23.76 = 300 psi",
    "P = 1000 lb. and v = 88 ft. per sec.\n\nH = P v = 160 hp",
    "p = 300 lb per sq. in., A = 12 sq. in.\n\nF = p A = 3600 lb",
    "p = 300 lb./sq.in., A = 12 sq.in.\n\nF = p A = 3600 lb",
    "p = 300 lb per sq in and A = 12 sq in.\n\nF = p A = 1.607 tons",
    "p = 300 lb/sq in and A = 12 sq in.\n\nF = p A = 1.8 tons",
    "W = 15 lb., v = 20 ft/s, g = 32.2 ft/s². E = W v²/(2 g) = 93.2 ft-lb",
    "W = 1.5 tons and h = 4 ft.\n\nThe work is E = W h = 6 ft.-tons.",
    "W = 161 lb, g = 32.2, k = 2000 lb/ft. ω = √(k g/W) = 20 rad/s",
    "W = 560 lb., r = 1.083 ft., g = 32.2 and ω = 27.08 radians per sec.\n\n"
    "F = (W/g) ω² r = (560/32.2) × 733.2 × 1.083 ≈ 13810 lb.",
    "W = 3 lb, r = 2.5 in, g = 386 and ω = 400 rad/s.\n\nF = W r ω²/g = 3·2.5·400²/386 = 3109 lb",
)
WRONG = (
    "C = 20600 ft.-lb. ≈ 8.2 ft.-tons",
    "E = 33600 foot-pounds = 25 foot-tons.",
    "M = 247200 in.-lb. = 9.2 in.-tons",
    "F = 12000 lb = 8 tons",
    "σ = 15 tons per sq. in. = 36300 lb. per sq. in.",
    "k = 500 lb/in = 78.6 N/mm.",
    "w = 3 lb/ft = 6.46 kg/m",
    "p = 6400 lb/in² = 41.4 N/mm²",
    "U = 17.9 lb-in = 306 kg·mm",
    "T = 286 oz-in = 20.2 N m",
    "W = 5.5 lb. and r = 3.25 in.\n\nThe moment is W r = 19.7 lb. in.",
    "P = 7128 lb. and A = 23.76 sq. in.\n\np = P/A = 30 lb. per sq. in.",
    "P = 1000 lb. and v = 88 ft. per sec.\n\nH = P v = 88 hp",
    "p = 300 lb per sq. in., A = 12 sq. in.\n\nF = p A = 6300 lb",
    "p = 300 lb./sq.in., A = 12 sq.in.\n\nF = p A = 300 lb",
    "p = 300 lb per sq in and A = 12 sq in.\n\nF = p A = 1.706 tons",
    "W = 15 lb., v = 20 ft/s, g = 32.2 ft/s². E = W v²/(2 g) = 186 ft-lb",
    "W = 1.5 tons and h = 4 ft.\n\nThe work is E = W h = 12 ft.-tons.",
    "W = 161 lb, g = 32.2, k = 2000 lb/ft. ω = √(k g/W) = 10 rad/s",
    "W = 560 lb., r = 1.083 ft., g = 32.2 and ω = 27.08 radians per sec.\n\n"
    "F = (W/g) ω² r = (560/32.2) × 733.2 × 1.083 ≈ 18310 lb.",
    "W = 3 lb, r = 2.5 in, g = 32.2, ω = 400 rad/s.\n\nF = W r ω²/g = 37267 lb",
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
