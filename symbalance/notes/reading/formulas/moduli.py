r"""The modulus behind a congruence: 900° ≡ 180° (mod 720°), n \equiv 1 \pmod{4}, modulo 2π."""

from __future__ import annotations

from fractions import Fraction
from typing import NamedTuple

from symbalance.document.formula import PI, Formula, Name, Number, Product
from symbalance.text import lazy_patterns as re

_MODULUS = re.compile(
    r"(?:[\s$,~]|\\[,;:! ]|\\q?quad)*\(?\s*"
    r"(?:\\[pb]?mod(?![a-z])|\\(?:mathrm|text|operatorname)\{\s*mod\s*\}|mod(?:ulo|\.)?(?![a-z]))[\s$~{]*"
    r"(?P<modulus>(?P<number>[0-9]+(?:/[0-9]+)?)?\s*"
    r"(?P<unit>°|\^\s*\{?\\circ\}?|\\degree|\\pi|π)?"
    r"(?P<letter>(?<![0-9])[A-Za-z](?![A-Za-z]|[ ][a-z]{2}))?"
    r"(?P<turn>(?:an?[ ]|one[ ])?(?:full[ ]|whole[ ]|complete[ ])?(?:turn|revolution)(?![a-z]))?)"
    r"(?P<more>\s*[-+−*/^·(_])?[\s}]*\)?"
)


class Modulus(NamedTuple):
    """A modulus as it is typed, its value, None where it is not read, and where it ends."""

    text: str
    value: Formula | None
    end: int


def modulus_at(text: str, place: int, end: int | None = None) -> Modulus | None:
    """Return the modulus that a text has at a place, behind a right side; None where it has none.

    >>> modulus = modulus_at("13 ≡ 1 (mod 4)", 6)
    >>> modulus.text, modulus.value.value, modulus.end, modulus_at("13 ≡ 1 (mod 4)", 0)
    ('4', Fraction(4, 1), 14, None)
    """
    match = _MODULUS.match(text, place, len(text) if end is None else end)
    if match is None:
        return None
    number, unit, letter = match["number"], match["unit"], match["letter"]
    value: Formula | None = Number(Fraction(number)) if number else None
    if match["more"]:
        value = None
    elif match["turn"]:
        value = Product((Number(Fraction(2)), PI))
    elif letter:
        value = Name(letter)
    elif unit:
        half_turn = PI if unit in ("\\pi", "π") else Product((Number(Fraction(1, 180)), PI))
        value = Product((value or Number(Fraction(1)), half_turn))
    return Modulus(match["modulus"].strip(), value, match.end())


def modulus_end(text: str, place: int, end: int) -> int:
    """Return where a modulus that begins at a place ends; 0 where none begins."""
    modulus = modulus_at(text, place, end)
    return modulus.end if modulus is not None else 0
