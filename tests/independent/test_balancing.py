"""Counterweights and balance shafts against the time domain: what a design ends is gone, to rounding."""

from __future__ import annotations

import json
import math
from fractions import Fraction

import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp

import symbalance as sb
from symbalance.design.balancing.bounded_weights import bounded_vectors
from symbalance.design.balancing.overbalance import amplitudes, first_order
from symbalance.design.balancing.planes import in_planes
from symbalance.engine.catalogue import preset_text
from symbalance.engine.crank_train import CrankTrain, Link
from symbalance.exact.angles import Angle
from symbalance.exact.arithmetic import total
from symbalance.exact.phasor import ZERO, Phasor
from tests import placed, rotating_model
from tests.different_presets import different_presets
from tests.independent import test_unlike

GONE = 1e-33
SIZED = CrankTrain(
    stroke=Fraction(86),
    rod=Fraction(143),
    reciprocating_mass=Fraction(1, 2),
    rotating_mass=Fraction(3, 5),
)
ALPHA = sympy.Symbol("alpha")


def assert_ended(design: sb.design.Design, pistons=rotating_model.like_pistons, gone=GONE, **how) -> None:
    """Assert that the orders to remove are gone and others as they were, in the time domain."""
    wanted = sorted({*design.remove, 3, 6})
    before = rotating_model.orders(design.engine, wanted, pistons, **how)
    after = rotating_model.orders(design.balanced, wanted, pistons, **how)
    for key in before:
        if key[0] in design.remove:
            assert rotating_model.largest([after[key]]) < gone, key
        else:
            gap = [(a - b, c - d) for (a, c), (b, d) in [(after[key], before[key])]]
            assert rotating_model.largest(gap) < gone, key


# Designs of catalogue engines and of layouts never seen ------------------------------------------


@pytest.mark.slow
@pytest.mark.parametrize("name", different_presets()[::5])  # the others' certificates: the next test
def test_a_preset_balanced_is_smooth_in_the_time_domain(name):
    layout = sb.load(name)
    design = sb.design_balance(layout, [1, 2, 4])
    assert design.is_complete
    if layout.has_common_harmonics:
        assert_ended(design)
    else:
        assert_ended(design, placed.planar, gone=1e-17, points=64)


@pytest.mark.spread(2)
@pytest.mark.parametrize("name", different_presets())
def test_as_many_shafts_as_signed_orders_and_no_fewer(name):
    layout = sb.load(name)
    before = sb.balance(layout, 4)
    terms = {*before.force.terms, *before.couple.terms}
    signed = {n for n in terms if abs(n) in (1, 2, 4)}
    design = sb.design_balance(layout, [1, 2, 4])
    assert len(design.shafts) == len(signed - {1}) == design.least_shafts
    bare = sb.design_balance(layout, [1, 2, 4], counterweights=False)
    assert bare.is_complete
    assert len(bare.shafts) == len(signed)
    if design.shafts:
        fewer = sb.design_balance(layout, [1, 2, 4], shafts=len(design.shafts) - 1)
        assert not fewer.is_complete
        assert len(fewer.shafts) == len(design.shafts) - 1


ANGLES = st.sampled_from(
    [Fraction(a) for a in (0, 30, 45, 60, 90, 120, 180, -90, -75)]
    + [Fraction(360 * k, d) for d in (5, 7, 11, 13) for k in (1, 2, 3)]
    + [Fraction("13.5"), Fraction("22.5")]
)
PLACES = st.tuples(ANGLES, ANGLES, st.fractions(-6, 6, max_denominator=4))


@st.composite
def layouts(draw: st.DrawFn, most: int = 24) -> sb.Engine:
    rows = draw(st.lists(PLACES, min_size=1, max_size=most))
    cylinders = [
        sb.Cylinder(i, throw, Angle(bank / 360).normalized(), station)
        for i, (throw, bank, station) in enumerate(rows, 1)
    ]
    ratio = draw(st.sampled_from([Fraction(4), Fraction("3.2"), Fraction(3, 2)]))
    strokes = draw(st.sampled_from([2, 4]))
    train = draw(st.sampled_from([None, SIZED]))
    return sb.engine.from_cylinders(cylinders, ratio=ratio, strokes=strokes, crank_train=train)


@pytest.mark.slow
@settings(max_examples=12, deadline=None)
@given(layouts(), st.sets(st.sampled_from([1, 2, 4, 6]), min_size=1), st.sampled_from(["ends", "even"]))
def test_any_layout_is_balanced_exactly(layout, remove, spread):
    stations = [6, "5/2", -3, -6] if spread == "even" else None
    design = sb.design_balance(layout, sorted(remove), spread=spread, stations=stations)
    assert design.is_complete
    with mp.workdps(30):
        assert_ended(design, gone=1e-28)


