"""A process that has all libraries but this one loaded, and forks: jobs start at once.

`python -m tests.faults.planting.worker` stands in a copy of the tree and reads a JSON object a line on
standard input: `do` (`list`, `cover`, `results` or `tests`), its arguments and `limit` in seconds. It
answers with a line: `value`, or `ended` if the child gave none.
"""

from __future__ import annotations

import contextlib
import json
import os
import resource
import select
import signal
import sys
import tempfile
import time
import types
from collections import defaultdict
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parents[3]
LIBRARY = str(ROOT / "symbalance") + os.sep
MEMORY = 12 << 30
"""Bytes of address space: a fault that fills the machine ends its own process instead."""
HANG = 40
"""Processor seconds of one test beyond ten times what it takes without a fault: longer is a catch."""


def main() -> None:
    """Answer jobs until standard input ends."""
    signal.signal(signal.SIGTERM, _end)
    answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
    for name in (
        "sympy",
        "numpy",
        "mpmath",
        "scipy.linalg",
        "scipy.sparse.linalg",
        "jsonschema",
    ):
        with contextlib.suppress(ImportError):  # what is not installed, no test needs
            __import__(name)
    loaded = [name for name in sys.modules if name == "symbalance" or name.startswith("symbalance.")]
    assert not loaded, f"{loaded[0]} is loaded: a fault in it would not be seen"
    print(json.dumps({"value": "ready"}), file=answers, flush=True)
    for line in sys.stdin:
        print(json.dumps(run(json.loads(line))), file=answers, flush=True)


_running: list[int] = []


def _end(*_: object) -> None:
    """Take the child along when this process is ended: a fault may never come to an end by itself."""
    for child in _running:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(child, signal.SIGKILL)
    os._exit(143)


def run(job: dict[str, Any]) -> dict[str, Any]:
    """Do a job in a child, with a limit."""
    with tempfile.TemporaryDirectory(prefix="symbalance-planting-") as scratch:
        answer = Path(scratch) / "answer.json"
        progress = Path(scratch) / "progress"
        over, held = os.pipe()
        child = os.fork()
        if child == 0:
            signal.signal(signal.SIGTERM, signal.SIG_DFL)
            os.close(over)
            os.setpgid(0, 0)
            _child(job, Path(scratch), answer)
        _running.append(child)
        os.close(held)
        ended, _, _ = select.select([over], [], [], job["limit"])
        if not ended:
            for kill, target in ((os.killpg, child), (os.kill, child)):
                with contextlib.suppress(ProcessLookupError):
                    kill(target, signal.SIGKILL)
        os.close(over)
        _, status = os.waitpid(child, 0)
        _running.remove(child)
        with contextlib.suppress(ProcessLookupError):
            os.killpg(child, signal.SIGKILL)  # what the tests had started
        if answer.exists():
            return {"value": json.loads(answer.read_text(encoding="utf-8"))}
        last = progress.read_text(encoding="utf-8") if progress.exists() else ""
        how = "limit" if not ended else f"status {status}"
        return {"ended": how, "last": last}


def _busy() -> float:
    """Return the processor seconds that this job has taken: a loaded machine shortens no budget."""
    times = os.times()
    return times.user + times.system + times.children_user + times.children_system


def _child(job: dict[str, Any], scratch: Path, answer: Path) -> None:
    code = 1
    try:
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        log = os.open(scratch / "log", os.O_WRONLY | os.O_CREAT, 0o600)
        null = os.open(os.devnull, os.O_RDONLY)
        for handle, stream in ((null, 0), (log, 1), (log, 2)):
            os.dup2(handle, stream)
        value = JOBS[job["do"]](job, scratch)
        new = answer.with_suffix(".new")
        new.write_text(json.dumps(value), encoding="utf-8")
        new.rename(answer)
        code = 0
    except BaseException as problem:
        text = f"{type(problem).__name__}: {problem}"
        (scratch / "progress").write_text(text, encoding="utf-8")
    finally:
        os._exit(code)


# Results ------------------------------------------------------------------------------------------


def list_results(job: dict[str, Any], scratch: Path) -> Any:
    """Return the recorded results: names, and command lines where they have one."""
    from . import recorded_results

    chosen = {name: list(case.arguments) for name, case in recorded_results.cases(ROOT).items()}
    return chosen | dict.fromkeys(recorded_results.names_of_examples())


