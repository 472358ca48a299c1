"""Laws of amplitudes of every kind: exact, with symbols for angles, and in decimals, alone and mixed."""

import pickle
from fractions import Fraction

import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from symbalance.errors import SymbalanceError
from symbalance.exact.amplitude import Amplitude
from symbalance.exact.angles import angle
from symbalance.exact.decimal_phasor import DecimalPhasor
from symbalance.exact.phasor import ONE, ZERO, Phasor
from symbalance.exact.spectrum import Spectrum
from symbalance.exact.symbolic_phasor import SymbolicPhasor
from symbalance.text.reals import Complex, Real, expjpi, nstr

CLOSE = Fraction(1, 10**35)
BANK = angle(sympy.Symbol("beta", real=True), "bank").symbols

turns = st.fractions(min_value=-2, max_value=2, max_denominator=24)
weights = st.fractions(min_value=-9, max_value=9, max_denominator=12)


@st.composite
def phasors(draw):
    total = ZERO
    for _ in range(draw(st.integers(0, 4))):
        total = total + Phasor.root(draw(turns)).scaled(draw(weights))
    return total


@st.composite
def amplitudes(draw):
    """Return an amplitude without symbols of any kind, so that decimals can judge it."""
    exact = draw(phasors())
    return draw(st.sampled_from([exact, SymbolicPhasor.holding(exact), DecimalPhasor(exact.evaluated())]))


def value(number: Amplitude) -> Complex:
    return number.evaluated(40)


def near(one: Complex, other: Complex) -> bool:
    return abs(one - other) <= CLOSE * (1 + abs(one) + abs(other))


@pytest.mark.slow
@given(amplitudes(), amplitudes())
def test_sums_and_products_of_any_two_kinds(one, other):
    assert near(value(one + other), value(one) + value(other))
    assert near(value(one - other), value(one) - value(other))
    assert near(value(one.times(other)), value(one) * value(other))
    assert type(one + other) is type(max(one, other, key=lambda number: number.rank))
    assert (one - one).is_zero()


@pytest.mark.slow
@given(amplitudes(), turns, weights)
def test_what_each_kind_does_alone(number, turn, weight):
    own, kind = value(number), type(number)
    pairs = [
        (-number, -own),
        (number.scaled(weight), own * weight),
        (number.turned(turn), own * expjpi(2 * turn)),
        (number.conjugate(), own.conjugate()),
        (number.real(), Complex(own.real)),
        (number.imaginary(), Complex(own.imag)),
        (number.norm(), Complex(abs(own) ** 2)),
    ]
    for result, expected in pairs:
        assert type(result) is kind
        assert near(value(result), expected)
    assert abs(number.size() - abs(own)) <= CLOSE * (1 + abs(own))
    assert number.most >= float(abs(own)) * (1 - 1e-12)
    assert number.is_zero() is not bool(own)


@pytest.mark.slow
@given(phasors())
def test_symbols_are_kept_and_have_no_decimals(number):
    moved = number.times(SymbolicPhasor.of({BANK: ONE}))
    assert moved.is_zero() == number.is_zero()
    back = moved.times(SymbolicPhasor.of({BANK: ONE}).conjugate())
    assert (back - number).is_zero()
    if not number.is_zero():
        for refused in (moved.evaluated, lambda: moved + DecimalPhasor(Complex(1))):
            with pytest.raises(SymbalanceError, match="symbols"):
                refused()


@pytest.mark.slow
@given(phasors().filter(lambda p: not p.is_zero()), st.integers(0, 5))
def test_what_a_file_holds_of_a_weight_cancels_it(number, count):
    """Files hold 30 digits: a weight that is read again ends what it was designed for, and 20 do not."""
    weight = value(number)
    parts = [number.scaled(Fraction(1, count + 1))] * (count + 1)

    def read_again(digits: int) -> DecimalPhasor:
        return DecimalPhasor(Complex(*(Real(nstr(x, digits)) for x in (weight.real, weight.imag))))

    assert sum(parts, -read_again(30)).is_zero()
    if 0 not in (weight.real, weight.imag) and read_again(20).value != weight:
        rest = abs(read_again(20).value - weight)
        assert sum(parts, -read_again(20)).is_zero() == (rest <= Fraction(2, 10**25) * abs(weight))


def test_orders_written_alike_share_their_components():
    number, other = Phasor.root(Fraction(1, 5)), Phasor.root(Fraction(2, 5))
    spectrum = Spectrum({1: number, -1: other, 6: number, -6: other, 2: other})
    for one in (spectrum, pickle.loads(pickle.dumps(spectrum))):
        assert one.component(1, "vertical") is one.component(6, "vertical")
        assert one.component(1, "vertical") is not one.component(2, "vertical")
        assert one.component(1, "vertical") is not one.component(1, "lateral")
