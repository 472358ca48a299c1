"""The sidecar a document still needs: its undeclared letters, ready to be given their meanings."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from symbalance.document.formula import Name
from symbalance.document.text_writer import formula_text
from symbalance.notes.checking.documents import declarations_of, text_of
from symbalance.notes.checking.meanings import KNOWN
from symbalance.notes.reading import read_document

_UNDECLARED = re.compile(r"letter (\S+) is not declared$")
MOST_ROUNDS = 60


def sidecar_draft(document: str | Path, symbols: Mapping[str, Any] | str | Path | None = None) -> str:
    """Return a sidecar with an entry for each undeclared letter, and the line it first stands on.

    `symbols` declares some already, as it does for `check`.
    """
    found = undeclared(document, symbols)
    lines = ["[symbols]"]
    for name, line in sorted(found.items(), key=lambda pair: pair[1]):
        lines.append(f'"{formula_text(Name(name), plain=True)}" = ""{"":12}# line {line}')
    known = "\n".join(f"#   {meaning}" for meaning in KNOWN)
    return (
        "\n".join(lines)
        + f"\n\n# meanings the checker knows; any other text is just a letter:\n{known}\n"
    )


def undeclared(
    document: str | Path, symbols: Mapping[str, Any] | str | Path | None = None
) -> dict[str, int]:
    """Return the letters of a document that are not declared, and where each is first missed.

    >>> undeclared("$$E = m c^2$$")
    {'m': 1, 'c': 1}
    """
    text, name, _ = text_of(document)
    declarations, text = declarations_of(document, symbols, text, name)
    found: dict[str, int] = {}

    def names_at(line: int) -> set[str]:
        return {*declarations.symbols_at(line), *found}

    for _ in range(MOST_ROUNDS):
        read = read_document(text, name, names_at)
        missing = [(_UNDECLARED.search(u.what), u.line) for u in read.unreadable]
        fresh = {m[1]: line for m, line in reversed(missing) if m and m[1] not in found}
        if not fresh:
            break
        found.update(fresh)
    return found
