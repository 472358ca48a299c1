"""Evidence: offset cylinders, link rods and rods with inertia, against geometry and Newton's laws.

The linkage is built here by intersecting circles with lines in the engine's frame, angles from the
master's axis, without the formulas of `symbalance.kinematics.mechanisms`: a piston is where the circle
of the rod about its pin meets the cylinder's axis. Derivatives are mpmath's differences at 60 digits,
harmonics are `mp.quad` or a plain sum, and the rod's inertia is that of points of mass along it.
"""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise

import pytest
from mpmath import mp

from symbalance.errors import SymbalanceError
from symbalance.kinematics.mechanisms import (
    LinkRod,
    RodSplit,
    SliderCrank,
    dead_centres,
    exact_dead_centres,
    force_harmonics,
    harmonics_of,
    height,
    height_motion,
    offset_left_out,
    offset_series,
    rocking_series,
    rod_angle,
    rod_angle_harmonics,
    rod_motion,
    side_thrust,
)
from symbalance.kinematics.slider_crank import acceleration_series, acceleration_values, rod_angle_value

F = Fraction
CENTRED, OFFSET = SliderCrank(4), SliderCrank("7/2", "-3/8")
RADIAL = LinkRod(SliderCrank("15/4"), "1/9", "7/8", "23/8", "1/9")
VEE = LinkRod(SliderCrank(4), "61/360", "3/5", "17/5", "1/6")
ODD = LinkRod(SliderCrank(3, "1/5"), "-2/7", "1/2", "5/2", "3/8", "-1/4")
OPPOSED = LinkRod(SliderCrank(3, "1/5"), "1/3", "1/2", 3, "1/2", "1/10")
STRAIGHT = LinkRod(SliderCrank(3), 0, "1/2", 3, 0)
SQUARE = LinkRod(SliderCrank(4), "7/12", "1/3", 3, "1/3")
LEANING = LinkRod(SliderCrank(4, "1/3"), "1/4", "1/3", 3, "1/4")
FORKED = LinkRod(SliderCrank(5), "1/7", 0, 3, "1/4", "1/3")
ALL = {
    "centred": CENTRED,
    "offset": OFFSET,
    "radial": RADIAL,
    "vee": VEE,
    "odd": ODD,
    "opposed": OPPOSED,
    "straight": STRAIGHT,
    "square": SQUARE,
    "leaning": LEANING,
    "forked": FORKED,
}
ANGLES = [mp.mpf(x) for x in ("0", "0.3", "1.5", "2.9", "-2.2", "11")]


@pytest.fixture(autouse=True)
def many_digits():
    with mp.workdps(40):
        yield


def every(**chosen):
    return pytest.mark.parametrize("mechanism", chosen.values(), ids=chosen.keys())


def number(value):
    return mp.mpf(F(value).numerator) / F(value).denominator


def direction(turns):
    return mp.expj(2 * mp.pi * number(turns))


def met(pin, length, axis, offset):
    """Return where the circle about `pin` meets the line along `axis`, `offset` beside the origin."""
    beside = 1j * axis * number(offset)
    half = ((pin - beside) * mp.conj(axis)).real
    apart = abs(pin - beside) ** 2 - number(length) ** 2
    return beside + axis * (half + mp.sqrt(half**2 - apart))


def built(mechanism, p):
    """Return the rod's pin, the piston's pin and the cylinder's axis, in the engine's frame."""
    if isinstance(mechanism, SliderCrank):
        pin = mp.expj(p)
        return pin, met(pin, mechanism.ratio, mp.mpc(1), mechanism.offset), mp.mpc(1)
    axis = direction(mechanism.bank_difference)
    crank, master, _ = built(mechanism.master, p + mp.arg(axis))
    along = (master - crank) / abs(master - crank)
    pin = crank + number(mechanism.link_radius) * along * direction(mechanism.link_angle)
    return pin, met(pin, mechanism.length, axis, mechanism.offset), axis


