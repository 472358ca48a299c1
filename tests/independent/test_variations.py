"""Formulas with symbols left in and sensitivities, against pistons that share no code with them."""

from __future__ import annotations

import json
import re
from fractions import Fraction
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st

import symbalance as sb
from symbalance.cli import run
from symbalance.document.nodes import Formulas
from symbalance.document.sympy_writer import formula_sympy
from tests.pistons import Piston, harmonics, pistons

LAYOUTS = ["inline-4", "inline-5", "v6-60", "v8-90", "boxer-4", "radial-5"]
STEP = 1e-5


def c_pair(resultant, n):
    """Return c_n and c_-n of a resultant with no symbol left."""
    found = []
    for name in ("forward", "backward"):
        part = getattr(resultant, name)
        found.append(complex(float(part.cos), float(part.sin)))
    return found[0].conjugate(), found[1]


@pytest.mark.parametrize("name", LAYOUTS)
@pytest.mark.parametrize("n", [1, 2, 4])
def test_masses_and_stations_as_symbols_are_the_pistons(name, n):
    layout, chance = sb.load(name), np.random.default_rng(7)
    order = sb.design.symbolic_order(layout, n, masses="m", stations="a")
    count = len(layout.cylinders)
    masses = [Fraction(int(x), 1000) for x in chance.integers(300, 600, count)]
    stations = [Fraction(int(x), 100) for x in chance.integers(-300, 300, count)]
    numbers = [c.number for c in layout.cylinders]
    values = {f"m_{k}": m for k, m in zip(numbers, masses, strict=True)}
    values |= {f"a_{k}": a for k, a in zip(numbers, stations, strict=True)}
    row = order.at(values)
    plane = sum(stations) / count
    engine = [
        p.changed(mass=float(m) - 1, station=float(a - plane) - p.station)
        for p, m, a in zip(pistons(layout), masses, stations, strict=True)
    ]
    factor = harmonics([Piston(1, 1, 4, 0, 0, 0, 0)])[n].real * 2
    for resultant, arms in ((row.force, False), (row.couple, True)):
        found = harmonics(engine, arms)
        ahead, against = c_pair(resultant, n)
        assert ahead * factor == pytest.approx(found[n], abs=1e-12)
        assert against * factor == pytest.approx(found[-n], abs=1e-12)


@pytest.mark.slow
@pytest.mark.parametrize("n", [1, 2, 3, 4])
def test_lengths_as_symbols_are_the_pistons(n):
    """Radii, rods and offsets of their own: the series to power 23 at r/l = 0.25, e/l < 0.06."""
    alpha = sympy.Rational(1, 3) * sympy.pi
    layout = sb.vee(alpha, pins=[0, 120, 240])
    sizes = [
        (1.0, 4.0, 0.2),
        (1.1, 4.4, -0.1),
        (0.9, 3.9, 0.0),
        (1.0, 4.1, 0.1),
        (1.0, 4.0, 0.15),
        (1.05, 4.2, 0),
    ]
    rows = [(0.5 + 0.01 * i, *s) for i, s in enumerate(sizes)]
    made = sb.design.symbolic_order(
        layout,
        n,
        masses="m",
        radii="r",
        rods=[str(s[1]) for s in sizes],
        offsets=[str(s[2]) for s in sizes],
        through=23,
    )
    values = {}
    for cylinder, (m, r, *_) in zip(layout.cylinders, rows, strict=True):
        values |= {f"m_{cylinder.number}": str(m), f"r_{cylinder.number}": str(r)}
    row = made.at(values)
    engine = [
        Piston(m, r, rod, e, p.throw, p.bank, p.station)
        for p, (m, r, rod, e) in zip(pistons(layout), rows, strict=True)
    ]
    for resultant, arms in ((row.force, False), (row.couple, True)):
        found = harmonics(engine, arms)
        ahead, against = c_pair(resultant, n)
        assert ahead == pytest.approx(found[n], abs=3e-9)
        assert against == pytest.approx(found[-n], abs=3e-9)


def test_zero_is_a_proof_with_symbols_in_it():
    """A seven whose masses are m and m + d in one cylinder: order 1 is d alone, in every component."""
    m, d = sympy.symbols("m d")
    one = sb.design.symbolic_order(sb.inline("1-2-3-4-5-6-7"), 1, masses=[m + d, *[m] * 6])
    assert one.symbols() == {d, m}  # the couple has m
    assert one.force.vertical.cos == d
    assert one.force.vertical.sin == 0
    assert one.force.lateral.is_zero()
    assert one.at({d: 0}).force.is_zero()
    assert not one.at({d: 0}).couple.is_zero()


