"""The hand derivation measured by `symbalance bench check`, with the list of its known errors.

`page.md` is read with `page.symbols.toml`, as a user's notes are; `page.truth.toml` lists its known
errors by line, with what belongs there, and the values of its letters, for numbers that need no checker.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from typing import Any

from symbalance.checking import check
from symbalance.document.formula import names
from symbalance.notes.checking.verdicts import Checked
from symbalance.notes.reading import canonical_name, read_document
from symbalance.notes.reading.equations import Chain, ReadNotes

PAGE = files("symbalance.bench") / "page.md"
WORKSHOP_PAGE = files("symbalance.bench") / "workshop_page.md"
"""An engineer's notes, with their letters beside them, of which only the time is measured."""


@dataclass(frozen=True)
class KnownError:
    """A known error: its line, the number of its relation there, the wrong text and the right one."""

    line: int
    wrong: str
    right: str
    link: int = 1


@dataclass(frozen=True)
class Page:
    """The page as written, its declarations, its known errors, and the values of its letters."""

    text: str
    sidecar: Mapping[str, Any]
    errors: tuple[KnownError, ...]
    values: Mapping[str, str]
    definitions: Mapping[str, int]

    @property
    def corrected(self) -> str:
        """The page with every known error put right."""
        lines = self.text.split("\n")
        for error in self.errors:
            if error.wrong not in lines[error.line - 1]:
                raise ValueError(f"page.truth.toml: line {error.line} does not hold {error.wrong}")
            lines[error.line - 1] = lines[error.line - 1].replace(error.wrong, error.right)
        return "\n".join(lines)

    @property
    def defining(self) -> frozenset[int]:
        """The lines on which a letter gets its value."""
        return frozenset(self.definitions.values())

    @property
    def letters(self) -> frozenset[str]:
        """The letters declared, by their canonical names."""
        return frozenset(canonical_name(letter) for letter in self.sidecar["symbols"])

    def read(self, text: str) -> ReadNotes:
        """Return the equations of a text in the letters of this page."""
        return read_document(text, "page.md", lambda _: self.letters)

    def check(self, text: str, lines: Collection[int] | None = None) -> Checked:
        """Return the verdicts on a text in this page's letters; binds only of `lines`, if given."""
        binds = [b for b in self.sidecar.get("bind", []) if lines is None or b["line"] in lines]
        return check(text, {"symbols": self.sidecar["symbols"], "bind": binds})


@cache
def bench_page() -> Page:
    """Return the page that comes with the package."""
    folder = files("symbalance.bench")
    truth = tomllib.loads((folder / "page.truth.toml").read_text(encoding="utf-8"))
    return Page(
        PAGE.read_text(encoding="utf-8"),
        tomllib.loads((folder / "page.symbols.toml").read_text(encoding="utf-8")),
        tuple(KnownError(**error) for error in truth["error"]),
        truth["values"],
        {canonical_name(letter): line for letter, line in truth["definitions"].items()},
    )


@dataclass(frozen=True)
class Block:
    """A paragraph of the page: its lines, the letters in it, and those it defines."""

    lines: range
    letters: frozenset[str]
    defines: frozenset[str]


def blocks(page: Page, document: ReadNotes) -> list[Block]:
    """Return the paragraphs of a document of this page that hold relations."""
    paragraphs = []
    for match in re.finditer(r"(?:[^\n]+\n?)+", document.text):
        first = document.line_of(match.start())
        lines = range(first, document.line_of(match.end() - 2) + 1)
        inside = [c for c in document.chains if c.relations and c.lines[0] in lines]
        if inside:
            letters = frozenset().union(*(names(side.node) for c in inside for side in c.sides))
            defines = frozenset(name for name, line in page.definitions.items() if line in lines)
            paragraphs.append(Block(lines, letters, defines))
    return paragraphs


def context(selection: Iterable[Block], every: Iterable[Block], follow: bool = False) -> list[Block]:
    """Return paragraphs with those before them that define their letters.

    With `follow` also the later ones that use the letters which the selected paragraphs define.
    """
    every, needed = list(every), list(selection)
    if follow:
        letters = frozenset().union(*(block.defines for block in needed))
        needed += [block for block in every if block.letters & letters and block not in needed]
    for block in needed:  # grows while it is read: a definition may need another
        needed += [
            b
            for b in every
            if b.defines & block.letters and b.lines[0] < block.lines[0] and b not in needed
        ]
    return sorted(needed, key=lambda block: block.lines[0])


def place_of(chain: Chain, k: int) -> tuple[int, int]:
    """Return the line of a chain's k-th relation and its number among those on that line."""
    line = chain.relations[k].line
    return line, 1 + sum(relation.line == line for relation in chain.relations[:k])


def with_blocks_alone(text: str, selection: Iterable[Block], earlier: Iterable[str] = ()) -> str:
    """Return a text with everything but some paragraphs blank; what remains keeps its lines.

    The first line is given to the `earlier` letters of what is blank, for the checker takes a relation
    that holds a letter for the first time as one that may fix it.
    """
    lines = {line for block in selection for line in block.lines}
    rows = [row if n in lines else "" for n, row in enumerate(text.split("\n"), 1)]
    letters = " ".join(rf"\{name}" if len(name) > 1 else name for name in sorted(earlier))
    return "\n".join([f"$$ {letters} = {letters} $$" if letters else rows[0], *rows[1:]])
