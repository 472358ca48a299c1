"""The command line as a user meets it: exit codes, streams, whole files, one-line refusals."""

import json
import os
import stat
import subprocess
import sys
from pathlib import Path

import pytest

from symbalance.cli import run
from tests.different_presets import different_presets

GOOD = """
[layout]
banks = [-30, 30]
cylinders = [[1, 3, 5], [2, 4, 6]]
firing_order = [1, 2, 3, 4, 5, 6]
"""
TWO = """\
[[cylinder]]
number = 1
throw = 0
fires = 0
[[cylinder]]
number = 2
throw = 180
"""


def refused(capsys, *arguments: str) -> str:
    """Run a command that must be refused, and return its one line."""
    code = run(list(arguments))
    out, err = capsys.readouterr()
    assert code == 2
    assert out == ""
    assert err.count("\n") == 1, err
    assert "Traceback" not in err
    return err


def printed(capsys, *arguments: str) -> str:
    """Run a command that must succeed, and return its output."""
    code = run(list(arguments))
    out, err = capsys.readouterr()
    assert (code, err) == (0, "")
    return out


def python(*arguments: str, **options) -> subprocess.CompletedProcess:
    return subprocess.run(
        [sys.executable, *arguments], capture_output=True, encoding="utf-8", check=False, **options
    )


def engine_file(folder: Path, text: str) -> str:
    path = folder / "engine.toml"
    path.write_text(text, encoding="utf-8")
    return str(path)


# What it prints -----------------------------------------------------------------------------------


def test_v12_table_fits_a_terminal_and_holds_one_family(capsys):
    out = printed(capsys, "balance", "v12-60")
    assert max(map(len, out.splitlines())) <= 80
    assert "6√3" in out
    assert "none, to order 12" in out


@pytest.mark.slow
@pytest.mark.parametrize("engine", different_presets()[::3])
def test_tables_fit_a_terminal(capsys, engine):
    out = printed(capsys, "balance", engine, "--order", "40")
    assert max(map(len, out.splitlines())) <= 80


def test_long_exact_forms_fit_a_terminal(capsys, tmp_path):
    path = engine_file(tmp_path, "[layout]\nfiring_order = [1,3,5,7,9,11,13,12,10,8,6,4,2]\n")
    out = printed(capsys, "balance", path, "--power", "40", "--order", "8")
    assert max(map(len, out.splitlines())) <= 80


def test_json_follows_the_interface(capsys):
    data = json.loads(printed(capsys, "balance", "v12-60", "--format", "json"))
    assert data["engine"] == "v12-60"
    assert data["ratio"] == "4"
    assert data["reference_plane"] == "mean of stations"
    first = data["cylinders"][0]
    agreed = {"number": 1, "throw": "-30", "bank": "-30", "station": "5/2", "fires": "0"}
    assert first == agreed | {"top_dead_centre": "0"}
    six, twelve = data["orders"]
    assert (six["order"], twelve["order"]) == ("6", "12")
    assert six["coefficient"]["series"] == "9/(128*lam**5) + 45/(512*lam**7)"
    assert six["coefficient"]["through"] == 7
    assert six["coefficient"]["value"] == "7.4379032794195738811e-5"
    vertical = six["force"]["vertical"]
    assert vertical["cos"] == vertical["amplitude"] == "6*sqrt(3)"
    assert vertical["phase"] == vertical["sin"] == "0"
    assert vertical["decimal"] == ["10.392304845413263761164678049", "0"]
    assert six["force"]["lateral"]["cos"] == "0"
    assert six["force"]["forward"]["cos"] == "3*sqrt(3)"
    assert six["couple"]["vertical"]["decimal"] == ["0", "0"]


def test_ratio_and_power_are_taken(capsys):
    arguments = ("balance", "inline-4", "--order", "2", "--ratio", "147.15/36.65", "--power", "5")
    data = json.loads(printed(capsys, *arguments, "--format", "json"))
    assert data["ratio"] == "2943/733"
    assert data["orders"][0]["coefficient"]["series"] == "1/lam + 1/(4*lam**3) + 15/(128*lam**5)"
    assert data["orders"][0]["coefficient"]["through"] == 5


