"""Copies of the checkout, in which alone faults are planted, each with a worker process of its own."""

from __future__ import annotations

import contextlib
import json
import os
import shutil
import subprocess
import sys
import threading
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[3]
WORKER = "tests.faults.planting.worker"


class PlantingError(Exception):
    """What cannot be planted or run, in one line."""


def files_of(root: Path) -> list[str]:
    """Return the files of a checkout that git knows or does not ignore."""
    command = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
    done = subprocess.run(command, cwd=root, capture_output=True, check=False)
    if done.returncode:
        raise PlantingError(f"{root}: is no git checkout, and its files are listed by git")
    names = [name for name in done.stdout.decode().split("\0") if name]
    return [name for name in names if (root / name).is_file()]


def copy_checkout(folder: Path) -> None:
    """Copy the checkout as it is, with the times of its files: compiled modules stay valid."""
    for name in files_of(ROOT):
        target = folder / name
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(ROOT / name, target)
    command = [sys.executable, "-m", "compileall", "-q", "symbalance", "tests"]
    subprocess.run(command, cwd=folder, check=True, capture_output=True)


class Tree:
    """One copy of the checkout and the worker that stands in it."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.stamp = 0
        scratch = folder.with_name(f"{folder.name}-scratch")
        scratch.mkdir()
        inherited = {
            k: v for k, v in os.environ.items() if not k.startswith(("PYTHON", "PYTEST", "SYMBALANCE"))
        }
        environment = inherited | {
            "PYTHONPATH": str(
                folder
            ),  # before the installed library, in this process and in those of tests
            "PYTHONUTF8": "1",
            "PYTHONHASHSEED": "0",
            "OPENBLAS_NUM_THREADS": "1",  # a process with threads is not safely forked
            "OMP_NUM_THREADS": "1",
            "COLUMNS": "80",
            "TMPDIR": str(scratch),  # goes with the copy, even where a job was cut off
        }
        self.process = subprocess.Popen(
            [sys.executable, "-m", WORKER],
            cwd=folder,
            env=environment,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            encoding="utf-8",
        )
        self._answer()

    def do(self, what: str, limit: float, **arguments: Any) -> dict[str, Any]:
        """Have the worker do a job and return its answer."""
        assert self.process.stdin is not None
        print(json.dumps({"do": what, "limit": limit, **arguments}), file=self.process.stdin, flush=True)
        return self._answer()

    def _answer(self) -> dict[str, Any]:
        assert self.process.stdout is not None
        line = self.process.stdout.readline()
        if not line:
            raise PlantingError("a worker has ended: the libraries cannot be imported, or memory ran out")
        return json.loads(line)

    @contextlib.contextmanager
    def changed(self, path: str, text: str) -> Iterator[None]:
        """Hold another text in one file of the copy.

        Each text has a time of its own: Python knows a compiled module by size and whole seconds.
        """
        file = self.folder / path
        before, times = file.read_bytes(), file.stat()
        self.stamp += 2
        file.write_text(text, encoding="utf-8")
        os.utime(file, (times.st_atime, int(times.st_mtime) + self.stamp))
        try:
            yield
        finally:
            file.write_bytes(before)
            os.utime(file, ns=(times.st_atime_ns, times.st_mtime_ns))

    def end(self) -> None:
        """End the worker."""
        self.process.terminate()
        try:
            self.process.wait(timeout=10)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        for stream in (self.process.stdin, self.process.stdout):
            if stream is not None:
                with contextlib.suppress(OSError):
                    stream.close()


@contextlib.contextmanager
def grown_trees(folder: Path, count: int) -> Iterator[list[Tree]]:
    """Give so many copies of the checkout with their workers, and end them."""
    copy_checkout(folder / "tree-0")
    for number in range(1, count):
        shutil.copytree(folder / "tree-0", folder / f"tree-{number}", symlinks=True)
    trees: list[Tree] = []
    try:
        for number in range(count):
            trees.append(Tree(folder / f"tree-{number}"))
        yield trees
    finally:
        for tree in trees:
            tree.end()


class Crew:
    """Trees that take jobs in turn: as many jobs at a time as there are trees."""

    def __init__(self, trees: list[Tree]) -> None:
        self.trees = trees

    def run_all(self, jobs: Mapping[Any, Any]) -> dict[Any, Any]:
        """Run functions of a tree, by key; return what they return, by key."""
        waiting = list(jobs.items())[::-1]
        done: dict[Any, Any] = {}
        problems: list[BaseException] = []
        lock = threading.Lock()

        def work(tree: Tree) -> None:
            while not problems:
                with lock:
                    if not waiting:
                        return
                    key, job = waiting.pop()
                try:
                    done[key] = job(tree)
                except BaseException as problem:
                    problems.append(problem)

        threads = [threading.Thread(target=work, args=(tree,), daemon=True) for tree in self.trees]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        if problems:
            raise problems[0]
        return {key: done[key] for key in jobs}
