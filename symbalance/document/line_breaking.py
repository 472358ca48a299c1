"""Long equations broken into lines: before a sign, and inside brackets only where it must be.

An equation becomes pieces that may not be split, nested as its brackets are. A piece that does not fit
what is left of a line goes to the next one; one that fits no line is broken at the signs inside it.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import pairwise

from symbalance.document.formula import Formula, Sum, Times
from symbalance.document.writer import Writer


@dataclass(frozen=True, slots=True)
class Piece:
    """Something printed, its width, and the smaller pieces it may be broken into (none: it may not)."""

    printed: str
    width: float
    inside: tuple[Piece, ...] = ()


@dataclass(slots=True)
class Line:
    """A line as it fills up; `depth` counts the brackets it continues."""

    depth: int
    printed: str
    width: float


def broken(relation: str, right: Formula, writer: Writer, room: float, indent: float) -> list[Line]:
    """Return `relation right` in lines no wider than `room` where that can be.

    Each bracket a line continues takes up `indent` of its room.

    >>> from symbalance.document.text_writer import TextWriter
    >>> from symbalance.document.formula import Name
    >>> a, b, c = map(Name, "abc")
    >>> [line.printed for line in broken("=", a * (a + b * (a + b) - c), TextWriter(), 14, 2)]
    ['= a [a', '+ b (a + b)', '− c]']
    """
    piece = _glued(_piece(right, writer), f"{relation} ", "", writer)
    done = [Line(0, "", 0)]
    _fill((piece,), done, room, indent, 0)
    return done


def _fill(pieces: Iterable[Piece], done: list[Line], room: float, indent: float, depth: int) -> None:
    for piece in pieces:
        fresh = not done[-1].printed
        if done[-1].width + piece.width <= room or (fresh and not piece.inside):
            done[-1].printed += piece.printed.lstrip() if fresh else piece.printed
            done[-1].width += piece.width
        elif not piece.inside or (not fresh and depth * indent + piece.width <= room):
            done.append(Line(depth, piece.printed.lstrip(), depth * indent + piece.width))
        else:
            if not fresh:
                done.append(Line(depth, "", depth * indent))
            _fill(piece.inside, done, room, indent, depth + 1)


def _piece(value: Formula, writer: Writer) -> Piece:
    if isinstance(value, Sum):
        signs = [writer.minus if value.terms[0][0] < 0 else ""]
        signs += [f" {'+' if sign > 0 else writer.minus} " for sign, _ in value.terms[1:]]
        terms = [
            _glued(
                _bracketed(term, writer) if isinstance(term, Sum) else _piece(term, writer),
                sign,
                "",
                writer,
            )
            for sign, (_, term) in zip(signs, value.terms, strict=True)
        ]
        return _joined(terms)
    if isinstance(value, Times) and any(isinstance(factor, Sum) for factor in value.factors):
        return _product(value, writer)
    printed = writer.write(value)
    return Piece(printed, writer.width(printed))


def _product(value: Times, writer: Writer) -> Piece:
    """Return a product that may be broken inside the last of its bracketed factors."""
    factors = value.factors
    place, inner = [(i, factor) for i, factor in enumerate(factors) if isinstance(factor, Sum)][-1]
    between = [writer.product(left, right) for left, right in pairwise(factors)]
    before = "".join(writer.factor(factors[i]) + between[i] for i in range(place))
    after = "".join(between[i] + writer.factor(factors[i + 1]) for i in range(place, len(between)))
    return _glued(_bracketed(inner, writer), before, after, writer)


def _bracketed(value: Sum, writer: Writer) -> Piece:
    left, right = writer.fences(value)
    return _glued(_piece(value, writer), left, right, writer)


def _glued(piece: Piece, before: str, after: str, writer: Writer) -> Piece:
    """Return a piece with something unbreakable before its first part and after its last."""
    if not piece.inside:
        return Piece(
            before + piece.printed + after, writer.width(before) + piece.width + writer.width(after)
        )
    first, *rest = piece.inside
    parts = [_glued(first, before, "" if rest else after, writer), *rest]
    if rest:
        parts[-1] = _glued(parts[-1], "", after, writer)
    return _joined(parts)


def _joined(parts: list[Piece]) -> Piece:
    return Piece("".join(p.printed for p in parts), sum(p.width for p in parts), tuple(parts))
