"""Conditions that stand right behind a relation: (N ≥ 3), (m = n), for p not a multiple of N.

Each is of that relation alone: of two on one line, Σ cos θ_i = 0 (N ≥ 2), Σ cos 2θ_i = 0 (N ≥ 3), each
has its own.
"""

from __future__ import annotations

import re
from collections.abc import Collection
from dataclasses import dataclass, replace

from symbalance.document.formula import (
    Formula,
    Integral,
    Name,
    Product,
    Summation,
    names,
    walk,
)
from symbalance.notes.algebra.special_values import ANY_WHOLE
from symbalance.notes.checking.deciding.inequalities import SATISFIED_BY
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge, StatedRange
from symbalance.notes.checking.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain, ReadNotes

_WORDS = r"for|if|when|where|provided|für|wenn|falls|sofern|pour|si"
_BLANK = r"\s|[$~&]|\\[,;:! ]|\\q?quad(?![a-z])|\\(?:text|mbox|mathrm|textrm)\s*\{|\\left|\\[bB]igg?l?|\}"
_BEHIND = re.compile(
    rf"(?:{_BLANK}|,)*(?:[(\[（]|(?<![A-Za-z\\])(?:{_WORDS})(?![A-Za-z]))"
    rf"(?:{_BLANK}|(?<![A-Za-z\\])(?:{_WORDS}|all|alle|every|any|jedes|jede)(?![A-Za-z]))*"
)
_LETTER = r"[\s$~]*(?P<{}>\\?[A-Za-z])[\s$~]*"
_MULTIPLE = re.compile(
    rf"{_LETTER.format('first')}(?:is|ist|=)?\s*(?P<not>not|no|kein)?\s*(?:an?\s+|ein\s+)?"
    r"(?:integer\s+|whole\s+|ganzzahliges\s+)?"
    rf"(?:multiple\s+of|Vielfaches\s+von){_LETTER.format('second')}"
    rf"|{_LETTER.format('divisor')}(?:\\mid(?![a-z])|divides|teilt|∣){_LETTER.format('divided')}"
)
_NEAR = 60
"""Characters behind a relation in which such words begin."""


@dataclass(frozen=True, slots=True)
class Conditions:
    """What is said right behind a relation of the letters in it."""

    ranges: tuple[StatedRange, ...] = ()
    values: tuple[tuple[str, Formula, str], ...] = ()
    """Letters with what they equal there, and the condition as text."""


def conditions_behind(chain: Chain, document: ReadNotes) -> Conditions:
    """Return the conditions right after a relation, in brackets or behind "for" and the like."""
    end = max(side.span[1] for side in chain.sides)
    opened = _BEHIND.match(document.text, end)
    if opened is None:
        return Conditions()
    own, counts = chain.letters, _counts(chain)
    ranges: list[StatedRange] = []
    values: list[tuple[str, Formula, str]] = []
    for other in document.chains:
        if other.sides[0].span[0] != opened.end() or other is chain:
            continue
        for k, relation in enumerate(other.relations):
            left, right = other.sides[k].node, other.sides[k + 1].node
            if not (names(left) | names(right)) <= set(own):
                continue
            line = chain.lines[0]
            if relation.sign in SATISFIED_BY:
                ranges.append(StatedRange(left, relation.sign, right, line, max(chain.lines)))
            elif counts and _is_equality(other):
                assert isinstance(left, Name)
                text = f"{plain_text(left)} = {plain_text(right)}"
                values.append((left.name, right, text))
    if counts:
        values += _multiples(document.text[opened.end() : opened.end() + _NEAR], own)
    return Conditions(tuple(ranges), tuple(values))


def equalities_behind(document: ReadNotes) -> frozenset[int]:
    """Return where the equations of a page begin that are conditions of the relation before: (m = n)."""
    starts = {c.sides[0].span[0] for c in document.chains if len(c.sides) == 2 and _is_equality(c)}
    return frozenset(
        opened.end()
        for chain in document.chains
        if starts and _counts(chain)
        if (opened := _BEHIND.match(document.text, max(side.span[1] for side in chain.sides)))
        if opened.end() in starts
    )


def _counts(chain: Chain) -> bool:
    """Tell whether a sum or an integral stands in a relation: its letters may be whole numbers."""
    return any(isinstance(part, Summation | Integral) for side in chain.sides for part in walk(side.node))


def _is_equality(chain: Chain) -> bool:
    """Tell whether a chain says of two letters that they are equal."""
    are_letters = all(isinstance(side.node, Name) for side in chain.sides)
    return are_letters and all(relation.sign == "=" for relation in chain.relations)


def _multiples(text: str, own: Collection[str]) -> list[tuple[str, Formula, str]]:
    """Return that a letter is a multiple of another one, as words or the sign for "divides" say."""
    match = _MULTIPLE.match(text)
    if match is None or match["not"]:
        return []
    first, second = match["first"] or match["divided"], match["second"] or match["divisor"]
    letters = first.lstrip("\\"), second.lstrip("\\")
    if not set(letters) <= set(own):
        return []
    value = Product((Name(ANY_WHOLE), Name(letters[1])))
    texts = [plain_text(Name(name)) for name in letters]
    return [(letters[0], value, f"{texts[0]} is a multiple of {texts[1]}")]


def with_conditions(chain: Chain, document: ReadNotes, knowledge: Knowledge) -> Knowledge:
    """Return what is known with the conditions right behind a relation, instead of others on its line."""
    conditions = conditions_behind(chain, document)
    if conditions == Conditions():
        return knowledge
    letters = {name for r in conditions.ranges for name in names(r.left) | names(r.right)}
    others = tuple(
        r
        for r in knowledge.ranges
        if r.line != chain.lines[0]
        or r.last_line is None
        or letters.isdisjoint(names(r.left) | names(r.right))
    )
    definitions = dict(knowledge.definitions)
    for name, value, text in conditions.values:
        definitions[name] = Definition(value, chain.lines[0], assumption=text)
    meaning = knowledge.meaning
    if conditions.values:
        meaning = replace(meaning, integer=meaning.integer | {ANY_WHOLE})
    return replace(
        knowledge, meaning=meaning, ranges=(*conditions.ranges, *others), definitions=definitions
    )
