"""Numbers put in as they are printed where an author went on with all their digits: 0.04·152 = 6.07.

A page that prints ω = 2π·1450/60 = 152 may go on with 152 or with 151.84, and so may a result of letters:
m_1 + m_2 = 7.1 + 3.4 = 10.6 is right where the masses are 7.125 and 3.43. What the page's own lines give
for a printed number is put in its place; nothing else is forgiven.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import combinations

from symbalance.document.formula import Formula, Negative, Number, Product, Quotient, names, walk
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.substitution import replace_part
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.reading.equations import Chain, ReadNotes, Side

MOST = 3
"""Numbers of an arithmetic that are looked for above it."""
_DIGITS, _FINE = 10**12, Fraction(1, 10**12)


def decide_unrounded(chain: Chain, k: int, document: ReadNotes, knowledge: Knowledge) -> Decision | None:
    """Return the proof of a result by the digits that its numbers have further up; None for no proof."""
    left, right, sign = chain.sides[k], chain.sides[k + 1], chain.relations[k].sign
    is_result = not names(left.node) and not names(right.node) and _lone(left.node) is None
    if not is_result or _lone(right.node) is None or sign not in ("=", "≈"):
        return None
    meant = list(_unrounded(chain, k, document, knowledge))[:MOST]
    for count in range(len(meant), 0, -1):
        for chosen in combinations(meant, count):
            node = left.node
            for number, exact in chosen:
                node = replace_part(node, number, Number(exact, _FINE))
            there = decide(Side((node,), left.span), right, sign, knowledge)
            if there.is_proved:
                return there
    return None


def _unrounded(
    chain: Chain, k: int, document: ReadNotes, knowledge: Knowledge
) -> Iterator[tuple[Number, Fraction]]:
    """Yield the numbers of an arithmetic that are results printed before it, with their full digits."""
    start = chain.sides[k].span[0]
    ends = {}
    for earlier in document.chains:
        for before, behind in zip(earlier.sides, earlier.sides[1:], strict=False):
            printed = _lone(behind.node)
            if printed is not None and behind.span[1] <= start and _lone(before.node) is None:
                ends[_typed(printed, behind, document)] = before, behind, printed
    for number in walk(chain.sides[k].node):
        if not isinstance(number, Number) or number.span[0] == number.span[1]:
            continue
        entry = ends.get(document.source(number.span).strip())
        if entry is None:
            continue
        before, behind, printed = entry
        values = number_of(before.node, knowledge), number_of(behind.node, knowledge)
        if values[0] is None or not values[1]:
            continue
        ratio = Fraction(round(float(values[0] / values[1]) * _DIGITS), _DIGITS)
        half = (printed.last_place or Fraction(1)) / 2 / abs(printed.value)
        if 0 < abs(ratio - 1) <= half:
            exact = round(number.value * ratio / _FINE) * _FINE
            yield number, Fraction(exact)


def _lone(node: Formula) -> Number | None:
    """Return the number that a side consists of, with or without its unit."""
    if isinstance(node, Negative):
        return _lone(node.operand)
    if isinstance(node, Product) and len(node.factors) == 2:
        first, unit = node.factors
        is_turn = isinstance(unit, Quotient) and unit.numerator.span == unit.denominator.span
        is_factor = isinstance(unit, Number) and unit.last_place is None and unit.value.denominator > 1
        is_unit = is_turn or is_factor
        return first if isinstance(first, Number) and is_unit else None
    return node if isinstance(node, Number) and node.value else None


def _typed(number: Number, side: Side, document: ReadNotes) -> str:
    """Return the digits of a printed number as they are typed."""
    source = document.source(side.span).strip()
    end = next(
        (n for n, sign in enumerate(source) if not (sign.isdecimal() or sign in ".,")), len(source)
    )
    return source[:end]
