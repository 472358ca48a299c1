"""Atomic writing of files: whole or not at all, even if the program is ended meanwhile.

The content goes into a temporary file in the folder of its target, which then takes the target's name in
one step: who opens that name finds the old file or the new one, never a part. Of several files all are
whole before the first is put in place; an end between two of those steps leaves some new and some old.

A writer holds a shared lock on the folder as long as it has temporary files there, which the system takes
back from a program that is killed. So the next writer knows whose files are left over: where it gets the
folder for itself nobody is writing, and temporary files of this form belong to nobody.
"""

from __future__ import annotations

import os
import re
import stat
import sys
import time
from collections.abc import Iterator, Mapping
from contextlib import ExitStack, contextmanager, suppress
from errno import EBADF, EINVAL, ELOOP, ENOTSUP, ENXIO
from typing import Any

from symbalance.errors import SymbalanceError

fcntl: Any
try:
    import fcntl
except ImportError:  # Windows has neither these locks nor descriptors of folders
    fcntl = None

REMEDY = "name a file in a folder you may write to"
LEFT_OVER = re.compile(r"\..{0,20}\.[0-9a-f]{16}\.part", re.DOTALL)
"""The form of a temporary file's name; see `temporary_name`."""
OLDEST = 3600.0
"""Seconds after which a temporary file is nobody's where there are no locks: no write takes so long."""
_STREAM = re.compile(r"/dev/(?:std(?P<word>out|err)|fd/(?P<dev>\d+))|/proc/self/fd/(?P<proc>\d+)")
_MOST_LINKS = 40
"""Links on the way to a file, as the system counts them."""
_CREATE = os.O_WRONLY | os.O_CREAT | os.O_EXCL
for _flag in ("O_NOFOLLOW", "O_CLOEXEC", "O_BINARY"):
    _CREATE |= getattr(os, _flag, 0)
_LOOK = os.O_WRONLY
for _flag in ("O_NOFOLLOW", "O_CLOEXEC", "O_NONBLOCK", "O_NOCTTY", "O_BINARY"):
    _LOOK |= getattr(os, _flag, 0)


