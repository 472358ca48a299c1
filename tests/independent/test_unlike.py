"""Engines whose cylinders are not alike, against pistons placed by intersecting circles and lines."""

from __future__ import annotations

import json
from fractions import Fraction

import numpy as np
import pytest
from mpmath import mp

import symbalance as sb
from symbalance.cli import run
from symbalance.engine.crank_train import CrankTrain, Link
from tests.placed import component, planar, planar_series

SHARED = CrankTrain(stroke=Fraction(90), rod=Fraction(164))


def narrow_six() -> sb.Engine:
    """Return a narrow vee: 15 degrees, axes 12.5 mm to either side of the crank, pins split by 22."""
    rows = []
    for number, pin in enumerate((0, 120, 240, 240, 120, 0), 1):
        odd = number % 2
        bank = Fraction(-15, 2) if odd else Fraction(15, 2)
        split = -11 if odd else 11
        offset = Fraction(-25, 2) if odd else Fraction(25, 2)
        rows.append(sb.Cylinder(number, pin + split, bank, Fraction(5, 2) - (number - 1), offset=offset))
    return sb.engine.from_cylinders(rows, crank_train=SHARED, name="narrow six")


def hung_radial(count: int = 5) -> sb.Engine:
    """Return a radial: one master rod, the others hung on it."""
    rows = [sb.Cylinder(1)]
    for i in range(1, count):
        bank = Fraction(360 * i, count)
        bank -= 360 * (bank > 180)
        rows.append(sb.Cylinder(i + 1, 0, bank, rod=Fraction(130), link=Link(1, bank, Fraction(34))))
    return sb.engine.from_cylinders(rows, crank_train=SHARED, name="hung radial")


def mixed_four() -> sb.Engine:
    """Return a four with one heavy and one short-stroke cylinder."""
    own = [{}, {"reciprocating_mass": Fraction(7, 10)}, {"stroke": 80, "rod": 150}, {}]
    throws, stations = (0, 180, 180, 0), (1.5, 0.5, -0.5, -1.5)
    rows = [
        sb.Cylinder(i + 1, throws[i], 0, Fraction(stations[i]), **own[i])  # pyright: ignore
        for i in range(4)
    ]
    train = CrankTrain(stroke=Fraction(90), rod=Fraction(164), reciprocating_mass=Fraction(1, 2))
    return sb.engine.from_cylinders(rows, crank_train=train, name="mixed four")


ENGINES = {"narrow six": narrow_six, "hung radial": hung_radial, "mixed four": mixed_four}


@pytest.mark.spread(2)
@pytest.mark.parametrize("name", ENGINES)
@pytest.mark.parametrize("arms", [False, True], ids=["force", "couple"])
def test_all_orders_together_are_the_pistons(name, arms):
    layout = ENGINES[name]()
    result = sb.balance(layout, 40)
    spectrum = result.couple if arms else result.force
    with mp.workdps(40):
        for theta in (mp.mpf("0.3"), mp.mpf("-2.1"), mp.mpf("4.4")):
            total = mp.mpc(0)
            for n in spectrum.orders():
                for unit, part in ((1, "vertical"), (1j, "lateral")):
                    cos, sin = spectrum.component(n, part).decimal(30)
                    total += unit * (cos * mp.cos(n * theta) + sin * mp.sin(n * theta))
            assert abs(total - planar(layout, theta, arms)) < mp.mpf(10) ** -15


@pytest.mark.slow
@pytest.mark.parametrize("name", ENGINES)
def test_functions_hold_the_same(name):
    layout = ENGINES[name]()
    outputs = ("force.vertical", "force.lateral", "couple.vertical")
    made = sb.to_function(sb.balance(layout, 30), outputs=outputs)
    theta = np.array([0.25, -3.0, 9.5])
    values = made(theta)
    with mp.workdps(30):
        for i, t in enumerate(theta):
            force, couple = planar(layout, mp.mpf(t), False), planar(layout, mp.mpf(t), True)
            assert abs(values["force.vertical"][i] - force.real) < 2e-15
            assert abs(values["force.lateral"][i] - force.imag) < 2e-15
            assert abs(values["couple.vertical"][i] - couple.real) < 2e-14


