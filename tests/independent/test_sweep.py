"""A sweep's values against separate balances and against sums over cylinders written out here."""

from __future__ import annotations

import csv
import io
import itertools
import json
import math
from fractions import Fraction

import mpmath
import pytest

import symbalance as sb
from symbalance.cli import run
from symbalance.engine.crank_train import CrankTrain
from symbalance.engine.variants import varied_engine
from symbalance.jobs import Progress
from tests.effort import effort

TURN = [2 * math.pi * k / 256 for k in range(256)]

TRAIN = CrankTrain(stroke=Fraction(80), rod=Fraction(150))
QUANTITIES = ["force.1", "force.2", "force.2.vertical", "couple.1", "couple.2.lateral", "torque.2"]


def harmonic(n: int, ratio: float, offset: float, function) -> complex:
    """Return a_n + i b_n of a function of the crank angle and the bare geometry, by 64 points a turn."""
    points = 256
    total = 0j
    for k in range(points):
        p = 2 * mpmath.pi * k / points
        total += function(p, ratio, offset) * mpmath.expj(n * p)
    return complex(2 * total / points)


def height(p, ratio: float, offset: float):
    """The piston's height over the crank's centre, in r: its axis passes the crank at `offset`."""
    return mpmath.cos(p) + mpmath.sqrt(ratio**2 - (mpmath.sin(p) - offset) ** 2)


def acceleration(p, ratio: float, offset: float):
    return -mpmath.diff(lambda x: height(x, ratio, offset), p, 2)


def torque_of(p, ratio: float, offset: float):
    """The inertia's torque on the crank: minus the force times the speed, in m r^2 omega^2."""
    return acceleration(p, ratio, offset) * mpmath.diff(lambda x: height(x, ratio, offset), p)


def largest(forces: list[tuple[complex, float, float]], n: int) -> float:
    """Return the largest size over a turn of forces (C + iS, axis' angle, weight) of one order."""
    best = 0.0
    for k in range(3600):
        phase = 2 * mpmath.pi * k / 3600
        push = [(w * (a * mpmath.expj(-phase)).real, axis) for a, axis, w in forces]
        up = sum(f * mpmath.cos(axis) for f, axis in push)
        right = sum(f * mpmath.sin(axis) for f, axis in push)
        best = max(best, float(mpmath.hypot(up, right)))
    return best


@pytest.mark.slow
@pytest.mark.parametrize(("ratio", "bank", "offset"), [(3.5, 60, 0), (4.0, 90, 12.0)])
def test_a_vee_against_a_sum_over_its_cylinders(ratio: float, bank: int, offset: float) -> None:
    """Two cylinders on one pin, the geometry alone: banks turn about their middle, the crank stays."""
    engine = sb.vee(90, pins=[0], crank_train=CrankTrain(stroke=Fraction(80)))
    result = sb.sweep(
        engine,
        {"ratio": [Fraction(ratio)], "bank": [bank], "offset": [Fraction(offset)]},
        ["force.2", "torque.2"],
    )
    (row,) = result.records()
    throws = [float(c.throw.in_degrees()) for c in engine.cylinders]
    axes = [-bank / 2, bank / 2]
    force, torque = [], 0j
    for throw, axis in zip(throws, axes, strict=True):
        # A_2 cos 2 (theta + throw - axis): the delay turns the amplitude of the second order.
        delay = mpmath.expj(-2 * mpmath.radians(throw - axis))
        force.append((harmonic(2, ratio, offset / 40, acceleration) * delay, mpmath.radians(axis), 1.0))
        torque += harmonic(2, ratio, offset / 40, torque_of) * delay
    assert row["force.2"] == pytest.approx(largest(force, 2), rel=1e-5)
    assert row["torque.2"] == pytest.approx(abs(torque), rel=1e-8)


