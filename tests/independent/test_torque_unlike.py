"""Evidence: torque and roll of engines whose cylinders are not alike, by energy and moment of momentum.

The positions of pistons and of rods that are three points of mass come from intersecting circles and
lines (`placed`), as functions of the crank angle; kinetic energy and moment of momentum are summed
from them, differentiated numerically, and the frame's moment follows from the theorem of the moment of
momentum: none of that knows of series, of two-mass rods or of J_x. The running engine is held against
the area of its indicator diagram and against its harmonics.
"""

from __future__ import annotations

import json
import math
from fractions import Fraction

import pytest
from mpmath import mp

import symbalance as sb
from symbalance.cli import run
from symbalance.engine.crank_train import CrankTrain
from symbalance.kinematics.mechanisms import LinkRod, RodSplit, SliderCrank
from symbalance.kinematics.piston_motion import Piston
from symbalance.kinematics.rod_torque import (
    rocking_couple_series,
    rocking_couple_values,
    rod_torque_series,
    rod_torque_values,
)
from symbalance.torque import (
    gas_torque,
    ideal_cycle,
    inertia_torque,
    offset_moment,
    pressure_trace,
    rod_couple,
    rod_torque,
    roll_moment,
    running_torque,
    torque_report,
)
from tests.cylinders import cylinder_with
from tests.independent.test_unlike import SHARED, hung_radial, mixed_four, narrow_six
from tests.placed import along, exact, place
from tests.placed import rotated as direction

POINTS = ((Fraction(1, 3), Fraction(-1, 10)), (Fraction(1, 5), Fraction(2, 5)), (Fraction(1, 7), 1))
"""A rod: kg at shares of its length from the big end."""
MASS = Fraction(11, 20)


def rod_sizes(length: Fraction) -> dict[str, Fraction]:
    """Return the engine file's keys for a rod of those points, by plain arithmetic."""
    mass = sum((m for m, _ in POINTS), Fraction(0))
    centre = sum((m * x for m, x in POINTS), Fraction(0)) / mass
    inertia = sum((m * (x - centre) ** 2 for m, x in POINTS), Fraction(0)) * length**2
    return {"rod_mass": mass, "rod_centre": centre * length, "rod_inertia": inertia}


def offset_twin() -> sb.Engine:
    """Return two cylinders with unlike offsets, rods and strokes, and rods of three points."""
    train = CrankTrain(stroke=Fraction(90), rod=Fraction(164), reciprocating_mass=MASS)
    rows = [
        sb.Cylinder(1, 10, -15, 1, offset=Fraction(25, 2), **rod_sizes(Fraction(164))),
        sb.Cylinder(2, 190, 30, 0, offset=-7, stroke=84, rod=150, **rod_sizes(Fraction(150))),
    ]
    return sb.engine.from_cylinders(rows, crank_train=train, name="offset twin")


def centred_three() -> sb.Engine:
    """Return an in-line three, alike, whose rods are three points."""
    train = CrankTrain(
        stroke=Fraction(80), rod=Fraction(140), reciprocating_mass=MASS, **rod_sizes(Fraction(140))
    )
    return sb.engine.from_cylinders(
        [sb.Cylinder(i, 120 * i) for i in (1, 2, 3)], crank_train=train, name="three"
    )


RODDED = {"offset twin": offset_twin, "centred three": centred_three}


def moving(layout: sb.Engine, cylinder: sb.Cylinder, theta: mp.mpf) -> list[tuple[mp.mpf, mp.mpc]]:
    """Return (kg, place in mm) of everything that moves with a cylinder: piston, and the rod's points.

    The rod's two end masses by the textbook are taken out of piston and pin, so that the whole is the
    engine that `reciprocating_mass` tells of, with a rod of points instead of a rod of two masses.
    """
    train, axis = cylinder.sizes, direction(cylinder.bank)
    pin = exact(train.stroke / 2) * mp.expj(theta) * direction(cylinder.throw)
    beside = exact(Fraction(train.offset or 0))
    piston = mp.mpc(along(pin, axis, train.rod, train.offset or 0), beside) * axis
    points = [(exact(Fraction(m)), pin + exact(Fraction(x)) * (piston - pin)) for m, x in POINTS]
    split = RodSplit(train.rod_mass, train.rod, train.rod_centre, train.rod_inertia)
    rest = exact(train.reciprocating_mass) - exact(split.reciprocating)
    return [(rest, piston), *points]