def test_what_cancels_among_like_cylinders_is_gone():
    """Three cylinders of each bank at 120 degrees: orders 1 and 2 of the force vanish exactly."""
    orders = sb.balance(narrow_six(), 12).force.orders()
    assert 1 not in orders
    assert 2 not in orders
    assert 3 in orders  # the offset brings odd orders


def test_the_narrow_vee_fires_evenly():
    """Split pins of 22 degrees make up for the bank angle and the dead centres the offset moves."""
    from symbalance.kinematics.mechanisms import dead_centres

    layout = narrow_six()
    tops = {}
    for cylinder in layout.cylinders[:2]:
        centre = dead_centres(cylinder.known_mechanism).top
        tops[cylinder.number] = float(centre) * 180 / np.pi - float(cylinder.delay.turns) * 360
    assert abs((tops[1] - tops[2] + 60) % 120 - 60) < 0.2  # modulo the crank's 120 degrees


def test_an_ideal_engine_stays_exact():
    plain = sb.balance(sb.load("inline-6"), 12)
    assert plain.kinematics is not None
    assert plain[6].coefficient is not None
    assert str(plain[6].force.vertical.cos) == "6"


FILE = """
name = "hung twin"
[crank_train]
stroke = 90
rod = 164
[[cylinder]]
number = 1
throw = 0
bank = -30
[[cylinder]]
number = 2
throw = {throw}
bank = 30
master = {master}
link_angle = 60
link_radius = {radius}
rod = {rod}
"""


def text(**changes: object) -> str:
    return FILE.format(**{"throw": 0, "master": 1, "radius": 30, "rod": 134, **changes})


def test_an_engine_file_of_link_rods(tmp_path, capsys):
    path = tmp_path / "twin.toml"
    path.write_text(text(), encoding="utf-8")
    for form in ("text", "latex", "json"):
        assert run(["balance", str(path), "--order", "4", "--format", form]) == 0
        out = capsys.readouterr().out
        if form == "json":
            written = json.loads(out)
            assert written["orders"][0]["coefficient"] is None
            assert written["cylinders"][1]["link"] == {"master": 1, "angle": "60", "radius": "2/3"}
            assert written["cylinders"][0]["ratio"] == "164/45"
        else:
            assert "rod of 1" in out
            assert "link pin" in out


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"throw": 10}, "a link rod shares its master's pin"),
        ({"master": 2}, "names no other cylinder"),
        ({"master": 7}, "names no other cylinder"),
        ({"radius": -3}, "must not be negative"),
        ({"rod": 40}, "for the rod to reach at every crank angle"),
        ({"rod": "134\nstroke = 80"}, "is not a link rod's to choose"),
        ({"rod": "0"}, "must be positive"),
    ],
)
def test_refusals_name_the_file(changes, words, tmp_path, capsys):
    path = tmp_path / "twin.toml"
    path.write_text(text(**changes), encoding="utf-8")
    assert run(["balance", str(path)]) == 2
    err = capsys.readouterr().err
    assert words in err
    assert err.count("\n") == 1


def test_sizes_some_have_and_others_not_are_refused():
    rows = [sb.Cylinder(1), sb.Cylinder(2, 180, reciprocating_mass=Fraction(1))]
    with pytest.raises(sb.SymbalanceError, match="given for some cylinders and not for others"):
        sb.balance(sb.engine.from_cylinders(rows, crank_train=SHARED))
    with pytest.raises(sb.SymbalanceError, match="needs the stroke"):
        sb.balance(sb.engine.from_cylinders([sb.Cylinder(1, offset=3)], ratio=4))
    with pytest.raises(sb.SymbalanceError, match="cannot be set"):
        sb.to_function(sb.balance(narrow_six()), ratio=4)


def near_the_limit() -> sb.Engine:
    """Return a twin whose rods nearly lie across: lambda 2.2, axes 1.1 r aside, one hung on the other."""
    rows = [
        sb.Cylinder(1, 0, -30, offset=Fraction(44)),
        sb.Cylinder(2, 0, 40, rod=Fraction(78), link=Link(1, Fraction(75), Fraction(12))),
    ]
    return sb.engine.from_cylinders(
        rows, crank_train=CrankTrain(stroke=Fraction(80), rod=Fraction(88)), name="limit"
    )


