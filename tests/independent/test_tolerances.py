"""Worst cases within tolerances: against all vertices, against chance, and as engines that reach them."""

from __future__ import annotations

import cmath
import itertools
import json
import re
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

import symbalance as sb
from symbalance.cli import run
from symbalance.design.variations.annular_sectors import AnnularSector, largest_sum, support
from tests.pistons import harmonics, largest, pistons
from tests.rotating_model import turning as rotating

ENGINES = [
    "inline-2",
    "inline-3",
    "inline-4",
    "inline-5",
    "v6-60",
    "v8-90",
    "boxer-4",
    "radial-5",
    "v2-45",
]


def seen(pair, mode: str) -> float:
    ahead, against = pair
    return {
        "largest": abs(ahead) + abs(against),
        "vertical": abs(ahead.conjugate() + against),
        "lateral": abs(ahead.conjugate() - against),
        "forward": abs(ahead),
        "backward": abs(against),
    }[mode]


@pytest.mark.spread(2)
@pytest.mark.parametrize("name", ENGINES)
def test_mass_tolerances_are_the_worst_of_all_vertices(name):
    """2^N engines whose masses are all at an end: no other is worse, the modulus being convex in them."""
    layout, part = sb.load(name).with_ratio(4), 0.02
    single = [[harmonics([p], arms) for p in pistons(layout)] for arms in (False, True)]
    signs = np.array(list(itertools.product((1 - part, 1 + part), repeat=len(layout.cylinders))))
    modes = ("largest", "vertical", "lateral", "forward", "backward")
    for worst in sb.worst_cases(layout, sb.design.Tolerances(mass="2%"), 4, of=modes):
        rows = single[worst.quantity == "couple"]
        ahead = signs @ np.array([r[worst.order] for r in rows])
        against = signs @ np.array([r[-worst.order] for r in rows])
        brute = max(seen(pair, worst.of) for pair in zip(ahead, against, strict=True))
        assert worst.attained == pytest.approx(brute, rel=1e-9, abs=1e-14)
        assert worst.bound == pytest.approx(brute, rel=1e-4, abs=1e-14)
        assert worst.bound >= brute * (1 - 1e-12) - 1e-15


def smooth(name: str) -> sb.Engine:
    layout = sb.load(name).with_ratio(4)
    if name == "v2-45":
        return sb.design.overbalanced(layout, "3/5").balanced_by(
            sb.BalanceShaft(2, [sb.engine.Weight(1, 30, share=1)])
        )
    return sb.design_balance(layout, [1, 2]).balanced


def turning(layout, n: int, arms: bool) -> complex:
    """Return c_n of what turns, from the model that shares no sums with symbalance."""
    rows = [(complex(pull), float(z - layout.mean_station)) for s, pull, z in rotating(layout) if s == n]
    return sum((pull * (arm if arms else 1.0) for pull, arm in rows), 0j)


@pytest.mark.spread(2)
@pytest.mark.parametrize("name", ["inline-1", "inline-3", "inline-4", "v6-60", "v2-45", "radial-5"])
def test_what_turns_counts_and_stays_as_made(name):
    """All vertices of the masses, with the counterweights and shafts of the nominal engine too."""
    layout, part = smooth(name), 0.02
    assert layout.balancers
    signs = np.array(list(itertools.product((1 - part, 1 + part), repeat=len(layout.cylinders))))
    single = [[harmonics([p], arms) for p in pistons(layout)] for arms in (False, True)]
    modes = ("largest", "vertical", "lateral", "forward", "backward")
    for worst in sb.worst_cases(layout, sb.design.Tolerances(mass="2%"), 4, of=modes):
        arms = worst.quantity == "couple"
        n = worst.order
        ahead = signs @ np.array([r[n] for r in single[arms]]) + turning(layout, n, arms)
        against = signs @ np.array([r[-n] for r in single[arms]]) + turning(layout, -n, arms)
        brute = max(seen(pair, worst.of) for pair in zip(ahead, against, strict=True))
        assert worst.attained == pytest.approx(brute, rel=1e-9, abs=1e-13)
        assert brute * (1 - 1e-12) - 1e-15 <= worst.bound <= brute * (1 + 1e-4) + 1e-13
        assert not worst.nominal or n > 2 or name == "v2-45"


