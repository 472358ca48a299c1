"""Radicals of a real cyclotomic number, from its parts under the characters of the Galois group."""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from itertools import product
from math import gcd

from symbalance.exact.phasor import ZERO, Phasor, common_denominator, prime_factors
from symbalance.exact.radicals.closed_forms import ClosedForm, square_root

LARGEST_RADICAL_FIELD = 240
"""Numbers of larger fields are written with cosines, without a search for radicals."""


def radical_form(number: Phasor) -> ClosedForm | None:
    """Return a real number in radicals nested at most twice, or None where that is impossible."""
    if number.modulus > LARGEST_RADICAL_FIELD:
        return None
    projections = [(_projected(number, c), c.order) for c in _even_characters(number.modulus)]
    parts = [(part, order) for part, order in projections if not part.is_zero()]
    if not (number - sum((part for part, _ in parts), ZERO)).is_zero():
        return None
    forms = (_part_form(part, order) for part, order in parts)
    return ClosedForm.of(term for form in forms for term in form.terms.items())


def _part_form(part: Phasor, order: int) -> ClosedForm:
    if order == 1:
        value = part.rational()
        assert value is not None
        return ClosedForm.rational(value)
    square = radical_form(part.times(part).primitive())
    assert square is not None
    return square_root(square).scaled(1 if part.real_value(15) > 0 else -1)


class _Character:
    """An even character of (Z/m)* with values in the fourth roots of unity, as logarithms mod 4."""

    def __init__(self, logarithms: dict[int, int]) -> None:
        self.logarithms = logarithms
        self.order = 4 // gcd(4, *logarithms.values())
        real = (1, 0, -1, 0)
        self.weights = {unit: real[e] for unit, e in logarithms.items() if real[e]}


def _projected(number: Phasor, character: _Character) -> Phasor:
    """Return the part of `number` that belongs to a character and its conjugate."""
    classes, modulus = 2 if character.order == 4 else 1, number.modulus
    terms, below = common_denominator(number.terms)
    total: dict[int, int] = {}
    for unit, weight in character.weights.items():
        for k, c in terms.items():
            place = k * unit % modulus
            total[place] = total.get(place, 0) + weight * c
    return Phasor.of(modulus, total).scaled(Fraction(classes, below * len(character.logarithms)))


@cache
def _even_characters(modulus: int) -> tuple[_Character, ...]:
    """Return one character of each conjugate pair, of order 1, 2 or 4, trivial on -1."""
    units = [u for u in range(1, modulus + 1) if gcd(u, modulus) == 1]
    tables = [table for power in _prime_powers(modulus) for table in _logarithm_tables(power)]
    characters: dict[tuple[int, ...], _Character] = {}
    for exponents in product(range(4), repeat=len(tables)):
        logarithms = _logarithms(units, tables, exponents)
        if logarithms is None or logarithms[modulus - 1 if modulus > 1 else 1] != 0:
            continue
        key = tuple(logarithms.values())
        conjugate = tuple(-v % 4 for v in key)
        if key not in characters and conjugate not in characters:
            characters[key] = _Character(logarithms)
    return tuple(sorted(characters.values(), key=lambda c: c.order))


def _prime_powers(modulus: int) -> list[int]:
    return [max(p**e for e in range(1, 64) if modulus % p**e == 0) for p in prime_factors(modulus)]


_Table = tuple[int, int, dict[int, int]]  # the prime power, a generator's order, its logarithms


def _logarithm_tables(power: int) -> list[_Table]:
    """Return discrete logarithms to generators of (Z/p^a)*: one, or for 2^a the pair -1 and 5."""
    if power % 2 == 0:
        signs = {u: (u % 4) // 2 for u in range(1, power, 2)}
        order = max(power // 4, 1)
        fives = {pow(5, e, power): e for e in range(order)}
        logs = {u: fives[u if u % 4 == 1 else power - u] for u in signs} if power > 2 else {1: 0}
        return [(power, 2 if power > 2 else 1, signs), (power, order, logs)]
    units = [u for u in range(1, power) if gcd(u, power) == 1]
    for generator in units:
        logs = {pow(generator, e, power): e for e in range(len(units))}
        if len(logs) == len(units):
            return [(power, len(units), logs)]
    raise AssertionError(f"no generator modulo {power}")


def _logarithms(
    units: list[int], tables: list[_Table], exponents: tuple[int, ...]
) -> dict[int, int] | None:
    """Return unit -> logarithm mod 4 of the character that sends each generator to i^exponent."""
    if any(order * e % 4 for (_, order, _), e in zip(tables, exponents, strict=True)):
        return None
    return {
        unit: sum(e * logs[unit % power] for (power, _, logs), e in zip(tables, exponents, strict=True))
        % 4
        for unit in units
    }
