"""How far a premise stated in prose reaches: "Take r = 1" to the next heading, a caption its paragraph."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cached_property

from symbalance.notes.reading.equations import Chain, ReadNotes

_HEADING = re.compile(
    r"#{1,6}\s|={2,6}\s*\S.*|<h[1-6]\b"
    r"|\\(?:part|chapter|(?:sub){0,2}section|paragraph|subparagraph)\*?\s*[\[{]",
    re.IGNORECASE,
)
_UNDERLINE = re.compile(r"(?:={3,}|-{3,})\s*$")
_CAPTION = re.compile(
    r"\s*(?:[*_]{0,2}(?:figure|fig\.|table|tab\.|abbildung|abb\.|bild|tabelle)\s*[\d.:a-z(]|図|表|!\[|\\caption\b)",
    re.IGNORECASE,
)
_INTRODUCTION = re.compile(
    r"(?<![A-Za-z])(?:take|let|for|if|assume|assuming|suppose|supposing|when|whenever|choose|put|set|setting|at|with"
    r"|für|bei|falls|wenn|sei|seien|nimm|setze|setzt man|angenommen)\s[^.;:!?\n$=]{0,30}$",
    re.IGNORECASE,
)
LONGEST_INTRODUCTION = 60
"""Characters before a relation in which such a word is looked for."""


@dataclass(frozen=True)
class Sections:
    """The headings and paragraphs of a document."""

    document: ReadNotes

    @cached_property
    def _lines(self) -> list[str]:
        return self.document.text.split("\n")

    @cached_property
    def _headings(self) -> list[int]:
        """The lines, from 1, that begin a section."""
        marked = [k for k, line in enumerate(self._lines, 1) if _HEADING.match(line.lstrip())]
        underlined = [
            k
            for k in range(1, len(self._lines))
            if _UNDERLINE.match(self._lines[k]) and self._lines[k - 1].strip()
        ]
        return sorted({*marked, *underlined})

    def section_end(self, line: int) -> int:
        """Return the last line of the section that a line stands in."""
        after = [heading for heading in self._headings if heading > line]
        return after[0] - 1 if after else len(self._lines)

    def paragraph_end(self, line: int) -> int:
        """Return the last line of the paragraph that a line stands in."""
        for k in range(line, len(self._lines)):
            if not self._lines[k].strip():
                return k
        return len(self._lines)

    def premise_end(self, chain: Chain) -> int | None:
        """Return the last line that a relation reaches if its sentence makes it a premise, else None."""
        line = chain.lines[0]
        if chain.inline and _CAPTION.match(self._paragraph_start(line)):
            return self.paragraph_end(line)
        start = min(side.span[0] for side in chain.sides)
        before = self.document.text[max(0, start - LONGEST_INTRODUCTION) : start]
        before = re.split(r"\n\s*\n", before)[-1].rstrip(" \t\n$\\([")
        return self.section_end(line) if chain.inline and _INTRODUCTION.search(before + " ") else None

    def _paragraph_start(self, line: int) -> str:
        """Return the text of a line's paragraph from its start."""
        first = line
        while first > 1 and self._lines[first - 2].strip():
            first -= 1
        return "\n".join(self._lines[first - 1 : line])
