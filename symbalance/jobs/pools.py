"""Executors for jobs: a pool of processes on this machine, or a Dask cluster of the same program.

Both are executors of `concurrent.futures`; `run_jobs` takes any other one too. A script that runs jobs in
processes needs the guard `if __name__ == "__main__":`, as multiprocessing has it, since every worker
imports the script anew.
"""

from __future__ import annotations

import logging
import os
import platform
import signal
from collections.abc import Iterator, Mapping
from concurrent.futures import BrokenExecutor, CancelledError, Executor, ProcessPoolExecutor
from contextlib import contextmanager, suppress
from multiprocessing import connection, get_context, parent_process
from threading import Thread
from typing import Any

from symbalance.errors import MissingPartError, SymbalanceError, brief
from symbalance.jobs.digests import program_digest
from symbalance.text.numbers import checked_whole

MOST_WORKERS = 1024
BLAS_THREADS = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS", "VECLIB_MAXIMUM_THREADS")
CONNECTING = 10
"""Seconds that a scheduler has to answer, and after which a lost one is no longer waited for."""


def process_pool(workers: int) -> ProcessPoolExecutor:
    """Return a pool of that many processes, each started anew, with one BLAS thread.

    Never by `fork`: threads of BLAS, and locks that they hold, do not survive it. A worker ignores
    Ctrl-C, which is its parent's to answer, and ends when its parent is gone, however that ended.
    """
    count = checked_whole(workers, "workers", 1, MOST_WORKERS, "as many as the machine has cores")
    return _Pool(count, mp_context=get_context("spawn"), initializer=_prepare_worker)


class _Pool(ProcessPoolExecutor):
    """A pool whose workers never hear of Ctrl-C, from their first moment on.

    A worker ignores it only once it has started, and a terminal sends it to all at once: one that still
    imports would die with a traceback. So it is begun with the signal blocked, which it inherits; the
    parent gets its own as soon as the worker is on its way.
    """

    def submit(self, fn: Any, /, *args: Any, **kwargs: Any) -> Any:
        if not hasattr(signal, "pthread_sigmask"):  # Windows
            return super().submit(fn, *args, **kwargs)
        before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
        try:
            return super().submit(fn, *args, **kwargs)
        finally:
            signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _prepare_worker() -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    # Before anything loads NumPy: processes already share the cores out among themselves.
    for name in BLAS_THREADS:
        os.environ.setdefault(name, "1")
    Thread(target=_end_with_parent, daemon=True).start()


def _end_with_parent() -> None:
    """End this process when its parent has: the pool's own pipes stay open among the workers."""
    parent = parent_process()
    if parent is not None:
        connection.wait([parent.sentinel])
        os._exit(1)


def end_pool(pool: Executor) -> None:
    """End a pool of processes at once, whatever they are doing."""
    processes = [*(getattr(pool, "_processes", None) or {}).values()]
    pool.shutdown(wait=False, cancel_futures=True)
    for process in processes:
        process.kill()
    for process in processes:
        process.join(5)


def killed_worker(problem: BaseException) -> bool:
    """Tell whether an exception says that a worker was killed, not that its work failed."""
    return isinstance(problem, BrokenExecutor) or type(problem).__name__ == "KilledWorker"


def lost_executor(problem: BaseException) -> bool:
    """Tell whether an exception says that there is nobody any more to do the work.

    A future that nobody cancelled is cancelled where Dask's client has given its scheduler up.
    """
    lost = ("CommClosedError", "ClosedClientError", "FutureCancelledError", "FuturesCancelledError")
    return isinstance(problem, CancelledError) or type(problem).__name__ in lost


@contextmanager
def dask_executor(address: str) -> Iterator[Executor]:
    """Yield the executor of a Dask cluster, whose versions are those of this program.

    `address` is its scheduler's, as tcp://10.0.0.1:8786. Refused where it does not answer, has no
    workers, or where Python, NumPy or symbalance (by content) differ somewhere.
    """
    with _silent_logs():
        client = _client(address)
        try:
            _check_versions(address, client)
            yield client.get_executor(pure=False)
        finally:
            with suppress(Exception):  # a scheduler that is gone cannot be taken leave of
                client.close(timeout=2)