def test_a_bank_angle_and_masses_stay_symbols_together():
    alpha, m = sympy.Symbol("alpha"), sympy.Symbol("m")
    twin = sb.design.symbolic_order(sb.vee(alpha, pins=[0]), 1, masses=[m, 1])
    value = twin.force.vertical.cos.subs({alpha: sympy.pi / 2, m: 3})
    engine = [
        p.changed(mass=w) for p, w in zip(pistons(sb.vee(sympy.pi / 2, pins=[0])), (2, 0), strict=True)
    ]
    found = harmonics(engine)
    assert float(value) == pytest.approx((found[1].conjugate() + found[-1]).real, abs=1e-12)
    assert float(twin.force.lateral.sin.subs({alpha: sympy.pi / 2, m: 3})) == pytest.approx(
        (1j * (found[1].conjugate() - found[-1])).imag, abs=1e-12
    )


@given(
    st.lists(st.integers(1, 50), min_size=4, max_size=4),
    st.lists(st.integers(1, 50), min_size=4, max_size=4),
)
@settings(max_examples=20, deadline=None)
def test_the_force_is_linear_in_the_masses(first, second):
    layout = sb.inline("1-3-4-2")

    def pair(masses):
        row = sb.design.symbolic_order(layout, 1, masses=masses)
        return row.force.vertical.cos, row.couple.vertical.cos

    both = pair([x + 2 * y for x, y in zip(first, second, strict=True)])
    assert both == tuple(x + 2 * y for x, y in zip(pair(first), pair(second), strict=True))


def test_the_derivative_of_the_formula_is_the_sensitivity():
    layout = sb.load("v8-90")
    whole = sb.design.symbolic_order(layout, 2, masses="m")
    for one in sb.sensitivities(layout, 2, parameters=["mass"]):
        if one.order == 2:
            slope = whole.differentiated(sympy.Symbol(f"m_{one.cylinder}", real=True))
            assert slope.force.vertical.cos == one.force.vertical.cos
            assert slope.couple.lateral.sin == one.couple.lateral.sin


CHANGES = {
    "mass": ("mass", 1), "throw": ("throw", 1), "bank": ("bank", 1), "station": ("station", 1),
    "stroke": ("radius", 1), "rod": ("rod", 1), "offset": ("offset", 1),
}  # fmt: skip


@pytest.mark.spread(2)
@pytest.mark.parametrize("name", LAYOUTS)
def test_sensitivities_are_finite_differences_of_pistons(name):
    """Every derivative, of every cylinder, to order 4: also of orders that cancel as drawn."""
    layout = sb.load(name).with_ratio(4)
    engine, seen = pistons(layout), 0
    place = {c.number: i for i, c in enumerate(layout.cylinders)}
    differences = {}
    for i, piston in enumerate(engine):
        for parameter, (key, _) in CHANGES.items():
            pair = [piston.changed(**{key: h}) for h in (STEP, -STEP)]
            differences[i, parameter] = [
                (harmonics([pair[0]], arms) - harmonics([pair[1]], arms)) / (2 * STEP)
                for arms in (False, True)
            ]
    for one in sb.sensitivities(layout, 4):
        force, couple = differences[place[one.cylinder], one.parameter]
        for signed, value in zip((one.order, -one.order), one.values, strict=True):
            assert value * one.weight("force") == pytest.approx(force[signed], abs=2e-8)
            assert value * one.weight("couple") == pytest.approx(couple[signed], abs=6e-8)
        seen += 1
    # mass, throw, bank, station, stroke at 1, 2, 4; rod at 2, 4; offset at 1, 3
    assert seen == len(engine) * (5 * 3 + 2 + 2)


