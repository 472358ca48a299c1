"""Proposals of what a page's letters mean and what its lines claim to be, gathered from the words around.

Nothing here is believed. A proposal goes, marked, into a draft of the symbols file; a person confirms it.

    letters     every letter and word of the page's formulas, with the line it first stands on
    roles       "s: ストローク", "where r is the crank radius", "Kurbelradius r", λ = l/s
    scopes      a letter that is introduced again with another meaning; components of a force
    bindings    what stands below a heading such as "6次慣性力", for the engine named last
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from symbalance.document.formula import names
from symbalance.document.letters import FUNCTION_WORDS
from symbalance.document.wordlists import word_set
from symbalance.notes.checking.declared.engines import Engines
from symbalance.notes.checking.declared.page_headings import LONGEST_LINE
from symbalance.notes.checking.declared.proposed_bindings import BindingsFromHeadings, BindProposal
from symbalance.notes.checking.declared.proposed_components import force_components
from symbalance.notes.checking.declared.proposed_meanings import (
    MeaningsFromWords,
    Proposal,
    ScopeProposal,
    gap_is_naming,
)
from symbalance.notes.checking.declared.role_phrases import roles_named
from symbalance.notes.reading import read_document
from symbalance.notes.reading.equations import ReadNotes
from symbalance.text import lazy_patterns as re

MOST_ROUNDS = 60
"""Each round of reading finds the first undeclared letter of every equation."""
_UNDECLARED = re.compile(r"letter (\S+) is not declared$")
_PLAIN_WORDS = word_set(
    "as at be by do go he if in is it me my no of on or so to up us we and are but can for had has let"
    " now so one our out per the two use was pi mm cm km kg kw hz nm rpm vs via etc ab am an da der die"
    " das du er es ich im ist man mit so um und von was wir wo zu tdc bdc ot ut"
)
_WORD = re.compile(r"(?<![A-Za-z\\{_.])([A-Z][a-z]{1,2}|[a-z]{2}|[A-Za-z][0-9]{1,2})(?![A-Za-z0-9({_])")


@dataclass(frozen=True, slots=True)
class Proposals:
    """All that is proposed for a page; `letters` tells the line on which each letter first stands."""

    letters: Mapping[str, int]
    meanings: Mapping[str, Proposal] = field(default_factory=dict)
    scopes: tuple[ScopeProposal, ...] = ()
    bindings: tuple[BindProposal, ...] = ()


def propose(
    text: str, name: str, names_at: Callable[[int], Collection[str]], engines: Engines
) -> Proposals:
    """Return what the words of a page propose; `names_at` tells the letters declared at each line.

    >>> from symbalance.notes.checking.declared.engines import NoEngines
    >>> page = "crank radius r, crank angle θ\\n\\n$$y = r cos θ$$"
    >>> proposed = propose(page, "page.md", lambda line: (), NoEngines())
    >>> [(p.letter, p.meaning) for p in proposed.meanings.values()]
    [('r', 'crank radius'), ('theta', 'crank angle')]
    """
    page, letters = _read_with_all_letters(text, name, names_at)
    lines = text.split("\n")
    roles = MeaningsFromWords(lines, page, letters, names_at)
    meanings, scopes = roles.gather()
    sections = BindingsFromHeadings(lines, page, engines)
    bindings = tuple(sections.bindings(meanings))
    scopes = (*scopes, *force_components(lines, letters, meanings))
    return Proposals(letters, meanings, tuple(sorted(scopes, key=lambda s: s.first)), bindings)


def meanings_from_words(
    page: ReadNotes,
    declared_at: Callable[[int], Collection[str]],
    in_english: Callable[[str], str] = str,
) -> dict[str, Proposal]:
    """Return the first meaning that a page's words propose for each letter of its formulas.

    Of a page as it was read; lines of prose that were broken are read on to the next one, and words of
    another language are put in English first.
    """
    letters: dict[str, int] = {}
    for chain in page.chains:
        for letter in sorted({n for side in chain.sides for n in names(side.node)}):
            if letter not in declared_at(chain.lines[0]) and not letter.endswith("'"):
                letters.setdefault(letter, chain.lines[0])
    lines = [in_english(line) for line in _read_on(page.text.split("\n"))]
    return MeaningsFromWords(lines, page, letters, declared_at).gather()[0]


def _read_on(lines: Sequence[str]) -> Iterator[str]:
    """Yield lines, of prose that goes on with the first words of the next one."""
    for line, following in zip(lines, [*lines[1:], ""], strict=True):
        is_prose = re.search(r"[a-z,]\s*$", line) and re.match(r"[a-z]{2,}\s+[a-z]", following)
        yield f"{line.rstrip()} {' '.join(following.split()[:4])}" if is_prose else line


def _read_with_all_letters(
    text: str, name: str, names_at: Callable[[int], Collection[str]]
) -> tuple[ReadNotes, dict[str, int]]:
    """Return a page read with every letter declared, and the letters that are not, by first line."""
    letters: dict[str, int] = dict(_words(text, names_at))
    page = read_document(text, name, lambda line: {*names_at(line), *letters})
    for _ in range(MOST_ROUNDS):
        missing = [(_UNDECLARED.search(part.what), part.line) for part in page.unreadable]
        new = {match[1]: line for match, line in reversed(missing) if match and match[1] not in letters}
        if not new:
            break
        letters.update(new)
        page = read_document(text, name, lambda line: {*names_at(line), *letters})
    for chain in page.chains:
        for side in chain.sides:
            for letter in names(side.node):
                line = chain.lines[0]
                if letter not in names_at(line) and not letter.endswith("'"):
                    letters[letter] = min(letters.get(letter, line), line)
    occurring = {letter for chain in page.chains for side in chain.sides for letter in names(side.node)}
    unread = {letter for letter in letters if letter not in occurring and not _WORD.fullmatch(letter)}
    ordered = sorted(letters, key=lambda letter: (letters[letter], letter))
    return page, {letter: letters[letter] for letter in ordered if letter in occurring | unread}


def _words(text: str, names_at: Callable[[int], Collection[str]]) -> Iterator[tuple[str, int]]:
    """Yield runs of letters that are one letter, such as Lh: alone before an equals sign, or named."""
    for number, line in enumerate(text.split("\n"), 1):
        if len(line) > LONGEST_LINE:
            continue
        for match in _WORD.finditer(line):
            word = match[1]
            if word in FUNCTION_WORDS or word in names_at(number) or word.lower() in _PLAIN_WORDS:
                continue
            rest, before = line[match.end() :].lstrip(), line[: match.start()]
            before = before.rstrip().removesuffix("\\displaystyle").rstrip()
            is_side = rest[:1] == "=" and not before[-1:].isalnum() and before[-1:] not in ("/", ")", "}")
            is_named = any(
                role.may_name(word) and gap_is_naming(line, role.start, role.end, *match.span(1))
                for role in roles_named(line)
            )
            if is_side or is_named:
                yield word, number
