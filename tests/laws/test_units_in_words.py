"""A unit in words counts with all of its words: radians per second are no radians."""

import pytest

from symbalance.checking import check

RIGHT = (
    "The crank turns at N = 1800 revolutions per minute.\n\nω = 2 π N/60 = 188.5 radians per second.",
    "The speed is v = 88 ft. per sec. and R = 3.25 ft.\n\nω = v/R = 88/3.25 = 27.08 radians per sec.",
    r"Die Winkelgeschwindigkeit ist $\omega = 2\pi\cdot 50 = 314$ Radiant pro Sekunde.",
    r"La vitesse angulaire est $\omega = 2\pi\cdot 50 = 314$ radians par seconde.",
    "La velocità angolare è ω = 2π·50 = 314 radianti al secondo.",
    "Stroke s = 80 mm, n = 50 1/s. The mean piston speed is c = 2 s n = 8 metres a second.",
    "Stroke s = 80 mm, n = 50 1/s. The mean piston speed is c = 2 s n = 480 metres per minute.",
    "r = 40 mm and ω = 300 radians per second, so r ω² = 3600 metres per second squared.",
    "g = 32.2 feet per second per second = 9.81 metres per second per second.",
    "n = 25 revolutions per second = 1500 revolutions per minute",
    "k = 1000 newtons per millimetre, x = 2 mm, and F = k x = 2000 N.",
    "k = 2000 newton metres per radian, J = 0.2 kilogram metres squared, ω = √(k/J) = 100 rad/s",
    "c = 4 newton-seconds per metre, v = 2 metres per second, F = c v = 8 newtons",
    "v = 60 miles per hour = 88 feet per second",
)
WRONG = (
    "The speed is v = 88 ft. per sec. and R = 3.25 ft.\n\nω = v/R = 88/3.25 = 37.08 radians per sec.",
    "The speed is v = 88 ft. per sec. and R = 3.25 ft.\n\nω = v/R = 88/3.25 = 27.08 ft. per sec.",
    r"La vitesse angulaire est $\omega = 2\pi\cdot 50 = 414$ radians par seconde.",
    "Stroke s = 80 mm, n = 50 1/s. The mean piston speed is c = 2 s n = 80 metres a second.",
    "Stroke s = 80 mm, n = 50 1/s. The mean piston speed is c = 2 s n = 8 metres per minute.",
    "r = 40 mm and ω = 300 radians per second, so r ω² = 3600 metres per second.",
    "g = 32.2 feet per second per second = 9.81 metres per second.",
    "n = 25 revolutions per second = 150 revolutions per minute",
    "k = 1000 newtons per millimetre, x = 2 mm, and F = k x = 2 N.",
    "k = 2000 newton metres per radian, J = 0.2 kilogram metres squared, ω = √(k/J) = 10 rad/s",
    "c = 4 newton-seconds per metre, v = 2 metres per second, F = c v = 80 newtons",
    "v = 60 miles per hour = 98 feet per second",
)
REFUTED = ("refuted", "contradiction")


@pytest.mark.parametrize("page", RIGHT)
def test_a_right_unit_in_words_is_not_refuted(page):
    verdicts = [v.verdict for v in check(page + "\n").verdicts]
    assert verdicts
    assert not {*verdicts} & {*REFUTED, "unreadable"}


@pytest.mark.parametrize("page", WRONG)
def test_a_wrong_unit_in_words_is_refuted(page):
    assert any(v.verdict in REFUTED for v in check(page + "\n").verdicts)
