"""A folder of results that changes whole: who reads it finds those of one run, whatever ends another.

At rest the results are plain files. A run that has new ones

1. writes them all into a hidden folder within, until they are on the disk;
2. has the old ones in a second hidden folder by another name of theirs, and a link `RESULTS` to that;
3. puts for every result a link through `RESULTS` in the place of the plain file: nothing changes for a
   reader, as each leads to what was there before;
4. points `RESULTS` to the new folder, in one step: now every name leads to the new results;
5. puts the new files in the places of their links, and removes what is left.

A run that is killed before step 4 leaves the old results, after it the new ones, and links that lead to
them; the next run goes on with step 5. What else lies in the folder is not touched.

Where a system has no links (FAT, Windows without that right) the files can only be put in place one
after the other. Then a note lies in the place of `RESULTS` meanwhile, and if a run is killed in that
moment the next one says that the results were of two runs.
"""

from __future__ import annotations

import os
import re
import shutil
import stat
from collections.abc import Callable, Mapping
from contextlib import suppress
from pathlib import Path

from symbalance.errors import SymbalanceError
from symbalance.text.writing import REMEDY, Folder, open_folder, resolved, temporary_name

RESULTS = ".symbalance-results"
"""The link to the results that count, while they are changed."""
GENERATION = re.compile(r"\.symbalance-results\.[0-9a-f]{16}")
NOTE = b"symbalance is putting results in place: while this file is here they may be of two runs\n"
PATIENCE = 60.0
"""Seconds to wait while another run puts its results in the same folder."""


def write_results(
    path: str | Path,
    contents: Mapping[str, str | bytes],
    *,
    what: str = "file ",
    remedy: str = REMEDY,
    say: Callable[[str], None] = lambda line: None,
) -> None:
    """Write results, texts (as UTF-8) or bytes by their files' names, into a folder: all, or none.

    What cannot be written is refused as `what` + its name, with `remedy`; the old results are then as
    they were. `say` hears of results of two runs, where an earlier one was killed on a system without
    links.
    """

    def refusal(name: str, problem: OSError | ValueError) -> SymbalanceError:
        rule = f"cannot be written ({getattr(problem, 'strerror', None) or problem})"
        return SymbalanceError(f"{what}{os.path.join(path, name) if name else path}", rule, remedy)

    try:
        with open_folder(resolved(str(path)), PATIENCE) as folder:
            _Swap(folder, contents, lambda line: say(f"{path}: {line}"), refusal).run()
    except SymbalanceError:
        raise
    except (OSError, ValueError) as problem:
        raise refusal("", problem) from None


