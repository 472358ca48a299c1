"""Torques, stars, cycles and traces as results: what they carry, say and refuse."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest

import symbalance as sb
from symbalance.errors import SymbalanceError
from symbalance.torque import torque_report

CYCLE = sb.torque.ideal_cycle(10, heat=20)
SIZES = {"bore": 80, "stroke": 80, "reciprocating_mass": "0.5", "rpm": 3000}


@pytest.mark.slow
def test_a_running_engine_prints_the_orders_and_the_flywheel_it_was_made_for() -> None:
    four = sb.running_torque(sb.load("inline-4"), CYCLE, order=4, delta="0.01", **SIZES)
    assert [n for n, *_ in four.terms()] == [2, 4]
    assert [row["order"] for row in four.records()] == [2.0, 4.0]
    assert four.flywheel() == pytest.approx(2 * four.flywheel("0.02"))
    at_6000 = four.at_speed(6000)
    assert (at_6000.highest, at_6000.delta) == (4, 0.01)
    usual = sb.running_torque(sb.load("inline-4"), CYCLE, **SIZES)
    assert (usual.highest, usual.delta) == (12, 0.02)
    for order in usual.gas_terms(), usual.inertia_terms(), usual.terms():
        assert max(n for n, *_ in order) == 12


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        ({"delta": 0}, "delta = 0: must lie between 0 and 1"),
        ({"delta": "1"}, "must lie between 0 and 1"),
        ({"delta": "little"}, "delta"),
        ({"order": 0}, "from 1 to 1000"),
    ],
)
def test_what_cannot_be_printed_is_refused(wrong: dict[str, object], words: str) -> None:
    with pytest.raises(SymbalanceError, match=words):
        sb.running_torque(sb.load("inline-4"), CYCLE, **SIZES, **wrong)  # type: ignore[arg-type]


@pytest.mark.slow
def test_a_report_takes_the_running_torque_of_its_own_engine_only() -> None:
    four = sb.load("inline-4")
    running = sb.running_torque(four, CYCLE, **SIZES)
    whole = torque_report(four, 4, running=running)
    assert whole.data()["running"] == running.data()
    assert len(whole.records()) == 2 + len(running.records())
    assert torque_report(four, 4).data()["running"] is None
    for engine, ratio in ((sb.load("inline-6"), None), (four, 5)):
        with pytest.raises(SymbalanceError, match="another engine"):
            torque_report(engine, 4, ratio=ratio, running=running)


def test_torques_say_which_they_are() -> None:
    crank = sb.inertia_torque(sb.load("v6-90"), 6)
    frame = crank.reaction()
    assert crank.document().title == "v6-90: inertia torque on the crank"
    assert frame.document().title == "v6-90: opposite of the inertia torque on the crank"
    assert frame.reaction().quantity == crank.quantity
    assert [-a["cos"] for a in crank.records()] == pytest.approx([b["cos"] for b in frame.records()])
    titles = {part.quantity for part in torque_report(sb.load("vw-vr6"), 3).parts()}
    assert len(titles) == 3
    assert any("roll moment" in title for title in titles)


def test_records_of_like_cylinders_times_their_coefficient_are_the_terms() -> None:
    """A row's cos and sin are geometry, in units of the coefficient that stands beside them."""
    five = sb.inertia_torque(sb.load("v2-45"), 6)
    rows = five.records()
    for row, (n, cos, sin) in zip(rows, five.terms(), strict=True):
        assert row["order"] == n
        assert row["cos"] * row["coefficient"] == pytest.approx(float(cos))
        assert row["sin"] * row["coefficient"] == pytest.approx(float(sin))
        assert row["unit"] == "t_n m r^2 omega^2"


def test_stars_are_a_sequence_whose_document_sums_their_vectors() -> None:
    """The sums by floating point from the angles in the records; the directions as they are printed."""
    stars = sb.torque.firing_stars(sb.load("v6-90"), 4)
    assert len(stars) == 8
    assert stars[2].order == Fraction(3, 2)
    assert [star.order for star in stars.open] == [Fraction(3, 2), 3]
    sums: dict[float, complex] = {}
    for row in stars.records():
        turn = math.radians(row["degrees"])
        sums[row["order"]] = sums.get(row["order"], 0j) + complex(math.cos(turn), math.sin(turn))
    text = sb.to_text(stars)
    for star in stars:
        size = abs(sums[float(star.order)])
        assert star.is_closed() == (size < 1e-12)
        assert star.is_closed() or f"{size:.5g}" in text
    assert "0°: 1, 3, 5; 225°: 2, 4, 6" in text
    assert repr(stars) == "Firing stars of v6-90 to order 4: open in order 1.5, 3"


def test_the_gas_torque_carries_its_ratio_pressure_and_mean() -> None:
    gas = sb.torque.gas_torque(sb.load("inline-4"), CYCLE, 4, ratio=5)
    assert gas.engine.ratio == 5
    assert gas.data()["ratio"] == "5"
    each = gas.data()["mean"] * 4 * math.pi / 4 / 2  # work of a cycle over A and twice the crank radius
    assert each == pytest.approx(CYCLE.mean_effective_pressure, rel=1e-4)
    assert [row["amplitude"] for row in gas.records()] == [order.amplitude for order in gas.orders]


def test_a_trace_and_a_cycle_say_their_peak() -> None:
    trace = sb.torque.pressure_trace(range(0, 720, 10), [40 if a == 10 else 1 for a in range(0, 720, 10)])
    assert (trace.peak, trace.peak_degrees) == (40, 10)
    assert repr(trace) == "Pressure trace over 720° of 72 points, from 1 to 40 bar"
    assert "40 bar at 10°" in sb.to_text(trace)
    assert [row["bar"] for row in trace.records()] == list(trace.bar)
    otto = sb.torque.ideal_cycle(10, heat=20, gamma="1.4")
    assert otto.records() == [otto.data()]
    assert otto.data()["efficiency"] == pytest.approx(1 - 10**-0.4)
    assert "0.601893" in sb.to_text(otto)
