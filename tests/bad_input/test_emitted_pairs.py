"""A C source compiles with the header that was written with it, and with no other of its name."""

from __future__ import annotations

import re
import shutil
import subprocess
from hashlib import sha256
from itertools import product
from pathlib import Path

import pytest

from symbalance.cli import run

COMPILER = shutil.which("gcc") or shutil.which("cc")
GENERATIONS = {
    "vertical": "v8-90 --outputs couple.vertical --order 2",
    "lateral": "v8-90 --outputs couple.lateral --order 2",
    "both": "v8-90 --outputs couple.vertical,couple.lateral --order 2",
    "another ratio": "v8-90 --outputs couple.vertical --order 2 --ratio 3.5",
    "another engine": "inline-4 --outputs force.vertical --order 2",
}


def emit(folder: Path, generation: str) -> Path:
    folder.mkdir()
    assert (
        run(["emit", *GENERATIONS[generation].split(), "--target", "c", "-o", str(folder / "e.c")]) == 0
    )
    return folder


def compiled(folder: Path) -> subprocess.CompletedProcess[str]:
    assert COMPILER is not None
    command = [COMPILER, "-std=c99", "-O0", "-DE_SELF_TEST", "e.c", "-lm", "-o", "test"]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)


@pytest.mark.slow
@pytest.mark.skipif(COMPILER is None, reason="no C compiler")
def test_every_mixture_of_two_generations_is_refused_by_the_compiler(tmp_path):
    folders = {name: emit(tmp_path / name.replace(" ", "-"), name) for name in GENERATIONS}
    for header, source in product(GENERATIONS, repeat=2):
        mixed = tmp_path / "mixed"
        shutil.rmtree(mixed, ignore_errors=True)
        mixed.mkdir()
        shutil.copy(folders[header] / "e.h", mixed)
        shutil.copy(folders[source] / "e.c", mixed)
        done = compiled(mixed)
        if header == source:
            assert done.returncode == 0, done.stderr
            assert subprocess.run([mixed / "test"], check=False).returncode == 0
        else:
            assert done.returncode != 0
            assert "e.h is not the header that was written with this source" in done.stderr


@pytest.mark.slow
@pytest.mark.skipif(COMPILER is None, reason="no C compiler")
def test_a_header_of_before_marks_is_refused_too(tmp_path):
    folder = emit(tmp_path / "new", "vertical")
    text = (folder / "e.h").read_text(encoding="utf-8")
    (folder / "e.h").write_text(re.sub(r"#define E_MARK.*\n", "", text), encoding="utf-8")
    assert "is not the header" in compiled(folder).stderr


def test_the_mark_is_the_contents_digest_and_the_same_in_both(tmp_path):
    marks = {}
    for number, name in enumerate([*GENERATIONS, "vertical"]):
        folder = emit(tmp_path / str(number), name)
        header, source = ((folder / f"e.{end}").read_text(encoding="utf-8") for end in "hc")
        (defined,) = re.findall(r"#define E_MARK (0x[0-9a-f]{15}ULL)", header)
        assert re.findall(r"E_MARK != (\S+)", source) == [defined]
        assert marks.setdefault(name, defined) == defined
        unmarked = "\0".join(text.replace(defined, "0x---------------ULL") for text in (header, source))
        assert sha256(unmarked.encode()).hexdigest()[:15] == defined[2:-3]
    assert len(set(marks.values())) == len(GENERATIONS)
