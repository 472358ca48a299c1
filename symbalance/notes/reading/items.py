"""A document to the stretches of mathematics in it, in order."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Callable, Collection, Iterator
from dataclasses import dataclass
from itertools import islice

from symbalance.notes.reading.failures import ReadingError
from symbalance.notes.reading.masking import mask_markdown, mask_plain, mask_tex, narrowed
from symbalance.notes.reading.pieces import has_any_relation, has_relation, pieces_of
from symbalance.notes.reading.prose import line_rules, segments, trimmed_segment
from symbalance.notes.reading.regions import Region, RegionFinder
from symbalance.notes.reading.vocabulary import Vocabulary, vocabulary

_COMMAND = re.compile(r"\\[A-Za-z]+")
_BULLET = re.compile(r"\s*(?:\(?[0-9]{1,3}[.)](?=\s))?\s*")
_MARKDOWN_BULLET = re.compile(r"\s*(?:>\s*)*(?:[-*+]\s+|[0-9]{1,3}[.)]\s+)?\s*")
_DASH = re.compile(r"[-*•]\s+(?=[^\s=])")
_LONG_WORD = re.compile(r"(?<!\\)\b(?<!\\)[A-Za-z]{4,}")
_CJK = re.compile("[\u2e80-\u9fff\uac00-\ud7af\uf900-\ufaff]")
_RULE = re.compile(r"\s*([-=_*~#+])\1{2,}\s*")
LONGEST_LINE = 20_000
_MARGIN = 200
MOST_ITEMS = 20_000


@dataclass(frozen=True, slots=True)
class Item:
    """A stretch that may be an equation: display, inline (in $ $), bare (a line) or prose (in a line).

    `block` numbers the display it belongs to; `strict` tells that a refusal is to be reported.
    """

    start: int
    end: int
    kind: str
    strict: bool
    first_line: int
    last_line: int
    tag: str = ""
    block: int = -1


class ItemFinder:
    """Finds the items of one document."""

    def __init__(self, text: str, suffix: str, names_at: Callable[[int], Collection[str]]) -> None:
        self.suffix, self.names_at = suffix, names_at
        self.fences: list[tuple[int, int]] = []
        narrow = narrowed(text)
        if suffix == ".tex":
            self.text = mask_tex(narrow)
        elif suffix == ".md":
            self.text, self.fences = mask_markdown(narrow)
        else:
            self.text = mask_plain(narrow)
        self.breaks = [place for place, sign in enumerate(self.text) if sign == "\n"]
        self.failures: list[ReadingError] = []

    def line_of(self, offset: int) -> int:
        """Return the line, from 1, of an offset."""
        return bisect_right(self.breaks, offset - 1) + 1

    def line_span(self, line: int) -> tuple[int, int]:
        """Return where a line begins and ends."""
        start = self.breaks[line - 2] + 1 if line > 1 else 0
        return start, self.breaks[line - 1] if line <= len(self.breaks) else len(self.text)

    def run(self) -> list[Item]:
        """Return the items, in order."""
        finder = RegionFinder(self.text, self.suffix == ".tex")
        finder.run()
        self.failures += finder.failures
        regions = [region for region in finder.regions if not self._in_fence(region)]
        regions += [Region(a, a, b, b, True) for a, b in self.fences]
        regions.sort(key=lambda region: region.first)
        items = list(islice(self._all(regions), MOST_ITEMS + 1))
        if len(items) > MOST_ITEMS:
            what = f"more than {MOST_ITEMS} stretches of mathematics"
            self.failures.append(ReadingError(items.pop().start, what, "split the document"))
        return sorted(items, key=lambda item: item.start)

    def _all(self, regions: list[Region]) -> Iterator[Item]:
        for number, region in enumerate(regions):
            if region.start < region.end:
                yield from self._of_region(region, number)
        if self.suffix != ".tex":
            yield from self._outside(regions)

    def _in_fence(self, region: Region) -> bool:
        return any(
            a < region.first < b or (a == region.first and region.start > a) for a, b in self.fences
        )

    def _of_region(self, region: Region, block: int) -> Iterator[Item]:
        alone = region.display or self._is_alone(region)
        if not alone and not has_any_relation(self.text, region.start, region.end):
            return
        kind = "display" if alone else "inline"
        for piece in pieces_of(self.text, region.start, region.end, region.environment):
            lines = self.line_of(piece.start), self.line_of(piece.end - 1)
            yield Item(piece.start, piece.end, kind, True, *lines, piece.tag, block)

    def _is_alone(self, region: Region) -> bool:
        before = self.text[max(0, region.first - _MARGIN) : region.first].rpartition("\n")
        after = self.text[region.last : region.last + _MARGIN].partition("\n")
        edges = (before[1] or region.first < _MARGIN) and (
            after[1] or region.last + _MARGIN > len(self.text)
        )
        return bool(edges) and not (before[2] + after[0]).strip(" \t.,;。、")

    def _outside(self, regions: list[Region]) -> Iterator[Item]:
        """Yield the items of lines and parts of lines outside delimiters."""
        place = 0
        for region in [*regions, None]:
            stop = region.first if region else len(self.text)
            if place < stop:
                yield from self._stretch(place, stop)
            place = max(place, region.last) if region else stop

    def _stretch(self, start: int, stop: int) -> Iterator[Item]:
        line = self.line_of(start)
        while start < stop:
            first, last = self.line_span(line)
            end = min(last, stop)
            whole = start == first and end == last
            if self.text[start:end].strip():
                yield from self._part(start, end, line, whole)
            start, line = last + 1, line + 1

    def _part(self, start: int, end: int, line: int, whole: bool) -> Iterator[Item]:
        source = self.text[start:end]
        if self.suffix == ".md" and source.lstrip().startswith(("#", "|")):
            return
        if _RULE.fullmatch(source):
            return
        words = vocabulary(self.names_at(line))
        if whole:
            start = self._after_bullet(start, end)
        command = _COMMAND.search(self.text, start, end)
        lenient = self._is_lenient(start, end)
        spans = segments(self.text, start, end, line_rules(self.text, start, end, words, lenient))
        marked = self.text.startswith("\\displaystyle", start) and not _CJK.search(self.text, start, end)
        if whole and (marked or (len(spans) == 1 and self._covers(spans[0], start, end))):
            yield from self._bare(start, end, line, command is not None)
            return
        for span in spans:
            if not self._is_argument_of_word(span[0], start):
                yield from self._segment(span, line, lenient, words)

    def _after_bullet(self, start: int, end: int) -> int:
        """Return where a line begins after its number or bullet; `- a` alone may be a term."""
        bullet = _MARKDOWN_BULLET if self.suffix == ".md" else _BULLET
        found = bullet.match(self.text, start, end)
        start = found.end() if found else start
        dash = _DASH.match(self.text, start, end)
        closing = self.text.count(")", start, end) > self.text.count("(", start, end)
        plain = "\\" not in self.text[start:end] and has_relation(self.text, start, end) and not closing
        return dash.end() if dash and plain else start

    def _is_lenient(self, start: int, end: int) -> bool:
        if self.text.find("\\displaystyle", start, end) >= 0:
            return True
        source = self.text[start:end]
        if not _COMMAND.search(source) or _CJK.search(source):
            return False
        return not _LONG_WORD.search(_COMMAND.sub(" ", source))

    def _covers(self, span: tuple[int, int], start: int, end: int) -> bool:
        around = self.text[start : span[0]] + self.text[span[1] : end]
        return not around.strip(" \t.,;∴⇒")

    def _bare(self, start: int, end: int, line: int, command: bool) -> Iterator[Item]:
        if end - start > LONGEST_LINE:
            yield Item(start, end, "bare", command, line, line)
            return
        for piece in pieces_of(self.text, start, end):
            strict = command or has_relation(self.text, piece.start, piece.end)
            yield Item(piece.start, piece.end, "bare", strict, line, line, piece.tag)

    def _is_argument_of_word(self, place: int, start: int) -> bool:
        """Tell f(x) with a word for f from brackets after a word and a space."""
        before = self.text[place - 1] if place > start else " "
        return self.text[place] in "([" and before.isascii() and before.isalnum()

    def _segment(
        self, span: tuple[int, int], line: int, lenient: bool, words: Vocabulary
    ) -> Iterator[Item]:
        if span[1] - span[0] > LONGEST_LINE or not has_any_relation(self.text, *span):
            return
        display = self.text.find("\\displaystyle", *span)
        if display >= 0:
            span = (display, span[1])
        start, end = trimmed_segment(self.text, *span, words)
        if not has_relation(self.text, start, end):
            return
        for piece in pieces_of(self.text, start, end):
            if has_relation(self.text, piece.start, piece.end):
                inner = trimmed_segment(self.text, piece.start, piece.end, words)
                yield Item(*inner, "prose", display >= 0, line, line, piece.tag)
