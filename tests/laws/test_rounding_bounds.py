"""Emitted harmonic sums of many shapes against their exact values, and what is said of their rounding.

A rounding bound is compared with what it bounds: every operation of the scheme is disturbed by itself,
and the effects are added up in size.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from fractions import Fraction
from itertools import count

import numpy as np
import pytest
from mpmath import mp
from numpy.polynomial import chebyshev

import symbalance as sb
from symbalance.codegen import plan_for, rounding
from symbalance.codegen.harmonic_sum import FORCE, HarmonicSum, HarmonicTerm
from symbalance.codegen.plans import choose_plan
from symbalance.codegen.polynomials import decompositions, powers
from symbalance.codegen.reinsch import ARGUMENT_ERROR, reinsch_rounding
from symbalance.codegen.requests import fewest_within, visible_terms
from symbalance.codegen.targets import files
from symbalance.text.reals import Real
from tests import kinematics

U = 2.0**-53
PSI = np.linspace(0.05, np.pi - 0.05, 41)


def terms(*rows: tuple[object, float, float]) -> tuple[HarmonicTerm, ...]:
    return tuple(HarmonicTerm(Fraction(n), Real(c), Real(s)) for n, c, s in rows)


SUMS = {
    "one cosine": terms((1, 0.7, 0)),
    "one phase": terms((3, 0.3, -0.9)),
    "first and even": terms((1, 1, 0.4), (2, 0.25, -0.1), (4, -0.01, 0.02), (6, 1e-4, 0)),
    "all in phase": terms((1, 1, 0), (2, 0.3, 0), (3, 0.2, 0), (5, -0.1, 0)),
    "half orders": terms(("1/2", 0.3, 1), (1, -1, 0.5), ("3/2", 0, 2), ("9/2", 0.2, 0.1)),
    "far apart": terms((2, 1, 0.2), (17, 0.1, -0.3)),
    "many": terms(*((n, 1 / n, (-1) ** n / n**2) for n in range(1, 25))),
    "beyond powers": terms(*((n, 0.5 / n, 0) for n in range(1, 50))),
    "steep": terms(*((2 * n, (-1) ** n, 0.0) for n in range(1, 16))),
    "multiples": terms((6, 10.0, 2.0), (12, -1e-3, 1e-3), (18, 1e-6, 0)),
    "sines": terms((1, 0, 1), (2, 0, 0.4), (3, 0, -0.3)),
}
ANGLES = np.concatenate(
    [[0.0, 1e-9, np.pi / 2, np.pi, -2.5], np.linspace(-7, 7, 13), [1e3, -98765.4321, 1e6]]
)


def namespace(sums: list[HarmonicSum], target: str) -> dict:
    (source,) = files(choose_plan(sums, Fraction(4), target), target, "wave", "wave").values()
    module: dict = {"__name__": "wave"}
    exec(source, module)
    return module


def exact(rows: tuple[HarmonicTerm, ...], theta: float, mean: float = 0.0) -> mp.mpf:
    """Return the sum, by mpmath alone."""
    angle = mp.mpf(theta)
    return mean + mp.fsum(
        mp.mpf(float(t.cos)) * mp.cos(angle * t.order.numerator / t.order.denominator)
        + mp.mpf(float(t.sin)) * mp.sin(angle * t.order.numerator / t.order.denominator)
        for t in rows
    )


@pytest.mark.spread("first and even", "half orders", "sines")
@pytest.mark.parametrize("name", SUMS)
@pytest.mark.parametrize("target", ["numpy", "array-api"])
def test_an_emitted_sum_errs_by_no_more_than_it_says(name, target):
    wave = HarmonicSum("force.vertical", FORCE, "a wave", SUMS[name], 60)
    plan = choose_plan([wave], Fraction(4), target)
    (output,), module = plan.outputs, namespace([wave], target)
    module["self_test"]() if target == "numpy" else module["self_test"](np)
    course = np.linspace(0, 4 * np.pi, 6001)
    orders = [(float(t.order), float(t.cos), float(t.sin)) for t in SUMS[name]]
    size = np.abs(sum(c * np.cos(n * course) + s * np.sin(n * course) for n, c, s in orders)).max()
    assert output.amplitude == pytest.approx(size, rel=2e-3)
    with mp.workdps(40):
        truth = [exact(SUMS[name], x) for x in ANGLES]
        values = module["evaluate"](ANGLES)
        worst = max(abs(mp.mpf(float(v)) - t) for v, t in zip(values, truth, strict=True))
        assert worst <= output.rounding * U * output.amplitude
        far = np.array([3e7 / 7, -1e9, 1e12 / 3])
        slack = 4 + plan.highest_step
        for theta, value in zip(far, module["evaluate"](far), strict=True):
            error = abs(mp.mpf(float(value)) - exact(SUMS[name], theta))
            assert error <= output.rounding * U * output.amplitude * slack
        single = ANGLES.astype(np.float32)
        rough = module["evaluate"](single)
        assert rough.dtype == np.float32
        for theta, value in zip(single, rough, strict=True):
            error = abs(mp.mpf(float(value)) - exact(SUMS[name], float(theta)))
            assert error <= (output.rounding + 2) * 2.0**-24 * output.amplitude
        turns = 2
        grid = module["on_grid"](7, turns) if target == "numpy" else module["on_grid"](7, turns, xp=np)
        for j, value in enumerate(grid):
            error = abs(mp.mpf(float(value)) - exact(SUMS[name], 2 * mp.pi * j / 7))
            assert error <= 2 * output.rounding * U * output.amplitude
    assert output.rounding < 60  # what is said is of use


def test_a_mean_stands_beside_the_waves_or_alone():
    with_mean = HarmonicSum("force.vertical", FORCE, "a wave", SUMS["first and even"], 6, mean=Real(2.5))
    alone = HarmonicSum("force.lateral", FORCE, "a mean", mean=Real(-0.75))
    nothing = HarmonicSum("force.forward", FORCE, "nothing")
    plan = choose_plan([with_mean, alone, nothing], Fraction(4), "numpy")
    values = namespace([with_mean, alone, nothing], "numpy")["evaluate"](ANGLES, mass=2.0, omega=3.0)
    with mp.workdps(40):
        truth = np.array([float(18 * exact(SUMS["first and even"], x, 2.5)) for x in ANGLES])
    assert values["force.vertical"] == pytest.approx(truth, rel=0, abs=18 * 4 * 12 * U)
    assert (values["force.lateral"] == -0.75 * 18).all()
    assert not values["force.forward"].any()
    first, second, third = plan.outputs
    assert (second.amplitude, third.amplitude, third.rounding) == (0.75, 0.0, 0.0)
    bare = choose_plan([HarmonicSum("f", FORCE, "", SUMS["first and even"], 6)], Fraction(4), "numpy")
    # rounded as a constant and in the sum: one and a half times the whole, beside what the waves round
    waves, whole = bare.outputs[0], first.amplitude
    own = (waves.rounding - 1) * waves.amplitude
    assert (first.rounding - 1) * whole == pytest.approx(own + 1.5 * whole)


@pytest.mark.parametrize("name", SUMS)
def test_every_way_to_cut_a_sum_into_families_is_the_sum(name):
    for families in decompositions(SUMS[name]):
        for theta in (0.0, 0.8, -2.1, 5.0):
            total = 0.0
            for one in families:
                x = float(one.step) * theta - 2 * np.pi * float(one.phase)
                total += sum(float(a) * np.cos(k * x) for k, a in enumerate(one.even))
                total += sum(float(a) * np.sin(k * x) for k, a in enumerate(one.odd))
            assert total == pytest.approx(float(exact(SUMS[name], theta)), abs=1e-12)


# The bounds, against disturbed arithmetic

ROWS = [[0.0, 1.0], [0.0, 0.4, 0.0, -0.2], [0.0, 1.0, 0.5, -0.3, 0.0, 0.2], [0.0, 0.0, 0.0, 0.7]]


class Disturbed:
    """Arithmetic in which the k-th rounding errs by `size` of its result."""

    def __init__(self, place: int, size: float) -> None:
        self.place, self.size, self.count = place, size, count()

    def __call__(self, value: np.ndarray) -> np.ndarray:
        return value * (1 + self.size) if next(self.count) == self.place else value


def effects(scheme: Callable[[Disturbed], np.ndarray]) -> np.ndarray:
    """Return the sum of what each rounding changes, over its size, as the first order has it."""
    plain, total = scheme(Disturbed(-1, 0.0)), 0.0
    everything = Disturbed(-1, 0.0)
    scheme(everything)
    for place in range(next(everything.count)):
        total = total + np.abs(scheme(Disturbed(place, 1e-6)) - plain) / 1e-6
    return np.asarray(total)


@pytest.mark.parametrize("coefficients", [*ROWS, [0.3, 0.0, 2.0, -1.0]])
def test_horners_rounding_is_that_of_its_operations(coefficients):
    c = np.cos(PSI)

    def horner(rounded: Disturbed) -> np.ndarray:
        value = np.zeros_like(c)
        for a in reversed(coefficients):
            value = rounded(value * c)
            if a:
                value = rounded(value + rounded(np.full_like(c, a)))
        return value

    assert rounding.horner_rounding(coefficients, PSI) == pytest.approx(
        effects(horner), rel=1e-5, abs=1e-9
    )


@pytest.mark.parametrize("row", ROWS)
@pytest.mark.parametrize("kind", ["T", "U"])
def test_clenshaws_rounding_is_that_of_its_operations(row, kind):
    c = np.cos(PSI)

    def clenshaw(rounded: Disturbed) -> np.ndarray:
        above, here = np.zeros_like(c), np.zeros_like(c)
        for a in row[:0:-1]:
            product = rounded(2 * c * here)
            value = rounded(rounded(np.full_like(c, a)) + product)
            above, here = here, rounded(value - above)
        return here if kind == "U" else rounded(rounded(c * here) - above)

    by_hand = effects(clenshaw)
    assert rounding.clenshaw_rounding(row, PSI, kind) == pytest.approx(by_hand, rel=1e-5, abs=1e-9)


@pytest.mark.parametrize("row", ROWS)
@pytest.mark.parametrize("kind", ["T", "U"])
def test_reinschs_rounding_covers_its_operations_and_is_not_far_above(row, kind):
    """d_k = s^k a_k + d_{k+1} - m b_{k+1}, b_k = b_{k+1} + d_k; then d_1 - m b_1/2, or sin times b_1."""
    trough = np.pi / 2 < PSI
    near, sign = np.where(trough, np.pi - PSI, PSI), np.where(trough, -1.0, 1.0)
    exact_m = 4 * np.sin(near / 2) ** 2

    def reinsch(rounded: Disturbed, m: np.ndarray = exact_m) -> np.ndarray:
        top = len(row) - 1
        d = b = rounded(np.full_like(PSI, row[top])) * sign**top
        for k in range(top - 1, 0, -1):
            first = rounded(rounded(np.full_like(PSI, row[k])) * sign**k + d) if row[k] else d
            d = rounded(first - rounded(m * b))
            b = rounded(b + d)
        # the last sum, or product, is counted with the output's own
        return sign * np.sin(near) * b if kind == "U" else d - rounded(m * b) / 2

    plain = sum(a * (np.cos if kind == "T" else np.sin)(k * PSI) for k, a in enumerate(row))
    whole = reinsch(Disturbed(-1, 0.0))
    assert whole == pytest.approx(plain, abs=1e-12)
    by_hand = effects(reinsch)
    if kind == "T":  # what the argument's own error does
        shifted = reinsch(Disturbed(-1, 0.0), exact_m * (1 + 1e-6))
        by_hand = by_hand + ARGUMENT_ERROR * np.abs(shifted - whole) / 1e-6
    bound = reinsch_rounding(row, PSI, kind)
    assert (bound >= by_hand * (1 - 1e-4)).all()
    assert (bound <= (2.5 if kind == "T" else 20) * by_hand + 6).all()


@pytest.mark.parametrize("row", ROWS)
def test_derivatives_in_the_cosine_are_those_of_the_polynomials(row):
    c, ends = np.cos(PSI), np.array([0.0, np.pi])
    slope = chebyshev.chebval(c, chebyshev.chebder(row))
    assert rounding.derivative(row, PSI) == pytest.approx(np.abs(slope), abs=1e-12)
    assert rounding.derivative(row, ends) == pytest.approx(
        np.abs(chebyshev.chebval(np.cos(ends), chebyshev.chebder(row)))
    )
    # sum a_k U_{k-1} is the derivative of sum a_k/k T_k
    primitive = [0.0, *(a / k for k, a in enumerate(row) if k)]
    inner = chebyshev.chebder(primitive)
    factors = rounding.sine_factors(row, PSI)
    assert factors[0] == pytest.approx(np.abs(chebyshev.chebval(c, inner)), abs=1e-12)
    change = np.sin(PSI) * chebyshev.chebval(c, chebyshev.chebder(inner))
    assert factors[1] == pytest.approx(np.abs(change), abs=1e-11)
    assert rounding.sine_factors(row, ends)[1] == pytest.approx([0, 0], abs=1e-6)
    for k in range(1, 7):
        u = chebyshev.chebval(np.cos(ends), chebyshev.chebder([0.0] * k + [1 / k]))
        assert rounding.chebyshev_u(k, ends) == pytest.approx(u)
        assert rounding.chebyshev_u(k, PSI) == pytest.approx(np.sin(k * PSI) / np.sin(PSI))


def test_the_grid_resolves_the_highest_harmonic():
    for highest in (1, 16, 17, 60):
        grid = rounding.resolving_angles(highest)
        assert (grid[0], grid[-1]) == (0.0, np.pi)
        steps = np.diff(grid)
        assert steps.max() == pytest.approx(steps.min())
        assert 16 * (1 - 1e-9) <= np.pi / (highest * steps.max()) <= 257


def test_the_cosines_own_error_is_that_of_a_sine_of_the_rest():
    """cos psi = sin x, x = pi/2 - psi twice rounded; of x + x^3(...) the end rounds, and the power."""
    x = np.pi / 2 - PSI
    expected = 2 * np.abs(x) * np.abs(np.sin(PSI)) + np.abs(np.cos(PSI)) / 2 + 1.5 * np.abs(x - np.sin(x))
    assert rounding.cosine_error(PSI) == pytest.approx(expected)


@pytest.mark.parametrize("kind", ["T", "U"])
@pytest.mark.parametrize("row", [[2.5], [0.0, 1.0], [0.5, -1.0, 2.0, 0.25, -3.0], [0.0, 0.0, 1.0]])
def test_powers_are_the_chebyshev_sum(row, kind):
    c = np.linspace(-1, 1, 9)
    if kind == "T":
        expected = chebyshev.chebval(c, row)
    else:
        expected = sum(
            a * np.sin(k * np.arccos(c[1:-1])) / np.sin(np.arccos(c[1:-1])) for k, a in enumerate(row)
        )
        c = c[1:-1]
    coefficients = [float(p) for p in powers(row, kind)]
    assert np.polyval(coefficients[::-1], c) == pytest.approx(expected, abs=1e-12)
    assert len(coefficients) == max(len(row) - (kind == "U" and len(row) > 1), 1)


# How many harmonics


def geometric(order: int) -> tuple[HarmonicTerm, ...]:
    return terms(*((n, 2.0**-n, 0) for n in range(1, order + 1)))


@pytest.mark.parametrize("tolerance", [0.3, 0.1, 1e-3, 1e-6])
def test_the_fewest_harmonics_whose_rest_is_within_the_tolerance(tolerance):
    kept, bound, none = fewest_within(geometric, lambda n: Real(2.0**-n), tolerance, 8)
    assert kept is not None
    assert not none
    # of sum 2^-n what is left after k terms is 2^-k in all
    fewest = next(k for k in range(200) if 2.0**-k <= tolerance)
    assert (len(kept), float(bound)) == (fewest, pytest.approx(2.0**-fewest))


def test_harmonics_nobody_can_see_and_none_at_all():
    kept, bound, _ = fewest_within(geometric, lambda n: Real(2.0**-n), 0.0, 8)
    assert kept is not None
    assert len(kept) == 58  # 2^-57 of the largest, 1/2
    assert float(bound) == 2.0**-58
    assert fewest_within(lambda n: (), lambda n: Real(0.25), 0.1, 8) == ((), Real(0.25), True)
    none, bound, empty = fewest_within(lambda n: (), lambda n: Real(2.0**-n), 0.01, 8, Real(1))
    assert (none, empty, float(bound) <= 0.01) == ((), True, True)
    out_of_reach = fewest_within(geometric, lambda n: Real(1), 0.5, 8)
    assert out_of_reach[0] is None
    shown = visible_terms(
        terms((1, 1, 0), (2, 0.5, 0), (3, 2.0**-56, 0), (4, 2.0**-58, 0), (5, 2.0**-59, 0))
    )
    assert [t.order for t in shown] == [1, 2, 3]
    assert visible_terms(()) == ()


# Closed forms

PISTONS = ("piston.displacement", "piston.velocity", "piston.acceleration")


@pytest.mark.spread(2)
@pytest.mark.parametrize("target", ["numpy", "array-api"])
@pytest.mark.parametrize("ratio", ["1.05", "1.3", "4"])
def test_all_orders_at_once_are_the_pistons_motion(target, ratio):
    function = sb.to_function(
        sb.balance(sb.load("inline-1"), ratio=ratio), outputs=(*PISTONS, "force.vertical"), tolerance=0,
        target=target,
    )  # fmt: skip
    values = function(ANGLES)
    lam = Fraction(ratio)
    # what a source tests itself with is no less exact
    result = sb.balance(sb.load("inline-1"), ratio=ratio)
    plan = plan_for(result, None, [*PISTONS, "force.vertical"], target, 0.0)
    values_of = {o.harmonic_sum.name: lambda theta, o=o: float(o.value(theta)) for o in plan.outputs}
    with mp.workdps(40):
        for name in (*PISTONS, "force.vertical"):
            part = name.split(".")[1] if name in PISTONS else "acceleration"
            motion = getattr(kinematics, part)
            truth = [motion(mp.mpf(float(x)), kinematics.number(lam)) for x in ANGLES]
            size = function.amplitude[name]
            worst = max(abs(mp.mpf(float(v)) - t) for v, t in zip(values[name], truth, strict=True))
            assert worst <= function.rounding[name] * U * size, name
            grid = [motion(2 * mp.pi * j / 500, kinematics.number(lam)) for j in range(0, 500, 4)]
            assert values_of[name](0.7) == pytest.approx(
                float(motion(mp.mpf(0.7), kinematics.number(lam))), rel=1e-14
            )
            assert size == pytest.approx(float(max(map(abs, grid))), rel=1e-2)


def test_a_shaft_faster_than_the_crank_is_in_no_cylinders_closed_form():
    """With weights at once and at twice the crank's speed: as they are alone, and as both."""
    four = sb.load("inline-4").with_ratio(4)
    slow = sb.BalanceShaft(1, [sb.engine.Weight(0, 20, share=1)])
    fast = sb.BalanceShaft(-2, [sb.engine.Weight(0, 70, share=3)])
    lam, a2 = Fraction(4), None
    with mp.workdps(30):
        a2 = kinematics.harmonics(lambda p: kinematics.acceleration(p, kinematics.number(lam)), [2], 256)[
            2
        ][0].real
        for shafts in ((slow,), (fast,), (slow, fast), (fast, slow)):
            engine = four.balanced_by(*shafts)
            value = sb.to_function(sb.balance(engine), tolerance=0)
            for theta in (0.3, 2.0, -4.0):
                angle = mp.mpf(theta)
                total = mp.fsum(
                    kinematics.acceleration(
                        angle + 2 * mp.pi * mp.mpf(c.throw.turns.numerator) / c.throw.turns.denominator,
                        kinematics.number(lam),
                    )
                    for c in four.cylinders
                )
                if slow in shafts:
                    total += mp.cos(angle + mp.radians(20))
                if fast in shafts:
                    total += 3 * a2 * mp.cos(-2 * angle + mp.radians(70))
                assert value(theta) == pytest.approx(float(total), abs=1e-13)