def write_file(
    path: str | os.PathLike[str],
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

    A link is followed: its target is replaced, and the link stays; but not a link that someone else put
    into a folder open to all. A device or a pipe is written to. A file that is replaced keeps its
    permissions; a new one gets those that `open` gives, or `permissions`. With `lasting` the content is
    on the disk before it takes its name, and the name before this returns, so that a computer that loses
    its power has the old file or the new one. What cannot be written is refused as `what` + its name,
    with `remedy`; then, as after any other exception, no temporary file is left.
    """
    staged: list[_Staged] = []
    name = ""
    with ExitStack() as stack:
        folders: dict[str, Folder] = {}
        try:
            for name, content in contents.items():
                data = content.encode("utf-8") if isinstance(content, str) else content
                target = _writable(name, data)
                if target is None:
                    continue
                path, base = os.path.split(target.path)
                if path not in folders:
                    folders[path] = stack.enter_context(open_folder(path))
                staged.append(_Staged(name, folders[path], base))
                staged[-1].fill(data, target.mode if permissions is None else permissions, lasting)
            while staged:
                name = staged[0].name
                staged[0].take_its_name()
                staged.pop(0)
            for folder in folders.values() if lasting else ():
                folder.sync()
        except (OSError, ValueError) as problem:
            reason = getattr(problem, "strerror", None) or str(problem)
            raise SymbalanceError(f"{what}{name}", f"cannot be written ({reason})", remedy) from None
        finally:
            for one in staged:
                with suppress(OSError):
                    one.folder.unlink(one.temporary)


# Targets ------------------------------------------------------------------------------------------------


class _Target:
    """A file to be replaced or created: its path, links followed, and its permissions if it is there.

    Neither this nor `_Staged` is a dataclass, nor is `secrets` used here: every command imports this,
    `--help` too, and they load a dozen modules of the standard library.
    """

    def __init__(self, path: str, mode: int | None) -> None:
        self.path, self.mode = path, mode


def _writable(name: str, data: bytes) -> _Target | None:
    """Return the file that a name stands for; None of a device or a pipe, which gets the data at once.

    What is there is opened, without a change to it, before it is asked what it is: a name that is a pipe
    when it is looked at may be a link to somebody's file when it is opened.
    """
    stream = _STREAM.fullmatch(name)
    if stream and os.name == "posix":
        # /dev/stdout leads to no path where a pipe is behind it; a file there is written on.
        sys.stdout.flush()
        number = {"out": 1, "err": 2}.get(stream["word"] or "")
        _write_out(os.dup(number or int(stream["dev"] or stream["proc"])), data)
        return None
    if not name:
        raise FileNotFoundError(2, os.strerror(2))
    path = resolved(name)
    try:
        descriptor = os.open(path, _LOOK)
    except FileNotFoundError:
        return _Target(path, None)
    except IsADirectoryError:
        raise OSError(0, "it is a directory") from None
    except PermissionError:
        rule = "it is a directory" if os.path.isdir(path) else "it is write-protected"
        raise OSError(0, rule) from None
    except OSError as problem:
        if problem.errno == ENXIO:
            raise OSError(0, "nobody reads from it: start its reader first") from None
        raise
    mode = os.fstat(descriptor).st_mode
    if stat.S_ISREG(mode):
        os.close(descriptor)
        return _Target(path, stat.S_IMODE(mode) & 0o777)
    if stat.S_ISBLK(mode):
        os.close(descriptor)
        raise OSError(0, "it is a disk")
    _write_out(descriptor, data)
    return None


def _write_out(descriptor: int, data: bytes) -> None:
    with os.fdopen(descriptor, "wb", 0) as stream:
        if hasattr(os, "set_blocking"):
            os.set_blocking(descriptor, True)
        rest = memoryview(data)
        while rest:
            rest = rest[stream.write(rest) :]


def resolved(name: str) -> str:
    """Return a path with every link followed, the last one too; what is not there may be its end.

    Refuses, as OSError, a link in a folder that all may write to and nobody but the owner delete from (as
    /tmp is) which belongs neither to this user nor to the folder's: it leads where someone else chose.
    Systems may refuse these themselves, but only where they follow the link, and here none is opened.
    """
    if os.name != "posix":
        return os.path.realpath(name)
    at = "/" if os.path.isabs(name) else os.path.realpath(os.curdir)
    rest, links = name.split("/")[::-1], 0
    while rest:
        part = rest.pop()
        if part in ("", os.curdir):
            continue
        if part == os.pardir:
            at = os.path.dirname(at)
            continue
        here = os.path.join(at, part)
        try:
            status = os.lstat(here)
        except FileNotFoundError:
            at = here
            continue
        if not stat.S_ISLNK(status.st_mode):
            at = here
            continue
        links += 1
        if links > _MOST_LINKS:
            raise OSError(ELOOP, os.strerror(ELOOP))
        if _is_planted(status, os.stat(at)):
            raise OSError(0, "it is a link that someone else put into a folder open to all")
        end = os.readlink(here)
        at = "/" if os.path.isabs(end) else at
        rest += end.split("/")[::-1]
    return at


def _is_planted(link: os.stat_result, folder: os.stat_result) -> bool:
    shared = stat.S_ISVTX | stat.S_IWOTH
    return folder.st_mode & shared == shared and link.st_uid not in (os.geteuid(), folder.st_uid)


# Folders ------------------------------------------------------------------------------------------------


class Folder:
    """A folder that is open: what is done in it is done in this one, whatever becomes of its name."""

    def __init__(self, path: str, descriptor: int | None, readable: bool) -> None:
        self.path, self.descriptor, self.readable = path, descriptor, readable

    def at(self, name: str) -> str:
        """Return what the system has to be given for a name in the folder."""
        return name if self.descriptor is not None else os.path.join(self.path, name)

    def create(self, name: str, permissions: int) -> int:
        """Return the descriptor of a new file; refused where anything has that name, a link too."""
        return os.open(self.at(name), _CREATE, permissions, dir_fd=self.descriptor)

    def replace(self, name: str, other: str) -> None:
        """Give a file another name, in one step, whatever had it."""
        ends = {"src_dir_fd": self.descriptor, "dst_dir_fd": self.descriptor}
        os.replace(self.at(name), self.at(other), **ends)

    def unlink(self, name: str) -> None:
        """Remove a name."""
        os.unlink(self.at(name), dir_fd=self.descriptor)

    def lstat(self, name: str) -> os.stat_result:
        """Return the status of what has a name, of a link itself."""
        return os.stat(self.at(name), dir_fd=self.descriptor, follow_symlinks=False)

    def names(self) -> list[str]:
        """Return the names in the folder, none where it may not be listed."""
        if not self.readable:
            return []
        return os.listdir(self.path if self.descriptor is None else self.descriptor)

    def sync(self) -> None:
        """Have the names on the disk; where a system cannot, its names are as safe as it makes them."""
        if self.descriptor is None or not self.readable:
            return
        try:
            os.fsync(self.descriptor)
        except OSError as problem:
            if problem.errno not in (EINVAL, ENOTSUP, EBADF):
                raise


@contextmanager
def open_folder(path: str, alone: float | None = None) -> Iterator[Folder]:
    """Open a folder to write in it: what killed writers left there is cleared first.

    As long as it is open it is known to have a writer, and what that writes is cleared by nobody. With
    `alone` nobody else writes there meanwhile; the number is the seconds to wait for that.
    """
    path = path or os.curdir
    if os.open not in os.supports_dir_fd or not hasattr(os, "O_DIRECTORY"):
        yield Folder(path, None, True)
        return
    flags, readable = os.O_DIRECTORY | os.O_CLOEXEC, True
    try:
        descriptor = os.open(path, os.O_RDONLY | flags)
    except PermissionError:  # one may write into a folder that one may not list
        if not hasattr(os, "O_PATH"):
            raise
        descriptor, readable = os.open(path, os.O_PATH | flags), False
    folder = Folder(path, descriptor, readable)
    try:
        if readable:
            _clear_left_over(folder)
            if alone is None:
                _lock(folder, "LOCK_SH")
            elif _lock(folder, "LOCK_EX", alone) is False:
                raise OSError(0, "another run writes there; run this again when it is finished")
        yield folder
    finally:
        os.close(descriptor)


def _lock(folder: Folder, kind: str, patience: float = 1.0) -> bool | None:
    """Try to lock a folder: True if it is, False if others have it, None where there are no locks.

    Never waits for long: somebody else may hold a lock on the folder for reasons of their own.
    """
    if fcntl is None:
        return None
    ends = time.monotonic() + patience
    while True:
        try:
            fcntl.flock(folder.descriptor, getattr(fcntl, kind) | fcntl.LOCK_NB)
            return True
        except BlockingIOError:
            if time.monotonic() >= ends:
                return False
            time.sleep(0.01)
        except OSError:  # a file system without locks
            return None


def _clear_left_over(folder: Folder) -> None:
    """Remove temporary files that killed writers left: this user's, of that form, written by nobody."""
    left_over = [name for name in folder.names() if LEFT_OVER.fullmatch(name)]
    if not left_over:
        return
    alone = _lock(folder, "LOCK_EX", 0.0)
    if alone is False:
        return
    for name in left_over:
        with suppress(FileNotFoundError, PermissionError):
            status = folder.lstat(name)
            is_file = stat.S_ISREG(status.st_mode) or stat.S_ISLNK(status.st_mode)
            own = is_file and status.st_uid == os.geteuid()
            if own and (alone or time.time() - status.st_mtime > OLDEST):
                folder.unlink(name)


def temporary_name(base: str) -> str:
    """Return a name that nobody can foresee; of `base` only a beginning is in it, to stay short enough.

    >>> LEFT_OVER.fullmatch(temporary_name("report.txt")) is not None
    True
    """
    return f".{base[:20]}.{os.urandom(8).hex()}.part"


class _Staged:
    """A file to be written: its name as given, its target's folder and name, and the temporary file."""

    def __init__(self, name: str, folder: Folder, base: str) -> None:
        self.name, self.folder, self.base, self.temporary = name, folder, base, temporary_name(base)

    def fill(self, data: bytes, permissions: int | None, lasting: bool) -> None:
        """Write the temporary file, with the permissions that the target shall have."""
        # The system applies the user's mask to the mode here, as it does for `open`: asking for the mask
        # would set it for every thread.
        descriptor = self.folder.create(self.temporary, 0o666 if permissions is None else permissions)
        with os.fdopen(descriptor, "wb") as stream:
            if permissions is not None and hasattr(os, "fchmod"):  # by name it could be another file's
                os.fchmod(descriptor, permissions)
            stream.write(data)
            stream.flush()
            if lasting:
                os.fsync(descriptor)

    def take_its_name(self) -> None:
        """Put the temporary file in the target's place, in one step."""
        self.folder.replace(self.temporary, self.base)
