"""A bare N behind a number is newton, or the letter N of the page: both readings, the likelier one first.

`ω = 2πN/60 = 0.10472 N` goes on in the letter N, `1 hp = 745.7 W` on a page about a weight W in watts.
The reader decides by what stands around the number; here the side gets the other reading beside it,
first if another side of its chain holds that letter. A relation that is true in one of them is true; one
that is wrong in both is accused in the likelier.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Formula, Name, Negative, Number, Product, names
from symbalance.notes.reading import ReadingError, canonical_name
from symbalance.notes.reading.equations import Chain, ReadNotes, Side
from symbalance.notes.reading.units import scale_of
from symbalance.text import lazy_patterns as re

Symbols = Callable[[int], Mapping[str, str]]
_QUANTITY = re.compile(
    r"\s*[-−]?\s*(?P<number>[0-9][0-9.,{}]*)(?:\s|~|\\[,;: ])*(?P<letter>[A-Za-z])(?:\s|[.,;$])*"
)

_SAME = Fraction(1, 50)
"""By how much a number may differ from the same one in another unit, rounded."""


def with_both_readings(document: ReadNotes, symbols_at: Symbols) -> ReadNotes:
    """Return a page whose sides of a number and one letter have both readings."""
    used = {name for chain in document.chains for side in chain.sides for name in names(side.node)}

    def is_letter(name: str, line: int) -> bool:
        return name in used or name in symbols_at(line)

    chains = tuple(_chain(chain, document, is_letter) for chain in document.chains)
    return replace(document, chains=chains)


def _chain(chain: Chain, document: ReadNotes, is_letter: Callable[[str, int], bool]) -> Chain:
    if not chain.relations:
        return chain
    sides = [_side(chain, k, document, is_letter) for k in range(len(chain.sides))]
    return replace(chain, sides=tuple(sides))


def _side(chain: Chain, place: int, document: ReadNotes, is_letter: Callable[[str, int], bool]) -> Side:
    side = chain.sides[place]
    match = _QUANTITY.fullmatch(document.source(side.span))
    if match is None or len(side.readings) > 1:
        return side
    try:
        name = canonical_name(match["letter"])
    except ReadingError:
        return side
    scale = scale_of(match["letter"])
    if scale is None or scale[1] or not is_letter(name, chain.lines[0]):
        return side
    others = {n for k, other in enumerate(chain.sides) if k != place for n in names(other.node)}
    sign, node = _bare(side.node)
    as_letter, as_unit = _both(node, name, scale[0])
    if as_letter is None or as_unit is None:
        return side
    readings = [sign(as_unit), sign(as_letter)]
    is_usual_letter = bool(names(side.node))
    is_letter_here = name in others or _goes_on_with_another_number(chain, place, as_unit)
    if is_letter_here or (is_usual_letter and not _gives_size(chain, place)):
        readings.reverse()
    return replace(side, readings=tuple(readings))


def _bare(node: Formula) -> tuple[Callable[[Formula], Formula], Formula]:
    """Return a formula without its sign, and what gives it back."""
    if isinstance(node, Negative):
        return (lambda part: replace(node, operand=part)), node.operand
    return (lambda part: part), node


def _both(node: Formula, name: str, scale: Fraction) -> tuple[Formula | None, Formula | None]:
    """Return a number times a letter, and the quantity in the unit of that name; None for neither."""
    if isinstance(node, Number):
        digits = (node.span[0], max(node.span[0], node.span[1] - 1))  # of which the letter is no unit
        number = replace(_scaled(node, 1 / scale), span=digits)
        return Product((number, Name(name, span=node.span)), span=node.span), node
    if isinstance(node, Product) and len(node.factors) == 2:
        number, letter = node.factors
        if isinstance(number, Number) and letter == Name(name):
            return node, replace(_scaled(number, scale), span=node.span)
        if isinstance(number, Number) and letter == Number(scale):
            return Product((number, Name(name, span=letter.span)), span=node.span), node
    return None, None


def _scaled(number: Number, scale: Fraction) -> Number:
    place = number.last_place
    return replace(number, value=number.value * scale, last_place=place * scale if place else None)


def _goes_on_with_another_number(chain: Chain, place: int, as_unit: Formula) -> bool:
    """Tell whether another number stands behind: in E = 0.38 W = 1.37 kJ the W is no watt."""
    after = chain.sides[place + 1].node if place + 1 < len(chain.sides) else None
    if not isinstance(after, Number) or not isinstance(as_unit, Number):
        return False
    return abs(after.value - as_unit.value) > _SAME * abs(as_unit.value)


def _gives_size(chain: Chain, place: int) -> bool:
    """Tell whether a side is the value that a lone letter, or a number, is set equal to."""
    before = chain.sides[place - 1].node if place else None
    return before is not None and not names(before)
