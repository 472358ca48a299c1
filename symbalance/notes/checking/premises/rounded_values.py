"""Numbers of an arithmetic that are letters' values, rounded: 240.9 for ω = 2π·2300/60.

A page need not print the value of a letter before it puts it in: m r ω² = 2.5·0.066·240.9² = 9.57 kN was
computed from ω, and 240.9 stands for all that is rounded to it.
"""

from __future__ import annotations

from symbalance.document.formula import Name, Number, names, walk
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.numbers_put_in import LONG, significant_digits
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.reading.equations import Chain

_CLOSE = 1e-9
"""Relative difference of a number that is a value with all its digits: a datum, not a rounded one."""


def values_put_in(chain: Chain, knowledge: Knowledge) -> frozenset[float]:
    """Return the decimals of a chain's arithmetic that are its first side's letters, rounded."""
    letters_put_in = names(chain.sides[0].node)
    if not any(n in knowledge.definitions or n in knowledge.meaning.values for n in letters_put_in):
        return frozenset()
    rows = [side.node for side in chain.sides[1:] if not names(side.node)]
    typed = {
        number
        for node in rows
        if not isinstance(node, Number)
        for number in walk(node)
        if isinstance(number, Number) and number.last_place and significant_digits(number) >= LONG
    }
    if not typed:
        return frozenset()
    values = [number_of(Name(name), knowledge) for name in sorted(letters_put_in)]
    return frozenset(
        abs(float(number.value))
        for number in typed
        for value in values
        if value is not None and _is_rounded(number, abs(float(value)))
    )


def _is_rounded(number: Number, value: float) -> bool:
    """Tell whether a number is a value to the last digit printed, and not the value itself."""
    assert number.last_place is not None
    gap = abs(abs(float(number.value)) - value)
    return _CLOSE * value < gap <= float(number.last_place) / 2
