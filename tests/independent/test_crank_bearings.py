"""Oil films against quadrature, a textbook and a time-domain route; series connections; film tables."""

from __future__ import annotations

import numpy as np
import pytest
from mpmath import mp

pytest.importorskip("scipy")

from symbalance.bench.inline_four import CYCLE
from symbalance.crankshaft.bearings.film_tables import film_from_tables, read_film, trigonometric_film
from symbalance.crankshaft.bearings.orbits import bearing_films, journal_orbit
from symbalance.crankshaft.bearings.series import equivalent_coefficients, equivalent_system
from symbalance.crankshaft.bearings.short_film import Bearing, equilibrium, film_state
from symbalance.crankshaft.frames import QUARTER_TURN, rotation
from symbalance.crankshaft.steady import steady_state
from symbalance.crankshaft.system import Housing, PeriodicSystem
from symbalance.errors import SymbalanceError

TEXTBOOK = Bearing(0.1, 0.03, 1e-4, 0.1)
OMEGA = 50 * np.pi


def by_quadrature(bearing, place, velocity, omega):
    """Reynolds' short-bearing pressure over its positive arc, from the film's height, in mpmath."""
    x, y = (mp.mpf(float(v)) / bearing.clearance for v in place)
    u = mp.mpf(float(velocity[0])) + omega / 2 * mp.mpf(float(place[1]))
    v = mp.mpf(float(velocity[1])) - omega / 2 * mp.mpf(float(place[0]))
    towards = mp.atan2(v, u)

    def pull(axis):
        def density(psi):
            height = 1 - x * mp.cos(psi) - y * mp.sin(psi)
            squeeze = u * mp.cos(psi) + v * mp.sin(psi)
            return squeeze / height**3 * (mp.cos(psi) if axis == 0 else mp.sin(psi))

        return mp.quad(density, mp.linspace(towards - mp.pi / 2, towards + mp.pi / 2, 9))

    return bearing.strength * np.array([float(pull(0)), float(pull(1))])


@pytest.mark.parametrize("seed", range(4))
def test_the_closed_form_is_the_integral_over_the_arc(seed):
    chance = np.random.default_rng(seed)
    radius, angle = (0.3, 0.6, 0.9, 0.98)[seed] * 1e-4, chance.uniform(0, 2 * np.pi)
    place = radius * np.array([np.cos(angle), np.sin(angle)])
    velocity = chance.normal(size=2) * 1e-2
    state = film_state(TEXTBOOK, place, velocity, OMEGA)
    assert np.allclose(state.force, by_quadrature(TEXTBOOK, place, velocity, OMEGA), rtol=1e-12)
    for given, table, step in ((0, state.stiffness, 1e-11), (1, state.damping, 1e-7)):
        for axis in range(2):
            shifts = [np.zeros((2, 2)), np.zeros((2, 2))]
            shifts[0][given, axis], shifts[1][given, axis] = step, -step
            ends = [film_state(TEXTBOOK, place + s[0], velocity + s[1], OMEGA).force for s in shifts]
            slope = (ends[0] - ends[1]) / (2 * step)
            assert np.allclose(slope, table[:, axis], rtol=1e-5, atol=1e-5 * np.abs(table).max())


def test_against_a_textbook_bearing():
    """Friswell et al., Dynamics of Rotating Machines (2010), ex. 5.5.1; its load is along -y."""
    place = equilibrium(TEXTBOOK, [0.0, -525.0], OMEGA)
    assert abs(np.linalg.norm(place) / 1e-4 - 0.2663) < 5e-5
    state = film_state(TEXTBOOK, place, [0.0, 0.0], OMEGA)
    mirror = np.array([[1, -1], [-1, 1]])
    assert np.allclose(state.force, [0.0, -525.0], atol=1e-9)
    published = np.array([[12.808, 16.394], [-25.060, 8.8153]])
    assert np.allclose(state.stiffness / 1e6, published, rtol=1e-4)
    published = np.array([[232.90, -81.924], [-81.924, 294.91]])
    assert np.allclose(state.damping / 1e3, published, rtol=1e-4)
    other = film_state(TEXTBOOK, place * [-1, 1], [0.0, 0.0], -OMEGA)
    assert np.allclose(other.stiffness, state.stiffness * mirror)


