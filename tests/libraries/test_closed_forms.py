"""Evidence: closed forms are spelled and printed as SymPy, an independent algebra, has the same numbers.

Programs read our strings with SymPy and compare them with its own; so each must be SymPy's to the letter.
"""

from __future__ import annotations

from fractions import Fraction

import pytest
import sympy
from hypothesis import assume, given, settings
from mpmath import mp

from symbalance.document.expressions import formula_of
from symbalance.exact.phasor import Phasor
from symbalance.exact.radicals import ClosedForm, exact_form, multiple_of_pi, square_root_form
from symbalance.exact.radicals.closed_forms import square_root, wave
from symbalance.kinematics.slider_crank import acceleration_series
from symbalance.kinematics.slider_crank.series import Series
from tests.laws.test_laws import phasors, reals

ANGLES = [
    Fraction(k, n) for n in (1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 15, 16, 45) for k in range(n + 1)
]


def check(form: ClosedForm) -> None:
    """Hold the text and the formula to those of SymPy's own expression."""
    expression = form.expression()
    assert form.spelling == str(expression)
    assert form.as_formula() == formula_of(expression)
    assert form.is_zero() == (expression == 0)


@pytest.mark.slow
@settings(max_examples=200)
@given(reals())
def test_real_numbers_are_spelled_as_sympy_spells_them(number: Phasor) -> None:
    check(exact_form(number))


@pytest.mark.slow
@given(phasors())
def test_amplitudes_are_spelled_as_sympy_spells_them(number: Phasor) -> None:
    assume(not number.is_zero())
    check(square_root_form(number.times(number.conjugate())))


@pytest.mark.parametrize("text", ["25/2 - 11*sqrt(5)/2", "-1 + sqrt(5)", "sqrt(2)/2 + sqrt(6)/2", "-7/3"])
def test_a_form_is_what_sympy_reads(text: str) -> None:
    expression = sympy.sympify(text)
    total = ClosedForm.rational(0)
    for term in sympy.Add.make_args(expression):
        factor, root = term.as_coeff_Mul()
        square = ClosedForm.rational(Fraction(str(root**2)))
        total += square_root(square).scaled(Fraction(str(factor)))
    assert total.spelling == text
    assert total.expression() == expression
    check(total)


@pytest.mark.parametrize("function", ["cos", "sin"])
def test_waves_are_short_where_sympys_are(function: str) -> None:
    for angle in ANGLES:
        ours = wave(function, angle)
        check(ours)
        with mp.workdps(40):
            expected = {"cos": mp.cospi, "sin": mp.sinpi}[function](
                mp.mpf(angle.numerator) / angle.denominator
            )
            assert abs(mp.mpmathify(sympy.N(ours.expression(), 35)) - expected) < mp.mpf(10) ** -30
        if angle.denominator in (1, 2, 3, 4, 5, 6, 8, 10, 12):
            theirs = getattr(sympy, function)(
                sympy.pi * sympy.Rational(angle.numerator, angle.denominator)
            )
            assert ours.expression() == theirs


@pytest.mark.parametrize(
    "value", [Fraction(1, 3), Fraction(12), Fraction(8, 27), Fraction(10**9 + 7, 4), Fraction(49)]
)
def test_roots_of_rationals_are_sympys(value: Fraction) -> None:
    ours = square_root(ClosedForm.rational(value))
    assert ours.expression() == sympy.sqrt(sympy.Rational(value.numerator, value.denominator))
    check(ours)


@pytest.mark.parametrize("factor", [0, 1, -1, Fraction(1, 2), Fraction(-2, 3), Fraction(7, 9)])
def test_multiples_of_pi_are_sympys(factor: Fraction) -> None:
    ours = multiple_of_pi(Fraction(factor))
    assert ours.expression() == sympy.pi * sympy.Rational(str(factor))
    check(ours)


def test_small_differences_of_large_numbers_keep_their_order() -> None:
    """Doubles lose the root of 2 - sqrt(4 - 1e-40) altogether."""
    inner = square_root(ClosedForm.rational(4 - Fraction(1, 10**40)))
    tiny = square_root(ClosedForm.rational(2) + inner.scaled(-1))
    assert 0 < tiny.value() < Fraction(1, 10**19)
    assert (tiny + ClosedForm.rational(Fraction(1, 10**21))).spelling.startswith(
        "1/1000000000000000000000 + "
    )


@pytest.mark.parametrize("order", [1, 2, 4, 6, 12, 30])
def test_series_are_spelled_as_sympy_spells_them(order: int) -> None:
    for through in (order, order + 3, order + 8):
        series = acceleration_series(order, through)
        assert series.spelling == str(series.in_lam())


@pytest.mark.parametrize(
    "terms",
    [{}, {0: 1, 2: -1}, {1: 1, 3: -1}, {5: 1}, {0: Fraction(-3, 2), 1: 2}, {2: -1, 4: Fraction(-7, 3)}],
)
def test_any_series_is_spelled_as_sympy_spells_it(terms: dict[int, int | Fraction]) -> None:
    series = Series({power: Fraction(c) for power, c in terms.items()}, 9)
    assert series.spelling == str(series.in_lam())
