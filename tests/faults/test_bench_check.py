"""The bench of the checker: its page is what its truth says, and faults planted in it are caught."""

from __future__ import annotations

import mpmath
import pytest
import sympy

from symbalance.bench import other_checkers
from symbalance.bench.check import POSITIVE, fault_table, misjudgements, report, truth
from symbalance.bench.check_page import bench_page, place_of
from symbalance.bench.fault_kinds import KINDS
from symbalance.bench.other_checkers import MATH_VERIFY, OURS, Answer, Comparison, SingleLine
from symbalance.bench.planted_faults import DEFINITION, LOWERED, NO_FAULT, STEP, Planter, tally
from symbalance.bench.sympy_decisions import (
    DIFFERENT,
    EQUALS,
    PROVED,
    UNDECIDED,
    Relation,
    SympyConverter,
    decide,
    decide_links,
    links,
)
from symbalance.notes.reading import read_expression

HERE = bench_page()


@pytest.fixture(scope="module")
def planter() -> Planter:
    return Planter(HERE)


@pytest.fixture(scope="module")
def checked():
    return HERE.check(HERE.text)


@pytest.mark.slow
def test_the_page_is_judged_as_its_truth_says(checked):
    assert misjudgements(HERE, checked) == []
    assert len(truth(HERE)) == len(checked.verdicts) >= 90
    assert sum(not right for right in truth(HERE).values()) == len(HERE.errors) == 12


@pytest.mark.slow
def test_lines_said_to_define_a_letter_do(checked):
    for line in HERE.defining:
        assert checked.at(line)[0].verdict == "definition"


@pytest.mark.slow
def test_every_known_error_is_found_and_put_right(planter):
    assert planter.known_errors() == (12, 12)


@pytest.mark.slow
def test_the_page_put_right_raises_no_alarm(planter):
    assert planter.false_alarms == []
    assert all(v.verdict in POSITIVE for v in planter.judgement.verdicts)


@pytest.mark.slow
def test_the_truth_by_numbers_alone(planter):
    """Every relation put right holds in value, or through the order it keeps; no known error does."""
    places = {(e.line, e.link) for e in HERE.errors}
    for text, wrong in ((HERE.corrected, set()), (HERE.text, places)):
        for chain in HERE.read(text).chains:
            sound = 0
            for k, relation in enumerate(chain.relations):
                one, other = chain.sides[sound].node, chain.sides[k + 1].node
                holds = planter.values.same(one, other) or planter.values.is_true_to_order(other, one)
                decimal = relation.sign == "≈" and "." in HERE.read(text).source(chain.sides[k + 1].span)
                if decimal:
                    pair = planter.values.of(one)[0], planter.values.of(other)[0]
                    holds = abs(pair[0] - pair[1]) < 1e-3 * abs(pair[0])
                assert holds == (place_of(chain, k) not in wrong), place_of(chain, k)
                sound = sound if place_of(chain, k) in wrong else k + 1


@pytest.mark.slow
def test_planted_faults_are_caught(planter):
    faults = [f for f in planter.plant(5, seed=7) if f.where == STEP]
    assert len(faults) == 5 * len(KINDS)
    missed = [f for f in faults if not f.is_caught]
    assert len(missed) <= 0.05 * len(faults), missed
    rows = tally(faults)
    assert sum(row["rightly"] for row in rows.values()) >= 0.6 * len(faults)
    assert "sign turned" in fault_table(faults, ["a note"])
    assert rows[DEFINITION]["planted"] == 0


def _place(planter: Planter, line: int, side: int):
    return next(p for p in planter.places() if p.chain.lines[0] == line and p.side == side)


@pytest.mark.slow
def test_what_is_no_fault_is_told_apart(planter):
    place = _place(planter, 42, 1)  # sin² θ = (1 − cos 2θ)/2
    assert planter.judge("", place, r"\frac{2 - 2 \cos 2\theta}{4}").where == NO_FAULT
    wrong = planter.judge("", place, r"\frac{1 + \cos 2\theta}{2}")
    assert (wrong.where, wrong.is_caught, wrong.is_right) == (STEP, True, True)
    place = _place(planter, 106, 1)  # v ≈ r ω (sin θ + sin 2θ/(2λ))
    assert planter.judge("", place, r"r \omega \sin\theta").where == LOWERED
    assert planter.judge("", place, r"r \omega \cos\theta").where == STEP


