"""What a link rod's big end does, by a model of its own: in balance, torque, variations and functions."""

from __future__ import annotations

from fractions import Fraction
from itertools import product

import numpy as np
import pytest

import symbalance as sb
from symbalance.cli import run
from symbalance.design.variations.part_sets import parse_parts
from symbalance.engine.engine_file import parse_engine
from symbalance.kinematics.mechanisms.moving_masses import link_pin_path, link_pin_tail
from symbalance.torque import offset_moment
from tests.cranks import engine, sheet
from tests.cylinders import cylinder_with
from tests.link_pins import force_series, torque_and_moment

NINE = sb.load("r-1820")
MASTER = "[[cylinder]]\nnumber = 1\nthrow = 0\n"
LINK = (
    "[[cylinder]]\nnumber = 2\nthrow = 0\nbank = 72\nmaster = 1\nlink_angle = 72\nlink_radius = 54\n"
    "rod = 186\n"
)


def train(mass: str = "") -> str:
    return f"[crank_train]\nstroke = 130\nrod = 240\nreciprocating_mass = 2\n{mass}\n"


def test_big_ends_on_link_pins_have_orders_that_those_on_the_crank_pin_have_not():
    """Eight link big ends of an R-1820: on the crank pin they would be 8 m r w^2 forward, and no more."""
    found = force_series(NINE, dict.fromkeys(range(2, 10), 1.0))
    assert abs(found[1] - 8) > 0.1  # forward too is not what the crank pin has
    assert abs(found[-1]) == pytest.approx(0.118, abs=5e-4)
    assert abs(found[2]) == pytest.approx(0.030, abs=5e-4)
    assert abs(found[-2]) == pytest.approx(0.030, abs=5e-4)
    # By hand: the pins' directions sum to minus the master's own, so that 8 e^(i theta) - (L/r) e^(-i
    # phi) is left, sin phi = rho sin theta: rho L/2r and, times 2^2, rho^2 L/8r to the leading power.
    rho, arm = 174.625 / 2 / 349.25, 82.55 / (174.625 / 2)
    assert abs(found[-1]) == pytest.approx(rho * arm / 2, rel=0.01)
    assert abs(found[2]) == pytest.approx(4 * rho**2 * arm / 8, rel=0.03)


def test_a_link_pin_on_the_crank_pins_axis_is_the_crank_pin():
    """Fork and blade: there the mass does turn, and is taken."""
    rows = [sb.Cylinder(1, rotating_mass=1)]
    rows += [sb.Cylinder(2, 0, 60, rod=160, link=sb.engine.Link(1, 60, 0), rotating_mass="1/2")]
    sizes = sb.engine.CrankTrain(stroke=Fraction(90), rod=Fraction(164), reciprocating_mass=Fraction(1))
    forked = sb.engine.from_cylinders(rows, crank_train=sizes)
    found = force_series(forked, {2: 1.0})
    assert found[1] == pytest.approx(1)
    assert max(abs(c) for n, c in found.items() if n != 1) < 1e-10
    assert forked.rotating_sizes == (1, Fraction(1, 2))
    changes = sb.sensitivities(forked, 1, parameters=["rotating"])
    assert [s.cylinder for s in changes] == [1, 2]


def radial(reciprocating: str = "3", rotating: str = "2") -> sb.Engine:
    """Return an R-1820 with masses in kg."""
    sizes = f"reciprocating_mass = {reciprocating}\nrotating_mass = {rotating}\n"
    text = sb.engine.engine_text(NINE).replace("[crank_train]\n", f"[crank_train]\n{sizes}")
    return parse_engine(text, "radial.toml")


FORCES = ("force.vertical", "force.lateral")
LINKS = range(2, 10)
LIGHT, HEAVY = radial(rotating="0"), radial()
SHARES = dict.fromkeys(LINKS, 2 / 3)