def _client(address: str) -> Any:
    try:
        from distributed import Client
    except ImportError:
        raise MissingPartError(
            "--dask", "distributed is not installed", "pip install 'symbalance[dask]'"
        ) from None
    remedy = "start one with `dask scheduler`, and give its address, as tcp://10.0.0.1:8786"
    try:
        return Client(address, timeout=CONNECTING, set_as_default=False)
    except (OSError, TimeoutError, ValueError, TypeError, ImportError) as problem:
        rule = f"no Dask scheduler answers there ({type(problem).__name__})"
        raise SymbalanceError(f"--dask {brief(address, 60)}", rule, remedy) from None


@contextmanager
def _silent_logs() -> Iterator[None]:
    """Keep Dask's own log from stderr: a lost worker is said in one line, by us, or made good."""
    log = logging.getLogger("distributed")
    names = [n for n in logging.root.manager.loggerDict if n.startswith("distributed")]
    loggers = {log, *(logging.getLogger(n) for n in names)}
    levels = {each: each.level for each in loggers}
    for each in loggers:
        each.setLevel(logging.CRITICAL + 1)
    try:
        yield
    finally:
        for each, level in levels.items():
            each.setLevel(level)


def own_versions() -> dict[str, str]:
    """Return what has to be the same on every machine: Python, NumPy, and this program by its content."""
    from importlib.metadata import PackageNotFoundError, version

    try:
        numpy = version("numpy")
    except PackageNotFoundError:
        numpy = "none"
    return {"Python": platform.python_version(), "numpy": numpy, "symbalance": program_digest()}


def _check_versions(address: str, client: Any) -> None:
    """Refuse a cluster on which a version differs; of the scheduler and every worker in one line."""
    own = own_versions()
    places = _python_versions(address, client)
    wrong = _differing(own, places)
    if not wrong:  # code is sent only where Python is known to be the same
        wrong = _differing(own, {place: {"symbalance": v} for place, v in _programs(client).items()})
    if not wrong:
        return
    shown = "; ".join(wrong[:3]) + (f"; and {len(wrong) - 3} more" if len(wrong) > 3 else "")
    raise SymbalanceError(
        f"--dask {brief(address, 60)}",
        f"has other versions than this program: {shown}",
        "install the same on the scheduler and every worker",
    )


def _differing(own: Mapping[str, str], places: Mapping[str, Mapping[str, str]]) -> list[str]:
    return [
        f"{name} {value[:12]} on {place}, here {own[name][:12]}"
        for place, versions in places.items()
        for name, value in versions.items()
        if value != own[name]
    ]


def _python_versions(address: str, client: Any) -> dict[str, dict[str, str]]:
    """Return the versions of Python and NumPy of the scheduler and every worker, as Dask knows them."""
    versions = client.get_versions()
    if not versions["workers"]:
        raise SymbalanceError(
            f"--dask {brief(address, 60)}", "has no workers", f"start some: dask worker {address}"
        )
    places = {"the scheduler": versions["scheduler"]}
    places |= {f"worker {name}": worker for name, worker in versions["workers"].items()}
    result: dict[str, dict[str, str]] = {}
    for place, its in places.items():
        packages = (its or {}).get("packages", {})
        # Dask writes 3.11.7.final.0.
        python = ".".join(str(packages.get("python", "unknown")).split(".")[:3])
        result[place] = {"Python": python, "numpy": str(packages.get("numpy") or "none")}
    return result


def _programs(client: Any) -> dict[str, str]:
    """Return the digest of the program on the scheduler and every worker, "none" where it is missing."""

    def program() -> str:  # a function within a function is sent whole: symbalance may be missing there
        try:
            from symbalance.jobs.digests import program_digest
        except ImportError:
            return "none"
        return program_digest()

    places = {"the scheduler": client.run_on_scheduler(program)}
    return places | {f"worker {name}": value for name, value in client.run(program).items()}
