"""Offset banks and link rods: when pistons are at the top, what a firing order means, what is refused."""

from __future__ import annotations

import math
import re
from fractions import Fraction

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import symbalance as sb
from symbalance.cli import run
from symbalance.crankshaft.loads import firing_crank_angles
from symbalance.engine.dead_centres import firing_dead_centres, has_shifted_dead_centres
from symbalance.engine.engine_document import piston_strokes
from symbalance.engine.engine_file import parse_engine
from symbalance.engine.stars import intervals, is_even, known_firing
from symbalance.torque import firing_pin_passings
from tests import placed

FILE = """
[crank_train]
stroke = 90
rod = 164
[layout]
banks = [-7.5, 7.5]
cylinders = [[1, 3, 5], [2, 4, 6]]
firing_order = [1, 5, 3, 6, 2, 4]
offset = [-12.5, 12.5]
stagger = ["1/4", "-1/4"]
"""
SIX = "1-5-3-6-2-4"


def layout(more: str = "", was: str = "", now: str = "") -> sb.Engine:
    return parse_engine(FILE.replace(was, now) + more, "six.toml")


def throws(made: sb.Engine) -> dict[int, Fraction]:
    return {c.number: c.throw.in_degrees() for c in made.cylinders}


def test_without_a_word_the_pins_follow_the_firing_order():
    """throw = bank - firing angle, whatever the offset: what an engine file has always meant."""
    made = layout()
    for cylinder in made.cylinders:
        assert (cylinder.bank.in_degrees() - cylinder.fires - cylinder.throw.in_degrees()) % 360 == 0
    assert has_shifted_dead_centres(made)
    assert not is_even(made)
    assert [round(float(gap), 1) for gap in intervals(made)] == [120, 120, 126.9, 120, 120, 113.1]


def test_dead_centres_are_even_as_near_as_the_pins_are_told():
    for step, most in (("1/100", 0.01), ("1/2", 0.5), ("1/1000", 0.001)):
        made = layout(f'firing_at = "dead centres"\npin_step = "{step}"\n')
        gaps = [float(gap) for gap in intervals(made)]
        assert max(abs(gap - 120) for gap in gaps) <= most
    split = throws(layout('firing_at = "dead centres"\npin_step = "1/2"\n'))
    assert (split[6] - split[1]) % 360 == 22  # one ray of an in-line six, split


def test_the_builder_and_the_file_say_the_same():
    built = sb.vr(15, SIX, offset=12.5, stroke=90, rod=164, pin_step="1/2")
    assert throws(built) == throws(layout('firing_at = "dead centres"\npin_step = "1/2"\n'))
    assert throws(built) == throws(sb.load("vw-vr6"))


def test_nothing_moves_without_an_offset():
    plain = sb.engine.from_firing_order(SIX)
    assert throws(sb.engine.from_firing_order(SIX, firing_at="dead centres")) == throws(plain)
    assert sb.engine.from_firing_order(SIX, offset=[0], firing_at="dead centres").has_common_harmonics
    assert not has_shifted_dead_centres(plain)


@settings(max_examples=30, deadline=None)
@given(
    st.integers(0, 60),
    st.sampled_from([SIX, "1-2-4-5-3", "1-3-4-2", "1-2"]),
    st.fractions(-1, 1, max_denominator=8),
    st.fractions(Fraction(5, 2), 5, max_denominator=8),
)
def test_the_pistons_themselves_are_evenly_at_the_top(angle, order, aside, ratio):
    """Any narrow vee built for even dead centres, by the pistons' highest places."""
    made = sb.vr(angle, order, offset=aside * 40, stroke=80, rod=ratio * 40, pin_step="1/50")
    tops = {c.number: placed.stroke_and_top(made, c)[1] for c in made.cylinders}
    for cylinder in made.cylinders:
        late = tops[cylinder.number] - tops[1] - float(cylinder.fires)
        assert abs((late + 180) % 360 - 180) < 0.0201


