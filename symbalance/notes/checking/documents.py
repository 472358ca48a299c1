"""Checking of a whole document, a file or a text, with the declarations of its letters.

`sidecar_draft` writes the sidecar a document still needs: its undeclared letters, to be given meanings.
"""

from __future__ import annotations

import re
import time
from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import Any

from symbalance.budgets import Budget, run_within
from symbalance.document.formula import Name
from symbalance.document.text_writer import formula_text
from symbalance.errors import SymbalanceError, brief
from symbalance.notes.checking.engines import Engines, NoEngines, Sources
from symbalance.notes.checking.judging import PAGE, Judge
from symbalance.notes.checking.one_reading import judge_in_one_reading
from symbalance.notes.checking.sidecar import (
    Declarations,
    declarations_in,
    parse_sidecar,
    read_sidecar,
    without_header,
)
from symbalance.notes.checking.symbol_roles import KNOWN
from symbalance.notes.checking.verdicts import Checked
from symbalance.notes.reading import read_document
from symbalance.notes.reading.equations import ReadNotes
from symbalance.notes.reading.notebooks import SUFFIX as NOTEBOOK
from symbalance.notes.reading.notebooks import notebook_text
from symbalance.text.files import STANDARD_INPUT, file_name, read_text

IN_FOLDERS = (".tex", ".md", ".txt", ".text", ".ipynb", ".markdown", ".latex", ".wiki", ".adoc")
"""What is taken for notes in a folder; web pages only by their names, as reports are web pages too."""
SUFFIXES = (*IN_FOLDERS, ".mediawiki", ".asciidoc", ".html", ".htm", ".xhtml")
_UNDECLARED = re.compile(r"letter (\S+) is not declared$")
MOST_ROUNDS = 60
"""Each round of reading finds the first undeclared letter of every equation."""


def check(
    document: str | Path,
    symbols: Mapping[str, Any] | str | Path | None = None,
    *,
    engines: Engines | None = None,
    budget: Budget = PAGE,
) -> Checked:
    """Return the verdicts on every equation of a hand derivation.

    `document` is a file (a Path, or a text that ends as one of SUFFIXES, or `-` for standard input) or
    the derivation itself.
    `symbols` maps letters to their meaning or unit, or is a whole sidecar (keys `symbols`, `scope`,
    `bind`), or the path of one; without it NAME.symbols.toml beside the file is read, or the header of
    the document. `engines` knows the engines that lines are bound to; without it such a line is refused.
    `budget` is what the document may take, each relation a 60th of the time and a quarter of the memory;
    what takes more is "undecided" with that reason.

        >>> from symbalance.notes.checking import check
        >>> checked = check("$$\\\\sin^2 x = \\\\frac{1 - \\\\cos 2x}{3}$$", {"x": "angle"})
        >>> checked.verdicts[0].verdict, checked.verdicts[0].fix.text
        ('refuted', '(1 - cos 2x)/2')

    Raises SymbalanceError for a file or a declaration that cannot be used; an equation that cannot be
    read is a verdict, not an error.
    """
    text, name, folder = text_of(document)
    declarations, text = declarations_of(document, symbols, text, name)
    page = run_within(budget, partial(read_document, text, name, _letters_by_line(declarations)))
    beside = Path(declarations.place).parent if declarations.place.endswith(".toml") else folder
    sources = Sources(engines or NoEngines(), beside)
    start = time.monotonic()

    def judge(notes: ReadNotes) -> Checked:
        """Judge a reading of the page in what is left of its budget."""
        seconds, memory = budget
        left = None if seconds is None else max(seconds - (time.monotonic() - start), 0.01)
        return Judge(notes, declarations, sources, Budget(left, memory)).check()

    return judge_in_one_reading(page, judge)


def declarations_of(
    document: str | Path, symbols: Mapping[str, Any] | str | Path | None, text: str, name: str
) -> tuple[Declarations, str]:
    """Return what is declared about a document, and its text without a header that declared it."""
    declarations = _declarations_apart(symbols, None if name == "text" else Path(document))
    body, header = without_header(text, Path(name).suffix)
    if declarations is not None:
        return declarations, text
    return (parse_sidecar(header, name), body) if header else (Declarations(), text)


