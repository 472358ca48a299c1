"""The record: what it keeps is what was said, and every planted difference is listed under its kind."""

import json
import re
import shutil
from contextlib import suppress
from pathlib import Path

import pytest

import symbalance as sb
from symbalance.cli import run
from tests.record.__main__ import main
from tests.record.cases import CHOSEN, COMMANDS, EMITTED, Case, all_cases
from tests.record.comparing import Allowance, compare, read_allowances, report
from tests.record.differences import KINDS, of_files
from tests.record.engines import OWN, Engine, engine_files, preset_names
from tests.record.exact_strings import relative_difference, values
from tests.record.inputs import gather
from tests.record.recording import (
    ROOT,
    RecordError,
    Settings,
    crew,
    git,
    in_lines,
    program_tree,
    record,
    write,
)

ONE = Settings(jobs=1)
SELECTED = (
    "balance/v8-90.*",
    "balance/own/offset-four.json",
    "balance-file/*",
    "check/hand/vtwin.md.txt",
    "emit-all/inline-4/*",
    "refusals/unknown-preset.txt",
)


@pytest.fixture(scope="module")
def written(tmp_path_factory) -> Path:
    """Return the record of a few cases of the tree as it is."""
    folder = tmp_path_factory.mktemp("record") / "old"
    write(folder, None, Settings(jobs=1, only=SELECTED))
    return folder


@pytest.fixture
def planted(written, tmp_path) -> Path:
    """Return a copy of that record, to plant differences in."""
    return shutil.copytree(written, tmp_path / "new")


def replace_in(path: Path, old: str, new: str) -> None:
    text = path.read_text(encoding="utf-8")
    assert old in text
    path.write_text(text.replace(old, new, 1), encoding="utf-8")


def kinds(old: Path, new: Path) -> set[tuple[str, str]]:
    return {(one.kind, one.case) for one in compare(old, new).differences}


# What is recorded -------------------------------------------------------------------------------------


@pytest.mark.slow
def test_what_is_kept_is_what_the_program_says(written, capsys):
    assert run(["balance", "v8-90", "--format", "json"]) == 0
    assert capsys.readouterr().out == (written / "balance/v8-90.json").read_text(encoding="utf-8")
    manifest = json.loads((written / "manifest.json").read_text(encoding="utf-8"))
    cases = manifest["cases"]
    assert cases["balance/v8-90.json"] == {
        "argv": ["balance", "v8-90", "--format", "json"],
        "exit": 0,
        "files": ["balance/v8-90.json"],
    }
    assert cases["refusals/unknown-preset.txt"]["exit"] == 2
    assert cases["balance-file/v8-90.txt"]["files"] == ["balance-file/v8-90.txt.files/v8.txt"]
    assert manifest["program"]["version"] == f"symbalance {sb.__version__}"
    files = {p.relative_to(written).as_posix() for p in written.rglob("*") if p.is_file()}
    assert files == {"manifest.json", *(f for case in cases.values() for f in case["files"])}


@pytest.mark.slow
def test_two_records_of_one_tree_are_the_same_bytes_whatever_the_order_of_sets(written, tmp_path, capsys):
    write(tmp_path / "new", None, Settings(jobs=1, hash_seed=7, only=SELECTED))
    manifest = (tmp_path / "new/manifest.json").read_text(encoding="utf-8")
    same = manifest.replace('"hash_seed": 7', '"hash_seed": 0')
    assert same == (written / "manifest.json").read_text(encoding="utf-8")
    for path in written.rglob("*"):
        if path.is_file() and path.name != "manifest.json":
            assert path.read_bytes() == (tmp_path / "new" / path.relative_to(written)).read_bytes(), path
    assert main(["compare", str(written), str(tmp_path / "new")]) == 0
    assert "\n0 differences in 0 cases" in capsys.readouterr().out


@pytest.mark.slow
@pytest.mark.skipif(not (ROOT / ".git").exists(), reason="a commit's record needs git")
def test_the_tree_of_a_commit_is_that_commit_s_and_is_taken_away():
    with program_tree("HEAD") as tree:
        assert tree != ROOT
        there = (tree / "symbalance/__init__.py").read_bytes()
        assert there == git("show", "HEAD:symbalance/__init__.py")
    assert not tree.exists()
    with pytest.raises(RecordError, match="no-such-commit"), program_tree("no-such-commit"):
        pass


