"""A series of harmonics that nobody names is judged by the slider-crank's formula that it nearly is."""

from __future__ import annotations

import tomllib
from fractions import Fraction
from math import asin, cos, isclose, pi, sin, tan

import pytest

from symbalance.notes.checking import check
from symbalance.notes.checking.meant.pistons.crank_series import (
    Harmonic,
    in_powers_of_sine,
    known_series,
    turned,
)
from symbalance.notes.checking.verdicts import FAILING, PROVED_WORDS, REFUTED, Verdict
from tests import TESTS

PAGES = tomllib.loads((TESTS / "laws" / "fields" / "patterns.toml").read_text(encoding="utf-8"))
RATIO, ANGLE, STEP = 0.05, 0.7, 1e-4
"""A short ratio, for which what is cut off is below the digits compared."""


def last_verdict(page: str) -> Verdict:
    checked = check(page + "\n", {})
    assert not checked.faults
    assert not checked.derivation.unreadable
    return max(checked.verdicts, key=lambda v: (v.line, v.span))


@pytest.mark.parametrize(("page", "formula"), PAGES["by_pattern"])
def test_one_wrong_term_is_refuted_with_what_it_should_be(page, formula):
    verdict = last_verdict(page)
    assert verdict.verdict == REFUTED
    assert "by its pattern" in verdict.reason
    assert verdict.fix is not None
    assert formula in ("", verdict.fix.text)
    fixed = page.replace(verdict.source, verdict.fix.text)
    assert fixed != page


@pytest.mark.parametrize("page", PAGES["proved"])
def test_a_root_or_a_rod_angle_and_its_series_agree(page):
    assert last_verdict(page).verdict in PROVED_WORDS


@pytest.mark.parametrize("page", PAGES["alone"])
def test_what_is_right_or_of_something_else_is_not_accused(page):
    checked = check(page + "\n", {})
    assert not {verdict.verdict for verdict in checked.verdicts} & {*FAILING}


@pytest.mark.parametrize("page", PAGES["by_parity"])
def test_a_motion_has_no_harmonic_of_the_other_kind(page):
    verdict = last_verdict(page)
    assert verdict.verdict == REFUTED
    assert "in the crank angle" in verdict.reason


def value(series, angle: float = ANGLE, ratio: float = RATIO) -> float:
    waves = {"sin": sin, "cos": cos}
    return sum(
        float(c) * ratio**p * waves[h.function](h.order * angle)
        for h, powers in series.items()
        for p, c in powers.items()
    )


def way(angle: float) -> float:
    return 1 - cos(angle) + (1 - cos(asin(RATIO * sin(angle)))) / RATIO


def slope(function, angle: float = ANGLE) -> float:
    return (function(angle + STEP) - function(angle - STEP)) / (2 * STEP)


def test_the_series_are_those_of_the_slider_crank():
    series = known_series()
    rod = asin(RATIO * sin(ANGLE))
    exact = {
        "displacement": way(ANGLE), "velocity": slope(way), "cosine of the rod's angle": cos(rod),
        "acceleration": slope(lambda a: slope(way, a)), "tangent of the rod's angle": tan(rod),
        "position": cos(ANGLE) + cos(rod) / RATIO, "rod's angle": rod,
        "secant of the rod's angle": 1 / cos(rod),
        "inertia torque": slope(way) * slope(lambda a: slope(way, a)),
        "radial force": cos(ANGLE + rod) / cos(rod),
    }  # fmt: skip
    for name, expected in exact.items():
        assert isclose(value(series[name]), expected, rel_tol=1e-6), name


def test_an_angle_may_be_counted_from_any_quarter():
    for series in known_series().values():
        for quarters in range(4):
            there = value(turned(series, quarters))
            assert isclose(there, value(series, ANGLE + quarters * pi / 2), abs_tol=1e-12)


def test_powers_of_the_sine_are_the_same_function():
    for series in known_series().values():
        total = 0.0
        for (function, order), powers in in_powers_of_sine(series).items():
            wave = (cos(ANGLE) if function == "cos" else 1) * sin(ANGLE) ** order
            total += wave * sum(float(c) * RATIO**p for p, c in powers.items())
        assert isclose(total, value(series), abs_tol=1e-9)
    tangent = in_powers_of_sine(known_series()["tangent of the rod's angle"])
    assert tangent[Harmonic("1", 3)] == {3: Fraction(1, 2)}


@pytest.mark.parametrize(
    "words", ["The inertia of one piston gives the torque", "Die Masse eines Kolbens gibt das Moment"]
)
@pytest.mark.parametrize(("sign", "verdict"), [("-", "conditional"), ("+", "refuted")])
def test_the_torque_of_one_piston_is_judged_beside_what_all_leave(words, sign, verdict):
    page = (
        f"With λ = r/l. {words}\n\n"
        f"$$T = \\tfrac12 m r^2ω^2(\\tfrac12λ\\sin θ - \\sin 2θ {sign} \\tfrac32λ\\sin 3θ"
        " - \\tfrac12λ^2\\sin 4θ),$$\n\nof which four cylinders leave the second order.\n"
    )
    assert check(page, {}).verdicts[-1].verdict == verdict