def _letters_by_line(declarations: Declarations) -> Any:
    """Return the letters declared for a line, each set of scopes looked up once."""
    cache: dict[tuple[int, ...], frozenset[str]] = {}

    def names_at(line: int) -> frozenset[str]:
        key = declarations.scope_at(line)
        if key not in cache:
            cache[key] = frozenset(declarations.symbols_at(line))
        return cache[key]

    return names_at


def text_of(document: str | Path) -> tuple[str, str, Path]:
    """Return a document's text, its name and its folder; a text without a file is called `text`."""
    if not isinstance(document, str | Path):
        raise SymbalanceError(
            f"document = {brief(document)}", "must be a path or a text", 'write check("notes.md")'
        )
    if isinstance(document, str) and ("\n" in document or not is_file_name(document)):
        return document, "text", Path()
    path = Path(document)
    text, name = (
        read_text(path, what="a .tex, .md, .txt, .ipynb, .wiki, .html or .adoc file"),
        file_name(path),
    )
    is_notebook = path.suffix.lower() == NOTEBOOK
    return (notebook_text(text, name) if is_notebook else text), name, path.parent


def is_file_name(document: str) -> bool:
    """Tell whether a text is the name of a file of notes, or `-` for standard input."""
    return document == STANDARD_INPUT or document.endswith(SUFFIXES)


def _declarations_apart(
    symbols: Mapping[str, Any] | str | Path | None, path: Path | None
) -> Declarations | None:
    """Return what is declared apart from the document; None where it may have a header of its own."""
    if isinstance(symbols, Mapping):
        return declarations_in(symbols)
    if symbols is not None:
        return read_sidecar(symbols)
    if path is not None:
        for beside in sidecars_beside(path):
            return read_sidecar(beside)
    return None


def sidecars_beside(path: Path) -> list[Path]:
    """Return the sidecars that lie beside a document; the first is its own. A pipe has none."""
    if not path.name or str(path) == STANDARD_INPUT:
        return []
    names = (f"{path.stem}.symbols.toml", f"{path.name}.symbols.toml")
    return [beside for name in names if (beside := path.with_name(name)).exists()]


# The sidecar a document still needs


def sidecar_draft(document: str | Path, symbols: Mapping[str, Any] | str | Path | None = None) -> str:
    """Return a sidecar with an entry for each undeclared letter, and the line it first stands on.

    `symbols` declares some already, as it does for `check`.
    """
    letters = undeclared_letters(document, symbols)
    lines = ["[symbols]"]
    for name, line in sorted(letters.items(), key=lambda pair: pair[1]):
        lines.append(f'"{formula_text(Name(name), plain=True)}" = ""{"":12}# line {line}')
    meanings = "\n".join(f"#   {meaning}" for meaning in KNOWN)
    return (
        "\n".join(lines)
        + f"\n\n# meanings the checker knows; any other text is just a letter:\n{meanings}\n"
    )


def undeclared_letters(
    document: str | Path, symbols: Mapping[str, Any] | str | Path | None = None
) -> dict[str, int]:
    """Return the letters of a document that are not declared, and where each is first missed.

    >>> undeclared_letters("$$E = m c^2$$")
    {'m': 1, 'c': 1}
    """
    text, name, _ = text_of(document)
    declarations, text = declarations_of(document, symbols, text, name)
    letters: dict[str, int] = {}

    def names_at(line: int) -> set[str]:
        return {*declarations.symbols_at(line), *letters}

    for _ in range(MOST_ROUNDS):
        page = read_document(text, name, names_at)
        missing = [(_UNDECLARED.search(u.what), u.line) for u in page.unreadable]
        new_letters = {m[1]: line for m, line in reversed(missing) if m and m[1] not in letters}
        if not new_letters:
            break
        letters.update(new_letters)
    return letters