# How cases are run ------------------------------------------------------------------------------------

PROGRAM = """
import os, sys, time
from pathlib import Path
state = []
def main():
    match sys.argv[1]:
        case "fail": sys.exit(3)
        case "text": sys.exit("no code but a text")
        case "crash": raise ValueError("planted")
        case "endless":
            print("begun", flush=True)
            while True: pass
        case "killed": os.kill(os.getpid(), 9)
        case "paths": print(__file__, Path.cwd(), sys.prefix, sep="\\n")
        case "files": Path("out").mkdir(); Path("out/a.txt").write_text("a"); Path("empty").write_text("")
        case "state": state.append(1); print(len(state))
        case "write-inputs": Path("inputs/engines/own/one-offset.toml").write_text("")
        case "engines": print("one  an engine" if len(sys.argv) == 2 else "[layout]\\nfiring_order = [1]")
        case "--version": print("fake 1")
        case _: sys.stdout.write("\\udcff") if sys.argv[1] == "bytes" else print("Zündung")
"""


@pytest.fixture
def fake(tmp_path) -> Path:
    """Return a tree with a program of our own under the program's name."""
    package = tmp_path / "tree" / "symbalance"
    package.mkdir(parents=True)
    (package / "__init__.py").write_text("")
    (package / "__main__.py").write_text(PROGRAM)
    return tmp_path / "tree"


@pytest.mark.slow
def test_every_way_to_end_is_told_apart(fake, tmp_path):
    words = ["fail", "text", "crash", "endless", "killed", "paths", "files", "state", "other"]
    (tmp_path / "scratch/inputs").mkdir(parents=True)
    with crew(fake, tmp_path / "scratch", Settings(jobs=1, limit=1)) as workers:
        said = workers.run_all([Case(word, (word,)) for word in words])
        again = workers.run_all([Case("state", ("state",))])["state"]
    assert [said[word].exit for word in words] == [3, 1, 1, "time limit", "signal 9", 0, 0, 0, 0]
    assert said["text"].files == {"text.stderr": b"no code but a text\n"}
    assert b"ValueError: planted" in said["crash"].files["crash.stderr"]
    assert said["endless"].files == {}
    shown = said["paths"].files["paths"].decode().splitlines()
    assert shown[0] == "<program>/symbalance/__main__.py"
    assert shown[1].startswith("<here>")
    assert shown[2] == "<python>"
    assert said["files"].files == {"files.files/out/a.txt": b"a", "files.files/empty": b""}
    assert said["state"].files["state"] == again.files["state"] == b"1\n", "a case leaves nothing behind"
    assert said["other"].files == {"other": "Zündung\n".encode()}
    assert not list((tmp_path / "scratch").glob("case-*"))


def test_a_program_from_elsewhere_is_refused(tmp_path):
    # The installed program would be imported, and recorded under a commit it is not of.
    (tmp_path / "scratch").mkdir()
    (tmp_path / "tree").mkdir()
    with (
        pytest.raises(RecordError, match="not from there"),
        crew(tmp_path / "tree", tmp_path / "scratch", ONE),
    ):
        pass


def test_a_case_that_writes_into_its_inputs_is_refused(fake, monkeypatch):
    monkeypatch.setattr("tests.record.recording.all_cases", lambda *_: [Case("bad", ("write-inputs",))])
    with pytest.raises(RecordError, match="inputs"):
        record(fake, ONE)


@pytest.mark.slow
def test_a_program_that_is_changed_while_it_runs_is_refused(fake, monkeypatch):
    def changing(*_: object) -> list[Case]:
        (fake / "symbalance/late.py").write_text("")
        return [Case("one", ("other",))]

    monkeypatch.setattr("tests.record.recording.all_cases", changing)
    with pytest.raises(RecordError, match="changed while it ran"):
        record(fake, ONE)


