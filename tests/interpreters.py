"""Runs the fast tests under every Python found on this machine, and with the oldest and newest packages.

    python -m tests.interpreters                  every combination that can be run here
    python -m tests.interpreters 3.12 oldest      some of them

Each runs in a fresh environment that uv makes in a temporary folder: Python 3.11 to 3.14 with the newest
packages that pyproject.toml allows, the oldest Python with the oldest ones, and the streams and the
locale of Windows emulated. A Python that is not found is named as not run; the exit code is 1 if some
tests fail, and 0 though a Python is missing, which no machine can be blamed for.

Windows is emulated only: its code page for streams and files (cp1252, cp932), and its path rules by
tests of their own in the fast core. No process of Windows runs here.
"""

from __future__ import annotations

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass, field
from pathlib import Path

HOME = Path(__file__).parent.parent
VERSIONS = ("3.11", "3.12", "3.13", "3.14")
ON_STREAMS = ("tests/bad_input", "tests/public", "tests/documents/test_ascii_spelling.py")
"""What is run under another code page: all that prints, reads or writes."""


@dataclass(frozen=True)
class Combination:
    """A Python with packages and an environment, under a name."""

    name: str
    version: str
    resolution: str = "highest"
    environment: dict[str, str] = field(default_factory=dict)
    tests: tuple[str, ...] = ()


def combinations() -> list[Combination]:
    """Return everything that is to be run."""
    windows = {"PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0", "LC_ALL": "C"}
    return [
        *(Combination(version, version) for version in VERSIONS),
        Combination("oldest", VERSIONS[0], "lowest-direct"),
        *(
            Combination(page, VERSIONS[0], "highest", windows | {"PYTHONIOENCODING": page}, ON_STREAMS)
            for page in ("cp1252", "cp932")
        ),
    ]


def interpreter(version: str) -> str | None:
    """Return a Python of that version: one of pyenv's, of uv's or of the search path; None if none is."""
    pyenv = Path(os.environ.get("PYENV_ROOT", Path.home() / ".pyenv")) / "versions"
    for folder in sorted(pyenv.glob(f"{version}.*"), reverse=True):
        if (folder / "bin/python").exists():
            return str(folder / "bin/python")
    uv = _uv("python", "find", "--no-project", version)
    if uv.returncode == 0 and _is_version(uv.stdout.strip(), version):
        return uv.stdout.strip()
    path = shutil.which(f"python{version}")
    return path if path and _is_version(path, version) else None


def _is_version(path: str, version: str) -> bool:
    program = "import sys; print('%d.%d' % sys.version_info[:2])"
    done = subprocess.run([path, "-c", program], capture_output=True, text=True, check=False)
    return done.stdout.strip() == version


def _uv(*arguments: str) -> subprocess.CompletedProcess[str]:
    own = HOME / ".uv/bin/uv"
    program = str(own) if own.exists() else shutil.which("uv")
    if program is None:
        raise SystemExit("uv is not installed: python3 -m pip install --target .uv uv")
    environment = {**os.environ, "PYTHONPATH": str(HOME / ".uv") if own.exists() else ""}
    return subprocess.run(
        [program, *arguments], capture_output=True, text=True, check=False, cwd=HOME, env=environment
    )


def run(combination: Combination, jobs: str) -> tuple[str, str]:
    """Return (how it ended, the last lines it printed): "passed", "failed" or "not run"."""
    python = interpreter(combination.version)
    if python is None:
        return "not run", f"Python {combination.version} is not on this machine"
    with tempfile.TemporaryDirectory(prefix="symbalance-python-") as folder:
        environment = str(Path(folder) / "venv")
        made = _uv("venv", "--quiet", "--python", python, environment)
        inside = str(Path(environment) / "bin/python")
        if made.returncode == 0:
            made = _uv(
                *("pip", "install", "--quiet", "--python", inside, "--editable", "."),
                *("--group", "test", "--resolution", combination.resolution),
            )
        if made.returncode != 0:
            return "not run", f"its packages cannot be installed: {_end(made.stderr, 4)}"
        command = [inside, "-m", "pytest", "-n", jobs, "-m", "not slow", "-p", "no:cacheprovider"]
        if combination.resolution != "highest":
            # What old packages are warned of by newer ones below them is between those.
            command += ["-o", "filterwarnings=default"]
        done = subprocess.run(
            [*command, *combination.tests],
            capture_output=True,
            encoding="utf-8",
            errors="replace",
            check=False,
            cwd=HOME,
            env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1", **combination.environment},
        )
    return ("passed" if done.returncode == 0 else "failed"), _end(done.stdout, 40)


def _end(text: str, lines: int) -> str:
    return "\n    ".join(text.strip().splitlines()[-lines:])


def main() -> int:
    """Run the combinations asked for, print a line for each, and return the exit code."""
    everything = {combination.name: combination for combination in combinations()}
    parser = argparse.ArgumentParser(prog="python -m tests.interpreters", description=__doc__)
    parser.add_argument("names", nargs="*", choices=[[], *everything], metavar="NAME")
    parser.add_argument("--jobs", default="2", help="test processes; default: 2")
    options = parser.parse_args()
    ends = []
    for name in options.names or everything:
        start = time.monotonic()
        end, text = run(everything[name], options.jobs)
        ends.append(end)
        print(f"{name:8} {end:8} {time.monotonic() - start:5.0f} s", flush=True)
        if end != "passed":
            print(f"    {text}", flush=True)
    return int("failed" in ends)


if __name__ == "__main__":
    sys.exit(main())
