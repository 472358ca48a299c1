"""Output of results, in the chosen format, to stdout or to a file that is written whole or not at all."""

from __future__ import annotations

import argparse
import os
import re
import sys
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, suppress
from errno import EINVAL
from pathlib import Path
from typing import TYPE_CHECKING

from symbalance.errors import SymbalanceError, encodable_name, visible
from symbalance.text import writing

if TYPE_CHECKING:
    from symbalance.document.result import Result

MEDIA = {
    "text": (".txt",),
    "latex": (".tex",),
    "html": (".html", ".htm"),
    "markdown": (".md",),
    "json": (".json",),
    "csv": (".csv",),
    "xlsx": (".xlsx",),
}
"""Every medium of `--format`, and the endings of files that ask for it."""
NARROWEST, WIDEST = 60, 160
"""Columns of a terminal that text is fitted to; 80 where there is no terminal."""
ESCAPES = {"json": "\\\\"}
"""How a backslash is written, where one stands for a byte of a file's name that is no text."""


def whole_number(text: str, name: str) -> int:
    """Return an option's value as an integer; ranges are checked where it is used."""
    stripped = text.strip()
    digits = stripped.removeprefix("-").removeprefix("+")
    if not (digits.isascii() and digits.isdigit() and len(digits) <= 18):
        quoted = text if len(text) <= 40 else text[:20] + "..."
        raise SymbalanceError(
            f"--{name} = {quoted}", "must be a whole number", f"write it like --{name} 12"
        )
    return int(stripped)


def show(result: Result, options: argparse.Namespace) -> None:
    """Write a result in the medium and to the place that a command line asks for."""
    form = medium(options)
    write(content_of(result, form, options), options.output, form)


def content_of(result: Result, form: str, options: argparse.Namespace) -> str | bytes:
    """Return a result in a medium, as a command line asks for it: its length, its labels."""
    return printed(
        result,
        form,
        options.output,
        standalone=options.standalone,
        full=getattr(options, "full", False),
        label=options.label,
    )


def medium(options: argparse.Namespace) -> str:
    """Return the medium asked for: by --format, by the ending of the file to write, else text.

    Options that are for LaTeX alone, and a workbook without a file to write it to, are refused.
    """
    named = str(options.output or "")
    by_ending = next((form for form, ends in MEDIA.items() if named.lower().endswith(ends)), "text")
    form = options.format or by_ending
    for name in ("standalone", "label"):
        if getattr(options, name, None) and form != "latex":
            raise SymbalanceError(f"--{name}", f"is for LaTeX, and this is {form}", "add --format latex")
    if form == "xlsx" and options.output in (None, "-"):
        rule = "is a workbook, which no terminal shows"
        raise SymbalanceError("--format xlsx", rule, "name a file: -o FILE.xlsx")
    return form


def medium_of_several(options: argparse.Namespace) -> str:
    """Return the medium of several results, which the ending of a file cannot say: -o is a folder."""
    return medium(argparse.Namespace(**{**vars(options), "output": "a folder"}))


def label_of(prefix: str | None, name: str) -> str | None:
    """Return the beginning of labels of one result among several, which its name makes its own.

    >>> label_of("mine", "v8_90 (1)"), label_of(None, "v8-90")
    ('mine-v8-90-1', None)
    """
    if prefix is None:
        return None
    plain = re.sub("[^A-Za-z0-9.:+-]+", "-", name).strip("-")
    return f"{prefix}-{plain}" if plain else prefix


def for_terminal(options: argparse.Namespace) -> argparse.Namespace:
    """Return a command line's options for what it shows on the terminal, where -o names a folder."""
    return argparse.Namespace(**{**vars(options), "output": None})


def printed(
    result: Result,
    form: str,
    output: str | None,
    *,
    standalone: bool = False,
    full: bool = False,
    label: str | None = None,
) -> str | bytes:
    """Return a result in a medium, texts ended by a line's end; only that medium's writer is imported."""
    from symbalance.document import result as results

    if form == "text":
        from symbalance.document.text_document import document_text

        stream = "utf-8" if output not in (None, "-") else sys.stdout.encoding or "utf-8"
        width = columns() if output in (None, "-") else 80
        return document_text(result.document().unfolded(full), width, lambda text: _quoted(text, stream))
    if form == "latex":
        return results.to_latex(result, standalone=standalone, full=full, label=label)
    if form == "html":
        return results.to_html(result, standalone=True)
    if form in ("csv", "xlsx"):
        return results.to_csv(result) if form == "csv" else results.to_xlsx(result)
    return results.to_markdown(result) if form == "markdown" else results.to_json(result) + "\n"


