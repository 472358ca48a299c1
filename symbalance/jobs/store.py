"""Store of finished results: a folder with one file a result, believed only under the same key.

A file opens with one line of JSON that says its format, its key, and the length and the sha256 of the
payload that follows. The key is a digest of all that the result depends on, the program among it. What
does not fit (another key, a length or a content that differs) is not believed: the caller learns why, and
computes anew. The payload is bytes that the caller encodes, as JSON or NPZ: never something that runs
when it is read, for a store may come from somewhere else.

A file is written whole or not at all. Two processes that work on one store can at worst compute the same
result twice: each reads what is there when it looks, and a file put in another's place is as whole.
"""

from __future__ import annotations

import json
import os
import re
from collections.abc import Callable
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path
from typing import Any, Generic, TypeVar

from symbalance.errors import SymbalanceError
from symbalance.jobs.digests import digest, program_digest
from symbalance.text.files import read_bytes
from symbalance.text.writing import write_file

FORMAT = 1
"""The number of this layout of a file, raised with every change of it."""
LONGEST_HEADER = 1000
LARGEST = 2**30
"""Bytes: a file beyond is none of ours, and is not read into memory."""
ENDING = ".result"
REMEDY = "name a folder you may write to"
_SLOT = re.compile(r"[A-Za-z0-9][A-Za-z0-9.+-]{0,99}")
Value = TypeVar("Value")


@dataclass(frozen=True)
class Codec(Generic[Value]):
    """How a result becomes bytes and is read back; `decode` raises anything on what is no such bytes.

    `disagreement` returns why a result that was read cannot be that of a job's value, "" if it can;
    `keeps` whether a result is one that another run would come to as well.
    """

    encode: Callable[[Value], bytes]
    decode: Callable[[bytes], Value]
    disagreement: Callable[[Any, Value], str] = lambda value, result: ""
    keeps: Callable[[Value], bool] = lambda result: True


class DamagedError(Exception):
    """Bytes are not those that were written; the text says in what."""


JSON: Codec[Any] = Codec(
    lambda value: json.dumps(value, ensure_ascii=True, separators=(",", ":")).encode("ascii"), json.loads
)
"""Results of numbers, texts, lists and dicts whose keys are texts."""


def _decoded(payload: bytes) -> str | bytes:
    kind, content = payload[:1], payload[1:]
    if kind not in (b"t", b"b"):
        raise DamagedError("is neither a text nor bytes")
    return content.decode("utf-8") if kind == b"t" else content


TEXT_OR_BYTES: Codec[str | bytes] = Codec(
    lambda value: b"b" + value if isinstance(value, bytes) else b"t" + value.encode("utf-8"), _decoded
)
"""Results that are files as they are written: texts, or bytes, as a workbook's are."""


@dataclass(frozen=True)
class Saved:
    """What a store has under a key: the payload, or None and the `reason` why a file is not valid.

    The reason is empty where there is no file at all.
    """

    payload: bytes | None
    reason: str = ""


@dataclass(frozen=True)
class Store:
    """Finished results in a folder, each in the file of its `slot`, which is its key or a plain name.

    With a name for its slot a result replaces the one that was computed before under another key, so
    that a folder does not grow with every change of the program.
    """

    folder: Path
    what: str = "store"
    """What a refusal calls the folder: the option that named it."""

    def __post_init__(self) -> None:
        object.__setattr__(self, "folder", Path(self.folder))

    def path(self, slot: str) -> Path:
        """Return where a result lies.

        >>> Store(Path("speeds")).path("2200rpm").name
        '2200rpm.result'
        """
        if not _SLOT.fullmatch(slot):
            raise ValueError(f"no slot of a store: {slot!r}")
        return self.folder / f"{slot}{ENDING}"

    def load(self, key: str, slot: str = "") -> Saved:
        """Return the result of a key if it is there; else why the file in its place is not it."""
        path = self.path(slot or key)
        if not os.path.lexists(path):
            return Saved(None)
        try:
            content = read_bytes(path, LARGEST, "a folder of your own", pipes=False)
        except SymbalanceError as problem:
            return Saved(None, problem.rule)
        return _payload(content, key)

    def save(self, key: str, payload: bytes, slot: str = "") -> None:
        """Put a result in its place in one step; refused where the folder cannot be written."""
        path = self.path(slot or key)
        header = {"symbalance": "result", "format": FORMAT, "key": key, "length": len(payload)}
        line = json.dumps({**header, "sha256": sha256(payload).hexdigest()}) + "\n"
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
        except OSError as problem:
            rule = f"cannot be written ({problem.strerror})"
            raise SymbalanceError(f"{self.what} {path}", rule, REMEDY) from None
        # Not synced: what a loss of power leaves behind is recognised by its digest, and computed anew.
        write_file(
            path, line.encode("ascii") + payload, what=f"{self.what} ", remedy=REMEDY, lasting=False
        )


def key_of(*parts: object) -> str:
    """Return a key that differs where some part's content does, or the program (see `digests`)."""
    return digest(FORMAT, program_digest(), parts)


def _payload(content: bytes, key: str) -> Saved:
    """Return what a file holds under a key; its length and its digest are checked first."""
    line, newline, payload = content.partition(b"\n")
    try:
        header = json.loads(line) if newline and len(line) <= LONGEST_HEADER else None
    except (ValueError, RecursionError):
        header = None
    if not isinstance(header, dict) or header.get("symbalance") != "result":
        return Saved(None, "is no result of symbalance, or damaged")
    if header.get("format") != FORMAT:
        return Saved(None, "is of another version")
    if header.get("key") != key:
        return Saved(None, "is of another input, other settings or another program")
    if header.get("length") != len(payload) or header.get("sha256") != sha256(payload).hexdigest():
        return Saved(None, "is damaged")
    return Saved(payload)
