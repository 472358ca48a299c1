"""Reading of text and TOML files, with errors that name the place and the reason."""

from __future__ import annotations

import re
import sys
import tomllib
from decimal import Decimal
from pathlib import Path
from typing import Any

from symbalance.errors import SymbalanceError

LARGEST_FILE = 1_000_000
STANDARD_INPUT = "-"
"""A name that stands for what is piped into the program."""


def file_name(path: str | Path) -> str:
    """Return what errors call a file.

    >>> file_name("v6.toml"), file_name("-")
    ('v6.toml', 'standard input')
    """
    return "standard input" if str(path) == STANDARD_INPUT else str(path)


def read_text(path: str | Path, largest: int = LARGEST_FILE, what: str = "an engine file") -> str:
    """Return a file's text, or refuse what is missing, a directory, too large or not UTF-8.

    `what` is the file that is wanted, as a refusal names it; `-` is standard input.
    """
    place = file_name(path)
    try:
        if str(path) == STANDARD_INPUT:
            data = sys.stdin.buffer.read(largest + 1)
        else:
            with open(path, "rb") as stream:
                data = stream.read(largest + 1)
    except IsADirectoryError:
        raise SymbalanceError(place, "is a directory", f"name {what} in it") from None
    except (OSError, ValueError) as problem:
        reason = getattr(problem, "strerror", None) or "not a usable path"
        raise SymbalanceError(place, f"cannot be read ({reason})", "check the path") from None
    if len(data) > largest:
        raise SymbalanceError(place, f"is larger than {largest} bytes", f"name {what} within that")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as problem:
        line = data[: problem.start].count(b"\n") + 1
        raise SymbalanceError(f"{place}:{line}", "is not UTF-8 text", "save it as UTF-8") from None


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
