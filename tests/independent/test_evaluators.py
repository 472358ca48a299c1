"""Evaluators against the exact kinematics in mpmath: digits, bounds, the stated rules, and the arrays."""

from __future__ import annotations

import tracemalloc
from fractions import Fraction
from functools import cache

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from mpmath import mp

import symbalance as sb
from symbalance.codegen.evaluators import plan_for
from symbalance.codegen.harmonic_sum import FORCE, HarmonicSum, HarmonicTerm
from symbalance.codegen.plans import choose_plan
from symbalance.codegen.targets import files
from symbalance.engine.catalogue import preset_text
from tests import kinematics, placed
from tests.different_presets import different_presets

U = mp.ldexp(1, -53)
OUTPUTS = tuple(f"{kind}.{part}" for kind in ("force", "couple") for part in ("vertical", "lateral"))
RNG = np.random.default_rng(20261121)
ANGLES = np.concatenate(
    [
        RNG.uniform(-1e6, 1e6, 24),
        RNG.uniform(-7, 7, 16),
        np.pi / 12 * np.array([0, 1, 2, 3, 6, 9, 12, -24, 48 * 9973, 3 * 999983]),
        [1e6, -1e6, 1e-9, 0.01],
    ]
)


@cache
def planar(name: str, arms: bool):
    """Return theta -> vertical + i lateral of a preset, from its throws, banks and stations alone."""
    layout = sb.load(name)
    if not layout.has_common_harmonics:
        return lambda theta: placed.planar(layout, theta, arms)
    places = [
        kinematics.Place(c.throw.turns * 360, c.bank.turns * 360, c.station) for c in layout.cylinders
    ]
    return kinematics.planar(places, layout.ratio, arms)


@cache
def truth(name: str, kind: str) -> list:
    """Return the exact force or couple of a preset at `ANGLES`."""
    with mp.workdps(40):
        exact = planar(name, kind == "couple")
        return [exact(mp.mpf(float(theta))) for theta in ANGLES]


def worst(values, exact, amplitude: float) -> float:
    """Return the largest error in u of the amplitude."""
    with mp.workdps(40):
        return max(
            float(abs(mp.mpf(float(v)) - e) / (U * amplitude)) for v, e in zip(values, exact, strict=True)
        )


WITHOUT_WEIGHTS = [name for name in different_presets() if "[[counterweight]]" not in preset_text(name)]


@pytest.mark.slow
@pytest.mark.parametrize("name", WITHOUT_WEIGHTS)
def test_all_orders_of_every_preset_against_its_pistons(name):
    """Within 4 u of the amplitude to 10^6 rad, 5 with all orders there; 0 where every order cancels."""
    layout = sb.load(name)
    made = sb.to_function(sb.balance(layout), outputs=OUTPUTS, tolerance=0)
    most = 4 if layout.has_common_harmonics else 5
    for output, values in made(ANGLES).items():
        kind, part = output.split(".")
        exact = [z.real if part == "vertical" else z.imag for z in truth(name, kind)]
        if made.amplitude[output] == 0:
            assert not values.any()
            assert max(abs(e) for e in exact) < 1e-30
        else:
            assert worst(values, exact, made.amplitude[output]) <= min(most, made.rounding[output])


def test_an_amplitude_is_what_the_function_reaches():
    made = sb.to_function(sb.balance(sb.load("v6-90")), outputs=OUTPUTS, tolerance=0)
    grid = made.on_grid(3600)
    for output, amplitude in made.amplitude.items():
        assert np.abs(grid[output]).max() == pytest.approx(amplitude, rel=1e-3)


@pytest.mark.slow
@pytest.mark.parametrize("lam", ["1.0000001", "1.01", "3.5", "1e6"])
def test_displacement_keeps_its_own_digits_near_every_dead_centre(lam):
    made = sb.to_function(sb.balance(sb.load("inline-1"), ratio=lam), outputs="piston.displacement")
    tops = np.array([0, 1, -1, 7, 1000, 99991, 159154]) * 2 * np.pi
    near = np.concatenate([tops, np.nextafter(tops, 1e9), *(tops + s for s in (1e-12, -1e-5, 0.01, 1.5))])
    angles = np.concatenate([near, [5e-324, 1e-300, -1e-160, 1e-8, 3.0], ANGLES])
    with mp.workdps(700):
        ratio = mp.mpf(Fraction(lam).numerator) / Fraction(lam).denominator
        for theta, value in zip(angles, made(angles), strict=True):
            sine = mp.sin(mp.mpf(float(theta)))
            root = mp.sqrt(ratio**2 - sine**2)
            exact = 2 * mp.sin(mp.mpf(float(theta)) / 2) ** 2 + sine**2 / (ratio + root)
            assert abs(value - exact) <= 4 * np.spacing(float(exact)), theta


