"""Weighed parts to cylinders: against all arrangements, by a route that shares no code."""

from __future__ import annotations

import itertools
import json
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import symbalance as sb
from symbalance.cli import run
from symbalance.design.variations import Part, PartSet, parse_parts
from symbalance.design.variations.arrangement_search import best_arrangement
from symbalance.design.variations.assignment_bounds import (
    arrangement_sum,
    least_matching,
    lower_bound,
    norm,
)
from tests.pistons import harmonics, pistons
from tests.rotating_model import turning as rotating

GRAMS = [453, 447, 451, 450, 455, 448, 449, 446]


def single(layout, orders, lever) -> np.ndarray:
    """Return what 1 kg in each cylinder adds: one column of complex numbers a cylinder."""
    columns = []
    for piston in pistons(layout):
        force, couple = harmonics([piston]), harmonics([piston], arms=True)
        columns.append([x for n in orders for s in (n, -n) for x in (force[s], couple[s] / lever)])
    return np.array(columns).T


@pytest.mark.spread(2)
@pytest.mark.parametrize(
    "name",
    ["inline-2", "inline-3", "inline-4", "inline-5", "inline-6", "v6-60", "boxer-4", "radial-5", "v2-90"],
)
@pytest.mark.parametrize("orders", [(1,), (1, 2)])
def test_one_set_is_the_best_of_all_arrangements(name, orders):
    layout = sb.load(name).with_ratio(4)
    masses = np.array(GRAMS[: len(layout.cylinders)]) / 1000
    found = sb.design.assign_parts(layout, [str(m) for m in masses], orders=orders)
    matrix = single(layout, orders, found.lever)
    brute = {
        p: np.linalg.norm(matrix @ (masses[list(p)] - masses.mean()))
        for p in itertools.permutations(range(len(masses)))
    }
    assert found.proved
    assert found.criterion == pytest.approx(min(brute.values()), abs=1e-12)
    assert found.as_listed == pytest.approx(brute[tuple(range(len(masses)))], abs=1e-12)
    assert found.at_random == pytest.approx(
        np.sqrt(np.mean(np.square(list(brute.values())))), rel=1e-9, abs=1e-12
    )
    numbers = [int(found.places[c.number]["piston"].split()[1]) - 1 for c in layout.cylinders]
    assert brute[tuple(numbers)] == pytest.approx(found.criterion, abs=1e-12)


def sets(pistons_, sliding, turning):
    rods = [Part(f"r{i}", s, t) for i, (s, t) in enumerate(zip(sliding, turning, strict=True))]
    return [
        PartSet("piston", tuple(Part(f"p{i}", m) for i, m in enumerate(pistons_))),
        PartSet("rod", tuple(rods)),
    ]


@pytest.mark.parametrize("name", ["v2-60", "inline-3", "inline-4", "boxer-4"])
@pytest.mark.parametrize("whole", [False, True])
def test_pistons_and_rods_are_the_best_of_all_pairs(name, whole):
    layout = sb.load(name).with_ratio(4)
    count = len(layout.cylinders)
    heads, sliding = np.array(GRAMS[:count]) / 1000, np.array([181, 178, 184, 180][:count]) / 1000
    turning = np.array([421, 425, 417, 420][:count]) / 1000
    given_sets = sets(*([str(x) for x in xs] for xs in (heads, sliding, turning)))
    found = sb.design.assign_parts(layout, given_sets, whole=whole)
    matrix = single(layout, (1,), found.lever)
    pins = np.array([
        [np.exp(2j * np.pi * float(c.throw.turns)) * w for w in (1, p.station / found.lever, 0, 0)]
        for c, p in zip(layout.cylinders, pistons(layout), strict=True)
    ]).T  # fmt: skip
    level = [0 if whole else x.mean() for x in (heads, sliding, turning)]
    orders = [list(p) for p in itertools.permutations(range(count))]
    brute = min(
        np.linalg.norm(
            matrix @ (heads[p] - level[0] + sliding[q] - level[1]) + pins @ (turning[q] - level[2])
        )
        for p, q in itertools.product(orders, repeat=2)
    )
    assert found.proved
    assert found.criterion == pytest.approx(brute, abs=1e-12)


numbers = st.floats(-3, 3, allow_nan=False)


