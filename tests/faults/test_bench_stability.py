"""The bench of stability: every case is there, a planted fault is seen, the truth is the kinematics'."""

from __future__ import annotations

import dataclasses
from fractions import Fraction

import numpy as np
import pytest
from mpmath import mp

import symbalance as sb
from symbalance.bench import closed_sum_cases as sums
from symbalance.bench import engine_cases as engines
from symbalance.bench import output_requests as requests
from symbalance.bench import piston_cases as pistons
from symbalance.bench import ratio_cases as ratios
from symbalance.bench import stability
from symbalance.bench.bounded_cases import BoundedCase, Part, attempt, worst, worst_point
from symbalance.bench.hard_angles import closest, hard, near_multiples, near_turns, quarters, small
from symbalance.bench.output_requests import OutputRequest
from symbalance.bench.true_values import (
    Points,
    accelerations_at,
    gauss,
    harmonics_at,
    piston_at,
    true_coefficients,
    weights,
)
from tests.kinematics import acceleration, displacement, velocity

REAL = Fraction(7, 2)
SINGLE = sb.inline(throws=[0])
ANGLES = np.array([0.3, -1.2, 1e-8, 1.5707963, 100.25, -987654.321])


@pytest.fixture
def numpy_alone(monkeypatch):
    """Let every part run with NumPy alone, and one engine."""
    for room in (pistons, engines, stability):
        monkeypatch.setattr(room, "targets", lambda: ["numpy"])
    monkeypatch.setattr(engines, "QUICK", ("v6-90",))
    monkeypatch.setattr(engines, "FAR", (1e9,))
    monkeypatch.setattr(engines, "twenty_four", lambda: [(sb.load("v12-60"), "force.vertical")])


@pytest.mark.slow
def test_the_report_has_every_case(numpy_alone):
    report = stability.report(quick=True)
    text = report.text()
    for words in (
        "displacement near TDC",
        "displacement at 2πn",
        "TDC at -360°/7",
        "velocity anywhere",
        "v6-90, orders to 12",
        "v6-90, all orders",
        "on a grid of 1441",
        "to 1e+09 rad",
        "A_2 ... A_200 at λ = 1 + 1e-09",
        "λ = 1 + 0.001, orders to 100",
        "λ = 1 + 0.001, all orders",
        "λ = 1e12 is refused",
        "orders to 1000",
        "sin(Nx)/sin(x) at its poles",
        "inline_couple",
        "float32 angles",
    ):
        assert words in text, words
    assert len(report.parts) == len(stability.PARTS)
    assert not [case for case in report.cases() if "raised" in case.where]
    assert report.missed_targets() == []
    assert "FAILED" not in text


def test_a_case_past_its_bound_is_missed():
    good, bad = (
        BoundedCase("good", "0.1", 3.9, 4.0),
        BoundedCase("bad", "0.2", 4.1, 4.0, naive={"sum": 1e6}),
    )
    report = stability.StabilityReport("head", [Part("title", "says", [good, bad])])
    assert report.missed_targets() == [bad]
    assert "FAILED: 1 of 2 cases\n  bad" in report.text()
    assert "1e+06 sum" in report.text()
    fine = stability.StabilityReport("head", [Part("title", "says", [good])])
    assert (fine.missed_targets(), "FAILED" in fine.text()) == ([], False)


def test_what_is_not_a_number_or_raises_is_missed():
    theta = np.array([1.0, 2.0])
    assert not worst_point("lost", theta, np.array([0.1, np.nan]), 4.0).is_met
    assert not BoundedCase("lost", "", float("nan"), 4.0).is_met

    def broken() -> BoundedCase:
        raise SyntaxError("too many nested parentheses")

    case = attempt("raises", 4.0, "u", broken)
    assert not case.is_met
    assert case.where.startswith("raised SyntaxError")
    assert worst([BoundedCase("a", "", 1.0, 4.0), case]).where == case.where


def test_a_wrong_constant_is_seen():
    """The largest coefficient of the source, 16 u of it off, fails; as it stands, it does not."""
    asked = OutputRequest(sb.load("inline-4"), "force.vertical", REAL)
    points = Points(hard(60))
    assert asked.case("right", points, 4.0).is_met
    source = asked.evaluator.source
    own = [row for row in source.splitlines() if row.startswith("FORCE_VERTICAL_") and " = " in row]
    line = max(own, key=lambda row: abs(float(row.split()[2])))
    value = float(line.split()[2])
    changed = source.replace(line, line.replace(repr(value), repr(value * (1 + 2.0**-49))))
    assert changed != source
    fault = dataclasses.replace(asked.evaluator, source=changed)
    case = asked.case("planted", points, 4.0, function=fault)
    assert case.error > 5.0
    assert not case.is_met


def test_a_bound_too_small_is_seen(monkeypatch):
    monkeypatch.setattr(ratios, "COEFFICIENT", 0.3)
    assert not ratios.coefficient_case(REAL, 60).is_met
    monkeypatch.setattr(ratios, "COEFFICIENT", 0.51)
    case = ratios.coefficient_case(REAL, 60)
    assert case.is_met
    assert case.naive["upward"] > 1e6


