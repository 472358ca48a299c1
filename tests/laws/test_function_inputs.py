"""Laws of every generated function for inputs that are no ordinary angles.

Angles that are not finite, signed zeros and subnormal numbers, arrays of other shapes, layouts and types,
keywords 0 and huge, `out=`. Warnings are errors throughout. Each law is broken once on purpose, by a
wrapped function or by a changed source, to show that it can be.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from functools import lru_cache
from typing import Any

import numpy as np
import pytest

from symbalance.codegen import to_function
from symbalance.codegen.targets import IN_MEMORY
from symbalance.engine.catalogue import load
from symbalance.forces.free_forces import balance

Function = Callable[..., Any]
OUTPUTS = ("force.vertical", "force.lateral", "couple.vertical", "piston.displacement", "piston.velocity")
OUTPUT = "couple.vertical"
"""The one output that the fast tests take: it has several harmonics and a phase."""
ARRAYS_ONLY = "array-api"
"""The target that takes float64 and float32 arrays of a library, and has no `out`."""
NOT_FINITE = (np.inf, -np.inf, np.nan)
HUGE = 1e200
"""A keyword whose product with two others overflows, while one alone does not."""
RUN = range(100, 140)
"""Where a run of neighbouring angles is not finite: longer than any vector register."""
KINDS = (np.float64, np.float32)


def crank_angles(count: int) -> np.ndarray:
    """Return angles of both signs, half spread evenly to 1e6 rad, half over all sizes from 1e-3."""
    draw = np.random.default_rng(21)
    even = draw.uniform(-1e6, 1e6, count // 2)
    sizes = 10.0 ** draw.uniform(-3, 6, count - count // 2) * draw.choice([-1.0, 1.0], count - count // 2)
    return np.concatenate([even, sizes])


FEW, MANY = crank_angles(2000), crank_angles(20_000)


@lru_cache
def function_of(output: str, target: str) -> Any:
    """Return a function on a target, compiled where that is done at the first call."""
    function = to_function(balance(load("v6-90"), order=12), 3.5, output, target)
    for kind in KINDS:
        function(np.zeros(2, kind))
    return function


def with_lost_angles(theta: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return angles some of which are not finite, and where: alone, in a run, and at both ends."""
    is_lost = np.zeros(theta.size, bool)
    is_lost[[0, -1, *range(5, theta.size, 997)]] = True
    is_lost[RUN] = True
    marked = theta.copy()
    marked[is_lost] = np.resize(np.array(NOT_FINITE, theta.dtype), int(is_lost.sum()))
    return marked, is_lost


def assert_same(values: Any, expected: Any) -> None:
    """Compare shape, type and every bit; a NaN is the same as a NaN."""
    values, expected = np.asarray(values), np.asarray(expected)
    assert values.dtype == expected.dtype
    np.testing.assert_array_equal(values, expected, strict=True)


# The laws: each takes a function and angles, and asserts. -------------------------------------------


def nan_stands_where_the_angle_is_not_finite(function: Function, theta: np.ndarray) -> None:
    marked, is_lost = with_lost_angles(theta)
    values = np.asarray(function(marked))
    assert values.dtype == theta.dtype
    assert np.array_equal(np.isnan(values), is_lost)


def values_beside_a_nan_keep_every_bit(function: Function, theta: np.ndarray) -> None:
    marked, is_lost = with_lost_angles(theta)
    assert_same(np.asarray(function(marked))[~is_lost], np.asarray(function(theta))[~is_lost])


def tiny_angles_give_the_value_at_0(function: Function, theta: np.ndarray) -> None:
    """±0, ±the smallest subnormal, ±the smallest normal number, within 4 ulp of 1 or of the value."""
    limits = np.finfo(theta.dtype)
    tiny, small = limits.smallest_subnormal, limits.smallest_normal
    values = np.asarray(function(np.array([0.0, -0.0, tiny, -tiny, small, -small], theta.dtype)))
    values = values.astype(np.float64)
    assert np.all(np.abs(values - values[0]) <= 4 * float(limits.eps) * max(abs(values[0]), 1.0))


def nothing_finite_gives_nan_alone(function: Function, theta: np.ndarray) -> None:
    for angles in (NOT_FINITE, *((angle,) for angle in NOT_FINITE)):
        assert np.all(np.isnan(np.asarray(function(np.array(angles, theta.dtype)))))


def empty_arrays_keep_shape_and_type(function: Function, theta: np.ndarray) -> None:
    for shape in ((0,), (3, 0), (0, 2)):
        values = np.asarray(function(np.empty(shape, theta.dtype)))
        assert (values.shape, values.dtype) == (shape, theta.dtype)


