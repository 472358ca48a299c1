"""Evidence: the torque on the crank, against routes that share nothing with it.

The inertia torque is held against minus velocity times acceleration of `kinematics`, taken apart by the
trapezoidal rule in 50 digits, and against the product of the velocity's series; the gas torque against
thermodynamics in closed form and against quadrature; orders that cancel against textbooks and against
floating-point sums. Laws: no work in a revolution, minus the kinetic energy's derivative, an engine
turned is a torque turned. And what is refused, and where.
"""

from __future__ import annotations

import cmath
import math
from fractions import Fraction
from pathlib import Path

import hypothesis.strategies as st
import pytest
import sympy
from hypothesis import given, settings
from mpmath import mp

import symbalance as sb
from symbalance.errors import SymbalanceError
from symbalance.kinematics.piston_torque import torque_left_out, torque_series, torque_values
from symbalance.kinematics.slider_crank import acceleration_series, acceleration_value, surviving
from symbalance.torque import (
    PressureTrace,
    RunningTorque,
    TangentialPressure,
    firing_pin_passings,
    firing_stars,
    flywheel_inertia,
    gas_torque,
    ideal_cycle,
    inertia_torque,
    parse_pressure,
    pressure_trace,
    read_pressure,
    running_torque,
    speed_fluctuation,
)
from tests import kinematics

few = settings(deadline=None, max_examples=25, derandomize=True, database=None)
RATIOS = [Fraction(4), Fraction(16, 5), Fraction(11, 10)]
OTTO = ideal_cycle(10, heat=20, gamma="1.3")
TRACE = OTTO.trace(4, 720)


def torque(p: mp.mpf, lam: mp.mpf) -> mp.mpf:
    """Return the inertia torque of one cylinder at its own angle, from the kinematics alone."""
    return -kinematics.velocity(p, lam) * kinematics.acceleration(p, lam)


# --- inertia, one cylinder ---


@pytest.mark.slow
@pytest.mark.parametrize("ratio", RATIOS)
def test_values_against_quadrature_of_velocity_times_acceleration(ratio: Fraction) -> None:
    with mp.workdps(kinematics.DIGITS):
        lam, points = kinematics.number(ratio), kinematics.points_for(ratio, 12)
        found = kinematics.harmonics(lambda p: torque(p, lam), range(1, 13), points)
        for n, value in torque_values(12, ratio, 30).items():
            cos, sin = found[n]
            assert abs(sin.real - value) < mp.mpf(10) ** -28 * abs(value)
            assert abs(cos) < mp.mpf(10) ** -40


def velocity_squared(power: int) -> dict[int, dict[int, Fraction]]:
    """Return cos n theta -> power of rho -> coefficient of (v/(r omega))^2, by multiplying out."""
    waves = {n: acceleration_series(n, power).terms for n in range(1, power + 3) if surviving(n)}
    total: dict[int, dict[int, Fraction]] = {}
    for a, left in waves.items():
        for b, right in waves.items():
            for p, c in left.items():
                for q, d in right.items():
                    if p + q <= power:
                        for n, sign in ((abs(a - b), 1), (a + b, -1)):
                            row = total.setdefault(n, {})
                            row[p + q] = row.get(p + q, Fraction(0)) + sign * c * d / (2 * a * b)
    return total


def test_series_against_the_product_of_the_velocity_series() -> None:
    product = velocity_squared(11)
    for n in range(1, 10):
        expected = {p: c * n / 2 for p, c in sorted(product[n].items()) if c}
        assert torque_series(n, 11).terms == expected


def test_textbook_leading_terms() -> None:
    leading = {1: {1: "1/4"}, 2: {0: "-1/2"}, 3: {1: "-3/4"}, 4: {2: "-1/4"}, 5: {3: "5/32"}}
    for n, terms in leading.items():
        assert torque_series(n, max(terms)).terms == {p: Fraction(c) for p, c in terms.items()}


@pytest.mark.slow
@given(st.integers(1, 30), st.fractions("13/10", 30, max_denominator=20))
@few
def test_series_converges_to_the_value(order: int, ratio: Fraction) -> None:
    through = 260
    exact = torque_values(order, ratio, 25)[order]
    kept = torque_series(order, through).at(ratio)
    assert abs(mp.mpf(kept.numerator) / kept.denominator - exact) < mp.mpf(10) ** -15


