"""Where results go: stdout, or a file that appears whole or not at all."""

from __future__ import annotations

import os
import stat
import sys
import tempfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from errno import EINVAL
from pathlib import Path

from symbalance.cli.ascii_spelling import as_encodable, as_json
from symbalance.errors import SymbalanceError, encodable_name

ESCAPES = {"json": "\\\\"}
"""How a backslash is written, where one stands for a byte of a file's name that is no text."""
SPELLINGS = {"text": as_encodable, "json": as_json}


def whole_number(text: str, name: str) -> int:
    """Return an option's value as an integer; ranges are checked where it is used."""
    stripped = text.strip()
    digits = stripped.removeprefix("-").removeprefix("+")
    if not (digits.isascii() and digits.isdigit() and len(digits) <= 18):
        shown = text if len(text) <= 40 else text[:20] + "..."
        raise SymbalanceError(
            f"--{name} = {shown}", "must be a whole number", f"write it like --{name} 12"
        )
    return int(stripped)


def write(text: str, output: str | None, form: str = "text") -> None:
    """Write `text` to stdout (None or "-") or to the file `output`, replaced in one step.

    A file is UTF-8. On stdout `form` says what may become of characters that it cannot take: a "text" is
    spelled in ASCII, "json" escapes them, and any other form, "latex" or "source", is for programs and
    stays UTF-8 whatever the locale.
    """
    text = encodable_name(text, ESCAPES.get(form, "\\"))
    if output in (None, "-"):
        _to_stdout(text, form)
        return
    write_files({str(output): text})


def write_files(contents: Mapping[str, str | bytes]) -> None:
    """Write several files, texts or bytes, all of them whole before the first is put in place."""
    staged: list[tuple[str, Path]] = []
    name = ""
    try:
        for name, content in contents.items():
            path = Path(os.path.realpath(name))
            if isinstance(content, str):
                escape = ESCAPES["json"] if path.suffix == ".json" else "\\"
                data = encodable_name(content, escape).encode("utf-8")
            else:
                data = content
            temporary = _staged(data, path)
            if temporary:
                staged.append((temporary, path))
        while staged:
            os.replace(*staged[0])
            staged.pop(0)
    except (OSError, ValueError) as problem:
        reason = getattr(problem, "strerror", None) or str(problem)
        raise SymbalanceError(
            f"file {name}",
            f"cannot be written ({reason})",
            "name a file in a folder you may write to",
        ) from None
    finally:
        for temporary, _ in staged:
            with suppress(OSError):
                os.unlink(temporary)


def finish() -> None:
    """Hand what is still in stdout's buffer to the system, while a failure can still be told."""
    with _stdout():
        sys.stdout.flush()


def _to_stdout(text: str, form: str) -> None:
    encoding = sys.stdout.encoding or "utf-8"
    with _stdout():
        if form in SPELLINGS:
            sys.stdout.write(SPELLINGS[form](text, encoding))
        elif encoding.lower().replace("_", "-") in ("utf-8", "utf8"):  # utf-8-sig would open with a mark
            sys.stdout.write(text)
        else:
            sys.stdout.flush()
            sys.stdout.buffer.write(text.encode("utf-8"))
        sys.stdout.flush()


@contextmanager
def _stdout() -> Iterator[None]:
    """Refuse what stdout cannot take; a reader that has gone is no failure, and ends silently."""
    try:
        yield
    except OSError as problem:
        # What stays in the buffer would fail once more while Python shuts down.
        with suppress(OSError, ValueError):
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        # Windows reports a closed pipe as an invalid argument.
        if isinstance(problem, BrokenPipeError) or (os.name == "nt" and problem.errno == EINVAL):
            return
        rule = f"cannot be written ({problem.strerror or problem})"
        raise SymbalanceError("standard output", rule, "make room, or name a file with -o") from None


def _staged(data: bytes, path: Path) -> str | None:
    """Write a temporary file beside `path`, ready to take its place; return its name.

    A device or a pipe has nothing to replace: it is written to, and there is no file to stage.
    """
    if path.is_dir():
        raise OSError(0, "it is a directory")
    if path.exists() and not stat.S_ISREG(path.stat().st_mode):
        path.write_bytes(data)
        return None
    if path.exists() and not os.access(path, os.W_OK):
        raise OSError(0, "it is write-protected")
    mode = stat.S_IMODE(path.stat().st_mode) if path.exists() else 0o666 & ~_umask()
    handle, temporary = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name[:100]}.")
    try:
        with os.fdopen(handle, "wb") as stream:
            stream.write(data)
        os.chmod(temporary, mode)
    except BaseException:
        with suppress(OSError):
            os.unlink(temporary)
        raise
    return temporary


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