BOUNDED = {**ENGINES, "near the limit": near_the_limit}
NOTHING = 1e-12


@pytest.mark.slow
@pytest.mark.parametrize("tolerance", [1e-2, 1e-5, 1e-9])
@pytest.mark.parametrize("name", BOUNDED)
def test_what_a_tolerance_leaves_out_is_bounded(name, tolerance):
    """The bound is within the tolerance, holds at every angle, and is no more than thrice too large."""
    layout = BOUNDED[name]()
    outputs = ("force.vertical", "force.lateral", "couple.vertical", "force.forward")
    made = sb.to_function(sb.balance(layout, 1), outputs=outputs, tolerance=tolerance)
    every = sb.to_function(sb.balance(layout, 1), outputs=outputs, tolerance=0)
    theta = np.linspace(0, 2 * np.pi, 20_001)
    kept, whole = made(theta), every(theta)
    for output in outputs:
        if not every.amplitude[output]:
            continue
        lost = np.abs(whole[output] - kept[output]).max()
        bound = made.left_out[output]
        assert lost <= bound + 1e-14
        assert bound <= tolerance
        assert lost > 1e-13 / 3 or bound < 1e-12, (output, lost, bound)
        if lost > NOTHING:
            assert bound < 3 * lost, (output, bound / lost)


@pytest.mark.slow
@pytest.mark.parametrize("ratio", ["1.3", "2", "4"])
@pytest.mark.parametrize("aside", ["0", "1/2", "9/10"])
@pytest.mark.parametrize("order", [1, 2, 5, 12, 40])
def test_the_tail_is_bounded(ratio, aside, order):
    """Every harmonic above an order: the proved bound is above their sum."""
    from symbalance.kinematics.mechanisms import SliderCrank, force_harmonics, force_tail

    lam = Fraction(ratio)
    crank = SliderCrank(lam, (lam - 1) * Fraction(aside))
    found = force_harmonics(crank, 300 if lam < 2 or aside == "9/10" else 120, 30)
    with mp.workdps(30):
        rest = mp.fsum(mp.hypot(*pair) for n, pair in found.items() if n > order)
        assert rest <= force_tail(crank, order) <= 150 * order ** mp.mpf("1.5") * rest


def test_the_tail_of_a_link_rod_is_bounded():
    from symbalance.kinematics.mechanisms import force_harmonics, force_tail

    layout = near_the_limit()
    link = layout.cylinders[1].known_mechanism
    found = force_harmonics(link, 300, 30)
    for order in (1, 4, 20, 60):
        rest = mp.fsum(mp.hypot(*pair) for n, pair in found.items() if n > order)
        assert rest <= force_tail(link, order)


def test_sizes_said_one_by_one_cost_nothing():
    """The function of a four whose cylinders each say that they are not offset is the plain one."""
    from symbalance.bench.ideal_engine import functions, stripped, whole

    own, plain = functions()
    assert np.array_equal(own(), plain())
    assert whole().force.terms == stripped().force.terms


def listed_backwards() -> sb.Engine:
    """Return a twin whose second cylinder, of another mass and stroke, is listed first."""
    rows = [
        sb.Cylinder(2, 150, 0, "-1/2", reciprocating_mass=Fraction(7, 10), stroke=80),
        sb.Cylinder(1, 0, 0, "1/2"),
    ]
    train = CrankTrain(stroke=Fraction(90), rod=Fraction(164), reciprocating_mass=Fraction(1, 2))
    return sb.engine.from_cylinders(rows, crank_train=train, name="listed backwards")


def test_the_unit_is_cylinder_1_wherever_it_is_listed():
    backwards = listed_backwards()
    forwards = sb.Engine(backwards.cylinders[::-1])
    mine, other = (sb.balance(engine, 4)[1].force.vertical for engine in (backwards, forwards))
    assert mine.decimal(25) == other.decimal(25)
    assert "crank radius of cylinder 1\n" in sb.to_text(sb.balance(backwards, 2))
    tolerances = sb.design.Tolerances(mass=0.01)
    for one, two in zip(
        sb.worst_cases(backwards, tolerances, 2), sb.worst_cases(forwards, tolerances, 2), strict=True
    ):
        assert one.attained == pytest.approx(two.attained, rel=1e-12)
    torques = (sb.inertia_torque(engine, 3).terms(None, 20) for engine in (backwards, forwards))
    for ours, theirs in zip(*torques, strict=True):
        assert ours[0] == theirs[0]
        assert mp.almosteq(mp.mpc(*ours[1:]), mp.mpc(*theirs[1:]), rel_eps=mp.mpf(10) ** -15)


