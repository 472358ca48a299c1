"""`symbalance crankshaft` as a user meets it: results, restarts, refusals."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from base64 import b64decode
from dataclasses import replace
from importlib import import_module
from pathlib import Path

import numpy as np
import pytest

from symbalance.cli import run
from symbalance.crankshaft import assembly
from symbalance.crankshaft.files import read_running_engine
from symbalance.crankshaft.running import configure_run
from symbalance.crankshaft.running import outcome as saved
from symbalance.crankshaft.running import speed_sweep as sweep
from symbalance.crankshaft.system import UnsolvedError
from symbalance.jobs import Store
from tests import ROOT
from tests.cranks import SINGLE, engine, sheet, written

QUICK = ("--webs", "nominal", "--steps", "120", "--about", "centre")


@pytest.fixture
def single(tmp_path: Path) -> str:
    return str(written(tmp_path, sheet()))


@pytest.mark.slow
def test_a_run_leaves_reports_curves_and_pictures(single, tmp_path, capsys, compile_latex):
    out = tmp_path / "out"
    assert run(["crankshaft", single, "--rpm", "1000:2000:500", *QUICK, "-o", str(out)]) in (0, 1)
    text, progress = capsys.readouterr()
    said, done = [], []
    for line in progress.splitlines():
        (done if re.match(r"\d of 3 done", line) else said).append(line)
    assert [line.split(":")[0] for line in said] == [
        f"{rpm} rpm ({i} of 3)" for i, rpm in enumerate((1000, 1500, 2000), 1)
    ]
    assert done[0].startswith("1 of 3 done, about ")
    assert done[-1] == "3 of 3 done"
    names = {p.name for p in out.iterdir()}
    assert {
        "report.txt",
        "report.tex",
        "report.html",
        "report.json",
        "speeds",
        "waterfall.png",
        "order-cuts.png",
    } < names
    assert {f"curves-{rpm}rpm.csv" for rpm in (1000, 1500, 2000)} < names
    assert (out / "report.txt").read_text(encoding="utf-8") == text
    for picture in out.glob("*.png"):
        assert picture.read_bytes().startswith(b"\x89PNG")
    source = (out / "report.tex").read_text(encoding="utf-8")
    assert compile_latex(re.sub(r"(includegraphics\[[^]]*\]\{)", rf"\1{out}/", source)).exists()
    pictures = {p.name for p in out.glob("*.png")}
    assert set(re.findall(r"includegraphics\[[^]]*\]\{(.*?)\}", source)) == pictures
    page = (out / "report.html").read_text(encoding="utf-8")
    shown = re.findall(r'src="data:image/png;base64,([^"]*)"', page)
    assert {b64decode(data) for data in shown} == {(out / name).read_bytes() for name in pictures}
    found = json.loads((out / "report.json").read_text(encoding="utf-8"))
    curve = np.genfromtxt(out / "curves-2000rpm.csv", delimiter=",", names=True)
    assert len(curve) == 120
    assert curve.dtype.names is not None
    name = curve.dtype.names[1]
    assert "pin_1_bending" in name
    loads = np.genfromtxt(out / "loads-2000rpm.csv", delimiter=",", names=True)
    assert loads.dtype.names == ("crank_angle_degrees", "pin_1_U_N", "pin_1_V_N")
    pressed = 3 + 60 - 1.01325  # bar, at the firing top dead centre, where the piston's inertia pulls up
    gas = pressed * 1e5 * np.pi / 4 * 0.092**2
    pulled = 1.5 * 0.06 * (2000 * np.pi / 30) ** 2 * (1 + 60 / 192)
    assert loads["pin_1_U_N"][0] == pytest.approx(pulled - gas, rel=1e-6)
    extreme = next(c for c in found["channels"] if c["name"] == "pin 1 bending")
    assert extreme["largest"] >= curve[name].max() * (1 - 1e-6)
    assert [s["rpm"] for s in found["speeds"]] == [1000, 1500, 2000]


@pytest.mark.slow
def test_a_second_run_takes_up_what_is_finished(single, tmp_path, capsys):
    options = ["crankshaft", single, *QUICK, "--no-plots", "-o", str(tmp_path / "out")]
    run([*options, "--rpm", "1500"])
    first = capsys.readouterr()
    run([*options, "--rpm", "1000,1500"])
    second = capsys.readouterr()
    assert "1500 rpm (1 of 1): solved" in first.err
    assert "1000 rpm (1 of 2): solved" in second.err
    assert "1500 rpm (2 of 2): found" in second.err
    changed = Path(single).read_text(encoding="utf-8").replace("clearance = 0.035", "clearance = 0.04")
    Path(single).write_text(changed, encoding="utf-8")
    run([*options, "--rpm", "1500"])
    assert "1500 rpm (1 of 1): solved" in capsys.readouterr().err


FILM = "".join(
    f"{angle}," + ",".join(["1e8,0,0,1e8,1e5,0,0,1e5"] * 2) + "\n" for angle in range(0, 720, 10)
)
UNLIKE = """strokes = 4
[[cylinder]]
number = 1
throw = 0
station = 1
fires = 0
[[cylinder]]
number = 2
throw = 180
fires = 180
reciprocating_mass = 1.4
"""


def saved_anew(path, out, capsys, change):
    """Whether a speed is solved anew after a change of what it depends on."""
    options = ["crankshaft", str(path), "--rpm", "1500", *QUICK, "--no-plots", "-o", str(out)]
    run(options)
    capsys.readouterr()
    run(options)
    assert "1500 rpm (1 of 1): found" in capsys.readouterr().err
    change()
    run(options)
    said = capsys.readouterr().err
    anew = "1500 rpm (1 of 1): solved" in said
    assert anew == ("1500rpm.result: is of another input, other settings or another program" in said)
    return anew


@pytest.mark.slow
def test_a_film_table_counts_by_its_content(tmp_path, capsys):
    """The same name, ten times the film: not found; another folder, the same content: found."""
    film = tmp_path / "film.csv"
    film.write_text(FILM, encoding="utf-8")
    path = written(tmp_path, sheet(viscosity='table = "film.csv"'))

    def stiffer():
        film.write_text(FILM.replace("1e8", "1e9"), encoding="utf-8")

    assert saved_anew(path, tmp_path / "out", capsys, stiffer)
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    (elsewhere / "film.csv").write_text(film.read_text(encoding="utf-8"), encoding="utf-8")
    moved = written(elsewhere, path.read_text(encoding="utf-8"))
    options = [str(moved), "--rpm", "1500", *QUICK, "--no-plots", "-o", str(tmp_path / "out")]
    run(["crankshaft", *options])
    assert "1500 rpm (1 of 1): found" in capsys.readouterr().err


@pytest.mark.slow
def test_a_pressure_trace_counts_by_its_content(single, tmp_path, capsys):
    trace = tmp_path / "trace.csv"

    def raise_pressure():
        trace.write_text(trace.read_text(encoding="utf-8").replace(",63", ",70"), encoding="utf-8")

    assert saved_anew(single, tmp_path / "out", capsys, raise_pressure)


@pytest.mark.slow
def test_a_cylinders_own_sizes_count(tmp_path, capsys):
    path = written(tmp_path, UNLIKE + sheet("").replace("[layout]\n", ""))

    def weigh():
        text = path.read_text(encoding="utf-8").replace("mass = 1.4", "mass = 1.6")
        path.write_text(text, encoding="utf-8")

    assert saved_anew(path, tmp_path / "out", capsys, weigh)


@pytest.mark.slow
def test_the_program_counts(single, tmp_path, capsys, monkeypatch):
    def update():
        monkeypatch.setattr(saved.store, "program_digest", lambda: "of another version")

    assert saved_anew(single, tmp_path / "out", capsys, update)


@pytest.mark.slow
def test_the_webs_compliance_counts_not_only_its_name(single, tmp_path, capsys, monkeypatch):
    real = assembly.nominal_flexibility

    def soften():
        monkeypatch.setattr(assembly, "nominal_flexibility", lambda arm: 2 * real(arm))

    assert saved_anew(single, tmp_path / "out", capsys, soften)


@pytest.mark.slow
def test_a_measured_curve_solves_nothing_anew(tmp_path, capsys):
    rows = "".join(f"{a},{a / 10}\n" for a in range(0, 720, 60))
    (tmp_path / "gauge.csv").write_text(rows, encoding="utf-8")
    path = written(tmp_path, sheet())

    def measure():
        table = '[running.overlay]\nfile = "gauge.csv"\nchannel = "pin 1 bending"'
        path.write_text(sheet(SINGLE, table), encoding="utf-8")

    assert not saved_anew(path, tmp_path / "out", capsys, measure)


@pytest.mark.slow
def test_speeds_close_together_keep_their_own_files(single, tmp_path, capsys):
    out = tmp_path / "out"
    options = ["crankshaft", single, *QUICK, "--no-plots", "-o", str(out)]
    for how in ("solved", "found"):
        run([*options, "--rpm", "2200.001,2200.002"])
        report, progress = capsys.readouterr()
        for rpm in ("2200.001", "2200.002"):
            assert f"\n  {rpm} " in report
            assert f"{rpm} rpm" in progress
        assert progress.count(how) == 2
    for name in ("curves-{}rpm.csv", "loads-{}rpm.csv", "speeds/{}rpm.result"):
        assert all((out / name.format(rpm)).exists() for rpm in ("2200.001", "2200.002"))
    assert not [p for p in out.rglob("*") if "2200rpm" in p.name]
    assert run([*options, "--rpm", "2200.001,2200.001"]) == 2
    assert "rpm = 2200.001: is named twice" in capsys.readouterr().err


@pytest.mark.slow
def test_a_damaged_file_is_said_and_solved_anew(single, tmp_path, capsys):
    options = ["crankshaft", single, *QUICK, "--no-plots", "-o", str(tmp_path / "out"), "--rpm", "1500"]
    run(options)
    whole = tmp_path / "out" / "report.json"
    first, kept = whole.read_text(encoding="utf-8"), tmp_path / "out" / "speeds" / "1500rpm.result"
    content = kept.read_bytes()
    capsys.readouterr()
    for damaged in (b"", b"half a file", content[: len(content) // 2]):
        kept.write_bytes(damaged)
        run(options)
        said = capsys.readouterr().err
        assert "1500rpm.result: is " in said
        assert "1500 rpm (1 of 1): solved" in said
    again = json.loads(whole.read_text(encoding="utf-8"))
    assert again["channels"] == json.loads(first)["channels"]


@pytest.mark.slow
def test_no_damage_to_a_file_gets_through(single, tmp_path):
    """Bytes changed one at a time: no outcome, and why."""
    made = configure_run(read_running_engine(single), webs="nominal", steps=90, about="centre")
    outcome = sweep.run_speed(made, 2200.0)
    store = Store(tmp_path)
    store.save("key", saved.encode_outcome(outcome), saved.slot_of(2200.0))
    path = store.path("2200rpm")
    content = path.read_bytes()
    for place in np.linspace(0, len(content) - 1, 300).astype(int):
        path.write_bytes(content[:place] + bytes([content[place] ^ 255]) + content[place + 1 :])
        restored = store.load("key", "2200rpm")
        assert restored.payload is None
        assert restored.reason
    path.write_bytes(content)
    payload = store.load("key", "2200rpm").payload
    assert payload is not None
    assert (saved.decode_outcome(payload).values == outcome.values).all()


@pytest.mark.slow
def test_an_interrupt_loses_nothing_finished(single, tmp_path, capsys, monkeypatch):
    out, real = tmp_path / "out", sweep.run_speed

    def interrupted(made, rpm, progress):
        if rpm > 1000:
            raise KeyboardInterrupt
        return real(made, rpm, progress)

    options = ["crankshaft", single, *QUICK, "--no-plots", "-o", str(out), "--rpm", "1000,1500"]
    monkeypatch.setattr(sweep, "run_speed", interrupted)
    assert run(options) == 130
    assert [p.name for p in out.rglob("*") if p.is_file()] == ["1000rpm.result"]
    monkeypatch.setattr(sweep, "run_speed", real)
    assert run(options) in (0, 1)
    progress = capsys.readouterr().err
    assert "1000 rpm (1 of 2): found" in progress
    assert "1500 rpm (2 of 2): solved" in progress
    assert "interrupted: 1 of 2 finished, kept in" in progress
    assert f"go on with: symbalance crankshaft {single}" in progress
    (out / "speeds" / "1000rpm.result").write_bytes(b"half a file")
    assert run(options) in (0, 1)
    assert "1000 rpm (1 of 2): solved" in capsys.readouterr().err


@pytest.mark.slow
def test_a_measured_curve_is_compared(tmp_path, capsys):
    rows = "".join(f"{a},{10 * np.cos(np.radians(a)):.4f}\n" for a in range(0, 720, 10))
    (tmp_path / "gauge.csv").write_text("angle,MPa\n" + rows, encoding="utf-8")
    more = '[running.overlay]\nfile = "gauge.csv"\nchannel = "pin 1 bending"'
    path = written(tmp_path, sheet(SINGLE, more))
    run(["crankshaft", str(path), *QUICK, "--format", "json"])
    (shown,) = json.loads(capsys.readouterr().out)["measured"]
    assert shown["span"] == pytest.approx(20)
    assert shown["rms"] > 0


@pytest.mark.slow
def test_formats_and_exit_codes(tmp_path, capsys):
    """0 where all is valid, 1 where a place is not safe."""
    calm = str(written(tmp_path, sheet()))
    options = ["crankshaft", calm, *QUICK, "--no-plots"]
    for form, start in (("latex", "% Needs"), ("html", "<!DOCTYPE html>"), ("markdown", "# Running")):
        assert run([*options, "--format", form]) == 0
        assert capsys.readouterr().out.startswith(start)
    assert run([*options, "--format", "latex", "--standalone"]) == 0
    assert capsys.readouterr().out.startswith("\\documentclass")
    assert run([*options, "--standalone"]) == 2
    assert "--standalone: is for LaTeX" in capsys.readouterr().err
    weak = "[running.strength]\ntensile = 60\nendurance = 20"
    assert run(["crankshaft", str(written(tmp_path, sheet(SINGLE, weak))), *QUICK]) == 1


REFUSED = [
    ({"diameter": "diameter = 0"}, "diameter = 0: must be positive"),
    ({"young": "yuong = 206"}, "crankshaft.yuong: is an unknown key; did you mean young?"),
    ({"young": 'young = "x"'}, "young = x: must be a number"),
    ({"thickness": "thickness = [24]"}, "must be one number or 2"),
    ({"rpm": "rpm = 0"}, "rpm = 0: must be positive"),
    ({"rpm": "rpm = []"}, "names no speed"),
    ({"rpm": "rpm = [900, 900]"}, "rpm = 900: is named twice"),
    ({"pressure": ""}, "[running]: needs pressure"),
    ({"pressure": 'pressure = "none.csv"'}, "none.csv: cannot be read"),
    ({"pressure": "compression = 16"}, "[running]: needs heat"),
    ({"big_end_mass": ""}, "[running]: needs big_end_mass"),
    ({"big_end_mass": "rod_mass = 1.5"}, "[running]: needs rod_centre"),
    ({"bore": "bore = -92"}, "bore = -92: must be positive"),
    ({"clearance": "clearance = 0"}, "clearance = 0: must be positive"),
    ({"clearance": "clearance = 35"}, "clearance = 35: exceeds 0.65 mm, a hundredth of the journal"),
    ({"bore": "bore = 92\nambient = -1"}, "ambient = -1: must not be negative"),
    ({"pressure": "compression = 16\nheat = -10"}, "heat = -10: must lie in"),
    ({"length": "length = -5"}, "length = -5: must be positive"),
    ({"diameter": "diameter = 300"}, "width = 100 mm: must cover the journal with its fillets"),
    ({"fillet": "fillet = 60"}, "fillet = 60 mm: must be less than half the length"),
    ({"viscosity": ""}, "[bearings]: needs viscosity"),
    ({"viscosity": "viscosity = 0.01\nlength = 40"}, "length = 40: exceeds the journal's 30 mm"),
    ({"viscosity": "viscosity = 0.01\nhousing_vertical = 1e9"}, "needs housing_lateral"),
    ({"young": "young = 206\npoisson = 0.5"}, "poisson = 0.5: must lie in [0, 0.5)"),
    ({"young": "young = 206\nno_bearing = [1, 2]"}, "leaves the crank no bearing"),
    ({"young": "young = 206\nno_bearing = [3]"}, "no_bearing = 3: must be a whole number from 1 to 2"),
    ({"bore": "bore = 92\ndamping = 1.5"}, "damping = 1.5: must lie in [0, 1)"),
    ({"reciprocating_mass": ""}, "cylinder 1: has no reciprocating_mass"),
]


@pytest.mark.spread(2)
@pytest.mark.parametrize(("changed", "said"), REFUSED, ids=[said for _, said in REFUSED])
def test_bad_input_is_one_line_that_names_the_place(changed, said, tmp_path, capsys):
    path = written(tmp_path, sheet(**changed))
    assert run(["crankshaft", str(path), *QUICK]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert len(err.splitlines()) == 1
    assert said in err
    assert ".toml:" in err or ".csv" in err


def test_a_chain_that_does_not_fit_the_pitch_is_refused(tmp_path, capsys):
    text = sheet("[layout]\nfiring_order = [1, 3, 4, 2]\n").replace("rod = 192", "rod = 192\npitch = 111")
    assert run(["crankshaft", str(written(tmp_path, text)), *QUICK]) == 2
    assert "pins 1 and 2 lie 110 mm apart: must lie 111 mm apart" in capsys.readouterr().err


def test_missing_tables_and_counterweights_on_one_web_are_refused(tmp_path, capsys):
    bare = written(tmp_path, sheet()).with_name("bare.toml")
    bare.write_text(
        "[layout]\nfiring_order = [1]\n[crank_train]\nreciprocating_mass = 1\n", encoding="utf-8"
    )
    assert run(["crankshaft", str(bare), *QUICK]) == 2
    assert "has no [crankshaft] table" in capsys.readouterr().err
    weight = "[[crankshaft.counterweight]]\nwebs = [1]\nmass = 1\nradius = 50"
    text = sheet(SINGLE, weight, weight)
    assert run(["crankshaft", str(written(tmp_path, text)), *QUICK]) == 2
    err = capsys.readouterr().err
    line = text.splitlines().index(
        "[[crankshaft.counterweight]]", text.splitlines().index(weight[:28]) + 1
    )
    assert f":{line + 2}: webs = [1]: gives web 1 a second counterweight" in err


def test_a_counterweight_names_its_webs(tmp_path, capsys):
    text = sheet(SINGLE, "[[crankshaft.counterweight]]\nmass = 1\nradius = 50")
    assert run(["crankshaft", str(written(tmp_path, text)), *QUICK]) == 2
    assert "[[crankshaft.counterweight]]: needs webs" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("name", "channel", "said"),
    [
        ("none.csv", "pin 1 bending", "none.csv: cannot be read"),
        ("wide.csv", "pin 1 bending", "wide.csv:2: the line: has 3 columns, not 2"),
        ("short.csv", "pin 1 bending", "holds 1 points, and a curve needs 8"),
        ("short.csv", "pin 9 bending", "names no channel of this crank; one of pin 1 bending"),
    ],
)
def test_a_measured_curve_is_checked_before_the_run(name, channel, said, tmp_path, capsys):
    (tmp_path / "wide.csv").write_text("degrees,MPa,x\n0,1,2\n", encoding="utf-8")
    (tmp_path / "short.csv").write_text("degrees,MPa\n0,1\n", encoding="utf-8")
    text = sheet(SINGLE, f'[running.overlay]\nfile = "{name}"\nchannel = "{channel}"')
    assert run(["crankshaft", str(written(tmp_path, text)), *QUICK]) == 2
    out, err = capsys.readouterr()
    assert (out, len(err.splitlines())) == ("", 1)
    assert said in err


@pytest.mark.parametrize(
    ("coefficients", "said"),
    [
        ([-1e8, 0, 0, -1e8, -1e5, 0, 0, -1e5], "film.csv"),
        ([1e8, 0, 0, 1e8, "nan", 0, 0, 1e5], "film.csv:1: cvv of bearing 1 = nan: must be a number"),
        ([1e8, 0, 0], "has 7 columns, not 17; degrees, then for each bearing kvv"),
    ],
)
def test_a_film_table_that_no_film_has_is_refused(coefficients, said, tmp_path, capsys):
    row = ",".join(map(str, coefficients))
    rows = "".join(f"{angle},{row},{row}\n" for angle in range(0, 720, 10))
    (tmp_path / "film.csv").write_text(rows, encoding="utf-8")
    path = written(tmp_path, sheet(viscosity='table = "film.csv"'))
    assert run(["crankshaft", str(path), *QUICK]) == 2
    out, err = capsys.readouterr()
    assert (out, len(err.splitlines())) == ("", 1)
    assert said in err


@pytest.mark.parametrize(
    ("option", "said"),
    [
        (("--rpm", "fast"), "--rpm fast: must be speeds in rpm"),
        (("--rpm", "0"), "--rpm 0: must be positive"),
        (("--rpm", "1000:2000"), "--rpm 1000:2000: must be from:to:step"),
        (("--rpm", "1:90000:0.1"), "asks for more than 1000 speeds"),
        (("--modes", "-1"), "modes = -1: must be a whole number"),
        (("--steps", "10"), "steps = 10: must be a whole number"),
        (("--webs", "solid?"), "invalid choice"),
    ],
)
def test_bad_options_are_refused(single, option, said, capsys):
    assert run(["crankshaft", single, *QUICK, *option]) == 2
    assert said in capsys.readouterr().err


def test_other_commands_read_past_the_tables(single, capsys):
    assert run(["balance", single]) == 0
    assert "1 cylinder" in capsys.readouterr().out


def test_a_missing_library_is_one_line_with_the_command(single, capsys, monkeypatch):
    monkeypatch.setitem(sys.modules, "rainflow", None)
    assert run(["crankshaft", single, *QUICK, "--no-plots"]) == 2
    assert "rainflow is not installed; pip install 'symbalance[crankshaft]'" in capsys.readouterr().err
    monkeypatch.undo()
    monkeypatch.setitem(sys.modules, "matplotlib.figure", None)
    assert run(["crankshaft", single, *QUICK]) == 2
    assert "or --no-plots" in capsys.readouterr().err


@pytest.mark.slow
def test_the_package_and_other_commands_need_none_of_it():
    code = (
        "import sys, symbalance, symbalance.cli as c; c.run(['engines']); print('scipy' in sys.modules)"
    )
    printed = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert printed.stdout.splitlines()[-1] == "False"


def test_the_readmes_tables_are_read(tmp_path):
    """The README's engine file with the three tables for cranks."""
    root = ROOT
    readme, keys = ((root / f).read_text(encoding="utf-8") for f in ("README.md", "docs/engine-files.md"))
    blocks = re.findall(r"```toml\n(.*?)```", readme + keys, re.DOTALL)
    tables = next(block for block in blocks if "[crankshaft.journal]" in block)
    text = blocks[0].replace("[layout]", "reciprocating_mass = 0.6\n\n[layout]") + tables
    made = engine(tmp_path, text)
    assert len(made.crank.pins) == 4
    assert made.operation.rpm == (1000, 2200)
    weighted = [i for i, p in enumerate(made.crank.parts) if getattr(p, "counterweight", None)]
    assert weighted == [1, 3, 13, 15]


