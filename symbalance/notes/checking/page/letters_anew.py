"""Letters that a page uses anew: a is declared the acceleration, and here a = 88 mm is a distance.

A declaration is of a whole page, often of a whole course. Where a section gives a letter of a motion or
a force a length in numbers, or adds it to lengths that stand still (b = l - a), the letter is the page's
own there: from then on it is a length, and nothing that the declaration says of it counts.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

from symbalance.document.formula import Formula, Name, Negative, Sum, names, walk
from symbalance.notes.checking.declared.sidecar import Declarations, Scope
from symbalance.notes.checking.declared.symbol_roles import (
    FROM_MIDDLE,
    FROM_PIN,
    FROM_TOP,
    MOVING,
    role_of,
)
from symbalance.notes.checking.units.dimensions import unit_of, written_unit
from symbalance.notes.checking.words.sections import Sections
from symbalance.notes.reading.equations import Chain, ReadNotes

_MOVED = {*MOVING} - {FROM_TOP, FROM_PIN, FROM_MIDDLE}
"""Meanings that are no length: a letter of a piston's place may well be given in mm."""
_STILL = ("crank radius", "stroke", "rod length", "cylinder pitch")


def with_letters_anew(page: ReadNotes, declarations: Declarations) -> tuple[ReadNotes, Declarations]:
    """Return a page and its declarations with a scope for each letter that a section uses anew."""
    sections, scopes, notes = Sections(page), list[Scope](), list[str]()
    for chain in page.chains:
        line = chain.lines[0]
        symbols = declarations.symbols_at(line)
        for name, unit in _used_anew(chain, page, symbols):
            if any(scope.holds(line) and name in scope.symbols for scope in scopes):
                continue
            first, last = _reach(page, sections, chain, name)
            scopes.append(Scope(first, last, {name: f"used anew here, {unit}"}, by_page=True))
            kind = role_of(symbols[name])
            notes.append(f"{name} is declared {kind}; in lines {first} to {last} it is in {unit}")
    if not scopes:
        return page, declarations
    page = replace(page, notes=(*page.notes, *notes))
    return page, replace(declarations, scopes=(*declarations.scopes, *scopes))


def _used_anew(chain: Chain, page: ReadNotes, symbols: Mapping[str, str]) -> Iterator[tuple[str, str]]:
    """Yield the letters of motions that a chain uses as something else, with the unit they have there."""
    moved = {name for name, text in symbols.items() if role_of(text) in _MOVED}
    for before, after in zip(chain.sides, chain.sides[1:], strict=False):
        head = before.node
        if isinstance(head, Name) and head.name in moved and not names(after.node):
            has_number, unit = written_unit(page.source(after.span))
            own = unit_of(unit) if has_number and unit else None
            if own is not None and own == unit_of("m"):
                yield head.name, "m"
    everything = {n for side in chain.sides for n in names(side.node)}
    if any(role_of(symbols.get(n, "")) in ("angular speed", "crank angle", "time") for n in everything):
        return
    for side in chain.sides:
        for total in (part for part in walk(side.node) if isinstance(part, Sum)):
            letters = [term.name for term in map(_bare, total.terms) if isinstance(term, Name)]
            if any(role_of(symbols.get(n, "")) in _STILL for n in letters):
                yield from ((n, "m") for n in letters if n in moved)


def _bare(term: Formula) -> Formula:
    return term.operand if isinstance(term, Negative) else term


def _reach(page: ReadNotes, sections: Sections, chain: Chain, name: str) -> tuple[int, int]:
    """Return the lines a letter is used anew in: its section, or what of it follows its declared use."""
    line, last = chain.lines[0], sections.section_end(chain.lines[0])
    first = line
    while first > 1 and sections.same_section(first - 1, line):
        first -= 1
    declared = [
        other
        for other in page.chains
        if first <= other.lines[0] <= last
        and isinstance(other.sides[0].node, Name)
        and other.sides[0].node.name == name
        and any(names(side.node) for side in other.sides[1:])
    ]
    return (sections.paragraph_start(line) if declared else first), last
