"""A folder of results is that of one run, whole, wherever the run that changes it is ended."""

from __future__ import annotations

import os
import stat
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from symbalance.errors import SymbalanceError
from symbalance.text.result_folders import RESULTS, write_results

posix = pytest.mark.skipif(os.name != "posix", reason="links and locks as POSIX has them")
OLD: dict[str, str | bytes] = {"report.txt": "old", "report.json": "old", "curves-1000rpm.csv": "old"}
NEW: dict[str, str | bytes] = {"report.txt": "new", "report.json": b"new", "curves-2000rpm.csv": "new"}
OWN = {"notes.txt": "mine", "speeds/1000rpm.npz": "saved", "webs.json": "saved"}
STEPS = ("open", "replace", "symlink", "link", "unlink", "mkdir", "rmdir", "fsync", "listdir")


class Killed(BaseException):
    """The process is no more: nothing that it would still do is done."""


@contextmanager
def killed_at(number: int, steps: tuple[str, ...] = STEPS) -> Iterator[list[str]]:
    """End every step from the `number`-th on, those of a clean-up too; yield the steps that were done."""
    done: list[str] = []
    real = {step: getattr(os, step) for step in steps}

    def step_of(name: str):
        def step(*given: object, **named: object) -> object:
            if len(done) >= number:
                raise Killed
            done.append(name)
            return real[name](*given, **named)

        return step

    with pytest.MonkeyPatch.context() as patch:
        for name in steps:
            patch.setattr(os, name, step_of(name))
        # `os.open in os.supports_dir_fd` is asked of the function itself.
        patch.setattr(os, "supports_dir_fd", {*os.supports_dir_fd, os.open})
        yield done


def fill(folder: Path) -> None:
    (folder / "speeds").mkdir(parents=True)
    for name, content in {**OLD, **OWN}.items():
        (folder / name).write_text(str(content))


def shown(folder: Path) -> dict[str, str]:
    """Return what a reader finds: the files by name, hidden ones and names that lead nowhere left out."""
    paths = [path for path in folder.iterdir() if not path.name.startswith(".") and path.is_file()]
    return {path.name: path.read_text() for path in paths}


def expected(results: dict[str, str | bytes]) -> dict[str, str]:
    own = {"notes.txt": "mine", "webs.json": "saved", "curves-1000rpm.csv": "old"}
    return own | {
        name: text if isinstance(text, str) else text.decode() for name, text in results.items()
    }


def is_at_rest(folder: Path) -> bool:
    return not any(path.is_symlink() or path.name.startswith(".") for path in folder.iterdir())


def steps_of_a_whole_run(folder: Path) -> int:
    fill(folder)
    with killed_at(10**9) as done:
        write_results(folder, NEW)
    assert shown(folder) == expected(NEW)
    assert is_at_rest(folder)
    return len(done)


@posix
@pytest.mark.slow
def test_a_kill_at_any_step_leaves_the_old_results_or_the_new_and_the_next_run_goes_on(tmp_path):
    count = steps_of_a_whole_run(tmp_path / "whole")
    states = []
    for number in range(count):
        folder = tmp_path / str(number)
        fill(folder)
        with killed_at(number), pytest.raises(Killed):
            write_results(folder, NEW)
        state = shown(folder)
        assert state in (expected(OLD), expected(NEW)), number
        states.append(state == expected(NEW))
        assert (folder / "speeds" / "1000rpm.npz").read_text() == "saved"
        # The next run is killed too, at some step of what it clears up, and the one after goes through.
        with killed_at(number % 17), pytest.raises(Killed):
            write_results(folder, dict.fromkeys(OLD, "third"))
        assert shown(folder) == state
        write_results(folder, dict.fromkeys(OLD, "third"))
        assert {**shown(folder), "curves-2000rpm.csv": ""} == {
            **expected(dict.fromkeys(OLD, "third")),
            "curves-2000rpm.csv": "",
        }
        assert is_at_rest(folder)
    assert states == sorted(states)  # one moment parts the old from the new
    assert {False, True} == set(states)