def energy(layout: sb.Engine, theta: mp.mpf) -> mp.mpf:
    """Return the kinetic energy over omega^2, kg mm^2."""
    total = mp.mpf(0)
    for cylinder in layout.cylinders:
        for i in range(len(POINTS) + 1):
            mass = moving(layout, cylinder, theta)[i][0]
            speed = mp.diff(lambda t, c=cylinder, i=i: moving(layout, c, t)[i][1], theta)
            total += mass * abs(speed) ** 2 / 2
    return total


def momentum(layout: sb.Engine, theta: mp.mpf) -> mp.mpf:
    """Return the moment of momentum about the crank over omega, kg mm^2."""
    total = mp.mpf(0)
    for cylinder in layout.cylinders:
        for i in range(len(POINTS) + 1):
            mass, where = moving(layout, cylinder, theta)[i]
            speed = mp.diff(lambda t, c=cylinder, i=i: moving(layout, c, t)[i][1], theta)
            total += mass * (mp.conj(where) * speed).imag
    return total


def summed(terms, theta: mp.mpf) -> mp.mpf:
    waves = (c * mp.cos(mp.mpf(int(n)) * theta) + s * mp.sin(int(n) * theta) for n, c, s in terms)
    return mp.fsum(waves)


def scale(layout: sb.Engine) -> mp.mpf:
    """Return m r^2 of cylinder 1 in kg mm^2."""
    train = layout.cylinders[0]
    return exact((train.reciprocating_mass or 1) * (train.stroke / 2) ** 2)


@pytest.mark.slow
@pytest.mark.parametrize("name", RODDED)
def test_crank_and_frame_by_energy_and_moment_of_momentum(name: str) -> None:
    """The crank gets what the energy loses; the frame minus that and minus the change of momentum."""
    layout = RODDED[name]()
    inertia, rod, frame = (f(layout, 24) for f in (inertia_torque, rod_torque, roll_moment))
    excess = layout.cylinders[0].rod_split.excess
    with mp.workdps(40):
        for theta in (mp.mpf("0.4"), mp.mpf("2.9")):
            torque = -mp.diff(lambda t: energy(layout, t), theta)
            change = mp.diff(lambda t: momentum(layout, t), theta)
            found = summed(inertia.terms(digits=35), theta) * scale(layout)
            found += summed(rod.terms(digits=35), theta) * exact(excess)
            assert abs(found - torque) < mp.mpf(10) ** -9 * scale(layout)
            whole = summed(frame.terms(), theta) * scale(layout)
            assert abs(whole + torque + change) < mp.mpf(10) ** -9 * scale(layout)
            assert abs(change) > scale(layout) / 1000  # the frame does not get the opposite alone


ENGINES = {"narrow six": narrow_six, "hung radial": hung_radial, "mixed four": mixed_four}


@pytest.mark.slow
@pytest.mark.parametrize("name", ENGINES)
def test_inertia_torque_against_the_energy_of_placed_pistons(name: str) -> None:
    layout = ENGINES[name]()

    def kinetic(theta: mp.mpf) -> mp.mpf:
        total = mp.mpf(0)
        for cylinder in layout.cylinders:
            mass = exact(cylinder.reciprocating_mass or Fraction(1))
            total += mass * mp.diff(lambda t, c=cylinder: place(layout, c, t), theta) ** 2 / 2
        return total

    terms = inertia_torque(layout, 40).terms(digits=30)
    with mp.workdps(40):
        for theta in (mp.mpf("0.3"), mp.mpf("-2.1")):
            torque = -mp.diff(kinetic, theta) / scale(layout)
            assert abs(summed(terms, theta) - torque) < mp.mpf(10) ** -13