def columns() -> int:
    """Return the columns of the terminal, 80 where stdout is none."""
    try:
        return min(max(os.get_terminal_size(sys.stdout.fileno()).columns, NARROWEST), WIDEST)
    except (OSError, ValueError, AttributeError):
        return 80


def write(content: str | bytes, output: str | None, form: str = "text") -> None:
    """Write a text to stdout (None or "-") or to the file `output`, replaced in one step.

    A file is UTF-8, or holds the bytes that `content` is. On stdout `form` says what may become of
    characters that it cannot take: a "text" is spelled in ASCII, "json" escapes them, and any other form,
    "latex" or "source", is for programs and stays UTF-8 whatever the locale.
    """
    if isinstance(content, bytes):
        write_all({str(output): content})
        return
    text = _safe(encodable_name(content, ESCAPES.get(form, "\\")))
    if output in (None, "-"):
        _to_stdout(text, form)
        return
    write_all({str(output): text})


def write_all(contents: Mapping[str, str | bytes]) -> None:
    """Write several files, texts or bytes, all of them whole before the first is put in place."""
    writing.write_files({name: _encodable(name, content) for name, content in contents.items()})


def write_folder(folder: Path, contents: Mapping[str, str | bytes], say: Callable[[str], None]) -> None:
    """Write a run's results into a folder, texts or bytes by their names: all of them, or none."""
    from symbalance.text.result_folders import write_results

    ready = {name: _encodable(name, content) for name, content in contents.items()}
    write_results(folder, ready, say=say)


def _encodable(name: str, content: str | bytes) -> str | bytes:
    """Return a text with the bytes of file names that are no text spelled by their codes."""
    if isinstance(content, bytes):
        return content
    return _safe(encodable_name(content, ESCAPES["json"] if name.endswith(".json") else "\\"))


def _safe(text: str) -> str:
    """Return a text that no terminal obeys; documents are so, and here is all that is none of them.

    The invisible signs of MathML stay, which a page of formulas holds.
    """
    return text if not _OBEYED.search(text) else _OBEYED.sub(lambda match: visible(match[0]), text)


_OBEYED = re.compile(
    "[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f\u061c\u200b-\u200f\u2028-\u202e\u2066-\u2069\ufeff]|\r(?!\n)"
)


def finish() -> None:
    """Hand what is still in stdout's buffer to the system, while a failure can still be told."""
    with _stdout():
        sys.stdout.flush()


def _to_stdout(text: str, form: str) -> None:
    encoding = sys.stdout.encoding or "utf-8"
    with _stdout():
        if form in ("text", "json"):
            sys.stdout.write(_spelled(text, form, encoding))
        elif _is_utf8(encoding) and not encoding.lower().endswith("sig") and form != "csv":
            # The first would open with a mark; of the other Windows would write CR CR LF.
            sys.stdout.write(text)
        else:
            sys.stdout.flush()
            sys.stdout.buffer.write(text.encode("utf-8"))
        sys.stdout.flush()


def _is_utf8(encoding: str) -> bool:
    return encoding.lower().replace("_", "-") in ("utf-8", "utf8", "utf-8-sig")


def _quoted(text: str, encoding: str) -> str:
    """Return somebody's own words so that a stream can take them; rules load where needed."""
    text = encodable_name(text)
    if _is_utf8(encoding):
        return text
    from symbalance.cli.ascii_spelling import as_quoted

    return as_quoted(text, encoding)


def _spelled(text: str, form: str, encoding: str) -> str:
    """Return a text or JSON so that a stream can take it."""
    if _is_utf8(encoding):
        return text
    from symbalance.cli.ascii_spelling import as_encodable, as_json

    return as_json(text, encoding) if form == "json" else as_encodable(text, encoding)


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