@pytest.mark.slow
@pytest.mark.parametrize(("lam", "order"), [("1.2", 12), ("1.05", 24), ("1.001", 100), ("1.00001", 240)])
@pytest.mark.parametrize("name", ["inline-1", "inline-4", "v2-90", "radial-5"])
def test_truncated_sums_near_rho_1_keep_their_stated_bound(name, lam, order):
    made = sb.to_function(sb.balance(sb.load(name), order, ratio=lam))
    result = sb.balance(sb.load(name), order, ratio=lam)
    with mp.workdps(40):
        rows = [(o.order, result.values[o.order], o.force.vertical.decimal(40)) for o in result.orders]
        exact = []
        for theta in map(mp.mpf, ANGLES[:40].tolist()):
            parts = ((n * theta, a, c, s) for n, a, (c, s) in rows)
            exact.append(mp.fsum(a * (c * mp.cos(x) + s * mp.sin(x)) for x, a, c, s in parts))
    assert (
        worst(made(ANGLES[:40]), exact, made.amplitude["force.vertical"])
        <= made.rounding["force.vertical"]
    )


@pytest.mark.slow
@pytest.mark.parametrize("tolerance", [1e-2, 1e-4, 1e-7, 1e-11])
@pytest.mark.parametrize(("name", "output"), [("inline-1", 0), ("inline-5", 2), ("v8-90-flat", 1)])
def test_a_tolerance_is_met_with_the_fewest_orders(name, output, tolerance):
    kind, part = OUTPUTS[output].split(".")
    made = sb.to_function(
        sb.balance(sb.load(name)), outputs=OUTPUTS[output], tolerance=tolerance, target="numba"
    )
    bound, orders = made.left_out[OUTPUTS[output]], made.orders[OUTPUTS[output]]
    assert bound is not None
    assert bound <= tolerance
    exact = [z.real if part == "vertical" else z.imag for z in truth(name, kind)]
    errors = [abs(float(v - e)) for v, e in zip(made(ANGLES), exact, strict=True)]
    assert max(errors) <= bound + made.rounding[OUTPUTS[output]] * 2.0**-53
    result = sb.balance(sb.load(name), int(orders[-1]))
    last = result.orders[-1]
    size = float(getattr(getattr(last, kind), part).amplitude) * abs(float(result.values[last.order]))
    assert bound + size > tolerance  # without the last order kept it would not be met


def test_the_closed_form_stands_where_it_is_cheaper():
    """By operations: the in-line four in NumPy, one cylinder near rho = 1; never where parts cancel."""

    def form(name: str, target: str, **keywords) -> str:
        made = sb.to_function(sb.balance(sb.load(name)), target=target, **keywords)
        return made.forms["force.vertical"]

    assert form("inline-4", "numpy", tolerance=0) == "closed form"
    assert form("inline-4", "numba", tolerance=0) == "polynomial in one cosine"
    assert form("inline-1", "numpy", tolerance=0) == "polynomial in one cosine"
    assert form("inline-1", "numba", tolerance=0, ratio="1.1") == "closed form"
    assert form("v12-60", "numpy", tolerance=0) == "polynomial in one cosine"
    assert form("inline-4", "numpy") == "polynomial in one cosine"  # an order was given: no more than it


def test_half_orders_and_phases_need_nothing_new():
    """A spectrum as torque has it: orders 1/2, 1, 3/2 with unlike phases, and 2 turns to a period."""
    half = Fraction(1, 2)
    terms = tuple(
        HarmonicTerm(n * half, mp.mpf(c), mp.mpf(s)) for n, c, s in ((1, 3, 1), (2, -1, 0.5), (3, 0, 2))
    )
    wave = HarmonicSum("force.vertical", FORCE, "a torque", terms, 3)
    (source,) = files(choose_plan([wave], Fraction(4), "numpy"), "numpy", "half", "half").values()
    namespace: dict = {"__name__": "half"}
    exec(source, namespace)
    namespace["self_test"]()
    with mp.workdps(40):
        exact = [wave.value(float(t)) for t in ANGLES]
    assert worst(namespace["evaluate"](ANGLES), exact, wave.amplitude()) <= 4
    theta = 2 * np.pi * np.arange(4 * 24) / 24
    assert np.allclose(namespace["on_grid"](24, 4), namespace["evaluate"](theta), rtol=0, atol=1e-13)