class _Swap:
    """One change of a folder's results; every step leaves those of one run under the plain names."""

    def __init__(
        self,
        folder: Folder,
        contents: Mapping[str, str | bytes],
        say: Callable[[str], None],
        refusal: Callable[[str, OSError | ValueError], SymbalanceError],
    ) -> None:
        self.folder, self.contents, self.say, self.refusal = folder, contents, say, refusal

    def run(self) -> None:
        """Change the results."""
        self.settle()
        modes = {name: self.permissions(name) for name in self.contents}
        try:
            new = self.new_folder()
            for name, content in self.contents.items():
                data = content.encode("utf-8") if isinstance(content, str) else content
                try:
                    self.write(f"{new}/{name}", data, modes[name])
                except (OSError, ValueError) as problem:
                    raise self.refusal(name, problem) from None
            self.sync_within(new)
            if self.lead_to_old():
                self.point(RESULTS, new)
            else:
                self.put_one_by_one(new)
            self.folder.sync()
        finally:
            self.settle()
        self.folder.sync()

    # Steps ------------------------------------------------------------------------------------------

    def settle(self) -> None:
        """Have plain files again, those that the links lead to, and nothing hidden beside them."""
        current = self.current()
        links = [name for name in self.folder.names() if self.link(name) == f"{RESULTS}/{name}"]
        for name in links:
            try:
                if current is None:
                    raise FileNotFoundError
                self.folder.replace(f"{current}/{name}", name)
            except FileNotFoundError:  # a result of the other generation alone
                self.folder.unlink(name)
        with suppress(FileNotFoundError):
            self.folder.unlink(RESULTS)
        for name in self.folder.names():
            if GENERATION.fullmatch(name) and self.link(name) is not None:
                self.folder.unlink(name)
            elif GENERATION.fullmatch(name):
                shutil.rmtree(os.path.join(self.folder.path, name))

    def current(self) -> str | None:
        """Return the hidden folder that the results are in, None where they are plain files."""
        target = self.link(RESULTS)
        if target is not None:
            return target if GENERATION.fullmatch(target) else None
        with suppress(FileNotFoundError):
            self.folder.lstat(RESULTS)
            self.say("an earlier run was ended while it put its results in place: they were of two runs")
        return None

    def lead_to_old(self) -> bool:
        """Put a link to the old result in the place of every result; False where there are no links."""
        old = self.new_folder()
        try:
            self.point(RESULTS, old)
        except (OSError, NotImplementedError):
            return False
        for name in self.contents:
            with suppress(FileNotFoundError):
                self.name_again(name, f"{old}/{name}")
        for name in self.contents:
            self.point(name, f"{RESULTS}/{name}")
        self.folder.sync()
        return True

    def name_again(self, name: str, other: str) -> None:
        """Have a result under another name too, or a copy of it where files have one name each."""
        if self.link(name) is not None:  # somebody's own: it shall lead there from the other place too
            end = os.path.realpath(os.path.join(self.folder.path, name))
            os.symlink(end, self.at(other), dir_fd=self.folder.descriptor)
            return
        ends = {"src_dir_fd": self.folder.descriptor, "dst_dir_fd": self.folder.descriptor}
        try:
            os.link(self.at(name), self.at(other), **ends, follow_symlinks=False)
        except FileNotFoundError:
            raise
        except (OSError, NotImplementedError):
            shutil.copy2(*(os.path.join(self.folder.path, each) for each in (name, other)))

    def put_one_by_one(self, new: str) -> None:
        """Put the new results in place, and a note beside them as long as some are the old ones."""
        self.write(RESULTS, NOTE, None)
        self.folder.sync()
        for name in self.contents:
            self.folder.replace(f"{new}/{name}", name)
        self.folder.sync()
        self.folder.unlink(RESULTS)

    # Files ------------------------------------------------------------------------------------------

    def at(self, name: str) -> str:
        return self.folder.at(name)

    def link(self, name: str) -> str | None:
        """Return where a link leads, None of what is none."""
        try:
            return os.readlink(self.at(name), dir_fd=self.folder.descriptor)
        except OSError:
            return None

    def point(self, name: str, target: str) -> None:
        """Have a name lead to a target, in one step."""
        temporary = temporary_name(name)
        os.symlink(target, self.at(temporary), dir_fd=self.folder.descriptor)
        try:
            self.folder.replace(temporary, name)
        except BaseException:
            self.folder.unlink(temporary)
            raise

    def new_folder(self) -> str:
        """Return the name of a new hidden folder, which nobody can foresee."""
        name = f"{RESULTS}.{os.urandom(8).hex()}"
        os.mkdir(self.at(name), dir_fd=self.folder.descriptor)
        return name

    def permissions(self, name: str) -> int | None:
        """Return those of the file that is replaced, None where there is none; refuse what is no file."""
        try:
            status = os.stat(self.at(name), dir_fd=self.folder.descriptor)
        except FileNotFoundError:
            return None
        if stat.S_ISDIR(status.st_mode):
            raise self.refusal(name, OSError(0, "it is a directory"))
        if not stat.S_ISREG(status.st_mode):
            raise self.refusal(name, OSError(0, "it is a pipe or a device"))
        if not os.access(self.at(name), os.W_OK, dir_fd=self.folder.descriptor):
            raise self.refusal(name, OSError(0, "it is write-protected"))
        return stat.S_IMODE(status.st_mode) & 0o777

    def write(self, name: str, data: bytes, permissions: int | None) -> None:
        """Write a new file, on the disk when this returns."""
        descriptor = self.folder.create(name, 0o666 if permissions is None else permissions)
        with os.fdopen(descriptor, "wb") as stream:
            if permissions is not None and hasattr(os, "fchmod"):
                os.fchmod(descriptor, permissions)
            stream.write(data)
            stream.flush()
            os.fsync(descriptor)

    def sync_within(self, name: str) -> None:
        """Have the names in a hidden folder on the disk."""
        with open_folder(os.path.join(self.folder.path, name)) as folder:
            folder.sync()