@pytest.mark.slow
@given(st.integers(2, 5), st.integers(1, 4), st.integers(1, 2), st.data())
@settings(max_examples=25, deadline=None)
def test_arrangements_of_any_vectors(count, size, kinds, data):
    """The search alone: exact, and never below the linear bound."""
    count = min(count, 4) if kinds == 2 else count
    chance = np.random.default_rng(data.draw(st.integers(0, 10**6)))
    tables = [
        [[tuple(v) for v in row] for row in chance.normal(size=(count, count, size))]
        for _ in range(kinds)
    ]
    start = tuple(chance.normal(size=size))
    found = best_arrangement(start, tables)
    orders = itertools.product(itertools.permutations(range(count)), repeat=kinds)
    brute = min(norm(arrangement_sum(start, tables, o)) for o in orders)
    assert found.length == pytest.approx(brute, abs=1e-9)
    assert lower_bound(start, tables)[0] <= brute + 1e-9


@given(st.integers(1, 6), st.integers(0, 10**6))
@settings(max_examples=40, deadline=None)
def test_least_matching_is_the_least(count, seed):
    costs = np.random.default_rng(seed).integers(-5, 6, (count, count)).astype(float)
    order = least_matching(costs.tolist())
    assert sorted(order) == list(range(count))
    brute = min(sum(costs[p[j], j] for j in range(count)) for p in itertools.permutations(range(count)))
    assert sum(costs[order[j], j] for j in range(count)) == brute


@pytest.mark.slow
def test_many_cylinders_have_a_good_arrangement_and_a_bound():
    layout = sb.load("radial-9")
    sixteen = sb.inline("-".join(map(str, range(1, 17))), ratio=4)
    for engine in (layout, sixteen):
        count = len(engine.cylinders)
        grams = np.random.default_rng(3).integers(440, 460, count)
        found = sb.design.assign_parts(engine, [f"{g}/1000" for g in grams], orders=[1])
        assert found.proved == (count <= 10)
        assert found.bound <= found.criterion < 0.2 * found.at_random
        assert sorted(n["piston"] for n in found.places.values()) == sorted(
            f"piston {i + 1}" for i in range(count)
        )


def test_what_is_left_is_what_pistons_leave():
    """Force and couple of the arrangement told, in N and N m, at 6000 rpm, and deviations alone count."""
    layout = sb.load("vq30de")
    masses = [Fraction(g, 1000) for g in GRAMS[:6]]
    found = sb.design.assign_parts(layout, masses, rpm=6000)
    placed = {n: masses[int(p["piston"].split()[1]) - 1] for n, p in found.places.items()}
    mean = sum(masses) / 6
    force = Fraction(733, 20) / 1000 * float(200 * np.pi) ** 2  # r omega^2
    engine = [
        p.changed(mass=float(placed[c.number] - mean) - 1)
        for p, c in zip(pistons(layout), layout.cylinders, strict=True)
    ]
    pairs = [(harmonics(engine, arms)[1], harmonics(engine, arms)[-1]) for arms in (False, True)]
    first = found.residual[0]
    assert first.force == pytest.approx(float(force) * sum(map(abs, pairs[0])), abs=1e-9)
    pitch = float(layout.pitch) / 1000
    assert first.couple == pytest.approx(float(force) * pitch * sum(map(abs, pairs[1])), abs=1e-9)


def test_equal_parts_stay_where_they_are():
    for name in ("inline-6", "v12-60", "inline-1"):
        layout = sb.load(name)
        found = sb.design.assign_parts(layout, ["0.45"] * len(layout.cylinders))
        assert found.criterion == found.as_listed == found.at_random == found.bound == 0
        assert found.places[1] == {"piston": "piston 1"}
    nothing = sb.design.assign_parts(sb.load("inline-4"), [0, 0, 0, 0], whole=True)
    assert nothing.criterion == 0


CSV = """name,piston,rod_reciprocating,rod_rotating
A,0.452,0.180,0.420
B,0.449,0.181,0.424
C,0.455,0.178,0.419
D,0.450,0.183,0.421
"""


