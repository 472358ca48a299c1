"""Delimited mathematics: dollars, \\( \\), \\[ \\] and environments."""

from __future__ import annotations

import re
from dataclasses import dataclass

from symbalance.document.wordlists import word_set
from symbalance.notes.reading.failures import ReadingError

ENVIRONMENTS = word_set(
    "equation align aligned gather gathered eqnarray multline split displaymath flalign alignat alignedat"
    " math dmath"
)
_NAMES = "|".join(sorted(ENVIRONMENTS | {"cases", "array", "dcases"}, key=len, reverse=True))
_OPENER = re.compile(rf"\\\\|\\\$|\$\$|\$|\\\(|\\\[|\\begin\s*\{{((?:{_NAMES})\*?)\}}")
_COLUMNS = re.compile(r"\s*\{\s*[0-9]+\s*\}")
_IN_BRACES = re.compile(r"\\[A-Za-z]+|\{[^{}]*\}")
_LONG_WORD = re.compile(r"[A-Za-z]{4,}")
_DOLLAR = re.compile(r"(?<!\\)\$")


@dataclass(frozen=True, slots=True)
class Region:
    """Mathematics from `start` to `end`; with its delimiters from `first` to `last`."""

    first: int
    start: int
    end: int
    last: int
    display: bool
    environment: str = ""


class RegionFinder:
    """Finds delimited mathematics; `tex` takes every dollar as a delimiter."""

    def __init__(self, text: str, tex: bool) -> None:
        self.text, self.tex = text, tex
        self.regions: list[Region] = []
        self.failures: list[ReadingError] = []
        self._missing: set[str] = set()

    def run(self) -> None:
        """Fill `regions` and `failures`."""
        place = 0
        while found := _OPENER.search(self.text, place):
            place = self._from(found)

    def _from(self, found: re.Match[str]) -> int:
        opener = found.group()
        if opener in ("\\\\", "\\$"):
            return found.end()
        if opener == "$":
            return self._dollar(found)
        environment = found.group(1) or ""
        closer = {"$$": "$$", "\\(": "\\)", "\\[": "\\]"}.get(opener) or f"\\end{{{environment}}}"
        end = -1 if closer in self._missing else self.text.find(closer, found.end())
        if end < 0:
            self._fail(found, closer)
            return found.end()
        whole = environment.rstrip("*") in ("cases", "array", "dcases")
        columns = _COLUMNS.match(self.text, found.end()) if "alignat" in environment else None
        start, stop = (columns.end() if columns else found.end()), end
        if whole:
            start, stop = found.start(), end + len(closer)
        display = opener != "\\("
        last = end + len(closer)
        self.regions.append(Region(found.start(), start, stop, last, display, environment.rstrip("*")))
        return last

    def _fail(self, found: re.Match[str], closer: str) -> None:
        if closer not in self._missing:
            what = f"{found.group()} without {closer}"
            self.failures.append(ReadingError(found.start(), what, "close the mathematics"))
        self._missing.add(closer)

    def _dollar(self, found: re.Match[str]) -> int:
        """A dollar opens where a dollar closes before the next empty line; elsewhere it is money."""
        start = found.end()
        closing = _DOLLAR.search(self.text, start) if "$" not in self._missing else None
        if closing is None:
            if self.tex:
                self._fail(found, "$")
            self._missing.add("$")
            return start
        inside = self.text[start : closing.start()]
        if "\n\n" in inside or (not self.tex and not _is_mathematics(inside, self.text, closing.end())):
            if self.tex:
                self._fail(found, "$")
            return start
        self.regions.append(Region(found.start(), start, closing.start(), closing.end(), False))
        return closing.end()


def _is_mathematics(inside: str, text: str, after: int) -> bool:
    """Tell dollars around mathematics from two sums of money."""
    if not inside.strip() or "\n" in inside.strip("\n"):
        return inside.count("\n") <= 3 and bool(inside.strip())
    if text[after : after + 1].isdecimal() or inside[0].isspace() != inside[-1].isspace():
        return False
    return len(_LONG_WORD.findall(_IN_BRACES.sub(" ", inside))) < 2
