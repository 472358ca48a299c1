"""The integrators: orders of convergence, Floquet multipliers, references that do not step, energy."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

pytest.importorskip("scipy")

from scipy.integrate import solve_ivp

from symbalance.bench.inline_four import Case, full_system, spin
from symbalance.bench.integrator_runs import Reference, kinds
from symbalance.crankshaft.bearings.film_tables import trigonometric_film
from symbalance.crankshaft.frames import QUARTER_TURN, rotation
from symbalance.crankshaft.harmonic_balance import harmonic_state
from symbalance.crankshaft.integrators.coefficients import film_forces, state_size
from symbalance.crankshaft.integrators.first_order import FirstOrderForm
from symbalance.crankshaft.integrators.methods import linear_steps
from symbalance.crankshaft.integrators.tableau import radau_iia
from symbalance.crankshaft.reduction import reduce_system
from symbalance.crankshaft.steady import periodic_start, steady_state
from symbalance.crankshaft.system import Film, Housing, PeriodicSystem
from symbalance.crankshaft.transient import METHODS, integrate
from symbalance.errors import SymbalanceError

NOTHING = np.zeros((0, 2, 2))


def turned_film(matrix):
    """A film whose stiffness in turning axes is `matrix(theta)` (s, 2, 2); no damping."""

    def stiffness(theta):
        turn = rotation(theta)
        return (turn @ matrix(theta) @ np.swapaxes(turn, 1, 2))[:, None]

    return Film(stiffness, lambda theta: np.zeros((len(theta), 1, 2, 2)))


def mathieu(delta, epsilon):
    """x'' + (delta + epsilon cos t) x = 0, the stiffness as a film."""

    def matrix(theta):
        table = np.zeros((len(theta), 2, 2))
        table[:, 0, 0] = delta + epsilon * np.cos(theta)
        return table

    one, none = np.eye(1), np.zeros((1, 1))
    points = np.array([[[1.0], [0.0]]])
    return PeriodicSystem(
        one,
        none,
        none,
        points,
        turned_film(matrix),
        None,
        lambda t: np.zeros((len(t), 1)),
        1.0,
        2 * np.pi,
    )


def monodromy(system, method, steps):
    return linear_steps(system, method, steps).propagate(np.eye(state_size(system)))


@pytest.mark.parametrize(
    ("method", "order", "steps"), [("newmark", 2, 64), ("radau-iia", 5, 24), ("radau-iia-9", 9, 8)]
)
def test_orders_of_convergence_on_mathieus_equation(method, order, steps):
    def slope(t, y):
        x, v = y[:2], y[2:]
        return np.concatenate([v, -(1.2 + 0.5 * np.cos(t)) * x])

    known = solve_ivp(
        slope, (0, 2 * np.pi), np.eye(2).ravel(), method="DOP853", rtol=1e-13, atol=1e-14
    ).y[:, -1]
    off = [
        np.abs(monodromy(mathieu(1.2, 0.5), method, n) - known.reshape(2, 2)).max()
        for n in (steps, 2 * steps)
    ]
    assert abs(np.log2(off[0] / off[1]) - order) < 0.35


def test_mathieus_tongue():
    """At delta = 1/4 the edges are at delta = 1/4 -+ epsilon/2 to first order; liouville: product 1."""
    for delta, stable in ((0.15, True), (0.25, False), (0.35, True)):
        factors = periodic_start(linear_steps(mathieu(delta, 0.1), "radau-iia", 200))[1]
        assert abs(np.prod(factors) - 1) < 1e-9
        assert (np.abs(factors).max() < 1 + 1e-7) == stable


def jeffcott(omega, stationary):
    """An asymmetric shaft k = 0.81, 1.21 with a unit mass, in turning or in stationary axes."""
    shaft = np.diag([0.81, 1.21])
    calm = lambda t: np.zeros((len(t), 2))  # noqa: E731
    if not stationary:
        gyro, stiffness = 2 * omega * QUARTER_TURN, shaft - omega**2 * np.eye(2)
        no_film = Film(lambda t: np.zeros((len(t), 0, 2, 2)), lambda t: np.zeros((len(t), 0, 2, 2)))
        points = np.zeros((0, 2, 2))
        return PeriodicSystem(np.eye(2), gyro, stiffness, points, no_film, None, calm, omega, 2 * np.pi)

    def matrix(theta):
        turn = rotation(theta)
        return turn @ shaft @ np.swapaxes(turn, 1, 2)

    none = np.zeros((2, 2))
    return PeriodicSystem(
        np.eye(2), none, none, np.eye(2)[None], turned_film(matrix), None, calm, omega, 2 * np.pi
    )


@pytest.mark.parametrize("stationary", [False, True])
@pytest.mark.parametrize(("omega", "growth"), [(0.89, 0.0), (1.0, 0.099504), (1.11, 0.0)])
def test_an_asymmetric_rotor_grows_between_its_two_frequencies(stationary, omega, growth):
    factors = periodic_start(linear_steps(jeffcott(omega, stationary), "radau-iia", 180))[1]
    rate = np.log(np.abs(factors).max()) * omega / (2 * np.pi)
    assert abs(rate - growth) < 1e-6


def test_newmark_keeps_the_energy_and_radau_takes_some():
    """Without damping, bearings or loads: x'Mx' + x'Sx is kept by the trapezoidal rule."""
    system = replace(jeffcott(1.0, False), damping=np.zeros((2, 2)), stiffness=np.diag([0.81, 1.21]))
    start = np.array([1.0, -0.4, 0.2, 0.7])

    def energy(method):
        y = linear_steps(system, method, 40).march(start, 20)
        return (y[:, 2:] ** 2).sum(1) + (y[:, :2] ** 2 * [0.81, 1.21]).sum(1)

    kept, lost = energy("newmark"), energy("radau-iia")
    assert np.ptp(kept) < 1e-12 * kept[0]
    assert (np.diff(lost) < 0).all()
    assert lost[-1] > 0.99 * lost[0]


