"""Real numbers of the exact fields as people write them: sums of fractions times cosines of degrees.

Every real number of a cyclotomic field is one: with x = sum of c_k e^(2 pi i k/m) and x = conj(x),

    x = Re x = sum of c_k cos(360 k/m).

So "1/2 cos 36 - 1/8" is exact, and is read by a grammar of its own: terms with a sign between, each a
fraction, a cosine, or a fraction and a cosine.
"""

from __future__ import annotations

import re
from fractions import Fraction

from symbalance.errors import SymbalanceError, brief
from symbalance.exact.angles import degrees
from symbalance.exact.phasor import Phasor
from symbalance.text.numbers import LARGEST_QUOTIENT, exact

MOST_TERMS = 100
"""Terms of one sum: nobody reads more."""
LONGEST = 4000
"""Characters of one sum that are looked at."""
_NUMBER = r"[0-9]{1,110}(?:\.[0-9]{1,110})?(?:/[0-9]{1,110})?"
TERM = rf"(?:{_NUMBER}\s*\*?\s*)?cos\s*{_NUMBER}|{_NUMBER}"
PATTERN = rf"^\s*[+-]?\s*(?:{TERM})(?:\s*[+-]\s*(?:{TERM}))*\s*$"
"""What a sum looks like, for a schema."""
_ONE = re.compile(rf"\s*([+-]?)\s*(?:({_NUMBER})?\s*\*?\s*cos\s*({_NUMBER})|({_NUMBER}))\s*")


def cosine_text(number: Phasor) -> str | None:
    """Return a real number as a sum of cosines, None where it takes too many terms.

    >>> cosine_text(Phasor.of(10, {1: Fraction(1, 4), 9: Fraction(1, 4), 0: Fraction(-1, 8)}))
    '-1/8 + 1/2 cos 36'
    """
    short = number.primitive()
    terms: dict[Fraction, Fraction] = {}
    for k, c in short.terms.items():
        turns = Fraction(k, short.modulus) % 1
        turns = min(turns, 1 - turns)
        sign = 1
        if turns > Fraction(1, 4):  # cos(180 - x) = -cos x
            turns, sign = Fraction(1, 2) - turns, -1
        terms[turns] = terms.get(turns, Fraction(0)) + sign * Fraction(c)
    cosines = [(turns, c) for turns, c in sorted(terms.items()) if c and turns != Fraction(1, 4)]
    if len(cosines) > MOST_TERMS:
        return None
    text = ""
    for turns, c in cosines:
        sign = ("-" if c < 0 else "") if not text else (" - " if c < 0 else " + ")
        text += sign + _term(abs(c), turns * 360)
    return text or "0"


def _term(size: Fraction, angle: Fraction) -> str:
    if not angle:
        return str(size)
    return f"cos {angle}" if size == 1 else f"{size} cos {angle}"


def read_cosines(text: str, name: str) -> Phasor:
    """Return the number that a sum of cosines of degrees says, exactly.

    >>> read_cosines("2 cos 45", "share").times(read_cosines("2 cos 45", "share")).rational()
    Fraction(2, 1)
    """
    total, place, count = Phasor.of(1, {}), 0, 0
    if len(text) > LONGEST:
        raise _refused(text, name)
    while place < len(text):
        term = _ONE.match(text, place)
        if term is None or (count and not term[1]) or count == MOST_TERMS:
            raise _refused(text, name)
        sign, factor, angle, alone = term.groups()
        size = exact(factor or alone or "1", name, LARGEST_QUOTIENT)
        total = total + _cosine(angle, name).scaled(-size if sign == "-" else size)
        place, count = term.end(), count + 1
    if not count:
        raise _refused(text, name)
    return total


def _cosine(angle: str | None, name: str) -> Phasor:
    if angle is None:
        return Phasor.of(1, {0: 1})
    turns = degrees(angle, name).turns
    half = Fraction(1, 2)
    return Phasor.root(turns).scaled(half) + Phasor.root(-turns).scaled(half)


def _refused(text: str, name: str) -> SymbalanceError:
    rule = "must be a number, or a sum of fractions times cosines of degrees"
    return SymbalanceError(f"{name} = {brief(text)}", rule, 'write it like 0.5 or "1/2 cos 36 - 1/8"')