def test_a_planted_wrong_coefficient_is_seen(monkeypatch):
    right = ratios.acceleration_floats

    def wrong(order, ratio):
        found = right(order, ratio)
        return found | {8: np.nextafter(found[8], 1)}

    monkeypatch.setattr(ratios, "acceleration_floats", wrong)
    case = ratios.coefficient_case(REAL, 20)
    assert not case.is_met
    assert case.where == "order 8.0"


def test_the_naive_forms_lose_what_ours_keep():
    near = Points(np.array([1e-8, 0.01, -1e-4]))
    truth = piston_at(near, "displacement", SINGLE, REAL)
    naive = 1 - np.cos(near.theta) + 3.5 * (1 - np.sqrt(1 - (np.sin(near.theta) / 3.5) ** 2))
    ours = OutputRequest(SINGLE, "piston.displacement", REAL, 1).evaluator(near.theta)
    assert np.max(truth.off(naive) / np.spacing(truth.high)) > 1e3
    assert np.max(truth.off(ours) / np.spacing(truth.high)) <= pistons.DISPLACEMENT


@pytest.mark.parametrize("ratio", [REAL, Fraction(1001, 1000), Fraction(10**6)])
def test_truth_of_a_piston_is_the_kinematics(ratio):
    points = Points(ANGLES)
    found = {
        displacement: piston_at(points, "displacement", SINGLE, ratio),
        velocity: piston_at(points, "velocity", SINGLE, ratio),
        acceleration: accelerations_at(points, weights(SINGLE, "piston.acceleration"), ratio),
    }
    with mp.workdps(80):
        lam = mp.mpf(ratio.numerator) / ratio.denominator
        for function, truth in found.items():
            for theta, high, low in zip(ANGLES, truth.high, truth.low, strict=True):
                value = function(mp.mpf(float(theta)), lam)
                assert abs(mp.mpf(float(high)) + mp.mpf(float(low)) - value) <= 1e-30 * abs(value)


@pytest.mark.parametrize("name", ["force.vertical", "force.lateral", "couple.vertical", "couple.lateral"])
def test_all_orders_sum_to_the_kinematics(name):
    """Two ways to the truth: harmonics of whole cylinders' vectors, and each cylinder's acceleration."""
    asked = OutputRequest(sb.load("v6-90"), name, REAL, tolerance=0.0)
    points = Points(ANGLES)
    whole = accelerations_at(points, weights(asked.engine, name), REAL)
    parts = harmonics_at(points, asked.terms)
    assert np.all(np.abs((whole.high - parts.high) + (whole.low - parts.low)) <= 1e-25)


@pytest.mark.slow
def test_coefficients_by_two_ways():
    for ratio in (Fraction(6, 5), Fraction(1001, 1000), 1 + Fraction(1, 10**9)):
        found = true_coefficients(60, ratio)
        for n in (2, 4, 30, 60):
            with mp.workdps(60):
                assert abs(found[n] / gauss(n, ratio) - 1) < mp.mpf(10) ** -50


def test_angles_are_hard():
    with mp.workdps(60):
        quarter = mp.pi / 2
        left = [abs(mp.mpf(float(a)) / quarter - mp.nint(mp.mpf(float(a)) / quarter)) for a in closest()]
        assert min(left) < 1e-14
        rotated = near_turns(5)[::5] / float(2 * mp.pi)
    assert np.abs(rotated - np.rint(rotated)).max() < 1e-9
    assert np.abs(near_turns(50)).max() < 2.0**20
    assert np.abs(hard(200)).max() >= 1e6
    assert np.abs(small(9)).min() == 5e-324
    peaks = np.cos(quarters(1e-6, 20, 1 / 7) + 2 * np.pi / 7)
    assert np.abs(peaks).max() < 1e-5
    twelfths = near_multiples(24, 9) * 12 / np.pi
    assert np.abs(twelfths - np.rint(twelfths)).max() < 1e-8


@pytest.mark.slow
def test_sums_are_held_to_the_sum_of_cosines(monkeypatch):
    cases = {case.name: case for case in sums.quotients((5, 6))}
    at_poles = cases["sin(Nx)/sin(x) at its poles, h exact"]
    assert at_poles.is_met
    assert at_poles.naive["quotient"] >= 1
    assert cases["... within 1e-3 to 1e-16 of them, h exact"].is_met
    monkeypatch.setattr(sums, "dirichlet_quotient", lambda N, n, h: float(N))
    assert not all(case.is_met for case in sums.quotients((5, 6)))


def test_c_is_tried_where_there_is_a_compiler(monkeypatch):
    monkeypatch.setattr(requests.shutil, "which", lambda name: None)
    assert "c" not in requests.targets()
    monkeypatch.setattr(requests.shutil, "which", lambda name: "/usr/bin/cc")
    assert "c" in requests.targets()