def test_sensitivities_of_unlike_cylinders_are_finite_differences_of_balance():
    def layout(extra=0):
        rows = [
            sb.Cylinder(1, 0, -10, "1/2", offset=5, reciprocating_mass=Fraction(1, 2) + extra),
            sb.Cylinder(2, 120, 10, 0, offset=-5),
            sb.Cylinder(3, 240, -10, "-1/2", stroke=80),
        ]
        train = sb.engine.CrankTrain(
            stroke=Fraction(90), rod=Fraction(150), reciprocating_mass=Fraction(1, 2)
        )
        return sb.engine.from_cylinders(rows, crank_train=train)

    # the unit is m r omega^2 of cylinder 1: change cylinder 1's mass and read in the old unit
    h = Fraction(1, 10**6)
    high, low = (sb.balance(layout(s * h / 2), 3) for s in (1, -1))
    found = [s for s in sb.sensitivities(layout(), 3, parameters=["mass"]) if s.cylinder == 1]
    assert [s.order for s in found] == [1, 2, 3] or len(found) == 3
    for one in found:
        for signed, value in zip((one.order, -one.order), one.values, strict=True):
            up, down = (
                complex(b.force.terms[signed].value) * float(1 + s * h) for b, s in ((high, 1), (low, -1))
            )
            assert value == pytest.approx((up - down) / float(2 * h), abs=1e-9)


@pytest.mark.slow
def test_link_rods_have_the_sensitivities_that_are_theirs():
    hung = sb.Cylinder(2, 0, 60, link=sb.engine.Link(1, 60, 30), rod=134)
    train = sb.engine.CrankTrain(stroke=Fraction(90), rod=Fraction(164))
    layout = sb.engine.from_cylinders([sb.Cylinder(1, 0, 0), hung], crank_train=train)
    found = sb.sensitivities(layout, 2)
    assert {s.parameter for s in found if s.cylinder == 2} == {"mass", "station", "bank", "rod", "offset"}
    whole = sb.balance(layout, 2)
    for n in (1, -1, 2, -2):
        total = sum(
            s.values[0 if n > 0 else 1] for s in found if s.parameter == "mass" and s.order == abs(n)
        )
        assert total == pytest.approx(complex(whole.force.terms[n].value), abs=1e-12)


def test_formulas_refuse_what_one_series_does_not_fit():
    """Link rods have no series in r/l; unequal strokes or rods no A_n in common."""
    train = sb.engine.CrankTrain(stroke=Fraction(90), rod=Fraction(164))
    for own in ({"stroke": 80}, {"rod": 150}, {"stroke": 80, "rod": 150}, {"offset": 3}):
        layout = sb.engine.from_cylinders(
            [sb.Cylinder(1), sb.Cylinder(2, 180, 0, -1, **own)], crank_train=train
        )
        with pytest.raises(sb.SymbalanceError, match="not alike"):
            sb.design.symbolic_order(layout, 2, masses="m")
        assert not sb.design.symbolic_order(layout, 2, masses="m", rods="l").force.is_zero()
    hung = sb.engine.from_cylinders(
        [sb.Cylinder(1), sb.Cylinder(2, 0, 60, link=sb.engine.Link(1, 60, 30), rod=134)],
        crank_train=train,
    )
    for lengths in ({}, {"rods": "l"}):
        with pytest.raises(sb.SymbalanceError, match="cylinder 2 on a link rod"):
            sb.design.symbolic_order(hung, 2, masses="m", **lengths)
    heavy = sb.engine.from_cylinders(
        [sb.Cylinder(1), sb.Cylinder(2, 180, reciprocating_mass=2)], crank_train=train
    )
    assert str(sb.design.symbolic_order(heavy, 2, masses="m").force.vertical.cos) == "m_1 + m_2"


STEPPED = {
    "throw": np.pi / 18000,
    "bank": np.pi / 18000,
    "stroke": 0.01 / 45,
    "rod": 0.01 / 45,
    "offset": 0.01 / 45,
}
"""One step of `hung_engine`: radians, or crank radii of cylinder 1."""


