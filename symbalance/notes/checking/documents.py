"""A document checked as a whole: from a file or a text, with its sidecar or a mapping of letters."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from symbalance.errors import SymbalanceError, shown
from symbalance.notes.checking.engines import Engines, NoEngines, Sources
from symbalance.notes.checking.header import without_header
from symbalance.notes.checking.judging import Judge
from symbalance.notes.checking.sidecar import Declarations, declared, parse_sidecar, read_sidecar
from symbalance.notes.checking.verdicts import Checked
from symbalance.notes.reading import read_document
from symbalance.text.files import STANDARD_INPUT, file_name, read_text

SUFFIXES = (".tex", ".md", ".txt", ".text")


def check(
    document: str | Path,
    symbols: Mapping[str, Any] | str | Path | None = None,
    *,
    engines: Engines | None = None,
) -> Checked:
    """Return the verdicts on every equation of a hand derivation.

    `document` is a file (a Path, or a text that ends in .tex, .md or .txt, or `-` for standard input) or
    the derivation itself.
    `symbols` maps letters to their meaning or unit, or is a whole sidecar (keys `symbols`, `scope`,
    `bind`), or the path of one; without it NAME.symbols.toml beside the file is read, or the header of
    the document. `engines` knows the engines that lines are bound to; without it such a line is refused.

        >>> from symbalance.notes.checking import check
        >>> found = check("$$\\\\sin^2 x = \\\\frac{1 - \\\\cos 2x}{3}$$", {"x": "angle"})
        >>> found.verdicts[0].verdict, found.verdicts[0].fix.text
        ('refuted', '(1 - cos 2x)/2')

    Raises SymbalanceError for a file or a declaration that cannot be used; an equation that cannot be
    read is a verdict, not an error.
    """
    text, name, folder = text_of(document)
    declarations, text = declarations_of(document, symbols, text, name)
    found = read_document(text, name, _remembered(declarations))
    beside = Path(declarations.place).parent if declarations.place.endswith(".toml") else folder
    return Judge(found, declarations, Sources(engines or NoEngines(), beside)).checked()


def declarations_of(
    document: str | Path, symbols: Mapping[str, Any] | str | Path | None, text: str, name: str
) -> tuple[Declarations, str]:
    """Return what is declared about a document, and its text without a header that declared it."""
    apart = _declarations(symbols, None if name == "text" else Path(document))
    body, header = without_header(text, Path(name).suffix)
    if apart is not None:
        return apart, text
    return (parse_sidecar(header, name), body) if header else (Declarations(), text)


def _remembered(declarations: Declarations) -> Any:
    """Return the letters declared for a line, each set of scopes looked up once."""
    known: dict[tuple[int, ...], frozenset[str]] = {}

    def names_at(line: int) -> frozenset[str]:
        key = declarations.scope_at(line)
        if key not in known:
            known[key] = frozenset(declarations.symbols_at(line))
        return known[key]

    return names_at


def text_of(document: str | Path) -> tuple[str, str, Path]:
    """Return a document's text, its name and its folder; a text without a file is called `text`."""
    if not isinstance(document, str | Path):
        raise SymbalanceError(
            f"document = {shown(document)}", "must be a path or a text", 'write check("notes.md")'
        )
    if isinstance(document, str) and ("\n" in document or not is_file_name(document)):
        return document, "text", Path()
    path = Path(document)
    return read_text(path, what="a .tex, .md or .txt file"), file_name(path), path.parent


def is_file_name(document: str) -> bool:
    """Tell whether a text is the name of a file of notes, or `-` for standard input."""
    return document == STANDARD_INPUT or document.endswith(SUFFIXES)


def _declarations(
    symbols: Mapping[str, Any] | str | Path | None, path: Path | None
) -> Declarations | None:
    """Return what is declared apart from the document; None where it may have a header of its own."""
    if isinstance(symbols, Mapping):
        return declared(symbols)
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
