"""Digests of inputs and of the program, by which a saved result is recognised as still valid.

A saved result is believed only where the digest of everything it depends on is the same: the input, the
content (never the name) of the files it names, the program that computed it and the libraries below. A
value whose content cannot be told is refused, not abbreviated: `repr` leaves things out.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass
from fractions import Fraction
from functools import cache
from hashlib import sha256
from importlib.resources import files
from importlib.resources.abc import Traversable
from pathlib import Path
from typing import Any

import symbalance
from symbalance.text.files import read_bytes

LARGEST_FILE = 20_000_000
"""Bytes of a file that counts by its content: no reader of the files an engine names takes more."""
LIBRARIES = ("numpy", "scipy", "sympy")
"""Their versions count: where films hardly settle, rounding decides which orbit results."""

SOURCES = (".py", ".toml", ".json")
"""The endings of the program's own files that decide what it computes."""


PLAIN = (bool, int, float, complex, str, bytes, Fraction)
"""Values whose `repr` is their whole content."""


def digest(*parts: object) -> str:
    """Return 32 hexadecimal digits that differ where any content of some part does.

    Parts are numbers, texts, None, NumPy arrays, paths (the file's content counts), and tuples, lists,
    mappings and dataclasses of these.

    >>> digest(1, "a") == digest(1, "a"), digest(1) == digest(1.0), digest("a", "b") == digest("ab")
    (True, False, False)
    """
    total = sha256()
    for piece in _pieces(parts):
        total.update(len(piece).to_bytes(8, "big"))
        total.update(piece)
    return total.hexdigest()[:32]


def _pieces(value: Any) -> Iterator[bytes]:
    """Yield a value's content; types are part of it, and every sequence says how long it is."""
    kind = type(value).__qualname__
    # Where nothing has loaded NumPy, no value is one of its own, and this room does without it.
    numpy: Any = sys.modules.get("numpy")
    if value is None or isinstance(value, PLAIN if numpy is None else (*PLAIN, numpy.generic)):
        yield f"{kind} {value!r}".encode()
    elif numpy is not None and isinstance(value, numpy.ndarray):
        yield f"array {value.dtype} {value.shape}".encode()
        yield value.tobytes()
    elif isinstance(value, Path):
        yield b"file"
        yield _content(value)
    elif isinstance(value, tuple | list):
        yield f"{kind} {len(value)}".encode()
        for item in value:
            yield from _pieces(item)
    elif isinstance(value, Mapping):
        yield f"mapping {len(value)}".encode()
        for key in sorted(value, key=repr):
            yield from _pieces((key, value[key]))
    elif is_dataclass(value) and not isinstance(value, type):
        yield kind.encode()
        for field in fields(value):
            yield from _pieces((field.name, getattr(value, field.name)))
    else:
        raise TypeError(f"no digest of a {kind}")


def _content(path: Path) -> bytes:
    return read_bytes(path, LARGEST_FILE, "a file", pipes=False)


@cache
def program_digest() -> str:
    """Return a digest of the program: its version, its files, the libraries it computes with.

    Of its files the sources count, the presets and what else it reads: a changed checkout, whose version
    stays, does not believe older results.
    """
    sources = {name: source.read_bytes() for name, source in _sources(files(symbalance), "")}
    libraries = {name: _version(name) for name in LIBRARIES}
    hashes = {name: sha256(source).hexdigest() for name, source in sources.items()}
    return digest(symbalance.__version__, hashes, libraries)


def _sources(folder: Traversable, inside: str) -> Iterator[tuple[str, Traversable]]:
    for entry in folder.iterdir():
        name = f"{inside}{entry.name}"
        if entry.is_dir():
            yield from _sources(entry, f"{name}/")
        elif entry.name.endswith(SOURCES):
            yield name, entry


def _version(library: str) -> str:
    from importlib.metadata import PackageNotFoundError, version

    try:
        return version(library)
    except PackageNotFoundError:  # SciPy is optional
        return "none"