def vee() -> sb.Engine:
    """Return an articulated vee whose link rods, axes and masses are not alike."""
    rows = [
        sb.Cylinder(1, 0, -30, "1/2", rotating_mass="1/4"),
        sb.Cylinder(2, 0, 35, "1/2", rod=160, link=sb.engine.Link(1, 60, 40), rotating_mass="1/2"),
        sb.Cylinder(3, 150, -30, "-1/2", offset=5),
        sb.Cylinder(
            4, 150, 35, "-1/2", rod=150, link=sb.engine.Link(3, 70, 45), offset=-3, rotating_mass="3/4"
        ),
    ]
    train = sb.engine.CrankTrain(
        stroke=Fraction(90), rod=Fraction(200), reciprocating_mass=Fraction(1, 2)
    )
    return sb.engine.from_cylinders(rows, crank_train=train)


def without_masses(layout: sb.Engine) -> sb.Engine:
    """Return an engine whose rotating masses are taken off."""
    return sb.Engine([cylinder_with(c, rotating_mass=None) for c in layout.cylinders])


VEE_SHARES = {2: 1.0, 4: 1.5}
CASES = {"radial": (HEAVY, LIGHT, SHARES), "vee": (vee(), without_masses(vee()), VEE_SHARES)}


@pytest.mark.slow
@pytest.mark.parametrize("case", CASES)
def test_forces_and_couples_have_what_link_pins_add_to_the_crank_pins_circle(case):
    heavy, light, shares = CASES[case]
    arms = {c.number: float(c.station) for c in heavy.cylinders}
    found, plain = sb.balance(heavy, 8), sb.balance(light, 8)
    for quantity, weights in (("force", dict.fromkeys(shares, 1.0)), ("couple", arms)):
        masses = {n: m * weights[n] for n, m in shares.items()}
        expected = force_series(heavy, masses)
        steady = sum(
            masses[c.number] * np.exp(2j * np.pi * float(c.throw.turns))
            for c in heavy.cylinders
            if c.number in masses
        )
        for n in (*range(-8, 0), *range(1, 9)):
            ours = complex_of(getattr(found, quantity), n) - complex_of(getattr(plain, quantity), n)
            assert ours == pytest.approx(expected[n] - (steady if n == 1 else 0), abs=1e-13), (
                quantity,
                n,
            )


def complex_of(spectrum, n: int) -> complex:
    number = spectrum.terms.get(n)
    return 0j if number is None else complex(number.evaluated())


@pytest.mark.slow
@pytest.mark.parametrize("case", CASES)
def test_torque_gives_back_their_energy_and_the_frame_gets_their_moment(case):
    heavy, light, shares = CASES[case]
    torque, moment = torque_and_moment(heavy, shares)
    parts = (
        (sb.inertia_torque(heavy, 8), sb.inertia_torque(light, 8), torque),
        (offset_moment(heavy, 8), offset_moment(light, 8), moment),
        (sb.torque.roll_moment(heavy, 8), sb.torque.roll_moment(light, 8), moment - torque),
    )
    for loaded, plain, expected in parts:
        for n in range(1, 9):
            ours = [
                complex(*map(float, of.components[n].decimal())) if n in of.components else 0j
                for of in (loaded, plain)
            ]
            assert ours[0] - ours[1] == pytest.approx(expected[n], abs=1e-12), n
    assert abs(torque[2]) > 1e-3  # there is something to find


@pytest.mark.slow
def test_with_counterweights_the_whole_of_them_counts():
    """One counterweight opposite the pin, of nothing: from then on rotating masses count themselves."""
    whole = sb.balance(HEAVY.balanced_by(sb.Counterweight(0, 0, unbalance=0)), 2)
    expected = force_series(HEAVY, SHARES)
    plain = sb.balance(LIGHT, 2)
    ours = complex_of(whole.force, 1) - complex_of(plain.force, 1)
    assert ours == pytest.approx(expected[1] + 2 / 3, abs=1e-13)  # and the master's on the crank pin
    assert complex_of(whole.force, -1) - complex_of(plain.force, -1) == pytest.approx(expected[-1])
    balanced = HEAVY.balanced_by(*(sb.Counterweight(throw=n, overbalance=0) for n in range(1, 10)))
    assert complex_of(sb.balance(balanced, 2).force, 1) == pytest.approx(
        complex_of(sb.balance(HEAVY, 2).force, 1)
    )


