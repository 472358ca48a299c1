"""Long work of commands: where it runs, its progress on stderr, and what is said of it at Ctrl-C."""

from __future__ import annotations

import argparse
import os
import shlex
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypedDict

from symbalance.cli.outcomes import say
from symbalance.cli.output import MEDIA, whole_number
from symbalance.errors import SymbalanceError

if TYPE_CHECKING:
    from concurrent.futures import Executor

    from symbalance.jobs.progress import Progress


STORE = "finished"
"""The folder, in that of the results, of what is finished."""


class Means(TypedDict):
    """How long work is done: the keywords of `run_jobs` that a command line decides."""

    workers: int
    executor: Executor | None
    progress: Progress


def take_one_blas_thread() -> None:
    """Let BLAS use one thread in this process, unless the user has set another number.

    Its sums depend on how many threads share them, so that with several a result would depend on --jobs
    in its last digits; and matrices of this size take longer with two threads than with one. Only before
    NumPy is loaded.
    """
    from symbalance.jobs.pools import BLAS_THREADS

    for name in BLAS_THREADS:
        os.environ.setdefault(name, "1")


@contextmanager
def long_work(options: argparse.Namespace, store: Path | None = None) -> Iterator[Means]:
    """Yield where the jobs run, as --jobs or --dask say, and their progress; `store` keeps them.

    At Ctrl-C one line says what is finished, where it is kept and how to go on.
    """
    from symbalance.jobs.pools import MOST_WORKERS, dask_executor
    from symbalance.jobs.progress import terminal_progress
    from symbalance.text.numbers import checked_whole

    workers = whole_number(options.jobs, "jobs")
    checked_whole(workers, "--jobs", 1, MOST_WORKERS, "as many as the machine has cores")
    progress = terminal_progress()
    try:
        if options.dask is None:
            yield Means(workers=workers, executor=None, progress=progress)
        else:
            with dask_executor(options.dask) as executor:
                yield Means(workers=1, executor=executor, progress=progress)
    except KeyboardInterrupt:
        say(interrupted(progress, store, options.command_line))
        raise


def interrupted(progress: Progress, store: Path | None, command: Any) -> str:
    """Return the line at Ctrl-C."""
    finished = f"symbalance: interrupted: {progress.finished} of {progress.total} finished"
    if store is None:
        return f"{finished}, and not kept: name an output folder to keep them"
    if not progress.finished:
        return f"{finished}; begin again with: {shlex.join(command)}"
    return f"{finished}, kept in {store}; go on with: {shlex.join(command)}"


def output_folder(output: str, option: str = "--output") -> Path:
    """Return the folder of an option, made if need be: refused before the long work, not after it."""
    folder = Path(output)
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as problem:
        rule = f"cannot be made ({problem.strerror})"
        raise SymbalanceError(f"{option} {output}", rule, "name a folder you may write to") from None
    if not os.access(folder, os.W_OK):
        raise SymbalanceError(f"{option} {output}", "is write-protected", "name another folder")
    return folder


def report_paths(folder: Path, names: Iterable[str], form: str, inputs: Iterable[Path]) -> list[Path]:
    """Return a file in a folder for each of several reports in a medium; none may be one that is read.

    Nor may two be one, which differ in capitals only: some file systems take them for the same.
    """
    paths = [folder / f"{name}{MEDIA[form][0]}" for name in names]
    read = [os.stat(path) for path in inputs if path.is_file()]
    claims: dict[str, Path] = {}
    for path in paths:
        if path.is_file() and any(os.path.samestat(os.stat(path), status) for status in read):
            rule = "is a file that is read, and would be replaced"
            raise SymbalanceError(f"--output {path}", rule, "name another folder")
        if claims.setdefault(str(path).casefold(), path) is not path:
            rule = "would be the report of two, and one would be lost"
            raise SymbalanceError(f"--output {path}", rule, "give them names of their own")
    return paths