def test_without_a_ratio_values_are_null(capsys, tmp_path):
    data = json.loads(printed(capsys, "balance", engine_file(tmp_path, GOOD), "--format", "json"))
    assert data["ratio"] is None
    assert {order["coefficient"]["value"] for order in data["orders"]} == {None}
    assert data["engine"] == "engine"


def test_engines_lists_every_preset_with_its_source(capsys):
    from symbalance.engine.catalogue import presets

    out = printed(capsys, "engines", "--full")
    assert max(map(len, out.splitlines())) <= 80
    joined = " ".join(out.split())
    for preset in presets():
        assert preset.name in joined
        assert preset.source.split()[0] in joined


def test_a_shown_preset_is_a_usable_engine_file(capsys, tmp_path):
    text = printed(capsys, "engines", "--show", "v8-90")
    path = engine_file(tmp_path, text)
    assert printed(capsys, "balance", path) == printed(capsys, "balance", "v8-90")


def test_derive_prints_text_and_latex(capsys):
    assert "θ" in printed(capsys, "derive", "--quantity", "displacement", "--convention", "l/s")
    assert r"\begin{document}" in printed(
        capsys, "derive", "--standalone", "--format", "latex", "--order", "4"
    )


@pytest.mark.slow
def test_derive_prints_the_equations_of_a_crankshaft_node(capsys, golden):
    golden("crank-node.txt", printed(capsys, "derive", "--quantity", "crank-node"))
    node = ("derive", "--quantity", "crank-node", "--rotation", "uvw")
    latex = printed(capsys, *node, "--format", "latex", "--standalone")
    assert r"\begin{document}" in latex
    assert "R_{u} R_{v} R_{w}" in latex
    data = json.loads(printed(capsys, *node, "--format", "json"))
    assert data["schema"] == {"result": "crank-node", "version": 1}
    assert data["rotation"] == "uvw"


@pytest.mark.parametrize(
    ("met", "code", "word"), [(True, 0, "met"), (False, 1, "MISSED"), (None, 0, "1.00 s")]
)
def test_a_missed_target_is_an_exit_code(capsys, monkeypatch, met, code, word):
    import symbalance.bench.derive as bench
    from symbalance.bench.timing import Measurement, Report

    found = Report(
        "here", [("title", [Measurement("fine", 1.0), Measurement("x", 1.0, "", None, "1 s", met)])]
    )
    monkeypatch.setattr(bench, "report", lambda quick: found)
    assert run(["bench", "derive"]) == code
    assert word in capsys.readouterr().out


# Refusals -----------------------------------------------------------------------------------------


@pytest.mark.spread(2)
@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ((), ["COMMAND"]),
        (("balanse", "v12-60"), ["balanse"]),
        (("balance",), ["ENGINE"]),
        (("balance", "v1260"), ["v1260", "v12-60"]),
        (("balance", "v12_60"), ["v12_60", "v12-60"]),
        (("balance", "zzz"), ["zzz", "symbalance engines"]),
        (("balance", ""), ["preset"]),
        (("balance", "v12-60", "--order", "0"), ["order = 0", "1 to 1000"]),
        (("balance", "v12-60", "--order", "-3"), ["-3"]),
        (("balance", "v12-60", "--order", "1001"), ["1001", "1000"]),
        (("balance", "v12-60", "--order", "9" * 5000), ["--order", "whole number"]),
        (("balance", "v12-60", "--order", "nan"), ["nan"]),
        (("balance", "v12-60", "--order", "6.5"), ["6.5"]),
        (("balance", "v12-60", "--order", "٣"), ["whole number"]),
        (("balance", "v12-60", "--ratio", "1"), ["ratio = 1", "longer"]),
        (("balance", "v12-60", "--ratio", "0.25"), ["0.25", "longer"]),
        (("balance", "v12-60", "--ratio", "nan"), ["nan"]),
        (("balance", "v12-60", "--ratio", "inf"), ["inf"]),
        (("balance", "v12-60", "--ratio", "1/0"), ["1/0"]),
        (("balance", "v12-60", "--ratio", "__import__('os')"), ["__import__"]),
        (("balance", "v12-60", "--ratio", "9" * 400), ["ratio"]),
        (("balance", "v12-60", "--power", "4"), ["power = 4", "11"]),
        (("balance", "v12-60", "--power", "-1"), ["-1"]),
        (("balance", "v12-60", "--power", "99999999999"), ["power"]),
        (("balance", "v12-60", "--format", "xml"), ["xml", "text"]),
        (("balance", "missing.toml"), ["missing.toml", "cannot be read"]),
        (("balance", "a\0b.toml"), ["cannot be read"]),
        (("derive", "--order", "0"), ["order = 0"]),
        (("derive", "--quantity", "jerk"), ["jerk", "velocity"]),
        (("derive", "--convention", "s/l"), ["s/l", "l/s"]),
        (("engines", "--show", "v12"), ["v12-60"]),
        (("bench", "speed"), ["derive"]),
    ],
)
def test_bad_arguments_are_refused_in_one_line(capsys, arguments, words):
    line = refused(capsys, *arguments)
    assert line.count("symbalance: ") == 1
    for word in words:
        assert word in line