def test_a_counterweight_cannot_help_what_turns_against_the_crank():
    """The check of the eight big ends, in m_be r omega^2, through the command's own numbers."""
    found, plain = sb.balance(HEAVY, 4), sb.balance(LIGHT, 4)
    left = {n: (complex_of(found.force, n) - complex_of(plain.force, n)) / (2 / 3) for n in (-2, -1, 2)}
    assert [round(abs(left[n]), 3) for n in (-1, 2, -2)] == [0.118, 0.030, 0.030]


def test_sensitivities_are_the_differences_of_balance():
    """A gram more on one link pin: every order's change, against balances of two engines."""
    number, step = 4, Fraction(1, 1000)
    rows = [
        cylinder_with(c, rotating_mass=2 + (step if c.number == number else 0)) for c in HEAVY.cylinders
    ]
    changed, before = sb.balance(sb.Engine(rows), 3), sb.balance(HEAVY, 3)
    ours = {
        s.order: s for s in sb.sensitivities(HEAVY, 3, parameters=["rotating"]) if s.cylinder == number
    }
    assert sorted(ours) == [1, 2, 3]
    for n, one in ours.items():
        for sign, value in zip((1, -1), one.pair("force"), strict=True):
            change = complex_of(changed.force, sign * n) - complex_of(before.force, sign * n)
            steady = 1 if sign * n == 1 else 0  # taken as balanced with the engine's rotating masses
            assert change / float(step / 3) == pytest.approx(value - steady, abs=1e-9)


@pytest.mark.slow
def test_worst_cases_of_rotating_masses_are_the_worst_of_all_signs():
    found = sb.worst_cases(HEAVY, sb.design.Tolerances(rotating="1%"), 2)
    rotating = {w.order: w for w in found if w.quantity == "rotating force"}
    pairs = {
        n: [s.pair("force") for s in sb.sensitivities(HEAVY, n, parameters=["rotating"]) if s.order == n]
        for n in (1, 2)
    }
    for n, rows in pairs.items():
        a, b = (np.array([row[k] for row in rows]) * 0.01 for k in (0, 1))
        signs = np.array(list(product((-1, 1), repeat=len(rows))))
        most = (abs(signs @ a) + abs(signs @ b)).max()
        assert rotating[n].attained == pytest.approx(most, rel=1e-12)
        assert most <= rotating[n].bound * (1 + 1e-12)
    nominal = {w.order: w.nominal for w in found if w.quantity == "force"}
    force = sb.balance(HEAVY, 2).force
    assert nominal[2] == pytest.approx(abs(complex_of(force, 2)) + abs(complex_of(force, -2)))


def test_assignment_counts_big_ends_where_they_are():
    """Nine rods of nine big ends: the criterion of the listed order, from vectors of the model."""
    rows = [f"1,0.1,{0.3 + i * i / 100}" for i in range(9)]
    text = "piston,rod_reciprocating,rod_rotating\n" + "\n".join(rows)
    sets = parse_parts(text, "p.csv", paired=True)
    ours = sb.design.assign_parts(LIGHT, sets, orders=[1, 2])
    mean = sum(0.3 + i * i / 100 for i in range(9)) / 9
    off = {n: 0.3 + (n - 1) ** 2 / 100 - mean for n in range(1, 10)}
    series = force_series(LIGHT, {n: off[n] for n in LINKS})
    series[1] += off[1]  # the master's turns with the crank
    assert ours.as_listed == pytest.approx(
        sum(abs(series[n]) ** 2 for n in (-2, -1, 1, 2)) ** 0.5, rel=1e-9
    )