def high(mechanism, p):
    _, piston, axis = built(mechanism, p)
    return (piston * mp.conj(axis)).real


def slope(mechanism, p):
    """Return phi: how far the rod leans back from the cylinder's axis."""
    pin, piston, axis = built(mechanism, p)
    return -mp.arg((piston - pin) * mp.conj(axis))


def close(found, expected, digits=30):
    assert abs(found - expected) <= mp.mpf(10) ** -digits * max(1, abs(expected)), (found, expected)


@every(**ALL)
def test_the_motion_is_that_of_the_circles_and_lines(mechanism):
    for p in ANGLES:
        close(height(mechanism, p), high(mechanism, p))
        close(rod_angle(mechanism, p), slope(mechanism, p))


@every(**ALL)
def test_derivatives_are_those_of_the_geometry(mechanism):
    for function, motion in ((high, height_motion), (slope, rod_motion)):
        for p in ANGLES[1:5]:
            found = motion(mechanism, p)
            with mp.workdps(90):
                expected = [mp.diff(lambda x: function(mechanism, x), p, n) for n in range(3)]  # noqa: B023
            for value, reference in zip(found, expected, strict=True):
                close(value, reference, 28)


@pytest.mark.slow
@every(offset=OFFSET, odd=ODD)
def test_coefficients_are_the_fourier_integrals(mechanism):
    with mp.workdps(25):
        for function, harmonics in ((high, harmonics_of), (slope, rod_angle_harmonics)):
            found = harmonics(mechanism, 3)
            for n in (0, 1, 2, 3):
                parts = mp.linspace(0, 2 * mp.pi, 5)
                total = mp.quad(lambda p: function(mechanism, p) * mp.expj(-n * p), parts)  # noqa: B023
                close(found[n], total / (2 * mp.pi), 20)


@pytest.mark.slow
@every(**ALL)
def test_what_is_left_out_is_zero_and_nothing_else_is(mechanism):
    points = 160
    angles = [2 * mp.pi * i / points for i in range(points)]
    for function, harmonics in ((high, harmonics_of), (slope, rod_angle_harmonics)):
        samples = [function(mechanism, p) for p in angles]
        found = harmonics(mechanism, 8, 24)
        for n in range(9):
            rotated = [mp.expj(-n * p) for p in angles]
            expected = mp.fsum(s * t for s, t in zip(samples, rotated, strict=True)) / points
            close(found.get(n, 0), expected, 24)
            parts = (found[n].real, found[n].imag) if n in found else ()
            assert all(x == 0 or abs(x) > 1e-20 for x in parts)


@pytest.mark.slow
@every(offset=OFFSET, radial=RADIAL, odd=ODD, near=SliderCrank("1.002", "1/1000"))
def test_errors_are_as_small_as_promised(mechanism):
    for harmonics in (harmonics_of, rod_angle_harmonics):
        rough, fine = harmonics(mechanism, 9, 6), harmonics(mechanism, 9, 30)
        allowed = mp.mpf(10) ** -6 * mp.exp(-9 * mechanism.strip)
        assert all(abs(rough[n] - fine[n]) < allowed for n in fine)


def test_without_offset_it_is_the_slider_crank():
    for ratio in (F(4), F(6, 5), F(10**9)):
        forces = force_harmonics(SliderCrank(ratio), 12, 25)
        for n, value in acceleration_values(12, ratio, 30).items():
            assert forces[n][1] == 0
            assert abs(forces[n][0] - value) < mp.mpf(10) ** -22 * abs(value)
        rods = rod_angle_harmonics(SliderCrank(ratio), 9, 25)
        assert [*rods] == [1, 3, 5, 7, 9]
        for n, value in rods.items():
            reference = rod_angle_value(n, ratio, 30)
            assert abs(2j * value - reference) < mp.mpf(10) ** -22 * abs(reference)


