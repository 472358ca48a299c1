"""Real commands, killed at moments nobody chose, leave the old or the new, and the next run works.

`tried` counts the kills that came before the command had ended, `mishandled` what is neither the old
results nor the new ones, `lost` what a run after it could not make good.
"""

from __future__ import annotations

import os
import random
import shutil
import signal
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.cranks import sheet, written

pytestmark = [
    pytest.mark.rare,
    pytest.mark.slow,
    pytest.mark.skipif(os.name != "posix", reason="signals as POSIX has them"),
]
KILLS = 32
Snapshot = dict[str, bytes]


def command(*arguments: str) -> list[str]:
    return [sys.executable, "-m", "symbalance", *arguments]


def snapshot(folder: Path, names: set[str] | None = None) -> Snapshot:
    """Return what a reader finds under plain names, in the folder itself."""
    paths = [path for path in folder.iterdir() if not path.name.startswith(".") and path.is_file()]
    return {path.name: path.read_bytes() for path in paths if names is None or path.name in names}


def kill_at_moments(
    folder: Path, old: Snapshot, new: Snapshot, run: list[str], judge: Callable[[Snapshot], bool]
) -> Counter[str]:
    """Kill a command again and again, in the second half of its time more often than in the first."""
    seed, counts = random.Random(17), Counter({"tried": 0, "mishandled": 0, "lost": 0, "new": 0})
    started = time.monotonic()
    subprocess.run(run, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
    whole = time.monotonic() - started
    assert snapshot(folder) == new
    while counts["tried"] < KILLS:
        restore(folder, old)
        with subprocess.Popen(run, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
            time.sleep(whole * seed.choice((seed.uniform(0, 1), seed.uniform(0.6, 1.1))))
            process.send_signal(signal.SIGKILL)
        if process.returncode != -signal.SIGKILL:  # it had ended before
            assert snapshot(folder) == new
            whole *= 0.98
            continue
        counts["tried"] += 1
        left = snapshot(folder)
        counts["mishandled"] += not judge(left)
        counts["new"] += left == new
        if counts["tried"] % 8 == 0:
            again = subprocess.run(run, capture_output=True, check=False)
            hidden = [path.name for path in folder.iterdir() if path.name.startswith(".")]
            counts["lost"] += snapshot(folder) != new or bool(hidden) or again.returncode not in (0, 1)
    print(dict(counts))
    return counts


def restore(folder: Path, old: Snapshot) -> None:
    """Put the old results back, and leave the stores: what is saved of a speed persists."""
    for path in folder.iterdir():
        if path.is_symlink() or path.is_file():
            path.unlink()
        elif path.name.startswith("."):
            shutil.rmtree(path)
    for name, content in old.items():
        (folder / name).write_bytes(content)


def test_balance_is_killed(tmp_path):
    """One file: the old one or the new one."""
    out = tmp_path / "out.txt"
    out.write_bytes(b"old")
    old = snapshot(tmp_path)
    run = command("balance", "v12-60", "--order", "6", "-o", str(out))
    subprocess.run(run, check=True)
    new = snapshot(tmp_path)
    counts = kill_at_moments(tmp_path, old, new, run, lambda left: left in (old, new))
    assert (counts["mishandled"], counts["lost"]) == (0, 0)


def test_emit_is_killed(tmp_path):
    """Two files: of one generation, or of two that the compiler refuses to put together."""
    out = str(tmp_path / "e.c")
    subprocess.run(command("emit", "v8-90", "--target", "c", "-o", out), check=True)
    old = snapshot(tmp_path)
    run = command(*f"emit v8-90 --target c --outputs couple.vertical,couple.lateral -o {out}".split())
    subprocess.run(run, check=True)
    new = snapshot(tmp_path)
    compiler = shutil.which("gcc") or shutil.which("cc")

    def judge(left: Snapshot) -> bool:
        if left in (old, new) or compiler is None:
            return left in (old, new)
        compiled = subprocess.run(
            [compiler, "-std=c99", "-c", "e.c", "-o", os.devnull],
            cwd=tmp_path,
            capture_output=True,
            check=False,
        )
        return all(left[name] in (old[name], new[name]) for name in old) and compiled.returncode != 0

    counts = kill_at_moments(tmp_path, old, new, run, judge)
    assert (counts["mishandled"], counts["lost"]) == (0, 0)


def test_crankshaft_is_killed(tmp_path):
    """A folder of results: those of the old run or of the new one, and the saved speeds stay."""
    for name in "ab":
        (tmp_path / name).mkdir()
    engine, other = written(tmp_path / "a", sheet()), written(tmp_path / "b", sheet(young="young = 190"))
    out = tmp_path / "out"
    quick = ["--webs", "nominal", "--steps", "120", "--about", "centre", "--no-plots"]
    quick += ["--rpm", "1000,1500"]
    runs = [command("crankshaft", str(path), *quick, "-o", str(out)) for path in (engine, other)]
    subprocess.run(runs[0], stdout=subprocess.DEVNULL, check=False)
    old = snapshot(out)
    (out / "notes.txt").write_bytes(b"mine")
    old["notes.txt"] = b"mine"
    subprocess.run(runs[1], stdout=subprocess.DEVNULL, check=False)
    new = snapshot(out)
    assert old.keys() == new.keys()
    assert old["report.json"] != new["report.json"]
    counts = kill_at_moments(out, old, new, runs[1], lambda left: left in (old, new))
    assert (counts["mishandled"], counts["lost"]) == (0, 0)
    assert len(list((out / "speeds").iterdir())) == 2
