"""Reading whole documents, single equations and single expressions."""

from __future__ import annotations

from collections.abc import Callable, Collection
from pathlib import PurePath

from symbalance.document.formula import Formula
from symbalance.notes.reading.assembly import Assembler
from symbalance.notes.reading.drafts import Draft, without_aside
from symbalance.notes.reading.equations import Chain, Document, Relation, Side, Unreadable
from symbalance.notes.reading.failures import ReadingError
from symbalance.notes.reading.items import Item, ItemFinder
from symbalance.notes.reading.lexer import lex
from symbalance.notes.reading.masking import narrowed
from symbalance.notes.reading.readings import read_tokens
from symbalance.notes.reading.tokens import Token

LONGEST_DOCUMENT = 1_000_000


def read_document(text: str, name: str, names_at: Callable[[int], Collection[str]]) -> Document:
    """Return the equations of a text; `names_at` tells the letters declared at each line.

    >>> document = read_document("where F = m a holds", "", lambda line: {"m", "a"})
    >>> document.source(document.chains[0].sides[1].span)
    'm a'
    """
    if len(text) > LONGEST_DOCUMENT:
        what = f"a document of more than {LONGEST_DOCUMENT} characters"
        return Document(name, text, (), (Unreadable(1, 1, what, "split it", (0, 0)),))
    known: dict[int, frozenset[str]] = {}

    def names(line: int) -> frozenset[str]:
        if line not in known:
            known[line] = frozenset(names_at(line))
        return known[line]

    assembler = Assembler(ItemFinder(text, PurePath(name).suffix.lower(), names), names)
    assembler.run()
    chains = sorted(assembler.chains, key=lambda chain: chain.sides[0].span)
    refused = sorted(assembler.unreadable, key=lambda one: (one.line, one.column))
    return Document(name, text, tuple(chains), tuple(refused))


def read_expression(text: str, names: Collection[str], offset: int = 0) -> tuple[Formula, ...]:
    """Return every reading of one expression, the usual one first; spans count from `offset`.

    >>> len(read_expression("1/2λ", {"lambda"})), len(read_expression("1/λ", {"lambda"}))
    (2, 1)
    """
    chain = read_equation(text, names, offset)
    if chain.relations:
        raise ReadingError(offset, "an equation where an expression belongs", "write one side only")
    return chain.sides[0].readings


def read_equation(text: str, names: Collection[str], offset: int = 0) -> Chain:
    """Return one chain a = b = c; a lone undeclared letter on the left declares itself."""
    item = Item(0, len(text), "display", True, 1, 1 + text.count("\n"))
    draft = Draft(item, set(names))
    source = narrowed(text)
    try:
        draft.add(item, without_aside(lex(source, 0, len(text), names)))
        draft.finish_alone()
        return _chain(draft, source, names, offset)
    except ReadingError as failure:
        failure.offset += offset
        raise


def _chain(draft: Draft, source: str, names: Collection[str], offset: int) -> Chain:
    known = frozenset(names) | draft.own_letter()
    sides: list[Side] = []
    for tokens in draft.sides:
        moved = [token.moved(offset) for token in tokens]
        readings, notes = _read(moved, known, offset, "\\" in source)
        draft.notes.extend(note for note in notes if note not in draft.notes)
        sides.append(Side(readings, (moved[0].start, moved[-1].end)))
    relations = tuple(Relation(t.value, source.count("\n", 0, t.start) + 1) for t in draft.signs)
    lines = tuple(range(1, draft.item.last_line + 1))
    return Chain(tuple(sides), relations, lines, notes=tuple(draft.notes))


def _read(
    tokens: list[Token], known: frozenset[str], offset: int, latex: bool
) -> tuple[tuple[Formula, ...], tuple[str, ...]]:
    try:
        return read_tokens(tokens, known, tokens[-1].end, latex)
    except ReadingError as failure:
        failure.offset -= offset
        raise