@pytest.mark.slow
def test_uneven_firing_and_two_strokes():
    for layout in (
        sb.vee("52", "1-2", firing_intervals=["412", "308"], ratio=4),
        sb.inline("1-3-2", strokes=2, ratio=4),
        sb.engine.from_firing_order(
            "1-2-3-4-5", banks=[-40, 0, 35], cylinders=[[1, 4], [2], [3, 5]], ratio="3.7", strokes=2
        ),
    ):
        design = sb.design_balance(layout, [1, 2, 4])
        assert design.is_complete
        assert_ended(design)


@pytest.mark.slow
@pytest.mark.parametrize("name", test_unlike.ENGINES)
def test_unlike_cylinders_are_balanced_to_their_digits(name):
    layout = test_unlike.ENGINES[name]()
    design = sb.design_balance(layout, [1, 2, 3])
    assert design.is_complete
    assert_ended(design, placed.planar, gone=1e-17, points=64)


@pytest.mark.slow
def test_hung_rods_with_rotating_masses():
    rows = [sb.Cylinder(1, rotating_mass=Fraction(2))]
    rows += [
        sb.Cylinder(i, 0, b, rod=Fraction(130), link=Link(1, b, Fraction(34)), rotating_mass=Fraction(0))
        for i, b in ((2, 120), (3, -120))
    ]
    train = CrankTrain(stroke=Fraction(90), rod=Fraction(164), reciprocating_mass=Fraction(1))
    design = sb.design_balance(sb.engine.from_cylinders(rows, crank_train=train), [1])
    assert design.is_complete
    assert_ended(design, placed.planar, gone=1e-17, points=64)


@pytest.mark.slow
def test_a_symbolic_bank_angle():
    twin = sb.vee(ALPHA, pins=[0])
    design = sb.design_balance(twin, [1, 2])
    assert design.is_complete
    assert [d.speed for d in design.devices] == [1, -1, 2, -2]
    for degrees in (45, 60, 90, 137):
        left = sb.vee(degrees, pins=[0], ratio=4)
        weights = [d.weights[0][1] for d in design.devices]
        built = left.balanced_by(
            *(
                sb.BalanceShaft(d.speed, [sb.engine.Weight(share=_at(w, Fraction(degrees)))])
                for d, w in zip(design.devices, weights, strict=True)
            )
        )
        found = rotating_model.orders(built, [1, 2])
        assert rotating_model.largest(found.values()) < GONE


def _at(number, degrees: Fraction):
    """Return a number in alpha at a value of it."""
    total = ZERO
    parts = number.parts if hasattr(number, "parts") else {(): number}
    for symbols, phasor in parts.items():
        turns = sum((f * degrees / 360 for _, f in symbols), Fraction(0))
        total = total + phasor.rotated(turns)
    return total


@pytest.mark.slow
def test_extremes():
    near = sb.inline("1-3-4-2", ratio="1.0001")
    design = sb.design_balance(near, [2, 4, 1000])
    assert design.is_complete
    assert len(design.shafts) == 6
    fast = sb.load("v12-60").balanced_by(sb.BalanceShaft(1000, [sb.engine.Weight(share=1)]))
    assert [o.order for o in sb.balance(fast, 1000).orders][-1] == 1000
    many = sb.inline(throws=[Fraction(360 * k, 13) for k in range(13)], ratio=4)
    assert sb.design_balance(many, list(range(1, 200))).is_complete


# Balancers in a balance ----------------------------------------------------------------------------


def test_nothing_changes_where_there_is_nothing():
    four = sb.load("inline-4")
    assert not four.balancers
    assert sb.to_json(sb.balance(four)) == sb.to_json(sb.balance(four.balanced_by()))
    assert "balancers" not in json.loads(sb.to_json(sb.balance(four)))


def test_half_and_half_ends_the_first_order_of_a_single():
    single = sb.inline("1", ratio=4)
    half = single.balanced_by(
        sb.Counterweight(throw=1, overbalance="1/2"),
        sb.BalanceShaft(-1, [sb.engine.Weight(share="1/2", phase=180)]),
    )
    assert [o.order for o in sb.balance(half, 4).orders] == [2, 4]
    wrong = single.balanced_by(
        sb.Counterweight(throw=1, overbalance="1/2"),
        sb.BalanceShaft(1, [sb.engine.Weight(share="1/2", phase=180)]),  # the wrong way round
    )
    assert 1 in [o.order for o in sb.balance(wrong, 4).orders]


