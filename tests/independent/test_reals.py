"""Numbers that carry their own precision: against fractions, and against mpmath with more digits."""

import copy
import math
import pickle
from fractions import Fraction

import numpy as np
import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st
from mpmath import mp
from mpmath.ctx_mp import MPContext

from symbalance.errors import SymbalanceError
from symbalance.text import numbers, reals
from symbalance.text.reals import Complex, Real, bits_of, nstr

judge = MPContext()
judge.dps = 120

fractions = st.fractions(min_value=-(10**6), max_value=10**6, max_denominator=10**9)
digits = st.integers(5, 60)


def value_of(number: Real) -> Fraction:
    """Return what a number is, exactly, from its mantissa and exponent."""
    sign, mantissa, exponent, _ = number._mpf_
    return (-1) ** sign * Fraction(int(mantissa)) * Fraction(2) ** exponent


def is_nearest(number: Real, exact: Fraction) -> bool:
    """Tell whether no number of as many bits is nearer: at most half of its last place away."""
    if exact == 0:
        return value_of(number) == 0
    place = Fraction(2) ** (math.floor(math.log2(abs(exact))) - number.bits + 1)
    return abs(value_of(number) - exact) <= place  # of log2's own rounding, a whole place


@pytest.mark.slow
@given(fractions, digits)
def test_a_fraction_is_rounded_once(x, n):
    number = Real(x, n)
    assert number.bits == bits_of(n)
    assert is_nearest(number, x)
    assert (number == x) is (value_of(number) == x)


@pytest.mark.slow
@given(fractions, fractions, digits, digits)
def test_the_more_precise_number_says_how_many_digits_there_are(x, y, m, n):
    a, b = Real(x, m), Real(y, n)
    u, v = value_of(a), value_of(b)
    for result, exact in ((a + b, u + v), (a - b, u - v), (a * b, u * v)):
        assert result.bits == max(a.bits, b.bits)
        assert is_nearest(result, exact)
    if v:
        assert is_nearest(a / b, u / v)
        assert (a / b).bits == max(a.bits, b.bits)


@pytest.mark.slow
@given(fractions, fractions, digits)
def test_fractions_are_exact_operands(x, y, n):
    a = Real(x, n)
    u = value_of(a)
    results = [(a + y, u + y), (y + a, u + y), (a - y, u - y), (y - a, y - u), (a * y, u * y)]
    results += [(a / y, u / y)] if y else []
    results += [(y / a, y / u)] if u else []
    for result, exact in results:
        assert result.bits == a.bits
        assert is_nearest(result, exact)
    assert (a < y, a <= y, a == y, a >= y, a > y) == (u < y, u <= y, u == y, u >= y, u > y)
    assert is_nearest(a - x, u - x)  # what its decimals leave out, to all digits


@given(fractions, st.integers(-6, 6), digits)
def test_whole_powers(x, power, n):
    a = Real(x, n)
    if a or power >= 0:
        result, exact = a**power, value_of(a) ** power
        assert abs(value_of(result) - exact) <= abs(exact) * Fraction(4, 2**a.bits)


@pytest.mark.slow
@given(
    st.fractions(min_value=Fraction(-99, 100), max_value=Fraction(99, 100), max_denominator=10**6), digits
)
def test_functions_against_more_digits(x, n):
    argument = Real(x, n)
    theirs = judge.mpf(argument)
    pairs = [
        (reals.sin(argument), judge.sin(theirs)),
        (reals.cos(argument), judge.cos(theirs)),
        (reals.tan(argument), judge.tan(theirs)),
        (reals.asin(argument), judge.asin(theirs)),
        (reals.exp(argument), judge.exp(theirs)),
        (reals.sqrt(1 - argument), judge.sqrt(judge.mpf(1 - argument))),
        (reals.log(1 + argument), judge.log(judge.mpf(1 + argument))),
        (reals.atan2(argument, Real(-1)), judge.atan2(theirs, -1)),
        (reals.hypot(argument, Real(2, n)), judge.hypot(theirs, 2)),
        (reals.cospi(x, n), judge.cospi(judge.mpf(x.numerator) / x.denominator)),
        (reals.sinpi(x, n), judge.sinpi(judge.mpf(x.numerator) / x.denominator)),
        (reals.expj(argument).imag, judge.sin(theirs)),
    ]
    for ours, true in pairs:
        assert abs(judge.mpf(ours) - true) <= abs(true) * judge.mpf(10) ** (1 - n) + judge.mpf(10) ** -110


@pytest.mark.parametrize("n", [20, 40, 90])
def test_larger_functions_against_more_digits(n):
    z = Real(Fraction(1, 7), n)
    theirs = judge.mpf(z)
    half = judge.mpf(0.5)
    pairs = [
        (reals.hyp2f1(-0.5, 2.5, 4, z), judge.hyp2f1(-half, 5 * half, 4, theirs)),
        (reals.ellipe(z), judge.ellipe(theirs)),
        (reals.pi(n), +judge.pi),
    ]
    for ours, true in pairs:
        assert ours.bits == bits_of(n)
        assert abs(judge.mpf(ours) / true - 1) < judge.mpf(10) ** (1 - n)
    rows = [[Real(1, n), Real(2, n)], [Real(3, n), Real(5, n)]]
    x, y = reals.solve(rows, [z, 2 * z])
    assert abs(x + z) < Fraction(1, 10 ** (n - 2))
    assert abs(y - z) < Fraction(1, 10 ** (n - 2))