@pytest.mark.slow
def test_equilibrium_carries_its_load_in_any_bearing():
    """Sizes, speeds and loads over decades: Newton's last step must not be halved away."""
    chance = np.random.default_rng(1)
    for _ in range(300):
        lows, highs = (-2.0, -2.0, -5.0, -2.5), (-0.5, -1.0, -3.5, -1.0)
        bearing = Bearing(
            *(10 ** chance.uniform(low, high) for low, high in zip(lows, highs, strict=True))
        )
        omega, load = 10 ** chance.uniform(1, 3), 10 ** chance.uniform(1, 5.5)
        place = equilibrium(bearing, [-load, 0.0], omega)
        force = film_state(bearing, place, [0.0, 0.0], omega).force
        assert np.allclose(force, [-load, 0.0], rtol=0, atol=1e-5 * load)


@pytest.mark.parametrize("load", [1e-3, 10.0, 1e4, 1e7])
def test_equilibrium_carries_its_load(load):
    wanted = load * np.array([np.cos(1.2), np.sin(1.2)])
    place = equilibrium(TEXTBOOK, wanted, OMEGA)
    assert np.allclose(film_state(TEXTBOOK, place, [0, 0], OMEGA).force, wanted, rtol=1e-7)


@pytest.mark.slow
def test_an_orbit_carries_its_loads_with_its_own_velocity():
    count = 360
    theta = 4 * np.pi / count * np.arange(count)
    loads = 2000 * np.stack([1.5 + np.cos(theta / 2), 0.7 * np.sin(theta)], axis=-1)[:, None]
    orbit = journal_orbit([TEXTBOOK], loads, OMEGA, 4 * np.pi)
    order = 1j * np.fft.fftfreq(count, 1 / count)[:, None, None] * OMEGA / 2
    speed = np.fft.ifft(order * np.fft.fft(orbit.place, axis=0), axis=0).real
    carried = bearing_films([TEXTBOOK], orbit.place, speed, OMEGA).force
    assert np.abs(carried - loads).max() < 5e-3 * np.abs(loads).max()
    assert (np.linalg.eigvalsh(orbit.damping)[..., 0] > 0).all()
    coarse = journal_orbit([TEXTBOOK], loads[::2], OMEGA, 4 * np.pi)
    coarser = journal_orbit([TEXTBOOK], loads[::4], OMEGA, 4 * np.pi)
    off = [
        np.abs(o.place[:: 2 ** (2 - k)] - orbit.place[::4]).max() for k, o in ((1, coarse), (2, coarser))
    ]
    assert off[0] < off[1] / 5


@pytest.mark.slow
@pytest.mark.parametrize("size", [300.0, 2000.0, 80000.0])
def test_the_whole_orbit_at_once_is_the_one_that_marching_finds(size, monkeypatch):
    theta = 4 * np.pi / 240 * np.arange(240)
    loads = size * np.stack([1.5 + np.cos(theta / 2) ** 9, 0.7 * np.sin(theta)], axis=-1)[:, None]
    found = journal_orbit([TEXTBOOK], loads, OMEGA, 4 * np.pi)
    monkeypatch.setattr("symbalance.crankshaft.bearings.orbits.periodic_places", lambda *_: None)
    marched = journal_orbit([TEXTBOOK], loads, OMEGA, 4 * np.pi)
    assert np.abs(found.place - marched.place).max() < 1e-6 * TEXTBOOK.clearance
    assert (found.place != marched.place).any()


def test_an_orbit_that_marching_does_not_close_is_found():
    """A light load: the journal whirls at half speed, hardly damped, and marching needs ages."""
    theta = 4 * np.pi / 240 * np.arange(240)
    loads = 20 * np.stack([1.5 + np.cos(theta / 2) ** 9, 0.7 * np.sin(theta)], axis=-1)[:, None]
    orbit = journal_orbit([TEXTBOOK], loads, OMEGA, 4 * np.pi)
    order = 1j * np.fft.fftfreq(240, 1 / 240)[:, None, None] * OMEGA / 2
    speed = np.fft.ifft(order * np.fft.fft(orbit.place, axis=0), axis=0).real
    assert np.abs(bearing_films([TEXTBOOK], orbit.place, speed, OMEGA).force - loads).max() < 0.2


def test_a_steady_load_has_no_orbit_but_a_place():
    orbit = journal_orbit([TEXTBOOK], np.full((32, 1, 2), [-400.0, 0.0]), OMEGA, 2 * np.pi)
    assert np.allclose(orbit.place, equilibrium(TEXTBOOK, [-400.0, 0.0], OMEGA), atol=1e-14)


