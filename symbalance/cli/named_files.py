"""Check of a command's file names: no output may overwrite an input or another output.

A file that is read may be a person's own work, and a result put in its place cannot be undone. So this is
checked before a command does anything, for every command alike.
"""

from __future__ import annotations

import argparse
import os
import stat
import unicodedata
from collections.abc import Iterator
from contextlib import suppress
from fnmatch import fnmatch
from pathlib import Path
from typing import Any

from symbalance.errors import SymbalanceError

READ = ("engine", "notes", "symbols", "pressure", "parts")
WRITTEN = ("output", "write", "picture", "certificates", "certificate")
PIPED = "-"
"""Stands for standard input, and among what is written for the terminal."""
IN_FOLDER = ("report.*", "curves-*.csv", "loads-*.csv", "*.png", "webs.json")
"""What `crankshaft` writes into its folder, beside speeds/*.result."""


def check_named_files(options: argparse.Namespace) -> None:
    """Refuse a command line that would replace a person's own file, or write two results to one file."""
    _check_given(options)
    outputs = list(_outputs(options))
    if not outputs:
        return
    inputs = [(path, status) for path in _inputs(options) if (status := _regular(path)) is not None]
    sidecars = [status for path in _passed_over(options) if (status := _regular(path)) is not None]
    claims: dict[tuple[str, ...], str] = {}
    for option, path in outputs:
        status = _regular(path)
        same = [r for r, of_input in inputs if status is not None and os.path.samestat(status, of_input)]
        if same:
            rule = f"is {same[0]}, which is read, and would be replaced"
            if str(path) == str(same[0]):
                rule = "is a file that is read, and would be replaced"
            raise SymbalanceError(f"--{option} {path}", rule, "name another file")
        if status is not None and any(os.path.samestat(status, sidecar) for sidecar in sidecars):
            rule = f"is the sidecar beside {options.notes}, and would be replaced"
            raise SymbalanceError(f"--{option} {path}", rule, "name another file")
        key = _place(path)
        if claims.setdefault(key, option) != option:
            rule = f"is named by --{claims[key]} too, and one of the two would be lost"
            raise SymbalanceError(f"--{option} {path}", rule, "name a file of its own for each")


def _check_given(options: argparse.Namespace) -> None:
    """Refuse a name that is empty: to the system that is the working folder, and to nobody a file."""
    piped = [option for option in READ if getattr(options, option, None) == PIPED]
    if len(piped) > 1:
        rule = f"is standard input, as {' and '.join(piped[:-1])} is, and can be read only once"
        raise SymbalanceError(f"{piped[-1]} -", rule, "name a file for one")
    for option in (*READ, *WRITTEN):
        if getattr(options, option, None) == "":
            remedy = "name a file" + (", or a preset (symbalance engines)" if option == "engine" else "")
            what = option.upper() if option in ("engine", "notes") else f"--{option}"
            raise SymbalanceError(f"{what} ''", "is an empty name", remedy)
    if options.command == "crankshaft" and options.output == "-":
        rule = "stands for the terminal, and this command writes a folder"
        raise SymbalanceError(
            "--output -", rule, "name a folder, or leave it out; --format says what is printed"
        )


def _outputs(options: argparse.Namespace) -> Iterator[tuple[str, Path]]:
    """Yield the option and the path of each file the command would write."""
    for option in WRITTEN:
        name = getattr(options, option, None)
        if name in (None, "-"):
            continue
        path = Path(name)
        if options.command == "crankshaft":
            yield from ((option, inner) for inner in _in_folder(path))
        else:
            yield option, path
            if options.command == "emit" and options.target == "c" and path.name:
                yield from ((option, path.with_suffix(end)) for end in (".c", ".h"))