@pytest.mark.parametrize("stages", [1, 2, 3, 5, 7])
def test_a_tableau_integrates_polynomials(stages):
    made = radau_iia(stages)
    for power in range(stages):
        assert np.allclose(made.matrix @ made.nodes**power, made.nodes ** (power + 1) / (power + 1))
    for power in range(2 * stages - 1):
        assert abs(made.matrix[-1] @ made.nodes**power - 1 / (power + 1)) < 1e-12
    assert made.order == 2 * stages - 1


@pytest.fixture(scope="module")
def four():
    return reduce_system(full_system(Case("test")))


@pytest.fixture(scope="module")
def balanced(four):
    return harmonic_state(four[0], 120)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("method", "steps", "within"),
    [("radau-iia", 720, 1e-4), ("radau-iia-9", 180, 1e-4), ("newmark", 2880, 1e-3)],
)
def test_shooting_finds_what_harmonic_balance_finds(four, balanced, method, steps, within):
    system, basis = four
    found = steady_state(system, method=method, steps=steps)
    known = balanced.states(found.theta)
    for kind in kinds(system, spin(), basis):
        off = np.abs((found.position - known[:, : system.size]) @ kind.T).max()
        assert off < within * np.abs(known[:, : system.size] @ kind.T).max()
    carried = film_forces(system, found.theta, known)
    assert np.abs(found.bearing - carried).max() < 20 * within * np.abs(carried).max()


@pytest.mark.slow
def test_all_bearings_together_carry_what_acts_on_the_crank(four):
    """Over a cycle the mean force on the shaft, stationary axes, is nil: bearings against loads."""
    system, _ = four
    found = steady_state(system, steps=720)
    full = full_system(Case("test"))
    rows = np.zeros((2, full.size))
    rows[0, 0::6], rows[1, 1::6] = 1, 1
    loads = (rotation(found.theta) @ (full.force(found.theta) @ rows.T)[..., None])[..., 0]
    total = found.bearing.sum(axis=1).mean(axis=0) + loads.mean(axis=0)
    assert np.abs(total).max() < 1e-4 * np.abs(found.bearing).max()


@pytest.mark.slow
def test_scipys_and_ours_end_at_one_state(four, balanced):
    system, _ = four
    start = balanced.states(np.zeros(1))[0]
    ends = {
        m: integrate(system, method=m, steps=360, start=start, rtol=1e-5) for m in ("radau-iia", "radau")
    }
    largest = np.abs(ends["radau"].position).max()
    for one in ends.values():
        assert np.abs(one.position - ends["radau"].position).max() < 1e-4 * largest