@pytest.mark.slow
@given(st.lists(st.tuples(fractions, digits), min_size=1, max_size=8))
def test_a_sum_is_rounded_once(terms):
    values = [Real(x, n) for x, n in terms]
    total = reals.fsum(values)
    assert total.bits == max(x.bits for x in values)
    assert is_nearest(total, sum(map(value_of, values), Fraction(0)))


@pytest.mark.slow
@given(fractions, fractions, fractions, fractions, digits)
def test_complex_arithmetic(a, b, c, d, n):
    z, w = Complex(Real(a, n), Real(b, n)), Complex(c, d, n)
    p, q = judge.mpc(z), judge.mpc(w)
    results = [(z + w, p + q), (z - w, p - q), (z * w, p * q), (z * 3, p * 3), (2 - z, 2 - p)]
    results += [(z / w, p / q)] if w else []
    results += [(z * Fraction(1, 3), p / 3), (z.conjugate(), judge.conj(p)), (z**3, p**3)]
    for ours, true in results:
        size = abs(p) * abs(q) + abs(p) + abs(q) + abs(p) ** 3 + abs(true) + 2
        assert abs(judge.mpc(ours) - true) <= size * judge.mpf(10) ** (1 - n)
        assert ours.bits == bits_of(n)
    assert abs(judge.mpf(abs(z)) - abs(p)) <= abs(p) * judge.mpf(10) ** (1 - n)


@given(st.floats(allow_nan=False, allow_infinity=False, width=64), st.integers(-(10**20), 10**20))
def test_floats_and_ints_go_in_and_out(x, k):
    assert float(Real(x)) == x
    assert Real(x) == x
    assert hash(Real(x)) == hash(x)
    assert hash(Real(k)) == hash(k)
    assert int(Real(k)) == k
    y = Real(x, 60)
    if abs(x) < 1e15:
        assert (math.floor(y), math.ceil(y), round(y), int(y)) == (
            math.floor(x), math.ceil(x), round(x), int(x)
        )  # fmt: skip


def test_a_negative_number_has_no_real_root():
    for wrong in (lambda: reals.sqrt(Real(-1)), lambda: Real(-2) ** 0.5, lambda: reals.log(Real(-1))):
        with pytest.raises(ValueError, match="negative"):
            wrong()
    with pytest.raises(TypeError):
        Real(["one"])


def test_a_rounded_number_is_no_size():
    with pytest.raises(SymbalanceError, match="rounded to 40 digits"):
        numbers.exact(Real(1) / 3, "share")


def test_numbers_do_not_change_and_survive_copies():
    x, z = Real(1, 30) / 3, Complex(1, 2, 30) / 3
    for number, name in ((x, "bits"), (x, "_mpf_"), (z, "bits"), (z, "_mpc_")):
        with pytest.raises(AttributeError):
            setattr(number, name, 0)
    for number in (x, z):
        for again in (pickle.loads(pickle.dumps(number)), copy.copy(number), copy.deepcopy(number)):
            assert (again, again.bits, repr(again)) == (number, number.bits, repr(number))


@pytest.mark.parametrize("dps", [3, 15, 70])
def test_the_callers_precision_has_no_say(dps):
    before = mp.dps
    try:
        mp.dps = dps
        x, z = Real(1) / 3, Complex(1, 2) / 3
        shown = [repr(v) for v in (x, z, reals.sin(x), reals.hyp2f1(0.5, 0.5, 2, x), reals.pi(50), x * z)]
        assert mp.dps == dps
    finally:
        mp.dps = before
    x, z = Real(1) / 3, Complex(1, 2) / 3
    assert shown == [
        repr(v) for v in (x, z, reals.sin(x), reals.hyp2f1(0.5, 0.5, 2, x), reals.pi(50), x * z)
    ]


def test_other_libraries_take_them_for_their_own():
    x, z = Real(1) / 3, Complex(1, 2) / 3
    with mp.workdps(50):
        assert abs(mp.mpf(x) - mp.mpf(1) / 3) < mp.mpf(10) ** -40
        assert mp.nstr(x, 12) == nstr(x, 12) == "0.333333333333"
        assert mp.mpc(z) == z
        assert type(mp.mpf(1) + x) is mp.mpf
        assert abs(mp.mpf(2) * z - Complex(2, 4) / 3) < 1e-39
        assert abs(mp.sin(x) - reals.sin(x)) < 1e-39
    assert sympy.Float(x, 20) == sympy.Rational(1, 3).n(20)
    assert abs(sympy.sympify(x) - sympy.Rational(1, 3)) < 1e-39
    assert (2 * sympy.Symbol("a") * x).free_symbols == {sympy.Symbol("a")}
    assert np.array([x, 2 * x], dtype=float).tolist() == [1 / 3, 2 / 3]
    assert np.float64(2) * x == x * 2
    assert x * np.int64(3) == x * 3
    assert complex(z) == complex(1 / 3, 2 / 3)
