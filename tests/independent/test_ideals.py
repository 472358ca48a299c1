"""Polynomial equations taken together, against SymPy's Gröbner bases: which cannot hold, what follows."""

import random
from fractions import Fraction

import pytest
import sympy as sp

from symbalance.notes.algebra.domain import Domain, Polynomial
from symbalance.notes.algebra.ideals import cannot_hold, follows

LETTERS = sp.symbols("x y z")
AWAY = sp.Symbol("away")


def drawn(chance: random.Random) -> sp.Expr:
    x, y, z = LETTERS
    terms = [x, y, z, x * y, y * z, x**2, y**2, x * z]
    return sum(chance.randint(-2, 2) * t for t in chance.sample(terms, 3)) + chance.randint(-2, 2)


def polynomial(domain: Domain, expression: sp.Expr) -> Polynomial:
    result: Polynomial = {}
    for powers, coefficient in sp.Poly(expression, *LETTERS).terms():
        pairs = zip(LETTERS, powers, strict=True)
        monomial = tuple(sorted((domain.symbol(str(letter)), p) for letter, p in pairs if p))
        result[monomial] = Fraction(int(coefficient))
    return {monomial: c for monomial, c in result.items() if c}


def has_no_solution(equations: list[sp.Expr], *gens: sp.Symbol) -> bool:
    rest = [e for e in equations if e != 0]
    return bool(rest) and sp.groebner(rest, *gens, order="grevlex").exprs == [1]


@pytest.mark.slow
def test_systems_without_solutions_are_those_of_a_groebner_basis_of_one():
    chance, seen = random.Random(20), set()
    for _ in range(60):
        equations = [drawn(chance) for _ in range(chance.choice([2, 3, 4, 5]))]
        domain = Domain()
        own = cannot_hold(domain, [polynomial(domain, e) for e in equations])
        assert own == has_no_solution(equations, *LETTERS), equations
        seen.add(own)
    assert seen == {True, False}


@pytest.mark.slow
def test_what_follows_is_what_vanishes_wherever_the_equations_do():
    chance, seen = random.Random(21), set()
    for k in range(50):
        equations = [drawn(chance) for _ in range(2)]
        x, y, z = LETTERS
        claim = sp.expand(equations[0] * (x + 1) - equations[1] * (y - z)) if k % 2 else drawn(chance)
        domain = Domain()
        rows = [polynomial(domain, e) for e in equations]
        own = follows(domain, rows, polynomial(domain, claim))
        assert own == has_no_solution([*equations, claim * AWAY - 1], *LETTERS, AWAY), (equations, claim)
        seen.add(own)
    assert seen == {True, False}


@pytest.mark.parametrize("step", [1, 6, 540])
def test_powers_of_one_power_are_eliminated_as_it_is(step: int):
    """A phase of half a degree has exponents of hundreds; it takes no longer than its first power."""
    x, y, z = LETTERS
    domain = Domain()
    pairs = [(x**2 + x * y - 3, y - 2), (x**2 * y - z, x - 1)]
    for first, second in pairs:
        system = [first, second, x**2 * z - 5]
        rows = [polynomial(domain, e.subs(x, x**step)) for e in system]
        assert cannot_hold(domain, rows) == has_no_solution(system, *LETTERS)
    system = [x * y - 1, y * z - 1]
    rows = [polynomial(domain, e.subs(x, x**step)) for e in system]
    own = [follows(domain, rows, polynomial(domain, (x - s * z).subs(x, x**step))) for s in (1, -1)]
    assert own == [has_no_solution([*system, (x - s * z) * AWAY - 1], *LETTERS, AWAY) for s in (1, -1)]
    assert own == [True, False]


def test_exponents_without_a_common_factor_stay():
    x, y, z = LETTERS
    domain = Domain()
    for system in ([x**2 - 1, x**3 - 1], [x**2 - 1, x**3 - 2], [x**2 * y - 1, x**3 * y**2 - 1, z - 1]):
        own = cannot_hold(domain, [polynomial(domain, e) for e in system])
        assert own == has_no_solution(system, *LETTERS), system