@pytest.mark.spread(2)
@pytest.mark.parametrize("ratio", [*RATIOS, Fraction(1001, 1000)])
@pytest.mark.parametrize("order", [1, 2, 3, 7])
def test_bound_on_what_is_left_out(ratio: Fraction, order: int) -> None:
    with mp.workdps(30):
        lam, values = kinematics.number(ratio), torque_values(order, ratio, 30)
        angles = [mp.pi * i / 360 for i in range(360)]
        gaps = [torque(p, lam) - mp.fsum(t * mp.sin(n * p) for n, t in values.items()) for p in angles]
        bound = torque_left_out(order, ratio)
        assert max(map(abs, gaps)) <= bound
        assert max(map(abs, gaps)) > bound / 3
        odd = mp.fsum(abs(t) for n, t in values.items() if n % 2)
        assert (
            abs(gaps[180] + odd - 1 / mp.sqrt(lam**2 - 1)) < mp.mpf(10) ** -24
        )  # attained at 90 degrees


@pytest.mark.slow
def test_bound_from_terms_and_from_the_whole_sum_agree() -> None:
    """On either side of where the way of computing it changes."""
    sides = [torque_left_out(9, Fraction(n, 100_000)) for n in (100_138, 100_139, 100_140)]
    assert sides[0] > sides[1] > sides[2] > sides[0] * 0.99


# --- inertia, whole engines ---


SURVIVING = {
    "inline-1": range(1, 13),
    "inline-3": (3, 6, 9, 12),
    "inline-4": (2, 4, 6, 8, 10, 12),
    "inline-5": (5, 10),
    "inline-6": (3, 6, 9, 12),
    "v8-90": (4, 8, 12),
    "v12-60": (6, 12),
    "radial-7": (7,),
}


@pytest.mark.parametrize("name", SURVIVING)
def test_surviving_orders(name: str) -> None:
    assert [o.order for o in inertia_torque(sb.load(name)).orders] == [*SURVIVING[name]]


@pytest.mark.slow
@given(st.lists(st.tuples(st.integers(0, 71), st.integers(-3, 3)), min_size=1, max_size=6))
@few
def test_any_layout_against_its_cylinders_added_up(places: list[tuple[int, int]]) -> None:
    layout = sb.Engine(sb.Cylinder(i, 5 * t, 30 * b) for i, (t, b) in enumerate(places, 1))
    with mp.workdps(30):
        theta, lam = mp.mpf("0.7"), mp.mpf(4)
        own = (theta + kinematics.radians(5 * t - 30 * b) for t, b in places)
        expected = mp.fsum(torque(p, lam) for p in own)
        terms = inertia_torque(layout, 40).terms(4)
        waves = (c * mp.cos(int(n) * theta) + s * mp.sin(int(n) * theta) for n, c, s in terms)
        assert abs(mp.fsum(waves) - expected) < mp.mpf(10) ** -20


def test_absent_orders_are_zero_and_present_ones_are_not() -> None:
    for name in ("v6-90", "v2-45", "v10-90", "inline-8"):
        layout = sb.load(name)
        kept = {o.order for o in inertia_torque(layout).orders}
        for n in range(1, 13):
            total = sum(cmath.exp(2j * cmath.pi * n * float(c.delay.turns)) for c in layout.cylinders)
            assert (abs(total) > 1e-9) == (n in kept)


def test_the_frame_gets_the_opposite() -> None:
    crank = inertia_torque(sb.load("v6-90"))
    for on_crank, on_frame in zip(crank.terms(), crank.reaction().terms(), strict=True):
        assert on_frame[0] == on_crank[0]
        assert max(abs(a + b) for a, b in zip(on_crank[1:], on_frame[1:], strict=True)) < 1e-25


def test_symbolic_bank_angle() -> None:
    twin = inertia_torque(sb.vee(sympy.Symbol("alpha"), pins=[0]), order=2)
    assert str(twin[1].torque.sin) == "2*cos(alpha/2)"
    assert twin[2].torque.cos == 0
    assert str(twin[2].torque.sin) == "2*cos(alpha)"


# --- stars ---


