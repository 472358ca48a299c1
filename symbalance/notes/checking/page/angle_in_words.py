"""The crank angle by a page's own words, where the letters declared have one that the page does not use.

A course declares θ for everybody, and a page says "Let α be the crank angle". Nobody declares α; left to
itself it would be any letter, and what is true of the page's own angle would be accused by θ.
"""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import names
from symbalance.document.letters import plain_letter
from symbalance.notes.checking.declared.proposals import meanings_from_words
from symbalance.notes.checking.declared.sidecar import Declarations
from symbalance.notes.checking.declared.symbol_roles import letters_by_role
from symbalance.notes.checking.words.glossary import glossary_of
from symbalance.notes.reading.equations import ReadNotes
from symbalance.text import lazy_patterns as re

_ANGLE = "crank angle"
_OF_CRANK_DRIVE = ("crank radius", "rod length", "crank ratio r/l", "rod ratio l/r", "angular speed")
_MACRO = re.compile(
    r"\\(?:(?:re|provide)?newcommand\*?\s?\{?|def)\s?\\(?P<name>[A-Za-z]+)\}?\s?\{(?P<letter>\\[A-Za-z]+)\}"
)
"""A macro that is a letter: \\newcommand{\\ph}{\\alpha}."""


def with_angle_in_words(page: ReadNotes, declarations: Declarations) -> tuple[ReadNotes, Declarations]:
    """Return a page with a note, and declarations with the letter that its words call the crank angle."""
    roles = letters_by_role(declarations.symbols)
    if declarations.scopes or not any(role in roles for role in _OF_CRANK_DRIVE):
        return page, declarations
    used = {name for chain in page.chains for side in chain.sides for name in names(side.node)}
    if used.intersection(roles.get(_ANGLE, ())):
        return page, declarations
    written = replace(page, text=_with_macros_written(page.text))
    meanings = meanings_from_words(written, declarations.symbols_at, glossary_of(page.text).english)
    named = [each for each in meanings.values() if each.meaning == _ANGLE and each.words]
    if len(named) != 1 or named[0].letter in declarations.symbols:
        return page, declarations
    (angle,) = named
    words = " ".join(re.sub(r"[$\\{}]", "", angle.words).split())
    note = f"{plain_letter(angle.letter)} is the crank angle, by “{words}”"
    idle = roles.get(_ANGLE, ())  # of two angles the geometry would be written in the other one
    symbols = {name: text for name, text in declarations.symbols.items() if name not in idle}
    symbols[angle.letter] = _ANGLE
    return replace(page, notes=(*page.notes, note)), replace(declarations, symbols=symbols)


def _with_macros_written(text: str) -> str:
    """Return a text with the letters that its macros stand for: Let $\\ph$ be the crank angle."""
    for macro in _MACRO.finditer(text):
        letter = macro["letter"]
        text = re.sub(rf"\\{macro['name']}(?![A-Za-z])", lambda _, letter=letter: letter, text)
    return text
