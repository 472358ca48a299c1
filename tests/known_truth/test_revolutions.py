"""Revolutions per minute are what the letter counts that takes them."""

from __future__ import annotations

import pytest

from symbalance.checking import check

LETTERS = {"omega": "angular speed", "n": "speed", "N": "engine speed rpm", "m": "reciprocating mass"}

RIGHT = [
    r"$n = 6000\,\mathrm{rpm}$, $\omega = \frac{2\pi n}{60} = 628.3\,\mathrm{rad/s}$",
    r"$n = 6000\,\mathrm{min}^{-1}$, $\omega = \frac{\pi n}{30} = 628.3\,\mathrm{s}^{-1}$",
    r"$n = 6000\,\mathrm{min}^{-1}$, $\omega = 2\pi n = 628.3\,\mathrm{s}^{-1}$",
    r"$k = 4500\,\mathrm{min}^{-1}$, $c = 2\cdot 0.09\,\mathrm{m}\cdot k = 13.5\,\mathrm{m/s}$",
    r"$c = 2\cdot 0.086\,\mathrm{m}\cdot 5000\,\mathrm{min}^{-1} = 14.33\,\mathrm{m/s}$",
    r"$\omega = 2\pi\cdot 5000\,\mathrm{rpm} = 523.6\,\mathrm{rad/s}$",
    r"$\omega = 6000\,\mathrm{rpm} = 628.3\,\mathrm{rad/s}$",
    r"$N = 6000\,\mathrm{rpm}$, $\omega = \frac{\pi N}{30} = 628.3\,\mathrm{rad/s}$",
]
WRONG = [
    r"$n = 6000\,\mathrm{rpm}$, $\omega = \frac{2\pi n}{60} = 314.2\,\mathrm{rad/s}$",
    r"$n = 6000\,\mathrm{min}^{-1}$, $\omega = 2\pi n = 37699\,\mathrm{s}^{-1}$",
    r"$k = 4500\,\mathrm{min}^{-1}$, $c = 2\cdot 0.09\,\mathrm{m}\cdot k = 810.0\,\mathrm{m/s}$",
    r"$\omega = 2\pi\cdot 5000\,\mathrm{rpm} = 3289.9\,\mathrm{rad/s}$",
    r"$\omega = 6000\,\mathrm{rpm} = 100.0\,\mathrm{rad/s}$",
]
FAILING = {"refuted", "contradiction", "undecided", "unreadable"}


@pytest.mark.parametrize("page", RIGHT)
def test_a_speed_is_what_its_formulas_count(page: str) -> None:
    assert not [v for v in check(page, LETTERS).verdicts if v.verdict in FAILING]


@pytest.mark.parametrize("page", WRONG)
def test_a_wrong_speed_does_not_pass(page: str) -> None:
    assert check(page, LETTERS).verdicts[-1].verdict == "refuted"


def test_a_letter_of_unknown_meaning_on_one_side_refutes_nothing() -> None:
    letters = {"x": "displacement from top dead centre", "r": "crank radius", "l": "rod length"}
    letters["theta"] = "crank angle"
    (verdict,) = check(r"$$x = r(1-\cos u)$$", letters).verdicts
    assert (verdict.verdict, verdict.reason) == (
        "undecided",
        "u is not declared and stands on one side only: declare what it means",
    )
    (both,) = check(r"$$F r\cos u = F l\cos u$$", letters).verdicts
    assert both.verdict == "refuted"


BY_MINUTE = [
    ("$n = 3000$ rpm", r"ω = 2πn", r"ω = \frac{{{}n}}{{30}}", "π", "2π"),
    (r"$n = 3000\,\mathrm{min}^{-1}$", r"ω = 2πn", r"ω = \frac{{{}n}}{{60}}", "2π", "π"),
    ("$n = 3000$ U/min", "P = 2πnM", r"P = \frac{{{}nM}}{{30}}", "π", "4π"),
    ("$n = 3000$ 1/min", r"c = \frac{sn}{30}", "c = {}sn", "2", "4"),
    ("$n = 3000$ rpm", "c = 2sn", "c = {}sn", "2", "120"),
]


@pytest.mark.parametrize(("given", "first", "second", "right", "wrong"), BY_MINUTE)
def test_revolutions_by_the_second_and_by_the_minute(given, first, second, right, wrong):
    pages = [f"{given}\n\n${first}$\n\n${second.format(n)}$\n" for n in (right, wrong)]
    words = [[e["verdict"] for e in check(page).data()["links"]] for page in pages]
    assert words[0][-1] in ("conditional", "holds")
    assert words[1][-1] == "refuted"


def test_no_number_by_the_minute_lets_no_thirtieth_pass():
    page = "$n = 50$ 1/s\n\n$ω = 2πn$\n\n$ω = \\frac{πn}{30}$\n"
    assert check(page).data()["links"][-1]["verdict"] == "refuted"