def test_an_order_of_a_shaft_alone_is_there():
    sizes = sb.engine.CrankTrain(
        stroke=Fraction(80), rod=Fraction(160), reciprocating_mass=Fraction(1, 2)
    )
    layout = sb.inline("1", crank_train=sizes)
    third = layout.balanced_by(sb.BalanceShaft(3, [sb.engine.Weight(unbalance=2)]))
    found = {(w.order, w.quantity): w for w in sb.worst_cases(third, sb.design.Tolerances(mass="1%"), 4)}
    assert found[3, "force"].bound == pytest.approx(2 * 9 / 20)
    assert found[3, "force"].attained == found[3, "force"].nominal == pytest.approx(0.9)


FULL = {
    "mass": "1%",
    "throw": "0.4",
    "bank": "0.3",
    "station": "2%",
    "stroke": "0.4",
    "rod": "0.5",
    "offset": "0.3",
}
TRAIN = sb.engine.CrankTrain(stroke=Fraction(80), rod=Fraction(140), pitch=Fraction(100))


@pytest.mark.slow
@pytest.mark.parametrize("firing", ["1-3-4-2", "1-2-4-5-3", "vee"])
def test_no_engine_within_tolerances_passes_the_bound(firing):
    made = sb.vee(60, firing_order="1-2-3-4-5-6") if firing == "vee" else sb.inline(firing)
    layout = sb.engine.from_cylinders(made.cylinders, crank_train=TRAIN)
    found = {(w.order, w.quantity): w for w in sb.worst_cases(layout, sb.design.Tolerances(**FULL), 4)}
    chance, engine = np.random.default_rng(5), [p.changed(rod=-0.5) for p in pistons(layout)]
    tried = dict.fromkeys(found, 0.0)
    for extreme in [True] * 60 + [False] * 40:
        errors = []
        for piston in engine:
            x = chance.choice([-1, 1], 7) if extreme else chance.uniform(-1, 1, 7)
            changes = dict(  # noqa: C408
                mass=0.01 * x[0], throw=np.radians(0.4) * x[1], bank=np.radians(0.3) * x[2],
                station=0.02 * x[3], radius=0.2 / 40 * x[4], rod=0.5 / 40 * x[5], offset=0.3 / 40 * x[6],
            )  # fmt: skip
            errors.append(piston.changed(**changes))
        for n, quantity in found:
            tried[n, quantity] = max(tried[n, quantity], largest(errors, n, quantity == "couple"))
    assert [n for n, q in found if q == "force"] == [1, 2, 3, 4]  # an offset brings order 3
    for key, worst in found.items():
        assert tried[key] <= worst.bound, key
        assert worst.nominal <= worst.attained <= worst.bound
        assert worst.attained > 0.9 * worst.bound, key
        assert worst.attained > tried[key] * 0.98, key


@pytest.mark.slow
@pytest.mark.parametrize("name", ENGINES)
def test_what_is_attained_is_attained(name):
    """The errors told, put into pistons, give the value told: mass, throw, bank and station."""
    layout = sb.load(name).with_ratio(4)
    tolerances = sb.design.Tolerances(mass="1%", throw="0.2", bank="0.1", station="1%")
    for worst in sb.worst_cases(layout, tolerances, 2):
        engine = []
        for piston, cylinder in zip(pistons(layout), layout.cylinders, strict=True):
            weight, station, throw, bank = worst.errors[cylinder.number]
            assert abs(weight - 1) <= 0.01 + 1e-12
            assert abs(station) <= 0.01 + 1e-12
            assert max(abs(throw) - 0.2, abs(bank) - 0.1) <= 1e-12
            changes = {
                "mass": weight - 1,
                "station": station,
                "throw": np.radians(throw),
                "bank": np.radians(bank),
            }
            engine.append(piston.changed(**changes))
        assert largest(engine, worst.order, worst.quantity == "couple") == pytest.approx(
            worst.attained, rel=1e-9
        )


