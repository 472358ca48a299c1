"""Temperatures on two scales, 20 °C = 293.15 K: the scales begin elsewhere, so no factor converts them.

A difference, as its letter says, goes by degrees alone: ΔT = 20 °C = 20 K. Any other temperature in °C
is read in kelvin, for it may be divided by another one; its number of degrees is known from that.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from functools import lru_cache

from symbalance.document.formula import (
    Constant,
    Formula,
    Name,
    Negative,
    Number,
    Product,
    Quotient,
    children,
    names,
    walk,
    with_children,
)
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, UNDECIDED, Decision
from symbalance.notes.reading.equations import Chain, ReadNotes, Side
from symbalance.text import lazy_patterns as re

_DEGREE = r"(?:°|\^\s?\\circ|\^\s?\{\s?\\circ\s?\}|\\degree)"
_SCALE = (
    rf"{_DEGREE}\s?(?:\\[,;: ]|\{{\s?\}})?\s?(?:\\(?:mathrm|text|rm|textrm)\s?\{{?\s?)?(?P<degrees>[CF])"
)
_TEMPERATURE = re.compile(
    r"\s*(?P<number>[-−]?[0-9]{1,6}(?:[.,][0-9]{1,6})?)(?:\s|\\[,;: ]|~|\$){0,4}"
    rf"(?:{_SCALE}|(?:\\(?:mathrm|text|textrm)\s?\{{\s?)?(?P<kelvin>K))[\s}}$]*"
)
_DIFFERENCES = ("Delta", "delta")
_CELSIUS = re.compile(
    rf"{_DEGREE}\s?(?:\\[,;: ]|\{{\s?\}}|\}})?\s?(?:\\(?:mathrm|text|rm|textrm)\s?\{{?\s?)?C(?![A-Za-z])"
)
_SCALE_BEHIND = re.compile(r"[\s$]{0,2}\\(?:text|textrm|mathrm|rm)\s?\{\s?C\s?\}")
"""The letter of the scale where it was read as words behind a number of degrees."""
_AFTER_DOLLAR = re.compile(rf"\s?(?:\$|\\\))(?:\s|~|\\[,;: ]|\$){{0,3}}{_DEGREE}\s?C(?![A-Za-z])")
_SPEAKS = re.compile(
    r"[Tt]emp[ée]rat|[Tt]hermi|Wärme|[Cc]haleur|[Cc]alor|[Hh]eat|[Kk]elvin|[Cc]elsius|温度|熱"
)
ROUNDED_ZERO = Fraction(3, 10)
"""The last place of a temperature read in kelvin: 20 °C are 293 K as most pages have it, or 293.15 K."""
_ZERO_OF_CELSIUS = Fraction("273.15")
_DEGREE_OF_ARC = Quotient(Constant("pi"), Number(Fraction(180)))
_ZEROS = {"C": Fraction("273.15"), "F": Fraction("459.67"), "K": Fraction(0)}
_STEPS = {"C": Fraction(1), "F": Fraction(5, 9), "K": Fraction(1)}


@lru_cache(maxsize=4)
def speaks_of_celsius(text: str) -> bool:
    """Tell whether a page has °C anywhere; it is asked of every relation."""
    return _CELSIUS.search(text) is not None


def with_temperatures(document: ReadNotes) -> ReadNotes:
    """Return a page whose temperatures in °C are numbers of kelvins, and no degrees of arc times C."""
    if not speaks_of_celsius(document.text):
        return document
    letters = {name for chain in document.chains for side in chain.sides for name in _other_letters(side)}
    if "C" in letters and not _SPEAKS.search(document.text):
        return document
    return replace(document, chains=tuple(_chain(chain, document.text) for chain in document.chains))


def _other_letters(side: Side) -> frozenset[str]:
    """Return the letters of a side but the C behind a degree sign."""
    return names(_read(side.node, "", is_difference=False))


def _chain(chain: Chain, text: str) -> Chain:
    head = chain.sides[0].node
    is_difference = isinstance(head, Name) and head.name.startswith(_DIFFERENCES)
    sides = (
        replace(
            side, readings=tuple(_side(node, text, is_difference=is_difference) for node in side.readings)
        )
        for side in chain.sides
    )
    return replace(chain, sides=tuple(sides))


def _side(node: Formula, text: str, *, is_difference: bool) -> Formula:
    """Return a side with its temperatures; that of a lone -20 °C has its sign."""
    if isinstance(node, Negative):
        degrees = _degrees(node.operand, text) or _number_before_scale(node.operand, text)
        if degrees is not None:
            return _temperature(replace(degrees, value=-degrees.value), node, is_difference=is_difference)
    number = _number_before_scale(node, text)
    if number is not None:
        return _temperature(number, node, is_difference=is_difference)
    return _read(node, text, is_difference=is_difference)


def _number_before_scale(node: Formula, text: str) -> Number | None:
    """Return a number with °C behind it outside its formula, $20$ °C; None for any other formula."""
    is_before = isinstance(node, Number) and node.span[1] and _AFTER_DOLLAR.match(text, node.span[1])
    return node if isinstance(node, Number) and is_before else None


def _read(node: Formula, text: str, *, is_difference: bool) -> Formula:
    """Return a formula with its temperatures in kelvin."""
    degrees = _degrees(node, text)
    if degrees is not None:
        return _temperature(degrees, node, is_difference=is_difference)
    parts = children(node)
    if isinstance(node, Product):
        joined = [*parts]
        for place in range(len(parts) - 1, 0, -1):
            pair = Product(
                parts[place - 1 : place + 1], span=(parts[place - 1].span[0], parts[place].span[1])
            )
            if _degrees(pair, text) is not None:
                joined[place - 1 : place + 1] = [pair]
        node, parts = replace(node, factors=tuple(joined)), tuple(joined)
    if not parts:
        return node
    return with_children(node, tuple(_read(part, text, is_difference=is_difference) for part in parts))


def _degrees(node: Formula, text: str) -> Number | None:
    """Return the number of a temperature in °C, None for any other formula."""
    behind = text[node.span[1] : node.span[1] + 20]
    if isinstance(node, Product) and len(node.factors) == 2 and node.factors[1] == Name("C"):
        return _of_arc(node.factors[0])
    is_behind = _SCALE_BEHIND.match(behind) is not None
    return _of_arc(node) if is_behind else None


def _of_arc(node: Formula) -> Number | None:
    """Return the number of degrees that a product with a degree sign has."""
    if not isinstance(node, Product) or len(node.factors) != 2 or node.factors[1] != _DEGREE_OF_ARC:
        return None
    unit = node.factors[1]
    is_sign = isinstance(unit, Quotient) and unit.numerator.span == unit.denominator.span
    return node.factors[0] if is_sign and isinstance(node.factors[0], Number) else None


def _temperature(degrees: Number, node: Formula, *, is_difference: bool) -> Number:
    if is_difference:
        return replace(degrees, span=node.span)
    return Number(degrees.value + _ZERO_OF_CELSIUS, ROUNDED_ZERO, span=node.span)


def is_temperature(node: Formula) -> bool:
    """Tell whether a formula is the number of a temperature that was read in kelvin."""
    return isinstance(node, Number) and node.last_place == ROUNDED_ZERO


def has_temperature(node: Formula) -> bool:
    """Tell whether a temperature that was read in kelvin stands in a formula."""
    return any(is_temperature(part) for part in walk(node))


def in_degrees(node: Formula) -> Formula:
    """Return a formula whose temperatures are the degrees as they are typed."""
    if isinstance(node, Number) and is_temperature(node):
        return Number(node.value - _ZERO_OF_CELSIUS, span=node.span)
    parts = children(node)
    return with_children(node, tuple(map(in_degrees, parts))) if parts else node


def decide_temperature(chain: Chain, k: int, document: ReadNotes) -> Decision | None:
    """Return the decision on a temperature that is written on another scale; None for other relations."""
    sides = chain.sides[k : k + 2]
    if chain.relations[k].sign not in "=≈" or isinstance(sides[0].node, Name):
        return None
    first, second = (_TEMPERATURE.fullmatch(document.source(side.span)) for side in sides)
    if first is None or second is None:
        return None
    scales = [match["degrees"] or match["kelvin"] for match in (first, second)]
    if scales[0] == scales[1]:
        return None
    head = chain.sides[0].node
    is_difference = isinstance(head, Name) and head.name.startswith(_DIFFERENCES)
    numbers = [Fraction(m["number"].replace("−", "-").replace(",", ".")) for m in (first, second)]
    exact = numbers[0] * _STEPS[scales[0]]
    if not is_difference:
        exact += _ZEROS[scales[0]] * _STEPS[scales[0]]
    exact /= _STEPS[scales[1]]
    if not is_difference:
        exact -= _ZEROS[scales[1]]
    off, place = abs(exact - numbers[1]), _last_place(second["number"])
    if off <= place / 2:
        return Decision(PROVED, order="" if not off else "the digits printed")
    if off < 2 * place and place == 1:
        return Decision(UNDECIDED, "the scales differ by 273.15, and one of them is rounded")
    words = f"{float(numbers[0]):g} on its scale is {float(exact):g} on the other one"
    return Decision(
        REFUTED, words, witness={"left": f"{float(exact):g}", "right": f"{float(numbers[1]):g}"}
    )


def _last_place(number: str) -> Fraction:
    decimals = len(number.replace(",", ".").partition(".")[2])
    return Fraction(1, 10**decimals)