@pytest.mark.parametrize("ratio", ["1.1", "4"])
def test_a_closed_form_holds_the_first_order_once_and_all_others(ratio):
    """Of one cylinder and of a vee: its value is the motion itself, whether or not a plan takes it."""
    lam = kinematics.number(Fraction(ratio))
    with mp.workdps(30):
        plan = plan_for(sb.balance(sb.load("inline-1"), ratio=ratio), None, PISTONS, "numba", 0.0)
        for output in plan.outputs:
            form = output.harmonic_sum.closed_form
            assert form is not None
            motion = getattr(kinematics, output.harmonic_sum.name.split(".")[1])
            assert float(form.value(0.7)) == pytest.approx(float(motion(mp.mpf(0.7), lam)), rel=1e-14)
        vee = sb.load("v2-45")
        (output,) = plan_for(sb.balance(vee, ratio=ratio), None, "force.vertical", "numba", 0.0).outputs
        form = output.harmonic_sum.closed_form
        assert form is not None
        total = mp.mpf(0)
        for cylinder in vee.cylinders:
            bank, throw = (kinematics.radians(x.in_degrees()) for x in (cylinder.bank, cylinder.throw))
            total += mp.cos(bank) * kinematics.acceleration(mp.mpf(0.7) + throw - bank, lam)
        assert float(form.value(0.7)) == pytest.approx(float(total), rel=1e-13)


@pytest.mark.spread("far apart", "one cosine", "half orders")
@pytest.mark.parametrize("name", SUMS)
def test_the_float32_sine_holds_on_all_that_its_angles_reach(name: str) -> None:
    """To 0.01 u32 up to a quarter turn and what a multiple of e, below 2^-11 turns, adds to it."""
    wave = HarmonicSum("force.vertical", FORCE, "a wave", SUMS[name], 60)
    plan = choose_plan([wave], Fraction(4), "array-api")
    (source,) = files(plan, "array-api", "wave", "wave").values()
    coefficients = [mp.mpf(value) for _, value in re.findall(r"\bR(\d+) = ([-\de.]+)", source)]
    assert len(coefficients) == 5
    multiples = [1.0, *(float(s) for s in re.findall(r"(?<![\w.])([\d.]+)\*e\b", source))]
    with mp.workdps(30):
        reach = mp.pi / 2 + 2 * mp.pi * max(multiples) / 2**11
        places = mp.linspace(0, reach, 200)
        values = [x + sum(s * x ** (2 * j + 3) for j, s in enumerate(coefficients)) for x in places]
        assert max(abs(v - mp.sin(x)) for v, x in zip(values, places, strict=True)) < 0.01 / 2**24