def hung_engine(number=0, name="", steps=0):
    """Return a cylinder beside a master with an articulated and a forked rod; one size is changed.

    A step is a hundredth of a degree, or 0.01 mm (of the stroke: of its half).
    """
    sizes: dict[int, dict[str, Any]] = {
        1: {"throw": 40, "bank": 0, "stroke": 90, "rod": 164, "offset": 0},
        2: {"throw": 100, "bank": -20, "stroke": 96, "rod": 170, "offset": 4},
        3: {"throw": 100, "bank": 25, "rod": 131, "offset": -3},
        4: {"throw": 100, "bank": 70, "rod": 165, "offset": 0},
    }
    moved = [2, 3, 4] if (number, name) == (2, "throw") else [number]
    for one in moved:
        if steps:
            sizes[one][name] += Fraction(steps * (2 if name == "stroke" else 1), 100)
    links = {3: sb.engine.Link(2, 41, 36), 4: sb.engine.Link(2, 0, 0)}
    rows = []
    for place, (key, own) in enumerate(sizes.items()):
        station = Fraction((1, 0, "-1/4", "-3/4")[place])
        rows.append(sb.Cylinder(key, station=station, link=links.get(key), **own))
    return sb.Engine(rows)


@pytest.mark.slow
def test_sensitivities_of_masters_and_link_rods_are_finite_differences_of_pistons():
    """A master's sizes move what hangs on it, each at its own station; all orders to 5, both vectors."""
    from tests.placed import planar_series

    found = {(s.parameter, s.cylinder, s.order): s for s in sb.sensitivities(hung_engine(), 5)}
    for number, names in {1: STEPPED, 2: STEPPED, 3: ("bank", "rod", "offset"), 4: ("bank",)}.items():
        for name in names:
            if name == "stroke" and number == 1:  # the unit itself
                continue
            for quantity in ("force", "couple"):
                far, up, down, near = (
                    planar_series(hung_engine(number, name, h), quantity == "couple")
                    for h in (2, 1, -1, -2)
                )
                slope = (8 * (up - down) - (far - near)) / (12 * STEPPED[name])
                for n in range(1, 6):
                    one = found.get((name, number, n))
                    pair = (0j, 0j) if one is None else one.pair(quantity)
                    assert pair == pytest.approx((slope[n], slope[-n]), abs=3e-8), (name, number, n)


@pytest.mark.slow
@pytest.mark.parametrize("ratio", ["1.001", "1.05", 4, 1000])
def test_slopes_obey_the_scale_of_the_mechanism(ratio):
    """r f is homogeneous of degree 1: its derivatives times r, l and e add up to it, at every order."""
    from symbalance.design.variations.length_derivatives import length_derivatives
    from symbalance.kinematics.mechanisms import SliderCrank

    mechanism = SliderCrank(Fraction(ratio), Fraction(ratio) / 10**4)
    for n, (value, stroke, rod, offset) in length_derivatives(mechanism, 6).items():
        left = stroke + rod * float(mechanism.ratio) + offset * float(mechanism.offset)
        assert abs(left - value) <= 1e-9 * (abs(value) + abs(stroke)), n


def test_extremes_of_size():
    many = sb.inline("-".join(map(str, range(1, 25))))
    assert len(sb.sensitivities(many.with_ratio(3), 2, parameters=["mass"])) == 48
    single = sb.sensitivities(sb.inline("1", ratio=4), 1, parameters=["mass", "rotating"])
    assert [s.largest for s in single] == [(1.0, 0.0), (1.0, 0.0)]
    high = sb.sensitivities(sb.inline("1", ratio=4), 1000, parameters=["mass"])
    assert high[-1].order == 1000
    assert 0 < float(high[-1].factor.__abs__()) < 1e-300 or float(high[-1].factor) == 0
    assert sb.design.symbolic_order(sb.inline("1"), 1000, masses="m").force.vertical.cos == sympy.Symbol(
        "m_1", real=True
    )


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"masses": [1, 2]}, "the engine has 4 cylinders"),
        ({"masses": "m 1"}, "must be a letter or a list"),
        ({"masses": 3}, "must be a list"),
        ({"masses": [sympy.sin(sympy.Symbol("x"))] * 4}, "must be a polynomial"),
        ({"masses": [sympy.Symbol("x") ** 0.5] * 4}, "must be a polynomial"),
        ({"masses": ["nan"] * 4}, "must be a number"),
        ({"radii": "r"}, "rods: are not given"),
        ({"radii": "r", "rods": [sympy.Symbol("l") + 1] * 4}, "must be one number or one symbol"),
        ({"rods": [0] * 4}, "must be one number or one symbol"),
        ({"rods": "l", "through": 0}, "is the least"),
        ({"rods": "l", "through": -1}, "must be a whole number"),
        ({"order": 0}, "order"),
    ],
)
def test_bad_formulas_are_refused(arguments, words):
    arguments = {"order": 2, **arguments}
    with pytest.raises(sb.SymbalanceError, match=words):
        sb.design.symbolic_order(sb.inline("1-3-4-2"), **arguments)