@pytest.mark.slow
@pytest.mark.parametrize("unit", ["share", "kg mm"])
def test_every_way_to_give_a_weight_in_the_time_domain(unit):
    size = {"unbalance": Fraction(7)} if unit == "kg mm" else {"share": Fraction(1, 3)}
    layout = sb.inline("1-3-2", crank_train=SIZED).balanced_by(
        sb.Counterweight(throw=2, overbalance="2/3", angle=5),
        sb.Counterweight(35, "3/2", **size),
        sb.Counterweight(throw=3, share="1/7", angle=10),
        sb.BalanceShaft(
            2, [sb.engine.Weight(1, 20, **size), sb.engine.Weight(-1, 200, share=2)], phase=15
        ),
        sb.BalanceShaft(-4, [sb.engine.Weight("1/2", 70, **size)]),
        sb.BalanceShaft(-1, [sb.engine.Weight(0, 0, **size)]),
    )
    result = sb.balance(layout, 6)
    assert (result.kinematics is not None) == (unit == "share")
    found = rotating_model.orders(layout, [1, 2, 4, 6])
    with mp.workdps(40):
        for (n, kind), (cos, sin) in found.items():
            scale = (
                rotating_model.coefficient(n, layout.ratio)
                if (result.kinematics is not None) and n > 1
                else 1
            )
            for name, part in (("vertical", lambda z: z.real), ("lateral", lambda z: z.imag)):
                c, s = getattr(result, kind).component(n, name).decimal(40)
                assert abs(c * scale - part(cos)) < GONE
                assert abs(s * scale - part(sin)) < GONE


def test_webs_stand_a_quarter_pitch_from_their_pin():
    four = sb.load("inline-4")
    on_web = four.balanced_by(*(sb.Counterweight(web=w, share="1/8") for w in range(1, 9)))
    by_hand = four.balanced_by(
        *(
            sb.Counterweight(180 if c.throw.turns == 0 else 0, c.station + side, share="1/8")
            for c in four.cylinders
            for side in (Fraction(1, 4), Fraction(-1, 4))
        )
    )
    left, right = sb.balance(on_web, 1), sb.balance(by_hand, 1)
    assert all((left.couple.terms[n] - c).is_zero() for n, c in right.couple.terms.items())
    assert left.force.orders() == right.force.orders()


def test_functions_of_a_balanced_engine():
    layout = sb.inline("1-3-2", crank_train=SIZED).balanced_by(
        sb.Counterweight(throw=1, overbalance=1), sb.BalanceShaft(-2, [sb.engine.Weight(1, 30, share=3)])
    )
    for options in ({}, {"tolerance": 1e-9}):
        made = sb.to_function(
            sb.balance(layout, 24), outputs=("force.lateral", "couple.vertical"), **options
        )
        for theta in (0.1, 2.9):
            values = made(theta)
            with mp.workdps(30):
                force = rotating_model.engine(layout, False)(mp.mpf(theta))
                couple = rotating_model.engine(layout, True)(mp.mpf(theta))
            assert abs(values["force.lateral"] - float(force.imag)) < 1e-8
            assert abs(values["couple.vertical"] - float(couple.real)) < 1e-8


# Rotating parts ------------------------------------------------------------------------------------


WEIGHTS = st.lists(
    st.builds(
        sb.engine.Weight,
        st.fractions(-4, 4, max_denominator=4),
        st.integers(0, 23).map(lambda k: 15 * k),
        unbalance=st.fractions(1, 50, max_denominator=10),
    ),
    min_size=1,
    max_size=8,
)


@pytest.mark.slow
@given(WEIGHTS, st.sampled_from([["3", "-3"], ["7/2", "1", "-1/2"], ["4", "2", "0", "-2", "-4"]]))
@settings(max_examples=40, deadline=None)
def test_rotating_parts_balance_in_two_planes_and_more(weights, stations):
    for spread in ("ends", "even"):
        found = sb.design.balanced_weights(weights, stations, spread=spread)
        both = [*weights, *(sb.engine.Weight(c.station, unbalance=c.weight.vector) for c in found)]
        force, couple = sb.design.rotating_unbalance(both, "1/3")
        assert force.is_zero()
        assert couple.is_zero()
        total = mp.fsum(abs(rotating_model.size(c.weight.vector)) for c in found)
        if spread == "ends":
            least = total
        else:
            assert total > least * (1 - 1e-14)


@pytest.mark.slow
@given(WEIGHTS, st.sampled_from([["1"], ["3", "-3"], ["4", "2", "-4"]]))
@settings(max_examples=25, deadline=None)
def test_what_is_left_of_turning_weights_is_their_sum_in_decimals(weights, stations):
    """In one plane the couple stays; the sums are complex numbers of Python's."""
    found = sb.design.balanced_weights(weights, stations)

    def plain(vector):
        return complex(*map(float, sb.exact.Component(vector).decimal()))

    every = [(float(w.station), plain(w.vector)) for w in weights]
    every += [(float(c.station), plain(c.weight.vector)) for c in found]
    left = found.remains
    assert [plain(part) for part in left] == pytest.approx(
        [sum(v for _, v in every), sum(z * v for z, v in every)], abs=1e-9
    )
    assert left[0].is_zero()
    said = found.data()
    assert said["complete"] is (left[0].is_zero() and left[1].is_zero())
    assert said["complete"] or len(stations) == 1
    assert len(found) == len(said["counterweights"]) == len(list(found))
    assert (found.summary().endswith("no force and no couple left")) is said["complete"]
    row = next(line for line in sb.to_text(found).splitlines() if line.startswith("  couple "))
    assert row.endswith("proved 0") is said["complete"]


