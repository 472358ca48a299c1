"""Reading of text and TOML files, with errors that name the place and the reason."""

from __future__ import annotations

import os
import re
import stat
import sys
import tomllib
from contextlib import suppress
from decimal import Decimal
from errno import EBADF, ENXIO
from pathlib import Path
from typing import Any

from symbalance.errors import SymbalanceError

LARGEST_FILE = 1_000_000
STANDARD_INPUT = "-"
"""A name that stands for what is piped into the program."""
_READ = os.O_RDONLY
for _flag in ("O_NONBLOCK", "O_CLOEXEC", "O_NOCTTY", "O_BINARY"):
    # Without O_NONBLOCK the opening of a pipe waits for somebody to write to it, for ever perhaps.
    _READ |= getattr(os, _flag, 0)


def file_name(path: str | Path) -> str:
    """Return what errors call a file.

    >>> file_name("v6.toml"), file_name("-")
    ('v6.toml', 'standard input')
    """
    return "standard input" if str(path) == STANDARD_INPUT else str(path)


def read_text(
    path: str | Path,
    largest: int = LARGEST_FILE,
    what: str = "an engine file",
    *,
    pipes: bool = True,
) -> str:
    """Return a file's text, or refuse what is no file, missing, too large or not UTF-8.

    `what` is the file that is wanted, as a refusal names it; `-` is standard input, which is what a
    refusal offers for a pipe, but where the name cannot be `-` (`pipes` False).
    """
    place, data = file_name(path), read_bytes(path, largest, what, pipes=pipes)
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as problem:
        line = data[: problem.start].count(b"\n") + 1
        raise SymbalanceError(f"{place}:{line}", "is not UTF-8 text", "save it as UTF-8") from None


def read_bytes(
    path: str | Path,
    largest: int = LARGEST_FILE,
    what: str = "an engine file",
    *,
    pipes: bool = True,
) -> bytes:
    """Return a file's content, or refuse what is no file, missing or too large; see `read_text`.

    No more than `largest` bytes and one are ever read, and nothing waits: what is opened is asked what it
    is, so that no name can become another thing between the look and the reading. The null device is an
    empty file.
    """
    place = file_name(path)
    try:
        data = _piped(largest) if str(path) == STANDARD_INPUT else _content(path, largest, what, pipes)
    except (OSError, ValueError) as problem:
        if isinstance(problem, SymbalanceError):
            raise
        reason = getattr(problem, "strerror", None) or "not a usable path"
        raise SymbalanceError(place, f"cannot be read ({reason})", "check the path") from None
    if len(data) > largest:
        raise SymbalanceError(place, f"is larger than {largest} bytes", f"name {what} within that")
    return data


def _piped(largest: int) -> bytes:
    if sys.stdin is None:
        raise OSError(EBADF, "it is closed")
    # Piece by piece, through Python in between: a Ctrl-C that comes within one long read in C may wait
    # for more input, for ever perhaps.
    read: Any = getattr(sys.stdin.buffer, "read1", sys.stdin.buffer.read)
    pieces, length = [], 0
    while length <= largest and (piece := read(1 << 16)):
        pieces.append(piece)
        length += len(piece)
    return b"".join(pieces)[: largest + 1]


def _content(path: str | Path, largest: int, what: str, pipes: bool) -> bytes:
    place = str(path)
    try:
        descriptor = os.open(path, _READ)
    except OSError as problem:
        if problem.errno == ENXIO:
            raise SymbalanceError(place, "is a socket or a device, not a file", f"name {what}") from None
        if os.name == "nt" and os.path.isdir(path):
            raise SymbalanceError(place, "is a directory", f"name {what} in it") from None
        raise
    try:
        status = os.fstat(descriptor)
        if stat.S_ISDIR(status.st_mode):
            raise SymbalanceError(place, "is a directory", f"name {what} in it")
        if stat.S_ISFIFO(status.st_mode):
            remedy = f"name {what}" + (f", or pipe it in as {STANDARD_INPUT}" if pipes else "")
            raise SymbalanceError(place, "is a pipe, not a file", remedy)
        if not stat.S_ISREG(status.st_mode):
            if _is_null(status):
                return b""
            raise SymbalanceError(place, "is a device, not a file", f"name {what}")
        if status.st_size > largest:
            raise SymbalanceError(place, f"is larger than {largest} bytes", f"name {what} within that")
        return _read_up_to(descriptor, largest + 1)
    finally:
        os.close(descriptor)


def _read_up_to(descriptor: int, count: int) -> bytes:
    """Return what a file holds, `count` bytes at most: a file may grow, and some say they are empty."""
    pieces, length = [], 0
    while length < count and (piece := os.read(descriptor, min(count - length, 1 << 20))):
        pieces.append(piece)
        length += len(piece)
    return b"".join(pieces)


def _is_null(status: os.stat_result) -> bool:
    with suppress(OSError):
        return os.path.samestat(status, os.stat(os.devnull))
    return False


def toml_table(text: str, place: str, remedy: str = "correct the line") -> dict[str, Any]:
    """Return the table in a TOML text, decimals exact, or refuse what is none; `place` is its name."""
    try:
        # TOML calls every line ending a newline; tomllib takes only \n and \r\n.
        return tomllib.loads(text.replace("\r\n", "\n"), parse_float=Decimal)
    except tomllib.TOMLDecodeError as problem:
        position = re.search(r"\(at line (\d+), column (\d+)\)", str(problem))
        where = (
            f"{place}:{position[1]}:{position[2]}" if position else f"{place}:{text.count(chr(10)) + 1}"
        )
        message = re.sub(r"\s*\(at .*\)$", "", str(problem))
        raise SymbalanceError(where, f"is not valid TOML ({message})", remedy) from None
    except (ValueError, RecursionError):
        rule = "holds a number or a nesting beyond all bounds"
        raise SymbalanceError(place, rule, "write plain numbers and lists") from None
