"""Revolutions per minute: what 6000 rpm is worth depends on the letter that takes it.

The reader turns 6000 rpm into radians per second, which an angular speed wants. In `ω = 2πn` n counts
revolutions per second, and n = 6000 min⁻¹ is 100; in `ω = 2πn/60` it is the number 6000. Both are usual,
so a letter that is no angular speed is taken as the formulas of its own page use it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import (
    Constant,
    Formula,
    Name,
    Number,
    Power,
    Product,
    Quotient,
    children,
    names,
    walk,
    with_children,
)
from symbalance.notes.checking.declared.symbol_roles import BY_MINUTE, role_of
from symbalance.notes.reading.equations import Chain, ReadNotes, Side
from symbalance.text import lazy_patterns as re

BETWEEN = r"(?:\s|[~$]|\\[,;: ]|\\(?:mathrm|text|textrm|unit|si)\s*\{|\}\{|</?[a-z]+>|&nbsp;){0,5}"
PER_MINUTE = (
    r"(?:rpm|r\.\s?p\.\s?m|(?:rev(?:olution)?s?\.?|turns|tr|U|Umdr?\.?|Umdrehungen|1|tours|giri|rivoluzioni|vueltas|revoluciones|r)"
    r"\s?(?:/|per|pro|par|an?|each|in\s(?:der|a|one)|al|por|à\sla)\s?"
    r"[Mm]in|min\s*[}$]?\s*(?:\^\s*\{?\s*[-−]\s*1|⁻¹|<sup>\s*[-−]\s*1)|\\rpm|\\per\\minute|回転)"
)
"""The unit of revolutions per minute, and what stands between it and its number."""
_UNIT_BEHIND = re.compile(BETWEEN + PER_MINUTE)
ANGULAR = "angular speed"
ANGULAR_LETTERS = ("omega", "Omega")
_PER_MINUTE = Quotient(Constant("pi"), Number(Fraction(30)))
_A_SIXTIETH = Number(Fraction(1, 60))
_BY_NUMBER = {Number(Fraction(60)), Number(Fraction(30))}
"""What a formula divides by whose speed is a number of revolutions per minute: 2πn/60, πn/30."""
_BY_CYCLES = {Number(Fraction(120))}
"""So where a cycle takes two revolutions, p V n/120; elsewhere 120 may be an angle."""
Symbols = Callable[[int], Mapping[str, str]]


def with_speeds(document: ReadNotes, symbols_at: Symbols) -> ReadNotes:
    """Return a page whose speeds in revolutions per minute are what their letters count."""
    if not any(_has_unit(side) for chain in document.chains for side in chain.sides):
        return document
    numbers = {
        name
        for chain in document.chains
        for side in chain.sides
        if divides_by_minute(side.node)
        for name in names(side.node)
    } | {
        chain.sides[0].node.name
        for chain in document.chains
        for side in chain.sides[1:]
        if isinstance(chain.sides[0].node, Name)
        and not _is_quantity(side.node)  # the 30 of Δn = 30 rpm turns no seconds into minutes
        and not _BY_NUMBER.isdisjoint(_factors_above(side.node))
    }
    stems = {_stem(name) for name in numbers if _stem(name) not in ANGULAR_LETTERS}
    speeds = {
        chain.sides[0].node.name
        for chain in document.chains
        if isinstance(chain.sides[0].node, Name) and any(map(_has_unit, chain.sides[1:]))
    }
    numbers |= {
        name for name in speeds if _stem(name) in stems
    }  # n_max beside n_m counts what that counts
    chains = (
        _with_turns_by_the_second(
            _chain(chain, symbols_at(chain.lines[0]), numbers, speeds, document),
            numbers & speeds,
            document,
        )
        for chain in document.chains
    )
    return replace(document, chains=tuple(chains))


def _chain(
    chain: Chain, symbols: Mapping[str, str], numbers: set[str], speeds: set[str], document: ReadNotes
) -> Chain:
    if not any(map(_has_unit, chain.sides)):
        return chain
    head = chain.sides[0].node
    name = head.name if isinstance(head, Name) else None
    role = role_of(symbols.get(name, "")) if name else ""
    is_angular = role == ANGULAR or name in ANGULAR_LETTERS
    is_angular = is_angular or (name is not None and not role and _stem(name) in ANGULAR_LETTERS)
    counted = _speeds_in(chain, speeds) if name is None else set()
    by_minute = name is None and any(map(_is_of_sixty, chain.sides))
    as_number = (
        role == BY_MINUTE or (name in numbers and not is_angular) or bool(counted & numbers) or by_minute
    )
    text = document.text[chain.start : chain.end + _UNIT_LENGTH]
    by_second = name is None and (by_minute or bool(counted) or _HERTZ.search(text) is not None)
    is_speed = (name is not None and not is_angular) or by_second

    def at_home(node: Formula) -> Formula:
        if _is_quantity(node) and not is_speed:
            return node
        if _is_quantity(node):
            return _without_unit(node, as_number)
        if not _BY_NUMBER.isdisjoint(_divisors(node)):
            return _without_units(node)
        if is_speed and _is_of_speeds(node, document):
            return _without_units(node) if as_number else _by_the_second(node)
        return _in_product(node, document)

    def with_counted(node: Formula) -> tuple[Formula, ...]:
        """Return a speed as radians, and as turns: of s⁻¹ alone nobody can tell which it is."""
        is_open = name is None and not is_speed and _PER_SECOND.search(text) is not None
        return (at_home(node), _by_the_second(node)) if is_open and _has_speed(node) else (at_home(node),)

    sides = (
        replace(side, readings=tuple(r for node in side.readings for r in with_counted(node)))
        for side in chain.sides
    )
    return replace(chain, sides=tuple(sides))


def _is_of_sixty(side: Side) -> bool:
    """Tell whether a side is sixty times what letters say of a second: 60 f in revolutions per minute."""
    return bool(names(side.node)) and Number(Fraction(60)) in _factors_above(side.node)


_OF_A_SECOND = re.compile(
    r"[0-9](?:[\s~{]|\\,|\\mathrm|\\text|\\frac|\\[td]frac)*(?:k?m\}?\s?(?:/|\}\{|\{)\s?(?:\\mathrm\{)?s|[kM]?W(?![A-Za-z]))"
)
"""What is per second whatever the speed is counted in: metres per second, watts."""


def _with_turns_by_the_second(chain: Chain, counted: set[str], document: ReadNotes) -> Chain:
    """Return a chain in which a number of revolutions per minute may count those of a second: v = 2 s n.

    n = 4500 U/min is a number in π n/30. In 2 s n = 13.8 m/s it is the quantity that it was given as.
    """
    own = {name for side in chain.sides for name in names(side.node)} & counted
    if not own or not any(_OF_A_SECOND.search(document.source(side.span)) for side in chain.sides):
        return chain
    if any(divides_by_minute(side.node) for side in chain.sides):
        return chain
    sides = tuple(
        replace(side, readings=(*side.readings, *(_turned(node, own) for node in side.readings)))
        if names(side.node) & own
        else side
        for side in chain.sides
    )
    return replace(chain, sides=sides)


def _turned(node: Formula, counted: set[str]) -> Formula:
    """Return a formula with a sixtieth of each letter that counts revolutions per minute."""
    if isinstance(node, Name):
        if node.name not in counted:
            return node
        return Product((node, replace(_A_SIXTIETH, span=node.span)), span=node.span)
    parts = children(node)
    return with_children(node, tuple(_turned(part, counted) for part in parts)) if parts else node


BY_THE_SECOND = r"(?:[kM]?Hz|rps|r\.p\.s\.|(?:rev|U|Umdr|tr|giri)\s?/\s?s)"
"""The units of turns and cycles by the second."""
_HERTZ = re.compile(rf"(?<![A-Za-z]){BY_THE_SECOND}(?![A-Za-z])")
_PER_SECOND = re.compile(
    r"(?<![A-Za-z])s\s*\}?\s*(?:⁻¹|\^\s*\{?\s*[-−]\s*1)|(?<![A-Za-z0-9])1\s*/\s*s(?![A-Za-z])"
)
_UNIT_LENGTH = 8
"""Characters of a unit behind the last side of a chain."""
_SIGNS = re.compile(
    r"\\(?:cdot|times|[dt]?frac|left|right|mathrm|text|textrm|unit|si|SI|qty)(?![A-Za-z])"
)
_LETTER = re.compile(r"[^\W\d_]")


def _speeds_in(chain: Chain, speeds: set[str]) -> set[str]:
    """Return the letters of a chain that are speeds in revolutions per minute, if nothing turns them."""
    parts = [part for side in chain.sides for part in _outside_units(side.node)]
    own = {part.name for part in parts if isinstance(part, Name)}
    turns = any(isinstance(part, Constant) and part.name == "pi" for part in parts)
    is_angular = any(_stem(name) in ANGULAR_LETTERS for name in own)
    return set() if is_angular or turns else own & speeds


def _outside_units(node: Formula) -> Iterator[Formula]:
    """Yield the parts of a formula but those of the units of speeds, π/30 of rpm."""
    if not is_unit_of_speed(node):
        yield node
        for part in children(node):
            yield from _outside_units(part)


def _is_of_speeds(node: Formula, document: ReadNotes) -> bool:
    """Tell whether a side is an arithmetic of speeds and numbers: 2 · 3000 rpm, 3000 rpm - 2900 rpm."""
    is_power = any(isinstance(part, Power) and _has_speed(part) for part in walk(node))
    if not _has_speed(node) or is_power or names(node):
        return False
    bare = _SIGNS.sub(" ", _UNIT_BEHIND.sub(" ", document.source(node.span)))
    return _LETTER.search(bare) is None and "°" not in bare


def _has_speed(node: Formula) -> bool:
    return any(is_unit_of_speed(part) for part in walk(node))


def _by_the_second(node: Formula) -> Formula:
    """Return a formula whose speeds are in revolutions per second."""
    if is_unit_of_speed(node):
        return replace(_A_SIXTIETH, span=node.span)
    parts = children(node)
    return with_children(node, tuple(map(_by_the_second, parts))) if parts else node


def _stem(name: str) -> str:
    """Return a letter without its subscript and strokes: n of n_max."""
    return name.partition("_")[0].rstrip("'0123456789")


_DIGITS = re.compile(r"[0-9][0-9.,\u202f\u2009]*")


def is_per_minute(text: str, place: int) -> bool:
    """Tell whether a unit of revolutions per minute stands at a place, behind a number."""
    return _UNIT_BEHIND.match(text, place) is not None


def is_per_minute_number(node: Formula, text: str) -> bool:
    """Tell whether a number was given in revolutions per minute, whatever it counts in formulas.

    Its unit stands behind it, or within a cell of a table that is the number.
    """
    if not isinstance(node, Number) or not node.span[1]:
        return False
    digits = _DIGITS.match(text, *node.span)
    return is_per_minute(text, node.span[1]) or (digits is not None and is_per_minute(text, digits.end()))


def divides_by_minute(node: Formula) -> bool:
    """Tell whether a formula has the 60 or 30 that a number of revolutions per minute is divided by."""
    return not (_BY_NUMBER.isdisjoint(_typed_numbers(node)) and _BY_CYCLES.isdisjoint(_divisors(node)))


def is_divided_by_minute(node: Formula) -> bool:
    """Tell whether a formula turns the revolutions of a minute into those of a second: πn/30."""
    return not (_BY_NUMBER | _BY_CYCLES).isdisjoint(_divisors(node))


def is_angular_speed(name: str, symbols: Mapping[str, str]) -> bool:
    """Tell whether a letter is an angular speed, by its meaning or by its usual letter."""
    return role_of(symbols.get(name, "")) == ANGULAR or (name in ANGULAR_LETTERS and name not in symbols)


def _is_quantity(node: Formula) -> bool:
    """Tell whether a side is a number with its unit and nothing else."""
    return isinstance(node, Product) and len(node.factors) == 2 and is_unit_of_speed(node.factors[1])


def _without_unit(node: Formula, as_number: bool) -> Formula:
    assert isinstance(node, Product)
    number, unit = node.factors
    return (
        number if as_number else Product((number, replace(_A_SIXTIETH, span=unit.span)), span=node.span)
    )


def _in_product(node: Formula, document: ReadNotes, with_pi: bool = False) -> Formula:
    """Return a formula whose speeds are in revolutions per second where its factors say so.

    2·π·6000 rpm has its own 2π, and 2·86 mm·5000 min⁻¹ counts strokes; (6000 rpm)² is an angular speed's.
    """
    if is_unit_of_speed(node):
        is_frequency = with_pi or "rpm" not in document.source(node.span)
        return replace(_A_SIXTIETH, span=node.span) if is_frequency else node
    if isinstance(node, Power) or not (parts := children(node)):
        return node
    if isinstance(node, Product):
        with_pi = with_pi or any(isinstance(part, Constant) and part.name == "pi" for part in parts)
    return with_children(node, tuple(_in_product(part, document, with_pi) for part in parts))


def _divisors(node: Formula) -> set[Formula]:
    """Return the factors that anything in a formula is divided by: 60 of 4000 rpm · 2π/60."""
    if isinstance(node, Quotient) and not is_unit_of_speed(node):
        return _factors_above(node.denominator) | _divisors(node.numerator)
    return {divisor for part in children(node) for divisor in _divisors(part)}


def _without_units(node: Formula) -> Formula:
    """Return a formula whose speeds are the numbers typed."""
    if isinstance(node, Product):
        factors = tuple(_without_units(part) for part in node.factors if not is_unit_of_speed(part))
        return factors[0] if len(factors) == 1 else replace(node, factors=factors)
    parts = children(node)
    return with_children(node, tuple(map(_without_units, parts))) if parts else node


def _has_unit(side: Side) -> bool:
    return any(is_unit_of_speed(part) for node in side.readings for part in walk(node))


def is_unit_of_speed(node: Formula) -> bool:
    """Tell the factor of a unit from π/30 as an author writes it."""
    return (
        isinstance(node, Quotient)
        and node == _PER_MINUTE
        and node.numerator.span == node.denominator.span
    )


def _factors_above(node: Formula) -> set[Formula]:
    """Return the factors of a product but those it is divided by: n = 60 f/q counts revolutions."""
    if isinstance(node, Quotient) and not is_unit_of_speed(node):
        return _factors_above(node.numerator)
    if isinstance(node, Product):
        return {factor for part in node.factors for factor in _factors_above(part)}
    return {node}


def _typed_numbers(node: Formula) -> set[Formula]:
    """Return the whole numbers of a formula but those of units."""
    if is_unit_of_speed(node):
        return set()
    if isinstance(node, Number):
        return {node}
    return {number for part in children(node) for number in _typed_numbers(part)}