@pytest.mark.slow
def test_the_jacobian_is_that_of_the_slope(four):
    first = FirstOrderForm.of(four[0])
    state = np.random.default_rng(1).normal(size=first.size)
    rest = first.slope(1.3, np.zeros(first.size))
    assert np.allclose(first.slope(1.3, state) - rest, first.matrix(1.3) @ state, rtol=1e-9, atol=1e-3)


@pytest.mark.slow
def test_a_housing_without_bounds_is_the_ground():
    full = full_system(Case("test"))
    system, _ = reduce_system(full)
    count = len(system.points)
    rigid = Housing(np.tile(1e19 * np.eye(2), (count, 1, 1)), np.tile(1e4 * np.eye(2), (count, 1, 1)))
    found = steady_state(replace(system, housing=rigid), steps=180)
    ground = steady_state(replace(system, housing=None), steps=180)
    assert np.abs(found.position - ground.position).max() < 1e-6 * np.abs(ground.position).max()
    assert abs(np.abs(found.multipliers).max() - np.abs(ground.multipliers).max()) < 1e-5


@pytest.mark.parametrize(("delta", "epsilon", "frozen"), [(0.1, 0.2, True), (0.25, 0.1, False)])
def test_frozen_angles_say_nothing(delta, epsilon, frozen):
    """Unstable at some angles taken one by one and stable over the cycle, and the other way about."""
    system = mathieu(delta, epsilon)
    first = FirstOrderForm.of(system)
    rates = [np.linalg.eigvals(first.matrix(a)).real.max() for a in np.arange(0, 2 * np.pi, 0.1)]
    factors = periodic_start(linear_steps(system, "radau-iia", 200))[1]
    assert (max(rates) > 0.1) == frozen
    assert (np.abs(factors).max() > 1 + 1e-3) == (not frozen)


@pytest.mark.slow
def test_a_table_too_coarse_limits_every_method(four):
    """Films known every 10 degrees only: more steps do not help."""
    system, _ = four
    theta = system.cycle / 72 * np.arange(72)
    coarse = trigonometric_film(system.film.stiffness(theta), system.film.damping(theta), system.cycle)
    found = [steady_state(replace(system, film=coarse), steps=n, multipliers=False) for n in (360, 1440)]
    known = steady_state(system, steps=1440, multipliers=False)
    size = np.abs(known.bearing).max()
    assert np.abs(found[0].bearing - found[1].bearing[::4]).max() < 2e-3 * size
    assert np.abs(found[1].bearing - known.bearing).max() > 2e-2 * size


@pytest.mark.slow
def test_attachment_vectors_are_worth_more_than_modes(four):
    full, (few, basis) = full_system(Case("test")), four
    plain, modes = reduce_system(full, 40, attachments=False)
    known = steady_state(full, steps=360, multipliers=False)
    off = [
        np.abs(steady_state(s, steps=360, multipliers=False).bearing - known.bearing).max()
        for s in (few, plain)
    ]
    assert few.size <= 42
    assert off[0] < 2e-3 * np.abs(known.bearing).max()
    assert off[0] < off[1] / 5
    assert modes.shape == (174, 40)
    assert np.allclose(basis.T @ full.mass @ basis, np.eye(few.size), atol=1e-7)


def test_large_systems_take_the_krylov_route_to_the_same_state(four, monkeypatch):
    system, _ = four
    made = linear_steps(system, "radau-iia", 90)
    dense, factors = periodic_start(made)
    monkeypatch.setattr("symbalance.crankshaft.steady.DENSE", 10)
    state, leading = periodic_start(made)
    assert np.abs((state - dense) / made.units).max() < 1e-8 * np.abs(dense / made.units).max()
    assert np.allclose(np.abs(leading[:4]), np.abs(factors[:4]), rtol=1e-5)


@pytest.mark.slow
def test_a_tolerance_is_kept(four):
    loose = steady_state(four[0], steps=90, tolerance=1e-4)
    assert loose.error <= 1e-4
    tight = steady_state(four[0], method="radau-iia-9", steps=720)
    every = len(tight.theta) // len(loose.theta)
    off = np.abs(loose.position - tight.position[::every]).max(axis=0)
    assert np.linalg.norm(off) < 1e-4 * np.linalg.norm(np.abs(tight.position).max(axis=0))