@given(st.lists(st.integers(0, 59), min_size=1, max_size=7), st.sampled_from([2, 4]))
@few
def test_stars_against_floating_sums(fires: list[int], strokes: int) -> None:
    cycle = 180 * strokes
    angles = [6 * f * strokes // 2 for f in fires]
    layout = sb.Engine((sb.Cylinder(i, -a, 0, fires=a) for i, a in enumerate(angles, 1)), strokes=strokes)
    for star in firing_stars(layout, 4):
        total = sum(cmath.exp(1j * float(star.order) * math.radians(a % cycle)) for a in angles)
        assert star.is_closed() == (abs(total) < 1e-9)
        assert abs(complex(*star.resultant.decimal()) - total) < 1e-12


@pytest.mark.parametrize(
    ("name", "orders"),
    [
        ("inline-6", "3 6 9"),
        ("v8-90", "4 8"),
        ("inline-5", "5/2 5 15/2"),
        ("inline-4", "2 4 6 8"),
        ("v12-60", "6"),
        ("v6-90", "3/2 3 9/2 15/2 9"),
    ],
)
def test_gas_orders_that_survive(name: str, orders: str) -> None:
    open_stars = [str(s.order) for s in firing_stars(sb.load(name), 9) if not s.is_closed()]
    assert open_stars == orders.split()


def test_firing_pin_passings_of_an_engine_not_at_top_dead_centre() -> None:
    """theta = 0 need not be cylinder 1's firing: it then fires in the turn from theta = 0 on."""
    four = sb.load("inline-4")
    rotated = sb.Engine(
        sb.Cylinder(c.number, c.throw.in_degrees() + 30, 0, 0, c.fires) for c in four.cylinders
    )
    assert firing_pin_passings(rotated) == {
        n: (top + 330) % 720 for n, top in firing_pin_passings(four).items()
    }
    here, there = (
        running_torque(e, TRACE, bore=80, stroke=80, reciprocating_mass=1, rpm=2000, ratio=4)
        for e in (four, rotated)
    )
    for theta in (0.1, 2.0, 7.0):
        assert there.at(theta) == pytest.approx(here.at(theta - math.radians(330)), rel=1e-9)


# --- gas, one cylinder ---


def test_constant_pressure_is_the_velocity() -> None:
    tangential = TangentialPressure(PressureTrace((0.0, 100.0), (3.5, 3.5)), Fraction(4), 1.0)
    for order, number in tangential.harmonics(6).items():
        expected = 0.0
        if order.denominator == 1:
            expected = 2.5 * float(acceleration_value(int(order), Fraction(4))) / int(order)
        assert abs(number - 1j * expected) < 1e-14
    assert abs(tangential.cycle_work) < 1e-13
    assert tangential.work(math.pi) == pytest.approx(2 * 2.5, rel=1e-13)  # p times the stroke, over r


def test_a_jump_is_a_jump() -> None:
    """4 bar above ambient from 0 to 180 degrees only: the velocity's harmonics over half a turn."""
    trace = PressureTrace((0.0, 0.0, 180.0, 180.0), (1.0, 5.0, 5.0, 1.0))
    lam = 10**6  # a sine
    found = TangentialPressure(trace, Fraction(lam), 1.0).harmonics(3)
    for order, number in found.items():
        n = float(order)
        cosine, sine = (
            mp.quad(lambda a, f=f, n=n: 4 * mp.sin(a) * f(n * a), [0, mp.pi]) / (2 * mp.pi)
            for f in (mp.cos, mp.sin)
        )
        assert abs(number - complex(cosine, sine)) < 1e-5


@pytest.mark.slow
@pytest.mark.parametrize("ratio", [Fraction(4), Fraction(8, 5)])
def test_isentropic_cycles_do_their_known_work(ratio: Fraction) -> None:
    """Otto's efficiency and the mixed cycle's, as textbooks write them, from the pressure alone."""
    for cycle, efficiency in (
        (OTTO, 1 - 10**-0.3),
        (ideal_cycle(16, heat=20, gamma="1.4", peak_pressure=100), mixed_efficiency(16, 1.4, 100, 20)),
        (ideal_cycle(18, heat=15, gamma="1.4", peak_pressure=18**1.4), None),
    ):
        if efficiency is not None:
            assert cycle.efficiency == pytest.approx(efficiency, rel=1e-12)
        found = TangentialPressure(cycle.trace(ratio), ratio).mean_effective_pressure
        assert found == pytest.approx(cycle.mean_effective_pressure, rel=1e-4)


def mixed_efficiency(volume: float, gamma: float, peak: float, heat: float) -> float:
    """Heywood's limited-pressure cycle: alpha = p3/p2, beta the cutoff."""
    alpha = peak / volume**gamma
    scale = (volume - 1) * (gamma - 1)
    beta = 1 + (heat - (peak - volume**gamma) / scale) * scale / (gamma * peak)
    return 1 - (alpha * beta**gamma - 1) / (
        volume ** (gamma - 1) * (alpha * gamma * (beta - 1) + alpha - 1)
    )


def test_the_exchange_of_a_four_stroke_costs_its_rectangle() -> None:
    part_load = ideal_cycle(10, heat=8, intake="0.4", exhaust=1)
    assert part_load.mean_effective_pressure == pytest.approx(part_load.closed_work - 0.6, rel=1e-12)
    found = TangentialPressure(part_load.trace(4), Fraction(4)).mean_effective_pressure
    assert found == pytest.approx(part_load.mean_effective_pressure, rel=1e-4)


def test_straight_lines_err_with_the_square_of_the_step() -> None:
    errors = [
        TangentialPressure(OTTO.trace(4, points), Fraction(4)).mean_effective_pressure
        - OTTO.mean_effective_pressure
        for points in (360, 720, 1440)
    ]
    assert errors[0] / errors[1] == pytest.approx(4, rel=0.01)
    assert errors[1] / errors[2] == pytest.approx(4, rel=0.01)
    assert 0 < errors[1] < 1e-4 * OTTO.mean_effective_pressure


TRACES = st.lists(st.tuples(st.integers(0, 719), st.integers(0, 60)), min_size=1, max_size=8).map(
    lambda rows: PressureTrace(
        tuple(float(a) for a, _ in sorted(rows)), tuple(float(p) for _, p in sorted(rows))
    )
)


@given(TRACES, st.sampled_from([Fraction(4), Fraction(7, 5)]))
@settings(few, max_examples=12)
def test_harmonics_and_work_of_any_trace_against_quadrature(
    trace: PressureTrace, ratio: Fraction
) -> None:
    tangential = TangentialPressure(trace, ratio, 1.0)
    found = tangential.harmonics(3)
    edges = trace.radians
    for order in (Fraction(1, 2), Fraction(2), Fraction(5, 2)):
        total = 0j
        for start, end, p, q in zip(edges, edges[1:], trace.closed, trace.closed[1:], strict=False):
            total += gauss(start, end, p, q, float(order), float(ratio))
        assert abs(found[order] - total / (2 * math.pi)) < 1e-7 * max(1, *trace.bar)
    assert found == tangential.harmonics(3)
    whole = sum(
        gauss(a, b, p, q, 0.0, float(ratio)).real
        for a, b, p, q in zip(edges, edges[1:], trace.closed, trace.closed[1:], strict=False)
    )
    assert tangential.cycle_work == pytest.approx(whole, abs=1e-6)


def gauss(start: float, end: float, p: float, q: float, order: float, lam: float) -> complex:
    """Return the integral of (p - 1) v e^(i order theta) over one straight line, in 40 pieces."""
    places = ((-0.861136311594053, 0.347854845137454), (-0.339981043584856, 0.652145154862546))
    half, total = (end - start) / 80, 0j
    for k in range(40):
        for place, weight in (*places, *((-x, w) for x, w in places)):
            share = (2 * k + 1 + place) / 80
            a = start + share * (end - start)
            speed = math.sin(a) * (1 + math.cos(a) / math.sqrt(lam**2 - math.sin(a) ** 2))
            total += weight * (p + share * (q - p) - 1) * speed * cmath.exp(1j * order * a)
    return total * half


@pytest.mark.slow
def test_work_is_the_area_in_the_indicator_diagram() -> None:
    """The polygon through (V, p): straight in V where the torque's lines are straight in theta."""
    trace = OTTO.trace(4)
    lam = mp.mpf(4)
    volumes = [float(kinematics.displacement(mp.mpf(a), lam)) for a in trace.radians]
    area = sum(
        (p + q) / 2 * (v - u)
        for u, v, p, q in zip(volumes, volumes[1:], trace.closed, trace.closed[1:], strict=False)
    )
    assert TangentialPressure(trace, Fraction(4)).cycle_work == pytest.approx(area, rel=1e-5)


# --- gas and inertia together ---


def engine(name: str = "inline-4", rpm: float = 3000, mass: float = 0.5) -> RunningTorque:
    return running_torque(
        sb.load(name), TRACE, bore=80, stroke=80, reciprocating_mass=mass, rpm=rpm, ratio=4
    )


@pytest.mark.slow
def test_mean_is_the_indicated_work() -> None:
    four = engine()
    swept = math.pi * 0.08**2 / 4 * 0.08
    assert four.work == pytest.approx(4 * OTTO.mean_effective_pressure * 1e5 * swept, rel=1e-4)
    assert four.mean * 4 * math.pi == pytest.approx(four.work, rel=1e-14)
    assert four.power == pytest.approx(four.work * 25, rel=1e-12)  # 1500 cycles a minute
    points = 7200
    sampled = sum(total for *_, total in four.curve(points)) / points
    assert sampled == pytest.approx(four.mean, rel=1e-5)


@given(st.floats(0, 13), st.sampled_from(["inline-4", "v6-90", "inline-5"]))
@few
def test_inertia_torque_is_minus_the_kinetic_energy_s_derivative(theta: float, name: str) -> None:
    made = engine(name)
    with mp.workdps(30):

        def energy(angle: mp.mpf) -> mp.mpf:
            own = (angle - mp.mpf(top) for top in made.firing_angles)
            return mp.fsum(kinematics.velocity(p, mp.mpf(4)) ** 2 for p in own)

        slope = float(mp.diff(energy, mp.mpf(theta)))
    unit = 0.5 * (0.04 * 3000 * math.pi / 30) ** 2
    assert made.inertia(theta) == pytest.approx(-unit * slope / 2, abs=1e-9 * unit)


@given(st.sampled_from(["inline-1", "inline-3", "v2-45"]), st.floats(0, 6.3))
@few
def test_inertia_does_no_work_in_a_revolution(name: str, start: float) -> None:
    made, points = engine(name), 96
    total = sum(made.inertia(start + 2 * math.pi * i / points) for i in range(points))
    assert abs(total) < 1e-7


def test_energy_is_the_integral_of_torque_less_mean() -> None:
    made, steps = engine("inline-3"), 4000
    for low, high in ((0.3, 1.1), (3.0, 8.5)):
        step = (high - low) / steps
        area = sum((made.at(low + (i + 0.5) * step) - made.mean) * step for i in range(steps))
        assert made.energy(high) - made.energy(low) == pytest.approx(area, abs=1e-3)
    assert made.energy(made.cycle) == pytest.approx(made.energy(0), abs=1e-9)


def test_terms_add_up_to_the_torque() -> None:
    smooth = [3 + 2 * math.cos(math.radians(a / 2)) ** 4 for a in range(0, 720, 2)]
    trace = pressure_trace(range(0, 720, 2), [f"{p:.9f}" for p in smooth])
    made = running_torque(
        sb.load("v6-90"), trace, bore=90, stroke=70, reciprocating_mass="0.4", rpm=2500, ratio=4
    )
    for theta in (0.0, 1.0, 9.0):
        waves = (
            float(c) * math.cos(float(n) * theta) + float(s) * math.sin(float(n) * theta)
            for n, c, s in made.terms(30)
        )
        assert made.mean + sum(waves) == pytest.approx(made.at(theta), abs=1e-2)  # chords of 2 degrees
        assert made.frame(theta) == -made.at(theta)


@pytest.mark.slow
def test_extremes_against_a_dense_grid() -> None:
    made = engine("inline-5", rpm=4000)
    grid = [made.cycle * i / 20_000 for i in range(20_000)]
    found = made.fluctuation
    torques, energies = [made.at(a) for a in grid], [made.energy(a) for a in grid]
    assert found.largest == pytest.approx(max(torques), rel=1e-6)
    assert found.least == pytest.approx(min(torques), rel=1e-6)
    assert found.energy == pytest.approx(max(energies) - min(energies), rel=1e-6)
    assert found.largest >= max(torques) - 1e-9
    assert found.of_torque == pytest.approx((found.largest - found.least) / made.mean)
    assert found.of_energy == found.energy / made.work


@pytest.mark.slow
def test_a_flywheel_keeps_the_speed_it_was_made_for() -> None:
    """J omega d omega/d theta = T - mean, solved exactly: omega^2 = start^2 + 2 E/J."""
    made = engine()
    inertia = made.flywheel("1/50")
    energies = [made.energy(made.cycle * i / 5000) for i in range(5000)]
    middle = (max(energies) + min(energies)) / 2
    start = made.omega**2 * (1 + 0.01**2)  # omega is the mean of the extremes
    fastest = math.sqrt(start + 2 * (max(energies) - middle) / inertia)
    slowest = math.sqrt(start + 2 * (min(energies) - middle) / inertia)
    assert (fastest + slowest) / 2 == pytest.approx(made.omega, rel=1e-7)
    assert (fastest - slowest) / made.omega == pytest.approx(0.02, rel=1e-5)
    assert made.speed_fluctuation(inertia) == pytest.approx(0.02, rel=1e-12)
    assert speed_fluctuation(10.0, 50.0, flywheel_inertia(10.0, 50.0, 0.1)) == pytest.approx(0.1)


def test_even_firing_engines_repeat_with_their_firing() -> None:
    six = engine("inline-6")
    for theta in (0.2, 1.3):
        assert six.at(theta) == pytest.approx(six.at(theta + 2 * math.pi / 3), rel=1e-6)


def test_two_strokes_fire_every_turn() -> None:
    cycle = ideal_cycle(10, heat=15, strokes=2)
    twin = sb.inline(throws=[0, 180], strokes=2, ratio=4)
    assert firing_pin_passings(twin) == {1: 0, 2: 180}
    made = gas_torque(twin, cycle.trace(4, 1440), 4)
    assert [str(o.order) for o in made.orders] == ["2", "4"]
    assert made.mean * math.pi == pytest.approx(2 * cycle.mean_effective_pressure, rel=1e-4)


# --- what is refused ---


def rows(angles: range, text: str = "1.5") -> str:
    return "\n".join(f"{a},{text}" for a in angles)


def refused(text: str) -> str:
    with pytest.raises(SymbalanceError) as problem:
        parse_pressure(text, "p.csv")
    return str(problem.value)


@pytest.mark.parametrize(
    "header", ["", "angle,p\n", "# measured\n\nCA deg;bar\n", "Kurbelwinkel,Druck\n"]
)
@pytest.mark.parametrize("angles", [range(0, 720, 5), range(-360, 361, 4), range(0, 721, 10)])
def test_traces_as_people_write_them(header: str, angles: range) -> None:
    separator = ";" if ";" in header else ","
    trace = parse_pressure(header + rows(angles).replace(",", separator), "p.csv")
    assert len(trace.degrees) == len([a for a in angles if a != angles.start + 720])
    assert trace.at(77.7) == 1.5


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "p.csv of 0 points"),
        ("angle,bar\n", "p.csv of 0 points"),
        (rows(range(0, 720, 20)), "p.csv:2: angle = 20.0: is more than 10 degrees past"),
        (rows(range(0, 700, 5)), "p.csv:140: angles from 0.0 to 695.0: leave some of 720"),
        (rows(range(0, 360, 5)), "leave some of 720 degrees open"),
        ("0,1\n5,1\n5,1\n", "p.csv:3: angle = 5.0: must be above the one before"),
        ("0,1\n5,1\n4,1\n", "p.csv:3: angle = 4.0: must be above"),
        ("0,1\n5,1,2\n", "p.csv:2: the line: has 3 columns"),
        ("0;1,5\n", "p.csv:1: pressure = 1,5: must be a number"),
        ("0\n", "p.csv:1: the line: has 1 columns"),
        ("0,1\n5,x\n", "p.csv:2: pressure = x: must be a number"),
        ("0,1\n5,nan\n", "p.csv:2: pressure = nan: must be a number"),
        ("0,1\n5,inf\n", "p.csv:2: pressure = inf: must be a number"),
        ("0,1\n5,__import__('os')\n", "p.csv:2: pressure = __import__('os'): must be a number"),
        ("0,1\n5,1+1\n", "p.csv:2: pressure = 1+1"),
        ("0,1\n5,-0.1\n", "p.csv:2: pressure = -0.1: must lie in [0, 2000] bar"),
        ("0,1\n5,101325\n", "p.csv:2: pressure = 101325.0: must lie in"),
        ("0,1\n800,1\n", "p.csv:2: angle = 800.0: must lie in [-720, 720]"),
        ("0,1\n\n# x\n5,a\n", "p.csv:4: pressure = a"),
        ("angle,kPa\n0,1\n", "p.csv:1: the header: names kPa"),
        ("angle [rad],bar\n0,1\n", "names rad"),
        ("x,y\nx,y\n0,1\n", "p.csv:2: angle = x"),
        (rows(range(0, 720, 5)) + "\n720,2", "p.csv:145: pressure = 2.0: must be the first one, 1.5"),
        (rows(range(0, 720, 5)).replace("370,1.5", "370,50"), "p.csv:75: angle = 370.0: has the highest"),
        (rows(range(-300, 430, 5)), "is more than a cycle"),
    ],
)
def test_bad_traces_name_file_and_line(text: str, words: str) -> None:
    line = refused(text)
    assert words in line
    assert "\n" not in line