def test_other_refusals():
    with pytest.raises(sb.SymbalanceError, match="must be an Engine"):
        sb.design.symbolic_order("inline-4", 1)  # type: ignore[arg-type]
    with pytest.raises(sb.SymbalanceError, match="not alike"):
        sb.design.symbolic_order(
            sb.engine.from_cylinders(
                [sb.Cylinder(1, offset=2)],
                crank_train=sb.engine.CrankTrain(stroke=Fraction(9), rod=Fraction(20)),
            ),
            1,
        )
    with pytest.raises(sb.SymbalanceError, match="is no parameter"):
        sb.sensitivities(sb.load("inline-4"), parameters=["colour"])
    with pytest.raises(sb.SymbalanceError, match="has no rod ratio"):
        sb.sensitivities(sb.inline("1-3-4-2"))
    with pytest.raises(sb.SymbalanceError, match="symbols for angles"):
        sb.sensitivities(sb.vee(sympy.Symbol("alpha"), pins=[0], ratio=4))
    with pytest.raises(sb.SymbalanceError, match="was not given"):
        sb.design.symbolic_order(sb.inline("1"), 1, masses="m").at({"x": 1})
    with pytest.raises(sb.SymbalanceError, match="must map symbols"):
        sb.design.symbolic_order(sb.inline("1"), 1, masses="m").at([1])  # type: ignore[arg-type]
    with pytest.raises(sb.SymbalanceError, match="is divided by"):
        sb.design.symbolic_order(sb.inline("1"), 2, rods="l").at({"l_1": 0})


def test_the_command(capsys, tmp_path, golden):
    assert run(["sensitivities", "inline-4", "--order", "2", "--parameters", "mass,throw"]) == 0
    out = capsys.readouterr().out
    assert "0.0174533" in out  # a degree of a throw, in order 1 that cancels as drawn
    golden("sensitivities-inline-4.txt", out)
    assert run(["sensitivities", "inline-4", "--order", "2", "--format", "json"]) == 0
    document = json.loads(capsys.readouterr().out)
    mass = [s for s in document["sensitivities"] if s["parameter"] == "mass" and s["order"] == "2"]
    assert [s["force"]["vertical"] for s in mass] == [{"cos": "1", "sin": "0"}] * 4
    assert all(s["factor"].startswith("0.25402504") for s in mass)
    assert (
        run(
            [
                "sensitivities",
                "v6-60",
                "--ratio",
                "3.5",
                "--format",
                "latex",
                "-o",
                str(tmp_path / "s.tex"),
            ]
        )
        == 0
    )
    assert r"\toprule" in (tmp_path / "s.tex").read_text(encoding="utf-8")
    assert run(["sensitivities", "inline-4", "--parameters", "colour"]) == 2
    assert "is no parameter" in capsys.readouterr().err


@pytest.mark.slow
def test_an_order_with_symbols_is_typeset(compile_latex, golden):
    alpha = sympy.Symbol("alpha")
    twin = sb.to_latex(sb.design.symbolic_order(sb.vee(alpha, pins=[0]), 1, masses="m"), standalone=True)
    golden("symbolic-order-vee.tex", twin)
    letters = {"masses": "m", "radii": "r", "rods": "l", "offsets": "e"}
    three = sb.to_latex(
        sb.design.symbolic_order(sb.inline("1-3-2"), 2, through=3, **letters), standalone=True
    )
    golden("symbolic-order-lengths.tex", three)
    for page in (twin, three):
        compile_latex(page)


