"""Conditions that stand right behind a relation: (N ≥ 3), (m = n), only if k is a multiple of 3.

That a letter is odd, or a multiple, may stand in the sentence before the relation as well.

Each is of that relation alone: of two on one line, Σ cos θ_i = 0 (N ≥ 2), Σ cos 2θ_i = 0 (N ≥ 3), each
has its own.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass, replace
from fractions import Fraction

from symbalance.document.formula import (
    Formula,
    Name,
    Number,
    Product,
    Sum,
    Summation,
    names,
    walk,
)
from symbalance.notes.algebra.special_values import ANY_WHOLE
from symbalance.notes.checking.deciding.inequalities import SATISFIED_BY, sample_ranges
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge, StatedRange
from symbalance.notes.checking.deciding.whole_numbers import orders_in
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.text import lazy_patterns as re

_WORDS = r"for|if|when|where|whenever|provided|für|wenn|falls|sofern|pour|si|quand|lorsque|se|quando|per"
_ONLY = (
    r"(?:holds?|is true|true|valid|gilt|vaut|vale)?\s*(?:and\s+)?(?:only|nur|genau dann|seulement|solo)?"
)
_JAPANESE = r"(?:と(?:なる|する)|が成り立つ|である)のは"
_BLANK = r"\s|[$~&]|\\[,;:! ]|\\q?quad(?![a-z])|\\(?:text|mbox|mathrm|textrm)\s*\{|\\left|\\[bB]igg?l?|\}"
_BEHIND = re.compile(
    rf"(?:{_BLANK}|,)*(?:[(\[（]|{_ONLY}(?:{_BLANK}|,)*(?<![A-Za-z\\])(?:{_WORDS})(?![A-Za-z])|{_JAPANESE})"
    rf"(?:{_BLANK}|(?<![A-Za-z\\])(?:{_WORDS}|all|alle|every|any|jedes|jede)(?![A-Za-z]))*"
)
_LETTER = r"[\s$~]*(?P<{}>\\?[A-Za-z])[\s$~]*"
_COUNT = r"[\s$~]*(?P<{}>\\?[A-Za-z]|[0-9]{{1,2}})(?![A-Za-z0-9])[\s$~]*"
_MULTIPLE = re.compile(
    rf"{_LETTER.format('first')}(?:is|ist|=)?\s*(?P<not>not|no|kein)?\s*(?:an?\s+|ein\s+)?"
    r"(?:integer\s+|whole\s+|ganzzahliges\s+)?"
    rf"(?:multiple\s+of|Vielfaches\s+von|(?:est\s+)?(?:un\s+)?multiple\s+de|è\s+multiplo\s+di"
    rf"|divisible\s+by|durch(?=\s*\$?[0-9A-Za-z]+\$?\s*teilbar)){_COUNT.format('second')}"
    rf"|{_LETTER.format('counted')}[がは]\s*\$?(?P<modulus>[0-9０-９]{{1,2}}|\\?[A-Za-z])\$?\s*の倍数(?!でない)"
    rf"|{_LETTER.format('divisor')}(?:\\mid(?![a-z])|divides|teilt|∣){_LETTER.format('divided')}"
)
_KIND = r"(?:odd|even|ungerade[nsrm]?|gerade[nsrm]?)"
_INTEGERS = r"(?:integers?\s+|numbers?\s+|ganze\s+|Zahlen\s+)?"
_OF_KIND = (
    rf"(?<![A-Za-z]){_KIND}\s+{_INTEGERS}\$?(?P<letter>\\?[A-Za-z])(?![A-Za-z])\$?"
    rf"|(?<![A-Za-z])(?P<subject>[a-zA-Z])\$?\s+(?:is\s+|ist\s+)?{_KIND}(?![A-Za-z])"
)
_PARITY = re.compile(rf"(?:{_OF_KIND})[\s$:,({{]*$")
_PARITY_BEHIND = re.compile(rf"[\s$,(]{{0,6}}(?:{_WORDS})\s+(?:all\s+|alle\s+)?\$?(?:{_OF_KIND})")
_UNLESS = re.compile(
    r"(?<![^\W\d_])(?:unless|except|save|außer|es\s+sei\s+denn|sauf|à\s+moins\s+que|salvo|tranne)(?![^\W\d_])[^,.;=]{0,30}$",
    re.IGNORECASE,
)
"""Right before what must not be: unless n is odd."""
_CLAUSES = re.compile(r"[.;!?]\s|[;\n]")
_BEFORE = re.compile(
    rf"(?<![A-Za-z\\])(?:{_WORDS}|as|since|because)(?![A-Za-z])(?:{_BLANK})*(?=\\?[A-Za-z](?![A-Za-z]))"
    r"|(?=\$?\\?[A-Za-z]\$?\s?[がは]\s?\$?[0-9０-９A-Za-z]{1,2}\$?\s?の倍数)",
    re.IGNORECASE,
)
_SENTENCES = re.compile(r"[.;!?]\s|[;。；]|\n\s*\n")
_DISPLAYED = re.compile(r"\s*(?:\$\$|\\\[|\\begin\{[a-z]+\*?\}|\+{4})\s*$")
"""What opens a formula of its own line, and the blank line before it."""
_NEAR, _REACH = 60, 120
"""Characters behind a relation, and before it, in which such words begin."""


@dataclass(frozen=True, slots=True)
class Conditions:
    """What is said right behind a relation of the letters in it."""

    ranges: tuple[StatedRange, ...] = ()
    values: tuple[tuple[str, Formula, str], ...] = ()
    """Letters with what they equal there, and the condition as text."""


def conditions_behind(chain: Chain, document: ReadNotes) -> Conditions:
    """Return the conditions right after a relation, in brackets or behind "for" and the like."""
    opened = _BEHIND.match(document.text, chain.end)
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
            elif _is_equality(other, counts):
                assert isinstance(left, Name)
                text = f"{plain_text(left)} = {plain_text(right)}"
                values.append((left.name, right, text))
    values += _multiples(document.text[opened.end() : opened.end() + _NEAR], own, counts)
    return Conditions(tuple(ranges), tuple(values))


def _parities(chain: Chain, document: ReadNotes) -> list[tuple[str, Formula, str]]:
    """Return the letters that the words right before or behind a relation say to be odd or even."""
    start, end = chain.start, chain.end
    before = _CLAUSES.split(document.text[max(start - _NEAR, 0) : start])[-1]
    behind = _PARITY_BEHIND.match(document.text, end)
    values: list[tuple[str, Formula, str]] = []
    for match in filter(None, (behind, _PARITY.search(before))):
        name = (match["letter"] or match["subject"]).lstrip("\\")
        is_odd = match.group().lower().find("odd") >= 0 or "ungerad" in match.group()
        is_odd ^= match is not behind and _UNLESS.search(before, 0, match.start()) is not None
        twice: Formula = Product((Number(Fraction(2)), Name(ANY_WHOLE)))
        if name in chain.letters:
            value = Sum((twice, Number(Fraction(1)))) if is_odd else twice
            values.append((name, value, f"{plain_text(Name(name))} is {'odd' if is_odd else 'even'}"))
    return values[:1]


def equalities_behind(document: ReadNotes) -> frozenset[int]:
    """Return where the equations begin that are conditions of the relation before: (m = n), (N = 3)."""
    heads = {c.sides[0].span[0]: c for c in document.chains if len(c.sides) == 2}
    behind: set[int] = set()
    for chain in document.chains:
        counts = _counts(chain)
        opened = _BEHIND.match(document.text, chain.end)
        head = heads.get(opened.end()) if counts and opened is not None else None
        if head is not None and _is_equality(head, counts):
            behind.add(head.sides[0].span[0])
    return frozenset(behind)


def values_behind(chain: Chain, document: ReadNotes) -> list[tuple[str, Formula]]:
    """Return the values that a relation is said for by the words right behind it: x/x = 1 for x = 0."""
    opened = _BEHIND.match(document.text, chain.end)
    if opened is None:
        return []
    return [
        (other.sides[0].node.name, other.sides[1].node)
        for other in document.chains
        if other.sides[0].span[0] == opened.end()
        and len(other.sides) == 2
        and other.relations[0].sign == "="
        and isinstance(other.sides[0].node, Name)
        and not names(other.sides[1].node)
    ]


def _counts(chain: Chain) -> frozenset[str]:
    """Return the letters of a relation's sums and integrals that may be whole numbers."""
    nodes = [side.node for side in chain.sides]
    bounds = [
        bound
        for node in nodes
        for part in walk(node)
        if isinstance(part, Summation)
        for bound in (part.lower, part.upper)
        if bound is not None
    ]
    return orders_in(nodes) | {name for bound in bounds for name in names(bound)}


