"""No command may replace a file it reads, by whatever name, or write two results to one file."""

import os
from pathlib import Path

import pytest

from symbalance.cli import named_files, run
from tests.cranks import sheet

ENGINE = """
[crank_train]
stroke = 80
rod = 140
pitch = 90
reciprocating_mass = 0.5
[layout]
banks = [0]
cylinders = [[1, 2, 3, 4]]
firing_order = [1, 3, 4, 2]
"""
NOTES = "$$\\sin^2 x = \\frac{1 - \\cos 2x}{2}$$\n"
SIDECAR = '[symbols]\nx = "angle"\n'
BOUND = SIDECAR + '[[bind]]\nline = 1\nquantity = "force.vertical"\nengine = "e.toml"\norder = 2\n'
PARTS = "name,piston,rod_reciprocating,rod_rotating\n" + "".join(
    f"{n},0.5,0.2,{0.3 + n / 1000}\n" for n in range(4)
)
PRESSURE = "".join(f"{angle},{1 + angle % 7}\n" for angle in range(0, 720, 10))

COMMANDS = {
    "balance": ("balance e.toml -o", "e.toml"),
    "torque": ("torque e.toml -o", "e.toml"),
    "torque, pressure": ("torque e.toml --pressure p.csv --bore 80 --rpm 3000 -o", "p.csv"),
    "sensitivities": ("sensitivities e.toml -o", "e.toml"),
    "tolerances": ("tolerances e.toml --mass 0.01 -o", "e.toml"),
    "assign": ("assign e.toml --parts parts.csv -o", "e.toml"),
    "assign, parts": ("assign e.toml --parts parts.csv -o", "parts.csv"),
    "design": ("design e.toml -o", "e.toml"),
    "design, write": ("design e.toml --write", "e.toml"),
    "design, picture": ("design e.toml --picture", "e.toml"),
    "emit": ("emit e.toml --target numpy -o", "e.toml"),
    "check": ("check notes.md -o", "notes.md"),
    "check, latex": ("check notes.md --format latex -o", "notes.md"),
    "check, declare": ("check notes.md --declare -o", "notes.md"),
    "check, certificates": ("check notes.md --certificates", "notes.md"),
    "check, sidecar beside": ("check notes.md -o", "notes.symbols.toml"),
    "check, declared anew": ("check notes.md --declare -o", "notes.symbols.toml"),
    "check, sidecar given": ("check notes.md --symbols other.toml -o", "other.toml"),
    "check, engine bound": ("check notes.md --symbols other.toml -o", "e.toml"),
    "check, engine bound in the document": ("check headed.md -o", "e.toml"),
}


@pytest.fixture
def folder(tmp_path, monkeypatch):
    files = {"e.toml": ENGINE, "notes.md": NOTES, "notes.symbols.toml": SIDECAR, "other.toml": BOUND}
    files |= {"parts.csv": PARTS, "p.csv": PRESSURE, "headed.md": f"<!-- {BOUND}-->\n{NOTES}"}
    for name, text in files.items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def contents(folder: Path) -> dict[str, bytes]:
    return {p.name: p.read_bytes() for p in folder.iterdir() if p.is_file()}


def refused(capsys, command: str, *named: str) -> str:
    assert run([*command.split(), *named]) == 2
    out, err = capsys.readouterr()
    assert (out, err.count("\n")) == ("", 1)
    return err


@pytest.mark.parametrize("case", COMMANDS)
def test_no_output_replaces_what_is_read(case, folder, capsys):
    command, name = COMMANDS[case]
    before = contents(folder)
    assert f"{name}: is a file that is read" in refused(capsys, command, name)
    assert contents(folder) == before


@pytest.mark.parametrize("spelling", ["relative", "absolute", "symbolic link", "hard link"])
def test_other_names_of_the_file_are_no_way_round(spelling, folder, capsys):
    (folder / "sub").mkdir()
    other = "sub/../notes.md"
    if spelling == "absolute":
        other = str(folder / "notes.md")
    elif spelling == "symbolic link":
        other = "linked.tex"
        os.symlink("notes.md", other)
    elif spelling == "hard link":
        other = "linked.tex"
        os.link("notes.md", other)
    assert "is read, and would be replaced" in refused(capsys, "check notes.md -o", other)
    assert Path("notes.md").read_text(encoding="utf-8") == NOTES


def test_the_read_file_may_be_the_one_that_is_linked(folder, capsys):
    os.symlink("notes.md", "mine.md")
    assert "is mine.md, which is read" in refused(capsys, "check mine.md -o notes.md")


@pytest.mark.parametrize("output", ["e.c", "e.h"])
def test_neither_file_of_a_pair_replaces_what_is_read(output, folder, capsys):
    (folder / output).write_text(PRESSURE, encoding="utf-8")
    command = f"emit e.toml --target c --outputs torque.gas --bore 80 --pressure {output} -o e.c"
    assert f"{output}: is a file that is read" in refused(capsys, command)
    assert (folder / output).read_text(encoding="utf-8") == PRESSURE


def test_a_folder_of_results_holds_nothing_that_is_read(folder, capsys):
    (folder / "out").mkdir()
    path = folder / "out" / "engine.toml"
    path.write_text(sheet(pressure='pressure = "loads-1000rpm.csv"'), encoding="utf-8")
    (folder / "out" / "loads-1000rpm.csv").write_text(PRESSURE, encoding="utf-8")
    err = refused(capsys, "crankshaft out/engine.toml -o out")
    assert "loads-1000rpm.csv: is a file that is read" in err
    assert sorted(os.listdir("out")) == ["engine.toml", "loads-1000rpm.csv"]