def test_in_line_four_by_hand():
    """Pistons 1 and 4 heavy, 2 and 3 light: 4 x in order 1; front heavy or rear heavy by turns: 4 x a."""
    layout = sb.inline("1-3-4-2", ratio=4)
    force, couple = sb.worst_cases(layout, sb.design.Tolerances(mass="1%"), 1)
    assert force.attained == pytest.approx(0.04, rel=1e-12)
    assert couple.attained == pytest.approx(0.04, rel=1e-12)  # (1.5 + 0.5 + 0.5 + 1.5) x
    assert force.statistical == pytest.approx(0.02, rel=1e-12)
    exact = sb.design.symbolic_order(layout, 1, masses=["1.01", "0.99", "0.99", "1.01"])
    assert exact.force.vertical.amplitude == Fraction(1, 25)


def test_without_tolerances_nothing_is_lost():
    layout = sb.load("v8-90")
    result = sb.balance(layout, 4)
    for worst in sb.worst_cases(layout, sb.design.Tolerances(), 4):
        assert worst.attained == worst.bound == worst.nominal
        assert worst.statistical == 0
    first = sb.worst_cases(layout, sb.design.Tolerances(), 1)[1]
    assert first.nominal == pytest.approx(float(result[1].couple.vertical.amplitude), rel=1e-12)
    assert sb.worst_cases(layout, sb.design.Tolerances(), 2)[2].nominal == 0  # an exact zero


@pytest.mark.slow
@given(st.integers(0, 40), st.integers(0, 40))
@settings(max_examples=8, deadline=None)
def test_wider_tolerances_are_never_better(one, more):
    layout = sb.load("v6-60")

    def bounds(mass, throw):
        found = sb.worst_cases(
            layout, sb.design.Tolerances(mass=f"{mass}%", throw=Fraction(throw, 10)), 2
        )
        return [w.bound for w in found]

    narrow, wide = bounds(one, more), bounds(one + 1, more + 1)
    assert all(a <= b * (1 + 1e-8) + 1e-12 for a, b in zip(narrow, wide, strict=True))


sectors = st.builds(
    lambda a, b, angle, half: AnnularSector(min(a, b), max(a, b), angle, half),
    st.floats(-2, 2), st.floats(-2, 2), st.floats(-7, 7), st.sampled_from([0.0, 0.0, 1e-3, 0.4, 1.8]),
)  # fmt: skip


@pytest.mark.slow
@example([AnnularSector(0.0, 1.0, 1.5), AnnularSector(-1.25, 1.0, 1.0, 1.8)])
@given(st.lists(sectors, min_size=1, max_size=4))
@settings(max_examples=60, deadline=None)
def test_the_largest_sum_is_the_top_of_its_support_function(rows):
    found = largest_sum(rows)
    top = max(sum(support(s, x) for s in rows) for x in np.linspace(0, 2 * np.pi, 361))
    size = sum(max(abs(s.low), abs(s.high)) for s in rows)
    assert top <= found.value + 1e-9 * size
    assert found.value <= top + 2e-4 * size + 1e-12  # second order in the steps of 1 degree
    for picks in itertools.islice(itertools.product((0, 1), (-1, 0, 1), repeat=len(rows)), 60):
        total = sum(
            (s.low, s.high)[picks[2 * i]] * cmath.rect(1, s.angle + picks[2 * i + 1] * s.half)
            for i, s in enumerate(rows)
        )
        assert abs(total) <= found.value + 1e-9 * size