@pytest.mark.slow
def test_the_other_commands_counterweights_are_said_to_take_no_part(single, capsys):
    table = '\n[[counterweight]]\nthrow = 1\noverbalance = "1/2"\n'
    text = Path(single).read_text(encoding="utf-8")
    Path(single).write_text(text + table, encoding="utf-8")
    run(["crankshaft", single, "--rpm", "1500", *QUICK])
    assert "[[counterweight]] and [[balance_shaft]] take no part" in capsys.readouterr().out
    Path(single).write_text(text, encoding="utf-8")
    run(["crankshaft", single, "--rpm", "1500", *QUICK])
    assert "take no part" not in capsys.readouterr().out


def grows(*_):
    raise UnsolvedError("the motion", "grows", "more steps")


@pytest.mark.slow
def test_films_that_do_not_settle_are_tried_at_finer_steps(single, tmp_path, capsys, monkeypatch):
    """The result is that of a run at the finer steps, and every place says so."""
    plain = ["crankshaft", single, "--rpm", "1500", "--webs", "nominal", "--no-plots"]
    run([*plain, "--steps", "240", "-o", str(tmp_path / "direct")])
    real, seen = sweep._solve_about_orbits, []

    def coarse_fails(made, rpm, orbits, **options):
        seen.append(made.steps)
        return grows() if seen == [120, 120] else real(made, rpm, orbits, **options)

    monkeypatch.setattr(sweep, "_solve_about_orbits", coarse_fails)
    capsys.readouterr()
    assert run([*plain, "--steps", "120", "-o", str(tmp_path / "finer")]) == 0
    report, progress = capsys.readouterr()
    assert seen[:3] == [120, 120, 240]
    assert "1500 rpm: films do not settle at 120 steps a cycle" in progress
    assert "then the motion: grows; more steps: trying 240 steps" in progress
    assert "1500 rpm: 240 steps a cycle: at 120 the films do not settle" in report
    texts = [(tmp_path / f / "curves-1500rpm.csv").read_text("utf-8") for f in ("direct", "finer")]
    assert texts[0] == texts[1]
    (speed,) = json.loads((tmp_path / "finer" / "report.json").read_text("utf-8"))["speeds"]
    assert (speed["steps"], speed["reason"]) == (240, None)