@pytest.mark.slow
def test_a_pattern_of_no_case_and_a_program_of_no_preset_are_refused(fake):
    with pytest.raises(RecordError, match="no case"):
        record(fake, Settings(jobs=1, only=("balace/*",)))
    replace_in(fake / "symbalance/__main__.py", "one  an engine", "")
    with pytest.raises(RecordError, match="lists no preset"):
        record(fake, ONE)


def test_a_folder_that_is_no_record_is_left_alone(tmp_path):
    folder = tmp_path / "work"
    folder.mkdir()
    (folder / "thesis.tex").write_text("everything")
    few = ("--jobs", "1", "--only", "help/version.txt")
    assert main(["write", str(folder), *few]) == 2
    assert [p.name for p in folder.iterdir()] == ["thesis.tex"]
    (folder / "manifest.json").write_text('{"record": 0}')
    assert main(["write", str(folder), *few]) == 2
    assert main(["write", str(folder / "thesis.tex"), *few]) == 2
    assert (folder / "thesis.tex").read_text() == "everything"


@pytest.mark.slow
def test_a_record_is_replaced_whole_or_not_at_all(fake, tmp_path, monkeypatch):
    monkeypatch.setattr("tests.record.recording.program_tree", lambda _: _given(fake))
    folder = tmp_path / "record"
    write(folder, None, Settings(jobs=1, only=("help/*",)))
    (folder / "help/left-behind.txt").write_text("stale")
    with monkeypatch.context() as failing:
        failing.setattr("tests.record.recording.in_lines", lambda _: 1 / 0)
        with pytest.raises(ZeroDivisionError):
            write(folder, None, Settings(jobs=1, only=("help/b*",)))
    assert (folder / "help/left-behind.txt").exists()
    write(folder, None, Settings(jobs=1, only=("help/b*",)))
    there = {p.name for p in (folder / "help").iterdir()}
    assert there == {"balance.txt", "bench.txt", "bounds.txt"}
    assert sorted(p.name for p in tmp_path.iterdir()) == ["record", "tree"]
    program = json.loads((folder / "manifest.json").read_text(encoding="utf-8"))["program"]
    assert program["version"] == "fake 1", "the program of that tree has run, not the one installed"


class _given:  # noqa: N801 - stands for a function
    def __init__(self, tree: Path) -> None:
        self.tree = tree

    def __enter__(self) -> Path:
        return self.tree

    def __exit__(self, *_: object) -> None:
        pass


# The cases --------------------------------------------------------------------------------------------


@pytest.mark.slow
def test_the_cases_cover_every_command_engine_and_page(capsys):
    def said(*arguments: str) -> str:
        with suppress(SystemExit):  # of --help
            assert run(arguments) == 0
        return capsys.readouterr().out

    inputs = gather(ROOT)
    presets = [
        Engine(name, name, said("engines", "--show", name)) for name in preset_names(said("engines"))
    ]
    files = [Engine(key, f"inputs/engines/{key}.toml", text) for key, text in engine_files(ROOT).items()]
    assert {*CHOSEN, *EMITTED} <= {engine.key for engine in (*presets, *files)}
    cases = all_cases([*presets, *files], inputs)
    names = {case.name for case in cases}
    for engine in (*presets, *files):
        for command in ("balance", "torque", "design", "sensitivities", "tolerances"):
            assert {f"{command}/{engine.key}.{s}" for s in ("json", "txt", "tex")} <= names
        assert f"emit-all/{engine.key}/numpy.py" in names
        assert f"assign/{engine.key}.json" in names
    for page in ("hand/vtwin.md", "hand/hostile/inject.txt", "checked/000_6d19e3a8fb7bcb72.txt"):
        assert {f"check/{page}.{suffix}" for suffix in ("json", "txt", "tex")} <= names
    assert set(re.findall(r"^ {4}([a-z]+)\b", said("--help"), re.MULTILINE)) == set(COMMANDS)
    assert {case.arguments[0] for case in cases if case.arguments} >= set(COMMANDS)


@pytest.mark.parametrize("path", sorted(OWN.glob("*.toml")), ids=lambda p: p.stem)
def test_the_record_s_own_engines_can_be_read(path):
    assert sb.load(path).cylinders


