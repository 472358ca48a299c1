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
