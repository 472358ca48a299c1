"""What is no file is refused at once, whatever it is, and what a file names stays within its folder."""

from __future__ import annotations

import os
import socket
import sys
from pathlib import Path

import pytest

import symbalance as sb
from symbalance.cli import run
from symbalance.crankshaft.files import read_running_engine
from symbalance.errors import SymbalanceError
from symbalance.text import files
from symbalance.text.named_paths import NamingFolder
from tests.bad_input.test_named_files import ENGINE, NOTES, PARTS, SIDECAR
from tests.cranks import SINGLE, sheet, written

posix = pytest.mark.skipif(os.name != "posix", reason="pipes and links as POSIX has them")
COMMANDS = {
    "engine": "balance {}",
    "notes": "check {}",
    "sidecar": "check notes.md --symbols {}",
    "parts": "assign e.toml --parts {}",
    "pressure": "torque e.toml --bore 80 --rpm 1000 --pressure {}",
    "crank": "crankshaft {}",
}
TABLES = {
    "pressure": {"pressure": 'pressure = "odd"'},
    "film": {"viscosity": 'table = "odd"'},
    "overlay": {},
}
OVERLAY = '[running.overlay]\nfile = "odd"\nchannel = "pin 1 bending"'
LARGE = 50_000_000


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    texts = {"e.toml": ENGINE, "notes.md": NOTES, "notes.symbols.toml": SIDECAR, "parts.csv": PARTS}
    for name, text in texts.items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def put(kind: str, path: Path) -> None:
    """Put what is no file, or too large a one, where a file is looked for."""
    if kind == "pipe":
        os.mkfifo(path)
    elif kind == "folder":
        path.mkdir()
    elif kind == "socket":
        home, name = os.getcwd(), path.name
        os.chdir(path.parent)  # a socket's whole path may have a hundred bytes
        with socket.socket(socket.AF_UNIX) as server:
            server.bind(name)
        os.chdir(home)
    elif kind == "large":
        with open(path, "wb") as stream:
            stream.truncate(LARGE)
    else:
        path.symlink_to(f"/dev/{kind}")


RULES = {
    "pipe": "is a pipe, not a file; name ",
    "folder": "is a directory; name ",
    "socket": "is a socket or a device, not a file; name ",
    "large": "is larger than ",
    "zero": "is a device, not a file; name ",
    "tty": "",
}


def one_line(capsys: pytest.CaptureFixture[str]) -> str:
    out, err = capsys.readouterr()
    assert (out, err.count("\n")) == ("", 1)
    return err


@posix
@pytest.mark.parametrize("kind", [kind for kind in RULES if kind != "tty"])
@pytest.mark.parametrize("option", COMMANDS)
def test_what_is_no_file_is_refused_and_hardly_read(option, kind, folder, capsys, monkeypatch):
    put(kind, folder / "odd.toml")
    counts, read = [], os.read

    def counted(descriptor: int, count: int) -> bytes:
        counts.append(len(data := read(descriptor, count)))
        return data

    monkeypatch.setattr(os, "read", counted)
    assert run(COMMANDS[option].format("odd.toml").split()) == 2
    err = one_line(capsys)
    # A folder of notes is work for `check`; this one is empty.
    is_notes_folder = (option, kind) == ("notes", "folder")
    assert f"odd.toml: {'holds no .tex, ' if is_notes_folder else RULES[kind]}" in err
    assert err.endswith(", or pipe it in as -\n") == (kind == "pipe")
    assert sum(counts) < 10_000  # the files beside it alone


@posix
@pytest.mark.parametrize("kind", ["pipe", "folder", "socket", "large", "zero"])
@pytest.mark.parametrize("table", TABLES)
def test_tables_that_an_engine_file_names_are_files_too(table, kind, tmp_path, capsys):
    more = (OVERLAY,) if table == "overlay" else ()
    path = written(tmp_path, sheet(SINGLE, *more, **TABLES[table]))
    put(kind, tmp_path / "odd")
    options = ["--trust-paths"] if kind == "zero" else []  # the link leaves the folder
    assert (
        run(["crankshaft", str(path), "--webs", "nominal", "--steps", "90", "--no-plots", *options]) == 2
    )
    err = one_line(capsys)
    assert f"odd: {RULES[kind]}" in err
    assert "-\n" not in err or table == "pressure"


@posix
def test_a_file_that_says_it_is_empty_is_read_to_the_limit(monkeypatch):
    """Files of /proc have no size: what is read counts, not what was said."""
    with pytest.raises(SymbalanceError, match=r"is larger than 10 bytes"):
        files.read_bytes("/proc/self/status", 10)


def test_a_closed_standard_input_is_refused(monkeypatch):
    monkeypatch.setattr(sys, "stdin", None)
    with pytest.raises(SymbalanceError, match="standard input: cannot be read"):
        files.read_text("-")


# Files named in files ---------------------------------------------------------------------------------

SECRET = "toor:$y$j9T$secret$hash:19000:0:99999:7:::\n" * 40


