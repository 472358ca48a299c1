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


OF_UNITS = (
    (r"$P = ?, $n=3000$ rpm. $$M = 9550\frac{P}{n} = 191\,\mathrm{N\,m}$$", "60$ kW", "60$ MW"),
    (r"Bei $P = ? und $n = 3000$ min⁻¹ ist $M = 9550\,P/n = 191$ Nm.", "60$ kW", "60$ W"),
    (r"$P = ?, $n=3000$ rpm. $$M = 9550\frac{P}{n} = 191\,\mathrm{N\,m}$$", "60$ kW", "60$ PS"),
    (r"$P = 60$ kW, $n = ?. $$M = 9550\frac{P}{n} = 11460\,\mathrm{N\,m}$$", "50$ rpm", "50$ Hz"),
    (r"$P = 60$ kW, $n=3000$ rpm. $$M = 9550\frac{P}{n} = 191\,\mathrm{?}$$", "N\\,m", "W"),
    (r"出力 $P = 60$ kW、回転数 $n=3000$ rpm のとき $T = 9550 P/n = 191$ ?。", "N·m", "N"),
    (r"$M = 200$ ?, $n=3000$ rpm. $$P = \frac{M n}{716.2} = 837.8\,\mathrm{PS}$$", "kp m", "N m"),
    (r"Le couple est $C = 200$ ? à $N = 3000$ tr/min: $P = C N/9{,}55 = 62827$ W.", "N m", "kN m"),
    (r"$D = ?, $p = 60$ bar: $$F = 7.85 p D^2 = 30144\,\mathrm{N}$$", "8$ cm", "8$ mm"),
    (r"$s = ?, $n = 3000$ rpm. $$v = \frac{s n}{30000} = 8\,\mathrm{m/s}$$", "80$ mm", "80$ cm"),
    (r"$s = ?, $n = 3000$ rpm. $$v = \frac{s n}{30000} = 0.3\,\mathrm{m/s}$$", "3$ mm", "3$ in"),
)


@pytest.mark.parametrize(("page", "right", "wrong"), OF_UNITS)
def test_a_constant_converts_the_units_of_the_page_only(page, right, wrong):
    verdicts = [check(page.replace("?", unit) + "\n").verdicts[-1].verdict for unit in (right, wrong)]
    assert verdicts[0] == "conditional"
    assert verdicts[1] in (*REFUTED, "undecided")