def test_orders_that_symmetry_forbids():
    assert [*harmonics_of(CENTRED, 7)] == [*harmonics_of(RADIAL, 7)] == [0, 1, 2, 4, 6]
    assert harmonics_of(RADIAL, 7)[1] == 0.5  # the first order of a link rod at its cylinder's own angle
    assert [*harmonics_of(VEE, 3)] == [*harmonics_of(OFFSET, 3)] == [0, 1, 2, 3]
    for mechanism in (OFFSET, OPPOSED):
        found = force_harmonics(mechanism, 8)
        assert all((b if n % 2 == 0 else a if n > 1 else a - 1) == 0 for n, (a, b) in found.items())


def test_fork_and_blade_is_a_slider_crank():
    assert harmonics_of(FORKED, 6) == harmonics_of(SliderCrank(3, "1/3"), 6)
    assert dead_centres(FORKED) == dead_centres(SliderCrank(3, "1/3"))


def test_a_mirrored_linkage_moves_backwards():
    mirrored = LinkRod(SliderCrank(3, "-1/5"), "2/7", "1/2", "5/2", "-3/8", "1/4")
    one, other = harmonics_of(ODD, 6), harmonics_of(mirrored, 6)
    for n, value in one.items():
        close(mp.conj(value), other[n], 20)


@pytest.mark.parametrize("offset", ["0", "1/2", "-1"])
def test_the_series_is_the_force_within_its_bound(offset):
    mechanism = SliderCrank(6, offset)
    forces = force_harmonics(mechanism, 7, 30)
    for n in range(1, 8):
        for through in (5, 10, 21):
            bound = number(offset_left_out(n, through, mechanism))
            exact = forces.get(n, (mp.mpf(0), mp.mpf(0)))
            series = offset_series(n, through)
            kept = [number(part.at(mechanism)) for part in series]
            errors = [abs(a - b) for a, b in zip(kept, exact, strict=True)]
            assert max(errors) <= bound + mp.mpf(10) ** -28
            assert all(e < mp.mpf(10) ** -28 for e, s in zip(errors, series, strict=True) if s.complete)


def test_the_series_alone_decides_which_powers_there_are():
    for n in range(1, 9):
        series = offset_series(n, 12)
        for (i, j), c in (*series.cos.terms.items(), *series.sin.terms.items()):
            assert c
            assert i + j <= 12
        assert all(i % 2 == 1 and j % 2 == 0 for i, j in series.cos.terms) or n == 1
        assert all(i % 2 == 0 and j % 2 == 1 for i, j in series.sin.terms)
        centred = {i: c for (i, j), c in series.cos.terms.items() if j == 0}
        assert centred == {p: c for p, c in acceleration_series(n, 12).terms.items() if c}


@every(offset=OFFSET, centred=CENTRED, far=SliderCrank(3, "19/10"))
def test_dead_centres_of_a_slider_crank(mechanism):
    found, exactly = dead_centres(mechanism), exact_dead_centres(mechanism)
    for name in ("top", "bottom", "highest", "lowest", "stroke", "down"):
        close(mp.mpf(getattr(exactly, name).evalf(40)), getattr(found, name), 35)
    close(high(mechanism, found.top), found.highest)
    close(high(mechanism, found.bottom), found.lowest)
    assert found.stroke >= 2
    assert (found.down > mp.pi) == (mechanism.offset > 0)
    for p in (found.top, found.bottom):
        close(height_motion(mechanism, p).first, 0)


@pytest.mark.slow
@every(radial=RADIAL, vee=VEE, odd=ODD, opposed=OPPOSED, straight=STRAIGHT)
def test_dead_centres_of_a_link_rod(mechanism):
    found = dead_centres(mechanism)
    heights = [high(mechanism, 2 * mp.pi * i / 200) for i in range(200)]
    assert max(heights) <= found.highest < max(heights) + 1e-3
    assert min(heights) >= found.lowest > min(heights) - 1e-3
    assert -mp.pi < found.top <= mp.pi
    assert 0 < found.down < 2 * mp.pi
    close(high(mechanism, found.top), found.highest)
    close(high(mechanism, found.bottom), found.lowest)
    for p in (found.top, found.bottom):
        close(mp.diff(lambda x: high(mechanism, x), p), 0, 15)


