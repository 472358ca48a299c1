"""Evidence about the evidence: faults put into the algebra on purpose, and seen by its tests.

Each comparison is one of `test_algebra` or `test_algebra_series`; it holds without the fault, and raises
with it.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import pytest

from symbalance.exact.phasor import Phasor
from symbalance.notes.algebra import derivatives, functions, polynomials, zero
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.roots import unit
from symbalance.notes.algebra.series import Expansion, Series
from tests.formulas import POINT, forms, tree
from tests.independent.test_algebra import DisagreementError, assert_soundly_compared, assert_value
from tests.independent.test_algebra_series import LARGE, SMALL, RemainderError, assert_good, series_of

Patch = pytest.MonkeyPatch
Comparison = Callable[[], None]


def valued(text: str) -> Comparison:
    return lambda: assert_value(text, forms(text)[0], POINT)


def compared(left: str, right: str) -> Comparison:
    return lambda: assert_soundly_compared(tree(left), tree(right))


def expanded(text: str, letter: tuple[str, int], through: int) -> Comparison:
    return lambda: assert_good(text, letter, series_of(text, letter, through))


def flipped_sine(patch: Patch) -> None:
    patch.setitem(functions._CIRCULAR, "sin", lambda x: functions.sine(x).scaled(-1))


def half_angle_lost(patch: Patch) -> None:
    whole = functions._phase
    patch.setattr(functions, "_phase", lambda domain, m, c: whole(domain, m, Fraction(c.__ceil__())))


def gauss_sum_not_turned(patch: Patch) -> None:
    """√p of p = 3 mod 4 without the factor -i."""
    right, lost = zero.root_of_prime, Fraction(1, 4)
    patch.setattr(zero, "root_of_prime", lambda p: right(p).turned(lost) if p % 4 == 3 else right(p))


def gauss_sum_of_a_wrong_residue(patch: Patch) -> None:
    wrong = Phasor.of(5, {1: 1, 4: -1, 2: -1, 3: 1})
    right = zero.root_of_prime
    patch.setattr(zero, "root_of_prime", lambda p: wrong if p == 5 else right(p))


def wrong_binomial_coefficient(patch: Patch) -> None:
    right = Expansion._compose

    def composed(self: Expansion, coefficients: list[Fraction], inner: Series) -> Series:
        wrong = [c * Fraction(1001, 1000) if k == 3 else c for k, c in enumerate(coefficients)]
        return right(self, wrong, inner)

    patch.setattr(Expansion, "_compose", composed)


def products_claiming_the_limit(patch: Patch) -> None:
    right = Series.times

    def times(self: Series, other: Series, limit: int) -> Series:
        product = right(self, other, limit)
        return Series(product.domain, product.terms, limit)

    patch.setattr(Series, "times", times)


def no_chain_rule_in_angles(patch: Patch) -> None:
    right = derivatives._Differentiation._find_relative

    def relative(self: Any, number: int) -> Form:
        kind = self.domain.generators[number].kind
        return unit(self.domain) if kind == "exponential" else right(self, number)

    patch.setattr(derivatives._Differentiation, "_find_relative", relative)


def no_chain_rule_in_functions(patch: Patch) -> None:
    patch.setattr(
        derivatives._Differentiation,
        "_opaque",
        lambda self, function, argument: derivatives._SLOPES[function](argument),
    )


def squares_left_under_their_root(patch: Patch) -> None:
    patch.setattr(polynomials, "_without_squares", lambda domain, polynomial: polynomial)


FAULTS: list[tuple[Callable[[Patch], None], Comparison]] = [
    (flipped_sine, valued("sin(theta)**3 + cos(theta)")),
    (flipped_sine, compared("cos(theta - pi/2)", "sin(theta)")),
    (half_angle_lost, valued("cos(theta/2)")),
    (gauss_sum_not_turned, compared("sqrt(3)", "2*cos(pi/6)")),
    (gauss_sum_not_turned, compared("sqrt(7)", "2*(sin(2*pi/7) + sin(4*pi/7) + sin(8*pi/7))")),
    (gauss_sum_of_a_wrong_residue, compared("sqrt(5)", "4*cos(pi/5) - 1")),
    (wrong_binomial_coefficient, expanded("sqrt(lambda**2 - sin(theta)**2)", LARGE, 6)),
    (wrong_binomial_coefficient, expanded("sqrt(1 + rho)", SMALL, 4)),
    (products_claiming_the_limit, expanded("exp(rho)/(exp(rho) - 1 - rho)", SMALL, 3)),
    (products_claiming_the_limit, expanded("lambda**30/(lambda - a)", LARGE, 3)),
    (no_chain_rule_in_angles, valued("diff(sin(x**2), x, 1)")),
    (no_chain_rule_in_angles, valued("diff(cos(sqrt(1 + x**2)), x, 1)")),
    (no_chain_rule_in_functions, valued("diff(asin(sin(theta)/lambda), theta, 1)")),
    (squares_left_under_their_root, compared("sqrt(1 + a)*sqrt(1 + a)", "1 + a")),
]


@pytest.mark.parametrize("comparison", [comparison for _, comparison in FAULTS])
def test_without_a_fault_the_comparison_holds(comparison: Comparison) -> None:
    comparison()


@pytest.mark.parametrize(("fault", "comparison"), FAULTS)
def test_a_fault_is_seen(
    fault: Callable[[Patch], None], comparison: Comparison, monkeypatch: pytest.MonkeyPatch
) -> None:
    fault(monkeypatch)
    with pytest.raises((DisagreementError, RemainderError)):
        comparison()
