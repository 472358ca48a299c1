"""What tests share: golden files (`pytest --update` rewrites them) and a LaTeX compiler."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import tempfile
from collections.abc import Callable
from pathlib import Path

import pytest

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
"""Small matrices: several threads, in several test processes, only wait for one another."""
if "NUMBA_CACHE_DIR" not in os.environ:  # compiled code of tests is not kept in the user's cache
    _numba = tempfile.TemporaryDirectory(prefix="symbalance-numba-")
    os.environ["NUMBA_CACHE_DIR"] = _numba.name

GOLDEN = Path(__file__).parent / "golden"
_FAULT = re.compile(r"^!.*|^Overfull \\hbox \(([\d.]+)pt.*|^LaTeX Warning: Reference.*", re.MULTILINE)


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--update", action="store_true", help="rewrite the golden files")


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
