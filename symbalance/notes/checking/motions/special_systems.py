"""Special cases of a free vibration: letters set equal, J₁ = J₂ = J, or to a multiple, J₂ = 2 J.

With one inertia and one stiffness left, the natural modes are numbers: A₂/A₁ = 1 - 3.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Formula, Name, Number, Product, names
from symbalance.notes.algebra.domain import Domain
from symbalance.notes.algebra.evaluation import FormEvaluator, SymbolValue
from symbalance.notes.checking.deciding.equality import decide_equality
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.motions.equations_of_motion import EquationOfMotion
from symbalance.notes.reading.equations import Chain

_ZERO, _ONE, _TWO = Number(Fraction(0)), Number(Fraction(1)), Number(Fraction(2))
_BARE = Knowledge()


def equalities_in(chains: Sequence[Chain], known: frozenset[str]) -> list[tuple[Formula, ...]]:
    """Return what chains set equal: letters only, or one of the system to a formula in new letters."""
    equal: list[tuple[Formula, ...]] = []
    for chain in chains:
        sides = tuple(side.node for side in chain.sides)
        if len(sides) < 2 or any(relation.sign != "=" for relation in chain.relations):
            continue
        head = sides[0]
        if not isinstance(head, Name) or head.name not in known:
            continue
        has_new = bool(names(sides[-1]))
        letters = {side.name for side in sides[:-1] if isinstance(side, Name)}
        if not letters <= known:
            continue  # of a system with more discs
        if all(isinstance(side, Name) for side in sides) or (len(sides) == 2 and has_new):
            equal.append(sides)
    return equal


def chosen_letters(
    equal: Sequence[Sequence[Formula]], own: frozenset[str] | set[str], known: frozenset[str]
) -> Mapping[str, Formula]:
    """Return for each mass or stiffness that is set equal to others the formula it is written by."""
    classes: list[set[str]] = []
    formulas: dict[str, Formula] = {}
    for sides in equal:
        letters = {side.name for side in sides if isinstance(side, Name)}
        if len(letters) < len(sides):
            head, value = sides
            if isinstance(head, Name) and not names(value) & known:
                formulas[head.name] = value
            continue
        joined = letters.union(*(each for each in classes if each & letters))
        classes = [each for each in classes if not each & joined] + [joined]
    chosen: dict[str, Formula] = {}
    for each in classes:
        written = sorted(each & own) or sorted(each - known) or sorted(each & known)
        chosen |= {name: Name(written[0]) for name in each & known if written and name != written[0]}
    return formulas | chosen


def with_letters_chosen(equation: EquationOfMotion, chosen: Mapping[str, Formula]) -> EquationOfMotion:
    """Return an equation of motion of the special case."""
    factors = dict(equation.factors)
    for name, formula in chosen.items():
        factors = {key: substitute(factor, name, formula) for key, factor in factors.items()}
    return replace(equation, factors=factors)


def is_ratio_in_mode(
    still: Sequence[Sequence[Formula]],
    inertia: Sequence[Sequence[Formula]],
    places: tuple[int, int],
    ratio: Fraction,
) -> bool | None:
    """Tell whether amplitudes have a ratio in a natural mode of a system with one inertia and stiffness.

    `still` are the factors at rest and `inertia` those of -ω²; `places` say which amplitude is divided by
    which. None where more than one letter stands in either, or where two modes have one frequency.
    """
    rests, masses = _as_numbers(still), _as_numbers(inertia)
    if rests is None or masses is None:
        return None
    size = len(rests)
    rows = [[[rests[i][j], -masses[i][j]] for j in range(size)] for i in range(size)]
    whole = _determinant(rows)
    if not whole:
        return None
    above, below = places
    for row in range(size):
        minors = [_cofactor(rows, row, column) for column in range(size)]
        first, second = minors[above], minors[below]
        if not first and not second:
            continue
        common = _common(whole, _minus(first, _times([ratio], second)))
        both = _common(first, second)
        while len(shared := _common(common, both)) > 1:
            common = _quotient(common, shared)
        if len(common) > 1:
            return True
    has_double_root = len(_common(whole, [n * c for n, c in enumerate(whole)][1:])) > 1
    return None if has_double_root else False


def _as_numbers(rows: Sequence[Sequence[Formula]]) -> list[list[Fraction]] | None:
    """Return a matrix without its one letter, in which all of it is linear; None for others."""
    own = frozenset[str]().union(*(names(entry) for row in rows for entry in row))
    if len(own) != 1:
        return None
    (name,) = own
    numbers: list[list[Fraction]] = []
    for row in rows:
        numbers.append([])
        for entry in row:
            once, twice = (substitute(entry, name, n) for n in (_ONE, _TWO))
            if not decide_equality(Product((_TWO, once)), twice, _BARE).is_proved:
                return None
            value = number_of(once)
            if value is None:
                return None
            numbers[-1].append(value)
    return numbers


def number_of(node: Formula) -> Fraction | None:
    """Return a formula without letters as a fraction, None for an irrational one."""
    form = FormEvaluator(Domain(), SymbolValue()).form(node)
    if set(form.numerator) - {()} or set(form.denominator) - {()}:
        return None
    return Fraction(form.numerator.get((), 0)) / Fraction(form.denominator.get((), 1))


_Polynomial = list[Fraction]
"""Coefficients of a polynomial in ω², the constant first; [] is zero."""


def _trimmed(one: _Polynomial) -> _Polynomial:
    while one and not one[-1]:
        one = one[:-1]
    return one


def _minus(one: _Polynomial, other: _Polynomial) -> _Polynomial:
    size = max(len(one), len(other))
    first = [*one, *[Fraction(0)] * (size - len(one))]
    second = [*other, *[Fraction(0)] * (size - len(other))]
    return _trimmed([a - b for a, b in zip(first, second, strict=True)])


def _times(one: _Polynomial, other: _Polynomial) -> _Polynomial:
    product = [Fraction(0)] * max(len(one) + len(other) - 1, 0)
    for i, a in enumerate(one):
        for j, b in enumerate(other):
            product[i + j] += a * b
    return _trimmed(product)


def _divided(one: _Polynomial, other: _Polynomial) -> tuple[_Polynomial, _Polynomial]:
    """Return quotient and remainder."""
    quotient, rest = [Fraction(0)] * max(len(one) - len(other) + 1, 0), list(one)
    while len(rest) >= len(other) and rest:
        factor, shift = rest[-1] / other[-1], len(rest) - len(other)
        quotient[shift] = factor
        rest = _minus(rest, [Fraction(0)] * shift + [factor * c for c in other])
    return _trimmed(quotient), rest


def _quotient(one: _Polynomial, other: _Polynomial) -> _Polynomial:
    return _divided(one, other)[0]


def _common(one: _Polynomial, other: _Polynomial) -> _Polynomial:
    """Return the greatest common divisor; zero is divisible by everything."""
    while other:
        one, other = other, _divided(one, other)[1]
    return one


def _determinant(rows: Sequence[Sequence[_Polynomial]]) -> _Polynomial:
    if not rows:
        return [Fraction(1)]
    total: _Polynomial = []
    for column, entry in enumerate(rows[0]):
        minor = [[*row[:column], *row[column + 1 :]] for row in rows[1:]]
        part = _times(_trimmed(list(entry)), _determinant(minor))
        total = _minus(total, part) if column % 2 else _minus(total, _times([Fraction(-1)], part))
    return total


def _cofactor(rows: Sequence[Sequence[_Polynomial]], row: int, column: int) -> _Polynomial:
    others = [each for n, each in enumerate(rows) if n != row]
    minor = _determinant([[*each[:column], *each[column + 1 :]] for each in others])
    return _times([Fraction(-1)], minor) if (row + column) % 2 else minor
