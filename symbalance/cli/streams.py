"""Set-up of stdin, stdout and stderr: closed ones replaced, pipes in UTF-8 unless set otherwise."""

from __future__ import annotations

import io
import os
import sys
from contextlib import suppress
from errno import EBADF
from typing import Any, TextIO


def prepare() -> None:
    """Make stdin, stdout and stderr usable whatever the program was started with."""
    _fill_descriptors()
    if sys.stdout is None:
        sys.stdout = _Closed()
    if sys.stderr is None:
        sys.stderr = open(os.devnull, "w", encoding="utf-8")  # noqa: SIM115
    sys.stderr = _Forgiving(sys.stderr)
    _choose_encoding(sys.stdout)


def _fill_descriptors() -> None:
    """Open nothing on a closed descriptor: the next file opened would take the place of stdout."""
    for descriptor in (0, 1, 2):
        try:
            os.fstat(descriptor)
        except OSError:
            with suppress(OSError):
                os.open(os.devnull, os.O_RDWR)


def _choose_encoding(stream: Any) -> None:
    """Write UTF-8 to a pipe or a file, unless PYTHONIOENCODING or a locale with letters asks for another.

    A pipe on Windows has the code page, and the C locale ASCII, because nobody chose.
    """
    if not isinstance(stream, io.TextIOWrapper) or os.environ.get("PYTHONIOENCODING", "").split(":")[0]:
        return
    with suppress(OSError, ValueError):
        unchosen = os.name == "nt" or stream.encoding.lower() in ("ascii", "us-ascii", "ansi_x3.4-1968")
        if unchosen and not stream.isatty():
            stream.reconfigure(encoding="utf-8", errors="strict")


class _Closed(io.TextIOBase):
    """A stdout that is not there: writing to it is refused, as it is to a full disk."""

    encoding = "utf-8"  # type: ignore[assignment]

    def write(self, _text: str) -> int:
        raise OSError(EBADF, "it is closed")


class _Forgiving:
    """A stderr whose own failure stops nothing: progress that nobody can read is not the result."""

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream

    def __getattr__(self, name: str) -> Any:
        return getattr(self._stream, name)

    def write(self, text: str) -> int:
        with suppress(OSError, ValueError):
            self._stream.write(text)
        return len(text)

    def flush(self) -> None:
        with suppress(OSError, ValueError):
            self._stream.flush()
