"""The units in which words count the letters of a relation: T in newton metres, n turns per minute.

A unit that words of the paragraph give a letter makes the letter a number of that unit; one that a table
of symbols declares is the unit of a quantity.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from symbalance.document.letters import plain_letter
from symbalance.notes.checking.units.stated_units import LETTER_SIGN
from symbalance.notes.checking.units.worded_units import WordedUnit, worded_unit
from symbalance.text import lazy_patterns as re

_IN_UNIT = re.compile(
    rf"{LETTER_SIGN}(?:\s+(?:is|are|being|be|always|here|measured|given|taken|expressed|counted|inserted|ist|wird|gemessen|gegeben|angegeben|eingesetzt|gezählt"
    r"|est|exprimée?|donnée?|mesurée?|è|espress[ao]|dat[ao]|misurat[ao]|es|expresad[ao]|dad[ao]|medid[ao]))*,?\s*"
    r"(?:\(?\s*(?:in|en)\s+(?:the\s+unit\s+)?|\[\s*|\(\s*)",
    re.IGNORECASE,
)
"""P in kW, T is given in N m, n [rpm]: up to the unit."""
_OF_TURNS = re.compile(rf"{LETTER_SIGN}\s+(?=\S)")
"""Right before the revolutions that a letter counts: n revolutions per minute."""
_COUNTS = re.compile(
    rf"{LETTER_SIGN}(?:\s+in\s+[^\W\d_]+)?\s+(?:counts|is|zählt|ist|compte|est|conta|è|cuenta|es)\s+"
    r"(?:(?:the|die|der|das|les?|la|il|el|los|number\s+of|Zahl|Anzahl|nombre\s+de|numero\s+di|número\s+de)\s+){0,2}",
    re.IGNORECASE,
)
"""f counts the revolutions per second; n ist die Zahl der Umdrehungen pro Minute."""
_OF_HEAD = re.compile(r"(?<![^\W\d_])(?:in|en)\s+(?=[^\W\d_])", re.IGNORECASE)
_LETTER_BEFORE = re.compile(r"(?:\$|(?<![^\W_])[^\W\d_])\s*,?\s*\(?$")
_TORQUE = re.compile(
    r"torque|twisting\s+moment|drehmoment|couple|coppia|momento\s+torcente|\bpar\b|トルク", re.IGNORECASE
)
_POUND_FEET = re.compile(
    r"[\s\\~${]{0,4}(?:mathrm\{|text\{)?(?:(?:lbs?|pounds?)(?:[\s·.-]|\\[,;]){0,2}(?:ft|feet|foot)"
    r"|(?:ft|foot|feet)(?:[\s·.-]|\\[,;]){0,2}(?:lbs?|pounds?))(?![A-Za-z])",
    re.IGNORECASE,
)
"""The unit of a torque in pounds that are forces: lb ft, foot-pounds."""
_NEAR = 40
"""Characters before a letter in which words call it a torque."""
_REACH = 80
_BEHIND = 200
"""Characters behind a relation in which words still say what its letters count."""


@dataclass(frozen=True, slots=True)
class LetterUnit:
    """A letter's unit, and whether words make the letter the number of it: n revolutions per minute."""

    unit: WordedUnit
    is_worded: bool
    is_number: bool = False


def units_in_words(text: str, names: frozenset[str]) -> dict[str, LetterUnit]:
    """Return the units that a text's words give letters; none for a letter that gets two.

    >>> words = "the torque $T$ in newton metres, $n$ revolutions per minute"
    >>> found = units_in_words(words, frozenset("Tn"))
    >>> found["T"].unit.text, found["n"].is_number
    ('N m', True)
    """
    signs = {sign: name for name in names for sign in (name, plain_letter(name))}
    found: dict[str, set[LetterUnit]] = {}
    for pattern, is_number in ((_IN_UNIT, False), (_OF_TURNS, True), (_COUNTS, True)):
        for match in pattern.finditer(text):
            name = signs.get(match["letter"].lstrip("\\").replace("{", "").replace("}", ""))
            words = text[max(0, match.start() - _NEAR) : match.start()]
            behind = text[match.end() : match.end() + _REACH]
            unit = None if name is None else _of_torque(words, behind) or worded_unit(behind)
            if name is None or unit is None or (is_number and not (unit.is_rate and _is_spelled(unit))):
                continue
            found.setdefault(name, set()).add(LetterUnit(unit, is_worded=True, is_number=is_number))
    return {name: _one(units) for name, units in found.items() if len({u.unit.scale for u in units}) == 1}


def _is_spelled(unit: WordedUnit) -> bool:
    """Tell whether a rate is written in words, or as rpm: n Hz may be a product."""
    return len(unit.text) > len("Hz") and unit.text not in ("1/s", "s^-1", "kHz")


def _one(units: set[LetterUnit]) -> LetterUnit:
    return max(units, key=lambda each: each.is_number)


def unit_of_sentence(sentence: str) -> LetterUnit | None:
    """Return the unit that a sentence names before its formula: in radians per second it is ω = …"""
    last = None
    for match in _OF_HEAD.finditer(sentence):
        if not _LETTER_BEFORE.search(sentence[: match.start()]):
            last = worded_unit(sentence[match.end() :]) or last
    return None if last is None else LetterUnit(last, is_worded=True)


def unit_behind(text: str, place: int) -> LetterUnit | None:
    """Return the unit right behind a formula: n = ω/(2π) rpm."""
    match = re.match(r"[\s$]{0,3}(?:\\\)\s?)?(?:\[|\(?in\s|en\s)?", text[place : place + 12])
    unit = worded_unit(text[place + (match.end() if match else 0) :][:_REACH])
    is_rate = unit is not None and unit.is_rate and _is_spelled(unit)
    return LetterUnit(unit, is_worded=True) if unit is not None and is_rate else None


def declared_units(symbols: Mapping[str, str], names: frozenset[str]) -> dict[str, LetterUnit]:
    """Return the units in brackets of a table of symbols."""
    found: dict[str, LetterUnit] = {}
    for name in names & symbols.keys():
        match = re.search(r"[\[(]\s*(?P<unit>[^\])]+?)\s*[\])]\s*$", symbols[name])
        unit = None if match is None else _of_torque(symbols[name], match["unit"])
        unit = unit or (None if match is None else worded_unit(match["unit"]))
        if unit is not None:
            found[name] = LetterUnit(unit, is_worded=False)
    return found


def _of_torque(words: str, unit: str) -> WordedUnit | None:
    """Return the unit of a torque in pounds and feet, where words call it that; None for others.

    >>> _of_torque("torque", "lb ft").text, _of_torque("unbalance", "lb ft")
    ('lbf ft', None)
    """
    is_torque = _POUND_FEET.match(unit) is not None and _TORQUE.search(words) is not None
    return worded_unit("lbf ft") if is_torque else None


def text_around(text: str, first: int, start: int, end: int) -> str:
    """Return the paragraph of a relation up to it, and a little of what stands behind."""
    behind = text[end : end + _BEHIND].partition("\n\n")[0]
    return f"{text[first:start]} \n {behind}"