def test_harmonics_of_a_link_rod_by_fourier_transform() -> None:
    """Single orders, by the trapezoidal rule over the energy's derivative, to 16 digits."""
    layout = hung_radial(3)
    terms = {int(n): mp.mpc(c, s) for n, c, s in inertia_torque(layout, 9).terms(digits=30)}
    with mp.workdps(40):
        points = 64
        samples = []
        for i in range(points):
            theta = 2 * mp.pi * i / points
            speeds = [mp.diff(lambda t, c=c: place(layout, c, t), theta) for c in layout.cylinders]
            samples.append(mp.fsum(v**2 for v in speeds) / 2)
        for n in (1, 2, 3, 6, 9):
            turned_by = [mp.expjpi(mp.mpf(2 * n * i) / points) for i in range(points)]
            wave = 2 * mp.fsum(s * z for s, z in zip(samples, turned_by, strict=True)) / points
            expected = -n * mp.mpc(wave.imag, -wave.real)  # of minus the derivative
            assert abs(expected / scale(layout) - terms[n]) < mp.mpf(10) ** -16


def test_what_cancels_among_like_cylinders_is_gone() -> None:
    alike = sb.engine.from_cylinders(narrow_six().cylinders[::2], crank_train=SHARED)
    assert [o.order for o in inertia_torque(alike, 12).orders] == [3, 6, 9, 12]
    assert [o.order for o in offset_moment(alike, 12).orders] == [3, 6, 9, 12]


@pytest.mark.parametrize("ratio", [Fraction(4), Fraction(23, 20)])
def test_rod_values_against_quadrature_and_their_series(ratio: Fraction) -> None:
    with mp.workdps(40):
        lam = exact(ratio)

        def rate(p):
            return mp.cos(p) / mp.sqrt(lam**2 - mp.sin(p) ** 2)

        points = 300
        angles = [2 * mp.pi * i / points for i in range(points)]
        squares, rates = [rate(p) ** 2 for p in angles], [rate(p) for p in angles]
        for n, value in rod_torque_values(8, ratio, 30).items():
            wave = 2 * mp.fsum(s * mp.cos(n * p) for s, p in zip(squares, angles, strict=True)) / points
            assert abs(n * wave / 2 - value) < mp.mpf(10) ** -28
        for n, value in rocking_couple_values(7, ratio, 30).items():
            wave = 2 * mp.fsum(s * mp.cos(n * p) for s, p in zip(rates, angles, strict=True)) / points
            assert abs(-n * wave - value) < mp.mpf(10) ** -28
        if ratio == 4:
            for series, values in (
                (rod_torque_series, rod_torque_values),
                (rocking_couple_series, rocking_couple_values),
            ):
                for n, value in values(6, ratio, 30).items():
                    assert abs(exact(series(n, 60).at(ratio)) - value) < mp.mpf(10) ** -30


def test_without_offset_or_rods_the_frame_gets_the_opposite() -> None:
    layout = mixed_four()
    crank, frame = inertia_torque(layout, 6).terms(), roll_moment(layout, 6).terms()
    with mp.workdps(30):
        for (n, *on_crank), (m, *on_frame) in zip(crank, frame, strict=True):
            assert n == m
            assert max(abs(a + b) for a, b in zip(on_crank, on_frame, strict=True)) < mp.mpf(10) ** -25
    assert not rod_torque(layout, 6).components
    assert not rod_couple(layout, 6).components


# --- gas, running ---


def fired(layout: sb.Engine) -> sb.Engine:
    """Return a layout with firing angles: each cylinder at its own next dead centre of the first turn."""
    first = layout.cylinders[0].delay
    rows = [
        cylinder_with(c, fires=(first - c.delay).in_degrees() % 360 + 360 * (c.number % 2))
        for c in layout.cylinders
    ]
    return sb.Engine(rows, pitch=layout.pitch, name=layout.name)


CYCLE = ideal_cycle(10, heat=20, gamma="1.3")


