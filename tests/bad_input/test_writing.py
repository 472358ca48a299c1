"""Evidence: a file that is written is there whole or is the old one, whatever ends the writer.

By killing it: a process that writes one file again and again is killed at moments that nobody chose; by
limits of the system (the largest file, a full device); by exceptions at each step it makes.
"""

from __future__ import annotations

import os
import random
import signal
import stat
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest

from symbalance.errors import SymbalanceError
from symbalance.text.writing import write_file, write_files

posix = pytest.mark.skipif(os.name != "posix", reason="signals and permissions as POSIX has them")
SIZE = 3_000_000
ENDLESS = f"""\
import itertools, sys
from symbalance.text.writing import write_file
print("ready", flush=True)
for letter in itertools.cycle("ab"):
    write_file(sys.argv[1], letter * {SIZE}, lasting=False)
"""


@pytest.mark.slow
@posix
def test_a_writer_that_is_killed_leaves_the_old_file_or_the_new_one_whole(tmp_path: Path) -> None:
    path = tmp_path / "result"
    moments, letters = random.Random(1), set()
    for _ in range(12):
        path.write_text("o" * SIZE)
        with subprocess.Popen([sys.executable, "-c", ENDLESS, path], stdout=subprocess.PIPE) as writer:
            assert writer.stdout is not None
            assert writer.stdout.readline() == b"ready\n"
            time.sleep(moments.uniform(0.0, 0.1))
            writer.send_signal(signal.SIGKILL)
        content = path.read_text()
        assert len(content) == SIZE
        assert len(set(content)) == 1
        letters.add(content[0])
    assert letters & {"a", "b"}  # the writer had begun


@posix
def test_a_file_that_grows_beyond_the_systems_limit_is_refused_and_nothing_is_left(
    tmp_path: Path,
) -> None:
    program = """\
import resource, sys
from symbalance.errors import SymbalanceError
from symbalance.text.writing import write_files
resource.setrlimit(resource.RLIMIT_FSIZE, (100_000, 100_000))
try:
    write_files({sys.argv[1]: "new", sys.argv[2]: "x" * 1_000_000})
except SymbalanceError as problem:
    print(problem)
"""
    first, second = tmp_path / "first", tmp_path / "second"
    first.write_text("old")
    done = subprocess.run(
        [sys.executable, "-c", program, first, second], capture_output=True, text=True, check=True
    )
    assert done.stdout.startswith(f"file {second}: cannot be written (File too large); name a file")
    assert (first.read_text(), os.listdir(tmp_path)) == ("old", ["first"])


@pytest.mark.parametrize("ends", [KeyboardInterrupt, MemoryError, SystemExit])
@pytest.mark.parametrize("step", ["open", "fdopen", "fsync", "fchmod", "replace"])
def test_an_exception_at_any_step_leaves_the_old_file_and_nothing_else(
    step: str, ends: type[BaseException], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "result"
    path.write_text("old")
    works = getattr(os, step)

    def interrupted(*given: Any, **named: Any) -> object:
        if step == "open" and not given[1] & os.O_CREAT:
            return works(*given, **named)
        works(*given, **named) if step in ("open", "fsync", "fchmod") else None
        raise ends

    monkeypatch.setattr(os, step, interrupted)
    with pytest.raises(ends):
        write_file(path, "new")
    monkeypatch.undo()
    assert (path.read_text(), os.listdir(tmp_path)) == ("old", ["result"])


def test_several_files_are_all_whole_before_the_first_is_put_in_place(tmp_path: Path) -> None:
    (tmp_path / "a").write_text("old")
    contents: dict[str, str | bytes] = {str(tmp_path / "a"): "new", str(tmp_path / "no" / "b"): b"new"}
    with pytest.raises(SymbalanceError, match=r"^file .*b: cannot be written \(No such file"):
        write_files(contents)
    assert (os.listdir(tmp_path), (tmp_path / "a").read_text()) == (["a"], "old")
    (tmp_path / "no").mkdir()
    write_files(contents)
    assert ((tmp_path / "a").read_text(), (tmp_path / "no" / "b").read_bytes()) == ("new", b"new")


@posix
@pytest.mark.parametrize("mask", [0o022, 0o077, 0o002])
def test_a_new_file_has_the_permissions_that_open_gives_and_an_old_one_keeps_its_own(
    mask: int, tmp_path: Path
) -> None:
    before = os.umask(mask)
    try:
        with open(tmp_path / "plain", "w", encoding="utf-8"):
            pass
        write_file(tmp_path / "new", "")
        write_file(tmp_path / "private", "", permissions=0o600)
        (tmp_path / "old").write_text("")
        (tmp_path / "old").chmod(0o751)
        write_file(tmp_path / "old", "")
    finally:
        os.umask(before)
    modes = {path.name: stat.S_IMODE(path.stat().st_mode) for path in tmp_path.iterdir()}
    assert modes["new"] == modes["plain"] == 0o666 & ~mask
    assert (modes["private"], modes["old"]) == (0o600, 0o751)


@posix
def test_a_link_stays_and_its_target_is_written_there_or_not(tmp_path: Path) -> None:
    inner = tmp_path / "inner"
    inner.mkdir()
    link = tmp_path / "link"
    link.symlink_to(inner / "target")
    for content in ("first", "second"):
        write_file(link, content)
        assert link.is_symlink()
        assert (inner / "target").read_text() == content


@posix
def test_a_pipe_is_written_to_by_any_of_its_names(tmp_path: Path) -> None:
    """/dev/stdout names a pipe by a link whose end is no path."""
    program = (
        "import sys; from symbalance.text.writing import write_file; write_file(sys.argv[1], 'through')"
    )
    command = [sys.executable, "-c", program, "/dev/stdout"]
    assert subprocess.run(command, capture_output=True, text=True, check=True).stdout == "through"


@pytest.mark.parametrize("name", ["ü" * 120, "漢" * 84, "x" * 255])
def test_a_name_as_long_as_systems_take_is_written(name: str, tmp_path: Path) -> None:
    write_file(tmp_path / name, "new")
    assert (tmp_path / name).read_text() == "new"


@pytest.mark.parametrize("name", ["", "a\0b", "folder", "folder/../no/file"])
def test_what_cannot_be_written_is_refused_in_one_line(name: str, tmp_path: Path) -> None:
    (tmp_path / "folder").mkdir()
    with pytest.raises(SymbalanceError, match=r"cannot be written \(.+\); say where$") as refusal:
        write_file(f"{tmp_path}/{name}" if name else "", "", what="--output ", remedy="say where")
    assert str(refusal.value).startswith("--output ")
    assert os.listdir(tmp_path) == ["folder"]