def test_fires_may_say_either_moment_of_a_moved_dead_centre():
    """`fires` need only say which top dead centre fires, where an offset or a link rod moves it."""
    rows = [
        sb.Cylinder(1, 0, -30, fires=0),
        sb.Cylinder(2, 0, 30, fires=425, rod=134, link=sb.engine.Link(1, 60, 30)),
    ]
    train = sb.engine.CrankTrain(stroke=Fraction(90), rod=Fraction(164))
    made = sb.engine.from_cylinders(rows, crank_train=train)
    top = firing_dead_centres(made)[2]
    assert 400 < top < 440
    assert known_firing(made).order == (1, 2)
    with pytest.raises(sb.SymbalanceError, match="nearly the same"):
        sb.engine.from_cylinders(
            [rows[0], sb.Cylinder(2, 0, 30, fires=500, rod=134, link=rows[1].link)], crank_train=train
        )
    with pytest.raises(sb.SymbalanceError, match="must be the same"):
        sb.engine.from_cylinders([rows[0], sb.Cylinder(2, 0, 30, fires=425)], crank_train=train)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["vw-vr6", "r-1820", "kharkiv-v2", "merlin-v12"])
def test_pins_pass_and_pistons_top_out_at_different_angles(name):
    """Three names, three meanings: pins past the axes, dead centres, and those from cylinder 1's."""
    made = sb.load(name)
    passings, after_first = firing_pin_passings(made), firing_dead_centres(made)
    angles = {n: math.degrees(a) for n, a in firing_crank_angles(made).items()}
    tops = {c.number: placed.stroke_and_top(made, c)[1] for c in made.cylinders}  # by the pistons alone
    cycle, rotated = 180 * made.strokes, []
    for cylinder in made.cylinders:
        n = cylinder.number
        assert abs((angles[n] - tops[n] + 180) % 360 - 180) < 5e-6
        late = angles[n] - angles[1] - float(after_first[n])
        assert abs((late + cycle / 2) % cycle - cycle / 2) < 5e-6
        pin_on_axis = float(passings[n] + cylinder.throw.in_degrees() - cylinder.bank.in_degrees())
        assert pin_on_axis % 360 == 0
        rotated.append(abs((angles[n] - float(passings[n]) + 180) % 360 - 180))
    assert max(rotated) == pytest.approx(
        {"vw-vr6": 3.4288, "merlin-v12": 0}.get(name, max(rotated)), abs=1e-4
    )
    assert (max(rotated) > 0.5) == has_shifted_dead_centres(made)


def test_a_table_says_how_far_apart_dead_centres_are(capsys):
    assert run(["balance", "vw-vr6", "--order", "3"]) == 0
    out = capsys.readouterr().out
    assert "119.86°" in out
    assert "0.07° before its firing top dead centre" in " ".join(out.split())
    assert run(["balance", "toyota-1nz", "--order", "3"]) == 0
    assert re.search(r"fires +1-3-4-2\n", capsys.readouterr().out)  # all moved alike


@pytest.mark.parametrize(
    ("was", "now", "line", "words"),
    [
        ("[-12.5, 12.5]", "[-12.5]", 9, "has 1 values for 2 bank(s)"),
        ("[-12.5, 12.5]", "12.5", 9, "must be a list of numbers or fractions"),
        ("[-12.5, 12.5]", '[0, "aside"]', 9, "must be a number or a fraction"),
        ("[-12.5, 12.5]", "[0, 200]", 9, "must lie within"),
        ("stagger", 'firing_at = "tops"\nstagger', 10, "must be one of pins, dead centres"),
        ("stagger", "firing_at = 1\nstagger", 10, "must be one of pins, dead centres"),
        ("stagger", 'firing_at = "dead centres"\npin_step = 0\nstagger', 11, "must lie in (0, 10]"),
        ("stagger", 'firing_at = "dead centres"\npin_step = [1]\nstagger', 11, "must be a number"),
        ("stroke = 90", "", 9, "needs the stroke"),
    ],
)
def test_refusals_name_file_and_line(was, now, line, words, tmp_path, capsys):
    path = tmp_path / "six.toml"
    path.write_text(FILE.replace(was, now, 1), encoding="utf-8")
    assert run(["balance", str(path)]) == 2
    err = capsys.readouterr().err
    assert err.count("\n") == 1
    assert words in err
    assert f"six.toml:{line}" in err


@pytest.mark.slow
@pytest.mark.parametrize("name", ["vw-vr6", "r-985", "vq30de"])
def test_the_strokes_that_a_drawing_says(name: str) -> None:
    engine = sb.load(name)
    strokes = piston_strokes(engine)
    for cylinder in engine.cylinders:
        assert float(strokes[cylinder.number]) == pytest.approx(
            placed.stroke_and_top(engine, cylinder)[0], abs=1e-6
        )