@pytest.mark.slow
def test_a_speed_whose_films_do_not_settle_has_no_stresses(single, tmp_path, capsys):
    """One pass leaves orbits half a clearance off their films: said everywhere, printed nowhere."""
    out = tmp_path / "out"
    options = ["crankshaft", single, "--rpm", "2200", "--webs", "nominal", "--steps", "120"]
    options += ["--passes", "1", "-o", str(out)]
    for _ in ("solved", "found"):
        assert run(options) == 1
        report, progress = capsys.readouterr()
        why = "films do not settle at 120 steps a cycle and 1 pass: orbits off theirs by 0."
        assert f"2200 rpm (1 of 1): {why}" in progress
        assert f"2200 rpm {why}" in " ".join(report.split())
        assert "No speed is to be relied on." in report
        assert "Stresses" not in report
        assert "Durability" not in report
    row = next(line.split() for line in report.splitlines() if line.startswith("  2200  "))
    assert row[3:5] == ["–", "–"]
    found = json.loads((out / "report.json").read_text(encoding="utf-8"))
    (speed,) = found["speeds"]
    assert speed["reason"].startswith(why)
    assert speed["departure"] > 0.05
    assert (speed["bearing"], speed["largest"], speed["error"]) == (None, None, None)
    assert (found["channels"], found["places"], found["measured"]) == ([], [], [])
    page = (out / "report.tex").read_text(encoding="utf-8")
    assert why in page
    assert "nan" not in report + page
    assert "Stresses and twists" not in page
    lines = (out / "curves-2200rpm.csv").read_text(encoding="utf-8").splitlines()
    assert len(lines) == 2
    assert lines[0].startswith(f"# 2200 rpm: {why}")
    assert [p.name for p in out.glob("*.png")] == ["frequencies.png"]


