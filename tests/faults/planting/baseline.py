"""What runs without any fault: the lines of each recorded result, the functions of each fast test.

It takes minutes and is kept, by the content of the files it depends on, in `.pytest_cache/planting`.
"""

from __future__ import annotations

import hashlib
import json
import sys
import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from .nearest_tests import nearest_files
from .trees import ROOT, Crew, PlantingError, Tree, files_of

STORE = ROOT / ".pytest_cache" / "planting"
LIMIT = 1200.0
"""Seconds for one batch of results or one file of tests."""
BATCHES = 12


@dataclass
class Baseline:
    """What is known of the program without a fault."""

    commands: dict[str, list[str] | None]
    digests: dict[str, str]
    seconds: dict[str, float]
    lines: dict[str, dict[str, list[int]]]
    """By result: by module, the lines it runs."""
    tests: dict[str, dict[str, Any]]
    """By test: seconds, functions (module, name, first line), and the outcome if it is no success."""

    def results_at(self, path: str, line: int, statement: int, at_import: bool) -> list[str]:
        """Return the results that run a line, the cheapest first."""
        module = path.removeprefix("symbalance/")
        direct, beside = [], []
        for name, ran in self.lines.items():
            numbers = ran.get(module)
            if numbers is None:
                continue
            (direct if line in numbers or statement in numbers else beside).append(name)
        # What runs at import is noted for the first result only; and a value may be kept for later ones.
        near = direct + beside if at_import or len(direct) < 3 else direct
        return sorted(near, key=lambda name: (name not in direct, self.seconds[name])) if direct else []


def measure(rooms: Iterable[str], crew: Crew, say: Callable[[str], None]) -> Baseline:
    """Return the baseline, of the tests near some rooms, as far as possible from what is kept."""
    names = files_of(ROOT)
    library = digest_of(name for name in names if name.startswith("symbalance/"))
    inputs = digest_of(
        name
        for name in names
        if name.startswith(
            ("tests/record/", "tests/hand/", "tests/results", "tests/cranks", "tests/faults/planting/rec")
        )
        or (name.startswith(("derivations/", "tests/")) and name.endswith(".toml"))
    )
    results = recall(f"results-{library}-{inputs}", lambda: _results(crew, say))
    shared = digest_of(
        name
        for name in names
        if name.startswith("tests/") and name.count("/") == 1 and name.endswith(".py")
    )
    tests: dict[str, dict[str, Any]] = {}
    units = sorted({file for room in rooms for file in nearest_files(room)})
    keys = {}
    for unit in units:
        own = digest_of([unit]) if unit.endswith(".py") else ""
        keys[unit] = f"tests-{library}-{shared}-{own}-{unit.replace('/', '+')}"
    lacking = [unit for unit in units if not (STORE / f"{keys[unit]}.json").exists()]
    if lacking:
        say(f"baseline: the fast tests of {len(lacking)} files")
        crew.run_all({unit: _covered(unit, keys[unit]) for unit in lacking})
    for unit in units:
        tests |= read(keys[unit])
    return Baseline(tests=tests, **results)


def _covered(unit: str, key: str) -> Callable[[Tree], None]:
    def job(tree: Tree) -> None:
        answer = tree.do("cover", LIMIT, files=[unit])
        if "value" not in answer:
            raise PlantingError(f"{unit}: its tests did not come to an end without a fault: {answer}")
        keep(key, answer["value"])  # at once: a break costs what was being measured, no more

    return job


def _results(crew: Crew, say: Callable[[str], None]) -> dict[str, Any]:
    answer = crew.trees[0].do("list", LIMIT)
    if "value" not in answer:
        raise PlantingError(f"the recorded results cannot be listed: {answer}")
    commands: dict[str, list[str] | None] = answer["value"]
    say(f"baseline: {len(commands)} results and the lines they run")
    start = time.monotonic()
    names = sorted(commands)
    batches = {n: {name: commands[name] for name in names[n::BATCHES]} for n in range(BATCHES)}

    def traced(results: dict[str, Any]) -> Callable[[Tree], Any]:
        return lambda tree: tree.do("results", LIMIT, results=results, lines=True)

    value: dict[str, Any] = {}
    for each in crew.run_all({n: traced(batch) for n, batch in batches.items()}).values():
        if "value" not in each:
            raise PlantingError(f"a recorded result did not come to an end without a fault: {each}")
        value |= each["value"]["value"]
    say(f"baseline: {len(value)} results in {time.monotonic() - start:.0f} s")
    return {
        "commands": commands,
        "digests": {name: one["digest"] for name, one in value.items()},
        "seconds": {name: one["seconds"] for name, one in value.items()},
        "lines": {name: one["lines"] for name, one in value.items()},
    }


def digest_of(names: Iterable[str]) -> str:
    """Return a digest of the content of files of the checkout."""
    digest = hashlib.sha256(sys.version.encode())
    for name in sorted(names):
        path = ROOT / name
        digest.update(f"{name}\0".encode())
        for file in [path] if path.is_file() else []:
            digest.update(file.read_bytes())
    return digest.hexdigest()[:12]


def recall(key: str, compute: Callable[[], Any]) -> Any:
    """Return what is kept under a key, computed if there is nothing."""
    if not (STORE / f"{key}.json").exists():
        keep(key, compute())
    return read(key)


def keep(key: str, value: Any) -> None:
    """Keep a value, whole or not at all."""
    STORE.mkdir(parents=True, exist_ok=True)
    new = STORE / f"{key}.new"
    new.write_text(json.dumps(value), encoding="utf-8")
    new.rename(STORE / f"{key}.json")


def read(key: str) -> Any:
    """Return what is kept under a key."""
    path: Path = STORE / f"{key}.json"
    return json.loads(path.read_text(encoding="utf-8"))
