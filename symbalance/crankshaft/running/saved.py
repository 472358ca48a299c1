"""Outcomes on disk: one NPZ file a speed, whole or not at all, under a key of all that it depends on.

The key is a digest of the engine (the content of the files it names), of how it is solved, of the webs'
compliances and of the program. A file under another key, or one that does not read, is not believed: the
speed is solved anew, and the caller learns why.
"""

from __future__ import annotations

import io
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

import numpy as np

from symbalance.crankshaft.digests import digest, program_digest
from symbalance.crankshaft.files.operation import speed_text
from symbalance.crankshaft.running.outcome import Outcome
from symbalance.errors import SymbalanceError
from symbalance.text.writing import write_file

FORMAT = 2
"""The number of this layout of a file, raised with every change of it."""
REMEDY = "name a folder you may write to"


@dataclass(frozen=True)
class Restored:
    """What a folder holds of a speed: its `outcome`, or None and `why` a file there is not believed."""

    outcome: Outcome | None
    why: str = ""


def key_of(*parts: object) -> str:
    """Return a key that differs where some part's content does, or the program (see `digests`)."""
    return digest(FORMAT, program_digest(), parts)


def file_of(folder: Path, rpm: float) -> Path:
    """Return where a speed's outcome lies: a file of its own for every speed.

    >>> file_of(Path("speeds"), 2200.0).name, file_of(Path("speeds"), 2200.001).name
    ('2200rpm.npz', '2200.001rpm.npz')
    """
    return folder / f"{speed_text(rpm)}rpm.npz"


def save(folder: Path, key: str, outcome: Outcome) -> None:
    """Write an outcome under its key, replacing an older one in one step."""
    path = file_of(folder, outcome.rpm)
    content = io.BytesIO()
    np.savez_compressed(content, key=key, **{f.name: getattr(outcome, f.name) for f in fields(outcome)})
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as problem:
        rule = f"cannot be written ({problem.strerror})"
        raise SymbalanceError(f"--output {path}", rule, REMEDY) from None
    write_file(path, content.getvalue(), what="--output ", remedy=REMEDY)


def restored(folder: Path, key: str, rpm: float) -> Restored:
    """Return a speed's outcome if one of the same key is there; else why a file there is not it."""
    path = file_of(folder, rpm)
    if not path.exists():
        return Restored(None)
    try:
        with np.load(io.BytesIO(path.read_bytes()), allow_pickle=False) as data:
            if str(data["key"]) != key:
                return Restored(None, "is of another engine, other settings or another program")
            return Restored(_outcome({f.name: data[f.name] for f in fields(Outcome)}))
    except Exception as problem:  # a damaged file raises anything, from zlib.error to TokenError
        return Restored(None, f"does not read ({type(problem).__name__})")


def _outcome(values: dict[str, Any]) -> Outcome:
    for field in fields(Outcome):
        if field.type == "float":
            values[field.name] = float(values[field.name])
        elif field.type == "str":
            values[field.name] = str(values[field.name])
        elif field.type == "tuple[str, ...]":
            values[field.name] = tuple(str(x) for x in values[field.name])
    return Outcome(**values)