@pytest.mark.slow
def test_other_speeds_keep_their_stresses(single, tmp_path, capsys, monkeypatch):
    real = sweep._solve_about_orbits

    def one_fails(made, rpm, orbits, **options):
        return grows() if rpm == 1500 else real(made, rpm, orbits, **options)

    monkeypatch.setattr(sweep, "_solve_about_orbits", one_fails)
    rows = "".join(f"{a},{a / 10}\n" for a in range(0, 720, 60))
    (tmp_path / "gauge.csv").write_text(rows, encoding="utf-8")
    curve = '[running.overlay]\nfile = "gauge.csv"\nchannel = "pin 1 bending"\nrpm = 1500'
    path = str(written(tmp_path, sheet(SINGLE, curve)))
    options = ["crankshaft", path, "--webs", "nominal", "--steps", "120", "--format", "json"]
    assert run([*options, "--rpm", "1500,2200"]) == 1
    both = json.loads(capsys.readouterr().out)
    assert run([*options, "--rpm", "2200"]) == 0
    alone = json.loads(capsys.readouterr().out)
    assert (both["channels"], both["places"]) == (alone["channels"], alone["places"])
    why = (
        "films do not settle at 120 steps a cycle: the motion: grows; more steps; nor at 240 or 480 steps"
    )
    assert [speed["reason"] for speed in both["speeds"]] == [why, None]
    assert (both["speeds"][0]["eccentricity"], both["speeds"][0]["departure"]) == (None, None)
    assert both["speeds"][1]["error"] == alone["speeds"][0]["error"] > 0
    assert any("belongs to 1500 rpm, whose films do not settle" in note for note in both["notes"])


