"""The bench of the evaluators: its truth is one, its error can fail, its files are whole."""

from __future__ import annotations

import csv
import io
import sys
from fractions import Fraction
from importlib import import_module

import numpy as np
import pytest
from mpmath import mp

from symbalance.bench import accuracy, error_sweep, evaluated_outputs, speed
from symbalance.bench import accuracy_alternatives as alternatives
from symbalance.bench.accuracy import AccuracyReport
from symbalance.bench.accuracy_alternatives import ALTERNATIVES, alternative, lacking, present
from symbalance.bench.crossover import crossover_table, crossovers
from symbalance.bench.error_sweep import (
    ErrorSweep,
    Judge,
    Point,
    comparison_angles,
    draw_points,
    points_csv,
    points_table,
)
from symbalance.bench.evaluated_outputs import (
    TARGETS,
    Candidate,
    EvaluatedOutput,
    available_targets,
    candidate,
    from_module,
)
from symbalance.bench.timing import Measurement, Report, Times, in_turn
from symbalance.bench.true_values import U
from symbalance.cli import run
from symbalance.kinematics.slider_crank import acceleration_floats
from tests.kinematics import Place, planar

SIX = EvaluatedOutput("inline-6", "force.vertical")
FIVE = EvaluatedOutput("inline-5", "couple.vertical", None, Fraction(4))


@pytest.fixture(scope="module")
def points() -> list[Point]:
    small = ErrorSweep(
        engines=(("inline-4", "force.vertical"), ("v8-90", "force.vertical")),
        ratios=(Fraction(4),),
        orders=(2, None),
        count=64,
        comparisons=30,
        rounds=1,
        passes=2,
        budget=0.0,
    )
    return small.points(available_targets().targets)


@pytest.fixture
def tiny(points: list[Point], monkeypatch: pytest.MonkeyPatch) -> AccuracyReport:
    """A report that is there at once: `symbalance bench accuracy` answers with it."""
    met = Measurement("one", 1.0, "other", 2.0, "twice", True)
    made = AccuracyReport(
        "head", [("Sweep", points_table(points))], Report("wanted", [("A", [met])]), points
    )
    monkeypatch.setattr(accuracy, "report", lambda quick: made)
    return made


@pytest.mark.parametrize(
    "case", [FIVE, EvaluatedOutput("v8-90", "couple.lateral", None, Fraction(10, 9))]
)
def test_the_truth_is_that_of_the_tests_own_kinematics(case):
    known = Judge.of(case, 12)
    places = [
        Place(c.throw.in_degrees(), c.bank.in_degrees(), c.station) for c in case.preset_engine.cylinders
    ]
    with mp.workdps(50):
        function = planar(places, case.rod_ratio, arms=True)
        pairs = zip(known.true_values.high, known.true_values.low, strict=True)
        values = [mp.mpf(float(high)) + mp.mpf(float(low)) for high, low in pairs]
        for theta, value in zip(known.angles, values, strict=True):
            both = function(mp.mpf(float(theta)))
            part = both.real if case.output.endswith("vertical") else both.imag
            assert abs(part - value) < 1e-30
            assert abs(value) <= known.amplitude * 1.0001


def test_angles_reach_a_million_radians_and_dead_centres():
    angles = comparison_angles(300)
    assert np.abs(angles).max() == 1e6
    to_centre = np.abs(angles / np.pi - np.rint(angles / np.pi))
    assert ((to_centre > 0) & (to_centre < 1e-6)).any()
    assert (np.abs(angles) < 4 * np.pi).sum() > 150


@pytest.mark.slow
@pytest.mark.parametrize("name", [*TARGETS, *present()])
def test_everyone_is_held_to_the_same_truth(name):
    one = candidate(FIVE, name) if name in TARGETS else alternative(FIVE, name)
    error = Judge.of(FIVE, 60).error(one)
    assert 0 < error.near < 64 * U
    assert error.near <= error.largest < (64 * U if name in TARGETS else 1e-8)


