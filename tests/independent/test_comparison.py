"""Evidence: several engines side by side, against sums of bare pistons and against other engines."""

from __future__ import annotations

import cmath
import json
import math
from pathlib import Path

import pytest

import symbalance as sb
from symbalance.cli import run
from symbalance.design import compare

NAMES = ("inline-1", "inline-3", "inline-5", "v2-90", "v2-45", "v6-60", "v6-90", "v8-90", "v8-90-flat")


def vector(engine: sb.Engine, order: int, kind: str, angle: float) -> complex:
    """Return the sum of the cylinders' n-th harmonics at a crank angle, up + i to the right."""
    plane = sum(c.station for c in engine.cylinders) / len(engine.cylinders)
    total = 0j
    for c in engine.cylinders:
        bank, throw = (math.radians(float(a.in_degrees())) for a in (c.bank, c.throw))
        weight = float(c.station - plane) if kind == "couple" else 1.0
        total += weight * math.cos(order * (angle + throw - bank)) * cmath.exp(1j * bank)
    return total


def compared(*names: str, order: int = 6, **more):
    return compare([sb.load(name) for name in names], order, **more)


@pytest.mark.parametrize("name", NAMES)
def test_the_largest_value_is_the_largest_over_a_turn(name):
    (line,) = table = compared(name)
    for place in table.places:
        kind, order = place
        angles = [2 * math.pi * i / 720 for i in range(720 // order)]
        size = line.size(place)
        assert size is not None
        seen = max(abs(vector(line.engine, order, kind, angle)) for angle in angles)
        assert math.isclose(float(size), seen, rel_tol=1e-3, abs_tol=1e-12)


def test_orders_that_cancel_everywhere_have_no_column():
    table = compared("inline-4", "inline-6")
    assert table.places == (("force", 2), ("force", 4), ("force", 6))
    assert compared("v12-60", "boxer-6").places[0][1] > 2


def test_per_cent_is_that_of_one_piston():
    table = compared("inline-4", "vw-vr6", order=2)
    assert table.percent  # of unlike cylinders there is nothing else
    (four, _) = table
    one = sb.balance(sb.load("inline-1"), 2)
    share = four.percent(("force", 2))
    assert share is not None
    assert math.isclose(float(share), 400 * float(one.values[2]), rel_tol=1e-15)


def test_what_balances_is_what_a_design_builds():

    for line in compared(*NAMES, order=2):
        devices = sb.design_balance(line.engine, [1, 2]).devices
        assert sorted(line.speeds) == sorted(d.speed for d in devices)
        assert line.counterweights == any(d.on_crank for d in devices)


def test_what_balances_does_not_depend_on_the_order_shown():
    assert [line.speeds for line in compared("inline-4", "v8-90", order=1)] == [(2, -2), (1,)]


# The command ----------------------------------------------------------------------------------------


def printed(capsys, *arguments: str) -> str:
    assert run(list(arguments)) == 0
    out, err = capsys.readouterr()
    assert err == ""
    return out


def refused(capsys, *arguments: str) -> str:
    assert run(list(arguments)) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err.count("\n") == 1
    return err


def test_several_engines_make_one_table(capsys):
    text = printed(capsys, "balance", "v8-90", "v8-90-flat", "inline-6", "--order", "6")
    assert max(map(len, text.splitlines())) < 80
    lines = {row.split()[0]: row.split() for row in text.splitlines() if row.strip()}
    assert lines["v8-90"] == ["v8-90", "90", "0", "4√2", "0", "√10", "f", "crank"]
    assert lines["v8-90-flat"][2:4] == ["4√2", "h"]
    assert lines["inline-6"][-1] == "nothing"


def test_a_file_gets_the_table_and_a_folder_a_file_each(capsys, tmp_path):
    table, folder = tmp_path / "table.json", tmp_path / "each"
    printed(capsys, "balance", "v8-90", "inline-4", "-o", str(table))
    data = json.loads(table.read_text(encoding="utf-8"))
    assert [e["engine"] for e in data["engines"]] == ["v8-90", "inline-4"]
    assert data["engines"][1]["orders"][0]["largest"] == "4"
    assert run(["balance", "v8-90", "inline-4", "-o", str(folder)]) == 0
    assert {p.name for p in folder.glob("*.txt")} == {"v8-90.txt", "inline-4.txt"}


def test_one_engine_that_is_refused_leaves_no_table(capsys, tmp_path):
    table = tmp_path / "table.md"
    assert "v1260" in refused(capsys, "balance", "v8-90", "v1260", "-o", str(table))
    assert not table.exists()


def test_a_table_never_replaces_an_engine_that_is_read(capsys, tmp_path: Path):
    engine, table = tmp_path / "mine.toml", tmp_path / "table.md"
    engine.write_text("[layout]\nfiring_order = [1, 3, 4, 2]\n", encoding="utf-8")
    table.symlink_to(engine)
    said = refused(capsys, "balance", "v8-90", str(engine), "-o", str(table))
    assert "would be replaced" in said
    assert "layout" in engine.read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("v8-90", "--percent"), "several engines"),
        (("v8-90", "--phases"), "several engines"),
        (("v8-90", "inline-4", "--power", "3"), "--power"),
        (("v8-90", "inline-4", "--jobs", "2"), "-o FOLDER/"),
        (("v8-90", "inline-4", "--rpm", "3000"), "--rpm"),
        (("v8-90", "inline-4", "--mass", "0.5"), "--mass"),
        (("v8-90", "-"), "standard input"),
        (("v8-90", "inline-4", "--order", "0"), "order = 0"),
    ],
)
def test_what_a_table_cannot_have_is_refused(capsys, arguments, words):
    assert words in refused(capsys, "balance", *arguments)
