"""Lengths put in without their unit beside letters that have one: p = F/(80·90) = 15.4 N/mm².

The force is in newtons, 80 and 90 are in millimetres, as the unit of the result says: its mm² stand for
two numbers without a unit.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from symbalance.document.formula import Formula, Number, Power, Product, Quotient, names
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.units.dimensions import written_unit
from symbalance.notes.reading.equations import Chain, ReadNotes, Side
from symbalance.text import lazy_patterns as re

LEAST = 5
"""A number below it is a factor of the formula rather than a length in mm or cm."""
_LENGTH = re.compile(
    r"(?P<prefix>[mc])m(?:\^?\(?\{?(?P<power>[-−]?[2-4])|(?P<raised>⁻?[²³⁴]))?(?![A-Za-z])"
)
_SCALES = {"m": Fraction(1, 1000), "c": Fraction(1, 100)}
_RAISED = {"²": 2, "³": 3, "⁴": 4}


def decide_with_bare_lengths(
    chain: Chain, k: int, document: ReadNotes, knowledge: Knowledge
) -> Decision | None:
    """Return the decision with the bare numbers of the left side in the length of its unit."""
    left, right = chain.sides[k], chain.sides[k + 1]
    unit = written_unit(document.source(right.span))[1]
    length = _LENGTH.search(unit)
    if length is None or not names(left.node) or names(right.node):
        return None
    power = int((length["power"] or "1").replace("−", "-"))
    power = _RAISED[length["raised"][-1]] if length["raised"] else power
    power = -power if "/" in unit[: length.start()] else power
    bare = list(_bare(left.node, document))
    if not bare or sum(own for _, own in bare) != power:
        return None
    if any(_is_in_another(number, length["prefix"], document) for number, _ in bare):
        return None
    scaled = Product((left.node, Number(_SCALES[length["prefix"]] ** power)))
    return decide(Side((scaled,), left.span), right, chain.relations[k].sign, knowledge)


def _is_in_another(number: Number, prefix: str, document: ReadNotes) -> bool:
    """Tell whether the page has a number in another unit of length: a pin of 80 mm by 90 mm."""
    typed = re.escape(document.source(number.span).strip())
    units = re.findall(rf"(?<![0-9.,]){typed}[$\s~]{{0,3}}([mc])m(?![A-Za-z])", document.text)
    return bool(units) and prefix not in units


def _bare(node: Formula, document: ReadNotes, power: int = 1) -> Iterator[tuple[Number, int]]:
    """Yield each factor that is a number without a unit and may be a length, and its power."""
    if isinstance(node, Number) and node.value >= LEAST:
        yield node, power
    elif isinstance(node, Product) and not any(_is_unit(factor, document) for factor in node.factors):
        for factor in node.factors:
            yield from _bare(factor, document, power)
    elif isinstance(node, Quotient):
        yield from _bare(node.numerator, document, power)
        yield from _bare(node.denominator, document, -power)
    elif isinstance(node, Power) and isinstance(node.exponent, Number) and not node.exponent.value % 1:
        yield from _bare(node.base, document, power * int(node.exponent.value))


def _is_unit(node: Formula, document: ReadNotes) -> bool:
    return isinstance(node, Number) and any(c.isalpha() for c in document.source(node.span))