def _in_folder(folder: Path) -> Iterator[Path]:
    """Yield what is already in a folder of results and would be replaced."""
    with suppress(OSError):
        for inner in folder.iterdir():
            if any(fnmatch(inner.name.casefold(), pattern) for pattern in IN_FOLDER):
                yield inner
    with suppress(OSError):
        yield from (folder / "speeds").iterdir()


def _inputs(options: argparse.Namespace) -> Iterator[Path]:
    """Yield every file the command would read, as far as its options tell, and the files these name."""
    for name in getattr(options, "engines", None) or ():
        if _is_file(name):
            yield from (Path(name), *_named_in(Path(name)))
    for option in READ:
        name = getattr(options, option, None)
        if name in (None, PIPED) or (
            option == "engine" and not _is_file(name) and options.command != "crankshaft"
        ):
            continue
        yield Path(name)
        if option in ("engine", "symbols"):
            yield from _named_in(Path(name))
        elif option == "notes":
            yield from _declared(Path(name), options.symbols is None)


def _passed_over(options: argparse.Namespace) -> list[Path]:
    """Return the sidecars beside the notes where another is named: not read, but no place for results."""
    if options.command != "check" or options.symbols is None or options.notes is None:
        return []
    from symbalance.notes.checking.documents import sidecars_beside

    return sidecars_beside(Path(options.notes))


def declared_files(notes: Path, symbols: str | None) -> list[Path]:
    """Return what decides, beside a document, what is said of it: sidecars, and engines they name."""
    named = _declared(notes, True) if symbols is None else (Path(symbols), *_named_in(Path(symbols)))
    return [path for path in named if _regular(path) is not None]


def _is_file(engine: str) -> bool:
    """Tell whether an engine is a file; a preset's name is none, though a file may be called so."""
    return engine.endswith(".toml") or "/" in engine or "\\" in engine


def _declared(notes: Path, beside: bool) -> Iterator[Path]:
    """Yield the sidecars beside a document, and the files they name, or its own header names."""
    from symbalance.notes.checking.declared.sidecar import without_header
    from symbalance.notes.checking.documents import sidecars_beside
    from symbalance.text.files import read_text

    for sidecar in sidecars_beside(notes) if beside else ():
        yield sidecar
        yield from _named_in(sidecar)
    if _regular(notes) is None:  # what a pipe holds can be read only once
        return
    with suppress(SymbalanceError):  # what cannot be read is refused where it is read
        yield from _named_by(without_header(read_text(notes), notes.suffix)[1], notes.parent)


def _named_in(path: Path) -> Iterator[Path]:
    from symbalance.text.files import read_text

    if _regular(path) is None:  # what a pipe holds can be read only once
        return
    with suppress(SymbalanceError):  # what cannot be read is refused where it is read
        yield from _named_by(read_text(path), path.parent)


def _named_by(text: str, folder: Path) -> Iterator[Path]:
    """Yield what an engine file or a sidecar may name: its texts that look like files' names."""
    from symbalance.text.files import toml_table

    try:
        table = toml_table(text, "")
    except SymbalanceError:  # refused where it is read
        return
    for name in _texts(table):
        if "." in name or _is_file(name):
            yield from (folder / name, Path(name))


def _texts(value: Any) -> Iterator[str]:
    if isinstance(value, str):
        yield value
    elif isinstance(value, dict | list):
        for part in value.values() if isinstance(value, dict) else value:
            yield from _texts(part)


def _regular(path: Path) -> os.stat_result | None:
    """Return the status of a regular file, links followed; a device or a pipe is never replaced."""
    try:
        status = os.stat(path)
    except (OSError, ValueError):
        return None
    return status if stat.S_ISREG(status.st_mode) else None


def _place(path: Path) -> tuple[str, ...]:
    """Return what two paths to one file have in common, capitals apart: some file systems ignore them."""
    try:
        parts = Path(os.path.realpath(path)).parts
    except (OSError, ValueError):
        parts = path.parts
    return tuple(unicodedata.normalize("NFC", part).casefold() for part in parts)