@pytest.mark.slow
def test_films_about_the_centre_may_give_no_motion(single, capsys, monkeypatch):
    monkeypatch.setattr(sweep, "_solve_periodic", grows)
    assert run(["crankshaft", single, "--rpm", "1500", *QUICK, "--format", "json"]) == 1
    (speed,) = json.loads(capsys.readouterr().out)["speeds"]
    assert speed["reason"] == "no steady state: the motion: grows; more steps"


@pytest.mark.slow
def test_a_journal_beyond_its_clearance_has_not_settled(single, monkeypatch):
    """However near the orbits lie to those of their films: no journal leaves its shell."""
    real = sweep._solve_about_orbits

    def beyond(made, rpm, orbits, **options):
        outcome = real(made, rpm, orbits, **options)
        return replace(outcome, departure=0.01, orbits=2 * outcome.orbits)

    monkeypatch.setattr(sweep, "_solve_about_orbits", beyond)
    made = configure_run(read_running_engine(single), webs="nominal", steps=120, iterations=1)
    outcome = sweep.run_speed(made, 2200.0)
    assert re.search(r"journals at 1\.\d\d of it", outcome.reason)


@pytest.mark.slow
def test_the_step_error_is_what_halved_steps_change(single):
    """The films kept; and it falls with the steps."""
    engine = read_running_engine(single)
    errors = []
    for steps in (90, 180):
        made, fine = (
            configure_run(engine, webs="nominal", about="centre", steps=n) for n in (steps, 2 * steps)
        )
        outcome, finer = sweep.run_speed(made, 2200.0), sweep.run_speed(fine, 2200.0)
        here, there = (
            outcome.values[:, :3],
            finer.values[::2, :3],
        )  # the pin's stresses are not the largest
        stresses = [i for i, unit in enumerate(outcome.units) if unit == "Pa"]
        largest = np.abs(outcome.values[:, stresses]).max()
        assert outcome.error >= np.abs(there - here).max() / largest > 0
        assert outcome.error < 0.05
        errors.append(outcome.error)
    assert errors[1] < errors[0] / 2