def test_the_command(capsys, tmp_path: Path):
    path = tmp_path / "parts.csv"
    path.write_text(CSV, encoding="utf-8")
    assert run(["assign", "inline-4", "--parts", str(path)]) == 0
    out = capsys.readouterr().out
    assert "all were compared" in out
    assert (
        run(
            [
                "assign",
                "inline-4",
                "--parts",
                str(path),
                "--paired",
                "--orders",
                "1,2",
                "--format",
                "json",
            ]
        )
        == 0
    )
    document = json.loads(capsys.readouterr().out)
    assert sorted(p["set"] for p in document["places"].values()) == list("ABCD")
    assert document["proved"] is True
    assert document["criterion"] <= document["as_listed"]
    tex = tmp_path / "a.tex"
    assert run(["assign", "inline-4", "--parts", str(path), "--format", "latex", "-o", str(tex)]) == 0
    assert r"\begin{tabular}" in tex.read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "holds no parts"),
        ("piston\n", "holds no parts"),
        ("weight\n1\n", "parts.csv:1: header: names no column that is known"),
        ("piston,weight\n1,1\n", "column 'weight': is not known"),
        ("name\nA\n", "names no mass"),
        ("name,piston\nA,.4\nB,.4\nC,.4\nB,.4\n", "parts.csv:5: name = 'B': is the name of a piston at"),
        ("name,piston\nA,.4\nB,.4\nC,.4\nB,.4\n", "parts.csv:3 too; name each part once"),
        ("name,piston\né,.4\ne\u0301,.4\nC,.4\nD,.4\n", "parts.csv:2 too"),
        ("name,piston\npiston 2,.4\n,.4\nC,.4\nD,.4\n", "parts.csv:3: name = 'piston 2'"),
        ("piston\n.5\n.5\n.5\n500\n", "parts.csv:5: piston 4: reciprocating mass = 500 kg: must be at"),
        ("piston\n.5\n.5\n.5\n500\n", "most 50 kg, as the engine gives no stroke; write kg, not g;"),
        ("rod_rotating\n.5\n400\n.5\n.5\n", "parts.csv:3: rod 2: rotating mass = 400 kg: must be at"),
        ("piston,piston\n1,1\n", "names a column twice"),
        ("piston\n1,2\n", "parts.csv:2: the line: has 2 columns, not 1"),
        ("piston\nx\n", "parts.csv:2: piston = x"),
        ("piston\n-1\n", "parts.csv:2: piston = -1: must lie in [0, 50000]; give kg"),
        ("piston\n__import__('os')\n", "must be a number"),
        ("piston\n1\n2\n", "the engine has 4 cylinders"),
    ],
)
def test_bad_parts_are_refused_in_one_line(text, words, capsys, tmp_path):
    path = tmp_path / "parts.csv"
    path.write_text(text, encoding="utf-8")
    assert run(["assign", "inline-4", "--parts", str(path)]) == 2
    err = capsys.readouterr().err
    assert words in err
    assert err.count("\n") == 1


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--orders", "0"], "order"),
        (["--orders", "x"], "must be a whole number"),
        (["--rpm", "-1"], "must lie in"),
        (["--rpm", "1000"], "needs the engine's stroke"),
        (["--lever", "10"], "needs the engine's pitch"),
    ],
)
def test_bad_options_are_refused(options, words, capsys, tmp_path):
    path = tmp_path / "parts.csv"
    path.write_text(CSV, encoding="utf-8")
    engine = tmp_path / "e.toml"
    engine.write_text(
        "[crank_train]\nratio = 4\n[layout]\nfiring_order = [1, 3, 4, 2]\n", encoding="utf-8"
    )
    assert run(["assign", str(engine), "--parts", str(path), *options]) == 2
    assert words in capsys.readouterr().err


@pytest.mark.parametrize(
    ("train", "heaviest"),
    [
        ("ratio = 4", 50),  # nothing said: no car's nor locomotive's piston is heavier
        ("stroke = 50\nrod = 100", 2.5),  # a motorcycle's weigh 0.2 kg
        ("stroke = 580\nrod = 1200", 3902.24),  # a medium-speed engine's weigh 300 kg
        ("stroke = 3468\nrod = 3720", 834190.0),  # beyond what is read at all
        ("ratio = 4\nreciprocating_mass = 300", 6000),
        ("stroke = 50\nrod = 100\nreciprocating_mass = 300", 6000),
    ],
)
def test_the_heaviest_part_goes_with_the_engine(train, heaviest, tmp_path, capsys):
    """Twenty thousand times the stroke's cube in metres, or twenty times the engine's own mass."""
    engine, parts = tmp_path / "e.toml", tmp_path / "p.csv"
    engine.write_text(f"[crank_train]\n{train}\n[layout]\nfiring_order = [1, 2]\n", encoding="utf-8")
    for share, code in ((0.999, 0), (1.001, 2)):
        parts.write_text(f"piston\n{min(heaviest, 50_000) * share}\n0.4\n", encoding="utf-8")
        assert run(["assign", str(engine), "--parts", str(parts)]) == code
    lines = capsys.readouterr().err.splitlines()
    (refusal,) = [line for line in lines if "far more than pistons" not in line]
    assert "kg" in refusal