@pytest.mark.spread(2)
@pytest.mark.parametrize("points", [1, 7, 360, 1000])
def test_a_grid_repeats_one_period(points):
    made = sb.to_function(
        sb.balance(sb.load("v12-60")), outputs=("force.vertical", "piston.velocity"), tolerance=0
    )
    values = made.on_grid(points, 3, mass=2.0)
    with mp.workdps(40):
        exact = planar("v12-60", False)
        for j in range(0, 3 * points, max(1, points // 5)):
            want = 2 * float(exact(2 * mp.pi * j / points).real)
            assert abs(values["force.vertical"][j] - want) <= 1e-15 * made.amplitude["force.vertical"] * 4


def test_memory_stays_at_inputs_and_outputs():
    """At 10^6 angles: what is held beside them is a few blocks."""
    theta = np.linspace(-1000, 1000, 10**6)
    made = sb.to_function(sb.balance(sb.load("inline-6")))
    made(theta[:10])
    tracemalloc.start()
    try:
        made(theta)
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert theta.nbytes + peak <= 1.1 * 2 * theta.nbytes


@pytest.mark.spread(1)
@pytest.mark.parametrize("target", ["numpy", "numba"])
def test_arrays_of_every_kind(target):
    made = sb.to_function(sb.balance(sb.load("inline-5")), outputs="couple.vertical", target=target)
    plain = np.linspace(-9, 9, 24)
    want = made(plain)
    assert (made(plain.reshape(2, 3, 4)) == want.reshape(2, 3, 4)).all()
    assert (made(np.asfortranarray(plain.reshape(4, 6))) == want.reshape(4, 6)).all()
    assert (made(plain[::-2]) == want[::-2]).all()
    assert (made(list(plain)) == want).all()
    assert made(np.array([])).shape == (0,)
    assert made(3) == made(3.0) == made(np.float64(3)) == made(np.array([3]))[0]
    assert made(plain.astype(np.float32)).dtype == np.float32
    out = np.empty_like(plain)
    assert made(plain, out=out) is out
    assert (out == want).all()
    with pytest.raises(ValueError, match="out must be a float64 array of shape"):
        made(plain, out=np.empty(3))
    with pytest.raises(TypeError, match="crank angles are real"):
        made(plain + 1j)


@pytest.mark.spread(1)
@pytest.mark.parametrize("target", ["numpy", "numba"])
def test_what_is_not_finite_gives_nan_there_alone(target):
    made = sb.to_function(sb.balance(sb.load("v8-90")), outputs=OUTPUTS, target=target, tolerance=0)
    theta = np.array([0.5, np.nan, 2.0, np.inf, -np.inf, 1e300, 5e-324, -0.0])
    clean = made(np.array([0.5, 2.0, 5e-324, -0.0]))
    for output, values in made(theta).items():
        assert np.isnan(values).tolist() == [False, True, False, True, True, False, False, False]
        assert (values[[0, 2, 6, 7]] == clean[output]).all()


@given(
    st.floats(min_value=-1e6, max_value=1e6),
    st.sampled_from(["inline-4", "v6-60", "v8-90"]),
)
def test_a_single_angle_is_worth_what_an_array_is(theta, name):
    made = function(name)
    assert made(theta) == made(np.array([theta]))[0]


@cache
def function(name: str):
    """Return a preset's vertical force."""
    return sb.to_function(sb.balance(sb.load(name)))


@pytest.mark.parametrize(
    ("keywords", "words"),
    [
        ({"tolerance": -1e-3}, "must be 0 or a positive number"),
        ({"tolerance": float("nan")}, "must be 0 or a positive number"),
        ({"tolerance": "1e-3"}, "must be 0 or a positive number"),
        ({"target": "fortran"}, "must be one of numpy, numba"),
        ({"outputs": "force.up"}, "is unknown"),
        ({"outputs": ()}, "names no output"),
    ],
)
def test_refusals(keywords, words):
    with pytest.raises(sb.SymbalanceError, match=words):
        sb.to_function(sb.balance(sb.load("inline-4")), **keywords)


@pytest.mark.slow
def test_orders_beyond_reach_are_refused():
    v6 = sb.balance(sb.load("v6-60"), ratio=Fraction(10**7 + 1, 10**7))
    with pytest.raises(sb.SymbalanceError, match="needs orders above 1000"):
        plan_for(v6, None, "force.forward", "numpy", 1e-6)