@pytest.mark.parametrize("second", ["a.toml", "./a.toml", "A.toml", "linked.toml"])
def test_one_name_is_not_taken_for_two_results(second, folder, capsys):
    (folder / "linked.toml").symlink_to("a.toml")
    before = contents(folder)
    assert "by --output too" in refused(capsys, f"design e.toml -o a.toml --write {second}")
    assert contents(folder) == before


def test_nothing_is_done_before_the_refusal(folder, capsys, monkeypatch):
    monkeypatch.setattr("symbalance.notes.checking.check", lambda *_: pytest.fail("checked"))
    refused(capsys, "check notes.md -o notes.md")


def test_a_file_called_like_a_preset_is_a_result_like_any_other(folder, capsys):
    for _ in range(2):
        assert run(["balance", "inline-4", "-o", "inline-4"]) == 0
    assert "inline-4" in (folder / "inline-4").read_text(encoding="utf-8")


def test_devices_may_be_read_and_written(folder):
    assert run(["balance", "e.toml", "-o", os.devnull]) == 0
    assert run(["check", os.devnull, "-o", os.devnull]) != 2


def test_every_option_that_takes_a_file_is_known():
    """An option with FILE, NOTES or ENGINE for its value is among those read or those written."""
    from symbalance.cli.parser import build_parser

    (commands,) = (a for a in build_parser()._actions if hasattr(a, "choices") and a.choices)
    known = {*named_files.READ, *named_files.WRITTEN, "engines"}
    for parser in commands.choices.values():
        files = {
            a.dest for a in parser._actions if a.metavar in ("FILE", "NOTES", "ENGINE", "OUT", "NAME")
        }
        assert files - {"show"} <= known


# Pipes, empty names, the sidecar that is not read -----------------------------------------------------


PIPED = [
    ("e.toml", "balance {}"),
    ("notes.md", "check {} --symbols notes.symbols.toml"),
    ("notes.symbols.toml", "check notes.md --symbols {}"),
    ("p.csv", "torque e.toml --pressure {} --bore 80 --rpm 3000"),
    ("parts.csv", "assign e.toml --parts {}"),
]


@pytest.mark.parametrize(("name", "command"), PIPED)
def test_standard_input_is_read_once_and_whole(name, command, folder, capsys, monkeypatch):
    assert run(command.format(name).split()) == 0
    printed = capsys.readouterr().out.splitlines()[1:]  # the first may have the file's name
    for output in ([], ["-o", "out.txt"]):
        with open(name, encoding="utf-8") as stream:
            monkeypatch.setattr("sys.stdin", stream)
            assert run([*command.format("-").split(), *output]) == 0
    assert capsys.readouterr().out.splitlines()[1:] == printed
    assert (folder / "out.txt").read_text(encoding="utf-8").splitlines()[1:] == printed


@pytest.mark.parametrize(
    "command",
    [
        "crankshaft crank.toml --rpm 1000 -o",
        "balance e.toml -o",
        "design e.toml --write",
        "design e.toml --picture",
        "check notes.md --symbols",
        "assign e.toml --parts",
        "torque e.toml --bore 80 --pressure",
        "bench accuracy -o",
        "check",
        "balance",
    ],
)
def test_an_empty_name_is_refused_before_anything_is_done(command, folder, capsys):
    (folder / "crank.toml").write_text(sheet(), encoding="utf-8")
    before = contents(folder)
    assert "'': is an empty name; name a file" in refused(capsys, command, "")
    assert contents(folder) == before


def test_a_folder_of_results_is_not_the_terminal(folder, capsys):
    (folder / "crank.toml").write_text(sheet(), encoding="utf-8")
    assert "--output -: stands for the terminal" in refused(capsys, "crankshaft crank.toml -o -")
    assert not (folder / "-").exists()


@pytest.mark.parametrize("more", ["", " --declare"])
@pytest.mark.parametrize("name", ["notes.symbols.toml", "./NOTES"])
def test_the_sidecar_beside_is_no_result_though_another_is_read(name, more, folder, capsys):
    if name == "./NOTES":
        os.link("notes.symbols.toml", name)
    before = contents(folder)
    err = refused(capsys, f"check notes.md --symbols other.toml{more} -o", name)
    assert "is the sidecar beside notes.md, and would be replaced" in err
    assert contents(folder) == before


@pytest.mark.parametrize(
    ("command", "wanted"),
    [
        ("balance {}", "an engine file"),
        ("check notes.md --symbols {}", "a symbols file"),
        ("assign e.toml --parts {}", "a CSV file of parts"),
        ("torque e.toml --bore 80 --rpm 1000 --pressure {}", "a CSV file of angles and pressures"),
    ],
)
def test_a_refusal_names_the_file_that_is_wanted(command, wanted, folder, capsys):
    assert f"is a directory; name {wanted}" in refused(capsys, command.format("./"))
    with open("./large.md", "w", encoding="utf-8") as stream:
        stream.write("a" * 1_100_000)
    if "--pressure" not in command:
        assert f"; name {wanted} within that" in refused(capsys, command.format("./large.md"))