M, D = sympy.symbols("m d")
TYPESET = {
    "vee of any angle": (sb.vee(sympy.Symbol("alpha"), pins=[0, 120]), 2, {"masses": "m"}),
    "lengths": (sb.inline("1-3-2"), 1, {"masses": "m", "rods": "l", "offsets": "e", "through": 4}),
    "irrational": (sb.inline("1-2-4-5-3"), 2, {"masses": "m", "stations": "a"}),
    "few symbols": (sb.inline("1-2-3-4-5-6-7"), 1, {"masses": [M + D, D, *[M] * 5]}),
    "none": (sb.load("v8-90"), 1, {"masses": [1, 2, 3, 4, 5, 6, 7, 8]}),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", TYPESET)
def test_the_formulas_of_a_document_are_those_of_the_order(name):
    """Their terms are ordered and their fractions built anew: numbers put into both agree."""
    engine, n, letters = TYPESET[name]
    order = sb.design.symbolic_order(engine, n, **letters)
    blocks = [block for block in order.document().blocks if isinstance(block, Formulas)]
    formulas = iter(each.links[0][1] for block in blocks for each in block.equations)
    count = 0
    for resultant in (order.force, order.couple):
        for component in (resultant.vertical, resultant.lateral):
            for value in (component.cos, component.sin):
                if value == 0:
                    continue
                written = formula_sympy(next(formulas))
                numbers = {
                    symbol: 1 + sympy.Rational(sum(map(ord, symbol.name)) % 37, 40)
                    for symbol in value.free_symbols | written.free_symbols
                }
                assert float(written.subs(numbers)) == pytest.approx(
                    float(value.subs(numbers)), rel=1e-12
                )
                count += 1
    assert count > 1
    assert next(formulas, None) is None


def test_an_order_says_what_was_put_in_and_what_it_is_the_derivative_by(golden):
    order = sb.design.symbolic_order(sb.inline("1-3-4-2"), 1, masses="m", stations="a")
    text = sb.to_text(
        order.at({"m_1": "1/3", "a_2": 2}).at({"m_2": 1}).differentiated(order.all_symbols[2])
    )
    assert "derivative by m₃" in text.splitlines()[0]
    assert "m₁ = 1/3, a₂ = 2, m₂ = 1" in text
    assert "unit A₁ r ω²\n" in text  # neither m nor a: masses and stations are given
    plain = sb.to_text(sb.design.symbolic_order(sb.inline("1-3-4-2"), 1, radii="r", rods="l"))
    golden("symbolic-order-lengths.txt", plain)


def test_every_sensitivity_stands_in_one_row_of_the_text():
    """Cylinders that change alike share a row: those of all rows are those of the result."""
    result = sb.sensitivities(sb.load("v6-90-splayed"), 3)
    rows = [re.split("  +", line.strip()) for line in sb.to_text(result, width=100).splitlines()]
    steps = {
        (int(row[0]), row[1], number): row[-2:]
        for row in rows
        if len(row) == 6 and row[0].isdecimal()
        for number in numbers_of(row[3])
    }
    assert len(steps) == len(result) > 60
    for change in result:
        written = steps[change.order, change.parameter, change.cylinder]
        values = [float(cell.translate(RAISED).replace(" × 10", "e")) for cell in written]
        assert values == pytest.approx(change.step(), rel=1e-5, abs=1e-30)


RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻−", "0123456789--")


def numbers_of(runs: str) -> list[int]:
    ends = [tuple(map(int, run.split("–"))) for run in runs.split(", ")]
    return [number for run in ends for number in range(run[0], run[-1] + 1)]


def test_results_are_sequences():
    """What was a list can be used as one: by index, slice, length, in loops, reversed."""
    changes = sb.sensitivities(sb.load("inline-4"), 2, parameters=["mass"])
    worst = sb.worst_cases(sb.load("inline-4"), sb.design.Tolerances(mass="1%"), 2)
    for sequence, count in ((changes, 8), (worst, 4)):
        assert len(sequence) == len(list(sequence)) == count
        assert sequence[0] is next(iter(sequence))
        assert next(reversed(sequence)) is sequence[-1]
        assert sequence[1:3] == tuple(sequence)[1:3]
        assert sequence.index(sequence[2]) == 2


def linked(changes: dict[str, Fraction] | None = None, of: int = 1) -> sb.Engine:
    """Return a master with its link rod, and a rod of its own, sizes of one of them changed."""
    table = {
        1: {"throw": 20, "bank": -10, "stroke": 90, "rod": 164, "offset": 5},
        2: {"throw": 20, "bank": 50, "rod": 134, "offset": 0},
        3: {"throw": 200, "bank": 0, "stroke": 80, "rod": 150, "offset": -4},
    }
    rows = {number: {k: Fraction(v) for k, v in sizes.items()} for number, sizes in table.items()}
    for name, change in (changes or {}).items():
        rows[of][name] += change
        if of == 1 and name == "throw":
            rows[2]["throw"] += change
    cylinders = []
    for number, sizes in rows.items():
        own = {k: v for k, v in sizes.items() if k not in ("throw", "bank")}
        if number == 2:
            own["link"] = sb.engine.Link(1, 60, 30)
        cylinders.append(
            sb.Cylinder(
                number, sizes["throw"], sizes["bank"], number, reciprocating_mass=Fraction(1, 2), **own
            )
        )
    return sb.engine.from_cylinders(cylinders)


@pytest.mark.spread(3)
@pytest.mark.parametrize(
    ("of", "name"),
    [
        *((1, name) for name in ("stroke", "rod", "offset", "throw")),
        *((2, name) for name in ("rod", "offset", "bank")),
        *((3, name) for name in ("rod", "stroke", "bank")),
    ],
)
def test_a_sensitivity_is_the_balance_of_a_slightly_changed_engine(of, name):
    """Of masters, link rods and rods of their own, in every order: central differences of `balance`."""
    step = Fraction(1, 100)
    spectra = [sb.balance(linked({name: sign * step}, of), 4) for sign in (1, -1)]
    angle = name in ("throw", "bank")
    by = np.radians(float(2 * step)) if angle else float(2 * step) / 45
    if name == "stroke":
        by /= 2  # in crank radii, as the radius grows
    changes = [
        s
        for s in sb.sensitivities(linked(), 4, parameters=[name])
        if (s.cylinder, s.parameter) == (of, name)
    ]
    plane = linked().mean_station
    assert plane == 2
    for n in range(1, 5):
        ours = [s for s in changes if s.order == n]
        for quantity in ("force", "couple"):
            ends = [getattr(b, quantity).terms for b in spectra]
            by_hand = [
                (complex(ends[0][k].evaluated()) - complex(ends[1][k].evaluated())) / by
                if k in ends[0]
                else 0j
                for k in (n, -n)
            ]
            if of == 1 and name == "stroke":  # m r omega^2 of cylinder 1 is the unit, and grows as well
                middle = getattr(sb.balance(linked(), 4), quantity).terms
                by_hand = [
                    x + (complex(middle[k].evaluated()) if k in middle else 0)
                    for x, k in zip(by_hand, (n, -n), strict=True)
                ]
            pair = ours[0].pair(quantity) if ours else (0j, 0j)
            assert pair == pytest.approx(by_hand, rel=1e-5, abs=1e-6), (n, quantity)


def test_the_worst_step_comes_first_by_the_force_or_the_couple_over_a_pitch() -> None:
    """In newtons as in units of the crank: a speed does not change what is worst."""
    engine = sb.load("vq30de")
    rows = sb.sensitivities(engine, 4, rpm=6000).records()
    effects = [max(row["force_of_step"], row["couple_of_step"] / 0.108) for row in rows]
    assert all(a >= b * (1 - 1e-12) for a, b in pairwise(effects))
    assert len({round(x) for x in effects}) > 5
    plain = sb.sensitivities(engine, 4).records()
    assert [(r["order"], r["parameter"], r["cylinder"]) for r in plain] == [
        (r["order"], r["parameter"], r["cylinder"]) for r in rows
    ]


def test_masses_that_differ_count_beside_a_symbolic_bank_angle() -> None:
    """Two pistons on one pin, of 0.5 and 0.6 kg, their force as numbers at an angle put in."""
    alpha = sympy.Symbol("alpha", real=True)
    masses = (Fraction(1, 2), Fraction(3, 5))
    twin = sb.vee(alpha, pins=[0])
    unlike = sb.Engine(
        sb.Cylinder(c.number, 0, c.bank.expression(), reciprocating_mass=mass)
        for c, mass in zip(twin.cylinders, masses, strict=True)
    )
    order = sb.design.symbolic_order(unlike, 2)
    half = np.radians(37.5)
    banks, theta = np.array([-half, half]), 0.7
    pushed = np.array([1.0, 1.2]) * np.cos(2 * (theta - banks))
    for name, part in (("vertical", np.cos), ("lateral", np.sin)):
        component = order.force.component(name)
        cos, sin = (float(x.subs(alpha, np.radians(75))) for x in (component.cos, component.sin))
        ours = cos * np.cos(2 * theta) + sin * np.sin(2 * theta)
        assert ours == pytest.approx(float(np.sum(part(banks) * pushed)), abs=1e-12)