def test_a_wrong_coefficient_shows():
    case = EvaluatedOutput("inline-4", "force.vertical", None)
    source = case.evaluator("numpy").source
    line = next(x for x in source.splitlines() if x.startswith("FORCE_VERTICAL_") and "e-" not in x)
    name, value = line.split("#")[0].split(" = ")
    wrong = source.replace(line, f"{name} = {float(value) * (1 + 2.0**-30)!r}")
    assert wrong != source
    known = Judge.of(case, 60)
    assert known.error(from_module("numpy", source)).in_u < 16
    assert known.error(from_module("numpy", wrong)).in_u > 1e5


def test_a_value_that_is_none_shows():
    lost = Candidate("lost", lambda theta, out: np.where(theta > 1e5, np.nan, theta))
    assert np.isnan(Judge.of(FIVE, 12).error(lost).largest)


@pytest.mark.slow
def test_the_table_has_all_candidates():
    row = speed.time_case(SIX, TARGETS, 100, 2, 0.0)
    assert set(row.times) == {
        speed.COPY,
        *TARGETS,
        *(target + speed.NEW for target in TARGETS),
        *present(),
    }
    table = speed.speed_table([row, speed.time_case(SIX, ("numpy",), 100, 2, 0.0)][:1])
    assert all(name in table for name in row.times)
    judged = speed.beside_alternatives(row)
    others = [*speed.NUMPY_TIMES, *speed.NUMPY_AT_MOST, *speed.NUMBA_TIMES, alternatives.PER_CYLINDER]
    assert len(judged) == sum(name in present() for name in others)
    assert all(m.is_met is not None for m in judged)
    assert [m.is_met for m in speed.beside_copy(row)] == [None, None]  # wanted of long arrays only


@pytest.mark.slow
def test_small_calls_and_memory(monkeypatch):
    monkeypatch.setattr(speed, "REPEAT", dict.fromkeys(speed.SMALL, 1))
    table = speed.small_table(speed.time_small_calls(SIX, ("numpy",), 2))
    assert "1000 angles" in table
    used = speed.memory(SIX, 10**6)
    assert used.is_met, used.target


def test_who_has_spent_the_budget_sits_out():
    counts = {"a": 0, "b": 0}

    def call(name):
        counts[name] += 1
        return sum(range(200 if name == "a" else 200_000))

    times = in_turn({"a": lambda: call("a"), "b": lambda: call("b")}, 20, budget=1e-3)
    assert counts["a"] > counts["b"] >= 3
    assert times["a"].best <= times["a"].median
    assert Times(4.0, 8.0).over(4) == Times(1.0, 2.0)


def test_what_is_lacking_is_said(monkeypatch):
    monkeypatch.setattr(evaluated_outputs, "find_spec", lambda name: None)
    monkeypatch.setattr(alternatives, "find_spec", lambda name: None)
    monkeypatch.setattr(evaluated_outputs.shutil, "which", lambda name: None)
    here = available_targets()
    assert here.targets == ("numpy",)
    assert "numba: not installed (pip install numba)" in here.notes
    assert any("no C compiler" in note for note in here.notes)
    assert present() == (alternatives.PER_CYLINDER, alternatives.LAMBDIFY)
    assert "heyoka: heyoka is not installed (pip install heyoka)" in lacking()
    assert {note.split(":")[0] for note in lacking()} | set(present()) == set(ALTERNATIVES)


@pytest.mark.slow
def test_csv_and_table_agree(points):
    rows = list(csv.DictReader(io.StringIO(points_csv(points))))
    assert [Point(**_read(row)) for row in rows] == points
    assert {row["order"] for row in rows} == {"2", "all"}
    assert not any(row["engine"] == "v8-90" and row["order"] == "2" for row in rows)  # it vanishes
    table = points_table(points)
    assert all(f"{p.ns_per_point:.3g}  {p.error_relative:.0e}" in table for p in points)
    assert {p.target for p in points} >= {
        *TARGETS,
        *({*error_sweep.CANCELLED} & {*present()}),
        alternatives.PER_CYLINDER,
    }