@pytest.mark.slow
def test_every_point_is_what_a_balance_of_its_own_gives() -> None:
    """The grid of a V6, its engine built anew for each point: amplitudes from components, not terms."""
    built = sb.load("v6-90")
    vary = {"ratio": [3, "7/2"], "bank": [60, 90, 120], "offset": [0, 5]}
    engine = varied_engine(built, {"stroke": 80})
    swept = sb.sweep(engine, vary, QUANTITIES)
    assert [p.settings for p in swept] == [
        tuple(map(Fraction, point)) for point in itertools.product(*vary.values())
    ]
    for point in swept:
        ratio, bank, offset = point.settings
        cylinders = [
            sb.Cylinder(
                c.number,
                throw=c.throw.in_degrees(),
                bank=bank / 2 if c.bank.in_degrees() > 0 else -bank / 2,
                station=c.station,
                stroke=80,
                rod=ratio * 40,
                offset=offset,
            )
            for c in engine.cylinders
        ]
        own = sb.Engine(cylinders)
        free, torque = sb.balance(own, 2), sb.inertia_torque(own, 2)
        for name, value in zip(QUANTITIES, point.values, strict=True):
            assert value is not None
            assert float(value) == pytest.approx(_apart(free, torque, name), rel=1e-12, abs=1e-25), name


def _apart(free, torque, name: str) -> float:
    what, order, *axis = name.split(".")
    n = int(order)
    if what == "torque":
        return float(next((mpmath.hypot(*map(_mp, (c, s))) for o, c, s in torque.terms() if o == n), 0))
    kept = [o for o in free.orders if o.order == n]
    if not kept:
        return 0.0
    unit = abs(float(free.values[n])) if free.kinematics is not None else 1.0
    resultant = kept[0].force if what == "force" else kept[0].couple
    parts = [
        [float(x) for x in resultant.component(a).decimal()] for a in axis or ("vertical", "lateral")
    ]
    if axis:
        return unit * float(mpmath.hypot(*parts[0]))
    (a, b), (c, d) = parts
    # The long half axis of the ellipse that (a cos + b sin, c cos + d sin) runs over.
    total, area = a * a + b * b + c * c + d * d, abs(a * d - b * c)
    return unit * float(mpmath.sqrt((total + mpmath.sqrt(max(total**2 - 4 * area**2, 0))) / 2))


def _mp(value) -> mpmath.mpf:
    return mpmath.mpf(str(value))


def test_the_vertical_and_lateral_amplitudes_of_a_v_twin() -> None:
    """One pin, banks at -b/2 and b/2: the primaries are 2 cos^2(b/2) and 2 sin^2(b/2), by hand."""
    rows = sb.sweep(
        sb.vee(90, pins=[0], ratio=4), {"bank": [0, 60, 90, 180]}, ["force.1.vertical", "force.1.lateral"]
    )
    values = [(row["force.1.vertical"], row["force.1.lateral"]) for row in rows.records()]
    assert values == [
        (2.0, 0.0),
        (1.5, 0.5),
        (1.0, 1.0),
        (0.0, 2.0),
    ]


def test_a_zero_is_exact_and_is_written_so() -> None:
    four = sb.sweep(sb.load("inline-4"), {"ratio": [3, 4]}, ["force.1", "couple.2"])
    assert [point["values"] for point in four.data()["points"]] == [["0", "0"]] * 2


def test_a_longer_rod_gives_the_ratio_anew_and_a_ratio_beside_both_lengths_is_refused() -> None:
    engine = sb.inline("1-3-4-2", crank_train=TRAIN)
    by_rod = sb.sweep(engine, {"rod": [120, 160]}, ["force.2"])
    by_ratio = sb.sweep(engine, {"ratio": [3, 4]}, ["force.2"])
    assert [p.values for p in by_rod] == [p.values for p in by_ratio]
    both = sb.sweep(engine, {"stroke": [75, 80], "rod": [150]}, ["force.2"])
    assert [p.values for p in both] == [
        p.values for p in sb.sweep(engine, {"ratio": [4, "15/4"]}, ["force.2"])
    ]
    with pytest.raises(sb.SymbalanceError, match="ratio: follows from stroke and rod"):
        sb.sweep(engine, {"stroke": [80], "rod": [150], "ratio": [3]}, ["force.2"])