def test_an_ellipse_says_of_which_order_and_engine_it_is():
    drawn = sb.design.ellipse(sb.balance(sb.load("v10-72"), 1), 1, "couple")
    assert repr(drawn) == "Free couple of order 1 of v10-72: ellipse, with the crank"
    said = sb.to_text(drawn)
    assert "6.5186" in said
    assert "3.441" in said


@pytest.mark.slow
def test_the_records_of_an_ellipse_are_the_extremes_of_its_reach():
    """Found by trying directions, on an engine that is symmetric about no plane."""
    rows = [sb.Cylinder(1, 137, -45, 1), sb.Cylinder(2, 25, 30, "-1/2"), sb.Cylinder(3, 211, -20, 0)]
    drawn = sb.design.ellipse(sb.balance(sb.engine.from_cylinders(rows, ratio=4), 1))
    (row,) = drawn.records()
    reach = [float(drawn.reach(Fraction(k, 500))) for k in range(1571)]
    assert row["major"] == pytest.approx(max(reach), rel=1e-4)
    assert row["minor"] == pytest.approx(min(reach), rel=1e-4)
    longest = max(range(1571), key=reach.__getitem__) / 500
    apart = (math.radians(row["direction_deg"]) - longest + math.pi / 2) % math.pi - math.pi / 2
    assert apart == pytest.approx(0, abs=3e-3)
    assert abs(row["direction_deg"]) > 5


def test_ends_have_the_least_total_of_all_choices():
    """By brute force: from the ends, move weight in any way that keeps force and couple; none is less."""
    force, couple = Phasor.of(4, {0: 3, 1: 1}), Phasor.of(4, {0: -2, 1: 5})
    arms = [Fraction(2), Fraction(1), Fraction(-2)]
    ends = in_planes(force, couple, arms, length=Fraction(1))
    pull = {z: complex(rotating_model.size(w)) for z, w in ends}
    least = sum(map(abs, pull.values()))
    for i in range(-20, 21):
        for j in range(-20, 21):
            middle = complex(i, j) / 10
            front, rear = pull[2] - middle * 3 / 4, pull[-2] - middle / 4
            assert abs(front) + abs(middle) + abs(rear) >= least - 1e-12


@pytest.mark.slow
def test_the_cross_plane_crank_with_two_four_six_and_eight_counterweights():
    eight = sb.load("v8-90")
    for stations in (
        [2, -2],
        [2, 1, -1, -2],
        [2, 1, "1/2", "-1/2", -1, -2],
        [2, "7/4", 1, "1/2", "-1/2", -1, "-7/4", -2],
    ):
        design = sb.design_balance(eight, [1], stations=stations, spread="even")
        assert design.is_complete
        assert len(design.devices[0].weights) == len(stations)
        assert_ended(design)


def test_one_throw_is_sum_of_masses_times_radii():
    assert sb.design.throw_unbalance([("0.35", 40), ("0.42", 40), ("0.9", 12), ("1.3", -32)]) == 0


# Overbalance ---------------------------------------------------------------------------------------


UNBALANCED = [name for name in different_presets() if "[[counterweight]]" not in preset_text(name)]


@pytest.mark.spread(4)
@pytest.mark.parametrize("name", UNBALANCED)
def test_half_overbalance_leaves_a_circle_turning_against_the_crank(name):
    """Where axes are offset the pistons' first order is not m r/2 each way: the rest is still exact."""
    layout = sb.load(name)
    offset = any(c.offset for c in layout.cylinders)
    left = sb.balance(sb.design.overbalanced(layout), 1)
    assert offset or 1 not in {*left.force.terms, *left.couple.terms}
    for arms, found in ((False, left.force), (True, left.couple)) if offset else ():
        mean = layout.mean_station
        pulled = (
            (float(c.station - mean) if arms else 1) * placed.direction(c.throw) / 2
            for c in layout.cylinders
        )
        expected = placed.planar_series(layout, arms)[1] - sum(pulled)
        assert abs(complex(found.terms.get(1, ZERO).evaluated()) - expected) < 1e-12