def views_give_what_copies_give(function: Function, theta: np.ndarray) -> None:
    square = theta[:360].reshape(12, 30)
    views = [theta[:360:3], theta[359::-1], np.asfortranarray(square), square.T, square[2:9, 1::4]]
    views += [theta[5], square[:, :1], np.broadcast_to(theta[:7], (5, 7)), theta[:8].reshape(2, 2, 2)]
    views += [np.array(theta[9]), np.frombuffer(theta[:360].tobytes(), theta.dtype)]
    for view in views:
        copy = np.array(view, theta.dtype, order="C")
        expected = np.asarray(function(copy.reshape(-1))).reshape(copy.shape)
        assert_same(function(np.asarray(view)), expected)


def angles_stay_as_they_are(function: Function, theta: np.ndarray) -> None:
    before = theta.copy()
    function(theta)
    assert_same(theta, before)


def keywords_0_give_zeros(function: Function, theta: np.ndarray) -> None:
    for zero in (0, 0.0, -0.0):
        assert not np.any(np.asarray(function(theta, mass=0.0, radius=zero)))


def an_overflowing_product_gives_no_number(function: Function, theta: np.ndarray) -> None:
    """Infinity or NaN; a displacement, whose product is one keyword alone, stays finite and right."""
    plain = np.asarray(function(theta)).astype(np.float64)
    huge = np.asarray(function(theta, mass=HUGE, radius=HUGE, omega=HUGE, pitch=HUGE))
    is_right = np.abs(huge - plain * HUGE) <= 1e-15 * HUGE
    assert np.all(~np.isfinite(huge) | is_right | (plain == 0))


def what_is_no_real_number_is_refused(function: Function, theta: np.ndarray) -> None:
    for angles in (np.array([1j]), np.array(["1.0"]), np.array([None])):
        with pytest.raises(TypeError):
            function(angles)


def integers_lists_and_numbers_are_angles(function: Function, theta: np.ndarray) -> None:
    whole = np.arange(-3, 9)
    pairs = [
        (whole, whole.astype(np.float64)),
        (np.arange(7, dtype=np.uint8), np.arange(7.0)),
        (np.array([True, False]), np.array([1.0, 0.0])),
        ([0.5, 1.5], np.array([0.5, 1.5])),
        ([[1, 2], [3, 4]], np.array([[1.0, 2.0], [3.0, 4.0]])),
    ]
    for angles, doubles in pairs:
        assert_same(function(angles), function(doubles))
    (alone,) = function(np.array([0.7]))
    assert all(float(function(x)) == float(alone) for x in (0.7, np.float64(0.7), np.array(0.7)))


def out_takes_the_values(function: Function, theta: np.ndarray) -> None:
    """`out` is filled and returned, may be theta itself, and is refused where it does not fit."""
    for kind in KINDS:
        out = np.full(theta.shape, 7.0, kind)
        assert function(theta.astype(kind), out=out) is out
        assert_same(out, function(theta.astype(kind)))
    for out in (np.empty(3), np.empty(theta.shape, np.float32), np.empty(2 * theta.size)[::2]):
        with pytest.raises(ValueError, match="out"):
            function(theta, out=out)
    same, expected = theta.copy(), function(theta)
    assert_same(function(same, out=same), expected)


OF_BOTH_KINDS = (
    nan_stands_where_the_angle_is_not_finite,
    values_beside_a_nan_keep_every_bit,
    tiny_angles_give_the_value_at_0,
    nothing_finite_gives_nan_alone,
    empty_arrays_keep_shape_and_type,
)
OF_DOUBLES = (
    views_give_what_copies_give,
    angles_stay_as_they_are,
    keywords_0_give_zeros,
    an_overflowing_product_gives_no_number,
    what_is_no_real_number_is_refused,
)
NOT_OF_ARRAY_LIBRARIES = (integers_lists_and_numbers_are_angles, out_takes_the_values)


def laws_of(target: str) -> list[tuple[Callable[..., None], Any]]:
    """Return the laws a target keeps to, each with a type of angles."""
    doubles = OF_DOUBLES if target == ARRAYS_ONLY else (*OF_DOUBLES, *NOT_OF_ARRAY_LIBRARIES)
    return [(law, kind) for law in OF_BOTH_KINDS for kind in KINDS] + [
        (law, np.float64) for law in doubles
    ]


def _name(value: Any) -> str | None:
    return getattr(value, "__name__", None)