def test_every_kind_of_fault_finds_places(planter):
    assert all(len(planter.candidates(kind)) > 50 for kind in KINDS)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (r"\frac{x^2 - 1}{2}", "(x**2 - 1)/2"),
        (r"\sqrt{1 - \sin^2 2x}", "sqrt(1 - sin(2*x)**2)"),
        (r"2 \cos\left(x - 60^\circ\right)", "2*cos(x - pi/3)"),
        (r"e^{-i x}", "exp(-I*x)"),
        (r"\sum_{k=0}^{3} k x", "6*x"),
        (r"\arctan\frac{1}{3} - |x|", "atan(Rational(1, 3)) - Abs(x)"),
        ("0.25 x", "x/4"),
    ],
)
def test_converter(text, expected):
    node = read_expression(text, {"x", "k"})[0]
    x = sympy.Symbol("x", real=True)
    assert sympy.simplify(SympyConverter().of(node) - sympy.sympify(expected, {"x": x})) == 0


def test_converter_differentiates_by_the_crank_angle_and_by_time():
    names = {"theta", "omega", "t", "x"}
    position = read_expression(r"\cos 2\theta", names)[0]
    convert = SympyConverter({"x": position})
    theta, omega = convert.symbol("theta"), convert.symbol("omega")
    assert convert.of(read_expression(r"\frac{dx}{d\theta}", names)[0]) == -2 * sympy.sin(2 * theta)
    twice = convert.of(read_expression(r"\frac{d^2 x}{dt^2}", names)[0])
    assert sympy.expand(twice + 4 * omega**2 * sympy.cos(2 * theta)) == 0


def test_values_are_those_of_the_motion(planter):
    """The page's x is the piston's way by the law of cosines, by numbers of our own."""
    position = read_expression("x", HERE.letters)[0]
    for point, value in zip(planter.values.points, planter.values.of(position), strict=True):
        r, theta = point["r"], point["theta"]
        rod = point["lambda"] * r
        pin = r * mpmath.cos(theta) + mpmath.sqrt(rod**2 - (r * mpmath.sin(theta)) ** 2)
        assert abs(value - (r + rod - pin)) < 1e-12


@pytest.mark.slow
def test_simplify_is_asked_fairly():
    asked = {(link.line, link.link): link for link in links(HERE)}
    assert decide(asked[42, 1]) == decide(asked[42, 1], EQUALS) == PROVED
    assert decide(asked[56, 1]) == decide(asked[56, 1], EQUALS) == DIFFERENT
    assert decide(asked[106, 1]) == PROVED
    assert asked[106, 1].highest == 1
    assert (170, 1) not in asked  # a definition


@pytest.mark.slow
def test_simplify_is_ended_at_its_limit():
    x = sympy.Symbol("x")
    hard = sympy.Add(*(sympy.cos(x + 2 * sympy.pi * k / 61) ** 7 for k in range(61)))
    quick = Relation(1, 1, sympy.sin(x) ** 2 + sympy.cos(x) ** 2 - 1, True)
    slow, after = decide_links([Relation(2, 1, hard, True), quick], limit=2.0)
    assert (slow.answer, slow.is_right) == (UNDECIDED, False)
    assert (after.answer, after.is_right) == (PROVED, True)


def test_the_bench_has_its_report():
    assert callable(report)


@pytest.mark.slow
def test_single_lines_are_read_and_judged_rightly_and_a_missing_program_is_a_line(monkeypatch):
    monkeypatch.setattr(other_checkers, "find_spec", lambda name: None)
    table = other_checkers.compare_checkers(every=9, ways=(OURS, other_checkers.EQUALS, MATH_VERIFY))
    count = len(table.lines)
    assert count >= 14
    assert table.counts(OURS) == (count, count, 0, 0)
    read, right, wrong, nothing = table.counts(other_checkers.EQUALS)
    assert (read, wrong, right + nothing) == (count, 0, count)
    (missing,) = table.missing
    assert missing == f"{MATH_VERIFY}: not installed; pip install math-verify"
    assert table.text().endswith(missing)


def test_a_false_line_called_equal_is_silently_wrong():
    lines = [SingleLine("1", "2", False, {}, (1.0, 2.0)), SingleLine("1", "1", True, {}, (1.0, 1.0))]
    given = [Answer(True, "proved", 0.1), Answer(False, "no answer", 0.1)]
    assert Comparison(lines, {OURS: given}, ()).counts(OURS) == (1, 0, 1, 1)
