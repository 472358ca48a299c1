"""Temperatures on two scales, 20 °C = 293.15 K: the scales begin elsewhere, so no factor converts them.

A difference, as its letter says, goes by degrees alone: ΔT = 20 °C = 20 K.
"""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import Name
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, UNDECIDED, Decision
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.text import lazy_patterns as re

_DEGREE = r"(?:°|\^\s?\\circ|\^\s?\{\s?\\circ\s?\}|\\degree)"
_SCALE = (
    rf"{_DEGREE}\s?(?:\\[,;: ]|\{{\s?\}})?\s?(?:\\(?:mathrm|text|rm|textrm)\s?\{{?\s?)?(?P<degrees>[CF])"
)
_TEMPERATURE = re.compile(
    r"\s*(?P<number>[-−]?[0-9]{1,6}(?:[.,][0-9]{1,6})?)(?:\s|\\[,;: ]|~|\$){0,4}"
    rf"(?:{_SCALE}|(?:\\(?:mathrm|text|textrm)\s?\{{\s?)?(?P<kelvin>K))[\s}}$]*"
)
_ZEROS = {"C": Fraction("273.15"), "F": Fraction("459.67"), "K": Fraction(0)}
_STEPS = {"C": Fraction(1), "F": Fraction(5, 9), "K": Fraction(1)}


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
    is_difference = isinstance(head, Name) and head.name.startswith(("Delta", "delta"))
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
