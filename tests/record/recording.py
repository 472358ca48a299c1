"""A record is made: the program of a tree runs every case, and what it says goes into a folder."""

from __future__ import annotations

import contextlib
import hashlib
import io
import itertools
import json
import os
import platform
import queue
import shutil
import subprocess
import sys
import tarfile
import tempfile
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass, field
from fnmatch import fnmatchcase
from importlib import metadata
from pathlib import Path

from .cases import Case, all_cases
from .engines import Engine, preset_names
from .inputs import digests, gather, stage, staged

ROOT = Path(__file__).resolve().parents[2]
MANIFEST = "manifest.json"
FORMAT = 1
"""Of the manifest: records of another format are refused, not misread."""
DEPENDENCIES = ("sympy", "mpmath", "numpy", "scipy", "numba", "matplotlib")


class RecordError(Exception):
    """What cannot be recorded or compared, in one line."""


@dataclass(frozen=True)
class Settings:
    """How cases are run."""

    jobs: int = os.cpu_count() or 1
    limit: int = 120
    """Seconds of processor time for a case: about ten times what the slowest takes."""
    hash_seed: int = 0
    only: tuple[str, ...] = ()
    seeds: Path | None = None


@dataclass
class Said:
    """What one case said, and how long it took."""

    exit: int | str
    files: dict[str, bytes] = field(default_factory=dict)
    seconds: float = 0.0


def write(folder: Path, commit: str | None = None, settings: Settings | None = None) -> dict[str, Said]:
    """Write the record of a commit, or of the tree as it is, into a folder; return what was said.

    The folder is replaced as a whole when all is done: a run that is interrupted leaves the old record.
    """
    settings = settings or Settings()
    folder = folder.resolve()
    refuse_foreign(folder)
    program = state(commit, "symbalance", "pyproject.toml")
    inputs_of = state(None, "tests", "derivations", "*.md")
    with program_tree(commit) as tree:
        manifest, said = record(tree, settings)
    manifest["program"] |= program
    manifest |= {"record": FORMAT, "inputs_of": inputs_of}
    folder.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=folder.parent, prefix=f".{folder.name}.") as nearby:
        new = Path(nearby) / "new"
        for one in said.values():
            for name, data in one.files.items():
                path = new / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(data)
        (new / MANIFEST).write_text(in_lines(manifest), encoding="utf-8")
        refuse_foreign(folder)  # it may have been filled while the cases ran
        if folder.exists():
            folder.rename(Path(nearby) / "old")
        new.rename(folder)
    return said


def refuse_foreign(folder: Path) -> None:
    """Refuse a folder that holds anything and is no record: writing would replace it."""
    if not folder.exists():
        return
    if not folder.is_dir():
        raise RecordError(f"{folder}: is not a folder")
    if any(folder.iterdir()):
        read_manifest(folder)


