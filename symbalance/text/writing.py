"""Atomic writing of files: whole or not at all, even if the program is ended meanwhile.

The content goes into a temporary file in the folder of its target, which then takes the target's name in
one step: who opens that name finds the old file or the new one, never a part. Of several files all are
whole before the first is put in place; an end between two of those steps leaves some new and some old.
"""

from __future__ import annotations

import os
import stat
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import NamedTuple

from symbalance.errors import SymbalanceError

REMEDY = "name a file in a folder you may write to"


def write_file(
    path: str | Path,
    content: str | bytes,
    *,
    what: str = "file ",
    remedy: str = REMEDY,
    permissions: int | None = None,
    lasting: bool = True,
) -> None:
    """Write one file, replacing an older one in one step; see `write_files`."""
    write_files({str(path): content}, what=what, remedy=remedy, permissions=permissions, lasting=lasting)


def write_files(
    contents: Mapping[str, str | bytes],
    *,
    what: str = "file ",
    remedy: str = REMEDY,
    permissions: int | None = None,
    lasting: bool = True,
) -> None:
    """Write files, texts (as UTF-8) or bytes, all of them whole before the first is put in place.

    A link is followed: its target is replaced, and the link stays. A device or a pipe is written to. A
    file that is replaced keeps its permissions; a new one gets those that `open` gives, or `permissions`.
    With `lasting` the content is on the disk before it takes its name, so that a computer that loses its
    power leaves no empty file. What cannot be written is refused as `what` + its name, with `remedy`;
    then, as after any other exception, no temporary file is left.
    """
    staged: list[_Staged] = []
    name = ""
    try:
        for name, content in contents.items():
            data = content.encode("utf-8") if isinstance(content, str) else content
            if not _written_through(name, data):
                staged.append(_Staged.beside(name))
                staged[-1].fill(data, permissions, lasting)
        while staged:
            name = staged[0].name
            os.replace(staged[0].temporary, staged[0].target)
            staged.pop(0)
    except (OSError, ValueError) as problem:
        reason = getattr(problem, "strerror", None) or str(problem)
        raise SymbalanceError(f"{what}{name}", f"cannot be written ({reason})", remedy) from None
    finally:
        for one in staged:
            with suppress(OSError):
                os.unlink(one.temporary)


def _written_through(name: str, data: bytes) -> bool:
    """Write to a device or a pipe, which has nothing to replace; False of a file, there or not.

    The name is taken as it stands: /dev/stdout leads to no path where a pipe is behind it.
    """
    try:
        mode = os.stat(name).st_mode
    except FileNotFoundError:
        return False
    if stat.S_ISDIR(mode):
        raise OSError(0, "it is a directory")
    if stat.S_ISREG(mode):
        return False
    Path(name).write_bytes(data)
    return True


class _Staged(NamedTuple):
    """A file to be written: its name as given, its target, and the temporary file beside that.

    Neither a dataclass nor `secrets` here: every command imports this, `--help` too, and they load a
    dozen modules of the standard library.
    """

    name: str
    target: str
    temporary: str

    @classmethod
    def beside(cls, name: str) -> _Staged:
        """Return a temporary name of its own in the target's folder; nothing is written yet.

        Of the target's name only a beginning is in it, so that it is no longer than systems take.
        """
        target = os.path.realpath(name)
        folder, base = os.path.split(target)
        return cls(name, target, os.path.join(folder, f".{base[:20]}.{os.urandom(8).hex()}.part"))

    def fill(self, data: bytes, permissions: int | None, lasting: bool) -> None:
        """Write the temporary file, with the permissions that the target shall have."""
        if os.path.exists(self.target):
            if not os.access(self.target, os.W_OK):
                raise OSError(0, "it is write-protected")
            if permissions is None:
                permissions = stat.S_IMODE(os.stat(self.target).st_mode)
        flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0)
        # The system applies the user's mask to the mode here, as it does for `open`: asking for the mask
        # would set it for every thread.
        handle = os.open(self.temporary, flags, 0o666 if permissions is None else permissions)
        with os.fdopen(handle, "wb") as stream:
            stream.write(data)
            if lasting:
                stream.flush()
                os.fsync(stream.fileno())
        if permissions is not None:
            os.chmod(self.temporary, permissions)