@pytest.mark.slow
@pytest.mark.parametrize("name", [*ENGINES, "offset twin"])
def test_a_running_engine_does_the_work_of_its_cycles(name: str) -> None:
    """Mean torque from the swept volumes and the cycle's mean effective pressure; energy; harmonics."""
    layout = fired({**ENGINES, "offset twin": offset_twin}[name]())
    known = layout.cylinders[0].reciprocating_mass is not None
    mass = {} if known else {"reciprocating_mass": "0.55"}
    made = running_torque(layout, CYCLE, bore=80, rpm=3000, **mass)
    swept = 0.0
    for cylinder in layout.cylinders:
        ways = [float(place(layout, cylinder, mp.mpf(i) / 500)) for i in range(3200)]
        swept += (max(ways) - min(ways)) * 1e-3 * made.area
    assert made.work == pytest.approx(swept * CYCLE.mean_effective_pressure * 1e5, rel=3e-5)
    for theta in (0.3, 2.0, 9.0):
        power = (made.energy(theta + 1e-4) - made.energy(theta - 1e-4)) / 2e-4
        assert power == pytest.approx(made.at(theta) - made.mean, rel=1e-4, abs=0.05)
    angles = [made.cycle * (i + 0.5) / 4000 for i in range(4000)]
    values = [made.at(a) for a in angles]
    for n, cos, sin in made.terms(3):
        for function, coefficient in ((math.cos, cos), (math.sin, sin)):
            waves = (v * function(float(n) * a) for v, a in zip(values, angles, strict=True))
            assert float(coefficient) == pytest.approx(sum(waves) / 2000, abs=0.2)
    gas = gas_torque(layout, CYCLE, 3)
    assert gas.mean * made.area * made.radius * 1e5 == pytest.approx(made.mean, rel=1e-12)


@pytest.mark.slow
@pytest.mark.parametrize("name", RODDED)
def test_the_running_frame_is_the_crank_reversed_and_the_change_of_momentum(name: str) -> None:
    layout = fired(RODDED[name]())
    made = running_torque(layout, CYCLE, bore=80, rpm=3000)
    for theta in (0.4, 2.9):
        with mp.workdps(30):
            torque = -float(mp.diff(lambda t: energy(layout, t), theta)) * 1e-6 * made.omega**2
            change = float(mp.diff(lambda t: momentum(layout, t), theta)) * 1e-6 * made.omega**2
        assert made.inertia(theta) == pytest.approx(torque, rel=1e-9)
        assert made.frame(theta) == pytest.approx(-made.at(theta) - change, rel=1e-9)
        waves = (
            float(c) * math.cos(int(n) * theta) + float(s) * math.sin(int(n) * theta)
            for n, c, s in made.inertia_terms(24)
        )
        assert sum(waves) == pytest.approx(torque, rel=1e-9)


@pytest.mark.parametrize(
    "mechanism",
    [SliderCrank("3.4", "0.3"), LinkRod(SliderCrank(4, "1/10"), "1/5", "3/4", "13/4", "1/5", "1/20")],
)
def test_floating_pistons_against_geometry(mechanism) -> None:
    from symbalance.kinematics.mechanisms import height_motion, rod_motion

    piston = Piston(mechanism)
    with mp.workdps(30):
        for a in (0.0, 0.7, 3.0, 5.5):
            p = mp.mpf(a) + mp.mpf(piston.top)
            y, phi = height_motion(mechanism, p), rod_motion(mechanism, p)
            assert piston.velocity(a) == pytest.approx(-float(y.first), abs=1e-14)
            assert piston.acceleration(a) == pytest.approx(-float(y.second), abs=1e-13)
            assert piston.rod_rates(a) == pytest.approx((float(phi.first), float(phi.second)), abs=1e-13)
        waves = sum(
            2 * v * complex(math.cos(2.2 * m), math.sin(2.2 * m)) for m, v in piston.speeds.items()
        )
        assert waves.real == pytest.approx(piston.velocity(2.2), abs=1e-14)
    assert piston.velocity(0.0) == pytest.approx(0, abs=1e-14)
    assert piston.velocity(piston.down) == pytest.approx(0, abs=1e-13)
    assert piston.displacement(piston.down) == pytest.approx(piston.stroke, abs=1e-13)


def test_a_measured_trace_counts_from_each_pistons_own_top() -> None:
    """A pressure that is high from the top to the bottom alone works over the whole stroke."""
    layout = fired(offset_twin())
    trace = pressure_trace(range(0, 720, 2), [11 if a < 150 else 1 for a in range(0, 720, 2)])
    made = running_torque(layout, trace, bore=80, rpm=100)
    first = made.cylinders[0]
    assert first.tangential.at(0.0) == pytest.approx(0, abs=1e-12)
    p = -math.radians(10 + 15) + math.asin(12.5 / (164 + 45))  # theta of the first one's own top
    assert math.remainder(first.firing_angle - p, 2 * math.pi) == pytest.approx(0, abs=1e-12)