@pytest.mark.slow
def test_emitted_functions_hold_them():
    theta = np.linspace(0, 2 * np.pi, 50)
    result = sb.balance(HEAVY, 24)
    expected = force_series(HEAVY, SHARES)
    expected[1] -= 8 * 2 / 3
    light = sb.to_function(sb.balance(LIGHT, 24), outputs=FORCES)(theta)
    for options in ({}, {"tolerance": 0}, {"tolerance": 1e-6}):
        made = sb.to_function(result, outputs=FORCES, **options)
        change = [made(theta)[name] - light[name] for name in FORCES]
        vector = sum(expected[n] * np.exp(1j * n * theta) for n in expected if n)
        error = max(abs(change[0] - vector.real).max(), abs(change[1] - vector.imag).max())
        assert error < (2e-6 if options.get("tolerance") else 2e-9), options


def test_a_mass_on_a_link_pin_needs_a_mass_to_compare_with():
    text = sb.engine.engine_text(NINE).replace("[crank_train]\n", "[crank_train]\nrotating_mass = 2\n")
    line = text[: text.index("rotating_mass")].count("\n") + 1
    with pytest.raises(sb.SymbalanceError, match=rf"radial.toml:{line}: rotating_mass: counts in units"):
        parse_engine(text, "radial.toml")


def test_even_orders_of_their_moment_vanish_on_a_master_without_offset():
    """By hand: the part of the moment of momentum that half a turn leaves as it is, is a constant."""
    rows = [
        sb.Cylinder(1),
        sb.Cylinder(2, 0, 60, rod=150, link=sb.engine.Link(1, 67, 40), rotating_mass=1),
    ]
    train = sb.engine.CrankTrain(
        stroke=Fraction(90), rod=Fraction(200), reciprocating_mass=Fraction(1, 2)
    )
    for order in (3, 4, 12):
        found = offset_moment(sb.engine.from_cylinders(rows, crank_train=train), order)
        assert list(found.components) == list(range(1, order + 1, 2))
    _, moment = torque_and_moment(sb.engine.from_cylinders(rows, crank_train=train), {2: 2.0})
    assert max(abs(moment[n]) for n in (2, 4, 6)) < 1e-12 < abs(moment[1])
    mirrored = [
        sb.Cylinder(c.number + k, t, c.bank.in_degrees(), **given)
        for k, t in ((0, 0), (2, 180))
        for c, given in (
            (rows[0], {}),
            (rows[1], {"rod": 150, "link": sb.engine.Link(1 + k, 67, 40), "rotating_mass": 1}),
        )
    ]
    assert not offset_moment(sb.engine.from_cylinders(mirrored, crank_train=train), 12).components


def test_files_may_give_it_to_all_or_to_one_and_write_it_back(capsys, tmp_path):
    for text in (
        train("rotating_mass = 0.5") + MASTER + LINK,
        train() + MASTER + LINK + "rotating_mass = 0.5\n",
        train("rotating_mass = 0.5") + MASTER + LINK + "rotating_mass = 0\n",
    ):
        path = tmp_path / "radial.toml"
        path.write_text(text, encoding="utf-8")
        assert run(["balance", str(path), "--order", "2"]) == 0
        capsys.readouterr()
        made = sb.load(str(path))
        assert parse_engine(sb.engine.engine_text(made), "again.toml").cylinders == made.cylinders


RADIAL = "".join(
    f"[[cylinder]]\nnumber = {n}\nthrow = 0\nbank = {bank}\nfires = {fires}\n{link}"
    for n, bank, fires, link in (
        (1, 0, 0, ""),
        (2, 60, 420, "master = 1\nlink_angle = 58\nlink_radius = 50\nrod = 140\n"),
        (3, -75, 285, "master = 1\nlink_angle = -75\nlink_radius = 48\nrod = 144\n"),
    )
)
ROD = "rod_mass = 1.6\nrod_centre = 60\nrod_inertia = 11000"