# Differences ------------------------------------------------------------------------------------------

JSON = (
    '{"order": "6", "cos": "6*sqrt(3)", "value": "0.25", "why": "it holds", "l": [{"line": 1, "x": "1"}]}'
)
TEXT = "Free force of order 2\n  vertical   6√3   cos 2θ − 1\nas computed\n"
SOURCE = '''"""Of the six."""
import numpy as np

SCALE = 0.5  # of the crank


def evaluate(theta, *, mass=1.0):
    """Return it."""
    return SCALE * np.cos(theta) * mass


def on_grid(points):
    return evaluate(np.arange(points) / points)
'''
C = "/* of the six */\nconst double SCALE = 0.5; // of the crank\n"
PLANTED = [
    ("a.json", JSON, "6*sqrt(3)", "sqrt(108)", "json: spelling"),
    ("a.json", JSON, "6*sqrt(3)", "-6*sqrt(3)", "json: sign"),
    ("a.json", JSON, "6*sqrt(3)", "6*sqrt(5)", "json: number"),
    ("a.json", JSON, "0.25", "0.250", "json: spelling"),
    ("a.json", JSON, "0.25", "0.25000000000000000000000000001", "json: digits"),
    ("a.json", JSON, "it holds", "it fails", "json: words"),
    ("a.json", JSON, '"it holds"', "null", "json: type"),
    ("a.json", JSON, '"order": "6", ', "", "json: key removed"),
    ("a.json", JSON, '"order"', '"new": 1, "order"', "json: key added"),
    ("a.json", JSON, '{"line": 1, "x": "1"}', "", "json: key removed"),
    ("a.json", JSON, '"line": 1', '"line": 2', "json: number"),
    ("a.json", JSON, '"order": "6", ', '"order":   "6", ', "json: layout"),
    ("a.json", JSON, "{", "", "json: formulas"),
    ("a.txt", TEXT, "order 2", "order 3", "text: numbers"),
    ("a.txt", TEXT, "− 1", "+ 1", "text: signs"),
    ("a.txt", TEXT, "cos 2θ − 1", "cos 2θ − 1", None),
    ("a.txt", TEXT, "computed", "calculated", "text: words"),
    ("a.txt", TEXT, "   6√3", " 6√3", "text: whitespace"),
    ("a.txt", TEXT, "order 2\n", "order\n2 ", "text: whitespace"),
    ("a.txt", TEXT, "cos", "sin", "text: formulas"),
    ("a.txt", TEXT, "6√3", "6√3²", "text: formulas"),
    ("a.txt", TEXT, "vertical   6", "lateral   7", "text: mixed"),
    ("a.txt", TEXT, "as computed\n", "", "text: lines removed"),
    ("a.txt", TEXT, "as computed\n", "as computed\nexactly so\n", "text: lines added"),
    ("a.tex", TEXT, "order 2", "order 3", "latex: numbers"),
    ("a.toml", TEXT, "order 2", "order 3", "toml: numbers"),
    ("a.txt.stderr", TEXT, "order 2", "order 3", "stderr: numbers"),
    ("a.py", SOURCE, "Of the six", "Of the four", "source: comments"),
    ("a.py", SOURCE, "of the crank", "of the rod", "source: comments"),
    ("a.py", SOURCE, "Return it", "Return them", "source: comments"),
    ("a.py", SOURCE, "SCALE * np.cos(theta)", "np.cos(theta) * SCALE", "source: code"),
    ("a.py", SOURCE, "0.5", "0.6", "source: evaluates differently"),
    ("a.py", SOURCE, "0.5", "-0.5", "source: evaluates differently"),
    ("a.py", SOURCE, " * mass", "", "source: evaluates differently"),
    ("a.py", SOURCE, "/ points", "/ (points - 1)", "source: evaluates differently"),
    ("a.py", SOURCE, "def evaluate", "def _evaluate", "source: evaluates differently"),
    ("a.py", SOURCE, "np.cos", "np.cosine", "source: evaluates differently"),
    ("a.c", C, "the six", "the four", "source: comments"),
    ("a.c", C, "of the crank", "of the rod", "source: comments"),
    ("a.c", C, "0.5", "0.6", "source: code"),
]