def test_springs_in_series_and_what_cross_terms_do():
    film, behind = 4.0 * np.eye(2)[None], Housing(12.0 * np.eye(2)[None], np.zeros((1, 2, 2)))
    stiffness, _ = equivalent_coefficients((film, 0 * film), behind, 3.0)
    assert np.allclose(stiffness, 3.0 * np.eye(2))
    crossed = np.array([[[4.0, 9.0], [-9.0, 4.0]]])
    stiffness, _ = equivalent_coefficients((crossed, 0 * film), behind, 0.0)
    assert stiffness[0, 0, 0] > 4.0
    near, far = (equivalent_coefficients((crossed, film), behind, w) for w in (1e-6, 0.0))
    assert np.allclose(near, far, rtol=1e-6)


def test_series_and_exact_agree_where_nothing_turns_or_changes():
    """A round rotor, a film the same at all angles, one order: the paper's way is exact there."""
    omega, order = 100.0, 3

    def pushed(theta):
        still = np.stack([np.cos(order * theta), 0.4 * np.sin(order * theta)], axis=-1)
        return (np.swapaxes(rotation(theta), 1, 2) @ still[..., None])[..., 0]

    spring, damper = np.array([[3e5, 1e5], [-5e4, 2e5]]), np.array([[900.0, 100.0], [100.0, 500.0]])
    film = trigonometric_film(np.tile(spring, (8, 1, 1, 1)), np.tile(damper, (8, 1, 1, 1)), CYCLE)
    behind = Housing(np.diag([4e5, 2e5])[None], np.diag([200.0, 300.0])[None])
    gyro, centrifugal = 2 * omega * QUARTER_TURN, -(omega**2) * np.eye(2)
    points, mass = np.eye(2)[None], np.eye(2)
    system = PeriodicSystem(mass, gyro, centrifugal, points, film, behind, pushed, omega, CYCLE)
    exact = steady_state(system, steps=720)
    size = np.abs(exact.position).max()
    for taken, same in ((order, True), (1, False)):
        series = steady_state(equivalent_system(system, taken), steps=720)
        assert (np.abs(series.position - exact.position).max() < 1e-7 * size) == same


def test_tables_come_back_at_their_angles():
    theta = np.radians([0.0, 100.0, 150.0, 400.0, 600.0])
    stiffness = np.random.default_rng(0).normal(size=(5, 1, 2, 2)) * 1e8
    damping = np.tile(1e5 * np.eye(2), (5, 1, 1, 1))
    film = film_from_tables(theta, stiffness, damping, CYCLE)
    assert np.allclose(film.stiffness(theta), stiffness)
    assert np.allclose(film.stiffness(theta + CYCLE), stiffness)
    smooth = trigonometric_film(
        *[np.cos(np.arange(16) * np.pi / 8)[:, None, None, None] * damping[:1]] * 2, CYCLE
    )
    assert np.allclose(smooth.damping(np.array([0.7]))[0, 0, 0, 0], 1e5 * np.cos(0.35))


HEAD = "deg,kvv,kvl,klv,kll,cvv,cvl,clv,cll\n"
GOOD = "1e8,2e7,-3e7,2e8,1e5,0,0,1e5"


@pytest.mark.parametrize(
    ("rows", "rule"),
    [
        (["0," + GOOD] * 4, "rising"),
        ([f"{a},{GOOD}" for a in (0, 180, 360, 720)], "below 720"),
        ([f"{a},1e8,0,0,1e8,1e5,0,0,-1e5" for a in (0, 180, 360, 540)], "positive definite"),
        ([f"{a},{GOOD},1" for a in (0, 180, 360, 540)], "has 10 columns, not 9"),
        ([f"{a},{GOOD[:-3]}x" for a in (0, 180, 360, 540)], "must be a number"),
        ([f"{a},{GOOD[:-3]}nan" for a in (0, 180, 360, 540)], "must be a number"),
        ([], "0 rows"),
    ],
)
def test_tables_that_no_film_has_are_refused(tmp_path, rows, rule):
    path = tmp_path / "film.csv"
    path.write_text(HEAD + "\n".join(rows))
    with pytest.raises(SymbalanceError, match=rule) as refused:
        read_film(path, 1, CYCLE)
    assert str(path) in str(refused.value)


def test_a_table_is_read(tmp_path):
    path = tmp_path / "film.csv"
    path.write_text("# oil at 90\n" + HEAD + "\n".join(f"{a},{GOOD}" for a in (0, 180, 360, 540)))
    film = read_film(path, 1, CYCLE)
    assert np.allclose(film.stiffness(np.array([1.0]))[0, 0], [[1e8, 2e7], [-3e7, 2e8]])
    with pytest.raises(SymbalanceError, match="cannot be read"):
        read_film(tmp_path / "none.csv", 1, CYCLE)