@pytest.mark.slow
@pytest.mark.parametrize("share", [0, "1/4", "1/2", "2/3", 1])
@pytest.mark.parametrize("degrees", [0, 45, 52, 60, 90, 120])
def test_the_ellipse_is_what_the_engine_draws(share, degrees):
    layout = sb.design.overbalanced(sb.vee(degrees, pins=[0], ratio=4), share)
    drawn = sb.design.ellipse(sb.balance(layout, 1), 1)
    with mp.workdps(30):
        cos, sin = rotating_model.orders(layout, [1])[1, "force"]
        reach = [abs(cos * mp.cos(t) + sin * mp.sin(t)) for t in mp.linspace(0, mp.pi, 721)]
        assert abs(max(reach) - mp.mpf(sympy.N(drawn.major, 25))) < 1e-4
        assert abs(min(reach) - mp.mpf(sympy.N(drawn.minor, 25))) < 1e-4
        along = drawn.reach(mp.mpf(sympy.N(drawn.direction, 30)))
        assert abs(along - mp.mpf(sympy.N(drawn.major, 25))) < 1e-20


@pytest.mark.slow
@pytest.mark.parametrize("aim", ["squares", "largest"])
@pytest.mark.parametrize(("vertical", "lateral"), [(1, 1), (3, 1), (1, 2), (1, 0)])
def test_the_best_overbalance_is_the_least_of_all(aim, vertical, lateral):
    askew = sb.engine.from_cylinders([sb.Cylinder(1, 20, -30, 1), sb.Cylinder(2, 75, 40, -1)], ratio=4)
    for layout in (sb.inline("1", ratio=4), sb.vee(50, pins=[0], ratio=4), askew):
        best = sb.design.best_overbalance(layout, vertical=vertical, lateral=lateral, objective=aim)
        pistons = rotating_model.orders(layout, [1])[1, "force"]
        pins = mp.fsum(rotating_model.direction(c.throw) for c in layout.cylinders)
        here = _cost(pistons, mp.mpf(sympy.N(best, 20)) * pins, vertical, lateral, aim)
        for step in range(-60, 161, 2):
            other = _cost(pistons, mp.mpf(step) / 100 * pins, vertical, lateral, aim)
            assert other >= here - mp.mpf(10) ** -12, (layout.name, step)


def _cost(pistons, weight, vertical, lateral, aim):
    """Return what is left of the pistons' first order with counterweights -weight e^(i theta)."""
    cos, sin = pistons[0] - weight, pistons[1] - weight * 1j
    up, side = mp.hypot(cos.real, sin.real), mp.hypot(cos.imag, sin.imag)
    if aim == "squares":
        return vertical * up**2 + lateral * side**2
    return max(vertical * up, lateral * side)


def test_a_twin_of_any_bank_angle():
    twin = sb.vee(ALPHA, pins=[0])
    assert sb.design.best_overbalance(twin) == sympy.Rational(1, 2)
    assert sympy.expand(sb.design.best_overbalance(twin, lateral=0) - (1 + sympy.cos(ALPHA)) / 2) == 0
    left = sb.balance(sb.design.overbalanced(twin), 1)[1].force
    assert left.forward.is_zero()
    assert left.backward.amplitude == sympy.cos(ALPHA)


def test_a_share_and_one_less_it_exchange_vertical_and_lateral():
    twin = sb.vee(50, pins=[0])
    one, other = (sb.balance(sb.design.overbalanced(twin, k), 1)[1].force for k in ("65/100", "35/100"))
    assert one.vertical.decimal()[0] == pytest.approx(abs(other.lateral.decimal()[1]))
    assert abs(one.lateral.decimal()[1]) == pytest.approx(other.vertical.decimal()[0])


# Limits --------------------------------------------------------------------------------------------


def test_without_counter_rotation_half_is_left():
    design = sb.design_balance(sb.inline("1", ratio=4), [1, 2], counter_rotation=False)
    assert not design.is_complete
    assert [d.speed for d in design.devices] == [1, 2]
    for n in (1, 2):
        left = sb.design.ellipse(design.remains, n)
        assert (left.shape, left.major, left.sense) == ("circle", sympy.Rational(1, 2), -1)


@pytest.mark.slow
@pytest.mark.parametrize(("vertical", "lateral"), [(1, 1), (3, 1), (0, 1)])
@pytest.mark.parametrize("shafts", [0, 1, 2, 3])
def test_the_shafts_chosen_leave_the_least(shafts, vertical, lateral):
    """By brute force over all sets of signed orders, each order's part chosen from a grid."""
    from itertools import combinations

    from symbalance.design.balancing.design_limits import Weighting
    from symbalance.design.balancing.order_selection import order_residual, parts_of

    layout = sb.load("inline-5")
    weighting = Weighting(Fraction(vertical), Fraction(lateral))
    design = sb.design_balance(layout, [1, 2], shafts=shafts, vertical=vertical, lateral=lateral)
    before = design.before
    signed = [n for n in parts_of(before, [1, 2]) if n != 1]
    costs = [
        sum(order_residual(before, n, [1, *chosen], weighting) for n in (1, 2))
        for chosen in combinations(signed, min(shafts, len(signed)))
    ]
    assert abs(_left(design, vertical, lateral) - min(costs)) < 1e-13
    assert len(design.shafts) <= shafts