def test_refusals(four):
    system, _ = four
    with pytest.raises(SymbalanceError, match="one of radau-iia"):
        steady_state(system, method="euler")
    with pytest.raises(SymbalanceError, match="at least 4"):
        steady_state(system, steps=2)
    with pytest.raises(SymbalanceError, match="must be positive"):
        steady_state(replace(system, omega=0.0))
    with pytest.raises(SymbalanceError, match="finite numbers"):
        integrate(system, start=np.zeros(3))
    drifting = replace(
        jeffcott(1.0, False),
        stiffness=np.zeros((2, 2)),
        damping=np.zeros((2, 2)),
        force=lambda t: np.ones((len(t), 2)),
    )
    with pytest.raises(SymbalanceError, match="no periodic state"):
        steady_state(drifting, steps=40)
    assert "rk45" in METHODS


@pytest.mark.parametrize(
    ("spring", "damper", "rule"),
    [
        (0.0, 0.0, "positive in every direction"),
        (-1e8, 1e3, "positive in every direction"),
        (np.nan, 1e3, "finite"),
        (1e9, -1.0, "zero or more"),
    ],
)
def test_housings_that_none_is_are_refused(four, spring, damper, rule):
    each = [np.diag([x, x]) for x in (1e9, spring, 1e9, 1e9, 1e9)]
    behind = Housing(np.array(each), np.array([np.diag([damper, damper])] * 5))
    with pytest.raises(SymbalanceError, match=rule) as refusal:
        steady_state(replace(four[0], housing=behind), steps=90)
    assert "bearing 1" in str(refusal.value) or "bearing 2" in str(refusal.value)


def test_numbers_that_none_is_are_refused(four):
    system, _ = four
    loaded = replace(system, force=lambda t: np.full((len(t), system.size), np.nan))
    for asked, rule in (
        (lambda: steady_state(loaded, steps=90), "must be finite"),
        (lambda: steady_state(system, steps=100.5), "whole number"),
        (lambda: steady_state(system, steps=10**9), "at most"),
        (lambda: steady_state(system, steps=90, tolerance=float("nan")), "positive"),
        (lambda: steady_state(replace(system, omega=np.inf), steps=90), "finite"),
        (lambda: steady_state(replace(system, mass=np.nan * system.mass), steps=90), "finite"),
        (lambda: integrate(system, cycles=0), "at least 1"),
        (lambda: harmonic_state(system, 0), "1 to 2000"),
        (lambda: integrate(system, method="radau", rtol=0.0), "between 0 and 1"),
        (lambda: reduce_system(full_system(Case("test")), 2.5), "must lie in"),
    ):
        with pytest.raises(SymbalanceError, match=rule):
            asked()


@pytest.mark.slow
def test_an_undamped_housing_of_1e13_and_films_without_damping_run(four):
    system, _ = four
    stiff = Housing(np.tile(1e13 * np.eye(2), (5, 1, 1)), np.zeros((5, 2, 2)))
    for method in ("radau-iia", "radau-iia-9"):
        found = steady_state(replace(system, housing=stiff), method=method, steps=360)
        assert 0.2 < np.abs(found.multipliers).max() < 0.25
    bare = Film(system.film.stiffness, lambda t: np.zeros((len(t), 5, 2, 2)))
    assert np.abs(steady_state(replace(system, film=bare), steps=180).multipliers).max() > 1


@pytest.mark.slow
def test_a_fault_in_the_steps_shows(four, balanced):
    """A step's gain off by a thousandth is far outside what the comparisons above allow."""
    system, _ = four
    made = linear_steps(system, "radau-iia", 180)
    wrong = replace(made, gain=made.gain * 1.001)
    theta = system.cycle / 180 * np.arange(180)
    known = balanced.states(theta)[:, : system.size]
    reference = Reference(
        system, [system.points.reshape(-1, system.size)], balanced.states(np.append(theta, 0.0)), 0.0
    )
    assert (
        reference.error(made.march(periodic_start(made, False)[0]))
        < 3e-4
        < reference.error(wrong.march(periodic_start(wrong, False)[0]))
    )
    assert known.shape == (180, system.size)


# A point mass in a film on a housing: springs in a row, in closed form

MASS, OMEGA, SPRING, DAMPER = 12.0, 150.0, 5e6, 2e3
LOADS = {1: 300.0 + 80j, 0: -MASS * 9.81, 3: 200j, -2: 150.0}
"""Forces e^(i n theta) in the stationary frame, vertical + i lateral: unbalance, weight, and others."""
BEHIND = [None, (8e6, 900.0), (3e6, 0.0)]