@pytest.mark.spread(2)
@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", ["[layout]", "[[cylinder]]"]),
        ("a = [1,\n2", ["TOML"]),
        ("x y\n", [":1:", "TOML"]),
        ("colour = 3\n" + GOOD, [":1:", "colour", "unknown key"]),
        (GOOD + "stager = [0, 0]\n", [":6:", "stager", "stagger"]),
        (GOOD.replace("4, 5, 6]\n", "4, 5, 5]\n"), [":5:", "repeats 5"]),
        (GOOD.replace("4, 5, 6]\n", "4, 5]\n"), ["6"]),
        (GOOD.replace("4, 5, 6]\n", "4, 5, 6, 7]\n"), ["7"]),
        (GOOD.replace("[-30, 30]", "[-30, 1000000001]"), [":3:", "1000000001", "within"]),
        (GOOD.replace("[-30, 30]", "[-30]"), ["2 lists", "1 bank"]),
        (GOOD.replace("[-30, 30]", "[nan, 30]"), ["NaN"]),
        (GOOD.replace("[-30, 30]", "[17.3333333, 30]"), [":3:", "17.3333333", "52/3"]),
        (GOOD.replace("[-30, 30]", '["import os", 30]'), ["import os"]),
        (GOOD.replace("[-30, 30]", "[1e99999999, 30]"), ["banks"]),
        (GOOD + "firing_intervals = [120,120,120,120,120,119]\n", [":6:", "719", "720"]),
        (GOOD + "firing_intervals = [360, 360]\n", [":6:", "firing_intervals of 2", "must hold 6"]),
        (
            GOOD + "firing_intervals = [840,-120,0,0,0,0]\n",
            [":6:", "firing_intervals[2] = -120", "negative"],
        ),
        (
            GOOD + "firing_intervals = [17.3333333,0,0,0,0,0]\n",
            [":6:", "firing_intervals[1] = 17.3333333", "52/3"],
        ),
        (GOOD + "strokes = 3\n", [":6:", "strokes = 3", "2 or 4"]),
        (GOOD + 'strokes = "4"\n', [":6:", "strokes = '4'", "quotes"]),
        ("name = ''\n" + GOOD, [":1:", "name = ''", "1 to 60"]),
        (
            GOOD.replace("[2, 4, 6]", "[2, 4, 6], []").replace("30]", "30, 0]"),
            [":4:", "cylinders[3] = []", "empty"],
        ),
        (GOOD.replace("[-30, 30]", '["1/9973", "1/9967"]'), [":3:", "of a turn", "four places"]),
        ("[crank_train]\nstroke = 80\nrod = 39\n" + GOOD, [":3:", "39/40", "longer"]),
        ("[crank_train]\nstroke = 0\n" + GOOD, [":2:", "stroke = 0", "positive"]),
        ("[crank_train]\noffset = 3\n" + GOOD, [":2:", "offset"]),
        ("[crank_train]\nrod = 1" + "0" * 400 + "\n" + GOOD, [":2:", "rod"]),
        ("[crank_train]\nrod = 1" + "0" * 5000 + "\n" + GOOD, ["beyond all bounds"]),
        ("[[cylinder]]\nnumber = 1\n", [":1:", "throw"]),
        (TWO.replace("number = 2", "number = 1"), [":6:", "two cylinders"]),
        (
            TWO.replace("180", '"1/9973"') + "[[cylinder]]\nnumber = 3\nthrow = '1/9967'\n",
            [":5:", "of a turn"],
        ),
        (TWO + "fires = 90\n", [":7:", "throw = 180 and fires = 90", "cylinder 1", "fires = 180"]),
        (TWO + "strokes = 4\n", [":8:", "unknown key"]),
        ("strokes = '4'\n" + TWO, [":1:", "strokes = '4'"]),
        ("[[cylinder]]\nnumber = 1\nthrow = 0\nmaster = 1\n", [":4:", "master", "no other cylinder"]),
        ("[[cylinder]]\nnumber = 1\nthrow = 0\nfires = 720\n", [":4:", "fires"]),
        ("[cylinder]\nnumber = 1\nthrow = 0\n", ["[[cylinder]]"]),
        ("layout = 3\n", [":1:", "[layout]"]),
        ("a = " + "[" * 5000, ["beyond all bounds"]),
    ],
)
def test_bad_files_are_refused_with_place_and_remedy(capsys, tmp_path, text, words):
    path = engine_file(tmp_path, text)
    line = refused(capsys, "balance", path)
    for word in ["engine.toml", *words]:
        assert word in line