@pytest.fixture
def outside(tmp_path: Path) -> Path:
    """Return a folder for an engine file; beside it, outside, lies somebody's secret."""
    (tmp_path / "secret").write_text(SECRET, encoding="utf-8")
    (tmp_path / "inside").mkdir()
    return tmp_path / "inside"


NAMES = ["../secret", "/{}/secret", "link", "linked/secret", "sub/../../secret", "-", ""]


@posix
@pytest.mark.parametrize("table", TABLES)
@pytest.mark.parametrize("name", NAMES)
def test_an_engine_file_names_files_of_its_own_folder_alone(name, table, outside, capsys, monkeypatch):
    (outside / "link").symlink_to(outside.parent / "secret")
    (outside / "linked").symlink_to(outside.parent)
    (outside / "sub").mkdir()
    name = name.format(str(outside.parent).lstrip("/"))
    more = (OVERLAY.replace("odd", name),) if table == "overlay" else ()
    changed = {key: text.replace("odd", name) for key, text in TABLES[table].items()}
    path = written(outside, sheet(SINGLE, *more, **changed))
    monkeypatch.chdir(outside)
    monkeypatch.setattr("sys.stdin", None)
    assert run(["crankshaft", path.name, "--webs", "nominal", "--no-plots"]) == 2
    err = one_line(capsys)
    assert f"{path.name}:" in err or "is a directory" in err
    assert "lies outside" in err or name in ("-", "")
    assert "toor" not in err
    assert "secret$" not in err


@posix
@pytest.mark.parametrize("table", TABLES)
def test_a_trusted_file_names_any_and_still_nothing_of_a_wrong_table_is_quoted(table, outside, capsys):
    more = (OVERLAY.replace("odd", "../secret"),) if table == "overlay" else ()
    changed = {key: text.replace("odd", "../secret") for key, text in TABLES[table].items()}
    path = written(outside, sheet(SINGLE, *more, **changed))
    options = ["--webs", "nominal", "--no-plots", "--trust-paths"]
    assert run(["crankshaft", str(path), *options]) == 2
    err = one_line(capsys)
    assert "secret" in err
    assert "toor" not in err
    with pytest.raises(SymbalanceError, match="lies outside the folder"):
        read_running_engine(path)


@pytest.mark.parametrize(
    "command", ["assign e.toml --parts {}", "torque e.toml --bore 8 --rpm 9 --pressure {}"]
)
def test_nothing_is_quoted_of_a_file_that_is_no_table(command, folder, capsys):
    (folder / "shadow").write_text(SECRET, encoding="utf-8")
    assert run(command.format("shadow").split()) == 2
    err = one_line(capsys)
    assert "toor" not in err
    assert "$" not in err


@posix
def test_a_sidecar_names_engine_files_of_its_own_folder_alone(outside, capsys, monkeypatch):
    (outside.parent / "e.toml").write_text(ENGINE, encoding="utf-8")
    (outside / "notes.md").write_text("$$F = 4 A$$\n", encoding="utf-8")
    bind = '[symbols]\nF = "force"\nA = "number"\n[[bind]]\nline = 1\nquantity = "force.vertical"\n'
    bind += 'order = 2\nengine = "{}"\n'
    sidecar = outside / "notes.symbols.toml"
    for name in ("../e.toml", str(outside.parent / "e.toml"), "-"):
        sidecar.write_text(bind.format(name), encoding="utf-8")
        assert run(["check", str(outside / "notes.md")]) == 2
        assert ("lies outside" in one_line(capsys)) == (name != "-")
    sidecar.write_text(bind.format("../e.toml"), encoding="utf-8")
    assert run(["check", str(outside / "notes.md"), "--trust-paths"]) in (0, 1)
    # In the working folder, where it was looked for once, lies nothing that a stranger's notes may name.
    monkeypatch.chdir(outside.parent)
    sidecar.write_text(bind.format("e.toml"), encoding="utf-8")
    assert run(["check", str(outside / "notes.md")]) == 2
    (outside / "e.toml").write_text(ENGINE, encoding="utf-8")
    assert run(["check", str(outside / "notes.md")]) in (0, 1)


def test_a_mapping_of_python_is_the_callers_word(tmp_path):
    (tmp_path / "e.toml").write_text(ENGINE, encoding="utf-8")
    bind = {"line": 1, "quantity": "force.vertical", "order": 2, "engine": str(tmp_path / "e.toml")}
    assert sb.check("$$F = 4 A_2$$", {"bind": [bind]}).verdicts


@posix
def test_files_in_folders_below_and_links_that_stay_are_read(tmp_path):
    (tmp_path / "sub").mkdir()
    (tmp_path / "sub" / "a.csv").write_text("", encoding="utf-8")
    (tmp_path / "b.csv").symlink_to("sub/a.csv")
    for name in ("sub/a.csv", "b.csv", "sub/../b.csv", str(tmp_path / "b.csv"), "漢.csv", "..a"):
        assert NamingFolder(tmp_path).file(name) == tmp_path / name