def mass_on_springs(behind):
    def force(theta):
        whole = sum(a * np.exp(1j * (n - 1) * theta) for n, a in LOADS.items())
        return np.stack([whole.real, whole.imag], axis=-1)

    def tables(value):
        return lambda theta: np.tile(value * np.eye(2), (len(theta), 1, 1, 1))

    quarter = np.array([[0.0, -1.0], [1.0, 0.0]])
    housing = None if behind is None else Housing(*(value * np.eye(2)[None] for value in behind))
    film = Film(tables(SPRING), tables(DAMPER))
    matrices = MASS * np.eye(2), 2 * MASS * OMEGA * quarter, -MASS * OMEGA**2 * np.eye(2)
    return PeriodicSystem(*matrices, np.eye(2)[None], film, housing, force, OMEGA, 2 * np.pi)


def springs_in_a_row(theta, behind):
    """Return the mass's place and velocity, the film's force on it and the housing's place, stationary.

    m x'' = F - x/(1/(k + i n c) + 1/(K + i n C)) in each frequency n.
    """
    place, speed, carried, housing = np.zeros((4, len(theta)), complex)
    for n, load in LOADS.items():
        rate = 1j * n * OMEGA
        yielding = 0.0 if behind is None else 1 / (behind[0] + rate * behind[1])
        compliance = 1 / (SPRING + rate * DAMPER) + yielding
        answer = load / (MASS * rate**2 + 1 / compliance)
        wave = np.exp(1j * n * theta)
        place += answer * wave
        speed += rate * answer * wave
        carried -= answer / compliance * wave
        housing += answer * yielding / compliance * wave
    return place, speed, carried, housing


@pytest.mark.parametrize("behind", BEHIND, ids=str)
@pytest.mark.parametrize(
    ("method", "steps", "within"),
    [("newmark", 1440, 2e-4), ("radau-iia", 120, 1e-6), ("radau-iia-9", 40, 1e-7)],
)
def test_a_mass_on_film_and_housing_swings_as_springs_in_a_row_do(method, steps, within, behind):
    state = steady_state(mass_on_springs(behind), method=method, steps=steps)
    place, _, carried, _ = springs_in_a_row(state.theta, behind)
    turned = (state.position[:, 0] + 1j * state.position[:, 1]) * np.exp(1j * state.theta)
    assert np.abs(turned - place).max() < within * np.abs(place).max()
    bearing = state.bearing[:, 0, 0] + 1j * state.bearing[:, 0, 1]
    assert np.abs(bearing - carried).max() < 20 * within * np.abs(carried).max()
    # the free motion: roots of m s^2 + 1/(1/(k + c s) + 1/(K + C s)), in the stationary frame
    film = np.polynomial.Polynomial([SPRING, DAMPER])
    free = np.polynomial.Polynomial([0, 0, MASS]) + film
    if behind is not None:
        ground = np.polynomial.Polynomial(list(behind))
        free = np.polynomial.Polynomial([0, 0, MASS]) * (film + ground) + film * ground
    slowest = max(np.exp(root.real * 2 * np.pi / OMEGA) for root in free.roots())
    close = 5e-3 if method == "newmark" else 1e-4
    assert np.abs(state.multipliers).max() == pytest.approx(slowest, rel=close)


@pytest.mark.parametrize("behind", BEHIND, ids=str)
def test_harmonic_balance_has_the_mass_on_springs_exactly(behind):
    balance = harmonic_state(mass_on_springs(behind), 6)
    theta = np.linspace(0, 2 * np.pi, 17)
    states, turn = balance.states(theta), np.exp(1j * theta)
    place, speed, _, housing = springs_in_a_row(theta, behind)
    assert (states[:, 0] + 1j * states[:, 1]) * turn == pytest.approx(place, rel=1e-9, abs=1e-12)
    # the velocity in turning axes is the stationary one less what turning alone gives
    turning = (states[:, 2] + 1j * states[:, 3]) * turn
    assert turning == pytest.approx(speed - 1j * OMEGA * place, rel=1e-9, abs=1e-10)
    assert states.shape[1] == (4 if behind is None else 6)
    if behind is not None:
        assert states[:, 4] + 1j * states[:, 5] == pytest.approx(housing, rel=1e-8, abs=1e-12)
