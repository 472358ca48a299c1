"""Exit codes and streams: full, closed and broken ones, faults of ours, Ctrl-C."""

import errno
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from symbalance.cli import run
from symbalance.cli.outcomes import DONE, FAILED, FAULT, INTERRUPTED, REFUSED
from tests.interrupts import that_hears_ctrl_c

PROGRAM = f"{sys.executable} -m symbalance"
FULL = Path("/dev/full")

needs_full = pytest.mark.skipif(not FULL.exists(), reason="no /dev/full")
needs_shell = pytest.mark.skipif(os.name != "posix", reason="no POSIX shell")


def shell(command: str, **environment: str) -> subprocess.CompletedProcess:
    return subprocess.run(
        ["bash", "-c", command],
        capture_output=True,
        encoding="utf-8",
        check=False,
        env={**os.environ, **environment},
    )


def test_the_exit_codes_are_those_agreed():
    assert (DONE, FAILED, REFUSED, FAULT, INTERRUPTED) == (0, 1, 2, 3, 130)


@pytest.mark.slow
@needs_full
@pytest.mark.parametrize(
    "arguments",
    [
        "balance v12-60",
        "balance inline-4 --order 300",  # more than a buffer holds
        "engines --show v12-60",
        "--help",
        "balance --help",
        "--version",
        "balance v12-60 -o /dev/full",
    ],
)
def test_what_cannot_be_written_is_refused_in_one_line(arguments):
    done = shell(f"{PROGRAM} {arguments} > /dev/full")
    assert done.returncode == REFUSED
    assert done.stderr.count("\n") == 1
    assert "cannot be written (No space left on device)" in done.stderr


@pytest.mark.slow
@needs_shell
@pytest.mark.parametrize("arguments", ["balance v12-60", "--help", "--version"])
def test_a_closed_stdout_is_refused(arguments):
    done = shell(f"{PROGRAM} {arguments} >&-")
    assert (done.returncode, done.stderr.count("\n")) == (REFUSED, 1)
    assert "standard output: cannot be written" in done.stderr


@pytest.mark.slow
@needs_shell
def test_a_closed_stdout_does_not_matter_to_a_file(tmp_path):
    done = shell(f"{PROGRAM} balance v12-60 -o {tmp_path / 'table'} >&- <&-")
    assert (done.returncode, done.stderr) == (DONE, "")
    assert (tmp_path / "table").read_text(encoding="utf-8").startswith("v12-60: ")


@pytest.mark.slow
@needs_full
@pytest.mark.parametrize("gone", ["2>&-", "2>/dev/full"])
def test_without_stderr_the_exit_code_speaks(gone):
    done = shell(f"{PROGRAM} balance nosuch {gone}")
    assert (done.returncode, done.stdout) == (REFUSED, "")
    done = shell(f"{PROGRAM} balance v12-60 {gone}")
    assert done.returncode == DONE
    assert done.stdout.startswith("v12-60: ")


@needs_shell
def test_progress_that_nobody_reads_stops_nothing(tmp_path):
    """Neither a full stderr nor one whose reader has gone may lose the result."""
    code = "import sys; from symbalance.cli.streams import prepare; prepare(); "
    code += "[print('x' * 5000, file=sys.stderr, flush=True) for _ in range(100)]; print('result')"
    script = tmp_path / "progress.py"
    script.write_text(code, encoding="utf-8")
    command = f"{{ {sys.executable} {script} 2>&1 >&3 | true; }} 3>&1; echo ${{PIPESTATUS[0]}}"
    assert shell(command).stdout.split() == ["result", "0"]


@pytest.mark.slow
@needs_shell
@pytest.mark.parametrize(
    ("arguments", "code"),
    [("balance inline-4 --order 300", DONE), ("--help", DONE), ("check {}", FAILED)],
)
def test_a_closed_pipe_ends_silently_with_the_code_of_the_command(arguments, code, tmp_path):
    page = tmp_path / "wrong.md"
    page.write_text("\n\n".join(f"$${n} = {n + 1}$$" for n in range(2000)), encoding="utf-8")
    command = f"{{ {PROGRAM} {arguments.format(page)}; echo $? >&2; }} | true"
    assert shell(command).stderr == f"{code}\n"


@needs_shell
def test_ctrl_c_ends_silently():
    running = subprocess.Popen(
        that_hears_ctrl_c("-m", "symbalance", "check", "-"),
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    )
    assert running.stdin is not None
    os.write(running.stdin.fileno(), b" " * 200_000)  # more than a pipe holds: the command reads by now
    time.sleep(0.5)  # and now waits for more
    running.send_signal(signal.SIGINT)
    running.wait(timeout=60)
    assert running.stdout is not None
    assert running.stderr is not None
    ended_with = running.returncode, running.stdout.read(), running.stderr.read()
    for stream in (running.stdin, running.stdout, running.stderr):
        stream.close()
    assert ended_with == (INTERRUPTED, b"", b"")


# Faults -----------------------------------------------------------------------------------------------


def ended(monkeypatch, capsys, problem: BaseException) -> tuple[int, str]:
    def failing(*_: object) -> None:
        raise problem

    monkeypatch.setattr("symbalance.engine.catalogue.load", failing)
    code = run(["balance", "v12-60"])
    out, err = capsys.readouterr()
    assert out == ""
    return code, err


@pytest.mark.parametrize("problem", [ZeroDivisionError("x"), KeyError("x"), RecursionError()])
def test_a_fault_of_ours_is_one_line_that_asks_for_a_report(problem, monkeypatch, capsys):
    code, err = ended(monkeypatch, capsys, problem)
    assert (code, err.count("\n")) == (FAULT, 1)
    assert f"a fault of symbalance, not of the input: {type(problem).__name__} in cli/" in err
    assert "please report it with the command and its input" in err
    assert "SYMBALANCE_TRACEBACK=1" in err


def test_the_traceback_of_a_fault_is_shown_where_it_is_wanted(monkeypatch, capsys):
    monkeypatch.setenv("SYMBALANCE_TRACEBACK", "1")
    code, err = ended(monkeypatch, capsys, ZeroDivisionError("x"))
    assert code == FAULT
    assert err.startswith("Traceback")
    assert "ZeroDivisionError: x\n" in err


def test_memory_and_the_system_are_no_fault_of_ours(monkeypatch, capsys):
    code, err = ended(monkeypatch, capsys, MemoryError())
    assert (code, err.count("\n")) == (REFUSED, 1)
    assert err.startswith("symbalance: memory: is not enough")
    code, err = ended(monkeypatch, capsys, OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), "w.json"))
    assert (code, err.count("\n")) == (REFUSED, 1)
    assert "w.json: cannot be used (No space left on device)" in err


def test_a_missing_file_of_our_own_is_a_fault_of_ours(monkeypatch, capsys):
    own = str(Path(sys.modules["symbalance"].__file__ or "").parent / "engines" / "gone.toml")
    code, _ = ended(monkeypatch, capsys, FileNotFoundError(errno.ENOENT, "No such file", own))
    assert code == FAULT


def test_ctrl_c_within_a_command(monkeypatch, capsys):
    assert ended(monkeypatch, capsys, KeyboardInterrupt()) == (INTERRUPTED, "")
