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
from itertools import combinations

from symbalance.notes.algebra.domain import TURN, Domain, Monomial, Polynomial, TooLargeError

Powers = tuple[int, ...]
Dense = dict[Powers, Fraction]
"""A polynomial by the exponents of all variables."""
MOST_VARIABLES = 14
MOST_TERMS = 60
"""Of an equation that is taken in."""
MOST_STEPS = 4000
"""Reductions of one polynomial by another: some tenths of a second."""
LARGEST_BITS = 2000
"""Of a coefficient on the way."""


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
        return _has_constant(system.rows)
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
        return _has_constant([*wider, away])
    except (TooLargeError, _OtherKindError):
        return False


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


def _has_constant(rows: list[Dense]) -> bool:
    """Tell whether 1 is a combination of polynomials, by Buchberger's algorithm."""
    work = [0]
    basis: list[Dense] = []
    for row in sorted(rows, key=len):
        rest = _reduced(row, basis, work)
        if rest:
            if _is_constant(rest):
                return True
            basis.append(_monic(rest))
    pairs = {(i, k): _lcm_degree(basis, i, k) for i, k in combinations(range(len(basis)), 2)}
    while pairs:
        i, k = min(pairs, key=pairs.__getitem__)
        del pairs[i, k]
        first, second = max(basis[i], key=_rank), max(basis[k], key=_rank)
        if not any(a and b for a, b in zip(first, second, strict=True)):
            continue  # no variable in common: it reduces to zero
        rest = _reduced(_difference(basis[i], basis[k], first, second), basis, work)
        if not rest:
            continue
        if _is_constant(rest):
            return True
        basis.append(_monic(rest))
        last = len(basis) - 1
        pairs |= {(n, last): _lcm_degree(basis, n, last) for n in range(last)}
    return False


def _rank(powers: Powers) -> tuple[int, Powers]:
    """Return the place of a monomial in the graded reverse lexicographic order."""
    return sum(powers), tuple(-p for p in reversed(powers))


def _is_constant(polynomial: Dense) -> bool:
    return len(polynomial) == 1 and not any(next(iter(polynomial)))


def _monic(polynomial: Dense) -> Dense:
    lead = polynomial[max(polynomial, key=_rank)]
    return {p: c / lead for p, c in polynomial.items()}


def _lcm_degree(basis: list[Dense], i: int, k: int) -> int:
    first, second = max(basis[i], key=_rank), max(basis[k], key=_rank)
    return sum(max(a, b) for a, b in zip(first, second, strict=True))


def _difference(first: Dense, second: Dense, lead: Powers, other_lead: Powers) -> Dense:
    common = tuple(max(a, b) for a, b in zip(lead, other_lead, strict=True))
    total: Dense = {}
    for polynomial, own, sign in ((first, lead, 1), (second, other_lead, -1)):
        shift = tuple(a - b for a, b in zip(common, own, strict=True))
        _add(total, polynomial, shift, Fraction(sign))
    return total


def _add(total: Dense, polynomial: Dense, shift: Powers, factor: Fraction) -> None:
    for powers, coefficient in polynomial.items():
        key = tuple(a + b for a, b in zip(powers, shift, strict=True))
        value = total.get(key, Fraction(0)) + factor * coefficient
        if value:
            total[key] = value
        else:
            total.pop(key, None)


def _reduced(polynomial: Dense, basis: list[Dense], work: list[int]) -> Dense:
    """Return what is left of a polynomial once every leading term of the basis is taken out."""
    rest, result = dict(polynomial), dict[Powers, Fraction]()
    leads = [max(own, key=_rank) for own in basis]
    while rest:
        lead = max(rest, key=_rank)
        by = next(
            (n for n, own in enumerate(leads) if all(a <= b for a, b in zip(own, lead, strict=True))),
            None,
        )
        if by is None:
            result[lead] = rest.pop(lead)
            continue
        work[0] += 1
        if work[0] > MOST_STEPS or rest[lead].numerator.bit_length() > LARGEST_BITS:
            raise TooLargeError("an elimination of too many steps")
        shift = tuple(b - a for a, b in zip(leads[by], lead, strict=True))
        _add(rest, basis[by], shift, -rest[lead])
    return result