def compute_results(job: dict[str, Any], scratch: Path) -> Any:
    """Compute results in turn; with `expected`, stop at the first that differs.

    Return digests, seconds and, if `lines` is asked for, which lines of the library each ran.
    """
    from tests.record.cases import Case

    from . import recorded_results

    recorded_results.stage_inputs(ROOT, scratch)
    expected = job.get("expected")
    lines = Lines()
    value: dict[str, Any] = {}
    until = _busy() + job.get("budget", 1e9)
    for name, arguments in job["results"].items():
        (scratch / "progress").write_text(name, encoding="utf-8")
        start = time.monotonic()
        with lines.traced() if job.get("lines") else contextlib.nullcontext({}) as ran:
            try:
                if arguments is None:
                    digest = recorded_results.digest_of_example(name)
                else:
                    digest = recorded_results.digest_of_case(
                        Case(name, tuple(arguments)), scratch / "inputs"
                    )
            except Exception as problem:
                digest = f"{type(problem).__name__}"
        value[name] = {"digest": digest, "seconds": time.monotonic() - start, "lines": ran}
        if expected and digest != expected[name]:
            return {"differs": name, "value": value}
        if _busy() > until:
            break
        _clear_caches()
    return {"differs": None, "value": value}


def _clear_caches() -> None:
    for name, module in list(sys.modules.items()):
        if name.startswith("symbalance"):
            for thing in list(vars(module).values()):
                for each in (thing, *(vars(thing).values() if isinstance(thing, type) else ())):
                    if hasattr(each, "cache_clear") and hasattr(each, "cache_info"):
                        each.cache_clear()


ENOUGH_CALLS = 60
"""Calls of a function whose lines are traced for one result: tracing all would take ten times as long."""


class Lines:
    """Which lines of the library run, by module."""

    def __init__(self) -> None:
        self.sets: dict[types.CodeType, set[int]] = {}
        self.calls: dict[types.CodeType, int] = {}

    @contextlib.contextmanager
    def traced(self) -> Iterator[dict[str, list[int]]]:
        """Trace what runs within; the lines are there when it has ended."""
        ran: dict[str, list[int]] = {}
        self.sets, self.calls = {}, {}
        sys.settrace(self._call)
        try:
            yield ran
        finally:
            sys.settrace(None)
            by_path: dict[str, set[int]] = defaultdict(set)
            for code, numbers in self.sets.items():
                by_path[code.co_filename[len(LIBRARY) :]] |= numbers
            ran.update({path: sorted(numbers) for path, numbers in by_path.items()})

    def _call(self, frame: types.FrameType, event: str, arg: object) -> Callable | None:
        code = frame.f_code
        if not code.co_filename.startswith(LIBRARY):
            return None
        numbers = self.sets.setdefault(code, set())
        self.calls[code] = self.calls.get(code, 0) + 1
        if self.calls[code] > ENOUGH_CALLS:
            return None

        def line(frame: types.FrameType, event: str, arg: object) -> Callable | None:
            if event == "line":
                numbers.add(frame.f_lineno)
            return line

        return line


# Tests --------------------------------------------------------------------------------------------

QUIET = ("-p", "no:cacheprovider", "-p", "no:xdist", "-m", "slow or not slow", "-q", "--no-header")