@pytest.mark.parametrize(
    ("rods", "words"),
    [
        ("big_end_mass = 1.1", "big_end_mass = 1.1: of cylinder 2 would sit on its link pin"),
        (ROD, "rod_mass = 1.6: of cylinder 2 would sit on its link pin"),
    ],
)
def test_the_running_crankshaft_refuses_link_rods_big_ends(tmp_path, rods, words):
    text = sheet("", big_end_mass=rods) + RADIAL
    line = text[: text.index(rods.split("\n")[0])].count("\n") + 1
    with pytest.raises(sb.SymbalanceError, match=rf"engine.toml:{line}: {words}"):
        engine(tmp_path, text)
    made = engine(tmp_path, sheet("", big_end_mass="big_end_mass = 0") + RADIAL)
    assert made.operation.big_end_mass == made.operation.excess == 0


def test_the_running_crankshaft_takes_one_rods_inertia_for_like_rods_only(tmp_path):
    """The rods' masses and J_x were cylinder 1's for all, whatever the others' lengths are."""
    rows = "".join(
        f"[[cylinder]]\nnumber = {n}\nthrow = {t}\nstation = {-n}\nfires = {f}\n{rod}"
        for n, t, f, rod in ((1, 0, 0, ""), (2, 180, 180, "rod = 200\n"))
    )
    with pytest.raises(sb.SymbalanceError, match=r"rod_mass = 1\.6: is one rod's"):
        engine(tmp_path, sheet("", big_end_mass=ROD) + rows)
    assert engine(tmp_path, sheet("", big_end_mass="big_end_mass = 1") + rows)
    assert engine(tmp_path, sheet("", big_end_mass=ROD) + rows.replace("rod = 200\n", ""))


@pytest.mark.slow
def test_a_master_may_be_listed_after_its_link_rods(tmp_path):
    """Any place in the file: the fifth of nine was taken, the last was refused as not there."""
    rows = [f"[[cylinder]]\nnumber = {n}\nthrow = 0\nbank = {40 * n}\n" for n in range(1, 10)]
    head = "[crank_train]\nstroke = 131.7625\nrod = 263.525\n"
    forces = []
    for master in range(1, 10):
        text = head
        for n, row in enumerate(rows, 1):
            link = f"master = {master}\nlink_angle = {40 * (n - master)}\n"
            link += "link_radius = 66.675\nrod = 196.85\n"
            text += row + (link if n != master else "")
        path = tmp_path / "nine.toml"
        path.write_text(text, encoding="utf-8")
        forces.append(float(sb.balance(sb.load(str(path)), 2)[2].force.forward.amplitude))
    assert np.ptp(forces) < 1e-12


@pytest.mark.slow
@pytest.mark.parametrize("order", [1, 2, 5, 12])
def test_the_bound_on_what_a_truncation_leaves_out_holds(order):
    for cylinder in vee().cylinders:
        if cylinder.link:
            path = link_pin_path(cylinder.mechanism, order + 60)
            beyond = sum(n * n * abs(w) for n, w in path.items() if abs(n) > order)
            assert 0 < beyond <= link_pin_tail(cylinder.mechanism, order)


def test_tables_of_sensitivities_name_the_unit_and_what_stays(tmp_path, capsys):
    """The unit is the cylinder of the lowest number, whichever that is."""
    rows = "".join(f"[[cylinder]]\nnumber = {n}\nthrow = {t}\n" for n, t in ((7, 0), (4, 180)))
    path = tmp_path / "twin.toml"
    path.write_text(train("rotating_mass = 1") + rows, encoding="utf-8")
    assert run(["sensitivities", str(path), "--order", "1"]) == 0
    said = capsys.readouterr().out
    assert "crank radius of cylinder 4" in said
    assert "rotating masses stay where they are" in " ".join(said.split())