MASSES = [(F(1, 3), F(-1, 10)), (F(1, 5), F(2, 5)), (F(1, 7), F(11, 10))]
"""Points of mass on a rod: how much, and how far from its pin in rods' lengths."""


def split(length):
    mass = sum(m for m, _ in MASSES)
    centre = sum(m * x for m, x in MASSES) / mass
    inertia = sum(m * (x - centre) ** 2 for m, x in MASSES)
    return RodSplit(mass, length, centre * length, inertia * length**2)


def test_energy_and_momentum_of_the_rod_are_those_of_its_split():
    """Exactly, for any motion of a rod: its pin's velocity, its direction and its turning are free."""
    length = F(13, 4)
    rod = split(length)
    cases = [
        ((F(3, 7), F(-2)), (F(3, 5), F(4, 5)), F(5, 9)),
        ((F(1), F(0)), (F(-5, 13), F(12, 13)), F(-7)),
    ]
    for (u, v), (c, s), turning in cases:

        def velocity(share, u=u, v=v, c=c, s=s, turning=turning):
            arm = share * length * turning
            return u - arm * s, v + arm * c

        real = sum(m * sum(x * x for x in velocity(share)) for m, share in MASSES)
        ends = [(rod.rotating, velocity(F(0))), (rod.reciprocating, velocity(F(1)))]
        assert real == sum(m * (x * x + y * y) for m, (x, y) in ends) + rod.excess * turning**2
        for i in (0, 1):
            assert sum(m * velocity(x)[i] for m, x in MASSES) == sum(m * end[i] for m, end in ends)


def inertia_forces(mechanism, p):
    """Return (place, -mass times acceleration) of every point of the rod, in the cylinder's frame."""

    def place(share, x):
        pin, piston, axis = built(mechanism, x)
        return (pin + share * (piston - pin)) * mp.conj(axis)

    with mp.workdps(80):
        return [
            (place(number(x), p), -number(m) * mp.diff(lambda a, x=x: place(number(x), a), p, 2))
            for m, x in MASSES
        ]


def moment(place, force):
    return (mp.conj(place) * force).imag


@every(centred=CENTRED, offset=OFFSET)
def test_all_the_rod_does_to_the_engine(mechanism):
    """Its inertia forces are those of the end masses, and their moment the couple: no new side force."""
    rod = split(mechanism.length)
    for p in ANGLES[1:5]:
        forces = inertia_forces(mechanism, p)
        total = mp.fsum(f for _, f in forces)
        axial = -number(rod.reciprocating) * height_motion(mechanism, p).second
        close(total, number(rod.rotating) * mp.expj(p) + axial, 25)
        couple = mp.fsum(moment(place, f) for place, f in forces) + number(mechanism.offset) * axial
        close(couple, number(rod.excess) * rod_motion(mechanism, p).second, 25)


@every(centred=CENTRED, offset=OFFSET, radial=RADIAL, odd=ODD)
def test_side_thrust_holds_the_rod(mechanism):
    """Moments about the rod's lower pin: inertia of all its points, gas and piston, and the wall."""
    rod, piston_mass, gas = split(mechanism.length), mp.mpf("1.7"), mp.mpf("-5.5")
    for p in ANGLES[1:5]:
        pin, piston, axis = built(mechanism, p)
        pin, piston = pin * mp.conj(axis), piston * mp.conj(axis)
        second = height_motion(mechanism, p).second
        loads = [*inertia_forces(mechanism, p), (piston, gas - piston_mass * second)]
        about_pin = mp.fsum(moment(place - pin, f) for place, f in loads)
        on_piston = -about_pin / (piston - pin).real
        axial = gas - (piston_mass + number(rod.reciprocating)) * second
        close(side_thrust(mechanism, p, axial, number(rod.excess)), -on_piston, 25)