@pytest.mark.spread(2)
@pytest.mark.parametrize(
    ("name", "text", "old", "new", "kind"), PLANTED, ids=[f"{row[4]}-{row[3][:12]!r}" for row in PLANTED]
)
def test_a_planted_difference_is_of_its_kind(name, text, old, new, kind):
    changed = text.replace(old, new, 1)
    found = list(of_files(name, name, text.encode(), changed.encode()))
    if kind == "json: layout":
        assert json.loads(text) == json.loads(changed)
    if name == "a.json" and kind == "json: key removed" and "line" in old:
        assert [d.place for d in found] == ["$.l[0]"]
    if old == "{":  # no JSON any more: compared as a text
        assert {d.kind for d in found} == {kind}
        return
    assert [d.kind for d in found] == ([kind] if kind else [])


def test_every_kind_is_planted_somewhere():
    tested = {kind.partition(": ")[2] for *_, kind in PLANTED if kind}
    in_folders = {
        "case missing", "case added", "arguments", "exit code", "file missing", "file added", "input"
    }  # fmt: skip
    assert tested | in_folders == set(KINDS)


def test_an_item_in_the_middle_of_a_list_is_named_by_its_order():
    old = {"orders": [{"order": "1", "cos": "1"}, {"order": "2", "cos": "2"}, {"order": "4", "cos": "4"}]}
    new = {"orders": [old["orders"][0], {"order": "4", "cos": "5"}]}
    found = list(of_files("a.json", "a.json", *(json.dumps(side).encode() for side in (old, new))))
    assert [(d.kind, d.place) for d in found] == [
        ("json: key removed", "$.orders[order 2]"),
        ("json: number", "$.orders[order 4].cos"),
    ]
    assert found[1].note == "relative 0.2"


@pytest.mark.parametrize(
    "text",
    [
        "__import__('os').system('true')",
        "().__class__",
        "9**9**9**9",
        "exp(10**9)",
        "1/0",
        "(" * 5000,
        "in-line 4",
        "cos",
        "10**(10**6)",
        "lam.real",
        "cos(1, 2, 3)",
        "True + 1",
    ],
)
def test_what_is_no_number_has_no_value_and_is_not_run(text):
    assert values(text) is None


@pytest.mark.parametrize(
    ("old", "new", "equal"),
    [
        ("sqrt(5 + 2*sqrt(6))", "sqrt(2) + sqrt(3)", True),
        ("sqrt(2)*sqrt(3) - sqrt(6)", "0", True),
        ("9/(128*lam**5) + 1/lam", "(9 + 128*lam**4)/(128*lam**5)", True),
        ("9/(128*lam**5)", "9/(128*lam**4)", False),
        ("atan2(-2*sqrt(2), -sqrt(2))", "-pi + atan(2)", True),
        ("0.333333333333333333333333333333", "1/3", True),
        ("0.33333333333333333333", "1/3", False),
        ("1e-60", "0", True),
    ],
)
def test_equal_numbers_are_equal_however_they_are_written(old, new, equal):
    before, after = values(old), values(new)
    assert before is not None
    assert after is not None
    assert (relative_difference(before, after) == 0) is equal


# Folders ----------------------------------------------------------------------------------------------