def test_firing_angles_follow_the_banks() -> None:
    """Built of the changed cylinders an engine is not refused: no piston fires beside its top."""
    opened = varied_engine(sb.load("v8-90"), {"bank": 60})
    again = sb.Engine(opened.cylinders)
    assert {c.bank.in_degrees() for c in again.cylinders} == {-30, 30}
    assert again.first.fires == 0
    unchanged = varied_engine(sb.load("v8-90"), {"bank": 90})
    assert unchanged == sb.load("v8-90")


def test_newtons_are_the_values_times_the_sizes_of_each_point() -> None:
    """By hand: m r ω², with the pitch for couples and the crank radius once more for torque, SI."""
    names = ["force.6", "couple.1", "couple.2.lateral", "torque.3"]
    vary = {"stroke": [80, "85.5"], "reciprocating_mass": ["0.5", "0.9"], "pitch": [100]}
    engine = sb.load("vq30de")
    plain = sb.sweep(engine, vary, names).records()
    at_speed = sb.sweep(engine, vary, names, rpm=4500)
    assert [at_speed.unit(name) for name in names] == ["N", "N m", "N m", "N m"]
    omega = 4500 * math.pi / 30
    for before, row in zip(plain, at_speed.records(), strict=True):
        assert row["rpm"] == 4500
        radius = before["stroke"] / 2000
        unit = before["reciprocating_mass"] * radius * omega**2
        for name, factor in zip(names, (1, 0.1, 0.1, radius), strict=True):
            assert math.isclose(row[name], before[name] * unit * factor, rel_tol=1e-14)
            assert row[name] > 0


def test_an_inverted_vee_opens_on_its_own_side() -> None:
    engine = sb.Engine([sb.Cylinder(1, bank=170), sb.Cylinder(2, bank=-170)])
    opened = varied_engine(engine, {"bank": 40})
    assert sorted(c.bank.in_degrees() for c in opened.cylinders) == [-160, 160]
    assert varied_engine(engine, {"bank": 20}).cylinders == engine.cylinders


def test_a_point_without_an_engine_stops_no_other() -> None:
    swept = sb.sweep(
        sb.inline("1", crank_train=CrankTrain(stroke=Fraction(80))), {"ratio": [1, 4]}, ["force.2"]
    )
    assert [bool(p.problem) for p in swept] == [True, False]
    assert swept.records()[0]["force.2"] is None
    assert "the rod must be longer than the crank" in swept.items[0].problem
    with pytest.raises(sb.SymbalanceError, match="the rod must be longer"):
        sb.sweep(sb.inline("1"), {"ratio": [1]}, ["force.2"])


@pytest.mark.parametrize(
    ("vary", "quantities", "said"),
    [
        ({}, ["force.1"], "vary = {}: must map sizes"),
        ([("ratio", [3])], ["force.1"], "must map sizes"),
        ({"length": [3]}, ["force.1"], "vary length: is no size of an engine"),
        ({"ratio": []}, ["force.1"], "must hold a value"),
        ({"ratio": "3,4"}, ["force.1"], "must be a list"),
        ({"ratio": [3, 3.0]}, ["force.1"], "ratio = 3: is named twice"),
        ({"ratio": ["x"]}, ["force.1"], "ratio = x"),
        ({"ratio": [3]}, [], "must hold one at least"),
        ({"ratio": [3]}, "force.1", "must be a list"),
        ({"ratio": [3]}, ["force"], "quantity = force: is none"),
        ({"ratio": [3]}, ["torque.2.vertical"], "is none"),
        ({"ratio": [3]}, ["force.0"], "order = 0"),
        ({"ratio": [3]}, ["force.1001"], "order = 1001"),
        ({"ratio": range(2, 400), "offset": range(300)}, ["force.1"], "are more than 100000"),
        ({"bank": [60]}, ["force.1"], "is of two banks, and inline-4 has 1"),
        ({"rod": [-1]}, ["force.1"], "rod = -1: must be positive"),
    ],
)
def test_what_cannot_be_varied_is_refused(vary, quantities, said) -> None:
    with pytest.raises(sb.SymbalanceError, match=said):
        sb.sweep(sb.load("inline-4"), vary, quantities)