def _left(design, vertical, lateral):
    """Return what the balanced engine leaves of the orders to remove, in the time domain."""
    total = mp.mpf(0)
    for (n, _), (cos, sin) in rotating_model.orders(design.balanced, list(design.remove)).items():
        assert n in design.remove
        total += vertical * (cos.real**2 + sin.real**2) + lateral * (cos.imag**2 + sin.imag**2)
    return total


def test_one_plane_where_two_are_wanted_misses_least():
    three = sb.inline("1-3-2", ratio=4)
    design = sb.design_balance(three, [1], stations=["1/2"], shafts=0, length=2)
    station, weight = design.devices[0].weights[0]
    assert station == Fraction(1, 2)
    force, couple = (b.terms.get(1, ZERO) for b in (design.remains.force, design.remains.couple))

    def cost(change):
        moved = rotating_model.size(force) + change, rotating_model.size(couple) + change / 2
        return abs(moved[0]) ** 2 + abs(moved[1]) ** 2 / 4

    for step in (0.01, -0.01, 0.01j, -0.01j):
        assert cost(mp.mpc(step)) > cost(mp.mpc(0))
    assert not weight.is_zero()


def test_a_shaft_goes_where_its_one_place_lets_it_help():
    """A couple alone cannot be had from the middle: the shaft serves a smaller order with a force."""
    odd = sb.engine.from_cylinders([sb.Cylinder(1, 0, 0, 9), sb.Cylinder(2, 180, 0, -9)], ratio=4)
    design = sb.design_balance(odd, [1, 2], stations=[0], shafts=1)
    assert [d.speed for d in design.devices] in ([2], [-2])
    assert sb.design_balance(odd, [1], stations=[0]).devices == ()
    assert [d.speed for d in sb.design_balance(odd, [1, 2], shafts=1).devices] == [1, -1]


@pytest.mark.slow
def test_no_weight_is_larger_than_it_may_be():
    layout = sb.inline("1-3-2", crank_train=SIZED)
    free = sb.design_balance(layout, [1])
    sizes = [free.unbalance(d, w) for d in free.devices for _, w in d.weights]
    tight = sb.design_balance(layout, [1], most="5")
    limited = [tight.unbalance(d, w) for d in tight.devices for _, w in d.weights]
    assert max(sizes) > 5
    assert max(limited) <= 5
    assert max(limited) > 5 - 1e-6
    assert not tight.is_complete
    wide = sb.design_balance(layout, [1], most="7", stations=[1, "1/2", "-1/2", -1])
    assert max(wide.unbalance(d, w) for d in wide.devices for _, w in d.weights) <= 7
    assert wide.is_complete  # shared out over four planes
    assert rotating_model.largest(rotating_model.orders(wide.balanced, [1]).values()) < 1e-25


def test_bounded_weights_that_must_lean_are_exact_too():
    """A force off the middle, so that the weights of least squares pass the bound and others do not."""
    places = [Fraction(z) for z in (2, 1, 0, -1)]
    force, couple = Phasor.of(1, {0: 10}), Phasor.of(1, {0: Fraction("10.6")})
    found = bounded_vectors(force, couple, places, Fraction("3.5"), Fraction(1))
    assert max(w.size() for _, w in found) <= 3.5
    assert (force - total(w for _, w in found)).is_zero()
    assert (couple - total(w.scaled(z) for z, w in found)).is_zero()
    even = in_planes(force, couple, places, spread="even", length=Fraction(1))
    assert max(w.size() for _, w in even) > 3.5


@pytest.mark.slow
def test_bounded_weights_of_both_parts_help_each_other():
    """Forward 1 and backward 1/2, weights up to 0.6: upright the backward one makes up for 0.1 of 0.4."""
    twin = sb.vee(60, pins=[0], crank_train=SIZED)
    for lateral, upright in ((0, 0.3), (1, 0.4)):
        design = sb.design_balance(twin, [1], lateral=lateral, most="12.9", stations=[0])
        cos, sin = rotating_model.orders(design.balanced, [1])[1, "force"]
        assert float(mp.hypot(cos.real, sin.real)) == pytest.approx(upright, abs=1e-8)
        for device, part in zip(design.devices, (1, -1), strict=True):
            before, after = (b.force.terms.get(part, ZERO) for b in (design.before, design.remains))
            assert (before + device.force - after).is_zero()


