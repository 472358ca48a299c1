"""What kind of quantity a page gives a letter: m = 0.45 kg is a mass, r = 33 mm a length.

A name of two letters that has a value of the kind of its first letter is no product: m·r is no mass.
"""

from __future__ import annotations

from symbalance.text import lazy_patterns as re

_QUANTITY = re.compile(
    r"[ \t]*[=≈≒≃][ \t]*(?P<number>[0-9]+(?:[.,][0-9]+)?)[ \t]*(?P<unit>[A-Za-zµ]{1,3})"
    r"(?![\w·*×/²³^-]|[ ](?:m|s|N)(?!\w))"
)
"""One number with a simple unit, and no formula."""
_KINDS = {
    "mass": "kg g mg t lb lbs",
    "length": "m mm cm dm km in ft",
    "force": "N kN MN daN lbf",
}
_KIND_OF_UNIT = {unit: kind for kind, units in _KINDS.items() for unit in units.split()}
USUAL_KIND = {"m": "mass", "M": "mass", "F": "force"} | dict.fromkeys("rRlLs", "length")
"""What a letter is where the page gives it no value."""
_NOUN_BEFORE = re.compile(
    r"(?<![^\W\d_])(?:(?P<mass>[Mm]ass(?:es|e|en)?|mass[ao]|masa|[Cc]ounterweight|Gegengewicht|contrepoids)"
    r"|(?P<length>[Rr]adius|rayon|raggio|radio|[Ll]ength|longueur|Länge|[Ss]troke|Hub))[ ]$"
)


def kind_of_value(plain: str, place: int) -> str | None:
    """Return the kind of the number with a unit that a sign at a place gives, None for another."""
    match = _QUANTITY.match(plain, place)
    return _KIND_OF_UNIT.get(match["unit"]) if match else None


def is_of_kind_of_base(spelling: str, place: int, plain: str) -> bool:
    """Tell whether mr has a value at a place of the kind of its first letter, m, which m·r cannot be.

    It is the product where its number is that of the product: the unit is then the mistake.

    >>> page = "m = 3 kg, r = 2 m, mr = {} kg"
    >>> [is_of_kind_of_base("mr", 21, page.format(number)) for number in (5, 6)]
    [True, False]
    """
    if len(spelling) != 2 or (kind := kind_of_value(plain, place)) is None:
        return False
    base, factor = (_quantity_of(letter, plain) for letter in spelling)
    if base[0] != kind or factor[0] is None:
        return False
    value = _QUANTITY.match(plain, place)
    if value is None or base[1] is None or factor[1] is None:
        return True
    number = _number(value)
    return abs(number - base[1] * factor[1]) > number / 50


def is_of_kind_of_noun(spelling: str, place: int, plain: str) -> bool:
    """Tell whether the noun before mr says the kind of its first letter: rotating mass mr."""
    noun = _NOUN_BEFORE.search(plain, max(place - 24, 0), place)
    return noun is not None and USUAL_KIND.get(spelling[0]) == noun.lastgroup


def _quantity_of(letter: str, plain: str) -> tuple[str | None, float | None]:
    """Return the kind of a letter and its number, as the page gives them or as is usual."""
    for match in re.finditer(rf"(?<![\w\\\u0370-\u03ff]){letter}(?=[ \t]*=)", plain):
        if given := _QUANTITY.match(plain, match.end()):
            return _KIND_OF_UNIT.get(given["unit"]), _number(given)
    return USUAL_KIND.get(letter), None


def _number(match: re.Match[str]) -> float:
    return float(match["number"].replace(",", "."))