def test_two_parts_of_one_name_are_refused_in_python_too():
    twice = PartSet("piston", (Part("A", ".4"), Part("A", ".41")))
    with pytest.raises(sb.SymbalanceError, match=r"^name = 'A': is the name of a piston before, and of"):
        sb.design.assign_parts(sb.inline("1-2", ratio=4), [twice])


def test_separators_and_comments():
    for separator in ",;\t":
        rows = [["piston", "name"], ["0.4", "left"], ["0.5", "right"]]
        text = "# weighed\n\n" + "\n".join(separator.join(r) for r in rows)
        (found,) = parse_parts(text, "p")
        assert [p.name for p in found.parts] == ["left", "right"]


@pytest.mark.slow
@pytest.mark.parametrize("name", ["inline-3", "v6-60", "v8-90"])
def test_whole_masses_count_beside_what_turns(name):
    """Counterweights and shafts stay as the nominal engine has them; every piston is its own weight."""
    sizes = sb.engine.CrankTrain(
        stroke=Fraction(80), rod=Fraction(160), reciprocating_mass=Fraction(45, 100),
        rotating_mass=Fraction(3, 10),
    )  # fmt: skip
    layout = sb.engine.from_cylinders(sb.load(name).cylinders, crank_train=sizes)
    smooth = sb.design_balance(layout, [1, 2]).balanced
    masses = [Fraction(g, 1000) for g in GRAMS[: len(layout.cylinders)]]
    found = sb.design.assign_parts(smooth, masses, orders=[1, 2], whole=True)
    best = {
        c.number: masses[int(found.places[c.number]["piston"].split()[1]) - 1] for c in layout.cylinders
    }
    engine = [
        p.changed(mass=float(best[c.number]) - 1)
        for p, c in zip(pistons(layout), layout.cylinders, strict=True)
    ]
    for shaking in found.residual:
        for arms, told in ((False, shaking.force), (True, shaking.couple)):
            parts = harmonics(engine, arms)
            total = 0.0
            for n in (shaking.order, -shaking.order):
                rows = [(p, float(z - layout.mean_station)) for s, p, z in rotating(smooth) if s == n]
                made = sum((complex(p) * (z if arms else 1.0) * 0.45 for p, z in rows), 0j)
                total += abs(parts[n] + made)
            assert told == pytest.approx(total, rel=1e-9, abs=1e-12)
    assert found.criterion < sb.design.assign_parts(layout, masses, orders=[1, 2], whole=True).criterion


@pytest.mark.parametrize("form", ["text", "json", "latex"])
def test_orders_that_leave_nothing_are_said_to(form, tmp_path, capsys):
    """A like engine has no odd order above 1, whatever its parts weigh."""
    parts = tmp_path / "parts.csv"
    rows = [f"{n},0.5,0.2,0.30{n}" for n in range(4)]
    parts.write_text("\n".join(["name,piston,rod_reciprocating,rod_rotating", *rows]), encoding="utf-8")
    assert run(["assign", "inline-4", "--parts", str(parts), "--orders", "7", "--format", form]) == 0
    printed = capsys.readouterr().out
    assert {"text": "none: these orders leave nothing", "json": '"left": []'}.get(form, "") in printed


@pytest.mark.parametrize(("count", "sets"), [(1, 1), (3, 1), (4, 2), (5, 1)])
def test_the_expected_length_is_the_root_mean_square_of_all_arrangements(count, sets):
    """With a constant, and columns that do not sum to nothing: every order of every set alike."""
    from symbalance.design.variations.assignment_objective import expected_length

    draw = np.random.default_rng(count)
    tables, start = draw.normal(0.7, 1, (sets, count, count, 3)), draw.normal(size=3)
    orders = [list(itertools.permutations(range(count)))] * sets
    squares = []
    for choice in itertools.product(*orders):
        total = start + sum(
            t[p, place] for t, own in zip(tables, choice, strict=True) for place, p in enumerate(own)
        )
        squares.append(total @ total)
    rows = [[[tuple(v) for v in row] for row in table] for table in tables.tolist()]
    assert expected_length(tuple(start), rows) == pytest.approx(np.mean(squares) ** 0.5, rel=1e-12)


@pytest.mark.slow
@pytest.mark.parametrize(("count", "proved"), [(12, True), (16, False)])
def test_a_dozen_places_have_their_best_arrangement_proved_and_many_more_have_not(count, proved):
    from symbalance.design.variations.arrangement_search import best_arrangement

    draw = np.random.default_rng(2)
    table = [[tuple(v) for v in row] for row in draw.normal(size=(count, count, 2)).tolist()]
    assert best_arrangement((0.0, 0.0), [table]).proved == proved
