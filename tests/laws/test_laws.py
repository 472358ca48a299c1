"""Evidence: laws that hold for every number, angle and engine, on examples that hypothesis draws.

The field laws of phasors (against complex floats), the radicals against their own decimals, and
how free forces and couples answer when an engine is turned, shifted, reversed, delayed, mirrored
or joined.
"""

from __future__ import annotations

import cmath
import math
import subprocess
import sys
import time
from collections.abc import Callable
from fractions import Fraction
from random import Random

import hypothesis.strategies as st
import pytest
import sympy
from hypothesis import assume, given, settings
from mpmath import mp

from symbalance.codegen import to_function
from symbalance.document.result import to_json, to_latex, to_text
from symbalance.engine.builders import from_firing_order, inline, vee
from symbalance.engine.catalogue import load
from symbalance.engine.cylinders import Cylinder
from symbalance.engine.engine import Engine
from symbalance.exact.angles import Angle, angle, degrees
from symbalance.exact.phasor import ONE, Phasor
from symbalance.exact.radicals import (
    ClosedForm,
    exact_form,
    radical_form,
    square_root_form,
    trigonometric_form,
)
from symbalance.exact.spectrum import COMPONENTS, Spectrum
from symbalance.forces.balance_data import balance_data
from symbalance.forces.free_forces import balance
from symbalance.kinematics.derivation import derive
from symbalance.kinematics.derivation.remainder_step import printed_error
from symbalance.kinematics.slider_crank import QUANTITIES, harmonics
from symbalance.kinematics.truncation import left_out
from symbalance.text.numbers import exact
from tests.caches import clear_caches

settings.register_profile("laws", deadline=None, max_examples=60, derandomize=True, database=None)
settings.load_profile("laws")

SMALL = st.integers(1, 60)
NAMED = st.sampled_from([1, 2, 3, 4, 5, 6, 7, 8, 9, 11, 12, 13, 15, 16, 17, 20, 24, 28, 32, 36, 60])
MODULI = st.one_of(NAMED, SMALL)
COEFFICIENTS = st.one_of(st.integers(-9, 9), st.fractions(-5, 5, max_denominator=12))


@st.composite
def raw_terms(draw: st.DrawFn) -> tuple[int, dict[int, int | Fraction]]:
    modulus = draw(MODULI)
    return modulus, draw(st.dictionaries(st.integers(0, modulus - 1), COEFFICIENTS, max_size=6))


@st.composite
def phasors(draw: st.DrawFn) -> Phasor:
    return Phasor.of(*draw(raw_terms()))


@st.composite
def reals(draw: st.DrawFn) -> Phasor:
    number = draw(phasors())
    return number + number.conjugate()


def value(number: Phasor) -> complex:
    return summed(number.modulus, dict(number.terms))


def summed(modulus: int, terms: dict[int, int | Fraction]) -> complex:
    return sum((float(c) * cmath.exp(2j * cmath.pi * k / modulus) for k, c in terms.items()), 0j)


def same(left: complex, right: complex) -> bool:
    return abs(left - right) < 1e-8 * max(1.0, abs(left), abs(right))


# Numbers ------------------------------------------------------------------------------------------


@pytest.mark.slow
@given(raw_terms())
def test_reducing_keeps_the_value(raw: tuple) -> None:
    number = Phasor.of(*raw)
    assert same(value(number), summed(*raw))
    assert same(value(Phasor(number.modulus, number.normal)), summed(*raw))
    assert all(number.normal.values())


@pytest.mark.slow
@given(phasors(), phasors())
def test_sums_products_and_conjugates_are_those_of_complex_numbers(a: Phasor, b: Phasor) -> None:
    assert same(value(a + b), value(a) + value(b))
    assert same(value(a - b), value(a) - value(b))
    assert same(value(-a), -value(a))
    assert same(value(a.times(b)), value(a) * value(b))
    assert same(value(a.conjugate()), value(a).conjugate())
    assert same(value(a.real()), value(a).real)
    assert same(value(a.imaginary()), value(a).imag)


@pytest.mark.slow
@given(phasors(), st.fractions(-3, 3, max_denominator=30))
def test_turning_multiplies_by_a_root_of_unity(a: Phasor, turns: Fraction) -> None:
    expected = value(a) * cmath.exp(2j * cmath.pi * float(turns))
    assert same(value(a.rotated(turns)), expected)
    assert (a.rotated(turns) - a.times(Phasor.root(turns))).is_zero()
    assert (a.rotated(turns).rotated(-turns) - a).is_zero()


