"""Evidence: several engines side by side, against sums of bare pistons and against other engines."""

from __future__ import annotations

import cmath
import csv
import io
import json
import math
from pathlib import Path

import numpy as np
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


# In newtons ------------------------------------------------------------------------------------------


SIZES = {"stroke": 86, "rod": 145, "mass": "0.5", "pitch": 100}
OWN = {"vq30de": (0.673, 0.03665, 0.108, 147.15 / 36.65)}
OMEGA = 6000 * math.pi / 30


def shaking(engine: sb.Engine, kind: str) -> list[complex]:
    """Return the force in N or the couple in N m at 1440 angles, from the pistons' own places."""
    mass, radius, pitch, lam = OWN.get(engine.name, (0.5, 0.043, 0.1, 145 / 43))
    plane, count = sum(c.station for c in engine.cylinders) / len(engine.cylinders), 1440
    turn = np.arange(count) * 2 * np.pi / count
    total = np.zeros(count, complex)
    orders = np.fft.fftfreq(count, 1 / count)
    for c in engine.cylinders:
        bank, throw = (math.radians(float(a.in_degrees())) for a in (c.bank, c.throw))
        angle = turn + throw - bank
        place = np.cos(angle) + np.sqrt(lam**2 - np.sin(angle) ** 2)
        # Below 60, which is where the noise of doubles, times n squared, begins to show.
        spectrum = np.where(abs(orders) < 60, -(orders**2) * np.fft.fft(place), 0)
        push = -mass * radius * OMEGA**2 * np.fft.ifft(spectrum).real
        arm = float(c.station - plane) * pitch if kind == "couple" else 1.0
        total += arm * push * cmath.exp(1j * bank)
    return list(total)


@pytest.mark.parametrize("name", ["v8-90", "vq30de", "inline-5", "v2-90"])
def test_newtons_are_those_of_the_pistons(name):
    table = compared(name, "vq30de", order=6).at(rpm=6000, **SIZES)
    line, size = table[0], 1440
    for kind in ("force", "couple"):
        whole = np.array(shaking(line.engine, kind))
        top = line.all_orders(kind)
        assert top is not None
        assert math.isclose(top.value, abs(whole).max(), rel_tol=1e-4, abs_tol=1e-3)
        harmonics = np.fft.fft(whole) / size
        for order in (n for of, n in table.places if of == kind):
            value = line.newtons((kind, order))
            assert value is not None
            largest = abs(harmonics[order]) + abs(harmonics[-order])
            assert math.isclose(float(value), largest, rel_tol=1e-9, abs_tol=1e-6)


def test_each_engine_has_its_own_sizes_and_what_is_said_fills_the_gaps():
    table = compared("inline-4", "vq30de", order=2).at(rpm=6000, **SIZES)
    points = [line.operating_point for line in table]
    assert [str(p.mass) for p in points if p] == ["1/2", "673/1000"]
    with pytest.raises(TypeError, match="the sizes are"):
        table.at(rpm=6000, weight=1)


def test_over_speeds_each_engine_shakes_as_it_does_alone(capsys):
    """Against the pistons of each engine at each speed, through a turn."""
    sizes = [word for name, value in SIZES.items() for word in (f"--{name}", str(value))]
    arguments = ("vq30de", "inline-4", "--rpm", "1500:6000:4500", *sizes)
    rows = list(csv.DictReader(io.StringIO(printed(capsys, "balance", *arguments, "--format", "csv"))))
    whole = [row for row in rows if row["order"] == "0"]
    assert {(row["engine"], row["of"], row["rpm"]) for row in whole} == {
        (*which, rpm)
        for which in (("vq30de", "force"), ("vq30de", "couple"), ("inline-4", "force"))
        for rpm in ("1500.0", "6000.0")
    }
    for row in whole:
        at_6000 = max(map(abs, shaking(sb.load(row["engine"]), row["of"])))
        largest = at_6000 * (float(row["rpm"]) / 6000) ** 2
        assert math.isclose(float(row["value"]), largest, rel_tol=1e-4)
    assert "rpm  vq30de   inline-4" in printed(capsys, "balance", *arguments)


def test_a_table_at_a_speed_in_every_medium(capsys, tmp_path):
    options = ["balance", "vq30de", "inline-4", "--order", "2", "--rpm", "6000"]
    options += ["--stroke", "86", "--mass", "0.5"]
    text = printed(capsys, *options)
    assert "Free force and couple at 6000 rpm, in N, couples in N m" in text
    primary = 1.5 * 0.673 * 0.03665 * 0.108 * OMEGA**2  # N m
    data = json.loads(printed(capsys, *options, "--format", "json"))
    six = data["engines"][0]
    assert six["operating_point"]["mass"] == "0.673"
    (first,) = [o for o in six["orders"] if (o["of"], o["order"]) == ("couple", "1")]
    assert math.isclose(float(first["newton_metres"]), primary, rel_tol=1e-12)
    assert "newton_metres" in first["vertical"]
    assert six["largest"]["couple"]["unit"] == "N m"
    rows = list(csv.DictReader(io.StringIO(printed(capsys, *options, "--format", "csv"))))
    (row,) = [r for r in rows if (r["engine"], r["of"], r["order"]) == ("vq30de", "couple", "1")]
    assert math.isclose(float(row["value"]), primary, rel_tol=1e-12)
    assert row["value_unit"] == "N m"
    (whole,) = [r for r in rows if (r["engine"], r["of"], r["order"]) == ("vq30de", "couple", "")]
    assert math.isclose(float(whole["value"]), six["largest"]["couple"]["value"])
    assert "tab:mine-newtons" in printed(capsys, *options, "--format", "latex", "--label", "mine")
    book = tmp_path / "table.xlsx"
    assert printed(capsys, *options, "-o", str(book)) == ""
    assert book.read_bytes().startswith(b"PK")


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
        (("v8-90", "inline-4", "--rpm", "3000"), "v8-90: rpm = 3000: needs the engine's stroke, recip"),
        (("vq30de", "inline-4", "--rpm", "3000"), "inline-4: rpm = 3000: needs the engine's stroke"),
        (("vq30de", "inline-4", "--rpm", "1000:2000:500"), "inline-4: rpm = 1000: needs the engine's"),
        (("vq30de", "vq30de", "--rpm", "9:99:9", "--percent"), "--percent: is for a table at one speed"),
        (("v8-90", "vq30de", "--rod", "140", "--rpm", "9"), "v8-90: rod = 140: makes a rod ratio with"),
        (("v8-90", "inline-4", "--mass", "0.5"), "--mass"),
        (("v8-90", "-"), "standard input"),
        (("v8-90", "inline-4", "--order", "0"), "order = 0"),
    ],
)
def test_what_a_table_cannot_have_is_refused(capsys, arguments, words):
    assert words in refused(capsys, "balance", *arguments)
