"""Rewriting of a text for the reader, every character of the result knowing where it comes from.

Macros, units of measure and other people's delimiters are put into plain LaTeX before anything is read;
what is read of the result is then placed in the document again, so that a report quotes the author.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable
from dataclasses import dataclass, field

Span = tuple[int, int]
_OPENING, _CLOSING = ("\\(", "\\[", "$"), ("\\)", "\\]", "$")
"""What marks of formulas become: each stands for its own mark, not for the formula between."""


@dataclass(frozen=True, slots=True)
class Piece:
    """Some text and the stretch of the document it stands for.

    `exact`: it is that stretch, character by character; else all of it stands for the whole stretch.
    """

    text: str
    start: int
    end: int
    exact: bool


@dataclass(frozen=True, slots=True)
class Rewritten:
    """A text made of pieces, with the places they come from."""

    text: str
    pieces: tuple[Piece, ...]
    begins: tuple[int, ...] = field(repr=False)

    def span(self, span: Span) -> Span:
        """Return where a span of the rewritten text stands in the document."""
        first = self._at(span[0], False)
        if span[1] <= span[0]:
            return first[0], first[0]
        last = self._at(span[1] - 1, True)
        return min(first[0], last[0]), max(first[1], last[1])

    def offset(self, offset: int) -> int:
        """Return where a character stands in the document."""
        return self._at(offset, False)[0]

    def _at(self, offset: int, is_last: bool) -> Span:
        """Return the stretch that a character stands for; an exact piece gives the character's own."""
        if not self.pieces:
            return offset, offset
        number = max(bisect_right(self.begins, offset) - 1, 0)
        piece = self.pieces[number]
        if not piece.exact:
            return piece.start, piece.end
        place = min(piece.start + offset - self.begins[number], piece.end)
        return place, min(place + 1, piece.end) if is_last else place

    def after(self, before: Rewritten | None) -> Rewritten:
        """Return this rewriting of a rewritten text as one of the first text."""
        if before is None:
            return self
        pieces: list[Piece] = []
        for piece in self.pieces:
            pieces += before.taken(piece)
        return rewritten(pieces)

    def taken(self, piece: Piece) -> Iterable[Piece]:
        """Yield a piece of a text made from this one as pieces of the document."""
        if not piece.exact:
            yield Piece(piece.text, *self.span((piece.start, piece.end)), False)
            return
        place, done = piece.start, 0
        number = max(bisect_right(self.begins, place) - 1, 0)
        while done < len(piece.text):
            inner = self.pieces[number]
            within = place - self.begins[number]
            length = min(len(inner.text) - within, len(piece.text) - done)
            text = piece.text[done : done + length]
            if inner.exact:
                yield Piece(text, inner.start + within, inner.start + within + length, True)
            else:
                yield Piece(text, inner.start, inner.end, False)
            done, place, number = done + length, place + length, number + 1


def rewritten(pieces: Iterable[Piece]) -> Rewritten:
    """Return the text that pieces make up, empty ones left out."""
    kept = tuple(piece for piece in pieces if piece.text)
    begins, place = [], 0
    for piece in kept:
        begins.append(place)
        place += len(piece.text)
    return Rewritten("".join(piece.text for piece in kept), kept, tuple(begins))


class Rewriter:
    """Builds a rewritten text from left to right: what is replaced, and the rest as it stands.

    Line ends of what is replaced stand in what replaces it or follow it: every line keeps its number.

    >>> rewriter = Rewriter("a = \\\\x b")
    >>> rewriter.replace(4, 6, "12")
    >>> done = rewriter.finish()
    >>> done.text, done.span((4, 6)), done.span((7, 8))
    ('a = 12 b', (4, 6), (7, 8))
    """

    def __init__(self, text: str) -> None:
        self.text, self.place = text, 0
        self.pieces: list[Piece] = []

    def replace(self, start: int, end: int, *texts: str | Span) -> None:
        """Put texts, and spans of the document's own, in place of a stretch at or after the last one."""
        self._keep(start)
        done = start
        for text in texts:
            if isinstance(text, str):
                self.pieces.append(Piece(text, *_stretch(text, texts, done, start, end), False))
            elif text[0] >= done:
                self._add_lines(done, text[0], start, end)
                self.pieces += self._argument(*text, True)
                done = text[1]
            else:
                self.pieces += self._argument(*text, False)
        self._add_lines(done, end, start, end)
        self.place = end

    def _add_lines(self, first: int, last: int, start: int, end: int) -> None:
        lines = self.text.count("\n", first, last)
        if lines:
            self.pieces.append(Piece(" \n" * lines, start, end, False))

    def _argument(self, start: int, end: int, stays: bool) -> Iterable[Piece]:
        """Yield a stretch as it stands; line ends that stood there once already are blanks."""
        if start < end:
            text = self.text[start:end]
            yield Piece(text if stays else text.replace("\n", " "), start, end, True)

    def _keep(self, start: int) -> None:
        if self.place < start:
            self.pieces.append(Piece(self.text[self.place : start], self.place, start, True))

    def finish(self) -> Rewritten:
        """Return the whole, with the rest of the text."""
        self._keep(len(self.text))
        self.place = len(self.text)
        return rewritten(self.pieces)


def _stretch(text: str, texts: tuple[str | Span, ...], done: int, start: int, end: int) -> Span:
    """Return the stretch that a text put in stands for: all that is replaced, or a formula's mark."""
    inner = [span for span in texts if not isinstance(span, str)]
    if len(inner) != 1:
        return start, end
    if done == start and text in _OPENING:
        return start, inner[0][0]
    return (inner[0][1], end) if done == inner[0][1] and text in _CLOSING else (start, end)
