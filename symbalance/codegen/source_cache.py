"""Files of generated source in the user's cache, so that Numba can keep the code it compiled from them.

Numba keeps what it compiled beside the file that holds the source, or in NUMBA_CACHE_DIR, and asks that
the file be there. The file's name is a digest of its text, and it is compared with the text before it is
relied on; nothing is ever read from it to be run. Numba's own key adds its version and the processor, and
the text its digest (`targets.numba_module`), so that code of another text, version or machine is never
taken for this one's. Where no file can be written there is none, and each process compiles.
"""

from __future__ import annotations

import os
import sys
from hashlib import sha256
from pathlib import Path

from symbalance.errors import SymbalanceError
from symbalance.text.writing import write_file

MOST_SOURCES = 200
"""Sources that stay, some 150 kB each with their code; the oldest go first."""


def source_file(source: str) -> Path | None:
    """Return a file that holds this very text, written now unless it is there; None where none can be."""
    data = source.encode()
    try:
        folder = _own_folder()
        path = folder / f"evaluator_{sha256(data).hexdigest()[:40]}.py"
        if not (path.is_file() and path.read_bytes() == data):
            # The user's alone, whatever the mask; one that is lost is written anew.
            write_file(path, data, permissions=0o600, lasting=False)
            _remove_oldest(folder)
    except (OSError, SymbalanceError, RuntimeError):  # RuntimeError: the user has no home
        return None
    return path


def _own_folder() -> Path:
    """Return the folder, made if need be, or raise: what is loaded from it must be the user's own."""
    folder = _cache() / "symbalance"
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    if hasattr(os, "getuid"):
        status = folder.stat()
        if status.st_uid != os.getuid() or status.st_mode & 0o022:
            raise PermissionError(f"{folder} can be written by others")
    return folder


def _cache() -> Path:
    folder = os.environ.get("NUMBA_CACHE_DIR")
    if folder:
        return Path(folder).absolute()
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA") or Path.home() / "AppData" / "Local")
    if sys.platform == "darwin":
        return Path.home() / "Library" / "Caches"
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")


def _remove_oldest(folder: Path) -> None:
    """Remove sources beyond `MOST_SOURCES` and their code, here or in Numba's folder beside this one."""
    by_age = sorted(folder.glob("evaluator_*.py"), key=lambda path: path.stat().st_mtime)
    for path in by_age[:-MOST_SOURCES]:
        for file in (path, *folder.parent.glob(f"symbalance*/**/{path.stem}.*")):
            file.unlink(missing_ok=True)