@pytest.mark.slow
def test_a_design_prints_like_a_balance(golden):
    design = sb.design_balance(sb.vee(ALPHA, pins=[0], ratio=4), [1])
    golden("design-vee-of-any-angle.txt", sb.to_text(design))
    assert json.loads(sb.to_json(design))["complete"] is True
    assert "Certificate" in sb.to_latex(design)
    assert "documentclass" in sb.to_latex(design, standalone=True)


@pytest.mark.parametrize("order", [0, 3, -1, "a", None])
def test_an_ellipse_that_was_not_asked_for_is_not_nothing(order):
    with pytest.raises(sb.SymbalanceError, match="order"):
        sb.design.ellipse(sb.balance(sb.inline("1"), 2), order)


def test_bounded_weights_take_the_fewest_planes():
    four = sb.inline("1-3-4-2", crank_train=SIZED)
    for most, count in (("3.4", 1), ("1.7", 2), ("1.2", 3), ("0.9", 4)):
        design = sb.design_balance(four, [2], stations=["3/2", "1/2", 0, "-1/2", "-3/2"], most=most)
        shafts = [[design.unbalance(d, w) for _, w in d.weights] for d in design.shafts]
        assert design.is_complete
        assert all(max(sizes) <= float(most) for sizes in shafts)
        assert {len(sizes) for sizes in shafts} == {count}


# The roll moment -------------------------------------------------------------------------------------


def test_roll_moment_of_shafts_in_the_time_domain():
    layout = sb.inline("1-3-4-2", crank_train=SIZED).balanced_by(
        sb.BalanceShaft(2, [sb.engine.Weight(share=2, phase=25)], x=-40, y=90),
        sb.BalanceShaft(-2, [sb.engine.Weight(share="1/2", phase=70)], x=55, y=-30, phase=10),
        sb.BalanceShaft(-1, [sb.engine.Weight(unbalance=4)], x=20),
    )
    exact = sb.forces.shaft_moment(layout)
    radius = rotating_model.number(SIZED.stroke) / 2
    axes = [(s.x, s.y) for s in layout.balancers.shafts]
    with mp.workdps(30):
        for theta in (mp.mpf("0.4"), mp.mpf("2.2")):
            moment = mp.mpf(0)
            for (speed, pull, _), (x, y) in zip(rotating_model.turning(layout), axes, strict=True):
                force = pull * mp.expj(speed * theta)
                moment += (y * force.imag - x * force.real) / radius
            total = mp.mpf(0)
            for n, part in exact.items():
                cos, sin = part.decimal(30)
                scale = rotating_model.coefficient(n, layout.ratio) if n > 1 else 1
                total += scale * (cos * mp.cos(n * theta) + sin * mp.sin(n * theta))
            assert abs(total - moment) < 1e-25


def test_tables_have_the_roll_moment():
    pair = [sb.BalanceShaft(s, [sb.engine.Weight(share=-2)], y=y) for s, y in ((2, 70), (-2, -70))]
    result = sb.balance(sb.inline("1-3-4-2", crank_train=SIZED).balanced_by(*pair), 4)
    assert "Roll moment of the shafts" in sb.to_text(result)
    assert "Roll moment of the shafts" in sb.to_latex(result)
    roll = json.loads(sb.to_json(result))["roll"]
    assert [(r["order"], r["cos"], r["sin"]) for r in roll] == [("2", "0", "-280/43")]
    assert "roll" not in json.loads(sb.to_json(sb.balance(sb.load("inline-4"))))


def test_one_rod_length_between_the_shafts_ends_the_second_roll_moment():
    """Silent shafts: to leading order h = l; exactly, h = -2 t_2 r/A_2."""
    four = sb.inline("1-3-4-2", crank_train=SIZED)
    pair = [
        sb.BalanceShaft(s, [sb.engine.Weight(share=-2)], y=y) for s, y in ((2, "143/2"), (-2, "-143/2"))
    ]
    built = four.balanced_by(*pair)
    assert 2 not in sb.balance(built, 2).force.orders()
    before = abs(sb.torque.roll_moment(four, 2)[2].torque.sin)
    after = abs(sb.torque.roll_moment(built, 2)[2].torque.sin)
    assert before == pytest.approx(2, abs=0.01)
    assert after < 0.03 * before
    the_other_way = four.balanced_by(*(sb.BalanceShaft(-s.speed, s.weights, y=s.y) for s in pair))
    assert abs(sb.torque.roll_moment(the_other_way, 2)[2].torque.sin) > 1.9 * before