def test_an_engines_offset_is_a_link_rods_too():
    """What [crank_train] gives holds for every cylinder that does not say otherwise."""
    rows = [sb.Cylinder(1, 0, -30), sb.Cylinder(2, 0, 30, rod=134, link=Link(1, 60, 30))]
    said = [
        sb.Cylinder(c.number, 0, c.bank.in_degrees(), rod=c.sizes.rod, link=c.link, offset=6)
        for c in rows
    ]
    train = {"stroke": Fraction(90), "rod": Fraction(164)}
    shared = sb.engine.from_cylinders(rows, crank_train=CrankTrain(**train, offset=Fraction(6)))
    own = sb.engine.from_cylinders(said, crank_train=CrankTrain(**train))
    assert sb.balance(shared, 4).force.terms == sb.balance(own, 4).force.terms
    series, found = planar_series(shared, False), sb.balance(shared, 4).force
    for n in (1, 2, 3, 4):
        assert component(series, n, "lateral") == pytest.approx(found.component(n, "lateral").decimal(15))


def test_a_rod_that_nearly_lies_across_is_one_among_others():
    """Centred cylinders have their closed form, whatever lies beside them; here against quadrature."""
    ratios = (Fraction(45_000_001, 45_000_000), Fraction(4))
    rows = [sb.Cylinder(i, 30 * i, rod=45 * ratio) for i, ratio in enumerate(ratios, 1)]
    result = sb.balance(sb.engine.from_cylinders(rows, crank_train=CrankTrain(stroke=Fraction(90))), 8)
    with mp.workdps(30):
        ends = [0, mp.mpf("1.5"), mp.mpf("1.57"), mp.mpf("1.5707"), mp.pi / 2]
        for n in (2, 8):
            total = mp.mpc(0)
            for i, ratio in enumerate(ratios, 1):
                lam = mp.mpf(ratio.numerator) / ratio.denominator
                height = mp.quad(
                    lambda p, a=lam, n=n: mp.sqrt(a * a - mp.sin(p) ** 2) * mp.cos(n * p), ends
                )
                total += 4 * n * n / mp.pi * height * mp.expjpi(mp.mpf(n * i) / 6)
            cos, sin = result[n].force.vertical.decimal(25)
            assert mp.almosteq(mp.mpc(cos, -sin), total, 1e-15), n


@pytest.mark.parametrize(
    ("own", "words"),
    [
        ("offset = 119", "offset = 119: must lie within -119 and 119 mm"),
        ("reciprocating_mass = 0", "is 0 for cylinder 1"),
    ],
)
def test_sizes_that_cannot_be_are_refused_in_the_files_units(own, words, tmp_path, capsys):
    path = tmp_path / "twin.toml"
    path.write_text(
        f"[crank_train]\nstroke = 90\nrod = 164\nreciprocating_mass = 1\n"
        f"[[cylinder]]\nnumber = 1\nthrow = 0\n{own}\n[[cylinder]]\nnumber = 2\nthrow = 180\n",
        encoding="utf-8",
    )
    assert run(["balance", str(path)]) == 2
    err = capsys.readouterr().err
    assert words in err
    assert err.count("\n") == 1


def test_digits_do_not_depend_on_the_callers_precision():
    """Forces and derivatives hold 40 digits, of centred cylinders too, at mpmath's default 15."""
    layout = sb.engine.from_cylinders([sb.Cylinder(1), sb.Cylinder(2, 90, rod=150)], crank_train=SHARED)

    def found():
        numbers = [sb.balance(layout, 4).force.terms[n].value for n in (2, 4)]  # pyright: ignore
        return numbers + [s.factor for s in sb.sensitivities(layout, 4, parameters=["mass"])]

    plain = found()
    with mp.workdps(60):
        for coarse, fine in zip(plain, found(), strict=True):
            assert abs(coarse - fine) <= mp.mpf(10) ** -38 * abs(fine)
