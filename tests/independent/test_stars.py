"""Evidence: firing orders, crank stars and bank angles against brute force and against engines built.

The brute force shares nothing with the package: floats, `cmath` sums, all permutations, Burnside's count.
"""

from __future__ import annotations

import cmath
import math
from collections import Counter
from fractions import Fraction
from itertools import permutations, product

import hypothesis.strategies as st
import pytest
from hypothesis import given, settings

from symbalance.engine.builders import boxer, from_firing_order, inline, radial, vee
from symbalance.engine.catalogue import load
from symbalance.engine.cylinders import Cylinder
from symbalance.engine.engine import Engine
from symbalance.engine.stars import (
    Firing,
    crank_stars,
    even_interval,
    evenest,
    fewest_cylinders,
    firing_orders,
    intervals,
    is_even,
    known_firing,
    natural_bank_angles,
    pin_offsets,
)
from symbalance.errors import SymbalanceError
from symbalance.forces.free_forces import balance
from tests.different_presets import different_presets

LAWS = settings(deadline=None, max_examples=60, derandomize=True, database=None)


def texts(layout: Engine, **asked: bool) -> list[str]:
    return [firing.as_text() for firing in firing_orders(layout, **asked)]


# Firing orders ------------------------------------------------------------------------------------


def fired_by_force(ahead: dict[int, int], strokes: int) -> set[tuple[tuple[int, ...], tuple[int, ...]]]:
    """Try every turn for every cylinder; `ahead` is throw - bank in whole degrees."""
    first, cycle, found = min(ahead), 180 * strokes, set()
    for turns in product(range(strokes // 2), repeat=len(ahead)):
        moments = {
            n: ((ahead[first] - own) % 360 + 360 * turn, n)
            for (n, own), turn in zip(ahead.items(), turns, strict=True)
        }
        if moments[first][0] or len({at for at, _ in moments.values()}) < len(ahead):
            continue
        ordered = sorted(moments.values())
        ends = [at for at, _ in ordered[1:]] + [cycle]
        gaps = tuple(end - at for (at, _), end in zip(ordered, ends, strict=True))
        found.add((tuple(n for _, n in ordered), gaps))
    return found


def engines():
    angles = st.integers(0, 11).map(lambda k: 30 * k)
    banks = st.sampled_from([-90, -45, 0, 30, 60])
    return st.tuples(st.lists(st.tuples(angles, banks), min_size=1, max_size=7), st.sampled_from([2, 4]))


@pytest.mark.slow
@LAWS
@given(engines())
def test_firing_orders_are_what_trying_every_turn_finds(engine):
    pairs, strokes = engine
    cylinders = [Cylinder(i, throw, bank) for i, (throw, bank) in enumerate(pairs, 1)]
    layout = Engine(cylinders, strokes=strokes)
    expected = fired_by_force({i: t - b for i, (t, b) in enumerate(pairs, 1)}, strokes)
    found = firing_orders(layout, even_only=False)
    assert {(f.order, f.intervals) for f in found} == expected
    assert len(found) == len(expected)
    even = [f for f in found if len(set(f.intervals)) == 1]
    assert firing_orders(layout) == even
    assert [f for f in found if f.is_even] == even
    squares = [sum(gap**2 for gap in f.intervals) for f in found]
    assert evenest(layout) == [f for f, q in zip(found, squares, strict=True) if q == min(squares)]


@pytest.mark.slow
@LAWS
@given(st.permutations(range(2, 7)), st.lists(st.integers(1, 9), min_size=6, max_size=6))
def test_every_firing_order_belongs_to_the_crank_built_from_it(rest, weights):
    order, shares = [1, *rest], [Fraction(720 * w, sum(weights)) for w in weights]
    banks = {"banks": [-30, 45], "cylinders": [[1, 2, 3], [4, 5, 6]]}
    layout = from_firing_order(order, firing_intervals=shares, **banks)
    assert known_firing(layout) == Firing(tuple(order), tuple(shares))
    allowed = firing_orders(layout, even_only=False)
    assert known_firing(layout) in allowed
    throws = [c.throw for c in layout.cylinders]
    for firing in allowed:
        again = from_firing_order(firing.order, firing_intervals=firing.intervals, **banks)
        assert [c.throw for c in again.cylinders] == throws


def test_firing_orders_of_engines_everyone_knows():
    assert texts(inline(throws=[0, 180, 180, 0])) == ["1-2-4-3", "1-3-4-2"]
    six = {"1-5-3-6-2-4", "1-2-3-6-5-4", "1-5-4-6-2-3", "1-2-4-6-5-3"}
    assert set(texts(inline(throws=[0, 240, 120, 120, 240, 0]))) == six
    assert texts(inline(throws=[0, 216, 144, 72, 288])) == ["1-2-4-5-3"]
    assert texts(inline(throws=[0, 240, 120], strokes=2)) == ["1-2-3"]
    assert texts(inline(throws=[0, 0])) == ["1-2"]
    assert texts(inline(throws=[0, 180])) == []
    assert texts(inline(throws=[0, 180]), even_only=False) == ["1-2", "1-2"]
    assert texts(radial(7)) == ["1-3-5-7-2-4-6"]


def test_the_cross_plane_v8_has_eight_and_shares_them_with_its_two_makers():
    """One of each pair that tops together may fire first: 5 with 8, 4 with 7, 3 with 2, 1 before 6."""
    expected = set()
    for swaps in product([False, True], repeat=3):
        order = "1-8-4-3-6-5-7-2"
        for swap, pair in zip(swaps, ("58", "47", "23"), strict=True):
            order = order.translate(str.maketrans(pair, pair[::-1])) if swap else order
        expected.add(order)
    found = set(texts(load("v8-90")))
    assert found == expected
    assert {"1-8-4-3-6-5-7-2", "1-8-7-2-6-5-4-3"} <= found  # Chevrolet small-block and LS
    numbered = vee(90, pins=[0, 90, 270, 180])  # odd numbers on the left, seen from the front
    by_force = fired_by_force({c.number: int(c.delay.in_degrees()) for c in numbered.cylinders}, 4)
    assert set(texts(numbered)) == {
        "-".join(map(str, order)) for order, gaps in by_force if set(gaps) == {90}
    }
    assert len(texts(numbered)) == 8


@pytest.mark.slow
@pytest.mark.parametrize("name", different_presets()[::3])
def test_catalogue_engines_fire_as_their_cranks_allow(name):
    layout = load(name)
    if layout.firing_order() is None:
        return
    known = known_firing(layout)
    assert list(known.order) == layout.firing_order()
    assert intervals(layout) == known.intervals
    assert sum(known.intervals) == 180 * layout.strokes
    if layout.has_common_harmonics:
        assert known in firing_orders(layout, even_only=is_even(layout))
    else:  # pins and link rods as built: nearly even
        near = [firing.order for firing in firing_orders(layout, within=8)]
        assert known.order in near


def test_cylinder_1_leads_wherever_its_firing_is_counted_from():
    cylinders = [Cylinder(1, 90, fires=270), Cylinder(2, 0, fires=0), Cylinder(5, 180, fires=540)]
    known = known_firing(Engine(cylinders))
    assert known == Firing((1, 5, 2), (Fraction(270), Fraction(180), Fraction(270)))
    assert known in firing_orders(Engine(cylinders), even_only=False)
    assert known.overlap() == -90
    assert known.overlap(300) == 30


def test_boxers():
    four = firing_orders(boxer("1-3-2-4"))
    assert [f.as_text() for f in four] == ["1-3-2-4", "1-4-2-3"]  # pairs 1-2 and 3-4 in phase: Subaru
    assert texts(boxer("1-4-3-2")) == ["1-2-3-4", "1-4-3-2"]  # Volkswagen's numbering
    assert len(texts(boxer("1-6-2-4-3-5"))) == 4


def test_cylinders_that_fire_together():
    twin = inline(throws=[0, 0])
    both = firing_orders(twin, even_only=False, simultaneous=True)
    assert [f.intervals for f in both] == [(0, 720), (360, 360)]
    assert [f.is_even for f in both] == [True, True]
    flat = inline(throws=[0, 180, 180, 0])
    assert len(firing_orders(flat, simultaneous=True, even_only=False)) == 8
    together = [f for f in firing_orders(flat, simultaneous=True) if 0 in f.intervals]
    assert together == []  # pairs 180 apart leave 540 degrees idle
    pairs = firing_orders(inline(throws=[0, 0, 0, 0]), simultaneous=True)
    assert [(f.as_text(), f.intervals) for f in pairs] == [
        ("1-2-3-4", (0, 0, 0, 720)),
        ("1-2-3-4", (0, 360, 0, 360)),
        ("1-3-2-4", (0, 360, 0, 360)),
        ("1-4-2-3", (0, 360, 0, 360)),
    ]
    uneven = Firing((1, 2, 3, 4), (Fraction(0), Fraction(240), Fraction(240), Fraction(240)))
    assert not uneven.is_even


# Bank angles --------------------------------------------------------------------------------------


def v6_at_90() -> Engine:
    return vee(90, pins=[0, 120, 240])


def test_a_v6_at_90_degrees_on_shared_pins_fires_90_150():
    orders = firing_orders(v6_at_90(), even_only=False)
    assert len(orders) == 32
    assert not any(f.is_even for f in orders)
    assert min(max(f.intervals) for f in orders) == 150
    by_turns = [
        f
        for f in orders
        if max(f.intervals) == 150
        and all((a + b) % 2 for a, b in zip(f.order, f.order[1:], strict=False))
    ]
    assert [(f.as_text(), f.intervals) for f in by_turns] == [("1-2-3-4-5-6", (90, 150) * 3)]


def evenly_by_force(pins: tuple[int, ...], beta: int, splay: int, strokes: int) -> bool:
    """Count top dead centres on 360 degrees: as many at each of the evenly spaced places."""
    tops = Counter([-p % 360 for p in pins] + [(beta - p - splay) % 360 for p in pins])
    places = sorted(tops)
    step = 360 * strokes // 2 // (2 * len(pins))
    spaced = all((place - places[0]) % step == 0 for place in places)
    return spaced and set(tops.values()) == {strokes // 2}


@pytest.mark.slow
@pytest.mark.parametrize(
    ("count", "strokes"), [(2, 4), (4, 4), (6, 4), (8, 4), (2, 2), (4, 2), (6, 2), (8, 2)]
)
def test_natural_angles_of_any_crank(count, strokes):
    step = 180 * strokes // count
    grid = range(0, 360, step)
    cranks = [(0, *rest) for rest in product(grid, repeat=count // 2 - 1)]
    found = [b for b in range(1, 181) if any(evenly_by_force(c, b, 0, strokes) for c in cranks)]
    assert list(natural_bank_angles(count, strokes)) == found


@pytest.mark.spread(2)
@pytest.mark.parametrize(
    "pins", [(0,), (0, 180), (0, 0), (0, 120, 240), (0, 90, 270, 180), (0, 180, 180, 0), (0, 60, 240)]
)
@pytest.mark.parametrize("strokes", [2, 4])
def test_angles_and_offsets_of_one_crank(pins, strokes):
    angles = [b for b in range(1, 181) if evenly_by_force(pins, b, 0, strokes)]
    assert list(natural_bank_angles(pins, strokes)) == angles
    for beta in (0, 15, 60, 90, 180):
        splays = [s for s in range(-179, 181) if evenly_by_force(pins, beta, s, strokes)]
        assert sorted(pin_offsets(pins, beta, strokes)) == splays
        for splay in splays:
            assert firing_orders(vee(beta, pins=pins, splay=splay, strokes=strokes))


def test_bank_angles_engines_are_built_with():
    assert [natural_bank_angles(n)[0] for n in (6, 8, 10, 12, 16)] == [120, 90, 72, 60, 45]
    assert natural_bank_angles(2) == ()
    assert natural_bank_angles([0, 90, 270, 180]) == (90, 180)  # cross-plane V8
    assert natural_bank_angles([0, 120, 240, 240, 120, 0]) == (60, 180)  # V12
    assert [pin_offsets(6, b)[0] for b in (120, 90, 60)] == [0, -30, -60]
    assert abs(pin_offsets(10, 90)[0]) == 18
    assert pin_offsets(8, 90)[0] == 0
    assert texts(vee(90, pins=[0, 120, 240], splay=-30)) == texts(vee(120, pins=[0, 120, 240]))
    splayed = load("v6-90-splayed")
    throws = {c.number: c.throw.in_degrees() for c in splayed.cylinders}
    assert is_even(splayed)
    assert {abs((throws[a] - throws[a + 1] + 180) % 360 - 180) for a in (1, 3, 5)} == {30}


def test_intervals_and_overlaps():
    table = {2: 360, 3: 240, 4: 180, 5: 144, 6: 120, 8: 90, 10: 72, 12: 60}
    assert {n: even_interval(n) for n in table} == table
    assert even_interval(3, 2) == 120
    overlaps = [firing_orders(crank_stars(n)[0].engine)[0].overlap() for n in (3, 4, 5, 6)]
    assert overlaps == [-60, 0, 36, 60]
    assert (fewest_cylinders(), fewest_cylinders("144"), fewest_cylinders(strokes=2)) == (5, 6, 3)


# Crank stars --------------------------------------------------------------------------------------

SIZES = [(n, 4) for n in range(1, 9)] + [(n, 2) for n in range(1, 8)]


def burnside(count: int, rays: int) -> int:
    """Count the classes as the mean number of stars a symmetry leaves as they are."""
    stars = set(permutations(list(range(rays)) * (count // rays)))
    fixed = 0
    for turn, sign, behind in product(range(rays), (1, -1), (False, True)):
        for star in stars:
            image = tuple((sign * ray + turn) % rays for ray in star)
            fixed += star == (image[::-1] if behind else image)
    assert fixed % (4 * rays) == 0
    return fixed // (4 * rays)


@pytest.mark.spread(2)
@pytest.mark.parametrize(("count", "strokes"), [size for size in SIZES if size[0] < 8])
def test_as_many_classes_as_burnside_counts(count, strokes):
    classes = crank_stars(count, strokes)
    rays = count // 2 if strokes == 4 and count % 2 == 0 else count
    assert len(classes) == burnside(count, rays)
    stars = math.factorial(count) // math.factorial(count // rays) ** rays // rays
    assert sum(c.stars for c in classes) == stars


def test_sizes_of_the_larger_lists():
    lengths = {(n, s): len(crank_stars(n, s)) for n, s in ((7, 4), (8, 4), (8, 2))}
    assert lengths == {(7, 4): 192, (8, 4): 183, (8, 2): 1320}
    assert sum(c.stars for c in crank_stars(8)) == 2520 // 4


@pytest.mark.slow
@pytest.mark.parametrize(("count", "strokes"), SIZES)
def test_couples_are_plain_sums_in_order(count, strokes):
    before = (-1.0, -1.0)
    for found in crank_stars(count, strokes)[:60]:
        sums = []
        for order, exact in ((1, found.first_couple), (2, found.second_couple)):
            turns = (cmath.exp(1j * order * math.radians(t)) for t in found.throws)
            plain = abs(sum(((count - 1) / 2 - j) * turn for j, turn in enumerate(turns)))
            assert math.isclose(float(exact), plain, abs_tol=1e-9)
            sums.append(round(plain, 9))
        assert before <= tuple(sums)
        before = (sums[0], sums[1])


@pytest.mark.slow
def test_couples_are_those_of_the_balance():
    for found in (*crank_stars(5), *crank_stars(6), *crank_stars(7)[::60]):
        left = balance(found.engine, order=2).couple
        for order, amplitude in ((1, found.first_couple), (2, found.second_couple)):
            assert left.component(order, "vertical").amplitude == amplitude


def test_the_in_line_five():
    from sympy import sqrt

    classes = crank_stars(5)
    assert [c.stars for c in classes] == [2, 4, 2, 4, 4, 2, 4, 2]
    for found, k in zip(classes, (-11, -9, -5, -1, 1, 5, 9, 11), strict=True):
        assert (found.first_couple**2 - (25 + k * sqrt(5)) / 2).expand() == 0
        assert (found.second_couple**2 - (25 - k * sqrt(5)) / 2).expand() == 0
        assert len(found.firings) == 1
    assert [f.as_text() for f in classes[0].firings] == ["1-2-4-5-3"]


def test_the_smoothest_are_those_that_are_built():
    assert crank_stars(4)[0].throws == (0, 180, 180, 0)
    assert crank_stars(6)[0].throws == (0, 240, 120, 120, 240, 0)
    assert [(c.first_couple, c.second_couple) for c in crank_stars(4)] == [(0, 0), (2, 0), (4, 0)]
    assert crank_stars(8)[0].first_couple == 0
    orders = [len(c.firings) for c in (*crank_stars(6), *crank_stars(8)[:5])]
    assert orders == [4] * 11 + [8] * 5


# Refused ------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("make", "says"),
    [
        (lambda: firing_orders("v8"), "engine = v8: must be an Engine"),  # pyright: ignore
        (lambda: firing_orders(radial(18), even_only=False), "131072 firing orders"),
        (lambda: firing_orders(inline(throws=[0] * 999), simultaneous=True, even_only=False), "too many"),
        (lambda: known_firing(radial(4)), "cylinder 1 of engine: has no firing angle"),
        (lambda: intervals(inline(throws=[0, 180])), "firing_orders(engine)"),
        (lambda: is_even(None), "must be an Engine"),  # pyright: ignore
        (lambda: crank_stars(11), "count = 11: makes more than 50000 stars"),
        (lambda: crank_stars(10, strokes=2), "makes more than 50000"),
        (lambda: crank_stars(1000), "makes more than 50000"),
        (lambda: crank_stars(0), "from 1 to"),
        (lambda: crank_stars(True), "from 1 to"),
        (lambda: crank_stars(4, strokes=3), "strokes = 3"),
        (lambda: even_interval("4"), "count = '4'"),  # pyright: ignore
        (lambda: fewest_cylinders(0), "push = 0: must lie in (0, 180]"),
        (lambda: fewest_cylinders(181), "push = 181"),
        (lambda: fewest_cylinders("1/1000"), "from 1 to 1000"),
        (lambda: natural_bank_angles(5), "must be an even number"),
        (lambda: natural_bank_angles("6"), "crank = '6'"),  # pyright: ignore
        (lambda: natural_bank_angles([]), "crank of 0 pins"),
        (lambda: natural_bank_angles([0, "x"]), "crank[2] = x"),
        (lambda: pin_offsets(6, 200), "bank_angle = 200"),
        (lambda: pin_offsets(6, "nan"), "bank_angle = nan"),
        (lambda: Firing((1, 2), (Fraction(0), Fraction(0))), "not all 0"),
        (lambda: Firing((1, 2), (Fraction(720),)), "must be 2 degrees"),
    ],
)
def test_refusals(make, says):
    with pytest.raises(SymbalanceError) as caught:
        make()
    assert says in str(caught.value)
    assert len(str(caught.value).splitlines()) == 1


def test_a_symbolic_angle_between_cylinders_is_refused_and_one_they_share_is_not():
    import sympy

    alpha = sympy.Symbol("alpha")
    with pytest.raises(SymbalanceError, match="symbolic angle"):
        firing_orders(vee(alpha, pins=[0, 120, 240]))
    shared = Engine([Cylinder(1, 0, alpha), Cylinder(2, 0, alpha)])
    assert texts(shared) == ["1-2"]
    assert texts(vee(alpha, "1-2")) == ["1-2"]