def read_manifest(folder: Path) -> dict:
    """Return the manifest of a record."""
    try:
        manifest = json.loads((folder / MANIFEST).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        raise RecordError(f"{folder}: holds no {MANIFEST} that can be read, so it is no record") from None
    if not isinstance(manifest, dict) or manifest.get("record") != FORMAT:
        raise RecordError(f"{folder}: {MANIFEST} is of another format than {FORMAT}: write it anew")
    return manifest


def in_lines(manifest: dict) -> str:
    """Return the manifest as JSON with a line a case, so that two of them can be read side by side."""
    head = {key: value for key, value in manifest.items() if key != "cases"}
    opening = json.dumps(head, indent=1, sort_keys=True, ensure_ascii=False)[:-2]
    cases = manifest["cases"]
    lines = [
        f"  {json.dumps(name, ensure_ascii=False)}: "
        f"{json.dumps(cases[name], ensure_ascii=False, sort_keys=True)}"
        for name in sorted(cases)
    ]
    return opening + ',\n "cases": {\n' + ",\n".join(lines) + "\n }\n}\n"


@contextlib.contextmanager
def program_tree(commit: str | None) -> Iterator[Path]:
    """Give the tree whose program is recorded: this one, or that of a commit, for as long as it takes."""
    if commit is None:
        yield ROOT
        return
    archive = git("archive", "--format=tar", resolved(commit), "symbalance")
    with tempfile.TemporaryDirectory(prefix="symbalance-record-") as folder:
        with tarfile.open(fileobj=io.BytesIO(archive)) as packed:
            packed.extractall(folder, filter="data")
        yield Path(folder).resolve()


def resolved(commit: str) -> str:
    """Return the whole name of a commit."""
    return (
        git("rev-parse", "--verify", "--quiet", "--end-of-options", f"{commit}^{{commit}}")
        .decode()
        .strip()
    )


def state(commit: str | None, *paths: str) -> dict[str, object]:
    """Return which commit some paths are of, and which of them differ from it."""
    if commit is not None:
        return {"commit": resolved(commit), "changed": []}
    try:
        head = resolved("HEAD")
    except RecordError:
        return {"commit": None, "changed": []}
    lines = git("-c", "core.quotePath=false", "status", "--porcelain", "-uall", "--", *paths)
    return {"commit": head, "changed": sorted(lines.decode().splitlines())}


def git(*arguments: str) -> bytes:
    """Return what git prints in this checkout."""
    try:
        done = subprocess.run(["git", *arguments], cwd=ROOT, capture_output=True, check=False)
    except FileNotFoundError:
        raise RecordError("git is not installed: the record of a commit needs it") from None
    if done.returncode:
        said = done.stderr.decode("utf-8", "replace").strip().splitlines()
        raise RecordError(f"git {arguments[0]} {arguments[-1]}: {said[-1] if said else 'not known here'}")
    return done.stdout


def record(tree: Path, settings: Settings) -> tuple[dict, dict[str, Said]]:
    """Run every case with the program of a tree; return the manifest, and what was said by case."""
    inputs = gather(ROOT, settings.seeds)
    sources = fingerprint(tree)
    with tempfile.TemporaryDirectory(prefix="symbalance-record-") as scratch_name:
        scratch = Path(scratch_name).resolve()
        stage(inputs, scratch / "inputs")
        with crew(tree, scratch, settings) as workers:
            version = workers.say(("--version",)).strip()
            cases = all_cases(engines_of(workers, inputs), inputs)
            if settings.only:
                cases = [c for c in cases if any(fnmatchcase(c.name, p) for p in settings.only)]
            if not cases:
                raise RecordError(f"--only {' '.join(settings.only)}: is the name of no case")
            said = workers.run_all(cases)
        if staged(scratch / "inputs") != inputs:
            raise RecordError("a case has written into its inputs: nothing after it can be believed")
    if fingerprint(tree) != sources:
        raise RecordError(f"{tree}: the program was changed while it ran: nothing here is of one program")
    manifest = {
        "program": {"version": version},
        "python": platform.python_version(),
        "dependencies": versions(),
        "settings": {"limit": settings.limit, "hash_seed": settings.hash_seed, "only": [*settings.only]},
        "inputs": digests(inputs),
        "cases": {
            case.name: {
                "argv": case.arguments,
                "exit": said[case.name].exit,
                "files": sorted(said[case.name].files),
            }
            for case in cases
        },
    }
    return manifest, said


def fingerprint(tree: Path) -> str:
    """Return one digest of all files of a tree's program, which imports some of them at every case."""
    digest = hashlib.sha256()
    for path in sorted((tree / "symbalance").rglob("*")):
        if path.is_file() and path.suffix != ".pyc":
            digest.update(f"{path.relative_to(tree).as_posix()}\0{path.stat().st_size}\0".encode())
            digest.update(path.read_bytes())
    return digest.hexdigest()


def versions() -> dict[str, str | None]:
    """Return the versions of what the program computes with, None where it is not installed."""
    found: dict[str, str | None] = {}
    for name in DEPENDENCIES:
        try:
            found[name] = metadata.version(name)
        except metadata.PackageNotFoundError:
            found[name] = None
    return found


def engines_of(workers: Crew, inputs: dict[str, bytes]) -> list[Engine]:
    """Return the engines to record: the program's presets, and the engine files among the inputs."""
    names = preset_names(workers.say(("engines",)))
    if not names:
        raise RecordError("`symbalance engines` lists no preset: the record would be silent about all")
    presets = [Engine(name, name, workers.say(("engines", "--show", name))) for name in names]
    files = [
        Engine(name.removeprefix("engines/").removesuffix(".toml"), f"inputs/{name}", data.decode())
        for name, data in inputs.items()
        if name.startswith("engines/")
    ]
    return presets + files


@contextlib.contextmanager
def crew(tree: Path, scratch: Path, settings: Settings) -> Iterator[Crew]:
    """Give the workers of a program, and end them."""
    workers = Crew(tree, scratch, settings)
    try:
        workers.start()
        yield workers
    finally:
        workers.end()


class Crew:
    """Worker processes of one program, and the queue they are taken from."""

    def __init__(self, tree: Path, scratch: Path, settings: Settings) -> None:
        self.tree, self.scratch, self.settings = tree, scratch, settings
        self.processes: list[subprocess.Popen[str]] = []
        self.idle: queue.SimpleQueue[subprocess.Popen[str]] = queue.SimpleQueue()
        self.numbers = itertools.count(1)
        # Longest first: one of these may lie within another.
        self.places = sorted(
            [(str(tree), "<program>"), (str(scratch), "<here>"), (sys.prefix, "<python>")],
            key=lambda place: -len(place[0]),
        )

    def start(self) -> None:
        """Start the workers; refuse a tree whose program is not what they import."""
        kept = {k: v for k, v in os.environ.items() if not k.startswith(("PYTHON", "LC_", "SYMBALANCE"))}
        environment = {
            **kept,
            "PYTHONPATH": str(self.tree),
            "PYTHONSAFEPATH": "1",  # this folder's modules must not be found in place of others
            "PYTHONUTF8": "1",
            "PYTHONDONTWRITEBYTECODE": "1",
            "PYTHONHASHSEED": str(self.settings.hash_seed),
            "OPENBLAS_NUM_THREADS": "1",  # a process with threads is not safely forked
            "OMP_NUM_THREADS": "1",
            "COLUMNS": "80",
            "LANG": "C.UTF-8",
        }
        command = [sys.executable, str(Path(__file__).with_name("worker.py")), str(self.tree)]
        for _ in range(self.settings.jobs):
            self.processes.append(
                subprocess.Popen(
                    command,
                    cwd=self.scratch,
                    env=environment,
                    stdin=subprocess.PIPE,
                    stdout=subprocess.PIPE,
                    encoding="utf-8",
                )
            )
        for process in self.processes:
            answer = self.answer(process)
            if "ready" not in answer:
                raise RecordError(f"{self.tree}: {answer['refused']}, not from there")
            self.idle.put(process)

    def end(self) -> None:
        """End the workers."""
        for process in self.processes:
            if process.stdin:
                with contextlib.suppress(OSError):
                    process.stdin.close()
            try:
                process.wait(timeout=5)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
            if process.stdout:
                process.stdout.close()

    def answer(self, process: subprocess.Popen[str]) -> dict:
        """Return a worker's next answer."""
        assert process.stdout is not None
        line = process.stdout.readline()
        if not line:
            raise RecordError("a worker has ended: the program cannot be imported, or memory ran out")
        return json.loads(line)

    def say(self, arguments: Sequence[str]) -> str:
        """Return what a command line prints that the record itself needs; refuse a refusal."""
        said = self.run(Case("out", tuple(arguments)))
        if said.exit != 0:
            reason = said.files.get("out.stderr", b"").decode("utf-8", "replace").strip().split("\n")[-1]
            raise RecordError(f"symbalance {' '.join(arguments)}: exit code {said.exit}: {reason}")
        return said.files.get("out", b"").decode("utf-8")

    def run_all(self, cases: Sequence[Case]) -> dict[str, Said]:
        """Run all cases, as many at a time as there are workers."""
        said: dict[str, Said] = {}
        with ThreadPoolExecutor(len(self.processes)) as pool:
            running = {pool.submit(self.run, case): case for case in cases}
            try:
                for done in as_completed(running):
                    said[running[done].name] = done.result()
                    if len(said) % 100 == 0:
                        print(f"record: {len(said)} of {len(cases)} cases", file=sys.stderr, flush=True)
            except BaseException:
                pool.shutdown(wait=False, cancel_futures=True)
                raise
        return {case.name: said[case.name] for case in cases}

    def take_folder(self) -> Path:
        """Return a folder for one case, with the inputs in it."""
        folder = self.scratch / f"case-{next(self.numbers)}" / "here"
        folder.mkdir(parents=True)
        (folder / "inputs").symlink_to(self.scratch / "inputs")
        return folder

    def run(self, case: Case) -> Said:
        """Run one case in a folder of its own, and remove the folder."""
        folder = self.take_folder()
        out, err = folder.parent / "out", folder.parent / "err"
        job = {
            "arguments": case.arguments,
            "folder": str(folder),
            "out": str(out),
            "err": str(err),
            "limit": self.settings.limit,
        }
        process = self.idle.get()
        try:
            assert process.stdin is not None
            with contextlib.suppress(BrokenPipeError):  # the worker has ended: so says its answer
                print(json.dumps(job), file=process.stdin, flush=True)
            answer = self.answer(process)
        finally:
            self.idle.put(process)
        said = Said(answer["exit"], seconds=answer["seconds"])
        if isinstance(said.exit, int):  # what was cut off is not the same twice
            self.keep(said, case.name, out.read_bytes())
            self.keep(said, f"{case.name}.stderr", err.read_bytes())
            for path in sorted(folder.rglob("*")):
                if path.is_file() and not path.is_symlink():
                    inside = path.relative_to(folder).as_posix()
                    self.keep(said, f"{case.name}.files/{inside}", path.read_bytes(), whole=True)
        shutil.rmtree(folder.parent)
        return said

    def keep(self, said: Said, name: str, data: bytes, whole: bool = False) -> None:
        """Keep what was said, less the paths of this machine; nothing is kept of nothing."""
        for place, token in self.places:
            data = data.replace(place.encode(), token.encode())
        if data or whole:
            said.files[name] = data


def summary(said: dict[str, Said]) -> str:
    """Return how many cases ended how, and which were slow or failed as no program should."""
    codes: dict[str, int] = {}
    for one in said.values():
        codes[str(one.exit)] = codes.get(str(one.exit), 0) + 1
    lines = [f"{len(said)} cases; exit " + ", ".join(f"{c}: {n}" for c, n in sorted(codes.items()))]
    seconds = sum(one.seconds for one in said.values())
    slow = sorted(said, key=lambda name: -said[name].seconds)[:5]
    named = ", ".join(f"{name} {said[name].seconds:.1f}" for name in slow)
    lines.append(f"{seconds:.0f} s of processor time; slowest: {named}")
    for name, one in said.items():
        crashed = b"Traceback (most recent call last)" in one.files.get(f"{name}.stderr", b"")
        if crashed or not isinstance(one.exit, int) or one.exit not in (0, 1, 2):
            lines.append(
                f"NOT AS IT SHOULD BE: {name}: exit {one.exit}{', traceback' if crashed else ''}"
            )
    return "\n".join(lines)