def test_unreadable_files_are_refused(capsys, tmp_path):
    assert "is a directory" in refused(capsys, "balance", f"{tmp_path}/")
    latin = tmp_path / "latin.toml"
    latin.write_bytes(b"# ok\nname = '\xe9'\n")
    line = refused(capsys, "balance", str(latin))
    assert "latin.toml:2" in line
    assert "UTF-8" in line


# Options that would play no part --------------------------------------------------------------------

GAS = "emit inline-4 --target numpy --outputs torque.gas --compression 10 --bore 80 --order 4"
IDLE = {
    "emit inline-4 --target numpy --compression 10 --bore 80": "--compression: is for the outputs",
    "emit inline-4 --target numpy --outputs torque.inertia --stroke 80": "--stroke: makes newtons",
    f"{GAS} --mass 1": "--mass: makes newtons at a speed only",
    f"{GAS} --rpm 3000 --stroke 80 --mass 1": "--mass: plays no part in the outputs",
    "emit inline-4 --target numpy --outputs piston.velocity --order 2": "--order: plays no part",
    "derive --quantity crank-node --order 4": "--order: plays no part in crank-node",
    "derive --quantity crank-node --convention r/l": "--convention: plays no part in crank-node",
    "derive --rotation uvw": "--rotation: is for --quantity crank-node",
    "check {notes} --declare --format json": "--format: plays no part in --declare",
    "check {notes} --declare --lenient": "--lenient: plays no part in --declare",
    "torque inline-4 --heat 18": "--heat: is for a running engine",
    "torque inline-4 --delta 0.02": "--delta: is for a running engine",
}


@pytest.mark.spread(2)
@pytest.mark.parametrize("command", IDLE)
def test_an_option_that_would_play_no_part_is_refused(command, capsys, tmp_path):
    notes = tmp_path / "notes.md"
    notes.write_text("$$a = b$$", encoding="utf-8")
    assert IDLE[command] in refused(capsys, *command.format(notes=notes).split())


def test_an_empty_option_is_not_the_default(capsys):
    running = ["--compression", "10", "--bore", "80", "--stroke", "80", "--mass", "1"]
    assert "rpm" in refused(capsys, "torque", "inline-4", *running, "--rpm", "")
    assert "--order" in refused(capsys, "derive", "--order", "")


def test_letters_declared_apart_are_not_asked_for_again(capsys, tmp_path):
    notes, symbols = tmp_path / "notes.md", tmp_path / "others.toml"
    notes.write_text("$$F = m a$$", encoding="utf-8")
    symbols.write_text('[symbols]\nm = "reciprocating mass"\n', encoding="utf-8")
    drafted = printed(capsys, "check", str(notes), "--declare", "--symbols", str(symbols))
    assert '"a" = ""' in drafted
    assert '"m" = ""' not in drafted