@pytest.mark.slow
@given(phasors(), phasors(), phasors())
def test_the_laws_of_a_field(a: Phasor, b: Phasor, c: Phasor) -> None:
    assert (a + b - (b + a)).is_zero()
    assert (a.times(b) - b.times(a)).is_zero()
    assert (a.times(b + c) - a.times(b) - a.times(c)).is_zero()
    assert (a.times(b).times(c) - a.times(b.times(c))).is_zero()
    assert (a.times(ONE) - a).is_zero()
    assert (a - a).is_zero()
    assert (a.times(b).conjugate() - a.conjugate().times(b.conjugate())).is_zero()


@pytest.mark.slow
@given(raw_terms(), st.integers(1, 6), st.data())
def test_equal_numbers_have_equal_normal_forms(raw: tuple, factor: int, data: st.DataObject) -> None:
    """The same number, written over a multiple of the modulus with vanishing sums mixed in."""
    modulus, terms = raw
    large = modulus * factor
    written: dict[int, int | Fraction] = {k * factor: c for k, c in terms.items()}
    primes = [p for p in (2, 3, 5, 7, 11, 13, 17) if large % p == 0]
    for _ in range(data.draw(st.integers(0, 3)) if primes else 0):
        prime = data.draw(st.sampled_from(primes))
        start, weight = data.draw(st.integers(0, large - 1)), data.draw(st.integers(-4, 4))
        for i in range(prime):
            place = (start + i * large // prime) % large
            written[place] = written.get(place, 0) + weight
    one, other = Phasor.of(modulus, terms), Phasor.of(large, written)
    assert (one - other).is_zero()
    assert one == other
    assert one.primitive().normal == other.primitive().normal
    assert one.primitive().modulus == other.primitive().modulus
    assert one.lifted(large).normal == other.lifted(large).normal


@pytest.mark.slow
@given(raw_terms())
def test_a_number_is_zero_exactly_when_it_is_numerically(raw: tuple) -> None:
    """Coefficients are small, so what is not zero is far from it (its norm is at least one)."""
    number = Phasor.of(*raw)
    with mp.workdps(150):
        modulus, terms = raw
        total = mp.fsum(
            mp.mpf(Fraction(c).numerator) / Fraction(c).denominator * mp.expjpi(mp.mpf(2 * k) / modulus)
            for k, c in terms.items()
        )
        assert number.is_zero() == (abs(total) < mp.mpf(10) ** -130)


@pytest.mark.slow
@given(phasors())
def test_the_primitive_is_the_same_number_and_stays(a: Phasor) -> None:
    small = a.primitive()
    assert (small - a).is_zero()
    assert a.modulus % small.modulus == 0
    assert small.primitive() == small
    assert a.lifted(a.modulus * 6).primitive() == small
    if small.rational() is not None:
        assert small.modulus == 1
        assert same(value(a), complex(small.rational() or 0))


@pytest.mark.slow
@given(phasors(), st.integers(1, 400))
def test_galois_images_respect_sums_and_products(a: Phasor, unit: int) -> None:
    b = Phasor.of(a.modulus, {k: c + 1 for k, c in a.terms.items()}).lifted(a.modulus)
    b = b if b.modulus == a.modulus else ONE.lifted(a.modulus)
    assume(math.gcd(unit, a.modulus) == 1)
    product = a.times(b).lifted(a.modulus)
    assert (product.mapped(unit) - a.mapped(unit).times(b.mapped(unit))).is_zero()


# Radicals and cosines -----------------------------------------------------------------------------


def close(form: ClosedForm, expected: mp.mpf) -> bool:
    with mp.workdps(45):
        found = mp.mpmathify(sympy.N(form.expression(), 40))
        return bool(abs(found - expected) <= mp.mpf(10) ** -30 * max(1, abs(expected)))


@pytest.mark.slow
@given(reals())
def test_a_real_number_and_its_expression_agree(number: Phasor) -> None:
    assert close(exact_form(number), number.real_value(35))


@settings(max_examples=25)
@given(reals())
def test_cosines_and_radicals_are_one_number(number: Phasor) -> None:
    small = number.primitive()
    expected = small.real_value(35)
    assert close(trigonometric_form(small), expected)
    radicals = radical_form(small)
    if radicals is not None:
        assert close(radicals, expected)
        assert not radicals.expression().has(sympy.cos, sympy.sin)


@pytest.mark.parametrize("modulus", [3, 4, 5, 6, 8, 10, 12, 15, 16, 20, 24])
def test_radicals_where_they_exist(modulus: int) -> None:
    for k in range(modulus):
        cosine = Phasor.of(modulus, {k: 1}).real()
        assert not exact_form(cosine).expression().has(sympy.cos, sympy.sin)
        assert close(exact_form(cosine), cosine.real_value(35))


@pytest.mark.parametrize("modulus", [7, 9, 11, 13, 17, 32])
def test_every_cosine_and_sine_of_a_modulus(modulus: int) -> None:
    for k in range(modulus):
        root = Phasor.root(Fraction(k, modulus))
        for number, wave in ((root.real(), mp.cospi), (root.imaginary(), mp.sinpi)):
            with mp.workdps(45):
                assert close(exact_form(number), wave(mp.mpf(2 * k) / modulus))


@pytest.mark.slow
@given(phasors())
def test_a_square_root_is_the_root_of_the_square(number: Phasor) -> None:
    assume(not number.is_zero())
    square = number.times(number.conjugate())
    with mp.workdps(45):
        expected = mp.sqrt(square.real_value(40))
    assert close(square_root_form(square), expected)


@pytest.mark.slow
@given(reals(), st.integers(5, 60))
def test_a_decimal_has_the_digits_it_promises(number: Phasor, digits: int) -> None:
    few, many = number.real_value(digits), number.real_value(2 * digits + 20)
    with mp.workdps(200):
        assert abs(few - many) <= abs(many) * mp.mpf(10) ** -digits


@pytest.mark.parametrize("n", [20, 60, 140])
def test_a_decimal_survives_any_cancellation(n: int) -> None:
    """(2 - 2 cos 24 degrees)... to the power n: tiny, with terms of 10^(n/2)."""
    base = Phasor.of(15, {0: -2, 2: 1, 13: 1})
    power = ONE
    for _ in range(n):
        power = power.times(base)
    with mp.workdps(60):
        expected = (2 * mp.cospi(mp.mpf(4) / 15) - 2) ** n
        assert abs(power.real_value(30) / expected - 1) < mp.mpf(10) ** -29


# Engines ------------------------------------------------------------------------------------------


ANGLES = st.one_of(
    st.sampled_from([Fraction(a) for a in (0, 30, 45, 60, 90, 120, 180, -90, -60)]),
    st.sampled_from([Fraction(360 * k, d) for d in (5, 7, 9, 11, 16) for k in range(1, 4)]),
    st.sampled_from([Fraction("13.5"), Fraction("22.5"), Fraction(-75)]),
)
STATIONS = st.fractions(-4, 4, max_denominator=4)


@st.composite
def layouts(draw: st.DrawFn) -> Engine:
    rows = draw(st.lists(st.tuples(ANGLES, ANGLES, STATIONS), min_size=1, max_size=5))
    return Engine(
        Cylinder(i, throw, Angle(bank / 360).normalized(), station)
        for i, (throw, bank, station) in enumerate(rows, 1)
    )


def remade(layout: Engine, **change: object) -> Engine:
    """Return the layout with its cylinders turned, delayed, shifted, reversed or mirrored."""
    turn = Angle(Fraction(str(change.get("turn", 0))) / 360)
    delay = Angle(Fraction(str(change.get("delay", 0))) / 360)
    shift = Fraction(str(change.get("shift", 0)))
    sign = -1 if change.get("reverse") else 1
    mirror = -1 if change.get("mirror") else 1
    first = int(str(change.get("first", 1)))
    return Engine(
        Cylinder(
            c.number + first - 1,
            c.throw.scaled(mirror) + turn + delay,
            (c.bank.scaled(mirror) + turn).normalized(),
            c.station * sign + shift,
        )
        for c in layout.cylinders
    )


def assert_same(left: Spectrum, right: Spectrum) -> None:
    assert left.terms.keys() == right.terms.keys()
    for n, number in left.terms.items():
        assert (number - right.terms[n]).is_zero(), n


@pytest.mark.slow
@given(layouts(), ANGLES)
def test_turning_the_engine_turns_what_it_does(layout: Engine, turn: Fraction) -> None:
    before, after = balance(layout, 8), balance(remade(layout, turn=turn), 8)
    assert_same(after.force, before.force.rotated(turn / 360))
    assert_same(after.couple, before.couple.rotated(turn / 360))


@pytest.mark.slow
@given(layouts(), ANGLES)
def test_advancing_the_crank_is_one_phase_for_each_order(layout: Engine, lead: Fraction) -> None:
    """Throws turned on by delta mean theta turned on by delta: c_n times e^(i n delta)."""
    before, after = balance(layout, 8), balance(remade(layout, delay=lead), 8)
    for old, new in ((before.force, after.force), (before.couple, after.couple)):
        assert_same(new, old.delayed(-lead / 360))
        for n, number in old.terms.items():
            expected = value(number) * cmath.exp(2j * cmath.pi * n * float(lead) / 360)
            assert same(value(new.terms[n]), expected)


@pytest.mark.slow
@given(layouts(), STATIONS)
def test_where_the_engine_stands_does_not_matter(layout: Engine, shift: Fraction) -> None:
    before, after = balance(layout, 8), balance(remade(layout, shift=shift), 8)
    assert_same(after.couple, before.couple)
    assert_same(after.force, before.force)


@pytest.mark.slow
@given(layouts())
def test_reversing_the_stations_negates_the_couple(layout: Engine) -> None:
    before, after = balance(layout, 8), balance(remade(layout, reverse=True), 8)
    assert_same(after.couple, before.couple.scaled(-1))
    assert_same(after.force, before.force)


@pytest.mark.slow
@given(layouts())
def test_a_mirrored_engine_swaps_and_conjugates_its_orders(layout: Engine) -> None:
    """Mirrored in the vertical and run backward: the vertical stays, the lateral is negated."""
    before, after = balance(layout, 6), balance(remade(layout, mirror=True), 6)
    assert before.force.orders() == after.force.orders()
    for order in before.force.orders():
        for name, sign in (("vertical", 1), ("lateral", -1)):
            old = before[order].force.component(name).number
            new = after[order].force.component(name).number
            assert (new - old.conjugate().scaled(sign)).is_zero()


@pytest.mark.slow
@given(layouts(), STATIONS)
def test_the_plane_of_reference_moves_the_couple_by_the_force(layout: Engine, at: Fraction) -> None:
    about_mean, about = balance(layout, 8), balance(layout, 8, reference=at)
    arm = layout.mean_station - at
    assert_same(about.couple, about_mean.couple + about_mean.force.scaled(arm))


@pytest.mark.slow
@given(layouts(), layouts())
def test_two_engines_on_one_crank_add(one: Engine, two: Engine) -> None:
    other = remade(two, first=len(one.cylinders) + 1)
    both = Engine([*one.cylinders, *other.cylinders])
    parts = [balance(part, 8, reference=0) for part in (one, two, both)]
    assert_same(parts[2].force, parts[0].force + parts[1].force)
    assert_same(parts[2].couple, parts[0].couple + parts[1].couple)


@pytest.mark.slow
@given(layouts())
def test_an_engine_and_its_opposite_cancel_the_odd_order(layout: Engine) -> None:
    """Delayed by half a turn, order 1 changes its sign and every even order doubles."""
    other = remade(layout, delay=180, first=len(layout.cylinders) + 1)
    both = balance(Engine([*layout.cylinders, *other.cylinders]), 8, reference=0)
    alone = balance(layout, 8, reference=0)
    assert 1 not in both.force.orders()
    even = Spectrum({n: c for n, c in alone.force.terms.items() if n % 2 == 0})
    assert_same(both.force, even.scaled(2))


@pytest.mark.slow
@given(layouts())
def test_what_is_listed_is_what_is_not_zero(layout: Engine) -> None:
    result = balance(layout, 10)
    for found in result.orders:
        assert not (found.force.is_zero() and found.couple.is_zero())
        assert found.order == 1 or found.order % 2 == 0
    for spectrum in (result.force, result.couple):
        for order in spectrum.orders():
            parts = [spectrum.component(order, name) for name in COMPONENTS]
            assert not all(part.is_zero() for part in parts[:2])
            vertical, _, forward, backward = parts
            assert (forward.number + backward.number - vertical.number).is_zero()


@pytest.mark.slow
@given(st.integers(1, 24), st.sampled_from([2, 4]), st.randoms(use_true_random=False))
def test_an_even_firing_in_line_engine_keeps_multiples_only(
    count: int, strokes: int, shuffle: Random
) -> None:
    """Order n survives in the force exactly if n half-turns (or turns) are whole firings."""
    rest = list(range(2, count + 1))
    shuffle.shuffle(rest)
    force = balance(inline([1, *rest], strokes=strokes), 48).force
    half_cycles = strokes // 2
    surviving = [1, *range(2, 49, 2)]
    expected = [n for n in surviving if half_cycles * n % count == 0]
    assert force.orders() == expected
    for n in expected:
        assert same(value(force.terms[n]), count / 2)


@pytest.mark.slow
@given(st.integers(1, 12), st.randoms(use_true_random=False))
def test_an_engine_with_mirrored_throws_has_no_couple(half: int, shuffle: Random) -> None:
    throws = [Fraction(360 * shuffle.randrange(12), 12) for _ in range(half)]
    result = balance(inline(throws=[*throws, *reversed(throws)]), 12)
    assert not result.couple.terms


# Symbols ------------------------------------------------------------------------------------------


ALPHA = sympy.Symbol("alpha")
BANK_ANGLES = [
    Fraction(60),
    Fraction(90),
    Fraction(360, 7),
    Fraction("22.5"),
    Fraction(0),
    Fraction(180),
]


def at(expression: sympy.Expr, bank_angle: Fraction) -> mp.mpf:
    radian = sympy.pi * sympy.Rational(bank_angle.numerator, 180 * bank_angle.denominator)
    return mp.mpmathify(sympy.N(expression.subs(ALPHA, radian), 35))


VEES = {
    "shared pins": {"pins": [0, 90, 270, 180]},
    "splayed pins": {"pins": [0, "360/7", 240], "splay": 30},
    "even firing": {"firing_order": [1, 4, 3, 2]},
    "uneven firing": {
        "firing_order": [1, 2, 3, 4],
        "firing_intervals": [90, 270, "128.5", "231.5"],
    },
    "staggered": {"firing_order": [1, 3, 2], "cylinders": [[1], [2, 3]], "stagger": ("1/3", 0)},
}


@pytest.mark.slow
@pytest.mark.parametrize("name", VEES)
def test_a_symbolic_bank_angle_holds_all_the_concrete_ones(name: str) -> None:
    symbolic = balance(vee(ALPHA, **VEES[name]), 4)
    for bank_angle in BANK_ANGLES:
        concrete = balance(vee(bank_angle, **VEES[name]), 4)
        for kind in ("force", "couple"):
            general, special = getattr(symbolic, kind), getattr(concrete, kind)
            for order in (1, 2, 4):
                for part in COMPONENTS:
                    found = general.component(order, part)
                    expected = special.component(order, part).decimal()
                    assert abs(at(found.cos, bank_angle) - expected[0]) < mp.mpf(10) ** -14
                    assert abs(at(found.sin, bank_angle) - expected[1]) < mp.mpf(10) ** -14
                    size = at(found.amplitude, bank_angle)
                    if not any(expected):  # it vanishes at this angle, and has no phase there
                        assert abs(size) < mp.mpf(10) ** -14
                        continue
                    phase = at(found.phase, bank_angle)
                    assert abs(size * mp.cos(phase) - expected[0]) < mp.mpf(10) ** -14
                    assert abs(size * mp.sin(phase) - expected[1]) < mp.mpf(10) ** -14


@pytest.mark.slow
def test_a_letter_for_a_bank_angle_holds_for_unlike_masses_too() -> None:
    """Components with a letter, at numbers, are those of the engine with numbers, kinematics and all."""
    masses = {1: "0.5", 2: "0.7", 3: "0.65", 4: "0.5"}

    def pistons(bank_angle: object) -> Engine:
        half = angle(bank_angle, "bank_angle").scaled(Fraction(1, 2))
        cylinders = [
            Cylinder(
                n,
                throw=90 * (n // 3),
                bank=half if n % 2 else half.scaled(-1),
                station=Fraction(n, 3),
                stroke=80,
                rod=160,
                reciprocating_mass=mass,
            )
            for n, mass in masses.items()
        ]
        return Engine(cylinders)

    symbolic = balance(pistons(ALPHA), 4)
    assert all(symbolic[n].coefficient is not None for n in (1, 2, 4))
    for bank_angle in (Fraction(60), Fraction("100.5")):
        concrete = balance(pistons(bank_angle), 4)
        assert concrete.kinematics is None
        for kind in ("force", "couple"):
            for order in (1, 2, 4):
                for part in COMPONENTS:
                    found = getattr(symbolic, kind).component(order, part)
                    expected = getattr(concrete, kind).component(order, part).decimal()
                    size = mp.mpf(str(symbolic.share(order)))
                    assert abs(size * at(found.cos, bank_angle) - expected[0]) < mp.mpf(10) ** -14
                    assert abs(size * at(found.sin, bank_angle) - expected[1]) < mp.mpf(10) ** -14


def test_an_amplitude_with_a_letter_is_above_zero_at_small_angles() -> None:
    """sin α with its phase turned by half a turn, not −sin α."""
    engines = [vee(ALPHA, pins=[0, 180]), vee(ALPHA, pins=[0, 90, 270, 180]), vee(ALPHA, pins=[0])]
    fixed = 0
    for engine in engines:
        result = balance(engine, 6)
        for order in result.orders:
            for resultant in (order.force, order.couple):
                for part in map(resultant.component, COMPONENTS):
                    turns = part.phase_in_turns
                    if part.is_zero() or turns is None:
                        continue
                    fixed += 1
                    assert at(part.amplitude, Fraction(1, 10)) > 0
                    assert part.phase == 2 * sympy.pi * sympy.Rational(turns.numerator, turns.denominator)
                    wave = part.amplitude * sympy.cos(part.phase), part.amplitude * sympy.sin(part.phase)
                    assert (sympy.expand(wave[0] - part.cos), sympy.expand(wave[1] - part.sin)) == (0, 0)
    assert fixed > 20


def test_a_symbolic_zero_is_zero_for_all_angles() -> None:
    result = balance(vee(ALPHA, pins=[0, 180]), 4)
    assert 1 not in result.force.orders()
    assert result.force.orders() == [2, 4]
    assert result.couple.orders() == [1]


def test_a_component_that_vanishes_for_all_angles_has_phase_zero() -> None:
    lateral = balance(Engine([Cylinder(1, throw=ALPHA)]), 1)[1].force.lateral
    assert lateral.is_zero()
    assert (lateral.cos, lateral.sin, lateral.amplitude, lateral.phase) == (0, 0, 0, 0)


def test_symbols_of_two_angles_stay_apart() -> None:
    beta = sympy.Symbol("beta")
    one = balance(Engine([Cylinder(1, bank=ALPHA), Cylinder(2, throw=beta, bank=beta)]), 2)
    vertical = one[1].force.vertical
    numbers = {ALPHA: sympy.Rational(1, 3), beta: sympy.Rational(-5, 7)}
    expected = sympy.cos(ALPHA) ** 2 + sympy.cos(beta)
    assert abs(sympy.N((vertical.cos - expected).subs(numbers), 30)) < 1e-28


def timed(work: Callable[[], object]) -> float:
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


@pytest.mark.slow
def test_exact_forms_of_fine_angles_are_integer_work() -> None:
    """An in-line eight in quarter degrees to order 24, beside 200,000 sums of fractions."""
    throws = ["0.25", "90.5", "181.75", "270.25", "45.5", "135.75", "225.25", "300.5"]
    ours = timed(lambda: to_json(balance(inline(throws=throws, ratio=4), 24)))
    third = Fraction(1, 3)
    sums = timed(lambda: [third + Fraction(k, 7) for k in range(200_000)])
    assert ours < 9 * sums


# Precision ----------------------------------------------------------------------------------------


def printed_at(digits: int) -> list[object]:
    """Return all that is made with decimals, made anew while the caller works with so many digits."""
    clear_caches()
    lam = Fraction(4)
    with mp.workdps(digits):
        engines = [balance(load(name), order=60) for name in ("v8-90", "v2-45")]
        seven = balance(inline("1-3-5-7-6-4-2", ratio="7/2"), order=200)
        function = to_function(seven, outputs="couple.vertical")
        return [
            *(form(result) for result in (*engines, seven) for form in (to_text, to_latex, to_json)),
            *(to_text(derive(quantity, n)) for quantity in QUANTITIES for n in (2, 6, 41)),
            *(printed_error(n, harmonics(quantity, n)) for quantity in QUANTITIES for n in (1, 2, 7)),
            *(left_out(6, ratio, quantity) for quantity in QUANTITIES for ratio in (lam, lam / 3)),
            function.outputs,
        ]


@pytest.mark.slow
def test_results_do_not_depend_on_the_callers_precision() -> None:
    assert printed_at(4) == printed_at(50)


def test_a_bound_is_rounded_up_at_any_precision() -> None:
    """The factor that covers rounding is no number of the precision set when it was imported."""
    code = (
        "import mpmath; mpmath.mp.dps = 4\n"
        "from symbalance.kinematics.truncation import ROUNDING, left_out\n"
        "from fractions import Fraction\n"
        "mpmath.mp.dps = 30; print(ROUNDING > 1, left_out(6, Fraction(4)))"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    with mp.workdps(30):
        assert run.stdout.split() == ["True", str(left_out(6, Fraction(4)))]


def test_documents_share_nothing_that_can_be_changed() -> None:
    result = balance(load("v8-90"))
    before, spoiled = to_json(result), balance_data(result)
    for order in spoiled["orders"]:
        for kind in ("force", "couple"):
            for part in order[kind].values():
                part["decimal"] = [*part["decimal"], "0"]
                part["cos"] = "spoiled"
    assert to_json(result) == before
    assert isinstance(balance_data(result)["orders"][0]["force"]["vertical"]["decimal"], tuple)


# Reading numbers ----------------------------------------------------------------------------------


@given(st.fractions(-(10**6), 10**6, max_denominator=10**6))
def test_a_fraction_reads_back_as_written(number: Fraction) -> None:
    assert exact(str(number), "x") == number
    assert exact(number, "x") == number
    assert exact(f" {number.numerator} / {number.denominator} ", "x") == number


@given(st.integers(-(10**9), 10**9), st.integers(0, 9))
def test_a_decimal_is_the_fraction_it_shows(digits: int, places: int) -> None:
    number = Fraction(digits, 10**places)
    sign, text = "-" if digits < 0 else "", str(abs(digits)).rjust(places + 1, "0")
    written = sign + (text[:-places] + "." + text[-places:] if places else text)
    assert exact(written, "x") == number
    assert exact(f"{digits}e-{places}", "x") == number


@given(st.floats(-1e6, 1e6).filter(lambda x: x == 0 or abs(x) > 1e-4))
def test_a_float_is_read_as_it_prints(number: float) -> None:
    assume(Fraction(repr(number)).denominator <= 10**12)
    assert exact(number, "x") == Fraction(repr(number))


@pytest.mark.slow
@given(st.fractions(-1000, 1000, max_denominator=1000))
def test_degrees_and_radians_are_one_angle(number: Fraction) -> None:
    radian = sympy.pi * sympy.Rational(number.numerator, 180 * number.denominator)
    assert angle(radian) == degrees(number) == angle(degrees(number))
    again = degrees(number).normalized()
    assert Fraction(-1, 2) < again.turns <= Fraction(1, 2)
    assert (again.turns - degrees(number).turns).denominator == 1


@pytest.mark.slow
@given(st.integers(2, 10), st.data())
def test_where_a_cylinder_fires_its_pin_points_along_its_bank(count: int, data: st.DataObject) -> None:
    order = [1, *data.draw(st.permutations(range(2, count + 1)))]
    cuts = sorted(data.draw(st.lists(st.integers(0, 720), min_size=count - 1, max_size=count - 1)))
    steps = [b - a for a, b in zip([0, *cuts], [*cuts, 720], strict=True)]
    layout = from_firing_order(
        order, banks=(-20, 25), cylinders=[[1], list(range(2, count + 1))], firing_intervals=steps
    )
    assert layout.cylinders[0].throw == layout.cylinders[0].bank
    for cylinder in layout.cylinders:
        assert cylinder.fires is not None
        at_firing = cylinder.throw.in_degrees() + cylinder.fires - cylinder.bank.in_degrees()
        assert at_firing % 360 == 0
    assert layout.mean_station == 0
