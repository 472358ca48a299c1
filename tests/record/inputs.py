"""What the recorded program reads: engine files, hand derivations, weighed parts, a pressure trace.

All of it comes from the checkout that the record command stands in, not from the commit that is
recorded: two programs are compared on the same inputs, wherever their trees keep such files.
"""

from __future__ import annotations

import hashlib
from math import cos, pi
from pathlib import Path

from .engines import engine_files

PAGES = ("tests/hand", "derivations/checked")
SUFFIXES = (".tex", ".md", ".txt", ".toml")
MOST_CYLINDERS = 18


def gather(root: Path, seeds: Path | None = None) -> dict[str, bytes]:
    """Return every input by its path under `inputs/`, which is how the command line names it."""
    files = {f"engines/{key}.toml": text.encode() for key, text in engine_files(root).items()}
    for folder in PAGES:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in SUFFIXES and path.name != "README.md" and path.is_file():
                inside = path.relative_to(root / folder).as_posix()
                files[f"pages/{Path(folder).name}/{inside}"] = path.read_bytes()
    for path in sorted(seeds.glob("*.txt")) if seeds else ():
        files[f"pages/seeds/{path.name}"] = path.read_bytes()
    for count in range(1, MOST_CYLINDERS + 1):
        files[f"parts/{count}.csv"] = parts(count).encode()
    for strokes in (4, 2):
        files[f"pressure-{strokes}.csv"] = pressure(strokes).encode()
    return dict(sorted(files.items()))


def stage(files: dict[str, bytes], folder: Path) -> None:
    """Write the inputs into a folder."""
    for name, data in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)


def digests(files: dict[str, bytes]) -> dict[str, str]:
    """Return the SHA-256 of every input: what tells two records' inputs apart."""
    return {name: hashlib.sha256(data).hexdigest() for name, data in files.items()}


def staged(folder: Path) -> dict[str, bytes]:
    """Return what a folder of inputs holds now."""
    paths = (path for path in folder.rglob("*") if path.is_file())
    return dict(sorted((path.relative_to(folder).as_posix(), path.read_bytes()) for path in paths))


def pages(files: dict[str, bytes]) -> list[str]:
    """Return the hand derivations among the inputs: documents, not what stands beside them."""
    return [
        name
        for name in files
        if name.startswith("pages/") and not name.endswith(".toml") and not is_verdict_page(name, files)
    ]


def is_verdict_page(name: str, files: dict[str, bytes]) -> bool:
    """Return whether a Markdown file is a checker's report on a document, not a document."""
    return name.startswith("pages/checked/") and name.endswith(".md")


def parts(count: int) -> str:
    """Return a list of weighed pistons and rods, spread as a batch of castings is, all unlike.

    >>> print(parts(2), end="")
    name,piston,rod_reciprocating,rod_rotating
    a,0.4530,0.1810,0.4210
    b,0.4479,0.1783,0.4254
    """
    rows = ["name,piston,rod_reciprocating,rod_rotating"]
    for i in range(count):
        piston, sliding, turning = 4530 - 51 * i % 97, 1810 - 27 * i % 53, 4210 + 44 * i % 89
        rows.append(f"{chr(97 + i)},{piston / 1e4:.4f},{sliding / 1e4:.4f},{turning / 1e4:.4f}")
    return "\n".join(rows) + "\n"


def pressure(strokes: int) -> str:
    """Return a pressure trace over a cycle: smooth, 1 bar and more, 60 bar a little after the top."""
    rows = ["degrees after firing top dead centre,bar absolute"]
    for angle in range(-90 * strokes, 90 * strokes, 5):
        hill = (1 + cos((angle - 15) * pi / 180)) / 2 if abs(angle - 15) < 180 else 0
        rows.append(f"{angle},{1 + 59 * hill**4:.4f}")
    return "\n".join(rows) + "\n"