@pytest.mark.slow
def test_unlike_engines_and_link_rods_have_worst_cases():
    hung = sb.Cylinder(2, 0, 60, link=sb.engine.Link(1, 60, 30), rod=134)
    train = sb.engine.CrankTrain(stroke=Fraction(90), rod=Fraction(164))
    layout = sb.engine.from_cylinders([sb.Cylinder(1, 0, 0), hung], crank_train=train)
    whole = sb.balance(layout, 3)
    for worst in sb.worst_cases(layout, sb.design.Tolerances(mass="1%"), 3):
        terms = (whole.force if worst.quantity == "force" else whole.couple).terms
        size = sum(abs(complex(terms[n].value)) for n in (worst.order, -worst.order) if n in terms)
        assert worst.nominal == pytest.approx(size, abs=1e-12)
        assert worst.attained >= worst.nominal * 1.0099
    with pytest.raises(sb.SymbalanceError, match="hang on link rods"):
        sb.worst_cases(layout, sb.design.Tolerances(rod=1), 2)
    with pytest.raises(sb.SymbalanceError, match=r"tolerances of bank\b.* hang on link rods"):
        sb.worst_cases(layout, sb.design.Tolerances(bank="0.1"), 2)
    narrow = [
        sb.Cylinder(i + 1, 120 * i, 7 if i % 2 else -7, i, offset=-12 if i % 2 else 12) for i in range(3)
    ]
    vr = sb.engine.from_cylinders(
        narrow, crank_train=sb.engine.CrankTrain(stroke=Fraction(90), rod=Fraction(164))
    )
    for worst in sb.worst_cases(vr, sb.design.Tolerances(mass="1%", offset="0.1", rod="0.1"), 3):
        assert worst.nominal <= worst.attained <= worst.bound
        assert worst.attained > 0.9 * worst.bound


@pytest.mark.slow
def test_extremes_of_size():
    many = sb.inline("-".join(map(str, range(1, 25))), ratio="1.01")
    found = sb.worst_cases(many, sb.design.Tolerances(mass="1%", throw="0.1"), 6)
    assert all(w.attained <= w.bound for w in found)
    one = sb.worst_cases(sb.inline("1", ratio=4), sb.design.Tolerances(mass="100%"), 1)
    assert one[0].bound == pytest.approx(2)
    high = sb.worst_cases(sb.load("inline-4"), sb.design.Tolerances(mass="1%"), 1000)
    assert 300 < high[-1].order < 1000  # beyond, the coefficient is no double any more