# --- the command ---

FILE = """
[crank_train]
stroke = 90
rod = 164
reciprocating_mass = 0.55
rod_mass = 0.6
rod_centre = 45
rod_inertia = 2900
offset = 12.5
[layout]
firing_order = [1, 5, 3, 6, 2, 4]
"""


def command(capsys, *arguments: str) -> str:
    assert run(["torque", *arguments]) == 0
    out, err = capsys.readouterr()
    assert err == ""
    return out


@pytest.mark.slow
def test_a_file_with_offset_and_rods(tmp_path, capsys, compile_latex) -> None:
    path = tmp_path / "six.toml"
    path.write_text(FILE, encoding="utf-8")
    options = (str(path), "--order", "3", "--compression", "10", "--bore", "81", "--rpm", "3000")
    text = command(capsys, *options)
    assert "−3.13 × 10⁻⁴ kg m²" in text
    assert "Roll moment on the frame" in text
    document = json.loads(command(capsys, *options, "--format", "json"))
    assert [o["order"] for o in document["inertia"]] == ["3"]
    assert document["inertia"][0]["coefficient"] is None
    assert document["rod"]["excess"] == "-313"
    assert document["frame"]["total"][0]["order"] == "3"
    compile_latex(command(capsys, *options, "--format", "latex", "--standalone"))


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("rod_centre = 45\n", "", "rod_mass, rod_inertia: belong together: rod_centre"),
        ("rod_centre = 45", "rod_centre = 200", "rod_centre = 200: must lie between the rod's ends"),
        ("rod_mass = 0.6", "rod_mass = -1", "rod_mass = -1: must not be negative"),
        ("rod = 164", "ratio = 4", "needs the rod's length"),
    ],
)
def test_half_a_rod_is_refused(old: str, new: str, words: str, tmp_path, capsys) -> None:
    path = tmp_path / "six.toml"
    text = FILE.replace(old, new).replace("offset = 12.5\n", "")
    path.write_text(text.replace("stroke = 90\n", "") if "ratio" in new else text, encoding="utf-8")
    assert run(["torque", str(path)]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert words in err
    assert err.startswith(f"symbalance: {path}:")
    assert err.count("\n") == 1


@pytest.mark.slow
@pytest.mark.parametrize("name", ["mixed four", "offset twin"])
def test_the_unit_is_cylinder_one_wherever_it_is_listed(name: str) -> None:
    """Forces, torque, rods, gas and functions are in cylinder 1's sizes, listed last as well."""
    layout = fired({"mixed four": mixed_four, "offset twin": offset_twin}[name]())
    turned_round = sb.Engine(reversed(layout.cylinders), pitch=layout.pitch, name=name)
    for of in (inertia_torque, roll_moment):
        found, expected = of(turned_round, 4), of(layout, 4)
        assert [o.order for o in found.orders] == [o.order for o in expected.orders]
        for (_, *ours), (_, *theirs) in zip(found.terms(), expected.terms(), strict=True):
            assert [float(x) for x in ours] == pytest.approx([float(x) for x in theirs], rel=1e-12)
    both = (layout, turned_round)
    pushes = [sb.to_function(sb.balance(e, 4), outputs="force.vertical")(0.7) for e in both]
    assert pushes[1] == pytest.approx(pushes[0], rel=1e-12)
    runs = [running_torque(e, CYCLE, bore=80, rpm=3000) for e in both]
    assert (runs[1].radius, runs[1].mass) == (runs[0].radius, runs[0].mass)
    assert runs[1].at(0.7) == pytest.approx(runs[0].at(0.7), rel=1e-12)


def test_the_legend_names_the_link_pins_angle_and_no_ratio_of_all() -> None:
    """Of a radial's torque: psi as a letter, and no lambda where every kind has its own."""
    latex = sb.to_latex(torque_report(hung_radial(), 2))
    assert r"\psi" in latex
    assert "?" not in latex
    assert r"\lambda" not in latex
    assert ", here 4" in sb.to_latex(torque_report(sb.load("inline-6"), 3, ratio=4))