@posix
@pytest.mark.slow
def test_without_links_the_next_run_says_that_results_were_of_two_runs(tmp_path, monkeypatch):
    def refuse(*_: object, **__: object) -> None:
        raise PermissionError(1, "no links here")

    monkeypatch.setattr(os, "symlink", refuse)
    steps = tuple(step for step in STEPS if step != "symlink")
    fill(tmp_path / "whole")
    with killed_at(10**9, steps) as done:
        write_results(tmp_path / "whole", NEW, say=pytest.fail)
    assert shown(tmp_path / "whole") == expected(NEW)
    assert is_at_rest(tmp_path / "whole")
    said = mixed = 0
    for number in range(len(done)):
        folder, lines = tmp_path / str(number), []
        fill(folder)
        with killed_at(number, steps), pytest.raises(Killed):
            write_results(folder, NEW)
        is_mixed = shown(folder) not in (expected(OLD), expected(NEW))
        write_results(folder, NEW, say=lines.append)
        assert bool(lines) >= is_mixed
        assert all(line.endswith("in place: they were of two runs") for line in lines)
        assert shown(folder) == expected(NEW)
        assert is_at_rest(folder)
        said, mixed = said + bool(lines), mixed + is_mixed
    assert 0 < mixed <= said < len(done)


@posix
def test_a_result_that_cannot_be_written_leaves_the_old_ones(tmp_path):
    folder = tmp_path / "run"
    fill(folder)
    (folder / "curves-2000rpm.csv").mkdir()
    with pytest.raises(
        SymbalanceError, match=r"^file .*/curves-2000rpm.csv: cannot be written \(it is a dir"
    ):
        write_results(folder, NEW)
    (folder / "curves-2000rpm.csv").rmdir()
    os.mkfifo(folder / "curves-2000rpm.csv")
    with pytest.raises(SymbalanceError, match=r"cannot be written \(it is a pipe or a device\)"):
        write_results(folder, NEW)
    (folder / "curves-2000rpm.csv").unlink()
    with pytest.raises(SymbalanceError, match=r"cannot be written \(No such file or directory\)"):
        write_results(folder / "none", NEW)
    assert shown(folder) == expected(OLD)
    assert is_at_rest(folder)


@posix
def test_links_and_permissions_of_somebodys_own(tmp_path):
    folder = tmp_path / "run"
    fill(folder)
    (folder / "report.json").chmod(0o640)
    (tmp_path / "elsewhere").write_text("old")
    (folder / "report.txt").unlink()
    (folder / "report.txt").symlink_to("../elsewhere")
    write_results(folder, NEW)
    assert stat.S_IMODE((folder / "report.json").stat().st_mode) == 0o640
    assert shown(folder) == expected(NEW)
    assert (tmp_path / "elsewhere").read_text() == "old"  # a result is a file of its own


@posix
@pytest.mark.slow
def test_two_runs_into_one_folder_come_one_after_the_other(tmp_path):
    fill(tmp_path / "run")
    names = [f"{i}.csv" for i in range(20)]
    runs = [
        threading.Thread(
            target=write_results, args=(tmp_path / "run", dict.fromkeys(names, letter * 50_000))
        )
        for letter in "abcd"
    ]
    for run in runs:
        run.start()
    for run in runs:
        run.join()
    assert len({(tmp_path / "run" / name).read_text() for name in names}) == 1
    assert is_at_rest(tmp_path / "run")


@posix
def test_a_planted_link_is_removed_and_not_followed(tmp_path):
    folder, victim = tmp_path / "run", tmp_path / "victim"
    fill(folder)
    victim.mkdir()
    (victim / "file").write_text("theirs")
    (folder / f"{RESULTS}.0123456789abcdef").symlink_to(victim)
    (folder / RESULTS).symlink_to(victim)
    write_results(folder, NEW)
    assert [path.name for path in victim.iterdir()] == ["file"]
    assert shown(folder) == expected(NEW)
    assert is_at_rest(folder)
