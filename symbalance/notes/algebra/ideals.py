"""Polynomial equations taken together: whether they can be true at once, and what follows from them.

Each equation p = 0 is a polynomial in letters, phases e^(iθ) and roots, every one a variable, those with
a relation of their own (i² = -1, R² = q) with that relation beside them. A Gröbner basis (Buchberger
1965) decides: no numbers at all satisfy the equations if 1 is a combination of them, and p = 0 follows
from them if none satisfy them together with p t = 1 (Rabinowitsch 1929). Both are proofs; where neither
comes out, nothing is proved: real numbers are fewer than complex ones.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from math import gcd

from symbalance.notes.algebra.domain import TURN, Domain, Monomial, Polynomial, TooLargeError
from symbalance.notes.algebra.unit_ideals import Dense, Powers, has_constant

MOST_VARIABLES = 14
MOST_TERMS = 60
"""Of an equation that is taken in."""


def cannot_hold(domain: Domain, equations: Sequence[Polynomial], nonzero: Iterable[int] = ()) -> bool:
    """Tell whether no numbers satisfy p = 0 for all equations; generators of `nonzero` are not 0.

    >>> domain = Domain()
    >>> x, y, one = ((domain.symbol("x"), 1),), ((domain.symbol("y"), 1),), Fraction(1)
    >>> product, left, right = {(*x, *y): one, (): -one}, {x: one, (): -2 * one}, {y: one, (): -2 * one}
    >>> cannot_hold(domain, [product, left]), cannot_hold(domain, [product, left, right])
    (False, True)
    """
    try:
        system = _System(domain, [*equations], set(nonzero))
        return has_constant(system.rows)
    except (TooLargeError, _OtherKindError):
        return False


def follows(
    domain: Domain, equations: Sequence[Polynomial], claim: Polynomial, nonzero: Iterable[int] = ()
) -> bool:
    """Tell whether claim = 0 wherever all equations hold, by proof."""
    try:
        system = _System(domain, [*equations, claim], set(nonzero))
        *rows, claimed = system.rows_of_equations
        size = len(system.variables) + 1
        away: dict[tuple[int, ...], Fraction] = {(*p, 1): factor for p, factor in claimed.items()}
        away[(0,) * size] = away.get((0,) * size, Fraction(0)) - 1
        wider = [{(*p, 0): c for p, c in row.items()} for row in (*rows, *system.relations)]
        return has_constant([*wider, away])
    except (TooLargeError, _OtherKindError):
        return False


def _take_roots(rows: Iterable[list[tuple[dict[object, int], Fraction]]]) -> None:
    """Write a variable whose exponents all are multiples of a number as the root of another, in place.

    The phase of half a degree stands as a 720th part of a turn, with exponents of hundreds, each of which
    a basis climbs by. Every complex number is such a power, so what can hold is the same.
    """
    monomials = [powers for row in rows for powers, _ in row]
    common: dict[object, int] = {}
    for powers in monomials:
        for variable, power in powers.items():
            common[variable] = gcd(common.get(variable, 0), power)
    for powers in monomials:
        for variable in powers:
            powers[variable] //= common[variable]


class _OtherKindError(Exception):
    """A generator or an exponent that is no variable of a polynomial: a cube root, a turn of 1/5."""


@dataclass
class _System:
    """Equations over a domain as polynomials in variables, and the relations between those."""

    domain: Domain
    equations: list[Polynomial]
    nonzero: set[int]
    variables: dict[object, int] = field(default_factory=dict)
    relations: list[Dense] = field(default_factory=list)
    rows_of_equations: list[Dense] = field(default_factory=list)

    def __post_init__(self) -> None:
        inverted: set[int] = set()
        rows: list[list[tuple[dict[object, int], Fraction]]] = []
        waiting = [self._cleared(equation, inverted) for equation in self.equations]
        count, entered = len(waiting), set[object]()
        relations: list[list[tuple[dict[object, int], Fraction]]] = []
        for row in waiting:
            rows.append(row)
            for powers, _ in row:
                for variable in powers:
                    if variable not in entered:
                        entered.add(variable)
                        relation = self._relation(variable, inverted)
                        if relation is not None:
                            relations.append(relation)
                            waiting.append(relation)
        del rows[count:]
        _take_roots((*rows, *relations))
        for place in sorted((inverted | self.nonzero) & entered):  # type: ignore[type-var]
            relations.append([({place: 1, ("over", place): 1}, Fraction(1)), ({}, Fraction(-1))])
        for row in (*rows, *relations):
            for powers, _ in row:
                for variable in powers:
                    self.variables.setdefault(variable, len(self.variables))
        if len(self.variables) > MOST_VARIABLES:
            raise TooLargeError("more letters than are eliminated")
        self.rows_of_equations = [self._dense(row) for row in rows]
        self.relations = [self._dense(row) for row in relations]

    @property
    def rows(self) -> list[Dense]:
        """The equations and the relations."""
        return [*self.rows_of_equations, *self.relations]

    def _cleared(
        self, equation: Polynomial, inverted: set[int]
    ) -> list[tuple[dict[object, int], Fraction]]:
        """Return an equation times the powers that its denominators hold; those are not zero."""
        if len(equation) > MOST_TERMS:
            raise TooLargeError("a long equation")
        lowest: dict[int, int] = {}
        for monomial in equation:
            for number, exponent in monomial:
                if exponent < 0:
                    if exponent.denominator != 1:
                        raise _OtherKindError
                    lowest[number] = min(lowest.get(number, 0), int(exponent))
        inverted |= lowest.keys()
        row = []
        for monomial, coefficient in equation.items():
            powers = dict(monomial)
            for number, least in lowest.items():
                powers[number] = powers.get(number, 0) - least
            row.append((self._powers(tuple(powers.items())), coefficient))
        return row

    def _powers(self, monomial: Monomial) -> dict[object, int]:
        result: dict[object, int] = {}
        for number, exponent in monomial:
            kind, scale = self.domain.generators[number].kind, 1
            if kind == "turn":
                scale = 4
            elif kind == "prime":
                scale = 2
            power = exponent * scale
            if power.denominator != 1:
                raise _OtherKindError
            if power:
                result[number] = int(power)
        return result

    def _relation(
        self, variable: object, inverted: set[int]
    ) -> list[tuple[dict[object, int], Fraction]] | None:
        """Return what a generator obeys: i² + 1, (√p)² - p, R² - q."""
        if not isinstance(variable, int):
            return None
        generator = self.domain.generators[variable]
        if generator.kind == "turn":
            return [({TURN: 2}, Fraction(1)), ({}, Fraction(1))]
        if generator.kind == "prime":
            return [({variable: 2}, Fraction(1)), ({}, Fraction(-generator.content))]
        if generator.kind == "radical":
            content = {m: -c for m, c in generator.content.items()}
            return self._cleared({((variable, 2),): Fraction(1), **content}, inverted)
        if generator.kind == "exponential":
            inverted.add(variable)
        return None

    def _dense(self, row: list[tuple[dict[object, int], Fraction]]) -> Dense:
        size, total = len(self.variables), dict[Powers, Fraction]()
        for powers, coefficient in row:
            exponents = [0] * size
            for variable, power in powers.items():
                exponents[self.variables[variable]] = power
            key = tuple(exponents)
            total[key] = total.get(key, Fraction(0)) + coefficient
        return {key: c for key, c in total.items() if c}
