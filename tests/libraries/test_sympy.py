"""Evidence: the behaviour of SymPy and mpmath that the package leans on, pinned.

A new version that changes one of these breaks a table or a value silently; here it breaks a test.
"""

from __future__ import annotations

import mpmath
import pytest
import sympy
from mpmath import mp


def test_an_unevaluated_atan2_keeps_its_form_and_its_value() -> None:
    phase = sympy.atan2(-1, 3, evaluate=False)
    assert isinstance(phase, sympy.atan2)
    assert phase.args == (-1, 3)
    assert str(phase) == "atan2(-1, 3)"
    with mp.workdps(30):
        assert abs(mp.mpmathify(sympy.N(phase, 30)) - mp.atan2(-1, 3)) < mp.mpf(10) ** -28


def test_atan2_knows_its_quadrants_after_a_round_trip_through_text() -> None:
    for y, x in ((1, 2), (1, -2), (-1, -2), (-1, 2)):
        again = sympy.sympify(str(sympy.atan2(y, x, evaluate=False)))
        assert abs(float(again) - float(mp.atan2(y, x))) < 1e-14


def test_square_roots_of_rationals_are_canonical() -> None:
    assert sympy.sqrt(sympy.Rational(8, 9)) == 2 * sympy.sqrt(2) / 3
    assert sympy.sqrt(12) - 2 * sympy.sqrt(3) == 0
    assert sympy.sqrt(sympy.Rational(1, 2)) == sympy.sqrt(2) / 2
    assert sympy.sqrt(sympy.Rational(9, 4)) == sympy.Rational(3, 2)
    assert sympy.sqrt(10).is_Pow
    assert sympy.sqrt(10).exp == sympy.Rational(1, 2)


def test_nested_roots_are_left_nested() -> None:
    nested = sympy.sqrt(sympy.Rational(25, 2) - 11 * sympy.sqrt(5) / 2)
    assert str(nested) == "sqrt(25/2 - 11*sqrt(5)/2)"
    assert sympy.sympify(str(nested)) == nested


def test_terms_come_apart_as_the_radicals_need_them() -> None:
    rational, root = (2 + 3 * sympy.sqrt(5)).as_coeff_Add()
    assert (rational, root) == (2, 3 * sympy.sqrt(5))
    assert root.as_coeff_Mul() == (3, sympy.sqrt(5))
    assert sympy.sqrt(5).as_coeff_Add() == (0, sympy.sqrt(5))
    assert sympy.Integer(0).as_coeff_Mul()[1] == 1


@pytest.mark.slow
@pytest.mark.parametrize("m", [7, 9, 11, 13, 14, 28, 36, 17, 257])
def test_cosines_keep_their_value_however_they_are_folded(m: int) -> None:
    """SymPy moves arguments into (0, pi/2) at construction: another form, the same number."""
    with mp.workdps(40):
        for k in range(m):
            cosine = sympy.cos(2 * sympy.pi * sympy.Rational(k, m))
            sine = sympy.sin(2 * sympy.pi * sympy.Rational(k, m))
            rotated = mp.mpf(2 * k) / m
            assert abs(mp.mpmathify(sympy.N(cosine, 35)) - mp.cospi(rotated)) < mp.mpf(10) ** -33
            assert abs(mp.mpmathify(sympy.N(sine, 35)) - mp.sinpi(rotated)) < mp.mpf(10) ** -33


def test_cosines_of_sevenths_are_left_as_they_are() -> None:
    assert str(2 * sympy.cos(2 * sympy.pi / 7)) == "2*cos(2*pi/7)"
    assert (
        sympy.cos(2 * sympy.pi * sympy.Rational(5, 7))
        == sympy.cos(4 * sympy.pi / 7)
        == (-sympy.cos(3 * sympy.pi / 7))
    )


def test_sums_of_cosines_are_not_seen_to_be_zero() -> None:
    """The reason phasors exist; the day this fails SymPy has learnt it."""
    total = sum(sympy.cos(2 * sympy.pi * sympy.Rational(k, 7)) for k in range(7))
    assert total != 0
    assert abs(sympy.N(total, 30)) < 1e-25


def test_phases_are_rewritten_at_construction() -> None:
    """The reason (order, amplitude, phase) are data and not an expression."""
    theta = sympy.Symbol("theta", real=True)
    assert sympy.cos(6 * theta - sympy.pi / 6) == sympy.sin(6 * theta + sympy.pi / 3)


def test_numbers_with_symbols_or_pi_are_told_from_rationals() -> None:
    assert sympy.pi.is_irrational
    assert (sympy.pi / 3).is_irrational
    assert not sympy.Rational(360, 7).is_irrational
    assert (sympy.Symbol("alpha") / 2).free_symbols
    assert sympy.Integer(0).free_symbols == set()
    factor, rest = (3 * sympy.pi / 2).as_coeff_Mul(rational=True)
    assert (factor, rest) == (sympy.Rational(3, 2), sympy.pi)


def test_rationals_show_their_parts_as_plain_integers() -> None:
    value = sympy.Rational(-5, 3)
    assert isinstance(value.p, int)
    assert isinstance(value.q, int)
    assert (value.p, value.q) == (-5, 3)


STRINGS = [
    "9/(128*lam**5) + 45/(512*lam**7)",
    "6*sqrt(3)",
    "sqrt(25/2 - 11*sqrt(5)/2)",
    "2*cos(2*pi/7)",
    "2*sin(2*pi/7) + 2*sin(3*pi/7)",
    "atan2(-1, 3)",
    "-5*pi/6",
    "0",
]


@pytest.mark.parametrize("text", STRINGS)
def test_our_strings_read_back_as_written(text: str) -> None:
    lam = sympy.Symbol("lam", positive=True)
    value = sympy.sympify(text, locals={"lam": lam})
    assert value.free_symbols <= {lam}
    assert sympy.sympify(str(value), locals={"lam": lam}) == value


def test_precision_given_as_a_context_ends_with_it() -> None:
    before = mp.dps
    with mp.workdps(50):
        third = mp.mpf(1) / 3
    assert mp.dps == before
    assert abs(third * 3 - 1) < mp.mpf(10) ** -15
    with mp.workdps(50):
        assert abs(third * 3 - 1) < mp.mpf(10) ** -49  # a number keeps the digits it was made with


def test_hypergeometric_values_keep_their_digits_near_one() -> None:
    with mp.workdps(40):
        z = 1 - mp.mpf(10) ** -20
        value = mp.hyp2f1(mp.mpf(-1) / 2, mp.mpf(1) / 2, 2, z)
        assert abs(value - mp.mpf(8) / (3 * mp.pi)) < mp.mpf(10) ** -17


def test_mpmath_is_one_that_sympy_takes() -> None:
    major, minor = (int(part) for part in mpmath.__version__.split(".")[:2])
    assert (major, minor) < (1, 4)
    assert tuple(int(part) for part in sympy.__version__.split(".")[:2]) >= (1, 13)