EVERY_LAW = [
    pytest.param(target, law, kind, marks=[pytest.mark.slow] if target == "numba" else [])
    for target in IN_MEMORY
    for law, kind in laws_of(target)
]


@pytest.mark.parametrize(("target", "law", "kind"), EVERY_LAW, ids=_name)
def test_law(target, law, kind):
    law(function_of(OUTPUT, target), FEW.astype(kind))


@pytest.mark.slow
@pytest.mark.parametrize("output", OUTPUTS)
@pytest.mark.parametrize("target", IN_MEMORY)
def test_every_law_of_every_output(target, output):
    function = function_of(output, target)
    for law, kind in laws_of(target):
        law(function, MANY.astype(kind))


def test_a_product_that_overflows_is_no_number_of_any_output():
    for output in OUTPUTS:
        an_overflowing_product_gives_no_number(function_of(output, "numpy"), FEW)


@pytest.mark.parametrize("kind", KINDS, ids=_name)
@pytest.mark.parametrize("target", ["numpy", pytest.param("numba", marks=pytest.mark.slow)])
def test_one_lost_angle_among_nine_thousand(target, kind):
    function = function_of(OUTPUT, target)
    theta = np.linspace(-50, 50, 9000).astype(kind)
    plain = np.asarray(function(theta))
    for place in (0, 4500, 8999):
        for lost in NOT_FINITE:
            marked = theta.copy()
            marked[place] = lost
            values = np.asarray(function(marked))
            assert np.isnan(values[place])
            assert np.array_equal(np.delete(values, place), np.delete(plain, place))


# Laws that can be broken -----------------------------------------------------------------------------

FAULTS = [
    (nan_stands_where_the_angle_is_not_finite, np.float64, lambda v, t: np.where(np.isfinite(t), v, 0.0)),
    (nan_stands_where_the_angle_is_not_finite, np.float32, lambda v, t: v.astype(np.float64)),
    (
        values_beside_a_nan_keep_every_bit,
        np.float64,
        lambda v, t: v * (1 + 2.0**-52 * np.isnan(t).any()),
    ),
    (tiny_angles_give_the_value_at_0, np.float64, lambda v, t: np.where(t == 0, v, np.nan)),
    (nothing_finite_gives_nan_alone, np.float64, lambda v, t: np.nan_to_num(v)),
    (empty_arrays_keep_shape_and_type, np.float64, lambda v, t: v.reshape(-1)),
    (views_give_what_copies_give, np.float64, lambda v, t: v.T),
    (angles_stay_as_they_are, np.float64, lambda v, t: np.negative(t, out=t)),
    (keywords_0_give_zeros, np.float64, lambda v, t: v + 1.0),
    (an_overflowing_product_gives_no_number, np.float64, lambda v, t: np.nan_to_num(v)),
    (integers_lists_and_numbers_are_angles, np.float64, lambda v, t: v + 1e-9 * (t.ndim == 0)),
    (out_takes_the_values, np.float64, lambda v, t: v.copy()),
]


@pytest.mark.parametrize(("law", "kind", "fault"), FAULTS, ids=_name)
def test_a_faulty_function_breaks_the_law(law, kind, fault):
    function = function_of(OUTPUT, "numpy")

    def faulty(theta, **keywords):
        theta = np.asarray(theta)
        with np.errstate(all="ignore"):
            return fault(np.asarray(function(theta, **keywords)), theta)

    law(function, FEW.astype(kind))
    with pytest.raises((AssertionError, ValueError)):
        law(faulty, FEW.astype(kind))


def test_what_accepts_complex_angles_breaks_the_law():
    with pytest.raises(pytest.fail.Exception):
        what_is_no_real_number_is_refused(lambda theta: theta, FEW)


def test_a_source_that_drops_nan_breaks_the_laws():
    function = function_of(OUTPUT, "numpy")
    changed = function.source.replace("np.where(far, b, a)", "np.nan_to_num(np.where(far, b, a))")
    assert changed != function.source
    faulty = dataclasses.replace(function, source=changed)
    assert_same(faulty(FEW), function(FEW))
    for law in (nan_stands_where_the_angle_is_not_finite, nothing_finite_gives_nan_alone):
        with pytest.raises(AssertionError):
            law(faulty, FEW)


def test_a_source_that_warns_breaks_a_law():
    function = function_of(OUTPUT, "numpy")
    changed = function.source.replace('np.errstate(invalid="ignore", over="ignore")', "np.errstate()")
    assert changed != function.source
    with pytest.raises(RuntimeWarning):
        nothing_finite_gives_nan_alone(dataclasses.replace(function, source=changed), FEW)