class Covering:
    """A pytest plugin: which functions of the library each test calls, and how long it takes."""

    def __init__(self) -> None:
        self.tests: dict[str, dict[str, Any]] = {}
        self.functions: set[tuple[str, str, int]] = set()

    def _call(self, frame: types.FrameType, event: str, arg: object) -> None:
        code = frame.f_code
        if code.co_filename.startswith(LIBRARY):
            self.functions.add((code.co_filename[len(LIBRARY) :], code.co_name, code.co_firstlineno))

    @pytest.hookimpl(tryfirst=True)
    def pytest_collection_modifyitems(self, items: list[pytest.Item]) -> None:
        """Leave `rare` tests out."""
        items[:] = [item for item in items if not item.get_closest_marker("rare")]

    @pytest.hookimpl(hookwrapper=True)
    def pytest_runtest_protocol(self, item: pytest.Item) -> Iterator[None]:
        """Trace one test."""
        self.functions = set()
        start = time.monotonic()
        sys.settrace(self._call)
        yield
        sys.settrace(None)
        entry = self.tests.setdefault(item.nodeid, {})
        entry |= {"seconds": time.monotonic() - start, "functions": sorted(self.functions)}

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Note a test that fails or is skipped without any fault: it says nothing about one."""
        if not report.passed:
            self.tests.setdefault(report.nodeid, {})["outcome"] = report.outcome


def cover_tests(job: dict[str, Any], scratch: Path) -> Any:
    """Run the fast tests of some files and return what each calls."""
    plugin = Covering()
    pytest.main(
        [*QUIET, "-m", "not slow", f"--basetemp={scratch}/tmp", *job["files"]],
        plugins=[plugin, Settling()],
    )
    return plugin.tests


class Running:
    """A pytest plugin: runs the tests it is given, in their order, up to the first failure."""

    def __init__(self, job: dict[str, Any], scratch: Path) -> None:
        self.order = {name: place for place, name in enumerate(job.get("tests") or ())}
        self.without = set(job.get("without", ()))
        self.seconds: dict[str, float] = job.get("seconds", {})
        self.until = _busy() + job["budget"]
        self.progress = scratch / "progress"
        self.failed = ""
        self.ran: dict[str, float] = {}
        self.omitted = 0
        self.collected = 0

    @pytest.hookimpl(trylast=True)
    def pytest_collection_modifyitems(self, items: list[pytest.Item]) -> None:
        """Choose and order."""
        chosen = [
            item
            for item in items
            if item.nodeid not in self.without and not item.get_closest_marker("rare")
        ]
        if self.order:
            chosen = [item for item in chosen if item.nodeid in self.order]
            chosen.sort(key=lambda item: self.order[item.nodeid])
        else:
            chosen.sort(
                key=lambda item: item.get_closest_marker("slow") is not None
            )  # stable: fast ones first
        items[:] = chosen
        self.collected = len(chosen)

    @pytest.hookimpl(tryfirst=True)
    def pytest_runtest_protocol(self, item: pytest.Item) -> bool | None:
        """Leave the rest when the budget is spent; give one test a limit."""
        if _busy() > self.until:
            self.omitted += 1
            return True
        self.progress.write_text(item.nodeid, encoding="utf-8")
        signal.signal(signal.SIGPROF, self._hang)
        signal.setitimer(signal.ITIMER_PROF, HANG + 10 * self.seconds.get(item.nodeid, 6))
        return None

    def _hang(self, *_: object) -> None:
        raise TimeoutError("the test takes far longer than without the fault")

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Note the first failure."""
        self.ran[report.nodeid] = self.ran.get(report.nodeid, 0.0) + report.duration
        if report.failed and not self.failed:
            self.failed = report.nodeid

    def pytest_collectreport(self, report: pytest.CollectReport) -> None:
        """A file that cannot be imported is a failure."""
        if report.failed and not self.failed:
            self.failed = report.nodeid or "collection"


def run_tests(job: dict[str, Any], scratch: Path) -> Any:
    """Run tests up to the first failure."""
    plugin = Running(job, scratch)
    pytest.main(
        [*QUIET, "-x", f"--basetemp={scratch}/tmp", "--tb=no", *job["files"]],
        plugins=[plugin, Settling()],
    )
    signal.setitimer(signal.ITIMER_PROF, 0)
    return {
        "failed": plugin.failed,
        "ran": plugin.ran,
        "omitted": plugin.omitted,
        "collected": plugin.collected,
        "busy": _busy(),
    }


class Settling:
    """A pytest plugin: Hypothesis draws the same examples each time, and no busy machine fails a test."""

    def pytest_sessionstart(self) -> None:
        """Load Hypothesis only now: pytest warns of a plugin that was there before it."""
        from hypothesis import settings

        settings.register_profile("planting", deadline=None, derandomize=True, database=None)
        settings.load_profile("planting")


JOBS: dict[str, Callable[[dict[str, Any], Path], Any]] = {
    "list": list_results,
    "results": compute_results,
    "cover": cover_tests,
    "tests": run_tests,
}

if __name__ == "__main__":
    main()