@pytest.mark.slow
def test_steps_too_coarse_are_said_and_are_exit_1(single, capsys, monkeypatch):
    monkeypatch.setattr(import_module("symbalance.crankshaft.reports.summary"), "COARSE", 1e-9)
    assert run(["crankshaft", single, "--rpm", "1500", "--webs", "nominal", "--steps", "120"]) == 1
    assert re.search(r"1500 rpm: halved steps change a stress by .* %", capsys.readouterr().out)


@pytest.mark.slow
def test_files_of_earlier_runs_are_said_to_be_no_part(single, tmp_path, capsys):
    out = tmp_path / "out"
    options = ["crankshaft", single, *QUICK, "--no-plots", "-o", str(out)]
    run([*options, "--rpm", "1000"])
    assert "earlier" not in capsys.readouterr().err
    run([*options, "--rpm", "1500"])
    said = "of earlier runs, no part of this report: curves-1000rpm.csv, loads-1000rpm.csv"
    assert said in capsys.readouterr().err


@pytest.mark.slow
def test_finished_speeds_are_as_readable_as_their_folder(single, tmp_path):
    out = tmp_path / "out"
    run(["crankshaft", single, "--rpm", "1500", *QUICK, "--no-plots", "-o", str(out)])
    folder, kept = out / "speeds", out / "speeds" / "1500rpm.result"
    assert kept.stat().st_mode & 0o666 == folder.stat().st_mode & 0o666