# Files, pipes, processes --------------------------------------------------------------------------


def test_output_appears_whole_or_not_at_all(capsys, tmp_path):
    target = tmp_path / "table.txt"
    target.write_text("before")
    refused(capsys, "balance", "v12-60", "--power", "1", "-o", str(target))
    assert target.read_text() == "before"
    assert printed(capsys, "balance", "v12-60", "-o", str(target)) == ""
    assert target.read_text(encoding="utf-8") == printed(capsys, "balance", "v12-60")
    assert os.listdir(tmp_path) == ["table.txt"]


def test_unwritable_output_is_refused(capsys, tmp_path):
    assert "cannot be written" in refused(capsys, "balance", "v12-60", "-o", str(tmp_path))
    missing = str(tmp_path / "no" / "file")
    assert "cannot be written" in refused(capsys, "balance", "v12-60", "-o", missing)


def test_a_device_is_written_to_and_not_replaced(capsys):
    assert printed(capsys, "balance", "v12-60", "-o", os.devnull) == ""
    assert stat.S_ISCHR(os.stat(os.devnull).st_mode)


def test_a_link_stays_a_link(capsys, tmp_path):
    target, link = tmp_path / "target", tmp_path / "link"
    target.write_text("")
    link.symlink_to(target)
    printed(capsys, "balance", "v12-60", "-o", str(link))
    assert link.is_symlink()
    assert target.read_text(encoding="utf-8")


@pytest.mark.slow
def test_a_closed_pipe_ends_silently():
    command = f"{sys.executable} -m symbalance balance inline-4 --order 900 | head -1"
    done = subprocess.run(["bash", "-c", command], capture_output=True, encoding="utf-8", check=False)
    assert done.stderr == ""
    assert done.stdout.count("\n") == 1


def test_help_imports_no_sympy():
    code = "import sys, symbalance.cli.parser as p; p.build_parser(); print('sympy' in sys.modules)"
    assert python("-c", code).stdout == "False\n"


def test_a_balance_of_like_cylinders_imports_neither_sympy_nor_numpy(tmp_path):
    """Both take longer to load than every balance here to compute: nothing of them may be needed."""
    code = (
        "import sys; from symbalance.cli import run;"
        f"codes = [run(['balance', name, '--format', form, '-o', {str(tmp_path / 'out')!r}])"
        " for name in ('v12-60', 'inline-5', 'v8-90') for form in ('text', 'json')];"
        "print(codes, sorted({'sympy', 'numpy'} & set(sys.modules)))"
    )
    assert python("-c", code).stdout == "[0, 0, 0, 0, 0, 0] []\n"


@pytest.mark.slow
def test_no_preset_of_like_cylinders_needs_sympy():
    code = (
        "import sys, symbalance as sb\n"
        "for preset in sb.presets():\n"
        "    result = sb.balance(sb.load(preset.name), 30)\n"
        "    if result.kinematics is not None and not result.engine.balancers:\n"
        "        texts = [write(result) for write in (sb.to_text, sb.to_json, sb.to_latex, sb.to_html)]\n"
        "        print(preset.name, all(texts), {'sympy', 'numpy'} & set(sys.modules))\n"
    )
    lines = python("-c", code).stdout.splitlines()
    assert len(lines) > 20
    assert [line for line in lines if not line.endswith("True set()")] == []


def test_importing_the_package_imports_nothing_heavy():
    code = "import sys, symbalance; print(sorted({'sympy', 'numpy', 'mpmath'} & set(sys.modules)))"
    assert python("-c", code).stdout == "[]\n"


@pytest.mark.slow
def test_an_ascii_terminal_gets_a_table_too():
    done = python(
        "-m", "symbalance", "balance", "v12-60", env={**os.environ, "PYTHONIOENCODING": "ascii"}
    )
    assert done.returncode == 0
    assert "6*sqrt(3)" in done.stdout


def test_version():
    assert python("-m", "symbalance", "--version").stdout.startswith("symbalance ")