def _is_equality(chain: Chain, counts: Collection[str]) -> bool:
    """Tell whether a chain says of a letter that counts that it is another one, or a whole number."""
    left, right = (side.node for side in (chain.sides[0], chain.sides[-1]))
    is_value = isinstance(right, Name) or (isinstance(right, Number) and right.value.denominator == 1)
    is_whole = isinstance(left, Name) and left.name in counts and is_value
    return is_whole and len(chain.sides) == 2 and chain.relations[0].sign == "="


def _multiples(
    text: str, own: Collection[str], counts: Collection[str]
) -> list[tuple[str, Formula, str]]:
    """Return that a letter is a multiple of another one, or of a number.

    Words say so of any letter, the sign for "divides" of one that counts: it is that of a modulus too.
    """
    match = _MULTIPLE.match(text)
    if match is None or match["not"] or (match["divided"] and not counts):
        return []
    name = (match["first"] or match["divided"] or match["counted"]).lstrip("\\")
    of = (match["second"] or match["divisor"] or match["modulus"]).lstrip("\\")
    modulus: Formula = Number(Fraction(int(of))) if of.isdecimal() else Name(of)
    if name not in own or (isinstance(modulus, Name) and of not in own):
        return []
    value = Product((Name(ANY_WHOLE), modulus))
    return [(name, value, f"{plain_text(Name(name))} is a multiple of {plain_text(modulus)}")]


def _multiples_before(chain: Chain, document: ReadNotes) -> list[tuple[str, Formula, str]]:
    """Return that a letter is a multiple by the words of a relation's own sentence before it."""
    lead = _DISPLAYED.sub("", document.text[max(chain.start - _REACH, 0) : chain.start])
    before = _SENTENCES.split(lead)[-1]
    opened = list(_BEFORE.finditer(before))
    return _multiples(before[opened[-1].end() :], chain.letters, ()) if opened else []


def with_conditions(chain: Chain, document: ReadNotes, knowledge: Knowledge) -> Knowledge:
    """Return what is known with the conditions right behind a relation, instead of others on its line."""
    conditions = conditions_behind(chain, document)
    further = (*_parities(chain, document), *_multiples_before(chain, document))
    conditions = replace(conditions, values=(*conditions.values, *further))
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
    drawn = sample_ranges(conditions.ranges)
    meaning = replace(meaning, ranges={**meaning.ranges, **drawn})
    return replace(
        knowledge, meaning=meaning, ranges=(*conditions.ranges, *others), definitions=definitions
    )