@pytest.mark.slow
def test_a_curve_of_a_speed_that_did_not_run_is_said_to_wait(tmp_path, capsys):
    curve = "".join(f"{a},{a / 10}\n" for a in range(0, 720, 60))
    (tmp_path / "gauge.csv").write_text(curve, encoding="utf-8")
    table = '[running.overlay]\nfile = "gauge.csv"\nchannel = "pin 1 bending"\nrpm = 1800'
    path = str(written(tmp_path, sheet(SINGLE, table)))
    run(["crankshaft", path, "--rpm", "1500", *QUICK])
    assert "belongs to 1800 rpm, which is no speed of this run" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("layout", "changed", "said"),
    [
        (
            SINGLE,
            "young = 206\nno_bearing = [1, 2]",
            "crankshaft.no_bearing: leaves the crank no bearing",
        ),
        (
            "[layout]\nbanks = [-30, 30]\ncylinders = [[1], [2]]\nfiring_order = [1, 2]\n",
            "young = 206",
            "cylinders 1 and 2 lie between the same journals on throws of -30 and 30 degrees",
        ),
    ],
)
def test_what_a_crank_lacks_is_said_where_it_lacks_it(layout, changed, said, tmp_path, capsys):
    path = str(written(tmp_path, sheet(layout, young=changed)))
    assert run(["crankshaft", path, *QUICK]) == 2
    assert said in capsys.readouterr().err