@given(st.text(alphabet="0123456789,;.-+eE \n\t#ab", max_size=60))
@few
def test_no_text_escapes(text: str) -> None:
    refused(text)


def test_files(tmp_path: Path) -> None:
    path = tmp_path / "p.csv"
    path.write_text(rows(range(0, 720, 10)), encoding="utf-8")
    assert read_pressure(path).at(0) == 1.5
    with pytest.raises(SymbalanceError, match=r"missing\.csv: cannot be read .* check the path"):
        read_pressure(tmp_path / "missing.csv")
    with pytest.raises(SymbalanceError, match=r":38: angle = 370.0: must lie in \[-360, 360\]"):
        read_pressure(path, strokes=2)


BAD = {
    "no ratio": (lambda: inertia_torque(sb.inline("1-3-4-2")).terms(), "no rod ratio"),
    "no layout": (lambda: inertia_torque("inline-4"), "must be an Engine"),
    "unlike": (
        lambda: inertia_torque(sb.Engine([sb.Cylinder(1, reciprocating_mass=1), sb.Cylinder(2, 180)])),
        "reciprocating_mass: is given for some cylinders and not for others",
    ),
    "power": (lambda: inertia_torque(sb.load("inline-6"), 9, power=5), "is 7"),
    "order": (lambda: torque_series(0, 3), "order = 0"),
    "no fires": (lambda: firing_pin_passings(sb.inline(throws=[0, 180])), "has no firing angle"),
    "trace": (lambda: gas_torque(sb.load("inline-4"), None), "must be a PressureTrace"),
    "two-stroke trace": (
        lambda: gas_torque(sb.load("inline-4"), ideal_cycle(9, heat=9, strokes=2).trace(4)),
        "does not fit inline-4",
    ),
    "no stroke": (
        lambda: running_torque(sb.load("inline-4"), TRACE, bore=80, rpm=3000),
        "stroke: is needed",
    ),
    "rpm": (lambda: engine(rpm=0), "rpm = 0"),
    "heat": (lambda: ideal_cycle(10), "needs heat or peak_pressure"),
    "low peak": (lambda: ideal_cycle(10, peak_pressure=5), "below the compression's end"),
    "unreached peak": (lambda: ideal_cycle(10, heat=1, peak_pressure=90), "not reached with this heat"),
    "beyond": (lambda: ideal_cycle(10, heat=900, peak_pressure=90), "beyond bottom dead centre"),
    "gamma": (lambda: ideal_cycle(10, heat=1, gamma=1), "gamma = 1: must lie in (1, 2]"),
    "delta": (lambda: engine().flywheel(0), "delta = 0"),
    "ambient": (lambda: gas_torque(sb.load("inline-4"), TRACE, ambient=-1), "ambient = -1"),
    "unlike numbers": (lambda: pressure_trace([0, 5], [1]), "2 angles and 1 pressures"),
    "unsorted": (lambda: PressureTrace((5.0, 1.0), (1.0, 1.0)), "must rise"),
    "infinite": (lambda: PressureTrace((0.0,), (math.inf,)), "finite"),
    "motored": (
        lambda: (
            running_torque(
                sb.load("inline-4"),
                pressure_trace(range(0, 720, 2), [1] * 360),
                bore=1,
                stroke=1,
                reciprocating_mass=1,
                rpm=1,
            ).fluctuation.of_torque
        ),
        "must be positive for a coefficient",
    ),
}


@pytest.mark.spread(2)
@pytest.mark.parametrize("name", BAD)
def test_bad_input(name: str) -> None:
    make, words = BAD[name]
    with pytest.raises(SymbalanceError) as problem:
        make()
    assert words in str(problem.value)


def test_absent_orders_say_so() -> None:
    with pytest.raises(KeyError, match=r"order 1 is absent.*left: 2, 4"):
        _ = inertia_torque(sb.load("inline-4"), 4)[1]
    with pytest.raises(KeyError, match="order 5/2 is absent"):
        _ = gas_torque(sb.load("inline-4"), TRACE)["5/2"]
    assert gas_torque(sb.load("inline-4"), TRACE)[2].amplitude > 0