@pytest.mark.slow
def test_a_store_gives_back_the_same_and_the_work_is_not_done_again(tmp_path) -> None:
    engine, vary = sb.load("v6-60"), {"ratio": [3, "10/3", 4]}
    quantities, progress = [*QUANTITIES, "force.12", "torque.60"], Progress()

    def swept():
        return sb.sweep(engine, vary, quantities, store=tmp_path / "kept", progress=progress)

    first = swept()
    assert progress.saved == 0
    again: list[sb.design.Sweep] = []
    cost = effort(lambda: again.append(swept()))
    assert progress.saved == 3
    assert [p.values for p in again[0]] == [p.values for p in first]
    assert cost < effort(lambda: sb.sweep(engine, vary, quantities)) / 2
    assert first.data() == again[0].data() == sb.sweep(engine, vary, quantities).data()


@pytest.mark.slow
def test_processes_give_the_same_to_the_last_digit(tmp_path) -> None:
    vary = {"ratio": [3, "7/2", 4], "bank": [60, 75]}
    engine = sb.load("v6-60")
    one, two = (sb.sweep(engine, vary, QUANTITIES, workers=n) for n in (1, 2))
    assert one.data() == two.data()


def test_the_command_prints_the_grid(capsys) -> None:
    command = ["sweep", "v2-90", "--vary", "ratio=3:4:0.5", "--vary", "bank=60,90"]
    assert run([*command, "--quantities", "force.1, torque.2", "--format", "json"]) == 0
    out, err = capsys.readouterr()
    points = json.loads(out)["points"]
    assert [p["settings"] for p in points] == [[r, b] for r in ("3", "7/2", "4") for b in ("60", "90")]
    assert err.splitlines()[-1] == "6 of 6 done"


def test_the_grid_is_a_table_for_spreadsheets(tmp_path) -> None:
    """By the ending of the file; a point that is refused says why, and has no numbers."""
    command = ["sweep", "v2-90", "--vary", "ratio=1,3,4", "--quantities", "force.2", "-o"]
    table, book = tmp_path / "grid.csv", tmp_path / "grid.xlsx"
    assert run([*command, str(table)]) == 1  # a rod ratio of 1 is refused
    first, *rows = csv.DictReader(io.StringIO(table.read_text(encoding="utf-8")))
    assert first["force.2"] == ""
    assert "ratio = 1" in first["problem"]
    # Two second orders, 90 degrees apart, of opposite phase: sqrt(2) A_2 along the lateral.
    for row, ratio in zip(rows, (3, 4), strict=True):
        height = [math.cos(t) + math.sqrt(ratio**2 - math.sin(t) ** 2) for t in TURN]
        second = 2 * sum(4 * y * math.cos(2 * t) for y, t in zip(height, TURN, strict=True)) / len(TURN)
        assert math.isclose(float(row["force.2"]), math.sqrt(2) * second, rel_tol=1e-12)
    assert run([*command, str(book)]) == 1
    assert book.read_bytes().startswith(b"PK")


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["--vary", "ratio"], "must be a size and its values"),
        (["--vary", "ratio="], "must be a size and its values"),
        (["--vary", "ratio=3:4"], "must be from:to:step"),
        (["--vary", "ratio=4:3:0.5"], "must rise by a positive step"),
        (["--vary", "ratio=3:4:0"], "must rise by a positive step"),
        (["--vary", "ratio=3:4:1e-9"], "asks for more than 10000 values"),
        (["--vary", "ratio=3", "--vary", "ratio=4"], "names ratio again"),
        (["--vary", "ratio=3", "--rpm", "900:990:9"], "a sweep is at one"),
        (["--vary", "ratio=3", "--rpm", "900"], "needs the engine's stroke and reciprocating_mass"),
        (["--vary", "stroke=80", "--rpm", "9", "--stroke", "80"], "--vary stroke gives it"),
        (["--vary", "ratio=3", "--mass", "1"], "plays a part at a speed only"),
        (["--vary", "ratio=3", "--jobs", "0"], "--jobs = 0: must be a whole number from 1"),
        (["--vary", "ratio=3", "--jobs", "2", "--dask", "tcp://x:1"], "not allowed with argument --jobs"),
    ],
)
def test_the_command_refuses_in_one_line(options, said, capsys) -> None:
    assert run(["sweep", "v2-90", "--quantities", "force.1", *options]) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert said in line
