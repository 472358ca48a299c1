"""Real cyclotomic numbers as people write them: radicals where they exist, cosines elsewhere.

A real number of an abelian field splits exactly into one part for each conjugacy class of even
characters of its Galois group (Z/m)*. The part of a character of order 1 is rational, the square of
a part of order 2 is rational, and the square of a part of order 4 lies in a quadratic field. So

    x = a + sum of +-sqrt(b) + sum of +-sqrt(c + d sqrt(e))

exactly when only characters of order 1, 2 and 4 occur: in-line fives, sixteenths of a turn, ....
Characters of order 3 (sevenths, ninths) admit no real radicals at all (the casus irreducibilis);
those numbers, and deeper towers, are written as rational combinations of cosines or sines instead.
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from functools import cache, lru_cache
from itertools import product
from math import gcd
from typing import TYPE_CHECKING, Any

from mpmath import mp

from symbalance.phasor import Phasor, prime_factors
from symbalance.rational import Real

if TYPE_CHECKING:
    import sympy

MOST_TO_SHORTEN = 100
"""A sum of more cosines is printed as it stands."""
LARGEST_RADICAL_FIELD = 240
"""Numbers of larger fields are written with cosines, without a search for radicals."""


def exact_form(number: Phasor) -> sympy.Expr:
    """Return a real cyclotomic number as a SymPy expression.

    >>> exact_form(Phasor.of(5, {1: 2, 4: 2}))
    -1 + sqrt(5)
    >>> exact_form(Phasor.of(7, {1: 1, 6: 1}))
    2*cos(2*pi/7)
    """
    return _cached_form(number.modulus, tuple(sorted(number.terms.items())))


@lru_cache(maxsize=4096)
def _cached_form(modulus: int, terms: tuple[tuple[int, int | Fraction], ...]) -> sympy.Expr:
    number = Phasor(modulus, dict(terms))
    form = radical_form(number.primitive())
    return form if form is not None else trigonometric_form(number)


def evaluated(number: Phasor, digits: int) -> Real:
    """Return a real cyclotomic number to `digits` significant digits, whatever cancels in it."""
    if number.is_zero():
        return mp.mpf(0)
    size = sum(abs(Fraction(c)) for c in number.terms.values())
    working = digits + 15
    while True:
        with mp.workdps(working):
            value = mp.fsum(
                mp.mpf(Fraction(c).numerator)
                / Fraction(c).denominator
                * mp.cospi(mp.mpf(2 * k) / number.modulus)
                for k, c in number.terms.items()
            )
            lost = mp.mpf(10) ** (digits + 5 - working) * size.numerator / size.denominator
            if abs(value) > lost:
                return value
        working *= 2


def square_root_form(square: Phasor) -> sympy.Expr:
    """Return the positive root of a positive real cyclotomic number.

    >>> square_root_form(Phasor.of(1, {0: 10}))
    sqrt(10)
    >>> square_root_form(Phasor.of(12, {0: 2, 1: 1, 11: 1}))  # of 2 + sqrt(3)
    sqrt(2)/2 + sqrt(6)/2
    """
    import sympy

    form = exact_form(square)
    rational, root = form.as_coeff_Add()
    radicand: Any
    factor, radicand = root.as_coeff_Mul()
    if radicand.is_Pow and radicand.exp == sympy.Rational(1, 2) and radicand.base.is_Rational:
        return _denested(rational, factor, radicand.base)
    return tidy_root(form)


def tidy_root(form: sympy.Expr) -> sympy.Expr:
    """Return the root of a positive number with the square factors of its content before it.

    >>> import sympy
    >>> tidy_root(sympy.Rational(5, 4) - sympy.sqrt(5) / 2)
    sqrt(5 - 2*sqrt(5))/2
    """
    import sympy

    content, rest = form.primitive()
    outside, inside = sympy.S.One, sympy.S.One
    for prime, power in sympy.factorrat(content).items():
        half = int(power / 2)  # towards zero, so that an odd power of a denominator stays inside
        outside *= sympy.Integer(prime) ** half
        inside *= sympy.Integer(prime) ** (power - 2 * half)
    return outside * sympy.sqrt(sympy.expand(inside * rest))


def _denested(rational: sympy.Expr, factor: sympy.Expr, base: sympy.Expr) -> sympy.Expr:
    """Return sqrt(a + b sqrt(d)) as sqrt(x) +- sqrt(y) where x and y are rational."""
    import sympy

    inner = sympy.sqrt(rational**2 - factor**2 * base)
    if not inner.is_Rational:
        return tidy_root(rational + factor * sympy.sqrt(base))
    large, small = (rational + inner) / 2, (rational - inner) / 2
    return sympy.sqrt(large) + (1 if factor > 0 else -1) * sympy.sqrt(small)


# Radicals: one part for each class of characters ------------------------------------------------


def radical_form(number: Phasor) -> sympy.Expr | None:
    """Return a real number in radicals nested at most twice, or None where that is impossible."""
    import sympy

    if number.modulus > LARGEST_RADICAL_FIELD:
        return None
    parts, left = [], number
    for character in _even_characters(number.modulus):
        part = _projected(number, character)
        if part.is_zero():
            continue
        left = left - part
        parts.append(_part_form(part, character.order))
    return sympy.Add(*parts) if left.is_zero() else None


def _part_form(part: Phasor, order: int) -> sympy.Expr:
    import sympy

    if order == 1:
        value = part.rational()
        assert value is not None
        return sympy.Rational(value.numerator, value.denominator)
    square = radical_form(part.times(part).primitive())
    assert square is not None
    return tidy_root(square) if evaluated(part, 15) > 0 else -tidy_root(square)


class _Character:
    """An even character of (Z/m)* with values in the fourth roots of unity, as logarithms mod 4."""

    def __init__(self, logarithms: dict[int, int]) -> None:
        self.logarithms = logarithms
        self.order = 4 // gcd(4, *logarithms.values())


def _projected(number: Phasor, character: _Character) -> Phasor:
    """Return the part of `number` that belongs to a character and its conjugate."""
    weight = (1, 0, -1, 0)
    total = Phasor(1, {})
    for unit, logarithm in character.logarithms.items():
        if weight[logarithm]:
            total = total + number.mapped(unit).scaled(weight[logarithm])
    classes = 2 if character.order == 4 else 1
    return total.scaled(Fraction(classes, len(character.logarithms)))


@cache
def _even_characters(modulus: int) -> tuple[_Character, ...]:
    """Return one character of each conjugate pair, of order 1, 2 or 4, trivial on -1."""
    units = [u for u in range(1, modulus + 1) if gcd(u, modulus) == 1]
    tables = [table for power in _prime_powers(modulus) for table in _logarithm_tables(power)]
    found: dict[tuple[int, ...], _Character] = {}
    for exponents in product(range(4), repeat=len(tables)):
        logarithms = _logarithms(units, tables, exponents)
        if logarithms is None or logarithms[modulus - 1 if modulus > 1 else 1] != 0:
            continue
        key = tuple(logarithms.values())
        conjugate = tuple(-v % 4 for v in key)
        if key not in found and conjugate not in found:
            found[key] = _Character(logarithms)
    return tuple(sorted(found.values(), key=lambda c: c.order))


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


# Cosines and sines: the shortest of the natural bases ---------------------------------------------


def trigonometric_form(number: Phasor) -> sympy.Expr:
    """Return a real number as a short rational combination of cosines, or of sines.

    >>> trigonometric_form(Phasor.of(28, {1: 1, 27: 1, 3: 1, 25: 1}))
    2*sin(2*pi/7) + 2*sin(3*pi/7)
    """
    import sympy

    rotated = number.turned(Fraction(1, 4))
    cosines, sines = _shortest(number, 1), _shortest(rotated, -1)
    as_sines = _length(sines, rotated.modulus) < _length(cosines, number.modulus)
    terms, modulus = (sines, rotated.modulus) if as_sines else (cosines, number.modulus)
    function = sympy.sin if as_sines else sympy.cos
    return sympy.Add(
        *(
            sympy.Rational(c.numerator, c.denominator)
            * function(2 * sympy.pi * sympy.Rational(k, modulus))
            for k, c in terms.items()
        )
    )


def _length(terms: dict[int, Fraction], modulus: int) -> tuple[int, int]:
    """Return what is compared between cosines and sines: how many, and how fine their angles."""
    return len(terms), sum(Fraction(2 * k, modulus).denominator for k in terms)


def _shortest(number: Phasor, parity: int) -> dict[int, Fraction]:
    """Return a number as few cosines (parity 1) or sines (-1) of 2 pi k/m, 0 <= k <= m/2.

    Sums over the p powers a p-th of a turn apart vanish; such a sum is taken away, so often as one of
    the coefficients says, wherever that leaves fewer terms or smaller ones.
    """
    modulus = number.modulus
    terms = _folded(((k, Fraction(c)) for k, c in number.terms.items()), modulus, parity)
    improved = len(terms) <= MOST_TO_SHORTEN
    while improved:
        improved = False
        for exponent, prime in product(list(terms), prime_factors(modulus)):
            steps = range(exponent, exponent + modulus, modulus // prime)
            relation = _folded(((k % modulus, Fraction(1)) for k in steps), modulus, parity)
            better = _least(terms, relation)
            if better is not None:
                terms, improved = better, True
                break
    return dict(sorted(terms.items()))


def _least(terms: dict[int, Fraction], relation: dict[int, Fraction]) -> dict[int, Fraction] | None:
    """Return `terms` less the multiple of a vanishing sum that helps most, None if none does."""
    if 2 * len(terms.keys() & relation.keys()) < len(relation):
        return None  # it would bring more terms than it takes
    best, found = _cost(terms), None
    for multiple in {terms[k] / c for k, c in relation.items() if k in terms}:
        changed = dict(terms)
        for k, c in relation.items():
            changed[k] = changed.get(k, Fraction(0)) - multiple * c
        changed = {k: c for k, c in changed.items() if c}
        if (cost := _cost(changed)) < best:
            best, found = cost, changed
    return found


def _cost(terms: dict[int, Fraction]) -> tuple[int, Fraction, int]:
    values = terms.values()
    return len(terms), sum(map(abs, values), Fraction(0)), sum(c < 0 for c in values)


def _folded(terms: Iterable[tuple[int, Fraction]], modulus: int, parity: int) -> dict[int, Fraction]:
    """Return the terms with m - k folded onto k, as cos does (parity 1) or sin (-1)."""
    total: dict[int, Fraction] = {}
    for exponent, coefficient in terms:
        k, sign = (exponent, 1) if 2 * exponent <= modulus else (modulus - exponent, parity)
        total[k] = total.get(k, Fraction(0)) + sign * coefficient
    return {k: c for k, c in total.items() if c and not (parity < 0 and 2 * k % modulus == 0)}
