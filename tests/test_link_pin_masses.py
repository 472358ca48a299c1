"""What a link rod's big end does, by a model of its own; until the library computes it, it is refused."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from cranks import engine, sheet
from link_pins import force_series

import symbalance as sb
from symbalance.cli import run
from symbalance.design.variations.weighed import parse_parts
from symbalance.engine.engine_file import parse_engine
from symbalance.engine.rotors import rotating_shares

NINE = sb.load("r-1820")
MASTER = "[[cylinder]]\nnumber = 1\nthrow = 0\n"
LINK = (
    "[[cylinder]]\nnumber = 2\nthrow = 0\nbank = 72\nmaster = 1\nlink_angle = 72\nlink_radius = 54\n"
    "rod = 186\n"
)


def train(mass: str = "") -> str:
    return f"[crank_train]\nstroke = 130\nrod = 240\nreciprocating_mass = 2\n{mass}\n"


def refusal(capsys, tmp_path, text: str, *command: str) -> str:
    path = tmp_path / "radial.toml"
    path.write_text(text, encoding="utf-8")
    assert run([command[0], str(path), *command[1:]]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err.count("\n") == 1
    return err.replace(str(tmp_path), "")


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
    rows += [sb.Cylinder(2, 0, 60, rod=160, link=sb.Link(1, 60, 0), rotating_mass="1/2")]
    sizes = sb.CrankTrain(stroke=Fraction(90), rod=Fraction(164), reciprocating_mass=Fraction(1))
    forked = sb.from_cylinders(rows, crank_train=sizes)
    found = force_series(forked, {2: 1.0})
    assert found[1] == pytest.approx(1)
    assert max(abs(c) for n, c in found.items() if n != 1) < 1e-10
    assert rotating_shares(forked) == [1, Fraction(1, 2)]
    changes = sb.sensitivities(forked, 1, parameters=["rotating"])
    assert [s.cylinder for s in changes] == [1, 2]


def test_files_refuse_a_link_rods_rotating_mass_where_it_stands(capsys, tmp_path):
    own = train() + MASTER + LINK + "rotating_mass = 0.5\n"
    said = refusal(capsys, tmp_path, own, "balance")
    assert "/radial.toml:17: rotating_mass = 1/2: of cylinder 2 would sit on its link pin" in said
    inherited = train("rotating_mass = 0.5") + MASTER + LINK
    for command in ("balance", "torque", "design", "tolerances", "sensitivities", "assign"):
        more = {"assign": ["--parts", "none.csv"], "tolerances": ["--mass", "1%"]}.get(command, [])
        said = refusal(capsys, tmp_path, inherited, command, *more)
        assert "/radial.toml:5: rotating_mass = 1/2: of cylinder 2" in said, command
    for text in (
        train("rotating_mass = 0.5") + MASTER + LINK + "rotating_mass = 0\n",
        train() + MASTER + "rotating_mass = 0.5\n" + LINK,
        train("rotating_mass = 0") + MASTER + LINK,
    ):
        path = tmp_path / "radial.toml"
        path.write_text(text, encoding="utf-8")
        assert run(["balance", str(path), "--order", "2"]) == 0
        capsys.readouterr()
        made = sb.load(str(path))
        assert parse_engine(sb.engine_text(made), "again.toml").cylinders == made.cylinders


def test_python_refuses_it_too():
    rows = [sb.Cylinder(1), sb.Cylinder(2, 0, 72, rod=186, link=sb.Link(1, 72, 54))]
    sizes = {"stroke": Fraction(130), "rod": Fraction(240), "reciprocating_mass": Fraction(2)}
    fine = sb.from_cylinders(rows, crank_train=sb.CrankTrain(**sizes))
    assert fine.link_pins == [2]
    with pytest.raises(sb.SymbalanceError, match="cylinder 2 would sit on its link pin"):
        sb.from_cylinders(rows, crank_train=sb.CrankTrain(**sizes, rotating_mass=Fraction(1, 2)))
    own = sb.Cylinder(2, 0, 72, rod=186, link=sb.Link(1, 72, 54), rotating_mass=1)
    with pytest.raises(sb.SymbalanceError, match="cylinder 2 would sit on its link pin"):
        sb.from_cylinders([rows[0], own], crank_train=sb.CrankTrain(**sizes))


def test_variations_of_rotating_masses_are_refused():
    with pytest.raises(sb.SymbalanceError, match="rotating: is of masses on the crank pin"):
        sb.sensitivities(NINE, 1, parameters=["mass", "rotating"])
    with pytest.raises(sb.SymbalanceError, match="rotating: is of masses on the crank pin"):
        sb.worst_cases(NINE, sb.Tolerances(mass="1%", rotating="1%"), 1)
    assert sb.sensitivities(NINE, 1, parameters=["mass"])
    rows = [f"{1 + i / 100},0.1,{{turning}}" for i in range(9)]
    text = "piston,rod_reciprocating,rod_rotating\n" + "\n".join(rows)
    for paired in (True, False):
        sets = parse_parts(text.format(turning="0.3"), "p.csv", paired=paired)
        for whole in (True, False):
            with pytest.raises(sb.SymbalanceError, match="rod_rotating: is of masses on the crank pin"):
                sb.assign_parts(NINE, sets, whole=whole)
    light = parse_parts(text.format(turning="0"), "p.csv", paired=True)
    assert len(sb.assign_parts(NINE, light).places) == 9


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
