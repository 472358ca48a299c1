"""What tests share: tiers by cost, golden files (`pytest --update` rewrites them), a LaTeX compiler.

The fast core, `-m "not slow"`, holds some of every kind of evidence. `slow` is all the rest, `rare` what
of it takes minutes, or programs that few machines have. A test's marks say where it belongs:

    @pytest.mark.slow                        the test, or as `pytestmark` the module
    @pytest.mark.rare                        the same, and slow
    @pytest.mark.spread(3)                   three of its cases are fast, from the first to the last
    @pytest.mark.spread("v6-60", "boxer-4")  the cases are fast whose parameters these are
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import tempfile
from collections import Counter, defaultdict
from collections.abc import Callable, Sequence
from pathlib import Path

import pytest

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
"""Small matrices: several threads, in several test processes, only wait for one another."""
if "NUMBA_CACHE_DIR" not in os.environ:  # compiled code of tests is not kept in the user's cache
    _numba = tempfile.TemporaryDirectory(prefix="symbalance-numba-")
    os.environ["NUMBA_CACHE_DIR"] = _numba.name

GOLDEN = Path(__file__).parent / "golden"
_FAULT = re.compile(r"^!.*|^Overfull \\hbox \(([\d.]+)pt.*|^LaTeX Warning: Reference.*", re.MULTILINE)


SLOW_DOCUMENTS = frozenset(
    f"{name}.md"
    for name in (
        "balance-tables",
        "balancing",
        "crankshaft-equations",
        "crankshaft-model",
        "crankshaft-running",
        "crankshaft-solution",
        "handbook-tables",
        "offset",
        "radials",
        "tolerances",
        "torque",
    )
)
"""Derivations whose formulas take more than a second to compute: a document cannot carry a mark."""


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--update", action="store_true", help="rewrite the golden files")
    parser.addoption("--none-skipped", action="store_true", help="fail if a test is skipped")


@pytest.hookimpl(tryfirst=True)  # before pytest's own, which takes out what `-m` does not ask for
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Mark as slow what stands in a slow document, is rare, or is none of the fast cases of its test."""
    cases: dict[str, list[pytest.Item]] = defaultdict(list)
    for item in items:
        slow_doctest = isinstance(item, pytest.DoctestItem) and item.path.name in SLOW_DOCUMENTS
        if slow_doctest or item.get_closest_marker("rare"):
            item.add_marker(pytest.mark.slow)
        elif item.get_closest_marker("spread"):
            cases[item.nodeid.partition("[")[0]].append(item)
    for same_test in cases.values():
        mark = same_test[0].get_closest_marker("spread")
        assert mark is not None
        for item in not_spread(same_test, mark.args):
            item.add_marker(pytest.mark.slow)


def not_spread(cases: Sequence[pytest.Item], fast: tuple[int | str, ...]) -> list[pytest.Item]:
    """Return the cases of a test that are none of the fast ones: so many, or those of that name."""
    if isinstance(fast[0], int):
        last, steps = len(cases) - 1, max(fast[0] - 1, 1)
        places = {round(last * step / steps) for step in range(fast[0])}
        return [case for place, case in enumerate(cases) if place not in places]
    parameters = [{str(value) for value in case.callspec.params.values()} for case in cases]  # type: ignore[attr-defined]
    lacking = set(fast) - set().union(*parameters)
    assert len(cases) == 1 or not lacking, f"{cases[0].nodeid}: no case is named {lacking}"
    return [case for case, values in zip(cases, parameters, strict=True) if not values & set(fast)]


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """List what was skipped, and why: a green run says what it did not look at."""
    skipped = terminalreporter.stats.get("skipped", [])
    reasons = Counter(report.longrepr[2] for report in skipped)
    for reason, count in sorted(reasons.items()):
        terminalreporter.write_line(f"{count} not run: {reason.removeprefix('Skipped: ')}", yellow=True)
    if skipped and terminalreporter.config.getoption("--none-skipped"):
        terminalreporter.write_line("--none-skipped: for this the run fails", red=True)


def pytest_sessionfinish(session: pytest.Session) -> None:
    """Let `--none-skipped` fail a run in which a test was skipped."""
    reporter = session.config.pluginmanager.get_plugin("terminalreporter")
    skipped = reporter.stats.get("skipped") if reporter is not None else None
    if skipped and session.config.getoption("--none-skipped") and session.exitstatus == 0:
        session.exitstatus = pytest.ExitCode.TESTS_FAILED


@pytest.fixture
def golden(request: pytest.FixtureRequest) -> Callable[[str, str], None]:
    """Return a check that a text is what the golden file of that name holds."""

    def check(name: str, text: str) -> None:
        if request.config.getoption("--update"):
            GOLDEN.mkdir(exist_ok=True)
            (GOLDEN / name).write_text(text, encoding="utf-8")
        assert text == (GOLDEN / name).read_text(encoding="utf-8")

    return check


@pytest.fixture
def compile_latex(tmp_path: Path) -> Callable[[str], Path]:
    """Return a compiler of LaTeX sources to PDF that fails on errors and lines over the margin."""
    program = shutil.which("pdflatex")
    if program is None:
        pytest.skip("pdflatex is not installed")

    def compiled(source: str) -> Path:
        (tmp_path / "document.tex").write_text(source, encoding="utf-8")
        command = [program, "-interaction=nonstopmode", "-halt-on-error", "document.tex"]
        run = subprocess.run(command, cwd=tmp_path, capture_output=True, timeout=120, check=False)
        log = run.stdout.decode("utf-8", "replace")
        faults = [m[0] for m in _FAULT.finditer(log) if m[1] is None or float(m[1]) > 1]
        assert run.returncode == 0, log[-2000:]
        assert not faults, "\n".join(faults)
        return tmp_path / "document.pdf"

    return compiled
