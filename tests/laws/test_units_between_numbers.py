"""A 12 of feet and inches, or the 3.6 of km/h, converts the numbers of a formula, and only these."""

import pytest

from symbalance.checking import check

INCHES = "Stroke s = 6.5 in. and N = 1800 rpm.\n\n"
RIGHT = (
    INCHES + "The mean piston speed is 2 s N/12 = 1950 ft. per min.",
    INCHES + "The mean piston speed is V = s N/6 = 6.5 × 1800/6 = 1950 feet per minute.",
    INCHES + "The mean piston speed is V = s N/360 = 32.5 ft. per sec.",
    INCHES + "The crank radius is r = s/24 = 0.2708 ft.",
    "D = 78 in., N = 258.6 rpm. The rim runs at π D N/12 = 5281 feet per minute.",
    "W = 360 lb. and a = 18 in. The couple is C = W a/12 = 540 ft.-lb.",
    "W = 10 lb, r = 6 in, ω = 100 rad/s. F = W r ω²/(12·32.2) = 1553 lb",
    r"Die Geschwindigkeit ist $V = 90$ km/h. $v = V/3{,}6 = 90/3{,}6 = 25$ m/s",
    "車速 V = 90 km/h、v = V/3.6 = 25 m/s。",
    r"La vitesse est $v = 25$ m/s, $V = 3{,}6\,v = 90$ km/h.",
)
WRONG = (
    INCHES + "The mean piston speed is 2 s N/12 = 1590 ft. per min.",
    INCHES + "The mean piston speed is V = s N/12 = 975 ft. per min.",
    INCHES + "The crank radius is r = s/24 = 2.167 ft.",
    "D = 78 in., N = 258.6 rpm. The rim runs at π D N/12 = 2581 feet per minute.",
    "W = 360 lb. and a = 18 in. The couple is C = W a/12 = 450 ft.-lb.",
    "W = 10 lb, r = 6 in, ω = 100 rad/s. F = W r ω²/(12·32.2) = 1853 lb",
    r"Die Geschwindigkeit ist $V = 90$ km/h. $v = V/3{,}6 = 52$ m/s",
    r"Die Geschwindigkeit ist $v = 90$ m/s. $V = v/3{,}6 = 25$ km/h",
    "車速 V = 90 km/h、v = 3.6 V = 324 m/s。",
    r"$U = \frac{\sqrt3}{2}\cdot 0.0058 = \SI{5.02e-3}{kg.m} = \SI{50.2}{kg.mm}$",
)
REFUTED = ("refuted", "contradiction")


@pytest.mark.parametrize("page", RIGHT)
def test_a_number_that_converts_units_is_right(page):
    verdicts = [v.verdict for v in check(page + "\n").verdicts]
    assert verdicts
    assert not {*verdicts} & {*REFUTED, "undecided", "unreadable"}


@pytest.mark.parametrize("page", WRONG)
def test_a_number_that_converts_nothing_excuses_nothing(page):
    assert any(v.verdict in REFUTED for v in check(page + "\n").verdicts)