@every(centred=CENTRED, offset=OFFSET)
def test_side_thrust_balances_power_and_moments(mechanism):
    """What F and the couple do in a turn of dp drives the crank; the wall and the axis bear the rest."""
    axial, excess = mp.mpf("-2.5"), mp.mpf("0.7")
    for p in ANGLES:
        piston, rod = height_motion(mechanism, p), rod_motion(mechanism, p)
        couple = excess * rod.second
        torque = axial * piston.first - couple * rod.first
        wall = side_thrust(mechanism, p, axial, excess)
        close(torque, couple - piston.value * wall - number(mechanism.offset) * axial)


def test_the_couple_and_its_series():
    mechanism, rod = SliderCrank(40), RodSplit("0.6", 150, 45, 2500)
    found = rod.couple_harmonics(mechanism, 5, 30)
    for n, k in found.items():
        series = number(rocking_series(n, 13).at(mechanism.ratio) * -rod.excess)
        close(k * 2j / series, 1, 16)  # k_n e^(inp) + its conjugate is -J_x times the series' sine
    with mp.workdps(30):
        p = mp.mpf("0.9")
        summed = 2 * mp.fsum((k * mp.expj(n * p)).real for n, k in found.items())
        close(summed, number(rod.excess) * rod_motion(mechanism, p).second, 9)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: SliderCrank(1), "lambda = l/r > 1"),
        (lambda: SliderCrank(3, 2), "offset = 2: must lie within -2 and 2"),
        (lambda: SliderCrank(3, "x"), "offset = x: must be a number"),
        (lambda: LinkRod(4, 0, 1, 3, 0), "master = 4: must be a SliderCrank"),
        (lambda: LinkRod(CENTRED, 0, -1, 3, 0), "link_radius = -1: must not be negative"),
        (lambda: LinkRod(CENTRED, 0, 1, "5/4", 0), "length = 5/4: must exceed 1.25"),
        (lambda: LinkRod(CENTRED, 0, 0, 1, 0), "length = 1: must exceed 1"),
        (lambda: LinkRod(CENTRED, 0, 0, -3, 0), "length = -3: must exceed 1"),
        (lambda: LinkRod(CENTRED, 0, "1/2", 3, 0, "8/3"), "must exceed 3.79"),
        (lambda: harmonics_of(CENTRED, 0), "order = 0: must be a whole number"),
        (lambda: harmonics_of(CENTRED, 4, 0), "digits = 0: must be a whole number"),
        (lambda: force_harmonics(CENTRED, 4, "x"), "digits = 'x'"),
        (lambda: harmonics_of(SliderCrank("1.0000001"), 4), "lengthen the rod"),
        (lambda: offset_series(2, -1), "through = -1"),
        (lambda: offset_series(2, 401), "through = 401"),
        (lambda: RodSplit(-1, 1, 0, 0), "mass = -1: must not be negative"),
        (lambda: RodSplit(1, 0, 0, 0), "length = 0"),
        (lambda: RodSplit(1, 2, 3, 0), "centre = 3: must lie between the rod's ends"),
    ],
)
def test_bad_input_is_refused(make, message):
    with pytest.raises(SymbalanceError) as refusal:
        make()
    assert message in str(refusal.value)


def test_harmonics_fall_where_the_strip_says():
    """The widest strip of an offset slider-crank: |c_n| falls like e^(-a n), no slower and no faster."""
    sizes = [abs(c) for n, c in harmonics_of(OFFSET, 60).items() if n >= 20]
    ratios = [mp.log(a / b) for a, b in pairwise(sizes)]
    assert all(0 < r - OFFSET.strip < 0.1 for r in ratios)
