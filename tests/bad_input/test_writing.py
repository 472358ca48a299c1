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
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest

from symbalance.errors import SymbalanceError
from symbalance.text import writing
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


# Links, pipes, what killed writers left ---------------------------------------------------------------


@pytest.fixture
def shared(tmp_path: Path) -> Path:
    """Return a folder such as /tmp, which belongs to another than who plants links in it."""
    folder = tmp_path / "shared"
    folder.mkdir()
    folder.chmod(0o1777)
    return folder


root = pytest.mark.skipif(
    not hasattr(os, "geteuid") or os.geteuid() != 0, reason="another user's link takes root to make"
)


@root
@pytest.mark.parametrize("there", [True, False], ids=["a victim's file", "a name to be created"])
@pytest.mark.parametrize("name", ["out.txt", "folder/out.txt", "sub/../out.txt"])
def test_a_link_that_another_put_into_an_open_folder_is_not_followed(name, there, shared, tmp_path):
    """By the kernel's own rule for such folders, whether it is switched on or not."""
    (shared / "sub").mkdir()
    home = tmp_path / "home"
    home.mkdir()
    victim = home / "out.txt"
    if there:
        victim.write_text("theirs")
    planted = shared / name.split("/")[0] if name.startswith("folder") else shared / "out.txt"
    planted.symlink_to(home if name.startswith("folder") else victim)
    os.chown(planted, 12345, 12345, follow_symlinks=False)
    with pytest.raises(
        SymbalanceError, match="is a link that someone else put into a folder open to all"
    ):
        write_file(shared / name, "ours")
    assert (victim.read_text() if there else victim.exists()) == ("theirs" if there else False)
    os.chown(planted, 0, 0, follow_symlinks=False)  # one's own leads where one wants
    write_file(shared / name, "ours")
    assert victim.read_text() == "ours"


@posix
def test_a_temporary_name_that_is_taken_is_not_written_to(tmp_path, monkeypatch):
    """As if somebody had foreseen it and planted a link to a victim's file."""
    victim = tmp_path / "victim"
    victim.write_text("theirs")
    (tmp_path / ".out.0123456789abcdef.part").symlink_to(victim)
    (tmp_path / ".out.fedcba9876543210.part").write_text("theirs")
    os.utime(tmp_path / ".out.fedcba9876543210.part", (0, 0))
    for name in (".out.0123456789abcdef.part", ".out.fedcba9876543210.part"):
        monkeypatch.setattr(writing, "temporary_name", lambda base, name=name: name)
        monkeypatch.setattr(writing, "_clear_left_over", lambda folder: None)
        with pytest.raises(SymbalanceError, match="File exists"):
            write_file(tmp_path / "out", "ours")
        assert victim.read_text() == "theirs"
        assert not (tmp_path / "out").exists()


@posix
def test_permissions_go_to_the_file_written_not_to_a_name(tmp_path, monkeypatch):
    """A name may be another file's by then: chmod by name is never called."""
    monkeypatch.setattr(os, "chmod", lambda *_, **__: pytest.fail("by name"))
    write_file(tmp_path / "private", "", permissions=0o600)
    assert stat.S_IMODE((tmp_path / "private").stat().st_mode) == 0o600


@posix
def test_what_is_a_pipe_when_looked_at_and_a_file_when_opened_is_not_emptied(tmp_path, monkeypatch):
    """It is opened as it is and asked what it is: there is no moment between."""
    pipe, file = tmp_path / "out", tmp_path / "file"
    os.mkfifo(pipe)
    file.write_text("theirs")
    flags, real = [], os.open

    def opened(path: Any, how: int, *rest: Any, **named: Any) -> int:
        flags.append(how)
        return real(file if path == str(pipe) else path, how, *rest, **named)

    monkeypatch.setattr(os, "open", opened)
    monkeypatch.setattr(os, "supports_dir_fd", {*os.supports_dir_fd, opened})
    write_file(pipe, "ours")
    assert not flags[0] & (os.O_CREAT | os.O_TRUNC)
    assert file.read_text() == "theirs"


@posix
def test_a_pipe_nobody_reads_is_refused_and_one_with_a_reader_is_written_to(tmp_path):
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    with pytest.raises(SymbalanceError, match=r"cannot be written \(nobody reads from it"):
        write_file(pipe, "x")
    with subprocess.Popen(["cat", pipe], stdout=subprocess.PIPE, text=True) as reader:
        deadline = time.monotonic() + 30
        while True:
            try:
                write_file(pipe, "x" * 30_000)
                break
            except SymbalanceError:
                assert time.monotonic() < deadline
                time.sleep(0.01)
        assert reader.stdout is not None
        assert reader.stdout.read() == "x" * 30_000


@posix
def test_a_file_behind_stdout_is_written_on_as_the_shell_said(tmp_path):
    program = "import sys\nfrom symbalance.text.writing import write_file\nprint('before')\n"
    program += "write_file(sys.argv[1], 'through\\n')\nprint('after')\n"
    log = tmp_path / "log"
    for name in ("/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"):
        log.write_text("old\n")
        with open(log, "ab") as stream:
            subprocess.run([sys.executable, "-c", program, name], stdout=stream, check=True)
        assert log.read_text() == "old\nbefore\nthrough\nafter\n"


