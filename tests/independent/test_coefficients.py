"""The harmonics as doubles, against sums of the kinematics and against the closed form, in ulp."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise
from math import acosh, copysign, cosh, log, ulp

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp

from symbalance.errors import SymbalanceError
from symbalance.kinematics.slider_crank import floats
from symbalance.kinematics.slider_crank.closed_forms import acceleration_value
from symbalance.kinematics.slider_crank.floats import acceleration_floats
from tests import kinematics

WORST = 0.51
STEP = 2.0**-1074
NORMAL = 2.0**-1022
RHOS = (1e-8, 1e-3, 0.1, 0.25, 0.3, 0.5, 0.7, 0.8, 0.83, 0.9, 0.99, 1 - 1e-4, 1 - 1e-6, 1 - 1e-9)
EXTREMES = (
    1 + 2**-52,
    Fraction(10**18 + 1, 10**18),
    Fraction(10**40 + 1, 10**40),
    1e30,
    Fraction(10**40, 7),
)


def off(found: float, true: mp.mpf) -> float:
    """Return by how many ulp of the true value a double is off; ulp is one step where subnormal."""
    with mp.workdps(60):
        return float(abs(mp.mpf(found) - true) / ulp(float(true)))


def switch(order: int) -> float:
    """Return the ratio near which the recurrence is turned round for an order."""
    return cosh(60 / (8 + order // 6) * log(2) / 4)


def true(order: int, ratio: Fraction | float) -> mp.mpf:
    """Return A_order from its closed form, to 40 digits."""
    return acceleration_value(order, Fraction(ratio), 40)


@pytest.mark.spread(2)
@pytest.mark.parametrize("rho", [0.1, 0.25, 0.5, 0.8, 0.83, 0.9, 0.97])
def test_against_sums_of_the_kinematics(rho: float) -> None:
    """A second derivative in closed form and the trapezoidal rule: nothing of 2F1 or its recurrence."""
    ratio = 1 / rho
    found = acceleration_floats(24, ratio)
    with mp.workdps(90):
        lam = kinematics.number(Fraction(ratio))
        points = kinematics.points_for(Fraction(ratio), 24, 60)
        summed = kinematics.harmonics(lambda p: kinematics.acceleration(p, lam), list(found), points)
    assert max(off(value, summed[n][0].real) for n, value in found.items()) < WORST


@pytest.mark.parametrize("ratio", [*(1 / rho for rho in RHOS), *EXTREMES])
def test_against_the_closed_form(ratio: Fraction | float) -> None:
    found = acceleration_floats(40, ratio)
    normal = [n for n in (2, 4, 6, 12, 20, 30, 40) if abs(found[n]) >= NORMAL]
    assert normal
    assert max(off(found[n], true(n, ratio)) for n in normal) < WORST


@pytest.mark.parametrize("order", [2, 12, 40, 200, 1000])
@pytest.mark.parametrize("beside", [1 - 1e-6, 1 + 1e-6, 1.05])
def test_either_way_to_the_highest_orders(order: int, beside: float) -> None:
    """On both sides of the ratio where the recurrence is turned round."""
    ratio = switch(order) * beside
    found = acceleration_floats(order, ratio)
    assert max(off(found[n], true(n, ratio)) for n in {2, order // 4 * 2 or 2, order}) < WORST


@pytest.mark.spread(8)
@pytest.mark.parametrize("order", [2, 6, 40, 1000])
@pytest.mark.parametrize("rho", [*RHOS, 0.6, 0.75, 0.86, 0.95, 0.999, 1 - 1e-13])
def test_what_is_rounded(monkeypatch: pytest.MonkeyPatch, order: int, rho: float) -> None:
    """Before the one rounding to a double a value is good to 2^-60, as the docstrings prove."""
    monkeypatch.setattr(floats, "ldexp", lambda whole, power: whole * Fraction(2) ** power)
    found = acceleration_floats(order, 1 / rho)
    for n in {2, order // 4 * 2 or 2, order}:
        with mp.workdps(40):
            assert abs(kinematics.number(found[n]) / true(n, 1 / rho) - 1) < mp.mpf(2) ** -60


@pytest.mark.parametrize("power", [20, 60, 1000])
def test_rod_as_long_as_the_crank(power: int) -> None:
    """The root becomes |cos theta|, A_n = 4 (-1)^(n/2+1) n^2/(pi (n^2 - 1)), up to k'^2 log k'."""
    found = acceleration_floats(1000, Fraction(10 ** (2 * power) + 1, 10 ** (2 * power)))
    with mp.workdps(60):
        limit = {n: -((-1) ** (n // 2)) * 4 * n * n / (mp.pi * (n * n - 1)) for n in range(2, 1001, 2)}
    assert max(off(found[n], limit[n]) for n in limit) < WORST


@pytest.mark.parametrize("ratio", [1e30, 2.0**400, Fraction(10**250, 3), 10**60])
def test_long_rods(ratio: Fraction | float) -> None:
    """A_2 = rho and A_4 = -rho^3/4 up to rho^2, correctly rounded."""
    found, rho = acceleration_floats(4, ratio), 1 / Fraction(ratio)
    assert (found[2], found[4]) == (float(rho), float(-(rho**3) / 4))


def test_beyond_every_double() -> None:
    """Underflow to zeros of the right sign, from numbers that no float holds."""
    found = acceleration_floats(8, Fraction(10**5000 + 1, 7))
    assert [str(found[n]) for n in (2, 4, 6, 8)] == ["0.0", "-0.0", "0.0", "-0.0"]


@pytest.mark.parametrize("ratio", [1e8, 3e7, 1e20, 1e155, 1e300, Fraction(10**320, 3)])
def test_subnormal_values(ratio: Fraction | float) -> None:
    found = acceleration_floats(60, ratio)
    small = [n for n in found if abs(found[n]) < NORMAL]
    assert small
    with mp.workdps(60):
        assert max(abs(found[n] - true(n, ratio)) for n in small) <= STEP


def test_a_value_in_the_midst_of_the_subnormals() -> None:
    found = acceleration_floats(40, 1e8)[40]
    assert 0 < abs(found) < NORMAL
    assert off(found, true(40, 1e8)) <= 1


def test_orders_and_signs() -> None:
    assert acceleration_floats(1, 4) == {1: 1.0}
    assert list(acceleration_floats(7, 1.01)) == list(acceleration_floats(6, 4)) == [1, 2, 4, 6]
    for ratio in (1.0001, 1.5, 4.0, 1e100):
        found = acceleration_floats(100, ratio)
        assert all(copysign(1, found[2 * k]) == (-1) ** (k + 1) for k in range(1, 51))
        assert all(type(value) is float for value in found.values())


@pytest.mark.parametrize("ratio", [1.2, 3.5, 1.0001])
def test_an_order_does_not_depend_on_the_highest(ratio: float) -> None:
    """Correct rounding leaves all but ties alike, whichever way and from wherever it was found."""
    long = acceleration_floats(1000, ratio)
    for order in (2, 8, 40, 300):
        short = acceleration_floats(order, ratio)
        assert all(abs(short[n] - long[n]) <= ulp(long[n]) for n in short)
        assert sum(short[n] != long[n] for n in short) <= 1


@pytest.mark.parametrize("order", [8, 40])
def test_longer_rods_shake_less(order: int) -> None:
    """All terms of an A_n have one sign: its size falls as lambda grows."""
    ratios = sorted([1 + 2.0**-j for j in range(2, 30)] + [1 + j / 16 for j in range(5, 80)])
    rows = [acceleration_floats(order, ratio) for ratio in ratios]
    for n in range(2, order + 1, 2):
        sizes = [abs(row[n]) for row in rows]
        assert all(more > less for more, less in pairwise(sizes)), n


def test_a_float_is_the_double_it_is() -> None:
    """Not what it prints as: near rho = 1 the seventeenth digit is seen."""
    ratio = 1 + 3 * 2**-50
    found = acceleration_floats(1000, ratio)
    assert found == acceleration_floats(1000, Fraction(ratio))
    assert found != acceleration_floats(1000, Fraction(str(ratio)[:-1]))
    assert acceleration_floats(40, 4.2) != acceleration_floats(40, Fraction("4.2"))
    assert (
        acceleration_floats(20, 4.0) == acceleration_floats(20, 4) == acceleration_floats(20, Fraction(4))
    )


def test_large_numerators_change_nothing() -> None:
    """4 and 4 + 10^-3000 round alike; so do 1.001 and a hair above."""
    for ratio in (Fraction(4), Fraction(1001, 1000)):
        assert acceleration_floats(40, ratio + Fraction(1, 10**3000)) == acceleration_floats(40, ratio)


@pytest.mark.parametrize("ratio", [1, -4.0, True, Fraction(1, 2)])
def test_a_rod_no_longer_than_the_crank_is_refused(ratio: Fraction) -> None:
    with pytest.raises(SymbalanceError, match="the rod must be longer than the crank"):
        acceleration_floats(4, ratio)


@pytest.mark.parametrize("ratio", [float("nan"), float("inf"), "4", None])
def test_a_ratio_that_is_no_number_is_refused_as_such(ratio: float) -> None:
    """Text "4" was said to be a rod shorter than the crank."""
    with pytest.raises(SymbalanceError, match=r"ratio = .*: must be a finite number"):
        acceleration_floats(4, ratio)


@pytest.mark.parametrize("order", [0, 1001, -2, 2.5])
def test_refused_orders(order: int) -> None:
    with pytest.raises(SymbalanceError, match="order = "):
        acceleration_floats(order, 4)


BARELY = st.builds(lambda n, j: 1 + Fraction(n, 2**62) / 10**j, st.integers(1, 2**62), st.integers(0, 25))
PLAIN = st.floats(1, 1e30, exclude_min=True)
ORDINARY = st.floats(1, 6, exclude_min=True)


@pytest.mark.slow
@settings(max_examples=120, deadline=None)
@given(st.one_of(BARELY, PLAIN, ORDINARY), st.integers(1, 40), st.integers(0, 460))
def test_any_ratio_any_order(ratio: Fraction | float, k: int, further: int) -> None:
    """Within 0.51 ulp, or a step where subnormal, whatever the highest order is."""
    found = acceleration_floats(2 * (k + further), ratio)[2 * k]
    assert off(found, true(2 * k, ratio)) <= (WORST if abs(found) >= NORMAL else 1)


@pytest.mark.slow
@given(ORDINARY)
def test_acceleration_at_dead_centres(ratio: float) -> None:
    """At theta = 0 the series sums to 1 + rho: a sum no coefficient was made from."""
    if acosh(ratio) < 0.1:
        ratio += 0.1
    values = acceleration_floats(1000, ratio).values()
    with mp.workdps(30):
        assert abs(mp.fsum(values) - 1 - 1 / mp.mpf(ratio)) < 3e-15
