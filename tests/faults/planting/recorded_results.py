"""The results that tell a fault that matters from one that changes nothing.

Some cases of the record, and an example of every kind of result.

A case of the record is a command line. An example is what one public function returns, in every medium.
What is compared is the exit code, standard output and the files written; the words of a refusal are not.
"""

from __future__ import annotations

import contextlib
import hashlib
import io
import os
import sys
import tempfile
from collections import defaultdict
from collections.abc import Sequence
from pathlib import Path

from tests.record.cases import Case, all_cases
from tests.record.engines import Engine, preset_names
from tests.record.inputs import gather, stage

EACH = 3
"""Cases of one command with the same options and format: so many engines or pages of it."""


def names_of_examples() -> list[str]:
    """Return the results that are computed by a call, not by a command."""
    from tests.drawn import DRAWN
    from tests.results import EXAMPLES

    return [*(f"example/{name}" for name in EXAMPLES), *(f"drawn/{name}" for name in DRAWN)]


def cases(root: Path) -> dict[str, Case]:
    """Return the cases of the record that are run, by name: of each command, options and format a few."""
    inputs = gather(root)
    listed = _printed(("engines",))
    engines = [Engine(name, name, _printed(("engines", "--show", name))) for name in preset_names(listed)]
    engines += [
        Engine(name.removeprefix("engines/").removesuffix(".toml"), f"inputs/{name}", data.decode())
        for name, data in inputs.items()
        if name.startswith("engines/")
    ]
    groups: dict[tuple[str, str], list[Case]] = defaultdict(list)
    for case in all_cases(engines, inputs):
        folder, _, rest = case.name.partition("/")
        if folder not in ("help", "refusals"):
            # Sources have the target as their name; all else, the format as its suffix.
            groups[
                folder, rest.rpartition("/")[2] if folder == "emit" else rest.rpartition(".")[2]
            ].append(case)
        else:
            groups[folder, rest].append(case)
    chosen = {}
    for group in groups.values():
        steps = min(len(group), EACH)
        for step in range(steps):
            case = group[round(step * (len(group) - 1) / max(steps - 1, 1))]
            chosen[case.name] = case
    return chosen


def stage_inputs(root: Path, folder: Path) -> None:
    """Write what the cases read into a folder."""
    stage(gather(root), folder / "inputs")


def _printed(arguments: Sequence[str]) -> str:
    from symbalance.__main__ import main

    out = io.TextIOWrapper(io.BytesIO(), encoding="utf-8")
    with contextlib.redirect_stdout(out):
        sys.argv = ["symbalance", *arguments]
        try:
            main()
        except SystemExit as end:
            if end.code not in (None, 0):
                raise RuntimeError(f"symbalance {' '.join(arguments)}: exit code {end.code}") from None
        out.flush()
        return out.buffer.getvalue().decode()


def digest_of_example(name: str) -> str:
    """Return a digest of one example in every medium, or of one drawing or page."""
    from symbalance.document.result import to_html, to_json, to_latex, to_text
    from tests.drawn import DRAWN
    from tests.results import EXAMPLES

    if name.startswith("drawn/"):
        text = DRAWN[name.removeprefix("drawn/")]()
        return hashlib.sha256(text.encode("utf-8", "replace")).hexdigest()

    result = EXAMPLES[name.removeprefix("example/")]()
    parts = [write(result) for write in (to_json, to_text, to_latex, to_html)]
    parts += [repr(result), repr(result.records())]
    return hashlib.sha256("\0".join(parts).encode("utf-8", "replace")).hexdigest()


def digest_of_case(case: Case, inputs: Path) -> str:
    """Run one command line in this process and return a digest of its exit code and all it writes."""
    from symbalance.__main__ import main

    before = Path.cwd()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name) / "here"
        folder.mkdir()
        (folder / "inputs").symlink_to(inputs)
        os.chdir(folder)
        handles = [os.dup(1), os.dup(2)]
        out = os.open(Path(name) / "out", os.O_WRONLY | os.O_CREAT, 0o600)
        err = os.open(Path(name) / "err", os.O_WRONLY | os.O_CREAT, 0o600)
        sys.stdout.flush()
        sys.stderr.flush()
        streams = sys.stdout, sys.stderr
        os.dup2(out, 1)
        os.dup2(err, 2)
        sys.stdout = os.fdopen(os.dup(1), "w", encoding="utf-8")
        sys.stderr = os.fdopen(os.dup(2), "w", encoding="utf-8")
        code: object = 0
        try:
            sys.argv = ["symbalance", *case.arguments]
            if case.name.startswith("kept/"):
                with contextlib.suppress(SystemExit):  # the next run reads what this one keeps
                    main()
                sys.argv = ["symbalance", *case.arguments]
            main()
        except SystemExit as end:
            code = end.code
        except Exception as problem:  # a traceback is a result like another: the digest says so
            code = type(problem).__name__
        finally:
            for stream in (sys.stdout, sys.stderr):
                with contextlib.suppress(OSError, ValueError):
                    stream.close()
            sys.stdout, sys.stderr = streams
            for handle, number in zip(handles, (1, 2), strict=True):
                os.dup2(handle, number)
                os.close(handle)
            os.close(out)
            os.close(err)
            os.chdir(before)
        digest = hashlib.sha256(repr(code).encode())
        # What is kept goes by a digest of the program, which every fault changes.
        passed_over = {"inputs", "finished"}
        written = sorted(
            path
            for path in folder.rglob("*")
            if path.is_file() and not passed_over & set(path.relative_to(folder).parts)
        )
        for path in [Path(name) / "out", *written]:
            digest.update(f"\0{path.relative_to(name)}\0".encode() + path.read_bytes())
    return digest.hexdigest()