def _read(row: dict[str, str]) -> dict[str, object]:
    numbers = {"ns_per_point", "error_relative", "error_u", "error_two_turns"}
    return {name: float(text) if name in numbers else text for name, text in row.items()}


@pytest.mark.slow
def test_pictures_are_whole(points):
    found = draw_points(points)
    assert found[".png"].startswith(b"\x89PNG")
    assert found[".png"].endswith(b"IEND\xaeB`\x82")
    assert found[".pdf"].startswith(b"%PDF")
    assert found[".pdf"].rstrip().endswith(b"%%EOF")


def test_both_forms_of_one_wave(monkeypatch):
    monkeypatch.setattr(import_module("symbalance.bench.crossover"), "COUNT", 64)
    (row,) = crossovers([EvaluatedOutput("inline-4", "force.vertical", None)], ["numpy"], (2, 4))
    assert {2, 4} < set(row.polynomials)
    assert row.places == 1
    assert max(row.closed_u, row.polynomial_u) < 16
    assert "inline-4 λ = 4, numpy" in crossover_table([row])


def test_coefficients_are_held_to_mpmath():
    ratio = accuracy.RHOS["0.9"]
    values = acceleration_floats(accuracy.HIGHEST, ratio)
    assert accuracy.worst_ulp(values, ratio) < 0.51
    assert accuracy.worst_ulp(values | {8: values[8] * (1 + 2.0**-48)}, ratio) > 10


@pytest.mark.slow
def test_command_writes_points_and_pictures(tiny, tmp_path, capsys):
    name = tmp_path / "here"
    assert run(["bench", "accuracy", "--quick", "-o", str(name)]) == 0
    assert capsys.readouterr().out == tiny.text()
    assert sorted(p.name for p in tmp_path.iterdir()) == ["here.csv", "here.pdf", "here.png"]
    assert name.with_suffix(".csv").read_text(encoding="utf-8") == points_csv(tiny.points)


@pytest.mark.slow
def test_a_missed_target_is_exit_code_1(tiny, monkeypatch, capsys):
    missed = Measurement("one", 1.0, "other", 1.5, "at least twice", False)
    late = AccuracyReport(tiny.head, tiny.tables, Report("wanted", [("A", [missed])]), tiny.points)
    monkeypatch.setattr(accuracy, "report", lambda quick: late)
    assert run(["bench", "accuracy"]) == 1
    assert "MISSED" in capsys.readouterr().out


def _no_run(quick):
    raise AssertionError("the long run has begun")


def test_matplotlib_missing_is_said_before_the_run(monkeypatch, tmp_path, capsys):
    monkeypatch.setattr(accuracy, "find_spec", lambda name: None)
    monkeypatch.setattr(accuracy, "report", _no_run)
    assert run(["bench", "accuracy", "-o", str(tmp_path / "here")]) not in (0, 1)
    said = capsys.readouterr().err
    assert said.rstrip().endswith("pip install matplotlib")
    assert said.count("\n") == 1
    assert list(tmp_path.iterdir()) == []


def test_a_folder_that_is_not_there_is_said_before_the_run(monkeypatch, tmp_path, capsys):
    monkeypatch.setattr(accuracy, "report", _no_run)
    assert run(["bench", "accuracy", "-o", str(tmp_path / "none" / "here")]) not in (0, 1)
    assert "cannot be written" in capsys.readouterr().err


def test_other_topics_write_their_table(monkeypatch, tmp_path):
    derive = import_module("symbalance.bench.derive")
    monkeypatch.setattr(derive, "report", lambda quick: Report("head", []))
    assert run(["bench", "derive", "-o", str(tmp_path / "table.txt")]) == 0
    assert (tmp_path / "table.txt").read_text(encoding="utf-8").startswith("head")
    assert sys.modules["symbalance.bench.derive"] is derive