def test_the_command(capsys, tmp_path, golden):
    options = ["tolerances", "inline-4", "--mass", "1%", "--throw", "0.1", "--rotating", "1%"]
    assert run(options) == 0
    golden("tolerances-inline-4.txt", capsys.readouterr().out)
    assert run([*options, "--format", "json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert document["worst_cases"][0]["errors"]["1"]["weight"] in (0.99, 1.01)
    assert run([*options, "--format", "latex", "-o", str(tmp_path / "a.tex")]) == 0
    assert r"\begin{tabular}" in (tmp_path / "a.tex").read_text(encoding="utf-8")
    assert run(["tolerances", "vq30de", "--mass", "0.002", "--rpm", "6000", "--order", "1"]) == 0
    title, *lines = capsys.readouterr().out.splitlines()
    assert "at 6000 rpm" in title
    order, of, drawn, worst, most, _ = next(line for line in lines if "largest" in line).split()
    assert (order, of, drawn, worst) == ("1", "largest", "0", most)
    # 2 sqrt 3 times 2 g at r omega^2, r = 36.65 mm at 6000 rpm
    assert float(worst) == pytest.approx(2 * 3**0.5 * 0.002 * 0.03665 * (200 * np.pi) ** 2, rel=1e-5)


@pytest.mark.slow
def test_at_a_speed_worst_cases_are_newtons_and_newton_metres():
    """VQ30DE: 36.65 mm of radius, and its mass and pitch, at 3000 rpm."""
    engine, tolerances = sb.load("vq30de"), sb.design.Tolerances(mass="1%", throw="0.1", rotating="1%")
    plain = sb.worst_cases(engine, tolerances, 2)
    at_speed = sb.worst_cases(engine, tolerances, 2, rpm="3000.0")
    mass, pitch = engine.cylinders[0].reciprocating_mass, engine.pitch
    assert mass is not None
    assert pitch is not None
    newtons = float(mass) * 0.03665 * (100 * np.pi) ** 2
    assert len(plain) == len(at_speed) == 6
    for one, other in zip(plain, at_speed, strict=True):
        by = newtons * float(pitch) / 1000 if "couple" in one.quantity else newtons
        for name in ("nominal", "attained", "bound", "statistical"):
            assert getattr(other, name) == pytest.approx(by * getattr(one, name), rel=1e-12), name
        assert one.errors == other.errors
    assert [plain.unit(w) for w in plain[:2]] == ["m r ω²", "m r ω² a"]
    assert [at_speed.unit(w) for w in at_speed[:2]] == ["N", "N m"]
    assert at_speed.data()["rpm"] == "3000"
    assert sb.worst_cases(engine, tolerances, 1, rpm="2500.5").data()["rpm"] == "2500.5"


def printed(value: float) -> str:
    """Return a float in the six digits of tables, its power of ten left out."""
    mantissa, exponent = f"{value:.5e}".split("e")
    digits = f"{value:.6g}" if -3 <= int(exponent) < 6 else mantissa
    return digits.rstrip("0").rstrip(".") if "." in digits else digits


@pytest.mark.slow
def test_every_worst_case_stands_in_the_text():
    """With what is reached, what is proved, the drawing's own, and the estimate, in one line."""
    tolerances = sb.design.Tolerances(mass="1%", throw="0.3", bank="0.2", rotating="1%")
    result = sb.worst_cases(sb.load("vq30de"), tolerances, 4, of=["largest", "lateral", "forward"])
    text = sb.to_text(result)
    wide = [w for w in result if w.bound > w.attained * (1 + 1e-6)]
    assert wide
    for worst in result:
        row = [worst.of, *map(printed, (worst.nominal, worst.attained))]
        row += [printed(worst.bound)] * (worst in wide) + [printed(worst.statistical)]
        pattern = rf"^ +{worst.order}  .*" + ".* ".join(map(re.escape, row))
        assert re.search(pattern, text, re.M), (pattern, text)
    assert "every cylinder: mass ±1 % of m, throw ±0.3°, bank ±0.2°, rotating ±1 % of m" in text


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["inline-4"], "is given no tolerance"),
        (["inline-4", "--mass", "0.002"], "needs the engine's reciprocating_mass"),
        (["inline-4", "--mass=-1%"], "must not be negative"),
        (["inline-4", "--mass", "200%"], "lets a mass be negative"),
        (["inline-4", "--mass", "nan"], "must be a number"),
        (["inline-4", "--throw", "1%"], "is no percentage"),
        (["inline-4", "--throw", "90"], "must be at most 45"),
        (["inline-4", "--station", "1"], "needs the engine's pitch"),
        (["inline-4", "--mass", "1%", "--rpm", "6000"], "needs the engine's"),
        (["vq30de", "--mass", "1%", "--rpm", "0"], "must lie in"),
        (["inline-4", "--mass", "1%", "--of", "sideways"], "is not known"),
        (["inline-4", "--mass", "1%", "--order", "0"], "order"),
        (["vq30de", "--rod", "200", "--order", "1"], ""),
    ],
)
def test_bad_tolerances_are_refused_in_one_line(options, words, capsys):
    assert run(["tolerances", *options]) == 2
    err = capsys.readouterr().err
    assert words in err
    assert err.count("\n") == 1
