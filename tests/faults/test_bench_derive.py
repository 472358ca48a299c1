"""The bench of derivations: its alternatives give what symbalance gives, so their times compare."""

from __future__ import annotations

from fractions import Fraction

import pytest
import sympy

from symbalance.bench import derive
from symbalance.bench.derive_alternatives import (
    flint_harmonics,
    has_flint,
    is_zero_by_equals,
    is_zero_by_flint,
    is_zero_in_field,
    ring_expressions,
    ring_harmonics,
)
from symbalance.bench.timing import at_least, at_most
from symbalance.kinematics.slider_crank import acceleration_integers, harmonics

ORDER = 20
PROOFS = [is_zero_in_field, *([is_zero_by_flint] if has_flint() else [])]


def _in_integers(terms: list[dict[int, Fraction]]) -> list[list[Fraction]]:
    """Return the numerators over 16^m of A_2k, from the coefficients of z^j in each term of rho^(2m)."""
    half = len(terms) - 1
    return [[8 * k * k * terms[m][m + k] * 16**m for m in range(k, half + 1)] for k in range(1, half + 1)]


def _fraction(value: object) -> Fraction:
    return Fraction(str(value))


def test_ring_series_gives_the_same_harmonics():
    terms = [
        {powers[0]: _fraction(value) for powers, value in term.terms()} for term in ring_harmonics(ORDER)
    ]
    assert _in_integers(terms) == acceleration_integers(ORDER)
    terms[5][7] += Fraction(1, 2**20)
    assert _in_integers(terms) != acceleration_integers(ORDER)


def test_flint_gives_the_same_harmonics():
    if has_flint():
        terms = [
            {j: int(power[j]) * _fraction(value) for j in range(power.length())}
            for power, value in flint_harmonics(ORDER)
        ]
        assert _in_integers(terms) == acceleration_integers(ORDER)


def test_expressions_are_those_of_symbalance():
    rows = [series.in_lam() for n, series in harmonics("acceleration", ORDER).terms.items() if n > 1]
    for one, other in zip(ring_expressions(ORDER), rows, strict=True):
        lam = sympy.Rational(7, 2)
        assert one.subs(*one.free_symbols, lam) == other.subs(*other.free_symbols, lam)


@pytest.mark.parametrize("is_zero", PROOFS)
@pytest.mark.parametrize("count", derive.COUNTS)
def test_zeros_are_the_same(count, is_zero):
    nonzero = [n for n in derive.ALL_ORDERS if not is_zero(count, n)]
    assert nonzero == derive.surviving_orders(count, derive.ALL_ORDERS) != []


def test_equals_proves_a_zero_and_no_other():
    assert is_zero_by_equals(3, 1)
    assert not is_zero_by_equals(3, 3)


def test_targets_are_missed_on_their_own_side():
    assert at_least(20, "a", 1.0, "b", 21.0).is_met
    assert not at_least(20, "a", 1.0, "b", 19.0).is_met
    assert at_most(2, "a", 1.9, "b", 1.0).is_met
    assert not at_most(2, "a", 2.1, "b", 1.0).is_met