def test_every_roll_moment_has_the_shafts():
    """What is printed, emitted and evaluated in SI is the pistons' moment and the shafts' together."""
    four = sb.inline("1-3-4-2", crank_train=SIZED)
    pair = [sb.BalanceShaft(s, [sb.engine.Weight(share=-2)], y=y) for s, y in ((2, 40), (-2, -30))]
    built = four.balanced_by(*pair)
    alone, whole = sb.torque.torque_report(four, 4), sb.torque.torque_report(built, 4)
    assert alone.is_opposite
    assert not whole.is_opposite
    assert whole.frame is not None
    assert "all inertia and balance shafts" in " ".join(sb.to_text(whole).split())
    trace = sb.torque.ideal_cycle(10, heat=20).trace(4)
    given = {"bore": 80, "stroke": 86, "reciprocating_mass": "1/2", "rpm": 3000}
    given["ratio"] = Fraction(143, 43)
    running = [sb.running_torque(layout, trace, **given) for layout in (four, built)]
    scale = 0.5 * 0.043**2 * running[0].omega ** 2
    for theta in (0.3, 1.9):
        moved = running[1].frame(theta) - running[0].frame(theta)
        unit = rotating_model.coefficient(2, four.ratio)
        # two weights of 2 F_2 each, 40 above and 30 below: y l, l = -2 sin 2 theta and +2 sin 2 theta
        expected = unit * (40 * -2 + -30 * 2) / 43 * mp.sin(2 * theta) * scale
        assert moved == pytest.approx(float(expected), rel=1e-12)


# Published figures -----------------------------------------------------------------------------------


def test_lanchester_shafts_of_an_inline_four():
    """m r^2/(2 l) a shaft, as 2 U (2 omega)^2 = 4 m r omega^2 r/l, and what all powers of r/l add."""
    four = sb.inline("1-3-4-2", crank_train=SIZED)
    design = sb.design_balance(four, [1, 2])
    sizes = [design.unbalance(d, d.weights[0][1]) for d in design.devices]
    book = 0.5 * 43 * 43 / (2 * 143)
    rho = 43 / 143
    assert [d.speed for d in design.devices] == [2, -2]
    assert float(sizes[0]) == pytest.approx(book * (1 + rho**2 / 4 + 15 * rho**4 / 128), rel=1e-3)
    assert float(sizes[0]) == pytest.approx(book, rel=0.03)
    assert all(w.in_kg_mm is False for s in design.balanced.balancers.shafts for w in s.weights)


def test_textbook_single_three_and_vees():
    single = sb.design_balance(sb.load("inline-1"), [1])
    shares = [abs(d.weights[0][1].rational()) for d in single.devices]
    assert shares == [Fraction(1, 2), Fraction(1, 2)]  # seed 002, section 5: half and half
    three = sb.design_balance(sb.load("inline-3"), [1])  # couple sqrt(3) m r a: half each way
    assert [len(d.weights) for d in three.devices] == [2, 2]
    assert not three.devices[0].force.terms
    twin = sb.design_balance(sb.load("v2-90"), [1])
    weight = twin.devices[0].weights[0][1]
    assert len(twin.devices) == 1
    assert (
        weight.times(weight.conjugate())
    ).rational() == 1  # the mass of one piston at the crank radius
    six_90 = sb.design_balance(sb.load("v6-90"), [1])
    assert [d.on_crank for d in six_90.devices] == [True]
    six_60 = sb.design_balance(sb.load("v6-60"), [1])
    assert [d.on_crank for d in six_60.devices] == [True]
    eight = sb.design_balance(sb.load("v8-90"), [1, 2])
    assert [d.on_crank for d in eight.devices] == [True]


def test_the_least_largest_of_an_engine_askew_is_found_at_once():
    """Throws of whole degrees lie in a field of degree 96: no equation there is left to SymPy."""
    rows = [sb.Cylinder(1, 137, -45, 1), sb.Cylinder(2, 25, 30, "-1/2"), sb.Cylinder(3, 211, -20, 0)]
    layout = sb.engine.from_cylinders(rows, ratio=4)
    parts = first_order(layout)
    for vertical, lateral in ((3, 1), (1, 1), (1, 3), (1, 0), (0, 1)):
        aim = {"vertical": vertical, "lateral": lateral, "objective": "largest"}
        best = Fraction(float(sb.design.best_overbalance(layout, **aim)))

        def left(k, v=vertical, side=lateral):
            up, across = amplitudes(parts, k)
            return max(v * up, side * across)

        least = min(left(best + Fraction(step, 50)) for step in (-50, -5, -1, 1, 5, 50))
        assert left(best) <= least + 1e-12


def test_a_best_forward_part_of_what_is_no_part_is_refused():
    for wrong in (sb.load("v2-90"), None, 3):
        with pytest.raises(sb.SymbalanceError, match=r"backward = .*must be a part of an order"):
            sb.design.best_forward(wrong)  # pyright: ignore[reportArgumentType]
