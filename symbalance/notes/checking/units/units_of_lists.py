"""Numbers of a list that have the unit at its end: F_1 = m r ω² = 3.2 and F_2 = λ F_1 = 0.96 kN."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Negative, Number, Product
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.units.conversions import quantity_of
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.text import lazy_patterns as re

MOST = 4
"""Members of a list behind a number among which the unit is looked for."""
_BETWEEN = re.compile(r"[^\w.]{1,8}(?:(?:[^\W\d_]{1,4}|bzw\.|resp\.|stem:)[^\w.]{1,4})?")
"""What parts the members: marks, and a short word, F_1 = 3.2 and F_2 = 0.96 kN."""
_BARE = re.compile(r"[\s$]*[-+−]?[0-9][0-9.,{} \u2009]*[\s$]*")


def decide_in_unit_of_list(
    chain: Chain, k: int, document: ReadNotes, knowledge: Knowledge
) -> Decision | None:
    """Return the proof of a bare result in the unit behind the list that it begins, None for others."""
    left, right = chain.sides[k], chain.sides[k + 1]
    if k != len(chain.relations) - 1 or not isinstance(right.node, Number | Negative):
        return None
    scale = _scale_at_end(chain, document)
    if scale is None or _BARE.fullmatch(document.source(right.span)) is None:
        return None
    in_unit = replace(right, readings=(Product((right.node, Number(scale))),))
    there = decide(left, in_unit, chain.relations[k].sign, knowledge)
    return there if there.is_proved else None


def _scale_at_end(chain: Chain, document: ReadNotes) -> Fraction | None:
    """Return what the unit of the last member of a list is worth, None where there is none."""
    text = document.text
    behind = sorted((c for c in document.chains if c.start >= chain.end), key=lambda c: c.start)
    end = chain.sides[-1].span[1]
    for following in behind[:MOST]:
        if _BETWEEN.fullmatch(text, end, following.start) is None:
            return None
        last = following.sides[-1]
        quantity = quantity_of(last, document)
        if quantity is not None:
            return quantity.scale
        end = last.span[1]
    return None