@posix
def test_what_a_killed_writer_left_is_cleared_at_the_next_write_and_nothing_else(tmp_path):
    own = [
        ".hidden.part",
        ".out.0123.part",
        "out.0123456789abcdef.part",
        ".out.0123456789abcdef.part.txt",
    ]
    for name in own:
        (tmp_path / name).write_text("mine")
    (tmp_path / ".folder.0123456789abcdef.part").mkdir()
    program = f"""\
import os, sys
from symbalance.text import writing
writing._Staged.take_its_name = lambda self: os.kill(os.getpid(), {int(signal.SIGKILL)})
writing.write_file(sys.argv[1], "half")
"""
    done = subprocess.run([sys.executable, "-c", program, tmp_path / "out"], check=False)
    assert done.returncode == -signal.SIGKILL
    before = {path.name for path in tmp_path.iterdir()}
    assert len(before) == len(own) + 2
    write_file(tmp_path / "other", "new")
    left = {path.name for path in tmp_path.iterdir()}
    assert left == {*own, ".folder.0123456789abcdef.part", "other"}


@posix
def test_what_a_living_writer_has_is_not_cleared(tmp_path):
    """It may take as long as it likes: a second writer goes on beside it."""
    program = """\
import sys
from symbalance.text import writing
real = writing._Staged.take_its_name
def wait(staged):
    print("staged", flush=True)
    sys.stdin.readline()
    real(staged)
writing._Staged.take_its_name = wait
writing.write_file(sys.argv[1], "slow")
"""
    command = [sys.executable, "-c", program, tmp_path / "slow"]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as writer:
        assert writer.stdin is not None
        assert writer.stdout is not None
        assert writer.stdout.readline() == b"staged\n"
        for staged in tmp_path.iterdir():
            os.utime(staged, (0, 0))
        write_file(tmp_path / "fast", "fast")
        assert len(list(tmp_path.iterdir())) == 2
        writer.stdin.write(b"go\n")
        writer.stdin.close()
        assert writer.wait() == 0
    assert (tmp_path / "slow").read_text() == "slow"
    assert sorted(os.listdir(tmp_path)) == ["fast", "slow"]


@posix
def test_without_locks_only_what_is_hours_old_is_cleared(tmp_path, monkeypatch):
    monkeypatch.setattr(writing, "fcntl", None)
    for name, age in ((".a.0123456789abcdef.part", 2 * writing.OLDEST), (".b.0123456789abcdef.part", 60)):
        (tmp_path / name).write_text("half")
        os.utime(tmp_path / name, (time.time() - age,) * 2)
    write_file(tmp_path / "out", "new")
    assert sorted(os.listdir(tmp_path)) == [".b.0123456789abcdef.part", "out"]


@posix
def test_content_is_on_the_disk_before_its_name_and_the_name_before_the_end(tmp_path, monkeypatch):
    done: list[str] = []
    fsync, replace = os.fsync, os.replace

    def synced(descriptor: int) -> None:
        done.append("folder" if stat.S_ISDIR(os.fstat(descriptor).st_mode) else "file")
        fsync(descriptor)

    def replaced(*given: Any, **named: Any) -> None:
        done.append("name")
        replace(*given, **named)

    monkeypatch.setattr(os, "fsync", synced)
    monkeypatch.setattr(os, "replace", replaced)
    write_files({str(tmp_path / "a"): "1", str(tmp_path / "b"): "2"})
    assert done == ["file", "file", "name", "name", "folder"]
    done.clear()
    write_file(tmp_path / "c", "3", lasting=False)
    assert done == ["name"]


@posix
def test_two_names_of_temporary_files_are_never_alike():
    names = {writing.temporary_name("report.txt") for _ in range(10_000)}
    assert len(names) == 10_000
    assert all(writing.LEFT_OVER.fullmatch(name) for name in names)


@root
@pytest.mark.slow
def test_a_full_disk_is_one_line_and_leaves_the_old_file(tmp_path):
    """On a small file system of its own, filled to the last page."""
    disk = tmp_path / "disk"
    disk.mkdir()
    command = ["mount", "-t", "tmpfs", "-o", "size=300k", "tmpfs", str(disk)]
    if subprocess.run(command, capture_output=True, check=False).returncode:
        pytest.skip("mounting is not allowed here")
    try:
        out = disk / "out.txt"
        out.write_text("old")
        with open(disk / "rest", "wb", 0) as rest, suppress(OSError):
            while True:
                rest.write(bytes(1000))
        command = [
            sys.executable,
            "-m",
            "symbalance",
            "balance",
            "v12-60",
            "-o",
            str(out),
        ]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        assert (done.returncode, done.stdout, done.stderr.count("\n")) == (2, "", 1)
        assert f"{out}: cannot be written (No space left on device)" in done.stderr
        assert (out.read_text(), sorted(os.listdir(disk))) == ("old", ["out.txt", "rest"])
    finally:
        subprocess.run(["umount", str(disk)], check=True)
