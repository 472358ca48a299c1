"""Outcomes on disk: one NPZ file a speed, whole or not at all, told apart by a key of what made it."""

from __future__ import annotations

import hashlib
import io
import os
import stat
import tempfile
import zipfile
from contextlib import suppress
from dataclasses import fields
from pathlib import Path

import numpy as np

from symbalance.crankshaft.running.outcome import Outcome
from symbalance.errors import SymbalanceError

FORMAT = 1


def key_of(*parts: object) -> str:
    """Return a key that differs where the repr of some part does."""
    text = repr((FORMAT, parts))
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def file_of(folder: Path, rpm: float) -> Path:
    """Return where a speed's outcome lies."""
    return folder / f"{rpm:g}rpm.npz"


def save(folder: Path, key: str, outcome: Outcome) -> None:
    """Write an outcome under its key, replacing an older one in one step."""
    path = file_of(folder, outcome.rpm)
    content = io.BytesIO()
    np.savez_compressed(content, key=key, **{f.name: getattr(outcome, f.name) for f in fields(outcome)})
    try:
        folder.mkdir(parents=True, exist_ok=True)
        _replaced(path, content.getvalue())
    except OSError as problem:
        rule = f"cannot be written ({problem.strerror})"
        raise SymbalanceError(f"--output {path}", rule, "name a folder you may write to") from None


def _replaced(path: Path, data: bytes) -> None:
    handle, temporary = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
    try:
        with os.fdopen(handle, "wb") as stream:
            stream.write(data)
        os.chmod(temporary, stat.S_IMODE(path.parent.stat().st_mode) & 0o666)  # as open as its folder
        os.replace(temporary, path)
    except BaseException:
        with suppress(OSError):
            os.unlink(temporary)
        raise


def restored(folder: Path, key: str, rpm: float) -> Outcome | None:
    """Return a speed's outcome if one of the same key is there; None for any other file."""
    try:
        with np.load(file_of(folder, rpm), allow_pickle=False) as data:
            if str(data["key"]) != key:
                return None
            found = {f.name: data[f.name] for f in fields(Outcome)}
    except (OSError, ValueError, KeyError, EOFError, zipfile.BadZipFile):
        return None
    for name in ("rpm", "largest", "error", "seconds", "departure"):
        found[name] = float(found[name])
    for name in ("names", "units"):
        found[name] = tuple(str(x) for x in found[name])
    return Outcome(**found)
