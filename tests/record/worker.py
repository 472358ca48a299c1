"""Runs command lines of one program, each in a process of its own that has imported everything already.

`worker.py TREE` reads one JSON object a line on standard input (`arguments`, `folder`, `out`, `err`,
`limit`) and answers each with a line: `exit` and `seconds`. The program is reached by its entry point
alone, `symbalance.__main__:main` with `sys.argv` set, which outlasts any change within.
Nothing here imports from the record: the recorded tree may hold another one.
"""

from __future__ import annotations

import importlib
import json
import os
import resource
import select
import signal
import sys
import tempfile
import traceback
import warnings
from pathlib import Path

WARMING = (
    ("balance", "v8-90", "--format", "json"),
    ("balance", "v8-90", "--format", "latex"),
    ("torque", "v8-90"),
    ("design", "v8-90"),
    ("tolerances", "v8-90", "--throw", "0.1"),
    ("emit", "v8-90", "--target", "numpy"),
    ("check", "absent.md"),
)
"""Runs that load what commands load; only the names of the modules are kept of them."""
GRACE = 20
"""Seconds of the clock allowed for each second of the processor: other work may hold the machine."""


def main() -> None:
    """Answer jobs until standard input ends."""
    tree = Path(sys.argv[1]).resolve()
    answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
    import symbalance

    found = Path(str(symbalance.__file__)).resolve()
    if tree not in found.parents:
        # An installed program would be recorded under the name of a commit it is not.
        print(json.dumps({"refused": f"symbalance was imported from {found}"}), file=answers, flush=True)
        return
    warm()
    print(json.dumps({"ready": str(found)}), file=answers, flush=True)
    for line in sys.stdin:
        job = json.loads(line)
        answer = run(job["arguments"], job["folder"], job["out"], job["err"], job["limit"])
        print(json.dumps(answer), file=answers, flush=True)


def warm() -> None:
    """Import, here, what the commands import, so that no child has to.

    The runs are made in a child: what they leave in caches and settings must not reach the cases.
    """
    with tempfile.TemporaryDirectory() as folder:
        names = Path(folder) / "modules"
        child = os.fork()
        if child == 0:
            try:
                redirect(folder, os.devnull, os.devnull)
                for arguments in WARMING:
                    call(arguments)
                names.write_text("\n".join(sys.modules), encoding="utf-8")
            finally:
                os._exit(0)
        os.waitpid(child, 0)
        modules = names.read_text(encoding="utf-8").split("\n") if names.exists() else []
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for name in modules:
            if name not in sys.modules and name.isprintable():
                try:
                    importlib.import_module(name)
                except Exception:  # what cannot be imported alone, a child imports itself
                    continue


def run(arguments: list[str], folder: str, out: str, err: str, limit: int) -> dict[str, object]:
    """Run one command line in a child and return its exit code, or how it ended without one."""
    over, held = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(over)
        os.setpgid(0, 0)
        resource.setrlimit(resource.RLIMIT_CPU, (limit, limit + 5))
        redirect(folder, out, err)
        os._exit(call(arguments))
    os.close(held)
    # The pipe ends when the child does: waiting for that can have a limit, waitpid cannot.
    ended, _, _ = select.select([over], [], [], limit * GRACE)
    if not ended:
        # The child may not have come to its setpgid yet, so it is named itself too.
        for kill, target in ((os.killpg, child), (os.kill, child)):
            try:
                kill(target, signal.SIGKILL)
            except ProcessLookupError:
                continue
    os.close(over)
    _, status, usage = os.wait4(child, 0)
    seconds = usage.ru_utime + usage.ru_stime
    if not ended or (os.WIFSIGNALED(status) and os.WTERMSIG(status) == signal.SIGXCPU):
        return {"exit": "time limit", "seconds": seconds}
    if os.WIFSIGNALED(status):
        return {"exit": f"signal {os.WTERMSIG(status)}", "seconds": seconds}
    return {"exit": os.WEXITSTATUS(status), "seconds": seconds}


def redirect(folder: str, out: str, err: str) -> None:
    """Give this process its folder and its three streams."""
    os.chdir(folder)
    flags = os.O_WRONLY | os.O_CREAT | os.O_TRUNC
    for path, mode, stream in ((os.devnull, os.O_RDONLY, 0), (out, flags, 1), (err, flags, 2)):
        handle = os.open(path, mode, 0o666)
        os.dup2(handle, stream)
        os.close(handle)
    sys.stdin = open(os.devnull, encoding="utf-8")  # noqa: SIM115 - it replaces the jobs' stream for good


def call(arguments: list[str] | tuple[str, ...]) -> int:
    """Call the program's entry point and return the code that the interpreter would exit with."""
    sys.argv = ["symbalance", *arguments]
    code: object = 0
    try:
        importlib.import_module("symbalance.__main__").main()
    except SystemExit as end:
        code = end.code
    except BaseException:
        traceback.print_exc()
        code = 1
    if code is not None and not isinstance(code, int):
        print(code, file=sys.stderr)
        code = 1
    for stream in (sys.stdout, sys.stderr):
        try:
            stream.flush()
        except (OSError, ValueError):
            code = code or 120  # as the interpreter does when it cannot flush
    return int(code or 0) & 0xFF


if __name__ == "__main__":
    main()
