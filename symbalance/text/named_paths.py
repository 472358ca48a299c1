"""The files that a file names: beside it or below its folder, unless its reader trusts it further.

An engine file or the sidecar of notes may come from anybody. What it names is opened in the name of who
reads it, so that it could have another file of theirs opened, and a piece of it quoted in a message. So
a name leads to a file in the folder of the file that names it, or in a folder within; wherever it leads
outside, by its parts, by a link or as an absolute path, it is refused.
"""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path

from symbalance.errors import SymbalanceError, brief
from symbalance.text.files import STANDARD_INPUT

RULE = "lies outside the folder of the file that names it"
REMEDY = "put it beside that file, or trust it: --trust-paths, in Python trust_paths=True"


@dataclass(frozen=True)
class NamingFolder:
    """The folder of a file that names others; one that is `trusted` may name any."""

    folder: Path
    trusted: bool = False

    @classmethod
    def of(cls, path: str | Path, trusted: bool = False) -> NamingFolder:
        """Return the folder of a file; what is piped in names files in the working folder."""
        return cls(Path() if str(path) == STANDARD_INPUT else Path(path).parent, trusted)

    def file(self, name: str) -> Path:
        """Return the path of a file by the name it is given, or refuse one outside.

        >>> NamingFolder(Path("engines")).file("traces/full-load.csv").as_posix()
        'engines/traces/full-load.csv'
        >>> NamingFolder(Path("engines")).file("../../other.csv")
        Traceback (most recent call last):
        ...
        symbalance.errors.SymbalanceError: ../../other.csv: lies outside the folder of the file that ...
        """
        if name == STANDARD_INPUT:
            raise SymbalanceError(f"{name!r}", "is standard input, which no file can name", "name a file")
        path = self.folder / name
        if not self.trusted and not _is_within(path, self.folder):
            raise SymbalanceError(brief(name), RULE, REMEDY)
        return path


def _is_within(path: Path, folder: Path) -> bool:
    try:
        inside, end = (os.path.normcase(os.path.realpath(each)) for each in (folder, path))
        return os.path.commonpath([inside, end]) == inside
    except (OSError, ValueError):  # another drive, or a name that no path can have
        return False