@pytest.mark.slow
def test_planted_in_a_record_each_is_listed(written, planted, capsys):
    cases = json.loads((planted / "manifest.json").read_text(encoding="utf-8"))
    replace_in(planted / "balance/v8-90.json", '"sqrt(10)"', '"sqrt(11)"')
    replace_in(planted / "balance/v8-90.txt", "cylinder 1", "piston 1")
    (planted / "balance/v8-90.tex").unlink()
    (planted / "balance/stray.txt").write_text("stale")
    (planted / "emit-all/inline-4/numpy.py").write_text(
        (written / "emit-all/inline-4/numpy.py").read_text(encoding="utf-8").replace("= 1.0", "= 1.5"),
        encoding="utf-8",
    )
    table = cases["cases"]
    table["refusals/unknown-preset.txt"]["exit"] = 0
    table["balance-file/v8-90.txt"]["argv"].append("--order")
    table["balance/new.json"] = table.pop("balance/own/offset-four.json") | {"files": []}
    (planted / "balance/own/offset-four.json").unlink()
    cases["inputs"]["pressure-4.csv"] = "0" * 64
    (planted / "manifest.json").write_text(in_lines(cases), encoding="utf-8")
    found = kinds(written, planted)
    assert found >= {
        ("json: number", "balance/v8-90.json"),
        ("text: words", "balance/v8-90.txt"),
        ("file missing", "balance/v8-90.tex"),
        ("file added", "balance/stray.txt"),
        ("exit code", "refusals/unknown-preset.txt"),
        ("arguments", "balance-file/v8-90.txt"),
        ("case added", "balance/new.json"),
        ("case missing", "balance/own/offset-four.json"),
        ("input", "inputs/pressure-4.csv"),
    }
    assert len(found) == 10
    assert main(["compare", str(written), str(planted)]) == 1
    shown = capsys.readouterr().out
    assert "sqrt(10) → sqrt(11)  (relative 0.047)" in shown
    assert "10 differences in 10 cases" in shown


@pytest.mark.slow
def test_what_is_allowed_is_not_counted_and_what_is_not_used_is_said(written, planted, tmp_path, capsys):
    replace_in(planted / "balance/v8-90.txt", "cylinder 1", "piston 1")
    allow = tmp_path / "allow.toml"
    allow.write_text(
        '[[allowed]]\ncase = "balance/*"\nkind = "text: words"\nreason = "pistons"\n'
        '[[allowed]]\ncase = "torque/*"\nkind = "*: sign"\nreason = "none"\n'
    )
    assert main(["compare", str(written), str(planted), "--allow", str(allow)]) == 0
    shown = capsys.readouterr().out
    assert "1 of text: words in balance/*: pistons" in shown
    assert "NOT USED: *: sign in torque/*" in shown
    replace_in(planted / "balance/v8-90.json", "sqrt(10)", "-sqrt(10)")
    assert main(["compare", str(written), str(planted), "--allow", str(allow)]) == 1


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ('[[allowed]]\ncase = "*"\nkind = "text: words"\n', "reason is missing"),
        ('[[allowed]]\ncase = "*"\nkind = "text: wrods"\nreason = "x"\n', "wrods"),
        ('[[allowed]]\ncase = "*"\nkind = "sign"\nreason = "x"\nwhy = "x"\n', "why"),
        ('[[allow]]\ncase = "*"\n', "nothing else"),
        ("[[allowed\n", "TOML"),
    ],
)
def test_an_unusable_allowance_is_refused(tmp_path, text, said):
    (tmp_path / "allow.toml").write_text(text)
    with pytest.raises(RecordError, match=said):
        read_allowances(tmp_path / "allow.toml")


@pytest.mark.slow
def test_a_place_with_brackets_is_allowed_by_its_name(written, planted):
    replace_in(planted / "balance/v8-90.json", '"sqrt(10)"', '"sqrt(11)"')
    place = "$.orders[order 1].couple.*"
    right = Allowance("balance/v8-90.json", "json: number", "planted", place)
    wrong = Allowance("balance/v8-90.json", "json: number", "planted", "$.orders[order 2].*")
    comparison = compare(written, planted, [wrong, right])
    assert [count for _, count in comparison.allowed] == [0, 1]
    assert not comparison.differences


@pytest.mark.slow
def test_what_is_no_record_is_not_compared(written, tmp_path, capsys):
    assert main(["compare", str(written), str(tmp_path)]) == 2
    assert "no record" in capsys.readouterr().err


@pytest.mark.slow
def test_a_report_shows_no_control_characters(written, planted):
    replace_in(planted / "balance/v8-90.txt", "cylinder 1", "cyl\x1b[31minder 1")
    shown = report(compare(written, planted), everything=True)
    assert "\x1b" not in shown
    assert "cyl\ufffd[31minder" in shown
